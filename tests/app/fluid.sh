#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A fluid in a run: the same operators on all ranks, threads and indexes, the same flow on all ranks, restart, steady and
# transient flow past a sphere, and scenes that make no sense. The closed forms are cases of examples/verify.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >sphere.yaml <<'YAML'
units: none
box: {lower: [-1, 0, 2], upper: [0, 1, 3], periodic: true}
particles: {from: single, position: [-0.9, 0.1, 2.05], radius: 0.31, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.0833333333333333333
  density: 1
  viscosity: 1
  equations: stokes
  drive: {body_force: [1, 0, 0]}
  initial: {flow: uniform, velocity: [1, 0.5, 0.25]}
step: {dt: 0.02, count: 3}
observables: {every: 1, list: [{name: fluid}]}
output: {dump: {every: 3, fields: [id, velocity, pressure, divergence, vorticity, drag]}}
YAML
cat >channel.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [0.5, 1, 0], periodic: [true, false, false], dimension: 2}
walls:
  - {name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: upper, shape: plane, point: [0, 1, 0], normal: [0, -1, 0], motion: [{kind: translate, velocity: [1, 0, 0]}]}
fluid: {spacing: 0.0625, density: 1, viscosity: 0.1, drive: {body_force: [1, 0, 0]}}
step: {dt: 0.02, count: 12}
observables: {every: 1, list: [{name: fluid}]}
output: {checkpoint: {every: 6}, dump: {every: 12, fields: [id, velocity, pressure, divergence, vorticity, drag]}}
YAML

needs_petsc channel.yaml 'fluid'

# The first frame, by id: velocity, pressure, divergence, vorticity, viscous forces, and the row of observables.
frame() { # DIR
    frames "$1" 1
    tail -n 1 "$1/observables.csv" | tr , ' '
}
frames() { # DIR NUMBER: id, type and 11 numbers a particle
    awk -v number="$2" '/^ITEM: TIMESTEP/ { n++ } n == number && !/^ITEM/ && NF == 13' "$1/dump.lammpstrj" | sort -n
}
same() { # FILE FILE: the numbers are of order 10; larger ones beside a surface that nearly touches a node
    awk -v bound=2e-11 'NR == FNR { line[FNR] = $0; n = FNR; next }
        { split(line[FNR], a); for (k = 1; k <= NF; k++) { d = $k - a[k]; d = d < 0 ? -d : d; e = a[k] < 0 ? -a[k] : a[k]; if (!(d <= bound * (1 + e / 20))) bad++ } m = FNR }
        END { printf "  %d rows, %d differ\n", n, bad; exit !(n == m && n > 1000 && bad == 0) }' "$1" "$2"
}
operators() { # RANKS THREADS SETTING...
    local ranks=$1 threads=$2
    shift 2
    rm -rf run
    run_scene "$ranks" sphere.yaml run --set "threads=$threads" --set step.count=0 "$@" && frame run >frame && same first frame
}
rm -rf run
check "one rank, brute: the first frame" run_scene 1 sphere.yaml run --set index=brute --set step.count=0
frame run >first
check "it has a divergence, and a force on the grain" awk '
    NF == 13 && ($13 > 1 || $13 < -1) { d++ } NF == 13 && ($9 > 1 || $9 < -1) { c++ } NF == 13 && $6 < -1e-3 { f++ }
    NF > 13 && $7 > 1 { g++ } END { exit !(d > 50 && c > 50 && f > 50 && g == 1) }' first
for index in linkcell ${SCREE_LONG:+multi bytype} hgrid auto; do
    check "index $index, 2 threads" operators 1 2 --set "index=$index"
done
check "2 ranks x 2 threads" operators 2 2
check_long "3 ranks, brute" operators 3 1 --set index=brute
check "4 ranks, hgrid" operators 4 1 --set index=hgrid
check_long "8 ranks" operators 8 1
check "2 ranks, reproducible order of sums" operators 2 1 --set newton=false
displaced=(--set fluid.fill.jitter=0.2 --set fluid.kernel.support=2.8)
rm -rf run
check "displaced particles, whose volumes differ: one rank" run_scene 1 sphere.yaml run --set index=brute --set step.count=0 "${displaced[@]}"
frame run >first
check "displaced particles: the same operators on 3 ranks" operators 3 1 "${displaced[@]}"
displaced+=(--set fluid.time=steady) # moving least squares go with it
check "displaced particles: moving least squares are other operators" eval '! operators 1 1 "${displaced[@]}" --set fluid.operators=mls'
rm -rf run
check "moving least squares: one rank" run_scene 1 sphere.yaml run --set index=brute --set step.count=0 "${displaced[@]}" --set fluid.operators=mls
frame run >first
check "moving least squares: 3 ranks, hgrid" operators 3 1 "${displaced[@]}" --set fluid.operators=mls --set index=hgrid

rm -rf run
check "body-centred lattice: one rank" run_scene 1 sphere.yaml run --set index=brute --set step.count=0 --set fluid.fill.arrangement=bcc
frame run >first
check "body-centred lattice: the same operators on 3 ranks, hgrid" operators 3 1 --set fluid.fill.arrangement=bcc --set index=hgrid
check "body-centred lattice: check tells its steps" eval '"$scree" check --all sphere.yaml --set fluid.fill.arrangement=bcc >said 2>&1 && grep -q "lattice *steps of 0.05, 0.05, 0.05: stretched by 0.048" said && grep -q "neighbours *2[0-9.]* a fluid particle" said'

# A lattice that is stretched to fit the box fills it: even flow has its velocity, energy and the porosity 1
stretched() {
    rm -rf run
    on 1 "$scree" check --all channel.yaml "$@" >told 2>&1 && grep -q 'lattice .*: stretched by 0.0[0-9]* to fit the box' told || { cat told; return 1; }
    run_scene 1 channel.yaml run --set threads=1 "$@" && within "$(last_of run fluid_velocity_x)" 1 1e-12 && within "$(last_of run fluid_velocity_y)" 0.5 1e-12 &&
        within "$(last_of run fluid_porosity)" 1 1e-12 && within "$(last_of run fluid_energy)" 0.625 1e-12
}
check "a stretched lattice: the flow has its mean velocity" stretched --set 'walls=[]' --set box.periodic=true --set fluid.fill.arrangement=hexagonal --set fluid.drive=~ \
    --set fluid.initial.velocity='[1, 0.5, 0]' --set step.count=0 --set output.dump=~

