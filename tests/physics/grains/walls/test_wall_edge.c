/* SPDX-License-Identifier: BSD-3-Clause */
/* Springs of wall contacts round a convex edge. */
#include "tests/test.h"

#include "physics/grains/walls/wall.h"
#include "physics/grains/laws/law_kernel.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

/* The sphere stands at `at` (distance 0.45 from the cube's edge x = z = 3) at this angle about the edge. */
static void stand_at_edge(struct world *w, double angle) {
    double *x = w->particles->state[0].x;
    x[0] = 3.0 + (angle > 0.0 ? 0.45 * sin(angle) : 0.5 * angle);
    x[2] = 3.0 + 0.45 * (angle > 0.0 ? cos(angle) : 1.0);
    if (angle > 0.5 * M_PI) {
        x[0] = 3.45;
        x[2] = 3.0 - 0.5 * (angle - 0.5 * M_PI);
    }
}

/* Round a convex edge: one contact, the normal force stays as it is, and a spring goes along, turned with the
 * normal, from the face to the edge to the other face; from one piece of the edge to the next, and over a
 * rebuild. */
static void test_spring_round_an_edge(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    text_cube(&t, 1.0, 3.0, 2);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "edge"));
    struct world w;
    world_open(&w, hand_box(5.0), hand_law(LAW_HOOKE, 1.0, 1e6), &mesh, 1, 1);
    remove(file);
    world_add(&w, 0, 1.7, 0, 0.5, 1.0);
    stand_at_edge(&w, -0.4);
    world_rebuild(&w, NULL);
    double *v = w.particles->state[0].v, load = 1e-4;
    v[0] = 1.0;
    v[1] = 2.0;
    world_forces(&w, load); /* springs (1, 2, 0) x load */
    v[0] = v[1] = 0.0;
    double k_t = 2e4 / 7.0;
    for (double angle = -0.4; angle < 0.5 * M_PI + 0.4; angle += 0.001) {
        double turn = angle < 0.0 ? 0.0 : angle > 0.5 * M_PI ? 0.5 * M_PI : angle;
        stand_at_edge(&w, angle);
        w.particles->state[0].x[1] = 1.7 + 0.3 * (angle + 0.4); /* over the middle of the edge */
        if (fabs(angle) < 0.0025 || fabs(angle - 0.7) < 0.001)
            world_rebuild(&w, NULL);
        world_forces(&w, 1e-4);
        assert_int_equal(w.sums.contacts, 1);
        const double *f = world_force(&w, 0), n = 1e4 * 0.05;
        assert_near(f[0], n * sin(turn) - k_t * load * cos(turn), 1e-3 * k_t * load);
        assert_near(f[1], -2.0 * k_t * load, 1e-3 * k_t * load);
        assert_near(f[2], n * cos(turn) + k_t * load * sin(turn), 1e-3 * k_t * load);
    }
    world_close(&w);
}

/* A step that brings the contact from a face far round the edge, or from one face to the other: the spring is
 * turned by as much as the normal, about the edge. */
static void test_spring_turns_with_the_normal(void **state) {
    (void)state;
    static const double to[] = {0.3, 0.7, 1.0};
    for (int k = 0; k < 6; k++) {
        char file[64];
        struct hand_text t = text_new();
        text_cube(&t, 1.0, 3.0, 2);
        struct wall_options mesh = hand_mesh(text_file(&t, file, "turn"));
        struct world w;
        world_open(&w, hand_box(5.0), hand_law(LAW_HOOKE, 1.0, 1e6), &mesh, 1, 1);
        remove(file);
        world_add(&w, 0, 1.7, 0, 0.5, 1.0);
        bool back = k >= 3; /* from the other face */
        double turn = back ? 0.5 * M_PI - to[k - 3] : to[k], load = 1e-4, k_t = 2e4 / 7.0;
        stand_at_edge(&w, back ? 0.5 * M_PI + 0.1 : -0.1);
        world_rebuild(&w, NULL);
        double *v = w.particles->state[0].v;
        v[back ? 2 : 0] = back ? -1.0 : 1.0; /* along the face, the way from the first to the second */
        v[1] = 2.0;
        world_forces(&w, load);
        v[0] = v[1] = v[2] = 0.0;
        stand_at_edge(&w, turn);
        world_forces(&w, 0.0);
        assert_int_equal(w.sums.contacts, 1);
        const double *f = world_force(&w, 0), n = 1e4 * 0.05;
        assert_near(f[0], n * sin(turn) - k_t * load * cos(turn), 1e-6 * k_t * load);
        assert_near(f[1], -2.0 * k_t * load, 1e-6 * k_t * load);
        assert_near(f[2], n * cos(turn) + k_t * load * sin(turn), 1e-6 * k_t * load);
        world_close(&w);
    }
}

TEST_MAIN(wall_edge, cmocka_unit_test(test_spring_round_an_edge),
          cmocka_unit_test(test_spring_turns_with_the_normal))
