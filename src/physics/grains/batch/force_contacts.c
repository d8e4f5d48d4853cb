/* SPDX-License-Identifier: BSD-3-Clause */
/* The list of present contacts, for output: a plain loop over the pairs with the law of the force loop. */
#include "physics/grains/batch/force.h"
#include "physics/grains/laws/law_general.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"

/* A walk over the history records of one thread, in the order of the thread's pairs. */
struct force_walk {
    const struct history_part *part; /* NULL without history */
    size_t cursor, base;
    int components;
};

/* The record of pair k, or NULL. */
static const double *force_walk_find(struct force_walk *walk, size_t k) {
    if (walk->part == NULL)
        return NULL;
    while (walk->cursor < walk->part->count && walk->part->pair[walk->cursor] < k - walk->base)
        walk->cursor++;
    if (walk->cursor == walk->part->count || walk->part->pair[walk->cursor] != k - walk->base)
        return NULL;
    return walk->part->value + walk->cursor * (size_t)walk->components;
}

static struct law_vector force_difference(const double a[3], const double b[3]) {
    return (struct law_vector){a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

static bool force_same(const double a[3], const double b[3]) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* True if two particles are fixed to each other, by the rule of the force loop. */
static bool force_pair_fixed(const struct particles *p, const double (*omega)[4], size_t i, size_t j) {
    const struct particle_state *si = &p->state[i], *sj = &p->state[j];
    return si->inverse_mass + sj->inverse_mass == 0.0 && force_same(si->v, sj->v) &&
           (omega == NULL || force_same(omega[i], omega[j]));
}

/* Fills the input of a law with parts or of the user's, whose other members are there. */
static void force_pair_general(const struct force_context *context, const struct pair_visit *pair,
                               const double *record, struct law_general *all) {
    const struct particles *p = context->particles;
    const uint8_t *material = material_numbers(p);
    size_t i = pair->i, j = pair->j;
    all->extra = law_extra_of(context->law, material_of(material, i), material_of(material, j));
    all->radius[0] = p->state[i].radius;
    all->radius[1] = p->state[j].radius;
    for (int c = 0; record && context->law->general && c < context->law->history_components; c++)
        all->value[c] = record[c];
}

/* Fills the law's input for two spheres; false if the spheres are out of range. `separation` is x_j - x_i. */
static bool force_pair_contact(const struct force_context *context, const struct pair_visit *pair,
                               const double *record, struct law_general *all, struct law_vector *separation) {
    struct law_contact *in = &all->contact;
    const struct particles *p = context->particles;
    uint32_t i = pair->i, j = pair->j;
    const struct particle_state *si = &p->state[i], *sj = &p->state[j];
    const double *shift = context->list->shift[pair->image], *drift = context->list->drift[pair->image];
    struct law_vector d = force_difference(sj->x, si->x);
    d = law_add(d, 1.0, (struct law_vector){shift[0], shift[1], shift[2]});
    *separation = d;
    double reach = si->radius + sj->radius, square = law_dot(d, d), far = reach + context->range;
    if (!(square < far * far))
        return false;
    const double(*omega)[4] = context->law->spin ? spin_values(p) : NULL;
    const uint8_t *material = material_numbers(p);
    if (force_pair_fixed(p, omega, i, j) ||
        (context->joined && context->joined(context->joined_context, i, j)))
        return false;
    double distance = sqrt(square), inertia = si->inverse_mass + sj->inverse_mass;
    struct law_case law = law_case_of(&context->law->options, false);
    *all = (struct law_general){0};
    *in = (struct law_contact){
        .overlap = reach - distance,
        .mass = inertia > 0.0 ? 1.0 / inertia : 0.0,
        .radius = si->radius * sj->radius / reach,
        .normal = law_scale(distance > 0.0 ? 1.0 / distance : 0.0, d),
        .velocity = force_difference(sj->v, si->v),
        .coefficients = *law_pair_of(context->law, material_of(material, i), material_of(material, j))};
    in->half_normal = in->normal;
    if (context->list->moves)
        in->velocity = law_add(in->velocity, 1.0, (struct law_vector){drift[0], drift[1], drift[2]});
    force_pair_general(context, pair, record, all);
    if (!law.friction || omega == NULL)
        return true;
    struct law_vector wi = {omega[i][0], omega[i][1], omega[i][2]};
    struct law_vector wj = {omega[j][0], omega[j][1], omega[j][2]};
    in->surface = law_add(law_scale(law_lever(law, si->radius, in->overlap), wi),
                          law_lever(law, sj->radius, in->overlap), wj);
    in->spin = law_add(wj, -1.0, wi);
    if (record && !context->law->general)
        in->spring = (struct law_vector){record[0], record[1], record[2]};
    if (record && law.rolling && !context->law->general)
        in->roll = (struct law_vector){record[3], record[4], record[5]};
    return true;
}

/* For a one-sided pair, whose mirror another thread or rank computes: true if this side reports the
 * contact. */
static bool force_pair_home(int64_t id_i, int64_t id_j, struct law_vector separation) {
    if (id_i != id_j)
        return id_i < id_j;
    double first = separation.x != 0.0 ? separation.x : separation.y != 0.0 ? separation.y : separation.z;
    return first > 0.0;
}

/* The response of the law with springs that stay; false if a law with parts finds no contact. */
static bool force_answer_of(const struct law *law, struct law_general *all, struct law_response *out) {
    if (law->general)
        return law_general_respond(law, law_general_step(&law->options, 0.0), all, out);
    if (law->options.user)
        all->contact.springs = law_springs_of(&law->options, &all->contact.coefficients, all->extra,
                                              all->contact.radius, all->contact.overlap);
    *out = law_respond(law_case_of(&law->options, false), law_step_of(&law->options, 0.0), &all->contact);
    return true;
}

static struct force_contact force_contact_of(const struct force_context *context,
                                             const struct pair_visit *pair, const struct law_contact *in,
                                             struct law_response out, struct law_vector separation) {
    const int64_t *id = context->particles->id;
    size_t i = pair->i, j = pair->j;
    return (struct force_contact){.id_i = id[i],
                                  .id_j = id[j],
                                  .number_i = i,
                                  .number_j = j,
                                  .branch = {separation.x, separation.y, separation.z},
                                  .normal = {in->normal.x, in->normal.y, in->normal.z},
                                  .overlap = in->overlap,
                                  .force = {out.force.x, out.force.y, out.force.z}};
}

size_t force_loop_contacts(const struct force_context *context, struct force_contact **contacts) {
    const struct pairlist *list = context->list;
    const int64_t *id = context->particles->id;
    size_t count = 0, capacity = 1024;
    if (context->solved)
        return context->solved(context->solver, false, contacts);
    *contacts = memory_allocate(capacity, sizeof **contacts, "contact list");
    for (int t = 0; t < list->threads; t++) {
        struct pair_visit pair = pairlist_thread(list, t);
        struct force_walk walk = {.base = pairlist_thread_first(list, t)};
        if (context->history) {
            walk.part = &context->history->part[context->history->now][t];
            walk.components = context->history->components;
        }
        while (pairlist_each(list, &pair)) {
            struct law_general in;
            struct law_response out;
            struct law_vector separation;
            if (!force_pair_contact(context, &pair, force_walk_find(&walk, pair.k), &in, &separation) ||
                !force_answer_of(context->law, &in, &out))
                continue;
            if (pair_gives_one(&pair) && !force_pair_home(id[pair.i], id[pair.j], separation))
                continue;
            if (count == capacity)
                *contacts = memory_resize(*contacts, capacity *= 2, sizeof **contacts, "contact list");
            (*contacts)[count++] = force_contact_of(context, &pair, &in.contact, out, separation);
        }
    }
    return count;
}
