/* SPDX-License-Identifier: BSD-3-Clause */
/* Ranks at different calls inside HDF5. The calls of HDF5 are collective, but if a call fails, or ends too
 * early, on one rank only, that rank continues with another internal step than the others, and all ranks wait
 * for ever. Therefore:
 *
 * - an incomplete write or closing of a watched file sets a timer. If HDF5 returns, as it mostly does, the
 *   ranks agree on the error and end the watch; else the rank with the failure prints a message and ends the
 *   job;
 * - an incomplete read ends the job at once, with the same message: MPI hides the failure from HDF5, which
 *   takes old memory for data, or crashes;
 * - all ranks together may open a file for twenty seconds, and ten times the time of the single opening. MPI
 *   closes, collectively, a file that one rank could not open, and may wait for ever. After the time limit a
 *   rank that does not have the file open prints a message and ends the job.
 *
 * The data of the signal handler are static: one file at a time, main thread. */
#ifndef SCREE_FORMATS_H5_WATCH_H
#define SCREE_FORMATS_H5_WATCH_H

#include "kernel/comm/comm.h"

/* From now on incomplete calls count as calls on this file. No communication. */
void h5_watch_begin(const struct comm *comm, const char *path);

/* Called before and after the call by which all ranks open the file together; `alone`: seconds of the single
 * opening of each rank. If the watch has not noticed the opening, rank 0 says so once (kernel/comm/files.h). */
void h5_watch_opening(double alone);
void h5_watch_opened(void);

/* Called after all calls on the file have returned. */
void h5_watch_end(void);

/* Makes a failure of this rank since h5_watch_begin an error of the system: "FILE: cannot be read on rank 1".
 * True if there was no failure. */
bool h5_watch_take(struct error *error);

#endif
