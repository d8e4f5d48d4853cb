/* SPDX-License-Identifier: BSD-3-Clause */
/* The number of a particle beside a plane. Read crossing.h first. */
#include "data/observe/crossing.h"

#include <math.h>

/* The periodic direction along which the plane faces, or -1. */
static int periodic_along(const struct box *box, const struct output_plane *plane) {
    for (int d = 0; d < 3; d++)
        if (box->periodic[d] && plane->normal[d] != 0)
            return d;
    return -1;
}

double crossing_number(const struct box *box, const struct output_plane *plane,
                       const struct particles *particles, size_t i) {
    const double *x = particles->state[i].x;
    int periodic = periodic_along(box, plane);
    double before = 0;
    for (int d = 0; d < 3; d++)
        before += plane->normal[d] * (x[d] + box->origin[d] - plane->point[d]);
    if (periodic < 0)
        return before >= 0 ? 1 : 0;
    const int32_t(*image)[3] = (const int32_t(*)[3])particles_images(particles);
    double sign = plane->normal[periodic] > 0 ? 1 : -1,
           edges =
               sign * (x[periodic] + box->origin[periodic] - plane->point[periodic]) / box->edge[periodic];
    return floor(edges + (image ? sign * image[i][periodic] : 0));
}

bool crossing_check(const struct box *box, const struct output_plane *plane, struct error *error) {
    const double *n = plane->normal;
    int periodic = periodic_along(box, plane);
    if (!(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > 0))
        return error_set(error, ERROR_USER, "observables: the normal of plane \"%s\" has no direction",
                         plane->name);
    if (periodic < 0)
        return true;
    bool along = n[(periodic + 1) % 3] == 0 && n[(periodic + 2) % 3] == 0;
    if (along && !box->motion.moves)
        return true;
    return error_set(
        error, ERROR_USER,
        along ? "observables: plane \"%s\" faces along the periodic direction %c of a box that moves: "
                "its images would move, too"
              : "observables: the normal of plane \"%s\" leans along the periodic direction %c; allowed: "
                "along it, or across it",
        plane->name, 'x' + periodic);
}
