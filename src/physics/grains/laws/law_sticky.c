/* SPDX-License-Identifier: BSD-3-Clause */
/* Read law_sticky.h first. */
#include "physics/grains/laws/law_sticky.h"
#include "physics/grains/laws/law_jkr.h"
#include <math.h>

struct law_sticky law_sticky_of(enum law_cohesion cohesion, const struct law_coefficients *c,
                                const struct law_extra *extra) {
    struct law_sticky sticky = {.surface_energy = extra->surface_energy,
                                .density = extra->cohesion_density,
                                .hamaker = extra->hamaker,
                                .gap_least = extra->gap_least,
                                .cut_off = extra->cut_off,
                                .k_2 = extra->k_2,
                                .k_c = extra->k_c,
                                .plasticity_depth = extra->plasticity_depth};
    if (cohesion == LAW_COHESION_JKR)
        sticky.length = law_jkr_length(law_modulus(c), extra->surface_energy);
    if (cohesion != LAW_COHESION_CAPILLARY || !(extra->surface_tension > 0.0))
        return sticky;
    double reach = 1.0 + 0.5 * extra->contact_angle;
    sticky.tension = 2.0 * M_PI * extra->surface_tension * cos(extra->contact_angle);
    sticky.volume = extra->bridge_volume;
    if (!(extra->bridge_volume > 0.0))
        sticky.volume_share = extra->bridge_fraction * 4.0 / 3.0 * M_PI;
    sticky.rupture = reach * cbrt(sticky.volume);
    sticky.rupture_share = reach * cbrt(sticky.volume_share);
    return sticky;
}

void law_sticky_widen(struct law_sticky *most, const struct law_sticky *pair) {
    most->length = fmax(most->length, pair->length);
    most->rupture = fmax(most->rupture, pair->rupture);
    most->rupture_share = fmax(most->rupture_share, pair->rupture_share);
    if (pair->hamaker > 0.0)
        most->cut_off = fmax(most->cut_off, pair->cut_off);
    most->hamaker = fmax(most->hamaker, pair->hamaker);
}
