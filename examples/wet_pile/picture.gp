# The two piles from the side, shaded by depth; variable: out
set terminal pngcairo size 1300,420 background "#fbfaf7" font "sans,12"
set output out . "wet-pile.png"
set multiplot layout 1,2
set size ratio -1
unset key
unset border
unset tics
unset colorbox
set xrange [-26:26]
set yrange [-1:17]
set palette defined (0 "#f4d58d", 1 "#8d6b3f")
set cbrange [-20:20]
set style fill solid border rgb "#5a4632"
set arrow from -26,0 to 26,0 nohead lw 2 lc rgb "#264653"
do for [pile in "dry wet"] {
    set title pile . " sand after 0.4 s"
    plot out . pile . ".txt" using 2:3:4:1 with circles lc palette
}
unset multiplot
