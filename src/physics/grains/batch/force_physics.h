/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics phase of the force loop: the law over a batch, once for each combination of law and flags.
 * Included by force_block.c alone, which is compiled for several instruction sets. */
#ifndef SCREE_BATCH_FORCE_PHYSICS_H
#define SCREE_BATCH_FORCE_PHYSICS_H

#include "physics/grains/batch/force_kernel.h"
#include "kernel/pairs/walk_four.h"

/* x / y, or 0 where y is 0. */
LAW_INLINE double force_ratio(double x, double y) {
    return y > 0.0 ? x / y : 0.0;
}

/* Turns the halves [from, from + 4) of four contacts' records into columns: the entries k ... k + 3 of x, y, z and w. */
LAW_INLINE void force_columns(const double (*record)[8], int from, double column[3][FORCE_BATCH],
                              double *restrict fourth, int k) {
    walk_four out[WALK_QUAD];
    walk_turn(out, *(const walk_four *)(record[k] + from), *(const walk_four *)(record[k + 1] + from),
              *(const walk_four *)(record[k + 2] + from), *(const walk_four *)(record[k + 3] + from));
    for (int c = 0; c < 3; c++)
        *(walk_four *)&column[c][k] = out[c];
    if (fourth)
        *(walk_four *)&fourth[k] = out[3];
}

/* Loop before the first: records become columns, so that the first loop reads side by side what it computes side by
 * side. `normal` holds x_j - x_i until then, `overlap` r_i + r_j, and `mass` 1/m_i + 1/m_j. */
LAW_INLINE void force_unpack(struct law_case law, struct force_batch *restrict b) {
    for (int k = 0; k < b->walk.padded; k += WALK_QUAD) {
        force_columns(b->walk.record, 0, b->normal, b->overlap, k);
        force_columns(b->walk.record, 4, b->velocity, b->mass, k);
        if (law.friction) {
            force_columns(b->walk.gathered[0], 0, b->omega[0], NULL, k);
            force_columns(b->walk.gathered[0], 4, b->omega[1], NULL, k);
        }
    }
}

/* First loop: computes the law's input for contact k from the columns. */
LAW_INLINE void force_measure(struct law_case law, struct force_batch *b, int k, struct law_step step) {
    double ri = b->walk.radius[0][k], rj = b->walk.radius[1][k], reach = b->overlap[k];
    struct law_vector d = force_vector(b->normal, k), v = force_vector(b->velocity, k);
    double distance = sqrt(law_dot(d, d)), overlap = reach - distance;
    b->overlap[k] = overlap;
    b->mass[k] = force_ratio(1.0, b->mass[k]);
    force_set(b->normal, k, law_scale(force_ratio(1.0, distance), d));
    if (law.radius)
        b->effective[k] = ri * rj / reach;
    if (!law.friction)
        return;
    struct law_vector wi = force_vector(b->omega[0], k), wj = force_vector(b->omega[1], k);
    double lever_i = law_lever(law, ri, overlap), lever_j = law_lever(law, rj, overlap);
    b->walk.lever[0][k] = lever_i;
    b->walk.lever[1][k] = lever_j;
    if (law.synchronised) {
        struct law_vector half = law_add(d, -0.5 * step.dt, v);
        double apart = sqrt(law_dot(half, half));
        force_set(b->half_normal, k, law_scale(force_ratio(1.0, apart), half));
        lever_i = law_lever(law, ri, reach - apart);
        lever_j = law_lever(law, rj, reach - apart);
    }
    force_set(b->surface, k, law_add(law_scale(lever_i, wi), lever_j, wj));
    if (law.rolling)
        force_set(b->spin, k, law_add(wj, -1.0, wi));
}

/* Second loop: the law. */
LAW_INLINE void force_respond(struct law_case law, struct force_batch *b, int k, struct law_step step) {
    struct law_contact in = {.overlap = b->overlap[k],
                             .mass = b->mass[k],
                             .normal = force_vector(b->normal, k),
                             .velocity = force_vector(b->velocity, k),
                             .coefficients = force_coefficients_of(b, k),
                             .radius = b->effective[k]};
    if (law.friction) {
        in.surface = force_vector(b->surface, k);
        in.spring = force_vector(b->walk.history, k);
    }
    if (law.synchronised)
        in.half_normal = force_vector(b->half_normal, k);
    if (law.rolling) {
        in.spin = force_vector(b->spin, k);
        in.roll = force_vector(b->walk.history + 3, k);
    }
    struct law_response out = law_respond(law, step, &in);
    force_set(b->walk.out + FORCE_OUT, k, out.force);
    if (law.energies) {
        b->energy[0][k] = out.normal_energy;
        b->energy[1][k] = out.spring_energy;
        b->energy[2][k] = out.taken;
    }
    if (!law.friction)
        return;
    force_set(b->walk.out + FORCE_MOMENT, k, out.moment);
    force_set(b->walk.history, k, out.spring);
    if (!law.rolling)
        return;
    force_set(b->walk.out + FORCE_ROLLING, k, out.rolling);
    force_set(b->walk.history + 3, k, out.roll);
}

LAW_INLINE struct law_vector force_where(bool chosen, struct law_vector v) {
    return (struct law_vector){chosen ? v.x : 0.0, chosen ? v.y : 0.0, chosen ? v.z : 0.0};
}

