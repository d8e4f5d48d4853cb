/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls that move: piston, servo, drum, conveyor, bounds of displacements. */
#include "tests/test.h"

#include "physics/grains/walls/wall.h"
#include "physics/grains/laws/law_kernel.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

static const struct wall_push no_force[1];

/* A piston meets a sphere at rest elastically: it leaves at twice the speed; the work is its energy. */
static void test_piston(void **state) {
    (void)state;
    struct wall_options plane = hand_plane(0, 0, 1, 0, 0, 1);
    struct world w;
    plane.motions = 1;
    plane.motion[0] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {0.0, 0.0, 0.5}};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.0), &plane, 1, 1);
    world_add(&w, 2, 2, 1.51, 0.5, 3.0);
    world_build(&w);
    assert_true(walls_move(w.walls));
    assert_false(walls_have_servo(w.walls));
    for (int n = 0; n < 5000; n++)
        world_step(&w, false, no_force);
    assert_near(walls_displacement(w.walls), 0.25, 1e-12);
    assert_near(w.particles->state[0].v[2], 1.0, 1e-4);
    assert_near(walls_work(w.walls), 0.5 * 3.0, 1e-4);
    struct wall_pose pose;
    walls_pose(w.walls, 0, &pose);
    assert_near(pose.translation[2], 0.25, 1e-12);
    assert_near(pose.velocity[2], 0.5, 1e-12);
    world_close(&w);
}

/* Lets the walls of a world follow the forces of `steps` steps. */
static void follow(struct world *w, int steps) {
    for (int n = 0; n < steps; n++) {
        double force[4][6];
        struct wall_push push[4] = {0};
        walls_forces(w->walls, force);
        for (int k = 0; k < walls_count(w->walls); k++) {
            memcpy(push[k].force, force[k], sizeof push[k].force);
            push[k].impedance = *walls_impedance(w->walls, k);
        }
        world_step(w, n % 100 == 0, push);
    }
}

/* A plate with a servo lies down on a sphere and presses with the force that it should: a force with a gain, and a
 * pressure on the section of the box, 16, or on a given area, whose gain follows from the sphere. */
static void test_servo(void **state) {
    (void)state;
    static const struct {
        double force, pressure, area, gain;
    } given[3] = {{.force = 25.0, .gain = 0.05}, {.pressure = 25.0 / 16.0}, {.pressure = 5.0, .area = 5.0}};
    for (int k = 0; k < 3; k++) {
        struct wall_options wall[2] = {hand_plane(0, 0, 1, 0, 0, 1), hand_plane(0, 0, 2.1, 0, 0, -1)};
        struct world w;
        wall[1].motions = 1;
        wall[1].motion[0] = (struct wall_motion){.kind = WALL_SERVO,
                                                 .stop = INFINITY,
                                                 .direction = {0.0, 0.0, 1.0},
                                                 .force = given[k].force,
                                                 .pressure = given[k].pressure,
                                                 .area = given[k].area,
                                                 .speed_max = 0.2,
                                                 .gain = given[k].gain};
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.3, 0.5), wall, 2, 1);
        world_add(&w, 2, 2, 1.5, 0.5, 1.0);
        world_build(&w);
        assert_true(walls_have_servo(w.walls));
        assert_near(walls_options(w.walls, 1)->motion[0].force, 25.0, 1e-14);
        follow(&w, 50000);
        double force[2][6];
        struct wall_pose pose;
        walls_forces(w.walls, force);
        walls_pose(w.walls, 1, &pose);
        assert_near(force[1][2], 25.0, 0.01);
        assert_near(force[0][2], -25.0, 0.01);
        assert_near(pose.translation[2], -0.1 - 2.0 * 25.0 / 1e4, 1e-5);
        assert_near(pose.servo_offset, pose.translation[2], 1e-15);
        double impedance = *walls_impedance(w.walls, 1);
        assert_near(impedance, given[k].gain > 0.0 ? 0.0 : sqrt(1.0 * 1e4), 0.01);
        world_close(&w);
    }
}

