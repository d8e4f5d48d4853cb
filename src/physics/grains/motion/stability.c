/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects the stiffness of contacts and finds the largest eigenvalue. Read stability.h first. */
#include "physics/grains/motion/stability.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/eigen3.h"
#include "base/memory.h"
#include "physics/grains/motion/timestep.h"
#include "physics/grains/walls/walls_free.h"
#include <math.h>

void stability_create(struct stability *s, const struct force_context *context, double step) {
    size_t count = context->particles->owned + context->particles->ghosts;
    *s = (struct stability){.step = step,
                            .count = count,
                            .sums = spin_values(context->particles) ? STABILITY_SUMS : STABILITY_PUSH};
    s->sum = memory_allocate_zero(count * (size_t)s->sums, sizeof *s->sum, "stability of contacts");
    s->local = memory_allocate_zero(count, sizeof *s->local, "stability of contacts");
}

void stability_free(struct stability *s) {
    memory_free(s->sum);
    memory_free(s->local);
    memory_free(s->wall);
    *s = (struct stability){0};
}

/* To a multiple of 2^-30: sums of such numbers are exact, in any order, up to 2^22. Next to 1.5 x 2^22 doubles
 * lie 2^-30 apart. */
static double rounded(double x) {
    const double middle = 6291456.0;
    return x + middle - middle;
}

/* Springs and dampers at step h. */
static void stiffen(const struct stability *s, const struct timestep_springs *springs,
                    struct stability_contact *contact) {
    double h = s->step;
    contact->push = h * (h * springs->k_n + 2.0 * springs->c_n);
    contact->turn = h * (h * springs->k_t + 2.0 * springs->c_t);
    contact->roll = h * (h * springs->k_r + 2.0 * springs->c_r);
    contact->twist = h * (h * springs->k_w + 2.0 * springs->c_w);
}

/* The contact of a pair of the list; false if the pair does not touch or neither particle is free. */
static bool pair_contact(const struct stability *s, const struct force_context *context,
                         const struct pair_visit *pair, struct stability_contact *contact) {
    const struct particles *p = context->particles;
    uint32_t i = pair->i, j = pair->j;
    const struct particle_state *a = &p->state[i], *b = &p->state[j];
    const double *shift = context->list->shift[pair->image];
    double reach = a->radius + b->radius, far = reach + context->range, square = 0.0;
    for (int d = 0; d < 3; d++) {
        contact->normal[d] = b->x[d] - a->x[d] + shift[d];
        square += contact->normal[d] * contact->normal[d];
    }
    double inertia = a->inverse_mass + b->inverse_mass;
    const uint8_t *number = material_numbers(p);
    if (!(square < far * far) || !(inertia > 0.0) ||
        (context->joined && context->joined(context->joined_context, i, j)))
        return false;
    double distance = sqrt(square);
    for (int d = 0; d < 3; d++)
        contact->normal[d] = distance > 0.0 ? contact->normal[d] / distance : 0.0;
    contact->i = i;
    contact->j = j;
    contact->lever = 1.0;
    contact->radius = a->radius * b->radius / reach;
    struct timestep_springs springs =
        timestep_springs(context->law, material_of(number, i), material_of(number, j), 1.0 / inertia,
                         contact->radius, reach - distance);
    stiffen(s, &springs, contact);
    return true;
}

/* Adds to a sum; `shared`: other threads may do so at the same time. */
static void add(double *sum, double value, bool shared) {
    value = rounded(value);
    if (!shared) {
        *sum += value;
        return;
    }
#pragma omp atomic
    *sum += value;
}

/* Adds (a - b) n n^T + b 1 to a tensor. */
static void add_tensor(double *sum, double along, double across, const double n[3], bool shared) {
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    for (int c = 0; c < 6; c++)
        add(&sum[c], (along - across) * n[row[c]] * n[column[c]] + (c < 3 ? across : 0.0), shared);
}

void stability_bound(struct stability *s, size_t i, double bound) {
    double *sum = s->sum + i * (size_t)s->sums;
    for (int c = 0; c < 3; c++) {
        add(&sum[c], bound, true);
        if (s->sums != STABILITY_PUSH)
            add(&sum[6 + c], bound, true);
    }
}

/* Adds the part of a contact to particle i; `sign` turns the normal outwards. */
static void add_to(const struct stability *s, const struct particles *p, size_t i,
                   const struct stability_contact *contact, double sign, bool shared) {
    const double turn = 1.0 / TIMESTEP_INERTIA;
    double *sum = s->sum + i * (size_t)s->sums, mass = p->state[i].inverse_mass;
    double share = contact->radius / p->state[i].radius;
    if (mass == 0.0)
        return;
    add_tensor(sum, mass * contact->push, mass * contact->turn, contact->normal, shared);
    if (s->sums == STABILITY_PUSH)
        return;
    double radius = p->state[i].radius, twist = contact->twist / (radius * radius);
    double slide = contact->turn * contact->lever;
    add_tensor(sum + 6, mass * turn * twist,
               mass * turn * (slide * contact->lever + share * share * contact->roll), contact->normal,
               shared);
    for (int d = 0; d < 3; d++)
        add(&sum[12 + d], sign * sqrt(turn) * mass * slide * contact->normal[d], shared);
}

