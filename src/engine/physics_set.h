/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics of a run as one: each function asks all active physics that have a part in its matter. Read physics.h first. */
#ifndef SCREE_ENGINE_PHYSICS_SET_H
#define SCREE_ENGINE_PHYSICS_SET_H

#include "engine/physics.h"

/* A physics of a run, and all of them. */
struct physics_active {
    const struct physics *row;
    int number; /* enum physics_number */
    struct physics_context context;
    int first; /* number of the first interaction of the physics */
};
struct physics_set {
    int count;
    struct physics_active active[PHYSICS_ALL];
    const struct physics_active *mover;     /* the one that moves the grains */
    const struct physics_active *obstacles; /* the one with this facet; NULL: none */
    struct interactions *interactions;      /* borrowed */
    double (
        *speed)[CLASS_MAX]; /* [thread][class]: largest squared speed of the last drift, raised by passes by
                                   rows; borrowed */
};

/* The active physics behind `before` (NULL: the first one) with a member, by its offset in struct physics, that is not
 * NULL; NULL: no more. */
const struct physics_active *physics_next(const struct physics_set *set, const struct physics_active *before,
                                          size_t member);
#define PHYSICS_EACH(active, set, member)                                                                    \
    for (const struct physics_active *active = NULL;                                                         \
         (active = physics_next(set, active, offsetof(struct physics, member))) != NULL;)

/* Starts the physics that are always there, which register their fields, then those that the scene asks for; adds their
 * interactions. `context` has all members but self, options and lists. Collective; errors may differ between ranks. */
bool physics_begin(struct physics_set *set, const struct physics_context *context,
                   struct interactions *interactions, struct error *error);

/* The row of a physics: of those that a scene may ask for, then of those that are always there; the key of its section. */
const struct physics *physics_get(enum physics_number number);
const char *physics_key(enum physics_number number);

/* Checks the options of all physics, and creates the own data of those that the scene asks for. */
bool physics_create(struct physics_set *set, struct error *error);
void physics_free(struct physics_set *set);

/* The own data of each physics that a scene may ask for; NULL of those that are not in the run. */
void physics_own(const struct physics_set *set, const void *own[PHYSICS_COUNT]);

/* Adds the particles of all physics. Collective; errors may differ between ranks. */
bool physics_fill(const struct physics_set *set, const struct physics_share *share, struct error *error);

/* The sphere `number` of a grain that enters: itself, or what a physics makes of it; false: it has no more. */
bool physics_part(const struct physics_set *set, const struct physics_grain *grain, int number,
                  struct physics_part *part);

/* The number of particles that a physics adds to a grain that enters, and the mass of what it becomes. */
int64_t physics_parts(const struct physics_set *set, const struct physics_grain *grain);
double physics_mass(const struct physics_set *set, const struct physics_grain *grain);

/* Particle k of this rank has been appended, and becomes what a physics makes of it; ids from first_id on are free. */
void physics_join(const struct physics_set *set, size_t k, int64_t first_id);

/* False, with a user's error, if a physics refuses that the calling program adds this grain, or (NULL) deletes any. Collective. */
bool physics_admit(const struct physics_set *set, const struct physics_grain *grain, struct error *error);

/* Gives each physics its lists, after the interactions with their own lists are known
 * (interactions_divide). */
void physics_lists(struct physics_set *set, const struct interactions *interactions);

/* Tells each mover of another evaluation, or of another length of steps. */
void physics_prepare(const struct physics_set *set);

/* Calls `rebuilt` of all physics, after the search of a rebuild. True if the engine must rebuild again. */
bool physics_rebuilt(struct physics_set *set, struct ghosts *ghosts);

/* True if no physics reads its lists until the next rebuild. */
bool physics_rests(const struct physics_set *set);

/* True if a physics needs a rebuild in the step in progress. */
bool physics_due(const struct physics_set *set);

/* The rows of all physics, by number, with their components; NULL where a physics has none. */
void physics_rows(const struct physics_set *set, struct history_rows *rows[PHYSICS_COUNT]);

/* This rank's parts of all in the balance of energies. */
void physics_energies(const struct physics_set *set, struct physics_energy *energy);

/* True if the set's obstacles are there and take part. */
bool physics_meets(const struct physics_set *set);

/* Sides of contacts in the last evaluation of forces, this rank's. */
int64_t physics_contact_sides(const struct physics_set *set);

/* True if a sphere at x (box-relative) would overlap an obstacle. Any thread. */
bool physics_occupied(const struct physics_set *set, const double x[3], double radius);

/* Calls `full_step` of all physics. Collective. */
void physics_full_step(const struct physics_set *set);

/* Runs the passes before output, after physics_full_step. Collective. */
void physics_look(const struct physics_set *set);

/* The smallest limit of all physics; `again`: in a run, of those that do not stay. */
double physics_limit(const struct physics_set *set, double most, bool again);

/* The cause of a limit, if that of a physics which tells causes is no larger; else NULL. Collective. */
const char *physics_limit_why(const struct physics_set *set, double limit);

/* The restart numbers of all physics. */
void physics_restart(const struct physics_set *set, struct restart *restart);

#endif
