#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Gas through beds of grains that it does not resolve, averaged over both: the drop of a bed between open sides, gas through a plate that holds the
# grains, a bed that floats, momentum with steps that are long for drag; ranks, resume
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >bed.yaml <<'YAML'
box: {lower: [0, 0, 0], upper: [30 mm, 30 mm, 150 mm], periodic: [true, true, false]}
groups: [{name: bed, motion: frozen}]
particles: {from: lattice, lattice: sc, spacing: 3 mm, sizes: 1.25 mm, density: 2500, group: bed, region: {shape: box, lower: [0, 0, 45 mm], upper: [30 mm, 30 mm, 105 mm]}}
fluid:
  spacing: 6 mm
  density: 1.2
  viscosity: 1.8e-5
  initial: {velocity: [0, 0, 2]}
  open: [{side: z_lower, velocity: [0, 0, 2]}, {side: z_upper, pressure: 0}]
  grains: {unresolved: 2 mm}
drag: {law: gidaspow, porosity: {support: 7.5 mm}}
step: {count: 60, dt: 1 ms}
observables: {every: 20, list: [{name: pressure_drop, components: z}, {name: grain_drag, components: z}, {name: porosity_mean}]}
output: {checkpoint: {at_end: false}, dump: {every: 60, fields: [id, kind, position, velocity, radius, porosity]}}
YAML
needs_petsc bed.yaml 'gas through beds'

# The law's drop is the sum of its forces over the area, at the porosity of each grain; of a bed of that porosity without ends it is Ergun's
drop() { # RANKS
    run_scene "$1" bed.yaml bed --overwrite --set threads=1 && tail -n 1 bed/observables.csv | tr , ' ' >last && awk '
        NR == FNR { found = $2; next }
        /^ITEM: TIMESTEP/ { getline; frame = $1 } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        !reading || frame != 60 { next }
        $at["kind"] == 1 { off = $at["vz"] / 2 - 1; off = off < 0 ? -off : off; if (off > worst) worst = off }
        $at["kind"] == 0 { e = $at["porosity"]; law += ergun(e) / 9e-4 }
        function ergun(e,    d) { d = 2.5e-3; return atan2(0, -1) / 6 * d / e ^ 3 * (150 * 1.8e-5 * (1 - e) + 1.75 * 1.2 * d * 2) * 2 }
        END { e = 1 - atan2(0, -1) / 6 * (2.5 / 3) ^ 3; ideal = 2000 * ergun(e) / 9e-4
            printf "  drop %g Pa, of the law %g (%g without ends); volume flow off by %.2g at most\n", found, law, ideal, worst
            exit !(found / law > 0.99 && found / law < 1.01 && found / ideal > 0.93 && found / ideal < 1.07 && worst < 0.02) }' last bed/dump.lammpstrj
}
check "the drop of a bed between open sides is the law's" drop 1
check "the drop of a bed between open sides is the law's, on 3 ranks" drop 3

# Walls beside the bed, five spacings apart: the gradient of the pressure is whole there, so the drop is the force on the grains
walled() {
    local walls='[{name: a, shape: plane, point: [0, 0, 0], normal: [1, 0, 0]}, {name: b, shape: plane, point: [30 mm, 0, 0], normal: [-1, 0, 0]}, {name: c, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}, {name: d, shape: plane, point: [0, 30 mm, 0], normal: [0, -1, 0]}]'
    run_scene 1 bed.yaml walled --overwrite --set threads=1 --set box.periodic=false --set "walls=$walls" --set fluid.walls='{velocity: slip, slip_length: 1 m}' &&
        tail -n 1 walled/observables.csv | awk -F , '{ printf "  drop %g Pa, force on the grains over the section %g Pa\n", $2, $3 / 9e-4; exit !($2 / $3 * 9e-4 > 0.98 && $2 / $3 * 9e-4 < 1.02) }'
}
check "the drop of a bed between walls is the force on its grains" walled

# The same drop with steps of the gas in which drag would take its momentum several times
long() { run_scene 1 bed.yaml long --overwrite --set threads=1 --set step.dt='5 ms' --set step.force=true --set fluid.equations=stokes && within "$(last_of long pressure_drop_z)" "$(last_of bed pressure_drop_z)" 0.2; }
check "steps that are long for drag" long

# Gas comes through the plate on which grains rest, and lifts them: its drop is their weight less buoyancy
cat >plate.yaml <<'YAML'
box: {lower: [0, 0, 0], upper: [30 mm, 30 mm, 90 mm], periodic: [true, true, false]}
gravity: [0, 0, -9.81]
contact: {law: hooke}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 200}]
walls: [{name: plate, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], permeable: true}]
particles: {from: lattice, lattice: sc, spacing: 2.6 mm, jitter: 0.4, count: 1000, sizes: 1.25 mm, region: {shape: box, lower: [0, 0, 0], upper: [30 mm, 30 mm, 60 mm]}}
fluid:
  spacing: 6 mm
  density: 1.2
  viscosity: 1.8e-5
  initial: {velocity: [0, 0, 1.4]}
  open: [{side: z_lower, velocity: [0, 0, 1.4]}, {side: z_upper, pressure: 0}]
  grains: {unresolved: 2 mm, every: 10}
