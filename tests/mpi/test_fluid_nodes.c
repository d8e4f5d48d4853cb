/* SPDX-License-Identifier: BSD-3-Clause */
/* Nodes of a lattice against plain loops over its places: nodes.h with a sphere, surface_marks behind open sides, narrow_gaps between
 * spheres, and lattice_fill's particles of them.
 * Ranks: 1 2 3 */
#include "tests/test.h"

#include "kernel/particles/kinds.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include "physics/fluid/lattice/lattice_fill.h"
#include "physics/fluid/lattice/lattice_fill_parts.h"
#include "physics/fluid/lattice/narrow_gaps.h"
#include "base/memory.h"
#include "team.h"

#include <math.h>
#include <string.h>

enum { SIDE = 20, GRAIN_ID = 77, FIRST_ID = 1000 };

static const double sphere[3] = {0.03, 0.51, 0.97}, radius = 0.26, support = 2.2;

/* A cube of edge 1 with 20 nodes a side; the sphere, which reaches across sides, is rank 0's. */
struct room {
    struct fluid_options options;
    struct box box;
    struct scene scene;
    struct fluid fluid;
    struct physics_context context;
};

static void room_make(struct room *r, struct team *team, bool closed) {
    *r = (struct room){.options = {.spacing = 1.0 / SIDE, .density = 1},
                       .box = {.dimension = 3, .edge = {1, 1, 1}, .periodic = {true, true, closed}}};
    r->options.grains.unresolved = NAN;
    r->options.grains.coupling = FLUID_MIRROR;
    r->options.kernel.support = support;
    r->scene.group[0].motion = SCENE_FROZEN;
    r->scene.groups = 1;
    r->fluid.options = &r->options;
    r->context = (struct physics_context){.self = &r->fluid,
                                          .options = &r->options,
                                          .scene = &r->scene,
                                          .box = &r->box,
                                          .comm = &team->comm,
                                          .particles = particles_create(8)};
    kinds_register(r->context.particles);
    fluid_fields(r->context.particles);
    if (team->comm.rank > 0)
        return;
    size_t i = particles_append(r->context.particles);
    memcpy(r->context.particles->state[i].x, sphere, sizeof sphere);
    r->context.particles->state[i].radius = radius;
    r->context.particles->id[i] = GRAIN_ID;
}

static void room_free(struct room *r) {
    memory_free(r->fluid.gaps);
    particles_destroy(&r->context.particles);
}

/* Depth of a place in the sphere or its nearest image, below 0 outside. */
static double depth_of(const double x[3]) {
    double square = 0;
    for (int d = 0; d < 3; d++) {
        double apart = x[d] - sphere[d];
        apart -= round(apart);
        square += apart * apart;
    }
    return radius - sqrt(square);
}

/* The place of node n of the whole lattice: that of (i + 1/2) / 20. */
static void place_of(int64_t n, double x[3]) {
    for (int d = 0; d < 3; d++, n /= SIDE)
        x[d] = ((double)(n % SIDE) + 0.5) / SIDE;
}

/* nodes: each is where it should be, in the sphere at its depth or fluid, on each rank that holds it, and one rank's own. */
static void nodes_see_a_sphere(void **state) {
    struct team *team = *state;
    struct room r;
    struct nodes nodes;
    struct error error = {0};
    int64_t own = 0, wrong = 0;
    room_make(&r, team, true);
    if (team_expect(team, nodes_make(&nodes, &r.context, &error), "%s", error.text)) {
        for (int64_t node = 0; node < nodes.all; node++) {
            int64_t number = nodes_number(&nodes, node);
            double x[3], found[3];
            place_of(number, x);
            nodes_place(&nodes, number, found);
            double depth = depth_of(x);
            bool solid = nodes.state[node] == NODES_SOLID;
            for (int d = 0; d < 3; d++)
                wrong += !(fabs(found[d] - x[d]) < 1e-12);
            wrong += depth > 0 ? !solid || !(fabs(nodes.depth[node] - depth) < 1e-6)
                               : nodes.state[node] != NODES_FLUID;
            wrong += solid && nodes.grain[nodes.owner[node]].id != GRAIN_ID;
            wrong += nodes_own(&nodes, node) !=
                     (nodes_rank_of(&nodes, nodes_plane(&nodes, node)) == team->comm.rank);
            own += nodes_own(&nodes, node);
        }
        comm_sum_int(&team->comm, &own, 1);
        team_expect(team, wrong == 0 && own == SIDE * SIDE * SIDE, "%d wrong, %d", (int)wrong, (int)own);
        team_expect(team, nodes.wanted == SIDE * SIDE * SIDE, "wanted %d", (int)nodes.wanted);
    }
    nodes_free(&nodes);
    room_free(&r);
    team_finish(team);
}

