# Rows of the table of growth: measured ones from the lines of examples/bench/growth.sh, then the model of docs/scaling.md for 10^10 particles on
# 10^5 ranks of one core. Call: awk -f growth.awk growth.jsonl scaling.md
function value(key, rest) {
    if (!match($0, "\"" key "\": ")) return ""
    rest = substr($0, RSTART + RLENGTH)
    sub(/^"/, "", rest)
    sub(/[",}].*/, "", rest)
    return rest
}
function power(n, e) { # 10000 as 10⁴
    split("⁰ ¹ ² ³ ⁴ ⁵ ⁶ ⁷ ⁸ ⁹", high, " ")
    e = int(log(n) / log(10) + 0.5)
    return "10" high[e + 1]
}
BEGIN {
    title["gas"] = "gas, a fifth solid"
    title["bed"] = "bed, 0.55 solid"
    title["particles"] = "packing, sizes 1 to 10, 0.4 solid"
    print "| scene | code | cores | particles | million updates a second and core | bytes a particle |"
    print "|---|---|---|---|---|---|"
}
/"conditions"/ {
    split($0, part, / \| /)
    machine = part[3]
    sub(/,.*/, "", machine)
}
/"series"/ && value("series") in title {
    printf "| %s | **scree** | %d of %s | %s | %.1f | %.0f |\n", title[value("series")], value("threads"), machine, power(value("particles")),
        1e3 / value("ns_per_particle") / value("threads"), value("bytes_per_particle")
}
/^\| 100,000 \| 100,000 \|/ {
    n = split($0, part, / *\| */)
    if (n == 11) step = part[9]
    else if (n == 8 && !bytes) bytes = part[4]
}
END { if (step) printf "| gas, a fifth solid | **scree**, modelled | 10⁵ | 10¹⁰ | %.1f | %.0f |\n", 100000 / step / 1e3, bytes * 1e6 / 100000 }
