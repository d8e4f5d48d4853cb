/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the shapes of a scene. Read bodies_shapes.h first. */
#include "physics/bodies/bodies_shapes.h"
#include "physics/bodies/shapes/chamfer.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>

int bodies_shapes_count(const struct bodies_options *options) {
    int count = options->clumps;
    for (int k = 0; k < options->rocks; k++)
        count += bodies_variants(&options->rock[k]);
    return count;
}

const char *bodies_shapes_key(const struct bodies_options *options, int k, const char *key, char *text,
                              size_t room) {
    const bool rock = k >= options->clumps;
    snprintf(text, room, "bodies.%s[%d]%s%s", rock ? "shapes" : "clumps", rock ? k - options->clumps : k,
             key[0] ? "." : "", key);
    return text;
}

void bodies_shapes_free(struct bodies *bodies) {
    for (int k = 0; k < bodies->shapes; k++)
        clump_free(&bodies->clump[k]);
    memory_free(bodies->clump);
    memory_free(bodies->entry);
}

double bodies_shapes_radius(const struct clump *clump) {
    return cbrt(clump->volume / (4 * M_PI / 3));
}

/* Of an entry by volume all variants have the volume of their grain, and the ball around the longest one is the grain. */
static void spans_find(struct clump *clump, int count) {
    double ball = 0;
    for (int k = 0; k < count; k++)
        ball = fmax(ball, clump[k].extent / bodies_shapes_radius(&clump[k]));
    for (int k = 0; k < count; k++)
        clump[k].span = ball * bodies_shapes_radius(&clump[k]);
}

bool bodies_shapes_make(struct bodies *bodies, const struct scene *scene,
                        const struct bodies_options *options, struct error *error) {
    bodies->options = options;
    bodies->shapes = bodies_shapes_count(options);
    struct clump *clump = bodies->clump =
        memory_allocate_zero((size_t)bodies->shapes, sizeof *clump, "shapes of bodies");
    const struct clump_entry **entry = bodies->entry =
        memory_allocate_zero((size_t)bodies->shapes, sizeof *entry, "shapes of bodies");
    int number = 0;
    for (int k = 0; k < options->clumps; k++, number++) {
        entry[number] = &options->clump[k].entry;
        if (!clump_make(&clump[number], scene, k, &options->clump[k], error))
            return false;
        spans_find(&clump[number], 1);
    }
    for (int k = 0; k < options->rocks; k++) {
        const int variants = bodies_variants(&options->rock[k]), first = number;
        for (int v = 0; v < variants; v++, number++) {
            entry[number] = &options->rock[k].entry;
            if (!rock_make(&clump[number], scene, k, &options->rock[k], v, error))
                return false;
        }
        spans_find(&clump[first], variants);
    }
    return true;
}

void bodies_shapes_show(const struct bodies *bodies, struct output_shapes *shapes) {
    for (int k = 0; k < bodies->shapes; k++) {
        const struct clump *clump = &bodies->clump[k];
        struct chamfer surface;
        if (clump->core.faces == 0)
            continue;
        struct output_shape *shape = output_shapes_add(shapes);
        chamfer_make(&surface, &clump->core, clump->rounding);
        *shape = (struct output_shape){.number = k,
                                       .radius = clump->extent,
                                       .rounding = clump->rounding,
                                       .corners = surface.corners,
                                       .polygons = surface.polygons,
                                       .corner = surface.corner,
                                       .start = surface.start,
                                       .ring = surface.ring};
        snprintf(shape->name, sizeof shape->name, "%s", bodies->entry[k]->name);
    }
}
