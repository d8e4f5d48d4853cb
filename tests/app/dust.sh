#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Grains that a fluid does not resolve, and that it loses momentum to: balance of momentum, Stokes's velocity, clouds, beds, resolved grains beside
# them; ranks, resume, what makes no sense.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# One heavy grain of a fiftieth of the spacing sinks in a periodic box; its terminal velocity by Stokes is 8.80e-4
cat >dust.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: true}
gravity: [0, 0, -1]
contact: {law: hooke}
materials: [{name: a, density: 100}]
material_pairs: [{k_n: 1, restitution: 0.9, friction: 0.3}]
particles: {from: single, position: [0.43, 0.51, 0.52], radius: 0.002}
fluid:
  spacing: 0.1
  density: 1
  viscosity: 0.1
  equations: stokes
  grains: {unresolved: 0.01}
  solver: {tolerance: 1e-9, petsc: -fluid_u_ksp_rtol 1e-13}
drag: {law: stokes}
step: {count: 40, dt: 2e-4}
observables: {every: 20, list: [{name: velocity, id: 1, components: z}, {name: fluid_momentum, components: z}, {name: grain_drag, components: z}]}
output: {checkpoint: {every: 20}}
YAML
needs_petsc dust.yaml 'grains that a fluid does not resolve'

# balance DIR WITHIN: momentum of the grain and of the fluid against the impulse of weight less buoyancy
balance() {
    tail -n 1 "$1/observables.csv" | awk -F , -v most="$2" '{ V = 4 / 3 * atan2(0, -1) * 0.002 ^ 3; off = (100 * V * $2 + $3) / (-99 * V * $1) - 1
        printf "  velocity %g of the grain, momentum %g of the fluid: off by %.2g\n", $2, $3, off; exit !($3 < 0 && off * off < most * most) }'
}
momentum() { # RANKS WITHIN SETTING...
    rm -rf run
    run_scene "$1" dust.yaml run --set threads=1 "${@:3}" && balance run "$2"
}
check "momentum is kept" momentum 1 1e-9
check "the velocity of a grain alone is Stokes's" within "$(last_of run particle1_vz)" -8.80e-4 0.005e-3
check "momentum is kept by a grain of the group free" momentum 1 1e-9 --set particles.group=free
resumed() { run_scene 1 dust.yaml resumed --set threads=1 --set particles.group=free --resume run/checkpoint-20.h5 && balance resumed 1e-9; }
check "and after a resume" resumed
check "momentum is kept on 3 ranks" momentum 3 1e-9
check "momentum is kept by a fluid of longer steps" momentum 1 1e-7 --set fluid.grains.every=5
check "momentum is kept among particles that follow the flow" momentum 1 0.01 --set fluid.equations=navier_stokes --set fluid.motion=lagrangian

# A cloud drags the fluid along, and sinks faster than a grain alone; on other ranks, and after a resume
sed 's/^particles:.*/particles: {from: random, count: 100, sizes: 0.002, region: {shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.2}}/
    s/{name: velocity, id: 1, components: z}/{name: momentum, components: z}/; s/count: 40/count: 300/; s/every: 20/every: 150/' dust.yaml >cloud.yaml
# of DIR: the mean velocity over that of a grain alone
of() {
    last_of "$1" momentum_z | awk '{ print $1 / (100 * 100 * 4 / 3 * atan2(0, -1) * 0.002 ^ 3 * -8.80e-4) }'
}
cloud() { # DIR RANKS FLAG...
    rm -rf "$1"
    run_scene "$2" cloud.yaml "$1" --set threads=1 "${@:3}"
}
faster() { cloud cloud 1 && echo "  $(of cloud) times a grain alone" && awk -v f="$(of cloud)" 'BEGIN { exit !(f > 1.15 && f < 2.2) }'; }
check "a cloud sinks faster than a grain alone" faster
other() { cloud other "$@" && within "$(of other)" "$(of cloud)" 1e-7; }
check "a cloud on 3 ranks" other 3
check "a cloud after a resume" other 1 --resume cloud/checkpoint-150.h5

