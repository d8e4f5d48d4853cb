/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws for tests. Include after cmocka.h. */
#ifndef SCREE_TESTS_LAWS_BY_HAND_H
#define SCREE_TESTS_LAWS_BY_HAND_H

#include "physics/grains/laws/law.h"
#include "physics/grains/laws/law_kernel.h"
#include "base/random.h"
#include <stdlib.h>
#include <string.h>
#include "tests/near.h"
#include "tests/own_law.h"

static const struct law_material glass[2] = {{"glass", 2500.0, 1e9, 0.2}, {"steel", 7200.0, 210e9, 0.2}};

static struct law_pair pairs[2][2];

/* Keeps the tables of a law until the test ends, which is when nobody looks at them any more. */
static inline void law_keep(const struct law *law) {
    static struct law *kept;
    static size_t count;
    kept = realloc(kept, (count + 1) * sizeof *kept);
    if (kept == NULL)
        fail_msg("no memory for law %zu", count);
    kept[count++] = *law;
}

/* A law for materials m[0] and m[1] with the same coefficients for all pairs. Its tables are kept. */
static inline struct law law_for(struct law_options options, const struct law_material m[2],
                                 struct law_pair pair) {
    struct law law;
    struct error error = {0};
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++)
            pairs[a][b] = pair;
    if (!law_prepare(&law, &options, 2, m, pairs[0], &error))
        fail_msg("%s", error.text);
    law_keep(&law);
    return law;
}

#endif
