/* SPDX-License-Identifier: BSD-3-Clause */
/* The end of an evaluation: sums of threads become the forces on walls, and the work of the walls. Read wall.h
 * first. */
#include "physics/grains/walls/walls_parts.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

/* Work on the particles in this step, with the mean of the forces before and after it. */
static double wall_work(const struct wall *wall, const double before[6], const double now[6], double dt) {
    struct law_vector velocity = wall_twist_at(&wall->twist, wall->centre_now);
    struct law_vector force = law_add(wall_vector(before), 1.0, wall_vector(now));
    struct law_vector torque = law_add(wall_vector(before + 3), 1.0, wall_vector(now + 3));
    return -0.5 * dt * (law_dot(force, velocity) + law_dot(torque, wall->twist.omega));
}

/* Stores force and power of a wall, and adds its work. */
static void set_load(struct walls *walls, int w, const double load[WALL_LOADS], double dt) {
    if (walls->wall[w].moving && walls->wall[w].free == NULL)
        walls->work += wall_work(&walls->wall[w], walls->force[w], load, dt);
    if (walls->wall[w].slides)
        walls->work += 0.5 * dt * (walls->power[w] + load[WALL_POWER]);
    memcpy(walls->force[w], load, sizeof walls->force[w]);
    walls->power[w] = load[WALL_POWER];
}

static void join_threads(struct walls *walls) {
    size_t bytes = (size_t)walls->count * sizeof *walls->exact;
    memset(walls->exact, 0, bytes);
    for (int t = 0; t < walls->threads; t++) {
        for (int w = 0; w < walls->count; w++)
            for (int c = 0; c < WALL_LOADS; c++)
                exact_join(&walls->exact[w][c], &walls->scratch[t]->exact[w][c]);
        memset(walls->scratch[t]->exact, 0, bytes);
    }
}

void walls_set_exact(struct walls *walls) {
    size_t count = (size_t)walls->count;
    walls->exact = memory_allocate_zero(count, sizeof *walls->exact, "forces on walls");
    for (int t = 0; t < walls->threads; t++)
        walls->scratch[t]->exact =
            memory_allocate_zero(count, sizeof *walls->scratch[t]->exact, "forces on walls");
}

int64_t *walls_exact(struct walls *walls, int *count) {
    *count = WALL_LOADS * walls->count * (int)EXACT_WORDS;
    return walls->exact[0][0].word;
}

void walls_close(struct walls *walls, double dt, bool mine) {
    for (int w = 0; w < walls->count; w++) {
        double load[WALL_LOADS] = {0};
        for (int c = 0; mine && c < WALL_LOADS; c++)
            load[c] = exact_value(&walls->exact[w][c]);
        set_load(walls, w, load, dt);
    }
}

void walls_impede(const struct walls *walls, struct wall_scratch *scratch, int wall, double impedance) {
    static const double most = 0x1p32;
    const double unit = walls->wall[wall].unit;
    if (unit > 0.0)
        scratch->impedance[wall] += unit * fmin(rint(impedance / unit), most);
}

void walls_finish(struct walls *walls, const struct force_context *context, struct force_sums *sums) {
    if (walls->exact)
        join_threads(walls);
    for (int w = 0; walls->exact == NULL && w < walls->count; w++) {
        double load[WALL_LOADS] = {0};
        for (int t = 0; t < walls->threads; t++)
            for (int c = 0; c < WALL_LOADS; c++)
                load[c] += walls->scratch[t]->load[w][c];
        set_load(walls, w, load, context->dt);
    }
    memset(walls->impedance, 0, (size_t)walls->count * sizeof *walls->impedance);
    for (int t = 0; t < walls->threads; t++) {
        for (int w = 0; w < walls->count; w++)
            walls->impedance[w] += walls->scratch[t]->impedance[w];
        memset(walls->scratch[t]->impedance, 0, (size_t)walls->count * sizeof *walls->impedance);
        force_sums_add(sums, &walls->scratch[t]->sums);
        walls->scratch[t]->sums = (struct force_sums){0};
        memset(walls->scratch[t]->load, 0, (size_t)walls->count * sizeof *walls->scratch[t]->load);
    }
    walls->now = 1 - walls->now;
}

void walls_forces(const struct walls *walls, double (*force_torque)[6]) {
    memcpy(force_torque, walls->force, (size_t)walls->count * sizeof *walls->force);
}

void walls_set_forces(struct walls *walls, double (*force_torque)[6]) {
    memcpy(walls->force, force_torque, (size_t)walls->count * sizeof *walls->force);
}

double *walls_surface_power(struct walls *walls, int wall) {
    return walls->wall[wall].slides ? &walls->power[wall] : NULL;
}

double walls_work(const struct walls *walls) {
    return walls->work;
}

void walls_set_work(struct walls *walls, double work) {
    walls->work = work;
}
