/* SPDX-License-Identifier: BSD-3-Clause */
/* Open sides that contradict each other, or the lattice. Read lattice_fill_parts.h first. */
#include "physics/fluid/lattice/lattice_fill_parts.h"
#include "base/memory.h"
#include "physics/fluid/schemes/open_sides.h"
#include <math.h>
#include <stdio.h>

/* The largest part of the flow by which in and out may differ: sums over a lattice differ from integrals. */
static const double balance_worst = 0.01;

/* The fluid at one side. */
struct at_side {
    double nodes, flow; /* flow: into the box, speed x area */
};

/* Goes through the fluid nodes next to a side; reached[region] counts those of each region. */
static struct at_side side_find(const struct nodes *nodes, const struct physics_context *context,
                                const struct fluid_open *open, double *reached) {
    int d = open->side / 2, out = open->side % 2 == 1 ? 1 : -1, step[3] = {0};
    struct at_side at = {0};
    double area = nodes->lattice.volume / nodes->lattice.step[d];
    step[d] = nodes->lattice.arrangement == FLUID_CUBIC ? out : 2 * out;
    for (int64_t node = 0; node < nodes->all; node++) {
        bool own = nodes->state[node] == NODES_FLUID && nodes_own(nodes, node);
        int64_t next = own ? nodes_neighbour(nodes, node, step) : -1;
        double x[3], velocity[3];
        if (next < 0 || nodes->state[next] != NODES_SOLID || nodes->owner[next] != body_of_side(open->side))
            continue;
        nodes_place(nodes, nodes_number(nodes, node), x);
        open_velocity(open, context->box, x, velocity);
        at.nodes++;
        at.flow -= isnan(velocity[d]) ? 0 : out * velocity[d] * area;
        if (isnan(velocity[d]))
            reached[nodes->owner[node]]++;
    }
    comm_sum(context->comm, &at.nodes, 1);
    comm_sum(context->comm, &at.flow, 1);
    return at;
}

/* Each region reaches a side of given pressure, or none does. */
static bool regions_suit(const struct physics_context *context, const double *reached, int regions,
                         struct error *error) {
    int with = 0;
    for (int k = 0; k < regions; k++)
        with += reached[k] > 0;
    return with == 0 || with == regions ||
           scene_fail(context->scene, error, "fluid.open",
                      "a pressure is given at a side of %d of the %d connected regions of the fluid; "
                      "allowed: of all or "
                      "of none",
                      with, regions);
}

bool lattice_fill_open_suits(const struct nodes *nodes, const struct regions *regions,
                             const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    double in = 0, out = 0,
           *reached = memory_allocate_zero((size_t)regions->count, sizeof *reached, "open sides");
    bool good = true;
    for (int k = 0; k < options->opens; k++) {
        struct at_side at = side_find(nodes, context, &options->open[k], reached);
        char key[64];
        snprintf(key, sizeof key, "fluid.open[%d].side", k);
        if (at.nodes == 0 && good)
            good = scene_fail(context->scene, error, key, "no fluid lies at %s",
                              open_name(options->open[k].side));
        in += fmax(at.flow, 0);
        out += fmax(-at.flow, 0);
    }
    comm_sum(context->comm, reached, regions->count);
    good = good && regions_suit(context, reached, regions->count, error);
    memory_free(reached);
    if (good && options->opens > 0 && !open_pressed(options) &&
        fabs(in - out) > balance_worst * fmax(in, out))
        return scene_fail(
            context->scene, error, "fluid.open",
            "the given velocities let %.3g times as much in as out; needed is a balance, or a side of given "
            "pressure",
            in / out);
    return good;
}
