/* Ranks that lose each other inside HDF5. Its flush is collective, but where a write fails, or ends too
 * early, on one rank alone, that rank goes on to another of its steps than the rest, and all wait for ever.
 * So the first write of a file under watch that is not whole sets a timer. If HDF5 returns, as it mostly
 * does, the ranks agree on the error and end the watch. Else the rank that met the failure says so and ends
 * the job.
 *
 * What a signal handler needs is static: one file at a time, main thread. */
#ifndef SCREE_FORMATS_H5_WATCH_H
#define SCREE_FORMATS_H5_WATCH_H

#include "comm/comm.h"

/* From now on writes that are not whole are those of this file. Nothing is sent. */
void h5_watch_begin(const struct comm *comm, const char *path);

/* All calls on the file have returned. */
void h5_watch_end(void);

#endif
