/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of weights from rows of pairs: count, scan, fill. Read weights.h first. */
#include "physics/fluid/operators/weights.h"
#include "base/memory.h"
#include "base/scan.h"
#include "physics/fluid/lattice/pattern.h"
#include "physics/fluid/operators/mls.h"
#include "kernel/particles/kinds.h"
#include <string.h>

/* Everything that a row needs. */
struct build {
    struct weights *weights;
    const struct weights_input *input;
    const struct weights_options *options;
};

static int kind_at(const struct weights_input *input, size_t k) {
    return input->kind ? input->kind[k] : KIND_FLUID;
}

/* The place of the neighbour that an entry of the pairs stands for; false if it has no part in the row. */
static bool neighbour_of(const struct weights_input *input, const struct weights_options *options, size_t i,
                         uint32_t partner, struct correction_tensors_neighbour *to) {
    const struct particle_state *state = input->particles->state;
    const double *shift = input->shift[pair_image(partner)], *xj = state[pair_partner(partner)].x;
    double square = 0;
    for (int d = 0; d < 3; d++) {
        to->e[d] = d < input->dimension ? -((xj[d] - state[i].x[d]) + shift[d]) : 0;
        square += to->e[d] * to->e[d];
    }
    to->distance = sqrt(square);
    if ((!options->moving && !(to->distance < options->kernel.support)) || to->distance == 0)
        return false;
    for (int d = 0; d < 3; d++)
        to->e[d] /= to->distance;
    return true;
}

/* Counts the fluid and wall neighbours of a row. */
static void row_count(const struct build *build, size_t row) {
    const struct pair_rows *pairs = build->input->pairs;
    size_t i = build->weights->first + row, entries = 0, walls = 0;
    for (size_t e = pairs->start[i]; e < pairs->start[i + 1]; e++) {
        struct correction_tensors_neighbour to;
        int kind = kind_at(build->input, pair_partner(pairs->partner[e]));
        if (kind == KIND_GRAIN || !neighbour_of(build->input, build->options, i, pairs->partner[e], &to))
            continue;
        entries++;
        walls += kind == KIND_BOUNDARY;
    }
    build->weights->start[row] = entries;
    build->weights->wall_start[row] = walls;
}

/* Fills the partners of a row, fluid first. */
static void row_fill(const struct build *build, size_t row) {
    struct weights *weights = build->weights;
    const struct pair_rows *pairs = build->input->pairs;
    size_t i = weights->first + row, at[2] = {weights->start[row], weights_walls(weights, row)};
    for (size_t e = pairs->start[i]; e < pairs->start[i + 1]; e++) {
        struct correction_tensors_neighbour to;
        int kind = kind_at(build->input, pair_partner(pairs->partner[e]));
        if (kind != KIND_GRAIN && neighbour_of(build->input, build->options, i, pairs->partner[e], &to))
            weights->partner[at[kind == KIND_BOUNDARY]++] = pairs->partner[e];
    }
}

/* V_i = 1 / sum of W over all neighbours and i itself. */
static void row_volume(const struct build *build, size_t row) {
    struct weights *weights = build->weights;
    double sum = kernel_value(&build->options->kernel, 0);
    for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
        struct correction_tensors_neighbour to;
        neighbour_of(build->input, build->options, weights->first + row, weights->partner[e], &to);
        sum += kernel_value(&build->options->kernel, to.distance);
    }
    weights->volume[row] = build->options->volume > 0 ? build->options->volume : 1 / sum;
}

/* The volume of a neighbour. */
static double volume_of(const struct weights *weights, const struct weights_input *input,
                        const struct weights_options *options, size_t particle) {
    if (options->volume > 0)
        return options->volume;
    if (input->volume)
        return input->volume[particle];
    if (particle >= input->first && particle < input->end)
        return weights->volume[particle - input->first];
    return kernel_power(options->spacing, input->dimension);
}

void weights_neighbour(const struct weights *weights, const struct weights_input *input,
                       const struct weights_options *options, size_t entry, size_t row,
                       struct correction_tensors_neighbour *to) {
    uint32_t partner = weights->partner[entry];
    neighbour_of(input, options, weights->first + row, partner, to);
    kernel_both(&options->kernel, to->distance, &to->value, &to->strength);
    to->strength *= volume_of(weights, input, options, pair_partner(partner));
}

/* Replaces the weights of a row by those of moving least squares, of the highest order that its neighbours allow. True
 * if that is the order asked for. */
