/* SPDX-License-Identifier: BSD-3-Clause */
/* Feet and mirror coefficients: count, scan, fill. Read mirror.h first. */
#include "physics/fluid/lattice/mirror.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

struct build {
    struct weights *weights;
    const struct mirror_input *input;
};

static int64_t body_at(const struct build *build, size_t entry) {
    return build->input->body[pair_partner(build->weights->partner[entry])];
}

/* The entry of the row that is the first one of the same body. */
static size_t first_of_body(const struct build *build, size_t row, size_t entry) {
    size_t first = weights_walls(build->weights, row);
    while (body_at(build, first) != body_at(build, entry))
        first++;
    return first;
}

static size_t bodies_count(const struct build *build, size_t row) {
    size_t count = 0;
    for (size_t e = weights_walls(build->weights, row); e < build->weights->start[row + 1]; e++)
        count += first_of_body(build, row, e) == e;
    return count;
}

/* x_j - x_i of an entry of pairs or weights. */
static void separation(const struct build *build, size_t i, uint32_t partner, double apart[3]) {
    const struct weights_input *rows = build->input->rows;
    const double *shift = rows->shift[pair_image(partner)];
    for (int d = 0; d < 3; d++)
        apart[d] =
            rows->particles->state[pair_partner(partner)].x[d] - rows->particles->state[i].x[d] + shift[d];
}

/* The foot on a grain: the nearest of its images. */
static bool grain_foot(const struct build *build, size_t i, int64_t body, struct weights_foot *foot) {
    const struct weights_input *rows = build->input->rows;
    foot->distance = INFINITY;
    for (size_t e = rows->pairs->start[i]; e < rows->pairs->start[i + 1]; e++) {
        size_t j = pair_partner(rows->pairs->partner[e]);
        struct weights_foot one = {0};
        double apart[3], away[3];
        if (rows->kind == NULL || rows->kind[j] != KIND_GRAIN || rows->particles->id[j] != body)
            continue;
        separation(build, i, rows->pairs->partner[e], apart);
        for (int d = 0; d < 3; d++)
            away[d] = -apart[d];
        const struct particle_state *grain = &rows->particles->state[j];
        body_sphere_foot(away, grain->radius, rows->dimension, grain->v,
                         build->input->spin ? build->input->spin[j] : NULL, &one);
        if (one.distance < foot->distance)
            *foot = one;
    }
    return isfinite(foot->distance);
}

/* The foot at the place of the neighbour itself, `apart` from i. */
static void own_foot(const double apart[3], struct weights_foot *foot) {
    foot->distance = sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
    for (int d = 0; d < 3; d++)
        foot->normal[d] = -apart[d] / foot->distance;
}

/* The foot of the row's particle on the body of an entry; counts in `behind` a particle behind it. */
static bool foot_make(const struct build *build, size_t row, size_t entry, struct weights_foot *foot,
                      size_t *behind) {
    size_t i = build->weights->first + row;
    int64_t body = body_at(build, entry);
    bool found = true;
    double apart[3];
    *foot = (struct weights_foot){0};
    separation(build, i, build->weights->partner[entry], apart);
    if (body < 0)
        build->input->wall(build->input->context, body, build->input->rows->particles->state[i].x, foot);
    else if (body == BODY_NONE || !(found = grain_foot(build, i, body, foot)))
        own_foot(apart, foot);
    foot->body = body;
    *behind += foot->distance < -MIRROR_BEHIND * build->input->spacing;
    foot->distance = fmax(foot->distance, WEIGHTS_NEAREST * build->input->spacing);
    return found;
}

/* beta of an entry: the depth of j behind the plane at i's foot, over i's distance. Where j is not behind that plane,
 * as with a wall that is bent around the fluid, the plane at j's own foot takes its place. */
static double beta_of(const struct build *build, size_t i, size_t entry, const struct weights_foot *foot) {
    double apart[3], x[3], away = 0;
    separation(build, i, build->weights->partner[entry], apart);
    double behind = body_behind(foot, apart);
    if (behind > 0 || foot->body >= 0)
        return behind / foot->distance;
    struct weights_foot own = {0};
    for (int d = 0; d < 3; d++)
        x[d] = build->input->rows->particles->state[i].x[d] + apart[d];
    build->input->wall(build->input->context, foot->body, x, &own);
    for (int d = 0; d < 3; d++)
        away -= own.normal[d] * apart[d];
    double before = away + own.distance;
    return own.distance < 0 && before > WEIGHTS_NEAREST * build->input->spacing ? -own.distance / before : 0;
}

/* True if an entry of the same body lies within the support. Particles that move keep pairs from beyond it, whose weights are 0 and
 * whose grain may be no neighbour. */
static bool body_near(const struct build *build, size_t row, size_t entry) {
    bool near = false;
    for (size_t e = entry; e < build->weights->start[row + 1]; e++) {
        double apart[3];
        separation(build, build->weights->first + row, build->weights->partner[e], apart);
        double square = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
        near = near || (body_at(build, e) == body_at(build, entry) &&
                        square < build->input->support * build->input->support);
    }
    return near;
}

