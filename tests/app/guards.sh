#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Guards: each guard stops the run with names, place and time, and leaves a checkpoint; `scree check` foresees the guards that follow
# from the scene.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >scene.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
step: {dt: 0.001, count: 400}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 10000}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: single, id: 71, position: [3, 5, 5], radius: 1, velocity: [2, 0, 0]}
    - {from: single, id: 83, position: [5.5, 5, 5], radius: 1, velocity: [-2, 0, 0]}
EOS

stops() { # DIR WORDS FLAG...: exit status 3, one message with the words, a checkpoint to look at
    local dir=$1 words=$2 status word
    shift 2
    on "$ranks" "$scree" run scene.yaml -o "$dir" --quiet "$@" >said 2>&1
    status=$?
    [ $status = 3 ] || { echo "  status $status"; cat said; return 1; }
    for word in $words; do
        holds said "$word" || return 1
    done
    "$scree" info "$dir"/checkpoint-*-stopped.h5 | grep -q whole
}
says() { "$scree" check --all scene.yaml "${@:2}" >said 2>&1; grep -q "$1" said || { cat said; return 1; }; }

for ranks in 1 2; do
    echo "== $ranks ranks"
    check 'overlap: who, where, when' stops deep$ranks "guards.overlap: 71 83 (4. step t" --set step.force=true --set material_pairs[0].k_n=0.1
    check 'overlap with a wall names it' stops wall$ranks "guards.overlap: 71 wall 'floor'" --set step.force=true --set material_pairs[0].k_n=0.1 \
        --set 'particles.sources[0].velocity=[0, 0, -20]'
    check 'speed' stops fast$ranks 'guards.speed: 71 moves unseen' --set 'particles.sources[0].velocity=[0, 2000, 0]'
    check 'energy: a step far above the stable one' stops hot$ranks 'guards.energy: without cause fastest' --set guards.energy=stop --set step.force=true \
        --set step.dt=0.04 --set guards.overlap=off --set material_pairs[0].restitution=1
done
ranks=1
check 'energy stays where nothing is wrong' run_scene 1 scene.yaml cold --set guards.energy=stop --set material_pairs[0].restitution=1 --set step.count=2000
warns() { # GUARD FLAG...: one warning, and the run goes on to its end
    run_scene 1 scene.yaml "warned-$1" --set "guards.$1=warn" "${@:2}" || return 1
    [ "$(grep -c "scree: warning: guards.$1: " "$out/said")" = 1 ] && [ "$(grep -c . "$out/said")" = 1 ] || { cat "$out/said"; return 1; }
    [ "$(number "warned-$1/report.json" last_step)" = 400 ]
}
check 'speed may warn, once' warns speed --set 'particles.sources[0].velocity=[0, 2000, 0]'
check 'energy may warn, once' warns energy --set step.force=true --set step.dt=0.04 --set guards.overlap=off \
    --set guards.speed=off --set material_pairs[0].restitution=1
# A spring that takes all of the slip is longer than friction loads it: energy of that law, no fault of the step
cat >slide.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [400, 10, 40]}
gravity: [0, 0, -10]
step: {dt: 5e-4, count: 2000}
integrator: velocity_verlet
contact: {law: hooke, damping: coefficient, end: overlap, lammps_history: true}
materials: [{name: stone, density: 1}]
material_pairs: [{k_n: 10000, k_t: 10000, gamma_n: 10, gamma_t: 100, friction: 0.1}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: single, position: [3, 5, 1.01], radius: 1, velocity: [20, 0, 0]}
observables: {every: 100, list: [{name: energy}]}
EOS
own=(--set 'contact={law: hooke, sliding: total, end: overlap}' --set integrator=synchronised_verlet --set)
slides() { # DIR FLAG...: to the end, though the spring holds more than half of the energy in play
    run_scene 1 slide.yaml "$@" || return 1
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { kinetic = $at["energy_kinetic"]; spring = $at["energy_elastic_tangential"]; if (kinetic > most) most = kinetic; if (spring > wound) wound = spring }
        END { print "  the spring holds up to " wound ", kinetic energy is up to " most; exit !(wound > 0.5 * most) }' "$1/observables.csv"
}
explodes() { # DIR FLAG...: the same law, a step far above the stable one
    on 1 "$scree" run slide.yaml -o "$@" --quiet --set step.force=true --set step.dt=0.04 --set guards.overlap=off --set guards.speed=off >said 2>&1
    [ $? = 3 ] && holds said 'guards.energy: energy has grown'
}
check "a spring that LAMMPS's law winds up is no growth" slides lammps
check 'nor is one of sliding: total' slides total "${own[@]}" 'material_pairs=[{restitution: 0.05, k_n: 10000, k_t: 10000, friction: 0.1}]'
check "under LAMMPS's law true growth stops a run" explodes lammps-hot --set material_pairs[0].gamma_n=0 --set material_pairs[0].gamma_t=10
check 'under sliding: total, too' explodes total-hot "${own[@]}" 'material_pairs=[{restitution: 1, k_n: 10000, k_t: 10000, friction: 0.1}]'
came() { # particles that come bring energy
    run_scene 1 scene.yaml came --set guards.energy=stop --set gravity='[0, 0, -10]' --set step.count=2000 \
        --set 'insertions=[{region: {shape: box, lower: [0, 0, 8], upper: [10, 10, 10]}, sizes: 0.3, rate: 20, count: 25, velocity: [0, 0, -1]}]'
}
check 'particles that come are no growth' came
check 'particles moved by order are refused' bash -c '! '"$scree"' check scene.yaml --set guards.energy=stop --set "groups=[{name: pushed, motion: moving, select: {ids: [71]}}]" >said 2>&1 && grep -q "guards.energy: group" said'
check 'check foresees a leap' says 'would stop the run' --set 'particles.sources[0].velocity=[0, 2000, 0]'
check 'check foresees an overlap' says 'overlap by .*would stop the run' --set step.force=true --set material_pairs[0].k_n=0.1
ends() { says . "${@:2}" && tail -n 1 said | grep -q "$1"; }
check 'and says so at its end' ends 'would stop this run.*guards.speed, guards.overlap$' --set 'particles.sources[0].velocity=[0, 2000, 0]' \
    --set step.force=true --set material_pairs[0].k_n=0.1
