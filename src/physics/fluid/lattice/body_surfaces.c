/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet on bodies. Read body_surfaces.h first. */
#include "physics/fluid/lattice/body_surfaces.h"
#include <math.h>
#include <string.h>

void body_sphere_foot(const double away[3], double radius, int dimension, const double velocity[3],
                      const double *omega, struct weights_foot *foot) {
    double square = 0, none[3] = {0};
    for (int d = 0; d < dimension; d++)
        square += away[d] * away[d];
    double distance = sqrt(square);
    foot->distance = distance - radius;
    for (int d = 0; d < 3; d++)
        foot->normal[d] = d >= dimension ? 0 : distance > 0 ? away[d] / distance : d == 0;
    const double *w = omega ? omega : none, *n = foot->normal;
    for (int d = 0; d < 3; d++)
        foot->velocity[d] =
            velocity[d] + distance * (w[(d + 1) % 3] * n[(d + 2) % 3] - w[(d + 2) % 3] * n[(d + 1) % 3]);
    memcpy(foot->spin, w, sizeof foot->spin);
}
