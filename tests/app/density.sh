#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Number density, the example of a physics in a folder of its own: the values against a sum over all pairs, on each index, on ranks
# and threads, in periodic and open boxes, in two and three dimensions; and only two lines outside of the folder name this physics.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >cloud.yaml <<'YAML'
units: none
box: {lower: [-1, -1, -1], upper: [4, 4, 4], periodic: true}
step: {count: 20}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0.3}]
particles:
  sources:
    - {from: single, position: [1, 1, 1.5], radius: 0.9}
    - {from: random, count: 250, sizes: {law: uniform, min: 0.15, max: 0.25}, velocity_sigma: 1}
skin: 0.05
number_density: {support: 0.9}
observables: {every: 10, list: [{name: number_density}]}
output: {dump: {every: 20, fields: [id, position, number_density]}}
YAML

# sums DIR EDGE DIMENSION PARTICLES: the dump's last frame against a double loop, the last row of observables against the frame.
# EDGE 0: an open box
sums() {
    tail -n "+$(grep -n '^ITEM: TIMESTEP' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" >last
    awk -v edge="$2" -v dimension="$3" -v h=0.9 -v particles="$4" '
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
        reading { n++; x[n] = $at["x"]; y[n] = $at["y"]; z[n] = $at["z"]; shown[n] = $at["number_density"] }
        function near(d) { return edge == 0 ? d : d - edge * int(d / edge + (d > 0 ? 0.5 : -0.5)) }
        END {
            pi = atan2(0, -1); w = dimension == 2 ? 7 / (pi * h^2) : 21 / (2 * pi * h^3); min = 1e300
            for (i = 1; i <= n; i++) {
                sum = 0
                for (j = 1; j <= n; j++) {
                    dx = near(x[i] - x[j]); dy = near(y[i] - y[j]); dz = dimension == 2 ? 0 : near(z[i] - z[j])
                    r = sqrt(dx * dx + dy * dy + dz * dz) / h
                    if (r < 1) sum += w * (1 - r)^4 * (1 + 4 * r)
                }
                e = shown[i] / sum - 1; if (e < 0) e = -e; if (!(e <= worst)) worst = e
                total += sum; if (sum < min) min = sum; if (sum > max) max = sum; alone += sum < 1.0001 * w
            }
            printf "  %d particles, largest difference %.2g; %.12g %.12g %.12g\n", n, worst, min, total / n, max
            exit !(worst < 1e-9 && n == particles && alone < n / 2)
        }' last >said || { cat said; return 1; }
    awk -F '[,; ]+' 'NR == FNR { min = $(NF - 2); mean = $(NF - 1); max = $NF; next } { last = $0 }
        END { split(last, v, ","); exit !(v[2] / min - 1 < 1e-9 && v[3] / mean - 1 < 1e-9 && v[4] / max - 1 < 1e-9 &&
            v[2] / min - 1 > -1e-9 && v[3] / mean - 1 > -1e-9 && v[4] / max - 1 > -1e-9) }' said "$1/observables.csv" ||
        { cat said; tail -n 1 "$1/observables.csv"; return 1; }
}

follows() { # RANKS THREADS EDGE DIMENSION SETTING...
    local ranks=$1 threads=$2 edge=$3 dimension=$4
    shift 4
    rm -rf run
    run_scene "$ranks" cloud.yaml run --set "threads=$threads" "$@" && sums run "$edge" "$dimension" 251
}
for index in $(indexes); do
    check "$index" follows 1 2 5 3 --set index.name=$index
done
check 'open' follows 1 1 0 3 --set box.periodic=false
for ranks in 2 3 4; do
    check "$ranks ranks, as many threads" follows $ranks $ranks 5 3
done
check '4 ranks, open, 2 threads' follows 4 2 0 3 --set box.periodic=false
check '2 ranks, newton off' follows 2 1 5 3 --set newton=off
check '3 ranks, reproducible' follows 3 2 5 3 --set reproducible=true
check 'pass after pass' follows 2 2 5 3 --set step.fused=off

