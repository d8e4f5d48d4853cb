#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about the sphere that settles: section.sh RESULTS, the lines of run.sh
set -eu
awk 'function of(key,    value) { if (!match($0, "\"" key "\": ")) return ""; value = substr($0, RSTART + RLENGTH); sub(/[,}].*/, "", value); return value }
    NR == 1 { printf "\n## A sphere settles\n\n"
      printf "[examples/settling](../examples/settling/README.md), `run.sh`: a sphere of 15 mm settles in four silicone oils, in a box of 100 mm by 100 mm (ten Cate et al., Phys. Fluids 14 (2002) 4012).\n"
      printf "The fluid moves the sphere, and its particles follow the flow.\n\n"
      printf "![Velocity of the sphere in four liquids](images/settling.png)\n\n"
      printf "| Reynolds number | density, kg/m3 | viscosity, Pa s | spacings a diameter | largest velocity, mm/s | measured, mm/s | difference |\n|---|---|---|---|---|---|---|\n" }
    /"liquid":/ { printf "| %s | %s | %s | %s | %s | %s | %+.1f %% |\n", of("reynolds"), of("density"), of("viscosity"), of("spacings_a_diameter"), of("velocity_mm_s"), of("measured_mm_s"), 100 * of("from_measured") }
    END { printf "\nThe boxes are 100 to 150 mm high, that of the experiment 160 mm: high enough for each sphere to reach its velocity before it is near the floor.\n" }' "$1"