void stability_add(struct stability *s, const struct particles *particles, size_t i,
                   const struct stability_contact *contact) {
    add_to(s, particles, i, contact, 1.0, false);
}

/* Shares go to one side or both, as forces do. */
static void add_thread(const struct stability *s, const struct force_context *context, int t) {
    struct stability_contact contact;
    struct pair_visit pair = pairlist_thread(context->list, t);
    while (pairlist_each(context->list, &pair)) {
        if (!pair_contact(s, context, &pair, &contact))
            continue;
        /* all threads may add to a particle that has slots, so every addition is atomic then */
        bool shared = context->list->slot_count > 0;
        add_to(s, context->particles, contact.i, &contact, 1.0, shared);
        if (!pair_gives_one(&pair))
            add_to(s, context->particles, contact.j, &contact, -1.0, shared);
    }
}

void stability_pairs(struct stability *s, const struct force_context *context) {
    const struct pairlist *list = context->list;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < list->threads; t++)
        add_thread(s, context, t);
}

void stability_walls(struct stability *s, const struct force_context *context,
                     const struct force_contact *contacts, size_t count, const int *material) {
    const struct particles *p = context->particles;
    const uint8_t *number = material_numbers(p);
    for (size_t k = 0; k < count; k++) {
        const struct force_contact *c = &contacts[k];
        const struct particle_state *state = &p->state[c->number_i];
        struct stability_contact contact = {.i = c->number_i,
                                            .normal = {c->normal[0], c->normal[1], c->normal[2]},
                                            .radius = state->radius,
                                            .lever = 1.0};
        if (state->inverse_mass == 0.0)
            continue;
        struct timestep_springs springs =
            timestep_springs(context->law, material_of(number, c->number_i), material[-c->id_j - 1],
                             1.0 / state->inverse_mass, state->radius, c->overlap);
        stiffen(s, &springs, &contact);
        add_to(s, p, contact.i, &contact, 1.0, false);
    }
}

/* What the visit of walls needs. */
struct wall_sums {
    struct stability *stability;
    const struct force_context *context;
    const struct walls *walls;
};

static void add_to_wall(void *sums, const struct wall_place *place) {
    const struct wall_sums *of = sums;
    const struct particles *p = of->context->particles;
    const struct particle_state *state = &p->state[place->particle];
    struct stability_contact contact = {0};
    double yield = walls_yield_worst(of->walls, place->wall, place->at),
           inverse = state->inverse_mass + yield;
    if (!(yield > 0.0))
        return;
    struct timestep_springs springs = timestep_springs(
        of->context->law, material_of(material_numbers(p), place->particle),
        walls_options(of->walls, place->wall)->material, 1.0 / inverse, state->radius, -place->gap);
    stiffen(of->stability, &springs, &contact);
    double turn = walls_turn_yield(of->walls, place->wall) *
                  (state->radius * state->radius * contact.roll + contact.twist);
    of->stability->wall[place->wall] += rounded(yield * fmax(contact.push, contact.turn) + turn);
}

void stability_free_walls(struct stability *s, const struct force_context *context, const struct walls *walls,
                          int thread) {
    struct wall_sums sums = {s, context, walls};
    if (s->wall == NULL) {
        s->walls = walls_count(walls);
        s->wall = memory_allocate_zero((size_t)s->walls, sizeof *s->wall, "stability of contacts");
    }
    walls_visit(walls, context->particles, thread, context->range, add_to_wall, &sums);
}

double stability_eigenvalue(const double *sum, int sums) {
    double push = eigen3_largest(sum);
    if (sums == STABILITY_PUSH)
        return push;
    double turn = eigen3_largest(sum + 6), half = 0.5 * (push - turn);
    double couple = sum[12] * sum[12] + sum[13] * sum[13] + sum[14] * sum[14];
    return 0.5 * (push + turn) + sqrt(half * half + couple);
}

void stability_solve(struct stability *s, const struct particles *particles) {
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++) {
        const double *sum = s->sum + k * (size_t)s->sums;
        bool touched = sum[0] + sum[1] + sum[2] > 0.0;
        s->local[k] = touched ? stability_eigenvalue(sum, s->sums) : 0.0;
    }
}

static double thread_worst(const struct stability *s, const struct force_context *context, int t) {
    struct stability_contact contact;
    double most = 0.0;
    struct pair_visit pair = pairlist_thread(context->list, t);
    while (pairlist_each(context->list, &pair)) {
        double both = s->local[pair.i] + s->local[pair.j];
        if (both > most && pair_contact(s, context, &pair, &contact))
            most = both;
    }
    return most;
}

double stability_worst(const struct stability *s, const struct force_context *context) {
    const struct pairlist *list = context->list;
    double most = 0.0, wall = 0.0;
#pragma omp parallel for schedule(static, 1) reduction(max : most)
    for (int t = 0; t < list->threads; t++)
        most = fmax(most, thread_worst(s, context, t));
    for (int w = 0; w < s->walls; w++)
        wall = fmax(wall, s->wall[w]);
    for (size_t k = 0; k < context->particles->owned;
         k++) /* contacts with walls: one that is not free has no L */
        most = fmax(most, s->local[k] + wall);
    return most;
}
