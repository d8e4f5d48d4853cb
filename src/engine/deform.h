/* SPDX-License-Identifier: BSD-3-Clause */
/* The box in motion: shear across Lees-Edwards boundaries, and strain (particles/box.h). In a step the box moves
 * with the particles; pairs keep their images, whose shifts and velocities follow (pairlist_follow). At a
 * rebuild the offset of the shear is brought back within half an edge, and the division among ranks learns which
 * subdomains face each other now. A box at rest never comes here. */
#ifndef SCREE_ENGINE_DEFORM_H
#define SCREE_ENGINE_DEFORM_H

#include "engine/state.h"

/* Prepares the parts of a simulation whose box moves, once they exist. */
void deform_prepare(struct simulation *simulation);

/* Adds the mean flow to the velocities of the owned particles, if the scene asks for this: at the start. */
void deform_start(struct simulation *simulation);

/* Moves the box by a step. */
void deform_advance(struct simulation *simulation);

/* Prepares the box for a rebuild: before positions are wrapped. */
void deform_settle(struct simulation *simulation);

/* Adds the numbers that a resume needs. */
void deform_restart(struct simulation *simulation, struct restart *restart);

/* True if the checkpoint of these numbers is of a box whose images are not where this scene has them; then an
 * error. */
bool deform_check(const struct simulation *simulation, const struct restart_values *values, const char *path,
                  struct error *error);

#endif
