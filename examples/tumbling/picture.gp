# The discs and the speed of the fluid at six times; variable: out
set terminal pngcairo size 1080,520 font "sans,11"
set output out . "tumbling.png"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
set cbrange [0:1.8]
unset key
unset xtics
unset ytics
set size ratio -1
set xrange [0:2]
set yrange [0:5]
set multiplot layout 1,6 margins 0.01,0.9,0.02,0.93 spacing 0.01
do for [k = 0:5] {
    set title sprintf("t = %.1f s", k * 0.5)
    if (k == 5) { set cblabel "speed, cm/s" } else { unset colorbox }
    if (k == 5) { set colorbox user origin 0.92,0.1 size 0.015,0.75 }
    plot out . sprintf("fluid-%d.txt", 500 * k) using 1:2:3 with points pt 5 ps 0.45 palette, \
        out . sprintf("discs-%d.txt", 500 * k) using 1:2:4:(int($0)) with circles fs solid border lc rgb "#e9c46a" lw 1
}
unset multiplot
