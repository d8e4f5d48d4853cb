/* SPDX-License-Identifier: BSD-3-Clause */
/* Bonds as a physics: forces and moments of bonds, and their ends (engine/physics.h). Read bonds.h first. */
#include "physics/bonds/bonds.h"
#include "physics/bonds/bonds_state.h"
#include "base/log.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "physics/grains/motion/stability.h"
#include "kernel/particles/kinds.h"
#include "data/scene/scene.h"
#include <math.h>
#include <string.h>

static bool at_time(const struct bonds_options *o, const struct clock *clock) {
    return o->when == BONDS_AT_START || clock->time >= o->time * (1 - 1e-12);
}

/* Until the bonds are made grains meet up to the gap; then bonds need no search. */
static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct bonds *bonds = context;
    (void)radius_a, (void)radius_b;
    if (bonds->made || bonds->options->list[0] || kind_a != KIND_GRAIN || kind_b != KIND_GRAIN)
        return -INFINITY;
    return bonds->options->gap;
}

static bool check_entry(const struct scene *scene, const struct bonds_entry *e, int k, struct error *error) {
    char key[64];
    snprintf(key, sizeof key, "bonds.laws[%d]", k);
    bool areal = !isnan(e->k_n) || !isnan(e->k_s), elastic = !isnan(e->modulus) || !isnan(e->ratio);
    if (areal == elastic || (areal && (isnan(e->k_n) || isnan(e->k_s))) ||
        (elastic && (isnan(e->modulus) || isnan(e->ratio))))
        return scene_fail(scene, error, key, "needs k_n and k_s, or else modulus and stiffness_ratio");
    return true;
}

/* Refuses sections that leave a number open. */
static bool check(const struct physics_context *context, struct error *error) {
    const struct bonds_options *o = context->options;
    const struct scene *scene = context->scene;
    struct error file = {0};
    if (scene->materials == 0)
        return scene_fail(scene, error, "bonds", "needs `materials`: grains");
    if (o->when == BONDS_AT_TIME && isnan(o->time))
        return scene_fail(scene, error, "bonds.time", "is needed with when: time");
    for (int k = 0; k < o->entries; k++)
        if (!check_entry(scene, &o->entry[k], k, error))
            return false;
    if (o->list[0] && context->comm->rank == 0 && !bonds_list_good(o->list, &file))
        return scene_fail(scene, error, "bonds.list", "%s", file.text);
    return true;
}

static void *create(const struct physics_context *context) {
    struct bonds *bonds = memory_allocate_zero(1, sizeof *bonds, "bonds");
    bonds->options = context->options;
    bonds->context = context;
    bonds->sums = memory_allocate_zero((size_t)context->threads, sizeof *bonds->sums, "bonds");
    return bonds;
}

static void destroy(void *self) {
    struct bonds *bonds = self;
    for (int t = 0; t < bonds->context->threads; t++)
        memory_free(bonds->sums[t].events.event);
    memory_free(bonds->sums);
    memory_free(bonds->events.event);
    history_rows_free(&bonds->rows);
    memory_free(bonds->link);
    if (bonds->file)
        fclose(bonds->file);
    memory_free(bonds);
}

static struct history_rows *rows_of(const struct physics_context *context) {
    struct bonds *bonds = context->self;
    bonds_compact(bonds);
    return &bonds->rows;
}

static bool due(const struct physics_context *context) {
    const struct bonds *bonds = context->self;
    return !bonds->made && at_time(bonds->options, context->clock);
}

/* Warns if there is no bond: units, or places, are then probably not what they should be. */
static void none_tell(const struct bonds *bonds) {
    const struct bonds_options *o = bonds->options;
    int64_t sides = (int64_t)bonds->rows.count;
    comm_sum_int(bonds->context->comm, &sides, 1);
    if (sides > 0 || bonds->context->comm->rank > 0)
        return;
    if (o->list[0])
        log_tell(bonds->context->log, "warning: bonds: there is no bond: %.300s lists none", o->list);
    else
        log_tell(bonds->context->log,
                 "warning: bonds: there is no bond at t = %.6g: no two grains that bonds.laws serve are at "
                 "most bonds.gap = "
                 "%.6g apart",
                 bonds->context->clock->time, o->gap);
}

