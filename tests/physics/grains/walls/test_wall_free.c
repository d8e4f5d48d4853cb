/* SPDX-License-Identifier: BSD-3-Clause */
/* Free walls against closed forms: fall, rest, impacts, an axis, tumbling, a spring with a damper; mass and inertia of shapes. */
#include "tests/test.h"

#include "physics/grains/walls/walls_free.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

/* What the particles of a world do to its walls. */
static void push_of(const struct world *w, struct wall_push push[4]) {
    double force[4][6];
    walls_forces(w->walls, force);
    memset(push, 0, 4 * sizeof *push);
    for (int k = 0; k < walls_count(w->walls); k++) {
        memcpy(push[k].force, force[k], sizeof push[k].force);
        memcpy(push[k].torque, force[k] + 3, sizeof push[k].torque);
    }
}

/* First forces, and velocities half a step back, of walls too. */
static void begin(struct world *w) {
    struct wall_push push[4];
    walls_set_gravity(w->walls, w->motion.gravity);
    world_build(w);
    push_of(w, push);
    walls_stagger(w->walls, push, w->motion.dt, w->motion.dt);
}

static void steps(struct world *w, int count) {
    struct wall_push push[4];
    for (int n = 0; n < count; n++) {
        push_of(w, push);
        world_step(w, n % 20 == 0, push);
    }
    push_of(w, push);
    walls_full_step(w->walls, push, w->motion.dt);
}

static struct wall_options box_wall(double x, double y, double z, const double edge[3], double mass) {
    struct wall_options o = {.name = "box",
                             .shape = WALL_BOX,
                             .lower = {x - 0.5 * edge[0], y - 0.5 * edge[1], z - 0.5 * edge[2]},
                             .upper = {x + 0.5 * edge[0], y + 0.5 * edge[1], z + 0.5 * edge[2]}};
    o.free = (struct wall_free_options){.given = 1, .mass = mass, .density = NAN};
    return o;
}

static const double block[3] = {0.6, 0.8, 1.0};

/* A box of a density falls by g t^2 / 2, whatever its freedom; one along a slope by the part of g along the slope. */
static void test_fall(void **state) {
    (void)state;
    static const double slope[3] = {3, 0, -4};
    for (int freedom = WALL_FREE_ALL; freedom <= WALL_FREE_ALONG; freedom++) {
        struct wall_options wall = box_wall(2, 2, 3, block, NAN);
        struct world w;
        wall.free.density = 500;
        wall.free.freedom = (enum wall_freedom)freedom;
        memcpy(wall.free.direction, slope, sizeof slope);
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
        w.motion.gravity[2] = -10.0;
        world_add(&w, 0.3, 0.3, 3.7, 0.1, 1.0);
        begin(&w);
        assert_true(walls_have_free(w.walls) && walls_move(w.walls) && walls_follow_particles(w.walls));
        steps(&w, 1000);
        double offset[3], velocity[3], omega[3], part = freedom == WALL_FREE_ALONG ? 0.8 : 1.0;
        walls_offset(w.walls, 0, offset);
        walls_velocity(w.walls, 0, velocity, omega);
        assert_near(offset[2], -0.05 * part * part, 1e-12);
        assert_near(offset[0], freedom == WALL_FREE_ALONG ? 0.05 * 0.8 * 0.6 : 0.0, 1e-12);
        assert_near(velocity[2], -part * part, 1e-12);
        assert_near(hand_length(omega), 0.0, 0.0);
        assert_near(walls_energy(w.walls), 0.0, 1e-9);
        world_close(&w);
    }
}

