# Turns the published list of particles (header; radius x y z) into a LAMMPS data file, units si: type 1 the glass spheres of
# radius 1 mm (M1), type 2 those of radius 2 mm (M2).
NR > 1 && NF == 4 {
    n++
    large = $1 > 0.0015
    row[n] = sprintf("%d %d %s %d %s %s %s", n, 1 + large, 2 * $1, large ? 2000 : 2500, $2, $3, $4)
}
END {
    print "rotating drum with spheres of two sizes, units si\n"
    print n " atoms\n2 atom types\n"
    print "-0.1 0.1 xlo xhi\n-0.03 0.03 ylo yhi\n-0.1 0.1 zlo zhi\n"
    print "Atoms # sphere\n"
    for (i = 1; i <= n; i++)
        print row[i]
}
