/* SPDX-License-Identifier: BSD-3-Clause */
/* The forces and moments of bonds on the particles of a thread: rows go through a batch (bond.h). */
#include "physics/bonds/bonds_state.h"
#include "kernel/particles/spin.h"
#include <math.h>

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

void bonds_act(const struct physics_context *context, int thread) {
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
