/* SPDX-License-Identifier: BSD-3-Clause */
/* Conditions at the open sides of the box. Read open_sides.h first. */
#include "physics/fluid/schemes/open_sides.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

const struct fluid_open *open_at(const struct fluid_options *options, int side) {
    for (int k = 0; k < options->opens; k++)
        if (options->open[k].side == side)
            return &options->open[k];
    return NULL;
}

static bool gives_velocity(const struct fluid_open *open) {
    return !isnan(open->velocity[0]);
}

bool open_pressed(const struct fluid_options *options) {
    bool pressed = false;
    for (int k = 0; k < options->opens; k++)
        pressed = pressed || !gives_velocity(&options->open[k]);
    return pressed;
}

double open_speed(const struct fluid_options *options) {
    double square = 0;
    for (int k = 0; k < options->opens; k++) {
        const double *v = options->open[k].velocity;
        square = gives_velocity(&options->open[k]) ? fmax(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
                                                   : square;
    }
    return sqrt(square);
}

void open_velocity(const struct fluid_open *open, const struct box *box, const double x[3],
                   double velocity[3]) {
    double share = 1;
    for (int d = 0; d < box->dimension; d++) {
        double part = x[d] / box->edge[d];
        if (open->profile == FLUID_PARABOLIC && d != open->side / 2 && !box->periodic[d])
            share *= fmax(4 * part * (1 - part), 0);
    }
    for (int d = 0; d < 3; d++)
        velocity[d] = share * open->velocity[d];
}

void open_foot(const struct fluid_options *options, const struct box *box, int side, const double x[3],
               struct weights_foot *foot) {
    const struct fluid_open *open = open_at(options, side);
    int d = side / 2;
    bool upper = side % 2 == 1;
    *foot = (struct weights_foot){.distance = upper ? box->edge[d] - x[d] : x[d]};
    foot->normal[d] = upper ? -1 : 1;
    foot->open = true;
    foot->pressed = !gives_velocity(open);
    if (foot->pressed)
        foot->pressure = open->pressure;
    else
        open_velocity(open, box, x, foot->velocity);
}

const char *open_name(int side) {
    static const char *const names[] = {"x_lower", "x_upper", "y_lower", "y_upper", "z_lower", "z_upper"};
    return names[side];
}

/* One side by itself. */
static bool side_suits(const struct physics_context *context, int k, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct fluid_open *open = &options->open[k];
    const struct box *box = context->box;
    int d = open->side / 2;
    char key[64];
    snprintf(key, sizeof key, "fluid.open[%d].side", k);
    if (open_at(options, open->side) != open)
        return scene_fail(context->scene, error, key, "%s is there twice", open_name(open->side));
    if (d >= box->dimension || box->periodic[d])
        return scene_fail(context->scene, error, key, "%s is no side: the box %s", open_name(open->side),
                          d >= box->dimension ? "has two dimensions" : "is periodic there");
    snprintf(key, sizeof key, "fluid.open[%d]", k);
    if (gives_velocity(open) == !isnan(open->pressure))
        return scene_fail(context->scene, error, key, "%s: needed is one of velocity and pressure, %s",
                          open_name(open->side), isnan(open->pressure) ? "not none" : "not both");
    snprintf(key, sizeof key, "fluid.open[%d].profile", k);
    return gives_velocity(open) || open->profile == FLUID_PLUG ||
           scene_fail(context->scene, error, key, "parabolic is of a velocity; %s has a pressure",
                      open_name(open->side));
}

bool open_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (options->opens > 0 && fluid_motion_moves(options))
        return scene_fail(context->scene, error, "fluid.open",
                          "open sides go with fluid.motion: fixed alone, as no particles come in or go out");
    for (int k = 0; k < options->opens; k++)
        if (!side_suits(context, k, error))
            return false;
    return true;
}
