/* SPDX-License-Identifier: BSD-3-Clause */
/* In a step new values of particles go to their copies on other ranks. */
#ifndef SCREE_ENGINE_VALUES_H
#define SCREE_ENGINE_VALUES_H

struct simulation;

/* Sends the values; receives those of others, and clears the forces of copies. Collective, in pairs. */
void values_send(struct simulation *simulation);
void values_receive(struct simulation *simulation);

#endif
