set logscale x
set xlabel "speed of the impact"
set ylabel "restitution"
set yrange [0:1.05]
name(k) = word("viscoelastic thornton sticky eepa luding", k)
text(k) = word("viscoelastic plastic plastic,-sticky EEPA Luding", k)
plot for [k = 1:5] out . name(k) . ".curve" using 1:2 with lines lc k lw 2 title text(k), \
    for [k = 1:5] out . name(k) . ".found" using 1:2 with points lc k pt 7 ps 0.6 notitle
