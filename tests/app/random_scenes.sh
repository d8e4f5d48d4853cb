#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Random scenes on random layouts against one rank, one thread, brute: random_scenes.sh [SEED [COUNT]]
#
# Scene number k is drawn from SEED + k alone (defaults: SEED 1, COUNT 12, with SCREE_LONG 200), so the seed of a line
# names one scene: random_scenes.sh 57 1. The script draws dimension, box and periodic sides, sizes, numbers, speeds, law,
# gravity, walls, particles that leave or come, groups that are held or moved, and skin; and ranks, threads, index, division,
# synchronisation, newton and ghosts. Every second scene is reproducible: all data of its checkpoint must be equal to the last bit, in
# every fourth of these scenes after a change of the layout half-way. The other scenes make at most 50 steps, after which positions
# must agree within 1e-9 of the box. Rounding may grow exponentially: if positions differ by more, the difference must not exceed the
# change of a run on one rank in a box longer by the factor 1 + 1e-14, some fifty times the rounding. A run may take 200 s, so that the
# script tells a run that hangs from a slow run; most take a second.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
all_indexes=$(indexes)
cd "$out" || exit 1

first=${1:-1}
count=${2:-${SCREE_LONG:+200}}
count=${count:-12}

# draw N: a whole number from 0 to N - 1, into `drawn`
draw() {
    state=$((state * 6364136223846793005 + 1442695040888963407))
    drawn=$((((state >> 33) & 0x7fffffff) % $1))
}

# pick WORD...: one of them, into `picked`
pick() {
    draw $#
    shift $drawn
    picked=$1
}

# real LOW HIGH: between them, both in thousandths, into `picked`
real() {
    draw $(($2 - $1 + 1))
    printf -v picked '%d.%03d' $((($1 + drawn) / 1000)) $((($1 + drawn) % 1000))
}

# once_in N
once_in() {
    draw "$1"
    [ $drawn = 0 ]
}

# number_of EXPRESSION: by awk
number_of() {
    awk "BEGIN { printf \"%.6g\", $1 }"
}

# at_most N RADIUS: N, or as many as fill a seventh of the box
at_most() {
    awk -v n="$1" -v r="$2" -v d="$dimension" -v v="${edge[0]} ${edge[1]} ${edge[2]}" 'BEGIN {
        split(v, e, " ")
        space = d == 3 ? e[1] * e[2] * e[3] : e[1] * e[2]
        one = d == 3 ? 4.19 * r ^ 3 : 3.15 * r ^ 2
        most = int(space / 7 / one)
        print (n < most ? n : most < 1 ? 1 : most) }'
}

draw_box() {
    local d
    pick 3 3 3 2
    dimension=$picked
    for d in 0 1 2; do
        real 4000 12000
        edge[d]=$picked
        pick true false
        periodic[d]=$picked
    done
    if [ "$dimension" = 2 ]; then
        edge[2]=1
        periodic[2]=false
    fi
    shortest=$(awk -v a="${edge[0]}" -v b="${edge[1]}" -v c="${edge[2]}" -v d="$dimension" 'BEGIN {
        s = a < b ? a : b; print (d == 3 && c < s ? c : s) }')
    longest=$(awk -v a="${edge[0]}" -v b="${edge[1]}" -v c="${edge[2]}" 'BEGIN { s = a > b ? a : b; print (c > s ? c : s) }')
}

# add_source MATERIAL COUNT SIZES
add_source() {
    sources+="    - {from: random, count: $2, material: $1, velocity_sigma: $speed, sizes: $3}
"
    particles=$((particles + $2))
}

# part THOUSANDTHS: of the shortest edge
part() {
    number_of "$shortest * $1 / 1000"
}

