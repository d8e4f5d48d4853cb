set xlabel "angle of impact (degrees)"
set ylabel "m/s"
plot out . "oxide" using 1:2 with lines ls 1 title "tangential velocity, reference", out . "oxide" using 1:3 ls 2 title "scree, oxide", \
    out . "aluminium" using 1:3 ls 5 title "aluminium", \
    out . "oxide" using 1:(-$4) with lines ls 3 title "spin times radius, reference", out . "oxide" using 1:(-$5) ls 4 title "scree, oxide", \
    out . "maw-curve" using 1:2 with lines lc rgb "#7a7a7a" dt 3 lw 2 title "Maw et al. (not judged)", \
    out . "maw-curve" using 1:(-$3) with lines lc rgb "#7a7a7a" dt 3 lw 2 notitle, \
    out . "measured-velocity" with points pt 8 ps 0.9 lw 1.5 lc rgb "#000000" title "measured, oxide (not judged)", \
    out . "measured-spin" using 1:(-$2) with points pt 8 ps 0.9 lw 1.5 lc rgb "#000000" notitle
