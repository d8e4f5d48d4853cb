/* SPDX-License-Identifier: BSD-3-Clause */
/* The problem of a single contact, and the models that solve it. In the frame of the contact (normal first, then two
 * tangents) the relative velocity is u = W p + free, and a linear contact wants
 *
 *   0 <= p_n,  0 <= w_n,  p_n w_n = 0,   |p_t| <= friction p_n,   w_t = 0 or p_t = -friction p_n w_t / |w_t|,   w = A p + c
 *
 * with A = W + softness of the springs and c = free + what they hold; a cohesion adds `press` to p_n in the limit of friction. Of spheres A has no entries between normal and
 * tangent and is the same in all tangents: the solution is a closed form (row.h), which all models but `projection` and
 * `frictionless` share. Of other bodies the models differ.
 *
 * The models are those of non-smooth granular dynamics (Preclik and Ruede, Comput. Part. Mech. 2 (2015) 173; Preclik, Eibl and
 * Ruede, Comput. Mech. 62 (2018) 583), the projections those of Anitescu and Tasora (Comput. Optim. Appl. 47 (2010) 207) and De
 * Saxce and Feng (Math. Comput. Model. 28 (1998) 225). */
#ifndef SCREE_HARD_MODELS_H
#define SCREE_HARD_MODELS_H

#include "physics/hard/arm.h"
#include <stdbool.h>

struct hard_local {
    double a[9]; /* row by row */
    double c[3];
    double friction;
    double press; /* friction's limit is friction x (p_n + press): of a cohesion */
};

/* A model of contacts (scene key contact.solver.model). */
struct hard_model {
    const char *name, *summary;
    hard_relaxation *relax;
    bool closed; /* of spheres it is the closed form */
};

#define HARD_MODEL_TABLE(ROW)                                                                                \
    ROW(COULOMB, coulomb, true,                                                                              \
        "Coulomb's law: the friction of a sliding contact is opposite to its slip; of spheres a closed "     \
        "form")                                                                                              \
    ROW(FRICTIONLESS, frictionless, false, "the normal impulse alone")                                       \
    ROW(DECOUPLED, decoupled, true,                                                                          \
        "normal impulse, then the tangential one that would stick, scaled to Coulomb's limit: no iteration") \
    ROW(PROJECTION, projection, false,                                                                       \
        "orthogonal projection onto the cone of friction: convex, but sliding contacts open")                \
    ROW(DE_SAXCE, de_saxce, true,                                                                            \
        "orthogonal projection with the slip in the normal row: Coulomb's law, no opening")                  \
    ROW(DISSIPATION, dissipation, true,                                                                      \
        "of all impulses in the cone that keep the contact closed the one that takes most energy")

#define HARD_MODEL_ENUMERATOR(NAME, name, closed, summary) HARD_MODEL_##NAME,
enum hard_model_number { HARD_MODEL_TABLE(HARD_MODEL_ENUMERATOR) HARD_MODELS };
#undef HARD_MODEL_ENUMERATOR

/* The row of a model. Any thread. */
const struct hard_model *hard_relax_model(enum hard_model_number number);

/* The x of |x| <= most with the least x a x / 2 + c x; a: 11 12 22. True if it lies on the rim. Any thread. */
bool hard_relax_disc(const double a[3], const double c[2], double most, double x[2]);

#endif
