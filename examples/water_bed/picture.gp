# The discs and the speed of the water at four times; variable: out
set terminal pngcairo size 960,320 font "sans,11"
set output out . "water-bed.png"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
set cbrange [0:1]
unset key
unset xtics
unset ytics
set size ratio -1
set xrange [0:88]
set yrange [0:104]
set multiplot layout 1,4 margins 0.01,0.9,0.02,0.92 spacing 0.01
do for [k = 0:3] {
    frame = word("4800 14400 33600 96000", k + 1)
    set title sprintf("t = %d", frame * 0.00625)
    if (k == 3) { set cblabel "speed"; set colorbox user origin 0.92,0.1 size 0.015,0.75 } else { unset colorbox }
    plot out . "fluid-" . frame . ".txt" using 1:2:3 with image, \
        out . "discs-" . frame . ".txt" using 1:2:4 with circles fs solid 1 border lc rgb "black" fc rgb "#d9b26a"
}
unset multiplot
