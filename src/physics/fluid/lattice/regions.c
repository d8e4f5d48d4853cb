/* SPDX-License-Identifier: BSD-3-Clause */
/* Connected regions: each rank floods its own planes, piece after piece; then labels spread between ranks through the
 * planes that meet, until each piece has the lowest label of its region. Read regions.h first. */
#include "physics/fluid/lattice/regions.h"
#include "kernel/comm/exchange.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

/* A region, or this rank's part of a region: the label is the lowest number on the lattice of its nodes. */
struct part {
    int64_t label, nodes;
};

/* The pieces of this rank: piece k is the own fluid nodes with owner k. */
struct pieces {
    int32_t count, room;
    struct part *piece;
};

static bool is_own_fluid(const struct nodes *nodes, int64_t node) {
    return nodes->state[node] == NODES_FLUID && nodes_own(nodes, node);
}

/* Gives all own fluid nodes that are joined to `start` the number of a piece; `stack` has room for all nodes. Returns how
 * many they are. */
static int64_t flood(struct nodes *nodes, int64_t start, int32_t number, int64_t *stack) {
    const int(*steps)[3];
    int edges = arrangement_edges(&nodes->lattice, &steps);
    int64_t depth = 0, count = 0;
    stack[depth++] = start;
    nodes->owner[start] = number;
    while (depth > 0) {
        int64_t node = stack[--depth];
        count++;
        for (int k = 0; k < edges; k++) {
            int64_t next = nodes_neighbour(nodes, node, steps[k]);
            if (next < 0 || !is_own_fluid(nodes, next) || nodes->owner[next] >= 0)
                continue;
            nodes->owner[next] = number;
            stack[depth++] = next;
        }
    }
    return count;
}

/* Own nodes come in the order of their numbers on the lattice, so the first one of a piece has the lowest. */
static struct pieces pieces_find(struct nodes *nodes) {
    struct pieces pieces = {0};
    int64_t *stack = memory_allocate((size_t)nodes->all, sizeof *stack, "regions of fluid");
    for (int64_t node = 0; node < nodes->all; node++)
        if (nodes->state[node] == NODES_FLUID)
            nodes->owner[node] = -1;
    for (int64_t node = 0; node < nodes->all; node++) {
        if (!is_own_fluid(nodes, node) || nodes->owner[node] >= 0)
            continue;
        if (pieces.count == pieces.room) {
            pieces.room = 2 * pieces.room + 16;
            pieces.piece =
                memory_resize(pieces.piece, (size_t)pieces.room, sizeof *pieces.piece, "regions of fluid");
        }
        int64_t size = flood(nodes, node, pieces.count, stack);
        pieces.piece[pieces.count++] = (struct part){nodes_number(nodes, node), size};
    }
    memory_free(stack);
    return pieces;
}

/* The planes through which labels spread: this rank's outermost own ones, and those of other ranks next to them. Labels
 * are by node of a plane; DRY where there is no fluid. */
struct faces {
    size_t nodes;      /* of a plane */
    int64_t plane[2];  /* of other ranks, below and above the own planes; -1: none */
    int64_t *label[2]; /* theirs */
    int64_t *out;      /* two messages: number of an own plane, and its labels */
};
#define DRY INT64_MAX

/* A plane that may lie beyond a side; -1 beyond an open one. */
static int64_t plane_at(const struct nodes *nodes, int64_t plane) {
    int64_t whole = nodes->whole[nodes->cut];
    if (nodes->box->periodic[nodes->cut])
        return (plane + whole) % whole;
    return plane < 0 || plane >= whole ? -1 : plane;
}

static void faces_make(struct faces *faces, const struct nodes *nodes) {
    int64_t own = nodes->own[1] - nodes->own[0];
    bool some = own > 0 && own < nodes->whole[nodes->cut];
    faces->nodes = (size_t)(nodes->whole[0] * (nodes->cut == 2 ? nodes->whole[1] : 1));
    faces->plane[0] = some ? plane_at(nodes, nodes->own[0] - 1) : -1;
    faces->plane[1] = some ? plane_at(nodes, nodes->own[1]) : -1;
    for (int side = 0; side < 2; side++)
        faces->label[side] = memory_allocate(faces->nodes, sizeof(int64_t), "regions of fluid");
    faces->out = memory_allocate(2 * (faces->nodes + 1), sizeof(int64_t), "regions of fluid");
}