# A bed of grains at rest in a channel of given flow: the pressure that drives the flow is the sum of the drag of the law
cat >bed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: true}
groups: [{name: bed, motion: frozen}]
particles: {from: lattice, lattice: sc, spacing: 0.0625, sizes: 0.025, group: bed, density: 2}
fluid:
  spacing: 0.125
  density: 1
  viscosity: 0.01
  grains: {unresolved: 0.025}
  drive: {mass_flow: 0.05, axis: z}
drag: {law: di_felice, porosity: {support: 0.15}}
step: {count: 60, dt: 1e-3}
observables: {every: 60, list: [{name: pressure_drop, components: z}, {name: grain_drag, components: z}, {name: fluid_velocity, components: z}, {name: porosity_mean}]}
output: {checkpoint: {at_end: false}}
YAML
bed() {
    run_scene 1 bed.yaml bed --set threads=1 && tail -n 1 bed/observables.csv | awk -F , '
        { d = 0.05; e = $5; re = d * $4 / 0.01; log10 = log(re) / log(10)
          x = 3.7 - 0.65 * exp(-(1.5 - log10) ^ 2 / 2); K = atan2(0, -1) / 8 * d ^ 2 * (0.63 + 4.8 / sqrt(re)) ^ 2 * $4 * e ^ -(x + 1); f = 4096 * K * $4
          printf "  porosity %g, drop %g, drag %g, law %g\n", e, $2, $3, f
          exit !($2 / $3 > 0.999 && $2 / $3 < 1.001 && $3 / f > 0.995 && $3 / f < 1.005) }'
}
check "the drop over a bed is the drag of the law" bed

# Grains of two classes in one fluid: a sphere that is resolved stands in a stream, small grains go around it
cat >two.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1.5, 1, 1], periodic: true}
contact: {law: hooke}
materials: [{name: a, density: 100}]
material_pairs: [{k_n: 1, restitution: 0.9, friction: 0.3}]
groups: [{name: rock, motion: frozen}]
particles:
  sources:
    - {from: single, position: [0.75, 0.5, 0.5], radius: 0.26, group: rock}
    - {from: random, count: 60, sizes: 0.004, region: {shape: box, lower: [0, 0.25, 0.25], upper: [0.4, 0.75, 0.75]}}
fluid:
  spacing: 0.125
  density: 1
  viscosity: 0.1
  initial: {velocity: [1, 0, 0]}
  drive: {mass_flow: 1, axis: x}
  grains: {unresolved: 0.01, every: 20}
drag: {law: schiller_naumann}
step: {count: 1000, dt: 1e-3, force: true}
observables: {every: 1000, list: [{name: drag/rock, components: x}, {name: grain_drag, components: x}]}
output: {checkpoint: {at_end: false}, dump: {every: 1000, fields: [id, position, velocity, radius]}}
YAML
two() {
    run_scene "$1" two.yaml two --overwrite --set threads=1 && awk -v L=1.5 '
        /^ITEM: TIMESTEP/ { frame++ }
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        /^ITEM/ { reading = 0 }
        reading && frame == 2 && $at["radius"] == 0.004 { n++; u = $at["vx"]; sum += u
            r = sqrt(($at["x"] - 0.75) ^ 2 + ($at["y"] - 0.5) ^ 2 + ($at["z"] - 0.5) ^ 2); if (r < 0.26) inside++ }
        END { printf "  %d small grains, mean velocity %g, %d in the sphere\n", n, sum / n, inside
            exit !(n == 60 && sum / n > 0.2 && inside == 0) }' two/dump.lammpstrj && awk -F , 'END { printf "  drag %g on the sphere\n", $2; exit !($2 > 0.1) }' two/observables.csv
}
check "small grains go around a resolved one" two 1

