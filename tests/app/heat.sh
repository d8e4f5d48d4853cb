#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Heat between grains: against sums over all pairs on each index, ranks and threads; closed forms of a chain, of one grain and of
# a gap of gas; conservation, resume, layouts, the limit of the step, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

awk 'BEGIN { srand(3); for (i = 0; i < 6; i++) for (j = 0; j < 6; j++) for (k = 0; k < 10; k++)
    printf "%.9f %.9f %.9f %.9f\n", 0.096 + 0.009 * rand(), 0.095 + 0.19 * i, 0.095 + 0.19 * j, 0.095 + 0.19 * k }' >bed.txt
cat >bed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1.14, 1.14, 1.9], periodic: [true, true, false]}
step: {count: 60, dt: 0.002}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0.3}]
groups: [{name: bed, motion: frozen}]
walls:
  - {name: hot, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: lid, shape: plane, point: [0, 0, 1.9], normal: [0, 0, -1]}
particles: {sources: [{from: file, format: table, file: bed.txt, columns: [radius, x, y, z], group: bed}]}
heat:
  temperature: 300
  gas: {conductivity: 0.3, distance: 0.02, roughness: 0.001}
  materials: [{conductivity: 2, capacity: 3}]
  walls: [{wall: hot, temperature: 400}, {wall: lid, flux: -5}]
observables: {every: 20, list: [{name: temperature}, {name: heat_walls}]}
output: {dump: {every: 60, fields: [id, position, radius, temperature, heat_flow, heat_wall_flow]}}
YAML

# flows DIR: the flows of the last frame against sums over all pairs and walls
flows() {
    tail -n "+$(grep -n '^ITEM: TIMESTEP' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" >last
    awk '
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        reading { n++; x[n] = $at["x"]; y[n] = $at["y"]; z[n] = $at["z"]; r[n] = $at["radius"]; T[n] = $at["temperature"]
            shown[n] = $at["heat_flow"]; wall[n] = $at["heat_wall_flow"] }
        function near(d) { return d - 1.14 * int(d / 1.14 + (d > 0 ? 0.5 : -0.5)) }
        function gas(R, gap) { return gap < 0.02 ? 2 * pi * 0.3 * R * log(0.02 / (gap > 0.001 ? gap : 0.001)) : 0 }
        function H(R, gap) { return (gap < 0 ? 4 * sqrt(-R * gap) : 0) + gas(R, gap) }
        function away(a, b) { a = a - b; b = b < 0 ? -b : b; a = a < 0 ? -a : a; return a / (b + 1) }
        END {
            pi = atan2(0, -1)
            for (i = 1; i <= n; i++) {
                sum = H(r[i], z[i] - r[i]) * (400 - T[i]) - (1.9 - z[i] < r[i] ? 5 * pi * r[i]^2 : 0)
                if (away(wall[i], sum) > worst) worst = away(wall[i], sum)
                for (j = 1; j <= n; j++) {
                    dx = near(x[i] - x[j]); dy = near(y[i] - y[j]); dz = z[i] - z[j]; d = sqrt(dx * dx + dy * dy + dz * dz)
                    if (i != j && d < r[i] + r[j] + 0.02) sum += H(r[i] * r[j] / (r[i] + r[j]), d - r[i] - r[j]) * (T[j] - T[i])
                }
                if (away(shown[i], sum) > worst) worst = away(shown[i], sum)
                if (T[i] > top) top = T[i]
            }
            printf "  %d grains up to %g, largest difference %.2g\n", n, top, worst
            exit !(n == 360 && top > 310 && worst < 1e-6)
        }' last >said || { cat said; return 1; }
}
bed() { # RANKS THREADS SETTING...
    local ranks=$1 threads=$2
    shift 2
    rm -rf run
    run_scene "$ranks" bed.yaml run --set "threads=$threads" "$@" && flows run
}
for index in brute linkcell hgrid; do
    check "$index" bed 1 2 --set index.name=$index
done
for ranks in 2 3 4; do
    check "$ranks ranks" bed $ranks $((ranks - 1))
done
check '2 ranks, newton off' bed 2 1 --set newton=off
check '3 ranks, reproducible' bed 3 1 --set reproducible=true
check 'pass after pass' bed 2 2 --set step.fused=off

# A chain between two walls: in the steady state the resistances of the contacts add up
cat >chain.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1.98], periodic: [true, true, false]}
step: {count: 30000, dt: 0.01}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0}]
groups: [{name: bed, motion: frozen}]
walls:
  - {name: hot, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: cold, shape: plane, point: [0, 0, 1.98], normal: [0, 0, -1]}
