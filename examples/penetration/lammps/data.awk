# Turns the published list of particles (header; radius x y z; the last row "5 0.01 0.01 0 0 0.06" is the ball) into a
# LAMMPS data file, units si. Set z and vz with -v to start the ball elsewhere than at 0.06 m and -5 m/s.
BEGIN {
    if (z == "")
        z = 0.06
    if (vz == "")
        vz = -5
}
NR > 1 && NF == 4 {
    n++
    row[n] = sprintf("%d 1 %s 2500 %s %s %s", n, 2 * $1, $2, $3, $4)
}
NR > 1 && NF == 6 {
    n++
    row[n] = sprintf("%d 2 %s 7200 %s %s %s", n, 2 * $2, $4, $5, z)
    ball = n
}
END {
    print "penetration of a bed of glass spheres by a steel ball, units si\n"
    print n " atoms\n2 atom types\n"
    print "-0.049 0.049 xlo xhi\n-0.03 0.03 ylo yhi\n-0.0902431 0.11 zlo zhi\n"
    print "Atoms # sphere\n"
    for (i = 1; i <= n; i++)
        print row[i]
    print "\nVelocities\n"
    for (i = 1; i <= n; i++)
        print i, "0 0", i == ball ? vz : 0, "0 0 0"
}
