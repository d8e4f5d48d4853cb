# Variables: curve (curve.awk), before, after (picture.awk, sorted), wide (mm), picture
set terminal pngcairo size 1500,620 background "#fbfaf7" font "sans,13"
set output picture
set multiplot layout 1,3
unset key
set size ratio -1
set xrange [-wide:wide]
set yrange [-0.5:1.1 * wide]
unset tics
unset border
set title "before: grains behind the middle plane"
plot before using 4:5:6:7 with circles fill solid noborder lc rgb variable
set title "after: red where bonds have broken"
plot after using 4:5:6:7 with circles fill solid noborder lc rgb variable
set title "force of the plate"
set size noratio
set border 3
set tics nomirror
set xrange [0:*]
set yrange [0:*]
set y2range [0:*]
set xlabel "way of the plate (mm)"
set ylabel "force (N)"
set y2label "broken bonds"
set y2tics
set key at graph 0.98, graph 0.55 right samplen 2
plot curve using 1:2 with lines lw 2 lc rgb "#264653" title "force", \
    curve using 1:($4 + $5) axes x1y2 with lines lw 2 lc rgb "#e76f51" title "broken bonds"
unset multiplot
