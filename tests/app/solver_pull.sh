#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Cohesion under contact.solver: a sphere hangs as long as it weighs less than the pull-off force, below a wall and below a sphere; a sphere
# that does not roll holds on a slope beyond the angle of friction; slow impacts stick; a bed that sticks goes on from a checkpoint on any
# ranks and threads, and keeps the balance of energies; what has no form is refused.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
# The pull at a wall is 2 pi gamma, and the weight 5/3 pi: a gamma of 5/6 is as much
cat >ball.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 4, 4]}
gravity: [0, 0, -10]
step: {count: 400, dt: 1e-3}
contact: {law: rigid, cohesion: dmt, solver: {tolerance: 1e-8, sweeps: 200}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0.3, surface_energy: 0.8416667}]
walls: [{shape: plane, name: lid, point: [0, 0, 4], normal: [0, 0, -1], material: a}]
particles: {sources: [{from: single, position: [2, 2, 3.5], radius: 0.5}]}
observables: {every: {steps: 400}, list: [{name: energy_balance}, {name: contacts}, {name: wall_force}]}
output: {dump: {every: {steps: 400}, fields: [position, velocity]}}
EOS
hertz=(--set contact.law=hertz --set materials[0].young=1e5 --set materials[0].poisson=0.3)
explicit=("${hertz[@]}" --set particles.sources[0].position='[2, 2, 3.50001]' --set contact.solver=~ --set step.dt=5e-5 --set step.count=8000 --set observables.every.steps=8000 --set output.dump.every.steps=8000)
ways=(rigid 'rigid rows' hertz 'without the solver')
way() { # NAME: `flags`
    case $1 in
    rigid) flags=() ;;
    'rigid rows') flags=(--set contact.solver.kappa=.inf) ;;
    hertz) flags=("${hertz[@]}") ;;
    newton) flags=(--set contact.solver.name=newton) ;;
    *) flags=("${explicit[@]}") ;;
    esac
}
! "$scree" check ball.yaml --set contact.solver.name=newton >said 2>&1 || ways+=(newton)

# at DIR N [PARTICLES]: number N of the first particle in the last frame: x y z, and the velocity
at() { tail -n "${3:-1}" "$1/dump.lammpstrj" | sort -n | head -n 1 | awk -v n="$2" '{ print $(NF - 6 + n) }'; }

hangs() { # GAMMA FLAG...
    run_scene 1 ball.yaml hangs --overwrite "${flags[@]}" --set "material_pairs[0].surface_energy=$1" "${@:2}" && within "$(at hangs 3)" 3.5 1e-3
}
falls() { ! hangs "$@" >/dev/null && [ "$(at hangs 3 | cut -c1)" != 3 ]; }
sphere() { # GAMMA Z BOUND: below a sphere, where R* is half of that at a wall
    local z=2.99
    [ "$name" != 'without the solver' ] || z=2.99001 # springs pull once they touch
    run_scene 1 ball.yaml below --overwrite "${flags[@]}" --set 'walls=~' --set 'observables.list=[{name: contacts}]' --set "material_pairs[0].surface_energy=$1" \
        --set "particles.sources[0]={from: single, position: [2, 2, $z], radius: 0.5}" --set 'groups=[{name: held, motion: frozen}]' \
        --set 'particles.sources[1]={from: single, position: [2, 2, 3.99], radius: 0.5, group: held}' && within "$(at below 3 2)" "$2" "$3"
}
slope() { # TANGENT GOES BOUND: with a weight as the pull the limit is 0.3 x (1 + 2)
    local z=0.5
    [ "$name" != 'without the solver' ] || z=0.49999
    run_scene 1 ball.yaml slope --overwrite "${flags[@]}" --set 'walls[0]={name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}' \
        --set "gravity=[$(awk -v t="$1" 'BEGIN { print 10 * t }'), 0, -10]" --set material_pairs[0].surface_energy=0.8333333 \
        --set contact.rolling=spring --set material_pairs[0].rolling_friction=10 --set particles.sources[0].position="[2, 2, $z]" &&
        within "$(at slope 1)" "$2" "$3"
}
for name in "${ways[@]}"; do
    way "$name"
    check "$name: it hangs" hangs 0.8416667
    check 'it falls if it is 1 % heavier than the pull' falls 0.825
    check 'below a sphere' sphere 1.6833333 2.99 1e-3
    check 'it falls from a sphere' sphere 1.65 2.2 0.1
    [ "$name" != newton ] || continue # it knows no rolling
    case $name in rigid*) tangent=0.88 ;; *) tangent=0.42 ;; esac # a spring that is loaded at once swings to twice its load
    check 'it holds on a slope beyond the angle of friction' slope $tangent 2 2e-2
    check 'it slides on a steeper one' slope 1 2.08 5e-2          # 10 (1 - 0.9) 0.4^2 / 2
done

