#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Small scenes with a known outcome, through the whole program: plane against mesh, no data of friction without friction,
# particles that come and go, moving walls, guards, conversions, ablation.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# column FILE NAME: the last row's value of a column whose name begins so
column() {
    awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) if (index($k, name) == 1) at = k } END { if (at) print $at; else print "no column " name }' "$1"
}

echo '== plane against mesh'
# mesh COLUMNS ROWS: a table of triangles that tile [-2, 6] x [-2, 4] at z = 0
triangles() {
    awk -v nx="$1" -v ny="$2" 'BEGIN { for (i = 0; i < nx; i++) for (j = 0; j < ny; j++) {
        x = -2 + 8 * i / nx; X = -2 + 8 * (i + 1) / nx; y = -2 + 6 * j / ny; Y = -2 + 6 * (j + 1) / ny
        printf "%.17g %.17g 0 %.17g %.17g 0 %.17g %.17g 0\n", x, y, X, y, X, Y
        printf "%.17g %.17g 0 %.17g %.17g 0 %.17g %.17g 0\n", x, y, X, Y, x, Y } }'
}
triangles 1 1 >two.txt
triangles 25 20 >thousand.txt
cat >roll.yaml <<'EOF'
units: none
box: {lower: [-2, -2, -1], upper: [6, 4, 3]}
gravity: [0.5, 0.2, -10]
step: {dt: 0.0002, count: 10000}
contact: {law: hertz}
materials: [{name: soft, density: 1, young: 1e5, poisson: 0.25}]
material_pairs: [{restitution: 0.6, friction: 0.4}]
particles: {from: single, position: [0.1, 0.1, 0.7], radius: 0.5, velocity: [1, 0.3, 0], omega: [0, -3, 1]}
observables: {every: 20, list: [{name: position, id: 1}, {name: energy_rotational}]}
output: {checkpoint: {at_end: false}}
EOF
{ cat roll.yaml; echo 'walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]'; } >plane.yaml
for mesh in two thousand; do
    { cat roll.yaml; echo "walls: [{name: floor, shape: mesh, file: $mesh.txt}]"; } >$mesh.yaml
done
# same_path A B: x, y, z within 1e-9 of the radius at all rows
same_path() {
    paste -d, "$1/observables.csv" "$2/observables.csv" | awk -F, 'NR > 1 { for (k = 2; k <= 4; k++) {
        d = $k - $(k + NF / 2); d = d < 0 ? -d : d; if (!(d <= most)) most = d } }
        END { printf "  %d rows, largest difference %.2g of the radius\n", NR - 1, most / 0.5; exit !(NR == 502 && most <= 1e-9 * 0.5) }'
}
for run in plane two thousand; do
    check "$run runs" run_scene 1 $run.yaml $run
done
rolled() { # bounced, then rolls: in touch at the end, turned by friction, has come over several triangles
    within "$(column plane/observables.csv particle1_z)" 0.5 0.01 && [ "$(number plane/report.json contacts)" = 1 ] &&
        awk -v x="$(column plane/observables.csv particle1_x)" 'BEGIN { exit !(x > 1.4) }'
}
check 'the sphere bounced and rolls' rolled
check 'plane and 2 triangles' same_path plane two
check 'plane and 1,000 triangles' same_path plane thousand

echo '== a tube of facets against a cylinder'
# tube FACETS: three turns of an elastic ball within, at an overlap of 0.005 of its radius; the energy at the end over that at the start
tube() {
    local wall="{name: tube, shape: mesh, file: tube$1.txt}"
    [ "$1" != 0 ] || wall='{name: tube, shape: cylinder, point: [0, 0, 0], axis: [0, 1, 0], radius: 3}'
    awk -v n="$1" 'BEGIN { for (k = 0; k < n; k++) { a = 8 * atan2(1, 1) * k / n; b = 8 * atan2(1, 1) * (k + 1) / n
        x = 3 * cos(a); z = 3 * sin(a); X = 3 * cos(b); Z = 3 * sin(b)
        printf "%.17g -2 %.17g %.17g -2 %.17g %.17g 2 %.17g\n", x, z, X, Z, X, Z
        printf "%.17g -2 %.17g %.17g 2 %.17g %.17g 2 %.17g\n", x, z, X, Z, x, z } }' >"tube$1.txt"
    cat >"tube$1.yaml" <<EOF
