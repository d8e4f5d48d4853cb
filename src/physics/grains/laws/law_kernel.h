/* SPDX-License-Identifier: BSD-3-Clause */
/* The contact laws themselves, as `static inline` functions: one contact in, forces and torques out. Sphere
 * against sphere and sphere against wall use the same function. The caller computes the geometry, this file
 * the physics (docs/physics.md).
 *
 * How to use it: fill a `struct law_case` with constants, so that the compiler drops the terms that the law
 * does not have; fill a `struct law_contact`; call law_respond. There are no branches that a vectorising
 * compiler could not turn into selects, and no memory: a loop that calls law_respond once an iteration
 * vectorises (as in physics/grains/batch/force_physics.h).
 *
 * Signs. The normal n points from i to j (wall: from the sphere to the wall). Velocities are those of j minus
 * those of i. Force, rolling torque and springs are those of j; the negatives hold for i. With n, velocities
 * and springs negated (the pair seen from j) every result is the negative to the last bit, as no operation
 * prefers a side; `moment` keeps its sign: the torques are
 *
 *     i: lever_i moment - rolling        j: lever_j moment + rolling
 *
 * Spheres: velocity = v_j - v_i of the centres, surface = lever_i omega_i + lever_j omega_j (levers of the
 * half step where springs advance in its plane), spin = omega_j - omega_i, mass and radius the effective
 * ones. The lever is r - overlap / 2: the contact point lies in the middle of the overlap for all radii, so
 * that the levers add up to the distance and angular momentum is conserved; with lammps_history the lever is
 * r. Walls: velocity = that of the wall's material point at the contact point - v of the sphere's centre,
 * surface = lever_i omega_i, spin = omega of the wall - omega_i, mass and radius those of the sphere. */
#ifndef SCREE_LAWS_LAW_KERNEL_H
#define SCREE_LAWS_LAW_KERNEL_H

#include "physics/grains/laws/law.h"
#include "physics/grains/laws/law_vector.h"
#include <float.h>

/* The case of a law that a loop is specialised for: compile-time constants in that loop. */
struct law_case {
    enum law_normal normal; /* the law of the table */
    bool damping_given;     /* the damper is a coefficient times the effective mass; else from the
                          restitution */
    bool friction;          /* a tangential spring with history */
    bool rolling;           /* a rolling spring with history */
    bool synchronised;      /* springs advance in the half-step tangent plane */
    bool radius;            /* the springs depend on the effective radius */
    bool lever_radius;      /* the lever is r (LAMMPS's), else r - overlap / 2 */
    bool energies;          /* fill the three energies of the response */
};

/* The numbers common to all contacts of one evaluation; from law_step_of. */
struct law_step {
    double dt;           /* time step of the springs, time; 0: the springs stay */
    double force_least;  /* lower bound of the normal force: 0, or -DBL_MAX if the force may attract */
    double spring_least; /* an over-limit spring of this square length or less gives no force; -1: never, 0:
                            empty ones (LAMMPS) */
    double rescale;      /* 1: a turned spring keeps its length; 0: the spring is projected only */
    double relaxation;   /* 1 / dt if a sliding spring relaxes against its damper; 0: cut at once */
    bool energies;       /* of a law with parts: fill the three energies of the response; law_step_of: true */
};

/* One contact. The members from half_normal on are used with friction only, `spin` and `roll` with rolling
 * only. */
struct law_contact {
    double overlap, mass,
        radius; /* length, effective mass (0: both sides are prescribed, no damping), effective radius */
    struct law_vector normal;             /* unit vector from i to j, now */
    struct law_vector velocity;           /* length/time, half-step */
    struct law_coefficients coefficients; /* of the two materials */

    struct law_vector half_normal; /* unit vector half a step ago (synchronised) */
    struct law_vector surface;     /* sum of lever x angular velocity, length/time */
    struct law_vector spin;        /* difference of the angular velocities, 1/time */
    struct law_vector spring;      /* tangential spring so far, length */
    struct law_vector roll;        /* rolling spring so far, length */
};

struct law_response {
    struct law_vector force;        /* on j, normal and tangential */
    struct law_vector moment;       /* torque per lever, on both sides */
    struct law_vector rolling;      /* torque on j */
    struct law_vector spring, roll; /* the springs to remember */
    double normal_energy;           /* stored in the normal spring */
    double spring_energy;           /* stored in the tangential and rolling springs */
    double taken; /* work taken in this step by the normal damper and by all tangential forces; the
                     excess over the growth of spring_energy is dissipated */
};

/* Makes the numbers of one evaluation of a law with time step dt. */
LAW_INLINE struct law_step law_step_of(const struct law_options *options, double dt) {
    bool lammps = options->lammps_history || options->lammps_granular;
    bool series = options->sliding == LAW_SLIDING_SERIES && !lammps;
    return (struct law_step){.dt = dt,
                             .force_least = options->end == LAW_END_FORCE ? 0.0 : -DBL_MAX,
                             .spring_least = lammps ? 0.0 : -1.0,
                             .rescale = options->lammps_history ? 0.0 : 1.0,
                             .relaxation = !series ? 0.0 : 1.0 / law_max(dt, 1e-30),
                             .energies = true};
}

