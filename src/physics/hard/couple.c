/* SPDX-License-Identifier: BSD-3-Clause */
/* Rolling and twisting in the visit of a row. Read resist.h and row.h first. */
#include "physics/hard/models.h"
#include "physics/hard/row.h"
#include <string.h>

enum { SLIDES, ROLLS, TURNS_MOST = 100 };

/* Sliding and rolling of spheres. With s = roll x n both are vectors of the tangent plane on which the spins act alike:
 * of all x[SLIDES] = q and x[ROLLS] = s within their limits those with the least
 *
 *   own[0] |q|^2 / 2 + own[1] |s|^2 / 2 + both q.s + rest[0].q + rest[1].s                                                */
struct plane {
    double own[2], both, most[2];
    double rest[2][3], x[2][3];
};

/* x[k] becomes `to`, cut to its limit; true if it was within. */
static bool cut(struct plane *plane, int k, const double to[3]) {
    double square = vector_dot(to, to), most = plane->most[k];
    bool within = square <= most * most;
    double keep = within ? 1.0 : most / sqrt(square);
    for (int d = 0; d < 3; d++)
        plane->x[k][d] = keep * to[d];
    return within;
}

/* What k wants while the other one stays. */
static bool answer_of(struct plane *plane, int k) {
    double to[3];
    for (int d = 0; d < 3; d++)
        to[d] = -(plane->rest[k][d] + plane->both * plane->x[1 - k][d]) / plane->own[k];
    return cut(plane, k, to);
}

/* What k wants if the other one holds; true if it does. */
static bool other_holds(struct plane *plane, int k) {
    double part = plane->both / plane->own[1 - k], own = plane->own[k] - part * plane->both, to[3];
    for (int d = 0; d < 3; d++)
        to[d] = -(plane->rest[k][d] - part * plane->rest[1 - k][d]) / own;
    cut(plane, k, to);
    return answer_of(plane, 1 - k);
}

/* Both hold, or one, or none: then in turns, which converges as the sum is convex. */
static void plane_solve(struct plane *plane) {
    if (other_holds(plane, SLIDES) || other_holds(plane, ROLLS))
        return;
    for (int turn = 0; turn < TURNS_MOST; turn++) {
        double before[3], change[3];
        memcpy(before, plane->x[ROLLS], sizeof before);
        answer_of(plane, SLIDES);
        answer_of(plane, ROLLS);
        vector_minus(plane->x[ROLLS], before, change);
        if (vector_dot(change, change) <= 1e-30 * vector_dot(before, before))
            return;
    }
}

/* The spin of the second body relative to the first: along the normal, and R times the rest. */
static double spin_of(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                      double rolled[3]) {
    double w[3];
    vector_minus(b->w, a->w, w);
    double along = vector_dot(w, row->normal);
    for (int d = 0; d < 3; d++)
        rolled[d] = row->resist->radius * (w[d] - along * row->normal[d]);
    return along;
}

/* The twisting impulse; `own`: change of R w_n by a unit impulse. */
static double twist_of(const struct hard_resist *resist, double own, double rate, double soft, double p) {
    double most = resist->twist_friction * p, sum = own + soft;
    if (!(most > 0.0) || !(sum > 0.0))
        return 0.0;
    double twist = (own * resist->now.twist - rate + soft * resist->hold.twist) / sum;
    return fabs(twist) > most ? copysign(most, twist) : twist;
}

void hard_resist_wish(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                      const struct hard_softness *soft, struct hard_answer *answer) {
    const struct hard_resist *resist = row->resist;
    double radius = resist->radius, swing = radius * radius * (a->swing + b->swing), u[3], rolled[3], s[3];
    double both = radius * (row->lever[0] * a->swing - row->lever[1] * b->swing),
           slide = hard_slide(row, a, b), pressed = answer->p + row->press;
    double along = spin_of(row, a, b, rolled), hold[3], own[3];
    struct plane plane = {.own = {slide + soft->slide, swing + soft->roll},
                          .both = both,
                          .most = {row->friction * pressed, resist->roll_friction * pressed}};
    hard_velocity(row, a, b, u);
    double u_n = vector_dot(u, row->normal);
    vector_cross(resist->now.roll, row->normal, own);
    vector_cross(resist->hold.roll, row->normal, hold);
    vector_cross(rolled, row->normal, s);
    for (int d = 0; d < 3; d++) {
        plane.rest[SLIDES][d] =
            (u[d] - u_n * row->normal[d]) - slide * row->q[d] - both * own[d] - soft->slide * row->hold[d];
        plane.rest[ROLLS][d] = s[d] - swing * own[d] - both * row->q[d] - soft->roll * hold[d];
    }
    if (plane.own[ROLLS] > 0.0 && plane.most[ROLLS] > 0.0) {
        plane_solve(&plane);
    } else if (plane.most[SLIDES] > 0.0) { /* whatever rolling had is gone */
        answer_of(&plane, SLIDES);
    }
    memcpy(answer->q, plane.x[SLIDES], sizeof answer->q);
    vector_cross(row->normal, plane.x[ROLLS], answer->couple.roll);
    answer->couple.twist = twist_of(resist, swing, radius * along, soft->twist, pressed);
}

/* How a unit impulse along `from` changes the velocity R w along `to`. */
static double turned_by(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                        const double from[3], const double to[3]) {
    double radius = row->resist->radius, spin[3];
    struct hard_body still[2] = {{.swing = a->swing}, {.swing = b->swing}};
    const double moment[3] = {radius * from[0], radius * from[1], radius * from[2]};
    hard_resist_apply(row->arm, &still[0], &still[1], moment);
    vector_minus(still[1].w, still[0].w, spin);
    return radius * vector_dot(spin, to);
}

double hard_resist_roll(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b) {
    double axis[3][3];
    hard_general_axes(row->normal, axis);
    return 0.5 * (turned_by(row, a, b, axis[1], axis[1]) + turned_by(row, a, b, axis[2], axis[2]));
}

void hard_resist_couple(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                        const struct hard_softness *soft, struct hard_answer *answer) {
    const struct hard_resist *resist = row->resist;
    double axis[3][3], rolled[3], w[3], c[2], x[2], pressed = answer->p + row->press,
                                                    most = resist->roll_friction * pressed;
    double along = spin_of(row, a, b, rolled);
    hard_general_axes(row->normal, axis);
    w[0] = turned_by(row, a, b, axis[1], axis[1]);
    w[1] = turned_by(row, a, b, axis[1], axis[2]);
    w[2] = turned_by(row, a, b, axis[2], axis[2]);
    for (int k = 0; k < 2; k++) {
        x[k] = vector_dot(resist->now.roll, axis[1 + k]);
        c[k] = vector_dot(rolled, axis[1 + k]) - soft->roll * vector_dot(resist->hold.roll, axis[1 + k]);
    }
    c[0] -= w[0] * x[0] + w[1] * x[1];
    c[1] -= w[1] * x[0] + w[2] * x[1];
    const double least = 1e-12 * (w[0] + w[2]); /* bodies of two dimensions turn about one axis */
    const double sum[3] = {w[0] + soft->roll + least, w[1], w[2] + soft->roll + least};
    if (most > 0.0 && sum[0] + sum[2] > 0.0)
        hard_relax_disc(sum, c, most, x);
    else
        x[0] = x[1] = 0.0;
    for (int d = 0; d < 3; d++)
        answer->couple.roll[d] = x[0] * axis[1][d] + x[1] * axis[2][d];
    answer->couple.twist = twist_of(resist, turned_by(row, a, b, row->normal, row->normal),
                                    resist->radius * along, soft->twist, pressed);
}
