/* SPDX-License-Identifier: BSD-3-Clause */
/* Motions: closed forms, velocities against displacements, composition, tables, servo. */
#include "tests/test.h"

#include "physics/grains/walls/wall_motion.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/walls_by_hand.h"

static const double origin[3] = {-1.0, 2.0, 0.5};

static struct wall_motions *motions(const struct wall_options *options) {
    struct wall_motions *m;
    struct error error = {0};
    must(wall_motions_create(&m, options, origin, &error), &error);
    return m;
}

static void assert_point(struct law_vector x, double a, double b, double c, double tolerance) {
    assert_near(x.x, a, tolerance);
    assert_near(x.y, b, tolerance);
    assert_near(x.z, c, tolerance);
}

static struct law_vector place(const struct wall_motions *m, double t, struct law_vector x) {
    struct wall_transform pose = wall_motions_place(m, t, 0.0);
    return wall_transform_point(&pose, x);
}

static void test_translate(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .start = 1.0, .stop = 3.0, .velocity = {1.0, -2.0, 0.5}};
    struct wall_motions *m = motions(&o);
    struct law_vector x = {7.0, 8.0, 9.0};
    assert_point(place(m, 0.5, x), 7.0, 8.0, 9.0, 0.0);
    assert_point(place(m, 2.0, x), 8.0, 6.0, 9.5, 1e-15);
    assert_point(place(m, 9.0, x), 9.0, 4.0, 10.0, 1e-15);
    /* a step that the stop cuts in half has half the speed */
    struct wall_twist twist = wall_motions_twist(m, 2.75, 0.5, 0.0, 0.0);
    assert_point(twist.velocity, 0.5, -1.0, 0.25, 1e-15);
    twist = wall_motions_twist(m, 3.0, 0.5, 0.0, 0.0);
    assert_point(twist.velocity, 0.0, 0.0, 0.0, 0.0);
    wall_motions_destroy(&m);
    assert_null(m);
}

/* A full turn comes back, a quarter turn is a quarter turn; the axis is given in the user's coordinates. */
static void test_rotate(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_ROTATE,
                                       .stop = INFINITY,
                                       .direction = {0.0, 3.0, 0.0},
                                       .point = {0.0, 5.0, 2.5},
                                       .rate = 2.0};
    struct wall_motions *m = motions(&o);
    struct law_vector x = {2.0, 4.0, 2.0}, pivot; /* the axis lies at x = 1, z = 2 of the box */
    assert_true(wall_motions_pivot(m, &pivot));
    assert_point(pivot, 1.0, 3.0, 2.0, 0.0);
    assert_point(place(m, 0.25 * M_PI, x), 1.0, 4.0, 1.0, 1e-15);
    assert_point(place(m, M_PI, x), 2.0, 4.0, 2.0, 1e-12);
    assert_point(place(m, 100.0 * M_PI, x), 2.0, 4.0, 2.0, 1e-12);
    struct wall_twist twist = wall_motions_twist(m, 0.3, 1e-7, 0.0, 0.0);
    assert_point(twist.omega, 0.0, 2.0, 0.0, 1e-15);
    assert_point(wall_twist_at(&twist, x), 0.0, 0.0, -2.0, 1e-15);
    wall_motions_destroy(&m);
}

/* Largest difference between the displacement of a point in a step and the velocity field of the step, which
 * is of second order in dt relative to the speed. */
static double twist_error(const struct wall_motions *m, double t, double dt, struct law_vector x) {
    struct law_vector before = place(m, t, x), after = place(m, t + dt, x);
    struct wall_twist twist = wall_motions_twist(m, t, dt, 0.0, 0.0);
    struct law_vector mean = law_scale(1.0 / dt, law_add(after, -1.0, before));
    struct law_vector middle = law_scale(0.5, law_add(after, 1.0, before));
    struct law_vector d = law_add(wall_twist_at(&twist, middle), -1.0, mean);
    return sqrt(law_dot(d, d));
}