/* True if the bonds were made in this rebuild: copies must then reach their partners. */
static bool rebuilt_again(const struct physics_context *context) {
    struct bonds *bonds = context->self;
    if (!due(context)) {
        bonds_link_all(bonds);
        return false;
    }
    bonds_make(bonds);
    if (bonds->error.kind == ERROR_NONE)
        none_tell(bonds);
    bonds->links = 0; /* partners may be missing until the rebuild that follows */
    bonds->made = 1;
    bonds->made_step = context->clock->step;
    return true;
}

/* Adds up the sums of the threads. */
static void finish(const struct physics_context *context) {
    struct bonds *bonds = context->self;
    bonds->stored = 0.0;
    for (int t = 0; t < context->threads; t++) {
        struct bonds_sums *sums = &bonds->sums[t];
        bonds->stored += sums->stored;
        bonds->taken += sums->taken;
        for (int e = 0; e < BOND_ENDS; e++)
            bonds->broken[e] += sums->broken[e];
        for (size_t k = 0; k < sums->events.count; k++)
            bonds_events_add(&bonds->events, &sums->events.event[k]);
        struct bonds_events events = {.event = sums->events.event, .capacity = sums->events.capacity};
        *sums = (struct bonds_sums){.events = events};
    }
}

/* Fills the field of numbers of bonds. */
static void count(const struct physics_context *context) {
    const struct bonds *bonds = context->self;
    double *number = bonds_numbers(context->particles);
    for (size_t i = 0; i < context->particles->owned; i++) {
        number[i] = 0;
        for (size_t k = bonds->rows.start[i]; k < bonds->rows.start[i + 1]; k++)
            number[i] += bonds->link[k].end == BOND_WHOLE;
    }
}

static void energy(const struct physics_context *context, struct physics_energy *energy) {
    const struct bonds *bonds = context->self;
    energy->held = bonds->stored;
    energy->taken = bonds->taken;
}

/* True if a bond that stands for the contact joins two particles, one of which is owned. */
static bool joined(const struct physics_context *context, size_t i, size_t j) {
    const struct bonds *bonds = context->self;
    const struct particles *p = context->particles;
    size_t carrier = i < p->owned ? i : j, other = i < p->owned ? j : i;
    for (size_t k = bonds->rows.start[carrier]; k < bonds->rows.start[carrier + 1]; k++)
        if (bonds->rows.row[k].partner == p->id[other] && bonds->link[k].end == BOND_WHOLE)
            return true;
    return false;
}

static bool joins(const struct physics_context *context) {
    return !((const struct bonds_options *)context->options)->contacts;
}

/* The springs of a bond as those of a contact: bending as rolling, whose torque acts over R*. */
static void stiffen(const struct physics_context *context, struct stability *stability) {
    const struct bonds *bonds = context->self;
    const struct particles *p = context->particles;
    double h = stability->step;
    for (size_t i = 0; i < p->owned; i++)
        for (size_t k = bonds->rows.start[i]; k < bonds->rows.start[i + 1]; k++) {
            const struct bonds_link *link = &bonds->link[k];
            const struct bond_section *s = &link->section;
            const double *d = bonds->rows.row[k].separation;
            double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), sign = link->lower ? 1.0 : -1.0;
            if (link->end != BOND_WHOLE || !(length > 0.0))
                continue;
            double a = p->state[i].radius, b = p->state[link->partner].radius, radius = a * b / (a + b);
            struct stability_contact contact = {.i = i,
                                                .j = link->partner,
                                                .radius = radius,
                                                .lever = (a - 0.5 * (a + b - length)) / a,
                                                .push = h * (h * s->stretch + 2.0 * s->c_stretch),
                                                .turn = h * (h * s->slide + 2.0 * s->c_slide),
                                                .roll =
                                                    h * (h * s->bend + 2.0 * s->c_bend) / (radius * radius),
                                                .twist = h * (h * s->twist + 2.0 * s->c_twist)};
            for (int c = 0; c < 3; c++)
                contact.normal[c] = sign * d[c] / length;
            stability_add(stability, p, i, &contact);
        }
}

