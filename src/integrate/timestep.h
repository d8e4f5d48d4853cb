/* The stable time step of the leapfrog scheme, from the contacts' frequencies and dampers, beside Rayleigh's
 * time. Formulas with their sources in docs/physics.md; in short:
 *
 *   A spring k and a damper c on a mass m, with w = sqrt(k/m) and zeta = c/(2 m w), are stable in the
 *   leapfrog scheme whose damper sees the velocity of the last half step up to
 *   dt = 2 (sqrt(1 + zeta^2) - zeta) / w, for any zeta (overdamped: dt -> 2 m/c).
 *
 *   A contact has a normal mode (k_n, c_n, mass m*) and, with friction, a tangential one, where both spheres
 * turn (k_t, c_t, mass m* / 3.5; with rolling resistance m* / 6). A particle with N contacts at a time is
 * counted as N times the spring and N times the damper: exact for N aligned contacts, and never too little
 * where each partner has N contacts at most.
 *
 *   Hertz: tangent stiffness at the overlap that the expected speed reaches, or at the stated one, whichever
 * is larger. */
#ifndef SCREE_INTEGRATE_TIMESTEP_H
#define SCREE_INTEGRATE_TIMESTEP_H

#include "contact/law.h"

/* One kind of particle present: its material and the range of radii; or a wall (or prescribed particles),
 * which have no mass to move and no radius that counts. */
struct timestep_kind {
    int material;
    bool wall;                     /* then the rest is not looked at */
    double radius_min, radius_max; /* of free particles of this material, length */
    double mass_min;               /* of the smallest; others scale with radius^3: where densities differ, the
                                      least density x its volume */
};

struct timestep_input {
    const struct law *law;
    int kinds;
    const struct timestep_kind *kind;
    const struct law_material *material;
    double speed_max;        /* largest impact speed expected, length/time; hertz stiffness grows with it */
    double overlap_relative; /* hertz: overlap counted with at least, relative to the smaller radius; 0:
                                default (0.001) */
    int contacts;            /* N, simultaneous contacts counted on a particle; 0: default (4) */
};

struct timestep_limits {
    double stable; /* largest stable step, damping included, also when overdamped; time; infinite without
                      kinds */
    double contact_time;        /* duration of the shortest elastic contact */
    double rayleigh;            /* smallest Rayleigh time over the materials (hertz), or 0 */
    double frequency;           /* sqrt(k_n/m*) of the one contact that sets the limit, rad/time */
    double damping_ratio;       /* zeta of its normal mode, for one contact */
    int material_a, material_b; /* its materials */
};

/* The default step as a fraction of `stable`, used when the scene gives none: 0.15, 20 steps a contact at
 * least. */
double timestep_default_fraction(void);

/* The stability bound above for stiffness k, damper c and inverse mass. Infinite if all are 0. */
double timestep_bound(double stiffness, double damping, double inverse_mass);

/* Finds the limits. One thread. */
void timestep_limits(struct timestep_limits *limits, const struct timestep_input *input);

#endif
