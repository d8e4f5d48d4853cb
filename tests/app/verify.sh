#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The verification cases in their quick form: all cases except those with many particles and many steps, which make check-long runs, too.
set -u
. "$top_srcdir/tests/app/common.sh"
case $scree in /*) ;; *) scree=$PWD/$scree ;; esac

slow=" beverloo beverloo-3d drum-angle fluid-cylinder hard-beverloo hard-janssen hard-mu-of-i janssen settling water-hindered water-two-spheres "
[ -z "${SCREE_LONG:-}" ] || slow=' '
# fluids want PETSc
[ -e "$top_builddir/libsolve_petsc.la" ] || { slow="$slow$(cd "$top_srcdir/examples/verify" && echo fluid-* water-*) "; echo 'skipped: the cases of fluids: PETSc is not there'; }
cases=
for folder in "$top_srcdir"/examples/verify/*/check; do
    name=$(basename "$(dirname "$folder")")
    [[ $slow == *" $name "* ]] || cases="$cases $name"
done
# shellcheck disable=SC2086
SCREE=$scree VERIFY_RESULTS=$out/verify "$top_srcdir/examples/verify/run.sh" --quick $cases >"$out/lines"
check 'all cases hold' [ $? = 0 ]
cat "$out/lines"
check 'many cases' [ "$(grep -c ': passed, ' "$out/lines")" -ge 30 ]
not_blind() { # a case whose scene is spoilt fails: VERIFY_ARGS come last
    ! SCREE=$scree VERIFY_RESULTS=$out/spoilt VERIFY_ARGS='--set material_pairs[0].friction=0.25' \
        "$top_srcdir/examples/verify/run.sh" --quick slide-to-roll >"$out/spoilt.lines" 2>&1 &&
        holds "$out/spoilt.lines" 'slide-to-roll: failed'
}
check 'a wrong friction is noticed' not_blind
finish
