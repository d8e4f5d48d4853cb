#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Laws with parts in whole runs: the same bits on all layouts, over rebuilds and a resume; what does not combine is refused; the range of
# small grains widens no search of large ones.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >sticky.yaml <<'YAML'
units: none
reproducible: true
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {dt: 2e-4, count: 3000}
contact: {law: hertz, rolling: epsd, twisting: marshall, tangential: rescale, cohesion: jkr}
materials: [{name: a, density: 1, young: 1e4, poisson: 0.3}]
material_pairs: [{restitution: 0.5, friction: 0.5, static_friction: 0.6, rolling_friction: 0.1, surface_energy: 1}]
walls: [{name: floor, shape: plane, point: [0, 0, 0.1], normal: [0, 0, 1]}]
particles: {from: random, region: {shape: box, lower: [0, 0, 0.2], upper: [6, 6, 5.5]}, sizes: {law: uniform, min: 0.2, max: 0.6}, volume_fraction: 0.4}
output: {dump: {every: 3000, fields: [id, radius, position, velocity, angular_velocity, force, torque]}, checkpoint: {every: 1500, keep: 9}}
YAML
wet=(--set 'contact={law: hooke, rolling: constant, twisting: sds, tangential: force, cohesion: capillary}' --set 'materials=[{name: a, density: 1}]'
    --set 'material_pairs=[{restitution: 0.5, friction: 0.5, rolling_friction: 0.02, k_n: 1e4, surface_tension: 1, contact_angle: 0.2, bridge_fraction: 0.01, twisting_stiffness: 10, twisting_friction: 0.01}]')

same_bits() { # SETTING...: one rank, two ranks with threads on another index, and a resume on two ranks
    rm -rf one two again
    run_scene 1 sticky.yaml one "$@" && run_scene 2 sticky.yaml two --set threads=2 --set index=bytype "$@" || return 1
    cmp one/dump.lammpstrj two/dump.lammpstrj || return 1
    run_scene 2 sticky.yaml again --resume one/checkpoint-1500.h5 "$@" || return 1
    awk '/^ITEM: TIMESTEP/ { keep = 0; getline step; keep = step == 3000 } keep' one/dump.lammpstrj >end.one
    awk '/^ITEM: TIMESTEP/ { keep = 0; getline step; keep = step == 3000 } keep' again/dump.lammpstrj >end.again
    [ -s end.one ] && cmp end.one end.again
}
check 'JKR, epsd, marshall, rescaled springs: the same bits on two ranks and threads, and after a resume' same_bits
check 'so with a liquid bridge, constant torque, springs that remember the force' same_bits "${wet[@]}"

plastic=(--set 'contact={law: luding, tangential: viscous}' --set 'materials=[{name: a, density: 1}]'
    --set 'material_pairs=[{restitution: 0.8, friction: 0.5, k_n: 1e4, k_2: 3e4, k_c: 1e4, plasticity_depth: 0.05}]')
check 'so with plastic springs and viscous friction' same_bits "${plastic[@]}"

another() { # a checkpoint of another cohesion is refused
    run_scene 1 sticky.yaml one --overwrite --set step.count=1500 || return 1
    ! run_scene 1 sticky.yaml again --overwrite --resume one/checkpoint-1500.h5 --set contact.cohesion=none --set 'material_pairs[0].surface_energy=~' &&
        holds said 'contact.law hertz, cohesion.law jkr'
}
check 'a resume with another cohesion is refused' another

refused() { # TEXT SETTING...
    local text=$1
    shift
    ! "$scree" check --all sticky.yaml "$@" >said 2>&1 && holds said "$text"
}
check 'JKR with a linear spring is refused, and what goes is named' refused 'with hooke go: none, sjkr, capillary, van_der_waals' \
    --set contact.law=hooke --set contact.tangential=history --set 'material_pairs[0].k_n=1e4' --set 'materials=[{name: a, density: 1}]'
check 'twisting without friction is refused' refused 'contact.twisting: exists only with' --set contact.tangential=none --set 'contact.rolling=~'

