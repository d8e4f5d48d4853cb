/* SPDX-License-Identifier: BSD-3-Clause */
/* The visit of a row with an arm: a contact of a rigid body, or one whose model has no closed form. Read row.h and models.h first. */
#include "physics/hard/models.h"
#include "physics/hard/row.h"
#include <string.h>

enum { HERTZ_STEPS = 20, SCALE_STEPS = 40, COUPLE_STEPS = 40 };

/* Force and couple of a visit are found to this part of the normal impulse: dissipation's search for an angle has no more digits. */
static const double couple_enough = 1e-8;

/* A contact in its own frame. */
struct framed {
    double axis[3][3]; /* normal and two tangents */
    double w[9];       /* change of the relative velocity by an impulse */
    double free[3];    /* relative velocity without the contact's own impulses */
    double p[3];       /* these */
};

void hard_general_axes(const double n[3], double axis[3][3]) {
    int k = fabs(n[0]) < fabs(n[1]) ? 0 : 1;
    if (fabs(n[2]) < fabs(n[k]))
        k = 2;
    double side[3] = {0.0, 0.0, 0.0}, length;
    memcpy(axis[0], n, sizeof axis[0]);
    side[k] = 1.0;
    vector_cross(n, side, axis[1]);
    length = sqrt(vector_dot(axis[1], axis[1]));
    for (int d = 0; d < 3; d++)
        axis[1][d] /= length;
    vector_cross(n, axis[1], axis[2]);
}

static void framed_make(struct framed *f, const struct hard_row *row, const struct hard_body *a,
                        const struct hard_body *b) {
    double u[3];
    hard_general_axes(row->normal, f->axis);
    f->p[0] = row->p;
    f->p[1] = vector_dot(row->q, f->axis[1]);
    f->p[2] = vector_dot(row->q, f->axis[2]);
    for (int k = 0; k < 3; k++) {
        hard_arm_change(row->arm, a, b, f->axis[k], u);
        for (int d = 0; d < 3; d++)
            f->w[3 * d + k] = vector_dot(f->axis[d], u);
    }
    hard_arm_velocity(row->arm, a, b, u);
    for (int d = 0; d < 3; d++)
        f->free[d] = vector_dot(f->axis[d], u) - vector_dot(f->w + 3 * d, f->p);
}

/* The impulse in the tangent plane. */
static void framed_rub(const struct framed *f, double q[3]) {
    for (int d = 0; d < 3; d++)
        q[d] = f->p[1] * f->axis[1][d] + f->p[2] * f->axis[2][d];
}

double hard_general_slide(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b) {
    struct framed f;
    framed_make(&f, row, a, b);
    return 0.5 * (f.w[4] + f.w[8]);
}

/* Linear springs. An overlap is released as hard_wish releases it. */
static void linear(struct framed *f, const struct hard_row *row) {
    struct hard_local local = {.friction = row->friction, .press = row->press};
    memcpy(local.a, f->w, sizeof local.a);
    local.a[0] += row->soft_n;
    local.a[4] += row->soft_t;
    local.a[8] += row->soft_t;
    local.c[0] = f->free[0] + row->bias;
    for (int d = 1; d < 3; d++)
        local.c[d] = f->free[d] - row->soft_t * vector_dot(row->hold, f->axis[d]);
    row->arm->relax(&local, f->p);
    if (f->p[0] > 0.0 && f->free[0] + vector_dot(f->w, f->p) > row->release) {
        local.a[0] = f->w[0] + HARD_RELEASE_PART * row->soft_n;
        local.c[0] = f->free[0] - row->release + HARD_RELEASE_PART * (row->release + row->bias);
        row->arm->relax(&local, f->p);
    }
    if (f->p[0] < row->least) { /* the normal impulse is given: the tangential one follows */
        const double a[3] = {local.a[4], local.a[5], local.a[8]};
        const double c[2] = {local.c[1] + local.a[3] * row->least, local.c[2] + local.a[6] * row->least};
        f->p[0] = row->least;
        hard_relax_disc(a, c, row->friction * row->least, f->p + 1);
    }
}

