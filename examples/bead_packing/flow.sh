# SPDX-License-Identifier: BSD-3-Clause
# Sourced by run.sh. flow CELLS: the steady flow with CELLS spacings along the column; a line of JSON, also to DIR/flows.jsonl.
# The same velocity over the whole cross-section of the column for any column: 2.771e-5 kg/s in one of 8.8 mm.

flow() {
    core_seconds
    before=$core
    spacing=$(awk -v height="$height" -v n="$1" 'BEGIN { printf "%.15g", height / n }')
    rate=$(awk -v column="$column" 'BEGIN { printf "%.15g", 2.771e-5 * (column / 4.4e-3) ^ 2 }')
    kept=
    if [ -n "${PICTURE:-}" ] && [ ! -s "$out/flows.jsonl" ]; then # of the coarsest spacing, all particles
        kept='--set output.dump.every=1 --set output.dump.fields=[position,velocity,radius,drag]'
    fi
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/flow-$1" --overwrite --quiet \
        --set "particles.sources[0].file=$(cd "$out" && pwd)/packing.txt" --set "walls[0].radius=$column" \
        --set "box.lower=[-$column, -$column, 0]" --set "box.upper=[$column, $column, $height]" \
        --set "fluid.spacing=$spacing" --set "fluid.drive.mass_flow=$rate" $kept ${SCREE_ARGS:-} 2>"$out/flow-$1.notes" || { cat "$out/flow-$1.notes" >&2; exit 1; }
    core_seconds
    awk -F, -v spacing="$spacing" -v before="$before" -v after="$core" -v column="$column" -v height="$height" -v diameter="$(head -n 1 "$out/packing.txt" | awk '{ print 2 * $1 }')" \
        -v report="$out/flow-$1/report.json" -f "$here/flow.awk" "$out/flow-$1/observables.csv" | tee -a "$out/flows.jsonl"
}
