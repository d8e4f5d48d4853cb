#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Speed against error: the results of `scree ablate --error` on a scene whose errors are known to be small, the input that the command
# refuses, and the end of the command by a signal.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >scene.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 8, 8]}
gravity: [0, 0, -10]
threads: 1
step: {dt: 0.001, count: 200}
contact: {law: hertz}
classes: {method: geometric, count: 2}
materials: [{name: soft, density: 1, young: 1e4, poisson: 0.3}]
material_pairs: [{restitution: 0.9, friction: 0.4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: random, count: 60, sizes: {law: uniform, min: 0.2, max: 0.6}, velocity_sigma: 3}
observables: {every: 20, list: [{name: energy}, {name: centre, label: heap, components: z}]}
EOS

study() { # RANKS DIR [FLAG...]
    local ranks=$1 dir=$2
    shift 2
    on "$ranks" "$scree" ablate scene.yaml --error -o "$dir" --samples 10 --repeat 1 "$@" >said 2>told || { cat said told; return 1; }
}
field() { # CSV SETTINGS COLUMN
    awk -F, -v settings="$2" -v column="$3" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } $2 == settings { print $at[column]; exit }' "$1"
}
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a ~ /^[0-9]/ && b ~ /^[0-9]/ && a < b) }' || { echo "  $1 is not below $2"; return 1; }; }

check 'a scene is studied' study 1 one --duration 0.1 --judge trajectory,heap_z
cat said
columns() {
    awk -F, 'NR == 1 { n = NF; next } NF != n { exit 1 } END { exit !(NR >= 12) }' one/speed_error.csv && head -n 1 one/speed_error.csv | grep -q '^group,settings,dt,.*seconds.*trajectory_error.*heap_z_error.*on_front' &&
        [ "$(awk -F, '$NF == "done" && $(NF - 1) == 1' one/speed_error.csv | wc -l)" -gt 0 ]
}
check 'a row a variant, some on the front' columns
converges() {
    less "$(field one/speed_error.csv 'dt x 0.5' trajectory_error)" "$(field one/speed_error.csv 'as it is' trajectory_error)" &&
        less "$(field one/speed_error.csv 'as it is' trajectory_error)" "$(field one/speed_error.csv 'dt x 1.5' trajectory_error)"
}
check 'the error grows with the step' converges
exact() { # skins and indexes change no more than rounding
    local settings
    for settings in 'skin / 2' 'skin x 2' 'index brute' 'index linkcell' '1 size class' reproducible; do
        within "$(field one/speed_error.csv "$settings" trajectory_error)" "$(field one/speed_error.csv 'as it is' trajectory_error)" 1e-9 || return 1
    done
}
check 'skin, index and classes change nothing' exact
physics() { less "$(field one/speed_error.csv 'as it is' trajectory_error)" "$(field one/speed_error.csv 'hooke for hertz' trajectory_error)" &&
    less 0.001 "$(field one/speed_error.csv 'no friction' energy_rotational_error)"; }