static struct wall_options all_kinds(const char *table) {
    struct wall_options o = {.motions = 5};
    o.motion[0] = (struct wall_motion){.kind = WALL_OSCILLATE,
                                       .stop = INFINITY,
                                       .direction = {1.0, 1.0, 0.0},
                                       .amplitude = 0.3,
                                       .frequency = 2.0,
                                       .phase = 0.4};
    o.motion[1] = (struct wall_motion){.kind = WALL_ROTATE,
                                       .stop = INFINITY,
                                       .direction = {0.0, 0.0, 1.0},
                                       .point = {1.0, 1.0, 0.0},
                                       .rate = 3.0};
    o.motion[2] = (struct wall_motion){.kind = WALL_OSCILLATE_ROTATION,
                                       .stop = INFINITY,
                                       .direction = {1.0, 0.0, 0.0},
                                       .point = {0.0, 2.0, 0.0},
                                       .amplitude = 0.7,
                                       .frequency = 1.0};
    o.motion[3] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {0.1, -0.2, 0.3}};
    o.motion[4] = (struct wall_motion){.kind = WALL_TABLE, .stop = INFINITY};
    snprintf(o.motion[4].table, WALL_PATH_MAX, "%s", table);
    return o;
}

/* Each kind alone, and all on top of one another: the velocity is the derivative of the place. */
static void test_velocities(void **state) {
    (void)state;
    static const char rows[] =
        "t x y z a b c\n0 0 0 0 0 0 0\n1 0.1 0.2 0 0.5 -0.2 0.1\n2 0 0.1 1 2.5 0.3 0\n";
    char path[64];
    hand_file(path, "table", rows, sizeof rows - 1);
    struct wall_options all = all_kinds(path);
    struct law_vector x = {2.0, -1.0, 0.7};
    for (int k = 0; k <= 5; k++) {
        struct wall_options one = {.motions = 1, .motion = {all.motion[k < 5 ? k : 0]}};
        struct wall_motions *m = motions(k < 5 ? &one : &all);
        for (double t = 0.05; t < 1.9; t += 0.13) {
            double coarse = twist_error(m, t, 1e-3, x), fine = twist_error(m, t, 1e-4, x);
            assert_true(coarse < 2e-3);
            assert_true(fine < 0.02 * coarse + 1e-10);
        }
        wall_motions_destroy(&m);
    }
    remove(path);
}

/* Rotate, then translate: about an axis that travels. Translate, then rotate: about a fixed one. */
static void test_order(void **state) {
    (void)state;
    struct wall_motion turn = {.kind = WALL_ROTATE,
                               .stop = INFINITY,
                               .direction = {0.0, 0.0, 1.0},
                               .point = {-1.0, 2.0, 0.5},
                               .rate = 0.5 * M_PI};
    struct wall_motion shift = {.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {1.0, 0.0, 0.0}};
    struct wall_options first = {.motions = 2, .motion = {turn, shift}},
                        second = {.motions = 2, .motion = {shift, turn}};
    struct wall_motions *a = motions(&first), *b = motions(&second);
    struct law_vector x = {2.0, 0.0, 0.0};
    assert_point(place(a, 1.0, x), 1.0, 2.0, 0.0, 1e-15);
    assert_point(place(b, 1.0, x), 0.0, 3.0, 0.0, 1e-15);
    wall_motions_destroy(&a);
    wall_motions_destroy(&b);
}

static void test_oscillate(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_OSCILLATE,
                                       .start = 0.5,
                                       .stop = 1.5,
                                       .direction = {0.0, 0.0, 2.0},
                                       .amplitude = 0.1,
                                       .frequency = 0.25,
                                       .phase = 0.25 * M_PI};
    struct wall_motions *m = motions(&o);
    struct law_vector x = {0.0, 0.0, 0.0};
    assert_near(place(m, 0.0, x).z, 0.1 * sin(0.5 * M_PI), 1e-15); /* rests where it starts from */
    assert_near(place(m, 1.0, x).z, 0.1 * sin(0.75 * M_PI), 1e-15);
    assert_near(place(m, 7.0, x).z, 0.1 * sin(M_PI), 1e-15);
    assert_near(wall_motions_twist(m, 1.0, 1e-9, 0.0, 0.0).velocity.z, 0.1 * 0.5 * M_PI * cos(0.75 * M_PI),
                1e-8);
    wall_motions_destroy(&m);
}

