# The plot of a case that has none of its own: rows `x reference computed` of the file curve, labels x and y
set xlabel x
set ylabel y
plot out . "curve" using 1:2 with lines ls 1 title "reference", out . "curve" using 1:3 ls 2 title "scree"
