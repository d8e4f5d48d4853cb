/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls for each particle that touches a wall, or is near one, without the forces of a law. Read wall.h first. */
#include "physics/grains/walls/walls_history.h"
#include "physics/grains/walls/walls_parts.h"

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
    struct law_vector velocity = wall_twist_at(&walls->wall[w].twist, at);
    if (walls->wall[w].slides)
        velocity = law_add(velocity, 1.0, walls_slip(&walls->wall[w], at, touch->normal));
    store(velocity, place.velocity);
    return place;
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
        for (size_t piece = walls->first[k], next; piece < walls->first[k + 1]; piece = next) {
            int w = walls->piece[piece].wall;
            size_t count =
                walls_find(walls, k, piece, &next, wall_vector(state->x), state->radius + range, scratch);
            for (size_t c = 0; c < count; c++) {
                struct wall_place place = place_of(walls, w, &scratch->touch[c], state);
                place.particle = walls->particle[k];
                if (scratch->from[c] >= 0)
                    place.record = old->value + (walls->first[k] + (size_t)scratch->from[c]) * components;
                visitor(context, &place);
            }
        }
    }
}

void walls_push(struct walls *walls, int thread, const struct wall_place *place, const double force[3],
                double impedance) {
    const struct wall *wall = &walls->wall[place->wall];
    struct law_vector f = wall_vector(force), at = wall_vector(place->at);
    struct law_vector torque = law_cross(law_add(at, -1.0, wall->centre_now), f);
    torque = law_add(torque, 1.0, wall_vector(place->torque));
    double power = wall->slides ? -law_dot(f, walls_slip(wall, at, wall_vector(place->normal))) : 0.0;
    const double load[WALL_LOADS] = {f.x, f.y, f.z, torque.x, torque.y, torque.z, power};
    struct wall_scratch *scratch = walls->scratch[thread];
    for (int c = 0; c < WALL_LOADS; c++) {
        if (scratch->exact)
            exact_add(&scratch->exact[place->wall][c], load[c]);
        else
            scratch->load[place->wall][c] += load[c];
    }
    walls_impede(walls, scratch, place->wall, impedance);
}

bool walls_plane(const struct walls *walls, int wall, double point[3], double normal[3]) {
    const struct wall *w = &walls->wall[wall];
    if (w->options.shape != WALL_PLANE)
        return false;
    store(w->point_now, point);
    store(w->axis_now, normal);
    return true;
}

void walls_surface_motion(const struct walls *walls, int wall, const double at[3], const double normal[3],
                          double velocity[3], double spin[3]) {
    const struct wall *w = &walls->wall[wall];
    struct law_vector v = wall_twist_at(&w->twist, wall_vector(at)), omega = w->twist.omega;
    if (w->slides) {
        v = law_add(v, 1.0, walls_slip(w, wall_vector(at), wall_vector(normal)));
        omega = law_add(omega, 1.0, w->surface.omega);
    }
    store(v, velocity);
    store(omega, spin);
}
