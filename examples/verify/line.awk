# The line of a case from its figures; variables: name, status
$7 == "shown" { next }
{
    split($5, bound, " ")
    share = $7 != "passed" ? 1e9 : $4 != "" && bound[1] > 0 ? $4 / bound[1] : 0
    if (!judged++ || share > most) {
        most = share
        figure = ($4 != "" ? $4 : $3) " (" $1 ")"
        tolerance = $4 != "" ? $5 : $2
    }
}
END {
    if (!judged) figure = tolerance = "none"
    printf "%s: %s, %s, %s\n", name, status == 0 ? "passed" : "failed", figure, tolerance
}
