# The plot of a case that has none of its own: rows `x reference computed` of the file curve, labels x and y
set xlabel x
set ylabel y
stats out . "curve" using 1:2 nooutput
n = 1 + int(STATS_records / 1000) # a picture needs no more points
plot out . "curve" every n using 1:2 with lines ls 1 title "reference", out . "curve" every n using 1:3 ls 2 title "scree"
