# The bed, the boulder and the speed of the liquid at three times; variable: out
set terminal pngcairo size 560,760 font "sans,11"
set output out . "scour.png"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
set cbrange [0:1]
unset key
unset xtics
unset ytics
set size ratio -1
set xrange [0:160]
set yrange [0:80]
set multiplot layout 3,1 margins 0.01,0.86,0.01,0.95 spacing 0.05
do for [k = 0:2] {
    frame = word("16000 32000 64000", k + 1)
    set title sprintf("t = %d", frame * 0.01)
    if (k == 2) { set cblabel "speed"; set colorbox user origin 0.9,0.1 size 0.015,0.75 } else { unset colorbox }
    plot out . "fluid-" . frame . ".txt" using 1:2:3 with image, \
        out . "discs-" . frame . ".txt" using 1:2:4 with circles fs solid 1 border lc rgb "black" fc rgb "#d9b26a"
}
unset multiplot