/* Areas along directions: of a plane, of a plate with corners in any order, and of a closed cube; none of a plane
 * that slants through the box, nor of a cylinder. */
static void test_area(void **state) {
    (void)state;
    struct hand_text plate = text_new(), cube = text_new();
    char file[2][64];
    text_plate(&plate, (double[3]){0, 0, 2}, (double[3]){3, 0, 0}, (double[3]){0, 2, 2}, 3, 2, 0.3);
    text_cube(&cube, 1.0, 2.5, 2);
    struct wall_options wall[5] = {hand_plane(0, 0, 1, 0, 0, 1),
                                   hand_plane(0, 0, 1, 0, 1, 1),
                                   {.name = "pipe", .shape = WALL_CYLINDER, .axis = {0, 0, 1}, .radius = 1.0},
                                   hand_mesh(hand_file(file[0], "plate", plate.text, plate.size)),
                                   hand_mesh(hand_file(file[1], "cube", cube.text, cube.size))};
    struct world w;
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.3, 0.5), wall, 5, 1);
    static const double up[3] = {0, 0, 2}, aside[3] = {1, 0, 0}, slanting[3] = {1, 0, 1};
    assert_near(walls_area(w.walls, 0, up), 16.0, 1e-13);
    assert_near(walls_area(w.walls, 0, slanting), 16.0 * sqrt(0.5), 1e-13);
    assert_near(walls_area(w.walls, 1, up), 0.0, 0.0);
    assert_near(walls_area(w.walls, 2, up), 0.0, 0.0);
    assert_near(walls_area(w.walls, 3, up), 6.0, 1e-12);
    assert_near(walls_area(w.walls, 3, aside), 0.0, 1e-12);
    assert_near(walls_area(w.walls, 4, up), 1.5 * 1.5, 1e-12);
    world_close(&w);
    unlink(file[0]);
    unlink(file[1]);
    memory_free(plate.text);
    memory_free(cube.text);
}

/* The deepest overlap of a sphere of radius 1 mm inside of the drum's polygon of 100 sides that has turned by
 * `turn`; x and z from the axis, `corner` the angle of one corner at the start. */
static double drum_overlap(double x, double z, double corner, double turn) {
    double rho = hypot(x, z), half = M_PI / 100.0, angle = atan2(x, z) - turn - corner;
    double from_middle = remainder(angle - half, 2.0 * half);
    return rho * cos(from_middle) - 0.1 * cos(half) + 1e-3;
}

/* The drum of the example at several angles: spheres feel the nearest of its 100 inner sides, and a full turn
 * brings every triangle back. */
