/* SPDX-License-Identifier: BSD-3-Clause */
/* In a step new values of particles go to their copies on other ranks. */
#ifndef SCREE_ENGINE_VALUES_H
#define SCREE_ENGINE_VALUES_H

#include "kernel/comm/ghosts.h"

/* Sends the values; receives those of others, and clears the forces of copies. Collective, in pairs. */
void values_send(struct ghosts *ghosts, struct particles *particles);
void values_receive(struct ghosts *ghosts, struct particles *particles);

#endif
