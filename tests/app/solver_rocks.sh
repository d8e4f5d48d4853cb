#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rocks under contact.solver: a cube comes to rest on a floor and does not rattle; slopes, a tower, a stack; impacts by closed forms, which never gain energy;
# momentum of a gas; a crowd of rocks, clumps and spheres on threads, indexes, ranks, after a resume, by each law; at meshes and walls that move;
# Newton's method; messages.
. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cube='vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05, size: drawn, orientation: given'
cat >drop.yaml <<YAML
units: none
box: {lower: [-50, -50, -1], upper: [50, 50, 19]}
gravity: [0, 0, -10]
step: {dt: 2e-3, count: 3000}
contact: {law: rigid, solver: {sweeps: 300, tolerance: 1e-11}}
materials: [{name: rock, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.5}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: single, position: [0, 0, 1.2], radius: 1}
bodies: {shapes: [{name: cube, $cube, quaternion: [1, 0.3, 0.2, 0.1]}]}
observables: {every: 100, list: [{name: position, id: 1}, {name: velocity, id: 1}, {name: angular_velocity, id: 1}, {name: energy}, {name: wall_force, target: floor}, {name: contacts}, {name: overlap_max}]}
output: {checkpoint: {at_end: false}}
YAML
drop=(--set threads=1)
last() { last_of "$1/observables.csv" "$2"; }
# most DIR COLUMN: its largest size in the second half of the rows
most() { awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); if ($k == name) at = k } next } { v[NR] = $at < 0 ? -$at : $at }
    END { for (k = int(NR / 2) + 1; k <= NR; k++) if (v[k] > most) most = v[k]; printf "%.3g", most }' "$1/observables.csv"; }

# A cube that falls leaning comes to rest on four corners, each of which carries a fourth of the weight: it sinks by g dt^2 / kappa x W m / 4, and the push of
# one on itself is W = (1 + 2 x 6 x 0.45^2) / m, as the corners of the core are 0.45 from the axes
rests() { # DIR BOUND OF SPEEDS
    within "$(last "$1" particle1_z)" "$(awk 'BEGIN { printf "%.12f", 0.5 - 10 * 4e-6 / 39.478417604357434 * (1 + 12 * 0.45 ^ 2) / 4 }')" 1e-10 &&
        within "$(last "$1" floor_fz)" -10 1e-8 && within "$(last "$1" contacts)" 4 0 &&
        within "$(most "$1" particle1_vz)" 0 "$2" && within "$(most "$1" particle1_wx)" 0 "$2" && within "$(most "$1" particle1_wz)" 0 "$2"
}
check 'a cube falls on a floor' run_scene 1 drop.yaml drop "${drop[@]}"
check 'it rests on four corners, and nothing moves' rests drop 1e-9
check 'rigid rows' run_scene 1 drop.yaml stiff "${drop[@]}" --set contact.solver.kappa=.inf
check 'all of the weight, at rest' within "$(last stiff floor_fz)" -10 1e-6
check "Hertz's law" run_scene 1 drop.yaml hertz "${drop[@]}" --set contact.law=hertz --set materials[0].young=1e6 --set materials[0].poisson=0.3
check 'all of the weight, at rest' within "$(last hertz floor_fz)" -10 1e-6
springs() { # four springs of k carry the cube
    run_scene 1 drop.yaml hooke "${drop[@]}" --set contact.law=hooke --set material_pairs[0].k_n=1e5 && within "$(last hooke particle1_z)" "$(awk 'BEGIN { print 0.5 - 1e-4 / 4 }')" 1e-9
}
check 'a linear spring at each corner' springs
mesh() { run_scene 1 drop.yaml mesh "${drop[@]}" --set "walls=[{name: floor, shape: rectangle, point: [-9, -9, 0], along: [18, 0, 0], across: [0, 18, 0]}]" && rests mesh 1e-9; }
check 'a floor of triangles' mesh

