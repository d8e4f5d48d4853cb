#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about the channel that mixes: section.sh RESULTS, the line that check prints
set -eu
awk 'function of(key,    value) { if (!match($0, "\"" key "\": ")) return ""; value = substr($0, RSTART + RLENGTH); sub(/[,}].*/, "", value); return value }
    { printf "\n## A field mixes two streams\n\n"
      printf "[examples/electroosmosis](../examples/electroosmosis/README.md), `check`: walls 20 um apart whose zeta potential changes its sign every 20 um, and a field along the channel. The ions\n"
      printf "beside the walls drag the water to the left and to the right in turns; the rolls mix a dye. The closed forms are in `fluid-electroosmosis` ([accuracy.md](accuracy.md)).\n\n"
      printf "![Potential with the flow, and the dye](images/fluid-electroosmosis.png)\n\n"
      printf "| largest speed, mm/s | slip by Smoluchowski, mm/s | net flow over the largest speed | dye lost | variance of the dye after 0.2 s | by diffusion alone |\n|---|---|---|---|---|---|\n"
      printf "| %s | %s | %s | %s | %s | %s |\n", of("speed_mm_s"), of("smoluchowski_mm_s"), of("net_flow"), of("dye_lost"), of("variance"), of("variance_by_diffusion")
    }' "$1"
