/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics: one row each. engine/physics.h has the contract and the recipe.
 *
 * PHYSICS_SECTION_TABLE has those that a scene may ask for, as rows ROW(NAME, key, PARTICLES, summary): `key` is the physics'
 * section in a scene. A row stands for these objects of src/physics/NAME/. PARTICLES is OWN if the physics makes particles of its own, and needs all pairs of each on
 * its rank (newton is then off); BODIES if its own particles meet nobody; GRAINS if it makes none:
 *
 *   NAME_physics      struct physics              engine/physics.h
 *   NAME_schema       struct schema_table         the rows of its section (data/scene/schema_rows.h)
 *   NAME_fields       void (struct particles *)   registers its fields (kernel/particles/fields.h)
 *   NAME_observables  struct observable_table     its observables (data/observe/observables_kinds.h)
 *
 * PHYSICS_FINISHED has those of them that derive something from a scene after it has been read, before its box is known. A row stands for
 *
 *   NAME_finish       bool (struct scene *, struct error *)
 *                                                 fills the members that no key names; false: a user's error
 *
 * PHYSICS_ALWAYS has those that every run has, before all others, as the first list of pairs is theirs. A row stands for
 *
 *   NAME_physics      struct physics              without `create`
 *   NAME_start        bool (struct physics_context *, struct error *)
 *                                                 makes its own data and its options, and registers its fields */
#ifndef SCREE_PHYSICS_TABLE_H
#define SCREE_PHYSICS_TABLE_H

#include <stdbool.h>

#define PHYSICS_SECTION_TABLE(ROW)                                                                           \
    ROW(density, number_density, GRAINS,                                                                     \
        "the SPH number density of each particle, sum of W(|x_ij|, support)")                                \
    ROW(drag, drag, GRAINS, "drag and buoyancy of grains in a fluid that does not resolve them")             \
    ROW(heat, heat, GRAINS, "heat that grains conduct through contacts, with walls and through gas")         \
    ROW(bonds, bonds, GRAINS, "parallel bonds that hold grains together until they break")                   \
    ROW(bodies, bodies, BODIES, "rigid bodies: of spheres, which may overlap, and rocks with flat faces")    \
    ROW(blocks, wall_contacts, GRAINS,                                                                       \
        "contacts of walls with walls: a plate on a floor, a drum on rollers")                               \
    ROW(fluid, fluid, OWN, "an incompressible fluid around grains and between walls (implicit SPH)")

/* Physics whose sections stand in `contact` (data/scene/schema_contact.c); PHYSICS_TABLE: all that a scene may ask for. */
#define PHYSICS_CONTACT_TABLE(ROW)                                                                           \
    ROW(hard, contact.solver, GRAINS,                                                                        \
        "a solver finds the forces of contacts at the end of each step: long steps for stiff grains")
#define PHYSICS_TABLE(ROW) PHYSICS_SECTION_TABLE(ROW) PHYSICS_CONTACT_TABLE(ROW)

#define PHYSICS_FINISHED(ROW) ROW(bodies)

#define PHYSICS_ALWAYS(ROW) ROW(grains)

#define PHYSICS_ENUMERATOR(name, key, whose, summary) PHYSICS_##name,
#define PHYSICS_ENUMERATOR_ALWAYS(name) PHYSICS_##name,
enum physics_number {
    PHYSICS_TABLE(PHYSICS_ENUMERATOR) PHYSICS_COUNT, /* those that a scene may ask for */
    PHYSICS_BEFORE_ALWAYS = PHYSICS_COUNT - 1,
    PHYSICS_ALWAYS(PHYSICS_ENUMERATOR_ALWAYS) PHYSICS_ALL
};
#undef PHYSICS_ENUMERATOR
#undef PHYSICS_ENUMERATOR_ALWAYS

/* Every file that uses or defines such an object declares it in this way. */
struct particles;
struct physics_context;
struct scene;
struct error;
#define PHYSICS_DECLARE_FINISH(name) bool name##_finish(struct scene *scene, struct error *error);
#define PHYSICS_DECLARE(name, key, whose, summary)                                                           \
    extern const struct physics name##_physics;                                                              \
    extern const struct schema_table name##_schema;                                                          \
    extern const struct observable_table name##_observables;                                                 \
    void name##_fields(struct particles *particles);
#define PHYSICS_DECLARE_ALWAYS(name)                                                                         \
    extern const struct physics name##_physics;                                                              \
    bool name##_start(struct physics_context *context, struct error *error);
PHYSICS_TABLE(PHYSICS_DECLARE)
PHYSICS_FINISHED(PHYSICS_DECLARE_FINISH)
PHYSICS_ALWAYS(PHYSICS_DECLARE_ALWAYS)
#undef PHYSICS_DECLARE
#undef PHYSICS_DECLARE_FINISH
#undef PHYSICS_DECLARE_ALWAYS

/* The particles that a physics makes. */
enum physics_particles { PHYSICS_GRAINS, PHYSICS_OWN, PHYSICS_BODIES };
static inline enum physics_particles physics_particles(int k) {
#define PHYSICS_PARTICLES(name, key, whose, summary) PHYSICS_##whose,
    static const enum physics_particles of[] = {PHYSICS_TABLE(PHYSICS_PARTICLES)};
#undef PHYSICS_PARTICLES
    return of[k];
}

/* True if physics k makes particles of its own. */
static inline bool physics_has_particles(int k) {
    return physics_particles(k) != PHYSICS_GRAINS;
}

/* Doubles that the options of one physics may take in a scene. */
enum { PHYSICS_OPTIONS_MAX = 12288 };

#endif
