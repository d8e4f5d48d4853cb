/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes random pairs of rocks, with their distance and normal, or their overlap, for tests/rock_distance.sh, which compares them with FCL. Not a test.
 *
 *   rock_pairs [PAIRS]      to standard output, in numbers of this machine: for each hundred pairs two solids (corners, entries of faces; x y z of
 *                           each corner; of each face its number of corners, then these), and for each pair the rotation of the second (nine numbers), its
 *                           place, 1 if the cores are apart, distance or overlap, normal from the first to the second */
#include "physics/bodies/shapes/deep.h"
#include "physics/bodies/shapes/gjk.h"
#include "tests/physics/bodies/shapes/solid_by_hand.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { TURNS = 100 };

struct record {
    double turn[9], apart[3];
    int64_t parted;
    double length, normal[3];
};

static void solid_write(const struct solid *solid) {
    const int32_t count[2] = {solid->corners, solid->faces + solid->rings};
    fwrite(count, sizeof count, 1, stdout);
    fwrite(solid->corner, sizeof *solid->corner, (size_t)solid->corners, stdout);
    for (int f = 0; f < solid->faces; f++) {
        fwrite(&solid->face[f].sides, sizeof solid->face[f].sides, 1, stdout);
        fwrite(solid->ring + solid->face[f].first, sizeof *solid->ring, (size_t)solid->face[f].sides, stdout);
    }
}

static void pair_write(const struct by_hand *a, struct by_hand *b, struct random_sequence *random, int m) {
    const struct gjk_set set_a = {a->core.corners, a->posed.corner};
    struct gjk_simplex simplex = {0};
    struct gjk_nearest nearest;
    struct record record;
    double q[4], norm = 0;
    by_hand_draw_turn(random, q);
    by_hand_pose(b, q, 0.1);
    for (int d = 0; d < 3; d++) {
        record.apart[d] = random_normal(random);
        norm += record.apart[d] * record.apart[d];
    }
    for (int d = 0; d < 3; d++)
        record.apart[d] *= (0.6 + 0.016 * m) / sqrt(norm);
    const struct gjk_set set_b = {b->core.corners, b->posed.corner};
    memcpy(record.turn, b->turn, sizeof record.turn);
    record.parted = gjk_distance(&set_a, &set_b, record.apart, &simplex, &nearest);
    if (record.parted) {
        record.length = nearest.distance;
        memcpy(record.normal, nearest.normal, sizeof record.normal);
    } else {
        record.length = deep_overlap(&a->posed, &b->posed, record.apart, record.normal);
    }
    fwrite(&record, sizeof record, 1, stdout);
}

int main(int count, char **argument) {
    const long pairs = count > 1 ? atol(argument[1]) : 20000;
    struct random_sequence random = random_sequence(5, RANDOM_TEST, 0);
    for (long n = 0; n < pairs; n += TURNS) {
        struct by_hand a, b;
        if (!by_hand_rock(&a, &random, 6 + (int)(n / TURNS) % 20, 0.1) ||
            !by_hand_rock(&b, &random, 6 + (int)(n / TURNS) % 13, 0.1))
            return 1;
        solid_write(&a.core);
        solid_write(&b.core);
        by_hand_pose(&a, (double[4]){1, 0, 0, 0}, 0.1);
        for (int m = 0; m < TURNS; m++)
            pair_write(&a, &b, &random, m);
        solid_free(&a.core);
        solid_free(&b.core);
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