check 'another law changes more than the step' physics
order() { # of the reference's trajectory: at least the first
    awk -F, '$1 == "trajectory" { found = 1; exit !($7 < 0.01 && $8 > 0.8) } END { exit !found }' one/speed_error_reference.csv
}
check 'the reference has converged' order
check 'advice is given' grep -q '^advice: .* times as fast' said
plotted() { grep -q '<svg' one/speed_error.svg && ! grep -q warning told; }
labelled() { # labels neither overlap nor leave the picture; each of the front has one; nothing stands below the floor
    awk -v width=900 -v height=560 '
        /^set label / {
            split($0, quoted, "\047")
            match($0, /screen [0-9.]+,[0-9.]+/)
            split(substr($0, RSTART + 7, RLENGTH - 7), at, ",")
            n++
            half = length(quoted[2]) * 6.2 / 2
            left[n] = at[1] * width - half; right[n] = at[1] * width + half; y[n] = at[2] * height; text[n] = quoted[2]
            if (left[n] < 0 || right[n] > width || y[n] < 0 || y[n] > height) { print "  outside: " text[n]; bad = 1 }
        }
        /^plot / { floor = $2 }
        /^\$/ { front = $1 == "$front" }
        /^[0-9.e+-]+ [0-9.e+-]+$/ { shown[++points] = $2; fronts += front }
        END {
            for (a = 1; a <= n; a++)
                for (b = 1; b < a; b++)
                    if (left[a] < right[b] && left[b] < right[a] && (y[a] - y[b])^2 < 12^2) { print "  one over the other: " text[a] ", " text[b]; bad = 1 }
            for (k = 1; k <= points; k++)
                if (shown[k] < floor * 0.99999) { print "  below the floor: " shown[k]; bad = 1 }
            print "  " n " labels, " fronts " points on the front, floor " floor
            exit bad || n < fronts + 1 || fronts < 1 || floor <= 0
        }' one/speed_error.gp || return 1
    while IFS= read -r settings; do
        grep -qF "set label '$settings' at " one/speed_error.gp || { echo "  no label: $settings"; return 1; }
    done < <(awk -F, '$(NF - 1) == 1 { print $2 }' one/speed_error.csv)
}
if command -v gnuplot >/dev/null; then check 'a plot is made' plotted; check 'whose labels can be read' labelled; else skip 'plots: no gnuplot here'; fi
kept() { # the processor's seconds are those that count for one thread alone; what was said is kept
    less 0 "$(field one/speed_error.csv 'dt x 1.5' cpu_seconds)" &&
        within "$(field one/speed_error.csv 'dt x 1.5' cpu_seconds)" "$(field one/speed_error.csv 'dt x 1.5' seconds)" 1e-9 &&
        cmp said one/speed_error.txt && grep -q '^measured on .*: 1 rank, 1 thread each' said
}
check 'what was said and measured on is kept' kept
each_kind() { local kind; for kind in step integrator law skin index classes order; do grep -q "^  $kind  *[^ ].* times as fast, .* off by" said || { echo "  nothing on $kind"; return 1; }; done; grep -q '^  law  *no friction: .*more than is allowed' said; }
check 'there is advice on each kind of setting' each_kind

same_on_ranks() {
    study 2 two --duration 0.025 --judge heap_z && study 1 three --duration 0.025 --judge heap_z &&
        within "$(field two/speed_error.csv 'dt x 1.5' trajectory_error)" "$(field three/speed_error.csv 'dt x 1.5' trajectory_error)" 1e-8
}
check 'two ranks find the same error' same_on_ranks
only() { # the kinds asked for, with the errors of the study of all
    study 1 only --duration 0.025 --judge heap_z --only step,skin && [ "$(awk -F, 'NR > 1 && $1 != "combined" { print $1 }' only/speed_error.csv | sort -u | tr '\n' ' ')" = 'scene skin step ' ] &&
        within "$(field only/speed_error.csv 'dt x 1.5' trajectory_error)" "$(field three/speed_error.csv 'dt x 1.5' trajectory_error)" 1e-12 || { cat said only/speed_error.csv; return 1; }
}
check 'kinds of settings can be chosen' only

means() {
    study 1 four --duration 0.1 --judge energy_kinetic --mean-from 0.05 && grep -q 'judged by their means from t = 0.05 on' said &&
        within "$(field four/speed_error.csv 'index linkcell' energy_kinetic_error)" "$(field four/speed_error.csv 'as it is' energy_kinetic_error)" 1e-9 &&
        less "$(field four/speed_error.csv 'as it is' energy_kinetic_error)" "$(field four/speed_error.csv 'no friction' energy_kinetic_error)" &&
        [ "$(field four/speed_error.csv 'no friction' energy_kinetic_error)" != "$(field one/speed_error.csv 'no friction' energy_kinetic_error)" ]
}
check 'columns can be judged by their means' means

