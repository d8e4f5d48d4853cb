/* SPDX-License-Identifier: BSD-3-Clause */
/* The part of nodes that grains fill. Read solid_field.h first. */
#include "physics/fluid/coupling/solid_field.h"
#include "base/memory.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

double solid_edge(double s) {
    return s <= -1 ? 1 : s >= 1 ? 0 : 0.5 * (1 - sin(0.5 * M_PI * s));
}

double solid_gain(double phi, double kappa) {
    return phi / (phi + kappa * (1 - phi));
}

double solid_kappa(double spacing, double viscosity, double dt) {
    return fmin(SOLID_DARCY * spacing * spacing / (viscosity * dt), SOLID_KAPPA_MOST);
}

void solid_mean(double radius, double spacing, double kappa, int dimension, double *volume, double *moment) {
    enum { POINTS = 64 };
    double inner = radius - SOLID_EDGE * spacing, width = 2 * SOLID_EDGE * spacing / POINTS;
    double full = dimension == 2 ? M_PI : 4.0 / 3.0 * M_PI, part = dimension == 2 ? 0.5 : 0.4;
    inner = fmax(inner, 0);
    *volume = full * pow(inner, dimension);
    *moment = part * *volume * inner * inner;
    for (int k = 0; k < POINTS; k++) {
        double r = radius - SOLID_EDGE * spacing + (k + 0.5) * width;
        if (r <= inner)
            continue;
        double g = solid_gain(solid_edge((r - radius) / (SOLID_EDGE * spacing)), kappa),
               shell = full * (pow(r + 0.5 * width, dimension) - pow(r - 0.5 * width, dimension));
        *volume += g * shell;
        *moment += g * shell * r * r * (dimension == 2 ? 1 : 2.0 / 3.0);
    }
}

void solid_pairs_take(struct solid_field *solid, const struct pair_rows *pairs, const uint8_t *kind,
                      size_t first, size_t end) {
    size_t count = 0;
    for (size_t e = pairs->start[first]; e < pairs->start[end]; e++)
        count += kind[pair_partner(pairs->partner[e])] == KIND_GRAIN;
    if (count > solid->pair_room) {
        solid->pair_room = count + count / 4;
        solid->pair = memory_resize(solid->pair, solid->pair_room, sizeof *solid->pair, "grains in a fluid");
    }
    solid->pairs = 0;
    for (size_t i = first; i < end; i++)
        for (size_t e = pairs->start[i]; e < pairs->start[i + 1]; e++)
            if (kind[pair_partner(pairs->partner[e])] == KIND_GRAIN)
                solid->pair[solid->pairs++] = (struct solid_pair){(uint32_t)(i - first), pairs->partner[e]};
}

/* The part of a pair; its share is 0 beyond the edge. */
static struct solid_part part_of(const struct solid_places *places, const struct solid_pair *pair) {
    struct solid_part part = {.row = pair->row, .grain = pair_partner(pair->partner)};
    const struct particle_state *node = &places->state[places->first + pair->row],
                                *grain = &places->state[part.grain];
    const double *shift = places->shift[pair_image(pair->partner)];
    double square = 0;
    for (int d = 0; d < places->dimension; d++) {
        part.arm[d] = node->x[d] - grain->x[d] - shift[d];
        square += part.arm[d] * part.arm[d];
    }
    double distance = sqrt(square) - places->hydraulic * grain->radius;
    if (places->bodies != NULL && rigid_bodies_member(places->bodies->particles, part.grain))
        part.grain = rigid_bodies_carrier(places->bodies, part.grain, part.arm, &distance);
    part.share = solid_edge(distance / (SOLID_EDGE * places->spacing));
    return part;
}

static void room(struct solid_field *solid, size_t most) {
    if (most <= solid->part_room && solid->start != NULL)
        return;
    solid->part_room = most;
    solid->part = memory_resize(solid->part, solid->part_room, sizeof *solid->part, "grains in a fluid");
    solid->start =
        memory_resize(solid->start, solid->part_room + 1, sizeof *solid->start, "grains in a fluid");
}

/* True if two parts are of the same image of a grain. */
static bool same(const struct solid_part *a, const struct solid_part *b, double spacing) {
    bool near = a->grain == b->grain;
    for (int d = 0; d < 3; d++)
        near = near && fabs(a->arm[d] - b->arm[d]) < 1e-3 * spacing;
    return near;
}

/* Adds a part to its row, which is the last one or a new one; another one of the same body, through another member, may be there. */
static void part_add(struct solid_field *solid, const struct solid_part *part, double spacing) {
    if (solid->parts == 0 || solid->part[solid->parts - 1].row != part->row)
        solid->start[solid->nodes++] = solid->parts;
    for (size_t k = solid->start[solid->nodes - 1]; k < solid->parts; k++)
        if (same(&solid->part[k], part, spacing)) {
            solid->part[k].share = fmax(solid->part[k].share, part->share);
            return;
        }
    solid->part[solid->parts++] = *part;
}

/* All parts with their phi, by row: those of grains, and in a row behind them those of walls. */
static void parts_take(struct solid_field *solid, const struct solid_places *places) {
    size_t wall = 0;
    for (size_t k = 0; k < solid->pairs; k++) {
        struct solid_part part = part_of(places, &solid->pair[k]);
        for (; wall < places->at_walls && places->at_wall[wall].row < part.row; wall++)
            part_add(solid, &places->at_wall[wall], places->spacing);
        if (part.share > 0)
            part_add(solid, &part, places->spacing);
    }
    for (; wall < places->at_walls; wall++)
        part_add(solid, &places->at_wall[wall], places->spacing);
}

void solid_field_make(struct solid_field *solid, const struct solid_places *places, size_t rows,
                      double *filled) {
    room(solid, solid->pairs + places->at_walls);
    memset(filled, 0, rows * sizeof *filled);
    solid->parts = solid->nodes = 0;
    parts_take(solid, places);
    for (size_t k = 0; k < solid->parts; k++)
        filled[solid->part[k].row] += solid->part[k].share;
    solid->start[solid->nodes] = solid->parts;
    for (size_t k = 0; k < solid->parts; k++) {
        struct solid_part *part = &solid->part[k];
        double all = filled[part->row];
        part->share *= solid_gain(fmin(all, 1), places->kappa) / all;
    }
    for (size_t row = 0; row < rows; row++)
        filled[row] = fmin(filled[row], 1);
}

void solid_field_free(struct solid_field *solid) {
    memory_free(solid->pair);
    memory_free(solid->part);
    memory_free(solid->start);
    *solid = (struct solid_field){0};
}
