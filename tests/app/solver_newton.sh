#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Hard contacts by Newton's method in whole runs: a bed at rest whose residual sweeps do not meet, by rigid contacts, by a linear spring
# and by Hertz at 70 GPa, on any layout; what is refused.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >bed.yaml <<'EOS'
box: {lower: [0, 0, 0], upper: [8 mm, 8 mm, 40 mm], periodic: [true, true, false]}
gravity: [0, 0, -9.81]
step: {dt: 1e-4, count: 900}
contact: {law: rigid, solver: {sweeps: 30, tolerance: 1e-4}}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.3, friction: 0.4}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: random, region: {shape: box, lower: [0, 0, 1 mm], upper: [8 mm, 8 mm, 16 mm]}, count: 60, sizes: {radius: 1 mm}}
    - {from: single, position: [4 mm, 4 mm, 20 mm], radius: 3 mm}
output: {dump: {every: {steps: 900}, fields: [position, velocity, angular_velocity]}, checkpoint: {every: 900}}
observables: {every: {steps: 1}, list: [{name: wall_force}, {name: momentum}, {name: contact_sweeps}, {name: contact_newton}, {name: contact_residual}]}
guards: {residual: stop}
EOS
glass=(--set contact.law=hertz --set materials[0].young=70e9 --set materials[0].poisson=0.2)
newton='{name: newton, sweeps: 10, tolerance: 1e-5}'
"$scree" check bed.yaml --set contact.solver="$newton" >said 2>&1
if holds said 'contact.solver.name: newton needs PETSc'; then
    skip "Newton's method: without PETSc"
    finish
    exit
fi

# rows DIR: the particles of the last frame, by id
rows() { awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next }
    reading { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' "$1/dump.lammpstrj" | sort -n; }
same() { [ -s "$1/dump.lammpstrj" ] && cmp <(rows "$1") <(rows "$2"); }

# column DIR NAME: its largest value, and its mean
column() { awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) if (index($k, name "[") == 1) at = k; next }
    { n++; sum += $at; if ($at > most) most = $at } END { print most, sum / n }' "$1/observables.csv"; }

# settles RANKS DIR SETTING...: thirty more steps of the settled bed, each of which Newton's method brings below the tolerance
settles() {
    local ranks=$1 dir=$2
    run_scene "$ranks" bed.yaml "$dir" --resume "$kept" --set step.count=930 --set output.dump.every.steps=30 --set contact.solver="$newton" "${@:3}" || return 1
    read -r most mean <<<"$(column "$dir" contact_newton)"
    within "$most" 15 14.5 && within "$(column "$dir" contact_residual | cut -d' ' -f1)" 0 1e-5
}

check 'a bed settles by sweeps' run_scene 1 bed.yaml settled --set threads=1 --set guards.residual=off
kept=settled/checkpoint-900.h5
check 'one rank, one thread' settles 1 one --set threads=1
check 'again' settles 1 again --set threads=1
check 'the same bits' same one again
check 'two threads' settles 1 threads --set threads=2
check 'another index' settles 1 brute --set threads=1 --set index=brute
check 'two ranks' settles 2 ranks2 --set threads=1
check 'three ranks, newton off' settles 3 ranks3 --set threads=1 --set newton=false
check 'without friction' settles 1 smooth --set threads=1 --set material_pairs[0].friction=0
check 'discs' run_scene 1 bed.yaml discs --set threads=1 --set guards.residual=off --set step.count=200 --set contact.solver="$newton" --set 'box={dimension: 2, lower: [0, 0], upper: [8 mm, 40 mm], periodic: [true, false]}' \
    --set 'gravity=[0, -9.81]' --set 'walls=[{shape: plane, name: floor, point: [0, 0], normal: [0, 1]}]' \
    --set 'particles={from: random, region: {shape: box, lower: [0, 1 mm], upper: [8 mm, 16 mm]}, count: 12, sizes: {radius: 1 mm}}'
check 'Hertz settles by sweeps' run_scene 1 bed.yaml hertz --set threads=1 --set guards.residual=off "${glass[@]}"
kept=hertz/checkpoint-900.h5
check 'Hertz at 70 GPa' settles 1 glass --set threads=1 "${glass[@]}"
check 'Hertz at 70 GPa on two ranks' settles 2 glass2 --set threads=1 "${glass[@]}"
check 'a linear spring settles by sweeps' run_scene 1 bed.yaml hooke --set threads=1 --set guards.residual=off --set contact.law=hooke --set material_pairs[0].k_n=1e5
kept=hooke/checkpoint-900.h5
check 'a linear spring' settles 1 spring --set threads=1 --set contact.law=hooke --set material_pairs[0].k_n=1e5
clumps='bodies.clumps=[{spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 0.8}]}]'
check 'bodies settle by sweeps' run_scene 1 bed.yaml bodies --set threads=1 --set guards.residual=off --set "$clumps"
kept=bodies/checkpoint-900.h5
check 'bodies' settles 1 body1 --set threads=1 --set "$clumps"
check 'bodies on two ranks' settles 2 body2 --set threads=1 --set "$clumps"

