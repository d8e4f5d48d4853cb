# SPDX-License-Identifier: BSD-3-Clause
# The flow between an inlet and an outlet as a line of JSON:
# awk -v spacing= -v height= -v zone= -v given= -v periodic= -v iterations= -v before= -v after= -f open.awk dump.lammpstrj
# The drop is the mean pressure of the layer of particles at the inlet, as it is 0 at the outlet; the flow through a layer is the sum of its velocities.
/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
/^ITEM/ { reading = 0 }
reading && $at["vz"] != 0 {
    layer = int(($at["z"] + zone) / spacing)
    flow[layer] += $at["vz"]
    pressure[layer] += $at["pressure"]
    count[layer]++
}
END {
    last = int((height + 2 * zone) / spacing + 0.5) - 1
    drop = pressure[0] / count[0]
    for (k = 0; k <= last; k++) all += flow[k] / (last + 1)
    printf "{\"open_spacing_um\": %.6g, \"zone_mm\": %.4g, \"open_pressure_drop_pa\": %.5g, \"periodic_pressure_drop_pa\": %.5g, \"open_over_periodic\": %.4f, " \
        "\"out_over_in\": %.5f, \"mean_flow_over_given\": %.4f, \"open_iterations\": %d, \"open_core_seconds\": %.4g}\n",
        spacing * 1e6, zone * 1e3, drop, periodic, drop / periodic, flow[last] / flow[0], all * spacing ^ 2 / given, iterations, after - before
}