# An impact slower than 8 (F/m) dt sticks, a faster one rebounds
impact() { # SPEED: on the lid, without gravity
    run_scene 1 ball.yaml impact --overwrite --set gravity='[0, 0, 0]' --set particles.sources[0].velocity="[0, 0, $1]" --set particles.sources[0].position='[2, 2, 3.48]' \
        --set material_pairs[0].surface_energy=0.8333333 --set step.count=800
}
sticks() { impact 0.07 && within "$(last_of impact/observables.csv contacts)" 1 0; }
rebounds() { impact 0.1 && within "$(last_of impact/observables.csv contacts)" 0 0; }
check 'a slow impact sticks' sticks
check 'a faster one rebounds' rebounds

foreseen() { # 8 x 10 dt, of two of these spheres: half of the pull, half of the mass
    "$scree" check --all ball.yaml --set gravity='[0, 0, 0]' --set material_pairs[0].surface_energy=0.8333333 >said 2>&1
    holds said 'of two of the smallest grains: 2.618; impacts slower than 0.08 stick'
}
check 'check names the speed' foreseen

# Elastic spheres stick below about 0.5, as their damper takes what the pull needs; the step is first order
elastic() { # DIR SPEED FLAG...
    run_scene 1 ball.yaml "$1" --set gravity='[0, 0, 0]' --set material_pairs[0].surface_energy=0.8333333 "${@:3}" \
        --set particles.sources[0].position='[2, 2, 3.4]' --set particles.sources[0].velocity="[0, 0, $2]"
}
implicit=("${hertz[@]}" --set step.dt=1e-4 --set step.count=4000 --set observables.every.steps=4000 --set output.dump.every.steps=4000)
rebound() { # the same with and without the solver
    elastic fast 1 "${implicit[@]}" && elastic fast-explicit 1 "${explicit[@]}" && within "$(at fast 6)" "$(at fast-explicit 6)" 0.02 && within "$(at fast 6)" -0.38 0.05
}
stays() { elastic slow 0.4 "${implicit[@]}" && elastic slow-explicit 0.4 "${explicit[@]}" && within "$(at slow 3)" "$(at slow-explicit 3)" 1e-3 && within "$(at slow 3)" 3.502 1e-3; }
check 'elastic spheres rebound as without the solver' rebound
check 'slow ones stick as without it' stays

# A bed that sticks, with a boulder
cat >bed.yaml <<'EOS'
units: none
seed: 3
box: {lower: [0, 0, 0], upper: [6, 6, 8], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {dt: 0.01, count: 2400}
contact: {law: rigid, cohesion: dmt, rolling: spring, solver: {sweeps: 40, tolerance: 0}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.2, friction: 0.5, rolling_friction: 0.2, surface_energy: 0.05}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles:
  sources:
    - {from: random, count: 25, region: {shape: box, lower: [0, 0, 0], upper: [6, 6, 3]}, sizes: {law: uniform, min: 0.3, max: 0.6}}
    - {from: single, position: [3, 3, 4.5], radius: 1}
observables: {every: 100, list: [{name: energy_balance}, {name: energy_kinetic}, {name: overlap_max}, {name: wall_force}, {name: contact_residual}]}
output: {checkpoint: {every: 1200, keep: 9}, dump: {every: {steps: 2400}, fields: [position, velocity, angular_velocity]}}
EOS
rows() { awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
    reading { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' "$1/dump.lammpstrj" | sort -n; }
same() { [ -s "$1/dump.lammpstrj" ] && cmp <(rows "$1") <(rows "$2"); }
rests() { # DIR [ENERGY]: spheres; a body may spin about its contact for long, as nothing resists that
    local file=$1/observables.csv
    within "$(last_of "$file" energy_kinetic)" 0 "${2:-1e-6}" && within "$(last_of "$file" overlap_max)" 0 2e-2 &&
        energy_kept "$file"
}
bed_everywhere
check 'Poisson' run_scene 1 bed.yaml poisson --set contact.solver.restitution=poisson --set contact.solver.tolerance=1e-5
check 'it rests' rests poisson
check 'bodies' run_scene 2 bed.yaml bodies --set threads=1 --set bodies.clumps='[{spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 0.8}]}]'
check 'they rest' rests bodies 1e-3

refuses() { # WORDS FLAG...
    on 1 "$scree" run bed.yaml -o refused --quiet "${@:2}" >said 2>&1
    [ $? = 2 ] && holds said "$1"
}
check 'refused: JKR of rigid grains' refuses 'not with rigid; with rigid go: none, dmt' --set contact.cohesion=jkr
check 'bridges' refuses 'contact.cohesion: has no form in contact.solver; allowed with it: none, dmt' "${hertz[@]}" --set contact.cohesion=capillary \
    --set 'material_pairs=[{restitution: 0.2, friction: 0.5, rolling_friction: 0.2, surface_tension: 0.1, bridge_fraction: 0.01}]'
check 'problems in files' refuses 'output.contact_problems.every: its format has no pulls' --set output.contact_problems.every=100 --set contact.rolling=none \
    --set material_pairs[0].rolling_friction=~
finish
