#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Time against cell size, Figures 3 and 4 of Stratford, Shire and Hanley: cells.sh R [--quick]
#
# The bidisperse systems of their Table 1, R = 10, 20 or 40, skin 0.5, a rebuild every four steps, on CORES ranks of one thread.
# Cells of the small spheres have the edge binsz = 1.25 ... 10 (a cut-off is 2.5, LAMMPS's own size half of it):
#   multi     newton on and off          one grid, a stencil for each type
#   bytype    newton on, off, and on with reduced ghosts     a grid for each type; that of the large ones keeps its own size
#   hgrid, auto     with the cells that they choose
#   LAMMPS    multi (which is the report's bytype) newton on, off, reduced; multi/old (the report's multi) newton on and off; at
#             R = 40 cells up to 5, and multi/old at 3.75 and 5 alone, newton on
# At R = 40 scree's multi leaves out 1.25 (an hour) unless MULTI_ALL=1.
#
# One JSON line a measurement: seconds is one rebuild (LAMMPS: Neigh), comm_seconds what a step sends and receives. The last line is
# the summary: the best of each curve with its binsz, the gain of bytype with reduced ghosts over multi (published: 7.5, 29, 161
# for R = 10, 20, 40), and rebuild_ratio, LAMMPS's best over scree's auto.
#
# SCREE, LAMMPS (lmp), CORES (all), WORK (keeps the packings), BINS may be set. SKIP_LAMMPS=1 leaves LAMMPS out. RESUME=1
# goes on with a run that was cut short: the points that it measured are taken over. --quick: a cube of edge max(4 R, 80), four sizes
# of cells.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
export OMP_NUM_THREADS=1
quick_after 1 "cells.sh 10|20|40 [--quick]" "$@"
ratio=$1
{ table1_system "$ratio" && [ "$ratio" -le 40 ]; } || wrong_call
lammps_unless_skipped cells.sh
bins=${BINS:-$(by_mode "1.25 2.5 5 10" "1.25 2.5 3.75 5 7.5 10")}
cube=
test -z "$quick" || cube=$(table1_cube "$(quick_edge "$ratio")")
# shellcheck disable=SC2086
packed bidisperse ratio="$ratio" $cube velocity=1
ranks=$cores
every=4
rows=$work/cells.rows
if [ -n "${RESUME:-}" ] && [ -s "$rows" ]; then
    grep "^{\"code\": .*\"R\": $ratio, .*\"particles\": $particles, .*}\$" "$rows" >"$rows.kept" || true
    mv "$rows.kept" "$rows"
    cat "$rows"
else
    : >"$rows"
fi

# measured CODE STYLE BINSZ: the point is there
measured() {
    grep -q "\"code\": \"$1\", .*\"style\": \"$2\", \"binsz\": $3, " "$rows"
}

# emit CODE STYLE BINSZ COMM STEPS FIGURES
emit() {
    echo "$6" | awk -v code="$1" -v style="$2" -v bin="$3" -v comm="$4" -v steps="$5" -v R="$ratio" -v ranks="$ranks" -v n="$particles" '{
        printf "{\"code\": \"%s\", \"R\": %d, \"style\": \"%s\", \"binsz\": %s, \"ranks\": %d, \"threads\": 1, \"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, ",
            code, R, style, bin, ranks, n, $2 / $3, 1e9 * $2 / $3 / n
        printf "\"comm_seconds\": %.6g, \"rebuilds\": %d, \"pairs\": %.0f, \"kinetic_energy\": %.15g}\n", comm / steps, $3, $4, $5 }' | tee -a "$rows"
}

# scree_point STYLE BINSZ STEPS KEY=VALUE...
scree_point() {
    style=$1 bin=$2 steps=$3
    shift 3
    ! measured scree "$style" "$bin" || return 0
    packing_run threads=1 step.count="$steps" observables.every="$steps" step.rebuild_every=$every "$@"
    emit scree "$style" "$bin" "$(stages comm decide)" "$steps" "$(scree_figures "$work/run" energy_kinetic)"
}

