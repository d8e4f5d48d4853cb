# The layers and what lies before the blade, shaded by depth; variables: out, numbers
set terminal pngcairo size 1400,560 background "#fbfaf7" font "sans,12"
set output out . "blade.png"
set multiplot layout words(numbers),1
set size ratio -1
unset key
unset border
unset tics
unset colorbox
set xrange [0.3:4.3]
set yrange [-0.03:0.75]
set palette defined (0 "#9fb8c4", 1 "#33505e")
set cbrange [0:0.2]
set style fill solid border rgb "#22343d"
set arrow 1 from 0.3,0 to 4.3,0 nohead lw 2 lc rgb "#264653"
set arrow 2 from 3.6,0.1 to 3.6,0.75 nohead lw 3 lc rgb "#e76f51"
do for [number in numbers] {
    set title "Bo = " . number
    plot out . number . ".txt" using 2:3:4:1 with circles lc palette
}
unset multiplot
