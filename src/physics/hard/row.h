/* SPDX-License-Identifier: BSD-3-Clause */
/* One row of a contact problem: a contact between two bodies, and its visit by Gauss and Seidel. Geometry and
 * mechanics alone: no lists, no threads, no ranks.
 *
 * In a step of length dt the impulse of a contact is p n + q, of which n points from the first body to the second
 * and q lies in the tangent plane; the second body gets it, the first one the opposite. With u the velocity of the
 * second surface relative to the first at the end of the step:
 *
 *   normal      p = max(0, -(u_n + bias) / soft_n)      soft_n = 1 / (stiffness x dt x duration)
 *   tangential  q = hold - u_t / soft_t, cut to |q| <= friction p
 *
 * `bias` is the gap over dt (negative: overlap), so that the normal row is a spring at its length at the end of the
 * step, and a gap may close but not be overshot. soft_n = 0 is a rigid row. `hold` is the tangential impulse of the
 * step before: the tangential row is a spring, too, so that a contact which sticks does not creep.
 * Impulses act over `duration`, which is dt, or half of it in the first evaluation of a run.
 *
 * No operation prefers one of the bodies: with these exchanged and the normal turned round all results are the same to
 * the last bit.
 *
 * Cohesion pulls the surfaces together by an impulse `pull`, which is given: it acts on the bodies before the first visit
 * (hard_problem_pull), so that p stays the impulse of the spring alone, and the contact opens where p is 0. Limits of
 * friction are multiples of p + press.
 *
 * A row with `hertz` > 0 has the elastic force hertz y^(3/2) of the overlap y at the end of the step, and a dashpot;
 * its equation is solved exactly in each visit. */
#ifndef SCREE_HARD_ROW_H
#define SCREE_HARD_ROW_H

#include "physics/hard/resist.h"
#include <stdbool.h>
#include <stdint.h>

/* Above its speed of release the force of a row falls to 0 within this part of the spring's excess of speed. */
#define HARD_RELEASE_PART 0.01

/* Newton's steps for the overlap of a row of Hertz; behind one that changes it by less than this part none changes it. */
enum { HARD_HERTZ_STEPS = 60 };
#define HARD_HERTZ_ENOUGH 1e-8

/* A contact. Lengths, velocities and impulses in the units of the scene. */
struct hard_row {
    uint32_t body[2];
    double normal[3];
    double lever[2];       /* from the centres to the point of contact */
    double gap;            /* between the surfaces at the start of the step; negative: overlap */
    double bias;           /* velocity */
    double soft_n, soft_t; /* velocity over impulse */
    double
        release; /* speed at which an overlap is released at most, but for HARD_RELEASE_PART; INFINITY: any */
    double friction; /* Coulomb's coefficient */
    double hertz;    /* impulse over overlap^(3/2); 0: a linear row */
    double damper;   /* impulse over velocity, of Hertz and overlap^(1/4); of a linear row a part of soft_n */
    double shear;    /* of Hertz: impulse over distance and overlap^(1/2) of its tangential spring */
    double deep;     /* of Hertz: overlap at the last visit */
    double approach; /* speed of approach at the start of the step, free of this step's impulses */
    double restitution;
    double least; /* normal impulse of an impact at least, by Poisson's restitution */
    double pull;  /* impulse of a cohesion, against p */
    double press; /* impulse that limits of friction count beside p */
    bool
        impact; /* a new contact that approaches so fast that it rebounds; the next step begins without its impulses */
    double p, q[3];
    double hold[3];
    const struct hard_arm *arm; /* of a contact that is not one of spheres alone; else NULL */
    struct hard_resist *resist; /* of a contact that resists rolling or twisting; else NULL */
};

/* The impulses that a visit finds; `couple` only of a row that resists. */
struct hard_answer {
    double p, q[3];
    struct hard_couple couple;
};

/* Of a row with an arm (general.c): the mean of W in the tangent plane; the impulses that hard_wish and hard_rebound find. */
double hard_general_slide(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b);
void hard_general_wish(struct hard_row *row, double dt, const struct hard_body *a, const struct hard_body *b,
                       struct hard_answer *answer);
void hard_general_rebound(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                          struct hard_answer *answer);

