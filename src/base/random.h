/* SPDX-License-Identifier: BSD-3-Clause */
/* Counter-based random numbers (Random123's Philox4x32-10): a value depends on the seed, a stream and a
 * counter alone, never on the rank or thread that calls. */
#ifndef SCREE_BASE_RANDOM_H
#define SCREE_BASE_RANDOM_H

#include <stdint.h>

/* The uses of streams: one stream for each use, so that no two uses share numbers. */
enum random_stream {
    RANDOM_POSITION,
    RANDOM_RADIUS,
    RANDOM_VELOCITY,
    RANDOM_INSERTION,
    RANDOM_TEST,
    RANDOM_ORIENTATION,
    RANDOM_SHAPE
};

/* A reader of one sequence: (seed, stream, item) fixes the sequence, and each draw advances `draw`. Plain
 * data; may be copied. */
struct random_sequence {
    uint64_t seed, item;
    uint32_t stream, draw;
};

/* The sequence of item number `item` (a particle, say) in a stream. */
struct random_sequence random_sequence(uint64_t seed, enum random_stream stream, uint64_t item);

/* The next double, uniform in [0, 1) with 53 bits. */
double random_uniform(struct random_sequence *sequence);

/* The next normal variate (mean 0, deviation 1; Box and Muller). */
double random_normal(struct random_sequence *sequence);

#endif
