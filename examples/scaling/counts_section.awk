# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/scaling.md from the lines of counts.sh
function of(key) {
    match($0, "\"" key "\": \"?[^\",}]*")
    text = substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4)
    sub(/^"/, "", text)
    return text
}
# the power of the number by which a value grows from the line before
function growth(value, before, n, n_before) {
    return value > 0 && before > 0 && n > n_before ? sprintf("%.2f", log(value / before) / log(n / n_before)) : "–"
}
{
    k = ++lines[of("kind")]
    key = of("kind") k
    n = of(of("kind"))
    row[key] = "| " of("scene") " | " n " | " of("particles") " | "
    busy[key] = of("instructions")
    count[key] = n
    scene[key] = of("scene")
    before = of("kind") (k - 1)
    same = k > 1 && scene[before] == scene[key]
    if (of("kind") == "threads") {
        row[key] = row[key] sprintf("%.4g | %.4g | %s | %.3g | %.1f %% | %.3g | %.3g |", of("all") / 1e6, busy[key] / 1e6,
            same ? growth(busy[key], busy[before], n, count[before]) : "–", of("alone") / 1e3, 100 * of("alone") / busy[key], of("regions"), of("barriers"))
    } else {
        row[key] = row[key] sprintf("%.4g | %s | %.4g | %.4g | %.4g | %.4g |", busy[key] / 1e6, same ? growth(busy[key], busy[before], n, count[before]) : "–",
            of("messages"), of("bytes") / 1e3, of("collectives"), of("memory"))
    }
}
END {
    print ""
    print "## Threads and ranks by counting"
    print ""
    print "`examples/scaling/counts.sh` writes this section. valgrind counts the instructions of the loop, without the set-up, so the machine and its other"
    print "work do not matter. A step of grains has a share of two rebuilds in 16 steps; a step of the fluid has all its solves."
    print "`sizes` are spheres of radii 1 and 10. The power says how the instructions grow from the row above: -1 is perfect for threads, 0 for ranks."
    print ""
    print "On threads the scene stays the same. \"Alone\" are the instructions of the first thread outside of parallel regions."
    print ""
    print "| scene | threads | particles | all threads, million a step | busiest | power | alone, thousand | of the busiest | regions | barriers inside |"
    print "|---|---|---|---|---|---|---|---|---|---|"
    for (k = 1; k <= lines["threads"]; k++) print row["threads" k]
    print ""
    print "On ranks of one thread gas, bed and fluid grow with the ranks; `sizes` stays the same. The instructions are those of one rank, without those of"
    print "MPI and of the C library. Messages and bytes are sent by a rank in a step; bytes of the fluid's solves are left out."
    print ""
    print "| scene | ranks | particles | million a step | power | messages | kB | collective calls | MB held |"
    print "|---|---|---|---|---|---|---|---|---|"
    for (k = 1; k <= lines["ranks"]; k++) print row["ranks" k]
}
