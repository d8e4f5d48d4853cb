#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Drag of grains in a given fluid: porosities and forces against sums over all pairs, on indexes, ranks and threads; energies, resume,
# layouts, the limit of the step, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# All grains move with one given velocity, so that a dump shows the velocity by which the law goes
cat >cloud.yaml <<'YAML'
units: none
box: {lower: [-1, -1, 0], upper: [2, 2, 3], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {count: 20, dt: 0.02}
contact: {law: hooke}
materials: [{name: a, density: 3}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0.3}]
groups: [{name: cloud, motion: moving, velocity: [0.7, 0.4, 0]}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: lid, shape: plane, point: [0, 0, 3], normal: [0, 0, -1]}
particles:
  sources:
    - {from: single, position: [1, 1, 1.5], radius: 0.5, group: cloud}
    - {from: random, count: 150, sizes: {law: uniform, min: 0.2, max: 0.25}, group: cloud}
skin: 0.05
drag:
  law: di_felice
  largest: 0.3
  fluid: {density: 0.5, viscosity: 0.02, velocity: [0.3, 0, 1], acceleration: [0, 0.5, 0]}
  porosity: {support: 1.3}
observables: {every: 20, list: [{name: drag_law}]}
output: {dump: {every: 20, fields: [id, position, radius, force, porosity]}}
YAML

# sums DIR LAW: the dump's last frame against a double loop
sums() {
    tail -n "+$(grep -n '^ITEM: TIMESTEP' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" >last
    awk -v law="$2" -v h=1.3 '
        BEGIN { pi = atan2(0, -1) }
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        reading { n++; x[n] = $at["x"]; y[n] = $at["y"]; z[n] = $at["z"]; r[n] = $at["radius"]; e[n] = $at["porosity"]
            f[n, 0] = $at["fx"]; f[n, 1] = $at["fy"]; f[n, 2] = $at["fz"] - (r[n] < 0.3 ? 0.5 * volume(r[n]) : 0) }
        function near(d) { return d - 3 * int(d / 3 + (d > 0 ? 0.5 : -0.5)) }
        function volume(r) { return 4 / 3 * pi * r^3 }
        function kernel(q) { return q < 1 ? 21 / (2 * pi * h^3) * (1 - q)^4 * (1 + 4 * q) : 0 }
        function front(s, k, sum, q) { # the integral over the planes before the wall, by the midpoint rule
            s /= h; if (s >= 1) return 1
            for (k = 0; k < 1000; k++) { q = s * (k + 0.5) / 1000; sum += 21 * (1 / 14 - q^2 / 2 + 2.5 * q^4 - 4 * q^5 + 2.5 * q^6 - 4 / 7 * q^7) * s / 1000 }
            return 0.5 + sum }
        function S(f) { return (1 - f)^4 / (1 + 4 * f + 4 * f^2 - 4 * f^3 + f^4) }
        function K(d, w, e, re, c) { re = 0.5 * d * w / 0.02
            if (law == "stokes") return 3 * pi * 0.02 * d
            if (law == "gidaspow" && e <= 0.8) return pi / 6 * d^3 * (150 * 0.02 * (1 - e) / (e^3 * d^2) + 1.75 * 0.5 * w / (e^3 * d))
            if (law != "di_felice") return 3 * pi * 0.02 * d * (1 + 0.15 * re^0.687) * (law == "gidaspow" ? e^-4.65 : 1)
            c = (0.63 + 4.8 / sqrt(re))^2
            return pi / 8 * 0.5 * d^2 * c * w * e^-(4.7 - 0.65 * exp(-(1.5 - log(re) / log(10))^2 / 2)) }
        function differ(a, b, size) { a = a - b; a = a < 0 ? -a : a; return a / size }
        END {
            for (i = 1; i <= n; i++) {
                others = 0; porosity = 1
                for (j = 1; j <= n && r[i] < 0.3; j++) if (j != i && r[j] < 0.3) {
                    dx = near(x[i] - x[j]); dy = near(y[i] - y[j]); dz = z[i] - z[j]
                    others += volume(r[j]) * kernel(sqrt(dx * dx + dy * dy + dz * dz) / h) }
                if (r[i] < 0.3 && law ~ /di_felice|gidaspow/) {
                    C = front(z[i]) * front(3 - z[i]); s = 0
                    for (k = 0; k < 100; k++) s = (others + volume(r[i]) * 21 / (2 * pi * h^3) * (1 - S(s))) / C
                    porosity = 1 - s; if (differ(e[i], porosity, 1) > apart) apart = differ(e[i], porosity, 1)
                    if (porosity < least || !least) least = porosity
                }
                w[0] = 0.3 - porosity * 0.7; w[1] = 0.5 * 0.4 - porosity * 0.4; w[2] = 1
                size = sqrt(w[0]^2 + w[1]^2 + w[2]^2); F = r[i] < 0.3 ? K(2 * r[i], size, porosity) : 0
                for (d = 0; d < 3; d++) total[d] += F * w[d]
                for (d = 0; d < 3; d++) if (differ(f[i, d], F * w[d], F * size + 1e-9) > off) off = differ(f[i, d], F * w[d], F * size + 1e-9)
            }
            printf "  %d grains, porosity down to %.3f, differences %.2g and %.2g\n%.12g %.12g %.12g\n", n, least, apart, off, total[0], total[1], total[2]
            exit !(n == 151 && (law !~ /di_felice|gidaspow/ || least < 0.75) && apart < 1e-5 && off < 1e-4)
        }' last >told
    local status=$?
    head -n 1 told
    [ $status = 0 ] && tail -n 1 "$1/observables.csv" | tr , ' ' | paste -d ' ' <(tail -n 1 told) - |
        awk '{ for (k = 1; k <= 3; k++) { d = $k - $(4 + k); off += d * d; size += $k * $k } exit !(off < 1e-8 * size) }'
}
cloud() { # RANKS THREADS LAW SETTING...
    local ranks=$1 threads=$2 law=$3 porosity='--set drag.porosity=~ --set output.dump.fields=[id,position,radius,force]'
    shift 3
    case $law in di_felice | gidaspow) porosity= ;; esac
    rm -rf run
    # shellcheck disable=SC2086
    run_scene "$ranks" cloud.yaml run --set "threads=$threads" --set drag.law="$law" $porosity "$@" && sums run "$law"
}
check 'di_felice, brute' cloud 1 2 di_felice --set index.name=brute
check 'di_felice, linkcell' cloud 1 1 di_felice --set index.name=linkcell
check 'gidaspow, hgrid' cloud 1 1 gidaspow --set index.name=hgrid
check 'di_felice, 2 ranks' cloud 2 1 di_felice
check 'gidaspow, 3 ranks' cloud 3 2 gidaspow
check 'di_felice, 4 ranks, newton off' cloud 4 1 di_felice --set newton=off
check 'pass after pass' cloud 1 2 gidaspow --set step.fused=off
check 'stokes, 2 ranks' cloud 2 1 stokes
check 'schiller_naumann' cloud 1 1 schiller_naumann

