/* The physics phase of the force loop: the law over a batch, once for each combination of law and flags.
 * Included by force_block.c alone, which is compiled for several instruction sets. */
#ifndef SCREE_CONTACT_FORCE_PHYSICS_H
#define SCREE_CONTACT_FORCE_PHYSICS_H

#include "contact/force_kernel.h"

/* x / y, or 0 where y is 0. */
LAW_INLINE double force_ratio(double x, double y) {
    return y > 0.0 ? x / y : 0.0;
}

/* Contact k of the batch as the law wants it. */
LAW_INLINE struct law_contact force_load(struct law_case law, const struct force_batch *b, int k,
                                         struct law_step step) {
    const double *record = b->record[k], *omega = b->omega[k];
    double ri = b->radius[0][k], rj = b->radius[1][k];
    struct law_vector d = {record[0], record[1], record[2]};
    struct law_contact in = {.velocity = {record[3], record[4], record[5]},
                             .mass = force_ratio(1.0, record[7]),
                             .coefficients = {b->coefficient[0][k], b->coefficient[1][k],
                                              b->coefficient[2][k], b->coefficient[3][k],
                                              b->coefficient[4][k], b->coefficient[5][k]}};
    double distance = sqrt(law_dot(d, d));
    in.overlap = record[6] - distance;
    in.normal = law_scale(force_ratio(1.0, distance), d);
    if (law.hertz || law.rolling)
        in.radius = ri * rj / record[6];
    if (!law.friction)
        return in;
    if (law.synchronised) {
        struct law_vector half = law_add(d, -0.5 * step.dt, in.velocity);
        in.half_normal = law_scale(force_ratio(1.0, sqrt(law_dot(half, half))), half);
    }
    double li = law_lever(law, ri, in.overlap), lj = law_lever(law, rj, in.overlap);
    in.surface = (struct law_vector){li * omega[0] + lj * omega[4], li * omega[1] + lj * omega[5],
                                     li * omega[2] + lj * omega[6]};
    in.spring = (struct law_vector){b->spring[0][k], b->spring[1][k], b->spring[2][k]};
    if (law.rolling) {
        in.spin = (struct law_vector){omega[4] - omega[0], omega[5] - omega[1], omega[6] - omega[2]};
        in.roll = (struct law_vector){b->spring[3][k], b->spring[4][k], b->spring[5][k]};
    }
    return in;
}

LAW_INLINE void force_store_vector(double out[4], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
    out[3] = 0.0;
}

LAW_INLINE void force_store(struct law_case law, struct force_batch *b, int k, const struct law_contact *in,
                            const struct law_response *out) {
    double ri = b->radius[0][k], rj = b->radius[1][k];
    b->overlap[k] = in->overlap / (ri < rj ? ri : rj);
    force_store_vector(b->force[k], out->force);
    if (law.energies) {
        b->energy[0][k] = out->normal_energy;
        b->energy[1][k] = out->spring_energy;
        b->energy[2][k] = out->dissipated;
    }
    if (!law.friction)
        return;
    force_store_vector(b->moment[k], out->moment);
    b->lever[0][k] = law_lever(law, ri, in->overlap);
    b->lever[1][k] = law_lever(law, rj, in->overlap);
    b->spring[0][k] = out->spring.x;
    b->spring[1][k] = out->spring.y;
    b->spring[2][k] = out->spring.z;
    if (law.rolling) {
        force_store_vector(b->rolling[k], out->rolling);
        b->spring[3][k] = out->roll.x;
        b->spring[4][k] = out->roll.y;
        b->spring[5][k] = out->roll.z;
    }
}

/* A function of its own, as variables inside of an `omp simd` loop would become arrays. */
LAW_INLINE void force_contact(struct law_case law, struct law_step step, struct force_batch *b, int k) {
    struct law_contact in = force_load(law, b, k, step);
    struct law_response out = law_respond(law, step, &in);
    force_store(law, b, k, &in, &out);
}

LAW_INLINE void force_physics_of(struct law_case law, struct force_batch *restrict b, struct law_step step) {
#pragma omp simd
    for (int k = 0; k < b->padded; k++)
        force_contact(law, step, b, k);
}

/* The specialisations: force_physics_table[normal and damper][friction][energies]. */
#define FORCE_PHYSICS(name, ...)                                                                             \
    static void name##_plain(struct force_batch *b, const struct law_step *step) {                           \
        force_physics_of((struct law_case){__VA_ARGS__}, b, *step);                                          \
    }                                                                                                        \
    static void name##_energies(struct force_batch *b, const struct law_step *step) {                        \
        force_physics_of((struct law_case){__VA_ARGS__, .energies = true}, b, *step);                        \
    }
#define FORCE_PHYSICS_FAMILY(name, ...)                                                                      \
    FORCE_PHYSICS(name##_smooth, __VA_ARGS__)                                                                \
    FORCE_PHYSICS(name##_rough, __VA_ARGS__, .friction = true)                                               \
    FORCE_PHYSICS(name##_rough_half, __VA_ARGS__, .friction = true, .synchronised = true)                    \
    FORCE_PHYSICS(name##_rolling, __VA_ARGS__, .friction = true, .rolling = true)                            \
    FORCE_PHYSICS(name##_rolling_half, __VA_ARGS__, .friction = true, .rolling = true, .synchronised = true)
#define FORCE_PHYSICS_ROW(name)                                                                              \
    {                                                                                                        \
        {name##_smooth_plain, name##_smooth_energies}, {name##_rough_plain, name##_rough_energies},          \
            {name##_rough_half_plain, name##_rough_half_energies},                                           \
            {name##_rolling_plain, name##_rolling_energies}, {                                               \
            name##_rolling_half_plain, name##_rolling_half_energies                                          \
        }                                                                                                    \
    }

FORCE_PHYSICS_FAMILY(force_given, .coefficient = true)
FORCE_PHYSICS_FAMILY(force_hooke, .coefficient = false)
FORCE_PHYSICS_FAMILY(force_hertz, .hertz = true)

static force_physics *const force_physics_table[3][5][2] = {
    FORCE_PHYSICS_ROW(force_given), FORCE_PHYSICS_ROW(force_hooke), FORCE_PHYSICS_ROW(force_hertz)};

static inline force_physics *force_physics_find(const struct law_options *options, bool energies) {
    struct law_case law = law_case_of(options, energies);
    int normal = law.hertz ? 2 : law.coefficient ? 0 : 1;
    int friction = !law.friction ? 0 : 1 + 2 * law.rolling + law.synchronised;
    return force_physics_table[normal][friction][energies];
}

#endif
