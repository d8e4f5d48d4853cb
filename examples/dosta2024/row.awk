# The last line of run.sh becomes a row of rows.tsv; variables: short (not empty: a beginning), load, when. The result of a beginning has behind / the
# reference over the same time; that of several seeds has its spread behind +-. A run of which a part was not timed has no seconds.
function value(key, rest) {
    if (!match($0, "\"" key "\": ")) return "-"
    rest = substr($0, RSTART + RLENGTH)
    if (rest ~ /^"/) { rest = substr(rest, 2); sub(/".*/, "", rest) } else sub(/[,}].*/, "", rest)
    return rest
}
BEGIN { OFS = "\t" }
/"case"/ {
    setting = sprintf("%s, %.3g us", value("step") == "solver" ? "solver" : value("step") == "soft" ? "Hertz, moduli / 100" : "Hertz", 1e6 * value("dt"))
    if (short != "") setting = setting ", the beginning"
    result = value("result") == "null" ? "-" : value("result")
    if (value("seeds") != "-") {
        setting = setting ", mean of " value("seeds") " seeds"
        result = result "+-" value("spread")
    }
    if (short != "" && result != "-") result = value("case") == "drum" ? "-" : result "/" value("reference")
    print value("case"), "scree", setting, value("cpu"), value("cores"), value("particles"), value("steps"), value("timed") == "-" ? sprintf("%.4g", value("seconds")) : "-",
        sprintf("%.4g", value("updates_per_core_second") * value("cores")), result, when,
        "examples/dosta2024/run.sh; revision " value("revision") (load > 0.5 ? "; load before " load : "")
}
