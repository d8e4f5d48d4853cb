#!/bin/sh
# Particle updates per core and second: run.sh [DIR [RANKS_X_THREADS ...]]
# Runs the scenarios with both ways of synchronising on each layout ("1x1 2x1 1x2" if none is named) and prints a JSON line
# for each run. SCENARIOS and STEPS, if set, name some of them and their steps; DIR (out beside this script) keeps the reports.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
find_scree
out=${1:-$(results out)}
[ $# = 0 ] || shift
[ $# != 0 ] || set -- 1x1 2x1 1x2
mkdir -p "$out"

# number KEY: of the last report
number() {
    sed -n 's/^ *"'"$1"'": \([-0-9.e+]*\),*$/\1/p' "$report" | head -n 1
}

for scenario in ${SCENARIOS:-sparse sparse-physical dense large}; do
    case $scenario in
    sparse-physical) scene=sparse more='--set step.dt=0.25' ;;
    *) scene=$scenario more= ;;
    esac
    for layout in "$@"; do
        for sync in neighbours shadow; do
            run=$out/$scenario-$sync-$layout
            report=$run/report.json
            if OMP_WAIT_POLICY=passive on_ranks "${layout%x*}" "$SCREE" run "$here/$scene/scene.yaml" -o "$run" --overwrite \
                --quiet --set threads="${layout#*x}" --set sync="$sync" ${STEPS:+--set step.count="$STEPS"} $more 2>"$run.log"; then
                echo "{\"scenario\": \"$scenario\", \"sync\": \"$sync\", \"ranks\": ${layout%x*}, \"threads\": ${layout#*x}, \"pupcs\": $(number pupcs), \"sync_share\": $(number sync_share), \"imbalance\": $(number imbalance)}"
            elif grep -q 'sync: neighbours' "$run.log"; then
                echo "{\"scenario\": \"$scenario\", \"sync\": \"$sync\", \"ranks\": ${layout%x*}, \"threads\": ${layout#*x}, \"pupcs\": null}"
            else
                cat "$run.log" >&2
                exit 1
            fi
        done
    done
done
