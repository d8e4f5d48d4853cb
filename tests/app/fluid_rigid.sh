#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Grains in which the flow of a fluid is rigid: the same on all ranks and layouts, restart, momentum, drag, rest, and what does not go with them.
# Closed forms and published values are cases of examples/verify.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# three discs of 2.5 times the fluid's density fall onto a floor and onto each other; one of them lies across the border of two ranks
cat >drop.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 24, 0], dimension: 2, periodic: [true, false, false]}
gravity: [0, -0.0833333, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 24, 0], normal: [0, -1, 0]}
contact: {law: hertz}
materials: [{name: glass, density: 0.46875, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0.3}]
particles: {from: file, format: table, file: discs.txt, columns: [x, y, z, radius]}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, coupling: rigid, every: 40}}
step: {dt: 0.00625, count: 1600}
observables: {every: 400, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: centre}, {name: wall_force, target: floor}, {name: fluid_velocity}, {name: fluid_speed}, {name: energy_balance}]}
output: {checkpoint: {every: 800}}
YAML
printf '%s\n' '16.2 4.5 0 4' '20 12 0 4' '1 6 0 4' >discs.txt
needs_petsc drop.yaml 'rigid grains in a fluid'

one() { run_scene 1 drop.yaml one --set threads=1; }
check "three discs fall on one rank" one
ranks() { # RANKS BOUND SETTING...
    local ranks=$1 bound=$2
    shift 2
    rm -rf other
    run_scene "$ranks" drop.yaml other --set threads=1 "$@" && rows_close one other "$bound"
}
check "the same on 2 ranks, to the tolerance" ranks 2 2e-3
check_long "the same on 4 ranks, to the tolerance" ranks 4 2e-3
check "the same with another index and 2 threads" ranks 1 1e-6 --set index=hgrid --set threads=2
resumes() { # RANKS BOUND
    rm -rf other
    run_scene "$1" drop.yaml other --set threads=1 --resume one/checkpoint-800.h5 && rows_close one other "$2"
}
check "a resume gives the same bits" eval 'resumes 1 0 && cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv)'
check "a resume on 2 ranks agrees to the tolerance" resumes 2 2e-3

# Momentum of what a periodic box holds, that of nodes and what grains have more than the fluid in them, over that of the grains at the start
cat >free.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 32, 0], dimension: 2, periodic: true}
particles:
  sources:
    - {from: single, position: [8, 9, 0], radius: 4, density: 0.46875, velocity: [0.5, 0.2, 0]}
    - {from: single, position: [22, 13, 0], radius: 4, density: 0.1875, velocity: [-0.3, 0.4, 0]}
    - {from: single, position: [15, 25, 0], radius: 4, density: 0.05625, velocity: [0.1, -0.6, 0]}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, coupling: rigid}}
step: {dt: 0.25, count: 40}
output: {dump: {every: 1, fields: [id, kind, velocity, solid]}}
YAML
momentum() {
    run_scene 1 free.yaml free --set threads=1 --set output.dump.every=20 && awk '
        BEGIN { s[1] = 2.5; s[2] = 1; s[3] = 0.3; a = 16 * 3.14159265358979 }
        /^ITEM: TIMESTEP/ { n++ } /^ITEM/ || NF < 7 { next }
        { m = $6 == 0 ? a * (s[$1] - 1) : 1; x[n] += m * $3; y[n] += m * $4; filled[n] += $7
          if ($6 == 0) { size += n == 1 ? a * s[$1] * sqrt($3 ^ 2 + $4 ^ 2) : 0; u[n] += $3 } }
        END { d = sqrt((x[3] - x[2]) ^ 2 + (y[3] - y[2]) ^ 2) / size
              printf "  %d frames, momentum changes by %.2g; filled %.4g of %.4g\n", n, d, filled[n] / 3, a
              exit !(n == 3 && d < 1e-3 && filled[n] / 3 > 0.98 * a && filled[n] / 3 < 1.03 * a && u[n] != u[1]) }' free/dump.lammpstrj
}
check "free discs and the fluid keep their momentum, at 2.5, 1 and 0.3 of its density" momentum