static void test_table(void **state) {
    (void)state;
    static const char rows[] = "1 0 0 0 0 0 0\n3 4 0 0 0 0 1.5707963267948966\n";
    char path[64];
    hand_file(path, "table", rows, sizeof rows - 1);
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_TABLE, .stop = INFINITY, .point = {-1.0, 2.0, 0.5}};
    snprintf(o.motion[0].table, WALL_PATH_MAX, "%s", path);
    struct wall_motions *m = motions(&o);
    struct law_vector x = {1.0, 0.0, 0.0};
    assert_point(place(m, 0.0, x), 1.0, 0.0, 0.0, 0.0);
    assert_point(place(m, 2.0, x), 2.0 + sqrt(0.5), sqrt(0.5), 0.0, 1e-15);
    assert_point(place(m, 9.0, x), 4.0, 1.0, 0.0, 1e-15);
    struct wall_twist twist = wall_motions_twist(m, 2.0, 1e-7, 0.0, 0.0);
    assert_point(twist.omega, 0.0, 0.0, 0.25 * M_PI, 1e-9);
    assert_point(wall_motions_twist(m, 5.0, 1e-7, 0.0, 0.0).velocity, 0.0, 0.0, 0.0, 0.0);
    wall_motions_destroy(&m);
    remove(path);
}

/* Steps that cross rows of a table, one or two, or begin before the first or end behind the last: what the
 * wall travels in them is what the table says, to the last digits. */
static void test_table_rows_in_a_step(void **state) {
    (void)state;
    static const char rows[] = "1 0 0 0 0 0 0\n1.5 2 0 0 0 0 0.3\n1.75 2 -1 0 0 0 0.1\n3 5 0 4 0 0 -0.7\n";
    static const double steps[][2] = {{1.4, 0.2}, {1.45, 0.4}, {1.6, 1}, {0.8, 0.5}, {2.9, 0.4}, {0.5, 3}};
    char path[64];
    hand_file(path, "rows", rows, sizeof rows - 1);
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_TABLE, .stop = INFINITY, .point = {-1.0, 2.0, 0.5}};
    snprintf(o.motion[0].table, WALL_PATH_MAX, "%s", path);
    struct wall_motions *m = motions(&o);
    for (size_t k = 0; k < sizeof steps / sizeof steps[0]; k++) {
        double t = steps[k][0], dt = steps[k][1], angle[2];
        struct law_vector pivot = {0.0, 0.0, 0.0}; /* in the box's coordinates */
        struct law_vector from = place(m, t, pivot), to = place(m, t + dt, pivot);
        struct wall_twist twist = wall_motions_twist(m, t, dt, 0.0, 0.0);
        for (int end = 0; end < 2; end++) {
            struct wall_transform turned = wall_motions_place(m, t + end * dt, 0.0);
            angle[end] = atan2(turned.rotation[3], turned.rotation[0]);
        }
        assert_near(twist.omega.z * dt, angle[1] - angle[0], 1e-14);
        struct law_vector travelled = law_add(to, -1.0, from);
        struct law_vector middle = place(m, t + 0.5 * dt, pivot); /* it turns about where the pivot is then */
        struct law_vector mean = law_scale(dt, wall_twist_at(&twist, middle));
        assert_point(mean, travelled.x, travelled.y, travelled.z, 1e-14);
    }
    wall_motions_destroy(&m);
    remove(path);
}

static void refuse(struct wall_options o, const char *words) {
    struct wall_motions *m;
    struct error error = {0};
    assert_false(wall_motions_create(&m, &o, origin, &error));
    assert_null(m);
    assert_int_equal(error.kind, ERROR_USER);
    if (strstr(error.text, words) == NULL)
        fail_msg("'%s' lacks '%s'", error.text, words);
}

static void refuse_table(const char *rows, const char *words) {
    char path[64];
    struct wall_options o = {.motions = 1, .motion = {{.kind = WALL_TABLE, .stop = 1.0}}};
    snprintf(o.motion[0].table, WALL_PATH_MAX, "%s", hand_file(path, "bad", rows, strlen(rows)));
    refuse(o, words);
    remove(path);
}

