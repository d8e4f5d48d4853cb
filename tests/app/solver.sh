#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Hard contacts in whole runs: a bed with a boulder comes to rest on any layout; threads and indexes give the same bits; a resume goes
# on from the forces of the checkpoint; a grain on a belt ends with 2/7 of its speed. solver_features.sh tries each feature.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >bed.yaml <<'EOS'
box: {lower: [0, 0, 0], upper: [8 mm, 8 mm, 40 mm], periodic: [true, true, false]}
gravity: [0, 0, -9.81]
step: {dt: 1e-4, count: 1600}
contact: {law: rigid, solver: {sweeps: 30, tolerance: 0}}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.3, friction: 0.4}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: random, region: {shape: box, lower: [0, 0, 1 mm], upper: [8 mm, 8 mm, 16 mm]}, count: 60, sizes: {radius: 1 mm}}
    - {from: single, position: [4 mm, 4 mm, 20 mm], radius: 3 mm}
output: {dump: {every: {steps: 800}, fields: [position, velocity, angular_velocity]}}
observables: {every: {steps: 100}, list: [{name: wall_force}, {name: energy_kinetic}, {name: overlap_max}, {name: contacts}, {name: contact_sweeps}, {name: contact_residual}, {name: coordination}, {name: stress}, {name: momentum}]}
EOS
weight=$(awk 'BEGIN { print -(60 * 1e-9 + 27e-9) * 4 / 3 * atan2(0, -1) * 2500 * 9.81 }')

