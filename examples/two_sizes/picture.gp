# A section along the stream at two times: speed of the fluid, the rock, small grains near the section; variable: out
set terminal pngcairo size 1000,400 font "sans,11"
set output out . "two-sizes.png"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
set cbrange [0:2]
unset key
unset xtics
unset ytics
set size ratio -1
set xrange [0:1.5]
set yrange [0:1]
set object 1 circle at 0.75,0.5 size 0.26 fs solid fc rgb "#8a8178" front
set multiplot layout 1,2 margins 0.01,0.9,0.03,0.9 spacing 0.02
do for [k = 1:2] {
    set title sprintf("t = %.1f", 0.4 * k)
    if (k == 1) { unset colorbox } else { set colorbox user origin 0.92,0.1 size 0.02,0.75; set cblabel "speed" }
    plot out . sprintf("fluid-%d.txt", 400 * k) using 1:2:3 with points pt 5 ps 3.4 palette, \
        out . sprintf("small-%d.txt", 400 * k) using 1:2 with points pt 7 ps 0.5 lc rgb "#ffffff"
}
unset multiplot
