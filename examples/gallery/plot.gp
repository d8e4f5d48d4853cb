# SPDX-License-Identifier: BSD-3-Clause
# The plot of a scene of the gallery: gnuplot -e "name='NAME'; folder='DIR'; picture='FILE'" plot.gp
set terminal pngcairo size 640, 480 font 'sans,12'
set output picture
set datafile separator ','
table = folder.'/observables.csv'
set xlabel 'time in s'
set key top left
if (name eq 'hopper') {
    set ylabel 'mass that has flown out, in g'
    plot table using 'time[s]':(1e3 * column('crossed_mass_outlet[kg]')) with lines lw 2 title ''
}
if (name eq 'drum') {
    set ylabel 'angle of the centre of mass, in degrees'
    plot table using 'time[s]':(abs(atan2(column('centre_x[m]'), -column('centre_z[m]'))) * 180 / pi) with lines lw 2 title ''
}
if (name eq 'shear_cell') {
    set ylabel 'shear stress over normal stress'
    set xlabel 'strain'
    set yrange [0:1]
    plot table using (abs(column('shear_strain[1]'))):(-column('stress_xy[Pa]') / column('stress_yy[Pa]')) every 5 with lines lw 2 title 'this cell', \
        0.38 + 0.26 / (0.279 / (5 * 1e-3 * sqrt(2500. / 100)) + 1) with lines dt 2 lw 2 title 'Jop et al.'
}
if (name eq 'compaction') {
    set ylabel 'pressure on the lid, in kPa'
    set xlabel 'way of the lid, in mm'
    set key off
    plot table using (-1e3 * column('lid_z[m]')):(column('lid_fz[N]') / 7.068583e-4 / 1e3) every ::300 with lines lw 2
}
if (name eq 'pouring') {
    set ylabel 'height of the heap, in mm'
    set y2label 'grains on the table'
    set ytics nomirror
    set y2tics
    plot table using 'time[s]':(1e3 * column('heap[m]')) with lines lw 2 title 'height', \
        '' using 'time[s]':'particles[1]' axes x1y2 with lines lw 2 title 'grains'
}
if (name eq 'sieve') {
    set xlabel 'opening of the sieve, in mm'
    set ylabel 'per cent that passes, by mass'
    set logscale x 2
    set yrange [0:105]
    stats table using (column('s2[kg]') / column('all[kg]')) name 'a' nooutput
    stats table using (column('s4[kg]') / column('all[kg]')) name 'b' nooutput
    stats table using (column('s5.6[kg]') / column('all[kg]')) name 'c' nooutput
    set print $bed
    print sprintf('2,%g', 100 * a_mean); print sprintf('4,%g', 100 * b_mean); print sprintf('5.6,%g', 100 * c_mean)
    unset print
    given = ARG0[1:strlen(ARG0) - 7].'sieves.txt'
    plot '<grep -v "^#" '.given.' | tr " " ,' using 1:2 with lines lw 2 title 'sieves.txt', $bed using 1:2 with points pt 7 ps 1.5 title 'the bed'
}