# close FILE FILE: last rows agree to 1e-5 of the flow (the solver's tolerance); ranks may take other numbers of iterations
close() {
    paste -d , <(tail -n 1 "$1") <(tail -n 1 "$2") | awk -F , -v head="$(head -n 1 "$1")" '{ m = NF / 2; split(head, name, ",")
        for (k = 1; k <= m; k++) { if (name[k] ~ /iterations|residual/) continue; d = $k - $(k + m); if (d * d > 1e-10 * ($2 * $2 + 1e-4)) { print "  column", k, $k, $(k + m); bad = 1 } } exit bad }'
}
# near DIR DIR FRAME BOUND: velocities, forces, vorticities and pressures of all particles agree to a part of the largest of their kind,
# pressures, of which the steady solver knows less, to 20 times this part
near() {
    frames "$1" "$3" >one.frame
    frames "$2" "$3" >other.frame
    paste -d ' ' one.frame other.frame | awk -v bound="$4" '
        function size(x) { return x < 0 ? -x : x }
        { for (k = 3; k <= 12; k++) { g = k < 6 ? 1 : k < 9 ? 2 : k < 12 ? 3 : 4; a = size($k); d = size($k - $(k + 13))
            if ($1 != $14) bad = 1; if (a > most[g]) most[g] = a; if (d > gap[g]) gap[g] = d } }
        END { for (g = 1; g <= 4; g++) { if (!(gap[g] <= bound * (g < 4 ? 1 : 20) * most[g] + 1e-12)) bad = 1
                printf " %.1e of %.2g,", gap[g], most[g] }
            print " " NR " particles"; exit bad || NR < 100 }'
}
flows() { # RANKS SCENE BOUND SETTING...
    local ranks=$1 scene=$2 bound=$3
    shift 3
    rm -rf other
    run_scene "$ranks" "$scene.yaml" other --set threads=1 "$@" && { [ "$bound" != 1e-6 ] || close one/observables.csv other/observables.csv; } && near one other 2 "$bound"
}
for scene in sphere channel; do
    rm -rf one
    check "$scene: runs" run_scene 1 "$scene.yaml" one --set threads=1 --set fluid.solver.tolerance=1e-9
    [ -z "${SCREE_LONG:-}" ] || check "$scene: the same flow on 2 ranks" flows 2 "$scene" 1e-6 --set fluid.solver.tolerance=1e-9
    check "$scene: the same flow on 3 ranks" flows 3 "$scene" 1e-6 --set fluid.solver.tolerance=1e-9
done

resumes() { # RANKS [FLAG...]
    local ranks=$1
    shift
    rm -rf whole half
    run_scene "$ranks" channel.yaml whole --set threads=1 "$@" &&
        run_scene "$ranks" channel.yaml half --set threads=1 --resume whole/checkpoint-6.h5 "$@" &&
        cmp <(tail -n 1 whole/observables.csv) <(tail -n 1 half/observables.csv)
}
check "a resume gives the same bits" resumes 1
check_long "a resume on 2 ranks gives the same bits" resumes 2
kept() { # the preconditioner of the pressure serves more matrices than the one that it was made for
    tr -d ' \n' <whole/report.json | sed 's/.*"name":"pressure",\([^}]*\)}.*/\1/' >solvers && cat solvers &&
        grep -q '"solves":12,' solvers && grep -q '"set_ups":[1-9][,}]' solvers && grep -q '"kept":[1-9]' solvers
}
# particles that move with the flow, beside walls of which one slides; lists that live for some steps
moving=(--set fluid.motion=lagrangian --set skin.length=0.06)
check "particles that move: a resume gives the same bits" resumes 1 "${moving[@]}"
check "particles that move: preconditioners are kept" kept
check "particles that move: a resume on 2 ranks gives the same bits" resumes 2 "${moving[@]}"
rm -rf one
run_scene 1 channel.yaml one --set threads=1 --set fluid.solver.tolerance=1e-9 "${moving[@]}"
moves() { # RANKS THREADS [FLAG...]: the flow of one rank, and particles that have moved
    local ranks=$1 threads=$2
    shift 2
    rm -rf other
    run_scene "$ranks" channel.yaml other --set threads="$threads" --set fluid.solver.tolerance=1e-9 "${moving[@]}" "$@" && close one/observables.csv other/observables.csv
}
check "particles that move: the same flow on 2 ranks x 2 threads" moves 2 2
check_long "particles that move: the same flow on 3 ranks, hgrid" moves 3 1 --set index=hgrid
check_long "particles that move: the same flow with brute, a search in each step" moves 1 1 --set index=brute --set step.rebuild_every=1
points=(--set 'fluid.motion={name: ale, velocity: [0.5, 0, 0], swing: [0.01, 0.01, 0], period: 0.2}')
check "points with a velocity of their own: a resume gives the same bits" resumes 1 "${points[@]}"
driven() { # a flow of given mass goes on as if it had not stopped
    rm -rf whole half
    run_scene 1 channel.yaml whole --set threads=1 --set 'fluid.drive={mass_flow: 0.7}' &&
        run_scene 1 channel.yaml half --set threads=1 --set 'fluid.drive={mass_flow: 0.7}' --resume whole/checkpoint-6.h5 &&
        cmp <(tail -n 1 whole/observables.csv) <(tail -n 1 half/observables.csv) &&
        awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^flow_rate_x/) c = k } END { exit !($c > 0.695 && $c < 0.705) }' whole/observables.csv
}
check "a resume of a flow of given mass" driven
# Points on given paths: after a fifth of a period their swing is sin(2 pi / 5) of the whole, but for the 1.6 % of two steps by the middle of each
swings() {
    rm -rf swing
    run_scene 1 channel.yaml swing --set threads=1 --set 'fluid.motion={name: ale, swing: [0, 1e-4, 0], period: 0.2}' --set step.count=2 --set output.dump.every=2 --set 'output.dump.fields=[id, kind, position]' --set output.checkpoint.every=2 &&
        awk '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
            reading && frame == 1 { x[$at["id"]] = $at["x"]; y[$at["id"]] = $at["y"] }
            reading && frame == 2 && $at["kind"] == 1 { id = $at["id"]; pi = atan2(0, -1); shape = sin(4 * pi * x[id]) * sin(pi * y[id]); moved += shape * ($at["y"] - y[id]); square += shape * shape; n++ }
            END { part = moved / square / 1e-4; printf "  %d points, %g of the swing\n", n, part; exit !(n > 100 && (part - sin(0.4 * pi) * 1.0166) ^ 2 < 1e-6) }' swing/dump.lammpstrj
}
check "points on given paths move by the middle of each step" swings
# A drive that pulsates: a table of time and factor, which begins again; the same bits after a resume
printf '%s\n' '# t factor' '0 1' '0.05 3' '0.1 -1' '0.15 1' >pulse.txt
pulse='fluid.drive={body_force: [1, 0, 0], table: pulse.txt, repeat: true}'
pulsating() {
    rm -rf whole half
    run_scene 1 channel.yaml whole --set threads=1 --set "$pulse" --set 'observables={every: 1, list: [{name: pressure_drop}]}' &&
        run_scene 1 channel.yaml half --set threads=1 --set "$pulse" --set 'observables={every: 1, list: [{name: pressure_drop}]}' --resume whole/checkpoint-6.h5 &&
        cmp <(tail -n 1 whole/observables.csv) <(tail -n 1 half/observables.csv) &&
        awk -F , 'NR == 2 { first = $2 } NR == 3 || NR == 4 || NR == 11 { print "  t " $1 ": " $2 / first }
            NR == 3 && ($2 / first - 1.4) ^ 2 > 1e-20 || NR == 4 && ($2 / first - 2.2) ^ 2 > 1e-20 || NR == 11 && ($2 / first - 1.8) ^ 2 > 1e-20 { bad = 1 } END { exit bad || NR < 10 }' whole/observables.csv
}
check "a drive by a table, and a resume" pulsating
# A resume with another force has that of the scene, unless the force was fitted to the flow
pushed_more() {
    local list='observables={every: 1, list: [{name: pressure_drop}, {name: flow_rate}]}'
    rm -rf whole half
    run_scene 1 channel.yaml whole --set threads=1 --set "$list" &&
        run_scene 1 channel.yaml half --set threads=1 --set "$list" --set 'fluid.drive.body_force=[2, 0, 0]' --resume whole/checkpoint-6.h5 &&
        awk -F , 'FNR > 1 && FNR == NR { drop[$1] = $2; flow[$1] = $5 } FNR > 1 && FNR < NR && ($2 != 2 * drop[$1] || $5 <= flow[$1]) { print "  " $0; bad = 1 } END { exit bad || FNR < 5 }' whole/observables.csv half/observables.csv
}
check "a resume with another force" pushed_more
check "a table of a steady drive" scene_refused 'fluid.drive.table|steady' sphere.yaml --set "$pulse" --set fluid.time=steady --set fluid.equations=stokes
check "a table of a given mass flow" scene_refused 'fluid.drive.table|body_force or pressure_drop' channel.yaml --set 'fluid.drive={mass_flow: 0.7, table: pulse.txt}'
printf '0 1\n0 2\n' >still.txt
printf '0 1\n' >one.txt
check "a table whose time stands" scene_refused 'still.txt:2|does not increase' channel.yaml --set 'fluid.drive={body_force: [1, 0, 0], table: still.txt}'
check "a table of one row that repeats" scene_refused 'two or more' channel.yaml --set 'fluid.drive={body_force: [1, 0, 0], table: one.txt, repeat: true}'
check "a table that is not there" scene_refused 'fluid.drive.table|none.txt' channel.yaml --set 'fluid.drive={body_force: [1, 0, 0], table: none.txt}'
rm -rf whole
run_scene 2 channel.yaml whole --set threads=1
other_ranks() {
    rm -rf half
    run_scene 3 channel.yaml half --set threads=1 --resume whole/checkpoint-6.h5 && close whole/observables.csv half/observables.csv
}
check "a resume on other ranks goes on with the same flow" other_ranks

