#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Faults while several ranks run: a rank that is killed, signals, a disk that is full, a checkpoint cut short, a message of the
# wrong length. Each fault ends the job with one message that names the fault, and leaves a checkpoint from which the run goes on, on
# another number of ranks and with another division of the box.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
cd "$out" || exit 1

cut_message=$top_builddir/tests/app/.libs/cut_message.so cut_write=$top_builddir/tests/app/.libs/cut_write.so
[ -e "$cut_write" ] || make -s -C "$top_builddir" tests/app/cut_message.la tests/app/cut_write.la >"$out/made" 2>&1

# Fast enough that particles change ranks at each rebuild, with springs, and a boulder whose copies take several rounds
cat >scene.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [9, 6, 6], periodic: true}
step: {dt: 0.0007, count: 40, rebuild_every: 10}
contact: {law: hooke}
guards: {overlap_bound: 1.5}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, friction: 0.5, k_n: 1500}]
particles:
  sources:
    - {from: single, position: [4, 3, 3], radius: 1.8, velocity: [3, 2, 1]}
    - {from: random, count: 400, velocity_sigma: 6, sizes: {law: uniform, min: 0.15, max: 0.3}}
skin: {length: 0.2}
domain: {name: brick}
EOF

# start RANKS DIR [FLAG...]: in the background, for longer than anybody waits; what it says is in DIR.said
start() {
    local ranks=$1 dir=$2
    shift 2
    limit=400 on "$ranks" "$scree" run scene.yaml -o "$dir" --quiet --set step.count=100000000 "$@" >"$dir.said" 2>&1 &
    starter=$!
}

# job COMMAND...: what it started is over afterwards, also where it gave up half-way
job() {
    local good running
    starter=
    "$@"
    good=$?
    running=$(ranks_of "$starter")
    [ -z "$running" ] || kill -KILL $running
    wait 2>/dev/null
    return $good
}

# gone PID: waits until it is; a dead process that nobody asks for is gone. One that stays is told once the limit of the job is over
gone() {
    local end=$((SECONDS + limit))
    while grep -q '^State:.*[^ZX] (' /proc/"$1"/status 2>/dev/null; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.1
    done
}

# ended: waits for the job, all of it; sets `status`, which is 124 if the job had to be ended
ended() {
    local pid
    wait "$starter" 2>/dev/null
    status=$?
    [ $status != 124 ] || { echo '  the job did not end by itself'; return 1; }
    for pid in $pids; do
        gone "$pid" || { echo "  process $pid is still there"; return 1; }
    done
}

# says_once FILE WORDS: one line of the program, with all words (separated by |)
says_once() {
    local said word
    local -a list
    said=$(grep '^scree: ' "$1")
    [ "$(grep -c . <<<"$said")" = 1 ] || { echo "  not one message:"; cat "$1"; return 1; }
    IFS='|' read -ra list <<<"$2"
    for word in "${list[@]}"; do
        grep -qF -e "$word" <<<"$said" || { echo "  no '$word' in: $said"; return 1; }
    done
}

# all_whole DIR: what bears the name of a checkpoint is one
all_whole() {
    local file
    for file in "$1"/checkpoint-*.h5; do
        "$scree" info "$file" | grep -q 'checkpoint, whole' || { echo "  $file is not whole"; return 1; }
    done
}

# goes_on DIR RANKS: from its last checkpoint, by ten steps, divided otherwise
goes_on() {
    local step
    step=$(newest "$1")
    all_whole "$1" || return 1
    run_scene "$2" scene.yaml "$1" --resume last --set step.count=$((step + 10)) --set domain="$bisection" --set output.dump.every=10 || return 1
    [ "$(number "$1/report.json" last_step)" = $((step + 10)) ] && [ "$(number "$1/report.json" particles)" = 401 ] &&
        [ -e "$1/checkpoint-$((step + 10)).h5" ] && ! compgen -G "$1/*.part" >/dev/null
}

echo '== ranks that die'
# killed RANK CHECKPOINT: SIGKILL to one of three ranks, once this checkpoint is there
killed() {
    local dir=killed$1
    start 3 "$dir" --set output.checkpoint.every=7 --set output.checkpoint.keep=1000
    wait_for "$dir/checkpoint-$2.h5" || return 1
    pids=$(ranks_of "$starter")
    [ "$(wc -w <<<"$pids")" = 3 ] || { echo "  not 3 ranks: $pids"; return 1; }
    kill -KILL "$(sed -n "$(($1 + 1))p" <<<"$pids")"
    ended || return 1
    [ $status = 137 ] || { echo "  status $status"; return 1; }
    [ "$(grep -c "process rank $1 .*exited on signal 9" "$dir.said")" = 1 ] && ! grep '^scree' "$dir.said" ||
        { echo '  not one message:'; cat "$dir.said"; return 1; }
    goes_on "$dir" $((4 - 2 * ($1 % 2)))
}
check 'SIGKILL to rank 1 of 3: one message; 2 ranks go on' job killed 1 14
check 'SIGKILL to rank 0 of 3: one message; 4 ranks go on' job killed 0 35