/* The normal direction of a law of the user's, whose springs are there: damper and energies, as law_respond has them. */
LAW_INLINE void force_damp(bool given, struct force_batch *b, int k, struct law_step step) {
    double elastic = b->springs[0][k], root = sqrt(b->mass[k] * b->springs[1][k]);
    double base = given ? b->mass[k] * b->springs[3][k] : root;
    double rate = law_dot(force_vector(b->velocity, k), force_vector(b->normal, k));
    double force = elastic - b->coefficient[FORCE_c_n][k] * base * rate;
    force = force <= step.force_least ? step.force_least : force;
    b->energy[0][k] = b->springs[4][k];
    b->energy[1][k] = 0.0;
    b->energy[2][k] = (elastic - force) * rate * step.dt;
    b->springs[0][k] = force;
    b->springs[1][k] = base;
    b->springs[3][k] = force;
    b->springs[4][k] = 1.0;
}

/* Two loops instead of one: in a single, long loop a processor could not begin a contact before all roots and
 * divisions of the previous contact are done. The bodies of the loops are functions, as variables inside an
 * `omp simd` loop would become arrays. */
LAW_INLINE void force_measure_all(struct law_case law, struct force_batch *restrict b, struct law_step step) {
    int count = b->walk.padded;
    force_unpack(law, b);
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_measure(law, b, k, step);
}

LAW_INLINE void force_respond_loop(struct law_case law, struct force_batch *restrict b,
                                   struct law_step step) {
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_respond(law, b, k, step);
}

/* A law that does not bring turned springs back to their length (LAMMPS's) needs no root and division for
 * this. A constant `rescale` lets the compiler drop both from the loop of that law. */
LAW_INLINE void force_respond_all(struct law_case law, struct force_batch *restrict b, struct law_step step) {
    if (law.friction && !law.rolling && step.rescale == 0.0) {
        step.rescale = 0.0;
        force_respond_loop(law, b, step);
    } else {
        force_respond_loop(law, b, step);
    }
}

/* The specialisations: force_measure_table[radius and lever][friction] for the geometry, force_respond_table[law][damper]
 * [energies][friction] for the laws of the table. */
#define FORCE_PHYSICS(phase, name, ...)                                                                      \
    static void name(struct force_batch *b, struct law_step step) {                                          \
        phase((struct law_case){__VA_ARGS__}, b, step);                                                      \
    }
#define FORCE_PHYSICS_FAMILY(phase, name, ...)                                                               \
    FORCE_PHYSICS(phase, name##_smooth, __VA_ARGS__)                                                         \
    FORCE_PHYSICS(phase, name##_rough, __VA_ARGS__, .friction = true)                                        \
    FORCE_PHYSICS(phase, name##_rough_half, __VA_ARGS__, .friction = true, .synchronised = true)             \
    FORCE_PHYSICS(phase, name##_rolling, __VA_ARGS__, .friction = true, .rolling = true)                     \
    FORCE_PHYSICS(phase, name##_rolling_half, __VA_ARGS__, .friction = true, .rolling = true,                \
                  .synchronised = true)
#define FORCE_PHYSICS_ROW(name)                                                                              \
    { name##_smooth, name##_rough, name##_rough_half, name##_rolling, name##_rolling_half }

FORCE_PHYSICS_FAMILY(force_measure_all, force_measure_plain, .radius = false)
FORCE_PHYSICS_FAMILY(force_measure_all, force_measure_radius, .radius = true)
FORCE_PHYSICS_FAMILY(force_measure_all, force_measure_lever, .lever_radius = true)
FORCE_PHYSICS_FAMILY(force_measure_all, force_measure_both, .radius = true, .lever_radius = true)
#define FORCE_LAW_CASES(name, ...)                                                                           \
    FORCE_PHYSICS_FAMILY(force_respond_all, force_##name, __VA_ARGS__)                                       \
    FORCE_PHYSICS_FAMILY(force_respond_all, force_##name##_energies, __VA_ARGS__, .energies = true)          \
    FORCE_PHYSICS_FAMILY(force_respond_all, force_##name##_given, __VA_ARGS__, .damping_given = true)        \
    FORCE_PHYSICS_FAMILY(force_respond_all, force_##name##_given_energies, __VA_ARGS__,                      \
                         .damping_given = true, .energies = true)
#define FORCE_LAW(NAME, name, traits, summary) FORCE_LAW_CASES(name, .normal = LAW_##NAME)
LAW_BUILT_TABLE(FORCE_LAW)

static force_physics *const force_measure_table[2][2][5] = {
    {FORCE_PHYSICS_ROW(force_measure_plain), FORCE_PHYSICS_ROW(force_measure_lever)},
    {FORCE_PHYSICS_ROW(force_measure_radius), FORCE_PHYSICS_ROW(force_measure_both)}};
#define FORCE_LAW_ROW(NAME, name, traits, summary)                                                           \
    {{FORCE_PHYSICS_ROW(force_##name), FORCE_PHYSICS_ROW(force_##name##_energies)},                          \
     {FORCE_PHYSICS_ROW(force_##name##_given), FORCE_PHYSICS_ROW(force_##name##_given_energies)}},
static force_physics *const force_respond_table[LAW_COUNT][2][2][5] = {LAW_BUILT_TABLE(FORCE_LAW_ROW)};

static inline int force_friction_of(struct law_case law) {
    return !law.friction ? 0 : 1 + 2 * law.rolling + law.synchronised;
}

static inline force_physics *force_measure_find(const struct law_options *options) {
    struct law_case law = law_case_of(options, false);
    return force_measure_table[law.radius][law.lever_radius][force_friction_of(law)];
}

static inline force_physics *force_respond_find(const struct law_options *options, bool energies) {
    struct law_case law = law_case_of(options, energies);
    return force_respond_table[law.normal][law.damping_given][energies][force_friction_of(law)];
}

#endif