draw_sizes() {
    local small large
    pick equal two two uniform power lognormal boulder boulder discrete few
    sizes=$picked
    draw 400
    local many=$((100 + drawn))
    draw 20
    smallest=$(part $((10 + drawn)))
    case $sizes in
    equal)
        smallest=$(part 45)
        add_source soft "$(at_most $many "$smallest")" "$smallest"
        ;;
    two)
        pick 4 10 20
        large=$(number_of "($smallest * $picked < $shortest / 4 ? $smallest * $picked : $shortest / 4)")
        draw 6
        add_source hard "$(at_most $((drawn + 1)) "$large")" "$large"
        add_source soft "$(at_most $many "$smallest")" "$smallest"
        ;;
    uniform) add_source soft "$(at_most $many "$(part 80)")" "{law: uniform, min: $smallest, max: $(part 80)}" ;;
    power) add_source soft "$(at_most $many "$(part 70)")" "{law: power, min: $smallest, max: $(part 140), exponent: -3}" ;;
    lognormal)
        add_source soft "$(at_most $many "$(part 60)")" \
            "{law: lognormal, mean: $(part 40), width: 0.5, min: $smallest, max: $(part 120)}"
        ;;
    boulder)
        draw 230
        large=$(part $((200 + drawn)))
        add_source hard 1 "$large"
        add_source soft "$(at_most $many "$(part 35)")" "{law: uniform, min: $smallest, max: $(part 35)}"
        ;;
    discrete)
        small="$smallest, $(number_of "$smallest * 2"), $(number_of "$smallest * 5")"
        add_source soft "$(at_most $many "$(number_of "$smallest * 3")")" \
            "{law: discrete, by: number, radii: [$small], weights: [6, 3, 1]}"
        ;;
    few)
        draw 5
        smallest=$(part 60)
        add_source soft $((drawn + 1)) "{law: uniform, min: $smallest, max: $(part 200)}"
        ;;
    esac
}

draw_walls() {
    local up=$((dimension - 1)) normal='[0, 0, 1]' gravity='[0, 0, -3]' motion=''
    [ "$dimension" = 3 ] || { normal='[0, 1, 0]' gravity='[0, -3, 0]'; }
    extra=
    if once_in 2; then extra+="gravity: $gravity
"; fi
    if [ "${periodic[up]}" = false ] && once_in 2; then
        if once_in 2; then motion=", motion: [{kind: oscillate, direction: $normal, amplitude: 0.02, frequency: 10}]"; fi
        extra+="walls: [{name: floor, shape: plane, material: hard, point: [0, 0, 0], normal: $normal$motion}]
"
    fi
    leave=keep
    if [ $reproducible = true ]; then
        pick keep keep delete
        leave=$picked
        if once_in 6; then
            steps=230
            extra+="insertions: [{rate: 300, count: 40, material: soft, sizes: $smallest, region: {shape: all}}]
"
        fi
    fi
}

# draw_scene FILE
draw_scene() {
    local stiffness young law tangential rolling
    sources=
    particles=0
    pick 5 50 1000 10000 # in thousandths of the shortest edge and 20 steps
    moved=$picked
    speed=$(number_of "$shortest * $moved / 1000 / 20 / 0.001")
    steps=$((20 + 5 * (state >> 40 & 3) + 15 * (state >> 50 & 1)))
    draw_sizes
    pick hooke hooke hertz
    law=$picked
    pick none history history
    tangential=$picked
    pick none spring
    rolling=$picked
    draw_walls
    # a step of a fifth to a tenth of what would be unstable for the smallest
    stiffness=$(number_of "0.04 * 4.19 * $smallest ^ 3 / 1e-6")
    young=$(number_of "0.02 * 4.19 * $smallest ^ 3 / 1e-6 / $smallest")
    pick 'length: '"$(part 4)" 'length: '"$(part 15)" 'relative: 0.3' 'relative: 1'
    local skin=$picked
    [ "$sizes" != boulder ] || skin=${skin/relative: 1/relative: 0.2} # or it would reach around the box
    [ "$reproducible" = true ] || ! once_in 6 || skin='length: 0'
    pick 0 0 1 7
    cat >"$1" <<EOF
units: none
seed: $seed
reproducible: $reproducible
box: {dimension: $dimension, lower: [-1, 0, 2], upper: [$(number_of "${edge[0]} - 1"), ${edge[1]}, $(number_of "${edge[2]} + 2")], periodic: [${periodic[0]}, ${periodic[1]}, ${periodic[2]}], leave: {all: $leave}}
step: {dt: 0.001, count: $steps, force: true, rebuild_every: $picked}
guards: {overlap: off, speed: off, overlap_bound: 1.5}
skin: {$skin}
EOF
    if [ "$law" = hooke ]; then
        echo "contact: {law: hooke, tangential: $tangential$([ $tangential = none ] || echo ", rolling: $rolling")}
materials: [{name: soft, density: 1}, {name: hard, density: 3}]
material_pairs: [{restitution: 0.7, k_n: $stiffness$([ $tangential = none ] || echo ", friction: 0.4$([ $rolling = none ] || echo ", rolling_friction: 0.05")")}]"
    else
        echo "contact: {law: hertz, tangential: $tangential}
materials: [{name: soft, density: 1, young: $young, poisson: 0.3}, {name: hard, density: 3, young: $young, poisson: 0.2}]
material_pairs: [{restitution: 0.7$([ $tangential = none ] || echo ", friction: 0.4")}]"
    fi >>"$1"
    printf '%sparticles:\n  sources:\n%s' "$extra" "$sources" >>"$1"
}