check 'and nothing where there is nothing' bash -c "$scree"' check scene.yaml >said 2>&1 && ! grep -q would said'

# A boulder squeezes a light grain against the floor, without losses: two springs in a row
cat >squeeze.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [60, 60, 60]}
duration: 12
contact: {law: hertz, tangential: none}
materials: [{name: soft, density: 1, young: 1000, poisson: 0.3}, {name: hard, density: 1, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 1}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: soft}]
particles:
  sources:
    - {from: single, position: [30, 30, 1], radius: 1, material: soft, density: 0.1}
    - {from: single, position: [30, 30, 12.0001], radius: 10, velocity: [0, 0, -0.1], material: hard}
guards: {overlap_bound: 0.9}
observables: {every: 1, list: [{name: overlap_max}]}
EOS
squeezes() { # DIR LEAST FLAG...: the overlap is at most that foretold (but for the grain's own mass), and LEAST of it at least
    local foretold
    "$scree" check --all squeeze.yaml "${@:3}" >checked || { cat checked; return 1; }
    foretold=$(sed -n 's/.* under the heaviest, on a support, by up to \([-0-9.e+]*\).*/\1/p' checked)
    run_scene 1 squeeze.yaml "$1" "${@:3}" || return 1
    awk -F, -v foretold="$foretold" -v least="$2" 'NR > 1 && $NF > most { most = $NF }
        END { print "  " most " of " foretold " foretold"; exit !(most <= 1.005 * foretold && most >= least * foretold) }' "$1/observables.csv"
}
linear=(--set contact.law=hooke --set materials[0].young=~ --set materials[0].poisson=~ --set materials[1].young=~ --set materials[1].poisson=~)
check 'check foresees how far a boulder squeezes a grain' squeezes alike 0.8
check 'between contacts of other stiffness' squeezes stiff 0.99 --set materials[0].young=10000
check 'the other way round, too' squeezes stiffer 0.8 --set materials[1].young=10000
check 'with springs' squeezes springs 0.99 "${linear[@]}" --set 'material_pairs=[{restitution: 1, k_n: 10000}, {between: [soft, hard], restitution: 1, k_n: 2000}]'
remedy() { # the modulus that the warning names keeps the overlap foretold below the bound, at the time step that it names
    local factor dt
    "$scree" check --all squeeze.yaml --set guards.overlap_bound=0.1 >checked || { cat checked; return 1; }
    set -- $(sed -n "s/^warning: guards.overlap: .* young of 'soft' times \([0-9.e+]*\) keeps .* time step of \([0-9.]*\) of this one; times .*/\1 \2/p" checked)
    [ $# = 2 ] || { echo '  no remedy:'; cat checked; return 1; }
    factor=$1 dt=$2
    "$scree" check --all squeeze.yaml --set guards.overlap_bound=0.101 --set materials[0].young="$(awk "BEGIN { print 1000 * $factor }")" \
        --set materials[1].young="$(awk "BEGIN { print 1000 * $factor }")" >stiffened || return 1
    ! grep -q '^warning' stiffened || { cat stiffened; return 1; }
    set -- $(sed -n 's/^  chosen *\([0-9.e-]*\) .*/\1/p' checked) $(sed -n 's/^  chosen *\([0-9.e-]*\) .*/\1/p' stiffened)
    within "$(awk "BEGIN { print $2 / $1 }")" "$dt" 0.02
}
check 'and the warning names a remedy that holds, and its price' remedy
check 'without a support nothing is squeezed' bash -c "$scree"' check squeeze.yaml --set "walls=[]" >said && ! grep -q "under the heaviest" said'

# Where things are
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid\n' >far.stl
meshes='walls=[{name: floor, shape: plane, point: [0, 0, 0.5], normal: [0, 0, 1]}, {name: far, shape: mesh, file: far.stl, offset: [20, 0, 0]},
    {name: near, shape: mesh, file: far.stl}, {name: pipe, shape: cylinder, point: [5, 5, 5], axis: [0, 1, 0], radius: 4}]'
