#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Stages of a scene: their ends, what they change, checkpoints between them, resumes within and between them, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >silo.yaml <<'EOS'
units: none
reproducible: true
gravity: [0, 0, -10]
box: {lower: [0, 0, -12], upper: [6, 6, 12], periodic: [true, true, false]}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.4, k_n: 2000}]
walls:
  - {name: gate, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: ground, shape: plane, point: [0, 0, -11], normal: [0, 0, 1]}
particles: {from: random, count: 40, sizes: 0.6, region: {shape: box, lower: [0, 0, 1], upper: [6, 6, 11]}}
step: {dt: 0.002}
guards: {overlap: warn}
stages:
  - {name: pour, after: 0.5, every: 50, until: [{name: energy_kinetic_mean, at_most: 0.001}, {name: count/above, at_least: 40}]}
  - {name: open, every: 50, set: {"walls[gate]": ~}, until: [{name: count/above, at_most: 0}]}
  - {name: push, duration: 0.5, set: {gravity: [2, 0, -10], "walls[ground].motion": [{kind: translate, velocity: [0, 0, 1]}], observables.every: 50}}
observables:
  every: 100
  regions: [{name: above, shape: box, lower: [-.inf, -.inf, 0]}]
  list: [{name: centre}, {name: momentum}, {name: wall_offset, target: ground}, {name: count, target: above}, {name: unbalanced_force}]
output: {checkpoint: {every: 300, keep: 99}, trajectory: {every: 500}}
EOS

# ends DIR: name, last step and reason of each stage of a report
ends() {
    sed -n 's/.*"name": "\([a-z]*\)", "first": [0-9]*, "last": \([0-9]*\),.*"end": "\(.*\)".*/\1 \2 \3/p' "$1/report.json"
}
check 'a run of three stages' run_scene 1 silo.yaml one
ends one >ends.txt
read -r _ pour _ <<<"$(sed -n 1p ends.txt)"
read -r _ open _ <<<"$(sed -n 2p ends.txt)"
read -r _ push _ <<<"$(sed -n 3p ends.txt)"
by_condition() {
    [ "$(sed 's/ [0-9]*//' ends.txt | tr '\n' ',')" = 'pour conditions,open conditions,push duration,' ] &&
        [ $((pour % 50)) = 1 ] && [ $((open % 50)) = 1 ] && [ $((push - open)) = 250 ] || { cat ends.txt; return 1; }
}
check 'two stages end a step after a look at their conditions, the third by its duration' by_condition
grew() { # the wall is gone, gravity has turned, the ground has moved
    awk -F, -v pour="$pour" -v open="$open" 'NR > 1 { step = $1 / 0.002 }
        NR > 1 && step <= pour && $11 != 40 { bad = "fell early" }
        END { if ($11 != 0) bad = "stayed"; if (!($5 > 30)) bad = "gravity " $5; if ($10 < 0.4 || $10 > 0.51) bad = "ground " $10
              print bad; exit bad != "" }' one/observables.csv
}
check 'a wall goes, gravity turns, the ground moves' grew
rows_once() {
    awk -F, 'NR > 2 && $1 <= last { bad = 1 } NR > 2 && $1 - last < 0.11 { fine++ } { last = $1 } END { exit bad || fine < 4 }' one/observables.csv
}
check 'rows go on through all stages, and become finer in the last' rows_once
has_boundaries() {
    [ -f "one/checkpoint-$pour.h5" ] && [ -f "one/checkpoint-$open.h5" ] && [ -f "one/checkpoint-$push.h5" ]
}
check 'a checkpoint at each end' has_boundaries

# same STEP FLAG...: a resume from this step ends with the bits of the run that was not interrupted
contents "one/checkpoint-$push.h5" >whole.txt
same() {
    local step=$1 ranks=$2
    shift 2
    rm -rf again
    run_scene "$ranks" silo.yaml again --resume "one/checkpoint-$step.h5" "$@" && checkpoint_lines "again/checkpoint-$push.h5" >lines.txt &&
        checkpoint_lines "one/checkpoint-$push.h5" | diff - lines.txt >/dev/null
}
check 'a resume within the first stage has the same bits' same 300 1
check 'a resume from the end of a stage has the same bits' same "$pour" 1
check 'a resume within the second stage has the same bits' same $((pour - pour % 300 + 300)) 1
check 'and on two ranks with another index' same "$open" 2 --set index=linkcell
waits() { # from the end of the stage before, not from the start of the run
    run_scene 1 silo.yaml wait --set 'stages=[{name: fall, duration: 0.2}, {name: wait, after: 0.1, every: 10, until: [{name: particles, at_least: 1}]}]' &&
        [ "$(ends wait | tr '\n' ',')" = 'fall 100 duration,wait 151 conditions,' ] || { ends wait; return 1; }
}
check 'a stage looks at its conditions after a time of its own' waits
brings() { # gravity and walls, beside the usual observables
    run_scene 1 silo.yaml bring --set gravity='[0, 0, 0]' --set walls='~' --set observables.regions='~' --set observables.list='~' \
        --set 'stages=[{name: still, duration: 0.02}, {name: fall, duration: 0.2, set: {gravity: [0, 0, -10], walls: [{name: ground, shape: plane, point: [0, 0, -11], normal: [0, 0, 1]}]}}]' &&
        [ "$(awk -F, '{ print NF }' bring/observables.csv | sort -u | wc -l)" = 1 ] && holds bring/observables.csv energy_gravity && holds bring/observables.csv work_walls
}
check 'a stage brings gravity and walls: their columns are there from the start' brings
never() { # a number that is none meets no condition
    run_scene 1 silo.yaml never --set 'stages=[{name: wait, duration: 0.1, every: 10, until: [{name: mean, of: z, where: z > 1e6, at_least: -1e9}]}]' &&
        [ "$(ends never)" = 'wait 50 duration, before the conditions held' ] || { ends never; return 1; }
}
if grep -q 'define HAVE_MUPARSER 1' "$top_builddir/config.h"; then
    check 'a condition on what is not there' never
