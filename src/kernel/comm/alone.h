/* SPDX-License-Identifier: BSD-3-Clause */
/* The start of MPI in a process that no mpirun or srun has started. By default Open MPI then starts a daemon and
 * looks for networks, which takes 0.4 s; a process without others needs neither. Without a daemon all such
 * processes of a user would share one session directory, which the first to end removes; so each process makes a
 * directory of its own. Other MPI libraries do not read these settings. One thread calls these functions. */
#ifndef SCREE_COMM_ALONE_H
#define SCREE_COMM_ALONE_H

struct alone;

/* Before MPI_Init: sets the environment variables that the user has not set. NULL if something has started this
 * process as one of several ranks, or if no directory can be made; then nothing is set. */
struct alone *alone_begin(void);

/* After MPI_Init: takes the variables back, so that programs that this one starts see none of them. */
void alone_started(const struct alone *alone);

/* After MPI_Finalize: removes the directory, and frees. NULL does nothing. */
void alone_end(struct alone **alone);

#endif