# On slopes (gravity turns): rests iff tan <= mu, else slides with g (sin - mu cos); a tower of half base 0.45 (without the rounding) and height 1 topples beyond 0.45
slope() { # DIR TAN SETTING...
    run_scene 1 drop.yaml "$1" "${drop[@]}" --set bodies.shapes[0].quaternion='[1, 0, 0, 0]' --set particles.position='[0, 0, 0.5]' --set step.count=500 \
        --set "gravity=[$(awk -v t="$2" 'BEGIN { printf "%.12f, 0, %.12f", 10 * t / sqrt(1 + t * t), -10 / sqrt(1 + t * t) }')]" "${@:3}"
}
holds_on() { slope holds 0.49 && within "$(last holds particle1_vx)" 0 1e-7; }
slides() { slope slides 0.8 && within "$(last slides particle1_vx)" "$(awk 'BEGIN { printf "%.12f", 10 * 0.3 / sqrt(1.64) }')" 1e-6 && within "$(most slides particle1_wy)" 0 1e-6; }
tower=(--set 'bodies.shapes[0].vertices=[0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,2, 1,0,2, 0,1,2, 1,1,2]' --set particles.position='[0, 0, 1]' --set material_pairs[0].friction=0.9 --set particles.radius=1.3)
stands() { slope stands 0.44 "${tower[@]}" && within "$(last stands particle1_wy)" 0 1e-6; }
topples() { slope topples 0.46 "${tower[@]}" --set step.count=1000 && awk -v w="$(last topples particle1_wy)" 'BEGIN { exit !(w > 0.02) }'; }
check 'a cube holds at a tangent of 0.49, mu = 0.5' holds_on
check 'it slides at 0.8' slides
check 'a tower stands at 0.44' stands
check 'it topples at 0.46' topples

# Ten cubes on each other
stack() { # RANKS SETTING...
    for ((k = 0; k < 10; k++)); do echo "$(awk -v k=$k 'BEGIN { print 0.01 * (k % 3), 0.01 * (k * 2 % 3), k + 0.5, 0.9 }')"; done >cubes.txt
    run_scene "$1" drop.yaml stack --overwrite "${drop[@]}" --set bodies.shapes[0].quaternion='[1, 0, 0, 0]' --set particles='{from: file, file: cubes.txt, format: table, columns: [x, y, z, radius]}' \
        --set step.count=1500 --set contact.solver.tolerance=1e-8 --set observables.list[0].id=10 --set observables.list[1].id=10 --set observables.list[2].id=10 "${@:2}" &&
        within "$(last stack floor_fz)" -100 1e-4 && within "$(most stack particle10_vz)" 0 1e-5 && within "$(most stack particle10_vx)" 0 1e-4 && within "$(last stack particle10_z)" 9.5 1e-3
}
check 'a stack of ten cubes' stack 1
check 'on 2 ranks' stack 2

# The end of a rod that hits a floor without friction: impulse (1 + e) u / (1/m + x^2/I), x the arm of the two lower corners
rod=(--set 'bodies.shapes[0].vertices=[0,0,0, 3,0,0, 0,0.4,0, 3,0.4,0, 0,0,0.4, 3,0,0.4, 0,0.4,0.4, 3,0.4,0.4]' --set bodies.shapes[0].rounding=0.1
    --set bodies.shapes[0].quaternion='[0.9659258262890683, 0, 0.25881904510252074, 0]' --set gravity='[0, 0, 0]' --set contact.tangential=none
    --set 'particles={from: single, position: [0, 0, 1.0], radius: 1.6, velocity: [0, 0, -1]}' --set observables.every=1)
