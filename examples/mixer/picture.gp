# The drum, the blade, the grains and the dye at four times; variable: out
set terminal pngcairo size 640,612 font "sans,9"
set output out . "mixer.png"
set palette defined (0 "#f4f1de", 0.5 "#81b29a", 1 "#1f4e79")
set cbrange [0:1]
unset key
unset xtics
unset ytics
unset border
set size ratio -1
set xrange [0:80]
set yrange [0:80]
set multiplot layout 2,2 margins 0.01,0.9,0.01,0.95 spacing 0.02,0.05
do for [k = 0:3] {
    frame = word("0 7500 20000 50000", k + 1)
    time = frame * 0.02
    a = 0.02 * time
    u = cos(a)
    v = sin(a)
    set title sprintf("t = %d: %.1f turns", time, a / (2 * pi))
    if (k == 3) { set cblabel "dye"; set colorbox user origin 0.93,0.1 size 0.015,0.75 } else { unset colorbox }
    set object 1 polygon from 40 - 30 * u + 2.5 * v, 40 - 30 * v - 2.5 * u to 40 + 30 * u + 2.5 * v, 40 + 30 * v - 2.5 * u to \
        40 + 30 * u - 2.5 * v, 40 + 30 * v + 2.5 * u to 40 - 30 * u - 2.5 * v, 40 - 30 * v + 2.5 * u to 40 - 30 * u + 2.5 * v, 40 - 30 * v - 2.5 * u \
        fs solid 1 border lc rgb "black" fc rgb "#666666" front
    set object 2 circle at 40,40 size 38 fs empty border lc rgb "black" lw 2 front
    plot out . "dye-" . frame . ".txt" using 1:2:3 with points pt 5 ps 0.72 palette, \
        out . "discs-" . frame . ".txt" using 1:2:3 with circles fs solid 1 border lc rgb "black" fc rgb "#e07a5f"
}
unset multiplot
