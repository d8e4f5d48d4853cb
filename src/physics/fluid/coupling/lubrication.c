/* SPDX-License-Identifier: BSD-3-Clause */
/* Lubrication that a lattice leaves out. Read lubrication.h first. */
#include "physics/fluid/coupling/lubrication.h"
#include "base/vector.h"
#include <math.h>

/* d of the head of lubrication.h, in spacings: near exp (-rate h). Between grains one for all, as two edges meet; at a wall, which is sharp, of squeezing by dimension - 2, and of slip and rolling. */
struct shift {
    double near, rate;
};
static const struct shift of_grains = {0.60, 1.15}, of_squeeze[] = {{0.48, 1.25}, {0.38, 1.35}},
                          of_slip = {0.21, 3.6};

/* Neighbours that all act at once. */
enum { NEIGHBOURS = 12 };

static double shift_of(const struct shift *shift, double spacing, double gap) {
    return spacing * shift->near * exp(-shift->rate * gap / spacing);
}

/* What the whole film has more at a gap than at the gap that the lattice has in its place. */
static struct lubrication_parts between(const struct lubrication *lubrication, double reduced, bool wall,
                                        double gap) {
    const struct shift *squeeze = wall ? &of_squeeze[lubrication->dimension - 2] : &of_grains,
                       *slip = wall ? &of_slip : &of_grains;
    const double mu = M_PI * lubrication->viscosity, far = gap + shift_of(squeeze, lubrication->spacing, gap),
                 wide = gap + shift_of(slip, lubrication->spacing, gap);
    if (lubrication->dimension == 2) {
        double a = reduced / gap, b = reduced / far, more = M_SQRT2 * mu * (sqrt(a) - sqrt(reduced / wide));
        return (struct lubrication_parts){3 * M_SQRT2 * mu * (a * sqrt(a) - b * sqrt(b)), more, more};
    }
    double more = mu * reduced * log(wide / gap);
    return (struct lubrication_parts){6 * mu * reduced * reduced * (1 / gap - 1 / far), 2 * more, 1.2 * more};
}

struct lubrication_parts lubrication_of(const struct lubrication *lubrication, double reduced, bool wall,
                                        double gap) {
    const double reach = LUBRICATION_REACH * lubrication->spacing, near = fmax(gap, lubrication->roughness);
    if (!(near < reach))
        return (struct lubrication_parts){0};
    struct lubrication_parts parts = between(lubrication, reduced, wall, near),
                             end = between(lubrication, reduced, wall, reach);
    parts.squeeze = fmax(parts.squeeze - end.squeeze, 0);
    parts.slip = fmax(parts.slip - end.slip, 0);
    parts.roll = fmax(parts.roll - end.roll, 0);
    return parts;
}

void lubrication_limit(struct lubrication_parts *parts, const struct lubrication_pair *pair, double dt) {
    double push = pair->lightness[0] + pair->lightness[1], slide = push;
    for (int e = 0; e < 2; e++)
        slide += pair->swing[e] > 0 ? pair->lever[e] * pair->lever[e] * pair->swing[e] : 0;
    double share = 2.0 / (NEIGHBOURS * dt);
    if (push > 0)
        parts->squeeze = fmin(parts->squeeze, share / push);
    if (slide > 0) { /* each surface takes part in slip and in rolling */
        parts->slip = fmin(parts->slip, 0.5 * share / slide);
        parts->roll = fmin(parts->roll, 0.5 * share / slide);
    }
}

/* out = lever spin x normal: the velocity that a spin gives the surface of the first at the gap; of the second it is the opposite. */
static void turning(const struct lubrication_pair *pair, int e, double out[3]) {
    vector_cross(pair->spin[e], pair->normal, out);
    for (int d = 0; d < 3; d++)
        out[d] *= pair->lever[e];
}

void lubrication_force(const struct lubrication_parts *parts, const struct lubrication_pair *pair,
                       double force[6]) {
    const double *n = pair->normal;
    const int wall = isinf(pair->lever[1]);
    const double ratio = wall ? -1 : (pair->lever[0] - pair->lever[1]) / (pair->lever[0] + pair->lever[1]);
    double u[3], first[3], second[3] = {0}, slip[3], roll[3], drag[3], along;
    vector_minus(pair->velocity[1], pair->velocity[0], u);
    along = vector_dot(u, n);
    turning(pair, 0, first);
    if (!wall)
        turning(pair, 1, second);
    for (int d = 0; d < 3; d++) {
        double tangential = u[d] - along * n[d];
        slip[d] = parts->slip * (tangential - first[d] - second[d]);
        roll[d] = parts->roll * (first[d] - second[d] - ratio * tangential);
        force[d] = parts->squeeze * along * n[d] + slip[d] - ratio * roll[d];
        drag[d] = pair->lever[0] * (slip[d] - roll[d]);
    }
    vector_cross(n, drag, force + 3);
}
