/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts that a contact law may have besides its springs (law_form.h), its damper and friction: cohesion, a
 * choice of tangential, rolling and twisting resistance, of dampers, plasticity. Each kind of part has a table
 * here; a row says with which laws of law_table.h the part combines. A scene that asks for no part goes
 * through the vectorised loops of force_physics.h, specialised for its law. A law with parts goes through the
 * general loop (force_general.c), which costs more. Where its parts are those of the normal direction alone, the
 * general loop has vectorised loops, too: force_grip.h for the normal direction of laws with one, and
 * force_physics.h for sliding and rolling.
 *
 * How to add a part:
 *
 *   1. Write src/physics/grains/laws/parts/KIND_NAME.h like its neighbours (physics/grains/laws/parts/cohesion_dmt.h is the shortest
 *      cohesion): law_part.h says what it states.
 *      The functions of the pull of a cohesion are arithmetic without branches.
 *   2. Include it here, and add a row to the table of its kind: LAW_PULL_TABLE for a cohesion that pulls beside the springs.
 *   3. `make pages` writes its keys to docs/scene.md; describe the formula with its source in docs/physics.md, and name the part in
 *      README.md, "More than dry grains".
 *   4. examples/step-fraction.sh finds the errors of a cohesion's impacts, its `step_error`; zeros: `scree check` knows none.
 *
 * The scene's names and keys, the check of ranges and of what combines, the loops of all instruction sets, the range of the
 * search, the help and `scree check` then know the part. tests/physics/grains/laws/test_law_parts.c compares each cohesion's force with the slope of its
 * energy, and each loop with single contacts. */
#ifndef SCREE_LAWS_LAW_PARTS_H
#define SCREE_LAWS_LAW_PARTS_H

#include "physics/grains/laws/parts/cohesion_capillary.h"
#include "physics/grains/laws/parts/cohesion_dmt.h"
#include "physics/grains/laws/parts/cohesion_jkr.h"
#include "physics/grains/laws/parts/cohesion_sjkr.h"
#include "physics/grains/laws/parts/cohesion_van_der_waals.h"
#include "physics/grains/laws/parts/damping_coefficient.h"
#include "physics/grains/laws/parts/damping_restitution.h"
#include "physics/grains/laws/parts/damping_tsuji.h"
#include "physics/grains/laws/parts/damping_viscoelastic.h"
#include "physics/grains/laws/parts/rolling_constant.h"
#include "physics/grains/laws/parts/rolling_epsd.h"
#include "physics/grains/laws/parts/rolling_spring.h"
#include "physics/grains/laws/parts/twisting_marshall.h"
#include "physics/grains/laws/parts/twisting_sds.h"

/* Rows: NAME, name in scenes, traits of the laws (law_table.h) that the part combines with, for whom the part is. */

/* Cohesions that take the place of a law's force at touch: KIND_NAME_grip. */
#define LAW_ADHESION_TABLE(ROW)                                                                              \
    ROW(JKR, jkr, "elastic yield",                                                                           \
        "fine, soft, sticky powders: elastic spheres with surface energy, whose contact area grows with it")

/* Cohesions that pull beside a law's springs: KIND_NAME_pull. */
#define LAW_PULL_TABLE(ROW)                                                                                  \
    ROW(DMT, dmt, "moduli stiff",                                                                            \
        "fine, hard powders: the elastic force less a constant pull while the spheres touch")                \
    ROW(SJKR, sjkr, "stiffness moduli",                                                                      \
        "cohesive bulk solids with a calibrated number: area of the overlap times an energy density")        \
    ROW(CAPILLARY, capillary, "stiffness moduli",                                                            \
        "wet sand and damp powders: a liquid bridge that forms at touch and breaks at its rupture distance") \
    ROW(VAN_DER_WAALS, van_der_waals, "stiffness moduli",                                                    \
        "particles of micrometres: Hamaker's attraction up to a cut-off distance")
#define LAW_COHESION_PARTS(ROW) LAW_ADHESION_TABLE(ROW) LAW_PULL_TABLE(ROW)
#define LAW_COHESION_TABLE(ROW)                                                                              \
    ROW(NONE, none, "stiffness moduli stiff", "dry grains") LAW_COHESION_PARTS(ROW)

#define LAW_TANGENTIAL_TABLE(ROW)                                                                            \
    ROW(NONE, none, "stiffness moduli stiff", "no friction: no spin, no torque, no history anywhere")        \
    ROW(HISTORY, history, "stiffness moduli stiff", "a spring with history, up to Coulomb's limit")          \
    ROW(RESCALE, rescale, "moduli",                                                                          \
        "the same, and the spring shrinks with the contact radius on unloading (mindlin_rescale)")           \
    ROW(FORCE, force, "stiffness moduli", "remembers the force, not the displacement (mindlin/force)")       \
    ROW(RESCALE_FORCE, rescale_force, "moduli", "both of these (mindlin_rescale/force)")                     \
    ROW(VISCOUS, viscous, "stiffness moduli",                                                                \
        "a dashpot up to Coulomb's limit, without memory: flows, not heaps")

