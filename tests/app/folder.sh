#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The folder of a run: files that are overwritten, files of an earlier run, two runs at once, a disk that is full, a run that is
# killed.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >good.yaml <<'EOF'
box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm]}
gravity: [0, 0, -9.81]
step: {count: 50}
contact: {law: hertz}
materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm}
output: {trajectory: {every: 10}, dump: {every: 10}, checkpoint: {every: 10, keep: 9}}
EOF

files() { (cd "$1" && ls | tr '\n' ' '); }

# holds_files DIR NAME...: these and no others
holds_files() {
    local dir=$1 got
    shift
    got=$(files "$dir")
    [ "$got" = "$* " ] || { echo "  $dir holds $got"; return 1; }
}

check 'a run' run_scene 1 good.yaml dir
echo mine >dir/notes.txt
touch dir/checkpoint-70-stopped.h5 dir/checkpoint-80.h5.part

echo '== going on from an earlier step'
check 'a resume' run_scene 1 good.yaml dir --set step.count=25 --resume dir/checkpoint-20.h5
check 'leaves no later checkpoints' holds_files dir checkpoint-10.h5 checkpoint-20.h5 checkpoint-25.h5 \
    dump.lammpstrj notes.txt report.json trajectory.h5 trajectory.xdmf

echo '== writing over'
check 'another run' run_scene 1 good.yaml dir --overwrite --set step.count=5 --set output.trajectory.every=0 \
    --set output.dump.every=0
check 'leaves nothing of the first, and what is not of a run' holds_files dir checkpoint-5.h5 notes.txt report.json
last() { run_scene 1 good.yaml "$1" --resume last --set step.count="$2" && [ "$(number "$1/report.json" last_step)" = "$2" ]; }
check 'the last checkpoint is its own' last dir 8

echo '== a run that is over'
over() { # DIR FLAG...: nothing to do, nothing written
    local dir=$1
    shift
    cat $dir/* 2>/dev/null | cksum >before
    run_scene 1 good.yaml $dir "$@" || return 1
    holds said "checkpoint-8.h5 is already at step 8, time" && holds said 'nothing to do: give a longer duration' &&
        cat $dir/* 2>/dev/null | cksum | cmp - before
}
check 'is not gone on with' over dir --resume last --set step.count=8
check 'nor one that is beyond its end' over dir --resume dir/checkpoint-8.h5 --set step.count=5
check 'nor one whose time is over' over dir --resume last --set 'step=~' --set duration="$(number dir/report.json time)"
check 'no folder is made for it' over none --resume dir/checkpoint-8.h5 --set step.count=8
check 'so that there is none' [ ! -e none ]

echo '== standard output that cannot be written'
mute() { # COMMAND...: status 1 and one line that says so, beside notes on the scene
    "$scree" "$@" >/dev/full 2>said
    [ $? = 1 ] && [ "$(grep -vcE 'NOTE: |warning: other programs' said)" = 1 ] && holds said 'scree: standard output cannot be written'
}
check 'help' mute help
check 'help of a key' mute help index.name
check 'version' mute --version
check 'check' mute check good.yaml
check 'info' mute info dir/checkpoint-8.h5
check 'run' mute run good.yaml -o unsaid --set output.progress=off
check 'whose files are whole' last unsaid 60
said_wrong() { "$scree" check nowhere.yaml >/dev/full 2>said; [ $? = 2 ]; }
check 'another error keeps its status' said_wrong

echo '== two runs at once'
"$scree" run good.yaml -o busy --quiet --set step.count=1000000000 --set output.trajectory.every=0 --set output.dump.every=0 \
    --set output.checkpoint.keep=1 &
runner=$!
check 'the first writes checkpoints' wait_for 'busy/checkpoint-*.h5'
second() {
    "$scree" run good.yaml -o busy --quiet "$@" >said 2>&1
    [ $? = 2 ] && grep -q 'busy: another run' said || { cat said; return 1; }
}
check 'the second is refused' second --overwrite
check 'also where it resumes' second --resume dir/checkpoint-8.h5
killed() {
    kill -KILL $runner
    wait $runner 2>/dev/null
    local newest
    newest=$(ls busy | sed -n 's/^checkpoint-\([0-9]*\)\.h5$/\1/p' | sort -n | tail -n 1)
    run_scene 1 good.yaml busy --resume last --set step.count=$((newest + 2)) --set output.trajectory.every=0 \
        --set output.dump.every=0 && [ "$(number busy/report.json last_step)" = $((newest + 2)) ]
}
check 'one that is killed while it writes checkpoints is resumed' killed

finish
