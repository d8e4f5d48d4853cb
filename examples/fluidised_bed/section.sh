#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about the fluidised bed: section.sh RESULTS, the line that check prints
set -eu
awk 'function of(key,    value) { if (!match($0, "\"" key "\": ")) return ""; value = substr($0, RSTART + RLENGTH); sub(/[,}].*/, "", value); return value }
    { printf "\n## Air makes a bed fluid\n\n"
      printf "[examples/fluidised_bed](../examples/fluidised_bed/README.md), `check`: air rises faster and faster through 2,880 beads of 1 mm. The flow around the beads is not resolved; a drag law\n"
      printf "(Di Felice) stands for it, with the porosity at each bead.\n\n"
      printf "![Pressure drop over the weight of the bed, porosity, and the beads](images/fluidised-bed.png)\n\n"
      printf "| porosity of the packed bed | velocity of least fluidisation, m/s | by Ergun, m/s | difference | drag over weight of the fluid bed |\n|---|---|---|---|---|\n"
      printf "| %s | %s | %s | %+.1f %% | %s |\n", of("porosity"), of("least_velocity"), of("ergun"), 100 * of("error"), of("fluidised_ratio")
    }' "$1"
