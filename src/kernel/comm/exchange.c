/* SPDX-License-Identifier: BSD-3-Clause */
/* Both forms of exchange: sparse and planned. Read exchange.h first. */
#include "kernel/comm/exchange.h"

#include "base/memory.h"

#include <assert.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXCHANGE_SEND SIZE_MAX

void exchange_init(struct exchange *exchange, const struct comm *comm) {
    *exchange = (struct exchange){.comm = comm, .piece = (size_t)1 << 30};
}

static int compare_ranks(const void *a, const void *b) {
    int left = ((const struct exchange_message *)a)->rank;
    int right = ((const struct exchange_message *)b)->rank;
    return (left > right) - (left < right);
}

/* The inbox entry for messages from a rank; the first piece of a message makes a new entry. */
static struct exchange_message *inbox_from(struct exchange_inbox *inbox, int rank) {
    for (size_t k = inbox->count; k > 0; k--)
        if (inbox->message[k - 1].rank == rank)
            return &inbox->message[k - 1];
    if (inbox->count == inbox->capacity) {
        inbox->capacity = 2 * inbox->capacity + 8;
        inbox->message =
            memory_resize(inbox->message, inbox->capacity, sizeof *inbox->message, "incoming messages");
    }
    struct exchange_message *message = &inbox->message[inbox->count++];
    *message = (struct exchange_message){.rank = rank};
    return message;
}

static void inbox_grow(struct exchange_message *message, size_t more) {
    message->data = memory_resize(message->data, message->bytes + more, 1, "incoming message");
}

void exchange_inbox_free(struct exchange_inbox *inbox) {
    for (size_t k = 0; k < inbox->count; k++)
        memory_free(inbox->message[k].data);
    memory_free(inbox->message);
    *inbox = (struct exchange_inbox){0};
}

/* Takes one piece that has arrived, if any. */
static void take_piece(const struct exchange *exchange, int tag, struct exchange_inbox *inbox) {
    int there = 0, got = 0;
    MPI_Message handle;
    MPI_Status status;
    comm_check(MPI_Improbe(MPI_ANY_SOURCE, tag, exchange->comm->handle, &there, &handle, &status),
               "MPI_Improbe");
    if (!there)
        return;
    comm_check(MPI_Get_count(&status, MPI_BYTE, &got), "MPI_Get_count");
    struct exchange_message *message = inbox_from(inbox, status.MPI_SOURCE);
    inbox_grow(message, (size_t)got);
    comm_check(MPI_Mrecv(message->data + message->bytes, got, MPI_BYTE, &handle, &status), "MPI_Mrecv");
    message->bytes += (size_t)got;
}

static size_t piece_count(const struct exchange *exchange, const struct exchange_message *message) {
    return message->bytes / exchange->piece + 1;
}

/* Posts the synchronous sends of one message. Returns the number of sends. */
static int send_pieces(struct exchange *exchange, const struct exchange_message *message, int tag,
                       MPI_Request *request) {
    size_t pieces = piece_count(exchange, message);
    for (size_t k = 0; k < pieces; k++) {
        size_t first = k * exchange->piece, left = message->bytes - first;
        size_t bytes = left < exchange->piece ? left : exchange->piece;
        comm_check(MPI_Issend(message->data + first, (int)bytes, MPI_BYTE, message->rank, tag,
                              exchange->comm->handle, &request[k]),
                   "MPI_Issend");
    }
    exchange->messages += pieces;
    exchange->bytes += message->bytes;
    exchange->sparse_messages += pieces;
    exchange->sparse_bytes += message->bytes;
    return (int)pieces;
}

/* Receives until the messages of all ranks have been received; a reduction serves as the barrier. A rank may
 * be one round ahead of another, never two, as the barrier of a round needs all ranks. Two alternating tags
 * keep the rounds apart. */
static void receive_all(const struct exchange *exchange, int tag, MPI_Request *request, int sends,
                        struct exchange_inbox *inbox, int *flag) {
    MPI_Request barrier = MPI_REQUEST_NULL;
    int sent = 0, through = 0, mine = *flag;
    while (!through) {
        take_piece(exchange, tag, inbox);
        if (sent) {
            comm_check(MPI_Test(&barrier, &through, MPI_STATUS_IGNORE), "MPI_Test");
            continue;
        }
        comm_check(MPI_Testall(sends, request, &sent, MPI_STATUSES_IGNORE), "MPI_Testall");
        if (sent)
            comm_check(MPI_Iallreduce(&mine, flag, 1, MPI_INT, MPI_MAX, exchange->comm->handle, &barrier),
                       "MPI_Iallreduce");
    }
}

void exchange_sparse(struct exchange *exchange, const struct exchange_message *out, size_t n,
                     struct exchange_inbox *inbox) {
    int flag = 0;
    exchange_sparse_max(exchange, out, n, inbox, &flag);
}

