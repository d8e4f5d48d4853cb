set xlabel "angle of impact (degrees)"
set ylabel "m/s"
plot out . "oxide" using 1:2 with lines ls 1 title "tangential velocity, reference", out . "oxide" using 1:3 ls 2 title "scree, oxide", \
    out . "aluminium" using 1:3 ls 5 title "aluminium", \
    out . "oxide" using 1:(-$4) with lines ls 3 title "spin times radius, reference", out . "oxide" using 1:(-$5) ls 4 title "scree, oxide"
