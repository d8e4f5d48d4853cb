#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rigid bodies in a fluid that is rigid inside of them (tests/app/fluid_rigid.sh has single grains): a clump of one sphere is a sphere, a body of the fluid's
# density does nothing, two spheres that touch sink as they should, bodies fall and rest, bodies with a given motion stir.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >box.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 24, 0], dimension: 2, periodic: [true, false, false]}
gravity: [0, -0.0833333, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 24, 0], normal: [0, -1, 0]}
contact: {law: hertz}
materials: [{name: glass, density: 0.46875, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0.3}]
particles: {from: single, position: [16.2, 14, 0], radius: 4}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: free}
step: {dt: 0.25, count: 20, force: true}
observables: {every: 20, list: [{name: velocity, id: 1}, {name: position, id: 1}, {name: energy_kinetic}, {name: energy_balance}]}
output: {checkpoint: {at_end: false}}
YAML
needs_petsc box.yaml 'rigid bodies in a fluid'

calc() { awk "BEGIN { printf \"%.12g\", $1 }"; }

one='bodies={clumps: [{name: one, spheres: [{centre: [0, 0, 0], radius: 1}], orientation: given, quaternion: [1, 0, 0, 0]}]}'
alike() { # SETTING...
    rm -rf grain body
    run_scene 1 box.yaml grain --set threads=1 "$@" && run_scene 1 box.yaml body --set threads=1 "$@" --set "$one" && rows_close grain body 1e-3
}
check "a clump of one sphere sinks as the sphere" alike
check "a light one rises as the sphere" alike --set 'materials[0].density=0.05'
check "with a solver of contacts, too" alike --set 'contact={law: rigid, solver: {sweeps: 50}}' --set 'materials=[{name: glass, density: 0.46875}]'
check "one with a given spin stirs as the sphere" alike --set 'groups=[{name: turned, motion: moving, omega: [0, 0, 0.02]}]' --set particles.group=turned \
    --set 'observables.list=[{name: drag, target: turned}, {name: fluid_energy}]'

# Two spheres that touch, in a periodic box of 24 spacings, against a force on the fluid that holds the whole at rest. Alone they sink at F / (6 pi mu r) / (2 x 0.645) along
# their line (Stimson and Jeffery 1926), and / (2 x 0.724) across it; the box takes 2.837 / L of 1 / r (Hasimoto 1959), and gives some of it back as they are long
cat >pair.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [24, 24, 24], periodic: true}
gravity: [1, 0, 0]
particles: {from: single, position: [12.1, 12.2, 12.3], radius: 6, density: 1.01}
bodies: {clumps: [{name: two, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}], orientation: given, quaternion: [1, 0, 0, 0]}]}
fluid: {spacing: 1, density: 1, viscosity: 1, equations: stokes, grains: free, drive: {body_force: [-1.6362e-4, 0, 0]}}
step: {dt: 5, count: 16, force: true}
observables: {every: 16, list: [{name: velocity, id: 1}]}
output: {checkpoint: {at_end: false}}
YAML
sinks() { # QUATERNION LAMBDA
    rm -rf sunk
    run_scene 1 pair.yaml sunk --set threads=1 --set "bodies.clumps[0].quaternion=$1" || return
    awk -v u="$(last_of sunk particle1_vx)" -v lambda="$2" 'BEGIN { r = 3; pi = 3.14159265358979; f = 2 * 4 / 3 * pi * r ^ 3 * 0.01; v = f / (6 * pi) * (1 / (2 * lambda * r) - 2.837 / 24)
        printf "  sinks at %.4g of the formula\n", u / v; exit !(u > 0.97 * v && u < 1.1 * v) }'
}
check "two spheres that touch sink along their line" sinks '[1, 0, 0, 0]' 0.645
check_long "two spheres that touch sink across their line" sinks '[1, 0, 0, 1]' 0.7243
still() {
    rm -rf still
    run_scene 1 pair.yaml still --set threads=1 --set step.count=4 --set observables.every=4 --set particles.density=1 --set 'fluid.drive.body_force=[0, 0, 0]' \
        --set 'bodies.clumps[0].quaternion=[2, 0.3, 1, 0]' && awk -v u="$(last_of still particle1_vx)" 'BEGIN { exit !(u ^ 2 < 1e-20) }'
}
check "a body of the fluid's density stays" still

# Two bodies fall onto a floor and onto each other
cat >bed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [20, 20, 20], periodic: [true, true, false]}
gravity: [0, 0, -0.0833333]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: lid, shape: plane, point: [0, 0, 20], normal: [0, 0, -1]}
contact: {law: rigid, solver: {sweeps: 100, tolerance: 1e-6}}
materials: [{name: glass, density: 2.5}]
material_pairs: [{restitution: 0.2, friction: 0.3}]
particles:
  sources:
    - {from: single, position: [10, 10, 5], radius: 4.5}
    - {from: single, position: [2, 12, 14], radius: 4.5}
