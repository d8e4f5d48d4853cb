/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a scene, from its sources. */
#ifndef SCREE_SCENE_SCENE_PARTICLES_H
#define SCREE_SCENE_SCENE_PARTICLES_H

#include "data/scene/scene.h"
#include "data/scene/scene_share.h"

/* Counts of the particles from all sources, over all ranks; the same on every rank. */
struct scene_census {
    uint64_t particles;
    int64_t id_max;
    double radius_min, radius_max;
    uint64_t material[LAW_MATERIALS_MAX];
    uint64_t group[INTEGRATOR_GROUPS_MAX];
    double speed_max;
    double volume; /* solid */
};

/* Fills an empty particle set, with the fields of scene_register, with this rank's particles: box-relative
 * positions, velocities as given (full step), inverse masses (0 in groups that do not move freely), ids,
 * materials, groups. Every rank reads or generates the whole stream; no communication. Errors in the data
 * name file, line, column and the allowed values. Duplicate ids and coinciding centres are searched for by
 * all ranks together, each a part: errors differ between ranks, so the caller agrees on them (comm_agree).
 * One thread. `census` may be NULL.
 * */
bool scene_particles(const struct scene *scene, const struct scene_share *share, struct particles *particles,
                     struct scene_census *census, struct error *error);

#endif
