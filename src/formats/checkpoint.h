/* SPDX-License-Identifier: BSD-3-Clause */
/* Checkpoints: the whole state of a run, so that a resume on the same layout goes on bit for bit, and on any
 * other layout goes on.
 *
 * DIR/checkpoint-STEP.h5 is an HDF5 file whose first 8 KiB (the user block) are text: name of the format,
 * size of the file, and for each dataset its place in the file and a checksum of its rows, then a checksum of
 * all bytes that belong to no dataset (HDF5's own), then one of the text itself. Reading begins with plain
 * reads against this table, so no damaged byte ever reaches HDF5: a file that is cut off, changed in any bit
 * or foreign is refused with a message that names file and dataset. Writing goes to a temporary name; the
 * file is read back against checksums made from memory, flushed to disk, renamed; only then are old ones
 * deleted. */
#ifndef SCREE_FORMATS_CHECKPOINT_H
#define SCREE_FORMATS_CHECKPOINT_H

#include "comm/domain_tree.h"
#include "formats/lineage.h"
#include "formats/output.h"
#include "formats/restart.h"
#include "particles/fields.h"

/* Suffix of the state that a guard stopped at. */
#define CHECKPOINT_STOPPED "-stopped"

/* Numbers of every run. Others come by name (restart.h). */
struct checkpoint_numbers {
    uint64_t step;
    double time, dt;
    uint64_t seed;
    int64_t next_id; /* of the next particle inserted */
    int grid[3];     /* ranks per direction where the box is divided into bricks; else 0 */
};

/* The pose of a wall by name. */
struct checkpoint_wall {
    char name[WALL_NAME_MAX];
    struct wall_pose pose;
};

/* What is written: all borrowed. particles must stand in the order in which the run continues (after a
 * rebuild). */
struct checkpoint {
    struct checkpoint_numbers numbers;
    const struct restart *restart;     /* NULL: none */
    const struct particles *particles; /* ghosts are ignored */
    const struct box *box;
    const struct domain_tree *tree;       /* of a bisection; NULL: bricks */
    int history_components;               /* 0: no history */
    const struct history_rows *history;   /* NULL where there is none */
    const struct wall_rows *wall_history; /* NULL where there is none */
    const struct walls *walls;            /* NULL: none */
    const char *law;                      /* its name */
    int materials, groups;
    const struct law_material *material; /* names and densities */
    const char *const *group;            /* names */
    const char *scene;                   /* text of the effective scene */
    const struct lineage *lineage;       /* NULL: nothing is known */
};

/* A material or a group as it was. */
struct checkpoint_kind {
    char name[OUTPUT_NAME_MAX];
    double density;    /* of a material */
    int64_t particles; /* of all ranks that are of it; not counted by checkpoint_read_head */
};

/* What was read; all owned, checkpoint_loaded_free releases (particles are the caller's set). */
struct checkpoint_loaded {
    struct checkpoint_numbers numbers;
    struct restart_values restart;
    struct box box;
    struct domain_tree *tree; /* of a bisection among as many ranks, else NULL */
    bool same_layout;         /* written on as many ranks: particles lie where they lay */
    int ranks;                /* that wrote it */
    uint64_t total;           /* particles on all ranks */
    int history_components;
    struct history_rows history;
    struct wall_rows wall_history;
    int walls;
    struct checkpoint_wall *wall;
    bool field_read[FIELDS_MAX]; /* by handle: the file has this field of the set */
    int materials, groups;
    struct checkpoint_kind *material, *group;
    char *law, *scene;
    struct lineage lineage;
};

/* Writes DIR/checkpoint-STEP.h5, then deletes all but the newest `keep` up to this step (keep = 0: deletes
 * none). `suffix` ("" or, say,
 * "-stopped") goes behind STEP; only files without a suffix count for keep. Collective. */
bool checkpoint_write(const struct comm *comm, const char *directory, const char *suffix,
                      const struct checkpoint *checkpoint, int keep, struct error *error);

/* Checks every byte of a checkpoint against its table. Names file and dataset if not good. Collective. */
bool checkpoint_verify(const struct comm *comm, const char *path, struct error *error);

/* Verifies, then reads. `particles` must be empty; its fields may differ from those written (what is
 * missing is at its fill; density is made from the mass). The numbers of materials and groups are those of the
 * checkpoint. On as many ranks as wrote it each gets its own particles
 * back in order, else slices of equal size, which the caller hands to their owners. Collective. */
bool checkpoint_read(const struct comm *comm, const char *path, struct particles *particles,
                     struct checkpoint_loaded *loaded, struct error *error);
void checkpoint_loaded_free(struct checkpoint_loaded *loaded);

/* Reads only the numbers and the scene text, after the table's own check (the data is not verified); for
 * deciding what to build before reading. loaded's rows stay empty. Collective. */
bool checkpoint_read_head(const struct comm *comm, const char *path, struct checkpoint_loaded *loaded,
                          struct error *error);

/* The path of a checkpoint in a directory (FILE_PATH_MAX bytes) by its place, 0 being the newest; false if
 * there are not so many. One rank. */
bool checkpoint_find(const char *directory, size_t place, char *path);

/* Deletes the checkpoints in a directory of steps after `step` (-1: all), also stopped and unfinished ones.
 * One rank. */
bool checkpoint_discard(const char *directory, int64_t step, struct error *error);

#endif
