/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat between grains and walls, whose temperature may follow a table over time. Read heat.h first. */
#include "kernel/particles/material.h"
#include "physics/grains/grains.h"
#include "physics/heat/heat_own.h"
#include "physics/heat/heat_state.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Reads the temperature of a wall over time. */
static bool course_read(struct numbers *course, const char *path, struct error *error) {
    bool good = numbers_read(course, path, 2, error) && numbers_check_times(course, path, "t T", error);
    for (size_t row = 0; good && row < course->rows; row++)
        good = course->value[2 * row + 1] >= 0 ||
               error_set(error, ERROR_USER, "%s:%u: the temperature %g is below 0 K", path, course->line[row],
                         course->value[2 * row + 1]);
    return good;
}

bool heat_walls_suit(const struct physics_context *context, int k, struct error *error) {
    const struct heat_options *o = context->options;
    const struct heat_wall *wall = &o->wall[k];
    char key[64];
    snprintf(key, sizeof key, "heat.walls[%d]", k);
    if (!isnan(wall->temperature) + !isnan(wall->flux) + (wall->table[0] != '\0') != 1)
        return scene_fail(context->scene, error, key, "needs one of temperature, flux and table");
    for (int before = 0; before < k; before++)
        if (o->wall[before].wall == wall->wall)
            return scene_fail(context->scene, error, key, "a second entry for wall '%s'",
                              context->scene->wall[wall->wall].name);
    struct numbers course = {0};
    bool good = wall->table[0] == '\0' || course_read(&course, wall->table, error);
    numbers_free(&course);
    return good;
}

void heat_walls_read(struct heat *heat) {
    const struct heat_options *o = heat->options;
    for (int k = 0; k < o->walls; k++) {
        struct error none = {0};
        heat->wall[o->wall[k].wall] = &o->wall[k];
        if (o->wall[k].table[0] && !course_read(&heat->course[o->wall[k].wall], o->wall[k].table, &none))
            error_fatal("%s", none.text); /* a file that has changed since the check */
    }
    for (int w = 0; w < heat->context->scene->walls; w++)
        heat->wall_material[w] = heat->context->scene->wall[w].material;
}

void heat_walls_free(struct heat *heat) {
    for (int w = 0; w < heat->context->scene->walls; w++)
        numbers_free(&heat->course[w]);
}

bool heat_walls_needed(const struct physics_context *context) {
    return grains_walls(context) && ((const struct heat_options *)context->options)->walls > 0;
}

/* A thread on its way through the grains near walls. */
struct at_walls {
    struct heat *heat;
    double *power;       /* by wall */
    double *temperature; /* by wall, now; NAN: a flux */
};

/* The temperature of a wall at the time of the step in progress. */
static double temperature_now(const struct heat *heat, int wall) {
    double value = heat->wall[wall] ? heat->wall[wall]->temperature : NAN;
    if (heat->course[wall].rows > 0)
        numbers_at(&heat->course[wall], heat->context->clock->time, &value);
    return value;
}

/* A grain that touches a wall, or is near one: called by the one thread that has the grain. */
static void at_wall(void *self, const struct wall_place *place) {
    const struct at_walls *at = self;
    size_t i = place->particle;
    int wall = place->wall;
    double gap = place->gap;
    const double *record = place->record;
    struct heat *heat = at->heat;
    const struct heat_wall *given = heat->wall[wall];
    double radius = heat->context->particles->state[i].radius, flow = 0.0;
    if (given == NULL)
        return;
    const int material[2] = {material_of(heat->material, i), heat->wall_material[wall]};
    double a = heat_contact_radius(heat, material, (double[2]){radius, INFINITY}, radius, gap, record);
    if (!isnan(at->temperature[wall])) {
        flow = heat_through_contact(heat, material, a) +
               heat_through_gas(heat, radius, a > 0.0 ? fmin(gap, 0.0) : gap);
        flow *= heat->conductance ? 1.0 : at->temperature[wall] - heat->temperature[i];
    } else if (a > 0.0 && !heat->conductance) {
        flow = given->flux * M_PI * radius * radius;
    }
    heat->flow[i] += flow;
    heat->wall_flow[i] += flow;
    at->power[wall] += flow;
}

void heat_walls_share(const struct physics_context *context, int thread) {
    struct heat *heat = context->self;
    double temperature[WALLS_MAX];
    struct at_walls at = {heat, heat->wall_power[thread], temperature};
    for (int w = 0; w < context->scene->walls; w++)
        temperature[w] = temperature_now(heat, w);
    memset(at.power, 0, sizeof heat->wall_power[thread]);
    walls_visit(grains_walls(context), context->particles, thread, fmax(heat->pairs.range, heat->reach),
                at_wall, &at);
}

double heat_wall_power(const struct heat *heat, int wall) {
    double power = 0.0;
    for (int t = 0; t < heat->context->threads; t++)
        power += heat->wall_power[t][wall];
    return power;
}