bodies: {clumps: [{name: two, spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.5, 0, 0], radius: 1}], orientation: given, quaternion: [2, 0.3, 1, 0]}]}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: free}
step: {dt: 0.25, count: 320, force: true}
observables: {every: 80, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: centre}, {name: wall_force, target: floor}, {name: fluid_velocity}, {name: energy_balance}, {name: position, id: 1}]}
output: {checkpoint: {every: 240}}
YAML
falls() {
    run_scene 1 bed.yaml bed --set threads=1 && awk -F , '
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { energy = $at["energy_kinetic"]; most = energy > most ? energy : most; floor = $at["floor_fz"]; balance[NR] = $at["energy_balance"] }
        END { weight = 2 * 190.852 * 1.5 * 0.0833333; drift = (balance[NR] - balance[2]) / balance[2]
              printf "  floor carries %.4g of the weight, energy %.2g of its peak, balance %.1g\n", -floor / weight, energy / most, drift
              exit !(floor < -0.9 * weight && floor > -1.1 * weight && energy < 0.1 * most && drift ^ 2 < 1e-6) }' bed/observables.csv
}
check "two bodies fall and rest" falls
again() { # RANKS BOUND FLAG...
    local ranks=$1 bound=$2
    shift 2
    rm -rf other
    run_scene "$ranks" bed.yaml other --set threads=1 "$@" && rows_close bed other "$bound"
}
check "a resume gives the same bits" eval 'again 1 0 --resume bed/checkpoint-240.h5'
check "the same on 2 ranks, to the tolerance" again 2 5e-3
soft=(--set 'contact={law: hertz}' --set 'materials=[{name: glass, density: 2.5, young: 1000, poisson: 0.3}]' --set fluid.grains.every=40 --set step.dt=0.00625 --set step.count=800
    --set observables.every=800 --set output.checkpoint.every=400)
cube='bodies={shapes: [{name: cube, vertices: [-1,-1,-1, 1,-1,-1, -1,1,-1, 1,1,-1, -1,-1,1, 1,-1,1, -1,1,1, 1,1,1], rounding: 0.1, orientation: given, quaternion: [2, 0.3, 1, 0]}]}'
softly() { # FLAG...
    rm -rf bed
    run_scene 1 bed.yaml bed --set threads=1 "${soft[@]}" "$@" && again 2 1e-3 "${soft[@]}" "$@" && again 1 0 "${soft[@]}" "$@" --resume bed/checkpoint-400.h5 &&
        again 1 1e-6 "${soft[@]}" "$@" --set index=hgrid --set threads=2
}
check "soft contacts: 2 ranks, a resume, another index" softly
check "rocks: 2 ranks, a resume, another index" softly --set "$cube"

# A bar that turns as given drives the fluid
turns() {
    local ranks
    for ranks in 1 2; do
        rm -rf "bar$ranks"
        run_scene "$ranks" box.yaml "bar$ranks" --set threads=1 --set 'groups=[{name: bar, motion: moving, omega: [0, 0, 0.05]}]' --set particles.group=bar --set particles.radius=8 \
            --set 'particles.position=[16, 12, 0]' --set step.count=40 --set observables.every=40 --set 'observables.list=[{name: drag, target: bar}, {name: fluid_energy}, {name: fluid_velocity}]' \
            --set 'bodies={clumps: [{name: bar, spheres: [{centre: [0, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}, {centre: [2, 0, 0], radius: 1}, {centre: [-1, 0, 0], radius: 1}, {centre: [-2, 0, 0], radius: 1}], orientation: given, quaternion: [1, 0, 0, 0]}]}' ||
            return
    done
    awk -v t="$(last_of bar1 drag_bar_torque_z)" -v e="$(last_of bar1 fluid_energy)" 'BEGIN { printf "  torque %.4g, energy %.4g\n", t, e; exit !(t < -1 && e > 1e-4) }' && rows_close bar1 bar2 2e-3
}
check "a bar that turns stirs the fluid, on 1 and 2 ranks" turns

refused() { # TEXT SETTING...
    local text=$1
    shift
    on 1 "$scree" check bed.yaml "$@" >said 2>&1
    [ $? = 2 ] && grep -q "$text" said || { cat said; false; }
}
check "a given centre is refused" refused 'bodies.clumps\[0\]: a given centre .*allowed with it: those of the shape' --set 'bodies.clumps[0].centre=[0, 0, 0]' --set 'bodies.clumps[0].inertia=[1, 1, 1, 0, 0, 0]' --set 'bodies.clumps[0].mass=1000'
check "mirrors of bodies are refused" refused 'fluid: a fluid around bodies needs coupling: rigid' --set fluid.motion=lagrangian --set 'contact={law: hertz}' \
    --set 'materials=[{name: glass, density: 2.5, young: 1000, poisson: 0.3}]'

# A body that resists rolling, by a solver of contacts, comes to rest with its lean on the floor; without the resistance it turns on
leans() { # RANKS DIR SETTING...
    run_scene "$1" box.yaml "$2" --set threads=1 --set 'particles={from: single, position: [16.2, 6, 0], radius: 4.6, velocity: [0.1, -0.1, 0]}' --set step.count=160 \
        --set 'bodies={clumps: [{spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 0.95}]}]}' --set 'materials=[{name: glass, density: 0.46875}]' \
        --set 'contact={law: rigid, solver: {sweeps: 50}}' --set 'observables={every: 160, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: centre}, {name: wall_force, target: floor}]}' "${@:3}"
}
resists=(--set contact.rolling=spring --set material_pairs[0].rolling_friction=0.3)
held() { leans 1 held "${resists[@]}" && within "$(last_of held/observables.csv energy_rotational)" 0 1e-8 && leans 1 loose && ! within "$(last_of loose/observables.csv energy_rotational)" 0 1e-4; }
check "a body rests by its resistance to rolling" held
check "the same on 2 ranks" leans 2 held2 "${resists[@]}"
check "to the tolerance" rows_close held held2 1e-5

finish
