/* SPDX-License-Identifier: BSD-3-Clause */
/* The mechanics of one bond. Read bond.h first. */
#include "physics/bonds/bond.h"
#include <math.h>
#include <string.h>

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

static struct law_vector vector_of(const double *v) {
    return (struct law_vector){v[0], v[1], v[2]};
}

static void vector_put(double *to, struct law_vector v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

/* The unit vector along `a`; where a is 0, `otherwise`. */
static struct law_vector unit(struct law_vector a, struct law_vector otherwise) {
    double length = sqrt(law_dot(a, a));
    return length > 0.0 ? law_scale(1.0 / length, a) : otherwise;
}

/* Half of the turn of a bond in a step. */
struct turn {
    double cosine, sine; /* of half the angle about the line of centres */
};

/* The angle by a rational form, which is a rotation to rounding, and the angle up to its third power. */
static struct turn turn_of(double half) {
    double q = 0.5 * half, over = 1.0 / (1.0 + q * q);
    return (struct turn){(1.0 - q * q) * over, 2.0 * q * over};
}

/* Turns a vector across the line `from` with the line to `to`, then about it. */
static struct law_vector turned(struct law_vector a, struct law_vector from, struct law_vector to,
                                struct turn turn) {
    struct law_vector b = law_transport(a, from, to);
    return law_add(law_scale(turn.cosine, b), turn.sine, law_cross(to, b));
}

/* Moves shear force, bending and twisting moment over the step: half the turn, the increments, half the turn. */
static void increments(const struct bond_section *s, const struct bond_motion *m, struct law_vector old,
                       struct law_vector now, struct history_row *row) {
    struct law_vector before = vector_of(row->separation),
                      middle = unit(law_add(before, 1.0, m->separation), now);
    struct law_vector mean = law_add(m->spin[0], 1.0, m->spin[1]);
    struct law_vector force = vector_of(row->value + BOND_SHEAR),
                      moment = vector_of(row->value + BOND_MOMENT);
    struct turn turn = turn_of(0.25 * m->dt * law_dot(mean, middle));
    double twist = law_dot(moment, old);
    moment = law_add(moment, -twist, old);
    struct law_vector roll = law_add(law_scale(m->lever[0], m->spin[0]), m->lever[1], m->spin[1]);
    struct law_vector moved = law_add(m->separation, -1.0, before);
    struct law_vector slip = law_add(law_project(moved, middle), -m->dt, law_cross(roll, middle));
    struct law_vector spin = law_add(m->spin[1], -1.0, m->spin[0]);
    double about = law_dot(spin, middle);
    force = law_add(turned(force, old, middle, turn), -s->slide, slip);
    moment = law_add(turned(moment, old, middle, turn), -s->bend * m->dt, law_add(spin, -about, middle));
    twist -= s->twist * m->dt * about;
    force = turned(force, middle, now, turn);
    moment = law_add(turned(moment, middle, now, turn), twist, now);
    vector_put(row->value + BOND_SHEAR, force);
    vector_put(row->value + BOND_MOMENT, moment);
}

/* The velocity of the higher end against the lower one at the middle of the bond. */
static struct law_vector slip_rate(const struct bond_motion *m, struct law_vector normal) {
    struct law_vector roll = law_add(law_scale(m->lever[0], m->spin[0]), m->lever[1], m->spin[1]);
    return law_add(m->velocity, -1.0, law_cross(roll, normal));
}

/* Adds the dampers. */
static void dampers(const struct bond_section *s, const struct bond_motion *m, struct bond_response *out) {
    struct law_vector n = out->normal, v = slip_rate(m, n);
    struct law_vector w = law_add(m->spin[1], -1.0, m->spin[0]);
    double apart = law_dot(v, n), about = law_dot(w, n);
    struct law_vector slip = law_add(v, -apart, n), bend = law_add(w, -about, n);
    struct law_vector force = law_add(law_scale(-s->c_slide, slip), -s->c_stretch * apart, n);
    struct law_vector moment = law_add(law_scale(-s->c_bend, bend), -s->c_twist * about, n);
    out->taken = -m->dt * (law_dot(force, v) + law_dot(moment, w));
    out->force = law_add(out->force, 1.0, force);
    out->moment = law_add(out->moment, 1.0, moment);
}

static double energy_of(const struct bond_section *s, double stretched, struct law_vector force, double twist,
                        double bend2) {
    return 0.5 * (s->stretch * stretched * stretched + law_dot(force, force) / s->slide +
                  twist * twist / s->twist + bend2 / s->bend);
}

double bond_energy(const struct bond_section *s, const struct history_row *row) {
    struct law_vector d = vector_of(row->separation), moment = vector_of(row->value + BOND_MOMENT);
    double length = sqrt(law_dot(d, d)), twist = length > 0.0 ? law_dot(moment, d) / length : 0.0;
    return energy_of(s, length - row->value[BOND_REST], vector_of(row->value + BOND_SHEAR), twist,
                     fmax(law_dot(moment, moment) - twist * twist, 0.0));
}

void bond_advance(const struct bond_section *s, const struct bond_motion *m, struct history_row *row,
                  struct bond_response *out) {
    const struct law_vector x = {1.0, 0.0, 0.0};
    struct law_vector old = unit(vector_of(row->separation), x);
    double length = sqrt(law_dot(m->separation, m->separation)), stretched = length - row->value[BOND_REST];
    *out = (struct bond_response){.normal = unit(m->separation, old)};
    if (m->dt > 0.0)
        increments(s, m, old, out->normal, row);
    vector_put(row->separation, m->separation);
    struct law_vector force = vector_of(row->value + BOND_SHEAR),
                      moment = vector_of(row->value + BOND_MOMENT);
    double twist = law_dot(moment, out->normal);
    double bend2 = fmax(law_dot(moment, moment) - twist * twist, 0.0);
    out->stored = energy_of(s, stretched, force, twist, bend2);
    out->tensile = s->stretch * stretched / s->area + sqrt(bend2) * s->bend_over;
    out->shear = sqrt(law_dot(force, force)) / s->area + fabs(twist) * s->twist_over;
    out->force = law_add(force, -s->stretch * stretched, out->normal);
    out->moment = moment;
    if (out->tensile >= s->tensile || out->shear >= s->shear) {
        out->end = out->tensile * s->shear >= out->shear * s->tensile ? BOND_TENSION : BOND_SHEARED;
        out->stored += 0.5 * m->dt *
                       (law_dot(out->force, slip_rate(m, out->normal)) +
                        law_dot(moment, law_add(m->spin[1], -1.0, m->spin[0])));
        return;
    }
    dampers(s, m, out);
}
