/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of src/physics/grains: the functions of its facets (engine/physics.h), by file. */
#ifndef SCREE_GRAINS_GRAINS_OWN_H
#define SCREE_GRAINS_GRAINS_OWN_H

#include "physics/grains/grains.h"

/* start.c: frees what grains_start made; refuses vector instructions that the CPU lacks. */
void start_end(void *self);
bool start_simd(const struct physics_context *context, struct error *error);

/* stable.c: of struct physics_mover. */
double stable_find(const struct physics_context *context);
void stable_why(const struct physics_context *context, char *text, size_t room);

/* A step of at most `most` that is stable for the present contacts: `most` itself if `most` is stable. The
 * step is never above the true limit of these contacts, and equals the limit if the bound of physics/grains/motion/stability.h is
 * sharp. Needs pairs and, with several ranks, copies at the positions of their originals. Collective; all
 * ranks get the same step. */
double limit_of_contacts(const struct physics_context *context, double most);

/* grains_balance.c: the overlap of the last evaluation against its guard; energies. */
void grains_guard(const struct physics_context *context, struct error *error);
void grains_energies(const struct physics_context *context, bool mechanical, double energy[GRAINS_ENERGIES]);

/* Walls as what grains meet; the part of a checkpoint; notes on walls. */
extern const struct physics_obstacles grains_obstacles;
extern const struct physics_record grains_record;
void grains_notes(const struct physics_context *context, struct notes *notes);
void grains_notes_seen(const struct physics_context *context, uint64_t first, struct notes *notes);

#endif
