#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Files that cannot be opened, read or closed on one rank: each run soon ends with status 1 and a message that names the
# file, or the run writes the same files as without the fault. Folders of long names, and folders without permission to write.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

fail_call=$top_builddir/tests/app/.libs/fail_call.so
[ -e "$fail_call" ] || make -s -C "$top_builddir" tests/app/fail_call.la >"$out/made" 2>&1

cat >scene.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: [true, true, false], leave: error}
step: {dt: 0.0007, count: 20}
contact: {law: hooke}
guards: {overlap_bound: 1.5}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, friction: 0.5, k_n: 1500}]
groups: [{name: others, motion: free, select: {ids: [3, 4]}}]
particles: {sources: [{from: random, count: 200, velocity_sigma: 6, sizes: {law: uniform, min: 0.15, max: 0.3}}]}
walls:
  - {name: floor, shape: plane, material: soft, point: [0, 0, 0.01], normal: [0, 0, 1]}
  - {name: lid, shape: plane, material: soft, point: [0, 0, 5.99], normal: [0, 0, -1]}
output: {checkpoint: {every: 10, keep: 9}, trajectory: {every: 5}}
YAML

# again RANKS: a folder as a run on so many ranks left it at step 10
again() {
    rm -rf again
    mkdir again
    cp "whole$1/checkpoint-10.h5" "whole$1/trajectory.h5" again
}

limit=100 # a rank that waits for ever is one of the faults looked for

# with RANKS CALL FILE NUMBER ERRNO RANK COMMAND...
with() {
    local ranks=$1
    export FAIL_CALL=$2 FAIL_FILE=$3 FAIL_NUMBER=$4 FAIL_ERRNO=$5 FAIL_RANK=$6 FAIL_NOTE=$out/failed
    shift 6
    rm -f failed
    on "$ranks" env LD_PRELOAD="$fail_call" ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" "$@" >said 2>&1
}

# unreadable RANKS CALL FILE ERRNO NUMBER...: the resumed run, with one call of the last rank that fails
unreadable() {
    local ranks=$1 call=$2 file=$3 errno=$4 number status reached=0
    shift 4
    for number; do
        again "$ranks"
        with "$ranks" "$call" "$file" "$number" "$errno" $((ranks - 1)) "$scree" run scene.yaml -o again --quiet --resume last
        status=$?
        [ -e failed ] && reached=$((reached + 1))
        if [ $status = 0 ]; then
            contents again/checkpoint-20.h5 | cmp - "whole$ranks.txt" || { echo "  $call $number: another state"; return 1; }
            [ "$(frames_of again)" = "$(frames_of "whole$ranks")" ] || { echo "  $call $number: other frames"; return 1; }
        elif [ $status != 1 ] || [ "$(grep -c '^scree: ' said)" != 1 ] || ! grep -q "^scree: again/$file" said; then
            echo "  $call $number: status $status"
            cat said
            return 1
        fi
    done
    [ $reached -ge "$least" ] || { echo "  only $reached calls failed"; return 1; }
}
frames_of() {
    "$scree" info "$1/trajectory.h5" | tail -n +2
}

# has_open PID: for wait_until
has_open() { ls -l "/proc/$1/fd" | grep -q '/trajectory.h5$'; }

# opened_by_others: MPI waits for ever after its open has failed on one rank; the signal of the timer is sent by hand
opened_by_others() {
    local rank ranks status
    again 2
    rm -f failed # of the check before: `with` removes it, too, but maybe after the wait has begun
    with 2 open trajectory.h5 2 24 1 "$scree" run scene.yaml -o again --quiet --resume last &
    wait_for failed || return 1
    ranks=$(ranks_of $!)
    [ "$(wc -w <<<"$ranks")" = 2 ] || { echo "  not two ranks: $ranks"; return 1; }
    wait_until has_open "$(head -n 1 <<<"$ranks")" # the first rank waits, too
    for rank in $ranks; do
        kill -ALRM "$rank"
    done
    wait $!
    status=$?
    # the other rank may say so too, as each waits for the other
    [ $status = 1 ] && grep -q '^scree: again/trajectory.h5: cannot be opened on rank 1$' said &&
        ! grep '^scree: ' said | grep -qv 'cannot be opened on rank [01]$' ||
        { echo "  status $status"; cat said; return 1; }
}

