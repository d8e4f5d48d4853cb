/* SPDX-License-Identifier: BSD-3-Clause */
/* Checkpoints: the whole state of a run, so that a resume on the same layout continues bit for bit, and a
 * resume on any other layout continues.
 *
 * DIR/checkpoint-STEP.h5 is an HDF5 file whose first 8 KiB (the user block) are text: name of the format,
 * size of the file, for each dataset its place in the file and a checksum of its rows, then a checksum of all
 * bytes that belong to no dataset (HDF5's own), then a checksum of the text itself. Reading begins with plain
 * reads that are compared with this table, so no damaged byte ever reaches HDF5: a file that is cut off,
 * changed in any bit or foreign is refused with a message that names file and dataset. A new checkpoint gets
 * a temporary name; the file is read back and compared with checksums from memory, flushed to disk, and
 * renamed. Only then are old checkpoints deleted. */
#ifndef SCREE_FORMATS_CHECKPOINT_H
#define SCREE_FORMATS_CHECKPOINT_H

#include "data/formats/checkpoint_folder.h"
#include "data/formats/checkpoint_state.h"

/* Writes DIR/checkpoint-STEP.h5, then deletes all but the newest `keep` checkpoints up to this step (keep =
 * 0: deletes none). `suffix` ("" or for example "-stopped") follows STEP in the name; `keep` counts only
 * files without a suffix. Collective. */
bool checkpoint_write(const struct comm *comm, const char *directory, const char *suffix,
                      const struct checkpoint *checkpoint, int keep, struct error *error);

/* Checks every byte of a checkpoint against its table. The error names file and dataset. Collective. */
bool checkpoint_verify(const struct comm *comm, const char *path, struct error *error);

/* Verifies, then reads. `particles` must be empty; the fields of the set may differ from the fields written
 * (a missing field gets its fill value; density is computed from the mass). The numbers of materials and
 * groups are those of the checkpoint. On as many ranks as wrote the checkpoint, each rank gets its own
 * particles back in order; else each rank gets a slice of equal size, and the caller sends the particles to
 * their owners. Collective. */
bool checkpoint_read(const struct comm *comm, const char *path, struct particles *particles,
                     struct checkpoint_loaded *loaded, struct error *error);
/* The same, but velocities and angular velocities are those of the full step, at the moment of the positions. Files of older
 * versions have those of the half step alone. */
bool checkpoint_read_full(const struct comm *comm, const char *path, struct particles *particles,
                          struct checkpoint_loaded *loaded, struct error *error);
void checkpoint_loaded_free(struct checkpoint_loaded *loaded);

/* Reads only the numbers and the scene text, after the table's own check (the data are not verified), so that
 * the caller can build a matching simulation before it reads the rows. The rows of `loaded` stay empty.
 * Collective. */
bool checkpoint_read_head(const struct comm *comm, const char *path, struct checkpoint_loaded *loaded,
                          struct error *error);

#endif