# Grains that settle and are carried: layouts and resumes give the same bits, and no energy is lost from the books
cat >bed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [3, 3, 8], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {count: 600, dt: 0.004}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 300, restitution: 0.6, friction: 0.3}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: lattice, lattice: sc, spacing: 0.55, jitter: 0.8, count: 150, sizes: 0.25, region: {shape: box, lower: [0, 0, 0], upper: [3, 3, 4]}}
skin: 0.05
reproducible: true
drag:
  fluid: {density: 0.5, viscosity: 0.02, velocity: [0, 0, 0.4], acceleration: [0, 0, 0.2]}
  porosity: {support: 1.3, every: 7}
observables: {every: 60, list: [{name: energy_balance}, {name: energy_kinetic}, {name: work_drag}, {name: porosity_mean}]}
output: {dump: {every: 300, fields: [id, position, velocity, porosity]}, checkpoint: {every: 300}}
YAML
rows() { tail -n 150 "$1/dump.lammpstrj" | sort -n; }
layouts() {
    run_scene 1 bed.yaml one --set threads=1 && rows one >one.rows || return 1
    for layout in '1 2' '3 1' '2 2'; do
        # shellcheck disable=SC2086
        set -- $layout
        run_scene "$1" bed.yaml other --set "threads=$2" --overwrite && rows other | cmp - one.rows || { echo "  $layout"; return 1; }
    done
}
# Two grains along an edge between two walls: the part of the kernel before both is the product of the parts
corner() {
    run_scene 1 cloud.yaml corner --set 'box.periodic=[false, true, false]' --set step.count=1 --set 'groups[0].velocity=[0, 0, 0]' \
        --set 'walls=[{name: side, shape: plane, point: [-1, 0, 0], normal: [1, 0, 0]}, {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]' \
        --set 'particles.sources=[{from: single, position: [-0.7, 1, 0.4], radius: 0.25, group: cloud}, {from: single, position: [-0.7, 1.6, 0.4], radius: 0.25, group: cloud}]' --set output.dump.every=1 || return 1
    local expected
    expected=$(awk 'function front(s, k, sum, q) { s /= 1.3
            for (k = 0; k < 4000; k++) { q = s * (k + 0.5) / 4000; sum += 21 * (1 / 14 - q^2 / 2 + 2.5 * q^4 - 4 * q^5 + 2.5 * q^6 - 4 / 7 * q^7) * s / 4000 }
            return 0.5 + sum }
        BEGIN { pi = atan2(0, -1); c = front(0.3) * front(0.4); own = 21 / (2 * pi * 1.3^3) * 4 / 3 * pi * 0.25^3
            q = 0.6 / 1.3; others = own * (1 - q)^4 * (1 + 4 * q); f = others / c
            for (k = 0; k < 50; k++) f = (others + own * (1 - (1 - f)^4 / (1 + 4 * f + 4 * f^2 - 4 * f^3 + f^4))) / c
            printf "%.12g", 1 - f }')
    awk -v e="$expected" 'BEGIN { exit e > 0.97 }' && within "$(tail -n 1 corner/dump.lammpstrj | awk '{ print $NF }')" "$expected" 1e-4
}
check 'the porosity in an edge between two walls' corner

