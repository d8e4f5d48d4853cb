#!/bin/sh
# The index that chooses itself against a sweep: auto.sh [--quick]
#
# For a score of scenes (mono, bidisperse, sand-like, exponential, lognormal, power laws, uniform by number and by volume,
# dilute to dense, boulders) times order + build + search of `auto` with its own classes, then of `hgrid` with 1, 2, 3, 4 and 6
# levels of equal occupancy at cells of 0.7, 1, 1.4 and 2 cut-offs. One JSON line a measurement, after each scene one
# with ratio (auto over the best), linkcell_ratio (auto over the best single level), prediction (predicted over measured);
# the last line is the summary: median and largest ratio.
#
# --quick: smaller scenes, a short sweep. Needs `make tests/index/bench_index`; BENCH (that program), THREADS (1), RUNS (5)
# may be set.
set -eu
bench=${BENCH:-tests/index/bench_index}
quick=
test "${1:-}" != --quick || quick=yes
test $# = 0 || test -n "$quick" || { echo "usage: auto.sh [--quick]" >&2; exit 2; }
command -v "$bench" >/dev/null || { echo "no $bench here: make tests/index/bench_index, or set BENCH" >&2; exit 1; }
export OMP_WAIT_POLICY=passive
threads=${THREADS:-1}
particles=50000
runs=${RUNS:-5}
levels="1 2 3 4 6"
factors="0.7 1 1.4 2"
if [ -n "$quick" ]; then
    particles=4000
    runs=3
    levels="1 2 3"
    factors="1 1.4"
fi
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT

measure() {
    # shellcheck disable=SC2086
    "$bench" $scene particles=$particles repetitions="$runs" threads="$threads" "$@"
}

value='function value(key) {
    match($0, "\"" key "\": [^,}]*")
    return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}'
while read -r scene; do
    {
        measure levels=0 index=auto
        for l in $levels; do
            for f in $factors; do
                measure levels="$l" factor="$f"
            done
        done
    } >"$rows"
    cat "$rows"
    awk -v scene="$scene" "$value"'
    NR == 1 { auto = value("seconds"); predicted = value("predicted"); particles = value("particles"); threads = value("threads"); best = auto; next }
    { t = value("seconds"); best = t < best ? t : best }
    value("levels") == 1 { one = one && one < t ? one : t }
    END { printf "{\"scene\": \"%s\", \"threads\": %d, \"seconds\": %g, \"particles\": %d, \"ns_per_particle\": %.1f, \"ratio\": %.3f, \"linkcell_ratio\": %.3f, \"prediction\": %.3f}\n",
          scene, threads, auto, particles, 1e9 * auto / particles, auto / best, auto / one, predicted / auto }' "$rows" | tee -a "$rows.all"
done <<END
law=power ratio=1 fraction=0.4 skin=0.3
law=power ratio=1 fraction=0.02 skin=0.3
law=power ratio=1 fraction=0.001 skin=0.3
law=bidisperse ratio=10 large=3.5e-4 fraction=0.45 skin=0.3
law=bidisperse ratio=2 large=0.5 fraction=0.4 skin=0.3
law=bidisperse ratio=4 large=0.02 fraction=0.45 skin=0.3
law=bidisperse ratio=30 large=4e-5 fraction=0.3 skin=0.3
law=power exponent=-3 ratio=50 fraction=0.4
law=power exponent=-3 ratio=50 fraction=0.1
law=power exponent=-3 ratio=50 fraction=0.5 skin=0.3
law=power exponent=-3 ratio=300 fraction=0.4 skin=0.3
law=power exponent=0 ratio=8 fraction=0.4 skin=0.3
law=power exponent=0 ratio=1.8 fraction=0.4 skin=0.3
law=power exponent=2 ratio=50 fraction=0.3 skin=0.3
law=power exponent=-2 ratio=20 fraction=0.4 skin=0.3
law=power exponent=-4 ratio=100 fraction=0.4 skin=0.3
law=exponential ratio=50 fraction=0.45 skin=0.3
law=lognormal ratio=20 fraction=0.4 skin=0.3
law=lognormal ratio=100 fraction=0.1 skin=0.3
law=sand ratio=20 fraction=0.45 skin=0.3
law=sand ratio=100 fraction=0.3 skin=0.3
law=boulder ratio=30 large=1 fraction=0.35 skin=0.3
law=boulder ratio=8 large=5 fraction=0.05 skin=0.3
END
sort_by() {
    sed "s/.*\"$1\": \([0-9.]*\).*/\1/" "$rows.all" | sort -n
}
count=$(wc -l <"$rows.all")
middle=$(((count + 1) / 2))
awk "$value"'{ s += value("seconds"); n += value("particles"); threads = value("threads") }
END { printf "{\"summary\": true, \"threads\": %d, \"seconds\": %g, \"particles\": %d, \"ns_per_particle\": %.1f, ", threads, s, n, 1e9 * s / n }' "$rows.all"
printf '"scenes": %d, "ratio_median": %s, "ratio_largest": %s, "linkcell_ratio_largest": %s, "prediction_median": %s}\n' "$count" \
    "$(sort_by ratio | sed -n "${middle}p")" "$(sort_by ratio | tail -1)" "$(sort_by linkcell_ratio | tail -1)" "$(sort_by prediction | sed -n "${middle}p")"
rm -f "$rows.all"