units: none
box: {lower: [-4, -4, -4], upper: [4, 4, 4]}
gravity: [0, 0, 0]
step: {dt: 1e-3, count: 37800}
contact: {law: hooke, tangential: none}
materials: [{name: ball, density: 0.238732414637843}]
material_pairs: [{restitution: 1, k_n: 100}]
walls: [$wall]
particles: {from: single, position: [2.005, 0, 0], radius: 1, velocity: [0, 0, 1.0012492]}
observables: {every: 1260, list: [{name: energy_kinetic}, {name: energy_elastic_normal}]}
output: {checkpoint: {at_end: false}}
EOF
    run_scene 1 "tube$1.yaml" "tube$1" && awk -F, 'NR == 2 { first = $2 + $3 } END { printf "%.9g\n", ($2 + $3) / first }' "tube$1/observables.csv" >"tube$1.energy"
}
keeps() { # FACETS BOUND
    tube "$1" && echo "  $1 facets keep $(cat "tube$1.energy") of the energy" && within "$(cat "tube$1.energy")" "$(cat tube0.energy)" "$2"
}
check 'a cylinder keeps the energy' eval 'tube 0 && within "$(cat tube0.energy)" 1 1e-6'
check '720 facets keep it as the cylinder does' keeps 720 1e-4
check '1,440 facets, too' keeps 1440 1e-4
check '96 facets, nearly' keeps 96 5e-4
check '48 facets, of 7.5 degrees, too' keeps 48 5e-4
check '24 facets, of 15 degrees, to two per cent' keeps 24 0.02
notes() { # FACETS FLAG...: what `scree check` says of the edges
    "$scree" check --all "tube$1.yaml" "${@:2}" | grep "^NOTE: mesh 'tube' turns by"
}
noted() { notes 24 | grep -F 'turns by 15 degrees at edges' | grep -F 'more than 0.034 of its radius (expected: up to 0.1)' || { notes 24; return 1; }; }
check 'of which scree check tells' noted
check 'but not where overlaps are small' eval '! notes 24 --set material_pairs[0].k_n=10000'
check 'nor of edges that are smooth' eval '! notes 48'

echo '== without friction nothing of friction'
cat >smooth.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
gravity: [0, 0, -10]
step: {dt: 0.0005, count: 100}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 1000}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: random, count: 60, sizes: 0.6, velocity_sigma: 3}
output: {trajectory: {every: 50}}
EOF
check 'the scene runs' run_scene 1 smooth.yaml smooth
"$scree" check --all smooth.yaml >needs.txt 2>&1
"$scree" info smooth/trajectory.h5 >inside.txt 2>&1
"$scree" info smooth/checkpoint-100.h5 >kept.txt 2>&1
not_needed() {
    local field
    for field in angular_velocity torque; do
        grep -q "^ *$field  *-  *not needed" needs.txt || { echo "  $field is needed:"; cat needs.txt; return 1; }
        lacks inside.txt $field && lacks kept.txt $field || return 1
    done
    holds needs.txt 'history: none' && lacks kept.txt /history && lacks kept.txt /wall_history && holds inside.txt velocity && holds kept.txt /particles/force
}
check 'no spin, torque and history in memory and files' not_needed

echo '== particles come and go'
cat >flow.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 10], leave: {z_lower: delete}}
gravity: [0, 0, -10]
step: {dt: 0.001, count: 3000}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, friction: 0.3, k_n: 1000}]
insertions: [{region: {shape: box, lower: [0, 0, 8], upper: [4, 4, 10]}, sizes: 0.3, rate: 20, count: 25, velocity: [0, 0, -1]}]
output: {checkpoint: {at_end: false}}
EOF
came_and_went() { # 25 in 1.25 s; a fall of 10 takes less than 1.5 s
    run_scene "$1" flow.yaml flow$1 || return 1
    [ "$(number flow$1/report.json inserted)" = 25 ] && [ "$(number flow$1/report.json deleted)" = 25 ] && [ "$(number flow$1/report.json particles)" = 0 ]
}
check 'inserted, and deleted where they leave' came_and_went 1
check 'so on two ranks' came_and_went 2
emptied() {
    run_scene 1 smooth.yaml emptied --set step.count=1 --set 'deletions=[{region: {shape: box, lower: [0, 0, 0], upper: [10, 10, 5]}, every: 1}]' &&
        run_scene 1 smooth.yaml full --set step.count=1 --set observables.every=1 --set 'observables.regions=[{name: low, shape: box, lower: [0, 0, 0], upper: [10, 10, 5]}]' \
            --set 'observables.list=[{name: count, target: low}]' || return 1
    local low
    low=$(column full/observables.csv count)
    [ "$low" -gt 5 ] && [ "$(number emptied/report.json deleted)" = "$low" ] && [ "$(number emptied/report.json particles)" = $((60 - low)) ]
}
check 'a deletion region takes those inside' emptied
cat >leave.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
step: {dt: 0.01, count: 150, force: true, rebuild_every: 10}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 1000}]
particles: {from: single, position: [2, 2, 2], radius: 0.5, velocity: [3, 0, 0]}
observables: {every: 150, list: [{name: position, id: 1}]}
EOF
left_kept() {
    run_scene "$1" leave.yaml left$1 && [ "$(number left$1/report.json particles)" = 1 ] && within "$(column left$1/observables.csv particle1_x)" 6.5 1e-9
}
check 'a particle that leaves is kept' left_kept 1
check 'so on two ranks' left_kept 2
left_deleted() {
    run_scene "$1" leave.yaml gone$1 --set box.leave=delete && [ "$(number gone$1/report.json particles)" = 0 ] && [ "$(number gone$1/report.json deleted)" = 1 ]
}
check 'a particle that leaves is deleted' left_deleted 1

