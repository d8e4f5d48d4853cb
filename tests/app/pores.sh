#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Examples of flow through pores, small: a packing of beads that is poured and flowed through, and the page of results.
set -u
. "$top_srcdir/tests/app/common.sh"
case $scree in /*) ;; *) scree=$PWD/$scree ;; esac

# the page has what the results say
check 'docs/pores.md is what examples/pores.sh writes' eval 'mkdir -p "$out/docs/results" && cp -r "$top_srcdir/docs/results/pores" "$out/docs/results/" &&
    sh "$top_srcdir/examples/pores.sh" "$out/docs" && cmp "$out/docs/pores.md" "$top_srcdir/docs/pores.md"'

if [ ! -e "$top_builddir/libsolve_petsc.la" ]; then
    skip 'flow through a packing: PETSc is not there'
    finish
fi
check 'beads are poured, and water flows through them' env SCREE="$scree" SCREE_ARGS='--set fluid.solver.tolerance=4e-3' sh "$top_srcdir/examples/bead_packing/check" "$out/beads"
check 'solves end at the end of a cycle of 16 iterations' awk 'match($0, /"iterations": [0-9]+/) { n++; i = substr($0, RSTART + 14, RLENGTH - 14) + 0; bad += i % 16 > 0 } END { exit !(n == 3 && bad == 0) }' \
    "$out/beads.lines"
check 'the last line has what others read' grep -qE '^\{"beads": 410, "porosity": 0\.[0-9]+, "spacings_um": \[[0-9., ]+\], "pressure_drops_pa": \[[0-9., ]+\], "richardson_pa": [0-9.]+, "eisfeld_schnitzlein_pa": [0-9.]+, "observed_order": [0-9.nul]+, "core_seconds": [0-9.]+' \
    "$out/beads.lines"
check 'two discs draft and touch' env SCREE="$scree" SCREE_ARGS='--set threads=1' sh "$top_srcdir/examples/tumbling/check" "$out/tumbling"
check 'a flow erodes a bed' env SCREE="$scree" SCREE_ARGS='--set threads=1' sh "$top_srcdir/examples/bed_erosion/check" "$out/bed"
check 'inertia raises the friction of a random packing' env SCREE="$scree" sh "$top_srcdir/examples/ergun/check" "$out/ergun"
finish