# One grain that drag slows down: the balance is kept but for dt^2 (F_n^2 - F_0^2) / 8 m, 1e-7 here
slowed() {
    run_scene 1 cloud.yaml slowed --set step.force=true --set box.periodic=true --set 'walls=~' --set 'groups=~' --set gravity='[0, 0, 0]' --set 'drag={law: stokes, fluid: {density: 0.5, viscosity: 0.02}}' \
        --set 'particles.sources=[{from: single, position: [1, 1, 1.5], radius: 0.5, velocity: [1, 0, 0]}]' --set 'observables.list=[{name: energy_kinetic}, {name: energy_balance}]' --set 'output.dump=~' &&
        awk -F, 'NR == 2 { first = $3 } { d = $3 - first; k = $2 / first }
            END { printf "  %g of the energy is left, balance off by %.1g\n", k, d; exit !(NR == 3 && k < 0.92 && d * d < 1e-12) }' slowed/observables.csv
}
check 'the work of drag on one grain' slowed
check 'the same bits on any layout' layouts
resumes() { run_scene 2 bed.yaml more --resume one/checkpoint-300.h5 && rows more | cmp - one.rows; }
check 'a resume gives the same bits' resumes
books() { # an error of second order in the step
    run_scene 1 bed.yaml fine --set step.dt=0.002 --set step.count=1200 --set observables.every=120 --set output.dump.every=1200 &&
        for run in one fine; do awk -F , 'NR == 2 { t = $2 } NR > 2 { d = $2 - t; d = d < 0 ? -d : d; if (d > most) most = d; work = $4 } END { print most, work }' $run/observables.csv; done >off &&
        cat off && awk '{ e[NR] = $1; w = $2 < 0 ? -$2 : $2 } END { exit !(e[1] < 0.02 * w && e[2] < 0.6 * e[1] && w > 1) }' off
}
check 'the work of drag closes the balance of energies' books
absent() {
    run_scene 1 bed.yaml without --set 'drag=~' --set step.count=20 --set 'observables.list=[{name: energy_kinetic}]' --set 'output.dump=~' &&
        ! "$scree" check --all bed.yaml --set 'drag=~' --set 'observables.list=[]' --set 'output.dump.fields=[id]' | grep -E '^  (drag_force|porosity) +[0-9]'
}
check 'absent unless asked for' absent

refused() { # TEXT SETTING...
    local text=$1
    shift
    ! "$scree" check --all bed.yaml "$@" >told 2>&1 && grep -qF -- "$text" told || { cat told; return 1; }
}
check 'a step above the limit' refused 'drag: mass of a grain over its drag' --set drag.fluid.viscosity=20
told() { # RANKS: check names what sets the stable step, and all ranks find it together
    on "$1" "$scree" check bed.yaml --set drag.fluid.viscosity=20 --set step='{count: 4}' >said 2>&1 &&
        grep -qF '(drag: mass of a grain over its drag per speed)' said || { cat said; return 1; }
}
check 'check names drag where that sets the step' told 1
check 'check names drag where that sets the step, on 2 ranks' told 2
check 'a porosity without support' refused 'drag.porosity.support: is missing' --set 'drag.porosity.support=~'
check 'a porosity that the law has not' refused 'drag.porosity' --set drag.law=stokes
check 'an unknown law' refused "drag.law" --set drag.law=felice
check 'a fluid without density' refused 'drag.fluid.density: is missing' --set 'drag.fluid={viscosity: 1}'
check 'two dimensions' refused 'needs a box of three dimensions' --set box.dimension=2 --set gravity='[0, -1, 0]' --set walls='[]' \
    --set particles='{from: single, position: [1, 1, 0], radius: 0.2}' --set reproducible=false
narrow() { ! "$scree" run bed.yaml -o narrow --quiet --set drag.porosity.support=1.2 >told 2>&1 && grep -qF 'drag.porosity.support: 1.2 is too short' told || { cat told; return 1; }; }
check 'a support that is too short' narrow
finish