impact() {
    run_scene 1 drop.yaml rod "${drop[@]}" "${rod[@]}" --set step.count=200 --set material_pairs='[{restitution: 0.5}]' || return 1
    local arm=$(awk 'BEGIN { pi = atan2(0, -1); print 1.4 * cos(pi / 6) - 0.1 * sin(pi / 6) }') mass=0.48
    local j=$(awk -v a="$arm" 'BEGIN { print 1.5 / (1 + a * a / ((9 + 0.16) / 12)) }')
    within "$(last rod particle1_vz)" "$(awk -v j="$j" 'BEGIN { print -1 + j }')" 2e-3 && within "$(last rod particle1_wy)" "$(awk -v j="$j" -v a="$arm" 'BEGIN { print -a * j * 12 / 9.16 }')" 4e-3
}
check 'the end of a rod hits a floor' impact

# 49 rocks hit a floor obliquely: no impact adds energy
awk 'BEGIN { srand(3); for (k = 0; k < 49; k++) print -30 + 10 * (k % 7), -30 + 10 * int(k / 7), 1.2 + rand(), 2 * rand() - 1, 2 * rand() - 1, -1 - rand(), 0.5 }' >thrown.txt
never_gains() { # DIR SETTING...
    run_scene 1 drop.yaml "$1" "${drop[@]}" --set gravity='[0, 0, 0]' --set 'particles={from: file, file: thrown.txt, format: table, columns: [x, y, z, vx, vy, vz, radius]}' --set step.count=1200 \
        --set 'bodies.shapes=[{name: rock, random: {corners: 12, variants: 9}, roundness: 0.15, angular_velocity: [1, 2, 0.5]}]' --set material_pairs='[{restitution: 0.8, friction: 0.4}]' \
        --set 'observables={every: 1, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: wall_force}]}' "${@:2}" || return 1
    awk -F, 'NR == 2 { for (k = 0; k < 3; k++) e[k] = $2 + $3; first = e[0] } # a row of the step of an impact has the mean of the velocities before and behind it
        NR > 2 { now = $2 + $3; before = 0; for (k = 0; k < 3; k++) if (e[k] > before) before = e[k]; d = now / before - 1; if (d > most || NR == 3) most = d
            if (now < e[NR % 3] * (1 - 1e-6)) hits++; e[(NR + 1) % 3] = now } # the free rotation itself is right to 1e-10
        END { print "  largest growth " most ", rows with impacts " hits ", energy left " now / first; exit !(most < 1e-8 && hits > 30 && now < 0.9 * first) }' "$1/observables.csv"
}
check 'oblique impacts never gain energy' never_gains thrown
check 'without friction' never_gains slick --set contact.tangential=none --set material_pairs='[{restitution: 0.8}]'

# A gas of rocks keeps its momentum
cat >gas.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [7, 7, 7], periodic: true}
step: {dt: 2e-3, count: 1000}
contact: {law: rigid, solver: {sweeps: 60}}
materials: [{name: rock, density: 1}]
material_pairs: [{restitution: 0.9, friction: 0.3}]
particles: {from: random, count: 36, sizes: {law: uniform, min: 0.8, max: 1}, velocity_sigma: 2}
bodies: {shapes: [{name: rock, random: {corners: 14, variants: 8}, roundness: 0.2}]}
observables: {every: 100, list: [{name: momentum}, {name: energy_kinetic}, {name: energy_rotational}, {name: overlap_max}]}
output: {checkpoint: {at_end: false}}
YAML
gas() { # RANKS BOUND
    run_scene "$1" gas.yaml gas --overwrite --set threads=1 && awk -F, -v bound="$2" 'NR == 2 { for (k = 2; k < 5; k++) p[k] = $k; first = $5 }
        NR > 1 { off = 0; for (k = 2; k < 5; k++) off += ($k - p[k]) ^ 2; if (off > most) most = off; if ($7 > deep) deep = $7; e = $5 + $6; if (NR > 2 && e > last * 1.000001) grows++; last = e }
        END { printf "  momentum %.2g, energy %g of %g, overlap %.2g\n", sqrt(most), $5, first, deep; exit !(sqrt(most) < bound && $5 < 0.9 * first && deep < 0.05 && !grows) }' gas/observables.csv
}
check 'a gas keeps its momentum' gas 1 1e-12
check 'on 3 ranks' gas 3 1e-12