sed 's/count: 250/count: 60/; s/radius: 0.9}/radius: 0.4}/' cloud.yaml >flat.yaml
flat() {
    rm -rf run
    run_scene "$1" flat.yaml run --set box.dimension=2 && sums run 5 2 61
}
check 'two dimensions' flat 1
check 'two dimensions, 2 ranks' flat 2

# Absent unless asked for: the same bits without it, no field, no pair
absent() {
    run_scene 1 cloud.yaml with --set threads=1 --set output.dump.fields='[id, position]' &&
        run_scene 1 cloud.yaml without --set threads=1 --set output.dump.fields='[id, position]' --set 'number_density=~' \
            --set 'observables.list=[{name: energy}]' && cmp with/dump.lammpstrj without/dump.lammpstrj &&
        ! "$scree" check --all cloud.yaml --set 'number_density=~' --set 'observables.list=[{name: energy}]' --set 'output.dump.fields=[id]' | grep -q '^  number_density  *8'
}

check 'absent unless asked for' absent

refused() {
    ! "$scree" check --all cloud.yaml --set 'number_density.support=~' >told 2>&1 && grep -q 'number_density.support: is missing' told &&
        ! "$scree" check --all cloud.yaml --set number_density.support=5 >told 2>&1 && grep -q 'too short' told
}
check 'a support is needed, and fits the box' refused

# Without materials nothing touches: the same sums, no contact in step, memory and files; a resume goes on
untouched() {
    sed '/^contact:/d; /^materials:/d; /^material_pairs:/d; s/radius: 0.9}/radius: 0.9, density: 1}/; s/velocity_sigma: 1}/velocity_sigma: 1, density: 1}/' \
        cloud.yaml >points.yaml
    rm -rf run more
    run_scene "$1" points.yaml run --set step.dt=0.01 --set output.checkpoint.every=10 && sums run 5 3 251 &&
        ! "$scree" check --all points.yaml --set step.dt=0.01 | grep -E '^  (contact|finish|wall) |spin *[0-9]' &&
        run_scene 1 points.yaml more --set step.dt=0.01 --resume run/checkpoint-10.h5 && sums more 5 3 251 &&
        awk -F , 'FNR == 1 { next } NR == FNR { a[$1] = $3; next } { d = $3 - a[$1]; if (d * d > 1e-20) exit 1 }' \
            run/observables.csv more/observables.csv
}
check 'without materials' untouched 1
check 'without materials, 3 ranks' untouched 3
needed() {
    ! "$scree" check --all points.yaml >told 2>&1 && grep -q 'step.dt is needed' told &&
        ! "$scree" check --all cloud.yaml --set 'materials=~' >told 2>&1 && grep -q 'material_pairs: is given, but' told &&
        ! "$scree" check --all points.yaml --set 'particles.sources[0].density=0' --set step.dt=0.01 >told 2>&1 && grep -q 'has no density' told &&
        ! "$scree" check --all points.yaml --set 'number_density=~' --set 'observables.list=[]' >told 2>&1 && grep -q 'materials: is missing' told
}
check 'what a scene without materials needs' needed

# What the rest of the program knows of it; a column of a grid's table has the name of the field, too
two_lines() {
    (cd "$top_srcdir" && grep -rnE 'number_density|density_(physics|schema|fields|observables)|src/physics/density|libdensity|PHYSICS_density' \
        --include='*.c' --include='*.h' --include='*.mk' --include=Makefile.am src index Makefile.am | grep -vE '^src/physics/density/|: \* |,number_density,') >known
    cat known
    [ "$(wc -l <known)" = 2 ] && grep -q '^src/physics_table.h' known && grep -q '^Makefile.am' known
}
check 'a row of a table and a line of the makefile' two_lines
short() {
    [ "$(cat "$top_srcdir"/src/physics/density/*.[ch] | wc -l)" -le 160 ]
}
check 'in 160 lines' short
finish
