/* SPDX-License-Identifier: BSD-3-Clause */
/* What the headers of parts (parts/KIND_NAME.h) share: how they state coefficients and keys, and what the formulas take and
 * give. Read law_parts.h first: it has the tables and the recipe for a new part.
 *
 * A part states its coefficients once, as an X-macro KIND_NAME_KEYS with one entry a key of `material_pairs`:
 *
 *     KEY(NAME, member, RANGE, .unit = "J/m2", .required = true, .example = "0.05 J/m2", .help = "...")
 *
 * The entries make the members of struct KIND_NAME_given, which the scene's values fill, the rows of the schema, and the
 * check of the ranges. Members from .unit on are those of a schema row (data/scene/schema_rows.h). A key that may be left
 * out has a `.fallback`; where this is missing, too, the value is 0.
 *
 * A cohesion also states as KIND_NAME_NUMBERS what its formula takes, made once from the coefficients: these are the members of
 * struct KIND_NAME, and columns of the loop over contacts (src/physics/grains/batch/force_grip.h). The range, KIND_NAME_range, is no less for larger
 * numbers: that of all pairs of materials is found from the largest of each. The whole of a cohesion that pulls beside the springs:
 *
 *     const char *cohesion_NAME_wrong(given)               what is wrong with these values together; NULL: nothing
 *     struct cohesion_NAME cohesion_NAME_of(c, given)      the numbers of a pair of materials
 *     double cohesion_NAME_range(numbers, effective)       the largest gap at which it acts, >= 0
 *     struct law_pull cohesion_NAME_pull(numbers, radii, overlap)
 *     double cohesion_NAME_energy(numbers, radii, overlap) <= 0; its slope is -force
 *     struct law_cohesion_form cohesion_NAME_form          properties; step_error by examples/step-fraction.sh
 *
 * One that takes the place of the springs (jkr alone so far) has _sticks, _grip and _last instead of _pull and _energy. A resistance to rolling
 * or twisting says as KIND_NAME_solved what a solver of contacts makes of it. */
#ifndef SCREE_LAWS_LAW_PART_H
#define SCREE_LAWS_LAW_PART_H

#include "physics/grains/laws/law_form.h"
#include <stddef.h>

/* Entries of the two macros, as members of a struct. */
#define LAW_GIVEN_MEMBER(part, member, ...) double member;
#define LAW_NUMBER_MEMBER(part, member) double member;

/* The radii of two surfaces, length: a wall's `other` is infinite; effective: R*. */
struct law_radii {
    double one, other, effective;
};

/* The attraction of two surfaces: force >= 0, d force/d overlap, and energy <= 0 with d energy/d overlap = -force. KIND_NAME_pull
 * leaves the energy out. */
struct law_pull {
    double force, slope, energy;
};

/* The properties of a cohesion. */
struct law_cohesion_form {
    bool remembers; /* surfaces need to have touched to attract each other across a gap */
    bool fixed;     /* friction's limit counts the force at rest, not the damper */
    bool
        constant; /* the pull of surfaces that touch grows as the effective radius, and is the same at any overlap: a
                       solver of contacts (contact.solver) takes it */
    double press; /* friction's limit counts the pull so many times beside the force */
    /* The errors of impacts, as those of law_form.h; 0: the cohesion is not studied. */
    double step_error[LAW_STEPS_STUDIED];
};

/* The normal direction of a contact. */
struct law_grip {
    bool interacts; /* false: there is no force, and nothing is remembered */
    bool touches;   /* the surfaces touch: dampers and friction act */
    double force;   /* elastic and cohesive; positive: repulsion */
    double least;   /* the damper may pull no harder than to this force, where it may not pull (end: force) */
    double press;   /* what friction's limit adds to the force */
    double a;       /* contact radius; also law_grip_radius */
    double spring;  /* force of the spring / overlap; of JKR k_n a: sets the damper of a restitution */
    double factor;  /* of a given damping coefficient */
    double tangent; /* d force / d overlap, for the stable step */
    double tangential; /* stiffness of the tangential spring */
    double energy;
};

/* What resistances to rolling and twisting see of a contact. */
struct law_touch {
    const struct law_coefficients *c;
    struct law_radii radii;
    const struct law_grip *grip;
    double base; /* the normal damper's coefficient over c_n */
    double mass; /* effective */
};

/* Stiffness, damper and limit of a resistance. Rolling: per displacement R* x angle, without a limit of its own; twisting: torques
 * per angle and rate, the limit over the force that presses. */
struct law_resistance {
    double stiffness, damping, limit;
};

/* What a solver of contacts (contact.solver) makes of a resistance: NONE, it has no form; RIGID, it holds up to its limit; TANGENTIAL, a spring
 * as stiff as the tangential one; SPRING, one of this stiffness (rolling: force per displacement R* x angle; twisting: moment per
 * angle). limit: of twisting, moment over the force. lacks: the key of a damper that is given and has no form; NULL: none. */
enum law_solved_row { LAW_SOLVED_NONE, LAW_SOLVED_RIGID, LAW_SOLVED_TANGENTIAL, LAW_SOLVED_SPRING };
struct law_solved {
    enum law_solved_row row;
    double stiffness, limit;
    const char *lacks;
};

/* The properties of a rolling resistance. */
struct law_rolling_form {
    bool spring; /* a spring with history */
    bool rests;  /* the dashpot rests at the limit */
    bool plain;  /* laws without parts have it, too: it is no part of a law's title */
};

/* What dampers are made from. */
struct law_damped {
    double restitution, gamma_n, gamma_t; /* of struct law_pair */
    enum law_end end;
    double damper, tangent;   /* of struct law_form */
    double tangential, ratio; /* scene key tangential_damping_ratio; k_t over the tangent stiffness */
};

/* What a damper's coefficient is a multiple of: the root of mass times stiffness, the mass, or the slope of the spring's force. */
enum law_base { LAW_BASE_ROOT, LAW_BASE_MASS, LAW_BASE_SLOPE };

/* The properties of a damping. */
struct law_damping_form {
    enum law_base base;
    bool given;       /* from gamma_n, gamma_t, k_n and k_t of the pair, not from moduli */
    bool restitution; /* from the pair's restitution */
    bool general;     /* needs the general loop */
};

#endif