# stops DIR WORDS COMMAND...: exit status 3, one message with the words, a checkpoint and a report to look at
stops() {
    local dir=$1 words=$2 status word
    shift 2
    on 1 "$@" >"$out/said" 2>&1
    status=$?
    [ $status = 3 ] && [ "$(wc -l <"$out/said")" = 1 ] || { echo "  status $status"; cat "$out/said"; return 1; }
    for word in 'scree: ' $words; do
        holds "$out/said" "$word" || return 1
    done
    "$scree" info "$dir"/checkpoint-*-stopped.h5 | grep -q whole && [ -e "$dir/report.json" ]
}
check 'a particle that leaves is an error' stops wrong 'particle upper box.leave' \
    "$scree" run leave.yaml -o wrong --quiet --set box.leave=error

echo '== guards'
cat >guard.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
step: {dt: 0.001, count: 2000, force: true}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 0.1}]
particles:
  sources:
    - {from: single, id: 71, position: [3, 5, 5], radius: 1, velocity: [2, 0, 0]}
    - {from: single, id: 83, position: [7, 5, 5], radius: 1, velocity: [-2, 0, 0]}
output: {trajectory: {every: 100}}
EOF
check 'an overlap beyond the bound stops' stops deep 'guards.overlap 71 83' "$scree" run guard.yaml -o deep --quiet
readable() { "$scree" info deep/trajectory.h5 | grep -q position; }
check 'the trajectory up to the stop is readable' readable
check 'a particle that is too fast stops' stops fast 'guards.speed particle 71' "$scree" run guard.yaml -o fast --quiet \
    --set guards.speed=stop --set 'particles.sources[0].velocity=[2000, 0, 0]'
warned() {
    run_scene 1 guard.yaml warned --set guards.overlap=warn && [ "$(grep -c 'scree: warning: guards.overlap' "$out/said")" = 1 ]
}
check 'a guard that warns does so once' warned

