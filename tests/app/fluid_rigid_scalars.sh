#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Scalars in a fluid whose flow is rigid in grains: nothing is lost while discs fall through them, a constant stays, the same on all layouts and after a resume; diffusion around discs at rest against
# Rayleigh's series; what a disc holds goes with it.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >dye.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 24, 0], dimension: 2, periodic: [true, false, false], density: area}
gravity: [0, -0.0833333, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 24, 0], normal: [0, -1, 0]}
  - {name: rod, shape: cylinder, point: [5, 17, 0], axis: [0, 0, 1], radius: 3, inside: false, motion: [{kind: translate, velocity: [0.2, 0, 0]}]}
contact: {law: hertz}
materials: [{name: glass, density: 2.5, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0.3}]
particles: {from: file, format: table, file: discs.txt, columns: [x, y, z, radius]}
fluid:
  spacing: 1
  density: 1
  viscosity: 0.2
  grains: {motion: free, every: 20}
  solver: {tolerance: 1e-8}
  scalars:
    - {name: dye, diffusivity: 0.05, initial: {value: 1, region: {shape: box, lower: [8, 0, 0], upper: [24, 12, 0]}}}
    - {diffusivity: 0.01, initial: 1}
    - {diffusivity: 0.2, advection: upwind, given: [{wall: floor, value: 1}]}
step: {dt: 0.0125, count: 800}
observables: {every: 400, list: [{name: scalar}, {name: centre}]}
output: {checkpoint: {every: 400}, dump: {every: 400, fields: [id, kind, scalar_1, scalar_2, scalar_3, solid]}}
YAML
printf '%s\n' '16.2 14 0 4' '26 9 0 3' >discs.txt
needs_petsc dye.yaml 'scalars beside rigid grains'
kept() {
    run_scene 1 dye.yaml one --set threads=1 && awk '
        /^ITEM: ATOMS/ { n++ } /^ITEM/ || NF != 7 || $3 != 1 { next }
        { sum[n] += $4; d = $5 - 1; d = d < 0 ? -d : d; if (d > gap) gap = d; if ($6 < -1e-9 || $6 > 1 + 1e-9) beyond++; if ($7 > 0.99) rides += $4; given[n] += $6 }
        END { d = sum[n] / sum[1] - 1; printf "  %d frames, %.12g of %.12g left, 1 stays to %.1e, the floor has given %.3g, %.3g in discs\n", n, sum[n], sum[1], gap, given[n], rides
              exit !(n == 3 && sum[1] > 150 && d * d < 1e-18 && gap < 1e-7 && !beyond && given[n] > 10 && rides > 1) }' one/dump.lammpstrj
}
check "discs fall through a dye, and nothing is lost" kept
again() { # RANKS BOUND FLAG...
    local ranks=$1 bound=$2
    shift 2
    rm -rf other
    run_scene "$ranks" dye.yaml other --set threads=1 "$@" && rows_close one other "$bound"
}
same() { cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv); }
check "the same on 2 ranks, to the tolerance" again 2 2e-3
check "the same with another index and 2 threads" again 1 1e-5 --set index=hgrid --set threads=2
check "a resume gives the same bits" eval 'again 1 0 --resume one/checkpoint-400.h5 && same'

# Steady diffusion between two walls, around a disc that fills a part f of a square: 1 - 2 f / (1 + f - 0.305827 f^4 / (1 - 1.402958 f^8) - 0.013362 f^8) of that without it (Rayleigh's series; Perrins, McKenzie and
# McPhedran 1979)
cat >still.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [16, 16, 0], dimension: 2, periodic: [true, false, false]}
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 16, 0], normal: [0, -1, 0]}
particles: {from: single, position: [8.2, 8.1, 0], radius: 4.0368, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 1
  density: 1
  viscosity: 1
  grains: {coupling: rigid}
  scalars: [{diffusivity: 1, given: [{wall: floor, value: 1}, {wall: lid, value: 0}]}]
step: {dt: 200, count: 12, force: true}
observables: {every: 12, list: [{name: scalar_1_flux}]}
output: {checkpoint: {at_end: false}}
YAML
calc() { awk "BEGIN { printf \"%.12g\", $1 }"; }
diffuses() { # RADIUS SERIES BOUND SETTING...
    local radius=$1 series=$2 bound=$3
    shift 3
    rm -rf still
    run_scene 1 still.yaml still --set threads=1 --set particles.radius="$radius" "$@" || return
    echo "  flux over the series: $(calc "$(last_of still scalar_1_flux_y) / 16 * 16 / $series" | cut -c 1-7)"
    within "$(calc "$(last_of still scalar_1_flux_y) / 16 * 16 / $series")" 1 "$bound"
}
check "diffusion around a disc" diffuses 4.0368 0.66653 0.015
check "diffusion around a larger disc" diffuses 5.7092 0.42535 0.015

check "a value given at grains is refused" scene_refused 'fluid.scalars[0].given[0].group|wall, side' still.yaml --set 'fluid.scalars=[{diffusivity: 1, given: [{group: bed, value: 1}]}]'
finish
