/* SPDX-License-Identifier: BSD-3-Clause */
/* The skin that a run chooses by itself (`skin: auto`): kernel/pairs/skin_choice.h has the model, and this file gives the
 * model its counts and sets the skins. A choice depends on counts and displacements alone, so a run is the same
 * each time, and in reproducible mode the same on all layouts. */
#ifndef SCREE_ENGINE_SKIN_AUTO_H
#define SCREE_ENGINE_SKIN_AUTO_H

#include "engine/state.h"
#include "data/formats/restart.h"

/* The options of the size classes, with the skin that is chosen at present. */
struct classes_options skin_auto_options(const struct scene *scene, const struct skin_choice *choice);

/* At the beginning of a rebuild, while the last pair list is there: chooses the skin for the lists to come.
 * Collective. */
void skin_auto_choose(struct simulation *simulation);

/* Before a step: true if so few displacements have used so little of the skin for so long that a rebuild with
 * a shorter skin saves more than the rebuild costs. Collective, and the same on every rank. */
bool skin_auto_due(struct simulation *simulation);

/* The largest factor on the skins of the scene that the box allows; `alone`: on one rank. */
double skin_auto_most(const struct skin_choice *choice, const struct size_classes *classes,
                      const struct scene *scene, const struct box *box, bool alone);

/* Lists the numbers that a resume needs. */
void skin_auto_restart(struct skin_choice *choice, struct restart *restart);

#endif