/* A plate on four spheres on a floor: the floor carries all, the plate is carried by its weight; it stays level. */
static void test_rest(void **state) {
    (void)state;
    struct wall_options wall[2] = {hand_plane(0, 0, 1, 0, 0, 1),
                                   {.name = "plate",
                                    .shape = WALL_RECTANGLE,
                                    .point = {1, 1, 2},
                                    .along = {2, 0, 0},
                                    .across = {0, 2, 0},
                                    .free = {.given = 1, .mass = 2.0, .density = NAN}}};
    struct world w;
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.2, 0.5), wall, 2, 2);
    for (int k = 0; k < 4; k++)
        world_add(&w, k & 1 ? 2.5 : 1.5, k & 2 ? 2.5 : 1.5, 1.5, 0.5, 1.0);
    w.motion.gravity[2] = -10.0;
    begin(&w);
    steps(&w, 20000);
    double force[2][6], rotation[3];
    walls_forces(w.walls, force);
    walls_rotation(w.walls, 1, rotation);
    assert_near(force[0][2], -60.0, 1e-6);
    assert_near(force[1][2], 20.0, 1e-6);
    assert_near(hand_length(rotation), 0.0, 1e-9);
    struct wall_pose pose;
    walls_pose(w.walls, 1, &pose);
    assert_near(pose.translation[2], -(15.0 + 5.0) / 1e4,
                1e-9); /* of floor and plate: 15 and 5 N a contact */
    world_close(&w);
}

/* A sphere of mass 1 and speed 1 strikes a box of mass 3 in the middle of a face, and at an arm: momentum, restitution, and
 * the spin that the arm gives, by J = (1 + e) v / (1/m + 1/M + r^2/I). */
static void test_impact(void **state) {
    (void)state;
    static const double arm[3] = {0.0, 0.0, 0.3}, e[3] = {1.0, 0.6, 1.0};
    for (int k = 0; k < 3; k++) {
        struct wall_options wall = box_wall(2.5, 2, 2, block, 3.0);
        struct world w;
        world_open(&w, hand_box(4.0), hand_law_end(LAW_HOOKE, e[k], 0.0, LAW_END_OVERLAP), &wall, 1, 1);
        w.motion.dt = 1e-5;
        world_add(&w, 2.5 - 0.3 - 0.201, 2, 2 + arm[k], 0.2, 1.0)->v[0] = 1.0;
        begin(&w);
        steps(&w, 12000);
        double velocity[3], omega[3], inertia = 3.0 / 12.0 * (0.6 * 0.6 + 1.0);
        double push = (1.0 + e[k]) / (1.0 + 1.0 / 3.0 + arm[k] * arm[k] / inertia);
        walls_velocity(w.walls, 0, velocity, omega);
        const double *v = w.particles->state[0].v;
        assert_int_equal(w.sums.contacts, 0);
        for (int d = 0; d < 3; d++)
            assert_near(v[d] + 3.0 * velocity[d], d == 0, 1e-12);
        assert_near(v[0], 1.0 - push, 5e-3);
        assert_near(omega[1], push * arm[k] / inertia, 5e-3);
        if (e[k] == 1.0)
            assert_near(0.5 * (v[0] * v[0] + v[2] * v[2]) + walls_energy(w.walls), 0.5, 1e-4);
        world_close(&w);
    }
}

/* A paddle about an axis, struck at an arm: the angular momentum about the axis stays. */
static void test_paddle(void **state) {
    (void)state;
    static const double edge[3] = {0.2, 0.8, 1.0};
    struct wall_options wall = box_wall(2.5, 2, 2, edge, 3.0);
    struct world w;
    wall.free.freedom = WALL_FREE_ABOUT;
    wall.free.direction[1] = 2.0;
    memcpy(wall.free.point, (double[3]){2.5, 1.0, 2.5}, sizeof wall.free.point);
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    w.motion.dt = 1e-5;
    world_add(&w, 2.5 - 0.1 - 0.201, 2, 1.7, 0.2, 1.0)->v[0] = 1.0;
    begin(&w);
    steps(&w, 9000);
    double rotation[3], velocity[3], omega[3], inertia = 3.0 * ((0.2 * 0.2 + 1.0) / 12.0 + 0.25), arm = -0.8;
    double push = 2.0 / (1.0 + arm * arm / inertia);
    const struct particle_state *s = &w.particles->state[0];
    walls_velocity(w.walls, 0, velocity, omega);
    walls_rotation(w.walls, 0, rotation);
    assert_near(omega[1], push * arm / inertia, 5e-3);
    assert_near(s->v[0], 1.0 - push, 5e-3);
    assert_near(inertia * omega[1] + (s->x[2] - 2.5) * s->v[0] - (s->x[0] - 2.5) * s->v[2], arm, 1e-3);
    assert_near(0.5 * (s->v[0] * s->v[0] + s->v[2] * s->v[2]) + walls_energy(w.walls), 0.5, 1e-4);
    assert_near(hand_length(velocity), 0.0, 0.0);
    assert_true(rotation[1] < -0.01);
    struct wall_pose pose;
    walls_pose(w.walls, 0, &pose);
    assert_near(pose.centre[2], 2.5, 1e-12);
    world_close(&w);
}