static void faces_free(struct faces *faces) {
    memory_free(faces->label[0]);
    memory_free(faces->label[1]);
    memory_free(faces->out);
}

/* The first node of the outermost own plane of a side. */
static int64_t face_begin(const struct faces *faces, const struct nodes *nodes, int side) {
    int64_t whole = nodes->whole[nodes->cut], plane = side ? nodes->own[1] - 1 : nodes->own[0];
    return (plane - nodes->plane + whole) % whole * (int64_t)faces->nodes;
}

/* Writes the labels of the outermost own plane of a side into a message. */
static void face_write(const struct faces *faces, const struct nodes *nodes, const struct pieces *pieces,
                       int side) {
    int64_t first = face_begin(faces, nodes, side), *out = faces->out + (size_t)side * (faces->nodes + 1);
    *out++ = nodes_plane(nodes, first);
    for (size_t k = 0; k < faces->nodes; k++) {
        int64_t node = first + (int64_t)k;
        out[k] = nodes->state[node] == NODES_FLUID ? pieces->piece[nodes->owner[node]].label : DRY;
    }
}

/* Takes the messages that arrived: a plane may be next to the own ones on both sides. */
static void faces_read(const struct faces *faces, const struct exchange_inbox *inbox) {
    size_t bytes = (faces->nodes + 1) * sizeof(int64_t);
    for (size_t m = 0; m < inbox->count; m++)
        for (size_t at = 0; at + bytes <= inbox->message[m].bytes; at += bytes) {
            int64_t plane;
            memcpy(&plane, inbox->message[m].data + at, sizeof plane);
            for (int side = 0; side < 2; side++)
                if (plane == faces->plane[side])
                    memcpy(faces->label[side], inbox->message[m].data + at + sizeof plane,
                           bytes - sizeof plane);
        }
}

/* Sends the labels of the outermost own planes to the ranks next to them. Collective. */
static void faces_exchange(const struct faces *faces, struct exchange *exchange, const struct nodes *nodes,
                           const struct pieces *pieces) {
    struct exchange_inbox inbox = {0};
    struct exchange_message out[2];
    size_t n = 0, bytes = (faces->nodes + 1) * sizeof(int64_t);
    for (int side = 0; side < 2; side++) {
        if (faces->plane[side] < 0)
            continue;
        int rank = nodes_rank_of(nodes, faces->plane[side]);
        face_write(faces, nodes, pieces, side);
        if (n > 0 && out[0].rank == rank) /* the two messages lie together */
            out[0].bytes += bytes;
        else
            out[n++] = (struct exchange_message){rank, bytes, (char *)faces->out + (size_t)side * bytes};
    }
    exchange_sparse(exchange, out, n, &inbox);
    faces_read(faces, &inbox);
    exchange_inbox_free(&inbox);
}

/* Lowers the label of the piece of a node to the lowest next to it on other ranks; true if it was higher. */
static bool lower(const struct faces *faces, const struct nodes *nodes, struct part *piece, int64_t node) {
    const int(*steps)[3];
    int edges = arrangement_edges(&nodes->lattice, &steps);
    int64_t before = piece->label;
    for (int k = 0; k < edges; k++) {
        int64_t next = nodes_neighbour(nodes, node, steps[k]);
        if (next < 0 || nodes_own(nodes, next))
            continue;
        int64_t plane = nodes_plane(nodes, next), at = next % (int64_t)faces->nodes;
        for (int side = 0; side < 2; side++)
            if (plane == faces->plane[side] && faces->label[side][at] < piece->label)
                piece->label = faces->label[side][at];
    }
    return piece->label < before;
}

