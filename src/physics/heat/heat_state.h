/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of heat: the state between its passes, `self` of heat_physics, and what its files call of each other. */
#ifndef SCREE_HEAT_HEAT_STATE_H
#define SCREE_HEAT_HEAT_STATE_H

#include "base/numbers.h"
#include "engine/physics.h"
#include "kernel/pairs/walk.h"
#include "physics/heat/heat.h"

struct heat {
    const struct heat_options *options;
    const struct physics_context *context;
    struct walk *walk;
    struct walk_work pairs;
    struct walk *contact_walk; /* NULL: a contact radius follows from the overlap alone */
    struct walk_work contacts;
    double reach; /* of contacts beyond touch, at most, from walls */
    double conductivity[LAW_MATERIALS_MAX], capacity[LAW_MATERIALS_MAX];
    double narrow;                           /* contact radius over that of the scene's grains */
    const struct heat_wall *wall[WALLS_MAX]; /* by wall; NULL: no heat */
    struct numbers course[WALLS_MAX];        /* by wall: temperature over time; no rows: as the entry says */
    int wall_material[WALLS_MAX];
    double *temperature, *flow, *wall_flow; /* of the fields, since the last rebuild */
    const uint8_t *material;
    bool conductance;                /* sums of H instead of flows */
    struct heat_work *work;          /* NULL: dissipation makes no heat */
    double (*wall_power)[WALLS_MAX]; /* [thread][wall]: power into grains in the last step, W */
    int64_t *strange; /* [thread]: 1 + id of a grain whose temperature has become not finite, 0: none */
};

/* heat_conduct.c: the contact radius of two spheres, or of one and a wall (an infinite radius), `gap` apart (overlap:
 * negative); `record` as law_grip_radius wants it. Any thread. */
double heat_contact_radius(const struct heat *heat, const int material[2], const double radius[2],
                           double effective, double gap, const double *record);

/* The power over one kelvin through a contact of radius a, and through gas; W/K. Any thread. */
double heat_through_contact(const struct heat *heat, const int material[2], double a);
double heat_through_gas(const struct heat *heat, double effective, double gap);

/* Pairs of grains, and contacts that remember their state, as clients of the walk. */
extern const struct walk_client heat_pairs_client, heat_contacts_client;

/* heat_walls.c: refuses entry `k` of the walls; reads the tables of all, `free` releases them. */
bool heat_walls_suit(const struct physics_context *context, int k, struct error *error);
void heat_walls_read(struct heat *heat);
void heat_walls_free(struct heat *heat);

/* True if walls exchange heat. The pass of the walls, one thread's share. */
bool heat_walls_needed(const struct physics_context *context);
void heat_walls_share(const struct physics_context *context, int thread);

#endif