refused() { # TEXT SETTING...
    scene_refused "$1" dust.yaml "${@:2}"
}
# The first step is as long as the slip at the start allows: the same for a grain at rest in a fluid that flows and for one that moves through a fluid at rest
limits() { # SETTING...: the stable step
    "$scree" check --all dust.yaml --set drag.law=schiller_naumann --set 'material_pairs[0].k_n=1e-9' --set step='{count: 4, fraction: 0.5, force: true}' --set guards='{speed: off, overlap: off}' "$@" | awk '$1 == "stable" { print $2 }'
}
slips() {
    local flow=(--set 'fluid.initial.velocity=[2500, 0, 0]') moves=(--set 'particles.velocity=[2500, 0, 0]') along against both
    along=$(limits "${flow[@]}") && against=$(limits "${moves[@]}") && both=$(limits "${flow[@]}" "${moves[@]}")
    echo "  $along, $against, without slip $both"
    within "$along" "$against" 1e-9 && within "$both" "$(limits)" 1e-9 && awk -v a="$along" -v b="$both" 'BEGIN { exit !(b > 4 * a && a > 0) }'
}
check "the limit of the first step knows the slip" slips
check "unresolved grains without drag" refused 'fluid.grains.unresolved|drag' --set 'drag=~'
check "a fluid that is given, too" refused 'drag.fluid|fluid.grains.unresolved' --set 'drag.fluid={density: 1, viscosity: 1}'
check "two bounds" refused 'drag.largest|fluid.grains.unresolved' --set drag.largest=0.01
check "a steady flow" refused 'fluid.grains.unresolved|transient' --set fluid.time=steady
check "steps of a fluid that moves nothing" refused 'fluid.grains.every' --set 'fluid.grains={every: 4}' --set 'drag=~'
check "no fluid for drag" refused 'drag.fluid|missing' --set 'fluid.grains={motion: given}' --set 'groups=[{name: g, motion: frozen}]' --set 'particles={from: single, position: [0.5, 0.5, 0.5], radius: 0.3, group: g}'
slow() { run_scene 1 bed.yaml slow --set threads=1 --set step.dt=0.1 --set step.force=true --set fluid.motion=lagrangian >told; grep -q 'fluid.grains.unresolved: grains take the momentum' told || { cat told; return 1; }; }
check "a step too long for the exchange, among particles that follow the flow" slow
# all ranks stop, with one message, where one of them has a grain without fluid around it
sed 's/^box:.*/box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: [true, true, false]}\nguards: {speed: off, overlap: off, energy: off}\nwalls: [{name: floor, shape: plane, point: [0, 0, 0.2], normal: [0, 0, 1]}, {name: lid, shape: plane, point: [0, 0, 0.8], normal: [0, 0, -1]}]/
    s/position: \[0.43, 0.51, 0.52\]/position: [0.43, 0.51, 0.2021], velocity: [0, 0, -3000]/; s/k_n: 1,/k_n: 1e-9,/' dust.yaml >lost.yaml
lost() { run_scene "$1" lost.yaml lost --overwrite --set threads=1 >told 2>&1; grep -q 'grain 1 has no fluid around it in step 1' told || { cat told; return 1; }; }
check "a grain that leaves the fluid" lost 1
check "a grain that leaves the fluid, on 2 ranks" lost 2
# All kinds of motion in one scene: its checkpoint has more datasets than any other, and a resume goes on with the same bits
cat >all.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1.2, 0], periodic: [true, false, false], dimension: 2}
gravity: [0, -10, 0]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 1.2, 0], normal: [0, -1, 0], motion: [{kind: translate, velocity: [1, 0, 0]}]}
contact: {law: hooke}
materials: [{name: disc, density: 7}]
material_pairs: [{k_n: 5, restitution: 0.5, friction: 0.2}]
groups: [{name: m, motion: moving, velocity: [0.2, 0, 0]}]
particles:
  sources:
    - {from: single, position: [0.5, 0.7, 0], radius: 0.15}
    - {from: single, position: [0.5, 0.2, 0], radius: 0.12, group: m}
    - {from: single, position: [0.1, 0.6, 0], radius: 0.01}
    - {from: single, position: [0.9, 0.5, 0], radius: 0.01}
fluid: {spacing: 0.05, density: 1, viscosity: 0.1, motion: lagrangian, grains: {motion: free, every: 4, unresolved: 0.02}}
drag: {law: schiller_naumann}
step: {dt: 4e-4, count: 80, force: true}
observables: {every: 40, list: [{name: energy}, {name: centre}, {name: fluid_velocity}]}
output: {checkpoint: {every: 40}}
YAML
all() {
    run_scene 1 all.yaml all --set threads=1 && run_scene 1 all.yaml again --set threads=1 --resume all/checkpoint-40.h5 &&
        cmp <(tail -n 1 all/observables.csv) <(tail -n 1 again/observables.csv)
}
check "grains of all kinds of motion, resumed" all
finish
