/* SPDX-License-Identifier: BSD-3-Clause */
/* Cohesion: the pull between two surfaces, at touch and beyond, by the rows of law_parts.h. All forces derive from a potential, except
 * that a bridge or an adhesive contact forms at touch and breaks farther apart. Any thread. */
#ifndef SCREE_LAWS_LAW_COHESION_H
#define SCREE_LAWS_LAW_COHESION_H

#include "physics/grains/laws/law.h"

/* Two surfaces as cohesion sees them. radius: of both; a wall's is infinite; effective: R*. */
struct law_surfaces {
    const struct law_coefficients *c;
    const struct law_extra *extra;
    double radius[2], effective;
};

/* The attraction of a cohesion of LAW_PULL_TABLE at an overlap (negative: a gap within the range); its energy only with `energy`, as
 * it may cost more than the force. Of other cohesions 0. */
struct law_pull law_cohesion_pull(enum law_cohesion cohesion, const struct law_surfaces *s, double overlap,
                                  bool energy);

/* The largest gap at which two surfaces interact, length: that at which a bridge or an adhesive contact breaks,
 * or an attraction ends. 0 where there is no cohesion, or none beyond touch. */
double law_cohesion_range(const struct law_options *options, const struct law_surfaces *s);

/* Cohesions of LAW_ADHESION_TABLE. True if the surfaces of a pair of materials stick. */
bool law_adhesion_sticks(enum law_cohesion cohesion, const union law_sticky *sticky);

/* The normal direction at the overlap `depth` of spheres with the effective radius `radius`; updates `held`. */
struct law_grip law_adhesion_grip(const struct law_options *options, const union law_sticky *sticky,
                                  const struct law_coefficients *c, double radius, double depth, bool *held);

/* The energy of a contact as it breaks, on the scale of that of law_adhesion_grip. */
double law_adhesion_last(const struct law_options *options, const union law_sticky *sticky,
                         const struct law_coefficients *c, double radius);

#endif