static double stiffest(const struct physics_context *context, const struct stability *stability) {
    const struct bonds *bonds = context->self;
    double most = 0.0;
    for (size_t i = 0; i < context->particles->owned; i++)
        for (size_t k = bonds->rows.start[i]; k < bonds->rows.start[i + 1]; k++)
            if (bonds->link[k].end == BOND_WHOLE)
                most = fmax(most, stability->local[i] + stability->local[bonds->link[k].partner]);
    return most;
}

static void guard(const struct physics_context *context, struct error *error) {
    const struct bonds *bonds = context->self;
    if (error->kind == ERROR_NONE)
        *error = bonds->error;
}

static void print(const struct physics_context *context, FILE *file) {
    const struct bonds *bonds = context->self;
    double number = 0.5 * (double)bonds->rows.count, longest = 0.0;
    comm_sum(context->comm, &number, 1);
    for (size_t k = 0; k < bonds->rows.count; k++) {
        const double *d = bonds->rows.row[k].separation;
        longest = fmax(longest, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    comm_max(context->comm, &longest, 1);
    if (context->comm->rank > 0)
        return;
    if (!bonds->made)
        fprintf(file, "  bonds: made at t = %g between surfaces up to %g apart\n", bonds->options->time,
                bonds->options->gap);
    else
        fprintf(file, "  bonds: %.0f, the longest %.6g between centres; %zu bytes a bond\n", number,
                sqrt(longest), 2 * (sizeof(struct history_row) + sizeof(struct bonds_link)));
}

static void restart(const struct physics_context *context, struct restart *list) {
    static const char *const names[BOND_ENDS] = {"bonds: whole", "bonds: broken by tension",
                                                 "bonds: broken by shear", "bonds: lost"};
    struct bonds *bonds = context->self;
    restart_add(list, RESTART_INTEGER, true, &bonds->made, "bonds: made");
    restart_add(list, RESTART_SUM, true, &bonds->taken, "bonds: energy taken");
    for (int e = BOND_TENSION; e < BOND_ENDS; e++)
        restart_add(list, RESTART_SUM, true, &bonds->broken[e], "%s", names[e]);
}

static const struct physics_pass passes[] = {
    {.name = "bonds",
     .does = "forces of bonds",
     .place = PASS_SHARES,
     .reads = "position velocity angular_velocity",
     .writes = "force torque",
     .share = bonds_act},
    {.name = "bonds_finish", .place = PASS_CLOSE, .timer = "bonds", .whole = finish},
    {.name = "bonds_count", .place = PASS_LOOK, .writes = "bonds", .whole = count}};

static const struct physics_rows rows = {
    .of = rows_of, .components = BOND_COMPONENTS, .due = due, .again = rebuilt_again};
static const struct physics_joints joints = {
    .joined = joined, .joins = joins, .stiffen = stiffen, .stiffest = stiffest};
static const struct physics_table table = {.open = bonds_table_open, .write = bonds_table_write};

static const struct physics_search search = {
    .interactions = 1, .interaction = {{.name = "bonds", .range = range}}, .range_of_self = true};

const struct physics bonds_physics = {.name = "bonds",
                                      .passes = sizeof passes / sizeof passes[0],
                                      .pass = passes,
                                      .check = check,
                                      .create = create,
                                      .destroy = destroy,
                                      .energy = energy,
                                      .guard = guard,
                                      .print = print,
                                      .restart = restart,
                                      .rows = &rows,
                                      .joints = &joints,
                                      .table = &table,
                                      .search = &search};