else
    skip 'a condition on an expression: no muParser'
fi
two_ranks() {
    run_scene 2 silo.yaml two --set index=linkcell && [ "$(ends two)" = "$(cat ends.txt)" ] &&
        checkpoint_lines "two/checkpoint-$push.h5" >lines.txt && checkpoint_lines "one/checkpoint-$push.h5" | diff - lines.txt >/dev/null
}
check 'all stages on two ranks have the same bits' two_ranks
by_hand() { # the last stage is a resume of a scene that has changed
    grep -v '^stages:\|^  - {name: \(pour\|open\|push\)\|name: gate' silo.yaml >hand.yaml
    rm -rf hand
    run_scene 1 hand.yaml hand --resume "one/checkpoint-$open.h5" --set step.count="$push" --set gravity='[2, 0, -10]' \
        --set 'walls[ground].motion=[{kind: translate, velocity: [0, 0, 1]}]' &&
        checkpoint_lines "hand/checkpoint-$push.h5" >lines.txt && checkpoint_lines "one/checkpoint-$push.h5" | sed 's/stage: [a-z ]* [0-9a-f]* //g; s/ stage: began.*//' |
        diff - lines.txt >/dev/null
}
check 'a stage is a resume of the scene with its changes' by_hand
over() {
    "$scree" run silo.yaml -o one --resume last 2>said && holds said 'all 3 stages are over'
}
check 'a run whose stages are over has nothing to do' over
shows() {
    "$scree" check --all silo.yaml >said 2>&1 && holds said 'until energy_kinetic_mean <= 0.001 and count/above >= 40' && holds said 'sets {"walls[gate]": ~}'
}
check 'scree check shows the stages' shows

# refused WORDS SETTING...: such a scene, with one message of these words
refused() {
    local words=$1 flag
    local -a flags=()
    shift
    for flag in "$@"; do flags+=(--set "$flag"); done
    scene_refused "$words" silo.yaml "${flags[@]}"
}
check 'a key that cannot change' refused "command line|stages[1].set: stage 'open' cannot change 'particles.sizes'|gravity, walls" 'stages[1].set={particles.sizes: 1}'
check 'a name that no wall has' refused "walls[gat]|gate, ground|in stage 'open', stages[1].set" 'stages[1]={name: open, duration: 1, set: {"walls[gat].radius": 3}}'
sed 's/"walls\[gate\]": ~/"walls[gat]": ~/' silo.yaml >typo.yaml
check 'with its line' scene_refused "typo.yaml:16: walls[gat]: nothing in this list is called 'gat'; known: gate, ground (in stage 'open', stages[1].set)" typo.yaml
check 'a value out of range' refused "gravity|three numbers|in stage 'push'" 'stages[2].set={gravity: 3}'
check 'a material of another name' refused "stage 'open' adds, drops or renames a material" 'stages[1].set={"materials[0].name": steel}'
check 'a wall that becomes permeable' refused "stage 'push' changes \`permeable\` of a wall" 'stages[2].set={"walls[ground].permeable": true}'
check 'a stage without an end' refused "stages[1]|stage 'open' has no end; give duration, or until" 'stages[1]={name: open}'
check 'a condition without a bound' refused "stages[0].until[0]|give at_least or at_most" 'stages[0].until=[{name: particles}]'
check 'a condition on a vector' refused "the vector 'momentum'; give component" 'stages[0].until=[{name: momentum, at_most: 1}]'
check 'a wall that is gone' refused "stages[2].until[0]|stage 'push'|a wall of the scene as it is in this stage" 'stages[2].until=[{name: wall_force/gate, component: z, at_most: 1}]'
check 'two stages of one name' refused "stages[1].name|pour" 'stages[1].name=pour'
check 'a duration of the whole' refused 'duration: the scene has stages' duration=3
check 'changes in the first stage' refused "stage 'pour' is the first" 'stages[0].set={gravity: [0, 0, -1]}'
refused_ablate() {
    ! "$scree" ablate silo.yaml -o table --steps 300 >said 2>&1 && holds said "ablate compares runs without stages"
}
check "scree ablate refuses stages" refused_ablate

finish
