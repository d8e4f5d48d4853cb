#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Particle updates per core and second: run.sh [DIR [RANKS_X_THREADS ...]]
# Runs the scenarios with both ways of synchronising on each layout ("1x1 2x1 1x2" if none is named) and prints a JSON line
# for each, the median of RUNS (3), taken in turns. SCENARIOS and STEPS, if set, name some of them and their steps; DIR (out beside
# this script) keeps the reports, the lines (lines.jsonl) and a section for the page on scaling (section.md).
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
[ $# = 0 ] || shift
[ $# != 0 ] || set -- 1x1 2x1 1x2
mkdir -p "$out"

section() {
    cat <<END

## Particle updates per core and second

\`examples/pupcs/run.sh\` writes this section. The scenarios are those of Eibl and Rüde's Table 1, with the share of one process on each core; the
table has millions of particle updates per core and second. \`sparse\` and \`large\` are for timing only (a contact lasts 5 steps, and more than 15
steps); in \`sparse-physical\` a contact lasts 20 steps. The scenarios \`-hard\` have rigid contacts and ten sweeps a step, as the paper's have. The columns of waLBerla are medians of its pe engine with soft contacts on two ranks of a
machine of the same kind; in \`large\` the results of waLBerla's next-neighbour synchronisation are wrong.

| scenario | ranks x threads | neighbours | shadow | shadow / neighbours | waLBerla, neighbours | shadow | ratio |
|---|---|---|---|---|---|---|---|
END
    awk -F'[:,"} ]+' '
        BEGIN {
            walberla["sparse"] = "0.611 | 0.468 | 0.77"
            walberla["dense"] = "1.002 | 0.986 | 0.98"
            walberla["large"] = "wrong | 0.596 | –"
        }
        {
            for (k = 2; k < NF; k++) field[$k] = $(k + 1)
            row = "| " field["scenario"] " | " field["ranks"] "x" field["threads"] " | "
            value = field["pupcs"] == "null" ? 0 : field["pupcs"] / 1e6
            if (field["sync"] == "neighbours") {
                first = value
                next
            }
            other = field["scenario"] in walberla ? walberla[field["scenario"]] : "– | – | –"
            print row (first ? sprintf("%.2f", first) : "refused") " | " sprintf("%.2f", value) " | " \
                (first ? sprintf("%.3f", value / first) : "–") " | " other " |"
        }' "$out/lines.jsonl"
}

# one_run SYNC: its figure goes to SYNC.pupcs; where next-neighbour synchronisation refuses the scene there is SYNC.refused
one_run() {
    run=$out/$scenario-$1-$layout
    # shellcheck disable=SC2086
    if OMP_WAIT_POLICY=passive on_ranks "${layout%x*}" "$SCREE" run "$here/$scene/scene.yaml" -o "$run" --overwrite \
        --quiet --set threads="${layout#*x}" --set sync="$1" ${STEPS:+--set step.count="$STEPS"} $more 2>"$run.log"; then
        report_number "$run" pupcs >>"$out/$1.pupcs"
    elif grep -q 'sync: neighbours' "$run.log"; then
        : >"$out/$1.refused"
    else
        cat "$run.log" >&2
        exit 1
    fi
}

: >"$out/lines.jsonl"
for scenario in ${SCENARIOS:-sparse sparse-physical dense large sparse-hard dense-hard large-hard}; do
    case $scenario in
    sparse-physical) scene=sparse more='--set step.dt=0.25' ;;
    *-hard) # ten sweeps a step, each moves a grain by up to a seventh of its radius
        scene=${scenario%-hard} more='--set contact.law=rigid --set contact.solver.sweeps=10 --set contact.solver.tolerance=0'
        case $scene in
        sparse) more="$more --set step.dt=0.1 --set skin=null --set material_pairs[0].restitution=0.9" ;;
        dense) more="$more --set step.dt=0.01" ;;
        large) more="$more --set material_pairs[0].restitution=0.9" ;;
        esac
        more="$more --set material_pairs[0].k_n=null"
        ;;
    *) scene=$scenario more= ;;
    esac
    for layout in "$@"; do
        rm -f "$out"/*.pupcs "$out"/*.refused
        for _ in $(seq "${RUNS:-3}"); do # in turns, as other load comes and goes
            for sync in neighbours shadow; do
                if [ ! -e "$out/$sync.refused" ]; then one_run "$sync"; fi
            done
        done
        for sync in neighbours shadow; do
            run=$out/$scenario-$sync-$layout
            line="{\"scenario\": \"$scenario\", \"sync\": \"$sync\", \"ranks\": ${layout%x*}, \"threads\": ${layout#*x}, \"pupcs\":"
            if [ -e "$out/$sync.refused" ]; then
                line="$line null}"
            else
                line="$line $(median 1 "$out/$sync.pupcs"), \"sync_share\": $(report_number "$run" sync_share), \"imbalance\": $(report_number "$run" imbalance)}"
            fi
            echo "$line" | tee -a "$out/lines.jsonl"
        done
    done
done
section >"$out/section.md"
