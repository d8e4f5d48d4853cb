#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Measures the friction mu(I) of a sheared packing: run.sh [--quick] [OUT]. Writes OUT/mu.tsv, a row for each inertial number I:
# I, mu, solid fraction, the curve of Jop, Forterre and Pouliquen (Nature 441 (2006) 727; glass beads: 0.38, 0.64, 0.279).
# With gnuplot, also OUT/mu.svg.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
find_scree
numbers="0.01 0.03 0.1 0.3 0.5"
count=600
edges="[10, 11, 8]"
if [ "${1:-}" = --quick ]; then
    numbers="0.15 0.5"
    count=150
    edges="[6, 7.7, 5]"
    shift
fi
out=${1:-$(results out)}
mkdir -p "$out"
: >"$out/mu.tsv"
for number in $numbers; do
    # I = rate d sqrt(density / stress): the flow is steady after a strain of 2 and a time of 60, and is measured for a strain of 4
    rate=$(awk -v i="$number" 'BEGIN { printf "%.6g", i / sqrt(1.909859317) }')
    steps=$(awk -v r="$rate" 'BEGIN { t = 2 / r; if (t < 60) t = 60; printf "%d", (t + 4 / r) / 0.003 }')
    "$SCREE" run "$here/scene.yaml" -o "$out/$number" --overwrite --quiet --set box.shear.rate="$rate" --set step.count="$steps" \
        --set particles.count=$count --set "box.upper=$edges" >"$out/$number.log" 2>&1 || { cat "$out/$number.log" >&2; exit 1; }
    awk -F, -v i="$number" -v rate="$rate" -v grains=$count '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        $at["time"] * rate > 2 && $at["time"] > 60 {
            n++; shear -= $at["stress_xy"]; normal += $at["stress_yy"]
            volume += $at["box_edges_x"] * $at["box_edges_y"] * $at["box_edges_z"] }
        END { pi = atan2(0, -1) # radii from 0.4 to 0.6: mean cube 0.13
            printf "%s\t%.4f\t%.4f\t%.4f\n", i, shear / normal, grains * 4 / 3 * pi * 0.13 / (volume / n), 0.38 + (0.64 - 0.38) / (0.279 / i + 1) }
        ' "$out/$number/observables.csv" >>"$out/mu.tsv"
done
cat "$out/mu.tsv"
if command -v gnuplot >/dev/null; then
    gnuplot <<END
set terminal svg size 640,420 font "sans,14" background "white"
set output '$out/mu.svg'
set logscale x
set xlabel 'inertial number I'
set ylabel 'mu'
set key left top
set xrange [0.005:1]
set yrange [0.2:0.7]
plot 0.38 + 0.26 / (0.279 / x + 1) with lines lw 2 lc rgb '#888888' title 'Jop, Forterre and Pouliquen 2006', \\
    '$out/mu.tsv' using 1:2 with points pt 7 ps 1.2 lc rgb '#0060ad' title 'this cell, 600 grains'
END
fi