# rows DIR: the particles of the last frame, by id
rows() { awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
    reading { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' "$1/dump.lammpstrj" | sort -n; }
same() { [ -s "$1/dump.lammpstrj" ] && cmp <(rows "$1") <(rows "$2"); }

rests() { # DIR: at rest, all of the weight on the floor, no overlap beyond a thousandth
    local file=$1/observables.csv
    within "$(last_of "$file" floor_fz)" "$weight" "$(awk -v w="$weight" 'BEGIN { print -0.02 * w }')" &&
        within "$(last_of "$file" energy_kinetic)" 0 1e-8 &&
        within "$(last_of "$file" overlap_max)" 0 1e-3
}

check 'one rank, one thread' run_scene 1 bed.yaml one --set threads=1
check 'it rests' rests one
check 'two threads' run_scene 1 bed.yaml threads --set threads=2
check 'the same bits' same one threads
for index in linkcell brute; do
    check "index $index" run_scene 1 bed.yaml "$index" --set threads=1 --set index=$index
    check 'the same bits' same one "$index"
done
for ranks in 2 3; do
    check "$ranks ranks" run_scene $ranks bed.yaml ranks$ranks --set threads=1 --set step.count=2400 # each comes to rest at a time of its own
    check 'it rests' rests ranks$ranks
done
check '2 ranks, newton off, 2 threads' run_scene 2 bed.yaml off --set threads=2 --set newton=false
check 'it rests' rests off
check 'rigid rows' run_scene 1 bed.yaml stiff --set threads=1 --set contact.solver.kappa=.inf --set contact.solver.sweeps=100
check 'it rests' rests stiff
check 'Hertz at 70 GPa' run_scene 1 bed.yaml hertz --set threads=1 --set contact='{law: hertz, solver: {sweeps: 30}}' --set materials[0].young=70e9 \
    --set materials[0].poisson=0.2
check 'it rests' rests hertz
check 'a linear spring' run_scene 1 bed.yaml hooke --set threads=1 --set contact='{law: hooke, solver: {sweeps: 30}}' --set material_pairs[0].k_n=1e5 \
    --set output.checkpoint.every=1600
check 'it rests' rests hooke
# A bed that settles needs as many sweeps on four ranks, each of which meets two others at faces and one at an edge, as on one
mean() { # RANKS X Y: sweeps a step to the tolerance
    run_scene "$1" bed.yaml mean --overwrite --set threads=1 --set domain="{x: $2, y: $3, z: 1}" --set step.count=500 --set contact.solver='{tolerance: 1e-5, sweeps: 1000}' \
        --set 'observables={every: {steps: 1}, list: [{name: contact_sweeps}]}' --set 'output=~' --set 'particles.sources[1]=~' \
        --set particles.sources[0].count=100 --set 'particles.sources[0].region.upper=[8 mm, 8 mm, 26 mm]' || return 1
    tail -n 200 mean/observables.csv | awk -F, '{ s += $2 } END { print s / NR }'
}
flat() {
    local one=$(mean 1 1 1) two=$(mean 2 2 1) four=$(mean 4 2 2)
    echo "  sweeps on 1, 2 and 4 ranks: $one, $two, $four"
    within "$two" "$one" "$(awk -v n="$one" 'BEGIN { print 0.15 * n }')" && within "$four" "$one" "$(awk -v n="$one" 'BEGIN { print 0.15 * n }')"
}
check 'the count of sweeps does not grow with the ranks' flat
weights() { # the contact list has the forces that the floor feels
    local file=one/observables.csv
    within "$(last_of "$file" coordination)" "$(awk -v n="$(last_of "$file" contacts)" 'BEGIN { print 2 * n / 61 }')" 0.5
}
check 'contacts are listed' weights

# Models of contacts, of which spheres know one, and Poisson's restitution
for model in decoupled de_saxce dissipation; do
    check "model $model" run_scene 1 bed.yaml "$model" --set threads=1 --set contact.solver.model=$model
    check 'the same bits' same one "$model"
done
for key in model=projection model=frictionless restitution=poisson; do
    check "$key" run_scene 1 bed.yaml "$key" --set threads=1 --set contact.solver.$key
    check 'all of the weight on the floor' within "$(last_of "$key/observables.csv" floor_fz)" "$weight" "$(awk -v w="$weight" 'BEGIN { print -0.1 * w }')"
done

# Bodies: threads and indexes give the same bits, other ranks the same rest, a resume goes on
clumps=(--set bodies.clumps='[{size: drawn, spheres: [{centre: [0, 0, 0], radius: 0.5 mm}, {centre: [0.5 mm, 0, 0], radius: 0.5 mm}, {centre: [0, 0.5 mm, 0], radius: 0.4 mm}], mass: 1e-5 kg}]'
    --set contact.solver.sweeps=60 --set particles.sources[1].radius='1 mm' --set output.checkpoint.every=800)
bodies_rest() { # DIR
    local file=$1/observables.csv
    within "$(last_of "$file" floor_fz)" -5.98e-3 1.2e-4 && within "$(last_of "$file" overlap_max)" 0 1e-2
}
check 'bodies' run_scene 1 bed.yaml bodies --set threads=1 "${clumps[@]}"
check 'they rest' bodies_rest bodies
check 'two threads' run_scene 1 bed.yaml bodies2 --set threads=2 "${clumps[@]}"
check 'the same bits' same bodies bodies2
check 'index brute' run_scene 1 bed.yaml bodies1 --set threads=1 --set index=brute "${clumps[@]}"
check 'the same bits' same bodies bodies1
check '3 ranks' run_scene 3 bed.yaml bodies3 --set threads=1 "${clumps[@]}"
check 'they rest' bodies_rest bodies3
check 'a run that goes on' run_scene 1 bed.yaml bodies4 --set threads=1 "${clumps[@]}" --resume bodies/checkpoint-800.h5
check 'the same bits' same bodies bodies4

lands() { # a boulder that lands on two layers of grains overlaps them as `check` says, and at the step that `check` names by about a tenth
    local scene=("${bed_of_two[@]}") step said most
    "$scree" check bed.yaml "${scene[@]}" --set step.dt=1e-4 >told 2>&1
    step=$(sed -n 's/.*lands on a bed.*needed is a step of \([0-9.e+-]*\)$/\1/p' told | head -n 1)
    [ -n "$step" ] || { cat told; return 1; }
    "$scree" check bed.yaml "${scene[@]}" --set step.dt="$step" >told 2>&1
    said=$(sed -n 's/^  impact .*about \([0-9.e+-]*\) of the smallest radius$/\1/p' told)
    run_scene 1 bed.yaml lands "${scene[@]}" --set threads=1 --set step.dt="$step" --set 'observables=~' --set 'output=~' || return 1
    most=$(sed -n 's/.*"overlap_max": \([0-9.e+-]*\),.*/\1/p' lands/report.json)
    echo "  step $step: about $said of a radius foreseen, $most found"
    awk -v s="$said" -v m="$most" 'BEGIN { exit !(s <= 0.101 && m > 0.02 && m <= 0.15) }'
}
bed_of_two=(--set 'box.upper=[24 mm, 24 mm, 60 mm]' --set 'particles.sources[0].region.upper=[24 mm, 24 mm, 8 mm]' --set 'particles.sources[0].count=288'
    --set 'particles.sources[1]={from: single, position: [12 mm, 12 mm, 34 mm], radius: 10 mm}' --set 'step.count=~' --set duration=0.1 --set 'contact.solver.tolerance=1e-4')
check 'a boulder lands at the step that check names' lands

# What insertions will bring counts from the start, at each of its sizes: of grains from 0.5 to 3.75 mm the price of kappa is 5 times that of the bed
# (ratio of radii 7.5 instead of 3, and half of the smallest radius); news travels by the smallest member of a body, a tenth of a grain of the bed
foreseen() { # WORD FLAG...: what `check` foresees
    "$scree" check bed.yaml --set step.dt=1e-5 "${@:2}" >told 2>&1
    sed -n "s/^  $1  .*: \(about \)*\([0-9.e+-]*\) \(in the\|of the\) smallest.*/\2/p" told
}
comes() { # WORD RATIO FLAG...
    local before after
    before=$(foreseen "$1")
    after=$(foreseen "$1" "${@:3}" --set 'materials=[{name: glass, density: 2500}, {name: b, density: 2500}]' --set particles.sources[0].material=glass \
        --set particles.sources[1].material=glass --set walls[0].material=glass)
    within "$(awk -v a="$after" -v b="$before" 'BEGIN { print a / b }')" "$2" "$(awk -v r="$2" 'BEGIN { print 0.06 * r }')" || { cat told; return 1; }
}
check 'heavy grains that will come' comes impact 5 --set 'insertions=[{region: {shape: box, lower: [0, 0, 22 mm], upper: [8 mm, 8 mm, 40 mm]}, sizes: {law: uniform, min: 0.5 mm, max: 3.75 mm}, rate: 10, material: b}]'
check 'small members of bodies that will come' comes news 0.1 --set 'insertions=[{region: {shape: box, lower: [0, 0, 22 mm], upper: [8 mm, 8 mm, 40 mm]}, sizes: {law: uniform, min: 0.5 mm, max: 1 mm}, rate: 10, material: b}]' \
    --set 'bodies.clumps=[{material: b, radius_above: 0.8 mm, size: drawn, spheres: [{centre: [0, 0, 0], radius: 0.5 mm}, {centre: [0.5 mm, 0, 0], radius: 0.1 mm}], mass: 1e-6 kg}]'

check 'a run with a checkpoint' run_scene 1 bed.yaml whole --set threads=1 --set output.checkpoint.every=800
check 'a run that goes on from it' run_scene 1 bed.yaml rest --set threads=1 --resume whole/checkpoint-800.h5
check 'the same bits' same whole rest
check 'and another wall before the floor' run_scene 1 bed.yaml lid --set threads=1 --resume whole/checkpoint-800.h5 \
    --set 'walls=[{shape: plane, name: lid, point: [0, 0, 39 mm], normal: [0, 0, -1]}, {shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]'
check 'the same bits' same whole lid
check 'with other keys of the solver' run_scene 1 bed.yaml keys --set threads=1 --resume whole/checkpoint-800.h5 \
    --set contact.solver='{sweeps: 90, tolerance: 1e-5, repair: 0.01}'
check 'it rests' rests keys
check 'with another kappa' run_scene 1 bed.yaml springs --set threads=1 --resume whole/checkpoint-800.h5 --set contact.solver.kappa=100
unsolved() {
    on 1 "$scree" run bed.yaml -o unsolved --quiet --resume hooke/checkpoint-1600.h5 --set contact.law=hooke --set contact.solver=~ \
        --set material_pairs[0].k_n=1e5 --set step.dt=1e-6 >said 2>&1
    [ $? = 2 ] && holds said 'contact.law, contact.solver, friction and rolling must stay'
}
check 'but not without the solver, whose springs differ' unsolved
check 'on two ranks' run_scene 2 bed.yaml rest2 --set threads=1 --resume whole/checkpoint-800.h5
check 'it rests' rests rest2

# A grain set on a belt of the speed V = 2 slides, then rolls with 2/7 V: the belt has done the work 2/7 m V^2, half of which is lost
cat >belt.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 2, 2]}
gravity: [0, 0, -10]
step: {count: 400, dt: 1e-3}
contact: {law: rigid, solver: {sweeps: 30}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.5}]
walls: [{name: belt, shape: plane, point: [0, 0, 0.5], normal: [0, 0, 1], motion: [{kind: translate, surface: true, velocity: [2, 0, 0]}]}]
particles: {from: single, position: [1, 1, 0.7], radius: 0.2}
observables: {every: 200, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: work_walls}, {name: energy_dissipated}, {name: momentum}]}
EOS
belt() { # MASS RANKS SETTING...: ends as the closed form says
    local file=rolls/observables.csv m=$1
    rm -rf rolls && run_scene "$2" belt.yaml rolls --set threads=1 "${@:3}" &&
        within "$(last_of "$file" momentum_x)" "$(awk -v m="$m" 'BEGIN { print m * 4 / 7 }')" 1e-4 &&
        within "$(last_of "$file" energy_rotational)" "$(awk -v m="$m" 'BEGIN { print m * 20 / 49 }')" 1e-4 &&
        within "$(last_of "$file" work_walls)" "$(awk -v m="$m" 'BEGIN { print m * 8 / 7 }')" 3e-4 &&
        within "$(last_of "$file" energy_dissipated)" "$(awk -v m="$m" 'BEGIN { print m * 4 / 7 }')" 3e-4
}
sphere=0.0335103216 disc=0.1256637061
check 'a grain on a belt: 2/7 of its speed, its work, half of it lost' belt $sphere 1
check 'the same on 2 ranks' belt $sphere 2
check 'a belt of triangles' belt $sphere 1 --set 'walls[belt]={name: belt, shape: rectangle, point: [0.5, 0.5, 0.5], along: [7, 0, 0], across: [0, 1, 0], motion: [{kind: translate, surface: true, velocity: [2, 0, 0]}]}'
check 'discs by their area' belt $disc 1 --set 'box={dimension: 2, density: area, lower: [0, 0], upper: [8, 2]}' --set 'gravity=[0, -10]' --set 'particles.position=[1, 0.7]' \
    --set 'walls=[{name: belt, shape: plane, point: [0, 0.5], normal: [0, 1], motion: [{kind: translate, surface: true, velocity: [2, 0]}]}]'