# stopped: SIGTERM to one rank
stopped() {
    start 3 stopped --set output.checkpoint.every=1000000 --set observables.every=1
    wait_until lines_there stopped/observables.csv '^[0-9]' 3 || return 1
    pids=$(ranks_of "$starter")
    kill -TERM "$(sed -n 2p <<<"$pids")"
    ended || return 1
    [ $status = 143 ] && ! grep '^scree' stopped.said || { echo "  status $status"; cat stopped.said; return 1; }
    [ "$(number stopped/report.json last_step)" = "$(newest stopped)" ] &&
        grep -q '"stopped": "signal 15"' stopped/report.json && goes_on stopped 2
}
check 'SIGTERM to one rank of 3: a checkpoint, and 2 ranks go on' job stopped

# all_stopped: SIGTERM to mpirun, which gives ranks a second
all_stopped() {
    local parent
    start 3 ended --set output.checkpoint.every=7 --set output.checkpoint.keep=1000
    wait_for ended/checkpoint-14.h5 || return 1
    pids=$(ranks_of "$starter")
    parent=$(awk '/^PPid/ { print $2 }' /proc/"$(head -n 1 <<<"$pids")"/status)
    kill -TERM "$parent"
    ended || return 1
    [ $status != 0 ] && goes_on ended 2
}
check 'SIGTERM to mpirun: the last checkpoint is whole, and 2 ranks go on' job all_stopped

echo '== full disks'
# full NAME RANKS FILE LESS WORDS FLAG...: so many ranks of a run may write no file larger than FILE, a pattern, is after a
# while, less LESS
full() {
    local dir=full-$1 limited=$2 file=$3 less=$4 words=$5 pid size
    shift 5
    run_scene 2 scene.yaml "$dir" --set step.count=10 || return 1
    start 2 "$dir" --resume last --set output.checkpoint.every=1000000 "$@"
    wait_for "$dir/$file" || return 1
    pids=$(ranks_of "$starter")
    size=$(stat -c %s "$dir"/$file 2>/dev/null | head -n 1)
    for pid in $(tail -n "$limited" <<<"$pids"); do
        prlimit --pid "$pid" --fsize=$((size + 1 - less)) || return 1
    done
    ended || return 1
    [ $status = 1 ] || { echo "  status $status"; cat "$dir.said"; return 1; }
    says_once "$dir.said" "$words" && goes_on "$dir" 3
}
if command -v prlimit >/dev/null; then
    check 'the dump cannot grow' job full dump 2 dump.lammpstrj 0 'dump.lammpstrj|cannot be written|File too large' \
        --set output.dump.every=1
    check 'the observables cannot grow' job full observables 2 observables.csv 0 'observables.csv|cannot be written|File too large' \
        --set observables.every=1
    check 'the trajectory cannot grow' job full trajectory 2 trajectory.h5 0 'trajectory.h5|File too large' \
        --set output.trajectory.every=1
    check 'one rank cannot write its part' job full part 1 trajectory.h5 0 'trajectory.h5|cannot be' --set output.trajectory.every=1
    check 'no room for the next checkpoint' job full checkpoint 2 'checkpoint-[2-9]0.h5' 5000 'checkpoint-|File too large' \
        --set output.checkpoint.every=10 --set output.checkpoint.keep=1000
else
    skip 'files that cannot grow (no prlimit here)'
fi

# A device that is always full stands for the file
always_full() {
    run_scene 2 scene.yaml device --set observables.every=1 || return 1
    ln -sf /dev/full device/observables.csv
    run_scene 2 scene.yaml device --resume last --set step.count=60 --set observables.every=1 >/dev/null
    [ $? = 1 ] && says_once said 'observables.csv|No space left on device' || { cat said; return 1; }
    rm device/observables.csv
    goes_on device 3
}
check 'no space left on device' always_full

# A small file system of one's own, where the system lets everybody have one
small_disk() {
    mkdir -p small
    unshare "$unshare" bash -c 'mount -t tmpfs -o size=3m none small && "$@" >said 2>&1; status=$?
        cp small/run/checkpoint-*.h5 small/run/report.json . 2>/dev/null; exit $status' _ "$@"
}
disk_full() {
    rm -f checkpoint-*.h5
    small_disk "$LAUNCH" -n 2 "$scree" run scene.yaml -o small/run --quiet --set step.count=100000 \
        --set output.dump.every=1 --set output.checkpoint.every=10 --set output.checkpoint.keep=1
    [ $? = 1 ] && says_once said 'small/run/|No space left on device' || { cat said; return 1; }
    mkdir -p kept && mv checkpoint-*.h5 kept && goes_on kept 3
}
# for everybody, or for root alone
for unshare in -rm -m none; do
    ! unshare "$unshare" mount -t tmpfs none /mnt 2>/dev/null || break
done
if [ $unshare != none ]; then
    check 'a disk that is full' disk_full