# Everything at once, between walls
cat >crowd.yaml <<'YAML'
units: none
seed: 5
box: {lower: [0, 0, 0], upper: [6, 6, 8], periodic: [true, true, false]}
gravity: [0, 0, -5]
step: {count: 400, dt: 0.001}
contact: {law: rigid, solver: {sweeps: 25, tolerance: 0}}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.3, friction: 0.3}]
groups: [{name: moves, motion: moving, velocity: [0.5, 0, 0], omega: [0, 0, 2]}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}
  - {name: lid, shape: plane, point: [0, 0, 8], normal: [0, 0, -1], material: a, motion: [{kind: oscillate, direction: [0, 0, 1], amplitude: 0.1, frequency: 2}]}
particles:
  sources:
    - {from: single, position: [3, 3, 3.2], radius: 2.5, material: b}
    - {from: single, position: [1, 1, 1], radius: 0.6, material: b, group: moves}
    - {from: random, count: 25, sizes: {law: uniform, min: 0.4, max: 0.6}, velocity_sigma: 3, material: b}
    - {from: random, count: 150, sizes: {law: uniform, min: 0.1, max: 0.3}, velocity_sigma: 4, material: a}
bodies:
  clumps: [{name: dumbbell, material: a, radius_above: 0.25, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]
  shapes:
    - {name: slab, material: b, radius_above: 2, vertices: [0,0,0, 4,0,0, 0,3,0, 4,3,0, 0,0,1, 4,0,1, 0,3,1, 4,3,1], rounding: 0.1, orientation: given, quaternion: [1, 0.2, 0.1, 0.3]}
    - {name: rock, material: b, random: {corners: 14, variants: 5}, roundness: 0.2}
observables: {every: 20, list: [{name: energy}, {name: particles}, {name: overlap_max}, {name: contact_solver}, {name: contacts}, {name: wall_force, target: lid}, {name: stress}]}
output: {dump: {every: 400, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 200, keep: 9}}
YAML
rows() { tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n; }
same() { [ -s "$1/dump.lammpstrj" ] && cmp <(rows "$1") <(rows "$2"); }
sound() { # DIR: small overlaps, and no energy from nowhere
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next } NR == 2 { first = $at["energy_balance"] }
        { if ($at["overlap_max"] > most) most = $at["overlap_max"] }
        END { drift = $at["energy_balance"] / first - 1; printf "  overlap %.2g, energy %.2g, rows %d\n", most, drift, NR; exit !(NR > 4 && most < 0.15 && drift < 0.02) }' "$1/observables.csv"
}
check 'a crowd of rocks, clumps and spheres' run_scene 1 crowd.yaml one --set threads=1
check 'it is sound' sound one
met() { awk -v lost="$(last one energy_dissipated)" 'BEGIN { print "  lost " lost; exit !(lost > 50) }'; }
check 'its particles meet' met
alike() { rm -rf other && run_scene 1 crowd.yaml other "$@" && same one other; }
check 'the same bits with 2 threads' alike --set threads=2
check 'with the index brute' alike --set threads=1 --set index=brute
check 'with linkcell and 2 threads' alike --set threads=2 --set index=linkcell
resumed() { rm -rf more && run_scene 1 crowd.yaml more --set threads=1 --resume one/checkpoint-200.h5 && same one more; }
check 'a resume gives the same bits' resumed
goes_on() { rm -rf more && run_scene "$1" crowd.yaml more --set threads=1 --resume one/checkpoint-200.h5 "${@:2}" && sound more; }
check 'a resume on 3 ranks' goes_on 3
# A bed of rocks, clumps and spheres comes to rest; from there a step solved to the end is the same on any layout
cat >bed.yaml <<'YAML'
units: none
seed: 5
box: {lower: [0, 0, 0], upper: [4, 4, 12], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {count: 1500, dt: 0.002}
contact: {law: rigid, solver: {sweeps: 60, tolerance: 1e-7}}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.2, friction: 0.5}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles:
  sources:
    - {from: random, count: 16, sizes: {law: uniform, min: 0.5, max: 0.7}, material: b, region: {shape: box, lower: [0, 0, 0], upper: [4, 4, 8]}}
    - {from: random, count: 40, sizes: {law: uniform, min: 0.2, max: 0.35}, material: a, region: {shape: box, lower: [0, 0, 0], upper: [4, 4, 10]}}
