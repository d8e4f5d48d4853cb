/* One block of the pair list through the force loop: filter, gather, physics, scatter (force_kernel.h).
 * Compiled once for each instruction set, under the name that FORCE_KERNEL gives. */
#include "contact/force_account.h"
#include "contact/force_four.h"
#include "contact/force_kernel.h"
#include "contact/force_physics.h"
#include <string.h>

/* Half a record of a particle: x y z radius, and vx vy vz 1/mass. */
#define FORCE_HALF(state, half) (*(const force_four *)((const double *)(state) + 4 * (half)))

/* What the loops over pairs read, side by side: a compiler must assume that their stores change what lies
 * behind pointers. */
struct force_view {
    const struct particle_state *state;
    const double (*omega)[4]; /* NULL without spin */
    const double *force;      /* only to fetch it ahead of the scatter */
    size_t stride;            /* doubles of a force record */
    const uint32_t *i, *j;    /* from the first pair of the block on */
    const double (*shift)[4];
    bool prescribed; /* there are particles whose motion is prescribed */
};

static inline struct force_view force_view_of(const struct force_task *task) {
    const struct particles *particles = task->context->particles;
    const struct pairlist *list = task->context->list;
    return (struct force_view){.state = particles->state,
                               .omega = task->context->law->spin ? particles->omega : NULL,
                               .force = particles->force,
                               .stride = (size_t)particles->force_stride,
                               .i = list->i + task->block->first_pair,
                               .j = list->j + task->block->first_pair,
                               .shift = list->shift,
                               .prescribed = particles->group != NULL};
}

/* What a pair is to the law: half 0 gives x_j - x_i and r_i + r_j, half 1 v_j - v_i and 1/m_i + 1/m_j. */
static inline force_four force_between(const struct particle_state *i, const struct particle_state *j,
                                       int half) {
    const force_four sign = {-1.0, -1.0, -1.0, 1.0};
    return FORCE_HALF(j, half) + FORCE_HALF(i, half) * sign;
}

/* Which of four pairs touch, one bit each. */
static inline unsigned force_touching(const struct force_view view, const uint32_t i[FORCE_QUAD],
                                      const uint32_t j[FORCE_QUAD]) {
    force_four between[FORCE_QUAD], row[FORCE_QUAD];
    for (int k = 0; k < FORCE_QUAD; k++)
        between[k] = force_between(&view.state[i[k]], &view.state[pair_partner(j[k])], 0) +
                     *(const force_four *)view.shift[pair_image(j[k])];
    force_turn(row, between[0], between[1], between[2], between[3]);
    return force_bits(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] < row[3] * row[3]);
}

/* Separations of the block's pairs [first, last) against the sum of radii; appends those that touch. */
static inline void force_filter(const struct force_view view, struct force_thread *restrict thread,
                                size_t first, size_t last) {
    uint32_t *out = thread->candidate + thread->candidates;
    size_t k = first;
    for (; k + FORCE_QUAD <= last; k += FORCE_QUAD) {
        for (size_t lane = 0; lane < FORCE_QUAD; lane++)
            __builtin_prefetch(&view.state[pair_partner(view.j[k + lane + FORCE_AHEAD])]);
        out = force_append(out, k, force_touching(view, view.i + k, view.j + k));
    }
    if (k < last) {
        uint32_t i[FORCE_QUAD], j[FORCE_QUAD];
        for (size_t lane = 0; lane < FORCE_QUAD; lane++) {
            i[lane] = view.i[k + lane < last ? k + lane : k];
            j[lane] = view.j[k + lane < last ? k + lane : k];
        }
        out = force_append(out, k, force_touching(view, i, j) & ((1u << (last - k)) - 1));
    }
    thread->candidates = (size_t)(out - thread->candidate);
}

/* True of two particles that are both prescribed and move and turn alike: what they overlap by stays, and is
 * no contact. */
static inline bool force_fixed(const struct force_batch *restrict b, int k, bool spin) {
    const double *record = b->record[k], *omega = b->omega[k];
    if (record[7] != 0.0 || record[4] != 0.0 || record[5] != 0.0 || record[6] != 0.0)
        return false;
    return !spin || (omega[0] == omega[4] && omega[1] == omega[5] && omega[2] == omega[6]);
}

