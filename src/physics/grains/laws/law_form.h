/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact law's form: how the elastic force between two spheres, or a sphere and a wall, depends on their
 * overlap. Damping, friction and rolling are the same for all forms (law_kernel.h); a form provides the
 * springs.
 *
 * How to add a law:
 *
 *   1. Write contact/law_NAME.h like its neighbours: the function law_NAME_springs, and a struct law_form
 *      named law_NAME.
 *   2. Include the new header in law_table.h, and add a row to LAW_TABLE there.
 *   3. List the file in src/physics/grains/laws/local.mk, and describe the law in docs/physics.md.
 *   4. Add the law to examples/step-fraction.sh, and what the script finds as `step_error` to the law.
 *
 * The scene's keys, the loops of all instruction sets, the stable step, `scree check`, `scree ablate`, the
 * report and the help then know the law. tests/test_law.c compares each law of the table with the law's own
 * potential. */
#ifndef SCREE_LAWS_LAW_FORM_H
#define SCREE_LAWS_LAW_FORM_H

#include <math.h>
#include <stdbool.h>

/* A loop over contacts vectorises only if the compiler inlines all calls in the loop. */
#define LAW_INLINE static inline __attribute__((always_inline))

/* The larger of two numbers; not fmax, which a loop would call. */
LAW_INLINE double law_most(double a, double b) {
    return a > b ? a : b;
}

/* Numbers of a pair of materials that a law of the user's takes. */
enum { LAW_NAME_MAX = 64, LAW_PATH_MAX = 1024, LAW_PARAMETERS_MAX = 8 };

/* The end of a contact: at zero overlap (the damper may attract just before), or as soon as the force would
 * attract. */
enum law_end { LAW_END_OVERLAP, LAW_END_FORCE };

/* A material (scene key `materials`). */
struct law_material {
    char name[LAW_NAME_MAX];
    double density;        /* mass/volume */
    double young, poisson; /* of laws with moduli; pressure, 1 */
};

/* Coefficients of a pair of materials that parts add; only those of the parts in use are read. */
struct law_extra {
    double surface_energy;        /* gamma of jkr, dmt: energy/area; the work of adhesion is W = 2 gamma */
    double cohesion_density;      /* sjkr: energy/volume */
    double surface_tension;       /* capillary: force/length */
    double contact_angle;         /* capillary: rad, 0 ... pi/2 */
    double bridge_volume;         /* capillary: volume of a bridge; 0: by bridge_fraction */
    double bridge_fraction;       /* capillary: volume over that of a sphere with radius 2 R* */
    double hamaker;               /* van_der_waals: energy */
    double gap_least;             /* van_der_waals: below this gap the force grows no more; length */
    double cut_off;               /* van_der_waals: beyond this gap there is no force; length */
    double dissipative_time;      /* viscoelastic: Brilliantov's A; time */
    double static_friction;       /* limit of a contact that sticks; below `friction`: `friction` */
    double rolling_stiffness;     /* spring: force/length; 0: the tangential spring's */
    double rolling_damping;       /* spring with a stiffness: force time/length */
    double rolling_damping_ratio; /* epsd: of the rolling oscillation */
    double twisting_stiffness;    /* sds: torque/rad */
    double twisting_damping;      /* sds: torque time/rad */
    double k_2,
        k_c; /* laws with hysteresis: slopes of the unloading and of the adhesive branch; force/length */
    double
        plasticity_depth;  /* overlap over the reduced radius at which the slope is k_2; 0: at any overlap */
    double yield_pressure; /* laws with yield: pressure */
    double plasticity_ratio;              /* eepa: lambda_p = 1 - k_1/k_2, 0 ... below 1 */
    double adhesion_exponent;             /* eepa: chi of the adhesive branch */
    double adhesion_energy;               /* eepa: delta gamma of the adhesive branch; energy/area */
    double pull_off;                      /* eepa: constant pull while the surfaces touch; force */
    double twisting_friction;             /* sds: limit of the torque over the normal force; length */
    double parameter[LAW_PARAMETERS_MAX]; /* of a law of the user's */
    int parameters;                       /* how many are given */
};

