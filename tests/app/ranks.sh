#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The same forces on every division of the box, synchronisation and number of ranks: newton on with full and with
# reduced ghosts, and off; bricks and bisection; next-neighbour (if every particle fits) and shadows; 1, 2, 4 and 8 ranks
# (all combinations, and 27 ranks, with SCREE_LONG). Rebuilds come with migration of touching pairs; forces must agree with those of
# brute on one rank within max(1e-12, 8 eps L / largest overlap) of the largest force; reproducible runs to the last bit.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
. "$top_srcdir/tests/app/forces.sh"
cd "$out" || exit 1

# scene FILE EDGE SOURCES...
scene() {
    local file=$1 edge=$2
    shift 2
    cat >"$file" <<END
units: none
guards: {overlap_bound: 1.5, speed: off}
materials: [{name: soft, density: 1}, {name: hard, density: 3}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 1000}]
contact: {law: hooke}
output: {dump: {every: 40}, checkpoint: {at_end: false}}
observables: {every: 40, list: [{name: momentum}, {name: overlap_max}, {name: load}]}
box: {lower: [0, 0, 0], upper: [$edge, $edge, $edge], periodic: true}
step: {dt: 0.00017, count: 40, rebuild_every: 10}
skin: {length: 0.05}
domain: {name: brick}
particles:
  sources:
END
    printf '    - {from: %s, velocity_sigma: 12}\n' "$@" >>"$file"
}
scene ten.yaml 8 'random, count: 20, material: hard, sizes: 0.9' 'random, count: 900, material: soft, sizes: 0.09'
scene forty.yaml 8 'random, count: 2, material: hard, sizes: 1.6' 'random, count: 2500, material: soft, sizes: 0.04'
scene continuous.yaml 8 'random, count: 900, material: soft, sizes: {law: uniform, min: 0.05, max: 0.5}'
scene boulder.yaml 8 'random, count: 1, material: hard, sizes: 2' 'random, count: 900, material: soft, sizes: {law: uniform, min: 0.08, max: 0.15}'

reference() {
    run_scene 1 "$1.yaml" "$1-first" --set index=brute --set threads=1 && last_frame "$1-first" || return 1
    echo "  $(number "$1-first/report.json" contacts) contacts, bound $(bound_of "$1" 8)"
    [ "$(number "$1-first/report.json" rebuilds)" -ge 4 ] && [ "$(number "$1-first/report.json" contacts)" -ge 4 ]
}

# layout CASE RANKS DOMAIN SYNC NEWTON GHOSTS
layout() {
    local dir=$1-other
    run_scene "$2" "$1.yaml" "$dir" --overwrite --set threads=1 --set domain="${3/bisection/$bisection}" --set sync="$4" --set newton="$5" \
        --set ghosts="$6" && same_forces "$1" "$dir" 8 particles contacts pairs && momentum_kept "$dir"
}

# refused CASE RANKS [FLAG...]: next-neighbour synchronisation says which particle does not fit
refused() {
    local case=$1 ranks=$2
    shift 2
    run_scene "$ranks" "$case.yaml" "$case-refused" --overwrite --set sync=neighbours "$@" >/dev/null
    [ $? = 2 ] && grep -q '^scree: sync: neighbours: particle' said || { cat said; return 1; }
}

# neighbours CASE RANKS DOMAIN NEWTON GHOSTS: after the same layout with shadows; if they took more than a round it is refused
neighbours() {
    if grep -q '"sync": ".* rounds"' "$1-other/report.json"; then
        refused "$1" "$2" --set domain="${3/bisection/$bisection}" --set newton="$4" --set ghosts="$5"
    else
        layout "$1" "$2" "$3" neighbours "$4" "$5"
    fi
}

# reproducibly RANKS DIR CASE [FLAG...]: the end of a reproducible run, in lines
reproducibly() {
    local ranks=$1 dir=$2 case=$3
    shift 3
    run_scene "$ranks" "$case.yaml" "$dir" --overwrite --set reproducible=true --set output.checkpoint.at_end=true --set threads=1 "$@" &&
        checkpoint_lines "$dir/checkpoint-40.h5" >"$dir.lines" && [ -s "$dir.lines" ]
}

# same_bits CASE RANKS DOMAIN
same_bits() {
    reproducibly "$2" bits "$1" --set domain="${3/bisection/$bisection}" --set sync=shadow && cmp "$1-bits.lines" bits.lines || return 1
    if grep -q '"sync": ".* rounds"' bits/report.json; then
        refused "$1" "$2" --set domain="${3/bisection/$bisection}" --set reproducible=true
    else
        reproducibly "$2" bits "$1" --set domain="${3/bisection/$bisection}" --set sync=neighbours && cmp "$1-bits.lines" bits.lines
    fi
}

