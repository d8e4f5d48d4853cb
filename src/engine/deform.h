/* SPDX-License-Identifier: BSD-3-Clause */
/* The box in motion: shear across Lees-Edwards boundaries, and strain (kernel/particles/box.h). In a step the box moves
 * with the particles; pairs keep their images, whose shifts and velocities follow (pairlist_follow). At a
 * rebuild the offset of the shear is brought back within half an edge, and the division among ranks learns which
 * subdomains face each other now. A box at rest never comes here. */
#ifndef SCREE_ENGINE_DEFORM_H
#define SCREE_ENGINE_DEFORM_H

#include "engine/state.h"

/* Prepares the servo, and the skin of a box that moves, once the skin exists; and frees what it made. */
void deform_prepare(struct box_servo *servo, const struct box *box, const struct scene *scene,
                    struct skin *skin, int threads);
void deform_free(struct box_servo *servo);

/* Adds the mean flow to the velocities of the owned particles, if the scene asks for this: at the start. */
void deform_start(const struct box *box, const struct scene *scene, struct particles *particles);

/* Prepares the servo of the stress, once the particles are known. Collective. */
void deform_begin(struct box_servo *servo, const struct box *box, const struct scene *scene,
                  const struct particles *particles, const struct comm *comm);

/* After the forces of a step: sets the rates of the edges and of the shear that follow the stress. The edge along d moves at the speed (stress - target) / Z, where Z = sqrt(rho K) is
 * the acoustic impedance of the packing, so that the face of the box takes up sound as more of the packing would.
 * K is found from the work W = sum f l and the energy E = sum k overlap^2 / 2 of the contacts: K = 0.3 W^2 / (E V),
 * an upper estimate (docs/physics.md), so that the servo is overdamped for soft and for hard grains. The rate of the
 * shear is 4 excess / (Z L) + the integral of excess / (4 rho L^2) over time, of the longest edge L: a packing that
 * flows comes to its target, too. With `reproducible` the stress is summed without rounding. Collective. */
void deform_control(struct simulation *simulation);

/* Before a step: gives the particles the change of the mean flow, if the rates of the box have changed, or if its
 * edges have. */
void deform_flow(struct box *box, struct particles *particles);

/* Moves the box by a step of the clock, and the pairs with it. An error if an edge becomes too short for the particles. */
void deform_advance(struct box *box, struct interactions *interactions, const struct size_classes *classes,
                    const struct clock *clock, struct error *error);

/* Prepares the box for a rebuild: before positions are wrapped. */
void deform_settle(struct box *box, struct domain *domain);

/* True if these numbers of a checkpoint are of a box that has moved. */
bool deform_moved(const struct restart_values *values);

/* Adds the numbers that a resume needs. */
void deform_restart(struct box *box, struct box_servo *servo, struct restart *restart);

/* True if the checkpoint of these numbers is of a box whose images are not where this scene has them; then an
 * error. */
bool deform_check(const struct box *box, const struct restart_values *values, const char *path,
                  struct error *error);

#endif
