/* SPDX-License-Identifier: BSD-3-Clause */
/* One draw is one block of Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
 * SC11): counter = (draw, stream, item), key = seed. */
#include "base/random.h"

#include <math.h>

#include <Random123/philox.h>

struct random_sequence random_sequence(uint64_t seed, enum random_stream stream, uint64_t item) {
    return (struct random_sequence){.seed = seed, .item = item, .stream = stream, .draw = 0};
}

static philox4x32_ctr_t next_block(struct random_sequence *sequence) {
    philox4x32_ctr_t counter = {
        {sequence->draw, sequence->stream, (uint32_t)sequence->item, (uint32_t)(sequence->item >> 32)}};
    philox4x32_key_t key = {{(uint32_t)sequence->seed, (uint32_t)(sequence->seed >> 32)}};
    sequence->draw++;
    return philox4x32(counter, key);
}

/* The 53 high bits of two words as a number in [0, 1). */
static double unit_interval(uint32_t low, uint32_t high) {
    uint64_t bits = (uint64_t)high << 32 | low;
    return (double)(bits >> 11) * 0x1p-53;
}

double random_uniform(struct random_sequence *sequence) {
    philox4x32_ctr_t block = next_block(sequence);
    return unit_interval(block.v[0], block.v[1]);
}

double random_normal(struct random_sequence *sequence) {
    philox4x32_ctr_t block = next_block(sequence);
    double radius = sqrt(-2 * log1p(-unit_interval(block.v[0], block.v[1])));
    return radius * cos(2 * M_PI * unit_interval(block.v[2], block.v[3]));
}
