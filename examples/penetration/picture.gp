# The bed cut open along the ball's middle plane; variables: spheres (made by picture.awk, sorted), picture
set terminal pngcairo size 1500,940 background "#fbfaf7"
set output picture
set size ratio -1
unset key
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [-0.0502:0.0502]
set yrange [-0.0915:-0.0285]
plot spheres using 4:5:6:7 with circles fill solid noborder lc rgb variable
