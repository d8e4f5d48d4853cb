/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact histories as rows, for a rebuild or a checkpoint. */
#ifndef SCREE_ENGINE_REBUILD_ROWS_H
#define SCREE_ENGINE_REBUILD_ROWS_H

#include "engine/state.h"
#include "kernel/pairs/history_keep.h"

/* Contact history of pairs and walls during a rebuild, or on the way to a checkpoint. */
struct rebuild_rows {
    struct history_rows pairs;
    bool keep;  /* the short way, if particles neither come nor go: records of pairs that stay on this rank
                */
    bool stays; /* particles keep their ranks and their order, if ... */
    uint64_t revision;   /* ... none has come or gone since */
    uint32_t *place;     /* several ranks: number of each of the `before` particles after the migration */
    size_t before, stay; /* stay: how many do not leave; arrivals follow */
    struct history_loose loose; /* several ranks, the short way: rows of the other pairs */
    struct history_loose leave; /* of these, the rows of particles that leave; then of the arrivals */
    uint32_t *near; /* several ranks, the short way: particles that had copies elsewhere; arrivals */
    size_t near_count;
    uint32_t *order;               /* new particle k is old order[k]; NULL: all stay */
    struct history_kept kept;      /* made between ghosts and search */
    struct history_rows obstacles; /* of contacts with these */
    /* Those of other physics, in the order of the table; NULL: none. The physics own them. */
    struct history_rows *carried[PHYSICS_COUNT];
    bool again; /* another rebuild follows */
};

/* Makes the rows of contacts of pairs and with obstacles; of obstacles alone. */
void rebuild_detach(const struct search *search, const struct physics_set *set,
                    const struct particles *particles, bool both_ends, struct rebuild_rows *rows);
void rebuild_detach_obstacles(const struct physics_set *set, struct rebuild_rows *rows);

/* The sets of rows that there may be: of pairs, of obstacles, of each other physics. */
enum { REBUILD_SETS = 2 + PHYSICS_COUNT };

/* Lists the sets that there are; returns their number. */
int rebuild_rows_list(struct rebuild_rows *rows, struct history_rows *list[REBUILD_SETS]);

/* The pass of the rebuild that decides whether particles stay as they lie, on their ranks and in the order of the last
 * build of the index (stay.c): rows->stays. Collective. */
void stay_decide(struct simulation *simulation, struct rebuild_rows *rows);

/* Passes of the rebuild, on several ranks: every particle gets a place among those that stay; histories of two that
 * stay remain where they are, the others become loose rows; particles go to their owners, with their rows. The
 * last one is collective. */
void rebuild_part(struct simulation *simulation, struct rebuild_rows *rows);
void rebuild_loosen(struct simulation *simulation, struct rebuild_rows *rows);
void rebuild_migrate(struct simulation *simulation, struct rebuild_rows *rows);

void rebuild_rows_free(struct rebuild_rows *rows);

#endif
