#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The hard cases in their quick form.

. "$(dirname "$0")/common.sh"
check 'hard cases' env SCREE="$scree" OMP_NUM_THREADS=1 bash "$top_srcdir/examples/hard/run.sh" --quick
finish
