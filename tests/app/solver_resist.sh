#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rolling and twisting under contact.solver: a ball rolls to rest in v^2/(2 a), a ball stays on a slope up to tan = mu_r, a spin dies
# linearly, all of them as without the solver; a bed goes on from a checkpoint, on any ranks and threads; what has no form is refused.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >ball.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [20, 4, 4]}
gravity: [0, 0, -10]
step: {count: 800, dt: 1e-3}
contact: {law: rigid, rolling: spring, solver: {tolerance: 1e-8}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.5, rolling_friction: 0.2}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles: {sources: [{from: single, position: [2, 2, 0.5], radius: 0.5, velocity: [1, 0, 0], omega: [0, 2, 0]}]}
observables: {every: {steps: 400}, list: [{name: energy_rotational}, {name: energy_balance}, {name: overlap_max}]}
output: {dump: {every: {steps: 400}, fields: [position, angular_velocity]}}
EOS
sed 's/velocity: .1, 0, 0., omega: .0, 2, 0./omega: [0, 0, 5]/; s/rolling: spring/twisting: sds/
    s/rolling_friction: 0.2/twisting_stiffness: 100, twisting_friction: 0.01/' ball.yaml >spin.yaml
hooke=(--set contact.law=hooke --set material_pairs[0].k_n=1e4)
explicit=("${hooke[@]}" --set contact.solver=~ --set step.dt=5e-5 --set step.force=true --set step.count=16000
    --set observables.every.steps=16000 --set output.dump.every.steps=16000)

# at DIR N: number N of the last row of the dump: x y z, and the spin
at() { tail -n 1 "$1/dump.lammpstrj" | awk -v n="$2" '{ print $(NF - 6 + n) }'; }

rolls() { # DIR BOUND FLAG...: from 1 to rest with 5/7 mu_r g: 0.35
    run_scene 1 ball.yaml "$1" "${@:3}" && within "$(at "$1" 1)" 2.35 "$2" && within "$(at "$1" 5)" 0 0.05
}
for rolling in spring constant; do
    check "it rolls to rest: rigid, $rolling" rolls rigid-$rolling 1e-6 --set contact.rolling=$rolling
    check 'rigid rows' rolls rows-$rolling 1e-6 --set contact.rolling=$rolling --set contact.solver.kappa=.inf
    check "hooke, $rolling" rolls hooke-$rolling 1e-3 --set contact.rolling=$rolling "${hooke[@]}"
    check 'the same without the solver' rolls explicit-$rolling 2e-3 --set contact.rolling=$rolling "${explicit[@]}"
done
check 'a spring of its own' rolls own 2e-3 --set material_pairs[0].rolling_stiffness=1e3
check 'hertz' rolls hertz 5e-3 --set contact.law=hertz --set materials[0].young=1e6 --set materials[0].poisson=0.3

slope() { # DIR TANGENT GOES BOUND FLAG...: from rest; after 0.8 it has gone 5/7 g (sin - mu_r cos) t^2 / 2, with 10 as g cos
    run_scene 1 ball.yaml "$1" --set gravity="[$(awk -v t="$2" 'BEGIN { print 10 * t }'), 0, -10]" --set particles.sources[0].velocity='[0, 0, 0]' \
        --set particles.sources[0].omega='[0, 0, 0]' "${@:5}" && within "$(at "$1" 1)" "$3" "$4"
}
above=$(awk 'BEGIN { print 2 + 5 / 7 * 10 * 0.1 * 0.32 }')
check 'it stays below mu_r' slope stays 0.19 2 1e-5
check 'it rolls above' slope steep 0.3 "$above" 2e-3
check 'hooke stays' slope stays-hooke 0.09 2 1e-3 "${hooke[@]}" # a spring that is loaded at once swings to twice its load
check 'hooke rolls above' slope steep-hooke 0.3 "$above" 2.5e-2 "${hooke[@]}"

spins() { # DIR FLAG...: 5 less mu_t N / I t, with N = 10 m and I = m / 10
    run_scene 1 spin.yaml "$1" "${@:2}" && within "$(at "$1" 6)" 4.2 1e-2
}
check 'spin dies linearly' spins spin
check 'hooke' spins spin-hooke "${hooke[@]}"
check 'without the solver' spins spin-explicit "${explicit[@]}"
check 'and rests' run_scene 1 spin.yaml spin-rest --set particles.sources[0].omega='[0, 0, 0.5]'
check 'it stands' within "$(at spin-rest 6)" 0 0.2