particles:
  sources:
    - {from: single, position: [0.5, 0.5, 0.198], radius: 0.2, group: bed}
    - {from: single, position: [0.5, 0.5, 0.594], radius: 0.2, group: bed}
    - {from: single, position: [0.5, 0.5, 0.990], radius: 0.2, group: bed}
    - {from: single, position: [0.5, 0.5, 1.386], radius: 0.2, group: bed}
    - {from: single, position: [0.5, 0.5, 1.782], radius: 0.2, group: bed}
heat: {temperature: 300, materials: [{conductivity: 0.7, capacity: 1.5}], walls: [{wall: hot, temperature: 400}, {wall: cold, temperature: 300}]}
observables: {every: 30000, list: [{name: temperature}]}
output: {dump: {every: 30000, fields: [id, temperature, heat_wall_flow]}}
YAML
chain() {
    rm -rf chain
    run_scene "$1" chain.yaml chain && tail -n 5 chain/dump.lammpstrj | sort -n | awk '
        { T[NR] = $3; flow[NR] = $4 }
        END {
            W = 1.4 * sqrt(0.2 * 0.002); H = 1.4 * sqrt(0.1 * 0.004) # 4 k k / (2 k) a
            P = 100 / (2 / W + 4 / H)
            for (k = 1; k <= 5; k++) { t = 400 - P / W - (k - 1) * P / H; d = (T[k] - t) / 100; if (d * d > worst) worst = d * d }
            printf "  power %.9g, by resistances %.9g, largest difference of temperature %.2g\n", flow[1], P, 100 * sqrt(worst)
            exit !(flow[1] / P - 1 < 1e-8 && flow[1] / P - 1 > -1e-8 && flow[5] / P + 1 < 1e-8 && flow[5] / P + 1 > -1e-8 && worst < 1e-16)
        }'
}
check 'a chain between walls: resistances in series' chain 1
check 'a chain between walls, 3 ranks' chain 3

# One grain on a hot wall: T = 400 - 100 exp(-H t / (m c)), the error of first order in the step
alone() {
    rm -rf alone && run_scene 1 chain.yaml alone --set step.dt="$1" --set step.count="$2" --set particles.sources='[{from: single, position: [0.5, 0.5, 0.198], radius: 0.2, group: bed}]' \
        --set output.dump.every="$2" --set observables.every="$2" && tail -n 1 alone/dump.lammpstrj | awk '
        { m = 2 * 4 / 3 * atan2(0, -1) * 0.008; t = 400 - 100 * exp(-1.4 * sqrt(0.2 * 0.002) * 2 / (m * 1.5)); printf "%.9g\n", $3 - t }'
}
exponential() {
    local coarse fine
    coarse=$(alone 0.01 200) && fine=$(alone 0.005 400) && echo "  errors $coarse, $fine" &&
        awk -v a="$coarse" -v b="$fine" 'BEGIN { exit !(a / b > 1.9 && a / b < 2.1 && a < 1 && a > -1 && 2 * b - a < 0.002 && 2 * b - a > -0.002) }'
}
check 'one grain: exponential, of first order in the step' exponential

# A wall whose temperature rises for a time unit from 300 to 350 and stays, by a table, and in the same way by stages: a grain of the time
# constant s = m c / H that begins at T0 follows T(1) = 300 + 50 (1 - s (1 - e)) + (T0 - 300) e, T(2) = 350 + (T(1) - 350) e with e = exp(-1 / s)
printf '# t T\n-1 300\n0 300\n1 350\n' >oven.txt
oven() { # STEP COUNT RANKS SETTING...: the difference after two time units
    local count=$2
    rm -rf oven && run_scene "$3" chain.yaml oven --set step.dt="$1" --set step.count="$count" --set output.dump.every="$count" --set observables.every="$count" \
        --set particles.sources='[{from: single, position: [0.5, 0.5, 0.198], radius: 0.2, group: bed, temperature: 320}]' "${@:4}" && tail -n 1 oven/dump.lammpstrj
}
by_table() { # RANKS
    local coarse fine
    coarse=$(oven 0.01 200 "$1" --set 'heat.walls=[{wall: hot, table: oven.txt}]') && fine=$(oven 0.005 400 "$1" --set 'heat.walls=[{wall: hot, table: oven.txt}]') &&
        echo "$coarse $fine" | awk '{ s = 2 * 4 / 3 * atan2(0, -1) * 0.008 * 1.5 / (1.4 * sqrt(0.2 * 0.002)); e = exp(-1 / s)
            t = 300 + 50 * (1 - s * (1 - e)) + 20 * e; t = 350 + (t - 350) * e; a = $3 - t; b = $7 - t; printf "  errors %g, %g\n", a, b
            exit !(a < 0.2 && a > -0.2 && 2 * b - a < 0.0005 && 2 * b - a > -0.0005) }'
}
check 'the temperature of a wall by a table, the first temperature by the source' by_table 1
check 'the same on 2 ranks' by_table 2
cat >ramp.yaml <<'YAML'
stages:
  - {name: hot, duration: 1}
  - {name: cold, duration: 1, set: {"heat.walls[0].temperature": 280}}
