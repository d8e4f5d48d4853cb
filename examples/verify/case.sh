# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the check of each case (sh, with `here` set to the case's folder): runs scenes, judges figures.
#
# A check runs its scene with `scene`, takes numbers out with `column`, `final` and awk, and hands each figure to one of
# `judge`, `worst`, `order`, `holds` (or `show`, which judges nothing); it ends with `picture` and `done_with`. A figure that is not a number fails.
#
# Environment, all set by run.sh and all with a default:
#   VERIFY_OUT       folder for the runs and the figures of this case (out/CASE)
#   VERIFY_QUICK     yes: the smaller variant
#   VERIFY_IMAGES    folder for pictures; empty: none
#   VERIFY_RANKS, VERIFY_THREADS, VERIFY_ARGS     layout of the runs, further flags of `scree run`

case=$(basename "$here")
. "$here/../../common.sh"
out=${VERIFY_OUT:-$(results out)}
quick=${VERIFY_QUICK:-no}
export OMP_NUM_THREADS="${VERIFY_THREADS:-1}" OMP_WAIT_POLICY=passive LC_ALL=C
mkdir -p "$out"
: >"$out/figures"

# scene NAME [FLAG...]: runs scene.yaml into $out/NAME; said only if it fails
scene() {
    run=$1
    shift
    # shellcheck disable=SC2086
    on_ranks "${VERIFY_RANKS:-1}" "$SCREE" run "${yaml:-$here/scene.yaml}" -o "$out/$run" --overwrite --quiet "$@" \
        ${VERIFY_ARGS:-} >"$out/$run.log" 2>&1 || {
        cat "$out/$run.log" >&2
        exit 1
    }
}

# by_mode QUICK FULL: one of the two
by_mode() {
    if [ "$quick" = yes ]; then echo "$1"; else echo "$2"; fi
}

# column RUN NAME...: the columns of these names in observables.csv, a row a line, no header
column() {
    file=$out/$1/observables.csv
    shift
    awk -F, -v names="$*" 'NR == 1 { n = split(names, name, " ")
            for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k }
            for (k = 1; k <= n; k++) if (!(name[k] in at)) { print "no column " name[k] >"/dev/stderr"; exit 1 }
            next }
        { for (k = 1; k <= n; k++) printf "%s%s", $at[name[k]], k < n ? " " : "\n" }' "$file"
}

# final RUN: id x y z vx vy vz wx wy wz of the last frame of the dump, by id
final() {
    awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
        reading { line[++n] = $1 " " $5 " " $6 " " $7 " " $8 " " $9 " " $10 " " $11 " " $12 " " $13 }
        END { for (k = 1; k <= n; k++) print line[k] }' "$out/$1/dump.lammpstrj" | sort -n
}

# last_frame RUN: x y z vx vy vz of the last frame of a dump of position and velocity
last_frame() {
    awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
        reading { line[++n] = $3 " " $4 " " $5 " " $6 " " $7 " " $8 }
        END { for (k = 1; k <= n; k++) print line[k] }' "$out/$1/dump.lammpstrj"
}

# report RUN KEY: a number of report.json
report() {
    report_number "$out/$1" "$2"
}

