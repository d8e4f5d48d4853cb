#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about two discs: section.sh RESULTS, the line of run.sh
set -eu
awk 'function of(key,    value) { if (!match($0, "\"" key "\": ")) return ""; value = substr($0, RSTART + RLENGTH); sub(/[,}].*/, "", value); return value }
    { printf "\n## Two discs sink\n\n"
      printf "[examples/tumbling](../examples/tumbling/README.md), `run.sh`: two discs of 2 mm sink one above the other (Feng and Michaelides, J. Comput. Phys. 195 (2004) 602). The upper one drafts in the wake\n"
      printf "of the lower one, up to %.2f times as fast; they touch after %s s, and it has overtaken after %s s.\n\n", of("faster"), of("touch"), of("overtakes")
      printf "![Discs and speed of the fluid at six times](images/tumbling.png)\n" }' "$1"
