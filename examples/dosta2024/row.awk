# The last line of run.sh becomes a row of rows.tsv; variables: short (not empty: the result is left out, unless it is that of a whole run), load, when
function value(key, rest) {
    if (!match($0, "\"" key "\": ")) return "-"
    rest = substr($0, RSTART + RLENGTH)
    if (rest ~ /^"/) { rest = substr(rest, 2); sub(/".*/, "", rest) } else sub(/[,}].*/, "", rest)
    return rest
}
BEGIN { OFS = "\t" }
/"case"/ {
    what = value("step") == "solver" ? "solver" : "Hertz"
    print value("case"), "scree", sprintf("%s, %.3g us%s", what, 1e6 * value("dt"), short == "" ? "" : ", the beginning"), value("cpu"), value("cores"), value("particles"), value("steps"),
        sprintf("%.4g", value("seconds")), sprintf("%.4g", value("updates_per_core_second") * value("cores")), short == "" || value("case") == "impact25" ? value("result") : "-", when,
        "examples/dosta2024/run.sh; revision " value("revision") (load > 0.5 ? "; load before " load : "")
}
