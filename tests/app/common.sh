# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the tests of the whole program (bash): finds the program, makes a folder that is removed at the end, and counts checks.
#
# Environment: top_builddir (absolute), top_srcdir, LAUNCH (tests/launch sets these two; by hand, in the build folder:
# top_builddir=$PWD ../tests/launch ../tests/app/SCRIPT).

scree=${SCREE:-$top_builddir/scree}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export OMP_WAIT_POLICY=passive # there may be more threads than cores
checks=0
failures=0

# check WHAT COMMAND...: a line; a failure is counted and the script goes on
check() {
    local what=$1
    shift
    checks=$((checks + 1))
    if "$@"; then
        echo "passed: $what"
    else
        echo "FAILED: $what"
        failures=$((failures + 1))
    fi
}

# check_long WHAT COMMAND...: one more check of a kind that the script has already; `make check-long` alone makes it
check_long() {
    [ -z "${SCREE_LONG:-}" ] || check "$@"
}

# in_turns SETTING...: sets `some` to all settings with SCREE_LONG, else to every second, the even and the odd ones in turns
in_turns() {
    local setting k=0
    some=()
    in_turns=$((1 - ${in_turns:-1}))
    for setting; do
        [ -z "${SCREE_LONG:-}" ] && [ $((k++ % 2)) != $in_turns ] || some+=("$setting")
    done
}

# skip WHAT: what is not tried here, and why, in a line that .ci/run lists
skip() {
    echo "skipped: $*"
}

# needs_petsc SCENE WHAT: the end of a script that tries a fluid in a build without PETSc, which must say so with status 2
needs_petsc() {
    "$scree" check --all "$1" >said 2>&1
    local status=$?
    [ $status != 0 ] || return 0
    skip "$2: $(cat said)"
    says_so() { [ $status = 2 ] && grep -q 'built without PETSc' said; }
    check 'a build without PETSc says so, with status 2' says_so
    finish
}

# rows_close DIR DIR BOUND: the last rows of observables, eight or more, agree to a part of their size; what is no number in one is none in both
rows_close() {
    paste -d , <(tail -n 1 "$1/observables.csv") <(tail -n 1 "$2/observables.csv") | awk -F , -v bound="$3" '{ m = NF / 2
        for (k = 1; k <= m; k++) {
            if ($k == $(k + m)) continue
            d = $k - $(k + m); a = $k < 0 ? -$k : $k
            if ($k ~ /nan/ || $(k + m) ~ /nan/ || !(d * d <= (bound * (a + 0.1)) ^ 2)) { print "  column", k, $k, $(k + m); bad = 1 }
        }
        exit bad || m < 8 }'
}

# take SCENE FEATURE...: `flags` gets the settings of features, lines of `sets[FEATURE]`, or of `sets[FEATURE-SCENE]` where this is there
take() {
    local scene=$1 feature line
    shift
    flags=()
    for feature; do
        [ -z "${sets[$feature-$scene]:-}" ] || feature=$feature-$scene
        while IFS= read -r line; do flags+=(--set "$line"); done <<<"${sets[$feature]}"
    done
}

# finish: the count, and the exit status
finish() {
    echo "$checks checks, $failures failed"
    [ "$failures" = 0 ] && [ "$checks" -gt 0 ]
    exit
}

# on RANKS COMMAND..., for at most `limit` seconds
limit=600
on() {
    if [ "$1" = 1 ]; then
        shift
        timeout "$limit" "$@"
    else
        TEST_SECONDS=$limit "$LAUNCH" -n "$@"
    fi
}

# run_scene RANKS SCENE DIR [FLAG...]: quietly; what the program says is shown if it fails
run_scene() {
    local ranks=$1 scene=$2 dir=$3
    shift 3
    on "$ranks" "$scree" run "$scene" -o "$dir" --quiet "$@" >"$out/said" 2>&1 || { local status=$?; cat "$out/said"; return $status; }
}

# indexes: the names of all indexes
indexes() {
    "$scree" help index.name | sed -n 's/,//g; s/^ *one of \(.*\); default .*/\1/p'
}

# number FILE KEY: a value of a report.json
number() {
    "$scree" info "$1" --get "$2"
}

# last_of FILE COLUMN: the value of a column of a table, with its unit or without, in the last row
last_of() {
    "$scree" info "$1" --column "$2" --row last
}

# within A B BOUND: |A - B| <= BOUND, all of them numbers
within() {
    awk -v a="$1" -v b="$2" -v bound="$3" 'BEGIN {
        good = a ~ /^[-+0-9.e]+$/ && b ~ /^[-+0-9.e]+$/ && a - b <= bound && b - a <= bound
        if (!good) print "  " a " and " b " differ by more than " bound
        exit !good }'
}

# holds FILE TEXT: the file has this text
holds() {
    grep -qF -e "$2" "$1" || { echo "  no '$2' in:"; head -n 5 "$1"; return 1; }
}

# lacks FILE TEXT: the file is there, without this text
lacks() {
    grep -F -e "$2" "$1"
    [ $? = 1 ]
}

# wait_until COMMAND...: until it is true; it fails once no job of the script is left that could make it true. The limit of the whole
# test (launch) ends a wait for what never comes: no test depends on how fast a machine is
wait_until() {
    until "$@"; do
        [ -n "$(jobs -r)" ] || { "$@"; return; }
        sleep 0.1
    done
}

