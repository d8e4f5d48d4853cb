#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# From Darcy to Forchheimer: pressure gradient against flow through random packings: run.sh [--quick] [DIR]
#
# scree packs 32 spheres in a periodic cube (58 % of the volume; PACKINGS, seeds, "1 2 3"), and a fluid flows through them at
# Reynolds numbers U d / nu of 0 (Stokes flow, solved at once) and 1 to 100 (REYNOLDS, marched until steady), on several lattices
# (CELLS, spacings an edge of the cube, "32 40", about 10 and 13 a diameter). Prints a line of JSON a flow, also to DIR/ergun.jsonl: friction
# factor, force d^2 porosity^3 / (viscosity U (1 - porosity)^2) (Ergun: 150 + 1.75 Re / (1 - porosity)), and what the
# velocity changed in the last fifth of the march. --quick: one packing, a coarse lattice, two flows.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"

packings=${PACKINGS:-1 2 3} cells=${CELLS:-32 40} reynolds=${REYNOLDS:-0 1 3 10 30 100}
out=
while [ $# -gt 0 ]; do
    case $1 in
        --quick) packings=1 cells=20 reynolds="0 5" ;;
        -*) echo "run.sh: $1: allowed is --quick" >&2; exit 2 ;;
        *) out=$1 ;;
    esac
    shift
done
out=${out:-$(results out)}
mkdir -p "$out"
out=$(cd "$out" && pwd)
count=32 solid=0.58

# flow PACKING CELLS RE: the force is what Ergun's equation says; the flow begins at rest and speeds up as Stokes flow, faster than it ends, so that the
# step is half a spacing over 20 times that velocity, or over 25 times the one that is wanted, which is enough once inertia holds the flow back; the march ends after
# 0.08 d^2/nu, ten times what a pore takes, sooner with inertia; a flow that is too fast for its step is left out, with a word
flow() {
    eval "$(awk -v n="$count" -v solid="$solid" -v cells="$2" -v re="$3" 'BEGIN {
        edge = (n * atan2(0, -1) / 6 / solid) ^ (1 / 3)
        e = 1 - solid
        spacing = edge / cells
        stokes = 150 * solid ^ 2 / e ^ 3
        force = re > 0 ? stokes * re + 1.75 * solid / e ^ 3 * re ^ 2 : stokes
        fast = force / stokes < 1.25 * re ? force / stokes : 1.25 * re
        dt = re > 0 ? 0.5 * spacing / (20 * fast) : 1
        if (re > 0 && dt > 1e-3) dt = 1e-3
        printf "spacing=%.15g force=%.12g dt=%.9g steps=%d\n", spacing, force, dt, (re > 0 ? int(0.08 / (1 + 0.02 * re) / dt + 0.5) : 1)
    }')"
    set -- "$1" "$2" "$3" "$out/flow-$1-$2-$3"
    scheme='--set fluid.time=transient'
    [ "$3" != 0 ] || scheme='--set fluid.time=steady --set fluid.equations=stokes --set fluid.solver.tolerance=5e-4'
    # shellcheck disable=SC2086
    "$SCREE" run "$here/scene.yaml" -o "$4" --overwrite --quiet --set "particles.sources[0].file=$out/packing-$1.h5" --set "fluid.spacing=$spacing" \
        --set "fluid.drive.body_force=[0, 0, $force]" --set "step.dt=$dt" --set "step.count=$steps" $scheme ${SCREE_ARGS:-} \
        2>"$4.notes" || {
        tail -n 1 "$4.notes" >&2
        grep -q 'advection wants' "$4.notes"
        return
    }
    awk -F , -v packing="$1" -v spacing="$spacing" -v force="$force" -v solid="$solid" -v target="$3" '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { u[++n] = $at["fluid_velocity_z"]; speed = $at["fluid_speed"]; porosity = $at["fluid_porosity"] }
        END {
            before = target > 0 ? u[n - int(0.2 * n)] : u[n]
            printf "{\"packing\": %d, \"spacings_a_diameter\": %.4g, \"target\": %s, \"reynolds\": %.6g, \"friction\": %.6g, \"change\": %.2g, \"speed_over_velocity\": %.4g, \"porosity_lattice\": %.5f, \"steps\": %d}\n",
                packing, 1 / spacing, target, (target > 0 ? u[n] : 0), force * (1 - solid) ^ 3 / (u[n] * solid ^ 2), u[n] / before - 1, speed / u[n], porosity, n - 1
        }' "$4/observables.csv" | tee -a "$out/ergun.jsonl"
}

: >"$out/ergun.jsonl"
for packing in $packings; do
    "$SCREE" pack discrete "$out/packing-$packing.h5" diameters=1 weights=1 count="$count" fraction="$solid" seed="$packing" --overwrite --quiet
    for n in $cells; do
        for re in $reynolds; do flow "$packing" "$n" "$re"; done
    done
done