# drag = body force x volume of the fluid; K of the steady flow (5.05: measured; 12 nodes an edge are few)
steady() {
    rm -rf run
    run_scene "$1" sphere.yaml run --set fluid.time=steady --set 'step={count: 1}' &&
        tail -n 1 run/observables.csv | awk -F , '{ K = 1 / (6 * 3.14159265 * 0.31 * $2); print "  K", K, "drag", $7, "porosity", $5
            exit !($7 / $5 > 0.999 && $7 / $5 < 1.001 && K > 4.0 && K < 4.4) }'
}
check "steady flow past an array of spheres" steady 1
check_long "steady flow on 2 ranks" steady 2
tight=(--set fluid.time=steady --set 'step={count: 1}' --set output.dump.every=1 --set fluid.solver.tolerance=1e-6)
rm -rf one
run_scene 1 sphere.yaml one --set threads=1 "${tight[@]}"
check "steady flow: the same velocities, drags and pressures on 3 ranks" flows 3 sphere 1e-3 "${tight[@]}"

# What is said of all particles is said of grains alone
grains() {
    rm -rf run
    run_scene 2 sphere.yaml run --set step.count=1 --set 'observables.regions=[{name: half, shape: box, lower: [-1, 0, 2], upper: [-0.5, 1, 3]}]' \
        --set 'observables.list=[{name: particles}, {name: speed_max}, {name: centre}, {name: momentum}, {name: energy_kinetic}, {name: count}, {name: solid_volume}]' &&
        tail -n 1 run/observables.csv | tr , ' ' >row && cat row &&
        awk '{ v = 4 / 3 * 3.14159265358979 * 0.31 ^ 3; split("0.02 1 0 -0.9 0.1 2.05 0 0 0 0 1 " sprintf("%.15g", v), wanted)
            for (k = 1; k <= NF; k++) { d = $k - wanted[k]; if (!(d * d < 1e-18)) bad = 1 } exit bad || NF != 12 }' row
}
check "particles of the fluid are no grains" grains

# The solvers: their part of the report, a residual that is far above its tolerance, and a solver that does not converge
report() {
    tr -d ' \n' <one/report.json | sed 's/.*"solvers":\[{"name":"velocity",\([^}]*\)},{"name":"steady",\([^}]*\)}\].*/\1 \2/' >solvers && cat solvers &&
        grep -q '"rows":1509,"entries":[1-9][0-9]*,"solves":0,.*"set_ups":1,.* "rows":6036,"entries":0,"solves":1,' solvers
}
check "the report counts solves and set-ups" report
doubtful() { # GUARD STATUS: ends so
    local limit=('-fluid_p_ksp_convergence_test skip -fluid_p_ksp_max_it 2')
    rm -rf run
    "$scree" run channel.yaml -o run --quiet --set threads=1 --set guards.residual="$1" --petsc "${limit[@]}" >/dev/null 2>said
    [ $? = "$2" ] || { cat said; return 1; }
}
doubt='guards.residual: the true residual of a solve for the pressure of the fluid is .* times its tolerance'
check "a doubtful residual is told" doubtful warn 0
check "once" test "$(grep -c "warning: $doubt" said)" = 1
check "or not at all" doubtful off 0
check "indeed not" test ! -s said
check "or stops the run" doubtful stop 3
check "with a checkpoint" test "$(grep -c "^scree: $doubt" said) $(find run -name '*-stopped.h5' | wc -l)" = '1 1'
fails() {
    rm -rf run
    "$scree" run channel.yaml -o run --quiet --set threads=1 --petsc '-fluid_p_ksp_max_it 2' >/dev/null 2>said
    [ $? = 3 ] && grep -q 'solver for the pressure of the fluid did not converge: after 2 iterations (DIVERGED_ITS) the residual is .*, and the tolerance 1e-05; .* may help (step 1, t = 0.02)' said &&
        [ "$(find run -name '*-stopped.h5' | wc -l)" = 1 ]
}
check "a solver that does not converge stops the run, with residual, step, advice and checkpoint" fails
displaced() { # the part of a right-hand side that no pressure reaches is no residual
    rm -rf run
    run_scene 1 sphere.yaml run --set threads=1 --set fluid.fill.jitter=0.4 --set step.dt=0.2 && [ ! -s said ] &&
        tail -n 1 run/observables.csv | awk -F , -v head="$(head -n 1 run/observables.csv)" '{ split(head, name, ",")
            for (k = 1; k <= NF; k++) if (name[k] ~ /fluid_residual/) { print "  residual", $k; exit !($k > 0 && $k <= 1e-4) } exit 1 }'
}
check "a residual at the tolerance on displaced particles" displaced

