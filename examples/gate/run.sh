#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A silo is filled, opened and tilted, in three stages: run.sh [DIR]. Draws DIR/gate.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
if command -v gnuplot >/dev/null; then
    awk '/^ITEM: TIMESTEP/ { frame++ } { line[NR] = $0; of[NR] = frame } END { for (k = 1; k <= NR; k++) if (of[k] == frame) print line[k] }' \
        "$out/dump.lammpstrj" | awk '/^ITEM: ATOMS/ { atoms = 1; for (k = 3; k <= NF; k++) at[$k] = k - 2; next } atoms { print $at["x"], $at["z"], $at["radius"] }' >"$out/last"
    gnuplot -e "folder='$out'; picture='$out/gate.png'" "$here/picture.gp"
    echo "drawn: $out/gate.png"
fi