static bool row_fit(const struct build *build, size_t row,
                    const struct correction_tensors_neighbour *neighbour, size_t count) {
    struct weights *weights = build->weights;
    int wanted = build->options->order, least = wanted < 2 ? wanted : 2;
    size_t first = weights->start[row];
    struct mls_options options = {wanted, weights->dimension, build->options->kernel.support,
                                  kernel_value(&build->options->kernel, 0)};
    for (; options.order >= least; options.order--)
        if (mls_weigh(&options, neighbour, count, weights->vectors + first * (size_t)weights->dimension,
                      weights->scalars + first))
            break;
    return options.order == wanted;
}

/* Computes the weights of a row; returns true if it does not have the operators asked for. */
static bool row_weigh(const struct build *build, size_t row, struct correction_tensors_neighbour *neighbour) {
    struct weights *weights = build->weights;
    size_t first = weights->start[row], count = weights->start[row + 1] - first;
    int dimension = build->input->dimension;
    struct tensors tensors;
    bool good = true;
    for (size_t e = 0; e < count; e++)
        weights_neighbour(weights, build->input, build->options, first + e, row, &neighbour[e]);
    if (build->options->operators == WEIGHTS_STANDARD)
        correction_tensors_standard(&tensors, dimension);
    else
        good = correction_tensors_make(&tensors, neighbour, count, dimension);
    weights->condition[row] = tensors.condition;
    for (size_t e = 0; e < count; e++)
        weights->scalars[first + e] = correction_tensors_weigh(
            &tensors, &neighbour[e], dimension, weights->vectors + (first + e) * (size_t)dimension);
    if (build->options->operators == WEIGHTS_MLS)
        good = row_fit(build, row, neighbour, count) && (good || build->options->order > 1);
    return !good;
}

static void reserve_rows(struct weights *weights) {
    if (weights->rows + 1 <= weights->row_room)
        return;
    size_t room = weights->row_room = weights->rows + weights->rows / 8 + 1;
    weights->start = memory_resize(weights->start, room, sizeof *weights->start, "weights");
    weights->wall_start = memory_resize(weights->wall_start, room, sizeof *weights->wall_start, "weights");
    weights->foot_start = memory_resize(weights->foot_start, room, sizeof *weights->foot_start, "weights");
    weights->volume = memory_resize(weights->volume, room, sizeof *weights->volume, "weights");
    weights->condition = memory_resize(weights->condition, room, sizeof *weights->condition, "weights");
}

static void reserve_entries(struct weights *weights) {
    size_t entries = weights->start[weights->rows], walls = weights->wall_start[weights->rows];
    if (entries > weights->entry_room) {
        size_t room = weights->entry_room = entries;
        weights->partner = memory_resize(weights->partner, room, sizeof *weights->partner, "weights");
    }
    if (walls > weights->wall_room) {
        weights->wall_room = walls;
        weights->mirror = memory_resize(weights->mirror, walls, sizeof *weights->mirror, "weights");
        weights->wall_foot = memory_resize(weights->wall_foot, walls, sizeof *weights->wall_foot, "weights");
    }
}

static void reserve_values(struct weights *weights, size_t room) {
    if (room <= weights->value_room)
        return;
    weights->value_room = room;
    weights->scalars = memory_resize(weights->scalars, room, sizeof *weights->scalars, "weights");
    weights->vectors = memory_resize(weights->vectors, room * (size_t)weights->dimension,
                                     sizeof *weights->vectors, "weights");
}

static size_t longest_row(const struct weights *weights) {
    size_t longest = 0;
#pragma omp parallel for schedule(static) reduction(max : longest)
    for (size_t row = 0; row < weights->rows; row++)
        longest = weights->start[row + 1] - weights->start[row] > longest
                      ? weights->start[row + 1] - weights->start[row]
                      : longest;
    return longest;
}

/* The codes of all entries; false if a row has other neighbours than the lattice. */
static bool rows_encode(const struct build *build, const struct pattern *pattern) {
    struct weights *weights = build->weights;
    bool good = true;
#pragma omp parallel reduction(&& : good)
    {
        struct correction_tensors_neighbour *neighbour =
            memory_allocate(pattern->count + 1, sizeof *neighbour, "weights of a row");
#pragma omp for schedule(static)
        for (size_t row = 0; row < weights->rows; row++) {
            size_t first = weights->start[row], count = weights->start[row + 1] - first;
            for (size_t e = 0; good && count == pattern->count && e < count; e++)
                neighbour_of(build->input, build->options, weights->first + row, weights->partner[first + e],
                             &neighbour[e]);
            good = good && pattern_find(pattern, neighbour, count, weights->code + first);
        }
        memory_free(neighbour);
    }
    return good;
}

/* Weighs the first row alone, for all, if the particles lie on a lattice on which rows are alike; else false, and nothing
 * is done. */
