/* SPDX-License-Identifier: BSD-3-Clause */
/* The checkpoints in a directory. */
#ifndef SCREE_FORMATS_CHECKPOINT_FOLDER_H
#define SCREE_FORMATS_CHECKPOINT_FOLDER_H

#include "base/error.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Suffix of the checkpoint of a run that a guard stopped. */
#define CHECKPOINT_STOPPED "-stopped"

/* The path of a checkpoint in a directory (FILE_PATH_MAX bytes) by its number, 0 for the newest; false if the
 * directory has fewer. One rank. */
bool checkpoint_find(const char *directory, size_t place, char *path);

/* Deletes the checkpoints in a directory of steps after `step` (-1: all), also stopped and unfinished ones.
 * One rank. */
bool checkpoint_discard(const char *directory, int64_t step, struct error *error);

/* Deletes all but the newest `keep` of the checkpoints up to step `newest`. One rank. */
void checkpoint_delete_old(const char *directory, uint64_t newest, int keep);

#endif
