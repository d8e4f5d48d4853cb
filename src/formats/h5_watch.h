/* SPDX-License-Identifier: BSD-3-Clause */
/* Ranks that lose each other inside HDF5. Its calls are collective, but where one fails, or ends too early,
 * on one rank alone, that rank goes on to another of its steps than the rest, and all wait for ever.
 * Therefore:
 *
 * - a write or the closing of a file under watch that is not whole sets a timer. If HDF5 returns, as it
 *   mostly does, the ranks agree on the error and end the watch; else the rank that met the failure says so
 *   and ends the job;
 * - a read that is not whole ends the job at once, with the same message: MPI hides it from HDF5, which takes
 *   what was in memory for data, or crashes;
 * - opening has twenty seconds on several ranks together, and ten times what it took each by itself: MPI
 *   closes a file, together, that one rank could not open. Then a rank that does not have the file open says
 *   so and ends the job.
 *
 * What a signal handler needs is static: one file at a time, main thread. */
#ifndef SCREE_FORMATS_H5_WATCH_H
#define SCREE_FORMATS_H5_WATCH_H

#include "comm/comm.h"

/* From now on calls that are not whole are those on this file. Nothing is sent. */
void h5_watch_begin(const struct comm *comm, const char *path);

/* Around the call by which all ranks open the file together; `alone`: seconds that it took each by itself. */
void h5_watch_opening(double alone);
void h5_watch_opened(void);

/* All calls on the file have returned. */
void h5_watch_end(void);

/* Makes a failure that this rank met since the begin of the watch an error of the system: "FILE: cannot be
 * read on rank 1". True if there was none. */
bool h5_watch_take(struct error *error);

#endif
