/* SPDX-License-Identifier: BSD-3-Clause */
/* The folder that a run writes to: used by one run at a time, and free of files of a replaced run. */
#ifndef SCREE_ENGINE_FOLDER_H
#define SCREE_ENGINE_FOLDER_H

#include "kernel/comm/comm.h"
#include "data/formats/lineage.h"

/* True if a directory exists and has no entries. */
bool folder_empty(const char *directory);

/* Makes a directory and the directories above it. False, with errno, if this fails; a directory that exists
 * already is no failure. */
bool folder_make(const char *directory);

/* Checks that files can be written to a directory or, if the directory does not exist yet, that it can be
 * made. Fails (user) if the path is too long for the names of a run's files, is no directory, or the system
 * allows no writing. Makes nothing. Collective. */
bool folder_check(const struct comm *comm, const char *directory, struct error *error);

/* Locks a directory against other runs until folder_unlock or the end of the program; does nothing if the
 * file system has no locks. `handle` is -1 on all ranks but the first. Fails (user) if another run holds the
 * lock. Collective. */
bool folder_lock(const struct comm *comm, const char *directory, int *handle, struct error *error);
void folder_unlock(int *handle);

/* Deletes the files of an earlier run in a directory: all files with names that a run uses, above all
 * checkpoints, which must not be mistaken for checkpoints of the new run. Other files stay. Collective. */
bool folder_clear(const struct comm *comm, const char *directory, struct error *error);

/* True if the newest whole checkpoint in a directory, if there is one, has the same beginning as `lineage`: else the
 * directory has the files of another run. Changes nothing. Collective. */
bool folder_suits(const struct comm *comm, const char *directory, const struct lineage *lineage,
                  struct error *error);

/* Deletes only the checkpoints of steps after `step`, as the run continues differently from `step`.
 * Collective. */
bool folder_rewind(const struct comm *comm, const char *directory, uint64_t step, struct error *error);

#endif
