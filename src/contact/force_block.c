/* One block of the pair list through the force loop: filter, gather, physics, scatter (force_kernel.h).
 * Compiled once for each instruction set, under the name that FORCE_KERNEL gives. */
#include "contact/force_kernel.h"
#include "contact/force_physics.h"
#include <string.h>

/* Four doubles that move together; lowered to narrower registers where the CPU has none so wide. */
typedef double force_four __attribute__((vector_size(32), aligned(8), may_alias));

/* Half a record of a particle: x y z vx, and vy vz radius 1/mass. */
#define FORCE_HALF(state, half) (*(const force_four *)((const double *)(state) + 4 * (half)))

/* Separation of the pairs [first, last) of the list against the sum of radii; appends those that touch. */
static inline void force_filter(const struct force_task *task, size_t first, size_t last) {
    const struct pairlist *list = task->context->list;
    const struct particle_state *state = task->context->particles->state;
    struct force_thread *restrict thread = task->thread;
    uint32_t touch[FORCE_CHUNK];
    int n = (int)(last - first);
    for (int k = 0; k < n; k++) {
        uint32_t code = list->j[first + (size_t)k];
        const struct particle_state *i = &state[list->i[first + (size_t)k]], *j = &state[pair_partner(code)];
        *(force_four *)thread->distance[k] =
            (FORCE_HALF(j, 0) - FORCE_HALF(i, 0)) + *(const force_four *)list->shift[pair_image(code)];
        thread->reach[k] = i->radius + j->radius;
    }
#pragma omp simd
    for (int k = 0; k < n; k++) {
        const double *d = thread->distance[k];
        double reach = thread->reach[k];
        touch[k] = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach;
    }
    uint32_t *out = thread->candidate + thread->candidates;
    uint32_t number = (uint32_t)(first - task->block->first_pair);
    for (int k = 0; k < n; k++) {
        *out = number + (uint32_t)k;
        out += touch[k];
    }
    thread->candidates = (size_t)(out - thread->candidate);
}