echo '== the stable step'
# light FILE SOURCES: spheres of radius 10 and density 1 that nearly touch, and others of the same material
light() {
    cat >"$1" <<EOF
units: none
box: {lower: [0, 0, 0], upper: [100, 100, 100]}
step: {count: 1}
contact: {law: hertz}
materials: [{name: stone, density: 1000, young: 1e7, poisson: 0.3}]
material_pairs: [{restitution: 0.9, friction: 0.0}]
particles:
  sources:
    - {from: single, position: [50, 50, 50], radius: 10, density: 1, velocity: [0, 0, 1]}
    - {from: single, position: [50, 50, 70], radius: 10, density: 1}
$2
EOF
}
light light.yaml ''
light heavy.yaml '    - {from: single, position: [30, 30, 30], radius: 1}'
stable() {
    "$scree" check --all "$1" | sed -n 's/^ *stable  *\([-0-9.e+]*\) .*/\1/p'
}
no_longer() { # small dense spheres beside them give no leave for a longer step
    awk -v alone="$(stable light.yaml)" -v beside="$(stable heavy.yaml)" 'BEGIN {
        good = alone > 0 && beside > 0 && beside <= alone
        if (!good) print "  stable step " alone " alone, " beside " beside dense spheres"
        exit !good }'
}
check 'the lightest spheres of a material decide' no_longer
# price FRACTION: the share of the steps, and the error of an impact in %, that the last check tells of at this part of the stable step
price() { awk -v part="$1" '$1 == part && $NF == "%" { print $2, $3 } $1 == part && $NF == "studied" { print $2, "unknown" }' told; }
price_of_step() { # the default, 0.15, against 0.9; 0.3 against 0.9; nothing beyond 0.9
    "$scree" check --all light.yaml >told && [ "$(price 0.15)" = '1 0.21' ] && [ "$(price 0.5)" = '0.3 0.75' ] && [ "$(price 0.9)" = '0.17 1.5' ] || { cat told; return 1; }
    "$scree" check --all light.yaml --set step.fraction=0.3 >told && [ "$(price 0.3)" = '1 0.5' ] && [ "$(price 0.5)" = '0.6 0.75' ] || { cat told; return 1; }
    "$scree" check --all light.yaml --set step.fraction=0.9 >told && [ "$(price 0.9)" = '1 1.5' ] && [ "$(grep -c '%$' told)" = 1 ] || { cat told; return 1; }
}
check 'check says what the step costs' price_of_step
price_of_cohesion() { # the larger of the law's error and the cohesion's; between the parts studied along a power of the step
    "$scree" check --all light.yaml --set contact.cohesion=jkr --set 'material_pairs[0].surface_energy=1e-9' >told && [ "$(price 0.15)" = '1 0.75' ] && holds told "cohesion stronger than the study's has larger ones" || { cat told; return 1; }
    "$scree" check --all light.yaml --set step.fraction=0.2 >told && [ "$(price 0.2)" = '1 0.3' ] || { cat told; return 1; }
}
check 'with cohesion, and between the steps of the study' price_of_cohesion
studied() { # the study again, for the impacts that decide the figures of Hertz's law and of Hooke's
    local name law
    for name in 'hertz, restitution 0.5' 'hooke, restitution 0.5'; do
        law=${name%%,*}
        STEP_IMPACT=$name STEP_FRACTION_OUT=$out/study SCREE=$scree bash "$top_srcdir/examples/step-fraction.sh" impacts >study.tsv || return 1
        error=$(awk -F'\t' '{ print 100 * $4 }' study.tsv)
        case $law in
        hooke) "$scree" check --all light.yaml --set contact.law=hooke --set 'materials=[{name: any, density: 1}]' --set 'material_pairs=[{restitution: 0.5, k_n: 1000}]' >told ;;
        hertz) "$scree" check --all light.yaml >told ;;
        esac
        within "$(price 0.15 | cut -d ' ' -f 2)" "$error" 0.02 || { cat told study.tsv; return 1; }
    done
}
check 'as the study finds it' studied

echo '== moving walls'
cat >oscillate.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
step: {dt: 0.001, count: 250, force: true}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 1000}]
walls: [{name: floor, shape: plane, point: [0, 0, 1], normal: [0, 0, 1], motion: [{kind: oscillate, direction: [0, 0, 1], amplitude: 0.2, frequency: 1, start: 0}]}]
particles: {from: single, position: [5, 5, 5], radius: 1}
observables: {every: 250, list: [{name: wall_offset, target: floor}]}
EOF
oscillated() { # a quarter of a cycle
    run_scene 1 oscillate.yaml oscillate && within "$(column oscillate/observables.csv floor_z)" 0.2 1e-9
}
check 'an oscillating wall stands at its amplitude after a quarter' oscillated
turned() { # its centre stays where it is, wherever the box begins
    run_scene 1 oscillate.yaml turned --set 'box={lower: [-3, -4, -5], upper: [10, 10, 10]}' \
        --set 'walls[0].motion=[{kind: rotate, direction: [0, 1, 0], point: [0, 0, 1], rate: 1}]' || return 1
    within "$(column turned/observables.csv floor_x)" 0 1e-9 && within "$(column turned/observables.csv floor_z)" 0 1e-9
}
check 'a wall that turns about its centre has not moved' turned
printf '0 0 0 0 0 0 0\n0.5 0.4 0 0.2 0 0 0\n' >path.txt
tabled() {
    run_scene 1 oscillate.yaml tabled --set 'walls[0].motion=[{kind: table, file: path.txt}]' || return 1
    within "$(column tabled/observables.csv floor_x)" 0.2 1e-9 && within "$(column tabled/observables.csv floor_z)" 0.1 1e-9
}
check 'a wall stands half-way between two rows of its table' tabled
swung() { # turned by 90 degrees about y through (4, 5, 3) the floor is the plane x = 2; forces by hand
    local expected list='{name: wall_force, target: floor}, {name: wall_torque, target: floor}, {name: wall_offset, target: floor}'
    run_scene 1 oscillate.yaml swung --set units=si --set material_pairs[0].restitution=1 --set "observables.list=[$list]" \
        --set 'walls[0]={name: floor, shape: plane, point: [5, 8, 1], normal: [0, 0, 1], motion:
            [{kind: oscillate_rotation, direction: [0, 2, 0], point: [4, 5, 3], angle: 90 deg, frequency: 1}]}' \
        --set 'groups=[{name: still, motion: frozen}]' \
        --set 'particles={from: single, position: [2.95, 8, 7], radius: 1, group: still}' || return 1
    for expected in fx:-50 fy:0 fz:0 tx:0 ty:-200 tz:150 x:0 y:0 z:0; do
        within "$(column swung/observables.csv "floor_${expected%:*}")" "${expected#*:}" 1e-6 || return 1
    done
}
check 'a wall that swings stands at its angle after a quarter' swung
cat >pressed.yaml <<'EOF'
units: none
box: {lower: [-3, -4, -5], upper: [13, 10, 10]}
step: {dt: 0.0005, count: 40}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, friction: 0.5, k_n: 1000}]
walls: [{name: floor, shape: plane, point: [5, 4, 1], normal: [0, 0, 1], motion: [{kind: translate, velocity: [0.75, -0.5, 0.25]}]}]
particles:
  sources:
    - {from: single, position: [2, 6, 1.97], radius: 1}
    - {from: single, position: [9, 5, 1.48], radius: 0.5}
