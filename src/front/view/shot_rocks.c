/* SPDX-License-Identifier: BSD-3-Clause */
/* Shapes of rocks for a page. Read shot_rocks.h first. */
#include "front/view/shot_rocks.h"
#include "physics/bodies/rocks_state.h"
#include "physics/bodies/shapes/chamfer.h"

bool shot_rocks_there(const struct simulation *s) {
    const struct bodies *bodies = bodies_of(&s->physics);
    return bodies && bodies->rocks;
}

static void shape_write(FILE *file, const struct clump *clump) {
    struct chamfer surface;
    chamfer_make(&surface, &clump->core, clump->rounding);
    fprintf(file, "{\"corners\": [");
    for (int c = 0; c < surface.corners; c++)
        for (int d = 0; d < 3; d++)
            fprintf(file, "%s%.5g", c + d ? ", " : "", surface.corner[c][d] / clump->extent);
    fprintf(file, "], \"polygons\": [");
    for (int p = 0; p < surface.polygons; p++) {
        fprintf(file, "%s[", p ? ", " : "");
        for (int k = surface.start[p]; k < surface.start[p + 1]; k++)
            fprintf(file, "%s%d", k > surface.start[p] ? ", " : "", surface.ring[k]);
        fprintf(file, "]");
    }
    fprintf(file, "]}");
    chamfer_free(&surface);
}

void shot_rocks_write(FILE *file, const struct simulation *s) {
    const struct bodies *bodies = bodies_of(&s->physics);
    fprintf(file, "[");
    for (int k = 0; k < bodies->shapes; k++) {
        fputs(k ? ", " : "", file);
        if (bodies->clump[k].core.faces > 0)
            shape_write(file, &bodies->clump[k]);
        else
            fprintf(file, "null");
    }
    fprintf(file, "]");
}

void shot_rocks_take(const struct simulation *s, size_t i, float row[SHOT_ROCK_NUMBERS]) {
    const int shape = rocks_shape(s->particles, i);
    const double *q = rocks_orientations(s->particles)[i];
    row[0] = (float)(shape + 1);
    for (int k = 0; k < 4; k++)
        row[1 + k] = (float)q[(k + 1) % 4];
}
