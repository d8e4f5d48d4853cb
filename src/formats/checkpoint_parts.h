/* What writing and reading checkpoints share: names of datasets, the form of the small tables. */
#ifndef SCREE_FORMATS_CHECKPOINT_PARTS_H
#define SCREE_FORMATS_CHECKPOINT_PARTS_H

#include "formats/checkpoint.h"
#include "formats/checkpoint_table.h"
#include "formats/h5.h"

enum {
    CHECKPOINT_POSE = 41,                           /* doubles of a wall's pose */
    CHECKPOINT_HISTORY = HISTORY_COMPONENTS_MAX + 3 /* doubles of a history row: value, separation */
};

/* Places in /run/integers. */
enum checkpoint_integer {
    CHECKPOINT_STEP,
    CHECKPOINT_SEED,
    CHECKPOINT_NEXT_ID,
    CHECKPOINT_RANKS,
    CHECKPOINT_FIELDS, /* how many fields of particles were written; nobody reads it */
    CHECKPOINT_HISTORY_COMPONENTS,
    CHECKPOINT_WALLS,
    CHECKPOINT_TOTAL,
    CHECKPOINT_GRID, /* three of them */
    CHECKPOINT_INTEGERS = CHECKPOINT_GRID + 3
};

/* The cuts of a bisection, a row each: coordinate, first rank above, axis. */
#define CHECKPOINT_CUTS "/run/cuts"
enum { CHECKPOINT_CUT = 3 };

/* /box/sides: dimension, periodic[3], leave[3][2]. */
enum { CHECKPOINT_SIDES = 10 };

/* The name of the dataset of a particle field. */
void checkpoint_field_name(const struct field *field, char name[OUTPUT_NAME_MAX]);

/* Bytes of one value of a type. */
size_t checkpoint_type_bytes(enum field_type type);

#endif