/* Returns the number of bodies that were not found; adds to `behind` 1 if the particle is behind a body. */
static size_t row_fill(const struct build *build, size_t row, size_t *behind) {
    struct weights *weights = build->weights;
    size_t i = weights->first + row, at = weights->foot_start[row], lost = 0, deep = 0;
    size_t walls = weights_walls(weights, row), before = weights->wall_start[row];
    for (size_t e = walls; e < weights->start[row + 1]; e++) {
        size_t first = first_of_body(build, row, e), own = before + (e - walls);
        bool found = true;
        if (first == e) {
            weights->wall_foot[own] = (uint32_t)at;
            found = foot_make(build, row, e, &weights->foot[at++], &deep);
        } else {
            weights->wall_foot[own] = weights->wall_foot[before + (first - walls)];
        }
        weights->mirror[own] = beta_of(build, i, e, weights_foot_of(weights, own));
        lost += !found && body_near(build, row, e);
    }
    *behind += deep > 0;
    return lost;
}

/* The image of an entry at an open side: j lies behind the side as deep as m lies before it. */
static struct weights_image image_of(const struct build *build, size_t row, size_t entry,
                                     const struct weights_foot *foot) {
    const struct weights *weights = build->weights;
    const double near = 1e-3 * build->input->spacing;
    size_t i = weights->first + row;
    double apart[3], x[3], off = 0;
    struct weights_foot own = {0};
    struct weights_image image = {.particle = WEIGHTS_NO_IMAGE};
    separation(build, i, weights->partner[entry], apart);
    for (int d = 0; d < 3; d++)
        x[d] = build->input->rows->particles->state[i].x[d] + apart[d];
    build->input->wall(build->input->context, foot->body, x, &own);
    memcpy(image.velocity, own.velocity, sizeof image.velocity);
    for (int d = 0; d < 3; d++) {
        apart[d] -= 2 * own.distance * own.normal[d];
        off += apart[d] * apart[d];
    }
    if (off < near * near)
        image.particle = (uint32_t)i;
    for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
        double to[3], gap = 0;
        separation(build, i, weights->partner[e], to);
        for (int d = 0; d < 3; d++)
            gap += (to[d] - apart[d]) * (to[d] - apart[d]);
        if (gap < near * near)
            image.particle = (uint32_t)pair_partner(weights->partner[e]);
    }
    return image;
}

static void images_make(const struct build *build) {
    struct weights *weights = build->weights;
    weights->image =
        memory_resize(weights->image, weights->wall_start[weights->rows], sizeof *weights->image, "weights");
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            const struct weights_foot *foot = weights_foot_of(weights, k);
            weights->image[k] = (struct weights_image){.particle = WEIGHTS_NO_IMAGE};
            if (foot->open)
                weights->image[k] = image_of(build, row, e, foot);
        }
    }
}

static void row_turn(struct weights *weights, const struct weights_input *rows, size_t row) {
    size_t e = weights_walls(weights, row);
    for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
        const double *w = weights_foot_of(weights, k)->spin;
        double to[3], *turn = weights->turn[k];
        weights_apart(weights, rows, row, e, to);
        for (int d = 0; d < 3; d++)
            turn[d] = w[(d + 1) % 3] * to[(d + 2) % 3] - w[(d + 2) % 3] * to[(d + 1) % 3];
    }
}

void mirror_turn(struct weights *weights, const struct weights_input *rows) {
    bool some = false;
    for (size_t k = 0; k < weights->foot_start[weights->rows]; k++) {
        const double *w = weights->foot[k].spin;
        some = some || w[0] != 0 || w[1] != 0 || w[2] != 0;
    }
    if (!some) {
        memory_free(weights->turn);
        weights->turn = NULL;
        return;
    }
    weights->turn =
        memory_resize(weights->turn, weights->wall_start[weights->rows], sizeof *weights->turn, "weights");
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        row_turn(weights, rows, row);
}

size_t mirror_make(struct weights *weights, const struct mirror_input *input) {
    const struct build build = {weights, input};
    size_t sum = 0, lost = 0, behind = 0;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        weights->foot_start[row] = bodies_count(&build, row);
    for (size_t row = 0; row <= weights->rows; row++) {
        size_t count = row < weights->rows ? weights->foot_start[row] : 0;
        weights->foot_start[row] = sum;
        sum += count;
    }
    if (sum > weights->foot_room) {
        weights->foot_room = sum;
        weights->foot = memory_resize(weights->foot, sum, sizeof *weights->foot, "feet on bodies");
    }
#pragma omp parallel for schedule(static) reduction(+ : lost, behind)
    for (size_t row = 0; row < weights->rows; row++)
        lost += row_fill(&build, row, &behind);
    weights->behind = behind;
    weights->opens = 0;
    for (size_t k = 0; k < sum; k++)
        weights->opens += weights->foot[k].open;
    if (weights->opens > 0)
        images_make(&build);
    mirror_turn(weights, input->rows);
    return lost;
}
