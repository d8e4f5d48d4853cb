set xlabel "overlap (µm)"
set ylabel "force (kN)"
k(name) = real(system("cat '" . out . name . ".k'"))
set xrange [0:380]
plot k("glass") * (x * 1e-6) ** 1.5 / 1e3 ls 1 title "Hertz, glass", k("limestone") * (x * 1e-6) ** 1.5 / 1e3 ls 3 title "limestone", \
    out . "glass" using ($2 > 0 ? $2 * 1e6 : NaN):($3 / 1e3) every 40 ls 2 title "scree, glass", \
    out . "limestone" using ($2 > 0 ? $2 * 1e6 : NaN):($3 / 1e3) every 40 ls 4 title "limestone"
