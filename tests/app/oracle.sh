#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Contact problems of hard contacts (output.contact_problems): what the files hold, when they are written, and that Siconos's solver finds
# the same velocities: tests/physics/hard/oracle.c, where configure has found Siconos.

. "$(dirname "$0")/common.sh"
oracle=$top_builddir/tests/physics/hard/oracle
cd "$out" || exit 1
cat >bed.yaml <<'EOS'
box: {lower: [0, 0, 0], upper: [6 mm, 6 mm, 20 mm], periodic: [true, true, false]}
gravity: [0, 0, -9.81]
step: {dt: 1e-4, count: 500}
contact: {law: rigid, solver: {sweeps: 2000, tolerance: 1e-9}}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0, friction: 0.4}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: random, region: {shape: box, lower: [0, 0, 1 mm], upper: [6 mm, 6 mm, 12 mm]}, count: 25, sizes: {radius: 1 mm}}
    - {from: single, position: [3 mm, 3 mm, 15 mm], radius: 2 mm}
output: {contact_problems: {every: 500}}
EOS
cat >plane.yaml <<'EOS'
box: {dimension: 2, lower: [0, 0, -2 mm], upper: [10 mm, 30 mm, 2 mm], periodic: [true, false, false]}
gravity: [2, -9.81, 0]
step: {dt: 1e-4, count: 500}
contact: {law: rigid, solver: {sweeps: 2000, tolerance: 1e-9}}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0, friction: 0.2}]
walls: [{shape: plane, name: floor, point: [0, 0, 0], normal: [0, 1, 0]}]
particles: {from: lattice, lattice: square, spacing: 2.2 mm, jitter: 0.2, count: 20, sizes: {law: uniform, min: 0.8 mm, max: 1 mm}, region: {shape: box, lower: [0, 0, -1 mm], upper: [10 mm, 15 mm, 1 mm]}}
output: {contact_problems: {every: 500}}
EOS

files() { (cd "$1" && echo contact-problem-*.hdf5); }
agrees() { # BOUND DIR...: Siconos has the same velocities, over g dt, in the last problem of each run
    local bound=$1 dir
    shift
    for dir; do "$oracle" "$bound" "$dir/$(files "$dir" | tr ' ' '\n' | sort -V | tail -n 1)" || return 1; done
}
refused() { # TEXT FLAG...
    local text=$1
    shift
    ! "$scree" run bed.yaml -o no "$@" >said 2>&1 && [ ! -e no ] && grep -q "$text" said
}

check 'springs of rigid grains' run_scene 1 bed.yaml springs
check 'a file at the end, none of the start without contacts' [ "$(files springs)" = contact-problem-500.hdf5 ]
check 'two ranks' run_scene 2 bed.yaml ranks
check 'in two dimensions, sliding' run_scene 1 plane.yaml plane
clump='bodies.clumps=[{size: drawn, spheres: [{centre: [0, 0, 0], radius: 0.5 mm}, {centre: [0.5 mm, 0, 0], radius: 0.5 mm}, {centre: [0, 0.5 mm, 0], radius: 0.4 mm}], mass: 1e-5 kg}]'
check 'bodies' run_scene 1 bed.yaml bodies --set "$clump" --set particles.sources[1].radius='1 mm'
check 'on two ranks' run_scene 2 bed.yaml bodies2 --set "$clump" --set particles.sources[1].radius='1 mm'
check 'bodies in two dimensions' run_scene 1 plane.yaml rods --set bodies.clumps='[{size: drawn, spheres: [{centre: [0, 0, 0], radius: 0.6 mm}, {centre: [0.7 mm, 0, 0], radius: 0.5 mm}]}]'
rock='bodies.shapes=[{name: rock, random: {corners: 10, variants: 3}, roundness: 0.2}]'
check 'rocks' run_scene 1 bed.yaml rocks --set "$rock" --set particles.sources[1].radius='1 mm'
check 'on two ranks' run_scene 2 bed.yaml rocks2 --set "$rock" --set particles.sources[1].radius='1 mm'
# each overlap that grows meets a strong damper, also in the step in which it begins
check 'a spring by the law' run_scene 1 bed.yaml hertz --set contact.law=hertz --set materials[0].young=1e8 --set materials[0].poisson=0.3 --set guards.residual=stop
check 'rigid rows' run_scene 1 bed.yaml rigid --resume springs/checkpoint-500.h5 --set contact.solver.kappa=.inf --set contact.solver.sweeps=100000 --set step.count=501 \
    --set output.contact_problems.every=1
check 'a resume keeps the files of earlier steps and writes its own' run_scene 1 bed.yaml springs --resume springs/checkpoint-500.h5 --set step.count=510 --set output.contact_problems.every=5
check 'which are' [ "$(files springs)" = 'contact-problem-500.hdf5 contact-problem-505.hdf5 contact-problem-510.hdf5' ]
if [ -x "$oracle" ]; then
    check 'Siconos finds the same velocities' agrees 1e-6 springs ranks plane rigid
    check 'of bodies, too' agrees 1e-6 bodies bodies2 rods
    check 'of rocks' agrees 1e-6 rocks rocks2
    check 'and of springs by their tangents' agrees 1e-5 hertz
else
    skip 'contact problems solved by Siconos: no Siconos here (Debian: libsiconos-numerics-dev)'
fi
check 'a new run takes earlier files away' run_scene 1 bed.yaml ranks --overwrite --set output.contact_problems.every=0
check 'all of them' [ "$(files ranks)" = 'contact-problem-*.hdf5' ]
check 'without a solver: refused' refused 'output.contact_problems.every: needs contact.solver' --set contact='{law: hooke}' --set material_pairs[0].k_n=1000
finish
