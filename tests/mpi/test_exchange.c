/* SPDX-License-Identifier: BSD-3-Clause */
/* Exchanges with and without a plan, over random graphs, in many small pieces, and the end of the job if a
 * message has the wrong length. Ranks: 1 2 3 4 8 */
#include "tests/test.h"

#include "kernel/comm/exchange.h"
#include "base/memory.h"
#include "base/random.h"
#include "team.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Length of the message from a to b in a round, the same on all ranks; SIZE_MAX: there is no message. */
static size_t length_of(int a, int b, unsigned round) {
    uint64_t item = (uint64_t)a << 40 | (uint64_t)b << 20 | round;
    struct random_sequence sequence = random_sequence(7, RANDOM_TEST, item);
    if (random_uniform(&sequence) < 0.5)
        return SIZE_MAX;
    return (size_t)(200 * random_uniform(&sequence)) / 8 * 8; /* some end with a whole piece of 8 bytes */
}

static char byte_of(int a, int b, unsigned round, size_t k) {
    return (char)(a * 131 + b * 17 + (int)round * 7 + (int)k);
}

/* Messages between this rank and all others, outgoing ones filled; incoming ones sorted by source. */
static size_t make_messages(const struct comm *comm, unsigned round, bool out,
                            struct exchange_message *message) {
    size_t n = 0;
    for (int other = 0; other < comm->size; other++) {
        int a = out ? comm->rank : other, b = out ? other : comm->rank;
        size_t bytes = length_of(a, b, round);
        if (bytes == SIZE_MAX)
            continue;
        message[n] = (struct exchange_message){other, bytes, memory_allocate(bytes, 1, "test")};
        for (size_t k = 0; out && k < bytes; k++)
            message[n].data[k] = byte_of(a, b, round, k);
        n++;
    }
    return n;
}

static void free_messages(struct exchange_message *message, size_t n) {
    for (size_t k = 0; k < n; k++)
        memory_free(message[k].data);
    memory_free(message);
}

static void expect_contents(struct team *team, const struct exchange_message *message, unsigned round) {
    for (size_t k = 0; k < message->bytes; k++)
        if (!team_expect(team, message->data[k] == byte_of(message->rank, team->comm.rank, round, k),
                         "round %u: byte %zu from rank %d", round, k, message->rank))
            return;
}

static struct exchange_message *room_for_all(const struct comm *comm) {
    return memory_allocate((size_t)comm->size, sizeof(struct exchange_message), "test");
}

/* Many rounds without a pause: ranks run ahead of each other. */
static void sparse(void **state) {
    struct team *team = *state;
    struct exchange exchange;
    exchange_init(&exchange, &team->comm);
    for (unsigned round = 0; round < 60; round++) {
        exchange.piece = round < 20 ? (size_t)1 << 30 : 8;
        struct exchange_message *out = room_for_all(&team->comm), *in = room_for_all(&team->comm);
        size_t outs = make_messages(&team->comm, round, true, out);
        size_t ins = make_messages(&team->comm, round, false, in);
        struct exchange_inbox inbox;
        exchange_sparse(&exchange, out, outs, &inbox);
        team_expect(team, inbox.count == ins, "round %u: %zu messages instead of %zu", round, inbox.count,
                    ins);
        for (size_t k = 0; k < ins && k < inbox.count; k++) {
            team_expect(team, inbox.message[k].rank == in[k].rank && inbox.message[k].bytes == in[k].bytes,
                        "round %u: message %zu from rank %d with %zu bytes", round, k, inbox.message[k].rank,
                        inbox.message[k].bytes);
            expect_contents(team, &inbox.message[k], round);
        }
        exchange_inbox_free(&inbox);
        free_messages(out, outs);
        free_messages(in, ins);
    }
    team_finish(team);
}

static void planned(void **state) {
    struct team *team = *state;
    struct exchange exchange;
    exchange_init(&exchange, &team->comm);
    struct exchange_flight flight = {0};
    for (unsigned round = 100; round < 160; round++) {
        exchange.piece = round < 120 ? (size_t)1 << 30 : 8;
        struct exchange_message *out = room_for_all(&team->comm), *in = room_for_all(&team->comm);
        size_t outs = make_messages(&team->comm, round, true, out);
        size_t ins = make_messages(&team->comm, round, false, in);
        exchange_start(&exchange, COMM_TAG_FORWARD, out, outs, in, ins, &flight);
        exchange_finish(&flight);
        for (size_t k = 0; k < ins; k++)
            expect_contents(team, &in[k], round);
        free_messages(out, outs);
        free_messages(in, ins);
    }
    exchange_flight_free(&flight);
    team_finish(team);
}

