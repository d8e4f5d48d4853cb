/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact laws: forces and torques between two spheres (or a sphere and a wall) that touch.
 *
 * A law gets two particles and a contact, and knows nothing of loops, threads and ranks. The functions that
 * the force loops call are the `static inline` ones of law_kernel.h, specialised by constant arguments; this
 * header holds the data prepared once: options and the table of coefficients for each pair of materials.
 *
 * With the overlap d > 0, the approach speed v_n, the effective mass m* and radius R*, the law of the table
 * (law_table.h) gives the elastic force F_e(d) and the tangential stiffness k_t(d). The normal force is
 *
 *   F_n = F_e + c v_n             c from the restitution, or from gamma_n m*
 *
 * and with the tangential spring xi, whose history a contact keeps, and the slip velocity v_t the tangential
 * one
 *
 *   F_t = -k_t xi - c_t v_t       |F_t| <= mu |F_n|
 *
 * docs/physics.md has the other terms and the sources of all terms. */
#ifndef SCREE_LAWS_LAW_H
#define SCREE_LAWS_LAW_H

#include "physics/grains/laws/law_parts.h"
#include "physics/grains/laws/law_table.h"
#include "base/error.h"

/* Materials of a scene at most: a particle keeps the number of its material in a byte. */
enum { LAW_MATERIALS_MAX = 255, LAW_MEMORY_MAX = 12 };

/* The velocity of the tangential damper while the contact slides. SERIES: the rate of change of the spring,
 * as the slider is in series with spring and damper (energy is never made). TOTAL: the whole slip velocity;
 * the spring takes the rest of the limit (Luding, Granular Matter 10 (2008) 235; LAMMPS). */
enum law_sliding { LAW_SLIDING_SERIES, LAW_SLIDING_TOTAL };

struct law_user; /* law_user.h */

/* Options of the law (scene key `contact`). Plain data. */
struct law_options {
    enum law_normal normal;
    char file[LAW_PATH_MAX];     /* a law with the trait `file`: its C file */
    const struct law_user *user; /* the law of that file, loaded; NULL: one of the table. Borrowed */
    enum law_damping damping;
    enum law_end end;
    enum law_tangential tangential; /* frictionless: no spin, no torque, no history anywhere */
    enum law_sliding sliding;
    enum law_rolling rolling;
    enum law_twisting twisting;
    enum law_cohesion cohesion;
    enum law_jkr_end jkr_end;
    double tangential_damping_ratio; /* restitution: c_t = this x c_n sqrt(k_t / k_n), k_n the tangent
                                        stiffness */
    bool tangential_damping_equal; /* c_t = c_n, as LAMMPS's pair_style granular does; for cross-code runs */
    bool lammps_history; /* LAMMPS's gran/hooke/history and gran/hertz/history to the letter: the lever is r,
                            not r - overlap / 2; sliding is TOTAL, the spring is projected, not turned, and an
                            empty spring over the Coulomb limit gives no force */
    bool
        lammps_granular; /* LAMMPS's pair_style granular to the letter: the lever of the slip is r, sliding is
                             TOTAL, an empty spring over the Coulomb limit gives no force */
    bool solved; /* a solver finds the forces of contacts, which have no history here; set from the scene */
    bool synchronised; /* history with the half-step normal (Vyas et al. 2025); set from the integrator */
};

/* Places in the history of a contact, -1: absent. Vectors come first: tangential and rolling spring, three
 * doubles each; then numbers. */
struct law_memory {
    int spring, roll;
    int twist;  /* twisting spring, rad */
    int held;   /* 1: the surfaces interacted one step ago, across a gap too */
    int radius; /* contact radius one step ago */
    int slides; /* 1: the contact slid one step ago */
    int past;   /* the numbers of a law with hysteresis, the largest overlap first */
};

struct law {
    struct law_options options;
    bool general;  /* the law has parts: contacts go through law_general.h */
    int materials; /* 0: no law, nothing touches */
    bool uniform;  /* all pairs of materials have the same coefficients */
    bool moduli;   /* springs come from young and poisson of the materials */
    /* By two materials (law_place_of), symmetric; one entry without materials. Owned */
    struct law_coefficients *pair;
    struct law_extra *extra;  /* of a law with parts */
    union law_sticky *sticky; /* of a law with cohesion */
    union law_sticky widest;  /* each number the largest of all pairs: no pair reaches farther (law_part.h) */
    struct law_memory memory;
    int history_components; /* doubles of history a contact */
    int history_odd;        /* as many of them are components of vectors */
    bool spin;              /* particles need angular velocity and torque */
};

/* The place of two materials in a table of materials x materials entries, and in those of a law. Any thread. */
LAW_INLINE size_t law_place_of(int materials, int a, int b) {
    return (size_t)a * (size_t)materials + (size_t)b;
}
LAW_INLINE const struct law_coefficients *law_pair_of(const struct law *law, int a, int b) {
    return &law->pair[law_place_of(law->materials, a, b)];
}
LAW_INLINE const struct law_extra *law_extra_of(const struct law *law, int a, int b) {
    return &law->extra[law_place_of(law->materials, a, b)];
}
LAW_INLINE const union law_sticky *law_sticky_at(const struct law *law, int a, int b) {
    return &law->sticky[law_place_of(law->materials, a, b)];
}

/* The defaults: hertz, restitution, end at zero force, history, no rolling. */
struct law_options law_options_default(void);

/* The normal law's form, springs, largest overlap of an elastic impact and its duration (law_form.h), be it a law of the
 * table or of a file. Any thread. */
const struct law_form *law_form_of(const struct law_options *options);
struct law_springs law_springs_of(const struct law_options *options, const struct law_coefficients *c,
                                  const struct law_extra *extra, double radius, double overlap);
double law_impact_of(const struct law_options *options, const struct law_coefficients *c,
                     const struct law_extra *extra, double mass, double radius, double speed);
double law_duration_of(const struct law_options *options, const struct law_coefficients *c,
                       const struct law_extra *extra, double mass, double radius, double overlap);

/* The largest gap at which spheres of these materials and radii interact, 0 or more; a wall has an infinite radius. Any
 * thread. */
double law_range_of(const struct law *law, int a, int b, double radius_a, double radius_b);

/* The same for any two materials: the largest. Without materials -INFINITY. Any thread. */
double law_range(const struct law *law, double radius_a, double radius_b);

/* Makes the tables of coefficients from the entries of a <= b in `pair` (materials x materials, law_place_of). Fails (user)
 * on values out of range or options that do not go together; `law` then holds nothing. Without materials there is no
 * law to check: nothing touches, has friction or a history. law_free releases; it takes a law that is all zero, too. One
 * thread. */
bool law_prepare(struct law *law, const struct law_options *options, int materials,
                 const struct law_material *material, const struct law_pair *pair, struct error *error);
void law_free(struct law *law);

/* Fails (user) where a part does not combine with the law, or two parts exclude each other; the message names what
 * does combine. Any thread. */
bool law_check_parts(const struct law_options *options, struct error *error);

/* Fails (user) on coefficients of the parts in use that are out of range; `name`: of the two materials. Any
 * thread. */
bool law_check_extra(const struct law_extra *extra, const struct law_options *options,
                     const char *const name[2], struct error *error);

/* Names the law and its parts, those of the defaults left out: "NAME", "NAME, cohesion jkr". Any thread. */
enum { LAW_TITLE_MAX = 128 };
void law_title(const struct law_options *options, char text[LAW_TITLE_MAX]);

#endif