YAML
by_stages() { # two stages of constant temperatures, 400 and 280
    { grep -v '^step:' chain.yaml && cat ramp.yaml && echo 'step: {dt: 0.002}'; } >staged.yaml
    rm -rf staged && run_scene 1 staged.yaml staged --set output.dump.every=1000 --set observables.every=1000 \
        --set particles.sources='[{from: single, position: [0.5, 0.5, 0.198], radius: 0.2, group: bed}]' && tail -n 1 staged/dump.lammpstrj |
        awk '{ s = 2 * 4 / 3 * atan2(0, -1) * 0.008 * 1.5 / (1.4 * sqrt(0.2 * 0.002)); e = exp(-1 / s); t = 400 - 100 * e; t = 280 + (t - 280) * e
            printf "  %g, exact %g\n", $3, t; exit !($3 - t < 0.1 && t - $3 < 0.1) }'
}
check 'the temperature of a wall by stages' by_stages
by_resume() { # a resume in the middle of the table gives the same bits
    local set=(--set step.count=200 --set output.dump.every=200 --set observables.every=200 --set output.checkpoint.every=100 --set step.dt=0.004 --set 'heat.walls=[{wall: hot, table: oven.txt}]')
    rm -rf whole rest && run_scene 1 chain.yaml whole "${set[@]}" && run_scene 2 chain.yaml rest "${set[@]}" --resume whole/checkpoint-100.h5 &&
        tail -n 5 whole/dump.lammpstrj | cmp - <(tail -n 5 rest/dump.lammpstrj)
}
check 'a resume within the table' by_resume
sources() { # grains of two sources, inserted ones and the members of a body, with temperatures of their own; nothing touches
    cat >sources.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [9, 9, 9], periodic: true}
step: {count: 101, dt: 0.01}
contact: {law: hooke}
materials: [{name: a, density: 200}, {name: b, density: 200}]
material_pairs: [{k_n: 10, restitution: 0.9}]
particles:
  sources:
    - {from: single, position: [1, 1, 1], radius: 0.2, material: a, temperature: 350}
    - {from: single, position: [3, 1, 1], radius: 0.2, material: a}
    - {from: single, position: [5, 1, 1], radius: 0.2, material: b, temperature: 333}
bodies: {clumps: [{material: b, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]}
heat: {temperature: 300, materials: [{conductivity: 1, capacity: 1}]}
observables: {every: 101, list: [{name: temperature}]}
output: {dump: {every: 101, fields: [id, kind, temperature]}}
YAML
    rm -rf sources inserted && run_scene "$1" sources.yaml sources && tail -n 5 sources/dump.lammpstrj | sort -n | awk '$4 == 0 { t[n++] = $3 } END { exit !(n == 4 && t[0] == 350 && t[1] == 300 && t[2] == 333 && t[3] == 333) }' || return 1
    run_scene "$1" sources.yaml inserted --set 'bodies=~' --set particles.sources='[{from: single, position: [1, 1, 1], radius: 0.2, material: a, temperature: 350}]' \
        --set 'insertions=[{material: a, rate: 1, sizes: 0.1, temperature: 280, region: {shape: box, lower: [4, 4, 4], upper: [8, 8, 8]}}]' --set 'output.dump.fields=[id, temperature]' &&
        tail -n 2 inserted/dump.lammpstrj | sort -n | awk '{ t[NR] = $3 } END { exit !(t[1] == 350 && t[2] == 280) }'
}
check 'temperatures of sources, of insertions and of bodies' sources 1
check 'the same on 2 ranks' sources 2