/* Takes contacts of particles that are fixed to each other out of the batch. */
static __attribute__((noinline)) void force_drop_fixed(struct force_batch *restrict b, bool spin) {
    int kept = 0;
    while (kept < b->count && !force_fixed(b, kept, spin))
        kept++;
    for (int k = kept + 1; k < b->count; k++) {
        if (force_fixed(b, k, spin))
            continue;
        memcpy(b->record[kept], b->record[k], sizeof b->record[k]);
        memcpy(b->omega[kept], b->omega[k], sizeof b->omega[k]);
        b->i[kept] = b->i[k];
        b->j[kept] = b->j[k];
        b->pair[kept] = b->pair[k];
        b->radius[0][kept] = b->radius[0][k];
        b->radius[1][kept] = b->radius[1][k];
        kept++;
    }
    b->count = kept;
}

/* Fills the batch with the first `count` candidates; `offset` is the number of the block's first pair in the
 * thread. */
static inline void force_gather(const struct force_view view, struct force_thread *restrict thread, int count,
                                uint32_t offset) {
    struct force_batch *restrict b = &thread->batch;
    for (int k = 0; view.omega && k < count; k++)
        __builtin_prefetch(view.omega[pair_partner(view.j[thread->candidate[k]])]);
    for (int k = 0; k < count; k++) {
        uint32_t pair = thread->candidate[k], i = view.i[pair], code = view.j[pair], j = pair_partner(code);
        const struct particle_state *si = &view.state[i], *sj = &view.state[j];
        __builtin_prefetch(view.force + i * view.stride, 1);
        __builtin_prefetch(view.force + j * view.stride, 1);
        b->i[k] = i;
        b->j[k] = j;
        b->pair[k] = pair + offset;
        b->radius[0][k] = si->radius;
        b->radius[1][k] = sj->radius;
        *(force_four *)b->record[k] =
            force_between(si, sj, 0) + *(const force_four *)view.shift[pair_image(code)];
        *(force_four *)(b->record[k] + 4) = force_between(si, sj, 1);
        if (view.omega) {
            *(force_four *)b->omega[k] = *(const force_four *)view.omega[i];
            *(force_four *)(b->omega[k] + 4) = *(const force_four *)view.omega[j];
        }
    }
    b->count = count;
    if (view.prescribed)
        force_drop_fixed(b, view.omega != NULL);
    b->padded = (b->count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
}

/* The springs of the batch where each of its contacts has one: records lie side by side. Reads up to a record
 * of padding at a time. */
static inline void force_recall_run(struct force_batch *restrict b, const double *restrict value,
                                    int components) {
    for (int k = 0; k < b->count; k += FORCE_QUAD)
        for (int c = 0; c < components; c += 3) {
            const double *from = value + k * components + c;
            force_four out[FORCE_QUAD];
            force_turn(out, *(const force_four *)from, *(const force_four *)(from + components),
                       *(const force_four *)(from + 2 * components),
                       *(const force_four *)(from + 3 * components));
            for (int row = 0; row < 3; row++)
                *(force_four *)&b->spring[c + row][k] = out[row];
        }
}

/* Finds the old springs of the batch's contacts: both run in the order of the pairs. Most often no contact
 * has come or gone. */
static inline void force_recall(const struct history_part old, struct force_thread *restrict thread,
                                int components) {
    struct force_batch *restrict b = &thread->batch;
    size_t cursor = thread->cursor, count = (size_t)b->count;
    while (cursor < old.count && old.pair[cursor] < b->pair[0])
        cursor++;
    if (cursor + count <= old.count && memcmp(old.pair + cursor, b->pair, count * sizeof *b->pair) == 0) {
        force_recall_run(b, old.value + cursor * (size_t)components, components);
        thread->cursor = cursor + count;
        return;
    }
    for (size_t k = 0; k < count; k++) {
        uint32_t pair = b->pair[k];
        while (cursor < old.count && old.pair[cursor] < pair)
            cursor++;
        bool known = cursor < old.count && old.pair[cursor] == pair;
        const double *value = old.value + cursor * (size_t)components;
        for (int c = 0; c < components; c++)
            b->spring[c][k] = known ? value[c] : 0.0;
    }
    thread->cursor = cursor;
}

/* Appends the new springs of the batch to the other buffer. Each store of three components spills into the
 * next, which is written after it: at the end, into the padding. */
static inline void force_remember(struct history_part *new, const struct force_batch *restrict b,
                                  int components) {
    double *restrict value = new->value + new->count *(size_t)components;
    memcpy(new->pair + new->count, b->pair, (size_t)b->count * sizeof *b->pair);
    for (int k = 0; k < b->count; k += FORCE_QUAD) {
        force_four half[2][FORCE_QUAD];
        for (int c = 0; c < components; c += 3) {
            force_four z = *(const force_four *)&b->spring[c + 2][k];
            force_turn(half[c / 3], *(const force_four *)&b->spring[c][k],
                       *(const force_four *)&b->spring[c + 1][k], z, z);
        }
        for (int m = 0; m < FORCE_QUAD; m++)
            for (int c = 0; c < components; c += 3)
                *(force_four *)(value + (k + m) * components + c) = half[c / 3][m];
    }
    new->count += (size_t)b->count;
}

/* Coefficients of each contact, where they differ between materials. */
static inline void force_mix(const struct force_task *task) {
    const struct law *law = task->context->law;
    const uint8_t *material = task->context->particles->material;
    struct force_batch *restrict b = &task->thread->batch;
    for (int k = 0; k < b->count; k++)
        force_set_coefficients(b, k, &law->pair[material[b->i[k]]][material[b->j[k]]]);
}

/* The same coefficients for all. */
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

/* Turns three components of the batch's contacts into records x y z 0 at share[k] + offset. */
static inline void force_transpose(struct force_batch *restrict b, double component[3][FORCE_BATCH],
                                   int offset) {
    const force_four zero = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < b->padded; k += FORCE_QUAD) {
        force_four out[FORCE_QUAD];
        force_turn(out, *(const force_four *)&component[0][k], *(const force_four *)&component[1][k],
                   *(const force_four *)&component[2][k], zero);
        for (int m = 0; m < FORCE_QUAD; m++)
            *(force_four *)(b->share[k + m] + offset) = out[m];
    }
}

