# An impact: the ball's displacement, every 0.5 ms, beside the curves of the other codes. Result: the deepest displacement in m until the end.
# Passed: at no time farther outside of the codes than these are apart, or than half of a bead. After the bounce of the shallow bed on its floor, which is
# chaotic, the published runs of ten seeds and several codes end between -0.013 and -0.07 m: the codes then count down to a line that ends at -0.07 m.
BEGIN {
    curves_read(name)
    bead = 0.001
}
NR == 2 { start = $place["ball_z"] }
{
    t[++n] = $1
    z[n] = $place["ball_z"] - start
    if (n == 1 || z[n] < z[deepest])
        deepest = n
}
END {
    for (k = 1; k <= codes; k++) {
        least = 0
        for (i = 1; i <= rows[code[k]] && curve[code[k], 1, i] <= t[n] + 1e-9; i++)
            if (curve[code[k], 2, i] < least) least = curve[code[k], 2, i]
        reference += least / codes
    }
    for (i = 1; i <= n; i++) {
        codes_at(2, t[i])
        seeds = -0.1385 + 0.0685 * (t[i] - 0.0305) / 0.0695
        if (name == "impact25" && t[i] > 0.0305 && seeds < low) low = seeds
        far = outside(z[i], bead)
        if (far > farthest) {
            farthest = far
            when = t[i]
        }
        off += (z[i] > mean ? z[i] - mean : mean - z[i]) / n
        if (i > 1 && far > 1) bad = 1
    }
    codes_at(2, t[n])
    passed = t[n] >= 0.032 * (1 - 1e-6) && !bad
    verdict_print(sprintf("%.5f", z[deepest]), sprintf("%.5f", reference), sprintf("\"deepest_at\": %.4f, \"end\": %.5f, \"end_reference\": %.5f, \"end_at\": %.4f, \"mean_difference\": %.5f, \"farthest_outside\": %.3f, \"farthest_at\": %.4f",
        t[deepest], z[n], mean, t[n], off, farthest, when), passed)
    exit !passed
}