for case in ten forty continuous boulder; do
    check "$case: the reference moves enough" reference $case
    in_turns '2 bisection shadow on reduced' '8 bisection shadow on full' '4 brick shadow off full' \
        '8 bisection shadow off full' '8 brick shadow on reduced'
    for setting in "${some[@]}"; do
        check "$case: ranks, domain, sync, newton, ghosts: $setting" layout $case $setting
    done
done
for setting in '2 brick neighbours on reduced' '4 brick neighbours off full' '8 brick neighbours on full'; do
    check "continuous: ranks, domain, sync, newton, ghosts: $setting" layout continuous $setting
done

# Poured into an empty periodic box: the first division has one particle to go by; then two meet across the seam
cat >seam.yaml <<'END'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10], periodic: true}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 1, k_n: 1000}]
step: {dt: 0.0005, count: 6000}
insertions:
  - {rate: 1e9, count: 1, sizes: 1, velocity: [0, 0, 0], region: {shape: box, lower: [6.9, 3.9, 3.9], upper: [9.1, 6.1, 6.1]}}
particles:
  sources: [{from: single, position: [0.9, 5, 5], radius: 1, velocity: [-1, 0, 0]}]
observables: {every: 500, list: [{name: velocity, id: 1, label: one}, {name: velocity, id: 2, label: two}]}
output: {checkpoint: {at_end: false}}
END
poured() {
    run_scene 1 seam.yaml seam-1 --overwrite && run_scene "$1" seam.yaml "seam-$1" --set domain.name=$bisection || return 1
    within "$(awk -F, 'END { print $2 }' seam-1/observables.csv)" "$(awk -F, 'END { print $2 }' "seam-$1/observables.csv")" 1e-9 &&
        within "$(awk -F, 'END { print ($2 > -0.99) }' seam-1/observables.csv)" 1 0
}
check 'a division by one particle keeps contacts across the box: 2 ranks' poured 2
check 'the same on 3 ranks' poured 3

# Three ranks: the first spans y, which the others share, and so holds copies of its own particles. Of two that rub against
# each other one crosses the seam there: the spring between them stays
cat >cross.yaml <<'END'
units: none
box: {lower: [0, 0, 0], upper: [6.1, 6, 6], periodic: true}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.9, friction: 0.8, k_n: 1000}]
step: {dt: 0.0005, count: 100, rebuild_every: 5}
particles:
  sources:
    - {from: single, position: [1, 5.09, 3], radius: 0.5, velocity: [0.4, 1, 0], omega: [0, 0, 2]}
    - {from: single, position: [1, 5.99, 3], radius: 0.5, velocity: [-0.4, 1, 0.1]}
observables: {every: 100, list: [{name: velocity, id: 1, label: one}, {name: angular_velocity, id: 1, label: one}]}
output: {checkpoint: {at_end: false}}
END
crossed() {
    local k
    run_scene 1 cross.yaml cross-1 && run_scene 3 cross.yaml cross-3 --set domain.name=$bisection || return 1
    for k in 2 3 4 5 6 7; do
        within "$(cut -d , -f $k cross-1/observables.csv | tail -n 1)" "$(cut -d , -f $k cross-3/observables.csv | tail -n 1)" 1e-9 || return 1
    done
}
check 'a spring goes over the seam with its pair where a rank is its own neighbour' crossed
# Rebuilds on several ranks leave particles on their ranks and in their order while that pays. Lists of such rebuilds have the pairs of
# brute on one rank: copies reach farther by the way that particles are outside of their subdomains. Divided or not, directions may be open
cat >stays.yaml <<'END'
units: none
seed: 3
gravity: [0, 0, -5]
box: {lower: [0, 0, 0], upper: [12, 12, 12], periodic: true}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.9, friction: 0.3, k_n: 200}]
skin: {length: 0.2}
guards: {overlap: off, speed: off}
step: {dt: 0.002, count: 96, rebuild_every: 4}
particles:
  sources:
    - {from: random, count: 6, velocity_sigma: 1, sizes: 1, region: {shape: box, lower: [0, 0, 8], upper: [12, 12, 12]}}
    - {from: random, count: 3000, velocity_sigma: 2, sizes: {law: uniform, min: 0.1, max: 0.25}}
output: {checkpoint: {at_end: false}}
END
stays() { # RANKS PERIODIC COUNT...
    local ranks=$1 periodic=$2 count some='' same='' sorts
    shift 2
    for count; do
        run_scene 1 stays.yaml stays-1 --overwrite --set index=brute --set step.count="$count" --set box.periodic="$periodic" &&
            run_scene "$ranks" stays.yaml stays-n --overwrite --set index=hgrid --set step.count="$count" --set box.periodic="$periodic" || return 1
        sorts=$(number stays-n/report.json sorts)
        [ "$(number stays-1/report.json pairs)" = "$(number stays-n/report.json pairs)" ] && [ "$sorts" -lt "$(number stays-n/report.json rebuilds)" ] ||
            { echo "  $count steps: $(number stays-1/report.json pairs), $(number stays-n/report.json pairs) pairs, $sorts sorts"; return 1; }
        [ "${some:-$sorts}" != "$sorts" ] || same=yes
        some=$sorts
    done
    [ "$same" = yes ] # one of the last rebuilds did not sort
}
check 'particles stay on their ranks: 2 ranks' stays 2 '[true, true, true]' 92 96
check 'the same on 4 ranks, open above and below' stays 4 '[true, true, false]' 92 96
check 'the same on 4 ranks, open in the divided directions' stays 4 '[false, false, true]' 92 96

