/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of a box that moves, and of the motion of particles relative to its mean flow (box_flow). Read
 * observables_kinds.h first. */
#include "data/observe/observables_kinds.h"

/* The squared speed of a free particle relative to the mean flow at its centre, times its mass; and its mass. */
static double fluctuation(const struct output_view *view, size_t i, double *mass) {
    const struct particle_state *state = &view->particles->state[i];
    double v[3], flow[3], square = 0;
    *mass = state->inverse_mass > 0 ? 1 / state->inverse_mass : 0;
    if (*mass == 0)
        return 0;
    integrator_full_step(view->particles, view->motion, i, v, NULL);
    box_flow(view->box, state->x, flow);
    for (int d = 0; d < 3; d++)
        square += (v[d] - flow[d]) * (v[d] - flow[d]);
    return *mass * square;
}

static void add_fluctuation(const struct output_view *view, const struct observable_item *item, size_t i,
                            double *part) {
    (void)item;
    double mass;
    part[0] += 0.5 * fluctuation(view, i, &mass);
}

static void add_temperature(const struct output_view *view, const struct observable_item *item, size_t i,
                            double *part) {
    (void)item;
    double mass;
    part[0] += fluctuation(view, i, &mass);
    part[1] += mass;
}

static void finish_temperature(const struct output_view *view, const struct observable_item *item,
                               double *part) {
    (void)item;
    part[0] = part[1] > 0 ? part[0] / (view->box->dimension * part[1]) : NAN;
}

static void finish_edges(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)item;
    for (int d = 0; d < 3; d++)
        part[d] = view->box->edge[d];
}

static void finish_strain(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)item;
    const struct box_motion *motion = &view->box->motion;
    part[0] = !motion->shears ? 0
                              : (motion->offset + motion->turns * view->box->edge[motion->flow]) /
                                    view->box->edge[motion->gradient];
}

/* The box is the same on all ranks: its numbers come in `finish`. */
static void of_box(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)context, (void)item, (void)part;
}

static bool moves(const struct output_view *view) {
    return view->box->motion.moves;
}

static const struct observable_kind kinds[] = {
    {.info = {"energy_fluctuation", "energy", "J",
              "translational energy of the free particles relative to the mean flow of a box that moves",
              OBSERVABLE_OF_ALL, 1, NULL},
     .parts = 1,
     .of_particle = add_fluctuation,
     .relevant = moves},
    {.info =
         {"granular_temperature", "", "m2/s2",
          "mean squared velocity relative to the mean flow, weighted by mass, over the number of dimensions",
          OBSERVABLE_OF_ALL, 1, NULL},
     .parts = 2,
     .of_particle = add_temperature,
     .finish = finish_temperature},
    {.info = {"box_edges", "box", "m", "edges of the box", OBSERVABLE_OF_ALL, 3, NULL},
     .parts = 3,
     .of_rank = of_box,
     .finish = finish_edges},
    {.info = {"shear_strain", "box", "1",
              "shear of the box since the start: displacement over the edge along the gradient",
              OBSERVABLE_OF_ALL, 1, NULL},
     .parts = 1,
     .of_rank = of_box,
     .finish = finish_strain},
};

int observables_flow_count(void) {
    return sizeof kinds / sizeof kinds[0];
}

const struct observable_kind *observables_flow(int k) {
    return &kinds[k];
}
