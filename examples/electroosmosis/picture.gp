# SPDX-License-Identifier: BSD-3-Clause
# The potential with the flow, and the dye early and late.
set terminal pngcairo size 900,1250 font ",14"
set output out.'electroosmosis.png'
set multiplot layout 3,1
set size ratio -1
set xrange [0:40]
set yrange [0:20]
set ylabel "y (um)"
unset key
set palette defined (-1 "#2166ac", 0 "#f7f7f7", 1 "#b2182b")
set cbrange [-50:50]
set title "potential of the ions (mV) and flow, at most 0.2 mm/s"
stats out.'early.txt' using (sqrt($3 ** 2 + $4 ** 2)) nooutput
set title sprintf("potential (mV) and flow, up to %.2f mm/s", 1e3 * STATS_max)
plot out.'early.txt' using 1:2:5 with points pt 5 ps 1.12 palette, \
    '' using (int($1 * 2) % 4 == 0 && int($2 * 2) % 4 == 0 ? $1 : NaN):2:(3 * $3 / STATS_max):(3 * $4 / STATS_max) with vectors head size 0.3,20 filled lc rgb "#000000" lw 1
set palette defined (0 "#ffffff", 1 "#0b3d91")
set cbrange [0:1]
set title "dye after 0.1 s"
plot out.'early.txt' using 1:2:6 with points pt 5 ps 1.12 palette
set xlabel "x (um)"
set title "dye after 0.4 s"
plot out.'late.txt' using 1:2:6 with points pt 5 ps 1.12 palette
