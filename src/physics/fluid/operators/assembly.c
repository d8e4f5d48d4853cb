/* SPDX-License-Identifier: BSD-3-Clause */
/* Patterns and values of the fluid's matrices. Read assembly.h first. */
#include "physics/fluid/operators/assembly.h"
#include "base/memory.h"
#include "base/timer.h"

#include <omp.h>
#include <string.h>

/* A fluid neighbour in the order of columns. */
struct link {
    int64_t column;
    size_t entry; /* of the weights; SIZE_MAX: the row's own */
};

static size_t fluid_entries(const struct weights *weights, size_t row) {
    return weights_walls(weights, row) - weights->start[row];
}

/* Sorts the columns of a row into `link`, and returns how many links there are: neighbours and one. */
static size_t sort_links(const struct flow *flow, size_t row, struct link *link) {
    const struct weights *weights = flow->weights;
    size_t count = 0;
    for (size_t e = weights->start[row]; e <= weights_walls(weights, row); e++) {
        bool own = e == weights_walls(weights, row);
        size_t particle = own ? weights->first + row : pair_partner(weights->partner[e]), at = count++;
        int64_t column = flow->row[particle];
        for (; at > 0 && link[at - 1].column > column; at--)
            link[at] = link[at - 1];
        link[at] = (struct link){column, own ? SIZE_MAX : e};
    }
    return count;
}

static size_t longest_row(const struct weights *weights) {
    size_t longest = 0;
    for (size_t row = 0; row < weights->rows; row++)
        longest = fluid_entries(weights, row) > longest ? fluid_entries(weights, row) : longest;
    return longest;
}

/* The places of the images of a row's wall entries, which are neighbours of the row or its own particle. */
static void place_images(struct assembly *assembly, const struct flow *flow, size_t row) {
    const struct weights *weights = flow->weights;
    size_t e = weights_walls(weights, row);
    for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
        const struct weights_image *image = weights_image_of(weights, k);
        int32_t at = assembly->start[row];
        while (image != NULL && assembly->column[at] != flow->row[image->particle])
            at++;
        assembly->place[e] = at;
    }
}

/* Goes through the rows: counts their columns into start[row + 1], or fills. */
static void scan_rows(struct assembly *assembly, const struct flow *flow, size_t longest, bool fill) {
    const struct weights *weights = flow->weights;
#pragma omp parallel
    {
        struct link *link = memory_allocate(longest + 1, sizeof *link, "columns of a row");
#pragma omp for schedule(static)
        for (size_t row = 0; row < weights->rows; row++) {
            size_t count = sort_links(flow, row, link);
            int32_t at = fill ? assembly->start[row] : 0;
            for (size_t k = 0; k < count; k++) {
                at += k > 0 && link[k].column != link[k - 1].column;
                if (!fill)
                    continue;
                assembly->column[at] = (int32_t)link[k].column;
                if (link[k].entry == SIZE_MAX)
                    assembly->diagonal[row] = at;
                else
                    assembly->place[link[k].entry] = at;
            }
            if (!fill)
                assembly->start[row + 1] = at + 1;
            else if (weights->opens > 0)
                place_images(assembly, flow, row);
        }
        memory_free(link);
    }
}

/* The stage of the report that gets the time of this file. */
static const char stage[] = "assembly";

static bool make(struct assembly *assembly, const struct flow *flow, struct error *error) {
    const struct weights *weights = flow->weights;
    int64_t rows = (int64_t)weights->rows, entries = (int64_t)(weights->start[weights->rows] + weights->rows);
    comm_sum_int(flow->comm, &rows, 1);
    comm_max_int(flow->comm, &entries, 1);
    if (rows >= INT32_MAX || entries >= INT32_MAX)
        return error_set(
            error, ERROR_USER,
            "%lld fluid particles with %lld entries of a matrix on one rank are more than PETSc's "
            "integers of 32 bits can count: take more ranks, or a coarser spacing",
            (long long)rows, (long long)entries);
    size_t n = weights->rows, longest = longest_row(weights);
    assembly->rows = (int32_t)n;
    assembly->start = memory_resize(assembly->start, n + 1, sizeof *assembly->start, "matrix");
    assembly->diagonal = memory_resize(assembly->diagonal, n, sizeof *assembly->diagonal, "matrix");
    assembly->place = memory_resize(assembly->place, weights->start[n], sizeof *assembly->place, "matrix");
    assembly->start[0] = 0;
    scan_rows(assembly, flow, longest, false);
    for (size_t row = 0; row < n; row++)
        assembly->start[row + 1] += assembly->start[row];
    size_t used = (size_t)assembly->start[n];
    assembly->column = memory_resize(assembly->column, used, sizeof *assembly->column, "matrix");
    assembly->value = memory_resize(assembly->value, used, sizeof *assembly->value, "matrix");
    scan_rows(assembly, flow, longest, true);
    return true;
}

bool assembly_make(struct assembly *assembly, const struct flow *flow, struct error *error) {
    timer_enter(assembly->timers = flow->timers, stage);
    bool good = make(assembly, flow, error);
    timer_leave(flow->timers, stage);
    return good;
}

