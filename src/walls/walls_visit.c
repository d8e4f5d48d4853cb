/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls for each particle that touches a wall, or is near one, without forces. Read wall.h first. */
#include "walls/walls_history.h"
#include "walls/walls_parts.h"
#include "walls/walls_touch.h"

void walls_visit_fixed(struct walls *walls) {
    walls->fixed_too = true;
}

void walls_visit(const struct walls *walls, const struct particles *particles, int thread, double range,
                 walls_visitor *visitor, void *context) {
    size_t first = walls->candidates * (size_t)thread / (size_t)walls->threads;
    size_t end = walls->candidates * ((size_t)thread + 1) / (size_t)walls->threads;
    struct wall_scratch *scratch = walls->scratch[thread];
    const struct wall_records *old = &walls->records[walls->now];
    size_t components = (size_t)walls->law->history_components;
    for (size_t k = first; k < end; k++) {
        const struct particle_state *state = &particles->state[walls->particle[k]];
        double radius = state->radius + range;
        for (size_t piece = walls->first[k], next; piece < walls->first[k + 1]; piece = next) {
            int w = walls->piece[piece].wall;
            for (next = piece + 1; next < walls->first[k + 1] && walls->piece[next].wall == w;)
                next++;
            size_t count = walls_touch(walls, walls->piece + piece, next - piece, wall_vector(state->x),
                                       radius, scratch);
            if (count > 1 && walls->wall[w].image_count > 1)
                walls_sort_images(scratch->touch, count);
            if (components > 0 && count > 0)
                walls_recall(walls, k, w, count, wall_vector(state->x), radius, scratch);
            for (size_t c = 0; c < count; c++) {
                const double *record = NULL;
                if (components > 0 && scratch->from[c] >= 0)
                    record = old->value + (walls->first[k] + (size_t)scratch->from[c]) * components;
                visitor(context, walls->particle[k], w, scratch->touch[c].distance - state->radius, record);
            }
        }
    }
}