/* Labels spread until nothing changes. Collective. */
static void spread(const struct nodes *nodes, struct pieces *pieces) {
    struct faces faces;
    struct exchange exchange;
    int64_t changed = nodes->comm->size > 1;
    faces_make(&faces, nodes);
    exchange_init(&exchange, nodes->comm);
    while (changed) {
        changed = 0;
        faces_exchange(&faces, &exchange, nodes, pieces);
        for (int side = 0; side < 2; side++) {
            int64_t first = face_begin(&faces, nodes, side), end = first + (int64_t)faces.nodes;
            for (int64_t node = first; faces.plane[side] >= 0 && node < end; node++)
                if (nodes->state[node] == NODES_FLUID)
                    changed |= lower(&faces, nodes, &pieces->piece[nodes->owner[node]], node);
        }
        comm_max_int(nodes->comm, &changed, 1);
    }
    faces_free(&faces);
}

static int by_label(const void *a, const void *b) {
    const struct part *x = a, *y = b;
    return (x->label > y->label) - (x->label < y->label);
}

static int larger_first(const void *a, const void *b) {
    const struct part *x = a, *y = b;
    return x->nodes != y->nodes ? (x->nodes < y->nodes) - (x->nodes > y->nodes) : by_label(a, b);
}

/* Adds up the parts of each region; returns how many regions there are. */
static size_t merge(struct part *region, size_t count) {
    size_t merged = 0;
    qsort(region, count, sizeof *region, by_label);
    for (size_t k = 0; k < count; k++)
        if (merged > 0 && region[merged - 1].label == region[k].label)
            region[merged - 1].nodes += region[k].nodes;
        else
            region[merged++] = region[k];
    return merged;
}

/* All regions, from the largest one on, on all ranks; allocated. Collective. */
static struct part *regions_gather(const struct comm *comm, const struct pieces *pieces, int64_t *count) {
    size_t own = (size_t)pieces->count;
    struct part *mine = memory_allocate(own, sizeof *mine, "regions of fluid");
    void *all = NULL;
    if (own > 0)
        memcpy(mine, pieces->piece, own * sizeof *mine);
    own = merge(mine, own);
    size_t bytes = comm_gather_varying(comm, mine, own * sizeof *mine, &all, NULL);
    memory_free(mine);
    *count = all ? (int64_t)merge(all, bytes / sizeof *mine) : 0;
    comm_broadcast(comm, count, sizeof *count);
    struct part *region = memory_allocate((size_t)*count, sizeof *region, "regions of fluid");
    if (all) {
        qsort(all, (size_t)*count, sizeof *region, larger_first);
        memcpy(region, all, (size_t)*count * sizeof *region);
    }
    memory_free(all);
    comm_broadcast(comm, region, (size_t)*count * sizeof *region);
    return region;
}

/* Which regions stay fluid, their numbers by piece in `to`. */
static struct regions choose(const struct part *region, int64_t count, const struct pieces *pieces,
                             int32_t *to) {
    struct regions regions = {0};
    for (int64_t k = 0; k < count; k++) {
        bool kept = (double)region[k].nodes >= REGIONS_POCKET * (double)region[0].nodes;
        regions.count += kept;
        *(kept ? &regions.fluid : &regions.pocket) += region[k].nodes;
    }
    /* kept regions are the first ones; there are few of them */
    for (int32_t p = 0; p < pieces->count; p++) {
        to[p] = REGIONS_NOBODY;
        for (int32_t k = 0; k < regions.count; k++)
            if (region[k].label == pieces->piece[p].label)
                to[p] = k;
    }
    return regions;
}

struct regions regions_find(struct nodes *nodes) {
    struct pieces pieces = pieces_find(nodes);
    int64_t count;
    spread(nodes, &pieces);
    struct part *region = regions_gather(nodes->comm, &pieces, &count);
    int32_t *to = memory_allocate((size_t)pieces.count, sizeof *to, "regions of fluid");
    struct regions regions = choose(region, count, &pieces, to);
    for (int64_t node = 0; node < nodes->all; node++) {
        if (!is_own_fluid(nodes, node))
            continue;
        nodes->owner[node] = to[nodes->owner[node]];
        if (nodes->owner[node] == REGIONS_NOBODY)
            nodes->state[node] = NODES_SOLID;
    }
    memory_free(to);
    memory_free(region);
    memory_free(pieces.piece);
    return regions;
}
