# The drum: small and large grains in two quarters. Result of 5 s: the period in s, the mean distance of the peaks and of the troughs of the
# small grains in the lower quarter. Result of less: these grains at the end. Passed: the period within 5 % of the other codes', and until
# 0.7 s all four counts no farther outside of the codes, every 0.1 s, than these are apart, or than 1.5 % of the kind.
BEGIN {
    curves_read("drum")
    split("m1_upper m2_upper m1_lower m2_lower", zone, " ")
    split("30000 8000 30000 8000", all, " ")
}
{
    t[++n] = $1
    small[n] = $place["m1_lower"]
    if (int($1 * 10 + 0.5) / 10 - $1 < 1e-6 && $1 - int($1 * 10 + 0.5) / 10 < 1e-6 && $1 > 0.05 && $1 < 0.75) {
        looked++
        for (k = 1; k <= 4; k++) {
            codes_at(k + 1, $1)
            far = outside($place[zone[k]], 0.015 * all[k])
            if (far > farthest) {
                farthest = far
                when = $1
            }
        }
    }
}
# The mean distance of peaks, and of troughs, of v over the times x, rows 1 to m, from the first peak at 0.6 s on; the extreme of `half` on both sides
function period(x, v, m, half, i, j, top, bottom, last, sum, pairs, kind) {
    for (i = 1; i <= m; i++) {
        top = bottom = x[i] > 0.45 && x[i] < x[m] - half / 2
        for (j = 1; j <= m && (top || bottom); j++)
            if (j != i && x[j] > x[i] - half && x[j] < x[i] + half) {
                if (v[j] > v[i] || v[j] == v[i] && j < i) top = 0
                if (v[j] < v[i] || v[j] == v[i] && j < i) bottom = 0
            }
        if (!top && !bottom)
            continue
        kind = top ? "top" : "bottom"
        if (kind in last) {
            sum += x[i] - last[kind]
            pairs++
        }
        last[kind] = x[i]
    }
    delete last
    return pairs ? sum / pairs : 0
}
END {
    passed = looked > 0 && farthest <= 1
    if (t[n] > 4.9) {
        for (k = 1; k <= codes; k++) {
            m = 0
            for (i = 1; i <= rows[code[k]]; i++) {
                x[++m] = curve[code[k], 1, i]
                v[m] = curve[code[k], 4, i]
            }
            reference += period(x, v, m, 0.5) / codes
        }
        result = period(t, small, n, 0.5)
        passed = passed && result > 0.95 * reference && result < 1.05 * reference
        what = "period"
    } else {
        codes_at(4, t[n])
        result = small[n]
        reference = mean
        what = "small grains in the lower quarter"
    }
    verdict_print(sprintf("%.5g", result), sprintf("%.5g", reference), sprintf("\"what\": \"%s\", \"end_at\": %.4f, \"farthest_outside\": %.3f, \"farthest_at\": %.2f", what, t[n], farthest, when), passed)
    exit !passed
}