# No step beyond the stable one is tried, so none is advised: here contacts of the start allow a quarter of what contacts to come would
cat >crystal.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [7.8, 7.8, 7.8], periodic: true}
threads: 1
step: {fraction: 0.45, contacts: 1, rebuild_every: 10}
duration: 0.5
contact: {law: hertz}
materials: [{name: soft, density: 1, young: 1e4, poisson: 0.3}]
material_pairs: [{restitution: 0.9, friction: 0.4}]
particles: {from: file, file: crystal.txt, format: table}
EOS
awk 'BEGIN { srand(1); print "x y z vx vy vz radius"; for (k = 0; k < 64; k++) print k % 4 * 1.95, int(k / 4) % 4 * 1.95, int(k / 16) * 1.95,
    0.02 * rand() - 0.01, 0.02 * rand() - 0.01, 0.02 * rand() - 0.01, 1 }' >crystal.txt
stable_alone() {
    local stable
    stable=$("$scree" check --all crystal.yaml | sed -n 's/^  stable  *\([0-9.e+-]*\) .*/\1/p')
    on 1 "$scree" ablate crystal.yaml --error -o stable --samples 2 --repeat 1 >said 2>told || { cat said told; return 1; }
    awk -F, -v stable="$stable" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        { part = $at["dt_of_stable"]; if (!(part <= 0.95)) { print "  " $2 ": " part " of its stable step"; bad = 1 } }
        $1 == "step" || $1 == "combined" { part = $at["dt"] / stable; if (part > most) most = part; if ($NF != "done") { print "  " $2 ": " $NF; bad = 1 } }
        END { print "  steps up to " most " of the stable one, " stable; exit bad || !(most > 0.8 && most <= 0.95) }' stable/speed_error.csv &&
        awk '/^advice: .* of the stable step/ { n++; match($0, /\([0-9.e+-]* of the stable/); if (!(substr($0, RSTART + 1) + 0 <= 0.95)) bad = 1 } END { exit bad || !n }' said || { cat said; return 1; }
}
check 'no step beyond the stable one is tried or advised' stable_alone

refuses() { # WORDS FLAG...
    local words=$1
    shift
    on 1 "$scree" ablate scene.yaml "$@" >said 2>&1
    [ $? = 2 ] && holds said "$words" && [ ! -e "$out/refused" ]
}
check 'unknown columns are refused' refuses 'allowed: trajectory, energy_kinetic' --error -o five --duration 0.05 --judge weather
check 'flags of the other table are refused' refuses 'does not take' --error -o six --threads 1
check 'a span of nothing is refused' refuses 'allowed: numbers' --error -o seven --duration 0
check 'unknown kinds of settings are refused' refuses 'allowed in this scene: step, integrator, law, stiffness, skin, index, classes, order' --error -o refused --only step,weather
check 'a mean beyond the end is refused' refuses 'allowed: numbers' --error -o eight --duration 0.01 --mean-from 1
many=$(for k in $(seq 43); do printf '{name: stress, label: s%d}, ' "$k"; done)
check 'more columns than can be compared are refused' refuses 'makes 258 columns; scree ablate --error compares up to 256' --error -o nine --duration 0.05 --set "observables.list=[${many%, }]"

check 'a study without contacts is refused' refuses 'nothing touches (never in the whole run)' --error -o refused --duration 0.05 --set 'gravity=[0, 0, 0]' \
    --set 'particles={from: single, position: [4, 4, 4], radius: 0.4, velocity: [20, 0, 0]}'
check 'a table of too few steps to rebuild, too' refuses 'no list of pairs is made again (the first time is at step ' -o refused --steps 2
check 'which says how many are needed' holds said 'needed: '