# A ring of grains closes in a pocket; a row of grains divides the fluid into two regions, of a null space of their own each.
bodies() { # AWK EXPRESSIONS for x and y of grain k = 0 ... 15
    cat <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [2, 2, 0], periodic: [true, false, false], dimension: 2}
walls:
  - {name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: upper, shape: plane, point: [0, 2, 0], normal: [0, -1, 0]}
groups: [{name: bed, motion: frozen}]
fluid: {spacing: 0.04, density: 1, viscosity: 0.1, equations: stokes, drive: {body_force: [1, 0, 0]}}
step: {dt: 0.05, count: 4}
observables: {every: 1, list: [{name: fluid}]}
particles:
  sources:
YAML
    awk "BEGIN { pi = atan2(0, -1); for (k = 0; k < 16; k++)
        printf \"    - {from: single, position: [%.6f, %.6f, 0], radius: 0.1, density: 1, group: bed}\\n\", $1, $2 }"
}
bodies '1 + 0.19 * cos(pi * k / 8)' '0.9 + 0.19 * sin(pi * k / 8)' >ring.yaml
bodies '0.0625 + k / 8' '0.9' >row.yaml
regions() { # SCENE WORDS RANKS: the flow has a small divergence, the drag is the force on the fluid less that of the walls
    on 1 "$scree" check --all "$1.yaml" >told 2>&1
    grep -q "$2" told || { cat told; return 1; }
    rm -rf one other
    run_scene 1 "$1.yaml" one --set threads=1 --set fluid.solver.tolerance=1e-9 &&
        run_scene "$3" "$1.yaml" other --set threads=1 --set fluid.solver.tolerance=1e-9 && close one/observables.csv other/observables.csv
}
check "a closed pocket becomes solid" regions ring 'nodes of the fluid lie in closed pockets' 2
check "with it the fluid is one region" grep -q '1 connected region$' told
check "two regions of fluid" regions row '2 connected regions' 3

# A turning cylinder takes the fluid with it: rigid rotation
cat >drum.yaml <<'YAML'
units: none
box: {lower: [-0.5, -0.5, 0], upper: [0.5, 0.5, 0], dimension: 2}
walls:
  - {name: drum, shape: cylinder, point: [0, 0, 0], axis: [0, 0, 1], radius: 0.45, motion: [{kind: rotate, point: [0, 0, 0], direction: [0, 0, 1], rate: 1}]}
fluid: {spacing: 0.0416666666666667, density: 1, viscosity: 0.1}
step: {dt: 0.04, count: 120}
output: {dump: {every: 120, fields: [position, velocity]}}
YAML
rotation() { # SETTING...
    rm -rf drum
    run_scene 1 drum.yaml drum --set threads=1 "$@" && awk '
        /^ITEM: TIMESTEP/ { gap = size = n = 0; next }
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        /^ITEM/ { reading = 0 }
        reading && NF > 4 { x = $at["x"]; y = $at["y"]; r = x * x + y * y
            if (r < 0.45 ^ 2) { gap += ($at["vx"] + y) ^ 2 + ($at["vy"] - x) ^ 2; size += r; n++ } }
        END { e = sqrt(gap / size); printf "  %d particles, relative error %.3g\n", n, e; exit !(n > 300 && e < 1e-3) }' drum/dump.lammpstrj
}
check "a turning cylinder takes the fluid with it" rotation
check "so does a cylinder whose surface alone turns" rotation --set 'walls[0].motion[0].surface=true'

# Grains that only spin stay where they are: a steady flow around them, and one in time on particles at rest; torque on a disc in an array of them,
# 4 pi mu omega R^2 / porosity, on one rank and on two
cat >wheel.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 0], periodic: [true, true, false], dimension: 2}
contact: {law: hooke}
materials: [{name: disc, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.5, friction: 0.2}]
particles: {from: single, position: [0.5, 0.5, 0], radius: 0.2, group: wheel}
groups: [{name: wheel, motion: moving, omega: [0, 0, 1]}]
fluid: {spacing: 0.03125, density: 1, viscosity: 1, equations: stokes, time: steady, solver: {tolerance: 1e-6}}
step: {count: 1}
observables: {every: 1, list: [{name: drag/wheel}]}
YAML
wheel() { # RANKS THREADS FLAG...
    local ranks=$1 threads=$2
    shift 2
    rm -rf wheel
    run_scene "$ranks" wheel.yaml wheel --set threads="$threads" "$@" && within "$(last_of wheel drag_wheel_torque_z)" -0.574899 0.003
}
check "a steady flow around a grain that spins" wheel 1 1
check "on two ranks" wheel 2 2
check "a flow in time around it" wheel 1 1 --set fluid='{spacing: 0.03125, density: 1, viscosity: 1}' --set step='{dt: 0.005, count: 60}' --set observables.every=60
check "a grain that spins and moves is no steady flow" scene_refused 'groups[0].velocity|only spin' wheel.yaml --set 'groups[0].velocity=[0.1, 0, 0]'
sed 's/, group: wheel}/}/; s/name: wheel, /&select: {ids: [1]}, /' wheel.yaml >selected.yaml
check "nor one that a selection puts into the group" scene_refused 'groups[0].velocity|only spin' selected.yaml --set 'groups[0].velocity=[0.1, 0, 0]'
sed '/^contact/d; /^material/d; s/radius: 0.2/&, density: 1/' wheel.yaml >smooth.yaml
check "a spin without friction" scene_refused "group 'wheel' has a spin|friction" smooth.yaml
sed '/^contact/d; /^material/d; s/radius: 0.2/&, density: 1/' selected.yaml >smooth.yaml
check "a spin without friction, of a group that selects" scene_refused "group 'wheel' has a spin|friction" smooth.yaml

# A frozen bed with contacts, gravity and walls: the flow and its drag are the same on other ranks
cat >bed.yaml <<'YAML'
units: none
gravity: [0, 0, -1]
box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: [true, false, true]}
contact: {law: hertz}
materials: [{name: glass, density: 2.5, young: 1e5, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
walls:
  - {name: a, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: b, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}
particles: {from: random, sizes: {law: uniform, min: 0.15, max: 0.2}, volume_fraction: 0.2, region: {shape: box, lower: [0, 0, 0], upper: [1, 1, 1]}, group: bed}
groups: [{name: bed, motion: frozen}]
fluid: {spacing: 0.0625, density: 1, viscosity: 1, equations: stokes, time: steady, drive: {body_force: [0, 0, 1]}, solver: {tolerance: 1e-4}}
step: {count: 1, dt: 0.001}
observables: {every: 1, list: [{name: fluid_velocity, components: z}, {name: fluid_drag, components: z}]}
YAML
bed() {
    rm -rf one other
    run_scene 1 bed.yaml one --set threads=1 && run_scene 3 bed.yaml other --set threads=1 &&
        paste -d , <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv) |
        awk -F , '{ u = $5 / $2 - 1; f = $6 / $3 - 1; printf "  velocity %g, drag %g; other ranks differ by %.1e and %.1e\n", $2, $3, u, f
            exit !($2 > 1e-3 && $3 > 0.1 && $3 < 1 && u * u < 1e-6 && f * f < 1e-6) }'
}
check "a bed of frozen grains between walls, on other ranks" bed