# lammps_point STYLE BINSZ STEPS NEIGHBOR NEWTON REDUCED
lammps_point() {
    ! measured lammps "$1" "$2" || return 0
    quietly on_ranks "$ranks" "$lammps" -in "$here/in.cells" -log "$work/lammps.log" -screen none -var data "$packing.data" -var style "$4" \
        -var newton "$5" -var reduced "$6" -var bin "$2" -var every $every -var steps "$3" || {
        tail -n 3 "$work/lammps.log" >&2
        return 1
    }
    emit lammps "$1" "$2" "$(awk -F'|' '/^Comm *\|/ { print $3 + 0 }' "$work/lammps.log")" "$3" "$(lammps_figures "$work/lammps.log" "$3")"
}

few=$((every * 3))
types="classes={method: cuts, cuts: [$(calc "$ratio / 2")]}"
for bin in $bins; do
    cells="index.level_cells=[$bin, 0]"
    factor=index.cell_factor=$(calc "$bin / 2.5")
    if [ "$ratio:$quick:$bin:${MULTI_ALL:-}" != 40::1.25: ]; then
        scree_point "multi newton on" "$bin" $every index=multi "$types" "$factor"
        scree_point "multi newton off" "$bin" $every index=multi "$types" "$factor" newton=off
    fi
    scree_point "bytype newton on" "$bin" $few index=hgrid "$types" "$cells"
    scree_point "bytype newton off" "$bin" $few index=hgrid "$types" "$cells" newton=off
    scree_point "bytype reduced" "$bin" $few index=hgrid "$types" "$cells" ghosts=reduced
    test -n "$with_lammps" || continue
    case $ratio:$quick:$bin in 40::7.5 | 40::10) continue ;; esac
    lammps_point "bytype newton on" "$bin" $few multi on no
    lammps_point "bytype newton off" "$bin" $few multi off no
    lammps_point "bytype reduced" "$bin" $few multi on yes
    case $ratio:$quick:$bin in
    40::3.75 | 40::5) lammps_point "multi newton on" "$bin" $every multi/old on no ;;
    40::*) ;;
    *)
        lammps_point "multi newton on" "$bin" $every multi/old on no
        lammps_point "multi newton off" "$bin" $every multi/old off no
        ;;
    esac
done
scree_point "hgrid" null $few index=hgrid "$types"
scree_point "auto" null $few index=auto classes.method=auto
scree_point "auto reduced" null $few index=auto classes.method=auto ghosts=reduced

awk -v R="$ratio" -v ranks="$ranks" '
    function word(key) {
        if (!match($0, "\"" key "\": \"?[^\",}]*")) return ""
        s = substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4)
        sub(/^"/, "", s)
        return s
    }
    {
        curve = word("code") " " word("style")
        t = word("seconds") + 0
        if (!(curve in least)) order[++n] = curve
        if (!(curve in least) || t < least[curve]) { least[curve] = t; at[curve] = word("binsz") }
        particles = word("particles") + 0
    }
    END {
        t = least["scree auto"]
        peer = ""
        split("bytype newton on,bytype newton off,bytype reduced", style, ",")
        for (k = 1; k <= 3; k++) {
            s = least["lammps " style[k]]
            if (s > 0 && (peer == "" || s < peer)) peer = s
        }
        printf "{\"summary\": true, \"R\": %d, \"ranks\": %d, \"threads\": 1, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, \"rebuild_ratio\": %s, ", R,
            ranks, t, particles, 1e9 * t / particles, peer == "" ? "null" : sprintf("%.4g", peer / t)
        printf "\"gain\": %.4g, \"lammps_gain\": %s", least["scree multi newton on"] / least["scree bytype reduced"],
            ("lammps multi newton on" in least) ? sprintf("%.4g", least["lammps multi newton on"] / least["lammps bytype reduced"]) : "null"
        for (k = 1; k <= n; k++)
            printf ", \"%s\": {\"rebuild_seconds\": %.6g, \"binsz\": %s}", order[k], least[order[k]], at[order[k]]
        print "}"
    }' "$rows"
