/* SPDX-License-Identifier: BSD-3-Clause */
/* Sliding, rolling and twisting over a batch, behind a push of the normal direction: a loop each, once for each kind of the part (law_parts.h). Included by force_block.c alone, which is compiled for several instruction sets. The same bits as
 * law_resist. A law whose contacts stick by a static friction, and pair_style granular of LAMMPS, have no loops. */
#ifndef SCREE_BATCH_FORCE_RESIST_H
#define SCREE_BATCH_FORCE_RESIST_H

#include "physics/grains/batch/force_kernel.h"
#include "physics/grains/batch/force_physics.h"
#include "physics/grains/laws/law_resist.h"

/* What the loops take of a contact, except its springs. */
LAW_INLINE struct law_contact force_resist_in(struct law_case law, struct force_batch *restrict b, int k) {
    struct law_contact in = {.normal = force_vector(b->normal, k),
                             .velocity = force_vector(b->velocity, k),
                             .coefficients = force_coefficients_of(b, k),
                             .mass = b->mass[k],
                             .radius = b->effective[k],
                             .surface = force_vector(b->surface, k),
                             .spin = force_vector(b->spin, k)};
    if (law.synchronised)
        in.half_normal = force_vector(b->half_normal, k);
    return in;
}

LAW_INLINE struct law_vector force_plane(struct law_case law, const struct law_contact *in) {
    return law.synchronised ? in->half_normal : in->normal;
}

/* The energies so far, and those with what a loop has added, if the surfaces touch. */
LAW_INLINE struct law_response force_energies(struct law_case law, const struct force_batch *restrict b,
                                              int k) {
    struct law_response out = {0};
    if (law.energies) {
        out.spring_energy = b->energy[1][k];
        out.taken = b->energy[2][k];
    }
    return out;
}

LAW_INLINE void force_put_energies(struct law_case law, struct force_batch *restrict b, int k, bool touches,
                                   const struct law_response *out) {
    if (!law.energies)
        return;
    b->energy[1][k] = touches ? out->spring_energy : b->energy[1][k];
    b->energy[2][k] = touches ? out->taken : b->energy[2][k];
}

/* Fills in the contact radii of elastic spheres, where the push has not written them. */
LAW_INLINE void force_necks(const struct law *law, struct force_batch *restrict b) {
    if (law_grip_radius_recalls(law))
        return;
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        b->springs[6][k] = sqrt(b->effective[k] * law_most(b->overlap[k], 0.0));
}

LAW_INLINE void force_slide_one(struct law_case law, enum law_tangential kind, double *past,
                                struct force_batch *restrict b, int k, struct law_step step) {
    struct law_vector push = law_scale(b->springs[0][k], force_vector(b->normal, k));
    if (kind == LAW_TANGENTIAL_NONE) {
        force_set(b->walk.out + FORCE_OUT, k, push);
        return;
    }
    const struct law_contact in = force_resist_in(law, b, k);
    struct law_response out = force_energies(law, b, k);
    struct law_vector rate = law_slip_rate(&in, force_plane(law, &in)), force;
    double stiffness = b->springs[2][k], damping = in.coefficients.c_t * b->springs[1][k],
           limit = in.coefficients.friction * b->springs[3][k];
    bool touches = b->springs[4][k] > 0.0;
    if (kind == LAW_TANGENTIAL_VISCOUS) {
        force = law_dash(step, rate, damping, limit, &out);
    } else {
        double a = law_rescales(kind) ? b->springs[6][k] : 0.0;
        double before = law_rescales(kind) ? past[k] : 0.0;
        struct law_vector spring =
            law_scale(law_spring_factor(kind, a, before, stiffness), force_vector(b->walk.history, k));
        force = law_slide(law, step, &in, rate, &spring, stiffness, damping, limit, &out);
        spring = law_scale(law_keeps_force(kind) ? stiffness : 1.0, spring);
        force_set(b->walk.history, k, force_where(touches, spring));
        if (law_rescales(kind))
            past[k] = touches ? (step.dt > 0.0 ? a : before) : 0.0;
    }
    force_set(b->walk.out + FORCE_OUT, k, law_add(push, 1.0, force_where(touches, force)));
    force_set(b->walk.out + FORCE_MOMENT, k, force_where(touches, law_cross(force, in.normal)));
    force_set(b->walk.out + FORCE_ROLLING, k, (struct law_vector){0.0, 0.0, 0.0});
    force_put_energies(law, b, k, touches, &out);
}

