/* SPDX-License-Identifier: BSD-3-Clause */
/* Notices failed calls on files on one rank, below the library that makes the calls: MPI's profiling
 * interface intercepts the MPI calls by which HDF5 opens, reads, writes and closes files. That needs these functions
 * before those of MPI in the order of linking: in the program they are, in libscree, which shows its own names alone, they
 * are not, and nothing is noticed. */
#ifndef SCREE_COMM_FILES_H
#define SCREE_COMM_FILES_H

/* From now on a rank calls `failed`, in the middle of the library's work, when a call of this rank on a file
 * fails, or reads or writes fewer bytes than asked for (reading beyond the end of a file is no failure).
 * `what` names the action that failed ("opened", "read", "written", "flushed", "cut", "closed"). NULL: no
 * function is called. While a function is set, MPI_File_open fails on all ranks if it fails on one. One
 * function at a time, kept in a static variable, because the profiling interface passes no context. */
void files_watch(void (*failed)(const char *what));

#endif
