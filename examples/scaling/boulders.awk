# The spheres of boulders.yaml; variables: blocks (along x), cells (places along the edge of a subdomain; a block has 3 x 3 x 3)
function gap(a, side) { # distance from the boulder's centre along an axis, nearest image
    a = a - int(a / side) * side - side / 2
    return a < 0 ? -a : a
}
BEGIN {
    side = 3 * cells
    boulder = 0.8 * cells
    print "x y z radius"
    for (b = 0; b < blocks; b++)
        printf "%g %g %g %g\n", (b + 0.5) * side, side / 2, side / 2, boulder
    for (i = 0; i < blocks * side; i++)
        for (j = 0; j < side; j++)
            for (k = 0; k < side; k++)
                if (gap(i + 0.5, side) ^ 2 + gap(j + 0.5, side) ^ 2 + gap(k + 0.5, side) ^ 2 > (boulder + 0.5) ^ 2)
                    printf "%g %g %g 0.46\n", i + 0.5, j + 0.5, k + 0.5
}