/* The counted bytes are those of length_of, without the messages of a rank to itself; sparse exchanges are
 * counted apart. */
static void counts(void **state) {
    struct team *team = *state;
    struct exchange exchange;
    struct exchange_flight flight = {0};
    exchange_init(&exchange, &team->comm);
    uint64_t messages = 0, bytes = 0;
    struct exchange_message *out = room_for_all(&team->comm);
    size_t outs = make_messages(&team->comm, 500, true, out);
    for (size_t k = 0; k < outs; k++) {
        messages += out[k].rank != team->comm.rank;
        bytes += out[k].rank != team->comm.rank ? out[k].bytes : 0;
    }
    struct exchange_inbox inbox;
    exchange_sparse(&exchange, out, outs, &inbox);
    team_expect(team, exchange.messages == messages && exchange.bytes == bytes,
                "%llu messages with %llu bytes", (unsigned long long)exchange.messages,
                (unsigned long long)exchange.bytes);
    struct exchange_message *in = room_for_all(&team->comm);
    size_t ins = make_messages(&team->comm, 500, false, in);
    exchange_start(&exchange, COMM_TAG_FORWARD, out, outs, in, ins, &flight);
    exchange_finish(&flight);
    exchange_flight_free(&flight);
    team_expect(
        team,
        exchange.sparse_messages == messages && exchange.sparse_bytes == bytes && exchange.bytes == 2 * bytes,
        "%llu messages with %llu of %llu bytes were sparse", (unsigned long long)exchange.sparse_messages,
        (unsigned long long)exchange.sparse_bytes, (unsigned long long)exchange.bytes);
    exchange_inbox_free(&inbox);
    free_messages(out, outs);
    free_messages(in, ins);
    team_finish(team);
}

static jmp_buf after_fatal;

static void catch_fatal(int status) {
    longjmp(after_fatal, status);
}

/* Runs exchange_finish with stderr kept in a file. Returns true if exchange_finish ended in a fatal error; the
 * text of the error is then in `text`. */
static bool finish_fatally(struct exchange_flight *flight, char *text, size_t size) {
    FILE *kept = tmpfile();
    volatile bool fatal = false;
    fflush(stderr);
    int terminal = dup(STDERR_FILENO);
    assert_true(kept != NULL && terminal >= 0 && dup2(fileno(kept), STDERR_FILENO) >= 0);
    if (setjmp(after_fatal) == 0)
        exchange_finish(flight);
    else
        fatal = true;
    fflush(stderr);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
    rewind(kept);
    text[fread(text, 1, size - 1, kept)] = '\0';
    fclose(kept);
    return fatal;
}

/* The last rank sends 24 bytes to rank 0, which expects `planned_bytes` of them. */
static void expect_wrong_length(struct team *team, size_t planned_bytes, const char *part) {
    const struct comm *comm = &team->comm;
    int last = comm->size - 1;
    char data[64] = "";
    struct exchange exchange;
    exchange_init(&exchange, comm);
    struct exchange_flight flight = {0};
    struct exchange_message out = {0, 24, data}, in = {last, planned_bytes, data};
    exchange_start(&exchange, COMM_TAG_REVERSE, &out, comm->rank == last, &in, comm->rank == 0, &flight);
    if (comm->rank == 0) {
        char text[1024], peer[32];
        snprintf(peer, sizeof peer, "from rank %d", last);
        error_set_abort(0, catch_fatal);
        bool fatal = finish_fatally(&flight, text, sizeof text);
        error_set_abort(0, comm_abort);
        team_expect(team, fatal, "24 bytes were taken for %zu", planned_bytes);
        team_expect(team, strstr(text, "rank 0: MPI_Irecv") != NULL && strstr(text, peer) != NULL, "%s",
                    text);
        team_expect(team, strstr(text, part) != NULL, "'%s' without '%s'", text, part);
    } else {
        exchange_finish(&flight);
    }
    exchange_flight_free(&flight);
    team_finish(team);
}

static void message_too_short(void **state) {
    struct team *team = *state;
    if (team->comm.size == 1)
        team_skip(team, "one rank sends no message");
    expect_wrong_length(team, 32, "(32 bytes expected): a message of 24 bytes came");
}

static void message_too_long(void **state) {
    struct team *team = *state;
    if (team->comm.size == 1)
        team_skip(team, "one rank sends no message");
    expect_wrong_length(team, 16, "16 bytes expected) failed: MPI_ERR_TRUNCATE");
}

TEAM_MAIN(exchange, team_case(sparse), team_case(planned), team_case(counts), team_case(message_too_short),
          team_case(message_too_long))
