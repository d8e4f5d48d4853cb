#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The skin that a run chooses by itself against fixed skins: skin.sh [--quick | --count]
#
# Ten packings made by scree pack, dilute to dense and cold to hot, each with skins of 0.05 ... 2 radii of the smaller spheres and with
# `skin: auto`, in turns. One JSON line a scene and skin: the median of its costs. Then a line a scene: `ratio` is the cost of auto over that
# of the best fixed skin, `default_ratio` the cost of auto over that of 0.3. The last line is the summary over the scenes. Wanted: a median of
# at most 1.05, and none above 1.15.
#
# The cost is the seconds of the loop, or with --count the instructions of all steps (valgrind's callgrind; other work on the machine
# does not change these, but they know no waiting for memory). --count needs 10 minutes, the seconds need 15, --quick 1.
#
# SCREE, THREADS (1), RUNS (5), COUNT (particles), STEPS, SCENES (those whose names match this expression), WORK may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
count_them=
if [ "${1:-}" = --count ]; then
    count_them=yes
    shift
    command -v valgrind >/dev/null || { echo 'no valgrind here: apt-get install valgrind' >&2; exit 1; }
fi
quick_after 0 "skin.sh [--quick | --count]" "$@"
threads=${THREADS:-1}
total=${COUNT:-50000}
steps=${STEPS:-1000}
runs=${RUNS:-5}
if [ -n "$quick" ]; then
    total=${COUNT:-5000}
    steps=${STEPS:-400}
    runs=${RUNS:-3}
fi
if [ -n "$count_them" ]; then
    total=${COUNT:-1000}
    steps=${STEPS:-600}
    runs=1
fi
skins="0.05 0.1 0.2 0.3 0.5 0.8 1.2 2 auto"

# run SKIN STEPS: the program behind `before`
run() {
    if [ "$1" = auto ]; then relative=0.3 itself=true; else relative=$1 itself=false; fi
    packing_run threads="$threads" skin.length=~ skin.relative="$relative" skin.auto=$itself step.dt=0.002 step.count="$2" \
        step.rebuild_every=0 observables.every="$steps" guards.overlap=off guards.speed=off guards.energy=off guards.step=off
}
# instructions SKIN STEPS
instructions() {
    real=$SCREE
    printf '#!/bin/sh\nexec valgrind --tool=callgrind --callgrind-out-file=/dev/null --log-file=%s %s "$@"\n' "$work/skin.said" "$real" >"$work/skin.counted"
    chmod +x "$work/skin.counted"
    SCREE=$work/skin.counted
    run "$1" "$2"
    SCREE=$real
    sed -n 's/.*Collected : //p' "$work/skin.said"
}
cost() {
    if [ -n "$count_them" ]; then
        first=$(instructions "$1" 1)
        all=$(instructions "$1" "$steps")
        calc "$all - $first"
    else
        run "$1" "$steps"
        report seconds
    fi
}

rows=$work/skin.rows
: >"$rows"
# scene NAME LAW KEY=VALUE...
scene() {
    name=$1
    shift
    echo "$name" | grep -qE "${SCENES:-.}" || return 0
    packed "$@"
    turn=0
    : >"$work/skin.costs"
    while [ $turn -lt "$runs" ]; do
        for skin in $skins; do
            spent=$(cost "$skin")
            echo "$skin $spent $(report rebuilds) $(report pairs) $(report skin_factor)" >>"$work/skin.costs"
        done
        turn=$((turn + 1))
    done
    for skin in $skins; do
        grep "^$skin " "$work/skin.costs" >"$work/skin.one"
        middle=$(median 2 "$work/skin.one")
        read -r _ _ rebuilds pairs factor <"$work/skin.one"
        echo "$skin $middle" >>"$work/skin.scene"
        printf '{"scene": "%s", "skin": "%s", "%s": %.6g, "particles": %d, "steps": %d, "rebuilds": %s, "pairs": %s, "factor": %s}\n' "$name" "$skin" \
            "$(if [ -n "$count_them" ]; then echo instructions; else echo seconds; fi)" "$middle" "$particles" "$steps" "$rebuilds" "$pairs" "$factor"
    done
    awk -v name="$name" '$1 == "auto" { own = $2; next } $1 == 0.3 { usual = $2 } !best || $2 < best { best = $2; at = $1 }
        END { printf "{\"scene\": \"%s\", \"best\": %g, \"ratio\": %.4f, \"default_ratio\": %.4f}\n", name, at, own / best, own / usual }' "$work/skin.scene" | tee -a "$rows"
    rm "$work/skin.scene"
}

rm -f "$work/skin.scene"
scene dilute-hot power count="$total" min=1 max=1.1 fraction=0.02 velocity=5
scene dilute-cold power count="$total" min=1 max=1.1 fraction=0.02 velocity=0.3
scene gas-hot power count="$total" min=1 max=2 fraction=0.1 velocity=5
scene gas-cold power count="$total" min=1 max=2 fraction=0.1 velocity=0.3
scene medium-hot power count="$total" min=1 max=4 fraction=0.3 velocity=2
scene medium power count="$total" min=1 max=4 fraction=0.3 velocity=0.5
scene medium-cold power count="$total" min=1 max=4 fraction=0.3 velocity=0.05
scene dense-hot power count="$total" min=1 max=2 fraction=0.5 velocity=1
scene dense-cold power count="$total" min=1 max=2 fraction=0.5 velocity=0.05
scene packed power count="$total" min=1 max=3 fraction=0.62 overlap=0.01 velocity=0.1
sed 's/.*"ratio": \([^,]*\), "default_ratio": \([^}]*\)}/\1 \2/' "$rows" >"$work/skin.ratios"
printf '{"summary": true, "counted": %s, "threads": %d, "scenes": %d, "median": %.4f, "worst": %.4f, "default_median": %.4f}\n' \
    "$(if [ -n "$count_them" ]; then echo true; else echo false; fi)" "$threads" "$(wc -l <"$work/skin.ratios")" "$(median 1 "$work/skin.ratios")" \
    "$(sort -g "$work/skin.ratios" | awk '{ last = $1 } END { print last }')" "$(median 2 "$work/skin.ratios")"
