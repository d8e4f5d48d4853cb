/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of laws with parts over a batch, once for each combination of law and cohesion (law_grip.h).
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
                                                 const struct law_coefficients *c,
                                                 const struct law_sticky *sticky, double radius,
                                                 double overlap, double *past) {
    if (!law_branches(loop->normal))
        return law_springs(loop->normal, c, radius, overlap);
    struct law_extra extra = {
        .k_2 = sticky->k_2, .k_c = sticky->k_c, .plasticity_depth = sticky->plasticity_depth};
    return law_branch(loop->normal, c, &extra, radius, overlap, past);
}

LAW_INLINE struct law_grip force_grip_of(const struct force_grip *loop, const struct law_coefficients *c,
                                         const struct law_sticky *sticky, const double radius[3],
                                         double overlap, bool *held, double *past) {
    if (loop->cohesion == LAW_COHESION_JKR)
        return law_grip_jkr(c, sticky->length, sticky->surface_energy, radius[2], overlap, loop->end, held);
    double pressed = law_most(overlap, 0.0), before = *past;
    struct law_springs springs = force_grip_springs(loop, c, sticky, radius[2], pressed, past);
    struct law_pull pull = law_pull_at(loop->cohesion, sticky, radius[0], radius[1], radius[2], overlap);
    double range = law_pull_range(loop->cohesion, sticky, radius[2]);
    struct law_grip grip = law_grip_join(loop->cohesion, &springs, &pull, range, overlap, held);
    *past = grip.touches ? *past : grip.interacts ? before : 0.0;
    return grip;
}

/* What force_set_sticky has written for contact k. */
LAW_INLINE struct law_sticky force_sticky_of(const struct force_batch *restrict b, int k) {
    return (struct law_sticky){.surface_energy = b->sticky[0][k],
                               .length = b->sticky[1][k],
                               .density = b->sticky[2][k],
                               .tension = b->sticky[3][k],
                               .volume = b->sticky[4][k],
                               .volume_share = b->sticky[5][k],
                               .rupture = b->sticky[6][k],
                               .rupture_share = b->sticky[7][k],
                               .hamaker = b->sticky[8][k],
                               .gap_least = b->sticky[9][k],
                               .cut_off = b->sticky[10][k],
                               .k_2 = b->sticky[11][k],
                               .k_c = b->sticky[12][k],
                               .plasticity_depth = b->sticky[13][k]};
}

LAW_INLINE void force_grip_one(const struct force_grip *loop, struct force_batch *restrict b, int k) {
    struct law_coefficients c = {.k_n = b->coefficient[0][k], .k_t = b->coefficient[1][k]};
    struct law_sticky sticky = force_sticky_of(b, k);
    double ri = b->walk.radius[0][k], rj = b->walk.radius[1][k];
    double radius[3] = {ri, rj, isinf(rj) ? ri : ri * rj / (ri + rj)};
    double past = loop->past ? loop->past[k] : 0.0;
    bool held = loop->held && loop->held[k] != 0.0;
    struct law_grip grip = force_grip_of(loop, &c, &sticky, radius, b->overlap[k], &held, &past);
    double rate = b->velocity[0][k] * b->normal[0][k] + b->velocity[1][k] * b->normal[1][k] +
                  b->velocity[2][k] * b->normal[2][k];
    struct law_push push = law_push_of(loop->manner, &grip, b->coefficient[2][k], b->mass[k], rate);
    b->effective[k] = radius[2];
    b->springs[0][k] = push.force;
    b->springs[1][k] = push.base;
    b->springs[2][k] = grip.tangential;
    b->springs[3][k] = push.press;
    b->springs[4][k] = grip.touches ? 1.0 : 0.0;
    b->springs[5][k] = held ? 1.0 : 0.0;
    if (loop->held)
        loop->held[k] = held ? 1.0 : 0.0;
    if (loop->past)
        loop->past[k] = past;
}

LAW_INLINE void force_grip_all(enum law_normal normal, enum law_cohesion cohesion, const struct law *law,
                               struct force_batch *restrict b) {
    const bool held = law_cohesion_remembers(cohesion), past = law_branches(normal);
    const struct force_grip loop = {.normal = normal,
                                    .cohesion = cohesion,
                                    .end = law->options.jkr_end,
                                    .manner = law_manner_of(&law->options),
                                    .held = held ? b->walk.history[law->memory.held] : NULL,
                                    .past = past ? b->walk.history[law->memory.past] : NULL};
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_grip_one(&loop, b, k);
}

/* Rows: a law of the table, and a cohesion that combines with the law. */
#define FORCE_GRIP_TABLE(ROW)                                                                                \
    ROW(HOOKE, hooke, NONE, none)                                                                            \
    ROW(HOOKE, hooke, SJKR, sjkr)                                                                            \
    ROW(HOOKE, hooke, CAPILLARY, capillary)                                                                  \
    ROW(HOOKE, hooke, VAN_DER_WAALS, van_der_waals)                                                          \
    ROW(HERTZ, hertz, NONE, none)                                                                            \
    ROW(HERTZ, hertz, JKR, jkr)                                                                              \
    ROW(HERTZ, hertz, DMT, dmt)                                                                              \
    ROW(HERTZ, hertz, SJKR, sjkr)                                                                            \
    ROW(HERTZ, hertz, CAPILLARY, capillary)                                                                  \
    ROW(HERTZ, hertz, VAN_DER_WAALS, van_der_waals)                                                          \
    ROW(LUDING, luding, NONE, none)                                                                          \
    ROW(LUDING, luding, SJKR, sjkr)                                                                          \
    ROW(LUDING, luding, CAPILLARY, capillary)                                                                \
    ROW(LUDING, luding, VAN_DER_WAALS, van_der_waals)

#define FORCE_GRIP_LOOP(NAME, name, COHESION, cohesion)                                                      \
    static void force_grip_##name##_##cohesion(const struct law *law, struct force_batch *b) {               \
        force_grip_all(LAW_##NAME, LAW_COHESION_##COHESION, law, b);                                         \
    }
FORCE_GRIP_TABLE(FORCE_GRIP_LOOP)

#define FORCE_GRIP_PLACE(NAME, name, COHESION, cohesion)                                                     \
    [LAW_##NAME][LAW_COHESION_##COHESION] = force_grip_##name##_##cohesion,

/* The loop of a law; NULL: its contacts go one after another. */
static inline force_gripper *force_grip_find(const struct law_options *options) {
    static force_gripper *const table[LAW_COUNT][LAW_COHESION_COUNT] = {FORCE_GRIP_TABLE(FORCE_GRIP_PLACE)};
    return options->user ? NULL : table[options->normal][options->cohesion];
}

#endif
