set xlabel "overlap (µm)"
set ylabel "force (kN)"
k(name) = real(system("cat '" . out . name . ".k'"))
set xrange [0:55]
plot k("aluminium") * (x * 1e-6) ** 1.5 / 1e3 ls 1 title "Hertz, aluminium", k("magnesium") * (x * 1e-6) ** 1.5 / 1e3 ls 3 title "magnesium", \
    out . "aluminium" using ($2 > 0 ? $2 * 1e6 : NaN):($3 / 1e3) every 40 ls 2 title "scree, aluminium", \
    out . "magnesium" using ($2 > 0 ? $2 * 1e6 : NaN):($3 / 1e3) every 40 ls 4 title "magnesium"
