/* SPDX-License-Identifier: BSD-3-Clause */
/* What surrounds a fluid, and how it moves and leaves: surface_feet on walls and open sides, shares beside walls, boundary_values,
 * fluid_motion, flow_loss.
 * Ranks: 1 */
#include "tests/test.h"

#include "base/memory.h"
#include "engine/physics_set.h"
#include "kernel/particles/kinds.h"
#include "physics/fluid/carried/shares.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/lattice/surface_feet.h"
#include "physics/fluid/schemes/boundary_values.h"
#include "physics/fluid/schemes/flow_loss.h"
#include "physics/fluid/schemes/fluid_motion.h"
#include "physics/grains/grains.h"
#include "team.h"
#include "tests/near.h"
#include "tests/physics/fluid/fluid_cloud.h"
#include "tests/physics/grains/walls/walls_by_hand.h"

/* surface_feet: in a tube of radius 1 that turns about its axis z by 3, a place 0.25 from the axis is 0.75 from the wall, and has the tube's
 * rigid motion there; a place beside an open side has what is given at the side. */
static void feet_have_the_motion_of_walls(void **state) {
    struct wall_options tube = {.name = "tube",
                                .shape = WALL_CYLINDER,
                                .point = {2, 2, 0},
                                .axis = {0, 0, 1},
                                .radius = 1,
                                .inside = true,
                                .motions = 1};
    struct fluid_options options = {.spacing = 0.1, .opens = 1};
    struct weights_foot foot = {0};
    struct world w;
    (void)state;
    tube.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 0, 1}, .point = {2, 2, 0}, .rate = 3};
    options.kernel.support = 2.5;
    options.open[0] = (struct fluid_open){.side = 5, .velocity = {0.1, 0.2, -0.3}, .pressure = NAN};
    world_open(&w, hand_box(4), hand_law(LAW_HOOKE, 0.5, 0.5), &tube, 1, 1);
    walls_advance(w.walls, 0, 0.1, NULL);
    const struct feet feet = {w.walls, &options, &w.box};
    assert_near(surface_feet_reach(&options, &w.box), 0.45, 1e-15);
    surface_feet_on(&feet, body_of_wall(0), (double[3]){2.25, 2, 1}, &foot);
    assert_near(foot.distance, 0.75, 1e-12);
    assert_near(foot.normal[0], -1, 1e-12);
    assert_near(foot.velocity[0], 0, 1e-12);
    assert_near(foot.velocity[1], 3 * 0.25, 1e-12);
    assert_near(foot.spin[2], 3, 1e-12);
    surface_feet_on(&feet, body_of_side(5), (double[3]){2, 2, 3.9}, &foot);
    assert_true(foot.open && !foot.pressed);
    assert_near(foot.distance, 0.1, 1e-12);
    assert_near(foot.normal[2], -1, 0);
    assert_near(foot.velocity[2], -0.3, 1e-15);
    world_close(&w);
}

/* The sum of w_ij k_ij (x_j - x_i)^2 / 4 over the fluid entries of all rows, along the planes: 1 a row in the open. */
static double section_of(const struct fluid_cloud *c, const struct weights *weights, const double *share) {
    double sum = 0, apart[3];
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
            weights_apart(weights, &c->input, row, e, apart);
            sum += weights_scalar(weights, e) * (share ? share[e] : 1) *
                   (apart[0] * apart[0] + apart[1] * apart[1]) / 2;
        }
    return sum / 2;
}

/* shares: between walls at z = 0.3 and 0.8 a section counts as its 500 cells, of which the entries that drop out had taken a part. */
static void shares_bring_the_section_back(void **state) {
    struct wall_options planes[2] = {hand_plane(0, 0, 0.3, 0, 0, 1), hand_plane(0, 0, 0.8, 0, 0, -1)};
    struct fluid_cloud c;
    struct world world;
    struct scene scene = {.walls = 2, .wall = planes};
    struct grains grains = {0};
    struct physics_set set = {.count = 1};
    struct fluid_options options = {.spacing = 0.1};
    struct fluid fluid = {.options = &options};
    uint8_t *kind;
    int64_t *body;
    (void)state;
    world_open(&world, (struct box){.dimension = 3, .edge = {1, 1, 1}, .periodic = {true, true, false}},
               hand_law(LAW_HOOKE, 0.5, 0), planes, 2, 1);
    grains.walls = world.walls;
    set.active[0] = (struct physics_active){.row = &grains_physics, .context = {.self = &grains}};
    options.kernel.support = 2.2;
    options.grains.unresolved = NAN;
    fluid_cloud_plane(&c, 0.3, &kind, &body);
    for (size_t k = 0; k < c.particles->owned; k++)
        body[k] = body_of_wall(c.particles->state[k].x[2] > 0.5);
    fluid.input = c.input;
    fluid.weights = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    const struct feet feet = {world.walls, &options, &world.box};
    const struct mirror_input mirror = {
        .rows = &c.input, .body = body, .spacing = c.spacing, .wall = surface_feet_on, .context = &feet};
    assert_int_equal(mirror_make(&fluid.weights, &mirror), 0);
    size_t n = c.particles->owned;
    fluid.flow = (struct flow){.weights = &fluid.weights,
                               .predicted = memory_allocate_zero(n, 3 * sizeof(double), "test"),
                               .increment = memory_allocate_zero(n, sizeof(double), "test")};
    const struct physics_context context = {.self = &fluid,
                                            .options = &options,
                                            .set = &set,
                                            .box = &world.box,
                                            .scene = &scene,
                                            .particles = c.particles};
    double *share = shares_make(&context, NULL, 0, NULL);
    assert_int_equal(fluid.weights.rows, 500);
    assert_true(section_of(&c, &fluid.weights, NULL) < 470);
    assert_near(section_of(&c, &fluid.weights, share), 500, 1e-9);
    memory_free(share);
    memory_free(fluid.flow.predicted);
    memory_free(fluid.flow.increment);
    memory_free(kind);
    memory_free(body);
    weights_free(&fluid.weights);
    fluid_cloud_free(&c);
    world_close(&world);
}

