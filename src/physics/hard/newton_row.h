/* SPDX-License-Identifier: BSD-3-Clause */
/* A row of a contact problem as Newton's method sees it: impulses as a function of the velocity at the contact, and
 * minus the derivative of that function. Geometry and mechanics alone: no lists, no threads, no ranks.
 *
 * With y = hold - u_t / soft_t, t its direction, and p the normal impulse (and `press` of a cohesion, in the limit):
 *
 *   stick  |y| <= friction p   q = y               derivative (1 - n n) / soft_t
 *   slide                      q = friction p t    derivative (1 - n n - t t) friction p / (soft_t |y|) + friction t dp/du
 *
 * The tangential spring of Hertz's law has the overlap of the last visit. A rigid tangential row is a soft one about its impulse. */
#ifndef SCREE_HARD_NEWTON_ROW_H
#define SCREE_HARD_NEWTON_ROW_H

#include "physics/hard/row.h"

struct hard_newton_row {
    double kept[5]; /* impulses and overlap of the least residual so far: p, q, deep */
    double lead[3]; /* impulse after a step that changes no velocity */
    /* Derivative: push n n + grip (1 - n n) - slip t t + couple t n, with t = along. */
    double push, grip, slip, couple, along[3];
};

/* Softness of a rigid tangential row over its inverse mass. */
#define HARD_STICK_SOFT 1e-3

/* The normal impulse at the normal velocity u, and minus its derivative. */
static inline double hard_newton_push(const struct hard_row *row, double dt, double u, double *slope) {
    *slope = 0.0;
    if (row->hertz > 0.0) {
        double y = -(row->gap + dt * u);
        if (!(y > 0.0))
            return 0.0;
        double root = sqrt(y), damper = row->damper * sqrt(root), closed = y + fmin(row->gap, 0.0);
        double p = row->hertz * y * root + damper * closed / dt;
        if (!(p > 0.0))
            return 0.0;
        *slope = 1.5 * row->hertz * dt * root + damper * (1.0 + fmax(0.0, 0.25 * closed / y));
        return p;
    }
    double p = -(u + row->bias) / row->soft_n, soft = row->soft_n;
    if (u > row->release) {
        soft *= HARD_RELEASE_PART;
        p = -(row->release + row->bias) / row->soft_n - (u - row->release) / soft;
    }
    if (!(p > 0.0))
        return 0.0;
    *slope = 1.0 / soft;
    return p;
}

/* The tangential spring: its softness, and the impulse at rest. */
static inline double hard_newton_spring(const struct hard_row *row, double slide, const double **hold) {
    double soft = row->soft_t;
    if (row->hertz > 0.0)
        soft = hard_shear_soft(row);
    *hold = soft > 0.0 ? row->hold : row->q;
    return soft > 0.0 ? soft : HARD_STICK_SOFT * slide;
}

/* The impulses p and q at the velocity u, and the derivative there. `row` has the impulse and the overlap of a visit; `slide` is
 * hard_slide's. */
static inline void hard_newton_at(const struct hard_row *row, struct hard_newton_row *newton, double dt,
                                  double slide, const double u[3], double *p, double q[3]) {
    const double *hold;
    double soft = hard_newton_spring(row, slide, &hold), along = vector_dot(u, row->normal), square = 0.0;
    *p = hard_newton_push(row, dt, along, &newton->push);
    double bound = row->friction * (*p + row->press);
    newton->grip = newton->slip = newton->couple = 0.0;
    for (int d = 0; d < 3; d++) {
        newton->along[d] = q[d] = 0.0;
        if (bound > 0.0)
            q[d] = hold[d] - (u[d] - along * row->normal[d]) / soft;
        square += q[d] * q[d];
    }
    if (!(bound > 0.0))
        return;
    double length = sqrt(square);
    newton->grip = 1.0 / soft;
    if (!(length > bound))
        return;
    newton->grip *= bound / length;
    newton->slip = newton->grip;
    newton->couple = row->friction * newton->push;
    for (int d = 0; d < 3; d++) {
        newton->along[d] = q[d] / length;
        q[d] = bound * newton->along[d];
    }
}

/* The derivative times a change of velocity. */
static inline void hard_newton_answer(const struct hard_row *row, const struct hard_newton_row *newton,
                                      const double du[3], double out[3]) {
    double n = (newton->push - newton->grip) * vector_dot(row->normal, du);
    double t = newton->slip * vector_dot(newton->along, du);
    t -= newton->couple * vector_dot(row->normal, du);
    for (int d = 0; d < 3; d++)
        out[d] = n * row->normal[d] + newton->grip * du[d] - t * newton->along[d];
}

/* How the velocity at a contact changes by the impulse p n + q. */
static inline void hard_change_of(const struct hard_row *row, const struct hard_body *a,
                                  const struct hard_body *b, double p, const double q[3], double change[3]) {
    double impulse[3], push, slide;
    for (int d = 0; d < 3; d++)
        impulse[d] = p * row->normal[d] + q[d];
    if (row->arm) {
        hard_arm_change(row->arm, a, b, impulse, change);
        return;
    }
    push = hard_push(row, a, b);
    slide = hard_slide(row, a, b);
    for (int d = 0; d < 3; d++)
        change[d] = push * p * row->normal[d] + slide * q[d];
}

/* Takes the derivative where a visit of the row would leave it. A stiff row whose impulse is a little wrong is far from its function;
 * the impulse and the velocity that a visit would give are on it. */
static inline void hard_newton_plan(struct hard_row *row, struct hard_newton_row *newton, double dt,
                                    const struct hard_body *a, const struct hard_body *b) {
    double u[3], p, q[3], more[3], change[3], back[3], slide = hard_slide(row, a, b);
    struct hard_answer answer;
    hard_velocity(row, a, b, u);
    hard_wish(row, dt, a, b, &answer);
    struct hard_row next = *row;
    next.p = answer.p;
    for (int d = 0; d < 3; d++) {
        next.q[d] = answer.q[d];
        more[d] = answer.q[d] - row->q[d];
    }
    hard_change_of(row, a, b, answer.p - row->p, more, change);
    for (int d = 0; d < 3; d++)
        u[d] += change[d];
    hard_newton_at(&next, newton, dt, slide, u, &p, q);
    hard_newton_answer(row, newton, change, back);
    for (int d = 0; d < 3; d++)
        newton->lead[d] = next.p * row->normal[d] + next.q[d] + back[d];
}

#endif