/* Force and torque of contact k added to the record of particle i (side 0, the negative) or j (side 1). */
static inline void force_add(double *record, const struct force_batch *restrict b, int k, int side,
                             int components) {
    const force_four *share = (const force_four *)b->share[k];
    force_four *sum = (force_four *)record;
    sum[0] = side ? sum[0] + share[0] : sum[0] - share[0];
    if (components == 0)
        return;
    force_four torque = share[1] * b->lever[side][k];
    if (components == 6)
        torque = side ? torque + share[2] : torque - share[2];
    sum[1] += torque;
}

/* Writes down what contact k gives to i (side 0) or j (side 1), as entry `at`. */
static inline __attribute__((always_inline)) void force_enter(const struct force_task *task,
                                                              const struct force_ledger ledger, size_t at,
                                                              int k, int side, int components) {
    const struct force_batch *b = &task->thread->batch;
    const size_t stride = components ? 8 : (size_t)task->context->particles->force_stride;
    const int64_t *id = task->context->particles->id;
    unsigned image = pair_image(task->context->list->j[b->pair[k] + task->pair_base]);
    double share[8] __attribute__((aligned(32))) = {0.0};
    force_add(share, b, k, side, components);
    ledger.particle[at] = side ? b->j[k] : b->i[k];
    ledger.source[at] =
        (struct force_source){id[side ? b->i[k] : b->j[k]], side ? image_opposite(image) : image};
    memcpy(ledger.share + at * stride, share, stride * sizeof *share);
}

/* The forces of the batch written down, to be summed in order. One-sided: others have the other side. */
static __attribute__((noinline)) void force_record(const struct force_task *task, int both, int one,
                                                   int components) {
    struct force_ledger *ledger = task->thread->ledger;
    size_t at = ledger->count, count = (size_t)task->thread->batch.count;
    force_ledger_reserve(ledger, at + 2 * count, (size_t)task->context->particles->force_stride);
    for (int k = 0; k < (int)count; k++) {
        force_enter(task, *ledger, at++, k, 0, components);
        if (k < both || k >= one)
            force_enter(task, *ledger, at++, k, 1, components);
    }
    ledger->count = at;
}

