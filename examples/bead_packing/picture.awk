# SPDX-License-Identifier: BSD-3-Clause
# From the particles of a flow to what is drawn: awk -v out= -v spacing=MICROMETRES -v column=MILLIMETRES -f picture.awk dump.lammpstrj
# Velocities are over the superficial one, U; that is flow over density and cross-section of the column.
/^ITEM: TIMESTEP/ { beads = mean = 0 }
/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
/^ITEM/ { reading = 0 }
!reading || NF < 5 { next }
$at["radius"] > 0.6e-6 * spacing { # a bead
    force[++beads] = $at["dragz"]
    mean += $at["dragz"]
    next
}
$at["vx"] == 0 && $at["vy"] == 0 && $at["vz"] == 0 { next }
{
    n++
    fast = $at["vz"] / 4.5673e-4
    sum += fast
    backwards += fast < 0
    count[int(fast * 10 + 1000) - 1000]++
    y = $at["y"] * 1e6
    if (y > 0 && y < spacing) print 1e3 * $at["x"], 1e3 * $at["z"], sqrt($at["vx"] ^ 2 + $at["vy"] ^ 2 + $at["vz"] ^ 2) / 4.5673e-4 >(out "/section.txt")
}
END {
    for (k = -20; k < 250; k++) if (k in count) print (k + 0.5) / 10, count[k] / n * 10 >(out "/speeds.txt")
    mean /= beads ? beads : 1
    for (i = 1; i <= beads; i++) { f = force[i] / mean; square += (f - 1) ^ 2; bin[int(f * 10)]++ }
    for (k = 0; k < 60; k++) if (k in bin) print (k + 0.5) / 10, bin[k] / beads * 10 >(out "/forces.txt")
    printf "{\"backwards_share\": %.4f, \"pore_velocity_over_superficial\": %.4f, \"force_mean_n\": %.4g, \"force_deviation\": %.4f}\n", backwards / n, sum / n, mean, sqrt(square / beads) \
        >(out "/statistics.json")
}
