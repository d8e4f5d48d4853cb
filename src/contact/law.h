/* Contact laws: what two spheres (or a sphere and a wall) that touch do to each other.
 *
 * A law sees two particles and a contact; never a loop, a thread or a rank. The functions that the force
 * loops call are the `static inline` ones of law_kernel.h, specialised by constant arguments; this header
 * holds what is prepared once: options and the table of coefficients for each pair of materials.
 *
 * With the overlap d > 0, the approach speed v_n, the effective mass m* and radius R*, and the effective
 * moduli E* and G* of the two materials, the normal force is
 *
 *   hooke   F_n = k_n d + c v_n          c = gamma_n m*, or 2 zeta sqrt(k_n m*) from the restitution
 *   hertz   F_n = K d^(3/2) + c v_n      K = 4/3 E* sqrt(R*),  c = alpha sqrt(m* K) d^(1/4)
 *
 * and with the tangential spring xi, whose history a contact keeps, and the slip velocity v_t the tangential
 * one
 *
 *   both    F_t = -k_t xi - c_t v_t      |F_t| <= mu |F_n|
 *   hooke   k_t                          a stiffness, given like k_n
 *   hertz   k_t = 8 G* sqrt(R* d)        Mindlin
 *
 * docs/physics.md has the other terms, and where all of this comes from. */
#ifndef SCREE_CONTACT_LAW_H
#define SCREE_CONTACT_LAW_H

#include "core/error.h"
#include <stdbool.h>

enum { LAW_MATERIALS_MAX = 32, LAW_NAME_MAX = 64 };

/* The smallest restitution that a contact with end at zero force can have (zeta = 22). */
#define LAW_RESTITUTION_LEAST 5e-4

enum law_normal { LAW_HOOKE, LAW_HERTZ };
/* Where the damping comes from: the restitution asked for, or LAMMPS's coefficients per unit of effective
 * mass. */
enum law_damping { LAW_DAMPING_RESTITUTION, LAW_DAMPING_COEFFICIENT };
/* When a contact ends: at zero overlap (the damper may attract just before), or where the force would
 * attract. */
enum law_end { LAW_END_OVERLAP, LAW_END_FORCE };
enum law_tangential { LAW_FRICTIONLESS, LAW_TANGENTIAL_HISTORY };
/* What the tangential damper sees while the contact slides: the spring's own change, as the slider is in
 * series with both (energy is never made); or all of the slip, the spring being set to what is left of the
 * limit (Luding, Granular Matter 10 (2008) 235; LAMMPS). */
enum law_sliding { LAW_SLIDING_SERIES, LAW_SLIDING_TOTAL };
enum law_rolling { LAW_ROLLING_NONE, LAW_ROLLING_SPRING };

/* Options of the law (scene key `contact`). Plain data. */
struct law_options {
    enum law_normal normal;
    enum law_damping damping;
    enum law_end end;
    enum law_tangential tangential; /* frictionless: no spin, no torque, no history anywhere */
    enum law_sliding sliding;
    enum law_rolling rolling;
    double tangential_damping_ratio; /* restitution: c_t = this x c_n sqrt(k_t / k_n), k_n the tangent
                                        stiffness */
    bool tangential_damping_equal; /* c_t = c_n, as LAMMPS's pair_style granular does; for cross-code runs */
    bool lammps_hooke; /* LAMMPS's gran/hooke/history to the letter: the lever is r, not r - overlap / 2;
                          sliding is TOTAL, the spring is projected, not turned, and an empty spring over the
                          Coulomb limit gives no force */
    bool synchronised; /* history with the half-step normal (Vyas et al. 2025); set from the integrator */
};

/* A material (scene key `materials`). */
struct law_material {
    char name[LAW_NAME_MAX];
    double density;        /* mass/volume */
    double young, poisson; /* hertz; pressure, 1 */
};

/* Coefficients of a pair of materials (scene key `material_pairs`; missing pairs are an error unless one
 * default is given). */
struct law_pair {
    double restitution;      /* 0 ... 1 */
    double friction;         /* Coulomb coefficient mu >= 0 */
    double rolling_friction; /* mu_r >= 0 */
    double k_n, k_t;         /* hooke: stiffness, force/length */
    double gamma_n, gamma_t; /* hooke with given coefficients: 1/time, per unit of effective mass */
};

/* What the kernel needs of a pair of materials, made once. */
struct law_coefficients {
    double k_n; /* hooke: k_n; hertz: 4/3 E*, times the contact radius sqrt(R* d) */
    double k_t; /* hooke: k_t; hertz: 8 G*, likewise */
    double c_n; /* coefficients given: gamma_n, times m*; restitution: 2 zeta (hooke) or alpha (hertz), times
                   sqrt(m* x elastic force / overlap) */
    double c_t; /* the same for the tangential damper; the rolling spring takes k_t and c_t too */
    double friction, rolling_friction;
};

struct law {
    struct law_options options;
    int materials;
    bool uniform; /* all pairs of materials have the same coefficients */
    struct law_coefficients pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX]; /* symmetric */
    double range;           /* how far beyond touch the law acts: 0 here */
    int history_components; /* doubles of history a contact: 0, 3 or 6 */
    bool spin;              /* particles need angular velocity and torque */
};

/* The defaults: hertz, restitution, end at zero force, history, no rolling. */
struct law_options law_options_default(void);

/* Makes the table of coefficients from the entries pair[a][b], a <= b < materials. Fails (user) on values out
 * of range or options that do not go together. One thread. */
bool law_prepare(struct law *law, const struct law_options *options, int materials,
                 const struct law_material *material,
                 struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX], struct error *error);

/* Damping ratio zeta of the linear spring-dashpot for a restitution e. End at zero overlap: zeta = -ln e /
 * sqrt(pi^2 + ln^2 e), 1 for e = 0. End at zero force: inverts e(zeta) of Schwager and Poeschel (Granular
 * Matter 9 (2007) 465); there e = 0 needs an infinite damper, and e below LAW_RESTITUTION_LEAST is taken as
 * that. */
double law_hooke_damping_ratio(double restitution, enum law_end end);

/* By which part of Coulomb's impulse, mu (1 + e) m* v, the friction of an impact that slides throughout
 * exceeds it: 0 where the contact ends at zero force; where it ends at zero overlap the limit counts the
 * damper's pull, too: 2 (e_F - e) / (1 + e), e_F being what e would be if the same damper ended at zero force
 * (both laws; docs/physics.md). */
double law_end_friction(double restitution, enum law_end end);

/* The Hertz damping coefficient alpha for a restitution, for either end: sqrt(5) zeta, as overlap^(5/4) turns
 * the damped Hertz contact into a linear spring-dashpot (Antypov and Elliott, EPL 94 (2011) 50004;
 * docs/physics.md). */
double law_hertz_alpha(double restitution, enum law_end end);

#endif
