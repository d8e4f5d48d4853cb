#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A field mixes two streams of water between walls of alternating charge: run.sh [DIR]. Draws DIR/electroosmosis.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
command -v gnuplot >/dev/null || { echo "no gnuplot here, so nothing is drawn"; exit 0; }
# frame NUMBER: x and y in um, the velocity, the potential in mV, the dye
frame() {
    awk -v number="$1" '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && frame == number && $at["y"] > 0 && $at["y"] < 20e-6 { print 1e6 * $at["x"], 1e6 * $at["y"], $at["vx"], $at["vy"], 1e3 * $at["potential"], $at["scalar_1"] }' "$out/dump.lammpstrj"
}
frame 2 >"$out/early.txt"
frame 5 >"$out/late.txt"
gnuplot -e "out='$out/'" "$here/picture.gp"
rm "$out/early.txt" "$out/late.txt"
echo "drawn: $out/electroosmosis.png"
