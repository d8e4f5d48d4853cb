# SPDX-License-Identifier: BSD-3-Clause
# What a packing of equal beads in a column is like: awk -v column=RADIUS -v height=HEIGHT -v profile=FILE -f packing.awk packing.txt
# Reads lines "radius x y z", axis z, heights 0 ... HEIGHT. Writes the porosity against the distance from the wall to FILE, with that of
# de Klerk, AIChE J. 49 (2003) 2022, and of Mueller, Powder Technol. 72 (1992) 269; prints one line of JSON.
# Local porosities come from POINTS points in each bead. The packing repeats along the axis; the porosity at the joint is that within a radius of height 0.
function floor(x) { return x < 0 && x != int(x) ? int(x) - 1 : int(x) }
function bessel(x,    k, sum) { # J0, as a mean of cos(x sin t)
    for (k = 0; k < 64; k++) sum += cos(x * sin((k + 0.5) * pi / 64))
    return sum / 64
}
function de_klerk(s) {
    return s <= 0.637 ? 2.14 * s * s - 2.53 * s + 1 : bulk + 0.29 * exp(-0.6 * s) * cos(2.3 * pi * (s - 0.16)) + 0.15 * exp(-0.9 * s)
}
function mueller(s,    across, far) {
    across = column / r
    far = 0.365 + 0.22 / across
    return far + (1 - far) * bessel((across < 13 ? 7.45 - 3.15 / across : 7.45 - 11.25 / across) * s) * exp(-(0.315 - 0.725 / across) * s)
}
# Points spread evenly over the unit ball: the fractions of multiples of three numbers that go together badly
function points_make(    k, cosine, turn, reach) {
    for (k = 0; k < points; k++) {
        cosine = 2 * fraction(k * 0.8191725134 + 0.5) - 1
        turn = 2 * pi * fraction(k * 0.6710436067)
        reach = fraction(k * 0.5497004779 + 0.5) ^ (1 / 3)
        px[k] = reach * sqrt(1 - cosine * cosine) * cos(turn)
        py[k] = reach * sqrt(1 - cosine * cosine) * sin(turn)
        pz[k] = reach * cosine
    }
}
function fraction(x) { return x - int(x) }
function cell(v) { return floor(v / (2.1 * r)) }
BEGIN { pi = atan2(0, -1); points = points ? points : 400; step = 0.05 }
/^#/ { next }
{ n++; r = $1; x[n] = $2; y[n] = $3; z[n] = $4 }
END {
    if (!(r > 0)) exit 1
    points_make()
    d = 2 * r
    volume = 4 / 3 * pi * r ^ 3
    for (i = 1; i <= n; i++)
        for (k = 0; k < points; k++) {
            h = z[i] + r * pz[k]
            if (h > height / 2) h -= height
            if (h > -r && h < r) joint += volume / points
            u = x[i] + r * px[k]
            v = y[i] + r * py[k]
            s = (column - sqrt(u * u + v * v)) / d
            solid[floor(s / step)] += volume / points
        }
    bins = int(column / d / step)
    for (b = 0; b < bins; b++) {
        outer = column - b * step * d
        inner = column - (b + 1) * step * d
        shell[b] = pi * (outer ^ 2 - inner ^ 2) * height
        if ((b + 0.5) * step > 3) { far_solid += solid[b]; far_shell += shell[b] }
    }
    bulk = 1 - far_solid / far_shell
    for (b = 0; b < bins; b++) {
        s = (b + 0.5) * step
        local = 1 - solid[b] / shell[b]
        printf "%g %.5f %.5f %.5f\n", s, local, de_klerk(s), mueller(s) >profile
        if (s < 4) { count++; klerk += (local - de_klerk(s)) ^ 2; mull += (local - mueller(s)) ^ 2 }
    }
    for (i = 1; i <= n; i++) {
        key = cell(x[i]) " " cell(y[i]) " " cell(z[i])
        held[key] = held[key] " " i
    }
    for (i = 1; i <= n; i++)
        for (a = -1; a <= 1; a++) for (b = -1; b <= 1; b++) for (c = -1; c <= 1; c++) {
            m = split(held[cell(x[i]) + a " " cell(y[i]) + b " " cell(z[i]) + c], near, " ")
            for (k = 1; k <= m; k++) {
                j = near[k]
                apart = sqrt((x[i] - x[j]) ^ 2 + (y[i] - y[j]) ^ 2 + (z[i] - z[j]) ^ 2)
                if (j == i) continue
                if (j > i && d - apart > deepest) deepest = d - apart
                # beads away from the wall and from the joint
                inner = column - sqrt(x[i] ^ 2 + y[i] ^ 2) > 2 * d && z[i] > 2 * d && z[i] < height - 2 * d
                if (inner && apart < d) touching++
                if (inner && apart < 1.01 * d) close_by++
            }
        }
    for (i = 1; i <= n; i++)
        insiders += column - sqrt(x[i] ^ 2 + y[i] ^ 2) > 2 * d && z[i] > 2 * d && z[i] < height - 2 * d
    insiders = insiders ? insiders : 1
    printf "{\"beads\": %d, \"diameter_um\": %.6g, \"column_mm\": %.6g, \"height_mm\": %.6g, \"porosity\": %.5f, \"porosity_bulk\": %.5f, \"porosity_joint\": %.5f, " \
        "\"from_de_klerk\": %.4f, \"from_mueller\": %.4f, \"coordination\": %.3f, \"neighbours_to_1_percent\": %.3f, \"overlap_percent\": %.3f}\n",
        n, d * 1e6, 2 * column * 1e3, height * 1e3, 1 - n * volume / (pi * column ^ 2 * height), bulk, 1 - joint / (pi * column ^ 2 * d), sqrt(klerk / count),
        sqrt(mull / count), touching / insiders, close_by / insiders, 100 * deepest / d
}
