/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts that a contact law may have besides its springs (law_form.h), its damper and friction: cohesion, a
 * choice of tangential, rolling and twisting resistance, of dampers, plasticity. Each kind of part has a table
 * here; a row says with which laws of law_table.h the part combines. A scene that asks for no part goes
 * through the vectorised loops of force_physics.h, specialised for its law. A law with parts goes through the
 * general loop (force_general.c), which costs more. Where its parts are those of the normal direction alone, the
 * general loop has vectorised loops, too: force_grip.h for the normal direction of the laws that it lists, and
 * force_physics.h for sliding and rolling.
 *
 * How to add a part:
 *
 *   1. Add a row to its table here, and its coefficients to struct law_extra (law_form.h).
 *   2. Write its formula: the pull of a cohesion in law_cohesion.h and its energy in law_cohesion.c (with a row of
 *      the table in force_grip.h the pull is vectorised), resistances in law_resist.c.
 *   3. Add the keys of the coefficients to src/data/scene/schema_contact.c, and the formula with its source to
 *      docs/physics.md.
 *
 * The scene's names, the check of what combines, the help and `scree check` then know the part.
 * tests/test_law_parts.c compares each cohesion's force with the slope of its energy. */
#ifndef SCREE_LAWS_LAW_PARTS_H
#define SCREE_LAWS_LAW_PARTS_H

#include "physics/grains/laws/law_form.h"

/* Rows: NAME, name in scenes, traits of the laws (law_table.h) that the part combines with, for whom the part is. */
#define LAW_COHESION_TABLE(ROW)                                                                              \
    ROW(NONE, none, "stiffness moduli stiff", "dry grains")                                                  \
    ROW(JKR, jkr, "elastic yield",                                                                           \
        "fine, soft, sticky powders: elastic spheres with surface energy, whose contact area grows with it") \
    ROW(DMT, dmt, "moduli",                                                                                  \
        "fine, hard powders: the elastic force less a constant pull while the spheres touch")                \
    ROW(SJKR, sjkr, "stiffness moduli",                                                                      \
        "cohesive bulk solids with a calibrated number: area of the overlap times an energy density")        \
    ROW(CAPILLARY, capillary, "stiffness moduli",                                                            \
        "wet sand and damp powders: a liquid bridge that forms at touch and breaks at its rupture distance") \
    ROW(VAN_DER_WAALS, van_der_waals, "stiffness moduli",                                                    \
        "particles of micrometres: Hamaker's attraction up to a cut-off distance")

#define LAW_TANGENTIAL_TABLE(ROW)                                                                            \
    ROW(NONE, none, "stiffness moduli stiff", "no friction: no spin, no torque, no history anywhere")        \
    ROW(HISTORY, history, "stiffness moduli stiff", "a spring with history, up to Coulomb's limit")          \
    ROW(RESCALE, rescale, "moduli",                                                                          \
        "the same, and the spring shrinks with the contact radius on unloading (mindlin_rescale)")           \
    ROW(FORCE, force, "stiffness moduli", "remembers the force, not the displacement (mindlin/force)")       \
    ROW(RESCALE_FORCE, rescale_force, "moduli", "both of these (mindlin_rescale/force)")                     \
    ROW(VISCOUS, viscous, "stiffness moduli",                                                                \
        "a dashpot up to Coulomb's limit, without memory: flows, not heaps")

#define LAW_ROLLING_TABLE(ROW)                                                                               \
    ROW(NONE, none, "stiffness moduli stiff", "round, smooth grains")                                        \
    ROW(SPRING, spring, "stiffness moduli",                                                                  \
        "a spring and dashpot against rolling, up to a limit (Luding 2008; rolling sds of LAMMPS where "     \
        "rolling_stiffness is given)")                                                                       \
    ROW(EPSD, epsd, "stiffness moduli",                                                                      \
        "elastic-plastic spring and dashpot, type C of Ai et al. 2011: heaps that stand")                    \
    ROW(CONSTANT, constant, "stiffness moduli",                                                              \
        "constant torque against the rolling, type A of Ai et al. 2011: flows; trembles at rest")

#define LAW_TWISTING_TABLE(ROW)                                                                              \
    ROW(NONE, none, "stiffness moduli stiff", "no resistance to turning about the normal")                   \
    ROW(SDS, sds, "stiffness moduli",                                                                        \
        "spring and dashpot up to a limit, all given (twisting sds of LAMMPS)")                              \
    ROW(MARSHALL, marshall, "stiffness moduli",                                                              \
        "from the tangential spring and the contact radius, nothing given (twisting marshall of LAMMPS)")

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

/* Where a contact of JKR ends as it is pulled apart: at the pull-off distance, where no equilibrium is left at
 * a given distance; or at the largest pull, which a given force cannot exceed (LAMMPS). */
enum law_jkr_end { LAW_JKR_END_DISTANCE, LAW_JKR_END_FORCE };

/* True if two surfaces need to have touched to attract each other across a gap. */
LAW_INLINE bool law_cohesion_remembers(enum law_cohesion cohesion) {
    return cohesion == LAW_COHESION_JKR || cohesion == LAW_COHESION_CAPILLARY;
}

#endif