/* A box without forces that turns about its middle axis, slightly off, tumbles: energy stays, and so does the centre's path;
 * the rotation stays one. */
static void test_tumble(void **state) {
    (void)state;
    struct wall_options wall = box_wall(2, 2, 2, block, 3.0);
    struct world w;
    double least = 2.0, offset[3], velocity[3], omega[3];
    memcpy(wall.free.omega, (double[3]){0.01, 10.0, 0.0}, sizeof wall.free.omega);
    wall.free.velocity[0] = 0.5;
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    w.motion.dt = 1e-3;
    world_add(&w, 0.3, 0.3, 3.7, 0.1, 1.0);
    begin(&w);
    steps(&w, 0);
    double energy = walls_energy(w.walls);
    assert_near(energy, 0.5 * 3.0 * 0.25 + 0.5 * 3.0 / 12.0 * (0.36 + 1.0) * 100.0, 1e-3);
    for (int n = 0; n < 40; n++) {
        struct wall_pose pose;
        steps(&w, 100);
        walls_pose(w.walls, 0, &pose);
        const double *r = pose.rotation;
        assert_near(walls_energy(w.walls), energy, 1e-4 * energy);
        assert_near(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], 1.0, 1e-12);
        assert_near(r[0] * r[3] + r[1] * r[4] + r[2] * r[5], 0.0, 1e-12);
        least = fmin(least, r[4]); /* the middle axis along y */
    }
    assert_true(least < -0.9); /* it turned over */
    walls_offset(w.walls, 0, offset);
    walls_velocity(w.walls, 0, velocity, omega);
    assert_near(offset[0], 2.0, 1e-9);
    assert_near(velocity[0], 0.5, 1e-12);
    world_close(&w);
}

/* A plane along its normal on a spring with a damper and a load: q'' = (P - k q - c q') / M. */
static void test_spring(void **state) {
    (void)state;
    struct wall_options wall = hand_plane(0, 0, 1, 0, 0, 1);
    struct world w;
    const double mass = 2.0, k = 200.0, c = 4.0, load = 3.0, slow = c / (2.0 * mass),
                 rate = sqrt(k / mass - slow * slow), t = 1.0, rest = load / k;
    wall.free = (struct wall_free_options){.given = 1,
                                           .freedom = WALL_FREE_ALONG,
                                           .mass = mass,
                                           .density = NAN,
                                           .direction = {0, 0, 1},
                                           .load = load,
                                           .spring = k,
                                           .damper = c};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    world_add(&w, 0.3, 0.3, 3.7, 0.1, 1.0);
    begin(&w);
    steps(&w, 10000);
    double offset[3],
        expected = rest * (1.0 - exp(-slow * t) * (cos(rate * t) + slow / rate * sin(rate * t)));
    walls_offset(w.walls, 0, offset);
    assert_near(offset[2], expected, 1e-7);
    assert_near(walls_energy(w.walls) + walls_taken(w.walls), 0.0, 1e-7);
    assert_true(walls_taken(w.walls) > 0.01);
    world_close(&w);
}

