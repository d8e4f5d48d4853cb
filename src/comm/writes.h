/* Writes to files that end too early, noticed below the library that makes them: MPI's two calls by which
 * HDF5 writes are taken in between by MPI's profiling interface. */
#ifndef SCREE_COMM_WRITES_H
#define SCREE_COMM_WRITES_H

/* From now on `cut` is called on a rank, in the middle of the library's work, when a write of this rank fails
 * or is shorter than asked; NULL: nobody is. Nothing is sent. One at a time, kept in a static variable: the
 * profiling interface hands nothing on. */
void writes_watch(void (*cut)(void));

#endif
