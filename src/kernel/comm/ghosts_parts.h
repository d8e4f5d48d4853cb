/* SPDX-License-Identifier: BSD-3-Clause */
/* Private parts of the plan of the copies; ghosts.c states the invariants. Only ghosts.c, ghosts_count.c,
 * ghosts_part.c, ghosts_stay.c and ghosts_used.c include this header. */
#ifndef SCREE_COMM_GHOSTS_PARTS_H
#define SCREE_COMM_GHOSTS_PARTS_H

#include "kernel/comm/exchange.h"
#include "kernel/comm/ghosts.h"

/* Copies exchanged with one rank. */
struct peer {
    int rank;
    size_t first, count;
};

/* The copies that pairs use: those that travel in a step. `to` and `from` have the peers of the plan, with the
 * numbers of such copies. */
struct ghosts_used {
    bool known; /* else all copies travel */
    struct peer *to, *from;
    uint32_t *original, *number;
    size_t sent, held;
    uint64_t class_count[CLASS_MAX];
};

struct ghosts {
    const struct comm *comm;
    const struct domain *domain;
    const struct box *box;
    struct ghosts_options options;
    struct exchange exchange;
    struct exchange_flight flight;
    struct field_list flying; /* the fields of a forward exchange between begin and end */
    bool flying_used;         /* they are those of the copies that pairs use */
    struct ghosts_used used;
    struct peer *to, *from;
    size_t to_count, from_count;
    uint32_t *original; /* owned particle of each copy sent */
    size_t sent;
    uint32_t *border; /* owned particles that have copies, each once */
    size_t border_count;
    uint8_t *image;     /* code of each ghost */
    uint32_t *number;   /* of each ghost: owned + k */
    double (*place)[3]; /* in_place: where the original of each ghost stood when it was made */
    size_t held;
    char *to_buffer, *from_buffer; /* values of all copies sent, and of all held */
    size_t to_room, from_room;
    struct exchange_message *to_message, *from_message;
    double shift[IMAGE_CODES][4];
    uint64_t revision; /* of the particles when the copies were made */
    uint64_t migrated;
    uint64_t class_count[CLASS_MAX], class_bytes[CLASS_MAX];
    double outside;  /* particles may lie so far outside of their subdomains: copies reach farther */
    double farthest; /* the largest ball that reached beyond the neighbours; 0: none */
    int rounds;      /* the most that a spread of shadows took */
    struct {
        int64_t id; /* -1: none */
        double radius, reach, clearance;
    } misfit;
};

/* Makes the list of the copies that pairs use, from one byte for each copy sent and for each held. */
void ghosts_used_make(struct ghosts *ghosts, const struct particles *particles, const uint8_t *sent,
                      const uint8_t *held);
void ghosts_used_free(struct ghosts_used *used);

#endif
