/* SPDX-License-Identifier: BSD-3-Clause */
/* Cohesion: the pull between two surfaces, at touch and beyond. All forces derive from a potential, except
 * that a bridge or an adhesive contact forms at touch and breaks farther apart. Formulas and sources in
 * docs/physics.md. Any thread. */
#ifndef SCREE_CONTACT_LAW_COHESION_H
#define SCREE_CONTACT_LAW_COHESION_H

#include "contact/law.h"

/* Two surfaces as cohesion sees them. radius: of both; a wall's is infinite; effective: R*. */
struct law_surfaces {
    const struct law_coefficients *c;
    const struct law_extra *extra;
    double radius[2], effective;
};

/* The attraction of a law other than JKR: force >= 0, d force/d overlap, and energy <= 0 with d energy/d overlap =
 * -force. */
struct law_pull {
    double force, slope, energy;
};

/* The attraction at an overlap (negative: a gap within the range); its energy only with `energy`, as it may cost more than
 * the force. */
struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy);

/* The largest gap at which two surfaces interact, length: that at which a bridge or an adhesive contact breaks,
 * or an attraction ends. 0 where there is no cohesion, or none beyond touch. */
double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s);

/* The largest pull on the surfaces at rest, force: 3/2 pi W R* of JKR, 2 pi W R* of DMT. */
double law_cohesion_largest(enum law_cohesion cohesion, const struct law_surfaces *s);

/* E* of the coefficients of a law with moduli. */
static inline double law_modulus(const struct law_coefficients *c) {
    return 0.75 * c->k_n;
}

#endif
