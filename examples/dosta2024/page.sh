#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Writes docs/benchmarks.md and its picture from the rows: page.sh [DOCUMENTS]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
documents=${1:-$here/../../docs}
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$documents/images"

# The rows by case, fastest first; a row with its rate a core
grep -v '^#' "$here/rows.tsv" | awk -F'\t' -v OFS='\t' -v cases="impact25 impact50 impact100 silo-large-m1 silo-small-m1 silo-large-m2 silo-small-m2 drum" '
    BEGIN { n = split(cases, name, " "); for (k = 1; k <= n; k++) place[name[k]] = k }
    NR == 1 { next }
    !($1 in place) || NF != 12 { print "rows.tsv: not a row: " $0 >"/dev/stderr"; exit 1 }
    { print place[$1], $8 == "-" ? 1e9 : $8, $0 }' >"$work/placed"
sort -s -t "$(printf '\t')" -k1,1n -k2,2g "$work/placed" | cut -f 3- >"$work/rows"

{
    cat "$here/page.head.md"
    # what a newcomer needs first: the rates of a core of each code that was timed on cores
    awk -F'\t' '
        function place(c, k) { for (k = n++; k > 0 && high[order[k - 1]] < high[c]; k--) order[k] = order[k - 1]; order[k] = c }
        function range(low, high) { return sprintf(low < 0.95 * high ? "%.2g to %.3g" : "%.3g", low < 0.95 * high ? low : high, high) }
        $5 != "-" && $9 != "-" && $3 !~ /solver|impulses|moduli/ {
            code = $2
            sub(/ .*/, "", code)
            rate = $9 / $5 / 1e6
            if (!(code in high) || rate > high[code]) high[code] = rate
            if (!(code in low) || rate < low[code]) low[code] = rate
            machine[code] = $4
        }
        END {
            for (code in high) place(code)
            printf "**Million particle updates a second and core:"
            for (k = 0; k < n; k++) printf "%s %s %s (%s)", k ? "," : "", order[k], range(low[order[k]], high[order[k]]), machine[order[k]]
            print ".**\n"
        }' "$work/rows"
    if command -v gnuplot >/dev/null; then
        # a point a row: place of the case, million updates a second of a core or of a card, one file a code
        awk -F'\t' -v work="$work" '
            $9 == "-" || $3 ~ /impulses|solver/ { next }
            { code = $2; sub(/ .*/, "", code); print $1 "\t" ($5 == "-" ? $9 : $9 / $5) / 1e6 >(work "/points-" code) }' "$work/rows"
        gnuplot -e "work='$work'; cases='$(cut -f 1 "$work/rows" | uniq | tr '\n' ' ')'; picture='$documents/images/benchmarks.svg'" "$here/page.gp"
    fi
    printf '![Million particle updates a second, of a core or of a graphics card](images/benchmarks.svg)\n\n'
    echo '| case | code | hardware | seconds | million updates a second | a core | result | error |'
    echo '|---|---|---|---|---|---|---|---|'
    awk -F'\t' '
        function million(x) { return sprintf(x < 1e7 ? "%.2f" : x < 1e8 ? "%.1f" : "%.0f", x / 1e6) }
        # a result is x, x+-s (mean and spread of seeds), or x/y, where the other codes have y over the same time
        function shown(x) { sub(/\/.*/, "", x); sub(/\+-/, " ± ", x); return x }
        function off(x, all, part) { return split(x, part, "/") == 2 ? part[1] / part[2] - 1 : x / all - 1 }
        NR == FNR {
            if ($2 ~ /^(MUSEN|LIGGGHTS|peclet)/ && $3 ~ /^Hertz/ && $10 != "-") { sum[$1] += $10; codes[$1]++ }
            next
        }
        {
            error = codes[$1] && $10 != "-" ? sprintf("%+.1f %%", 100 * off($10, sum[$1] / codes[$1])) : "–"
            cores = $5 == "-" ? "" : $5 == 1 ? ", 1 core" : ", " $5 " cores"
            mark = $8 != "-" && $12 ~ /shared|load/ ? " (shared)" : ""
            printf "| %s | %s: %s | %s%s | %s%s | %s | %s | %s | %s |\n", $1, $2 ~ /^scree/ ? "**" $2 "**" : $2, $3, $4, cores, $8 == "-" ? "–" : $8, mark,
                $9 == "-" ? "–" : million($9), $5 == "-" || $9 == "-" ? "–" : million($9 / $5), $10 == "-" ? "–" : shown($10), error
        }' "$work/rows" "$work/rows"
    awk -f "$here/growth.awk" "$here/../../docs/results/performance/growth.jsonl" "$here/../../docs/scaling.md" >"$work/growth"
    sed -e "/^@growth@\$/{ r $work/growth" -e 'd; }' "$here/page.tail.md"
} >"$work/page"
cp "$work/page" "$documents/benchmarks.md"
