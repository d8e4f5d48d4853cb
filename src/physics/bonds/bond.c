/* SPDX-License-Identifier: BSD-3-Clause */
/* The mechanics of one bond. Read bond.h first. */
#include "physics/bonds/bond.h"
#include "base/clones.h"
#include <math.h>
#include <stddef.h>

enum { BOND_LANES = 8 };

struct bond_section bond_section_of(const struct bond_numbers *n) {
    double r = n->radius, area = M_PI * r * r, bending = 0.25 * area * r * r, polar = 2.0 * bending;
    struct bond_section s = {.radius = r,
                             .area = area,
                             .stretch = n->k_n * area,
                             .slide = n->k_s * area,
                             .bend = n->k_n * bending,
                             .twist = n->k_s * polar,
                             .tensile = n->tensile,
                             .shear = n->shear,
                             .bend_over = r / bending,
                             .twist_over = r / polar};
    s.c_stretch = 2.0 * n->damping * sqrt(n->mass * s.stretch);
    s.c_slide = 2.0 * n->damping * sqrt(n->mass * s.slide);
    s.c_bend = 2.0 * n->damping * sqrt(n->inertia * s.bend);
    s.c_twist = 2.0 * n->damping * sqrt(n->inertia * s.twist);
    return s;
}

LAW_INLINE struct law_vector vector_of(const double *v) {
    return (struct law_vector){v[0], v[1], v[2]};
}

/* What moves with a bond. */
struct moving {
    struct law_vector before, force, moment; /* separation a step ago; shear force and moment */
};

/* The unit vector along `a`; where a is 0, `otherwise`. */
LAW_INLINE struct law_vector unit(struct law_vector a, struct law_vector otherwise) {
    double length = sqrt(law_dot(a, a));
    bool some = length > 0.0;
    struct law_vector n = law_scale(1.0 / (some ? length : 1.0), a);
    return (struct law_vector){some ? n.x : otherwise.x, some ? n.y : otherwise.y, some ? n.z : otherwise.z};
}

/* Half of the turn of a bond in a step. */
struct turn {
    double cosine, sine; /* of half the angle about the line of centres */
};

/* The angle by a rational form, which is a rotation to rounding, and the angle up to its third power. */
LAW_INLINE struct turn turn_of(double half) {
    double q = 0.5 * half, over = 1.0 / (1.0 + q * q);
    return (struct turn){(1.0 - q * q) * over, 2.0 * q * over};
}

/* Turns a vector across the line `from` with the line to `to`, then about it. */
LAW_INLINE struct law_vector turned(struct law_vector a, struct law_vector from, struct law_vector to,
                                    struct turn turn) {
    struct law_vector b = law_transport(a, from, to);
    return law_add(law_scale(turn.cosine, b), turn.sine, law_cross(to, b));
}

/* Moves shear force, bending and twisting moment over the step: half the turn, the increments, half the turn. */
LAW_INLINE void increments(const struct bond_section *s, const struct bond_motion *m, double dt,
                           struct law_vector old, struct law_vector now, struct moving *moving) {
    struct law_vector before = moving->before, middle = unit(law_add(before, 1.0, m->separation), now);
    struct law_vector mean = law_add(m->spin[0], 1.0, m->spin[1]);
    struct law_vector force = moving->force, moment = moving->moment;
    struct turn turn = turn_of(0.25 * dt * law_dot(mean, middle));
    double twist = law_dot(moment, old);
    moment = law_add(moment, -twist, old);
    struct law_vector roll = law_add(law_scale(m->lever[0], m->spin[0]), m->lever[1], m->spin[1]);
    struct law_vector moved = law_add(m->separation, -1.0, before);
    struct law_vector slip = law_add(law_project(moved, middle), -dt, law_cross(roll, middle));
    struct law_vector spin = law_add(m->spin[1], -1.0, m->spin[0]);
    double about = law_dot(spin, middle);
    force = law_add(turned(force, old, middle, turn), -s->slide, slip);
    moment = law_add(turned(moment, old, middle, turn), -s->bend * dt, law_add(spin, -about, middle));
    twist -= s->twist * dt * about;
    moving->force = turned(force, middle, now, turn);
    moving->moment = law_add(turned(moment, middle, now, turn), twist, now);
}

