#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What a fluid costs: fluid.sh [--quick] [N ...], fluid.sh --counts [N], fluid.sh --page [--still]
#
# Frozen spheres on a cubic lattice of 16 spacings, of radius 4.96 (12.5 % of the volume), in a periodic box with some N nodes of
# the fluid's lattice, displaced at random by up to a tenth of a spacing (30,000, 100,000 and 300,000), on one rank; on two ranks
# N in all, and N each. The flow begins to move in 11 transient steps, and is solved for at once. One JSON line a run:
#
#   particles            fluid particles: rows of the pressure's matrix
#   iterations           a solve for the pressure, mean (steady: all of the coupled solve)
#   ns_per_particle      of a rank, by phase: neighbours (sorting, copies, index, pairs), operators (weights and mirrors), assembly,
#                        preconditioner: once; velocity, pressure (solves; steady: the iterations) and flow (the rest): a step
#   bytes_per_particle   resident memory beyond that of 450 particles, all ranks together
#   spmv_ratio           seconds of the solves for the pressure over those of their passes over the matrix at the triad's bandwidth
#                        (tests/bench_triad, as many threads as ranks). A pass reads 12 bytes an entry and 20 a row. An iteration
#                        has one product with the matrix, and in its cycle of multigrid five passes on each level: symmetric
#                        relaxation before and after, two passes each, and a residual. All levels together have `complexity`
#                        times the entries of the matrix, as hypre says.
#   product_ratio        the same of PETSc's products alone
#   before_solve         neighbours, operators and assembly over preconditioner and solves of one step
#
# --counts: instructions of one step by phase, under valgrind's callgrind, of some N (8,000) nodes: other work on the machine does
# not change these. --page: runs all, and writes the table of docs/fluid-method.md; with --still without nanoseconds and what follows from
# them, on a machine that other work disturbs.
#
# --quick: 4,096 nodes, 2 steps. SCREE, TRIAD, WORK, STEPS (11), RANKS ("1 2") may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
export LC_ALL=C OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1
usage='fluid.sh [--quick] [N ...] | --counts [N] | --page [--still]'
quick= counts= page= still=
while [ $# -gt 0 ]; do
    case $1 in
    --quick) quick=yes ;;
    --counts) counts=yes ;;
    --page) page=yes ;;
    --still) still=yes ;;
    [1-9]*) break ;;
    *) wrong_call ;;
    esac
    shift
done
steps=${STEPS:-$(by_mode 2 11)}
numbers=${*:-$(by_mode 4096 "30000 100000 300000")}
rows=$work/fluid.rows

# scene CELLS_X CELLS: boxes of 16 nodes, with a sphere each
scene() {
    cat >"$work/fluid.yaml" <<YAML
units: none
threads: 1
box: {lower: [0, 0, 0], upper: [$((16 * $1)), $((16 * $2)), $((16 * $2))], periodic: true}
particles:
  from: lattice
  lattice: sc
  spacing: 16
  sizes: 4.96
  density: 1
  group: bed
  region: {shape: box, lower: [0, 0, 0], upper: [$((16 * $1)), $((16 * $2)), $((16 * $2))]}
groups: [{name: bed, motion: frozen}]
fluid: {spacing: 1, density: 1, viscosity: 0.1, equations: stokes, fill: {jitter: 0.2}, kernel: {support: 2.2}, drive: {body_force: [1e-3, 0, 0]}}
step: {dt: 1, count: $steps}
observables: {every: 1000000, list: [{name: fluid_speed}]}
output: {checkpoint: {at_end: false}}
YAML
}

# flow RANKS KEY=VALUE...: runs the scene into WORK/fluid.run, with hypre's complexity in WORK/fluid.said
flow() {
    local ranks=$1 setting
    local -a set=()
    shift
    for setting; do
        set+=(--set "$setting")
    done
    on_ranks "$ranks" "$SCREE" run "$work/fluid.yaml" -o "$work/fluid.run" --overwrite --quiet "${set[@]}" >"$work/fluid.said" 2>&1 ||
        { cat "$work/fluid.said" >&2; exit 1; }
}
say_levels='fluid.solver.petsc=-fluid_p_pc_hypre_boomeramg_print_statistics 1'

