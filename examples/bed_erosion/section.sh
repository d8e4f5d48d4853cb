#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about a bed that a flow erodes: section.sh RESULTS, the lines of run.sh
set -eu
awk 'function of(key,    value) { if (!match($0, "\"" key "\": ")) return ""; value = substr($0, RSTART + RLENGTH); sub(/[,}].*/, "", value); return value }
    NR == 1 { printf "\n## A flow erodes a bed\n\n"
      printf "[examples/bed_erosion](../examples/bed_erosion/README.md), `run.sh`: a force on a liquid drives it over a bed of grains, which it does not resolve: Di Felice'"'"'s law moves them, and the liquid\n"
      printf "loses what they gain. Lengths in diameters, accelerations in g; after %s times sqrt(d/g).\n\n", of("time")
      printf "![Liquid and grains from the side, below and above the Shields number at which grains move](images/bed-erosion.png)\n\n"
      printf "| force on a volume | Shields number | mean velocity of the grains | of the liquid |\n|---|---|---|---|\n" }
    { printf "| %s | %s | %s | %s |\n", of("force"), of("shields"), of("grains"), of("liquid") }' "$1"
