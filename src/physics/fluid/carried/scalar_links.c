/* SPDX-License-Identifier: BSD-3-Clause */
/* Matrix, right-hand side and fluxes of a scalar. Read scalar_links.h first. */
#include "physics/fluid/carried/scalar_links.h"
#include <math.h>
#include <string.h>

/* c_j - c_i of a wall entry: constant + image c_m - own c_i. */
struct beyond {
    double own, image, constant;
};

static struct beyond beyond_of(const struct links *links, size_t wall) {
    const struct weights *weights = links->weights;
    uint32_t foot = weights->wall_foot[wall];
    bool image = weights_image_of(weights, wall) != NULL;
    double given = links->given[foot], straight = 1 + weights->mirror[wall];
    if (image)
        return isnan(given) ? (struct beyond){1, 1, 0} : (struct beyond){1, -1, 2 * given};
    if (!isnan(given))
        return (struct beyond){straight, 0, straight * given};
    double slope = links->slope != NULL ? links->slope[foot] : 0;
    return (struct beyond){0, 0, -straight * weights->foot[foot].distance * slope};
}

static double carry_of(const struct links *links, size_t entry) {
    return links->carry != NULL ? links->carry[entry] : 0;
}

/* The free part of an entry of a row: the mean of both ends; none where grains fill one of them whole. */
static double free_of(const struct links *links, size_t row, size_t entry) {
    const struct weights *weights = links->weights;
    if (links->filled == NULL)
        return 1;
    double own = 1 - links->filled[weights->first + row], other = own;
    if (entry < weights_walls(weights, row))
        other = 1 - links->filled[pair_partner(weights->partner[entry])];
    return own > 0 && other > 0 ? 0.5 * (own + other) : 0;
}

/* K + a of an entry: its diffusion. */
static double diffusion_of(const struct links *links, size_t row, size_t entry) {
    double k = links->diffusivity * weights_scalar(links->weights, entry) * free_of(links, row, entry);
    if (links->share != NULL)
        k *= links->share[entry];
    return links->upwind ? k + fabs(carry_of(links, entry)) : k;
}

static double link_of(const struct links *links, size_t row, size_t entry) {
    return diffusion_of(links, row, entry) - carry_of(links, entry);
}

void scalar_links_matrix(const struct links *links, double factor, const double *diagonal,
                         struct assembly *assembly) {
    const struct weights *weights = links->weights;
    double *value = assembly->value;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double sum = diagonal != NULL ? diagonal[row] : 1;
        size_t e = weights->start[row];
        memset(value + assembly->start[row], 0,
               (size_t)(assembly->start[row + 1] - assembly->start[row]) * sizeof *value);
        for (; e < weights_walls(weights, row); e++) {
            double k = factor * link_of(links, row, e);
            value[assembly->place[e]] -= k;
            sum += k;
        }
        for (size_t w = weights->wall_start[row]; w < weights->wall_start[row + 1]; w++, e++) {
            struct beyond beyond = beyond_of(links, w);
            double k = factor * link_of(links, row, e);
            sum += k * beyond.own;
            if (beyond.image != 0)
                value[assembly->place[e]] -= k * beyond.image;
        }
        value[assembly->diagonal[row]] += sum;
    }
}

void scalar_links_side(const struct links *links, double factor, double *side) {
    const struct weights *weights = links->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t e = weights_walls(weights, row);
        side[row] = 0;
        for (size_t w = weights->wall_start[row]; w < weights->wall_start[row + 1]; w++, e++)
            side[row] += factor * link_of(links, row, e) * beyond_of(links, w).constant;
    }
}

/* c_j - c_i of a wall entry. */
static double step_beyond(const struct links *links, size_t wall, const double *value, double own) {
    const struct weights_image *image = weights_image_of(links->weights, wall);
    struct beyond beyond = beyond_of(links, wall);
    return beyond.constant - beyond.own * own + (image != NULL ? beyond.image * value[image->particle] : 0);
}

void scalar_links_apply(const struct links *links, const double *value, double *out) {
    const struct weights *weights = links->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double own = value[weights->first + row], sum = 0;
        size_t e = weights->start[row];
        for (; e < weights_walls(weights, row); e++)
            sum += link_of(links, row, e) * (value[pair_partner(weights->partner[e])] - own);
        for (size_t w = weights->wall_start[row]; w < weights->wall_start[row + 1]; w++, e++)
            sum += link_of(links, row, e) * step_beyond(links, w, value, own);
        out[row] = sum;
    }
}

/* Adds what an entry carries away, F_ij times its way. */
static void add_flux(const struct links *links, size_t row, size_t entry, const double values[2],
                     const double way[3], double flux[3]) {
    double give = 2 * carry_of(links, entry) * 0.5 * (values[0] + values[1]) -
                  diffusion_of(links, row, entry) * (values[1] - values[0]);
    for (int d = 0; d < 3; d++)
        flux[d] += give * way[d];
}

void scalar_links_flux(const struct links *links, const double *value, double (*out)[3]) {
    const struct weights *weights = links->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double own = value[weights->first + row], way[3];
        size_t e = weights->start[row];
        memset(out[row], 0, sizeof out[row]);
        for (; e < weights_walls(weights, row); e++) {
            weights_apart(weights, links->input, row, e, way);
            for (int d = 0; d < 3; d++)
                way[d] *= 0.5;
            add_flux(links, row, e, (double[2]){own, value[pair_partner(weights->partner[e])]}, way,
                     out[row]);
        }
        for (size_t w = weights->wall_start[row]; w < weights->wall_start[row + 1]; w++, e++) {
            const struct weights_foot *foot = weights_foot_of(weights, w);
            for (int d = 0; d < 3; d++)
                way[d] = -foot->distance * foot->normal[d];
            add_flux(links, row, e, (double[2]){own, own + step_beyond(links, w, value, own)}, way, out[row]);
        }
    }
}
