/* SPDX-License-Identifier: BSD-3-Clause */
/* The copies of a part: the plan of all copies with the others left out. Read ghosts.h first. */
#include "kernel/comm/ghosts.h"
#include "kernel/comm/ghosts_parts.h"
#include "base/memory.h"
#include <string.h>

/* One direction: rows by peer. */
struct side {
    struct peer *peer;
    size_t peers, count;
    int32_t *row;
    struct exchange_message *message;
    char *buffer;
    size_t room;
};

struct ghosts_part {
    struct ghosts *ghosts;
    struct side to, from; /* originals of copies elsewhere; copies here */
};

/* Keeps the entries whose particle has a row. Peers without such an entry get no message. */
static void side_make(struct side *side, const struct peer *peer, size_t peers, const uint32_t *particle,
                      size_t entries, const int32_t *row) {
    side->peer = memory_allocate(peers, sizeof *side->peer, "peers of a part");
    side->row = memory_allocate(entries, sizeof *side->row, "rows of a part");
    side->message = memory_allocate(peers, sizeof *side->message, "messages of a part");
    for (size_t p = 0; p < peers; p++) {
        struct peer own = {peer[p].rank, side->count, 0};
        for (size_t k = peer[p].first; k < peer[p].first + peer[p].count; k++)
            if (row[particle[k]] >= 0)
                side->row[side->count++] = row[particle[k]];
        own.count = side->count - own.first;
        if (own.count > 0)
            side->peer[side->peers++] = own;
    }
}

static void side_free(struct side *side) {
    memory_free(side->peer);
    memory_free(side->row);
    memory_free(side->message);
    memory_free(side->buffer);
}

struct ghosts_part *ghosts_part_create(struct ghosts *ghosts, const int32_t *row) {
    struct ghosts_part *part = memory_allocate_zero(1, sizeof *part, "part of the copies");
    part->ghosts = ghosts;
    side_make(&part->to, ghosts->to, ghosts->to_count, ghosts->original, ghosts->sent, row);
    side_make(&part->from, ghosts->from, ghosts->from_count, ghosts->number, ghosts->held, row);
    return part;
}

void ghosts_part_destroy(struct ghosts_part **part) {
    if (*part == NULL)
        return;
    side_free(&(*part)->to);
    side_free(&(*part)->from);
    memory_free(*part);
    *part = NULL;
}

static void side_messages(struct side *side, size_t each) {
    if (side->count * each > side->room) {
        side->room = side->count * each;
        memory_free(side->buffer);
        side->buffer = memory_allocate(side->room, 1, "values of a part");
    }
    for (size_t p = 0; p < side->peers; p++)
        side->message[p] = (struct exchange_message){side->peer[p].rank, side->peer[p].count * each,
                                                     side->buffer + side->peer[p].first * each};
}

/* Packs the rows of one side, and has them in the buffer of the other. */
static void cross(struct ghosts_part *part, enum comm_tag tag, struct side *out, struct side *in,
                  const double *value, int width) {
    struct ghosts *ghosts = part->ghosts;
    size_t each = (size_t)width * sizeof *value;
    side_messages(out, each);
    side_messages(in, each);
    for (size_t k = 0; k < out->count; k++)
        memcpy(out->buffer + k * each, value + (size_t)out->row[k] * (size_t)width, each);
    exchange_start(&ghosts->exchange, tag, out->message, out->peers, in->message, in->peers, &ghosts->flight);
    exchange_finish(&ghosts->flight);
}

void ghosts_part_forward(struct ghosts_part *part, double *value, int width) {
    struct side *in = &part->from;
    size_t each = (size_t)width * sizeof *value;
    cross(part, COMM_TAG_FORWARD, &part->to, in, value, width);
    for (size_t k = 0; k < in->count; k++)
        memcpy(value + (size_t)in->row[k] * (size_t)width, in->buffer + k * each, each);
}

void ghosts_part_sum(struct ghosts_part *part, double *value, int width) {
    struct side *in = &part->to;
    cross(part, COMM_TAG_REVERSE, &part->from, in, value, width);
    for (size_t k = 0; k < in->count; k++) {
        const double *more = (const double *)(const void *)in->buffer + k * (size_t)width;
        double *sum = value + (size_t)in->row[k] * (size_t)width;
        for (int c = 0; c < width; c++)
            sum[c] += more[c];
    }
}