table() { # brute force comes last; what will be done stands first
    on 1 "$scree" ablate scene.yaml -o table --newton on --threads 1 --steps 200 >said 2>told || { cat said told; return 1; }
    head -n 1 said | grep -qx '6 runs; index linkcell, multi, bytype, hgrid, auto, brute; newton on; threads 1' &&
        sed -n 2p said | grep -q '^  60 particles, 200 steps each: about 0:0.* a run, 0:0.* in all' || { cat said; return 1; }
    [ "$(wc -l <table/ablate.csv)" = 7 ] && tail -n 1 table/ablate.csv | grep -q ^brute && tail -n 1 said | grep -q '^  brute ' &&
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } $at["rebuilds"] < 1 || $at["pairs"] != pairs && NR > 2 { exit 1 } { pairs = $at["pairs"] }' table/ablate.csv || { cat table/ablate.csv; return 1; }
}
check 'a table says first what it will do, and runs brute force last' table
varied() { # keys of the scene: all combinations, the other axes as the scene has them; one that the scene refuses is left out; the same in JSON
    on 1 "$scree" ablate scene.yaml -o varied --steps 200 --vary step.dt=0.001,0.0005 --vary 'gravity=[0, 0, -10],[0, 0, -9]' --vary materials[0].density=1,-1 >said 2>told || { cat said told; return 1; }
    head -n 1 said | grep -qxF '8 runs; step.dt 0.001, 0.0005; gravity [0, 0, -10], [0, 0, -9]; materials[0].density 1, -1' &&
        [ "$(grep -c 'density -1: left out: ' said)" = 4 ] && head -n 1 varied/ablate.csv | grep -qF 'index,newton,step.dt,gravity,materials[0].density,ranks' || { cat said varied/ablate.csv; return 1; }
    /usr/bin/python3 - <<'EOP'
import csv, json
lines = [json.loads(line) for line in open('varied/ablate.jsonl')]
rows = list(csv.DictReader(open('varied/ablate.csv')))
keys = [(r['step.dt'], r['gravity']) for r in rows]
assert keys == [('0.001', '[0, 0, -10]'), ('0.001', '[0, 0, -9]'), ('0.0005', '[0, 0, -10]'), ('0.0005', '[0, 0, -9]')], keys
assert [float(r['dt']) for r in rows] == [l['dt'] for l in lines] == [0.001, 0.001, 0.0005, 0.0005]
assert all(l['sweeps'] is None and l['steps'] == 200 for l in lines) and list(lines[0]) == list(rows[0])
EOP
}
check 'any key of the scene can vary' varied
check 'a list without values is refused' refuses 'must read KEY=VALUE' -o refused --vary step.dt
check 'where all values are refused, so is the whole' refuses 'density' -o none --steps 200 --vary materials[0].density=-1
dear() { # 60,000 spheres that touch, searched at each step
    on 1 "$scree" ablate scene.yaml -o dear --newton on --threads 1 --steps 20 --set step.rebuild_every=1 --set step.dt=1e-5 --set 'box.upper=[80, 80, 80]' \
        --set 'classes=~' --set 'particles={from: lattice, lattice: sc, spacing: 2, sizes: 1, velocity_sigma: 1, region: {shape: box, lower: [0, 0, 0], upper: [80, 80, 76]}}' \
        --set 'walls=~' --set 'gravity=[0, 0, 0]' >said 2>told || { cat said told; return 1; }
    grep -q '^  brute .* left out: it would take about .*; --index brute runs it all the same' said && [ "$(grep -c '^  [a-z]* .*rebuild [0-9]' said)" = 5 ] &&
        lacks dear/ablate.csv brute || { cat said; return 1; }
}
check 'brute force is left out where it would take too long' dear

unlike() { # ranks that could have different numbers of threads make the same runs: those of rank 0
    on 2 bash -c 'OMP_NUM_THREADS=$((1 + ${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-0}})) exec "$@"' _ \
        "$scree" ablate scene.yaml -o unlike --index brute --newton on --steps 200 >said 2>&1 || { cat said; return 1; }
    [ "$(cut -d, -f1-4 unlike/ablate.csv | tail -n +2)" = brute,on,2,1 ] || { cat unlike/ablate.csv; return 1; }
}
check 'ranks with unlike numbers of threads make the same runs' unlike

