#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The tables of docs/hard.md, "What goes together": each row has settings, one between two backquotes each; those of the first table run, those of the
# second one are refused with the message that stands last in the row.

. "$(dirname "$0")/common.sh"
page=$top_srcdir/docs/hard.md
cd "$out" || exit 1
cat >space.yaml <<'EOS'
units: none
seed: 3
threads: 1
gravity: [0, 0, -1]
box: {lower: [0, 0, 0], upper: [5, 5, 6], periodic: [true, true, false]}
step: {dt: 0.005, count: 30}
contact: {law: rigid, solver: {sweeps: 20}}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles: {sources: [{from: random, count: 12, region: {shape: box, lower: [0, 0, 0], upper: [5, 5, 3]}, sizes: {law: uniform, min: 0.3, max: 0.5}}]}
observables: {every: 10, list: [{name: energy_kinetic}, {name: contact_residual}]}
EOS

# settings ROW: `flags` gets what stands between backquotes, `last` the last of it
settings() {
    local row=$1
    flags=()
    while [[ $row == *'`'*'`'* ]]; do
        row=${row#*'`'}
        last=${row%%'`'*}
        flags+=(--set "$last")
        row=${row#*'`'}
    done
}
goes() { run_scene 1 space.yaml goes --overwrite "${flags[@]}"; }
refused() {
    on 1 "$scree" run space.yaml -o refused --quiet "${flags[@]}" >said 2>&1
    [ $? = 2 ] && [ ! -e refused ] && holds said "$last"
}

seen=(0 0)
kind=
while IFS= read -r row; do
    case $row in
        '| goes with |'*) kind=goes ;;
        '| refused |'*) kind=refused ;;
        '|---'*) ;;
        '| '*)
            [ -n "$kind" ] || continue
            name=${row#| }
            settings "$row"
            if [ $kind = refused ]; then
                unset 'flags[-1]' 'flags[-1]'
                seen[1]=$((seen[1] + 1))
            else
                seen[0]=$((seen[0] + 1))
            fi
            check "$kind: ${name%% |*}" $kind
            ;;
        *) kind= ;;
    esac
done <"$page"
check 'both tables were found' [ "${seen[0]}" -gt 15 -a "${seen[1]}" -gt 20 ]
finish