void assembly_free(struct assembly *assembly) {
    memory_free(assembly->start);
    memory_free(assembly->column);
    memory_free(assembly->place);
    memory_free(assembly->diagonal);
    memory_free(assembly->value);
    *assembly = (struct assembly){0};
}

struct solve_rows assembly_rows(const struct assembly *assembly) {
    return (struct solve_rows){assembly->rows, assembly->start, assembly->column, assembly->value};
}

double assembly_wall_factor(const struct weights *weights, size_t wall, int component) {
    double straight = 1 + weights->mirror[wall];
    if (weights_image_of(weights, wall) != NULL)
        return 1;
    if (weights->opens > 0 && weights_foot_of(weights, wall)->pressed)
        return 0;
    if (!(weights->slip > 0))
        return straight;
    double n = weights->foot[weights->wall_foot[wall]].normal[component],
           along = weights_tangential_factor(weights, wall);
    return along + (straight - along) * n * n;
}

/* What a gradient of the pressure multiplies: a factor of each entry, or one of each particle, and C of gradient_correction.h, or 1. */
struct share {
    struct operators_values k; /* without values: 1 */
    const double *entry;       /* NULL: 1 */
    bool whole;
};

/* The mean share of the particles i and j of an entry, along the line between them. */
static double share_of(const struct share *share, const struct weights *weights, size_t i, size_t j,
                       size_t entry) {
    const double *k = share->k.value;
    if (share->entry != NULL)
        return share->entry[entry];
    double own = k != NULL ? k[i * share->k.stride] : 1, other = k != NULL ? k[j * share->k.stride] : 1;
    if (share->whole) {
        own *= weights_whole_along(weights, i, entry);
        other *= weights_whole_along(weights, j, entry);
    }
    return 0.5 * (own + other);
}

/* Adds -factor share w_ij (f_j - f_i) over the fluid neighbours of a row to the cleared values. */
static void add_neighbours(struct assembly *assembly, const struct weights *weights, size_t row,
                           double factor, const struct share *share) {
    double *value = assembly->value, sum = 0;
    memset(value + assembly->start[row], 0,
           (size_t)(assembly->start[row + 1] - assembly->start[row]) * sizeof *value);
    for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
        double part = share_of(share, weights, weights->first + row, pair_partner(weights->partner[e]), e);
        double term = factor * part * weights_scalar(weights, e);
        value[assembly->place[e]] -= term;
        sum += term;
    }
    value[assembly->diagonal[row]] += sum;
}

/* Adds the share of the image of a wall entry: -factor w_ij f_m where the value goes on (`even`), else the opposite. */
static void add_image(struct assembly *assembly, const struct weights *weights, size_t wall, size_t entry,
                      double factor, bool even) {
    if (weights_image_of(weights, wall) != NULL)
        assembly->value[assembly->place[entry]] += (even ? -factor : factor) * weights_scalar(weights, entry);
}

void assembly_momentum(struct assembly *assembly, const struct weights *weights, double inertia,
                       double viscous, int component) {
    timer_enter(assembly->timers, stage);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double sum = 0;
        size_t e = weights_walls(weights, row);
        add_neighbours(assembly, weights, row, viscous, &(struct share){0});
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            sum += weights_scalar(weights, e) * assembly_wall_factor(weights, k, component);
            add_image(assembly, weights, k, e, viscous, weights_foot_of(weights, k)->pressed);
        }
        assembly->value[assembly->diagonal[row]] += inertia + viscous * sum;
    }
    timer_leave(assembly->timers, stage);
}

/* value = - div share grad, without flux through walls. */
static void fill_pressure(struct assembly *assembly, const struct weights *weights,
                          const struct share *share) {
    timer_enter(assembly->timers, stage);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t e = weights_walls(weights, row), i = weights->first + row;
        add_neighbours(assembly, weights, row, 1, share);
        for (size_t wall = weights->wall_start[row];
             weights->opens > 0 && wall < weights->wall_start[row + 1]; wall++, e++) {
            bool pressed = weights_foot_of(weights, wall)->pressed;
            const struct weights_image *image = weights_image_of(weights, wall);
            double part = image     ? 1
                          : pressed ? 1 + weights->mirror[wall]
                                    : 0,
                   own = share_of(share, weights, i, image ? image->particle : i, e);
            add_image(assembly, weights, wall, e, own, !pressed);
            assembly->value[assembly->diagonal[row]] += own * weights_scalar(weights, e) * part;
        }
    }
    timer_leave(assembly->timers, stage);
}

void assembly_pressure(struct assembly *assembly, const struct weights *weights, bool whole,
                       const double *mobility) {
    fill_pressure(
        assembly, weights,
        &(struct share){.k = {.value = mobility, .stride = 1}, .whole = whole && weights->whole != NULL});
}

void assembly_darcy(struct assembly *assembly, const struct weights *weights, struct operators_values k) {
    fill_pressure(assembly, weights, &(struct share){.k = k});
}

void assembly_shared(struct assembly *assembly, const struct weights *weights, const double *share) {
    fill_pressure(assembly, weights, &(struct share){.entry = share});
}