/* boundary_values: walls, open sides and groups of grains are found in the list; others are not. */
static void surfaces_have_their_numbers(void **state) {
    const struct fluid_surface list[3] = {{1, -1, -1}, {-1, 2, -1}, {-1, -1, 5}};
    (void)state;
    assert_int_equal(boundary_values_number(list, 3, body_of_wall(1), -1), 0);
    assert_int_equal(boundary_values_number(list, 3, 77, 2), 1);
    assert_int_equal(boundary_values_number(list, 3, body_of_side(5), -1), 2);
    assert_int_equal(boundary_values_number(list, 3, body_of_wall(5), -1), -1);
    assert_int_equal(boundary_values_number(list, 3, body_of_side(1), -1), -1);
    assert_int_equal(boundary_values_number(list, 3, 77, 1), -1);
    assert_int_equal(boundary_values_number(list, 3, 77, -1), -1);
    assert_int_equal(boundary_values_number(list, 3, BODY_NONE, 2), -1);
}

/* fluid_motion: the given velocity is that of its formula, one wave an edge where it repeats, half a one between walls; a point with a
 * uniform velocity goes by dt w. */
static void points_move_as_given(void **state) {
    const struct box box = {.dimension = 2, .edge = {2, 3, 1}, .periodic = {true, false, false}};
    struct fluid_options options = {
        .spacing = 0.1,
        .motion = {.name = FLUID_ALE, .velocity = {0.5, 0, 9}, .swing = {0.01, -0.02, 9}, .period = 4}};
    double w[3], time = 0.7, x[3] = {0.3, 1.1, 0.5}, omega = M_PI / 2;
    double shape = omega * cos(omega * time) * sin(M_PI * x[0]) * sin(M_PI / 3 * x[1]);
    (void)state;
    fluid_motion_given(&options.motion, &box, x, time, w);
    assert_near(w[0], 0.5 + 0.01 * shape, 1e-14);
    assert_near(w[1], -0.02 * shape, 1e-14);
    assert_near(w[2], 0, 0);
    struct fluid fluid = {.options = &options};
    const struct clock clock = {.step = 3, .time = 1, .dt = 0.25};
    const struct size_classes classes = {.count = 1, .kind = {KIND_FLUID}};
    struct particles *p = particles_create(1);
    size_t i = particles_append(p);
    const struct physics_context context = {.self = &fluid,
                                            .options = &options,
                                            .box = &box,
                                            .particles = p,
                                            .classes = &classes,
                                            .clock = &clock};
    options.grains.unresolved = NAN;
    options.motion.swing[0] = options.motion.swing[1] = 0;
    memcpy(p->state[i].x, x, sizeof x);
    assert_near(fluid_motion_move(&context, 0, i, i + 1, 0), 0.25, 1e-15);
    assert_near(p->state[i].x[0], 0.3 + 0.25 * 0.5, 1e-15);
    assert_near(p->state[i].x[1], 1.1, 0);
    particles_destroy(&p);
}

/* flow_loss: two particles in a row of edge 1, between an inlet of velocity 2 and an outlet of given pressure: what goes out less than in, or
 * through the middle less than through both, is the loss, as a part of 2. */
static void what_does_not_come_out_is_lost(void **state) {
    const double flow[4][3] = {{2, 2, 0}, {2, 1.5, 0.25}, {1, 2, 0.25}, {2, 0, 1}};
    struct team *team = *state;
    struct fluid_options options = {.spacing = 0.5, .density = 1, .viscosity = 1};
    struct weights_foot foot[2] = {
        {.distance = 0.25, .normal = {1, 0, 0}, .velocity = {2, 0, 0}, .body = body_of_side(0), .open = true},
        {.distance = 0.25, .normal = {-1, 0, 0}, .body = body_of_side(1), .open = true, .pressed = true}};
    size_t foot_start[3] = {0, 1, 2};
    double volume[2] = {0.5, 0.5};
    struct fluid fluid = {
        .options = &options,
        .lattice = {.step = {0.5, 1, 1}},
        .weights = {.dimension = 2, .rows = 2, .foot = foot, .foot_start = foot_start, .volume = volume}};
    const struct box box = {.dimension = 2, .edge = {1, 1, 1}, .periodic = {false, true, false}};
    const struct clock clock = {.dt = 0.1};
    struct particles *p = particles_create(2);
    const struct physics_context context = {.self = &fluid,
                                            .options = &options,
                                            .box = &box,
                                            .comm = &team->comm,
                                            .particles = p,
                                            .clock = &clock};
    options.grains.unresolved = NAN;
    for (int k = 0; k < 2; k++)
        p->state[particles_append(p)].x[0] = 0.25 + 0.5 * k;
    for (int k = 0; k < 4; k++) {
        p->state[0].v[0] = flow[k][0];
        p->state[1].v[0] = flow[k][1];
        assert_near(flow_loss_measure(&context), flow[k][2], 1e-14);
    }
    particles_destroy(&p);
}

TEAM_MAIN(fluid_surroundings, cmocka_unit_test(feet_have_the_motion_of_walls),
          cmocka_unit_test(shares_bring_the_section_back), cmocka_unit_test(surfaces_have_their_numbers),
          cmocka_unit_test(points_move_as_given), team_case(what_does_not_come_out_is_lost))