#define LAW_ROLLING_PARTS(ROW)                                                                               \
    ROW(SPRING, spring, "stiffness moduli stiff",                                                            \
        "a spring and dashpot against rolling, up to a limit (Luding 2008; rolling sds of LAMMPS where "     \
        "rolling_stiffness is given)")                                                                       \
    ROW(EPSD, epsd, "stiffness moduli",                                                                      \
        "elastic-plastic spring and dashpot, type C of Ai et al. 2011: heaps that stand")                    \
    ROW(CONSTANT, constant, "stiffness moduli stiff",                                                        \
        "constant torque against the rolling, type A of Ai et al. 2011: flows; trembles at rest")
#define LAW_ROLLING_TABLE(ROW)                                                                               \
    ROW(NONE, none, "stiffness moduli stiff", "round, smooth grains") LAW_ROLLING_PARTS(ROW)

#define LAW_TWISTING_PARTS(ROW)                                                                              \
    ROW(SDS, sds, "stiffness moduli stiff",                                                                  \
        "spring and dashpot up to a limit, all given (twisting sds of LAMMPS)")                              \
    ROW(MARSHALL, marshall, "stiffness moduli",                                                              \
        "from the tangential spring and the contact radius, nothing given (twisting marshall of LAMMPS)")
#define LAW_TWISTING_TABLE(ROW)                                                                              \
    ROW(NONE, none, "stiffness moduli stiff", "no resistance to turning about the normal")                   \
    LAW_TWISTING_PARTS(ROW)

#define LAW_DAMPING_TABLE(ROW)                                                                               \
    ROW(RESTITUTION, restitution, "stiffness moduli stiff", "from the given restitution, at any speed")      \
    ROW(COEFFICIENT, coefficient, "stiffness moduli",                                                        \
        "from gamma_n and gamma_t, per unit of effective mass, as in LAMMPS")                                \
    ROW(VISCOELASTIC, viscoelastic, "stiffness moduli",                                                      \
        "viscoelastic material, whose restitution falls with the speed (Brilliantov et al. 1996)")           \
    ROW(TSUJI, tsuji, "moduli", "from the restitution by the fit of Tsuji et al. 1992, for comparisons")

#define LAW_COHESION_ENUMERATOR(NAME, name, with, summary) LAW_COHESION_##NAME,
#define LAW_TANGENTIAL_ENUMERATOR(NAME, name, with, summary) LAW_TANGENTIAL_##NAME,
#define LAW_ROLLING_ENUMERATOR(NAME, name, with, summary) LAW_ROLLING_##NAME,
#define LAW_TWISTING_ENUMERATOR(NAME, name, with, summary) LAW_TWISTING_##NAME,
#define LAW_DAMPING_ENUMERATOR(NAME, name, with, summary) LAW_DAMPING_##NAME,
enum law_cohesion { LAW_COHESION_TABLE(LAW_COHESION_ENUMERATOR) LAW_COHESION_COUNT };
enum law_tangential { LAW_TANGENTIAL_TABLE(LAW_TANGENTIAL_ENUMERATOR) LAW_TANGENTIAL_COUNT };
enum law_rolling { LAW_ROLLING_TABLE(LAW_ROLLING_ENUMERATOR) LAW_ROLLING_COUNT };
enum law_twisting { LAW_TWISTING_TABLE(LAW_TWISTING_ENUMERATOR) LAW_TWISTING_COUNT };
enum law_damping { LAW_DAMPING_TABLE(LAW_DAMPING_ENUMERATOR) LAW_DAMPING_COUNT };
#define LAW_FRICTIONLESS LAW_TANGENTIAL_NONE

/* The damping of a scene that names none. */
#define LAW_DAMPING_DEFAULT LAW_DAMPING_RESTITUTION
#define LAW_DAMPING_DEFAULT_NAME "restitution"

/* The kinds of parts. */
enum law_part {
    LAW_PART_COHESION,
    LAW_PART_TANGENTIAL,
    LAW_PART_ROLLING,
    LAW_PART_TWISTING,
    LAW_PART_DAMPING,
    LAW_PART_COUNT
};

struct law_part_row {
    const char *name, *with, *summary;
};

/* The key of a kind of part below `contact`, its rows and their number. Any thread. */
const char *law_part_key(enum law_part part);
const struct law_part_row *law_part_rows(enum law_part part, int *count);

/* True if a row combines with a law of these traits. */
bool law_part_combines(const struct law_part_row *row, const char *traits);

/* Coefficients of a pair of materials beside those of struct law_pair; only those of the law and of the parts in use are read. Each
 * part has its own, by KIND_NAME. */
