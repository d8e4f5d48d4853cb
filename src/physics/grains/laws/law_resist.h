/* SPDX-License-Identifier: BSD-3-Clause */
/* Resistance of a law with parts to sliding, rolling and twisting (law_parts.h). Formulas and sources in
 * docs/physics.md. Any thread. */
#ifndef SCREE_LAWS_LAW_RESIST_H
#define SCREE_LAWS_LAW_RESIST_H

#include "physics/grains/laws/law_grip.h"

/* What the normal direction says to the others. */
struct law_hold {
    const struct law_grip *grip;
    double press; /* the force that limits of friction are multiples of */
    double base;  /* the normal damper's coefficient over c_n */
};

/* Adds forces, torques and energies to the response, and advances the springs in `in->value`. */
void law_resist(const struct law *law, struct law_step step, struct law_general *in,
                const struct law_hold *hold, struct law_response *out);

/* Sets the springs in `value` to zero, and leaves what the normal direction remembers. */
void law_resist_forget(const struct law *law, double *value);

/* Adds the springs and dampers for small changes. */
void law_resist_stiff(const struct law *law, const struct law_surfaces *surfaces, const struct law_hold *hold,
                      double mass, struct law_stiff *stiff);

#endif
