/* SPDX-License-Identifier: BSD-3-Clause */
/* LAMMPS text dumps: DIR/dump.lammpstrj, all frames in one file, particles sorted by id. OVITO reads such
 * files. */
#ifndef SCREE_FORMATS_DUMP_H
#define SCREE_FORMATS_DUMP_H

#include "data/formats/frame.h"
#include "data/formats/rows.h"

struct dump;

/* Opens `path`: a new file, or on a resume (`resume_step` >= 0) the existing file, cut after the last whole
 * frame up to that step. Rank 0 handles the file; all ranks get the same result. Collective. */
bool dump_open(struct dump **dump, const struct comm *comm, const char *path, int64_t resume_step,
               struct error *error);

/* The columns of a dump that show a field, by its name in H5MD, as in the head of the dump ("vx vy vz"). A
 * number without a name in LAMMPS has the name of the field. "" if the dump has no columns for the field. */
const char *dump_columns_of(const char *field, int components);

/* Checks a list of names, all of them fields of the particles. A field that a dump has no columns for is a user's error. */
bool dump_check_fields(const struct output_fields *fields, const struct particles *particles,
                       struct error *error);

/* Appends a frame and flushes it. Fields that a dump has no columns for are left out. Collective. */
bool dump_write(struct dump *dump, const struct frame *frame, struct error *error);

/* Closes. Collective. */
bool dump_close(struct dump **dump, struct error *error);

/* Reads one frame of a text dump (counted from 0, negative from the end): id, type - 1, radius (or diameter /
 * 2), mass, x y z (or xu, xs), v, omega. One rank. rows_free releases. */
bool dump_read(const char *path, int64_t frame, struct rows *rows, struct error *error);

/* Number of frames. One rank. */
bool dump_frames(const char *path, uint64_t *frames, struct error *error);

#endif