# A bed, with a boulder and a wall that moves
cat >bed.yaml <<'EOS'
units: none
seed: 3
box: {lower: [0, 0, 0], upper: [6, 6, 8], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {dt: 0.01, count: 2400}
contact: {law: rigid, rolling: spring, twisting: sds, solver: {sweeps: 40, tolerance: 0}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.2, friction: 0.5, rolling_friction: 0.2, twisting_stiffness: 500, twisting_friction: 0.05}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles:
  sources:
    - {from: random, count: 25, region: {shape: box, lower: [0, 0, 0], upper: [6, 6, 3]}, sizes: {law: uniform, min: 0.3, max: 0.6}}
    - {from: single, position: [3, 3, 4.5], radius: 1}
observables: {every: 100, list: [{name: energy_balance}, {name: energy_rotational}, {name: overlap_max}, {name: wall_force}, {name: contact_residual}]}
output: {checkpoint: {every: 1200, keep: 9}, dump: {every: {steps: 2400}, fields: [position, velocity, angular_velocity]}}
EOS
rows() { awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
    reading { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' "$1/dump.lammpstrj" | sort -n; }
same() { [ -s "$1/dump.lammpstrj" ] && cmp <(rows "$1") <(rows "$2"); }
rests() { # DIR: energy is only lost where it should be, and nothing turns
    local file=$1/observables.csv
    within "$(last_of "$file" energy_rotational)" 0 1e-6 && within "$(last_of "$file" overlap_max)" 0 2e-2 &&
        energy_kept "$file"
}
bed_everywhere
check 'Poisson, rigid rows of rolling' run_scene 1 bed.yaml poisson --set contact.rolling=constant --set contact.solver.restitution=poisson --set contact.solver.tolerance=1e-5
check 'it rests' rests poisson
check 'projection' run_scene 1 bed.yaml projection --set contact.solver.model=projection
check 'it rests' rests projection
check 'bodies' run_scene 2 bed.yaml bodies --set threads=1 --set bodies.clumps='[{spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 0.8}]}]'
check 'they rest' rests bodies

# What has no form
refuses() { # WORDS FLAG...
    local words=$1
    shift
    on 1 "$scree" run bed.yaml -o refused --quiet "$@" >said 2>&1
    [ $? = 2 ] && holds said "$words"
}
check 'refused: type C' refuses 'contact.rolling: epsd goes with contact.law hooke' --set contact.rolling=epsd
hook=(--set contact.law=hooke --set material_pairs[0].k_n=1e4)
check 'type C of springs' refuses 'contact.rolling: has no form in contact.solver; allowed with it: none, spring, constant' "${hook[@]}" --set contact.rolling=epsd
check 'a limit by the contact radius' refuses 'contact.twisting: has no form in contact.solver; allowed with it: none, sds' "${hook[@]}" --set contact.twisting=marshall \
    --set material_pairs='[{restitution: 0.2, friction: 0.5, rolling_friction: 0.2, k_n: 1e4}]'
check 'a damper of rolling' refuses 'rolling_damping has no form in contact.solver' --set material_pairs[0].rolling_damping=1 --set material_pairs[0].rolling_stiffness=10
check 'a damper of twisting' refuses 'twisting_damping has no form in contact.solver' --set material_pairs[0].twisting_damping=1
check 'problems in files' refuses 'output.contact_problems.every: its format has no moments' --set output.contact_problems.every=100
untwisted=(--set contact.twisting=none --set step.count=20 --set output.checkpoint.every=10 --set material_pairs[0].twisting_stiffness=~
    --set material_pairs[0].twisting_friction=~)
check 'a run without twisting' run_scene 1 bed.yaml untwisted "${untwisted[@]}"
check 'another memory' refuses 'contact.rolling and contact.twisting must stay' --resume untwisted/checkpoint-10.h5 "${untwisted[@]}" --set contact.rolling=none \
    --set material_pairs[0].rolling_friction=~
check 'another law' refuses 'contact.law must stay' --resume one/checkpoint-1200.h5 "${untwisted[@]}"
if "$scree" --version | grep -q -i petsc || "$scree" help contact.solver.name | grep -q newton; then
    check "Newton's method" refuses 'newton knows neither rolling nor twisting' --set contact.solver='{name: newton}'
fi
finish