# agree DIR DIR: velocities and spins after a step, to 1e-6 g dt and that over a radius
agree() {
    paste <(rows "$1") <(rows "$2") | awk '{ n = NF / 2; for (k = 6; k <= n; k++) { d = $k - $(k + n); if (k > 8) d *= 1e-3; d = d < 0 ? -d : d; if (d > most) most = d } }
        END { print "  " NR " spheres and bodies differ by " most / 9.81e-4 " g dt"; exit !(NR > 100 && most < 1e-6 * 9.81e-4) }'
}
step() { # RANKS DIR SOLVER: one more
    run_scene "$1" bed.yaml "$2" --resume "$kept" --set threads=1 --set step.count=901 --set output.dump.every.steps=1 --set guards.residual=off --set "$clumps" --set contact.solver="$3"
}
check 'a step of bodies by very many sweeps' step 1 swept '{sweeps: 20000, tolerance: 1e-12}'
check "the same by Newton's method" step 1 newton '{name: newton, sweeps: 10, tolerance: 1e-11}'
check 'they agree' agree swept newton
check 'on two ranks' step 2 newton2 '{name: newton, sweeps: 10, tolerance: 1e-11}'
check 'they agree' agree swept newton2

cat >heavy.yaml <<'EOS'
units: none
box: {lower: [-2, -2, 0], upper: [2, 2, 10]}
gravity: [0, 0, -10]
step: {dt: 1e-3, count: 300}
contact: {law: rigid, solver: {name: newton, sweeps: 30, tolerance: 1e-6, kappa: 100}}
materials: [{name: light, density: 1}, {name: heavy, density: 1e4}]
material_pairs: [{restitution: 0, friction: 0.3}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: light}]
bodies:
  clumps:
    - {material: light, orientation: given, quaternion: [1, 0, 0, 0], size: drawn, spheres: [{centre: [0.5, 0, 0], radius: 0.5}, {centre: [-0.25, 0.4330127, 0], radius: 0.5}, {centre: [-0.25, -0.4330127, 0], radius: 0.5}]}
particles:
  sources:
    - {from: single, position: [0, 0, 0.5], radius: 1, material: light}
    - {from: single, position: [0, 0, 1.914214], radius: 1, material: heavy}
observables: {every: 1, list: [{name: contact_newton}, {name: contact_residual}, {name: overlap_max}]}
EOS
# heavy DENSITY KAPPA FRICTION MOST: so many steps of Newton's at most, one as a rule. All contacts of the sphere slide in the first step; sweeps
# leave a small residual, by which they stick
heavy() {
    local dir=heavy-$1-$2-$3
    run_scene 1 heavy.yaml "$dir" --set threads=1 --set "materials[heavy].density=$1" --set "contact.solver.kappa=$2" --set "material_pairs[0].friction=$3" || return 1
    read -r most mean <<<"$(column "$dir" contact_newton)"
    echo "  Newton's steps: $most at most, $mean as a mean; residual $(column "$dir" contact_residual)"
    within "$most" "$(awk -v n="$4" 'BEGIN { print n / 2 }')" "$(awk -v n="$4" 'BEGIN { print n / 2 }')" && within "$mean" 1 1 &&
        within "$(column "$dir" contact_residual | cut -d' ' -f1)" 0 1e-6
}
check 'a sphere of ten thousand times its mass on a body of three' heavy 1e4 100 0.3 6
check 'a sphere of a million times its mass' heavy 1e6 100 0.3 6
for friction in 0.2 0.35; do
    check "the same by stiff contacts, friction $friction" heavy 1e6 1e4 $friction 12
done
reports() { "$scree" run bed.yaml -o told --set threads=1 --set guards.residual=off --set step.count=300 --set contact.solver="$newton" >said 2>&1; holds said 'newton  ' && holds said 'newton_step'; }
check 'the report has its steps' reports
refuses() { # WORDS FLAG...
    "$scree" check bed.yaml "${@:2}" >said 2>&1
    [ $? = 2 ] && holds said "$1"
}
check 'rigid rows are refused' refuses 'contact.solver.kappa: rigid rows have no derivative; allowed with newton is a finite number' --set contact.solver='{name: newton, kappa: .inf}'
check 'steps belong to Newton alone' refuses 'contact.solver.steps' --set contact.solver='{steps: 3}'
finish