bodies:
  clumps: [{name: dumbbell, material: a, radius_above: 0.28, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]
  shapes: [{name: rock, material: b, random: {corners: 14, variants: 5}, roundness: 0.2}]
guards: {residual: off}
observables: {every: 20, list: [{name: energy}, {name: overlap_max}, {name: contact_solver}, {name: contacts}, {name: wall_force, target: floor}]}
output: {dump: {every: 500, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 500, keep: 9}}
YAML
quiet() { # DIR: the floor carries all, slowly enough
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next } { n++; f = $at["floor_fz"]; sum += n > 50 ? f : 0; count += n > 50; kinetic = $at["energy_kinetic"]; o = $at["overlap_max"]; if (o > most) most = o; contacts = $at["contacts"] }
        END { printf "  force %g, kinetic energy %.2g, overlap %.2g, contacts %d\n", sum / count, kinetic, most, contacts; exit !(kinetic < 0.1 && most < 0.1 && contacts > 60 && sum / count > -121 && sum / count < -99) }' "$1/observables.csv"
}
check 'a bed' run_scene 1 bed.yaml bed --set threads=1
check 'it comes to rest' quiet bed
bits() { rm -rf other && run_scene 1 bed.yaml other "$@" --set contact.solver.tolerance=0 --set contact.solver.sweeps=20 --set step.count=1000 && same fixed other; }
check 'a bed by twenty sweeps' run_scene 1 bed.yaml fixed --set threads=1 --set contact.solver.tolerance=0 --set contact.solver.sweeps=20 --set step.count=1000
check 'the same bits with 2 threads and another index' bits --set threads=2 --set index=linkcell
check 'after a resume' bits --set threads=1 --resume fixed/checkpoint-500.h5
check 'on 3 ranks it rests, too' run_scene 3 bed.yaml bed3 --set threads=1
check 'it does' quiet bed3
step() { # RANKS DIR SETTING...
    run_scene "$1" bed.yaml "$2" --overwrite --resume bed/checkpoint-1500.h5 --set threads=1 --set step.count=1501 --set output.dump.every=1 --set contact.solver='{sweeps: 20000, tolerance: 1e-12}' "${@:3}"
}
agrees() { # RANKS SETTING...: velocities to 1e-6 g dt
    step "$1" stepped "${@:2}" && paste <(rows exact) <(rows stepped) | awk '{ n = NF / 2; for (k = 6; k <= 8; k++) { d = $k - $(k + n); d = d < 0 ? -d : d; if (d > most) most = d } }
        END { printf "  %d particles differ by %.2g g dt\n", NR, most / 0.02; exit !(NR > 70 && most < 1e-6 * 0.02) }'
}
check 'a step solved to the end' step 1 exact
check 'the same on 2 ranks' agrees 2
check 'on 3 ranks, newton off' agrees 3 --set newton=false
check 'on 4 ranks by bisection' agrees 4 --set domain.name=bisection
declare -A sets=(
    [hertz]='contact.law=hertz
materials=[{name: a, density: 1, young: 1e5, poisson: 0.3}, {name: b, density: 2, young: 2e5, poisson: 0.2}]'
    [hooke]='contact.law=hooke
material_pairs=[{restitution: 0.3, friction: 0.4, k_n: 1e4}]'
    [stiff]='contact.solver={kappa: .inf, sweeps: 100}'
    [poisson]='contact.solver.restitution=poisson'
    [projection]='contact.solver.model=projection'
    [rolls]='contact.rolling=spring
material_pairs[0].rolling_friction=0.2'
    [belt]='walls[floor]={name: floor, shape: rectangle, point: [0, 0, 0], along: [6, 0, 0], across: [0, 6, 0], material: a, motion: [{kind: translate, surface: true, velocity: [0.5, 0, 0]}]}'
    [box]='walls[floor]={name: floor, shape: box, lower: [1, 1, -0.5], upper: [5, 5, 0.3], material: a, motion: [{kind: rotate, direction: [0, 0, 1], point: [3, 3, 0], rate: 1}]}
box.periodic=false'
    [comes]='insertions=[{region: {shape: box, lower: [0, 0, 6.5], upper: [6, 6, 7.8]}, sizes: 0.4, rate: 20, velocity: [0, 0, -1], material: b}]
deletions=[{region: {shape: box, lower: [0, 0, 0], upper: [6, 6, 1]}, every: 50}]'
    [stages]='step.count=~
stages=[{name: one, duration: 0.2}, {name: two, duration: 0.2, set: {gravity: [0.5, 0, -5]}}]'
    [lists]='output.trajectory={every: 100, contacts: {steps: 100}}')
