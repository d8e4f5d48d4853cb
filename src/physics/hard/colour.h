/* SPDX-License-Identifier: BSD-3-Clause */
/* Colours of pairs: no two pairs of one colour have a particle in common. The colours follow from the ids of the
 * particles and from the pairs alone, not from their order in memory, threads or ranks.
 *
 * A particle with many partners (a *hub*) would need a colour for each of them. The pairs of a hub therefore make a
 * bundle, which one thread visits in the order of ids, and bundles get colours as pairs do. */
#ifndef SCREE_HARD_COLOUR_H
#define SCREE_HARD_COLOUR_H

#include <stddef.h>
#include <stdint.h>

/* A particle with more partners than this is a hub. */
enum { HARD_HUB = 40 };

/* Pairs that are visited one after another, `first` up to `last` of struct hard_colours.order, and the groups of
 * those that may be visited at once. */
struct hard_colours {
    size_t pairs;
    uint32_t *order; /* numbers of the pairs */
    size_t cuts;
    size_t *cut; /* cuts + 1 */
    int colours;
    size_t *colour; /* colours + 1: first cut of each */
};

/* Colours `pairs` pairs (end[k][0], end[k][1]) of `particles` particles with these ids. Two pairs of the same
 * particles are told apart by `image`, the image code of the second one, and then by `tie`, two numbers for its two ends (NULL: by
 * nothing). Allocates; hard_colours_free releases. One thread. */
void hard_colours_make(struct hard_colours *colours, size_t pairs, const uint32_t (*end)[2],
                       const uint8_t *image, const int64_t (*tie)[2], size_t particles, const int64_t *id);
void hard_colours_free(struct hard_colours *colours);

#endif
