/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps, edges and neighbourhoods of lattices. Read arrangement.h first. */
#include "physics/fluid/lattice/arrangement.h"
#include "base/memory.h"
#include "engine/physics.h"
#include <math.h>

static const double same = 1e-6; /* part of an edge by which multiples of the spacing may miss it */

/* The steps of a lattice of spacing 1, the numbers that share a node, and its dimensions (0: any). */
static const struct {
    double step[3];
    int numbers, dimension;
} rows[] = {
    [FLUID_CUBIC] = {{1, 1, 1}, 1, 0},
    [FLUID_BCC] = {{0.62996052494743658, 0.62996052494743658, 0.62996052494743658}, 4, 3}, /* 4^(-1/3) */
    [FLUID_FCC] = {{0.79370052598409974, 0.79370052598409974, 0.79370052598409974}, 2, 3}, /* 2^(-1/3) */
    /* d / 2 and d 3^(1/2) / 2 of neighbours at the distance d = (4 / 3)^(1/4) */
    [FLUID_HEXAGONAL] = {{0.53728496591177096, 0.93060485910209967, 1}, 2, 2}};

struct arrangement arrangement_make(const struct fluid_options *options, const struct box *box) {
    enum fluid_arrangement arrangement = options->fill.arrangement;
    struct arrangement lattice = {
        .arrangement = arrangement, .dimension = box->dimension, .volume = rows[arrangement].numbers};
    for (int d = 0; d < 3; d++) {
        double step = rows[arrangement].step[d] * options->spacing, steps = box->edge[d] / step;
        bool fits = arrangement != FLUID_CUBIC && d < box->dimension;
        lattice.planes[d] = fits && box->periodic[d] ? 2 * llround(0.5 * steps) : llround(steps);
        lattice.step[d] = fits ? box->edge[d] / fmax((double)lattice.planes[d], 1) : step;
        lattice.stretch = fmax(lattice.stretch, fabs(lattice.step[d] / step - 1));
    }
    for (int d = 0; d < box->dimension; d++)
        lattice.volume *= lattice.step[d];
    return lattice;
}

/* The cubic lattice is not stretched. */
static bool cubic_suits(const struct arrangement *lattice, const struct physics_context *context,
                        struct error *error) {
    const struct box *box = context->box;
    for (int d = 0; d < lattice->dimension; d++) {
        double step = lattice->step[d], planes = (double)lattice->planes[d], steps = box->edge[d] / step;
        if (box->periodic[d] && (fabs(steps - planes) > same * steps || planes < 1))
            return scene_fail(context->scene, error, "fluid.spacing",
                              "%g does not divide the periodic %c edge, %g; the nearest that does is %.15g",
                              step, 'x' + d, box->edge[d], box->edge[d] / fmax(planes, 1));
    }
    return true;
}

bool arrangement_suits(const struct arrangement *lattice, const struct physics_context *context,
                       struct error *error) {
    const struct fluid_options *options = context->options;
    if (lattice->arrangement == FLUID_CUBIC)
        return cubic_suits(lattice, context, error);
    if (lattice->dimension != rows[lattice->arrangement].dimension)
        return scene_fail(
            context->scene, error, "fluid.fill.arrangement",
            lattice->dimension == 2
                ? "this is a lattice of three dimensions; allowed in two: cubic, hexagonal"
                : "hexagonal is a lattice of two dimensions; allowed in three: cubic, bcc, fcc");
    return lattice->stretch <= ARRANGEMENT_STRETCH ||
           scene_fail(context->scene, error, "fluid.spacing",
                      "%g: the lattice would have to be stretched by %.2g to fit the box; allowed is %g: a "
                      "finer spacing fits better",
                      options->spacing, lattice->stretch, ARRANGEMENT_STRETCH);
}

int arrangement_edges(const struct arrangement *lattice, const int (**steps)[3]) {
    static const int cubic[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    static const int hexagonal[6][3] = {{2, 0, 0},  {-2, 0, 0}, {1, 1, 0},
                                        {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
    static const int bcc[8][3] = {{1, 1, 1},  {-1, 1, 1},  {1, -1, 1},  {-1, -1, 1},
                                  {1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}};
    static const int fcc[12][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                   {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1}};
    switch (lattice->arrangement) {
    case FLUID_BCC:
        *steps = bcc;
        return 8;
    case FLUID_FCC:
        *steps = fcc;
        return 12;
    case FLUID_HEXAGONAL:
        *steps = hexagonal;
        return 6;
    default:
        *steps = cubic;
        return 2 * lattice->dimension;
    }
}

size_t arrangement_around(const struct arrangement *lattice, double spacing, double reach, int (**steps)[3]) {
    int64_t far[3] = {0}, at[3];
    size_t count = 0, room = 1;
    for (int d = 0; d < lattice->dimension; d++) {
        far[d] = (int64_t)ceil(reach / lattice->step[d]);
        room *= (size_t)(2 * far[d] + 1);
    }
    *steps = memory_allocate(room, sizeof **steps, "neighbours on the lattice");
    for (at[2] = -far[2]; at[2] <= far[2]; at[2]++)
        for (at[1] = -far[1]; at[1] <= far[1]; at[1]++)
            for (at[0] = -far[0]; at[0] <= far[0]; at[0]++) {
                double square = 0, limit = reach / spacing;
                for (int d = 0; d < 3; d++)
                    square += pow((double)at[d] * lattice->step[d] / spacing, 2);
                if (square == 0 || square >= limit * limit || !arrangement_has(lattice, at))
                    continue;
                for (int d = 0; d < 3; d++)
                    (*steps)[count][d] = (int)at[d];
                count++;
            }
    return count;
}
