/* SPDX-License-Identifier: BSD-3-Clause */
/* Test for a wall at the place of a new sphere. The same geometry as for forces, for one sphere at any
 * place. */
#include "physics/grains/walls/walls_near.h"
#include "physics/grains/walls/walls_touch.h"
#include "base/memory.h"

static bool overlaps_wall(const struct walls *walls, int w, struct law_vector x, double radius) {
    size_t pieces = walls_near(walls, w, x, radius, NULL, NULL);
    if (pieces == 0)
        return false;
    struct wall_scratch scratch = {0};
    struct wall_piece *piece = memory_allocate(pieces, sizeof *piece, "walls");
    int32_t *number = memory_allocate(pieces, sizeof *number, "walls");
    walls_scratch_reserve(&scratch, pieces);
    walls_near(walls, w, x, radius, piece, number);
    bool touches = walls_touch(walls, piece, pieces, x, radius, &scratch) > 0;
    walls_scratch_free(&scratch);
    memory_free(piece);
    memory_free(number);
    return touches;
}

bool walls_overlap(const struct walls *walls, const double x[3], double radius) {
    for (int w = 0; w < walls->count; w++)
        if (overlaps_wall(walls, w, wall_vector(x), radius))
            return true;
    return false;
}
