#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs without an end: the duration, or the number of steps, is infinite or huge. Each run makes steps until a signal ends the run,
# and leaves a checkpoint from which a run goes on to an end.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >scene.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [9, 9, 9], periodic: true}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 1500}]
particles: {from: single, position: [4, 3, 3], radius: 1, velocity: [3, 2, 1]}
EOF

# endless DIR SETTING: SIGTERM after some checkpoints; status 143
endless() {
    local pid
    "$scree" run scene.yaml -o "$1" --quiet --set step.dt=0.001 --set "$2" --set output.checkpoint.every=100 >said 2>&1 &
    pid=$!
    wait_for "$1/checkpoint-*00.h5"
    kill -TERM $pid 2>/dev/null
    wait $pid
    [ $? = 143 ] && [ "$(number "$1/report.json" last_step)" -ge 100 ] || { echo "  it ended by itself:"; cat said "$1/report.json"; return 1; }
}
check 'a duration of .inf' endless infinite duration=.inf
check 'a duration of 1e30' endless huge duration=1e30
check 'a step count of 1e18' endless steps step.count=1e18

goes_on() {
    local step
    step=$(($(number infinite/report.json last_step) + 50))
    run_scene 1 scene.yaml infinite --resume last --set step.dt=0.001 --set step.count=$step && [ "$(number infinite/report.json last_step)" = $step ]
}
check 'what was endless goes on to an end' goes_on

# refused SETTING WORDS
refused() {
    ! "$scree" run scene.yaml -o refused --set step.dt=0.001 --set "$1" >said 2>&1 && grep -qF "$2" said && ! [ -e refused ] || { cat said; return 1; }
}
check 'more steps than 64 bits count are refused' refused step.count=1e19 "step.count: '1e19' is out of range"
check 'and as digits' refused step.count=10000000000000000000 "is out of range"
check 'no number is none' refused duration=.nan 'duration: '

finish
