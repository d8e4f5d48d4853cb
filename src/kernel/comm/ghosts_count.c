/* SPDX-License-Identifier: BSD-3-Clause */
/* The counters of the plan of the copies, and a check that the plan is consistent. */
#include "kernel/comm/ghosts_parts.h"

#include <stdio.h>
#include <string.h>

/* The number of other ranks in either list; both lists are sorted. */
static size_t count_neighbours(const struct ghosts *ghosts) {
    size_t t = 0, f = 0, count = 0;
    while (t < ghosts->to_count || f < ghosts->from_count) {
        int a = t < ghosts->to_count ? ghosts->to[t].rank : ghosts->comm->size;
        int b = f < ghosts->from_count ? ghosts->from[f].rank : ghosts->comm->size;
        int rank = a < b ? a : b;
        t += a == rank;
        f += b == rank;
        count += rank != ghosts->comm->rank;
    }
    return count;
}

void ghosts_count(const struct ghosts *ghosts, struct ghosts_counts *counts) {
    *counts = (struct ghosts_counts){.ghosts = ghosts->held,
                                     .neighbours = count_neighbours(ghosts),
                                     .messages = ghosts->exchange.messages,
                                     .bytes = ghosts->exchange.bytes,
                                     .rebuild_messages = ghosts->exchange.sparse_messages,
                                     .rebuild_bytes = ghosts->exchange.sparse_bytes,
                                     .migrated = ghosts->migrated,
                                     .clearance = domain_clearance(ghosts->domain),
                                     .reach = ghosts->farthest,
                                     .rounds = ghosts->rounds};
    memcpy(counts->bytes_class, ghosts->class_bytes, sizeof counts->bytes_class);
    memcpy(counts->ghosts_class, ghosts->class_count, sizeof counts->ghosts_class);
}

static bool peers_valid(const struct peer *peer, size_t peers, size_t total) {
    size_t at = 0;
    for (size_t k = 0; k < peers; k++) {
        if (peer[k].first != at || peer[k].count == 0 || (k > 0 && peer[k].rank <= peer[k - 1].rank))
            return false;
        at += peer[k].count;
    }
    return at == total;
}

bool ghosts_valid(const struct ghosts *ghosts, const struct particles *particles, char *why,
                  size_t why_size) {
    if (particles->ghosts != ghosts->held || particles->revision != ghosts->revision)
        return snprintf(why, why_size, "plan of %zu copies, revision %llu, but %zu copies, revision %llu",
                        ghosts->held, (unsigned long long)ghosts->revision, particles->ghosts,
                        (unsigned long long)particles->revision) < 0;
    if (!peers_valid(ghosts->to, ghosts->to_count, ghosts->sent) ||
        !peers_valid(ghosts->from, ghosts->from_count, ghosts->held))
        return snprintf(why, why_size, "peers are out of order or do not add up") < 0;
    for (size_t t = 0; t < ghosts->to_count; t++)
        for (size_t k = ghosts->to[t].first; k < ghosts->to[t].first + ghosts->to[t].count; k++)
            if (ghosts->original[k] >= particles->owned)
                return snprintf(why, why_size, "original %u of copy %zu for rank %d is none",
                                ghosts->original[k], k, ghosts->to[t].rank) < 0;
    for (size_t f = 0; f < ghosts->from_count; f++)
        for (size_t k = ghosts->from[f].first; k < ghosts->from[f].first + ghosts->from[f].count; k++)
            if (ghosts->from[f].rank == ghosts->comm->rank && ghosts->image[k] == 0)
                return snprintf(why, why_size, "copy %zu stands where its original does", k) < 0;
    return true;
}
