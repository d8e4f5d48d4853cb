/* SPDX-License-Identifier: BSD-3-Clause */
/* Numbers of a pair of materials that the formulas of cohesion (law_cohesion.h) and of springs with branches
 * (law_table.h) take, made once. */
#ifndef SCREE_LAWS_LAW_STICKY_H
#define SCREE_LAWS_LAW_STICKY_H

#include "physics/grains/laws/law_parts.h"

struct law_sticky {
    double surface_energy, length; /* of jkr and dmt; of jkr: law_jkr_length */
    double density;                /* of sjkr */
    /* Of a bridge with r = 2 R*: force over r; volume, and volume over r^3; the gap at which it breaks, and that over r. */
    double tension, volume, volume_share, rupture, rupture_share;
    double hamaker, gap_least, cut_off; /* of van_der_waals */
    double k_2, k_c, plasticity_depth;  /* of luding (struct law_extra) */
};

/* The numbers from the coefficients of the law and of the parts. Any thread. */
struct law_sticky law_sticky_of(enum law_cohesion cohesion, const struct law_coefficients *c,
                                const struct law_extra *extra);

/* Raises the numbers of `most` on which a range depends to those of a pair of materials: then no such pair reaches farther,
 * at any radii (law_range). Any thread. */
void law_sticky_widen(struct law_sticky *most, const struct law_sticky *pair);

#endif