static void test_bad(void **state) {
    (void)state;
    refuse_table("t x y z a b c\n", "no row");
    refuse_table("0 0 0 0 0 0\n", ":1: 6 numbers, 7 are needed");
    refuse_table("0 0 0 0 0 0 0\n0 0 0 0 0 0 0\n", ":2: time 0 does not increase");
    refuse_table("0 0 0 0 0 0 inf\n", ":1: not a finite number: 'inf'");
    struct wall_motion turn = {.kind = WALL_ROTATE, .stop = 1.0};
    refuse((struct wall_options){.name = "w", .motions = 1, .motion = {turn}},
           "wall 'w': the direction of motion 1");
    struct wall_motion late = {.kind = WALL_TRANSLATE, .start = 2.0, .stop = 1.0};
    refuse((struct wall_options){.motions = 1, .motion = {late}}, "stops (1) before it starts (2)");
    struct wall_motion servo = {
        .kind = WALL_SERVO, .stop = 1.0, .direction = {0, 0, 1}, .force = 1.0, .speed_max = 1.0};
    refuse((struct wall_options){.motions = 2, .motion = {servo, servo}}, "motion 2 is a second servo");
    servo.force = 0.0;
    refuse((struct wall_options){.motions = 1, .motion = {servo}}, "a force other than 0");
}

/* Below its force a servo moves against its direction, above along it, never faster than allowed. */
static void test_servo(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_SERVO,
                                       .start = 1.0,
                                       .stop = 2.0,
                                       .direction = {0.0, 0.0, 1.0},
                                       .force = 10.0,
                                       .speed_max = 0.5,
                                       .gain = 2.0};
    struct wall_motions *m = motions(&o);
    assert_true(wall_motions_has_servo(m));
    assert_near(wall_motions_servo_speed(m, 1.5, &(struct wall_push){.force = {3.0, 4.0, 9.0}}), -0.2, 1e-15);
    assert_near(wall_motions_servo_speed(m, 1.5, &(struct wall_push){.force = {3.0, 4.0, 11.0}}), 0.2, 1e-15);
    assert_near(wall_motions_servo_speed(m, 1.5, &(struct wall_push){.force = {0.0, 0.0, 0.0}}), -0.5, 0.0);
    assert_near(wall_motions_servo_speed(m, 0.5, &(struct wall_push){.force = {0.0, 0.0, 0.0}}), 0.0, 0.0);
    assert_near(wall_motions_servo_speed(m, 2.0, &(struct wall_push){.force = {0.0, 0.0, 0.0}}), 0.0, 0.0);
    assert_near(wall_motions_servo_follow(m, 1.5, &(struct wall_push){.force = {0.0, 0.0, 0.0}}, 0.3), 0.284,
                1e-15);
    assert_near(wall_motions_servo_follow(m, 2.0, &(struct wall_push){.force = {0.0, 0.0, 0.0}}, 0.3), 0.0,
                0.0);
    struct wall_transform pose = wall_motions_place(m, 1.5, 0.25);
    assert_near(pose.translation[2], 0.25, 0.0);
    assert_near(wall_motions_twist(m, 1.5, 1e-3, 0.25, -0.2).velocity.z, -0.2, 0.0);
    wall_motions_destroy(&m);
}

/* Without a gain the speed is the error over twice the impedance; the speed follows by a tenth. */
static void test_servo_impedance(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){
        .kind = WALL_SERVO, .stop = 2.0, .direction = {0.0, 0.0, 1.0}, .force = 10.0, .speed_max = 0.5};
    struct wall_motions *m = motions(&o);
    struct wall_push push = {.force = {0.0, 0.0, 9.0}, .impedance = 2.0};
    assert_near(wall_motions_servo_speed(m, 0.0, &push), -0.25, 1e-15);
    assert_near(wall_motions_servo_follow(m, 0.0, &push, 0.0), -0.025, 1e-15);
    push.impedance = 0.5;
    assert_near(wall_motions_servo_speed(m, 0.0, &push), -0.5, 0.0);
    push.impedance = 0.0;
    assert_near(wall_motions_servo_speed(m, 0.0, &push), -0.5, 0.0);
    push.force[2] = 10.0;
    assert_near(wall_motions_servo_speed(m, 0.0, &push), 0.0, 0.0);
    double unit = wall_motions_servo_unit(m);
    assert_near(unit, exp2(rint(log2(unit))), 0.0);
    assert_true(unit > 0.0 && unit < 1e-5 * 10.0 / 0.5);
    wall_motions_destroy(&m);
    o.motion[0].gain = 1.0;
    m = motions(&o);
    assert_near(wall_motions_servo_unit(m), 0.0, 0.0);
    wall_motions_destroy(&m);
}

/* What turns a servo's displacement turns the direction of the force that it looks at: by a quarter from t =
 * 1 on; what comes before it does not. */
