#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Resuming from a checkpoint: bit for bit on the same layout, within rounding on another layout; with other gravity and
# duration; after SIGTERM, SIGINT and SIGKILL; files that continue from the checkpoint, also with particles that come and go.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
. "$top_srcdir/tests/app/scenes.sh"
cd "$out" || exit 1

{
    cat <<'EOF'
units: none
step: {dt: 0.001, count: 120}
output: {checkpoint: {every: 80, keep: 9}}
guards: {overlap_bound: 0.9}
EOF
    bed
} >scene.yaml

# contacts with history in a checkpoint, or the tests below would test nothing
rows() {
    "$scree" info "$1" | awk -v name="$2" '$1 == name { print $2; found = 1 } END { exit !found }'
}

# same_layout RANKS THREADS [NAME SETTINGS...]: whole: 120 steps; then again from step 80
same_layout() {
    local whole=whole-$1-$2${3:-} again=again-$1-$2${3:-} ranks=$1 threads=$2
    shift $(($# > 2 ? 3 : 2))
    run_scene "$ranks" scene.yaml "$whole" --set threads="$threads" "$@" || return 1
    run_scene "$ranks" scene.yaml "$again" --set threads="$threads" "$@" --resume "$whole/checkpoint-80.h5" || return 1
    [ "$(number "$again/report.json" steps)" = 40 ] || { echo '  not 40 steps'; return 1; }
    contents "$whole/checkpoint-120.h5" >whole.txt && contents "$again/checkpoint-120.h5" >again.txt || return 1
    diff whole.txt again.txt
}

for layout in '1 1' '1 2' '2 1' '2 2'; do
    check "resumed bit for bit on ranks x threads $layout" same_layout $layout
done
chosen() {
    same_layout 2 2 -auto --set skin.auto=true || return 1
    local changes half
    changes=$(number whole-2-2-auto/report.json skin_changes) half=$(number again-2-2-auto/report.json skin_factor)
    echo "  $changes changes, factor $half at the end"
    [ "$changes" -ge 1 ] && [ "$half" != 1 ] && [ "$half" = "$(number whole-2-2-auto/report.json skin_factor)" ]
}
check 'resumed bit for bit with a skin that the run chooses' chosen
divided() {
    [ "$(number whole-3-1-bisection/report.json divisions)" -gt 0 ]
}
if [ $bisection = bisection ]; then
    check 'resumed bit for bit under a bisection that follows the load' same_layout 3 1 -bisection \
        --set domain.name=bisection --set domain.threshold=1.01
    check 'it was divided again on the way' divided
fi

# same_bits RANKS THREADS SETTING: the same 120 steps with another setting
same_bits() {
    local other=other-$1-$2-$3
    run_scene "$1" scene.yaml "$other" --set threads="$2" --set "$3" || return 1
    contents "$other/checkpoint-120.h5" >other.txt && contents "whole-$1-$2/checkpoint-120.h5" >whole.txt || return 1
    diff <(grep -vE '^/scene |^/runs/' other.txt) <(grep -vE '^/scene |^/runs/' whole.txt)
}
for layout in '1 1' '1 2' '2 1' '2 2'; do
    check "the fused step gives the bits of the plain one on ranks x threads $layout" same_bits $layout step.fused=false
done
check 'the baseline instructions give the bits of the widest' same_bits 1 1 simd=baseline
history_there() {
    local pairs walls
    pairs=$(rows whole-1-1/checkpoint-80.h5 /history/partner) && walls=$(rows whole-1-1/checkpoint-80.h5 /wall_history/wall_patch) &&
        [ "$pairs" -gt 800 ] && [ "$walls" -ge 40 ]
}
check 'more than fifty contacts between particles, five with walls are remembered' history_there

# other_layout FROM TO: the same 20 steps on other ranks
other_layout() {
    local bound=1e-11 from=whole-$1-1 ranks
    [ -e "$from" ] || run_scene "$1" scene.yaml "$from" --set threads=1 || return 1
    for ranks in "$1" "$2"; do
        run_scene "$ranks" scene.yaml "other-$ranks" --overwrite --set threads=1 --set output.dump.every=20 --set step.count=100 \
            --resume "$from/checkpoint-80.h5" || return 1
    done
    awk -f "$top_srcdir/examples/bidisperse/compare.awk" "other-$1/dump.lammpstrj" "other-$2/dump.lammpstrj" >difference || return 1
    awk -v bound=$bound '{ for (k = 1; k < NF; k++) if ($k == "position" || $k == "velocity") { seen++; worse += !($(k + 1) <= bound) } }
        END { if (seen < 2 || worse) { print "  " $0; exit 1 } }' difference
}
check 'resumed on 3 ranks what 1 rank wrote' other_layout 1 3
check 'resumed on 2 ranks what 3 ranks wrote' other_layout 3 2

# Frames every few steps: a run that stopped beyond its last checkpoint goes on in the same folder
cat >frames.txt <<'EOF'
--set output.trajectory.every=8 --set output.trajectory.contacts=16 --set output.dump.every=6 --set observables.every=4
EOF
files_go_on() {
    local flags ranks=$1 dir file
    flags=$(cat frames.txt)
    run_scene "$ranks" scene.yaml "smooth$ranks" $flags || return 1
    run_scene "$ranks" scene.yaml "broken$ranks" $flags --set step.count=110 --set output.checkpoint.at_end=false || return 1
    run_scene "$ranks" scene.yaml "broken$ranks" $flags --resume last || return 1
    for dir in "smooth$ranks" "broken$ranks"; do
        "$scree" convert "$dir/trajectory.h5" "$dir/frames.lammpstrj" || return 1
        sort "$dir/trajectory.xdmf" >"$dir/shown" # fields may change places
        "$scree" info "$dir/trajectory.h5" | tail -n +2 >"$dir/told"
    done
    for file in dump.lammpstrj observables.csv frames.lammpstrj told shown; do
        cmp "smooth$ranks/$file" "broken$ranks/$file" || return 1
    done
    [ "$(grep -c 'ITEM: TIMESTEP' "smooth$ranks/frames.lammpstrj")" = 16 ] && [ "$(wc -l <"smooth$ranks/observables.csv")" = 32 ]
}
check 'files of a run that stopped and went on equal those of one that did not' files_go_on 1
check 'so on two ranks' files_go_on 2

# Particles come at steps 100 and 200 and go at each 20th, so frames vary in length; the checkpoint is of step 160
varying=(--set step.force=true --set 'insertions=[{rate: 100, material: soft, sizes: 0.2, velocity_sigma: 2, region: {shape: box, lower: [0, 0, 1.6], upper: [6, 6, 8]}}]'
    --set 'deletions=[{every: 20, region: {shape: box, lower: [0, 0, 0], upper: [2, 2, 4]}}]'
    --set output.trajectory.every=8 --set output.dump.every=6 --set observables.every=4 --set output.checkpoint.every=160)
varying_go_on() {
    local whole=varying$1 parts=parted$1 dir file key first last
    run_scene "$1" scene.yaml "$whole" "${varying[@]}" --set step.count=240 || return 1
    run_scene "$1" scene.yaml "$parts" "${varying[@]}" --set step.count=230 --set output.checkpoint.at_end=false || return 1
    run_scene "$1" scene.yaml "$parts" "${varying[@]}" --set step.count=240 --resume last || return 1
    for dir in "$whole" "$parts"; do
        "$scree" convert "$dir/trajectory.h5" "$dir/frames.lammpstrj" || return 1
        "$scree" info "$dir/trajectory.h5" | tail -n +2 >"$dir/told"
        contents "$dir/checkpoint-240.h5" | grep -v '^/runs/' >"$dir/kept" || return 1
    done
    for file in dump.lammpstrj observables.csv frames.lammpstrj told kept; do
        cmp "$whole/$file" "$parts/$file" || return 1
    done
    [ "$(grep -A1 'NUMBER OF ATOMS' "$whole/frames.lammpstrj" | grep -c '^[0-9]')" = 31 ] || { echo '  not 31 frames'; return 1; }
    run_scene "$1" scene.yaml "$parts" --overwrite "${varying[@]}" --set step.count=160 || return 1
    for key in inserted deleted; do
        first=$(number "$parts/report.json" $key) last=$(number "$whole/report.json" $key)
        echo "  $key: $first, then $last"
        [ "$first" -gt 0 ] && [ "$last" -gt "$first" ] || return 1
    done
}
check 'so where particles come and go' varying_go_on 1
check 'these, too, on two ranks' varying_go_on 2

# A resume may change gravity and duration: a free fall that turns aside after 1 s
cat >fall.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [100, 100, 100]}
gravity: [0, 0, -2]
duration: 1
step: {dt: 0.001, force: true}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 1000}]
particles: {from: single, position: [50, 50, 50], radius: 1}
observables: {every: {time: 1}, list: [{name: position, id: 1}]}
EOF
turned_aside() {
    run_scene 1 fall.yaml fall && run_scene 1 fall.yaml fall --resume last --set 'gravity=[4, 0, 0]' --set duration=3 || return 1
    # x = 50 + 4 2^2 / 2; z = 49 - 2 2; a step's share of either acceleration apart
    [ "$(wc -l <fall/observables.csv)" = 5 ] &&
        tail -n 1 fall/observables.csv | awk -F, '{ exit !($1 == 3 && $2 - 58 < 0.01 && 58 - $2 < 0.01 && $3 == 50 && $4 - 45 < 0.01 && 45 - $4 < 0.01) }' ||
        { cat fall/observables.csv; return 1; }
}
check 'resumed with other gravity and duration' turned_aside