# A grain that moves through a fluid that moves: the same as the flow past it in its own frame, on other ranks, after a resume; its boundary
# particles keep their places in it, and turn with it
cat >disc.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 0], periodic: [true, true, false], dimension: 2}
contact: {law: hertz}
materials: [{name: glass, density: 1, young: 1e5, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
particles: {from: single, position: [0.5, 0.5, 0], radius: 0.2, density: 1, group: disc}
groups: [{name: disc, motion: moving, velocity: [-1, 0, 0]}]
fluid: {spacing: 0.05, density: 1, viscosity: 0.1, motion: lagrangian, solver: {tolerance: 1e-9}}
step: {dt: 0.004, count: 40, force: true}
observables: {every: 1, list: [{name: fluid_velocity, components: x}, {name: fluid_porosity}, {name: fluid_drag}]}
output: {checkpoint: {every: 20}, dump: {every: 40, fields: [id, position, velocity, angular_velocity]}}
YAML
frames() {
    run_scene 1 disc.yaml one --set threads=1 && run_scene 1 disc.yaml other --set threads=1 --set 'groups=[{name: disc, motion: frozen}]' \
        --set fluid.initial.velocity='[1, 0, 0]' && paste -d , <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv) |
        awk -F , '{ drag = $4 / $10 - 1; u = $8 / $9 - 1 - $2 / $3; printf "  drag %g, other frame by %.2g; velocity by %.2g\n", $4, drag, u
            exit !($4 > 0.5 && drag * drag < 1e-4 && u * u < 1e-6) }'
}
rm -rf one other
check "a grain that moves: as the flow past it in its frame" frames
carried() { # SCENE BOUND RANKS FLAG...: the first three observables at the end are those of the run in `one`
    rm -rf other
    run_scene "$3" "$1.yaml" other --set threads=1 "${@:4}" && paste -d , <(tail -n 1 one/observables.csv) <(tail -n 1 other/observables.csv) |
        awk -F , -v most="$2" '{ m = NF / 2; for (k = 2; k <= 4; k++) { d = $k / $(k + m) - 1; bad += !(d * d < most * most) } exit bad }'
}
check "a grain that moves, on 3 ranks" carried disc 1e-8 3
check "a grain that moves, after a resume" carried disc 1e-8 1 --resume one/checkpoint-20.h5
rigid() {
    rm -rf one
    run_scene 2 disc.yaml one --set threads=1 --set 'groups=[{name: disc, motion: moving, velocity: [-1, 0, 0], omega: [0, 0, 2]}]' && awk -v w=2 -v V=-1 -v T=0.16 '
        /^ITEM: TIMESTEP/ { frame++ }
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        /^ITEM/ { reading = 0 }
        reading && NF > 5 { id = $at["id"]; x[frame, id] = $at["x"]; y[frame, id] = $at["y"]; u[frame, id] = $at["vx"]; v[frame, id] = $at["vy"]; spin[id] = $at["omegaz"] }
        function near(a) { return a - int(a + (a < 0 ? -0.5 : 0.5)) }
        END { c = cos(w * T); s = sin(w * T)
            for (id in spin) if (spin[id] == w && id != 1) {
                a = near(x[1, id] - x[1, 1]); b = near(y[1, id] - y[1, 1]); p = near(x[2, id] - x[2, 1]); q = near(y[2, id] - y[2, 1]); n++
                place += (p - c * a + s * b) ^ 2 + (q - s * a - c * b) ^ 2; speed += (u[2, id] - V + w * q) ^ 2 + (v[2, id] - w * p) ^ 2 }
            printf "  %d boundary particles, places off by %.1e, velocities by %.1e\n", n, sqrt(place), sqrt(speed); exit !(n > 40 && place < 1e-22 && speed < 1e-18) }' one/dump.lammpstrj
}
check "boundary particles ride on a grain that turns" rigid

# A grain that the fluid moves: momentum of grain and fluid grows by its weight less buoyancy; on other ranks, after a resume, with steps of its own
sed 's/, group: disc}/}/; s/density: 1}/density: 7.5}/; /^groups/d; s/motion: lagrangian,/motion: lagrangian, grains: free,/; s/^contact:/gravity: [0, -10, 0]\n&/' disc.yaml |
    sed 's/{name: fluid_velocity, components: x}/{name: fluid_velocity, components: y}/; s/{name: fluid_drag}/{name: velocity, id: 1, components: y}/' >falling.yaml