check 'check shows where the particles are' says 'particles  *2 \.\.\. 6\.5  *4 \.\.\. 6  *4 \.\.\. 6 *$'
check 'and which are outside' says '4 \.\.\. 6 .*NOTE: 1 of them outside of the box' --set 'particles.sources[0].position=[12, 5, 5]'
check 'where a mesh is, outside' says "mesh 'far'  *20 \.\.\. 21  *0 \.\.\. 2  *0 \.\.\. 0 .*NOTE: wholly outside of the box" --set "$meshes"
check 'or inside' says "mesh 'near'  *0 \.\.\. 1  *0 \.\.\. 2  *0 \.\.\. 0 *$" --set "$meshes"
check 'and the other walls' says "cylinder 'pipe'  *1 \.\.\. 9  *-inf \.\.\. inf  *1 \.\.\. 9 *$" --set "$meshes"
spread() {
    on 2 "$scree" check --all scene.yaml --set 'particles.sources[0].position=[12, 5, 5]' >said 2>&1
    grep -q 'particles  *4\.5 \.\.\. 13  *4 \.\.\. 6 .*NOTE: 1 of them' said || { cat said; return 1; }
}
check 'on two ranks, too' spread

# A rough floor: frozen spheres overlap each other and are sunk into a plane; one lies still on it
cat >rough.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [20, 20, 20], periodic: false}
step: {dt: 1e-3, count: 100}
gravity: [0, 0, -10]
contact: {law: hooke}
materials: [{name: stone, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0.5, k_n: 10000}]
groups: [{name: rough, motion: frozen}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: single, position: [5, 5, 0], radius: 1, group: rough}
    - {from: single, position: [6.2, 5, 0], radius: 1, group: rough}
    - {from: single, position: [12, 5, 0.995811], radius: 1}
observables: {every: 100, list: [{name: contacts}, {name: energy_elastic_normal}, {name: wall_force, target: floor, components: z}]}
EOF
rough_floor() {
    run_scene 1 rough.yaml rough || return 1
    set -- $(awk -F, 'END { print $2, $3, $4 }' rough/observables.csv)
    [ "$1" = 1 ] && within "$2" 0.0878 0.005 && within "$3" -41.9 4
}
check 'spheres that are fixed to each other and to a wall have no contacts' rough_floor
turning() { # KIND SPEED: a sphere that its group moves feels the plane from the start
    run_scene 1 rough.yaml "turning-$1" --set "groups=[{name: rough, motion: moving, $1: [0, $2, 0]}]" --set step.count=1 \
        --set observables.every=1 --set 'particles.sources=[{from: single, position: [5, 5, 0.99], radius: 1, group: rough}]' || return 1
    set -- $(awk -F, 'END { print $2, $4 }' "turning-$1/observables.csv")
    [ "$1" = 1 ] && within "$2" -100 1e-6
}
check 'but for one that turns' turning omega 1
check 'and one that moves' turning velocity 1

# A speed whose square is no number, of the first of more particles than one block holds
cat >thrown.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [14, 14, 20]}
step: {dt: 0.001, count: 10}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 10000}]
groups: [{name: thrown, motion: moving, velocity: [1.5e308, 1.5e308, 0]}]
particles:
  sources:
    - {from: single, position: [7, 7, 1], radius: 0.4, group: thrown}
    - {from: lattice, lattice: sc, spacing: 1, sizes: 0.4, region: {shape: box, lower: [0, 0, 3], upper: [14, 14, 15]}}
