/* SPDX-License-Identifier: BSD-3-Clause */
/* The number density of smoothed particle hydrodynamics, n_i = sum over j, i included, of W(|x_i - x_j|), with
 * Wendland's C2 kernel and one support h (Dehnen and Aly, MNRAS 425 (2012) 1068, table 1): for r < h
 *   W(r) = w (1 - r/h)^4 (1 + 4 r/h),  w = 21 / (2 pi h^3), in two dimensions 7 / (pi h^2) */
#ifndef SCREE_DENSITY_DENSITY_H
#define SCREE_DENSITY_DENSITY_H

struct density_options { /* the section `number_density` of a scene */
    double support;      /* h, length */
};
#endif