/* The case of a law's options, for callers that do not specialise. */
LAW_INLINE struct law_case law_case_of(const struct law_options *options, bool energies) {
    bool friction = options->tangential != LAW_FRICTIONLESS;
    bool rolling =
        friction && (options->rolling != LAW_ROLLING_NONE || options->twisting != LAW_TWISTING_NONE);
    bool empty = law_has_trait(options->normal, "file") && options->user == NULL;
    return (struct law_case){.normal = empty ? law_linear() : options->normal,
                             .damping_given = law_damping_form_of(options->damping)->given,
                             .friction = friction,
                             .rolling = rolling,
                             .synchronised = options->synchronised,
                             .radius = rolling || law_form_of(options)->radius,
                             .lever_radius = options->lammps_history,
                             .energies = energies};
}

/* The lever arm of a sphere (length) against another sphere or a wall: from the centre of the sphere to the
 * middle of the overlap, or the radius of the sphere (LAMMPS). */
LAW_INLINE double law_lever(struct law_case law, double radius, double overlap) {
    return law.lever_radius ? radius : radius - 0.5 * overlap;
}

/* One spring-dashpot with a sliding limit: advances `spring` by dt x rate, turns it into the tangent plane,
 * and lets the spring slide if the force exceeds `limit`. The force is then cut to the limit, and the spring
 * takes the length at which spring and damper give that force. The damper acts on the rate of change of the
 * spring (slider in series, dissipation never negative) or on all of `rate` (relaxation 0). `rate` is taken
 * in the half-step plane if synchronised. Returns the force. Energies are added to the response; the work is
 * that of the mean of the forces before and after the step. */
LAW_INLINE struct law_vector law_slide(struct law_case law, struct law_step step,
                                       const struct law_contact *in, struct law_vector rate,
                                       struct law_vector *spring, double stiffness, double damping,
                                       double limit, struct law_response *out) {
    struct law_vector plane = law.synchronised ? in->half_normal : in->normal;
    struct law_vector trial = law_add(law_turn(*spring, plane, step.rescale), step.dt, rate);
    if (law.synchronised) {
        trial = law_transport(trial, plane, in->normal);
        rate = law_transport(rate, plane, in->normal);
    }
    struct law_vector force = law_add(law_scale(-stiffness, trial), -damping, rate);
    double size = sqrt(law_max(law_dot(force, force), DBL_MIN));
    double give = law_max(stiffness + damping * step.relaxation, 1e-100);
    double inverse = 1.0 / (give * size); /* one division for two: limit / size and 1 / give */
    double ratio = limit * (give * inverse);
    double keep = ratio < 1.0 ? ratio : 1.0;
    bool empty = law_dot(trial, trial) <= step.spring_least;
    double keep_spring = empty ? 1.0 : keep;
    double keep_force = keep < keep_spring ? 0.0 : keep;
    *spring = law_add(trial, (1.0 - keep_spring) * (size * inverse), force);
    force = law_scale(keep_force, force);
    if (law.energies) {
        struct law_vector way = law_scale(step.dt, rate); /* slip = trial - spring; stretch = way - slip */
        struct law_vector stretch = law_add(way, -1.0, law_add(trial, -1.0, *spring));
        out->spring_energy += 0.5 * stiffness * law_dot(*spring, *spring);
        out->taken -= law_dot(law_add(force, 0.5 * stiffness, stretch), way);
    }
    return force;
}

/* Tangential and rolling part of law_respond; normal_force, stiffness and base are values found in
 * law_respond. */
LAW_INLINE void law_rub(struct law_case law, struct law_step step, const struct law_contact *in,
                        double normal_force, double stiffness, double base, struct law_response *out) {
    struct law_vector plane = law.synchronised ? in->half_normal : in->normal;
    struct law_vector rate = law_add(law_project(in->velocity, plane), -1.0, law_cross(in->surface, plane));
    double damping = in->coefficients.c_t * base;
    double pressure = fabs(normal_force);

    out->spring = in->spring;
    struct law_vector force = law_slide(law, step, in, rate, &out->spring, stiffness, damping,
                                        in->coefficients.friction * pressure, out);
    out->force = law_add(out->force, 1.0, force);
    out->moment = law_cross(force, in->normal);
    if (!law.rolling)
        return;
    rate = law_scale(in->radius, law_project(in->spin, plane));
    out->roll = in->roll;
    force = law_slide(law, step, in, rate, &out->roll, stiffness, damping,
                      in->coefficients.rolling_friction * pressure, out);
    out->rolling = law_scale(in->radius, force);
}

/* Forces and torques of a contact whose normal springs are known, as those of a law of the user's are. Any thread. */
LAW_INLINE struct law_response law_respond_with(struct law_case law, struct law_step step,
                                                const struct law_contact *in, struct law_springs springs) {
    struct law_response out = {0};
    double base = law.damping_given ? in->mass * springs.contact : sqrt(in->mass * springs.stiffness);
    double rate = law_dot(in->velocity, in->normal);
    double force = springs.force - in->coefficients.c_n * base * rate;
    force = force <= step.force_least ? step.force_least : force; /* a force that is no number stays one */
    out.force = law_scale(force, in->normal);
    if (law.energies) {
        out.normal_energy = springs.energy;
        out.taken = (springs.force - force) * rate * step.dt;
    }
    if (law.friction)
        law_rub(law, step, in, force, springs.tangential, base, &out);
    return out;
}

/* Forces and torques of a contact: formulas in law.h and docs/physics.md. Any thread. */
LAW_INLINE struct law_response law_respond(struct law_case law, struct law_step step,
                                           const struct law_contact *in) {
    return law_respond_with(law, step, in,
                            law_springs(law.normal, &in->coefficients, in->radius, in->overlap));
}

#endif