many=$(for k in $(seq 60); do printf '{name: m%d, density: 1}, ' "$k"; done)
check 'sixty materials' belt $sphere 1 --set "materials=[$many{name: a, density: 1}]" --set 'particles.material=a' --set 'walls[belt].material=a' \
    --set 'material_pairs=[{restitution: 0.3, friction: 0.1}, {between: [a, a], restitution: 0.3, friction: 0.5}]'

# While it slides, the stress is symmetric as that of the explicit law, xz half of F R / V, and its tangential spring holds F^2 / (2 k_t)
slides() { # SETTING...
    rm -rf slides && run_scene 1 belt.yaml slides --set threads=1 --set step.count=100 \
        --set 'observables={every: 100, list: [{name: stress}, {name: energy}]}' "$@" &&
        within "$(last_of slides/observables.csv stress_xz)" 5.2359877e-4 5e-7
}
check 'the stress of a grain that slides' slides
check 'the energy of its tangential spring' within "$(last_of slides/observables.csv energy_elastic_tangential)" 3.71361e-8 1e-12
check 'the stress by the explicit law' slides --set contact='{law: hooke}' --set material_pairs[0].k_n=2000 --set step.dt=5e-4 --set step.count=200

# A grain that moves as given hits a free one: e = 0.5 takes 3/8 m v^2 of what the given motion does. What rests on a frozen grain
# weighs on it, wherever the frozen one lives
cat >given.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 4, 4]}
gravity: [0, 0, -10]
step: {dt: 1e-3, count: 1000}
contact: {law: rigid, tangential: none, solver: {sweeps: 30}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5}]
groups: [{name: goes, motion: moving, velocity: [1, 0, 0]}, {name: still, motion: frozen}]
walls: [{shape: plane, name: floor, point: [0, 0, 0.5], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: single, position: [1, 2, 1], radius: 0.5, group: goes}
    - {from: single, position: [2.1, 2, 1], radius: 0.5}
    - {from: single, position: [7, 2, 1], radius: 0.5, group: still}
    - {from: single, position: [7, 2, 2], radius: 0.5}
output: {dump: {every: {steps: 1000}, fields: [position, force]}}
observables: {every: 1000, list: [{name: energy_dissipated}]}
EOS
given() { # RANKS SETTING...
    rm -rf given && run_scene "$1" given.yaml given --set threads=1 "${@:2}" &&
        within "$(last_of given/observables.csv energy_dissipated)" 0.1963495408 1e-4 &&
        within "$(rows given | awk '$1 == 3 { print $NF }')" -5.235987756 1e-5
}
check 'given motions do work, and frozen grains feel forces' given 1
check 'the same on 2 ranks' given 2
check 'the same on 3 ranks, newton off' given 3 --set newton=false

# A wall that moves by a tenth of a radius a step is found before it cuts into a grain at rest without gravity
cat >piston.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [20, 4, 4]}
step: {dt: 1e-2, count: 150}
contact: {law: rigid, tangential: none, solver: {sweeps: 30}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0}]
walls: [{shape: plane, name: piston, point: [2, 0, 0], normal: [1, 0, 0], motion: [{kind: translate, velocity: [5, 0, 0]}]}]
particles: {from: single, position: [7, 2, 2], radius: 0.5}
observables: {every: 1, list: [{name: overlap_max}, {name: momentum}]}
EOS
piston() { # RANKS SETTING...: the overlap is that of the spring, a 1/kappa of the way of a step
    rm -rf piston && run_scene "$1" piston.yaml piston --set threads=1 "${@:2}" &&
        within "$(awk -F, 'NR > 1 && $2 > most { most = $2 } END { print most }' piston/observables.csv)" 0.0025 1e-4
}
check 'a fast wall' piston 1
check 'a fast wall on 2 ranks' piston 2
check 'a fast wall of triangles' piston 1 --set 'walls[piston]={name: piston, shape: rectangle, point: [2, 0, 0], along: [0, 4, 0], across: [0, 0, 4], motion: [{kind: translate, velocity: [5, 0, 0]}]}'
check 'a fast cylinder' piston 1 --set 'walls[piston]={name: piston, shape: cylinder, point: [1, 2, 2], axis: [0, 0, 1], radius: 1, inside: false, motion: [{kind: translate, velocity: [5, 0, 0]}]}'

