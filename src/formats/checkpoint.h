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

#include "formats/checkpoint_folder.h"
#include "formats/checkpoint_state.h"

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

#endif