/* The inverse mass at the corner of a box along z, that of shapes by hand, and texts. */
static void test_yield(void **state) {
    (void)state;
    struct wall_options wall[4] = {box_wall(2, 2, 2, block, 3.0),
                                   {.name = "rod",
                                    .shape = WALL_CYLINDER,
                                    .point = {2, 2, 2},
                                    .axis = {0, 0, 2},
                                    .radius = 0.5,
                                    .length = 2.0},
                                   {.name = "tube",
                                    .shape = WALL_CYLINDER,
                                    .point = {2, 2, 2},
                                    .axis = {0, 0, 2},
                                    .radius = 0.5,
                                    .length = 2.0,
                                    .inside = true}};
    wall[3] = (struct wall_options){.name = "sheet",
                                    .shape = WALL_RECTANGLE,
                                    .point = {1, 1.5, 2},
                                    .along = {2, 0, 0},
                                    .across = {0, 1, 0}};
    wall[3].free = (struct wall_free_options){.given = 1, .mass = 2.0, .density = NAN};
    struct world w;
    wall[1].free = (struct wall_free_options){.given = 1, .mass = NAN, .density = 10.0};
    wall[2].free = (struct wall_free_options){.given = 1, .mass = 3.0, .density = NAN};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), wall, 4, 1);
    const double corner[3] = {2.3, 2.4, 2.5}, side[3] = {2.5, 2, 2.5}, up[3] = {0, 0, 1},
                 across[3] = {0, 1, 0}, out[3] = {1, 0, 0};
    double x = 3.0 / 12.0 * (0.64 + 1.0), y = 3.0 / 12.0 * (0.36 + 1.0), rod = 10.0 * M_PI * 0.25 * 2.0;
    assert_near(walls_yield(w.walls, 0, corner, up), 1.0 / 3.0 + 0.16 / x + 0.09 / y, 1e-12);
    assert_near(walls_yield(w.walls, 1, side, across),
                1.0 / rod + 0.25 / (rod * 0.125) + 0.25 / (rod * (0.0625 + 1.0 / 3.0)), 1e-12);
    assert_near(walls_yield(w.walls, 2, side, out), 1.0 / 3.0 + 0.25 / (3.0 * (0.125 + 1.0 / 3.0)), 1e-12);
    const double rim[3] = {3, 2.5, 2};
    assert_near(walls_yield(w.walls, 3, rim, up), 1.0 / 2.0 + 0.25 / (2.0 / 12.0) + 1.0 / (2.0 * 4.0 / 12.0),
                1e-12);
    for (int k = 0; k < 3; k++) {
        char text[128];
        walls_describe(w.walls, k, text, sizeof text);
        assert_non_null(strstr(text, "free, mass"));
        assert_true(walls_yield_most(w.walls, k) >= walls_yield_worst(w.walls, k, k ? side : corner));
        assert_true(walls_yield_worst(w.walls, k, side) >= walls_yield(w.walls, k, side, across));
    }
    world_close(&w);
}

