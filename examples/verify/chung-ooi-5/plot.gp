set xlabel "v_t / (mu v_n) before"
set ylabel "recoil of the surface / (mu v_n)"
set xrange [0:14]
set yrange [-3:7]
plot out . "steel" using 1:2 with lines ls 1 title "reference, steel", out . "polyethylene" using 1:2 with lines ls 3 title "polyethylene", \
    out . "steel" using 1:3 ls 2 title "scree, steel", out . "polyethylene" using 1:3 ls 4 title "polyethylene", \
    out . "maw-steel" using 1:2 with lines lc rgb "#7a7a7a" dt 3 lw 2 title "Maw et al., steel (not judged)", \
    out . "maw-polyethylene" using 1:2 with lines lc rgb "#b0a0c0" dt 3 lw 2 title "polyethylene", \
    out . "finite-elements" using 1:2 with points pt 8 ps 0.9 lw 1.5 lc rgb "#000000" title "finite elements (not judged)"
