#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Cases on which codes break: what must hold, and what comes out.
#
#   run.sh [--quick] [--table FILE] [--index NAME] [--ranks N] [--threads N] [CASE...]
#
# Prints a line a case, `CASE: passed|failed, outcome`, and fails if one failed. --quick: a tenth of the steps where there are many;
# --table: writes the lines as a table too; --index, --ranks, --threads: all of it in this layout.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick=no
table=
cases=()
asked=1
layout=()
while [ $# -gt 0 ]; do
    case $1 in
    --quick) quick=yes ;;
    --table) table=$2; shift ;;
    --index) layout=(--set index.name="$2"); shift ;;
    --ranks) asked=$2; shift ;;
    --threads) export OMP_NUM_THREADS=$2; shift ;;
    -*) sed -n '5s/^#  */usage: /p' "$0" >&2; exit 2 ;;
    *) cases+=("$1") ;;
    esac
    shift
done
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1} OMP_WAIT_POLICY=passive

# go NAME SCENE FLAG...: runs a scene; what it says is in $out/said
go() {
    local name=$1 scene=$2
    shift 2
    on_ranks "${ranks:-1}" "$SCREE" run "$here/$scene.yaml" -o "$out/$name" --overwrite --quiet "${layout[@]}" "$@" \
        >"$out/said" 2>&1
}
# value NAME COLUMN [ROW]: of the observables; row 1 is the start, none the last
value() {
    awk -F, -v column="$2" -v row="${3:-0}" 'NR == 1 { for (i = 1; i <= NF; i++) { split($i, head, "["); if (head[1] == column) at = i } next }
        { last = $at; if (NR - 1 == row) { print last; done = 1; exit } } END { if (!done) print last }' "$out/$1/observables.csv"
}
count() { # NAME KEY: of the report
    report_number "$out/$1" "$2"
}
calc() { awk "BEGIN { printf \"%.3g\", $1 }"; }
true_if() { awk "BEGIN { exit !($1) }"; }
said() { head -n 1 "$out/said" | cut -c 1-170; }