/* Of a row that resists (couple.c): what the tangential row and the two resistances of spheres want at the normal impulse
 * answer->p; fills the rest of `answer`. */
void hard_resist_wish(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                      const struct hard_softness *soft, struct hard_answer *answer);

/* The same of the resistances of bodies with levers, while the other impulses stay: fills answer->couple. */
void hard_resist_couple(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b,
                        const struct hard_softness *soft, struct hard_answer *answer);

/* The change of the rolling velocity, R w_t, by a unit impulse; of two directions the mean. */
double hard_resist_roll(const struct hard_row *row, const struct hard_body *a, const struct hard_body *b);

/* The normal and two tangents. */
void hard_general_axes(const double normal[3], double axis[3][3]);

/* Change of the relative normal velocity by a unit impulse; the same for a tangential one, of two directions the mean. */
static inline double hard_push(const struct hard_row *row, const struct hard_body *a,
                               const struct hard_body *b) {
    double u[3];
    if (row->arm == NULL)
        return a->lightness + b->lightness;
    hard_arm_change(row->arm, a, b, row->normal, u);
    return vector_dot(u, row->normal);
}
static inline double hard_slide(const struct hard_row *row, const struct hard_body *a,
                                const struct hard_body *b) {
    if (row->arm)
        return hard_general_slide(row, a, b);
    return (a->lightness + b->lightness) +
           (row->lever[0] * row->lever[0] * a->swing + row->lever[1] * row->lever[1] * b->swing);
}

/* The velocity of the second surface relative to the first. */
static inline void hard_velocity(const struct hard_row *row, const struct hard_body *a,
                                 const struct hard_body *b, double u[3]) {
    double turn[3], rolled[3];
    if (row->arm) {
        hard_arm_velocity(row->arm, a, b, u);
        return;
    }
    for (int d = 0; d < 3; d++)
        turn[d] = row->lever[0] * a->w[d] + row->lever[1] * b->w[d];
    vector_cross(turn, row->normal, rolled);
    for (int d = 0; d < 3; d++)
        u[d] = b->v[d] - a->v[d] - rolled[d];
}

/* Adds the impulse p n + q to the bodies. */
static inline void hard_apply(const struct hard_row *row, struct hard_body *a, struct hard_body *b, double p,
                              const double q[3]) {
    double turn[3];
    if (row->arm) {
        const double impulse[3] = {p * row->normal[0] + q[0], p * row->normal[1] + q[1],
                                   p * row->normal[2] + q[2]};
        hard_arm_apply(row->arm, a, b, impulse);
        return;
    }
    vector_cross(row->normal, q, turn);
    for (int d = 0; d < 3; d++) {
        double impulse = p * row->normal[d] + q[d];
        a->v[d] -= a->lightness * impulse;
        b->v[d] += b->lightness * impulse;
        a->w[d] -= row->lever[0] * a->swing * turn[d];
        b->w[d] -= row->lever[1] * b->swing * turn[d];
    }
}

/* What the bodies take along the normal, and whether they take anything at all. */
static inline double hard_net(const struct hard_row *row) {
    return row->p - row->pull;
}
static inline bool hard_acts(const struct hard_row *row) {
    return row->p > 0.0 || row->pull > 0.0;
}

/* The impulse on end e of a row, and its moment about the centre of the body. */
static inline void hard_impulse(const struct hard_row *row, int e, double impulse[6]) {
    double sign = e ? 1.0 : -1.0, turn[3];
    for (int d = 0; d < 3; d++)
        impulse[d] = sign * (hard_net(row) * row->normal[d] + row->q[d]);
    if (row->arm) {
        vector_cross(row->arm->lever[e], impulse, impulse + 3);
    } else {
        vector_cross(row->normal, row->q, turn);
        for (int d = 0; d < 3; d++)
            impulse[3 + d] = -row->lever[e] * turn[d];
    }
    if (row->resist) {
        hard_resist_moment(row->resist, row->normal, &row->resist->now, turn);
        for (int d = 0; d < 3; d++)
            impulse[3 + d] += sign * turn[d];
    }
}

/* The normal impulse of a row of Hertz: the root of y (1 + a c) + a dt k y^(3/2) = -(gap + dt u_free) - a c min(gap, 0),
 * whose left side is convex, by Newton: from the overlap of the last visit, which the first step brings above the root, or from
 * above. The damper has the overlap of the last visit, and acts from touch on: a gap that closes in the step is no overlap
 * that grows. */
