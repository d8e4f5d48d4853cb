/* SPDX-License-Identifier: BSD-3-Clause */
/* Notices failed calls on files on one rank, below the library that makes the calls: MPI's profiling
 * interface intercepts the MPI calls by which HDF5 opens, reads, writes and closes files. That needs these functions
 * before those of MPI in the order in which the system looks for names. In the program they are; libscree exports these
 * names, so they are there in programs that link libscree before MPI, and in Python. Where another library has loaded
 * MPI before, they are not: files_opened tells. */
#ifndef SCREE_COMM_FILES_H
#define SCREE_COMM_FILES_H

/* From now on a rank calls `failed`, in the middle of the library's work, when a call of this rank on a file
 * fails, or reads or writes fewer bytes than asked for (reading beyond the end of a file is no failure).
 * `what` names the action that failed ("opened", "read", "written", "flushed", "cut", "closed"). NULL: no
 * function is called. While a function is set, MPI_File_open fails on all ranks if it fails on one. One
 * function at a time, kept in a static variable, because the profiling interface passes no context. */
void files_watch(void (*failed)(const char *what));

/* How many files have been opened through these functions. A file that HDF5 has opened and that does not count shows that
 * the calls of HDF5 pass these functions by. */
unsigned long files_opened(void);

#endif
