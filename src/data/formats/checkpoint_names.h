/* SPDX-License-Identifier: BSD-3-Clause */
/* Part of checkpoints: names and shapes of datasets that are written and read, and the numbers that
 * every checkpoint has. */
#ifndef SCREE_FORMATS_CHECKPOINT_NAMES_H
#define SCREE_FORMATS_CHECKPOINT_NAMES_H

#include "data/formats/restart.h"
#include "kernel/pairs/history.h"
#include "kernel/particles/fields.h"

enum {
    CHECKPOINT_POSE = 41 /* doubles of a wall's pose */
};

/* Doubles of a history row that hold the value; three more hold the separation. */
static inline size_t checkpoint_history_width(int components) {
    return (size_t)(components > HISTORY_COMPONENTS_USUAL ? components : HISTORY_COMPONENTS_USUAL);
}

/* The datasets of rows of pairs, "/GROUP/count" ..., and the groups of the physics (their names). */
enum checkpoint_rows_name {
    CHECKPOINT_ROWS_COUNT,
    CHECKPOINT_ROWS_PARTNER,
    CHECKPOINT_ROWS_VALUE,
    CHECKPOINT_ROWS_NAMES
};
void checkpoint_rows_names(const char *group, char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX]);
extern const char *const checkpoint_physics_names[];

/* Names of datasets that are written and read. */
#define CHECKPOINT_MATERIALS "/materials/name"
#define CHECKPOINT_DENSITIES "/materials/density"
#define CHECKPOINT_GROUPS "/groups/name"
#define CHECKPOINT_RUN_STEPS "/runs/step"
#define CHECKPOINT_RUN_PROGRAMS "/runs/version_revision"
#define CHECKPOINT_RUN_SCENES "/runs/scene"

/* Velocities of the full step, and angular velocities where there are any. */
#define CHECKPOINT_FULL "/full_step/velocity"

/* The cuts of a bisection, a row each: coordinate, first rank above, axis. */
#define CHECKPOINT_CUTS "/run/cuts"
enum { CHECKPOINT_CUT = 3 };

/* /box/sides: dimension, periodic[3], leave[3][2]. */
enum { CHECKPOINT_SIDES = 10 };

/* Names and values of the numbers of each kind (restart.h). */
extern const char *const checkpoint_name_datasets[RESTART_KINDS];
extern const char *const checkpoint_value_datasets[RESTART_KINDS];

/* The numbers that every checkpoint has. */
struct checkpoint_core {
    int64_t step, seed, next_id, ranks, history_components, particles, grid[3];
    double time, dt;
};

/* Lists these numbers with their names. */
void checkpoint_core_list(struct checkpoint_core *core, struct restart *restart);

/* The name of the dataset of a particle field. */
void checkpoint_field_name(const struct field *field, char name[OUTPUT_NAME_MAX]);

/* Doubles of a particle in CHECKPOINT_FULL. */
size_t checkpoint_full_width(const struct particles *particles);

/* Bytes of one value of a type. */
size_t checkpoint_type_bytes(enum field_type type);

#endif
