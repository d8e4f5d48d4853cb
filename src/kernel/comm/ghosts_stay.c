/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that stay on their rank although they have left its subdomain by a little. Read ghosts.h first. */
#include "kernel/comm/copies.h"
#include "kernel/comm/ghosts_parts.h"

#include <math.h>

/* Particles outside of their subdomain lengthen the lists of copies: so far they may be, as a share of the shortest
 * reach. */
static const double OUTSIDE_MOST = 0.25;

/* The bounds of the own subdomain, infinite in wrapped directions. */
static void bounds(const struct ghosts *ghosts, double lower[3], double upper[3]) {
    bool wrapped[3];
    domain_wrap(ghosts->domain, wrapped);
    domain_bounds(ghosts->domain, ghosts->comm->rank, lower, upper);
    for (int d = 0; d < 3; d++) {
        lower[d] = wrapped[d] ? -INFINITY : lower[d];
        upper[d] = wrapped[d] ? INFINITY : upper[d];
    }
}

/* The shortest reach, and the largest distance from a subdomain at which a particle has a copy there. */
static void reaches(const struct ghosts *ghosts, const struct size_classes *classes, double *least,
                    double *most) {
    double reach[CLASS_MAX];
    copies_reach(classes, ghosts->options.reduced, reach);
    *least = INFINITY;
    *most = 0;
    for (int c = 0; c < classes->count; c++) {
        *least = reach[c] >= 0 ? fmin(*least, reach[c]) : *least;
        *most = fmax(*most, classes->radius_max[c] + reach[c]);
    }
}

/* The largest distance of an owned particle from the subdomain. */
static double distance_outside(const struct ghosts *ghosts, const struct particles *particles) {
    double lower[3], upper[3], most = 0;
    bounds(ghosts, lower, upper);
#pragma omp parallel for schedule(static) reduction(max : most)
    for (size_t k = 0; k < particles->owned; k++) {
        const double *x = particles->state[k].x;
        double square = 0;
        for (int d = 0; d < 3; d++) {
            double below = lower[d] - x[d], above = x[d] - upper[d];
            double out = below > above ? below : above;
            square += out > 0 ? out * out : 0;
        }
        most = square > most ? square : most;
    }
    return sqrt(most) * (1 + 1e-12);
}

bool ghosts_let_stay(struct ghosts *ghosts, const struct particles *particles,
                     const struct size_classes *classes, bool wanted) {
    double least, most, outside = INFINITY;
    reaches(ghosts, classes, &least, &most);
    if (wanted && copies_own_reach(particles) == NULL)
        outside = distance_outside(ghosts, particles);
    double worst[2] = {outside, -domain_clearance(ghosts->domain)};
    comm_max(ghosts->comm, worst, 2);
    bool stay = isfinite(worst[0]) && worst[0] <= OUTSIDE_MOST * least && most + 2 * worst[0] < -worst[1];
    ghosts->outside = stay ? worst[0] : 0;
    return stay;
}

void ghosts_around(const struct ghosts *ghosts, const struct size_classes *classes, double low[3],
                   double high[3]) {
    double least, most;
    reaches(ghosts, classes, &least, &most);
    bounds(ghosts, low, high);
    const double depth = (most + ghosts->outside) * (1 + 1e-6);
    for (int d = 0; d < 3; d++) {
        low[d] -= depth;
        high[d] += depth;
    }
}