observables:
  every: 40
  list: [{name: wall_force, target: floor}, {name: wall_torque, target: floor}, {name: wall_velocity, target: floor}, {name: speed_max},
    {name: position, id: 1}, {name: velocity, id: 1}, {name: force, id: 1}, {name: position, id: 2}, {name: velocity, id: 2}, {name: force, id: 2}]
EOF
pressed() { # RANKS: (middle of the overlap - centre) x force, where the floor has come to in 0.02
    run_scene "$1" pressed.yaml pressed$1 && awk -F, '
        function value(name) { if (!(name in at)) bad = "no " name; return $at[name] }
        function same(name, expected) { d = value(name) - expected; if (!(d < 1e-8 && d > -1e-8)) bad = name " is " value(name) ", not " expected }
        NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } }
        END { for (p = 1; p <= 2; p++) { one = "particle" p "_"
                x = value(one "x") - 5.015; y = value(one "y") - 3.99; z = (value(one "z") - (p == 1 ? 1 : 0.5) - 1.005) / 2
                fx = -value(one "fx"); fy = -value(one "fy"); fz = -value(one "fz")
                force += fz; tx += y * fz - z * fy; ty += z * fx - x * fz; tz += x * fy - y * fx
                speed = sqrt(value(one "vx") ^ 2 + value(one "vy") ^ 2 + value(one "vz") ^ 2); fastest = speed > fastest ? speed : fastest }
            same("floor_fz", force); same("floor_tx", tx); same("floor_ty", ty); same("floor_tz", tz); same("speed_max", fastest)
            same("floor_vx", 0.75); same("floor_vy", -0.5); same("floor_vz", 0.25)
            if (!bad && (force > -20 || tz * tz < 1 || fastest < 0.01)) bad = "too little: " $0
            if (bad) print "  " bad; exit bad != "" }' "pressed$1/observables.csv"
}
check 'torque and velocity of a moving wall, and the largest speed' pressed 1
check 'so on two ranks' pressed 2
cat >servo.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
step: {dt: 0.0005, count: 6000}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.3, k_n: 1000}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 1], normal: [0, 0, 1]}
  - {name: lid, shape: plane, point: [0, 0, 3.1], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, 0, 1], force: 20, speed_max: 0.1}]}