static inline double hard_hertz(struct hard_row *row, double dt, double a, double free) {
    double c = row->damper * sqrt(sqrt(row->deep)), linear = 1.0 + a * c;
    double steep = a * dt * row->hertz, before = fmin(row->gap, 0.0);
    double goal = -(row->gap + dt * free) - a * c * before;
    if (!(goal > 0.0)) {
        row->deep = 0.0;
        return 0.0;
    }
    double y = row->deep, change = INFINITY;
    if (!(y > 0.0))
        y = steep > 0.0 ? fmin(goal / linear, cbrt((goal / steep) * (goal / steep))) : goal / linear;
    for (int k = 0; k < HARD_HERTZ_STEPS && fabs(change) > HARD_HERTZ_ENOUGH * y; k++) {
        double root = sqrt(y);
        change = (y * (linear + steep * root) - goal) / (linear + 1.5 * steep * root);
        y -= change;
    }
    row->deep = y;
    return fmax(0.0, row->hertz * y * sqrt(y) + c * (y + before) / dt);
}

/* The softness of Hertz's tangential spring at the overlap of the last visit. */
static inline double hard_shear_soft(const struct hard_row *row) {
    return row->deep > 0.0 && row->shear > 0.0 ? 1.0 / (row->shear * sqrt(row->deep)) : 0.0;
}

static inline struct hard_softness hard_softness_of(const struct hard_row *row, double slide) {
    const struct hard_resist *resist = row->resist;
    return (struct hard_softness){slide, resist->roll_soft < 0.0 ? slide : resist->roll_soft,
                                  resist->twist_soft};
}

/* The impulses that the row wants while those of all others stay: a visit without its effect on the bodies. */
static inline void hard_wish(struct hard_row *row, double dt, const struct hard_body *a,
                             const struct hard_body *b, struct hard_answer *answer) {
    if (row->arm) {
        hard_general_wish(row, dt, a, b, answer);
        return;
    }
    double u[3], push = hard_push(row, a, b), soft_t = row->soft_t, *q = answer->q;
    hard_velocity(row, a, b, u);
    double u_n = vector_dot(u, row->normal), free = u_n - push * row->p;
    q[0] = q[1] = q[2] = 0.0;
    answer->p = 0.0;
    if (!(push > 0.0)) {
        answer->couple = (struct hard_couple){0};
        return;
    }
    if (row->hertz > 0.0) {
        answer->p = hard_hertz(row, dt, push, free);
        soft_t = hard_shear_soft(row);
    } else {
        double spring = -(free + row->bias) / (push + row->soft_n);
        if (free + push * spring > row->release)
            spring = (row->release - HARD_RELEASE_PART * (row->release + row->bias) - free) /
                     (push + HARD_RELEASE_PART * row->soft_n);
        answer->p = fmax(row->least, spring);
    }
    if (row->resist) {
        const struct hard_softness soft = hard_softness_of(row, soft_t);
        hard_resist_wish(row, a, b, &soft, answer);
        return;
    }
    double limit = row->friction * (answer->p + row->press);
    if (!(limit > 0.0))
        return;
    double slide = hard_slide(row, a, b), square = 0.0;
    for (int d = 0; d < 3; d++) {
        q[d] = (slide * row->q[d] - (u[d] - u_n * row->normal[d]) + soft_t * row->hold[d]) / (slide + soft_t);
        square += q[d] * q[d];
    }
    if (square > limit * limit) {
        double keep = limit / sqrt(square);
        for (int d = 0; d < 3; d++)
            q[d] *= keep;
    }
}

/* Gives the bodies the change of the couple. */
static inline void hard_couple_change(const struct hard_row *row, struct hard_body *a, struct hard_body *b,
                                      const struct hard_couple *couple) {
    struct hard_couple *now = &row->resist->now, more = {.twist = couple->twist - now->twist};
    double moment[3];
    vector_minus(couple->roll, now->roll, more.roll);
    hard_resist_moment(row->resist, row->normal, &more, moment);
    hard_resist_apply(row->arm, a, b, moment);
    *now = *couple;
}