# line SCHEME RANKS EACH: the last run as a line of JSON; EACH: weak, strong or one
line() {
    tr -d '\n' <"$work/fluid.run/report.json" | awk -v scheme="$1" -v ranks="$2" -v series="$3" -v steps="$steps" -v base="$base" \
        -v triad="$bandwidth" -v complexity="$(sed -n 's/.*operator = *\([0-9.]*\).*/\1/p' "$work/fluid.said" | head -n 1)" '
        # the object behind a key, up to its closing bracket
        function part(text, key, first, last, at, depth, from) {
            from = index(text, "\"" key "\": " first)
            for (at = from; from && at <= length(text); at++) {
                if (substr(text, at, 1) == first) depth++
                if (substr(text, at, 1) == last && --depth == 0) return substr(text, from, at - from + 1)
            }
            return ""
        }
        function number(text, key) {
            return match(text, "\"" key "\": [-+.0-9e]+") ? substr(text, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0 : 0
        }
        # mean seconds of the stages of these names
        function stage(text, names, name, k, sum) {
            n = split(names, name, " ")
            for (k = 1; k <= n; k++) sum += number(part(text, name[k], "{", "}"), "mean")
            return sum
        }
        function solver(name, at) {
            at = index(solvers, "{\"name\": \"" name "\"")
            return at ? substr(solvers, at, index(substr(solvers, at), "}")) : ""
        }
        function ns(seconds) { return 1e9 * seconds * ranks / particles }
        {
            early = part($0, "setup_stages", "{", "}")
            late = part($0, "stages", "{", "}")
            solvers = part($0, "solvers", "[", "]")
            u = solver("velocity")
            p = solver(scheme == "steady" ? "steady" : "pressure")
            particles = number(scheme == "steady" ? u : p, "rows")
            turns = number(p, "solves")
            near = stage(early, "reorder ghosts index pairs")
            operators = stage(early, "operators")
            assembly = stage(late, "assembly")
            prepare = number(u, "seconds_set_up") + number(p, "seconds_set_up")
            if (scheme == "steady") {
                iterations = number(p, "iterations")
                velocity = 0
                pressure = number(p, "seconds_solve")
            } else {
                iterations = number(p, "iterations") / turns
                velocity = number(u, "seconds_solve") / steps
                pressure = number(p, "seconds_solve") / steps
            }
            printf "{\"scheme\": \"%s\", \"series\": \"%s\", \"particles\": %d, \"ranks\": %d, \"threads\": 1, \"iterations\": %.4g, ", scheme,
                series, particles, ranks, iterations
            printf "\"ns_per_particle\": {\"neighbours\": %.4g, \"operators\": %.4g, \"assembly\": %.4g, \"preconditioner\": %.4g, ", ns(near),
                ns(operators), ns(assembly), ns(prepare)
            printf "\"velocity\": %.4g, \"pressure\": %.4g, \"flow\": %.4g}, \"bytes_per_particle\": %.0f, ", ns(velocity), ns(pressure),
                ns(stage(late, "flow")) / steps, (number($0, "memory_peak") - base) * ranks / particles
            if (scheme != "steady") {
                pass = (12 * number(p, "entries") + 20 * particles) / (1e9 * triad)
                printf "\"complexity\": %.3f, \"spmv_ratio\": %.3g, \"product_ratio\": %.3g, ", complexity,
                    number(p, "seconds_solve") / (pass * (number(p, "iterations") * (1 + 5 * complexity) + turns)),
                    number(p, "seconds_products") / number(p, "products") / pass
            }
            printf "\"before_solve\": %.3g, \"residual\": %.2g}\n", (near + operators + assembly) / (prepare + velocity + pressure),
                number(p, "residual_worst")
        }'
}

# measure RANKS CELLS_X CELLS SERIES
measure() {
    flow_base "$1"
    scene "$2" "$3"
    flow "$1" "$say_levels"
    line transient "$1" "$4"
    flow "$1" fluid.time=steady step.count=1
    line steady "$1" "$4"
}

# resident memory of a rank with hardly any fluid, and the bandwidth, on that many ranks
flow_base() {
    scene 1 1
    sed -i 's/\[16, 16, 16\]/[8, 8, 8]/g; s/spacing: 16/spacing: 8/; s/4.96/2.4/' "$work/fluid.yaml"
    flow "$1"
    base=$(report_number "$work/fluid.run" memory_peak)
    bandwidth=$("$triad" "$1" ${quick:+64} | sed -n 's/.*triad.*"gigabytes_per_second": \([0-9.]*\).*/\1/p')
}

cells_of() { # N: boxes along an edge
    awk -v n="$1" 'BEGIN { k = int((n / 4096) ^ (1 / 3) + 0.5); print (k > 1 ? k : 1) }'
}

series() {
    local n k ranks
    for n in $numbers; do
        k=$(cells_of "$n")
        for ranks in ${RANKS:-1 2}; do
            if [ "$ranks" = 1 ]; then
                measure 1 "$k" "$k" one
            else
                measure "$ranks" $((ranks * k)) "$k" weak
                [ "$k" = 1 ] || measure "$ranks" "$k" "$k" strong
            fi
        done
    done
}

# table: the lines of JSON on stdin as a table of markdown
table() {
    awk -v still="$still" '
        function word(key) { return match($0, "\"" key "\": \"[a-z]*") ? substr($0, RSTART + length(key) + 5, RLENGTH - length(key) - 5) : "" }
        function number(key) { return match($0, "\"" key "\": [-+.0-9e]+") ? substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0 : 0 }
        BEGIN {
            print "| scheme | particles | ranks | iterations | bytes a particle | levels" (still ? "" : " | neighbours | operators | assembly | preconditioner | velocity | pressure | rest | solve / bound | product / bound | before / solve") " |"
            print "|---|---|---|---|---|---" (still ? "" : "|---|---|---|---|---|---|---|---|---|---") "|"
        }
        {
            steady = word("scheme") == "steady"
            printf "| %s | %d | %d | %.3g | %d | %s", word("scheme"), number("particles"), number("ranks"), number("iterations"),
                number("bytes_per_particle"), steady ? "" : sprintf("%.2f", number("complexity"))
            if (!still) {
                printf " | %d | %d | %d | %d | %s | %d | %d", number("neighbours"), number("operators"), number("assembly"),
                    number("preconditioner"), steady ? "" : int(number("velocity")), number("pressure"), number("flow")
                printf " | %s | %s | %.2g", steady ? "" : number("spmv_ratio"), steady ? "" : number("product_ratio"), number("before_solve")
            }
            print " |"
        }'
}

# page: writes the table between the marks of docs/fluid-method.md
page() {
    local file=$here/../../docs/fluid-method.md
    series | tee "$rows" >&2
    table <"$rows" >"$work/fluid.table"
    awk -v table="$work/fluid.table" '
        /<!-- fluid.sh -->/ { print; while ((getline row <table) > 0) print row; skip = 1; marks++; next }
        /<!-- end -->/ { skip = 0 }
        !skip
        END { exit marks != 1 }' "$file" >"$work/fluid.md" && mv "$work/fluid.md" "$file"
}

# counted: instructions of each phase a fluid particle
counted() {
    local k
    command -v valgrind >/dev/null || { echo 'no valgrind here: apt-get install valgrind' >&2; exit 1; }
    k=$(cells_of "${1:-8000}")
    scene "$k" "$k"
    quietly valgrind --tool=callgrind --callgrind-out-file="$work/fluid.callgrind" "$SCREE" run "$work/fluid.yaml" -o "$work/fluid.run" --overwrite \
        --quiet --set step.count=1
    particles=$(tr -d '\n' <"$work/fluid.run/report.json" | sed 's/.*"name": "pressure", "rows": \([0-9]*\).*/\1/')
    callgrind_annotate --inclusive=yes --threshold=100 "$work/fluid.callgrind" | awk -v n="$particles" '
        BEGIN {
            phase["index_build"] = phase["index_order"] = phase["pairlist_build"] = phase["pair_rows_build"] = "neighbours"
            phase["interactions_select"] = phase["particles_reorder"] = "neighbours"
            phase["weights_make"] = phase["mirror_make"] = "operators"
            phase["assembly_make"] = phase["assembly_momentum"] = phase["assembly_pressure"] = phase["petsc_matrix_make"] = "assembly"
            phase["petsc_matrix_values"] = "assembly"
            phase["petsc_solver_set_up"] = "preconditioner"
            phase["petsc_solver_solve"] = "solve"
            phases = split("neighbours operators assembly preconditioner solve", order, " ")
        }
        match($0, /:[A-Za-z_0-9.]+( |$)/) {
            name = substr($0, RSTART + 1, RLENGTH - 1)
            sub(/[. ].*/, "", name)
            instructions = $1
            gsub(",", "", instructions)
            if (name in phase && !(name in seen)) { sum[phase[name]] += instructions; seen[name] = 1 }
        }
        END {
            printf "{\"particles\": %d, \"instructions_per_particle\": {", n
            for (k = 1; k <= phases; k++) printf "%s\"%s\": %.0f", (k > 1 ? ", " : ""), order[k], sum[order[k]] / n
            printf "}, \"before_solve\": %.3g}\n", (sum["neighbours"] + sum["operators"] + sum["assembly"]) / (sum["preconditioner"] + sum["solve"])
        }'
}

if [ -n "$counts" ]; then
    counted "$@"
    exit
fi
triad=$(built TRIAD "${TRIAD:-}" tests/bench_triad)
if [ -n "$page" ]; then page; else series; fi