drag: {law: gidaspow, porosity: {support: 7.5 mm, every: 10}}
step: {dt: 40 us, count: 8000, speed_max: 3}
observables: {every: 50, list: [{name: pressure_drop, components: z}, {name: mean, of: z, label: height}, {name: drag_over_weight}, {name: wall_force/plate, components: z}]}
output: {checkpoint: {every: 4000}}
YAML
weight=$(awk 'BEGIN { printf "%.6g", 1000 * 2498.8 * atan2(0, -1) / 6 * 2.5e-3 ^ 3 * 9.81 / 9e-4 }')
floats() {
    run_scene "$1" plate.yaml plate --overwrite --set threads=1 && awk -F , -v weight="$weight" '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        $1 > 0.16 { drop += $at["pressure_drop_z"]; held -= $at["plate_fz"] / 9e-4; height += $at["height"]; n++ }
        END { printf "  mean drop %g Pa and %g on the plate of %g of the grains, mean height %g mm\n", drop / n, held / n, weight, 1e3 * height / n
            all = (drop + held) / n / weight; exit !(all > 0.99 && all < 1.01 && drop / n / weight > 0.94) }' plate/observables.csv
}
check "gas lifts a bed: its drop is the weight of the grains" floats 1
resumed() { run_scene 1 plate.yaml resumed --overwrite --set threads=1 --resume plate/checkpoint-4000.h5 && cmp <(tail -n 1 plate/observables.csv) <(tail -n 1 resumed/observables.csv); }
check "and after a resume, with the same bits" resumed
# A dense cloud takes the momentum of gas that blows through it, within less than a step of the gas; all momenta together stay
cat >cloud.yaml <<'YAML'
box: {lower: [0, 0, 0], upper: [30 mm, 30 mm, 30 mm], periodic: true}
contact: {law: hooke}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 200}]
particles: {from: lattice, lattice: sc, spacing: 2.7 mm, jitter: 0.1, count: 1100, sizes: 1.25 mm}
fluid:
  spacing: 6 mm
  density: 1.2
  viscosity: 1.8e-5
  equations: stokes
  initial: {velocity: [0, 0, 3]}
  grains: {unresolved: 2 mm, every: 25}
  solver: {tolerance: 1e-9, petsc: -fluid_u_ksp_rtol 1e-13}
drag: {law: gidaspow, porosity: {support: 7.5 mm, every: 25}}
step: {dt: 40 us, count: 500}
observables: {every: 100, list: [{name: momentum, components: z}, {name: fluid_momentum, components: z}, {name: fluid_velocity, components: z}]}
output: {checkpoint: {at_end: false}}
YAML
kept() {
    run_scene "$1" cloud.yaml cloud --overwrite --set threads=1 && awk -F , 'NR == 2 { first = $2 + $3; gas = $3 } END { off = ($2 + $3) / first - 1
        printf "  of the momentum of the gas %.3g is left to it; all momenta are off by %.2g\n", $3 / gas, off; exit !(NR == 7 && $3 / gas < 0.2 && off * off < 1e-18) }' cloud/observables.csv
}
check "momentum is kept in steps that are long for drag" kept 1
check "momentum is kept in steps that are long for drag, on 3 ranks" kept 3
refused() { # TEXT SETTING...
    scene_refused "$1" cloud.yaml "${@:2}"
}
full() { run_scene 1 cloud.yaml full --overwrite --set threads=1 --set 'particles={from: single, position: [15 mm, 15 mm, 15 mm], radius: 2 mm}' --set 'drag={law: schiller_naumann}' --set fluid.spacing='2 mm' >told 2>&1; grep -q 'grains take .* of the room around a particle of the fluid' told || { cat told; return 1; }; }
check "a spacing that is too short for an average" full

# A plane that a fluid goes through bounds no scalar: the flux is that of two walls 16 apart, 1
cat >sieve.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [16, 16, 0], dimension: 2, periodic: [true, false, false]}
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 16, 0], normal: [0, -1, 0]}
  - {name: sieve, shape: plane, point: [0, 7.3, 0], normal: [0, 1, 0], permeable: true}
fluid: {spacing: 1, density: 1, viscosity: 1, scalars: [{diffusivity: 1, given: [{wall: floor, value: 1}, {wall: lid, value: 0}]}]}
step: {dt: 200, count: 12, force: true}
observables: {every: 12, list: [{name: scalar_1_flux, components: y}]}
output: {checkpoint: {at_end: false}}
YAML
sieve() { run_scene 1 sieve.yaml sieve --overwrite --set threads=1 && within "$(last_of sieve scalar_1_flux_y)" 1 1e-6; }
check "a scalar diffuses through a permeable wall" sieve

# In two dimensions a grain is a sphere in a unit of depth: one as heavy as the fluid goes with it, 0.01 x 0.4
cat >two.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 0], dimension: 2, periodic: true}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1, restitution: 0.9, friction: 0.3}]
particles: {from: single, position: [0.43, 0.51, 0], radius: 0.002}
fluid: {spacing: 0.1, density: 1, viscosity: 1e-9, equations: stokes, grains: {unresolved: 0.01}, drive: {body_force: [0.01, 0, 0]}}
drag: {law: stokes}
step: {count: 40, dt: 1e-2, force: true}
observables: {every: 40, list: [{name: velocity, id: 1, components: x}]}
output: {checkpoint: {at_end: false}}
YAML
disc() { run_scene 1 two.yaml two --overwrite --set threads=1 "$@" && within "$(last_of two particle1_vx)" 0.004 1e-6; }
check "a grain as heavy as the fluid goes with it, in two dimensions" disc
check "and a disc by area" disc --set box.density=area
finish