# Square array of discs at a fifth of the area: 51.53 (Sangani and Acrivos 1982), whatever the step
cat >array.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [16, 16, 0], periodic: true, dimension: 2}
particles: {from: single, position: [8, 8, 0], radius: 4.0368, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid: {spacing: 1, density: 1, viscosity: 1, equations: stokes, grains: {coupling: rigid}, drive: {body_force: [1, 0, 0]}}
step: {dt: 2, count: 200}
observables: {every: 200, list: [{name: fluid_velocity, components: x}, {name: fluid_porosity}, {name: drag, target: bed, components: x}]}
YAML
array() { # DT COUNT
    rm -rf array
    run_scene 1 array.yaml array --set threads=1 --set step.dt="$1" --set step.count="$2" --set observables.every="$2" &&
        within "$(calc "256 / $(last_of array fluid_velocity_x)")" 51.53 1.1 && within "$(last_of array fluid_porosity)" 0.8 0.008 &&
        within "$(last_of array drag_bed_x)" "$(calc "256 - 16 * 16 * 0.2")" 1.5
}
calc() { awk "BEGIN { printf \"%.12g\", $1 }"; }
check "the drag of a square array, long steps" array 8 60
check "the drag of a square array, short steps" array 1 300

# Open sides: a light disc goes with the flow, and out of the box
cat >open.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 16, 0], dimension: 2}
gravity: [0, -0.002, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 16, 0], normal: [0, -1, 0]}
particles: {from: single, position: [22, 8, 0], radius: 3, density: 0.09}
fluid: {spacing: 1, density: 1, viscosity: 0.5, grains: free, open: [{side: x_lower, velocity: [0.3, 0, 0], profile: parabolic}, {side: x_upper, pressure: 0}]}
step: {dt: 0.5, count: 120}
observables: {every: 120, list: [{name: velocity, id: 1}, {name: position, id: 1}]}
output: {checkpoint: {at_end: false}}
YAML
leaves() {
    run_scene 1 open.yaml open --set threads=1 && awk -v x="$(last_of open particle1_x)" -v v="$(last_of open particle1_vx)" 'BEGIN { printf "  at %.4g with %.4g\n", x, v; exit !(x > 35 && v > 0.2 && v < 0.35) }'
}
check "a light disc leaves by an open side" leaves

# A disc creeps along a floor: its path is that of the velocity that the fluid finds, though half of its momentum is lost to drag within a step of the fluid
cat >slide.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [24, 16, 0], dimension: 2, periodic: [true, false, false]}
gravity: [0.05, -0.0833333, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 16, 0], normal: [0, -1, 0]}
contact: {law: hertz}
materials: [{name: glass, density: 0.46875, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0}]
particles: {from: single, position: [12, 4, 0], radius: 4}
fluid: {spacing: 1, density: 1, viscosity: 10, equations: stokes, grains: {motion: free, coupling: rigid, every: 10}}
step: {dt: 0.025, count: 1600}
observables: {every: 40, list: [{name: position, id: 1}, {name: velocity, id: 1}]}
output: {checkpoint: {at_end: false}}
YAML
creeps() { # SETTING...
    rm -rf slid
    run_scene 1 slide.yaml slid --set threads=1 "$@" && awk -F , '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        NR > 15 { v = $at["particle1_vx"]; x = $at["particle1_x"]; if (n++) { path += x - last[1]; sum += 0.5 * (v + last[2]) * ($1 - last[0]) }; last[0] = $1; last[1] = x; last[2] = v }
        END { printf "  path over the integral of the velocity: %.5g\n", path / sum; exit !(n > 20 && sum > 0.1 && path > 0.998 * sum && path < 1.002 * sum) }' slid/observables.csv
}
check "a disc that creeps along a floor goes as fast as the fluid says" creeps
check "the same by a solver of contacts" creeps --set 'contact={law: rigid, solver: {sweeps: 50}}' --set 'materials=[{name: glass, density: 0.46875}]' --set step.dt=0.25 \
    --set step.force=true --set fluid.grains.every=1 --set step.count=160 --set observables.every=4

