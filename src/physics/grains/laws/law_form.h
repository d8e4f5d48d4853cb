/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact law's form: how the elastic force between two spheres, or a sphere and a wall, depends on their
 * overlap. Damping, friction and rolling are the same for all forms (law_kernel.h); a form provides the
 * springs.
 *
 * How to add a law:
 *
 *   1. Write law_NAME.h like its neighbours: the function law_NAME_springs, and a struct law_form
 *      named law_NAME.
 *   2. Include the new header in law_table.h, and add a row to one of the tables there.
 *   3. List the file in src/physics/grains/laws/local.mk, and describe the law in docs/physics.md.
 *   4. Add the law to examples/step-fraction.sh, and what the script finds as `step_error` to the law.
 *
 * The scene's keys, the loops of all instruction sets, the stable step, `scree check`, `scree ablate`, the
 * report and the help then know the law. tests/physics/grains/laws/test_law.c compares each law of the table with the law's own
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

struct law_extra; /* law_parts.h */

/* Input of the kernel for a pair of materials, made once. k_n, k_t: of the springs; the form defines their meaning. c_n: coefficients
 * given: gamma_n, times m* and the form's contact; restitution: the form's `damper` times the damping ratio, times sqrt(m* x elastic
 * force / overlap). c_t: the same for the tangential damper; the rolling spring takes k_t and c_t too. Batches of contacts have a
 * column for each (src/physics/grains/batch/force_kernel.h). */
#define LAW_COEFFICIENT_TABLE(ROW) ROW(k_n) ROW(k_t) ROW(c_n) ROW(c_t) ROW(friction) ROW(rolling_friction)
#define LAW_COEFFICIENT_MEMBER(member) double member;
struct law_coefficients {
    LAW_COEFFICIENT_TABLE(LAW_COEFFICIENT_MEMBER)
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
