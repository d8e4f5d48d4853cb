#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Writes docs/pores.md from the results of the examples of flow through pores: pores.sh [DOCUMENTS]
#
# Each example that has a section there has a script EXAMPLE/section.sh, which gets DOCUMENTS/results/pores/EXAMPLE.jsonl and prints the section, from its
# heading of second order on. A further example needs its name below, its script and its results.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
documents=${1:-$here/../docs}
results=$documents/results/pores
{
    cat "$here/pores.head.md"
    for example in bead_packing ergun electroosmosis settling tumbling bed_erosion fluidised_bed fluid_scaling; do
        [ ! -s "$results/$example.jsonl" ] || "$here/$example/section.sh" "$results/$example.jsonl"
    done
} >"$documents/pores.md.new"
mv "$documents/pores.md.new" "$documents/pores.md"