# Soft grains: the contact radius over the cube root of softening
softened() {
    run_scene 1 chain.yaml soft --set heat.softening=1000 --set step.count=1 --set output.dump.every=1 --set observables.every=1 &&
        run_scene 1 chain.yaml hard --set step.count=1 --set output.dump.every=1 --set observables.every=1 &&
        tail -n 5 soft/dump.lammpstrj | sort -n | head -n 1 >a && tail -n 5 hard/dump.lammpstrj | sort -n | head -n 1 |
        cat - a | awk '{ f[NR] = $4 } END { exit !(f[1] / f[2] > 9.9 && f[1] / f[2] < 10.1) }'
}
check 'softening' softened

# Grains that move: heat is conserved, layouts and resumes give the same bits
cat >gas.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4.5, 4.5, 4.5], periodic: true}
step: {count: 800, dt: 0.0015}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{k_n: 1000, restitution: 0.95, friction: 0.3}]
particles:
  sources:
    - {from: random, count: 40, sizes: {law: fixed, radius: 0.35}, velocity_sigma: 1, material: b}
    - {from: random, count: 300, sizes: {law: uniform, min: 0.15, max: 0.25}, velocity_sigma: 1, material: a}
walls: [{name: heater, shape: cylinder, point: [2, 2, 2], axis: [0, 0, 1], radius: 0.3, inside: false, material: a}]
heat:
  gas: {conductivity: 0.1, distance: 0.05, roughness: 0.001}
  materials: [{conductivity: 1, capacity: 1}, {material: b, conductivity: 20, capacity: 2}]
  walls: [{wall: heater, temperature: 500}]
skin: 0.05
reproducible: true
observables: {every: 100, list: [{name: temperature}, {name: heat_walls}]}
output: {dump: {every: 400, fields: [id, position, temperature, heat_flow]}, checkpoint: {every: 400}}
YAML
rows() { tail -n 340 "$1/dump.lammpstrj" | sort -n; }
layouts() {
    run_scene 1 gas.yaml one --set threads=1 && rows one >one.rows &&
        awk '{ if ($6 > top) top = $6; if ($6 < least || !least) least = $6 } END { exit !(top > 300 && least < 294) }' one.rows || return 1
    for layout in '1 2' '3 1' '2 2'; do
        # shellcheck disable=SC2086
        set -- $layout
        run_scene "$1" gas.yaml other --set "threads=$2" --overwrite && rows other | cmp - one.rows || { echo "  $layout"; return 1; }
    done
}
check 'the same bits on any layout' layouts
resumes() {
    run_scene 1 gas.yaml more --set threads=1 --resume one/checkpoint-400.h5 && rows more | cmp - one.rows
}
check 'a resume gives the same bits' resumes
conserved() {
    run_scene 2 gas.yaml closed --set 'heat.walls=[{wall: heater, flux: 0}]' --set reproducible=false &&
        awk -F , 'NR > 1 { exit !($2 > 293.1499999 && $4 < 293.1500001) }' closed/observables.csv
}
check 'without differences nothing flows' conserved
# Friction, dampers and plastic flow warm the grains: what the grains gain is what the contacts lose, springs that end loaded included
warmed() { # RANKS PART SETTING...
    local ranks=$1 part=$2
    shift 2
    rm -rf warm
    run_scene "$ranks" gas.yaml warm --set heat.dissipation="$part" --set heat.walls='[]' --set 'observables.list=[{name: energy_thermal}, {name: energy_dissipated}]' \
        --set 'material_pairs[0].restitution=0.6' --set 'output.dump=~' --set step.dt=0.0008 "$@" && awk -F , -v part="$part" '
        NR == 2 { begin = $2 } { gain = $2 - begin; lost = part * $3 }
        END { printf "  lost %.9g, gained %.9g\n", lost, gain; exit !(lost > 0.1 && gain / lost - 1 < 1e-9 && gain / lost - 1 > -1e-9) }' warm/observables.csv
}
check 'what contacts lose warms the grains' warmed 1 1 --set threads=2
check 'a part of it, on 3 ranks' warmed 3 0.25 --set reproducible=false
check 'plastic contacts and rolling, 2 ranks' warmed 2 1 --set contact='{law: luding, rolling: epsd}' \
    --set 'material_pairs=[{k_n: 1000, k_2: 2000, k_c: 200, restitution: 0.9, friction: 0.3, rolling_friction: 0.1}]'
