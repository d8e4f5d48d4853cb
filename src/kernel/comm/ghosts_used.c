/* SPDX-License-Identifier: BSD-3-Clause */
/* The copies that pairs use: the plan of all copies, thinned. Owner and holder thin the same list in the same
 * order, so messages need no numbers. */
#include "kernel/comm/ghosts_parts.h"

#include "base/memory.h"

/* The entries of a list that are used, and their peers. */
static struct peer *thin(const struct peer *peer, size_t peers, const uint32_t *entry, const uint8_t *used,
                         uint32_t **kept, size_t *count) {
    struct peer *thinned = memory_allocate(peers, sizeof *thinned, "peers");
    size_t all = peers > 0 ? peer[peers - 1].first + peer[peers - 1].count : 0, n = 0;
    *count = 0;
    for (size_t k = 0; k < all; k++)
        *count += used[k] != 0;
    *kept = memory_allocate(*count, sizeof **kept, "copies in use");
    for (size_t p = 0; p < peers; p++) {
        thinned[p] = (struct peer){peer[p].rank, n, 0};
        for (size_t k = peer[p].first; k < peer[p].first + peer[p].count; k++)
            if (used[k])
                (*kept)[n++] = entry[k];
        thinned[p].count = n - thinned[p].first;
    }
    return thinned;
}

void ghosts_used_make(struct ghosts *ghosts, const struct particles *particles, const uint8_t *sent,
                      const uint8_t *held) {
    struct ghosts_used *used = &ghosts->used;
    ghosts_used_free(used);
    used->known = true;
    used->to = thin(ghosts->to, ghosts->to_count, ghosts->original, sent, &used->original, &used->sent);
    used->from = thin(ghosts->from, ghosts->from_count, ghosts->number, held, &used->number, &used->held);
    for (size_t k = 0; k < used->held; k++)
        used->class_count[particles->size_class[used->number[k]]]++;
}

void ghosts_used_free(struct ghosts_used *used) {
    memory_free(used->to);
    memory_free(used->from);
    memory_free(used->original);
    memory_free(used->number);
    *used = (struct ghosts_used){0};
}
