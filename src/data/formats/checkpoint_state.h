/* SPDX-License-Identifier: BSD-3-Clause */
/* The contents of a checkpoint: for writing, and after reading. */
#ifndef SCREE_FORMATS_CHECKPOINT_STATE_H
#define SCREE_FORMATS_CHECKPOINT_STATE_H

#include "kernel/comm/domain_tree.h"
#include "data/formats/lineage.h"
#include "data/formats/output.h"
#include "data/formats/restart.h"
#include "kernel/particles/fields.h"

/* Numbers of every run. Other numbers have names (restart.h). */
struct checkpoint_numbers {
    uint64_t step;
    double time, dt;
    uint64_t seed;
    int64_t next_id; /* id of the next particle inserted */
    int grid[3];     /* ranks per direction if the box is divided into bricks; else 0 */
};

/* The pose of a wall by name. */
struct checkpoint_wall {
    char name[WALL_NAME_MAX];
    struct wall_pose pose;
};

/* The data to write; all borrowed. The particles must stand in the order in which the run continues (after a
 * rebuild). */
struct checkpoint {
    struct checkpoint_numbers numbers;
    const struct restart *restart;     /* NULL: none */
    const struct particles *particles; /* ghosts are ignored */
    const struct integrator_context
        *motion; /* makes full-step velocities, for programs that show them; NULL: none */
    const struct box *box;
    const struct domain_tree *tree;          /* of a bisection; NULL: bricks */
    int history_components;                  /* 0: no history */
    const struct history_rows *history;      /* NULL where there is none */
    const struct history_rows *wall_history; /* NULL where there is none (wall_row_partner) */
    struct history_rows *const *carried;     /* PHYSICS_COUNT rows of physics, NULL where there are none */
    const struct walls *walls;               /* NULL: none */
    const char *law;                         /* name of the law */
    int materials, groups;
    const struct law_material *material; /* names and densities */
    const char *const *group;            /* names */
    const char *scene;                   /* text of the effective scene */
    const struct lineage *lineage;       /* NULL: unknown */
};

/* A material or a group at the time of the checkpoint. */
struct checkpoint_kind {
    char name[OUTPUT_NAME_MAX];
    double density;    /* of a material */
    int64_t particles; /* its particles on all ranks; not counted by checkpoint_read_head */
};

/* The data read; all owned, checkpoint_loaded_free releases (the set of particles belongs to the caller). */
struct checkpoint_loaded {
    struct checkpoint_numbers numbers;
    struct restart_values restart;
    struct box box;
    struct domain_tree *tree; /* of a bisection among as many ranks, else NULL */
    bool same_layout;         /* written on as many ranks: particles are on the same ranks again */
    int ranks;                /* number of ranks that wrote the checkpoint */
    uint64_t total;           /* particles on all ranks */
    int history_components;
    struct history_rows history;
    struct history_rows wall_history;
    struct history_rows carried[PHYSICS_COUNT]; /* of physics; start NULL: the file has none */
    int walls;
    struct checkpoint_wall *wall;
    bool field_read[FIELDS_MAX]; /* by handle: the file has this field of the set of particles */
    int materials, groups;
    struct checkpoint_kind *material, *group;
    char *law, *scene;
    struct lineage lineage;
};

#endif