# goes_on DIR: its last checkpoint is whole, and ten more steps can be made
goes_on() {
    local step
    step=$(newest "$1")
    "$scree" info "$1/checkpoint-$step.h5" | grep -q 'checkpoint, whole' || { echo '  not whole'; return 1; }
    run_scene 1 scene.yaml "$1" --resume last --set step.count=$((step + 10)) || return 1
    [ -e "$1/checkpoint-$((step + 10)).h5" ] && [ "$(number "$1/report.json" steps)" = 10 ]
}

# process_of STARTER: the first rank's, somewhere below it
process_of() {
    local child=$1
    while [ -n "$child" ] && [ "$(cat /proc/"$child"/comm)" != "$(basename "$scree")" ]; do
        child=$(awk '{ print $NF }' /proc/"$child"/task/"$child"/children)
    done
    echo "$child"
}

# stopped RANKS SIGNAL NUMBER: sent to one rank
stopped() {
    local dir=stopped$1-$2 status
    on "$1" "$scree" run scene.yaml -o $dir --quiet --set step.count=100000000 --set output.checkpoint.every=1000000 \
        --set output.dump.every=50 >"$out/said" 2>&1 &
    local starter=$!
    wait_until lines_there $dir/dump.lammpstrj TIMESTEP 3 || return 1
    kill "-$2" "$(process_of $starter)" || return 1
    wait $starter
    status=$?
    [ $status = $((128 + $3)) ] || { echo "  status $status"; cat "$out/said"; return 1; }
    [ "$(number $dir/report.json last_step)" = "$(newest $dir)" ] || { echo '  no checkpoint of the last step'; return 1; }
    grep -q "\"stopped\": \"signal $3\"" $dir/report.json && goes_on $dir
}
check 'SIGTERM: a checkpoint, status 143, and it goes on' stopped 1 TERM 15
check 'SIGTERM to one of two ranks' stopped 2 TERM 15
check 'SIGINT: so with status 130' stopped 1 INT 2
check 'SIGINT to one of two ranks' stopped 2 INT 2

killed() {
    "$scree" run scene.yaml -o killed --quiet --set step.count=100000000 --set output.checkpoint.every=50 --set output.checkpoint.keep=2 &
    local victim=$!
    wait_for 'killed/checkpoint-*00.h5' || return 1
    kill -KILL $victim
    wait $victim 2>/dev/null
    goes_on killed
}
check 'SIGKILL: the last checkpoint is whole, and it goes on' killed

# Checkpoints by the clock: they come where 0.12 s may pass between them, and none where a year must
by_clock() {
    local victim
    "$scree" run scene.yaml -o clock --quiet --set step.count=100000000 --set output.checkpoint.every=0 \
        --set output.checkpoint.minutes=0.002 --set output.checkpoint.keep=1000 &
    victim=$!
    wait_for 'clock/checkpoint-*.h5' 3 || return 1
    kill -KILL $victim
    wait $victim 2>/dev/null
    goes_on clock || return 1
    run_scene 1 scene.yaml year --set step.count=500 --set output.checkpoint.every=0 --set output.checkpoint.minutes=525600 &&
        [ "$(echo year/checkpoint-*.h5)" = year/checkpoint-500.h5 ]
}
check 'checkpoints by the clock, and the last one goes on' by_clock

finish
