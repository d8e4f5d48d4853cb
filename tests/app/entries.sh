#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The entries of reports: those of runs that have all kinds of them are those that docs/output.md describes; the report on the terminal.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >all.yaml <<'EOS'
gravity: [0, 0, -9.81]
box: {lower: [0, 0, 0], upper: [20 mm, 20 mm, 40 mm], leave: {x_lower: delete, x_upper: delete, y_lower: delete, y_upper: delete}}
contact: {law: hertz}
skin: auto
materials: [{name: glass, density: 2500, young: 1 MPa, poisson: 0.25}]
material_pairs: [{restitution: 0.3, friction: 0.4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
insertions:
  - {name: rain, sizes: 2 mm, rate: 20000, count: 30, region: {shape: box, lower: [3 mm, 3 mm, 2 mm], upper: [17 mm, 17 mm, 38 mm]}}
  - {sizes: 3 mm, rate: 1e6, count: 2000, velocity: [1, 0, 0], region: {shape: box, lower: [2 mm, 2 mm, 2 mm], upper: [18 mm, 18 mm, 10 mm]}}
stages: [{name: pour, duration: 1 ms}, {name: rest, duration: 2 ms}]
step: {dt: 20 us}
EOS
cat >solved.yaml <<'EOS'
units: none
gravity: [0, 0, -10]
box: {lower: [0, 0, 0], upper: [4, 4, 20], periodic: [true, true, false]}
contact: {solver: {}, law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0, friction: 0.4, k_n: 1000}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: lattice, lattice: sc, spacing: 1.2, sizes: 0.5, region: {shape: box, lower: [0.1, 0.1, 0.1], upper: [3.9, 3.9, 4]}}
step: {count: 5, dt: 0.001}
EOS
run() { on "$1" "$scree" run "$2.yaml" -o "$2-$1" "${@:3}" >"$2-$1.txt" 2>"$2-$1.err" || { cat "$2-$1.err"; return 1; }; }
check 'a run of stages and insertions' run 1 all
check 'the same on 2 ranks' run 2 all
check 'a run with a solver of contacts' run 1 solved

# keys REPORT...: the keys that reports have, without the stages
keys() {
    sed '/^    "[a-z_ ]*": {"min"/d' "$@" | grep -o '"[a-z_]*": ' | tr -d '": ' | sort -u
}
# described: the keys of the table in the page, each without those before it; those of stages left out
described() {
    sed -n '/^<!-- report: /,/^<!-- end of report/s/^| `\([^`]*\)`.*/\1/p' "$top_srcdir/docs/output.md" | grep -v '^stages\.' |
        sed 's/.*\.//' | sort -u
}
same_keys() {
    keys all-1/report.json all-2/report.json solved-1/report.json >has
    described >wants
    diff has wants
}
check 'docs/output.md describes all entries that reports have, and no others' same_keys
stages_described() {
    local stage
    sed -n 's/^    "\([a-z_ ]*\)": {"min".*/\1/p' all-1/report.json | sort -u >stages.all
    [ "$(wc -l <stages.all)" -gt 10 ] || return 1
    while read -r stage; do
        grep -qF "| \`stages.$stage\` |" "$top_srcdir/docs/output.md" || { echo "  $stage"; return 1; }
    done <stages.all
}
check 'and all their stages' stages_described
same_order() { # two reports of one scene have the same keys in the same order
    diff <(grep -o '^  "[a-z_]*"' all-1/report.json) <(grep -o '^  "[a-z_]*"' all-2/report.json)
}
check 'on 2 ranks the same keys in the same order' same_order

shows() { # FILE WORDS...: the terminal shows them
    local file=$1 words
    shift
    for words; do
        grep -qF -- "$words" "$file" || { echo "  no '$words'"; return 1; }
    done
}
check 'the terminal has the lines of the run' shows all-1.txt ' steps of ' '  index auto, law hertz, integrator ' '1 rank x ' ' pairs, ' \
    '  skin: ' ' bytes a particle, peak memory of a rank ' '  index chosen: ' '  level    particles ' 'radii [m]' '  seconds  ' '  insertion rain: ' \
    'are placed: NOTE: ' '  stage pour ' ', ended by duration'
check 'on 2 ranks those of ranks' shows all-2.txt '2 ranks x ' ' ghosts; a rank and step sends ' '  sync ' '  class 0: '
alone() { ! grep -qE ' ghosts; |  sync |  class |  solver ' all-1.txt; }
check 'which one rank does not have' alone
check 'a solver has its line' shows solved-1.txt '  solver       solves iterations' '  contacts          6 '
finish