# calc EXPRESSION: by awk, with pi
calc() {
    awk "function abs(x) { return x < 0 ? -x : x } function min(a, b) { return a < b ? a : b } function max(a, b) { return a > b ? a : b }
        function acos(x) { return atan2(sqrt(1 - x * x), x) }
        BEGIN { pi = atan2(0, -1); printf \"%.15g\", $1 }"
}

# judge WHAT REFERENCE COMPUTED TOLERANCE [absolute]: relative error, or absolute
judge() {
    awk -v what="$1" -v r="$2" -v c="$3" -v bound="$4" -v kind="${5:-relative}" '
        function number(x) { return x ~ /^[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$/ }
        BEGIN { error = c - r; error = error < 0 ? -error : error
            if (kind == "relative") error = r == 0 ? error : error / (r < 0 ? -r : r)
            good = number(r) && number(c) && number(bound) && error <= bound
            printf "%s|%.7g|%.7g|%.2g|%s%s||%s\n", what, r, c, error, bound, kind == "absolute" ? " absolute" : "", good ? "passed" : "failed" }' >>"$out/figures"
}

# worst WHAT FILE TOLERANCE [absolute]: rows `x reference computed`; the row with the largest error is shown
worst() {
    line=$(awk -v kind="${4:-relative}" '{ error = $3 - $2; error = error < 0 ? -error : error
            if (kind == "relative" && $2 != 0) error /= $2 < 0 ? -$2 : $2
            if (!(error <= most) || NR == 1) { most = error; row = $2 " " $3 } } END { print row }' "$2")
    # shellcheck disable=SC2086
    judge "$1, $(wc -l <"$2") values" ${line:-nothing nothing} "$3" "${4:-relative}"
}

# show WHAT FILE: as worst by absolute error, but not judged: rows of something that the scene's law does not claim to compute
show() {
    awk -v what="$1" '{ error = $3 - $2; error = error < 0 ? -error : error; if (NR == 1 || error > most) { most = error; row = sprintf("%.7g|%.7g", $2, $3) } }
        END { printf "%s, %d values|%s|%.2g|not judged||%s\n", what, NR, NR ? row : "|", most, NR ? "shown" : "failed" }' "$2" >>"$out/figures"
}

# beside FILE COLUMN CURVE COLUMN: rows `x y` of the first with the curve's value there, between its points on a straight line
beside() {
    awk -v c="$2" -v of="$4" 'FNR == NR { n++; x[n] = $1; y[n] = $of; next }
        { for (k = 1; k < n; k++) if ($1 >= x[k] && $1 <= x[k + 1]) {
            print $1, $c, y[k] + (y[k + 1] - y[k]) * ($1 - x[k]) / (x[k + 1] - x[k]); break } }' "$3" "$1"
}

# order WHAT FILE LEAST [MOST]: rows `dt error`; the slope of log error against log dt is at least LEAST
order() {
    awk -v what="$1" -v least="$3" -v most="${4:-1e9}" '$2 > 0 { x = log($1); y = log($2); n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
        $2 <= 0 { bad = 1 }
        END { slope = n > 1 ? (n * sxy - sx * sy) / (n * sxx - sx * sx) : -1
            good = n > 1 && n == NR && !bad && slope >= least && slope <= most
            printf "%s|%s%s|%.3f||%s|%.2f|%s\n", what, most < 1e9 ? "" : "at least ", least, slope, most < 1e9 ? "up to " most : "none below", slope, good ? "passed" : "failed" }' "$2" >>"$out/figures"
}

# holds WHAT COMPUTED LEAST MOST: within a range
holds() {
    awk -v what="$1" -v c="$2" -v least="$3" -v most="$4" '
        BEGIN { good = c ~ /^[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$/ && c + 0 >= least + 0 && c + 0 <= most + 0
            printf "%s|%s ... %s|%.7g||in the range||%s\n", what, least, most, c, good ? "passed" : "failed" }' >>"$out/figures"
}

# tool NAME: compiles ../NAME.c into $out, once
tool() {
    ${CC:-cc} -O2 -o "$out/$1" "$here/../$1.c" -lm
}

# quoted TEXT: as it stands between two ' of gnuplot
quoted() { echo "$1" | sed "s/'/''/g"; }

# picture [X Y]: the plot.gp of the case, or else the rows `x reference computed` of $out/curve with the labels X and Y, into
# VERIFY_IMAGES
picture() {
    if [ -n "${VERIFY_IMAGES:-}" ] && command -v gnuplot >/dev/null; then
        plot=$here/plot.gp
        [ -e "$plot" ] || plot=$here/../curve.gp
        gnuplot -e "out='$out/'; picture='$VERIFY_IMAGES/verify-$case.svg'; x='$(quoted "${1:-}")'; y='$(quoted "${2:-}")'" "$here/../style.gp" "$plot"
    fi
}

# done_with SOURCE: the last line of a check: where the reference is from; the figures; fails if one failed
done_with() {
    echo "$1" >"$out/source"
    awk -F'|' '{ printf "  %s: %s, reference %s, computed %s, error %s, tolerance %s\n", $7, $1, $2, $3, $4, $5; bad += $7 != "passed" && $7 != "shown" }
        END { if (NR == 0) print "  nothing was judged"; exit !(NR > 0 && !bad) }' "$out/figures"
}
