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
    of("resolved") != "" && !resolved++ {
      printf "\n`run.sh --resolved`: a bed of discs that the liquid resolves, eight spacings a diameter: a layer that is fixed, one in its hollows, three discs on top. Force and torque of the liquid move the discs; they rest on\n"
      printf "each other below a Shields number, and roll out of their hollows above it; after %s times sqrt(d/g).\n\n", of("time")
      printf "| force on a volume | Shields number | mean velocity of the discs | their mean way | velocity of the liquid |\n|---|---|---|---|---|\n" }
    of("resolved") != "" { printf "| %s | %s | %s | %s | %s |\n", of("force"), of("shields"), of("grains"), of("way"), of("liquid"); next }
    { printf "| %s | %s | %s | %s |\n", of("force"), of("shields"), of("grains"), of("liquid") }' "$1"
