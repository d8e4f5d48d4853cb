#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Draws a flow of which run.sh has kept the particles (PICTURE=1): picture.sh DIR. Writes DIR/bead-packing.png, and beside it the columns drawn:
# section.txt, speeds.txt (histogram of the velocity along the axis), forces.txt (histogram of the forces on beads).
set -e
here=$(cd "$(dirname "$0")" && pwd)
out=$1
dump=$(ls "$out"/flow-*/dump.lammpstrj | head -n 1)
spacing=$(sed -n 's/^{"spacing_um": \([0-9.]*\).*/\1/p' "$out/flows.jsonl" | head -n 1)
awk -v out="$out" -v spacing="$spacing" -v column="$(sed -n 's/.*"column_mm": \([0-9.]*\).*/\1/p' "$out/packing.json")" -f "$here/picture.awk" "$dump"
command -v gnuplot >/dev/null || { echo "no gnuplot here, so nothing is drawn"; exit 0; }
gnuplot -e "out='$out/'; spacing=$spacing" "$here/picture.gp"
echo "drawn: $out/bead-packing.png" >&2
