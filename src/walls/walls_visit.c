/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls for each particle that touches a wall, or is near one, without the forces of a law. Read wall.h first. */
#include "walls/walls_history.h"
#include "walls/walls_parts.h"
#include "walls/walls_touch.h"

void walls_visit_fixed(struct walls *walls) {
    walls->fixed_too = true;
}

static void store(struct law_vector from, double to[3]) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

static struct wall_place place_of(const struct walls *walls, int w, const struct wall_touch *touch,
                                  const struct particle_state *state) {
    struct wall_place place = {.wall = w, .feature = touch->feature, .gap = touch->distance - state->radius};
    struct law_vector x = law_add(wall_vector(state->x), -1.0, walls_shift(walls, w, touch->image));
    struct law_vector at = law_add(x, touch->distance, touch->normal);
    store(touch->normal, place.normal);
    store(at, place.at);
    store(wall_twist_at(&walls->wall[w].twist, at), place.velocity);
    return place;
}

void walls_visit(const struct walls *walls, const struct particles *particles, int thread, double range,
                 walls_visitor *visitor, void *context) {
    size_t first = walls->candidates * (size_t)thread / (size_t)walls->threads;
    size_t end = walls->candidates * ((size_t)thread + 1) / (size_t)walls->threads;
    struct wall_scratch *scratch = walls->scratch[thread];
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
            for (size_t c = 0; c < count; c++) {
                struct wall_place place = place_of(walls, w, &scratch->touch[c], state);
                place.particle = walls->particle[k];
                visitor(context, &place);
            }
        }
    }
}

void walls_push(struct walls *walls, int thread, int wall, const double at[3], const double force[3]) {
    struct law_vector f = wall_vector(force);
    struct law_vector torque = law_cross(law_add(wall_vector(at), -1.0, walls->wall[wall].centre_now), f);
    const double both[6] = {f.x, f.y, f.z, torque.x, torque.y, torque.z};
    for (int c = 0; c < 6; c++)
        walls->scratch[thread]->force[wall][c] += both[c];
}