/* The velocity of the higher end against the lower one at the middle of the bond. */
LAW_INLINE struct law_vector slip_rate(const struct bond_motion *m, struct law_vector normal) {
    struct law_vector roll = law_add(law_scale(m->lever[0], m->spin[0]), m->lever[1], m->spin[1]);
    return law_add(m->velocity, -1.0, law_cross(roll, normal));
}

/* Force, moment and work of the dampers, added to those of the springs. */
LAW_INLINE void dampers(const struct bond_section *s, const struct bond_motion *m, double dt,
                        struct bond_response *out) {
    struct law_vector n = out->normal, v = slip_rate(m, n);
    struct law_vector w = law_add(m->spin[1], -1.0, m->spin[0]);
    double apart = law_dot(v, n), about = law_dot(w, n);
    struct law_vector slip = law_add(v, -apart, n), bend = law_add(w, -about, n);
    struct law_vector force = law_add(law_scale(-s->c_slide, slip), -s->c_stretch * apart, n);
    struct law_vector moment = law_add(law_scale(-s->c_bend, bend), -s->c_twist * about, n);
    out->taken = -dt * (law_dot(force, v) + law_dot(moment, w));
    out->force = law_add(out->force, 1.0, force);
    out->moment = law_add(out->moment, 1.0, moment);
}

LAW_INLINE double energy_of(const struct bond_section *s, double stretched, struct law_vector force,
                            double twist, double bend2) {
    return 0.5 * (s->stretch * stretched * stretched + law_dot(force, force) / s->slide +
                  twist * twist / s->twist + bend2 / s->bend);
}

double bond_energy(const struct bond_section *s, const struct history_row *row) {
    struct law_vector d = vector_of(row->separation), moment = vector_of(row->value + BOND_MOMENT);
    double length = sqrt(law_dot(d, d)), twist = length > 0.0 ? law_dot(moment, d) / length : 0.0;
    return energy_of(s, length - row->value[BOND_REST], vector_of(row->value + BOND_SHEAR), twist,
                     law_most(law_dot(moment, moment) - twist * twist, 0.0));
}

/* The answer of a bond whose force and moment have moved. Returns the end. */
LAW_INLINE enum bond_end respond(const struct bond_section *s, const struct bond_motion *m, double dt,
                                 double rest, const struct moving *moving, struct bond_response *out) {
    struct law_vector force = moving->force, moment = moving->moment;
    double stretched = sqrt(law_dot(m->separation, m->separation)) - rest;
    double twist = law_dot(moment, out->normal);
    double bend2 = law_most(law_dot(moment, moment) - twist * twist, 0.0);
    out->tensile = s->stretch * stretched / s->area + sqrt(bend2) * s->bend_over;
    out->shear = sqrt(law_dot(force, force)) / s->area + fabs(twist) * s->twist_over;
    out->force = law_add(force, -s->stretch * stretched, out->normal);
    out->moment = moment;
    bool breaks = (out->tensile >= s->tensile) | (out->shear >= s->shear);
    double lost = 0.5 * dt *
                  (law_dot(out->force, slip_rate(m, out->normal)) +
                   law_dot(moment, law_add(m->spin[1], -1.0, m->spin[0])));
    out->stored = energy_of(s, stretched, force, twist, bend2) + (breaks ? lost : 0.0);
    dampers(s, m, dt, out);
    enum bond_end end = out->tensile * s->shear >= out->shear * s->tensile ? BOND_TENSION : BOND_SHEARED;
    return breaks ? end : BOND_WHOLE;
}

LAW_INLINE struct law_vector lane(const double (*column)[BOND_BATCH], int k) {
    return (struct law_vector){column[0][k], column[1][k], column[2][k]};
}

LAW_INLINE void lane_put(double (*column)[BOND_BATCH], int k, struct law_vector v) {
    column[0][k] = v.x;
    column[1][k] = v.y;
    column[2][k] = v.z;
}

