# A silo: grains above the orifice. Result: the rate of discharge in 1/s, over 0.1 s ... 0.3 s or 0.1 s ... 1 s of a short run, or
# 0.5 s ... 3.5 s. Passed: within 5 % of the mean of the other codes over the same time; of M2, which has one other code, within 10 % of that.
BEGIN {
    if (name ~ /m1$/) curves_read(name)
    published["silo-large-m2"] = 21700
    published["silo-small-m2"] = 7200
}
{
    t[++n] = $1
    left[n] = $place["left"]
}
function ours_at(time, i) {
    for (i = 1; i < n && t[i] < time * (1 - 1e-9); i++)
        ;
    return left[i]
}
END {
    from = 0.1
    to = 0.3
    if (t[n] >= 1 - 1e-6) to = 1
    if (t[n] >= 3.5 * (1 - 1e-6)) {
        from = 0.5
        to = 3.5
    }
    whole = t[n] >= to * (1 - 1e-6)
    rate = (ours_at(from) - ours_at(to)) / (to - from)
    allowed = codes ? 0.05 : 0.1
    reference = codes ? 0 : published[name]
    for (k = 1; k <= codes; k++)
        reference += (curve_at(code[k], 2, from) - curve_at(code[k], 2, to)) / (to - from) / codes
    passed = whole && rate > reference * (1 - allowed) && rate < reference * (1 + allowed)
    paper = name == "silo-large-m1" ? "\"paper\": 23200, " : ""
    verdict_print(whole ? sprintf("%.1f", rate) : "null", sprintf("%.1f", reference), paper sprintf("\"from\": %g, \"to\": %g, \"left\": %d, \"end_at\": %.4f, \"codes\": %d", from, to, left[n], t[n], codes ? codes : 1), passed)
    exit !passed
}
