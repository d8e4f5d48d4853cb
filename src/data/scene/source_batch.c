/* SPDX-License-Identifier: BSD-3-Clause */
/* The common part of the kinds of particle source: the life of a batch, keys for messages, the region that is
 * meant. */
#include "data/scene/source_batch.h"
#include "base/memory.h"

#include <stdio.h>
#include <string.h>

void source_batch_free(struct source_batch *batch) {
    rows_free(&batch->rows);
    memory_free(batch->form);
    batch->form = NULL;
}

const char *source_key(int source, const char *key, char *text, size_t room) {
    snprintf(text, room, "particles.sources[%d].%s", source, key);
    return text;
}

struct region source_region(const struct scene *scene, const struct region *region,
                            struct region_space *space) {
    struct region resolved = *region;
    if (region->shape == REGION_ALL) {
        resolved.shape = REGION_BOX;
        memcpy(resolved.lower, scene->box_lower, sizeof(resolved.lower));
        memcpy(resolved.upper, scene->box_upper, sizeof(resolved.upper));
    }
    *space = (struct region_space){.dimension = scene->box.dimension,
                                   .plane = (scene->box_lower[2] + scene->box_upper[2]) / 2};
    for (int d = 0; d < 3; d++)
        space->wrap[d] = scene->box.periodic[d] && resolved.shape == REGION_BOX &&
                         resolved.lower[d] <= scene->box_lower[d] && resolved.upper[d] >= scene->box_upper[d];
    return resolved;
}

bool source_room(double count, double bytes, struct error *error) {
    const double gib = 1024.0 * 1024.0 * 1024.0;
    size_t room = memory_room();
    return room == SIZE_MAX || count * bytes <= (double)room ||
           error_set(error, ERROR_USER,
                     "particles: %.0f particles need %.3g GiB of memory at least, and %.3g GiB are free "
                     "here; allowed: "
                     "fewer particles, or more ranks on other machines",
                     count, count * bytes / gib, (double)room / gib);
}