momentum() { # SETTING...: rows t, fluid's velocity, porosity, velocity of the grain; mass 0.251, displaced 0.126
    rm -rf one
    run_scene 1 falling.yaml one --set threads=1 "$@" && tail -n 1 one/observables.csv | awk -F , '
        { m = 4 / 3 * atan2(0, -1) * 0.008 * 7.5; P = m * $4 + $2; F = -10 * (m - atan2(0, -1) * 0.04) * $1; printf "  velocity %g, momentum %g, impulse %g\n", $4, P, F
            exit !($4 < -0.1 && P / F > 0.96 && P / F < 1.04) }'
}
check "a grain that falls in a fluid: with subcycles, momentum is kept" momentum --set step.dt=0.001 --set step.count=160 --set fluid.grains='{motion: free, every: 4}' --set output.checkpoint.every=80 --set output.dump.every=160 --set observables.every=160
# before the first step of the fluid the added mass of a disc is all of the mass that it displaces
added_mass() {
    run_scene 1 falling.yaml added --overwrite --set threads=1 --set step.dt=0.001 --set step.count=3 --set fluid.grains='{motion: free, every: 4}' --set observables.every=1 --set output.checkpoint.every=3 --set output.dump.every=3 &&
        awk -F , 'NR == 4 { pi = atan2(0, -1); m = 4 / 3 * pi * 0.008 * 7.5; f = pi * 0.04; v = -10 * (m - f) / (m + f) * $1; printf "  velocity %g of %g\n", $4, v; good = ($4 / v - 1) ^ 2 < 1e-12 } END { exit !good }' added/observables.csv
}
check "a grain that falls in a fluid: its added mass" added_mass
check "a grain that falls in a fluid: momentum is kept" momentum
check "a grain that falls in a fluid, on 3 ranks" carried falling 1e-7 3
check "a grain that falls in a fluid, after a resume" carried falling 1e-7 1 --resume one/checkpoint-20.h5
# A disc that sets out at once at Reynolds number 60, beside a wall a seventh of a spacing from the nearest particles: no swing grows
cat >swift.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1.042, 1.25, 0], dimension: 2, periodic: [false, true, false]}
walls: [{name: left, shape: plane, point: [0, 0, 0], normal: [1, 0, 0]}, {name: right, shape: plane, point: [1.042, 0, 0], normal: [-1, 0, 0]}]
particles: {from: single, position: [0.5, 0.5, 0], radius: 0.125, density: 1, group: disc}
groups: [{name: disc, motion: moving, velocity: [0, -1, 0]}]
fluid: {spacing: 0.0625, density: 1, viscosity: 0.004, motion: lagrangian}
step: {dt: 0.02, count: 50, force: true}
observables: {every: 1, list: [{name: fluid_drag, components: y}]}
output: {checkpoint: {at_end: false}}
YAML
swift() {
    run_scene 1 swift.yaml swift --set threads=1 && awk -F , 'NR > 22 { n++; sum += $2; square += $2 * $2 }
        END { mean = sum / n; rms = sqrt(square / n - mean * mean); printf "  drag %g, rms %g\n", mean, rms; exit !(mean > 0.12 && mean < 0.17 && rms < 0.4 * mean) }' swift/observables.csv
}
check "a disc that moves fast" swift
# A sphere that falls by two of its diameters: fluid particles come up to its surface; it speeds up, quietly, and slows down above the floor
cat >sphere_falls.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [0.8, 1, 0.8], periodic: [true, false, true]}
gravity: [0, -10, 0]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}, {name: lid, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}]
particles: {from: single, position: [0.42, 0.7, 0.37], radius: 0.2, density: 14}
fluid: {spacing: 0.1, density: 1, viscosity: 0.5, motion: lagrangian, grains: free}
step: {dt: 0.025, count: 24, force: true}
observables: {every: 1, list: [{name: velocity, id: 1, components: y}, {name: fluid_drag, components: y}]}
output: {checkpoint: {at_end: false}}
YAML
falls() {
    run_scene 1 sphere_falls.yaml fallen --set threads=1 && awk -F , 'NR > 3 { if ($3 < last || $3 < 0.5) bad = 1; last = $3; v = $2; if (v < most) most = v }
        END { printf "  largest velocity %g, at the end %g, drag %g of weight 4.357\n", most, v, last; exit !(!bad && most < -0.5 && v > most && last > 4.3 && last < 6) }' fallen/observables.csv
}
check "a sphere that falls in a fluid: forces make sense" falls
# Discs that are put on each other under water, a bit apart: they come to rest, with their weight less buoyancy on the floor (9 x 981 x (0.0783 - 0.03135))
{
    cat <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [0.8, 0.8, 0], periodic: [true, false, false], dimension: 2}
gravity: [0, -981, 0]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}, {name: lid, shape: plane, point: [0, 0.8, 0], normal: [0, -1, 0]}]
contact: {law: hooke}
materials: [{name: disc, density: 18.75}]
material_pairs: [{k_n: 100000, restitution: 0.5, friction: 0.2}]
fluid: {spacing: 0.025, density: 1, viscosity: 0.1, motion: lagrangian, grains: {motion: free, every: 10}}
step: {dt: 1e-4, count: 1000}
observables: {every: 1000, list: [{name: energy_kinetic}, {name: centre, components: y}, {name: wall_force, target: floor, components: y}]}
output: {checkpoint: {at_end: false}}
particles:
  sources:
YAML
    for place in '0.1, 0.0998' '0.3, 0.0998' '0.5, 0.0998' '0.7, 0.0998' '0.2, 0.2729' '0.4, 0.2729' '0.6, 0.2729' '0.3, 0.4459' '0.5, 0.4459'; do
        echo "    - {from: single, position: [$place, 0], radius: 0.0999}"
    done
} >pile.yaml
pile() {
    run_scene 1 pile.yaml pile --set threads=1 && tail -n 1 pile/observables.csv | awk -F , '{ part = $4 / (9 * 981 * (0.0783 - 0.03135))
        printf "  kinetic energy %g, height %g, on the floor %g of the weight\n", $2, $3, -part; exit !($2 < 1e-5 && $3 > 0.2325 && $3 < 0.2335 && part < -0.98 && part > -1.02) }'
}
check "discs that rest on each other in a fluid" pile
# the same bits after a resume between two steps of the fluid
pile_resumed() {
    local to=(--set threads=1 --set fluid.grains.every=1 --set step.count=33 --set observables.every=33 --set 'output.checkpoint={every: 30}')
    run_scene 1 pile.yaml pile-on "${to[@]}" && run_scene 1 pile.yaml pile-again "${to[@]}" --resume pile-on/checkpoint-30.h5 &&
        cmp <(tail -n 1 pile-on/observables.csv) <(tail -n 1 pile-again/observables.csv)
}
check "they go on with the same bits after a resume" pile_resumed
# discs that get too fast for their fluid: the message says that pockets between grains may be the cause
too_fast() {
    "$scree" run pile.yaml -o too-fast --quiet --set threads=1 --set 'gravity=[0, 50000, 0]' >/dev/null 2>said
    [ $? = 3 ] && grep -q 'spacings in step .*close pockets of fluid between them' said || { cat said; return 1; }
}
check "a flow that grains make too fast" too_fast
# the other ending: a solver that diverges, here as its bound says so at once
diverged() {
    "$scree" run pile.yaml -o diverged --quiet --set threads=1 --petsc '-fluid_p_ksp_divtol 1e-3' >/dev/null 2>said
    [ $? = 3 ] && grep -q 'did not converge: .*DIVERGED_DTOL.*(step .*close pockets of fluid between them' said || { cat said; return 1; }
}
check "a solver that diverges where grains move names pockets, too" diverged
# One disc of a fiftieth of the fluid's density: it rises the same way in long and short steps of the fluid
light() {
    local every
    for every in 10 2; do
        run_scene 1 light.yaml "light-$every" --set threads=1 --set fluid.grains.every=$every || return 1
    done
    paste -d , <(tail -n 1 light-10/observables.csv) <(tail -n 1 light-2/observables.csv) |
        awk -F , '{ printf "  heights %g %g, velocities %g %g\n", $2, $5, $3, $6; exit !($2 > 0.56 && $2 < 0.61 && $2 - $5 < 2e-3 && $5 - $2 < 2e-3 && $3 > 5 && $3 / $6 > 0.98 && $3 / $6 < 1.02) }'
}
# and after a resume while boundary particles wait for the next step of the fluid: those of discs that move stand in one order
waiting() {
    local to=(--set threads=1 --set step.count=60 --set observables.every=60 --set output.checkpoint='{every: 17, keep: 9}')
    run_scene 1 waiting.yaml waiting "${to[@]}" && run_scene 1 waiting.yaml waited "${to[@]}" --resume waiting/checkpoint-17.h5 &&
        cmp <(tail -n 1 waiting/observables.csv) <(tail -n 1 waited/observables.csv)
}
sed '/position: /d; s/gravity: .*/gravity: [100, -300, 0]/; s/viscosity: 0.1/viscosity: 1/; s/{name: energy_kinetic}/&, {name: fluid_velocity}/' pile.yaml >waiting.yaml
for place in '0.15, 0.21' '0.42, 0.23' '0.66, 0.19' '0.2, 0.52' '0.55, 0.55'; do
    echo "    - {from: single, position: [$place, 0], velocity: [0.3, -0.2, 0], omega: [0, 0, 5], radius: 0.08}"