LAW_INLINE void force_slide_all(struct law_case law_is, enum law_tangential kind, const struct law *law,
                                struct law_step step, struct force_batch *restrict b) {
    if (law_rescales(kind))
        force_necks(law, b);
    double *past = law_rescales(kind) ? b->walk.history[law->memory.radius] : NULL;
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_slide_one(law_is, kind, past, b, k, step);
}

/* Contact k as resistances to rolling and twisting see it; `grip` has what they read. */
LAW_INLINE struct law_touch force_touch(const struct force_batch *restrict b, int k,
                                        const struct law_contact *in, const struct law_grip *grip) {
    return (struct law_touch){.c = &in->coefficients,
                              .radii = {b->walk.radius[0][k], b->walk.radius[1][k], in->radius},
                              .grip = grip,
                              .base = b->springs[1][k],
                              .mass = in->mass};
}

#define FORCE_ROLLING_TAKE(part, member, ...)                                                                \
    .member = b->rolling[offsetof(struct rolling_##part##_given, member) / sizeof(double)][k],
#define FORCE_TWISTING_TAKE(part, member, ...)                                                               \
    .member = b->twisting[offsetof(struct twisting_##part##_given, member) / sizeof(double)][k],

LAW_INLINE struct law_resistance force_rolling_of(enum law_rolling kind, const struct force_batch *restrict b,
                                                  int k, const struct law_contact *in) {
    const struct law_grip grip = {.tangential = b->springs[2][k], .spring = b->springs[7][k]};
    const struct law_touch touch = force_touch(b, k, in, &grip);
#define CASE(NAME, name, with, summary)                                                                      \
    if (kind == LAW_ROLLING_##NAME) {                                                                        \
        const struct rolling_##name##_given given = {ROLLING_##NAME##_KEYS(FORCE_ROLLING_TAKE)};             \
        return rolling_##name##_resist(&given, &touch);                                                      \
    }
    LAW_ROLLING_PARTS(CASE)
#undef CASE
    return (struct law_resistance){0};
}

/* `past`: the springs. */
LAW_INLINE void force_roll_one(struct law_case law, enum law_rolling kind, double past[3][FORCE_BATCH],
                               struct force_batch *restrict b, int k, struct law_step step) {
    const struct law_contact in = force_resist_in(law, b, k);
    const struct law_rolling_form *form = law_rolling_form_of(kind);
    struct law_response out = force_energies(law, b, k);
    struct law_vector rate = law_scale(in.radius, law_project(in.spin, force_plane(law, &in))), force;
    double limit = in.coefficients.rolling_friction * b->springs[3][k];
    bool touches = b->springs[4][k] > 0.0;
    if (form->spring) {
        struct law_vector spring = force_vector(past, k);
        force = law_roll(law, step, &in, rate, &spring, form->rests, force_rolling_of(kind, b, k, &in), limit,
                         &out);
        force_set(past, k, force_where(touches, spring));
    } else {
        force = law_dash(step, rate, INFINITY, limit, &out);
    }
    struct law_vector torque = force_vector(b->walk.out + FORCE_ROLLING, k);
    force_set(b->walk.out + FORCE_ROLLING, k, law_add(torque, in.radius, force_where(touches, force)));
    force_put_energies(law, b, k, touches, &out);
}

LAW_INLINE void force_roll_all(struct law_case law_is, enum law_rolling kind, const struct law *law,
                               struct law_step step, struct force_batch *restrict b) {
    double(*past)[FORCE_BATCH] =
        law_rolling_form_of(kind)->spring ? b->walk.history + law->memory.roll : NULL;
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_roll_one(law_is, kind, past, b, k, step);
}

LAW_INLINE struct law_resistance force_twisting_of(enum law_twisting kind,
                                                   const struct force_batch *restrict b, int k,
                                                   const struct law_contact *in) {
    const struct law_grip grip = {.tangential = b->springs[2][k], .a = b->springs[6][k]};
    const struct law_touch touch = force_touch(b, k, in, &grip);
#define CASE(NAME, name, with, summary)                                                                      \
    if (kind == LAW_TWISTING_##NAME) {                                                                       \
        const struct twisting_##name##_given given = {TWISTING_##NAME##_KEYS(FORCE_TWISTING_TAKE)};          \
        return twisting_##name##_resist(&given, &touch);                                                     \
    }
    LAW_TWISTING_PARTS(CASE)
#undef CASE
    return (struct law_resistance){0};
}

LAW_INLINE void force_twist_one(struct law_case law, enum law_twisting kind, double *past,
                                struct force_batch *restrict b, int k, struct law_step step) {
    const struct law_contact in = force_resist_in(law, b, k);
    struct law_response out = force_energies(law, b, k);
    struct law_resistance twisting = force_twisting_of(kind, b, k, &in);
    bool touches = b->springs[4][k] > 0.0;
    double angle = past[k];
    double torque = law_twist(step, law_dot(in.spin, in.normal), &angle, twisting,
                              twisting.limit * b->springs[3][k], false, &out);
    struct law_vector before = force_vector(b->walk.out + FORCE_ROLLING, k);
    past[k] = touches ? angle : 0.0;
    force_set(b->walk.out + FORCE_ROLLING, k, law_add(before, touches ? torque : 0.0, in.normal));
    force_put_energies(law, b, k, touches, &out);
}

LAW_INLINE void force_twist_all(struct law_case law_is, enum law_twisting kind, const struct law *law,
                                struct law_step step, struct force_batch *restrict b) {
    force_necks(law, b);
    double *past = b->walk.history[law->memory.twist];
    int count = b->walk.padded;
#pragma omp simd
    for (int k = 0; k < count; k++)
        force_twist_one(law_is, kind, past, b, k, step);
}

/* The loops of a part: in the plane of the full step and of the half step, without and with energies. */
#define FORCE_RESIST_LOOP(what, kind, loop, ...)                                                             \
    static void loop(const struct law *law, struct law_step step, struct force_batch *b) {                   \
        force_##what##_all((struct law_case){.friction = true, __VA_ARGS__}, kind, law, step, b);            \
    }
#define FORCE_RESIST_LOOPS(what, kind, loop)                                                                 \
    FORCE_RESIST_LOOP(what, kind, loop, .energies = false)                                                   \
    FORCE_RESIST_LOOP(what, kind, loop##_energies, .energies = true)                                         \
    FORCE_RESIST_LOOP(what, kind, loop##_half, .synchronised = true)                                         \
    FORCE_RESIST_LOOP(what, kind, loop##_half_energies, .synchronised = true, .energies = true)
#define FORCE_RESIST_ROW(loop)                                                                               \
    {                                                                                                        \
        {loop, loop##_energies}, {                                                                           \
            loop##_half, loop##_half_energies                                                                \
        }                                                                                                    \
    }

#define FORCE_SLIDES(ROW)                                                                                    \
    ROW(NONE, none)                                                                                          \
    ROW(HISTORY, history)                                                                                    \
    ROW(RESCALE, rescale) ROW(FORCE, force) ROW(RESCALE_FORCE, rescale_force) ROW(VISCOUS, viscous)
#define FORCE_SLIDE_LOOPS(NAME, name) FORCE_RESIST_LOOPS(slide, LAW_TANGENTIAL_##NAME, force_slide_##name)
#define FORCE_ROLL_LOOPS(NAME, name, with, summary)                                                          \
    FORCE_RESIST_LOOPS(roll, LAW_ROLLING_##NAME, force_roll_##name)
#define FORCE_TWIST_LOOPS(NAME, name, with, summary)                                                         \
    FORCE_RESIST_LOOPS(twist, LAW_TWISTING_##NAME, force_twist_##name)
FORCE_SLIDES(FORCE_SLIDE_LOOPS)
LAW_ROLLING_PARTS(FORCE_ROLL_LOOPS)
LAW_TWISTING_PARTS(FORCE_TWIST_LOOPS)

/* True if the law's resistances have loops. */
static inline bool force_resist_has(const struct law *law) {
    return !law->options.lammps_granular && law->memory.slides < 0;
}

/* The loops of a law that has them, in their order; NULL: the law has none of a kind. */
static inline void force_resist_find(const struct law_options *options, bool energies,
                                     force_pusher *loop[FORCE_RESISTS]) {
#define SLIDE(NAME, name) [LAW_TANGENTIAL_##NAME] = FORCE_RESIST_ROW(force_slide_##name),
#define ROLL(NAME, name, with, summary) [LAW_ROLLING_##NAME] = FORCE_RESIST_ROW(force_roll_##name),
#define TWIST(NAME, name, with, summary) [LAW_TWISTING_##NAME] = FORCE_RESIST_ROW(force_twist_##name),
    static force_pusher *const slide[LAW_TANGENTIAL_COUNT][2][2] = {FORCE_SLIDES(SLIDE)};
    static force_pusher *const roll[LAW_ROLLING_COUNT][2][2] = {LAW_ROLLING_PARTS(ROLL)};
    static force_pusher *const twist[LAW_TWISTING_COUNT][2][2] = {LAW_TWISTING_PARTS(TWIST)};
#undef SLIDE
#undef ROLL
#undef TWIST
    loop[0] = slide[options->tangential][options->synchronised][energies];
    loop[1] = roll[options->rolling][options->synchronised][energies];
    loop[2] = twist[options->twisting][options->synchronised][energies];
}

#endif
