set xlabel "spin before (rad/s)"
set ylabel "spin after (rad/s)"
set y2label "tangential velocity after (m/s)"
set y2tics
set ytics nomirror
plot out . "aluminium" using 1:4 with lines ls 1 title "spin, reference", out . "aluminium" using 1:5 ls 2 title "scree, aluminium", \
    out . "copper" using 1:5 ls 5 title "copper", out . "aluminium" using 1:(-$2) axes x1y2 with lines ls 3 title "velocity, reference", \
    out . "aluminium" using 1:(-$3) axes x1y2 ls 4 title "scree, aluminium"
