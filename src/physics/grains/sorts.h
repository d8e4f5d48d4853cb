/* SPDX-License-Identifier: BSD-3-Clause */
/* The sorts of grains of a run: what the stable step and the expected overlaps need to know of the particles, those of
 * insertions included. Particles of one material may differ in density, and are divided into sorts by powers of two of
 * the density. At every size a sort counts with its least density if that is the worst case, else with its largest. */
#ifndef SCREE_GRAINS_SORTS_H
#define SCREE_GRAINS_SORTS_H

#include "physics/grains/motion/timestep.h"
#include "engine/physics.h"

enum { SORTS_DENSITIES = 16, SORTS_MAX = LAW_MATERIALS_MAX * SORTS_DENSITIES };

struct sorts {
    double radius_min[SORTS_MAX], radius_max[SORTS_MAX]; /* length; radius_max 0: there are none */
    double lightest[SORTS_MAX], heaviest[SORTS_MAX];     /* mass / radius^3 */
    struct timestep_body body[SORTS_MAX];                /* the worst */
    double start[SORTS_MAX]; /* square of the largest speed at the start, or of insertion; (length/time)^2 */
    double fall[SORTS_MAX];  /* square of the speed of the deepest fall from rest to a side of the box */
    double fixed[LAW_MATERIALS_MAX]; /* 1: particles with prescribed motion, or walls, of the material */
    double fastest;                  /* as `start`, of all particles, those with prescribed motion included */
};

/* Collects the sorts of all ranks. Collective. */
void sorts_collect(const struct physics_context *context, struct sorts *sorts);

/* Sizes of an insertion that are looked at. */
enum { SORTS_SIZES = 17 };

/* The grains of an insertion, from the smallest to the largest, with the first variant of what they become. Returns their number, up to
 * SORTS_SIZES. */
int sorts_entering(const struct physics_context *context, const struct insertion_options *options,
                   struct physics_grain grain[SORTS_SIZES]);

/* The material of a sort. */
int sorts_material(int sort);

#endif