static bool lattice_weigh(const struct build *build) {
    struct weights *weights = build->weights;
    size_t count = weights->rows > 0 ? weights->start[1] : 0;
    memory_free(weights->code);
    weights->code = NULL;
    if (count == 0 || count > PATTERN_NEIGHBOURS_MAX || !(build->options->volume > 0) ||
        build->options->moving)
        return false;
    struct correction_tensors_neighbour neighbour[PATTERN_NEIGHBOURS_MAX];
    struct pattern *pattern = memory_allocate(1, sizeof *pattern, "lattice of the weights");
    for (size_t e = 0; e < count; e++)
        neighbour_of(build->input, build->options, weights->first, weights->partner[e], &neighbour[e]);
    weights->code = memory_allocate(weights->start[weights->rows], sizeof *weights->code, "weights");
    if (!pattern_make(pattern, neighbour, count, build->options->kernel.support) ||
        !rows_encode(build, pattern)) {
        memory_free(weights->code);
        weights->code = NULL;
    }
    memory_free(pattern);
    if (weights->code == NULL)
        return false;
    reserve_values(weights, count);
    bool poor = row_weigh(build, 0, neighbour);
    for (size_t row = 1; row < weights->rows; row++)
        weights->condition[row] = weights->condition[0];
    weights->poor = poor ? weights->rows : 0;
    weights->poor_first = poor ? 0 : SIZE_MAX;
    return true;
}

void weights_weigh(struct weights *weights, const struct weights_input *input,
                   const struct weights_options *options) {
    const struct build build = {weights, input, options};
    size_t poor = 0, poor_first = SIZE_MAX, longest = longest_row(weights);
    if (lattice_weigh(&build))
        return;
    reserve_values(weights, weights->start[weights->rows]);
#pragma omp parallel reduction(+ : poor) reduction(min : poor_first)
    {
        struct correction_tensors_neighbour *neighbour =
            memory_allocate(longest + 1, sizeof *neighbour, "weights of a row");
#pragma omp for schedule(static)
        for (size_t row = 0; row < weights->rows; row++)
            if (row_weigh(&build, row, neighbour)) {
                poor++;
                poor_first = row < poor_first ? row : poor_first;
            }
        memory_free(neighbour);
    }
    weights->poor = poor;
    weights->poor_first = poor_first;
}

void weights_rows(struct weights *weights, const struct weights_input *input,
                  const struct weights_options *options) {
    const struct build build = {weights, input, options};
    weights->dimension = input->dimension;
    weights->first = input->first;
    weights->rows = input->end - input->first;
    weights->slip = options->slip;
    weights->behind = 0;
    reserve_rows(weights);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        row_count(&build, row);
    scan_sizes(weights->start, weights->rows, weights->start);
    scan_sizes(weights->wall_start, weights->rows, weights->wall_start);
    reserve_entries(weights);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        row_fill(&build, row);
        row_volume(&build, row);
    }
    memset(weights->foot_start, 0, (weights->rows + 1) * sizeof *weights->foot_start);
}

void weights_make(struct weights *weights, const struct weights_input *input,
                  const struct weights_options *options) {
    weights_rows(weights, input, options);
    weights_weigh(weights, input, options);
}

void weights_apart(const struct weights *weights, const struct weights_input *input, size_t row, size_t entry,
                   double apart[3]) {
    uint32_t partner = weights->partner[entry];
    const struct particle_state *state = input->particles->state;
    for (int d = 0; d < 3; d++)
        apart[d] = state[pair_partner(partner)].x[d] - state[weights->first + row].x[d] +
                   input->shift[pair_image(partner)][d];
}

void weights_free(struct weights *weights) {
    memory_free(weights->start);
    memory_free(weights->wall_start);
    memory_free(weights->partner);
    memory_free(weights->scalars);
    memory_free(weights->vectors);
    memory_free(weights->code);
    memory_free(weights->mirror);
    memory_free(weights->turn);
    memory_free(weights->wall_foot);
    memory_free(weights->image);
    memory_free(weights->foot);
    memory_free(weights->foot_start);
    memory_free(weights->volume);
    memory_free(weights->condition);
    *weights = (struct weights){0};
}

size_t weights_memory(const struct weights *weights) {
    size_t entry = sizeof *weights->partner + (weights->code ? sizeof *weights->code : 0),
           value = sizeof *weights->scalars + (size_t)weights->dimension * sizeof *weights->vectors;
    return weights->row_room * (3 * sizeof(size_t) + 2 * sizeof(double)) + weights->entry_room * entry +
           weights->value_room * value +
           weights->wall_room * (sizeof *weights->mirror + sizeof *weights->wall_foot +
                                 (weights->turn ? sizeof *weights->turn : 0)) +
           weights->foot_room * sizeof *weights->foot;
}