done >>waiting.yaml
check "and between two steps of the fluid" waiting
# Before the first step of the fluid: a disc that is let go has the added mass of a disc, and one that its contact carries stays where it is
let_go() {
    run_scene 1 let_go.yaml let_go --set threads=1 && tail -n 1 let_go/observables.csv | awk -F , '{ pi = atan2(0, -1); m = 4 / 3 * pi * 0.0999 ^ 3 * 18.75; V = pi * 0.0999 ^ 2
        v = -(m - V) * 981 / (m + V) * 5e-4; printf "  velocities %g, %g, of a disc %g\n", $2, $3, v; exit !($2 < 1e-3 && $2 > -1e-3 && $3 / v > 0.9999 && $3 / v < 1.0001) }'
}
sed '/position: /d; s/count: 1000/count: 5/; s/every: 1000, list.*/every: 5, list: [{name: velocity, id: 1, components: y}, {name: velocity, id: 2, components: y}]}/' pile.yaml >let_go.yaml
printf '    - {from: single, position: [%s, 0], radius: 0.0999}\n' '0.2, 0.0994393' '0.6, 0.4' >>let_go.yaml
check "discs that are let go in a fluid" let_go
sed '/position: /d; s/density: 18.75/density: 0.15/; s/k_n: 100000/k_n: 3000/; s/count: 1000/count: 300/; s/every: 1000, list.*/every: 300, list: [{name: position, id: 1, components: y}, {name: velocity, id: 1, components: y}]}/' pile.yaml >light.yaml
echo '    - {from: single, position: [0.3, 0.4459, 0], radius: 0.0999}' >>light.yaml
check "a light disc rises" light
# Discs that move by a fifth of a spacing between two steps of the fluid: rows keep pairs from beyond the support, whose grain is no neighbour
check "grains that move between two steps of the fluid" run_scene 1 "$top_srcdir/examples/tumbling/scene.yaml" tumbling --set threads=1 --set step.count=230 --set output.dump=~
# A sphere without torque between walls that slide, four of its diameters apart, turns at half of the rate of shear
spin() { # DENSITY STEPS
    run_scene 1 "$top_srcdir/examples/verify/fluid-settling/shear.yaml" spin --overwrite --set threads=1 --set box.upper='[1, 1, 1]' --set box.dimension=3 --set box.periodic='[true, false, true]' \
        --set particles.position='[0.5, 0.5, 0.5]' --set particles.radius=0.125 --set particles.density="$1" --set 'materials[0].density=1' --set fluid.spacing=0.0625 \
        --set step.count="$2" --set observables.every="$2"
}
spins_at_half() { spin 1 40 && within "$(last_of spin particle1_wz)" -0.5 0.01; }
check "a sphere in shear turns at half of its rate" spins_at_half
# a heavy one speeds up by 8 pi mu R^3 / (2 I) = 0.480 at most, less while the shear grows
spins_up() { spin 1000 20 && within "$(last_of spin particle1_wz)" -0.028 0.0104; }
check "a heavy sphere in shear begins to turn with it" spins_up
check "free grains with mirrors among particles at rest" scene_refused 'fluid.grains|lagrangian' falling.yaml --set fluid.motion=fixed --set fluid.grains='{motion: free, coupling: mirror}'

# What a scene refuses at the start it refuses in a resume and in a later stage, too
on_refused() { # WORDS SCENE FLAG...
    on_ranks_refused 1 "$@"
}
on_ranks_refused() { # RANKS WORDS SCENE FLAG...
    rm -rf refused
    on "$1" "$scree" run "$3" -o refused --quiet "${@:4}" >/dev/null 2>said
    [ $? = 2 ] && [ "$(grep -c "$2" said)" = 1 ] || { cat said; return 1; }
}
check "a resume with a steady flow with inertia" on_refused 'fluid.time: steady goes with' channel.yaml --resume whole/checkpoint-6.h5 --set fluid.time=steady
check "a resume with grains that nothing moves" on_refused 'falling.yaml:.* grain 1 moves freely' falling.yaml --resume one/checkpoint-20.h5 --set fluid.grains=given
for walls in '[]' '[{name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}]'; do
    for ranks in 1 3; do
        check "a resume without walls that bound the fluid, on $ranks: $walls" on_ranks_refused "$ranks" 'walls: wall number [12] bounds the fluid and is missing ([01] are given)' channel.yaml --resume whole/checkpoint-6.h5 --set "walls=$walls"
    done
done
sides=(--set threads=1 --set box.periodic=false --set fluid.drive=~ --set output.checkpoint.every=2)
check "a flow between open sides" run_scene 1 channel.yaml sides "${sides[@]}" --set step.count=2 --set 'fluid.open=[{side: x_lower, pressure: 1}, {side: x_upper, pressure: 0}]'
check "a resume without one of them" on_refused 'fluid.open: the side x_lower bounds the fluid and is missing' channel.yaml --resume sides/checkpoint-2.h5 "${sides[@]}" --set 'fluid.open=[{side: x_upper, pressure: 0}]'
check "a resume with another spacing" on_refused 'fluid.spacing: the particles of the fluid were made with a spacing of 0.0625' channel.yaml --resume whole/checkpoint-6.h5 --set fluid.spacing=0.09
sed 's/^step:.*/step: {dt: 0.02}\nstages: [{name: a, duration: 0.04}, {name: b, duration: 0.02, set: {walls: []}}]/' channel.yaml >bare.yaml
check "a stage without them" on_refused 'walls: wall number' bare.yaml
sed 's/^step:.*/step: {dt: 0.02}\nstages: [{name: a, duration: 0.02}, {name: b, duration: 0.02, set: {"groups[bed].motion": free}}]/' sphere.yaml >staged.yaml
check "a stage that sets a grain free among particles at rest" on_refused 'group .bed. moves; allowed beside' staged.yaml
check "the stage before it was run" test -s refused/checkpoint-1.h5