refused() { # TEXT SETTING...
    local text=$1
    shift
    on 1 "$scree" check drop.yaml "$@" >said 2>&1
    [ $? = 2 ] && grep -q "$text" said || { cat said; false; }
}
check "steady flows are refused" refused 'fluid.time: .*allowed with it: transient' --set fluid.time=steady --set fluid.equations=stokes
check "particles that move are refused" refused 'fluid.motion: .*allowed with it: fixed' --set fluid.motion=lagrangian
check "unresolved grains are refused" refused 'fluid.grains.unresolved: ' --set fluid.grains.unresolved=0.1 --set drag.law=stokes
check "slip is refused" refused 'fluid.walls.velocity: ' --set 'fluid.walls={velocity: slip, slip_length: 1}'
check "other lattices are refused" refused 'fluid.fill.arrangement: ' --set fluid.fill.arrangement=hexagonal

# What is observed between steps is the same run
seen() {
    rm -rf other
    run_scene 1 drop.yaml other --set threads=1 --set step.count=800 --set observables.every=800 && mv other seldom &&
        run_scene 1 drop.yaml other --set threads=1 --set step.count=800 --set observables.every=40 &&
        cmp <(tail -n 1 seldom/observables.csv) <(tail -n 1 other/observables.csv)
}
check "observables change no bit of the flow" seen

# A solver of contacts in the step of the fluid: three discs fall, roll apart and rest
solved=(--set 'contact={law: rigid, solver: {sweeps: 200, tolerance: 1e-6}}' --set 'materials=[{name: glass, density: 0.46875}]' --set step.dt=0.25 --set step.force=true
    --set fluid.grains.every=1 --set step.count=400 --set observables.every=100 --set output.checkpoint.every=200)
solves() {
    rm -rf one
    run_scene 1 drop.yaml one --set threads=1 "${solved[@]}" && awk -F , '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { energy = $at["energy_kinetic"]; most = energy > most ? energy : most; floor = $at["floor_fy"]; y = $at["centre_y"]; balance[NR] = $at["energy_balance"] }
        END { weight = 3 * 3.14159265358979 * 16 * 1.5 * 0.0833333; drift = (balance[NR] - balance[2]) / balance[2]
              printf "  floor carries %.4g of the weight, discs at %.6g, energy %.2g of its peak, balance %.1g\n", -floor / weight, y, energy / most, drift
              exit !(floor < -0.98 * weight && floor > -1.02 * weight && y > 3.998 && y < 4 && energy < 0.05 * most && drift ^ 2 < 1e-6) }' one/observables.csv
}
check "discs fall and rest by a solver of contacts" solves
check "the same on 2 ranks, to the tolerance" ranks 2 2e-3 "${solved[@]}"
check "a resume gives the same bits" eval 'rm -rf other; run_scene 1 drop.yaml other --set threads=1 "${solved[@]}" --resume one/checkpoint-200.h5 &&
    cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv)'
check "Newton's method gives the same" ranks 1 2e-3 "${solved[@]}" --set contact.solver.name=newton
check "a solver of contacts and mirrors are refused" refused 'fluid: .*needs coupling: rigid' "${solved[@]}" --set fluid.grains=free --set fluid.motion=lagrangian

# Lubrication of gaps below two spacings: discs land and roll apart slower; the same on all layouts
near=(--set fluid.grains.lubrication=0.02)
lands() {
    local bare=$1
    shift
    rm -rf one
    run_scene 1 drop.yaml one --set threads=1 "$@" && awk -F , 'NR == FNR { bare = $2; next } { now = $2 } END { printf "  energy %.4g, %.4g without\n", now, bare; exit !(now != bare && now < 10 * bare) }' "$bare" one/observables.csv
}
check "discs with lubrication fall" eval 'rm -rf bare && run_scene 1 drop.yaml bare --set threads=1 && lands bare/observables.csv "${near[@]}"'
check "the same on 2 ranks, to the tolerance" ranks 2 2e-3 "${near[@]}"
check "a resume gives the same bits" eval 'rm -rf other; run_scene 1 drop.yaml other --set threads=1 "${near[@]}" --resume one/checkpoint-800.h5 &&
    cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv)'
check "lubrication and mirrors are refused" refused 'fluid.grains.lubrication: .*needs coupling: rigid' --set fluid.grains='{motion: free, lubrication: 0.02}' --set fluid.motion=lagrangian
check "a roughness above the gaps that have lubrication is refused" refused 'fluid.grains.lubrication: .*less than 2 spacings, 2' --set fluid.grains.lubrication=2
notes() { "$scree" check --all drop.yaml "$@" >said 2>&1 && grep -c 'gaps  *NOTE\|too coarse' said; }
told() { [ "$(notes)" = 2 ] && [ "$(notes "${near[@]}")" = 0 ] && grep -q 'gaps  *1 between grains and 1 between' said || { cat said; return 1; }; }
check "narrow gaps are too coarse without lubrication alone" told
check "lubrication by a solver of contacts" lands bare/observables.csv "${solved[@]}" "${near[@]}"

