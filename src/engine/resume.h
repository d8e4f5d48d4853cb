/* SPDX-License-Identifier: BSD-3-Clause */
/* Checkpoints, and resuming from them; resume.c describes the method. */
#ifndef SCREE_ENGINE_RESUME_H
#define SCREE_ENGINE_RESUME_H

#include "engine/rebuild_rows.h"

/* Writes DIR/checkpoint-STEP[suffix].h5. The last step must have rebuilt; else a resumed run differs in bits.
 * Collective. */
bool resume_write(struct simulation *simulation, const struct output_run *run, const char *suffix,
                  struct error *error);

/* Reads a checkpoint: particles (at any position), numbers, wall poses, and histories into `rows`.
 * resume_begin then rebuilds; the forces are those of the file. Collective. */
bool resume_read(struct simulation *simulation, const char *path, struct rebuild_rows *rows,
                 struct error *error);
void resume_begin(struct simulation *simulation, struct rebuild_rows *rows);

#endif