# Subdomains of unlike widths: copies of those outside still go to next neighbours alone
cat >unlike.yaml <<'END'
units: none
seed: 3
box: {lower: [0, 0, 0], upper: [40, 16, 16], periodic: true}
step: {dt: 0.002, count: 400, rebuild_every: 10}
guards: {overlap: off, speed: off}
skin: {length: 2.25}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.9, friction: 0.3, k_n: 200}]
domain: {name: bisection, weights: particles, threshold: 0}
sync: neighbours
particles:
  sources:
    - {from: random, count: 40, velocity: [-1.5, 0, 0], sizes: 0.7, region: {shape: box, lower: [0, 0, 0], upper: [3.2, 14, 14]}}
    - {from: random, count: 40, sizes: 0.7, region: {shape: box, lower: [3.3, 0, 0], upper: [17.3, 14, 14]}}
    - {from: random, count: 40, sizes: 0.7, region: {shape: box, lower: [17.4, 0, 0], upper: [31.9, 14, 14]}}
END
if [ $bisection = bisection ]; then check 'next neighbours do where particles are outside of unlike subdomains' run_scene 3 unlike.yaml unlike; fi
check 'boulder: next neighbours do not do' refused boulder 8 --set domain.x=8
for case in ten forty; do
    check "$case: the reference of reproducible runs" reproducibly 1 "$case-bits" "$case" --set index=brute
    check "$case: the same bits on 8 ranks" same_bits $case 8 bisection
done
if [ -n "${SCREE_LONG:-}" ]; then
    for case in ten forty continuous boulder; do
        for domain in brick bisection; do
            for ranks in 1 2 4 8 27; do
                for setting in 'on full' 'on reduced' 'off full'; do
                    check "$case: ranks, domain, newton, ghosts: $ranks $domain $setting, shadows" \
                        layout $case $ranks $domain shadow $setting
                    check "$case: ranks, domain, newton, ghosts: $ranks $domain $setting, neighbours" \
                        neighbours $case $ranks $domain $setting
                done
            done
        done
    done
    for case in ten forty continuous boulder; do
        check "$case: the reference of reproducible runs" reproducibly 1 "$case-bits" "$case" --set index=brute
        for domain in brick bisection; do
            for ranks in 2 4 8 27; do
                check "$case: the same bits on $ranks ranks, $domain" same_bits $case $ranks $domain
            done
        done
    done
    # A sphere that must be known beyond the neighbours of its owner: places, and the worst overlap, after 50 steps
    cp "$top_srcdir/examples/pupcs/large/scene.yaml" large.yaml
    limit=900
    large() { # RANKS DIR
        run_scene "$1" large.yaml "$2" --set threads=1 --set step.count=50 --set output.dump.every=50 \
            --set 'observables={every: 50, list: [{name: overlap_max}]}' && last_frame "$2"
    }
    large_agrees() {
        local places overlap
        large 1 large-1 && large 64 large-64 || return 1
        grep -q '"sync": ".* rounds"' large-64/report.json || { echo '  no shadow went beyond neighbours'; return 1; }
        places=$(awk '
            function apart(a, b) { a = a > b ? a - b : b - a; return a > 40 ? 80 - a : a } # nearest images
            FNR == 1 { rows = 0; file++ }
            /^ITEM: ATOMS id type radius mass x y z / { rows = 1; next }
            rows && file == 1 { n++; for (d = 0; d < 3; d++) place[$1, d] = $(5 + d) }
            rows && file == 2 { n--; for (d = 0; d < 3; d++) if ((a = apart(place[$1, d], $(5 + d))) > most) most = a }
            END { print n == 0 && file == 2 ? most / 80 : "?" }' large-1/last large-64/last)
        overlap=$(tail -qn 1 large-1/observables.csv large-64/observables.csv | cut -d , -f 2 | tr '\n' ' ')
        echo "  places differ by $places of the box, the worst overlaps are $overlap"
        within "$places" 0 1e-9 && within ${overlap% *} 1e-9
    }
    check 'large: 64 ranks and one move the spheres alike' large_agrees
    check 'large: the reference of reproducible runs' reproducibly 1 large-bits large --set step.count=40
    check 'large: the same bits on 64 ranks' reproducibly 64 bits large --set step.count=40
    check 'large: nothing differs' cmp large-bits.lines bits.lines
fi

finish