static void test_drum(void **state) {
    (void)state;
    enum { SPHERES = 400 };
    const char *folder = getenv("top_srcdir");
    struct box box = {.dimension = 3, .origin = {-0.105, -0.035, -0.105}, .edge = {0.21, 0.07, 0.21}};
    struct wall_options drum = hand_mesh("");
    struct world w;
    snprintf(drum.file, sizeof drum.file, "%s/examples/drum/walls.txt", folder ? folder : ".");
    drum.motions = 1;
    drum.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0.0, 1.0, 0.0}, .rate = 2.0};
    world_open(&w, box, hand_law(LAW_HOOKE, 0.5, 0.3), &drum, 1, 1);
    double(*before)[9], (*after)[9], corner_angle = 0.0;
    assert_int_equal(walls_triangles(w.walls, 0, &before), 1200);
    assert_near(before[0][0], 0.00158628, 1e-15); /* the user's coordinates */
    for (int k = 0; k < 1200; k++)
        if (fabs(hypot(before[k][0], before[k][2]) - 0.1) < 1e-4)
            corner_angle = atan2(before[k][0], before[k][2]);
    unsigned seed = 2;
    for (int i = 0; i < SPHERES; i++) {
        double angle = 2.0 * M_PI * hand_random(&seed), rho = 0.0985 + 0.0012 * hand_random(&seed);
        world_add(&w, 0.105 + rho * sin(angle), 0.035 + 0.05 * (hand_random(&seed) - 0.5),
                  0.105 + rho * cos(angle), 1e-3, 1e-5);
    }
    for (int turn = 1; turn <= 3; turn++) {
        double t = turn == 3 ? M_PI : 0.37 * turn, overlap[SPHERES] = {0};
        walls_advance(w.walls, t - 1e-6, 1e-6, NULL);
        world_rebuild(&w, NULL);
        world_forces(&w, 0.0);
        struct force_contact *contact;
        size_t n = walls_contacts(w.walls, &w.context, &contact);
        for (size_t k = 0; k < n; k++) {
            int i = (int)contact[k].id_i - 1;
            overlap[i] = fmax(overlap[i], contact[k].overlap);
        }
        for (int i = 0; i < SPHERES; i++) {
            const double *x = w.particles->state[i].x;
            double expected = drum_overlap(x[0] - 0.105, x[2] - 0.105, corner_angle, 2.0 * t);
            assert_near(overlap[i], fmax(expected, 0.0), 2e-6); /* the file has six digits */
        }
        assert_true(n > SPHERES / 2 && n < SPHERES * 5 / 4);
        memory_free(contact);
    }
    walls_triangles(w.walls, 0, &after);
    for (int k = 0; k < 1200; k++)
        for (int c = 0; c < 9; c++)
            assert_near(after[k][c], before[k][c], 1e-12);
    struct wall_pose pose;
    walls_pose(w.walls, 0, &pose);
    assert_near(pose.omega[1], 2.0, 1e-12);
    assert_near(pose.centre[0], 0.105, 1e-15);
    memory_free(after);
    memory_free(before);
    world_close(&w);
}

/* A conveyor: the floor travels around the periodic box, and spheres on it come to its speed. */
static void test_conveyor(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    double o[3] = {0, 0, 1}, a[3] = {4, 0, 0}, b[3] = {0, 4, 0};
    text_plate(&t, o, a, b, 4, 4, 0.5);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "conveyor"));
    struct box box = hand_box(4.0);
    box.periodic[0] = box.periodic[1] = true;
    mesh.motions = 1;
    mesh.motion[0] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {20.0, 0.0, 0.0}};
    struct world w;
    world_open(&w, box, hand_law(LAW_HOOKE, 0.5, 1.0), &mesh, 1, 1);
    remove(file);
    for (int i = 0; i < 4; i++)
        world_add(&w, 1.0 * i, 0.5 * i, 1.5 - 9.81e-4, 0.5, 1.0);
    w.motion.gravity[2] = -9.81;
    world_build(&w);
    for (int n = 0; n < 20000; n++) {
        world_step(&w, n % 50 == 0, NULL);
        assert_int_equal(w.sums.contacts, 4);
    }
    /* 40 long: ten times around; a sphere that rolls takes 2/7 of the speed (the lever is 0.1 % short of r)
     */
    for (size_t i = 0; i < 4; i++) {
        assert_near(w.particles->state[i].v[0], 20.0 * 2.0 / 7.0, 0.02);
        assert_near(w.particles->state[i].v[2], 0.0, 1e-3);
    }
    world_close(&w);
}

/* A sphere whose motion is prescribed rubs on a wall at rest if it turns, and only then. */
static void test_turns_on_the_spot(void **state) {
    (void)state;
    struct wall_options plane = hand_plane(0, 0, 1, 0, 0, 1);
    struct world w;
    double force[1][6];
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &plane, 1, 1);
    world_add(&w, 2, 2, 1.45, 0.5, 1.0)->inverse_mass = 0.0;
    world_rebuild(&w, NULL);
    world_forces(&w, 1e-3);
    assert_int_equal(w.sums.contacts, 0);
    spin_of(w.particles)[0][1] = 2.0;
    world_rebuild(&w, NULL);
    world_forces(&w, 1e-3);
    assert_int_equal(w.sums.contacts, 1);
    walls_forces(w.walls, force);
    assert_near(force[0][0], -2e4 / 7.0 * 1e-3 * (0.5 - 0.5 * 0.05) * 2.0, 1e-12);
    assert_near(force[0][2], -1e4 * 0.05, 1e-9);
    world_close(&w);
}