# Bridges and adhesive contacts form, are stretched and break, between spheres and at a wall: the balance of energies stays, to the
# error of the time step
cat >forms.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [8, 8, 8]}
step: {dt: 0.0005, count: 8000}
contact: {law: hertz, tangential: none, cohesion: {law: capillary}}
materials: [{name: a, density: 1, young: 1000, poisson: 0}]
material_pairs: [{restitution: 0.9, surface_tension: 0.1, contact_angle: 0, bridge_volume: 0.005}]
walls: [{name: hot, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: single, position: [4, 4, 1.05], radius: 1, velocity: [0,0,-0.6]}
    - {from: single, position: [4, 4, 3.25], radius: 1, velocity: [0, 0, -0.6]}
observables: {every: 1, list: [{name: energy_balance}, {name: energy_kinetic}, {name: energy_elastic_normal}, {name: energy_dissipated}, {name: contacts}]}
YAML
balanced() { # LEAST FLAG...: the energy of springs falls below -LEAST, and the balance moves by far less
    run_scene 1 forms.yaml forms --overwrite "${@:2}" || return 1
    awk -F, -v least="$1" 'NR == 2 { first = $2 } NR > 1 { off = $2 - first; off = off < 0 ? -off : off; if (off > most) most = off; if ($4 < low) low = $4; if ($6 > touch) touch = $6 }
        END { print "  up to " touch " contacts, energy of springs down to " low ", balance off by up to " most; exit !(touch == 2 && low < -least && most < 1e-3) }' forms/observables.csv
}
sticky_law() { echo "contact={law: $1, tangential: none, cohesion: {law: $2, end: $3}}"; }
check 'a bridge that forms leaves the balance of energies' balanced 0.05
check 'and one between plastic springs' balanced 0.05 --set 'contact={law: luding, cohesion: {law: capillary}, tangential: none}' --set 'materials=[{name: a, density: 1}]' \
    --set 'material_pairs=[{restitution: 0.9, k_n: 300, k_2: 600, k_c: 0, surface_tension: 0.1, contact_angle: 0, bridge_volume: 0.005}]'
for end in distance force; do
    check "JKR, end: $end" balanced 0.005 --set "$(sticky_law hertz jkr $end)" --set 'material_pairs=[{restitution: 0.9, surface_energy: 0.1}]'
done
check 'JKR between plastic spheres' balanced 0.05 --set "$(sticky_law thornton jkr distance)" --set 'material_pairs=[{restitution: 0.9, surface_energy: 0.1, yield_pressure: 20}]'
from_touch() { # contacts that are there at the start do not form again
    balanced 0.05 --set 'particles.sources[0].position=[4, 4, 0.999]' --set 'particles.sources[1].position=[4, 4, 2.998]'
}
check 'contacts that there are at the start do not form' from_touch
goes_on() { # a resume while bridges hold
    run_scene 1 forms.yaml forms --overwrite --set step.count=1200 && run_scene 1 forms.yaml forms --overwrite --resume last || return 1
    awk -F, 'NR == 2 { first = $2 } NR > 1 { off = $2 - first; if (off * off > 1e-6) exit 1 }' forms/observables.csv
}
check 'nor do they after a resume' goes_on

# Bidisperse: radii 10 and 40. The cohesion of the small ones costs few pairs.
cat >two.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [400, 400, 400], periodic: true}
step: {dt: 1e-3, count: 1}
contact: {law: hertz, tangential: none}
materials: [{name: small, density: 1, young: 1e6, poisson: 0.3}, {name: large, density: 1, young: 1e6, poisson: 0.3}]
material_pairs: [{restitution: 0.5}]
particles:
  sources:
    - {from: random, material: large, region: {shape: box, lower: [0, 0, 0], upper: [400, 400, 400]}, sizes: 40, count: 60}
    - {from: random, material: small, region: {shape: box, lower: [0, 0, 0], upper: [400, 400, 400]}, sizes: 10, count: 3000}
YAML
pairs() { "$scree" check --all two.yaml --set index="$1" "${@:2}" | sed -n 's/.*; \([0-9]*\) pairs and.*/\1/p'; }
few_more() { # INDEX: pairs with JKR among the small ones over those without
    local without with
    without=$(pairs "$1") with=$(pairs "$1" --set contact.cohesion=jkr \
        --set 'material_pairs=[{restitution: 0.5, surface_energy: 0}, {between: [small, small], restitution: 0.5, surface_energy: 1e4}]')
    echo "  $1: $without pairs, $with with cohesion"
    awk -v a="$without" -v b="$with" 'BEGIN { exit !(a > 0 && b >= a && b <= 1.3 * a) }'
}
for index in bytype hgrid linkcell multi; do
    check "JKR among small grains beside large ones: at most 1.3 times the pairs on $index" few_more $index
done

finish
