#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the case and compares it with LAMMPS, on the default index alone: run.sh [DIR]. `check` does all layouts.
set -e
here=$(cd "$(dirname "$0")" && pwd)
INDEXES=hgrid NEWTON=on RANKS=1 THREADS=1 "$here/check" "${1:-}"
