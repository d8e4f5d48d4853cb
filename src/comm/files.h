/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls on files that fail on one rank, noticed below the library that makes them: MPI's calls by which HDF5
 * opens, reads, writes and closes files are taken in between by MPI's profiling interface. */
#ifndef SCREE_COMM_FILES_H
#define SCREE_COMM_FILES_H

/* From now on `failed` is called on a rank, in the middle of the library's work, when a call of this rank on
 * a file fails, or reads or writes less than asked for (reading beyond the end of a file is no failure);
 * `what` is what could not be done ("opened", "read", "written", "flushed", "cut", "closed"). NULL: nobody is
 * called. While somebody is, MPI_File_open ends with an error on all ranks where it does on one. One at a
 * time, kept in a static variable: the profiling interface hands nothing on. */
void files_watch(void (*failed)(const char *what));

#endif