together() { # RANKS NAME...
    local flags
    take crowd "${@:2}"
    rm -rf meets && run_scene "$1" crowd.yaml meets --set threads=1 "${flags[@]}" && sound meets
}
ranks=0
for names in hertz hooke stiff poisson projection rolls belt 'belt rolls hertz' 'comes stages' lists box; do
    ranks=$((ranks % 3 + 1))
    # shellcheck disable=SC2086 # words
    check "$names, ranks: $ranks" together $ranks $names
done
newton() { "$scree" check drop.yaml --set contact.solver.name=newton >said 2>&1; }
if newton; then
    by_newton() {
        run_scene 1 drop.yaml newton "${drop[@]}" --set contact.solver='{name: newton, tolerance: 1e-9}' && rests newton 1e-7
    }
    check "a cube rests by Newton's method" by_newton
    check "a step of the bed by Newton's method" agrees 1 --set contact.solver='{name: newton, sweeps: 10, tolerance: 1e-11, steps: 100}'
    check 'on 2 ranks' agrees 2 --set contact.solver='{name: newton, sweeps: 10, tolerance: 1e-11, steps: 100}'
else
    skip "Newton's method: without PETSc"
fi

# The step is that of the sphere inside: half of the edge of a cube, of a slab half of its thickness
step_of() { "$scree" check drop.yaml --set step.dt=~ --set step.speed_max=1 "$@" 2>&1 | sed -n 's/^time step *\([0-9.e+-]*\).*/\1/p'; }
thin() { within "$(step_of)" "$(awk 'BEGIN { printf "%.9f", 0.15 * sqrt(0.5 / 10) / 15 }')" 1e-5 &&
    within "$(step_of --set 'bodies.shapes[0].vertices=[0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,0.2, 1,0,0.2, 0,1,0.2, 1,1,0.2]')" "$(awk 'BEGIN { printf "%.9f", 0.15 * sqrt(0.1 / 10) / 15 }')" 1e-5; }
check 'the step follows the thickness' thin

refused() { # TEXT SETTING...
    on 1 "$scree" check drop.yaml "${@:2}" >said 2>&1
    [ $? = 2 ] && holds said "$1"
}
check 'refused: cohesion' refused 'is for spheres' --set contact.cohesion=dmt --set material_pairs[0].surface_energy=0.1
check 'refused: twisting' refused 'is for spheres' --set contact.twisting=sds --set material_pairs[0].twisting_friction=0.01 --set material_pairs[0].twisting_stiffness=10
check 'refused: files of loads on walls' refused 'output.walls' --set output.walls.every=10
finish