/* Fills the batch with the first `count` candidates. */
static inline void force_gather(const struct force_task *task, int count) {
    const struct pairlist *list = task->context->list;
    const struct particles *particles = task->context->particles;
    const force_four sign = {-1.0, -1.0, 1.0, 1.0};
    const double(*omega)[4] = task->context->law->spin ? particles->omega : NULL;
    struct force_thread *restrict thread = task->thread;
    struct force_batch *restrict b = &thread->batch;
    for (int k = 0; k < count; k++) {
        size_t pair = task->block->first_pair + thread->candidate[k];
        uint32_t i = list->i[pair], code = list->j[pair], j = pair_partner(code);
        const struct particle_state *si = &particles->state[i], *sj = &particles->state[j];
        b->i[k] = i;
        b->j[k] = j;
        b->pair[k] = (uint32_t)(pair - task->pair_base);
        b->radius[0][k] = si->radius;
        b->radius[1][k] = sj->radius;
        *(force_four *)b->record[k] =
            (FORCE_HALF(sj, 0) - FORCE_HALF(si, 0)) + *(const force_four *)list->shift[pair_image(code)];
        *(force_four *)(b->record[k] + 4) = FORCE_HALF(sj, 1) + FORCE_HALF(si, 1) * sign;
        if (omega) {
            *(force_four *)b->omega[k] = *(const force_four *)omega[i];
            *(force_four *)(b->omega[k] + 4) = *(const force_four *)omega[j];
        }
    }
    b->count = count;
    b->padded = (count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
}

/* Finds the old springs of the batch's contacts: both run in the order of the pairs. */
static inline void force_recall(const struct force_task *task, int components) {
    const struct history_part *old = task->old;
    struct force_batch *restrict b = &task->thread->batch;
    size_t cursor = task->thread->cursor, end = old->count;
    for (int k = 0; k < b->count; k++) {
        while (cursor < end && old->pair[cursor] < b->pair[k])
            cursor++;
        bool known = cursor < end && old->pair[cursor] == b->pair[k];
        for (int c = 0; c < components; c++)
            b->spring[c][k] = known ? old->value[cursor * (size_t)components + (size_t)c] : 0.0;
    }
    task->thread->cursor = cursor;
}

/* Appends the new springs of the batch to the other buffer. */
static inline void force_remember(const struct force_task *task, int components) {
    struct history_part *restrict new = task->new;
    const struct force_batch *restrict b = &task->thread->batch;
    double *value = new->value + new->count *(size_t)components;
    for (int k = 0; k < b->count; k++) {
        new->pair[new->count + (size_t)k] = b->pair[k];
        for (int c = 0; c < components; c++)
            *value++ = b->spring[c][k];
    }
    new->count += (size_t)b->count;
}

/* Coefficients of each contact, where there are several materials. */
static inline void force_mix(const struct force_task *task) {
    const struct law *law = task->context->law;
    const uint8_t *material = task->context->particles->material;
    struct force_batch *restrict b = &task->thread->batch;
    for (int k = 0; k < b->count; k++) {
        const struct law_coefficients *c = &law->pair[material[b->i[k]]][material[b->j[k]]];
        b->coefficient[0][k] = c->k_n;
        b->coefficient[1][k] = c->k_t;
        b->coefficient[2][k] = c->c_n;
        b->coefficient[3][k] = c->c_t;
        b->coefficient[4][k] = c->friction;
        b->coefficient[5][k] = c->rolling_friction;
    }
}

/* The same coefficients for all, where there is one material. */
static void force_mix_one(struct force_batch *b, const struct law_coefficients *c) {
    const double value[6] = {c->k_n, c->k_t, c->c_n, c->c_t, c->friction, c->rolling_friction};
    for (int row = 0; row < 6; row++)
        for (int k = 0; k < FORCE_BATCH; k++)
            b->coefficient[row][k] = value[row];
}

/* Repeats the last contact up to a full vector. */
static inline void force_pad(struct force_batch *b) {
    int last = b->count - 1;
    for (int k = b->count; k < b->padded; k++) {
        memcpy(b->record[k], b->record[last], sizeof b->record[k]);
        memcpy(b->omega[k], b->omega[last], sizeof b->omega[k]);
        for (int side = 0; side < 2; side++)
            b->radius[side][k] = b->radius[side][last];
        for (int c = 0; c < HISTORY_COMPONENTS_MAX; c++)
            b->spring[c][k] = b->spring[c][last];
        for (int c = 0; c < 6; c++)
            b->coefficient[c][k] = b->coefficient[c][last];
    }
}

/* Force and torque of contact k added to the record of particle i (side 0, the negative) or j (side 1). */
static inline void force_add(double *record, const struct force_batch *b, int k, int side, bool spin,
                             bool rolling) {
    force_four *force = (force_four *)record;
    const force_four *share = (const force_four *)b->force[k];
    *force = side ? *force + *share : *force - *share;
    if (!spin)
        return;
    force_four torque = *(const force_four *)b->moment[k] * b->lever[side][k];
    if (rolling)
        torque =
            side ? torque + *(const force_four *)b->rolling[k] : torque - *(const force_four *)b->rolling[k];
    force[1] += torque;
}

/* The forces of the batch added to the particles, by segment of the list. */
static inline void force_scatter(const struct force_task *task, bool spin, bool rolling) {
    const struct force_context *context = task->context;
    const struct force_batch *b = &task->thread->batch;
    const struct pair_block *block = task->block;
    size_t stride = (size_t)context->particles->force_stride;
    double *force = context->particles->force;
    uint32_t one_sided = (uint32_t)(block->one_sided - task->pair_base);
    uint32_t slotted = (uint32_t)(block->slotted - task->pair_base);
    int k = 0;
    for (; k < b->count && b->pair[k] < one_sided; k++) {
        force_add(force + b->i[k] * stride, b, k, 0, spin, rolling);
        force_add(force + b->j[k] * stride, b, k, 1, spin, rolling);
    }
    task->thread->sums.contact_sides += 2 * (size_t)b->count;
    for (; k < b->count && b->pair[k] < slotted; k++) {
        force_add(force + b->i[k] * stride, b, k, 0, spin, rolling);
        task->thread->sums.contact_sides--;
    }
    for (; k < b->count; k++) {
        size_t slot = (size_t)context->list->slot_of[b->j[k]];
        force_add(force + b->i[k] * stride, b, k, 0, spin, rolling);
        force_add(task->thread->slots + slot * stride, b, k, 1, spin, rolling);
    }
}

/* The largest overlap so far, and whose. */
static inline void force_watch(const struct force_task *task) {
    const struct force_batch *b = &task->thread->batch;
    struct force_sums *sums = &task->thread->sums;
    double largest = sums->overlap_max;
    for (int k = 0; k < b->count; k++)
        largest = b->overlap[k] > largest ? b->overlap[k] : largest;
    if (largest == sums->overlap_max)
        return;
    for (int k = 0; k < b->count; k++)
        if (b->overlap[k] == largest) {
            sums->overlap_id[0] = task->context->particles->id[b->i[k]];
            sums->overlap_id[1] = task->context->particles->id[b->j[k]];
        }
    sums->overlap_max = largest;
}

/* Energies and virial of the batch; a one-sided pair counts half. */
static void force_account(const struct force_task *task) {
    const struct force_batch *b = &task->thread->batch;
    struct force_sums *sums = &task->thread->sums;
    uint32_t one_sided = (uint32_t)(task->block->one_sided - task->pair_base);
    uint32_t slotted = (uint32_t)(task->block->slotted - task->pair_base);
    for (int k = 0; k < b->count; k++) {
        double weight = b->pair[k] >= one_sided && b->pair[k] < slotted ? 0.5 : 1.0;
        const double *d = b->record[k], *f = b->force[k];
        sums->elastic_normal += weight * b->energy[0][k];
        sums->elastic_tangential += weight * b->energy[1][k];
        sums->dissipated += weight * b->energy[2][k];
        sums->virial[0] += weight * d[0] * f[0];
        sums->virial[1] += weight * d[1] * f[1];
        sums->virial[2] += weight * d[2] * f[2];
        sums->virial[3] += weight * 0.5 * (d[0] * f[1] + d[1] * f[0]);
        sums->virial[4] += weight * 0.5 * (d[0] * f[2] + d[2] * f[0]);
        sums->virial[5] += weight * 0.5 * (d[1] * f[2] + d[2] * f[1]);
    }
}

/* Takes the first `count` candidates through gather, physics and scatter. */
static inline void force_flush(const struct force_task *task, force_physics *physics, int count) {
    struct force_thread *thread = task->thread;
    const struct law *law = task->context->law;
    int components = law->history_components;
    force_gather(task, count);
    if (components == 3)
        force_recall(task, 3);
    else if (components == 6)
        force_recall(task, 6);
    if (law->materials > 1)
        force_mix(task);
    force_pad(&thread->batch);
    physics(&thread->batch, &task->step);
    if (components == 6)
        force_scatter(task, true, true);
    else if (components == 3)
        force_scatter(task, true, false);
    else
        force_scatter(task, false, false);
    if (components == 3)
        force_remember(task, 3);
    else if (components == 6)
        force_remember(task, 6);
    force_watch(task);
    if (task->energies)
        force_account(task);
    thread->candidates -= (size_t)count;
    memmove(thread->candidate, thread->candidate + count, thread->candidates * sizeof thread->candidate[0]);
}

static void force_block(const struct force_task *task) {
    const struct pair_block *block = task->block;
    struct force_thread *thread = task->thread;
    force_physics *physics = force_physics_find(&task->context->law->options, task->energies);
    thread->candidates = 0;
    if (task->context->law->materials == 1)
        force_mix_one(&thread->batch, &task->context->law->pair[0][0]);
    for (size_t first = block->first_pair; first < block->end_pair; first += FORCE_CHUNK) {
        size_t last = first + FORCE_CHUNK < block->end_pair ? first + FORCE_CHUNK : block->end_pair;
        force_filter(task, first, last);
        while (thread->candidates >= FORCE_BATCH)
            force_flush(task, physics, FORCE_BATCH);
    }
    if (thread->candidates > 0)
        force_flush(task, physics, (int)thread->candidates);
}

const struct force_kernel FORCE_KERNEL = {FORCE_KERNEL_NAME, force_block};