# Grains that are smaller to the fluid: the filled area is theirs
small() {
    rm -rf array
    run_scene 1 array.yaml array --set threads=1 --set fluid.grains.hydraulic=0.8 --set step.count=40 --set observables.every=40 &&
        within "$(last_of array fluid_porosity)" "$(calc '1 - 0.2 * 0.64')" 0.008
}
check "grains that are smaller to the fluid" small
smaller=(--set fluid.grains.hydraulic=0.8)
check "they fall" eval 'rm -rf one; run_scene 1 drop.yaml one --set threads=1 "${smaller[@]}"'
check "the same on 2 ranks, to the tolerance" ranks 2 2e-3 "${smaller[@]}"
check "a resume gives the same bits" eval 'rm -rf other; run_scene 1 drop.yaml other --set threads=1 "${smaller[@]}" --resume one/checkpoint-800.h5 &&
    cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv)'
check "a resume on 2 ranks agrees to the tolerance" ranks 2 2e-3 "${smaller[@]}" --resume one/checkpoint-800.h5
check "lubrication beside them is refused" refused 'fluid.grains.lubrication: .*one of the two' "${near[@]}" --set fluid.grains.hydraulic=0.8
check "mirrors of them are refused" refused 'fluid.grains.hydraulic: ' --set fluid.grains='{motion: given, coupling: mirror, hydraulic: 0.8}'

# A drum that is full of water turns: it lifts the discs in it until they roll down
cat >drum.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [48, 48, 0], dimension: 2, density: area}
gravity: [0, -0.0833333, 0]
walls: [{name: drum, shape: cylinder, point: [24, 24, 0], axis: [0, 0, 1], radius: 22, inside: true, motion: [{kind: rotate, direction: [0, 0, 1], point: [24, 24, 0], rate: 0.01}]}]
contact: {law: hertz}
materials: [{name: glass, density: 2.5, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0.5}]
seed: 1
particles: {from: random, count: 9, sizes: 4}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, every: 40, hydraulic: 0.8}}
step: {dt: 0.00625, count: 20000}
observables: {every: 2000, list: [{name: centre}, {name: fluid_speed}, {name: energy_balance}]}
output: {checkpoint: {at_end: false}}
YAML
turns() {
    run_scene 1 drum.yaml drum --set threads=1 && awk -v x="$(last_of drum centre_x)" -v y="$(last_of drum centre_y)" -v v="$(last_of drum fluid_speed)" \
        'BEGIN { printf "  discs at %.4g, %.4g, water up to %.3g\n", x, y, v; exit !(x > 27 && x < 36 && y > 10 && y < 20 && v > 0.2 && v < 1) }'
}
check "a drum of water and discs turns" turns
# Lubrication at a wall that slides within itself
oiled() { # RANKS DIR FLAG...
    run_scene "$1" drum.yaml "$2" --set threads=1 --set fluid.grains.hydraulic=1 "${near[@]}" --set step.count=2400 --set observables.every=1200 --set output.checkpoint='{every: 1200}' \
        --set 'observables.list=[{name: centre}, {name: fluid_speed}, {name: energy_balance}, {name: energy_kinetic}, {name: energy_rotational}, {name: wall_force, target: drum}]' "${@:3}"
}
check "a drum that turns, with lubrication" eval 'rm -rf one; oiled 1 one && awk -v e="$(last_of one energy_rotational)" "BEGIN { exit !(e > 0) }"'
check "the same on 2 ranks, to the tolerance" eval 'rm -rf other; oiled 2 other && rows_close one other 5e-3'
check "a resume gives the same bits" eval 'rm -rf other; oiled 1 other --resume one/checkpoint-1200.h5 && cmp <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv)'

check "ten discs fall and rest" env SCREE="$scree" SCREE_ARGS='--set threads=1' sh "$top_srcdir/examples/water_bed/check" "$out/bed"
finish
