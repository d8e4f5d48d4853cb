/* SPDX-License-Identifier: BSD-3-Clause */
/* Prints the contents of a file for people: H5MD trajectories, checkpoints, LAMMPS data files and dumps. The
 * kind is found from the content. */
#ifndef SCREE_FORMATS_INFO_H
#define SCREE_FORMATS_INFO_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include <stdio.h>

enum info_kind { INFO_UNKNOWN, INFO_H5MD, INFO_CHECKPOINT, INFO_LAMMPS_DATA, INFO_LAMMPS_DUMP };

/* The kind of a file by its first bytes (fails, naming the file, if it cannot be read). */
bool info_kind(const char *path, enum info_kind *kind, struct error *error);

/* Prints frames, particles, fields, box, histogram of sizes. comm is that of one rank. */
bool info_print(const char *path, const struct comm *comm, FILE *file, struct error *error);

/* Prints the same for the files of a run in a folder: trajectory, dump, newest checkpoint. False with a user's error if
 * it has none of them. */
bool info_folder(const char *folder, const struct comm *comm, FILE *file, struct error *error);

#endif
