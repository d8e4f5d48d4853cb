#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A picture of a flow in the plane: flow.sh DIR PICTURE LENGTH [Z DEPTH]
# Draws the last frame of DIR/dump.lammpstrj (positions and velocities): the speed as colour, arrows of up to LENGTH. Of three
# dimensions the slice of thickness DEPTH about the height Z.
set -e
dir=$1 picture=$2 length=$3 z=${4:-0} depth=${5:-1e300}
command -v gnuplot >/dev/null || { echo "no gnuplot here, so nothing is drawn"; exit 0; }
awk -v z="$z" -v depth="$depth" '
    /^ITEM: TIMESTEP/ { n = 0; next }
    /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
    /^ITEM/ { reading = 0 }
    reading && NF > 4 { h = $at["z"] - z; if (h < 0) h = -h
        if (h <= depth / 2 && ($at["vx"] != 0 || $at["vy"] != 0)) line[n++] = $at["x"] " " $at["y"] " " $at["vx"] " " $at["vy"] " " sqrt($at["vx"]^2 + $at["vy"]^2 + $at["vz"]^2) }
    END { for (k = 0; k < n; k++) print line[k] }' "$dir/dump.lammpstrj" >"$dir/flow.txt"
gnuplot -e "flow='$dir/flow.txt'; picture='$picture'; length=$length" - <<'GP'
set terminal pngcairo size 900,820 font ",14"
set output picture
stats flow using 5 nooutput
most = STATS_max > 0 ? STATS_max : 1
stats flow using 1 nooutput
set xrange [STATS_min - 0.01:STATS_max + 0.01]
n = sqrt(STATS_records)
stats flow using 2 nooutput
set yrange [STATS_min - 0.01:STATS_max + 0.01]
set size ratio -1
set cblabel "speed"
set xlabel "x"; set ylabel "y"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
plot flow using 1:2:5 with points pt 5 ps (820.0 / n / 8.5) palette notitle, \
    flow using (int($0) % 7 == 0 && $5 > 0 ? $1 : NaN):2:($3 / most * length):($4 / most * length) with vectors head size 0.008,20 filled lc rgb "#ffffff" lw 0.8 notitle
GP
rm "$dir/flow.txt"
echo "drawn: $picture"
