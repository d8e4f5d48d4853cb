#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about many ranks: section.sh RESULTS (lines of run.sh)
# LATENCY (2e-6 s a message), BANDWIDTH (4e8 bytes a second and rank) of the model may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
awk -v latency="${LATENCY:-2e-6}" -v bandwidth="${BANDWIDTH:-4e8}" -f "$here/section.awk" "$1"
