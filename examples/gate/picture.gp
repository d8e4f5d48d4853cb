# SPDX-License-Identifier: BSD-3-Clause
# The silo at the ends of its stages, and the number of grains in it: gnuplot -e "folder='DIR'; picture='FILE'" picture.gp
set terminal pngcairo size 1200, 420 font 'sans,11'
set output picture
set multiplot layout 1, 2
set datafile separator ','
set xlabel 'time in s'
set ylabel 'grains in the silo'
set yrange [0:950]
set y2label 'unbalanced force over contact force'
set y2range [0.001:10]
set logscale y2
set ytics nomirror
set y2tics format '10^{%T}'
set key top right
plot folder.'/observables.csv' using 1:2 every ::1 with lines lw 2 title 'grains in the silo', \
     '' using 1:4 every ::1 axes x1y2 with lines title 'unbalanced force'
unset y2tics; unset y2label; unset logscale
set datafile separator whitespace
set xlabel 'x in cm'; set ylabel 'z in cm'
set xrange [-3:3]; set yrange [-4:6]
set size ratio -1
set style fill solid 0.6 border lc rgb 'black'
stats folder.'/last' using 1 nooutput
plot folder.'/last' using (100 * $1):(100 * $2):(100 * $3) with circles lc rgb '#c08040' notitle, \
     '-' with lines lw 4 lc rgb 'black' notitle
-3 0
-0.7 0

0.7 0
3 0
e
unset multiplot