whole() {
    run_scene "$1" scene.yaml "whole$1" && contents "whole$1/checkpoint-20.h5" >"whole$1.txt"
}

for ranks in 1 2; do
    check "a run to go on from, ranks: $ranks" whole $ranks
done
# `make check-long` lets each call fail, `make check` every tenth
every=${SCREE_LONG:+1}
every=${every:-10}
if [ -e "$fail_call" ]; then
    least=$((20 / every))
    check 'a checkpoint that cannot be read (EIO), one rank' unreadable 1 pread checkpoint-10 5 $(seq 1 "$every" 40)
    least=$((10 / every))
    check 'so on one of two ranks' unreadable 2 pread checkpoint-10 5 $(seq 2 $((2 * every)) 26)
    least=1
    check 'a checkpoint that cannot be opened (EMFILE), one of two ranks' unreadable 2 open checkpoint-10 24 1 2
    check 'a trajectory that cannot be opened (EMFILE), one of two ranks' unreadable 2 open trajectory.h5 24 1
    check 'the same inside of MPI: time is up at the rank that has not opened it' opened_by_others
    least=2
    check 'a trajectory that cannot be read (EIO), one rank' unreadable 1 pread trajectory.h5 5 $(seq 1 $((3 * every)) 41)
    check 'so on the second of two ranks' unreadable 2 pread trajectory.h5 5 1 3 8 16
    least=1
    check 'a trajectory that cannot be closed (EIO)' unreadable 2 close trajectory.h5 5 1 2 3
else
    skip 'calls that fail (no shared libraries)'
fi

echo '== long names of folders'
# long LENGTH: sets `dir`, a path of so many characters in folders of 200
long() {
    rm -rf "$out/l"
    dir=$out/l
    while [ $((${1} - ${#dir})) -gt 201 ]; do dir=$dir/$(head -c 199 /dev/zero | tr '\0' x); done
    dir=$dir/$(head -c $(($1 - ${#dir} - 1)) /dev/zero | tr '\0' y)
    mkdir -p "$(dirname "$dir")"
}
# written LENGTH RANKS: a run and a resume in such a folder
written() {
    long "$1"
    run_scene "$2" scene.yaml "$dir" && run_scene "$2" scene.yaml "$dir" --resume last --set step.count=25 || return 1
    [ -e "$dir/checkpoint-25.h5" ] && [ -e "$dir/trajectory.h5" ] && contents "$dir/checkpoint-20.h5" | cmp - "whole$2.txt"
}
for length in 220 235 974; do
    check "$length characters" written $length 1
done
check '235 characters, two ranks' written 235 2
too_long() { # LENGTH: refused before anything is made
    long "$1"
    "$scree" run scene.yaml -o "$dir" --quiet >said 2>&1
    [ $? = 2 ] && holds said 'characters; with the names of files' && [ ! -e "$dir" ]
}
check '976 characters are refused' too_long 976
check 'so are 1,100' too_long 1100

echo '== folders that cannot be written to'
# unwritable FOLDER FLAG...: refused, by a user who is not root, before the particles are made (there are too many)
as_user=()
[ "$(id -u)" != 0 ] || as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
unwritable() {
    local dir=$1
    shift
    timeout "$limit" "${as_user[@]}" "$scree" run scene.yaml -o "$dir" --quiet --set particles.sources[0].count=100000000 "$@" >said 2>&1
    [ $? = 2 ] && holds said "scree: $dir: " && holds said 'Permission denied'
}
mkdir closed
chmod 555 closed
chmod 755 "$out"
if [ "$(id -u)" != 0 ] || setpriv --reuid=65534 --regid=65534 --clear-groups "$scree" --version >/dev/null 2>&1; then
    check 'an old one' unwritable closed --overwrite
    check 'a new one in it' unwritable closed/new
    check 'one to resume in' unwritable closed --resume "$out/whole1/checkpoint-10.h5"
else
    skip 'folders that cannot be written to (root may write everywhere here, and setpriv cannot run the program)'
fi

finish
