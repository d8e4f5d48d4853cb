#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the first steps of scenes in examples with a program built under sanitizers:
#
#   examples_sanitized.sh [STEPS [PATTERN [EVERY]]]    STEPS: 2; of the scenes with the PATTERN all, or every EVERYth
#
# A scene fails if a sanitizer speaks, or if the program dies. A scene that is refused (status 2), as a few want files that a script
# makes, or that a guard stops (3), is in order. Scenes that take longer than SECONDS_EACH (60) are cut, and named.
set -u
. "$(dirname "$0")/app/common.sh"
steps=${1:-2} pattern=${2:-.} every=${3:-1}
seconds=${SECONDS_EACH:-60}
cd "$out" || exit 1
bad=0 ran=0 cut=()

while IFS= read -r scene; do
    name=${scene#"$top_srcdir"/examples/}
    timeout --kill-after=10 "$seconds" env OMP_NUM_THREADS=2 "$scree" run "$scene" -o run --overwrite --quiet --set step.count="$steps" \
        --set duration='~' --set output.checkpoint.at_end=false >said 2>&1
    status=$?
    [ $status != 2 ] || ! grep -qE 'duration|stages' said || { # a scene of stages, or one that needs its duration
        timeout --kill-after=10 "$seconds" env OMP_NUM_THREADS=2 "$scree" check "$scene" >said 2>&1
        status=$?
    }
    ran=$((ran + 1))
    if grep -qE 'Sanitizer|runtime error:' said || [ $status -gt 3 -a $status != 124 ] || [ $status = 1 ]; then
        echo "FAILED: $name (status $status)"
        grep -E -A 12 'Sanitizer|runtime error:' said | head -n 30
        bad=$((bad + 1))
    fi
    [ $status != 124 ] || cut+=("$name")
done < <(find "$top_srcdir/examples" -name '*.yaml' | grep -E "$pattern" | sort | awk -v every="$every" 'NR % every == 0')

[ ${#cut[@]} = 0 ] || echo "cut after $seconds s: ${cut[*]}"
echo "$ran scenes, $bad failed"
[ $bad = 0 ] && [ $ran -gt 0 ]
