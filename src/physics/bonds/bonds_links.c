/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows and their partners: the partner of a bond is found by its id among the particles and copies of this
 * rank. Read bonds.h first. */
#include "physics/bonds/bonds_state.h"
#include "kernel/comm/copies.h"
#include "base/memory.h"
#include "base/hash.h"
#include "kernel/particles/groups.h"
#include <math.h>
#include <string.h>

/* How far beyond its last length a bond's partner is still known after a rebuild. */
#define BONDS_SLACK 1.25

static bool named(int count, const int *name, int a, int b) {
    if (count == 0)
        return true;
    int other = name[count - 1];
    return (name[0] == a && other == b) || (name[0] == b && other == a);
}

int bonds_entry_of(const struct bonds_options *options, const int material[2], const int group[2]) {
    for (int e = 0; e < options->entries; e++) {
        const struct bonds_entry *entry = &options->entry[e];
        if (named(entry->materials, entry->material, material[0], material[1]) &&
            named(entry->groups, entry->group, group[0], group[1]))
            return e;
    }
    return -1;
}

/* The effective value of two that are given by their inverses; 0 where both inverses are 0. */
static double effective(double inverse_a, double inverse_b) {
    return inverse_a + inverse_b > 0.0 ? 1.0 / (inverse_a + inverse_b) : 0.0;
}

struct bond_section bonds_section(const struct bonds *bonds, int entry, uint32_t i, uint32_t j) {
    const struct bonds_entry *e = &bonds->options->entry[entry];
    const struct particle_state *a = &bonds->context->particles->state[i],
                                *b = &bonds->context->particles->state[j];
    double turn_a = 2.5 * a->inverse_mass / (a->radius * a->radius);
    double turn_b = 2.5 * b->inverse_mass / (b->radius * b->radius);
    bool given = !isnan(e->k_n);
    double k_n = given ? e->k_n : e->modulus / (a->radius + b->radius);
    return bond_section_of(&(struct bond_numbers){.k_n = k_n,
                                                  .k_s = given ? e->k_s : k_n / e->ratio,
                                                  .radius = e->radius * fmin(a->radius, b->radius),
                                                  .tensile = isnan(e->tensile) ? INFINITY : e->tensile,
                                                  .shear = isnan(e->shear) ? INFINITY : e->shear,
                                                  .damping = e->damping,
                                                  .mass = effective(a->inverse_mass, b->inverse_mass),
                                                  .inertia = effective(turn_a, turn_b)});
}

void bonds_compact(struct bonds *bonds) {
    const struct particles *p = bonds->context->particles;
    struct history_rows *rows = &bonds->rows;
    double *reach = copies_own_reach(p);
    uint8_t *told = bonds_groups(p);
    const uint8_t *group = groups_of(p);
    if (rows->start == NULL) {
        rows->start = memory_allocate_zero(p->owned + 1, sizeof *rows->start, "bonds");
        rows->row = memory_allocate(0, sizeof *rows->row, "bonds");
        rows->count = 0;
    }
    size_t kept = 0, first = 0;
    for (size_t i = 0; i < p->owned; i++) {
        size_t last = rows->start[i + 1];
        double far = 0.0;
        told[i] = group ? group[i] : 0;
        rows->start[i] = kept;
        for (size_t k = first; k < last; k++) {
            const double *d = rows->row[k].separation;
            if (bonds->links > 0 && bonds->link[k].end != BOND_WHOLE)
                continue;
            far = fmax(far, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            if (bonds->links > 0)
                bonds->link[kept] = bonds->link[k];
            rows->row[kept++] = rows->row[k];
        }
        reach[i] = BONDS_SLACK * sqrt(far);
        first = last;
    }
    rows->start[p->owned] = rows->count = kept;
    bonds->links = bonds->links > 0 ? kept : 0;
}

/* The partners of all rows, each by the first row that has it. */
struct partners {
    const struct history_rows *rows;
    uint32_t *number; /* of the partner of a row: a particle here, or BONDS_NOBODY */
    struct hash by_id;
};

/* The first row with this partner, or HASH_END. */
static uint32_t partners_find(const struct partners *partners, int64_t id) {
    uint32_t k = hash_first(&partners->by_id, (uint64_t)id);
    while (k != HASH_END && partners->rows->row[k].partner != id)
        k = partners->by_id.next[k];
    return k;
}

/* An owned particle goes before its copies. */
static void partners_make(struct partners *partners, const struct history_rows *rows,
                          const struct particles *p) {
    *partners = (struct partners){
        .rows = rows, .number = memory_allocate(rows->count, sizeof *partners->number, "partners of bonds")};
    hash_start(&partners->by_id, rows->count, "partners of bonds");
    for (size_t k = 0; k < rows->count; k++) {
        partners->number[k] = BONDS_NOBODY;
        if (partners_find(partners, rows->row[k].partner) == HASH_END)
            hash_put(&partners->by_id, (uint64_t)rows->row[k].partner, (uint32_t)k);
    }
    for (size_t k = 0; k < p->owned + p->ghosts; k++) {
        uint32_t row = partners_find(partners, p->id[k]);
        if (row != HASH_END && partners->number[row] == BONDS_NOBODY)
            partners->number[row] = (uint32_t)k;
    }
}

/* The entry of a row; the scene of a resume may have fewer. */
static int entry_of(struct bonds *bonds, const struct history_row *row) {
    int entry = (int)row->value[BOND_ENTRY];
    if (entry >= 0 && entry < bonds->options->entries)
        return entry;
    error_set(&bonds->error, ERROR_USER, "bonds.laws: the bonds of the checkpoint have %d laws or more",
              entry + 1);
    return 0;
}

/* A bond whose partner has gone ends. */
static void lost(struct bonds *bonds, size_t i, const struct history_row *row) {
    const struct physics_context *c = bonds->context;
    const struct particle_state *state = &c->particles->state[i];
    bool lower = row->id < row->partner;
    struct bonds_event event = {.step = c->clock->step,
                                .time = c->clock->time,
                                .id = {lower ? row->id : row->partner, lower ? row->partner : row->id},
                                .end = BOND_LOST};
    for (int d = 0; d < 3; d++)
        event.x[d] = state->x[d] + (lower ? 0.5 : -0.5) * row->separation[d];
    bonds->broken[BOND_LOST]++;
    bonds_events_add(&bonds->events, &event);
}

void bonds_link_all(struct bonds *bonds) {
    const struct particles *p = bonds->context->particles;
    const struct history_rows *rows = &bonds->rows;
    struct partners partners;
    partners_make(&partners, rows, p);
    memory_free(bonds->link);
    bonds->link = memory_allocate(rows->count, sizeof *bonds->link, "bonds");
    bonds->links = rows->count;
    for (size_t i = 0; i < p->owned; i++)
        for (size_t k = rows->start[i]; k < rows->start[i + 1]; k++) {
            const struct history_row *row = &rows->row[k];
            struct bonds_link *link = &bonds->link[k];
            *link = (struct bonds_link){.partner = partners.number[partners_find(&partners, row->partner)],
                                        .lower = row->id < row->partner};
            if (link->partner == BONDS_NOBODY) {
                link->end = BOND_LOST;
                lost(bonds, i, row);
                continue;
            }
            uint32_t here = (uint32_t)i;
            link->section = bonds_section(bonds, entry_of(bonds, row), link->lower ? here : link->partner,
                                          link->lower ? link->partner : here);
        }
    memory_free(partners.number);
    hash_free(&partners.by_id);
}