# A solver of contacts beside explicit runs of the same scene, whose stiffest is the reference
cat >solved.yaml <<'EOS'
box: {lower: [0, 0, 0], upper: [8 mm, 8 mm, 40 mm]}
gravity: [0, 0, -9.81]
threads: 1
step: {dt: 1e-4}
duration: 0.01
contact: {law: rigid, solver: {sweeps: 12}}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.5, friction: 0.4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: lattice, lattice: sc, spacing: 2.1 mm, sizes: 1 mm, region: {shape: box, lower: [0, 0, 0], upper: [7 mm, 7 mm, 5 mm]}}
observables: {every: 20, list: [{name: centre, label: heap, components: z}, {name: wall_force, target: floor, components: z}, {name: contact_sweeps}]}
guards: {residual: "off"}
EOS
solved() {
    on 1 "$scree" ablate solved.yaml --error -o solved --samples 5 --repeat 1 --members 2 --young 2e7 --only explicit,solver --vary contact.solver.repair=0.001 >said 2>told || { cat said told; return 1; }
    grep -q '^scree: reference 3 of 3: explicit 20 MPa at 0.15 of stable step, ' told && grep -q 'contact_sweeps .*(not judged)' said || { cat said told; return 1; }
    # softer is farther from the reference, and takes longer steps; the scene's own is near it
    /usr/bin/python3 - <<'EOP'
import json
rows = {r['settings']: r for r in (json.loads(line) for line in open('solved/speed_error.jsonl'))}
soft, real, hard = rows['explicit 5 MPa at 0.6 of stable step'], rows['explicit 20 MPa at 0.6 of stable step'], rows['as it is']
for name in ('4 sweeps', '36 sweeps', 'kappa 9.87', 'kappa 394.8', 'newton', 'contact.solver.repair=0.001'):
    assert name in rows, (name, list(rows))
assert real['heap_z_error'] < soft['heap_z_error'], (real, soft)
assert real['dt'] < 0.6 * soft['dt'] < 0.6 * hard['dt'], (real, soft, hard)
assert hard['heap_z_error'] < 0.1, hard
assert '1 GPa' not in str(list(rows))
EOP
}
check 'a solver is set beside explicit runs' solved
many() { # an explicit run has two keys of each material
    on 1 "$scree" ablate solved.yaml --error -o many --samples 2 --repeat 1 --members 2 --young 2e5 --duration 0.02 --only skin \
        --set "materials=[$(for k in $(seq 200); do printf '{name: m%d, density: 2500}, ' "$k"; done){name: glass, density: 2500}]" \
        --set particles.material=glass --set walls[0].material=glass >said 2>told && grep -q '^scree: reference 3 of 3: explicit 0.2 MPa at 0.15 of stable step, ' told || { cat said told; return 1; }
}
check 'of many materials, too' many

# takes_signals PID: it is the program, and has its own way with SIGTERM
takes_signals() {
    [ "$(cat /proc/"$1"/comm 2>/dev/null)" = "$(basename "$scree")" ] &&
        [ $((0x0$(awk '/^SigCgt/ { print $2 }' /proc/"$1"/status) >> 14 & 1)) = 1 ]
}
at_work() { # for wait_until: sets `program`
    program=$(awk '{ print $1 }' /proc/$starter/task/$starter/children 2>/dev/null)
    [ -n "$program" ] && takes_signals "$program" && { [ -z "$file" ] || [ -s "$file" ]; }
}
# ended DIR FILE FLAG...: SIGTERM while the first run goes on and, if a file is named, once it holds a line; the program says so and
# goes no further
ended() {
    local dir=$1 file=$2 starter program status
    shift 2
    timeout "$limit" "$scree" ablate scene.yaml -o "$dir" "$@" >said 2>told &
    starter=$!
    wait_until at_work
    kill -TERM "$program" || { cat told; return 1; }
    wait $starter
    status=$?
    [ $status = 143 ] && holds told 'scree: ended by signal 15' && lacks said advice || { echo "  status $status"; cat told; return 1; }
}
check 'a signal ends a table of times, with status 143' ended ended-table ended-table/ablate.csv --threads 1 --index brute,linkcell --steps 100000000
check 'what was written is kept' grep -q '^index,newton,ranks' ended-table/ablate.csv
check 'a signal ends a study, with status 143' ended ended-study '' --error --duration 100000 --samples 2
finish
