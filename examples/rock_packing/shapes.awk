# SPDX-License-Identifier: BSD-3-Clause
# Prints the corners of a shape, "x,y,z,x,y,z,...": awk -v shape=NAME -f shapes.awk
function corner(x, y, z) { list = list (list == "" ? "" : ",") sprintf("%.12g,%.12g,%.12g", a * x, b * y, c * z) }
# All signs of x, y and z, in the three orders x y z, y z x, z x y
function turns(x, y, z,    i, j, k) {
    for (i = -1; i < 2; i += 2) for (j = -1; j < 2; j += 2) for (k = -1; k < 2; k += 2) {
        if ((x == 0 && i < 0) || (y == 0 && j < 0) || (z == 0 && k < 0)) continue
        corner(i * x, j * y, k * z); corner(j * y, k * z, i * x); corner(k * z, i * x, j * y)
    }
}
# A football of 60 corners, three faces at each, so that its rounding has no more; stretched
function round_shape(along_x, along_y, along_z) {
    a = along_x; b = along_y; c = along_z
    turns(0, 1, 3 * g); turns(1, 2 + g, 2 * g); turns(g, 2, 2 * g + 1)
}
# 48 corners on x^4 + y^4 + z^4 = 1, with faces along those of a cube, an octahedron and its edges
function superball(    s) {
    s = (0.3 ^ 4 + 0.65 ^ 4 + 1) ^ -0.25
    turns(0.3 * s, 0.65 * s, s); turns(0.65 * s, 0.3 * s, s)
}
BEGIN {
    g = (1 + sqrt(5)) / 2; a = b = c = 1
    if (shape == "tetrahedron") { corner(1, 1, 1); corner(1, -1, -1); corner(-1, 1, -1); corner(-1, -1, 1) }
    else if (shape == "octahedron") turns(0, 0, 1)
    else if (shape == "cube") for (i = -1; i < 2; i += 2) for (j = -1; j < 2; j += 2) for (k = -1; k < 2; k += 2) corner(i, j, k)
    else if (shape == "dodecahedron") {
        turns(0, 1 / g, g)
        for (i = -1; i < 2; i += 2) for (j = -1; j < 2; j += 2) for (k = -1; k < 2; k += 2) corner(i, j, k)
    }
    else if (shape == "ball") round_shape(1, 1, 1)
    else if (shape == "oblate") round_shape(1.9, 1.9, 1)
    else if (shape == "triaxial") round_shape(1.25, 1, 0.8)
    else if (shape == "superball") superball()
    else exit 1
    print list
}
