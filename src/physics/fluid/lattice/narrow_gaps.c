/* SPDX-License-Identifier: BSD-3-Clause */
/* Narrow gaps: found, told, printed. Read narrow_gaps.h first. */
#include "physics/fluid/lattice/narrow_gaps.h"
#include "physics/grains/grains.h"
#include "physics/fluid/lattice/nodes.h"
#include <math.h>

/* Takes a gap between grain a and another grain, or a wall. */
static void take(struct gaps *gaps, double gap, int64_t a, int64_t b, bool wall) {
    if (gap >= gaps->narrowest)
        return;
    gaps->narrowest = gap;
    gaps->at_wall = wall;
    gaps->of[0] = wall || a < b ? a : b;
    gaps->of[1] = wall || a < b ? b : a;
}

static void take_pair(struct gaps *gaps, const struct nodes *nodes, size_t i, size_t j) {
    const struct nodes_grain *a = &nodes->grain[i], *b = &nodes->grain[j];
    double gap = sqrt(box_distance2(nodes->box, a->x, b->x)) - a->radius - b->radius;
    take(gaps, gap, a->id, b->id, false);
    gaps->grains += gap < GAPS_NARROW * nodes->spacing;
}

/* Goes through the grains after grain i, which are sorted along x: from i on, and across a periodic side from the last
 * one back. */
static void look_from(struct gaps *gaps, const struct nodes *nodes, size_t i, double largest) {
    const struct nodes_grain *grain = nodes->grain;
    double reach = grain[i].radius + largest + GAPS_NARROW * nodes->spacing;
    size_t j = i + 1;
    for (; j < nodes->grains && grain[j].x[0] - grain[i].x[0] <= reach; j++)
        take_pair(gaps, nodes, i, j);
    for (size_t k = nodes->grains; nodes->box->periodic[0] && k-- > j;) {
        if (grain[i].x[0] + nodes->box->edge[0] - grain[k].x[0] > reach)
            break;
        take_pair(gaps, nodes, i, k);
    }
}

/* A grain that lies wholly behind a wall has no gap to it. */
static void look_at_wall(struct gaps *gaps, const struct nodes *nodes, const struct walls *walls, int wall) {
    double narrow = GAPS_NARROW * nodes->spacing;
    for (size_t k = 0; k < nodes->grains; k++) {
        const struct nodes_grain *grain = &nodes->grain[k];
        struct wall_foot foot;
        walls_foot(walls, wall, grain->x, grain->radius + narrow, &foot);
        double gap = foot.distance - grain->radius;
        if (gap <= -2 * grain->radius)
            continue;
        take(gaps, gap, grain->id, wall, true);
        gaps->walls += gap < narrow;
    }
}

struct gaps narrow_gaps_find(const struct nodes *nodes, const struct physics_context *context) {
    struct gaps gaps = {.narrowest = INFINITY};
    double largest = 0;
    for (size_t k = 0; k < nodes->grains; k++)
        largest = fmax(largest, nodes->grain[k].radius);
    for (size_t i = 0; i < nodes->grains; i++)
        look_from(&gaps, nodes, i, largest);
    for (int wall = 0; wall < context->scene->walls; wall++)
        if (!context->scene->wall[wall].permeable)
            look_at_wall(&gaps, nodes, grains_walls(context), wall);
    return gaps;
}

/* The two bodies of the narrowest gap. */
static const char *between(const struct gaps *gaps, const struct physics_context *context, char *text,
                           size_t size) {
    if (gaps->at_wall)
        snprintf(text, size, "grain %lld and wall '%s'", (long long)gaps->of[0],
                 context->scene->wall[gaps->of[1]].name);
    else
        snprintf(text, size, "grains %lld and %lld", (long long)gaps->of[0], (long long)gaps->of[1]);
    return text;
}

/* True if gaps are too narrow, and no lubrication acts in them. */
static bool is_told(const struct gaps *gaps, const struct fluid_options *options) {
    return gaps->grains + gaps->walls > 0 && isnan(options->grains.lubrication);
}

void narrow_gaps_note(const struct gaps *gaps, const struct physics_context *context) {
    const struct fluid_options *options = context->options;
    char place[512], bodies[128];
    if (!is_told(gaps, options))
        return;
    log_tell(context->log,
             "note: %s: fluid.spacing: is too coarse for %lld gaps between grains and %lld between grains "
             "and walls, which are below %g spacings; the narrowest, between %s, is %.3g spacings",
             scene_place(context->scene, "fluid.spacing", place, sizeof place), (long long)gaps->grains,
             (long long)gaps->walls, GAPS_NARROW, between(gaps, context, bodies, sizeof bodies),
             gaps->narrowest / options->spacing);
}

void narrow_gaps_print(const struct gaps *gaps, const struct physics_context *context, FILE *file) {
    const struct fluid_options *options = context->options;
    char bodies[128];
    if (isinf(gaps->narrowest))
        return;
    fprintf(
        file,
        "  gaps         %s%lld between grains and %lld between grains and walls are below %g spacings; the "
        "narrowest, between %s, is %.3g spacings\n",
        is_told(gaps, options) ? "NOTE: " : "", (long long)gaps->grains, (long long)gaps->walls, GAPS_NARROW,
        between(gaps, context, bodies, sizeof bodies), gaps->narrowest / options->spacing);
}