# draw_layout: into `ranks` and `layout`
draw_layout() {
    local newton ghosts
    pick 2 2 3 4 4 5 6 7 8 8 12
    ranks=$picked
    pick 1 1 2 3
    layout="threads=$picked"
    pick $all_indexes
    layout+=" index=$picked"
    pick auto auto shadow shadow neighbours
    layout+=" sync=$picked"
    pick on on off
    newton=$picked
    pick full reduced
    ghosts=$picked
    [ "$newton" = on ] || ghosts=full
    layout+=" newton=$newton ghosts=$ghosts"
    if once_in 2; then
        pick pairs particles time
        layout+=" domain=$bisection"
        [ $bisection = brick ] || layout+=" domain.weights=$picked"
        pick 1.001 1.2
        [ $bisection = brick ] || layout+=" domain.threshold=$picked"
    else
        layout+=" domain=brick"
        if once_in 3; then layout+=" domain.x=$ranks"; fi
    fi
    if once_in 4; then layout+=" step.fused=false"; fi
    if once_in 3 && [[ $reproducible$layout = *true*index=auto* ]]; then layout+=" index.measure=true"; fi
}

# draw_more FILE: what goes behind the rest, so that the rest of a seed stays what it was: particles that are poured where
# there were few, a group that is held or moved
draw_more() {
    if [ $sizes = few ] && [[ $extra != *insertions* ]]; then
        draw 60
        poured=$((poured + 1))
        echo "insertions: [{rate: 1e6, count: $((drawn + 20)), material: soft, sizes: {law: uniform, min: $(part 20), max: $(part 60)}, region: {shape: all}}]"
    fi >>"$1"
    if once_in 4; then
        pick 'motion: frozen' 'motion: moving, velocity: [0.5, -0.3, 0], omega: [0, 0, 2]'
        ! grep -q 'tangential: none' "$1" || picked=${picked%, omega*}
        held=$((held + 1))
        echo "groups: [{name: held, $picked, select: {ids: [1, 2, 3, 5, 8, 13, 21, 34, 55]}}]"
    fi >>"$1"
}

# timed RANKS DIR [FLAG...]: a run of scene.yaml, within its time
timed() {
    local count=$1 dir=$2 status
    shift 2
    if [ "$count" = 1 ]; then
        timeout 200 "$scree" run scene.yaml -o "$dir" --quiet --overwrite "$@" >said 2>&1
    else
        SCREE_LONG='' TEST_SECONDS=200 "$LAUNCH" -n "$count" "$scree" run scene.yaml -o "$dir" --quiet --overwrite "$@" >said 2>&1
    fi
    status=$?
    [ $status != 124 ] && [ $status != 137 ] || echo '  took more than 200 s'
    return $status
}

# on_layout DIR [FLAG...]: on the layout drawn; one that next neighbours do not serve must say so, and does it with shadows
on_layout() {
    local dir=$1 flags=() setting
    shift
    for setting in $layout; do flags+=(--set "$setting"); done
    timed "$ranks" "$dir" "${flags[@]}" "$@" && return 0
    if [ $? = 2 ] && [[ $layout = *sync=neighbours* ]] && grep -q '^scree: sync: neighbours: particle' said; then
        refused=$((refused + 1))
        timed "$ranks" "$dir" "${flags[@]}" --set sync=shadow "$@" && return 0
    fi
    cat said
    return 1
}

# apart DIR DIR: the largest distance of a particle's positions in the last frames of two runs, by nearest images, in parts
# of the box's longest edge; "none" where the particles are not the same
apart() {
    awk -v edges="${edge[*]}" -v periodic="${periodic[*]}" -v longest="$longest" '
        BEGIN { split(edges, edge, " "); split(periodic, wraps, " ") }
        FNR == 1 { file++; reading = 0 }
        /^ITEM: TIMESTEP/ { reading = 0; worst = 0; if (file == 1) rows = 0; else seen = 0 }
        /^ITEM: ATOMS/ {
            for (k = 3; k <= NF; k++)
                place[$k] = k - 2
            reading = 1
            next
        }
        reading && /^[0-9]/ {
            if (file == 1) {
                rows++
                x[$1, 1] = $place["x"]; x[$1, 2] = $place["y"]; x[$1, 3] = $place["z"]
                next
            }
            seen++
            now[1] = $place["x"]; now[2] = $place["y"]; now[3] = $place["z"]
            for (d = 1; d <= 3; d++) {
                apart = now[d] - x[$1, d]
                if (wraps[d] == "true")
                    apart -= edge[d] * int(apart / edge[d] + (apart < 0 ? -0.5 : 0.5))
                apart = apart < 0 ? -apart : apart
                if (!(apart <= worst)) worst = apart
            }
        }
        END {
            if (rows > 0 && rows == seen && worst == worst + 0) printf "%.3g\n", worst / longest
            else print "none"
        }' "$1/dump.lammpstrj" "$2/dump.lammpstrj"
}

