#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A drum turns with dumbbells: run.sh [DIR]. Draws DIR/dumbbells.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
if command -v gnuplot >/dev/null; then
    awk -f "$here/members.awk" "$out/dump.lammpstrj" | sort -rg >"$out/members"
    gnuplot -e "members='$out/members'; picture='$out/dumbbells.png'" "$here/picture.gp"
    echo "drawn: $out/dumbbells.png"
fi