particles: {from: single, position: [5, 5, 2], radius: 1}
observables: {every: 6000, list: [{name: wall_force, target: lid}]}
EOF
pushed() {
    run_scene "$1" servo.yaml servo$1 && within "$(column servo$1/observables.csv lid_fz)" 20 0.5
}
check 'a servo finds its force' pushed 1
check 'so on two ranks' pushed 2
steady() { # where the contact's damper answers the gain with 23 times the force sought
    run_scene 1 servo.yaml steady --set walls[1].motion[0].speed_max=10 --set walls[1].motion[0].gain=10 --set observables.every=7 || return 1
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^lid_fz/) column = k } NR > 800 { rows++; if ($column < 19.5 || $column > 20.5) { bad = $column } }
        END { if (bad) print "  force " bad; exit !(rows > 20) || bad }' steady/observables.csv
}
check 'it holds it without chatter' steady
cat >column.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [5, 4, 12], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {dt: 0.0005, count: 16000}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.4, k_n: 10000}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: lid, shape: plane, point: [0, 0, 12], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, 0, 1], pressure: 30, speed_max: 5}]}
particles: {from: random, count: 100, sizes: {law: uniform, min: 0.4, max: 0.6}}
observables: {every: 4000, list: [{name: wall_force, target: lid}, {name: wall_force, target: floor}, {name: solid_volume, target: all}], regions: [{name: all, shape: box, lower: [0, 0, -1], upper: [5, 4, 13]}]}
EOF
weighed() { # a column at rest: the lid carries pressure x section, the floor the weight besides
    run_scene "$1" column.yaml column$1 && within "$(column column$1/observables.csv lid_fz)" 600 0.01 &&
        within "$(column column$1/observables.csv floor_fz)" "$(awk -v m="$(column column$1/observables.csv solid_volume)" 'BEGIN { print -600 - 10 * m }')" 0.06
}
check 'a pressure is force over the section of the box' weighed 1
mesh_lid() { # a plate of half the section instead, and half the force
    printf '0 0 0 5 0 0 0 2 0\n5 0 0 5 2 0 0 2 0\n' >half.txt
    run_scene 1 column.yaml half --set 'walls[1]={name: lid, shape: mesh, file: half.txt, offset: [0, 1, 12], motion: [{kind: servo, direction: [0, 0, 1], pressure: 30, speed_max: 5}]}' &&
        within "$(column half/observables.csv lid_fz)" 300 0.06
}
check 'and over a plate of triangles' mesh_lid

echo '== insertion'
cat >clear.yaml <<'EOF'
box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm]}
step: {count: 1000}
contact: {law: hertz}
materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
walls:
  - {shape: plane, point: [5 mm, 5 mm, 4 mm], normal: [1, 0, 2]}
  - {shape: cylinder, point: [5 mm, 5 mm, 5 mm], axis: [0, 0, 1], radius: 4 mm, inside: true}
particles: {from: single, position: [5 mm, 5 mm, 8 mm], radius: 0.5 mm}
insertions: [{rate: 1e6, count: 40, sizes: 0.4 mm, attempts: 100}]
observables: {every: 1, list: [{name: energy}]}
EOF
still() { # without gravity nothing moves, and nothing is squeezed
    run_scene "$1" clear.yaml clear$1 && [ "$(number clear$1/report.json inserted)" = 40 ] &&
        [ "$(column clear$1/observables.csv energy_kinetic)" = 0 ] && [ "$(column clear$1/observables.csv energy_elastic_normal)" = 0 ]
}
check 'particles appear clear of walls and of each other' still 1
check 'so on two ranks' still 2
placed() { # those that are there from the start, too
    run_scene 1 clear.yaml placed --set 'insertions=~' --set 'particles={from: random, count: 60, sizes: 0.4 mm}' --set step.count=1 &&
        [ "$(number placed/report.json particles)" = 60 ] && [ "$(column placed/observables.csv energy_elastic_normal)" = 0 ]
}
check 'particles placed at random are clear of walls' placed
check 'the report tells that all are placed' holds clear2/report.json '{"name": "insertions[0]", "asked": 40, "placed": 40, "lost": 0}'
crowded() {
    on 1 "$scree" run clear.yaml -o crowded --set 'insertions=[{name: rain, rate: 1e9, count: 400, sizes: 1 mm, attempts: 2}]' \
        >said 2>&1 || { cat said; return 1; }
    local placed
    placed=$(number crowded/report.json inserted)
    [ "$placed" -gt 0 ] && [ "$placed" -lt 360 ] &&
        holds crowded/report.json "{\"name\": \"rain\", \"asked\": 400, \"placed\": $placed, \"lost\": 0}" &&
        holds said "insertion rain: $placed of the 400 particles due are placed: NOTE"
}
check 'and that many are not' crowded
cat >lid.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10], leave: {all: delete}}
step: {count: 200, dt: 1e-3}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 1000}]
particles: {from: lattice, lattice: sc, spacing: 2, sizes: 0.4, count: 12, region: {shape: box, lower: [1, 1, 1], upper: [9, 9, 4]}}
insertions: [{sizes: 0.2, rate: 500, region: {shape: box, lower: [0, 0, 6], upper: [10, 10, 14]}}]
walls: [{name: lid, shape: plane, point: [0, 0, 5], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, 0, 1], force: 5, speed_max: 1}]}]
YAML
lost() { # RANKS: what check foretells, what the run tells, and what it counts
    local k lost
    on "$1" "$scree" check --all lid.yaml --set walls=[] >said 2>&1 && holds said 'warning: insertions[0].region reaches out of the box at its upper z side, by up to 3.8' || return 1
    on "$1" "$scree" run lid.yaml -o lost --overwrite --set walls=[] >said 2>&1 && holds said 'scree: warning: insertions[0].region reaches out' || return 1
    lost=$(number lost/report.json insertions[0].lost)
    [ "$lost" -gt 20 ] && holds said "particles due are placed: NOTE: $lost of them outside of the box" || return 1
    [ "$(number lost/report.json deleted)" -gt 0 ]
}
check 'an insertion out of the box is told' lost 1
check 'so on two ranks' lost 2
pushed() { # WORDS|LACKS WORD SETTING...: of the end of the run
    local which=$1 word=$2
    shift 2
    on 2 "$scree" run lid.yaml -o pushed --overwrite --set insertions=[] "$@" >said 2>&1 || { cat said; return 1; }
    "$which" said "$word"
}
check 'a servo that meets nothing is told' pushed holds "nothing pushed on wall 'lid' in the last 200 steps. Its servo moved it by -0.19"
check 'one that meets grains is not' pushed lacks 'nothing pushed' --set walls[0].point='[0, 0, 1.8]'

