/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of laws with parts over a batch, once for each combination of law and cohesion (law_parts.h).
 * Included by force_block.c alone, which is compiled for several instruction sets. The same bits as law_general_push. */
#ifndef SCREE_BATCH_FORCE_GRIP_H
#define SCREE_BATCH_FORCE_GRIP_H

#include "physics/grains/batch/force_kernel.h"
#include "physics/grains/laws/law_general.h"

/* A loop: law and cohesion are constants. `held`, `past`: what the contacts remember; NULL: nothing. */
struct force_grip {
    enum law_normal normal;
    enum law_cohesion cohesion;
    enum law_jkr_end end;
    struct law_manner manner;
    double *held, *past;
};

/* The springs of a law, and the new `past`. */
LAW_INLINE struct law_springs force_grip_springs(const struct force_grip *loop,
                                                 const struct force_batch *restrict b, int k,
                                                 const struct law_coefficients *c, double radius,
                                                 double overlap, double *past) {
    if (!law_branches(loop->normal))
        return law_springs(loop->normal, c, radius, overlap);
#define TAKE(member) .member = b->branch[LAW_BRANCH_##member][k],
    struct law_extra extra = {LAW_BRANCH_NUMBERS(TAKE)};
#undef TAKE
    return law_branch(loop->normal, c, &extra, radius, overlap, past);
}

/* The attraction of a cohesion that pulls beside the springs, and how far it acts. */
LAW_INLINE struct law_pull force_grip_pull(const struct force_grip *loop,
                                           const struct force_batch *restrict b, int k,
                                           const struct law_radii *radii, double *range) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (loop->cohesion == LAW_COHESION_##NAME) {                                                             \
        const struct cohesion_##name p = force_##name##_of(b, k);                                            \
        *range = cohesion_##name##_range(&p, radii->effective);                                              \
        return cohesion_##name##_pull(&p, radii, b->overlap[k]);                                             \
    }
    LAW_PULL_TABLE(CASE)
#undef CASE
    *range = 0.0;
    return (struct law_pull){0};
}

LAW_INLINE struct law_grip force_grip_of(const struct force_grip *loop, const struct force_batch *restrict b,
                                         int k, const struct law_radii *radii, bool *held, double *past) {
    const struct law_coefficients c = {.k_n = b->coefficient[FORCE_k_n][k],
                                       .k_t = b->coefficient[FORCE_k_t][k]};
#define CASE(NAME, name, with, summary)                                                                      \
    if (loop->cohesion == LAW_COHESION_##NAME) {                                                             \
        const struct cohesion_##name p = force_##name##_of(b, k);                                            \
        return cohesion_##name##_grip(&p, &c, radii->effective, b->overlap[k], loop->end, held);             \
    }
    LAW_ADHESION_TABLE(CASE)
#undef CASE
    double overlap = b->overlap[k], pressed = law_most(overlap, 0.0), before = *past, range;
    struct law_springs springs = force_grip_springs(loop, b, k, &c, radii->effective, pressed, past);
    struct law_pull pull = force_grip_pull(loop, b, k, radii, &range);
    struct law_grip grip = law_grip_join(loop->cohesion, &springs, &pull, range, overlap, held);
    *past = grip.touches ? *past : grip.interacts ? before : 0.0;
    return grip;
}