/* The forces of the batch added to the particles, by segment of the list. */
static inline void force_scatter(const struct force_task *task, int components) {
    const struct particles *particles = task->context->particles;
    struct force_thread *thread = task->thread;
    const struct force_batch *restrict b = &thread->batch;
    const int32_t *slot_of = task->context->list->slot_of;
    const size_t stride = components ? 8 : (size_t)particles->force_stride;
    double *force = particles->force, *slots = thread->slots;
    int both = force_before(task, task->block->one_sided), one = force_before(task, task->block->slotted);
    int count = b->count;
    force_transpose(&thread->batch, thread->batch.force, 0);
    if (components >= 3)
        force_transpose(&thread->batch, thread->batch.moment, 4);
    if (components == 6)
        force_transpose(&thread->batch, thread->batch.rolling, 8);
    thread->sums.contact_sides += 2 * (size_t)count - (size_t)(one - both);
    if (thread->ledger) {
        force_record(task, both, one, components);
        return;
    }
    for (int k = 0; k < both; k++) {
        force_add(force + b->i[k] * stride, b, k, 0, components);
        force_add(force + b->j[k] * stride, b, k, 1, components);
    }
    for (int k = both; k < count; k++)
        force_add(force + b->i[k] * stride, b, k, 0, components);
    for (int k = one; k < count; k++)
        force_add(slots + (size_t)slot_of[b->j[k]] * stride, b, k, 1, components);
}

/* The loops that this law needs. */
struct force_phases {
    force_physics *measure, *respond;
};

/* Takes the batch through physics and scatter. */
static inline void force_evaluate(const struct force_task *task, const struct force_phases *phases,
                                  int components) {
    struct force_thread *thread = task->thread;
    if (components)
        force_recall(*task->old, thread, components);
    if (!task->context->law->uniform)
        force_mix(task);
    force_pad(&thread->batch);
    phases->measure(&thread->batch, task->step);
    phases->respond(&thread->batch, task->step);
    force_scatter(task, components);
    if (components)
        force_remember(task->new, &thread->batch, components);
    force_watch(task);
    force_sum(task);
}

/* Takes the first `count` candidates out, through a batch. */
static inline void force_flush(const struct force_task *task, const struct force_view view,
                               const struct force_phases *phases, int count, int components) {
    struct force_thread *thread = task->thread;
    force_gather(view, thread, count, (uint32_t)(task->block->first_pair - task->pair_base));
    if (thread->batch.count > 0)
        force_evaluate(task, phases, components);
    thread->candidates -= (size_t)count;
    memmove(thread->candidate, thread->candidate + count, thread->candidates * sizeof thread->candidate[0]);
}

/* The block with a constant number of history components. */
static inline __attribute__((always_inline)) void force_sweep(const struct force_task *task, int components) {
    const struct force_view view = force_view_of(task);
    struct force_thread *thread = task->thread;
    const struct law_options *options = &task->context->law->options;
    const struct force_phases phases = {force_measure_find(options),
                                        force_respond_find(options, task->energies)};
    size_t pairs = task->block->end_pair - task->block->first_pair;
    thread->candidates = 0;
    for (size_t first = 0; first < pairs; first += FORCE_CHUNK) {
        force_filter(view, thread, first, first + FORCE_CHUNK < pairs ? first + FORCE_CHUNK : pairs);
        while (thread->candidates >= FORCE_BATCH)
            force_flush(task, view, &phases, FORCE_BATCH, components);
    }
    if (thread->candidates > 0)
        force_flush(task, view, &phases, (int)thread->candidates, components);
}

static void force_block(const struct force_task *task) {
    const struct law *law = task->context->law;
    if (law->uniform)
        force_mix_one(&task->thread->batch, &law->pair[0][0]);
    if (law->history_components == 6)
        force_sweep(task, 6);
    else if (law->history_components == 3)
        force_sweep(task, 3);
    else
        force_sweep(task, 0);
}

static void force_answer(const struct law_options *options, bool energies, struct force_batch *batch,
                         struct law_step step) {
    batch->padded = (batch->count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
    force_respond_find(options, energies)(batch, step);
}

const struct force_kernel FORCE_KERNEL = {FORCE_KERNEL_NAME, force_block, force_answer};
