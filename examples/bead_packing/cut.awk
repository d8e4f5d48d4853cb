# SPDX-License-Identifier: BSD-3-Clause
# Cuts COUNT beads out of a dump: awk -v count= -v height= -v floor= -v slack= -f cut.awk dump.lammpstrj
# The cut begins at the first height from FLOOR on, within SLACK, above which HEIGHT holds least beads beyond COUNT, but not fewer. Of those beyond, the ones that
# overlap most across the joint, where the end of the cut meets its beginning, are left out. Prints lines "radius x y z", z from 0.
/^ITEM: TIMESTEP/ { n = reading = 0; next }
/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
/^ITEM/ { reading = 0 }
reading { n++; r[n] = $at["radius"]; x[n] = $at["x"]; y[n] = $at["y"]; z[n] = $at["z"] }
function held(low,    i, sum) {
    for (i = 1; i <= n; i++) sum += z[i] >= low && z[i] < low + height
    return sum
}
END {
    for (k = 0; k <= 200 && best != count; k++) {
        low = floor + slack * k / 200
        inside = held(low)
        if (inside >= count && (best == "" || inside < best)) { best = inside; start = low }
    }
    if (best == "") { print "cut.awk: fewer than " count " beads in every cut" >"/dev/stderr"; exit 1 }
    for (i = 1; i <= n; i++) {
        if (z[i] < start || z[i] >= start + height) continue
        m++
        R[m] = r[i]; X[m] = x[i]; Y[m] = y[i]; Z[m] = z[i] - start
        if (Z[m] < 2 * R[m]) lower[++lowers] = m
        if (Z[m] > height - 2 * R[m]) upper[++uppers] = m
    }
    for (; best > count; best--) {
        deepest = -1
        for (a = 1; a <= uppers; a++)
            for (b = 1; b <= lowers; b++) {
                i = upper[a]; j = lower[b]
                if (gone[i] || gone[j]) continue
                depth = R[i] + R[j] - sqrt((X[i] - X[j]) ^ 2 + (Y[i] - Y[j]) ^ 2 + (Z[i] - height - Z[j]) ^ 2)
                if (depth > deepest) { deepest = depth; worst = i }
            }
        gone[worst] = 1
    }
    for (i = 1; i <= m; i++)
        if (!gone[i]) print R[i], X[i], Y[i], Z[i]
}
