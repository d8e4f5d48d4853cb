#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the case and draws the last state and the temperatures: run.sh [DIR [SECONDS]]
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --set duration="${2:-3} s"
if command -v gnuplot >/dev/null; then
    awk '/^ITEM: ATOMS/ { n = 0; reading = 1; for (k = 3; k <= NF; k++) at[$k] = k - 2; next } /^ITEM:/ { reading = 0; next }
        reading { line[++n] = $at["x"] * 1e3 " " $at["y"] * 1e3 " " $at["radius"] * 1e3 " " $at["temperature"] }
        END { for (k = 1; k <= n; k++) print line[k] }' "$out/dump.lammpstrj" >"$out/last.txt"
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/heated-drum.png"
fi