static void test_servo_turned(void **state) {
    (void)state;
    struct wall_motion servo = {
        .kind = WALL_SERVO, .stop = INFINITY, .direction = {0.0, 0.0, 1.0}, .force = 10.0, .speed_max = 0.5};
    struct wall_motion turn = {
        .kind = WALL_ROTATE, .stop = 1.0, .direction = {0.0, 1.0, 0.0}, .rate = 0.5 * M_PI};
    struct wall_push push = {.force = {10.0, 0.0, 0.0}, .impedance = 10.0}; /* along z when it has turned */
    struct wall_options o = {.motions = 2, .motion = {servo, turn}};
    struct wall_motions *m = motions(&o);
    assert_near(wall_motions_servo_speed(m, 0.0, &push), -0.5, 1e-15);
    assert_near(wall_motions_servo_speed(m, 2.0, &push), 0.0, 1e-15);
    assert_point(wall_motions_twist(m, 2.0, 1e-3, 0.1, 0.3).velocity, 0.3, 0.0, 0.0, 1e-15);
    wall_motions_destroy(&m);
    o = (struct wall_options){.motions = 2, .motion = {turn, servo}};
    m = motions(&o);
    assert_near(wall_motions_servo_speed(m, 2.0, &push), -0.5, 1e-15);
    assert_point(wall_motions_twist(m, 2.0, 1e-3, 0.1, 0.3).velocity, 0.0, 0.0, 0.3, 1e-15);
    wall_motions_destroy(&m);
}

/* Tables that stay in the plane, and others. */
static void test_flat(void **state) {
    (void)state;
    const char *const rows[] = {"0 0 0 0 0 0 0\n1 2 3 0 0 0 4\n", "0 0 0 0 0 0 0\n1 2 3 4 0 0 0\n",
                                "0 0 0 0 0 0 0\n1 0 0 0 1 0 0\n", "0 0 0 0 0 0 0\n1 0 0 0 0 1 0\n"};
    for (int k = 0; k < 4; k++) {
        struct wall_options o = {.motions = 1, .motion = {{.kind = WALL_TABLE, .stop = INFINITY}}};
        struct error error = {0};
        char file[64];
        snprintf(o.motion[0].table, sizeof o.motion[0].table, "%s",
                 hand_file(file, "flat", rows[k], strlen(rows[k])));
        struct wall_motions *m = motions(&o);
        assert_true(wall_motions_flat(m, &error) == (k == 0));
        if (k > 0)
            assert_non_null(strstr(error.text, "flat:2: leaves the plane"));
        wall_motions_destroy(&m);
        remove(file);
    }
}

static void test_transforms(void **state) {
    (void)state;
    struct wall_options o = {.motions = 1};
    o.motion[0] = (struct wall_motion){.kind = WALL_ROTATE,
                                       .stop = INFINITY,
                                       .direction = {1.0, 2.0, -1.0},
                                       .point = {3.0, 1.0, 0.0},
                                       .rate = 1.0};
    struct wall_motions *m = motions(&o);
    struct wall_transform a = wall_motions_place(m, 0.7, 0.0), b = wall_motions_place(m, 1.1, 0.0);
    struct wall_transform sum = wall_motions_place(m, 1.8, 0.0), ab = wall_transform_compose(&a, &b);
    assert_true(wall_transform_near(&ab, &sum));
    assert_false(wall_transform_near(&a, &b));
    struct wall_transform back = wall_transform_inverse(&a), rest = wall_transform_identity(),
                          none = wall_transform_compose(&back, &a);
    assert_true(wall_transform_near(&none, &rest));
    struct law_vector x = {0.3, -0.4, 2.0};
    assert_point(wall_transform_back(&a, wall_transform_point(&a, x)), 0.3, -0.4, 2.0, 1e-14);
    wall_motions_destroy(&m);
}

TEST_MAIN(wall_motion, cmocka_unit_test(test_translate), cmocka_unit_test(test_rotate),
          cmocka_unit_test(test_velocities), cmocka_unit_test(test_order), cmocka_unit_test(test_oscillate),
          cmocka_unit_test(test_table), cmocka_unit_test(test_table_rows_in_a_step),
          cmocka_unit_test(test_bad), cmocka_unit_test(test_servo), cmocka_unit_test(test_servo_impedance),
          cmocka_unit_test(test_servo_turned), cmocka_unit_test(test_flat), cmocka_unit_test(test_transforms))
