# Grains and liquid seen from the side, at the end of two runs; variable: out
set terminal pngcairo size 1000,430 font "sans,11"
set output out . "bed-erosion.png"
set palette defined (0 "#0b1d51", 0.25 "#1f6fb4", 0.5 "#5fc3c0", 0.75 "#f5e06e", 1 "#d7301f")
unset key
unset xtics
unset ytics
set size ratio -1
set xrange [0:12]
set yrange [0:9.6]
set multiplot layout 1,2 margins 0.01,0.88,0.03,0.9 spacing 0.02
do for [k = 0:1] {
    force = word("0.02 0.2", k + 1)
    set title "Shields number " . word("0.05 0.47", k + 1)
    if (k == 0) { unset colorbox } else { set colorbox user origin 0.9,0.1 size 0.02,0.75; set cblabel "velocity along the channel" }
    set cbrange [0:1.5]
    plot out . "force-" . force . "-liquid.txt" using 1:2:3 with points pt 5 ps 6.8 palette, \
        out . "force-" . force . "-grains.txt" using 1:2:4:3 with circles fs solid border lc rgb "#444444" palette
}
unset multiplot
