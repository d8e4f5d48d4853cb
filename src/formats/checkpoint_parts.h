/* SPDX-License-Identifier: BSD-3-Clause */
/* What the files of checkpoints share: checkpoint.c writes, with checkpoint_head.c, checkpoint_read.c reads,
 * with checkpoint_read_head.c; checkpoint_folder.c finds and deletes. */
#ifndef SCREE_FORMATS_CHECKPOINT_PARTS_H
#define SCREE_FORMATS_CHECKPOINT_PARTS_H

#include "formats/checkpoint.h"
#include "formats/checkpoint_file.h"
#include "formats/checkpoint_table.h"
#include "formats/h5.h"

enum {
    CHECKPOINT_POSE = 41,                           /* doubles of a wall's pose */
    CHECKPOINT_HISTORY = HISTORY_COMPONENTS_MAX + 3 /* doubles of a history row: value, separation */
};

/* Names of datasets that are written and read. */
#define CHECKPOINT_MATERIALS "/materials/name"
#define CHECKPOINT_DENSITIES "/materials/density"
#define CHECKPOINT_GROUPS "/groups/name"
#define CHECKPOINT_RUN_STEPS "/runs/step"
#define CHECKPOINT_RUN_PROGRAMS "/runs/version_revision"
#define CHECKPOINT_RUN_SCENES "/runs/scene"

/* Names and values of the numbers of each kind (restart.h). */
extern const char *const checkpoint_name_datasets[RESTART_KINDS];
extern const char *const checkpoint_value_datasets[RESTART_KINDS];

/* The numbers that every checkpoint has. */
struct checkpoint_core {
    int64_t step, seed, next_id, ranks, history_components, particles, grid[3];
    double time, dt;
};

/* Lists them under their names. */
void checkpoint_core_list(struct checkpoint_core *core, struct restart *restart);

/* A checkpoint on its way. */
struct checkpoint_writing {
    const struct comm *comm;
    const struct checkpoint *checkpoint;
    struct h5 h5;
    struct checkpoint_table table;
    uint64_t first, total; /* particles before this rank's, and of all */
};

/* Enters a dataset, just written, into the table. Collective, as the next ones. */
bool checkpoint_enter(struct checkpoint_writing *w, const char *name, const struct h5_table *rows,
                      size_t row_bytes, const void *data, struct error *error);

/* Writes a table that every rank has: the first writes it. */
bool checkpoint_put_common(struct checkpoint_writing *w, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, const void *data, struct error *error);

/* Writes one row of every rank. */
bool checkpoint_put_of_ranks(struct checkpoint_writing *w, const char *name, enum field_type type,
                             uint64_t width, const void *data, struct error *error);

/* Writes all that is not a row of a particle. */
bool checkpoint_put_head(struct checkpoint_writing *w, struct error *error);

/* A checkpoint that is being read. */
struct checkpoint_reading {
    const struct comm *comm;
    struct checkpoint_file file;
    struct checkpoint_loaded *loaded;
    uint64_t first, count; /* particles of this rank */
};

/* Reads a table that every rank gets whole: `rows` of `width` values (0: one). Collective, as the next one.
 */
bool checkpoint_get_common(struct checkpoint_reading *r, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, void *data, struct error *error);

/* Reads all that is not a row of a particle. */
bool checkpoint_get_head(struct checkpoint_reading *r, struct error *error);

/* Deletes all but the newest `keep` of the checkpoints up to step `newest`. One rank. */
void checkpoint_delete_old(const char *directory, uint64_t newest, int keep);

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
