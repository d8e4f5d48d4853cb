/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal direction of a contact of a law with parts: the elastic force and cohesion. */
#ifndef SCREE_CONTACT_LAW_GRIP_H
#define SCREE_CONTACT_LAW_GRIP_H

#include "contact/law_cohesion.h"
#include "contact/law_kernel.h"

/* A contact; `contact.spring` and `contact.roll` are not read: springs are in `value`. */
struct law_general {
    struct law_contact contact;
    const struct law_extra *extra;
    double radius[2];             /* of both surfaces; a wall's is infinite */
    double value[LAW_MEMORY_MAX]; /* in: the contact's history, 0 for a new one; out: the new one */
};

/* The normal direction of a contact. */
struct law_grip {
    bool interacts; /* false: there is no force, and nothing is remembered */
    bool touches;   /* the surfaces touch: dampers and friction act */
    double force;   /* elastic and cohesive; positive: repulsion */
    double least;   /* the damper may pull no harder than to this force, where it may not pull (end: force) */
    double press;   /* what friction's limit adds to the force */
    double a;       /* contact radius */
    double spring;  /* force of the spring / overlap; of JKR k_n a: sets the damper of a restitution */
    double factor;  /* of a given damping coefficient */
    double tangent; /* d force / d overlap, for the stable step */
    double tangential; /* stiffness of the tangential spring */
    double energy;
};

/* What a contact remembers of the normal direction. */
struct law_past {
    bool held;                   /* the surfaces held to each other one step ago; updated */
    double number[LAW_PAST_MAX]; /* of a law with hysteresis (law_form.h); updated */
    bool no_energy;              /* nobody asks for the energy, which may cost more than the force */
};

/* The normal direction at an overlap (negative: a gap); updates `past`. */
struct law_grip law_grip_at(const struct law_options *options, const struct law_surfaces *surfaces,
                            double overlap, struct law_past *past);

/* The overlap at which the elastic force and cohesion cancel, length; 0 without cohesion. */
double law_grip_rest(const struct law_options *options, const struct law_surfaces *surfaces);

/* Springs and dampers of a contact for small changes. */
struct law_stiff {
    double k_n, k_t, k_r, k_w; /* normal, tangential, rolling: force/length; twisting: torque/rad */
    double c_n, c_t, c_r, c_w; /* the dampers: the same times time */
};

#endif