/* surface_marks: between open sides nodes go on by three planes, each as deep in its side as it lies beyond. */
static void marks_lie_beyond_open_sides(void **state) {
    struct team *team = *state;
    struct room r;
    struct nodes nodes;
    struct error error = {0};
    int64_t beyond[2] = {0}, wrong = 0;
    room_make(&r, team, false);
    r.context.particles->owned = 0;
    r.options.opens = 2;
    r.options.open[0].side = 4;
    r.options.open[1].side = 5;
    if (team_expect(team, nodes_make(&nodes, &r.context, &error), "%s", error.text)) {
        surface_marks_make(&nodes, &r.context);
        for (int64_t node = 0; node < nodes.all; node++) {
            double z = ((double)(nodes_plane(&nodes, node) - 3) + 0.5) / SIDE;
            int upper = z > 0.5;
            if (z > 0 && z < 1) {
                wrong += nodes.state[node] != NODES_FLUID;
                continue;
            }
            wrong += nodes.state[node] != NODES_SOLID || nodes.owner[node] != body_of_side(4 + upper) ||
                     !(fabs(nodes.depth[node] - (upper ? z - 1 : -z)) < 1e-6);
            beyond[upper] += nodes_own(&nodes, node);
        }
        comm_sum_int(&team->comm, beyond, 2);
        team_expect(team, wrong == 0, "%d wrong", (int)wrong);
        team_expect(team, beyond[0] == 3 * SIDE * SIDE && beyond[1] == beyond[0], "%d and %d beyond",
                    (int)beyond[0], (int)beyond[1]);
    }
    nodes_free(&nodes);
    room_free(&r);
    team_finish(team);
}

/* lattice_fill: as many fluid particles as places outside of the sphere, and boundary particles in it up to the support deep, all of
 * the grain, with ids in the order of the lattice. */
static void particles_fill_the_rest(void **state) {
    struct team *team = *state;
    struct room r;
    struct error error = {0};
    const struct physics_share share = {.first_id = FIRST_ID};
    int64_t count[2] = {0}, found[2] = {0}, wrong = 0;
    room_make(&r, team, true);
    r.options.initial.velocity[1] = 3;
    for (int64_t n = 0; n < SIDE * SIDE * SIDE; n++) {
        double x[3];
        place_of(n, x);
        count[0] += depth_of(x) < 0;
        count[1] += depth_of(x) >= 0 && depth_of(x) < support / SIDE;
    }
    const struct particles *p = r.context.particles;
    size_t before = p->owned;
    team_expect(team, lattice_fill_run(&r.context, &share, &error), "%s", error.text);
    for (size_t i = before; i < p->owned; i++) {
        double x[3];
        place_of(p->id[i] - FIRST_ID, x);
        bool fluid = kinds_of(p)[i] == KIND_FLUID;
        found[!fluid]++;
        wrong += fluid != (depth_of(x) < 0) || p->state[i].v[1] != (fluid ? 3 : 0) ||
                 (!fluid && fluid_body(p)[i] != GRAIN_ID) || p->state[i].radius != 0.5 / SIDE;
        for (int d = 0; d < 3; d++)
            wrong += !(fabs(p->state[i].x[d] - x[d]) < 1e-12);
    }
    comm_sum_int(&team->comm, found, 2);
    team_expect(team, wrong == 0, "%d wrong", (int)wrong);
    team_expect(team, found[0] == count[0] && found[1] == count[1], "%d fluid, not %d; %d boundary, not %d",
                (int)found[0], (int)count[0], (int)found[1], (int)count[1]);
    room_free(&r);
    team_finish(team);
}

/* narrow_gaps: of three spheres in a row, one gap goes across the side; two of the three gaps are below two spacings. */
static void gaps_are_measured_across_sides(void **state) {
    struct team *team = *state;
    struct room r;
    struct nodes_grain grain[3] = {
        {{0.1, 0.5, 0.5}, 0.08, 9}, {{0.47, 0.5, 0.5}, 0.2, 5}, {{0.9, 0.5, 0.5}, 0.08, 3}};
    room_make(&r, team, true);
    const struct nodes nodes = {.spacing = 1.0 / SIDE, .box = &r.box, .grains = 3, .grain = grain};
    struct gaps gaps = narrow_gaps_find(&nodes, &r.context);
    team_expect(team, gaps.grains == 2 && gaps.walls == 0 && !gaps.at_wall, "%d gaps", (int)gaps.grains);
    team_expect(team, fabs(gaps.narrowest - 0.04) < 1e-12 && gaps.of[0] == 3 && gaps.of[1] == 9,
                "gap %g of %d and %d", gaps.narrowest, (int)gaps.of[0], (int)gaps.of[1]);
    grain[1].x[0] = 0.46; /* overlaps with none, and is now the narrowest: 0.36 - 0.33 */
    grain[1].radius = 0.25;
    gaps = narrow_gaps_find(&nodes, &r.context);
    team_expect(team, fabs(gaps.narrowest - 0.03) < 1e-12 && gaps.of[0] == 5 && gaps.of[1] == 9, "gap %g",
                gaps.narrowest);
    room_free(&r);
    team_finish(team);
}

TEAM_MAIN(fluid_nodes, team_case(nodes_see_a_sphere), team_case(marks_lie_beyond_open_sides),
          team_case(particles_fill_the_rest), team_case(gaps_are_measured_across_sides))