/* Hertz's normal force and the tangential row, in turns. */
static void hertzian(struct framed *f, struct hard_row *row, double dt) {
    for (int k = 0; k < HERTZ_STEPS; k++) {
        double last[3] = {f->p[0], f->p[1], f->p[2]}, a[3], c[2];
        f->p[0] = hard_hertz(row, dt, f->w[0], f->free[0] + f->w[1] * f->p[1] + f->w[2] * f->p[2]);
        double soft = hard_shear_soft(row);
        a[0] = f->w[4] + soft;
        a[1] = f->w[5];
        a[2] = f->w[8] + soft;
        for (int d = 1; d < 3; d++)
            c[d - 1] = f->free[d] + f->w[3 * d] * f->p[0] - soft * vector_dot(row->hold, f->axis[d]);
        hard_relax_disc(a, c, row->friction * (f->p[0] + row->press), f->p + 1);
        if (fabs(f->p[0] - last[0]) + fabs(f->p[1] - last[1]) + fabs(f->p[2] - last[2]) <=
            1e-14 * (f->p[0] + row->press))
            break;
    }
}

/* The force alone, while the couple stays. */
static void push_and_rub(struct hard_row *row, double dt, const struct hard_body *a,
                         const struct hard_body *b, struct hard_answer *answer) {
    struct framed f;
    framed_make(&f, row, a, b);
    answer->p = answer->q[0] = answer->q[1] = answer->q[2] = 0.0;
    if (!(f.w[0] > 0.0))
        return;
    if (row->hertz > 0.0)
        hertzian(&f, row, dt);
    else
        linear(&f, row);
    answer->p = f.p[0];
    framed_rub(&f, answer->q);
}

/* How much a visit would change the impulses of a row. */
static double change_of(const struct hard_row *row, const struct hard_answer *answer) {
    double sum = fabs(answer->p - row->p) + fabs(answer->couple.twist - row->resist->now.twist);
    for (int d = 0; d < 3; d++)
        sum += fabs(answer->q[d] - row->q[d]) + fabs(answer->couple.roll[d] - row->resist->now.roll[d]);
    return sum;
}

/* Force and couple, in turns. */
void hard_general_wish(struct hard_row *row, double dt, const struct hard_body *a, const struct hard_body *b,
                       struct hard_answer *answer) {
    if (row->resist == NULL) {
        push_and_rub(row, dt, a, b, answer);
        return;
    }
    struct hard_resist resist = *row->resist;
    struct hard_row next = *row;
    struct hard_body end[2] = {*a, *b};
    next.resist = &resist;
    for (int k = 0; k < COUPLE_STEPS; k++) {
        struct hard_answer last = {next.p, {next.q[0], next.q[1], next.q[2]}, resist.now};
        answer->couple = resist.now;
        push_and_rub(&next, dt, &end[0], &end[1], answer);
        hard_change(&next, &end[0], &end[1], answer);
        const struct hard_softness soft =
            hard_softness_of(&next, row->hertz > 0.0 ? hard_shear_soft(&next) : row->soft_t);
        hard_resist_couple(&next, &end[0], &end[1], &soft, answer);
        hard_change(&next, &end[0], &end[1], answer);
        if (change_of(&next, &last) <= couple_enough * (answer->p + row->press))
            break;
    }
    row->deep = next.deep;
}

/* Energy that the impulses of a contact add: they act at the mean of the velocities before the step and behind. Over all contacts
 * these are the change of the energy, so that none of several impacts of one body pays for another. */
static double gain(const struct framed *f, const struct hard_row *row) {
    double sum = 0.0;
    for (int d = 0; d < 3; d++) {
        double before = vector_dot(f->axis[d], row->arm->start);
        sum += 0.5 * f->p[d] * (before + f->free[d] + vector_dot(f->w + 3 * d, f->p));
    }
    return sum;
}

/* The impulses after which the bodies part with this speed. */
static void part(struct framed *f, const struct hard_row *row, double speed) {
    struct hard_local local = {.friction = row->friction, .c = {f->free[0] - speed, f->free[1], f->free[2]}};
    memcpy(local.a, f->w, sizeof local.a);
    row->arm->relax(&local, f->p);
}

/* With friction, bodies that are no spheres might part with more energy than they had: then more slowly, so that an impact
 * gains none. */
void hard_general_rebound(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                          struct hard_answer *answer) {
    struct framed f;
    framed_make(&f, row, a, b);
    double whole = row->restitution * row->approach, low = 0.0, high = 1.0;
    part(&f, row, whole);
    if (gain(&f, row) > 0.0) {
        for (int k = 0; k < SCALE_STEPS; k++) {
            double middle = 0.5 * (low + high);
            part(&f, row, middle * whole);
            if (gain(&f, row) > 0.0)
                high = middle;
            else
                low = middle;
        }
        part(&f, row, low * whole);
    }
    framed_rub(&f, answer->q);
    answer->p = f.p[0];
    if (row->resist)
        hard_resist_couple(row, a, b, &(struct hard_softness){0}, answer);
}
