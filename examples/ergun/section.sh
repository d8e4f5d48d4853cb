#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about inertia: section.sh RESULTS (lines of run.sh)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
awk -f "$here/section.awk" "$1"