# A grain rests on a floor by the implicit form of a law with a damper: its spring holds what the overlap says
cat >spring.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
gravity: [0, 0, -10]
step: {dt: 1e-3, count: 3000}
contact: {law: hooke, solver: {sweeps: 30}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.3, k_n: 1e4, k_t: 1e4}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: single, position: [2, 2, 0.5], radius: 0.5}
observables: {every: 1000, list: [{name: energy_elastic_normal}]}
EOS
spring() { # ENERGY SETTING...
    rm -rf spring && run_scene 1 spring.yaml spring --set threads=1 "${@:2}" &&
        within "$(last_of spring/observables.csv energy_elastic_normal)" "$1" 1e-9
}
check 'energy of a linear spring, F^2 / (2 k)' spring 1.37077839e-3
check "energy of Hertz's spring, 2/5 F overlap" spring "$(awk 'BEGIN { f = 10 * atan2(0, -1) / 6; printf "%.12g", 0.4 * f * (f / (4 / 3 * 1e5 / 0.91 * sqrt(0.5) / 2)) ^ (2 / 3) }')" \
    --set contact.law=hertz --set 'materials=[{name: a, density: 1, young: 1e5, poisson: 0.3}]' --set 'material_pairs=[{restitution: 0.3, friction: 0.3}]'