/* Coefficients of a pair of materials (scene key `material_pairs`; missing pairs are an error unless one
 * default is given). */
struct law_pair {
    double restitution;      /* 0 ... 1 */
    double friction;         /* Coulomb coefficient mu >= 0 */
    double rolling_friction; /* mu_r >= 0 */
    double k_n, k_t;         /* of laws without moduli, or with given damping: stiffness; force/length, or of
                                laws with moduli force/length^2, times the contact radius */
    double gamma_n, gamma_t; /* given damping, per unit of effective mass: 1/time, or of laws with moduli
                                1/(time length), times the contact radius */
    struct law_extra extra;
};

/* Input of the kernel for a pair of materials, made once. */
struct law_coefficients {
    double k_n, k_t; /* of the springs; the form defines their meaning */
    double c_n;      /* coefficients given: gamma_n, times m* and the form's contact; restitution: the form's
                   `damper` times the damping ratio, times sqrt(m* x elastic force / overlap) */
    double c_t;      /* the same for the tangential damper; the rolling spring takes k_t and c_t too */
    double friction, rolling_friction;
};

/* The springs of one contact. */
struct law_springs {
    double force;      /* elastic normal force; positive: repulsion */
    double stiffness;  /* force / overlap: sets the damper that belongs to a restitution */
    double tangent;    /* d force / d overlap, for the stable step */
    double tangential; /* stiffness of the tangential and of the rolling spring */
    double contact;    /* factor of a given damping coefficient */
    double energy;     /* stored in the normal spring */
    double press;      /* adhesion of the law's own, which friction's limit counts beside the force */
};

/* Numbers that a law with hysteresis may remember of a contact. */
enum { LAW_PAST_MAX = 2 };

/* The parts of the stable step at which examples/step-fraction.sh studies a law: 0.05, 0.1, 0.15, 0.3, 0.5, 0.7, 0.9. */
enum { LAW_STEPS_STUDIED = 7 };

/* What plastic flow has left of two spheres: their effective radius, and the overlap at which they just touch. */
struct law_flat {
    double radius, left;
};

/* The other properties of a form. */
struct law_form {
    bool linear;    /* force proportional to overlap for all radii; other laws are compared with this one */
    bool radius;    /* the springs depend on the effective radius */
    double damper;  /* c_n over the damping ratio of the linear spring-dashpot with the same restitution */
    double tangent; /* d force / d overlap over force / overlap, at small overlaps */
    /* Laws with moduli: k_n and k_t from Young's modulus and Poisson's ratio of both materials. NULL: k_n and
     * k_t are those of the pair. */
    void (*moduli)(const struct law_material *a, const struct law_material *b, struct law_coefficients *c);
    /* A law with hysteresis: the springs at an overlap; updates the numbers that a contact remembers, `past`, of
     * which there are `remembers`, all 0 for a new contact; the first is the largest overlap. Contacts then go
     * through the general loop. NULL: the law remembers nothing. */
    struct law_springs (*unload)(const struct law_coefficients *c, const struct law_extra *extra,
                                 double radius, double overlap, double past[LAW_PAST_MAX]);
    int remembers;
    /* A law with hysteresis that combines with the cohesion of elastic spheres: what it has left of the spheres after
     * the largest overlap `most`. */
    struct law_flat (*flatten)(const struct law_coefficients *c, const struct law_extra *extra, double radius,
                               double most);
    /* Largest overlap of an elastic impact at `speed`, with the effective mass and radius; length. */
    double (*impact)(const struct law_coefficients *c, double mass, double radius, double speed);
    /* Duration of the elastic impact that reaches `overlap`; time. */
    double (*duration)(const struct law_coefficients *c, double mass, double radius, double overlap);
    /* Largest error of a velocity after an impact, over the speed of approach, at the parts studied of the stable step
     * (docs/speed-error.md); 0: the law is not studied. */
    double step_error[LAW_STEPS_STUDIED];
};

#endif