/* Bond k. `moves`: the step is longer than 0. */
LAW_INLINE void advance_one(struct bond_batch *restrict b, int k, double dt, bool moves) {
#define TAKE(member) .member = b->section[offsetof(struct bond_section, member) / sizeof(double)][k],
    const struct bond_section s = {BOND_SECTION_TABLE(TAKE)};
#undef TAKE
    const struct bond_motion m = {lane(b->motion, k),
                                  lane(b->motion + 3, k),
                                  {lane(b->motion + 6, k), lane(b->motion + 9, k)},
                                  {b->motion[12][k], b->motion[13][k]}};
    struct moving moving = {lane(b->before, k), lane(b->value + BOND_SHEAR, k),
                            lane(b->value + BOND_MOMENT, k)};
    struct law_vector old = unit(moving.before, (struct law_vector){1.0, 0.0, 0.0});
    struct bond_response out = {.normal = unit(m.separation, old)};
    if (moves)
        increments(&s, &m, dt, old, out.normal, &moving);
    enum bond_end end = respond(&s, &m, dt, b->value[BOND_REST][k], &moving, &out);
    lane_put(b->before, k, m.separation);
    lane_put(b->value + BOND_SHEAR, k, moving.force);
    lane_put(b->value + BOND_MOMENT, k, moving.moment);
    lane_put(b->out + BOND_OUT_FORCE, k, out.force);
    lane_put(b->out + BOND_OUT_MOMENT, k, out.moment);
    lane_put(b->out + BOND_OUT_NORMAL, k, out.normal);
    b->out[BOND_OUT_STORED][k] = out.stored;
    b->out[BOND_OUT_TAKEN][k] = out.taken;
    b->out[BOND_OUT_TENSILE][k] = out.tensile;
    b->out[BOND_OUT_SHEAR][k] = out.shear;
    b->out[BOND_OUT_END][k] = (double)end;
}

SCREE_CLONES static void advance_all(struct bond_batch *restrict b, double dt) {
    const int count =
        (b->count + BOND_LANES - 1) / BOND_LANES * BOND_LANES; /* entries behind the last are not read */
#pragma omp simd
    for (int k = 0; k < count; k++)
        advance_one(b, k, dt, true);
}

void bond_batch_advance(struct bond_batch *b, double dt) {
    if (dt > 0.0)
        advance_all(b, dt);
    for (int k = 0; k < b->count && !(dt > 0.0); k++)
        advance_one(b, k, dt, false);
}

void bond_batch_add(struct bond_batch *b, const struct bond_section *section,
                    const struct bond_motion *motion, const struct history_row *row) {
    int k = b->count++;
    const double *numbers = (const double *)section, *moves = (const double *)motion;
    for (int n = 0; n < BOND_SECTIONS; n++)
        b->section[n][k] = numbers[n];
    for (int n = 0; n < BOND_MOTIONS; n++)
        b->motion[n][k] = moves[n];
    for (int d = 0; d < 3; d++)
        b->before[d][k] = row->separation[d];
    for (int n = 0; n < BOND_ENTRY; n++)
        b->value[n][k] = row->value[n];
}

void bond_batch_take(const struct bond_batch *b, int k, struct history_row *row, struct bond_response *out) {
    for (int d = 0; d < 3; d++)
        row->separation[d] = b->before[d][k];
    for (int n = 0; n < BOND_ENTRY; n++)
        row->value[n] = b->value[n][k];
    *out = (struct bond_response){.force = lane(b->out + BOND_OUT_FORCE, k),
                                  .moment = lane(b->out + BOND_OUT_MOMENT, k),
                                  .normal = lane(b->out + BOND_OUT_NORMAL, k),
                                  .stored = b->out[BOND_OUT_STORED][k],
                                  .taken = b->out[BOND_OUT_TAKEN][k],
                                  .tensile = b->out[BOND_OUT_TENSILE][k],
                                  .shear = b->out[BOND_OUT_SHEAR][k],
                                  .end = (enum bond_end)b->out[BOND_OUT_END][k]};
}