LAW_INLINE void force_grip_one(const struct force_grip *loop, struct force_batch *restrict b, int k) {
    double ri = b->walk.radius[0][k], rj = b->walk.radius[1][k];
    const struct law_radii radii = {ri, rj, isinf(rj) ? ri : ri * rj / (ri + rj)};
    const bool remembers = law_cohesion_form_of(loop->cohesion)->remembers,
               flows = law_branches(loop->normal);
    double past = flows ? loop->past[k] : 0.0;
    bool held = remembers && loop->held[k] != 0.0;
    struct law_grip grip = force_grip_of(loop, b, k, &radii, &held, &past);
    double rate = b->velocity[0][k] * b->normal[0][k] + b->velocity[1][k] * b->normal[1][k] +
                  b->velocity[2][k] * b->normal[2][k];
    struct law_push push = law_push_of(loop->manner, &grip, b->coefficient[FORCE_c_n][k], b->mass[k], rate);
    b->effective[k] = radii.effective;
    b->springs[0][k] = push.force;
    b->springs[1][k] = push.base;
    b->springs[2][k] = grip.tangential;
    b->springs[3][k] = push.press;
    b->springs[4][k] = grip.touches ? 1.0 : 0.0;
    b->springs[5][k] = held ? 1.0 : 0.0;
    if (law_adheres(loop->cohesion))
        b->springs[6][k] = grip.a;
    b->springs[7][k] = grip.spring;
    if (remembers)
        loop->held[k] = held ? 1.0 : 0.0;
    if (flows)
        loop->past[k] = past;
}

LAW_INLINE void force_grip_all(enum law_normal normal, enum law_cohesion cohesion, const struct law *law,
                               struct force_batch *restrict b) {
    const bool held = law_cohesion_form_of(cohesion)->remembers, past = law_branches(normal);
    const struct force_grip loop = {.normal = normal,
                                    .cohesion = cohesion,
                                    .end = law->options.jkr_end,
                                    .manner = law_manner_of(&law->options, cohesion),
                                    .held = held ? b->walk.history[law->memory.held] : NULL,
                                    .past = past ? b->walk.history[law->memory.past] : NULL};
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_grip_one(&loop, b, k);
}

/* The laws that have loops, with a cohesion that pulls beside the springs. */
#define FORCE_GRIP_LAWS(ROW, COHESION, cohesion)                                                             \
    ROW(HOOKE, hooke, COHESION, cohesion)                                                                    \
    ROW(HERTZ, hertz, COHESION, cohesion)                                                                    \
    ROW(LUDING, luding, COHESION, cohesion)

#define FORCE_GRIP_LOOP(NAME, name, COHESION, cohesion)                                                      \
    static void force_grip_##name##_##cohesion(const struct law *law, struct law_step step,                  \
                                               struct force_batch *b) {                                      \
        (void)step;                                                                                          \
        force_grip_all(LAW_##NAME, LAW_COHESION_##COHESION, law, b);                                         \
    }
#define FORCE_GRIP_LOOPS(NAME, name, with, summary) FORCE_GRIP_LAWS(FORCE_GRIP_LOOP, NAME, name)
/* An adhesion is of elastic spheres */
#define FORCE_GRIP_ADHESION(NAME, name, with, summary) FORCE_GRIP_LOOP(HERTZ, hertz, NAME, name)
FORCE_GRIP_LOOPS(NONE, none, , )
LAW_PULL_TABLE(FORCE_GRIP_LOOPS)
LAW_ADHESION_TABLE(FORCE_GRIP_ADHESION)

#define FORCE_GRIP_PLACE(NAME, name, COHESION, cohesion)                                                     \
    [LAW_##NAME][LAW_COHESION_##COHESION] = force_grip_##name##_##cohesion,
#define FORCE_GRIP_ADHESION_PLACE(NAME, name, with, summary) FORCE_GRIP_PLACE(HERTZ, hertz, NAME, name)
#define FORCE_GRIP_PLACES(NAME, name, with, summary) FORCE_GRIP_LAWS(FORCE_GRIP_PLACE, NAME, name)

/* The loop of a law; NULL: its contacts go one after another. */
static inline force_pusher *force_grip_find(const struct law_options *options) {
    static force_pusher *const table[LAW_COUNT][LAW_COHESION_COUNT] = {FORCE_GRIP_PLACES(
        NONE, none, , ) LAW_PULL_TABLE(FORCE_GRIP_PLACES) LAW_ADHESION_TABLE(FORCE_GRIP_ADHESION_PLACE)};
    return options->user ? NULL : table[options->normal][options->cohesion];
}

#endif