/* What a turning wall drags along is its velocity at the contact: a held sphere inside of a drum that turns
 * about its own axis. */
static void test_drags_at_the_contact(void **state) {
    (void)state;
    struct wall_options drum = {
        .name = "drum", .shape = WALL_CYLINDER, .point = {4, 4, 4}, .radius = 3.0, .inside = true};
    struct world w;
    double force[1][6], dt = 1e-3, rate = 2.0;
    drum.axis[1] = 1.0;
    drum.motions = 1;
    drum.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 1, 0}, .point = {4, 4, 4}, .rate = rate};
    world_open(&w, hand_box(8.0), hand_law(LAW_HERTZ, 1.0, 1e6), &drum, 1, 1);
    world_add(&w, 4.0, 4.0, 1.98, 1.0, 1.0);
    world_rebuild(&w, NULL);
    walls_advance(w.walls, 0.0, dt, NULL);
    world_forces(&w, dt);
    assert_int_equal(w.sums.contacts, 1);
    walls_forces(w.walls, force);
    double lever = 1.0 - 0.5 * 0.02, scale = sqrt(1.0 * 0.02);
    double k_t = scale * w.law.pair[law_place_of(w.law.materials, 0, 0)].k_t;
    double speed = rate * (2.02 + lever); /* of the drum, towards -x at its lowest line */
    assert_near(force[0][0], k_t * dt * speed, 1e-4 * k_t * dt * speed);
    world_close(&w);
}

/* What a wall gets is what the sphere gives, as torques too, with a rolling spring: both about the wall's
 * centre add up to nothing. */
static void test_torques_balance(void **state) {
    (void)state;
    struct wall_options plane = hand_plane(1, 2, 1, 0.6, 0, 0.8);
    struct law law = hand_law(LAW_HERTZ, 0.5, 0.5);
    struct world w;
    double force[1][6], twist = 0.0;
    law.options.rolling = LAW_ROLLING_SPRING;
    law.history_components = 6;
    law.pair[law_place_of(law.materials, 0, 0)].rolling_friction = 0.3;
    world_open(&w, hand_box(4.0), law, &plane, 1, 1);
    struct particle_state *s = world_add(&w, 2.3, 2.2, 0.635, 0.5, 1.0);
    double *omega = spin_of(w.particles)[0];
    for (int d = 0; d < 3; d++) {
        s->v[d] = 0.3 - 0.2 * d;
        omega[d] = 2.0 - 3.0 * d;
    }
    world_rebuild(&w, NULL);
    for (int n = 0; n < 5; n++)
        world_forces(&w, 1e-3);
    assert_int_equal(w.sums.contacts, 1);
    walls_forces(w.walls, force);
    const double *on_sphere = world_force(&w, 0), *centre = plane.point;
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        double arm = (s->x[e] - centre[e]) * on_sphere[f] - (s->x[f] - centre[f]) * on_sphere[e];
        assert_near(force[0][d], -on_sphere[d], 1e-9);
        assert_near(force[0][3 + d], -arm - on_sphere[4 + d], 1e-9);
        twist += fabs(on_sphere[4 + d]);
    }
    assert_true(twist > 1.0);
    world_close(&w);
}

/* How far walls have moved, for the decision to rebuild. */
static void test_displacement(void **state) {
    (void)state;
    struct wall_options wall = hand_plane(1, 1, 1, 0, 0, 1), tube = {.name = "tube", .shape = WALL_CYLINDER};
    struct world w;
    wall.motions = 1; /* within itself */
    wall.motion[0] = (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {3, 4, 0}};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &wall, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    tube.axis[2] = 1.0;
    tube.radius = 1.0;
    tube.motions = 1; /* about its own axis */
    tube.motion[0] =
        (struct wall_motion){.kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 0, 1}, .rate = 3.0};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &tube, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    tube.point[0] = 0.5; /* about another */
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &tube, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 2.0 * 0.5 * sin(0.15), 1e-15);
    world_rebuild(&w, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    wall.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 1, 0}, .point = {1, 1, 1}, .rate = 1.0};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &wall, 1, 1); /* a corner at x = 4: 3 away */
    walls_advance(w.walls, 0.0, 1e-3, NULL);
    assert_near(walls_displacement(w.walls), 3e-3, 2e-6);
    world_close(&w);
}