/* A state that is read goes on with the same bits; without a state the wall becomes free where it stands. */
static void test_go_on(void **state) {
    (void)state;
    struct wall_options wall = box_wall(2.5, 2, 2, block, 3.0);
    struct world one, two;
    struct wall_pose pose, other;
    struct wall_push push[4] = {0};
    double *number, *copy;
    memcpy(wall.free.omega, (double[3]){1.0, 3.0, 2.0}, sizeof wall.free.omega);
    world_open(&one, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    world_add(&one, 0.3, 0.3, 3.7, 0.1, 1.0);
    begin(&one);
    steps(&one, 100);
    world_open(&two, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    int count = walls_free_numbers(one.walls, 0, &number);
    assert_int_equal(walls_free_numbers(two.walls, 0, &copy), count);
    memcpy(copy, number, (size_t)count * sizeof *copy);
    walls_pose(one.walls, 0, &pose);
    walls_set_pose(two.walls, 0, &pose);
    for (int n = 0; n < 50; n++) {
        walls_advance(one.walls, 0.0, 1e-4, push);
        walls_advance(two.walls, 0.0, 1e-4, push);
    }
    walls_pose(one.walls, 0, &pose);
    walls_pose(two.walls, 0, &other);
    assert_memory_equal(&pose, &other, sizeof pose);
    world_close(&two);

    struct wall_options door = wall; /* the state of another freedom: the wall stays where it is */
    door.free.freedom = WALL_FREE_ABOUT;
    door.free.direction[0] = 1.0;
    world_open(&two, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &door, 1, 1);
    walls_free_numbers(two.walls, 0, &copy);
    memcpy(copy, number, (size_t)count * sizeof *copy);
    walls_set_pose(two.walls, 0, &pose);
    walls_advance(two.walls, 0.0, 1e-4, push);
    walls_pose(two.walls, 0, &other);
    for (int k = 0; k < 9; k++)
        assert_near(other.rotation[k], pose.rotation[k], 1e-14);
    world_close(&two);

    memset(wall.free.omega, 0, sizeof wall.free.omega);
    world_open(&two, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    walls_set_pose(two.walls, 0, &pose);
    walls_advance(two.walls, 0.0, 1e-4, push);
    walls_pose(two.walls, 0, &other);
    for (int k = 0; k < 9; k++)
        assert_near(other.rotation[k], pose.rotation[k], 1e-14);
    assert_near(hand_length(other.omega), 0.0, 0.0);
    world_close(&one);
    world_close(&two);
}

/* A velocity that is given anew acts on a wall that is free already, and goes half a step back; what is not given goes on; the same
 * velocity once more changes nothing. */
static void test_given(void **state) {
    (void)state;
    struct wall_options wall = box_wall(2.5, 2, 2, block, 3.0);
    struct wall_push push[4] = {0};
    struct wall_pose pose, after;
    struct world one, two;
    double *number, *copy;
    memcpy(wall.free.omega, (double[3]){1.0, 3.0, 2.0}, sizeof wall.free.omega);
    world_open(&one, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    world_add(&one, 0.3, 0.3, 3.7, 0.1, 1.0);
    one.motion.gravity[2] = -10.0;
    begin(&one);
    steps(&one, 100);
    int count = walls_free_numbers(one.walls, 0, &number);
    walls_pose(one.walls, 0, &pose);
    wall.free.velocity_given = 3;
    wall.free.velocity[2] = 2.0;
    for (int k = 0; k < 2; k++) {
        world_open(&two, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
        assert_int_equal(walls_free_numbers(two.walls, 0, &copy), count);
        memcpy(copy, number, (size_t)count * sizeof *copy);
        walls_set_gravity(two.walls, one.motion.gravity);
        walls_set_pose(two.walls, 0, &pose);
        walls_stagger(two.walls, push, 0.0, 1e-2);
        walls_pose(two.walls, 0, &after);
        assert_near(after.velocity[2], k == 0 ? 2.0 + 10.0 * 0.5e-2 : pose.velocity[2], 1e-12);
        for (int d = 0; d < 3; d++) {
            assert_near(after.omega[d], pose.omega[d], 1e-12);
            assert_near(after.translation[d], pose.translation[d], 1e-12);
        }
        memcpy(number, copy, (size_t)count * sizeof *copy); /* as a checkpoint of the second run has them */
        walls_pose(two.walls, 0, &pose);
        world_close(&two);
    }
    world_close(&one);
}

/* Shapes without what a freedom needs are refused. */
static void test_refused(void **state) {
    (void)state;
    struct wall_options wall[3] = {
        hand_plane(0, 0, 1, 0, 0, 1),
        {.name = "sheet", .shape = WALL_RECTANGLE, .along = {1, 0, 0}, .across = {0, 1, 0}},
        box_wall(2, 2, 2, block, 1.0)};
    static const char *const why[3] = {"wall 'plane': free: no inertia follows",
                                       "wall 'sheet': free: the shape encloses no volume",
                                       "wall 'box': free: no body has such moments"};
    struct box box = hand_box(4.0);
    struct law law = hand_law(LAW_HOOKE, 1.0, 0.0);
    wall[0].free = (struct wall_free_options){.given = 1, .mass = 1.0, .density = NAN};
    wall[1].free = (struct wall_free_options){.given = 1, .mass = NAN, .density = 1.0};
    wall[2].free.inertia_given = 6;
    memcpy(wall[2].free.inertia, (double[3]){1.0, 1.0, 2.1}, 3 * sizeof(double));
    for (int k = 0; k < 3; k++) {
        struct error error = {0};
        struct walls *walls;
        assert_false(walls_create(&walls, &wall[k], 1, &law, &box, 1, &error, NULL));
        assert_non_null(strstr(error.text, why[k]));
    }
    law_free(&law);
}

TEST_MAIN(wall_free, cmocka_unit_test(test_fall), cmocka_unit_test(test_rest), cmocka_unit_test(test_impact),
          cmocka_unit_test(test_paddle), cmocka_unit_test(test_tumble), cmocka_unit_test(test_spring),
          cmocka_unit_test(test_yield), cmocka_unit_test(test_go_on), cmocka_unit_test(test_given),
          cmocka_unit_test(test_refused))
