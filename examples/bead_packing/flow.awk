# SPDX-License-Identifier: BSD-3-Clause
# The flow at one spacing as a line of JSON: awk -F, -v spacing= -v report= -v column= -v height= -v diameter= -v before= -v after= -f flow.awk observables.csv
function of_report(key,    line, inside, value) {
    while ((getline line <report) > 0)
        if (value == "" && match(line, "\"" key "\": ")) { value = substr(line, RSTART + RLENGTH); sub(/[,}].*/, "", value) }
    close(report)
    return value + 0
}
NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } }
{ last = $0 }
END {
    split(last, v, ",")
    pi = atan2(0, -1)
    drop = v[at["pressure_drop_z"]]
    # permeability by the velocity over the cross-section of the column, not of the box
    flow = v[at["flow_rate_z"]]
    velocity = flow / (997.561 * pi * column ^ 2)
    box = 4 * column ^ 2 * height
    driving = drop / height * v[at["fluid_porosity"]] * box
    held = v[at["fluid_drag_z"]] + v[at["drag_column_z"]]
    fluid = v[at["fluid_porosity"]] * box / spacing ^ 3
    printf "{\"spacing_um\": %.6g, \"spacings_a_diameter\": %.4g, \"fluid_particles\": %.0f, \"particles\": %.0f, \"pressure_drop_pa\": %.6g, \"flow_kg_s\": %.6g, \"permeability_m2\": %.6g, " \
        "\"porosity_lattice\": %.5f, \"iterations\": %d, \"residual\": %.3g, \"force_balance\": %.6f, \"wall_share\": %.4f, \"speed_max\": %.5g, \"ranks\": %d, " \
        "\"seconds_setup\": %.4g, \"seconds\": %.4g, \"core_seconds\": %.4g, \"memory_bytes\": %.0f, \"bytes_a_fluid_particle\": %.0f}\n",
        spacing * 1e6, diameter / spacing, fluid, of_report("particles"), drop, flow, 8.887e-4 * velocity * height / drop, fluid * spacing ^ 3 / (pi * column ^ 2 * height),
        v[at["fluid_iterations"]], v[at["fluid_residual"]], held / driving, v[at["drag_column_z"]] / held, v[at["fluid_speed"]] / velocity, of_report("ranks"),
        of_report("seconds_setup"), of_report("seconds"), after - before, of_report("memory_peak") * of_report("ranks"),
        of_report("memory_peak") * of_report("ranks") / fluid
}