echo '== conversions'
shape() { # without title and image counts
    tail -n +2 "$1" | cut -d ' ' -f 1-7
}
round_trip() { # H5MD -> LAMMPS data -> H5MD -> LAMMPS data
    "$scree" convert smooth/trajectory.h5 a.data >said 2>&1 && "$scree" convert a.data b.h5 >>said 2>&1 && "$scree" convert b.h5 b.data >>said 2>&1 || { cat said; return 1; }
    [ "$(grep -c . a.data)" -gt 60 ] && diff <(shape a.data) <(shape b.data)
}
check 'H5MD to LAMMPS data and back' round_trip
dumped() {
    "$scree" convert smooth/trajectory.h5 frames.lammpstrj >said 2>&1 && [ "$(grep -c 'ITEM: TIMESTEP' frames.lammpstrj)" = 3 ] && [ "$(wc -l <frames.lammpstrj)" = $((3 * 69)) ]
}
check 'H5MD to a dump, frame by frame' dumped
one_frame() { # NUMBER LINES of all frames
    "$scree" convert smooth/trajectory.h5 one.lammpstrj --overwrite --frame "$1" >said 2>&1 || { cat said; return 1; }
    [ -s one.lammpstrj ] && diff one.lammpstrj <(sed -n "$2p" frames.lammpstrj)
}
check 'one frame by its number' one_frame 1 70,138
check 'and from the end' one_frame -3 1,69
# Two particles in two frames: the second may show others, or other values of the same
frame() { # STEP LINE LINE
    printf 'ITEM: TIMESTEP\n%s\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 10\n0 10\n0 10\n' "$1"
    printf 'ITEM: ATOMS id type radius mass x y z\n%s\n%s\n' "$2" "$3"
}
values_of() { # id, type, radius and mass of each particle of a dump
    awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; rows = 1; next } /^ITEM/ { rows = 0 }
        rows { print $at["id"], $at["type"], $at["radius"], $at["mass"] }' "$1"
}
changes() { # SECOND FRAME: dump -> H5MD -> dump keeps it
    { frame 0 '1 1 1 4 2 2 2' '2 1 1 4 5 5 5' && frame 10 "$@"; } >changing.lammpstrj
    "$scree" convert changing.lammpstrj changing.h5 --overwrite >said 2>&1 &&
        "$scree" convert changing.h5 changed.lammpstrj --overwrite >>said 2>&1 || { cat said; return 1; }
    [ "$(values_of changed.lammpstrj | wc -l)" = 4 ] && diff <(values_of changing.lammpstrj) <(values_of changed.lammpstrj)
}
check 'particles that are others, as many as before' changes '2 1 1 4 5 5 5' '3 1 1 4 8 8 8'
check 'a radius that changes' changes '1 1 0.5 4 2 2 2' '2 1 1 4 5 5 5'
check 'a mass that changes' changes '1 1 1 4 2 2 2' '2 1 1 3 5 5 5'
check 'a material that changes' changes '1 1 1 4 2 2 2' '2 2 1 4 5 5 5'
fixed_once() {
    changes '1 1 1 4 3 3 3' '2 1 1 4 6 6 6' && holds changing.xdmf 'changing.h5:/particles/all/radius<'
}
check 'what stays the same is written once' fixed_once
again() { # what was converted is a source of particles
    run_scene 1 smooth.yaml again --set step.count=1 --set 'particles={file: a.data, format: lammps-data}' && [ "$(number again/report.json particles)" = 60 ]
}
check 'the data file is a source of particles' again
told() { holds inside.txt 60 && holds kept.txt 'step       100' && "$scree" info a.data | grep -q 60; }
check 'info tells what is inside' told

