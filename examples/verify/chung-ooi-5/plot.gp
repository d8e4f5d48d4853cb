set xlabel "v_t / (mu v_n) before"
set ylabel "recoil of the surface / (mu v_n)"
set xrange [0:14]
set yrange [-3:7]
plot out . "steel" using 1:2 with lines ls 1 title "reference, steel", out . "polyethylene" using 1:2 with lines ls 3 title "polyethylene", \
    out . "steel" using 1:3 ls 2 title "scree, steel", out . "polyethylene" using 1:3 ls 4 title "polyethylene"
