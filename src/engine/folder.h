/* SPDX-License-Identifier: BSD-3-Clause */
/* The folder that a run writes to: one run at a time, and nothing in it of a run that it replaces. */
#ifndef SCREE_ENGINE_FOLDER_H
#define SCREE_ENGINE_FOLDER_H

#include "comm/comm.h"

/* Tells whether files can be written to a directory, or, where it is not there yet, whether it can be made:
 * fails (user) where the path is too long for the names of a run's files, is no directory, or where the
 * system allows no writing. Nothing is made. Collective. */
bool folder_check(const struct comm *comm, const char *directory, struct error *error);

/* Keeps other runs out of a directory until folder_unlock or the end of the program, but not where the file
 * system knows no locks; `handle` is -1 on all ranks but the first. Fails (user) if another run has it.
 * Collective. */
bool folder_lock(const struct comm *comm, const char *directory, int *handle, struct error *error);
void folder_unlock(int *handle);

/* Deletes what an earlier run wrote to a directory: all files of the names that a run uses, checkpoints above
 * all, which must not be taken for those of the run that begins. Other files stay. Collective. */
bool folder_clear(const struct comm *comm, const char *directory, struct error *error);

/* Deletes only the checkpoints of steps after `step`: a run goes on from there, another way. Collective. */
bool folder_rewind(const struct comm *comm, const char *directory, uint64_t step, struct error *error);

#endif
