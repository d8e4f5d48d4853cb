# SPDX-License-Identifier: BSD-3-Clause
# Sourced by run.sh. open CELLS: the same beads between an inlet and an outlet, with zones of 1 mm without beads before and behind them; a line of JSON,
# also to DIR/open.jsonl. After flow CELLS, with the same spacing and flow.

open() {
    core_seconds
    before=$core
    zone=$(awk -v h="$spacing" 'BEGIN { printf "%.15g", int(1e-3 / h + 0.5) * h }')
    velocity=$(awk -v rate="$rate" -v column="$column" 'BEGIN { printf "%.15g", rate / 997.561 / (atan2(0, -1) * column ^ 2) }')
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/open-$1" --overwrite --quiet \
        --set "particles.sources[0].file=$(cd "$out" && pwd)/packing.txt" --set "walls[0].radius=$column" --set box.periodic=false \
        --set "box.lower=[-$column, -$column, -$zone]" --set "box.upper=[$column, $column, $(calc "$height + $zone")]" \
        --set "fluid.spacing=$spacing" --set 'fluid.drive={}' --set "fluid.open=[{side: z_lower, velocity: [0, 0, $velocity]}, {side: z_upper, pressure: 0}]" \
        --set output.dump.every=1 --set 'output.dump.fields=[position,velocity,pressure]' ${SCREE_ARGS:-} 2>"$out/open-$1.notes" || { cat "$out/open-$1.notes" >&2; exit 1; }
    core_seconds
    awk -v spacing="$spacing" -v height="$height" -v zone="$zone" -v given="$(calc "$rate / 997.561")" -v before="$before" -v after="$core" \
        -v periodic="$("$SCREE" info "$out/flow-$1" --column pressure_drop_z --row last)" -v iterations="$("$SCREE" info "$out/open-$1" --column fluid_iterations --row last)" \
        -f "$here/open.awk" "$out/open-$1/dump.lammpstrj" | tee -a "$out/open.jsonl"
    rm "$out/open-$1/dump.lammpstrj"
}

calc() {
    awk "BEGIN { printf \"%.15g\", $1 }"
}