void exchange_sparse_max(struct exchange *exchange, const struct exchange_message *out, size_t n,
                         struct exchange_inbox *inbox, int *flag) {
    int tag = exchange->round++ % 2 == 0 ? COMM_TAG_SPARSE_EVEN : COMM_TAG_SPARSE_ODD;
    *inbox = (struct exchange_inbox){0};
    size_t room = 0;
    for (size_t k = 0; k < n; k++)
        room += piece_count(exchange, &out[k]);
    assert(room <= INT_MAX && exchange->piece <= INT_MAX);
    MPI_Request *request = memory_allocate(room, sizeof(MPI_Request), "messages under way");
    int sends = 0;
    for (size_t k = 0; k < n; k++) {
        if (out[k].rank != exchange->comm->rank) {
            sends += send_pieces(exchange, &out[k], tag, request + sends);
            continue;
        }
        struct exchange_message *own = inbox_from(inbox, out[k].rank);
        inbox_grow(own, out[k].bytes);
        if (out[k].bytes > 0)
            memcpy(own->data, out[k].data, out[k].bytes);
        own->bytes = out[k].bytes;
    }
    receive_all(exchange, tag, request, sends, inbox, flag);
    memory_free(request);
    if (inbox->count > 1)
        qsort(inbox->message, inbox->count, sizeof *inbox->message, compare_ranks);
}

static MPI_Request *flight_add(struct exchange_flight *flight, int peer, size_t expected) {
    if (flight->count == flight->capacity) {
        flight->capacity = 2 * flight->capacity + 8;
        size_t n = flight->capacity;
        flight->request = memory_resize(flight->request, n, sizeof *flight->request, "messages under way");
        flight->expected = memory_resize(flight->expected, n, sizeof *flight->expected, "message lengths");
        flight->peer = memory_resize(flight->peer, n, sizeof *flight->peer, "message peers");
    }
    flight->peer[flight->count] = peer;
    flight->expected[flight->count] = expected;
    return &flight->request[flight->count++];
}

static void post_receive(const struct exchange *exchange, int tag, const struct exchange_message *message,
                         struct exchange_flight *flight) {
    for (size_t first = 0; first < message->bytes; first += exchange->piece) {
        size_t left = message->bytes - first, bytes = left < exchange->piece ? left : exchange->piece;
        MPI_Request *request = flight_add(flight, message->rank, bytes);
        comm_check(MPI_Irecv(message->data + first, (int)bytes, MPI_BYTE, message->rank, tag,
                             exchange->comm->handle, request),
                   "MPI_Irecv");
    }
}

static void post_send(struct exchange *exchange, int tag, const struct exchange_message *message,
                      struct exchange_flight *flight) {
    for (size_t first = 0; first < message->bytes; first += exchange->piece) {
        size_t left = message->bytes - first, bytes = left < exchange->piece ? left : exchange->piece;
        MPI_Request *request = flight_add(flight, message->rank, EXCHANGE_SEND);
        comm_check(MPI_Isend(message->data + first, (int)bytes, MPI_BYTE, message->rank, tag,
                             exchange->comm->handle, request),
                   "MPI_Isend");
        exchange->messages++;
        exchange->bytes += bytes;
    }
}

void exchange_start(struct exchange *exchange, enum comm_tag tag, const struct exchange_message *out,
                    size_t outs, const struct exchange_message *in, size_t ins,
                    struct exchange_flight *flight) {
    int rank = exchange->comm->rank;
    const struct exchange_message *to_self = NULL;
    assert(flight->count == 0);
    for (size_t k = 0; k < ins; k++) {
        if (in[k].rank == rank)
            to_self = &in[k];
        else
            post_receive(exchange, (int)tag, &in[k], flight);
    }
    for (size_t k = 0; k < outs; k++) {
        if (out[k].rank != rank) {
            post_send(exchange, (int)tag, &out[k], flight);
            continue;
        }
        if (to_self == NULL || to_self->bytes != out[k].bytes)
            error_fatal("the message of %zu bytes to itself does not fit what it expects", out[k].bytes);
        if (out[k].bytes > 0)
            memcpy(to_self->data, out[k].data, out[k].bytes);
    }
}

/* Waits for one message; ends the program if it failed or had another length than planned. */
static void wait_for(MPI_Request *request, int peer, size_t expected) {
    MPI_Status status;
    int code = MPI_Wait(request, &status), got = 0;
    char call[96];
    if (code != MPI_SUCCESS) {
        if (expected == EXCHANGE_SEND)
            snprintf(call, sizeof call, "MPI_Isend to rank %d", peer);
        else
            snprintf(call, sizeof call, "MPI_Irecv from rank %d (%zu bytes expected)", peer, expected);
        comm_check(code, call);
    }
    if (expected == EXCHANGE_SEND)
        return;
    comm_check(MPI_Get_count(&status, MPI_BYTE, &got), "MPI_Get_count");
    if ((size_t)got != expected)
        error_fatal("MPI_Irecv from rank %d (%zu bytes expected): a message of %d bytes came", peer, expected,
                    got);
}

/* Waits for the messages one by one: MPI_Waitall of Open MPI 4.1 may never return after a message that was
 * too long. */
void exchange_finish(struct exchange_flight *flight) {
    for (size_t k = 0; k < flight->count; k++)
        wait_for(&flight->request[k], flight->peer[k], flight->expected[k]);
    flight->count = 0;
}

void exchange_flight_free(struct exchange_flight *flight) {
    memory_free(flight->request);
    memory_free(flight->expected);
    memory_free(flight->peer);
    *flight = (struct exchange_flight){0};
}
