/* SPDX-License-Identifier: BSD-3-Clause */
/* Messages between ranks, for migrate.c and ghosts.c: one aggregated message per neighbour and direction.
 *
 * Two forms:
 *   sparse   no rank knows which ranks will send to it (rebuild). Synchronous sends, and a non-blocking
 *            barrier that a rank enters after its own sends have been received: when the barrier is complete,
 *            no message is under way (Hoefler, Siebert, Lumsdaine, "Scalable communication protocols for
 *            dynamic sparse data exchange", PPoPP 2010). No array has the length of the number of ranks.
 *   planned  both sides know the lengths (every step): _start posts receives and sends, _finish waits for
 *            them. A message of another length than planned ends the program with an error message.
 *
 * A message to the own rank is a copy in memory. Messages above `piece` bytes go in several: as messages of
 * one pair of ranks and one tag do not overtake each other, the pieces arrive in order, and in a sparse
 * exchange a piece shorter than `piece` is the last. */
#ifndef SCREE_COMM_EXCHANGE_H
#define SCREE_COMM_EXCHANGE_H

#include "kernel/comm/comm.h"

/* A message to or from `rank`. */
struct exchange_message {
    int rank;
    size_t bytes;
    char *data;
};

struct exchange {
    const struct comm *comm;  /* borrowed */
    size_t piece;             /* bytes of the longest single MPI message */
    unsigned round;           /* sparse exchanges so far: neighbouring rounds use different tags */
    uint64_t messages, bytes; /* sent to other ranks so far */
    uint64_t sparse_messages, sparse_bytes; /* of messages and bytes: in sparse exchanges */
};

/* The messages received: sorted by source, at most one message of each. */
struct exchange_inbox {
    struct exchange_message *message;
    size_t count, capacity;
};

/* The requests of a planned exchange between start and finish. */
struct exchange_flight {
    MPI_Request *request;
    size_t *expected; /* bytes of a receive; SIZE_MAX for a send */
    int *peer;
    size_t count, capacity;
};

/* Makes an exchange ready to use; borrows `comm`. */
void exchange_init(struct exchange *exchange, const struct comm *comm);

/* Delivers the `n` messages in `out` (at most one per rank; the own rank and 0 bytes are allowed) and
 * collects the messages that other ranks sent to this rank. Collective. */
void exchange_sparse(struct exchange *exchange, const struct exchange_message *out, size_t n,
                     struct exchange_inbox *inbox);

/* As exchange_sparse; *flag also becomes the largest *flag of all ranks. The barrier carries the flag. */
void exchange_sparse_max(struct exchange *exchange, const struct exchange_message *out, size_t n,
                         struct exchange_inbox *inbox, int *flag);
void exchange_inbox_free(struct exchange_inbox *inbox);

/* Posts `outs` sends, and `ins` receives into in[].data, all with the planned lengths. The buffers belong to
 * the exchange until _finish, which waits for all messages. The two sides of a message state the same length.
 */
void exchange_start(struct exchange *exchange, enum comm_tag tag, const struct exchange_message *out,
                    size_t outs, const struct exchange_message *in, size_t ins,
                    struct exchange_flight *flight);
void exchange_finish(struct exchange_flight *flight);
void exchange_flight_free(struct exchange_flight *flight);

#endif
