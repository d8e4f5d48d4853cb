/* The stable time step: from the contact's frequency w0 = sqrt(k/m*) and its damping, counting simultaneous
 * contacts, beside Rayleigh's. Formulas with their sources in docs/physics.md. */
#ifndef SCREE_INTEGRATE_TIMESTEP_H
#define SCREE_INTEGRATE_TIMESTEP_H

#include "contact/law.h"

/* One kind of particle present: its material and the smallest radius (and mass) of it, and of the partners it
 * may meet. */
struct timestep_kind {
    int material;
    double radius_min, radius_max; /* of free particles of this material */
    double mass_min;
};

struct timestep_input {
    const struct law *law;
    int kinds;
    const struct timestep_kind *kind;
    const struct law_material *material;
    double speed_max; /* largest impact speed expected; hertz stiffness depends on overlap, so on speed */
    int contacts;     /* simultaneous contacts counted on a particle; 0: default */
};

struct timestep_limits {
    double
        stable; /* largest stable step of the explicit scheme, damping included, also when overdamped; time */
    double contact_time;        /* duration of the shortest elastic contact */
    double rayleigh;            /* smallest Rayleigh time over the materials (hertz), or 0 */
    double frequency;           /* w0 of the stiffest pair */
    double damping_ratio;       /* of that pair */
    int material_a, material_b; /* the pair that sets the limit */
};

/* The default step as a fraction of `stable`, used when the scene gives none. */
double timestep_default_fraction(void);

/* Finds the limits. One thread. */
void timestep_limits(struct timestep_limits *limits, const struct timestep_input *input);

#endif
