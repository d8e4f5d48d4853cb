/* SPDX-License-Identifier: BSD-3-Clause */
/* Bonds as a physics: forces and moments of bonds, and their ends (engine/physics.h). Read bonds.h first. */
#include "physics/bonds/bonds.h"
#include "physics/bonds/bonds_state.h"
#include "kernel/particles/spin.h"
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

/* The separation from the lower id to the higher, over the image that is nearest to that of the last step. */
static struct law_vector separation_of(const struct box *box, const double *lower, const double *higher,
                                       const double *last) {
    double apart[3];
    for (int d = 0; d < 3; d++) {
        apart[d] = higher[d] - lower[d];
        if (box->periodic[d])
            apart[d] += round((last[d] - apart[d]) / box->edge[d]) * box->edge[d];
    }
    return (struct law_vector){apart[0], apart[1], apart[2]};
}

/* The motion of the ends of the bond `row`. */
static struct bond_motion motion_of(const struct bonds *bonds, const double (*omega)[4], uint32_t lower,
                                    uint32_t higher, const struct history_row *row) {
    const struct particles *p = bonds->context->particles;
    const struct particle_state *a = &p->state[lower], *b = &p->state[higher];
    const double *u = omega[lower], *w = omega[higher];
    struct bond_motion m = {.velocity = {b->v[0] - a->v[0], b->v[1] - a->v[1], b->v[2] - a->v[2]},
                            .spin = {{u[0], u[1], u[2]}, {w[0], w[1], w[2]}}};
    m.separation = separation_of(bonds->context->box, a->x, b->x, row->separation);
    double half = 0.5 * (a->radius + b->radius - sqrt(law_dot(m.separation, m.separation)));
    m.lever[0] = a->radius - half;
    m.lever[1] = b->radius - half;
    return m;
}

/* Writes the end of a bond down, at the particle with the lower id. */
static void end_note(const struct bonds *bonds, const struct history_row *row,
                     const struct bond_response *out, const double *x, double lever,
                     struct bonds_sums *sums) {
    const struct clock *clock = bonds->context->clock;
    const double normal[3] = {out->normal.x, out->normal.y, out->normal.z};
    struct bonds_event event = {.step = clock->step,
                                .time = clock->time,
                                .id = {row->id, row->partner},
                                .end = (int32_t)out->end,
                                .tensile = out->tensile,
                                .shear = out->shear};
    for (int d = 0; d < 3; d++) {
        double edge = bonds->context->box->edge[d];
        event.x[d] = x[d] + lever * normal[d];
        if (bonds->context->box->periodic[d])
            event.x[d] -= edge * floor(event.x[d] / edge);
    }
    sums->broken[out->end]++;
    sums->taken += out->stored;
    bonds_events_add(&sums->events, &event);
}

/* The bonds of a thread on their way through a batch: row and carrier of each. */
struct bonds_task {
    struct bonds *bonds;
    struct bonds_sums *sums;
    const double (*omega)[4];
    double dt;
    struct bond_batch batch;
    size_t row[BOND_BATCH], carrier[BOND_BATCH];
};

/* Takes bond k of the batch: its row, and force and torque on its carrier. */
static void row_act(struct bonds_task *task, int k) {
    struct bonds *bonds = task->bonds;
    struct particles *p = bonds->context->particles;
    size_t i = task->carrier[k];
    struct history_row *row = &bonds->rows.row[task->row[k]];
    struct bonds_link *link = &bonds->link[task->row[k]];
    const double lever[2] = {task->batch.motion[12][k], task->batch.motion[13][k]};
    struct bond_response out;
    bond_batch_take(&task->batch, k, row, &out);
    link->end = (uint8_t)out.end;
    if (out.end != BOND_WHOLE) {
        if (link->lower)
            end_note(bonds, row, &out, p->state[i].x, lever[0], task->sums);
        return;
    }
    double sign = link->lower ? -1.0 : 1.0, *force = p->force + i * (size_t)p->force_stride;
    struct law_vector torque =
        law_add(law_scale(-lever[!link->lower], law_cross(out.normal, out.force)), sign, out.moment);
    force[0] += sign * out.force.x;
    force[1] += sign * out.force.y;
    force[2] += sign * out.force.z;
    force[4] += torque.x;
    force[5] += torque.y;
    force[6] += torque.z;
    if (link->lower) {
        task->sums->stored += out.stored;
        task->sums->taken += out.taken;
    }
}

static void flush(struct bonds_task *task) {
    bond_batch_advance(&task->batch, task->dt);
    for (int k = 0; k < task->batch.count; k++)
        row_act(task, k);
    task->batch.count = 0;
}

/* Puts row k of particle i into the batch, if the bond is whole. */
static void row_add(struct bonds_task *task, size_t i, size_t k) {
    const struct bonds_link *link = &task->bonds->link[k];
    const struct history_row *row = &task->bonds->rows.row[k];
    uint32_t here = (uint32_t)i;
    if (link->end != BOND_WHOLE)
        return;
    if (task->batch.count == BOND_BATCH)
        flush(task);
    task->row[task->batch.count] = k;
    task->carrier[task->batch.count] = i;
    struct bond_motion motion = motion_of(task->bonds, task->omega, link->lower ? here : link->partner,
                                          link->lower ? link->partner : here, row);
    bond_batch_add(&task->batch, &link->section, &motion, row);
}

/* The bonds of the particles of a thread. */
static void act(const struct physics_context *context, int thread) {
    struct bonds *bonds = context->self;
    struct particles *p = context->particles;
    struct bonds_task task = {.bonds = bonds,
                              .sums = &bonds->sums[thread],
                              .omega = spin_values(p),
                              .dt = context->clock->step == bonds->made_step ? 0.0 : context->clock->dt};
    size_t first = p->owned * (size_t)thread / (size_t)context->threads;
    size_t last = p->owned * ((size_t)thread + 1) / (size_t)context->threads;
    for (size_t i = first; i < last; i++)
        for (size_t k = bonds->rows.start[i]; k < bonds->rows.start[i + 1]; k++)
            row_add(&task, i, k);
    flush(&task);
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
     .share = act},
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