#define LAW_COHESION_GIVEN(NAME, name, with, summary) struct cohesion_##name##_given cohesion_##name;
#define LAW_ROLLING_GIVEN(NAME, name, with, summary) struct rolling_##name##_given rolling_##name;
#define LAW_TWISTING_GIVEN(NAME, name, with, summary) struct twisting_##name##_given twisting_##name;
#define LAW_DAMPING_GIVEN(NAME, name, with, summary) struct damping_##name##_given damping_##name;
struct law_extra {
    LAW_COHESION_PARTS(LAW_COHESION_GIVEN)
    LAW_ROLLING_PARTS(LAW_ROLLING_GIVEN)
    LAW_TWISTING_PARTS(LAW_TWISTING_GIVEN)
    LAW_DAMPING_TABLE(LAW_DAMPING_GIVEN)
    double static_friction; /* limit of a contact that sticks; below `friction`: `friction` */
    double k_2,
        k_c; /* laws with hysteresis: slopes of the unloading and of the adhesive branch; force/length */
    double
        plasticity_depth;  /* overlap over the reduced radius at which the slope is k_2; 0: at any overlap */
    double yield_pressure; /* laws with yield: pressure */
    double plasticity_ratio;              /* eepa: lambda_p = 1 - k_1/k_2, 0 ... below 1 */
    double adhesion_exponent;             /* eepa: chi of the adhesive branch */
    double adhesion_energy;               /* eepa: delta gamma of the adhesive branch; energy/area */
    double pull_off;                      /* eepa: constant pull while the surfaces touch; force */
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

/* What the formula of the cohesion in use takes of a pair of materials, made once: columns of a batch of contacts. */
#define LAW_COHESION_NUMBERS(NAME, name, with, summary) struct cohesion_##name name;
union law_sticky {
    LAW_COHESION_PARTS(LAW_COHESION_NUMBERS)
};
enum { LAW_STICKY = sizeof(union law_sticky) / sizeof(double) };

/* A key of `material_pairs` that the part `name` of a kind has: its place in struct law_extra, and the members of a row of the schema
 * (data/scene/schema_rows.h). */
struct law_given_key {
    enum law_part part;
    const char *name;
    size_t offset;
    const char *key, *range, *unit, *fallback, *help, *example;
    bool required;
};

/* The keys of all parts, and their number. Any thread. */
const struct law_given_key *law_given_keys(int *count);

/* The properties of a cohesion. With a constant the compiler drops the others. */
static const struct law_cohesion_form law_cohesion_none = {.press = 1.0};
LAW_INLINE const struct law_cohesion_form *law_cohesion_form_of(enum law_cohesion cohesion) {
#define LAW_PART_CASE(NAME, name, with, summary)                                                             \
    case LAW_COHESION_##NAME:                                                                                \
        return &cohesion_##name##_form;
    switch (cohesion) {
        LAW_COHESION_PARTS(LAW_PART_CASE)
    case LAW_COHESION_NONE:
    case LAW_COHESION_COUNT:
        break;
    }
#undef LAW_PART_CASE
    return &law_cohesion_none;
}

/* True for a cohesion of LAW_ADHESION_TABLE. */
LAW_INLINE bool law_adheres(enum law_cohesion cohesion) {
#define LAW_PART_CASE(NAME, name, with, summary) || cohesion == LAW_COHESION_##NAME
    return false LAW_ADHESION_TABLE(LAW_PART_CASE);
#undef LAW_PART_CASE
}

/* The properties of a rolling resistance and of a damping. */
static const struct law_rolling_form law_rolling_none = {.plain = true};
static inline const struct law_rolling_form *law_rolling_form_of(enum law_rolling rolling) {
#define LAW_PART_CASE(NAME, name, with, summary)                                                             \
    case LAW_ROLLING_##NAME:                                                                                 \
        return &rolling_##name##_form;
    switch (rolling) {
        LAW_ROLLING_PARTS(LAW_PART_CASE)
    case LAW_ROLLING_NONE:
    case LAW_ROLLING_COUNT:
        break;
    }
#undef LAW_PART_CASE
    return &law_rolling_none;
}

static inline const struct law_damping_form *law_damping_form_of(enum law_damping damping) {
    static const struct law_damping_form none = {0};
#define LAW_PART_CASE(NAME, name, with, summary)                                                             \
    case LAW_DAMPING_##NAME:                                                                                 \
        return &damping_##name##_form;
    switch (damping) {
        LAW_DAMPING_TABLE(LAW_PART_CASE)
    case LAW_DAMPING_COUNT:
        break;
    }
#undef LAW_PART_CASE
    return &none;
}

/* The numbers of a cohesion from the coefficients of the law and of the parts. Any thread. */
union law_sticky law_sticky_of(enum law_cohesion cohesion, const struct law_coefficients *c,
                               const struct law_extra *extra);

/* Raises each number of `widest` to that of a pair of materials. Any thread. */
void law_sticky_widen(enum law_cohesion cohesion, union law_sticky *widest, const union law_sticky *pair);

/* What a solver makes of a resistance with these coefficients; of `none` nothing. Any thread. */
struct law_solved law_rolling_solved(enum law_rolling rolling, const struct law_extra *extra);
struct law_solved law_twisting_solved(enum law_twisting twisting, const struct law_extra *extra);

/* True if a rolling resistance with these coefficients needs the general loop. Any thread. */
bool law_rolling_general(enum law_rolling rolling, const struct law_extra *extra);

#endif