else
    skip 'a small file system (no user namespaces here)'
fi

echo '== checkpoints cut short'
cut_short() {
    local newest refused=0
    run_scene 2 scene.yaml cut --set output.checkpoint.every=20 --set output.checkpoint.keep=2 || return 1
    newest=cut/checkpoint-40.h5
    cp "$newest" whole.h5
    for size in 3000 $(($(stat -c %s whole.h5) / 2)) $(($(stat -c %s whole.h5) - 1)); do
        head -c "$size" whole.h5 >"$newest"
        run_scene 3 scene.yaml cut --resume "$newest" >/dev/null
        [ $? = 2 ] && says_once said "$newest" || { cat said; return 1; }
        "$scree" info "$newest" 2>/dev/null | grep -q 'checkpoint, whole' && return 1
        refused=$((refused + 1))
    done
    [ $refused = 3 ]
}
check 'three cuts are refused' cut_short
# one_before: with the newest cut short the one before serves, and one message says so
one_before() {
    run_scene 3 scene.yaml cut --resume last --set step.count=30 &&
        says_once said 'cut/checkpoint-40.h5: is cut off|going on from cut/checkpoint-20.h5 instead' &&
        [ "$(number cut/report.json steps)" = 10 ] && [ ! -e cut/checkpoint-40.h5 ] && goes_on cut 2
}
check 'the last one whole is the one before' one_before
none_whole() {
    local file
    for file in cut/checkpoint-*.h5; do
        head -c 3000 "$file" >part.h5
        cp part.h5 "$file"
    done
    run_scene 2 scene.yaml cut --resume last >/dev/null
    [ $? = 2 ] && says_once said "cut/checkpoint-$(newest cut).h5: is cut off" || { cat said; return 1; }
}
check 'none is whole: the newest is named' none_whole

echo '== writes that end too early on one rank'
# cut_one NUMBER WORDS: the NUMBERth write of rank 1; after some of them HDF5 never returns (h5_watch.h)
cut_one() {
    local dir=write status
    rm -rf $dir
    on 2 env LD_PRELOAD="$cut_write" ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" CUT_RANK=1 CUT_NUMBER="$1" \
        "$scree" run scene.yaml -o $dir --quiet --set output.trajectory.every=20 >write.said 2>&1
    status=$?
    [ $status = 1 ] && says_once write.said "$2|cannot be written" || { echo "  status $status"; cat write.said; return 1; }
}
if [ -e "$cut_write" ]; then
    check 'of a dataset' cut_one 8 '/particles/all/position/value'
    check 'of what HDF5 keeps about the file, in a flush' cut_one 3 'trajectory.h5'
    check 'of the same, in a later frame' cut_one 18 'trajectory.h5'
    printf '#include <scree.h>\nint main(int argc, char **argv) { return scree_main(argc, argv); }\n' >linked.c
    in_library() { # the same in a program that links the library
        ${CC:-cc} -I"$top_srcdir/src" linked.c -o linked -L"$top_builddir/.libs" -lscree "-Wl,-rpath,$top_builddir/.libs" || return 1
        local scree=$out/linked
        cut_one 3 'trajectory.h5'
    }
    if [ -e "$top_builddir/.libs/libscree.so" ] && ! grep -q -- -fsanitize "$top_builddir/config.status"; then
        check 'in a program that links the library' in_library
    else
        skip 'a program that links the library (no shared library, or sanitizers)'
    fi
    writes_alone() { ! cut_one 1000000 nothing >/dev/null && [ "$(number write/report.json last_step)" = 40 ]; }
    check 'and writes that are left alone do no harm' writes_alone
else
    skip 'writes that end too early (no shared libraries)'
fi

echo '== messages of the wrong length'
# cut NUMBER CALL BYTES: the NUMBERth message that rank 1 sends by CALL gets longer by BYTES
cut() {
    local status dir=message
    rm -rf $dir
    on 5 env LD_PRELOAD="$cut_message" ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" CUT_CALL="$2" CUT_RANK=1 \
        CUT_NUMBER="$1" CUT_BYTES="$3" "$scree" run scene.yaml -o $dir --quiet --set output.dump.every=10 \
        --set output.checkpoint.every=10 >message.said 2>&1
    status=$?
    [ $status = 1 ] && says_once message.said "scree: rank|rank 1|bytes" || { echo "  status $status"; cat message.said; return 1; }
}
if [ -e "$cut_message" ]; then
    for setting in '5 MPI_Isend -8' '8 MPI_Isend 8' '1 MPI_Issend -4' '3 MPI_Issend 4' '5 MPI_Issend -4' '7 MPI_Issend -3'; do
        check "number, call, bytes: $setting" cut $setting
    done
    uncut() { cut 1000000 MPI_Isend -8 >/dev/null; [ "$(number message/report.json last_step)" = 40 ]; }
    check 'and a message that is left alone does no harm' uncut
else
    skip 'messages of the wrong length (no shared libraries)'
fi

finish
