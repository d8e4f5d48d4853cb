# SPDX-License-Identifier: BSD-3-Clause
# gnuplot -e "out='DIR/'; spacing=MICROMETRES" picture.gp: the section through the axis, velocities, forces, porosity near the wall.
set terminal pngcairo size 1500,1000 font ",15"
set output out."bead-packing.png"
set multiplot
set size 0.56,1; set origin 0,0
set size ratio -1
set xlabel "x, mm"; set ylabel "z, mm" offset 1
set cblabel "speed / superficial velocity"
set cbrange [0:8]
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
stats out."section.txt" using 1:2 nooutput
set xrange [STATS_min_x - 0.05:STATS_max_x + 0.05]
set yrange [STATS_min_y - 0.05:STATS_max_y + 0.05]
set title "Section through the axis"
plot out."section.txt" using 1:2:3 with points pt 5 ps spacing / 23.0 / (STATS_max_y > 6 ? 4 : 2) / 1.3 palette notitle
set size noratio
unset colorbox
set size 0.44,0.34; set origin 0.56,0.66
set title "Velocity along the axis"
set xrange [-2:15]; set yrange [1e-5:2]; set logscale y; set format y "10^{%L}"
set xlabel "velocity / superficial velocity"; set ylabel "density"
plot out."speeds.txt" using 1:2 with lines lw 2 lc rgb "#1f6fb4" notitle
unset logscale y; set format y "%g"
set origin 0.56,0.33
set title "Force along the axis on each bead"
set xrange [0:3]; set yrange [0:*]
set xlabel "force / mean force"
plot out."forces.txt" using 1:2 with histeps lw 2 lc rgb "#d7301f" notitle
set origin 0.56,0
set title "Porosity near the wall"
set xrange [0:5]; set yrange [0:1]
set xlabel "distance from the wall, diameters"; set ylabel "porosity"
plot out."profile.txt" using 1:2 with lines lw 2 lc rgb "#1f6fb4" title "this packing", \
    out."profile.txt" using 1:3 with lines dt 2 lw 1.5 lc rgb "#d7301f" title "de Klerk 2003", \
    out."profile.txt" using 1:4 with lines dt 3 lw 1.5 lc rgb "#444444" title "Mueller 1992"
unset multiplot
