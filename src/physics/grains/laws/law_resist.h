/* SPDX-License-Identifier: BSD-3-Clause */
/* Resistance of a law with parts to sliding, rolling and twisting (law_parts.h). Formulas and sources in
 * docs/physics.md. Any thread.
 *
 * The inline functions are arithmetic without branches: loops over contacts call them (physics/grains/batch/force_resist.h), and law_resist does
 * for one contact after another, with the same bits. Each adds the work that it takes, and what its spring stores, to `out`. */
#ifndef SCREE_LAWS_LAW_RESIST_H
#define SCREE_LAWS_LAW_RESIST_H

#include "physics/grains/laws/law_grip.h"

/* What the normal direction says to the others. */
struct law_hold {
    const struct law_grip *grip;
    double press; /* the force that limits of friction are multiples of */
    double base;  /* the normal damper's coefficient over c_n */
};

#define LAW_RESIST_TINY 1e-100

/* True if the tangential spring shrinks with the contact radius; if the force is remembered, not the displacement. */
LAW_INLINE bool law_rescales(enum law_tangential kind) {
    return kind == LAW_TANGENTIAL_RESCALE || kind == LAW_TANGENTIAL_RESCALE_FORCE;
}
LAW_INLINE bool law_keeps_force(enum law_tangential kind) {
    return kind == LAW_TANGENTIAL_FORCE || kind == LAW_TANGENTIAL_RESCALE_FORCE;
}

/* The slip between the surfaces, length/time. */
LAW_INLINE struct law_vector law_slip_rate(const struct law_contact *in, struct law_vector plane) {
    return law_add(law_project(in->velocity, plane), -1.0, law_cross(in->surface, plane));
}

/* The factor by which a tangential spring changes before it advances: with the contact radius a on unloading, and where the force
 * is remembered, from force to displacement by the stiffness now. */
LAW_INLINE double law_spring_factor(enum law_tangential kind, double a, double before, double stiffness) {
    double shrunk = a / law_max(before, LAW_RESIST_TINY);
    double factor = law_rescales(kind) && a < before ? shrunk : 1.0;
    return law_keeps_force(kind) ? factor / law_max(stiffness, LAW_RESIST_TINY) : factor;
}

/* A dashpot up to a limit. */
LAW_INLINE struct law_vector law_dash(struct law_step step, struct law_vector rate, double damping,
                                      double limit, struct law_response *out) {
    double most = limit / law_max(sqrt(law_dot(rate, rate)), LAW_RESIST_TINY);
    struct law_vector force = law_scale(damping < most ? -damping : -most, rate);
    out->taken -= step.dt * law_dot(force, rate);
    return force;
}

/* A rolling spring and dashpot up to a limit; `rests`: the dashpot does not act at the limit. */
LAW_INLINE struct law_vector law_roll(struct law_case law, struct law_step step, const struct law_contact *in,
                                      struct law_vector rate, struct law_vector *spring, bool rests,
                                      struct law_resistance rolling, double limit, struct law_response *out) {
    struct law_vector force =
        law_slide(law, step, in, rate, spring, rolling.stiffness, rests ? 0.0 : rolling.damping, limit, out);
    bool turns = rests && law_dot(force, force) < limit * limit * (1.0 - 1e-12);
    double damping = turns ? rolling.damping : 0.0;
    out->taken += step.dt * damping * law_dot(rate, rate);
    struct law_vector damped = law_add(force, -damping, rate);
    return (struct law_vector){turns ? damped.x : force.x, turns ? damped.y : force.y,
                               turns ? damped.z : force.z};
}

/* A twisting spring and dashpot up to a limit: the torque; advances the angle. `against`: at the limit the torque acts against the
 * rate, not against spring and dashpot. */
LAW_INLINE double law_twist(struct law_step step, double rate, double *angle, struct law_resistance twisting,
                            double limit, bool against, struct law_response *out) {
    double before = *angle, trial = before + step.dt * rate;
    double torque = -twisting.stiffness * trial - twisting.damping * rate;
    bool over = fabs(torque) > limit;
    double cut = over ? copysign(limit, against ? -rate : torque) : torque;
    double give = law_max(twisting.stiffness + twisting.damping * step.relaxation, LAW_RESIST_TINY);
    *angle = over ? trial + (torque - cut) / give : trial;
    out->spring_energy += 0.5 * twisting.stiffness * *angle * *angle;
    out->taken -= step.dt * rate * (cut + 0.5 * twisting.stiffness * (*angle - before));
    return cut;
}

/* Adds forces, torques and energies to the response, and advances the springs in `in->value`. */
void law_resist(const struct law *law, struct law_step step, struct law_general *in,
                const struct law_hold *hold, struct law_response *out);

/* Sets the springs in `value` to zero, and leaves what the normal direction remembers. */
void law_resist_forget(const struct law *law, double *value);

/* Adds the springs and dampers for small changes. */
void law_resist_stiff(const struct law *law, const struct law_surfaces *surfaces, const struct law_hold *hold,
                      double mass, struct law_stiff *stiff);

#endif