# stretched LOWER EDGE: the upper end of a longer edge
stretched() {
    awk -v lower="$1" -v edge="$2" 'BEGIN { printf "%.17g", lower + edge * (1 + 1e-14) }'
}

# positions_agree: those of `alone` and `other`
positions_agree() {
    local far grown upper
    far=$(apart alone other)
    [ "$far" != none ] || { echo '  not the same particles'; return 1; }
    number_of "($far <= 1e-9)" | grep -qx 1 && return
    printf -v upper '[%s, %s, %s]' "$(stretched -1 "${edge[0]}")" "$(stretched 0 "${edge[1]}")" "$(stretched 2 "${edge[2]}")"
    timed 1 stretched --set threads=1 --set index=brute --set output.dump.every="$steps" --set "box.upper=$upper" || { cat said; return 1; }
    grown=$(apart alone stretched)
    [ "$grown" != none ] || { echo '  a stretched box has other particles'; return 1; }
    echo "  positions differ by $far of the box, those in a box longer by 1e-14 by $grown"
    chaotic=$((chaotic + 1))
    number_of "($far <= $grown && $far <= 1e-4)" | grep -qx 1
}

# count_up: what was met, over all scenes
count_up() {
    local contacts
    contacts=$(number alone/report.json contacts)
    [ "${contacts:-0}" = 0 ] || touching=$((touching + 1))
    if grep -q '"sync": ".*shadow (' other/report.json; then shadows=$((shadows + 1)); fi
    if grep -q '"divisions": [1-9]' other/report.json; then divided=$((divided + 1)); fi
}

# agrees: one scene, drawn from `seed`
agrees() {
    local half
    rm -rf alone other
    if [ $reproducible = false ]; then
        timed 1 alone --set threads=1 --set index=brute --set output.dump.every="$steps" || { cat said; return 1; }
        on_layout other --set output.dump.every="$steps" && count_up && positions_agree
        return
    fi
    half=$((steps / 2))
    timed 1 alone --set threads=1 --set index=brute --set output.checkpoint.every=$half || { cat said; return 1; }
    checkpoint_lines "alone/checkpoint-$steps.h5" >alone.lines || return 1
    if [ $change = yes ]; then
        on_layout other --set output.checkpoint.every=$half --set step.count=$half || return 1
        layout=$later ranks=$later_ranks
        cp "other/checkpoint-$half.h5" half.h5
        on_layout other --set output.checkpoint.every=$half --set step.count=$steps --resume half.h5 || return 1
    else
        on_layout other --set output.checkpoint.every=$half || return 1
    fi
    count_up
    checkpoint_lines "other/checkpoint-$steps.h5" >other.lines && cmp alone.lines other.lines
}

# one SEED
one() {
    local before=$failures
    seed=$1
    state=$((seed * 0x1e3779b97f4a7c15 + 0x2545f4914f6cdd1d))
    edge=() periodic=()
    draw 8
    draw_box
    reproducible=true
    [ $((seed % 2)) = 1 ] || reproducible=false
    draw_scene scene.yaml
    draw_layout
    later=$layout later_ranks=$ranks change=no
    if once_in 4; then change=yes; fi
    draw_layout
    draw_more scene.yaml
    check "seed $seed: $particles $sizes in ${dimension}D, moving $moved, reproducible $reproducible, $ranks ranks $layout$([ $change = no ] || [ $reproducible = false ] || echo ", then $later_ranks ranks $later")" agrees
    [ $failures = $before ] || sed 's/^/    /' scene.yaml
}

chaotic=0 touching=0 shadows=0 divided=0 refused=0 poured=0 held=0
for ((scene = 0; scene < count; scene++)); do
    one $((first + scene))
done
echo "contacts in $touching scenes, shadows needed in $shadows, refused by next neighbours $refused, divided again $divided; $poured poured, $held with a group, differences that grow in $chaotic"
if [ "$count" -ge 12 ]; then
    check 'a third of the scenes have contacts' [ $((3 * touching)) -ge "$count" ]
    check 'some need shadows' [ $shadows -ge 1 ]
fi
finish
