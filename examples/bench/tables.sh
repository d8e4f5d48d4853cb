# SPDX-License-Identifier: BSD-3-Clause
# Sourced by page.sh (sh): values out of the results of benchmarks, tables, pictures, and what is missing. Wants `here`, `results`,
# `documents` and `data`.

# fields FILE PATTERN KEY...: the values of the keys in the lines with the pattern, by |; nothing where a key is not there
fields() {
    file=$results/$1.jsonl pattern=$2
    shift 2
    test ! -s "$file" || grep -E "$pattern" "$file" | awk -v keys="$*" '
        BEGIN { n = split(keys, key, " ") }
        {
            row = ""
            for (k = 1; k <= n; k++) {
                line = $0
                m = split(key[k], part, "/") # OUTER/KEY: the key inside of an object
                if (m == 2) {
                    gsub(/_/, " ", part[1])
                    at = index(line, "\"" part[1] "\": {")
                    line = at ? substr(line, at) : ""
                }
                v = ""
                if (match(line, "\"" part[m] "\": (\"[^\"]*\"|[^\",}]*)")) {
                    v = substr(line, RSTART + length(part[m]) + 4, RLENGTH - length(part[m]) - 4)
                    gsub(/"/, "", v)
                }
                row = row (k > 1 ? "|" : "") v
            }
            print row
        }'
}

# table HEADING...: rows by | from the standard input as a table; a heading may end in :SCALE (times) and :SCALE:DIGITS
table() {
    awk -F'|' -v OFS=' | ' -v headings="$(printf '%s|' "$@")" '
        BEGIN {
            n = split(headings, heading, "|") - 1
            for (k = 1; k <= n; k++) {
                m = split(heading[k], part, ":")
                name[k] = part[1]
                scale[k] = m > 1 ? part[2] : ""
                digits[k] = m > 2 ? part[3] : 3
            }
        }
        NR == 1 {
            line = "|"
            rule = "|"
            for (k = 1; k <= n; k++) { line = line " " name[k] " |"; rule = rule "---|" }
            print line
            print rule
        }
        {
            line = "|"
            for (k = 1; k <= n; k++) {
                v = $k
                if (scale[k] != "" && v ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/) v = sprintf("%." digits[k] "g", v * scale[k])
                if (v ~ /e\+/) v = sprintf("%.0f", v)
                line = line " " (v == "" || v == "null" ? "–" : v) " |"
            }
            print line
        }'
}

# done_for NAME...: is there a result of any of these? Says which are missing
done_for() {
    some= missing= broken=
    for name; do
        if grep -q -e '"summary": true' -e '"loop_ratio' -e '"variant"' "$results/$name.jsonl" 2>/dev/null; then
            some=yes
        elif [ -e "$results/$name.failed" ]; then
            broken="$broken $name"
        else
            missing="$missing $name"
        fi
    done
    test -z "$missing" || echo "Not run yet: \`examples/bench/report.sh --only \"${missing# }\"\`."
    test -z "$broken" || echo "Failed: \`examples/bench/report.sh --only \"${broken# }\"\` tries again."
    test -n "$some" || return 1
    test -z "$missing$broken" || echo
}

# plot NAME WIDTH,HEIGHT: gnuplot's commands from the standard input make images/performance-NAME.svg, and a link to it
plot() {
    if ! command -v gnuplot >/dev/null; then
        echo "(No picture: gnuplot is not there.)"
        cat >/dev/null
        return
    fi
    {
        echo "out = '$data/'; picture = '$documents/images/performance-$1.svg'"
        cat "$here/../verify/style.gp"
        echo "set terminal svg size $2 font 'sans,12' background 'white' noenhanced; set output picture; set key inside top right vertical font ',10'"
        echo "set style line 6 lc rgb '#8d5a97' pt 9 ps 0.6 lw 1.5; set style line 7 lc rgb '#6c757d' lw 1.5 dt 3; set datafile separator '|'"
        cat
    } | gnuplot || { echo "page.sh: no picture $1" >&2; return; }
    printf '\n![%s](images/performance-%s.svg)\n' "$1" "$1"
}

# having PATTERN WORD...: for how many words the file, with the word for %, holds something; 1 at least
having() {
    pattern=$1
    shift
    n=0
    for word; do
        test ! -s "$(echo "$pattern" | sed "s/%/$word/")" || n=$((n + 1))
    done
    echo $((n > 0 ? n : 1))
}