warm_resume() {
    rm -rf warm more
    run_scene 1 gas.yaml warm --set heat.dissipation=1 && run_scene 2 gas.yaml more --set heat.dissipation=1 --resume warm/checkpoint-400.h5 && rows warm >a && rows more | cmp - a
}
check 'a resume of it gives the same bits, on two ranks' warm_resume
each_wall() { # RANKS FLAG...: the power of each wall in the steady chain
    rm -rf walls
    run_scene "$1" chain.yaml walls "${@:2}" --set 'observables.list=[{name: heat_wall}, {name: heat_walls}]' --set step.count=20000 --set observables.every=20000 --set 'output.dump=~' &&
        tail -n 1 walls/observables.csv | awk -F , '{ H = 1.4 * sqrt(0.1 * 0.004); W = 1.4 * sqrt(0.2 * 0.002); P = 100 / (2 / W + 4 / H)
            printf "  %s\n", $0; exit !($2 / P > 0.999999 && $2 / P < 1.000001 && $3 / P < -0.999999 && $3 / P > -1.000001 && $4 - $2 - $3 < 1e-12 && $4 - $2 - $3 > -1e-12) }'
}
check 'power of each wall' each_wall 2
check 'power of each wall, on two threads' each_wall 1 --set threads=2
check 'an entry with a name goes over the one without' each_wall 1 \
    --set 'heat.materials=[{material: a, conductivity: 0.7, capacity: 1.5}, {conductivity: 9, capacity: 9}]'