/* Gives the bodies the change of the row's impulses. */
static inline void hard_change(struct hard_row *row, struct hard_body *a, struct hard_body *b,
                               const struct hard_answer *answer) {
    const double *q = answer->q;
    double more[3] = {q[0] - row->q[0], q[1] - row->q[1], q[2] - row->q[2]};
    hard_apply(row, a, b, answer->p - row->p, more);
    row->p = answer->p;
    row->q[0] = q[0];
    row->q[1] = q[1];
    row->q[2] = q[2];
    if (row->resist)
        hard_couple_change(row, a, b, &answer->couple);
}

static inline void hard_visit(struct hard_row *row, double dt, struct hard_body *a, struct hard_body *b) {
    struct hard_answer answer;
    hard_wish(row, dt, a, b, &answer);
    hard_change(row, a, b, &answer);
}

/* The overlap at the end of the step of a row that is on its spring. */
static inline double hard_overlap(const struct hard_row *row, double dt) {
    return row->hertz > 0.0 ? row->deep : dt * (row->soft_n * row->p + row->bias) - row->gap;
}

/* Energy in the springs of a row, which act over `duration`, and of its cohesion: normal, tangential. */
static inline void hard_stored(const struct hard_row *row, double dt, double duration, double stored[2]) {
    double share = 0.5 * dt / duration, soft_t = row->soft_t;
    if (row->hertz > 0.0) {
        double root = sqrt(row->deep);
        stored[0] = 0.4 * row->hertz / duration * row->deep * row->deep * root;
        soft_t = hard_shear_soft(row);
    } else if (row->damper > 0.0) { /* of the spring alone, by its overlap at the end of the step */
        double overlap = fmax(0.0, hard_overlap(row, dt));
        stored[0] = 0.5 * (1.0 / row->soft_n - row->damper) / (dt * duration) * overlap * overlap;
    } else {
        stored[0] = share * row->soft_n * row->p * row->p;
    }
    if (row->pull >
        0.0) { /* from touch, in the middle of the step: velocities and work are those of the mean, too */
        double end = row->p > 0.0 ? fmax(0.0, hard_overlap(row, dt)) : 0.0;
        stored[0] -= row->pull / duration * 0.5 * (fmax(0.0, -row->gap) + end);
    }
    stored[1] = share * soft_t * vector_dot(row->q, row->q);
    if (row->resist) {
        const struct hard_softness soft = hard_softness_of(row, soft_t);
        const struct hard_couple *now = &row->resist->now;
        stored[1] +=
            share * (soft.roll * vector_dot(now->roll, now->roll) + soft.twist * now->twist * now->twist);
    }
}

/* True if the row takes part in the pass of restitution. */
static inline bool hard_rebounds(const struct hard_row *row) {
    return row->impact && row->restitution > 0.0 && row->p > 0.0;
}

/* A visit of the pass of restitution: the relative normal velocity becomes restitution x approach; all other rows
 * are rigid. */
static inline void hard_rebound(struct hard_row *row, struct hard_body *a, struct hard_body *b) {
    struct hard_answer answer;
    double u[3], *q = answer.q, square = 0.0, push = hard_push(row, a, b), slide = hard_slide(row, a, b);
    if (!(push > 0.0))
        return;
    if (row->arm) {
        hard_general_rebound(row, a, b, &answer);
        hard_change(row, a, b, &answer);
        return;
    }
    hard_velocity(row, a, b, u);
    double u_n = vector_dot(u, row->normal);
    double p = answer.p = fmax(0.0, row->p + (row->restitution * row->approach - u_n) / push);
    if (row->resist) {
        hard_resist_wish(row, a, b, &(struct hard_softness){0}, &answer);
        hard_change(row, a, b, &answer);
        return;
    }
    for (int d = 0; d < 3; d++) {
        q[d] = row->friction > 0.0 ? row->q[d] - (u[d] - u_n * row->normal[d]) / slide : 0.0;
        square += q[d] * q[d];
    }
    double limit = row->friction * (p + row->press),
           keep = square > limit * limit ? limit / sqrt(square) : 1.0;
    for (int d = 0; d < 3; d++)
        q[d] *= keep;
    hard_change(row, a, b, &answer);
}

#endif