# wait_for PATTERN [COUNT]: until there are so many such files (one)
files_there() { [ "$(compgen -G "$1" | wc -l)" -ge "${2:-1}" ]; }
wait_for() {
    wait_until files_there "$@" || { echo "  no $1"; return 1; }
}

# lines_there FILE PATTERN COUNT: the file has so many such lines; for wait_until
lines_there() { [ "$(grep -acE -e "$2" "$1" 2>/dev/null)" -ge "$3" ]; }

# ranks_of PID: the processes of the program below a starter
ranks_of() {
    local child
    for child in $(cat /proc/"$1"/task/*/children 2>/dev/null); do
        if [ "$(cat /proc/"$child"/comm)" = "$(basename "$scree")" ]; then
            echo "$child"
        else
            ranks_of "$child"
        fi
    done
}

# newest DIR: the last checkpoint's step
newest() {
    find "$1" -name 'checkpoint-*.h5' | sed 's/.*checkpoint-\([0-9]*\)\.h5/\1/' | sort -n | tail -n 1
}

# find_bisection: sets `bisection`; without Zoltan there are only bricks
find_bisection() {
    bisection=bisection
    grep -q 'define HAVE_ZOLTAN 1' "$top_builddir/config.h" && return
    bisection=brick
    skip 'bisection: this program has no Zoltan'
}

# browse SECONDS FLAG... URL: headless Chromium, which calls nobody and keeps nothing; `browser` is empty where there is none
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
browse() {
    local seconds=$1
    shift
    HOME=$out timeout "$seconds" "$browser" --headless --no-sandbox --disable-quic --no-first-run --disable-background-networking \
        --disable-component-update --disable-sync --user-data-dir="$(mktemp -d "$out/browser.XXXX")" "$@"
}

# checkpoint_lines CHECKPOINT: what it holds, in lines that do not depend on the layout
checkpoint_lines() {
    local lines=$top_builddir/tests/checkpoint_lines
    [ -x "$lines" ] || make -s -C "$top_builddir" tests/checkpoint_lines >&2 || return 1
    "$lines" "$1" >"$out/unsorted" && sort "$out/unsorted"
}

# contents CHECKPOINT: name, bytes and checksum of each dataset, from the table at its head (between the datasets HDF5 may
# leave what it likes)
contents() {
    head -c 8192 "$1" | grep -a '^dataset ' | awk '{ print $2, $4, $6 } END { exit NR < 20 }'
}

# scene_refused WORDS SCENE SETTING...: `check` refuses the scene with status 2 and one line that has these words (separated by |)
scene_refused() {
    local words=$1 scene=$2 word
    local -a list
    shift 2
    on 1 "$scree" check "$scene" "$@" >/dev/null 2>said
    [ $? = 2 ] && [ "$(wc -l <said)" = 1 ] || { cat said; return 1; }
    IFS='|' read -ra list <<<"$words"
    for word in "${list[@]}"; do
        grep -qF -e "$word" said || { echo "  no '$word' in: $(cat said)"; return 1; }
    done
}

# energy_kept FILE: the balance of energies never grows by more than 1 % of its start, nor falls by more than 2 %
energy_kept() {
    awk -F, -v column=energy_balance 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ "^" column) c = k; next } NR == 2 { first = $c }
        { if ($c > 1.01 * first || $c < 0.98 * first) bad = 1; last = $c } END { print "  energy", last / first; exit bad }' "$1"
}
# bed_everywhere: bed.yaml, with a checkpoint of step 1200, on threads, another index, after a resume and on ranks. The script has `rests DIR`,
# which says whether a run has come to rest as it should, and `same DIR DIR`, whether two runs have the same bits
bed_everywhere() {
    check 'a bed' run_scene 1 bed.yaml one --set threads=1
    check 'it rests' rests one
    check 'two threads' run_scene 1 bed.yaml two --set threads=2
    check 'the same bits' same one two
    check 'another index' run_scene 1 bed.yaml brute --set threads=1 --set index.name=brute
    check 'the same bits' same one brute
    check 'a run that goes on' run_scene 1 bed.yaml rest --set threads=1 --resume one/checkpoint-1200.h5
    check 'the same bits' same one rest
    check '3 ranks' run_scene 3 bed.yaml three --set threads=1
    check 'it rests' rests three
    check 'goes on, on 2 ranks, newton off' run_scene 2 bed.yaml goes --set threads=1 --set newton=false --resume three/checkpoint-1200.h5
    check 'it rests' rests goes
}

# many.yaml is run as `one`, and again as `other` on more ranks, threads and indexes, and from its checkpoint of step 600. The script has `rows DIR`, the
# particles at the end, and `row DIR`, the observables that must be the same
many_same() { rows other | cmp - one.rows && row other | cmp - one.row; }
many_one() { rm -rf one && run_scene 1 many.yaml one --set threads=1 && rows one >one.rows && row one >one.row; }
many_layouts() {
    local layout
    for layout in '1 2 hgrid' '3 1 linkcell' '2 2 multi'; do
        # shellcheck disable=SC2086
        set -- $layout
        rm -rf other && run_scene "$1" many.yaml other --set "threads=$2" --set "index.name=$3" && many_same || { echo "  $layout"; return 1; }
    done
}
many_resumes() { rm -rf other && run_scene "$1" many.yaml other --set threads=1 --resume one/checkpoint-600.h5 && many_same; }