refuses() { # WORDS FLAG...: exit status 2, one message that begins with the place and has the words
    "$scree" check bed.yaml "${@:2}" >said 2>&1
    [ $? = 2 ] || { cat said; return 1; }
    holds said "$1"
}
check 'a rigid law without a solver' refuses 'contact.law: rigid needs contact.solver' --set contact='{law: rigid}'
check 'a law without a form' refuses 'bed.yaml:4: contact.solver: goes with contact.law hooke, hertz, rigid, not with eepa' --set contact.law=eepa \
    --set materials[0].young=1e7 --set materials[0].poisson=0.2 --set material_pairs[0].plasticity_ratio=0.5
check 'the end of a damper' refuses 'contact.end: has no form in contact.solver; allowed with it: force' --set contact.end=overlap
check 'the slip of a damper' refuses 'contact.sliding: has no form in contact.solver; allowed with it: series' --set contact.sliding=total
check 'a tangential damper' refuses 'contact.tangential_damping_ratio: has no form in contact.solver; allowed with it: 1' --set contact.tangential_damping_ratio=0.5
check 'a step that is too long' refuses 'step.dt: the time step 0.01 is above' --set step.dt=0.01
check 'an unknown method' refuses 'gauss_seidel' --set contact.solver.name=jacobi
guarded() {
    on 1 "$scree" run bed.yaml -o guarded --quiet --set threads=1 --set guards.residual=stop --set contact.solver='{sweeps: 1, tolerance: 1e-9}' >said 2>&1
    [ $? = 3 ] && holds said 'guards.residual: the residual of the contacts'
}
check 'a residual that is not met ends the run if the scene says so' guarded
warned() { # SETTING: how often a run with too few sweeps warns
    on 1 "$scree" run bed.yaml -o guarded --overwrite --quiet --set threads=1 --set step.count=400 --set "$1" --set contact.solver='{sweeps: 1, tolerance: 1e-9}' 2>said
    [ "$(grep -c 'warning: guards.residual: the residual of the contacts' said)" = "$2" ]
}
check 'else there is one warning' warned guards.residual=warn 1
check 'or none' warned guards.residual=off 0
proposes() { "$scree" check bed.yaml --set step.dt=~ >said 2>&1; holds said 'solver of contacts'; }
check 'check proposes a step' proposes
told() { "$scree" check bed.yaml >said 2>&1 && ! grep -E 'end of a contact|overlap by 0 ' said && [ "$(grep -c 'expected speed' said)" = 1 ]; }
check 'check has one expected speed, and nothing of a law that has no springs' told
calm() { # SETTING...: a step that is allowed is neither warned of nor changed
    on 1 "$scree" run bed.yaml -o calm --overwrite --quiet --set threads=1 --set step.count=501 "$@" 2>said
    ! grep -E 'guards.step|stiffer' said
}
check 'a run does not look at the longest step again' calm --set step.dt=5.6e-4
check 'nor at a fraction of it' calm --set step.dt=~ --set step.fraction=1
ablates() { "$scree" ablate bed.yaml -o ablated --error --only stiffness >said 2>&1; [ $? = 2 ] && holds said '--only stiffness: allowed in this scene: step, law, solver, skin, index, order, explicit'; }
check 'ablate softens rigid grains in explicit runs alone, and changes no integrator that only springs feel' ablates
soft() { "$scree" check bed.yaml --set contact.solver.kappa=1e-3 >said 2>&1; holds said 'NOTE: contact.solver.kappa: news travels' && holds said 'NOTE: contact.solver.kappa: the heaviest grain'; }
check 'check says that a medium is too soft' soft
cat >impact.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4], periodic: [true, true, false]}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
contact: {law: rigid, solver: {}}
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: single, position: [2, 2, 0.5351], radius: 0.5, velocity: [0, 0, -1]}
step: {dt: 0.01, count: 10}
observables: {every: 1, list: [{name: velocity, id: 1}, {name: position, id: 1}]}
YAML
# rows show the central difference of positions: -1 before, -0.25 in the step of the impact, 0.5 after
differences() {
    run_scene 1 impact.yaml impact || return 1
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        { z[NR] = $at["particle1_z[1]"]; v[NR] = $at["particle1_vz[1]"] }
        END { for (k = 3; k < NR; k++) { d = v[k] - (z[k + 1] - z[k - 1]) / 0.02; if (d * d > 1e-20) bad = 1; middle += (v[k] + 0.25) ^ 2 < 1e-20 }
            exit bad || middle != 1 || NR != 12 }' impact/observables.csv
}
check 'velocities in rows are those at the positions, in an impact, too' differences
# a bed at rest stays at rest with other springs: the floor carries the weight in each step
calm() { # DIR: from the start on
    "$scree" info "$1/observables.csv" --column floor_fz | awk -v w="$weight" '$1 ~ /^[-0-9]/ { n++; if ($1 / w < 0.85 || $1 / w > 1.15) bad = 1 } END { exit bad || n < 100 }'
}
check 'a bed at rest' run_scene 1 bed.yaml settled --set contact.solver.tolerance=1e-4 --set contact.solver.sweeps=100
for change in contact.solver.kappa=400 contact.solver.kappa=8 contact.solver.kappa=.inf 'step={dt: 5e-5, count: 1800}'; do
    check "resumed with $change" run_scene 1 bed.yaml "changed-$change" --resume settled/checkpoint-1600.h5 --set contact.solver.tolerance=1e-4 --set contact.solver.sweeps=400 \
        --set step.count=1800 --set observables.every=1 --set "$change"
    check 'keeps the weight on the floor in each step' calm "changed-$change"
done

# the report has what the contacts have seen; a medium softer than its flow says so, before and after
check 'the report has the largest overlap' awk '/"overlap_max"/ { found = 1 } END { exit !found }' settled/report.json
soft_told() {
    on 1 "$scree" run bed.yaml -o soft --set contact.solver.kappa=1e-3 --set step.count=400 --set guards.overlap=off >said 2>&1 && grep -q 'kappa: news travels at' said &&
        grep -q 'kappa: grains were as fast as' said && grep -q 'contacts     overlap up to' said
}
check 'a medium softer than its flow is told, with the kappa that it wants' soft_told

finish