EOF
thrown() { # THREADS
    on 1 "$scree" run thrown.yaml -o thrown$1 --quiet --set threads="$1" >said 2>&1
    [ $? = 3 ] && holds said 'guards.nan: position or velocity of particle 1 at' && holds said 'at step 1, '
}
spun() { # turned by order beyond what a number holds
    on 1 "$scree" run thrown.yaml -o spun --overwrite --quiet --set 'groups[0].velocity=[0, 0, 0]' --set 'groups[0].omega=[1.5e308, 1.5e308, 0]' \
        --set contact.tangential=history >said 2>&1
    [ $? = 3 ] || { cat said; return 1; }
    holds said 'guards.nan: angular velocity of particle 1 at' && holds said 'at step 1, '
}
check 'a speed that is no number shows at once, whoever moves after it' thrown 1
check 'and on whatever thread' thrown 2
check 'a spin that is no number stops the run, too' spun

# A law that gives no number: its force is no number either, in every order of the step and on every layout
cat >none.c <<'EOF'
#include <scree_law.h>
static inline struct scree_law_springs springs(struct scree_law_contact c) {
    double force = c.k_n * c.overlap / 0.0 * 0.0;
    return (struct scree_law_springs){
        .force = force, .stiffness = c.k_n, .tangent = c.k_n, .tangential = c.k_t, .contact = 1.0, .energy = force};
}
SCREE_LAW(springs, .name = "none")
EOF
none() { # RANKS FLAG...
    on "$1" "$scree" run scene.yaml -o none --overwrite --quiet --set 'contact.law={file: none.c}' "${@:2}" >said 2>&1
    [ $? = 3 ] && holds said 'guards.nan: position or velocity of particle 71 at' && holds said 'is not finite at step 127, ' &&
        "$scree" info none/checkpoint-*-stopped.h5 | grep -q whole
}
check 'a law that gives no number stops the run' none 1
check 'and friction does not hide it' none 1 --set contact.tangential=history
check 'nor does the plain order' none 1 --set step.fused=false
check 'nor does the reproducible mode' none 1 --set reproducible=true
check 'nor do parts of a law' none 1 --set contact.cohesion=sjkr --set 'material_pairs[0].cohesion_density=1'
check 'nor do ranks' none 2
last() { # what the last step gives is seen, though nobody moves by it
    on "$1" "$scree" run scene.yaml -o none --overwrite --quiet --set 'contact.law={file: none.c}' --set step.count=126 >said 2>&1
    [ $? = 3 ] || { cat said; return 1; }
    holds said 'guards.nan: force or torque of particle 71 at'
}
check 'nor does the end of the run' last 1
check 'on ranks, too' last 2
hot() { # a temperature beyond what a number holds
    on 1 "$scree" run scene.yaml -o hot --overwrite --quiet --set 'particles.sources[0].position=[3, 5, 0.9]' --set 'particles.sources[0].velocity=[0, 0, 0]' \
        --set 'heat={temperature: 300, materials: [{conductivity: 1, capacity: 1}], walls: [{wall: floor, flux: 1.7e308}]}' "$@" >said 2>&1
    [ $? = 3 ] || { cat said; return 1; }
    holds said 'guards.nan: the temperature of particle 71 is not finite at step'
}
check 'a temperature that is no number stops the run' hot
check 'in plain order, too' hot --set step.fused=false

# Crossings of a periodic box are counted in 32 bits; a counter that is full ends the run, also where guards are off
printf 'title\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms # sphere\n\n7 1 1 1 3.9 2 2 2147483647 0 0\n' >full.data
cat >full.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4], periodic: true}
step: {dt: 0.01, count: 50}
contact: {law: hooke}
guards: {speed: off, overlap: off}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 1, k_n: 100}]
particles: {file: full.data, format: lammps-data, velocity: [1, 0, 0]}
observables: {every: 10, list: [{name: centre}]}
EOF
full() {
    on 1 "$scree" run full.yaml -o full --quiet "$@" >said 2>&1
    [ $? = 3 ] && holds said 'particle 7 has crossed the periodic box in x more often than 32 bits count, at step ' || { cat said; return 1; }
}
check 'crossings beyond 32 bits end the run' full
check 'but not crossings back' run_scene 1 full.yaml back --set 'particles.velocity=[-20, 0, 0]'

# Nobody is left: the centre is nan, without a sign
gone() {
    run_scene 1 full.yaml gone --set box.periodic=false --set box.leave=delete --set 'particles.velocity=[10, 0, 0]' &&
        tail -n 1 gone/observables.csv | grep -q ',nan,nan,nan$' || { cat said gone/observables.csv; return 1; }
}
check 'the centre of no particles is nan' gone
check 'a damping ratio of nothing has no sign' says 'damping ratio 0)' --set material_pairs[0].restitution=1
finish