/* What turns moves farther where a particle has left the box; a finite cylinder no farther than its rims. */
static void test_displacement_outside(void **state) {
    (void)state;
    struct wall_options wall[2] = {hand_plane(1, 1, 1, 0, 0, 1),
                                   {.name = "tube", .shape = WALL_CYLINDER, .axis = {1, 0, 0}, .radius = 3}};
    const double lower[3] = {2, 2, 2}, upper[3] = {31, 2, 2}, here[3] = {3, 3, 3};
    for (int k = 0; k < 2; k++) {
        struct world w;
        double angle = 1e-3;
        wall[k].point[0] = wall[k].point[1] = wall[k].point[2] = 1.0;
        wall[k].motions = 1;
        wall[k].motion[0] = (struct wall_motion){
            .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 1, 0}, .point = {1, 1, 1}, .rate = 1.0};
        world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &wall[k], 1, 1);
        walls_advance(w.walls, 0.0, angle, NULL);
        double inside = walls_displacement(w.walls);
        walls_set_extent(w.walls, here, here); /* within the box: no change */
        assert_near(walls_displacement(w.walls), inside, 0.0);
        walls_set_extent(w.walls, lower, upper);
        double moved = walls_displacement(w.walls);
        assert_true(moved >= 30.0 * sin(angle) && moved <= (k == 0 ? 31.0 : 60.0) * angle);
        world_close(&w);
    }
    wall[1].length = 8.0;
    struct world w;
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &wall[1], 1, 1);
    walls_advance(w.walls, 0.0, 1e-3, NULL);
    walls_set_extent(w.walls, lower, upper);
    assert_near(walls_displacement(w.walls), 5e-3, 1e-8);
    world_close(&w);
}

/* How far the centre has moved, wherever the box begins: a turn about it adds nothing, one about another
 * point does. */
static void test_offset(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct wall_options wall = hand_plane(1, 2, 3, 0, 0, 1);
        struct wall_motion shift = {.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {0, 1, 2}};
        struct wall_motion turn = {
            .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 1, 0}, .point = {3, 2, 1}, .rate = M_PI};
        struct box box = hand_box(4.0);
        struct world w;
        double offset[3];
        for (int d = 0; d < 3; d++)
            box.origin[d] = 7.0 * k;
        wall.motions = 2;
        wall.motion[0] = k == 2 ? shift : turn;
        wall.motion[1] = k == 2 ? turn : shift;
        world_open(&w, box, hand_law(LAW_HOOKE, 0.5, 0.5), &wall, 1, 1);
        walls_advance(w.walls, 0.0, 0.5, NULL);
        walls_offset(w.walls, 0, offset);
        assert_near(offset[0], k == 2 ? 1.0 : 0.0, 1e-14);
        assert_near(offset[1], 0.5, 1e-14);
        assert_near(offset[2], k == 2 ? 0.0 : 1.0, 1e-14);
        world_close(&w);
    }
}

TEST_MAIN(wall_moving, cmocka_unit_test(test_piston), cmocka_unit_test(test_servo),
          cmocka_unit_test(test_area), cmocka_unit_test(test_drum), cmocka_unit_test(test_conveyor),
          cmocka_unit_test(test_turns_on_the_spot), cmocka_unit_test(test_drags_at_the_contact),
          cmocka_unit_test(test_torques_balance), cmocka_unit_test(test_displacement),
          cmocka_unit_test(test_displacement_outside), cmocka_unit_test(test_offset))
