/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the contacts of a cloud of spheres by scree's search, without the engine:
 *
 *     cc search.c -o search $(pkg-config --cflags --libs scree-index) -lm && ./search */
#include <math.h>
#include <scree_pairs.h>
#include <stdio.h>
#include <stdlib.h>

enum { SPHERES = 2000 };

/* The next number of a simple sequence in [0, 1). */
static double next(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

int main(void) {
    static double position[SPHERES][3], radius[SPHERES];
    struct scree_spheres spheres = {.count = SPHERES,
                                    .position = position[0],
                                    .radius = radius,
                                    .edge = {20, 20, 20},
                                    .periodic = {true, true, false},
                                    .dimension = 3};
    struct scree_pair *pairs = NULL;
    char why[256];
    size_t found = 0, touching = 0;
    uint64_t state = 1;
    for (int k = 0; k < SPHERES; k++) {
        for (int d = 0; d < 3; d++)
            position[k][d] = 20 * next(&state);
        radius[k] = k % 100 == 0 ? 2 : 0.2;
    }
    if (!scree_pairs("hgrid", &spheres, 0.1, 0, &pairs, &found, why, sizeof why)) {
        fprintf(stderr, "search: %s\n", why);
        return EXIT_FAILURE;
    }
    for (size_t p = 0; p < found; p++) {
        double d2 = 0;
        for (int d = 0; d < 3; d++)
            d2 += pow(position[pairs[p].j][d] + pairs[p].image[d] * spheres.edge[d] - position[pairs[p].i][d],
                      2);
        touching += sqrt(d2) < radius[pairs[p].i] + radius[pairs[p].j];
    }
    printf("%zu pairs nearer than 0.1, %zu of them touch\n", found, touching);
    scree_free(pairs);
    return EXIT_SUCCESS;
}