# Contacts that are pulled apart, from an overlap to a neck across a gap: the law's contact radius, by hand for each law
cat >neck.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 8, 8]}
step: {dt: 0.001, count: 1000, force: true}
contact: {law: hertz, tangential: none, cohesion: {law: jkr}}
materials: [{name: a, density: 1, young: 1000, poisson: 0}]
material_pairs: [{restitution: 1, surface_energy: 0.5}]
walls: [{name: hot, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
groups:
  - {name: one, motion: moving, velocity: [0, 0, 0.035]}
  - {name: two, motion: moving, velocity: [0, 0, 0.07]}
particles:
  sources:
    - {from: single, position: [4, 4, 0.98], radius: 1, group: one}
    - {from: single, position: [4, 4, 2.96], radius: 1, group: two}
heat: {temperature: 300, materials: [{conductivity: 10, capacity: 1}], walls: [{wall: hot, temperature: 400}]}
observables: {every: 100, list: [{name: sum, label: one, of: "temperature*(id==1)"}, {name: sum, label: two, of: "temperature*(id==2)"}]}
EOS
cat >neck.awk <<'EOS'
function sticky(d, r,   s, low, high, a, k) { # JKR: the largest a with a^2/R - s sqrt(a) = d
    s = 2 * sqrt(pi * 0.5 / modulus); low = (s * r / 4) ^ (2 / 3); high = 1
    for (k = 0; k < 60; k++) { a = (low + high) / 2; if (a * a / r - s * sqrt(a) < d) low = a; else high = a }
    return a
}
function flowed(d, r,   yield, a, force, flat, left) { # Thornton: unloading with the flattened radius from the largest overlap, 0.02
    yield = pi * 20 * r / (2 * modulus); a = sqrt(r * 0.02)
    force = 4 / 3 * modulus * yield ^ 3 / r + pi * 20 * (a * a - yield * yield)
    flat = 4 / 3 * modulus * a ^ 3 / force; left = 0.02 - a * a / flat
    return d > left ? sqrt(flat * (d - left)) : 0
}
function radius(d, r) { return law == "jkr" ? sticky(d, r) : law == "thornton" ? flowed(d, r) : d > 0 ? sqrt(r * d) : 0 }
function gas(r, d,   g) { g = law == "jkr" || d > 0 ? 0.001 : -d > 0.001 ? -d : 0.001; return conductivity > 0 && g < 0.05 ? 2 * pi * conductivity * r * log(0.05 / g) : 0 }
BEGIN {
    pi = 3.14159265358979; modulus = 500; one = two = 300
    for (n = 0; n < 1000; n++) {
        d = 0.02 - 0.035 * 0.001 * n
        w = (20 * radius(d, 1) + gas(1, d)) * (400 - one); p = (20 * radius(d, 0.5) + gas(0.5, d)) * (one - two)
        one += 0.001 * (w - p) / (4 / 3 * pi); two += 0.001 * p / (4 / 3 * pi)
    }
    printf "%.12g %.12g\n", one, two
}
EOS
necks() { # LAW CONDUCTIVITY RANKS FLAG...: both temperatures at the end
    run_scene "$3" neck.yaml neck --overwrite "${@:4}" || return 1
    set -- $(awk -v law="$1" -v conductivity="$2" -f neck.awk) $(awk -F, 'END { print $2, $3 }' neck/observables.csv)
    within "$3" "$1" 1e-7 && within "$4" "$2" 1e-7
}
plastic=(--set 'contact={law: thornton, tangential: none}' --set 'material_pairs=[{restitution: 1, yield_pressure: 20}]')
check 'heat flows through a neck of JKR with its contact radius' necks jkr 0 1
check 'on two ranks, too' necks jkr 0 2 --set newton=false
check 'the gas around a neck is as that around contacts' necks jkr 0.3 1 --set 'heat.gas={conductivity: 0.3, distance: 0.05, roughness: 0.001}'
check 'flattened surfaces' necks thornton 0 1 "${plastic[@]}"
check 'Hertz with gas' necks hertz 0.3 1 --set 'contact={law: hertz, tangential: none}' --set 'material_pairs=[{restitution: 1}]' \
    --set 'heat.gas={conductivity: 0.3, distance: 0.05, roughness: 0.001}'
check 'DMT' necks hertz 0 1 --set 'contact={law: hertz, tangential: none, cohesion: {law: dmt}}'
resumed_neck() { # within the neck: what a contact remembers goes on
    run_scene 1 neck.yaml half --overwrite --set step.count=700 && run_scene 1 neck.yaml half --overwrite --resume last || return 1
    set -- $(awk -v law=jkr -v conductivity=0 -f neck.awk) $(awk -F, 'END { print $2, $3 }' half/observables.csv)
    within "$3" "$1" 1e-7 && within "$4" "$2" 1e-7
}
check 'after a resume, too' resumed_neck

heated_drum() { SCREE=$scree "$top_srcdir/examples/heated_drum/check" "$PWD/heated" 1500 | sed 's/^/  /'; [ "${PIPESTATUS[0]}" -eq 0 ]; }
check 'examples/heated_drum: the balance of heat, step by step' heated_drum
absent() {
    run_scene 1 gas.yaml without --set threads=1 --set 'heat=~' --set 'observables.list=[{name: energy_kinetic}]' \
        --set 'output.dump.fields=[id, position]' && rows without | cut -d ' ' -f 1-5 >cold && cut -d ' ' -f 1-5 one.rows | cmp - cold &&
        ! "$scree" check --all gas.yaml --set 'heat=~' --set 'observables.list=[{name: energy_kinetic}]' --set 'output.dump.fields=[id, position]' |
        grep -E '^  (temperature|heat_flow) +8'
}
check 'absent unless asked for, and no grain moves otherwise' absent

refused() { # TEXT SCENE SETTING...
    local text=$1 scene=$2
    shift 2
    ! "$scree" check --all "$scene" "$@" >told 2>&1 && grep -qF -- "$text" told || { cat told; return 1; }
}
check 'a step above the limit' refused 'above the stable one' chain.yaml --set step.dt=5
check 'a material is missing' refused "material 'a' is missing" gas.yaml --set 'heat.materials=[{material: b, conductivity: 1, capacity: 1}]'
check 'a material twice' refused 'a second entry for the same material' gas.yaml --set 'heat.materials=[{conductivity: 1, capacity: 1}, {conductivity: 1, capacity: 1}]'
check 'neither temperature nor flux' refused 'needs one of temperature, flux and table' gas.yaml --set 'heat.walls=[{wall: heater}]'
check 'a gas without distance' refused 'needs a roughness and a distance' gas.yaml --set 'heat.gas={conductivity: 0.1}'
printf '0 300\n0 310\n' >flat.txt
printf '0 300\n1 -3\n' >below.txt
check 'a table whose time stands' refused 'flat.txt:2: time 0 does not increase' gas.yaml --set 'heat.walls=[{wall: heater, table: flat.txt}]'
check 'a table below 0 K' refused 'below.txt:2: the temperature -3 is below 0 K' gas.yaml --set 'heat.walls=[{wall: heater, table: below.txt}]'
check 'no table' refused 'nowhere.txt' gas.yaml --set 'heat.walls=[{wall: heater, table: nowhere.txt}]'
check 'a temperature without heat' refused 'particles.sources[0].temperature: needs the section heat' gas.yaml --set 'heat=~' --set 'particles.sources[0].temperature=300' --set 'observables.list=[]'
check 'an unknown wall' refused 'heat.walls[0].wall' gas.yaml --set 'heat.walls=[{wall: nobody, temperature: 1}]'
check 'kelvins' refused 'heat.temperature' gas.yaml --set units=si --set 'heat.temperature=20 kg'
finish