echo '== ablation'
ablated() {
    on 1 "$scree" ablate smooth.yaml -o table --threads 1 --steps 25 >said 2>&1 || { cat said; return 1; }
    awk -F, -v all="$(indexes | wc -w)" 'NR == 1 { columns = NF; for (k = 1; k <= NF; k++) if ($k == "pairs") at = k; next } NF != columns || !at || seen[$1 "," $2 "," $4]++ { bad = 1 } { pairs[$at]++; index_[$1]++; newton[$2]++ }
        END { for (p in pairs) different++; for (i in index_) indexes++; for (n in newton) newtons++
            exit !(NR == 1 + 2 * all && !bad && different == 1 && indexes == all && all >= 6 && newtons == 2) }' table/*.csv || { cat table/*.csv; return 1; }
}
check 'a row a variant, the same pairs in each' ablated


# Discs: in two dimensions `density` may be a mass over the area of a disc, of materials, sources and insertions, also after a resume with another
cat >discs.yaml <<'YAML'
box: {dimension: 2, density: area, lower: [0, 0], upper: [1, 1]}
step: {count: 100, dt: 10 us}
contact: {law: hooke}
materials: [{name: a, density: 5 kg/m2}]
material_pairs: [{k_n: 1000, restitution: 0.9}]
groups: [{name: some, motion: free, select: {radius_above: 25 cm}}]
particles:
  sources:
    - {from: single, position: [0.2, 0.2], radius: 0.1}
    - {from: single, position: [0.7, 0.3], radius: 0.3}
    - {from: single, position: [0.2, 0.5], radius: 0.1, density: 8000 g/m2}
insertions: [{sizes: 0.05, rate: 1 MHz, count: 1, density: 6, region: {shape: box, lower: [0.1, 0.8], upper: [0.9, 0.95]}}]
output: {dump: {every: 100, fields: [id, mass]}, checkpoint: {every: 100}}
YAML
masses() { # DIR M1 M2 M3 M4: as densities of discs
    tail -n 4 "$1/dump.lammpstrj" | sort -n | awk -v want="$2 $3 $4 $5" 'BEGIN { split(want, w, " "); split("0.1 0.3 0.1 0.05", r, " "); pi = atan2(0, -1) }
        { d = $3 / (w[NR] * pi * r[NR]^2) - 1; if (d > 1e-12 || d < -1e-12) { bad = 1; print } } END { exit NR != 4 || bad }'
}
discs() { run_scene 1 discs.yaml discs && masses discs 5 5 8 6; }
check 'discs: mass over area' discs
discs_resumed() { run_scene 2 discs.yaml denser --resume discs/checkpoint-100.h5 --set step.count=200 --set 'materials[a].density=7' --set output.dump.every=200 && masses denser 7 7 8 6; }
check 'discs: another density at a resume, on 2 ranks' discs_resumed
refused_discs() { # TEXT COMMAND...
    ! "$scree" "${@:2}" >told 2>&1 && grep -qF -- "$1" told || { cat told; return 1; }
}
printf 'box: {density: area, lower: [0, 0, 0], upper: [1, 1, 1]}\ncontact: {law: hooke}\nmaterials: [{name: a, density: 5}]\nmaterial_pairs: [{k_n: 1000, restitution: 0.9}]\nparticles: {from: single, position: [0.5, 0.5, 0.5], radius: 0.1}\nstep: {count: 1, dt: 10 us}\n' >balls.yaml
check 'discs: not in three dimensions' refused_discs 'box.density: area needs box.dimension: 2' check balls.yaml
check 'discs: the unit' refused_discs 'materials[0].density' check discs.yaml --set 'materials[a].density=5 kg/m3'
check 'discs: what density means stays at a resume' refused_discs 'box.density must stay' run discs.yaml -o volume --resume discs/checkpoint-100.h5 --set box.density=volume --set 'materials[a].density=5' --set 'particles.sources[2].density=8' --set step.count=200
echo_discs() { "$scree" check discs.yaml >told && holds told 'density x pi r^2 (box.density: area)' && lacks told 'density of a gas'; }
check 'discs: check tells it' echo_discs
finish
