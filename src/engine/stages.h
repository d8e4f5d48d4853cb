/* SPDX-License-Identifier: BSD-3-Clause */
/* The stages of a run, to which the timers charge its time: those of the passes of the active physics and
 * those of the engine itself. A pass names its stage; passes that name the same one share it. */
#ifndef SCREE_ENGINE_STAGES_H
#define SCREE_ENGINE_STAGES_H

#include "base/timer.h"
#include "engine/physics_set.h"

/* Registers the stages of a run with these physics, whether or not a pass of the stage will run: runs of a
 * scene on other ranks and in other orders have the same stages. */
void stages_register(struct timers *timers, const struct physics *const *physics, int count);

/* Registers the first stage alone, that of the set-up; returns its number. */
int stages_begin(struct timers *timers);

/* Registers the stages of all physics that there are, for the documentation. */
void stages_register_all(struct timers *timers);

/* The stage of a physics' pass, or of a name; the stage is registered. */
int stages_of_pass(const struct timers *timers, const struct physics_pass *pass);
int stages_find(const struct timers *timers, const char *name);

#endif