case_ratio() {
    what='radii 1:1000, masses 1:10^9, in one contact: restitution 0.5'
    go ratio ratio --set step.fraction=0.03 || { outcome=$(said); return 1; }
    local e
    e=$(calc "($(value ratio grain_vx)) - ($(value ratio sphere_vx))")
    outcome="e = $(awk "BEGIN { printf \"%.6f\", $(value ratio grain_vx) - ($(value ratio sphere_vx)) }")"
    true_if "$e - 0.5 < 1e-3 && 0.5 - $e < 1e-3"
}
case_boulder() {
    local steps=1000000 creep before after
    [ $quick = no ] || steps=100000
    what="boulder on dust of 1/20 its radius, settled, then at rest for $steps steps: no creep, no heating"
    go boulder boulder --set step.count=$((100000 + steps)) --set observables.every=100000 || { outcome=$(said); return 1; }
    creep=$(calc "$(value boulder boulder_y) - ($(value boulder boulder_y 2))")
    before=$(calc "$(value boulder energy_kinetic 2)")
    after=$(calc "$(value boulder energy_kinetic)")
    outcome="moved by $creep of a dust radius; kinetic energy $before before, $after after (weight of the boulder x dust radius: 6700)"
    true_if "($creep < 0 ? -($creep) : $creep) < 1e-3 && $after < 1e-7 * 6700"
}
case_jammed() {
    what='dense packing under gravity: kinetic energy decays to rounding and stays'
    go jammed jammed || { outcome=$(said); return 1; }
    local before after
    before=$(value jammed energy_kinetic 4)
    after=$(calc "$(value jammed energy_kinetic)")
    outcome="$(calc "$(value jammed energy_kinetic 2)") after a quarter, $(calc "$before") after three, $after at the end (m g r is about 25; free spin about a contact's normal keeps $(calc "$(value jammed energy_rotational)"), as no law here resists it)"
    true_if "$after < 1e-22 && $before < 1e-22"
}
case_far() {
    what='the same scene moved by 2^20 box lengths: equal after subtracting the shift'
    local s=8388608 t=8388616 column
    go near far && go far far --set "box.lower=[$s, $s, $s]" --set "box.upper=[$t, $t, $t]" \
        --set "particles.offset=[$s, $s, $s]" --set "walls[0].point=[$s, $s, $s]" --set "walls[1].point=[$s, $s, $t]" || { outcome=$(said); return 1; }
    outcome='energies and momentum equal in all digits'
    for column in energy_kinetic energy_rotational momentum_x momentum_y momentum_z; do
        [ "$(value near $column)" = "$(value far $column)" ] || { outcome="$column: $(value near $column) and $(value far $column)"; return 1; }
    done
}
case_rotated() {
    what='an oblique impact turned by 90 and by 30 degrees: the same'
    local c=0.8660254037844386 s=0.5 energy apart
    go as_is oblique && go turned oblique --set "particles.sources[1].position=[-0.5, 2.5, 0]" --set "particles.sources[1].velocity=[0, -2, 0]" &&
        go tilted oblique --set "particles.sources[1].position=[$(awk "BEGIN { printf \"%.17g, %.17g\", 2.5 * $c - 0.5 * $s, 2.5 * $s + 0.5 * $c }"), 0]" \
            --set "particles.sources[1].velocity=[$(awk "BEGIN { printf \"%.17g, %.17g\", -2 * $c, -2 * $s }"), 0]" || { outcome=$(said); return 1; }
    energy=$(value as_is energy_kinetic)
    apart="$(calc "$(value turned energy_kinetic) / $energy - 1") and $(calc "$(value tilted energy_kinetic) / $energy - 1")"
    outcome="kinetic energy differs by $apart"
    true_if "($(value turned energy_kinetic) / $energy - 1)^2 < 1e-24 && ($(value tilted energy_kinetic) / $energy - 1)^2 < 1e-20"
}
case_faces() {
    what='spheres exactly on faces of cells, box and subdomains: each touches six, on every index and 1, 2, 4 ranks'
    local index found='' wrong=0
    for index in brute linkcell multi bytype hgrid; do
        for ranks in 1 2 4; do
            [ $quick = no ] || [ $ranks = 1 ] || [ "$ranks$index" = 2hgrid ] || continue
            go faces faces --set index.name=$index || { outcome="$index, $ranks ranks: $(said)"; return 1; }
            [ "$(count faces contacts)" = 1536 ] || { wrong=1; found="$index, $ranks ranks: $(count faces contacts) contacts"; }
            true_if "$(value faces energy_kinetic) < 1e-20" || { wrong=1; found="$index, $ranks ranks: they move"; }
        done
    done
    ranks=$asked
    outcome=${found:-1,536 contacts and no motion each time}
    [ $wrong = 0 ]
}
refused() { # STATUS WORDS: the last run ended so
    [ "$status" = "$1" ] && grep -q "$2" "$out/said"
}
case_coincide() {
    what='two particles in one place: a clear stop'
    go coincide coincide
    status=$?
    outcome="refused: $(said)"
    refused 2 'its centre coincides with that of particle 1'
}
case_fast() {
    what='an impact so fast that a grain could pass in a step: stopped, or caught'
    go fast fast --set 'particles.sources[1].velocity=[45000, 0, 0]'
    status=$?
    outcome="4.5 radii a step: $(said)"
    refused 3 guards.speed || return 1
    go fast fast --set 'particles.sources[1].velocity=[9900, 0, 0]'
    status=$?
    outcome="$outcome; 0.99 radii a step: $([ $status = 0 ] && echo "target hit, $(calc "$(value fast target_vx)")" || said)"
    if [ $status = 0 ]; then true_if "$(value fast target_vx) > 0"; else refused 3 guards.overlap; fi
}
case_fast_known() {
    what='check foresees it'
    "$SCREE" check --all "$here/fast.yaml" --set 'particles.sources[1].velocity=[45000, 0, 0]' >"$out/said" 2>&1
    outcome=$(grep 'would stop' "$out/said" | head -n 1 | sed 's/^ *//')
    [ -n "$outcome" ]
}
impact() { # NAME FLAG...: restitution of pair.yaml
    go "$@" || return 1
    e=$(awk "BEGIN { printf \"%.6f\", ($(value "$1" b_vx) - ($(value "$1" a_vx))) / 2 }")
}
case_stiffness() {
    what='Young moduli 1:10^6 in one contact: restitution 0.6'
    impact stiffness pair --set materials[1].young=1e11 || { outcome=$(said); return 1; }
    outcome="e = $e"
    true_if "$e - 0.6 < 1e-3 && 0.6 - $e < 1e-3"
}
case_elastic() {
    what='e = 1'
    impact elastic pair --set material_pairs[0].restitution=1 || { outcome=$(said); return 1; }
    outcome="e = $e"
    true_if "$e - 1 < 1e-3 && 1 - $e < 1e-3"
}
case_plastic() {
    what='e = 0'
    impact plastic pair --set material_pairs[0].restitution=0 || { outcome=$(said); return 1; }
    outcome="e = $e"
    true_if "$e < 1e-2 && $e > -1e-2"
}
case_below() {
    what='0.99 of the stable step: bounded'
    go below limit || { outcome=$(said); return 1; }
    local most
    most=$(awk -F, 'NR > 1 && $3 > m { m = $3 } END { print m }' "$out/below/observables.csv")
    outcome="largest speed $(calc "$most") in 2,000 steps, 0.001 at the start"
    true_if "$most < 0.1"
}
case_above() {
    what='1.01 of the stable step: refused; 1.5 forced: the guard of energies sees it'
    go above limit --set step.fraction=1.01
    status=$?
    outcome="refused: $(said | sed 's/^.*step.fraction: //')"
    refused 2 'of the stable time step' || return 1
    go forced limit --set step.fraction=1.5 --set step.force=true --set guards.energy=stop
    status=$?
    outcome="$outcome; forced: $(said | sed 's/^.*guards/guards/')"
    refused 3 guards
}
case_denormal() {
    what='speeds of 10^-310'
    go denormal denormal || { outcome=$(said); return 1; }
    outcome="velocity at the end $(value denormal a_vx), no stop and no NaN"
    true_if "$(value denormal energy_kinetic) < 1 && $(value denormal energy_kinetic) >= 0"
}
falls_as() { # on the middle of a plane, by how much the velocity differs
    go plane edge --set 'walls=[{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]' || return 1
    apart=$(awk "BEGIN { x = $(value mesh ball_vx); y = $(value mesh ball_vy); z = $(value mesh ball_vz) - ($(value plane ball_vz)); printf \"%.3g\", sqrt(x * x + y * y + z * z) }")
}
case_edge() {
    what='a sphere hits the edge of two triangles exactly: as on a plane'
    go mesh edge && falls_as || { outcome=$(said); return 1; }
    outcome="velocity differs by $apart"
    true_if "$apart < 1e-9"
}
case_corner() {
    what='and a corner where eight triangles meet'
    awk 'BEGIN { for (k = 0; k < 8; k++) printf "0 0 0 %.17g %.17g 0 %.17g %.17g 0\n", 5 * cos(k * atan2(0, -1) / 4), 5 * sin(k * atan2(0, -1) / 4), 5 * cos((k + 1) * atan2(0, -1) / 4), 5 * sin((k + 1) * atan2(0, -1) / 4) }' >"$out/fan.txt"
    go mesh edge --set walls[0].file="$out/fan.txt" && falls_as || { outcome=$(said); return 1; }
    outcome="velocity differs by $apart"
    true_if "$apart < 1e-9"
}
case_slivers() {
    what='a mesh with slivers, doubles and twice the same corner: repaired, and said so'
    go mesh edge --set walls[0].file=slivers.txt || { outcome=$(said); return 1; }
    local told
    told=$(said)
    falls_as || { outcome=$(said); return 1; }
    outcome="velocity differs by $apart; $told"
    true_if "$apart < 1e-9" && [ -n "$told" ]
}
case_only_slivers() {
    what='a mesh of slivers alone: refused'
    go mesh edge --set walls[0].file=only_slivers.txt
    status=$?
    outcome="refused: $(said)"
    refused 2 'only_slivers.txt: no triangle is left'
}

[ ${#cases[@]} -gt 0 ] || cases=(ratio boulder jammed far rotated faces coincide fast fast_known stiffness elastic plastic below above denormal edge corner slivers only_slivers)
failed=0
rows=
for name in "${cases[@]}"; do
    declare -F "case_$name" >/dev/null || { echo "there is no case $name" >&2; exit 2; }
    ranks=$asked
    outcome=
    if "case_$name"; then verdict=passed; else verdict=failed; failed=$((failed + 1)); fi
    outcome=${outcome//$here\//}
    outcome=${outcome//$out\//}
    echo "$name: $verdict, $outcome"
    rows="$rows| $name | $what | $verdict | ${outcome//|/\\|} |
"
done
if [ -n "$table" ]; then
    {
        echo '# Hard cases'
        echo
        echo 'Cases on which codes of this kind break, and what comes out here. This page is written by'
        echo '`examples/hard/run.sh --table docs/hard-cases.md`; the scenes are in `examples/hard`, and a quick form runs in `make check`.'
        echo
        echo '| case | what must hold | outcome | figure |'
        echo '|---|---|---|---|'
        printf '%s' "$rows"
    } >"$table"
fi
[ $failed = 0 ]