check "a support below the diagonal" scene_refused 'fluid.kernel.support|from 1.42' sphere.yaml --set fluid.kernel.support=1.2
least_squares='fluid.operators|moving least squares of order|allowed in time'
check "moving least squares of order 2 in time beside a grain" scene_refused "$least_squares|order 2 let" sphere.yaml --set fluid.operators=mls
check "between walls" scene_refused "$least_squares" channel.yaml --set 'fluid.operators={name: mls, order: 4}'
vortices=(--set box.periodic=true --set 'walls=[]' --set box.upper='[1, 1, 0]' --set 'fluid.initial={flow: taylor_green, speed: 1}' --set 'fluid.drive=~')
check "of order 3 without bodies" scene_refused "$least_squares" channel.yaml "${vortices[@]}" --set 'fluid.operators={name: mls, order: 3}'
calm() { # the energy of vortices without bodies falls
    run_scene 1 channel.yaml calm --set threads=1 "${vortices[@]}" --set 'fluid.operators={name: mls, order: 4}' && awk -F , '{ print "  energy " $6 } NR > 2 && $6 > last { bad = 1 } { last = $6 } END { exit bad }' calm/observables.csv
}
check "orders 2 and 4 go with vortices" calm
check "two drives" scene_refused 'fluid.drive.mass_flow|exclude each other' sphere.yaml --set fluid.drive.mass_flow=1
check "a drive towards a wall" scene_refused 'fluid.drive.pressure_drop|periodic' channel.yaml --set 'fluid.drive={pressure_drop: 1, axis: y}'
check "a spacing that does not divide a periodic edge" scene_refused 'fluid.spacing|does not divide|0.0909' sphere.yaml --set fluid.spacing=0.09
check "a spacing too coarse for a grain" scene_refused 'fluid.spacing|too coarse|grain 1' sphere.yaml --set fluid.spacing=0.2
check "no fluid in the region" scene_refused 'there is no fluid' channel.yaml --set 'fluid.fill={region: {shape: sphere, centre: [9, 9, 0], radius: 1}}'
check "fluid where a grain stands" scene_refused 'fluid.fill|grains or walls stand at all' sphere.yaml --set 'fluid.fill={region: {shape: sphere, centre: [-0.9, 0.1, 2.05], radius: 0.2}}'
check "a lattice of three dimensions in two" scene_refused 'fluid.fill.arrangement|hexagonal' channel.yaml --set fluid.fill.arrangement=bcc
check "a lattice of two dimensions in three" scene_refused 'fluid.fill.arrangement|bcc, fcc' sphere.yaml --set fluid.fill.arrangement=hexagonal
check "a lattice that does not fit" scene_refused 'fluid.spacing|stretched by|finer' channel.yaml --set fluid.fill.arrangement=hexagonal --set 'box.upper=[0.3, 1, 0]'
check "an open side" scene_refused 'open side near|wall' channel.yaml --set box.periodic=false
check "a region that ends in the open" scene_refused 'open side near' sphere.yaml --set 'fluid.fill={region: {shape: box, lower: [-1, 0, 2], upper: [0, 1, 2.5]}}'
check "grains that move" scene_refused 'grain 1 moves freely|fluid.grains: free' sphere.yaml --set 'particles={from: single, position: [-0.9, 0.1, 2.05], radius: 0.31, density: 1}' --set 'groups=[]'
check "a motion that is not known" scene_refused 'fluid.motion|lagrangian' channel.yaml --set fluid.motion=eulerian
check "particles that move without inertia" scene_refused 'fluid.motion|navier_stokes' channel.yaml --set fluid.motion=lagrangian --set fluid.equations=stokes
check "points that leave the box" scene_refused 'fluid.motion.velocity|along y' channel.yaml --set 'fluid.motion={name: ale, velocity: [0, 1, 0]}'
check "a steady flow with inertia" scene_refused 'fluid.time|stokes' channel.yaml --set fluid.time=steady
check "a grain that moves through particles at rest" scene_refused 'lagrangian|group' disc.yaml --set fluid.motion=fixed
check "an unknown key" scene_refused 'fluid.viscosty|fluid.viscosity' channel.yaml --set fluid.viscosty=1
check "vortices in a box that does not repeat" scene_refused 'taylor_green|periodic' channel.yaml --set 'fluid.initial={flow: taylor_green, speed: 1}'
cat >tube.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1]}
walls: [{name: tube, shape: cylinder, point: [0.5, 0.5, 0.5], axis: [0, 0, 1], radius: 0.4, length: 0.5}]
fluid: {spacing: 0.1, density: 1, viscosity: 1}
step: {dt: 1, count: 1}
YAML
check "a tube of finite length is a bore through a plate, open at its ends" scene_refused 'tube.yaml:4|open side near' tube.yaml
stops() {
    "$scree" run channel.yaml -o stops --quiet --set 'walls[1].motion[0].velocity=[0, 0.1, 0]' >/dev/null 2>said
    [ $? = 2 ] && grep -q 'a wall moves towards the fluid' said
}
check "a wall that moves away" stops
monitored() {
    run_scene 2 channel.yaml monitored --petsc '-fluid_p_ksp_monitor -unheard_of 3' >/dev/null 2>&1 && [ "$(grep -c 'KSP Residual norm' said)" -gt 12 ] &&
        [ "$(grep -c 'knows nothing to do with -unheard_of$' said)" = 1 ]
}
check "options of PETSc on the command line, and what PETSc does not know" monitored
# A loose tolerance and a tight one give the same flow through narrow gaps between open sides, to 2 %
cat >bed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4.2, 2, 0], periodic: [false, true, false], dimension: 2}
particles: {from: file, format: table, file: bed.txt, columns: [radius, x, y, z], density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.05
  density: 1
  viscosity: 1
  equations: stokes
  time: steady
  open: [{side: x_lower, pressure: 1}, {side: x_upper, pressure: 0}]
step: {dt: 1, count: 1}
observables: {every: 1, list: [{name: fluid}]}
output: {checkpoint: {at_end: false}}
YAML
awk 'BEGIN { for (i = 0; i < 8; i++) for (j = 0; j < 4; j++)
    print 0.215, 0.5 + 0.44 * i + 0.02 * ((i + 3 * j) % 3 - 1), 0.25 + 0.5 * j + 0.25 * (i % 2) + 0.02 * ((2 * i + j) % 3 - 1), 0 }' >bed.txt
check "moving least squares in time between open sides" scene_refused "$least_squares" bed.yaml --set 'fluid.operators={name: mls, order: 2}' --set fluid.time=transient
conserved() {
    local tolerance
    for tolerance in 0.05 1e-3; do
        run_scene 1 bed.yaml "bed-$tolerance" --set fluid.solver.tolerance=$tolerance || return 1
        "$scree" info "bed-$tolerance" --column fluid_velocity_x --row last
    done | awk '{ u[NR] = $1 } END { print "  " u[1], u[2]; exit !(NR == 2 && u[2] > 0 && u[1] / u[2] > 0.98 && u[1] / u[2] < 1.02) }'
}
check 'a loose tolerance loses less than 2 % between open sides' conserved

finish
