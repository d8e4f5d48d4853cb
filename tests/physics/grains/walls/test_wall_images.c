/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls felt through periodic images: springs of contacts with several of them, and walls far outside of the
 * box. */
#include "tests/test.h"

#include "physics/grains/walls/wall.h"
#include "physics/grains/laws/law_kernel.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

static const double radius = 0.52, load = 1e-4;

/* From the centre to the middle of the overlap, of a sphere as far from a wall. */
static double lever(double distance) {
    return 0.5 * (radius + distance);
}

/* A sphere between two images of a post, which are 1 away from each other: at x the springs along y are these
 * on its lower and on its upper side, in units of the load. */
static void assert_springs(struct world *w, double x, double lower, double upper) {
    double k_t = 2e4 / 7.0, off = x - 2.0 * nearbyint(0.5 * x);
    w->particles->state[0].x[0] = x;
    world_forces(w, load);
    const double *force = world_force(w, 0);
    assert_int_equal(w->sums.contacts, (lower != 0.0) + (upper != 0.0));
    assert_near(force[1], -k_t * load * (lower + upper), 1e-9);
    assert_near(force[6], -k_t * load * (upper * lever(0.5 - off) - lower * lever(0.5 + off)), 1e-9);
}

/* Springs stay on their sides whichever image is nearer, over a rebuild that wraps the sphere, after rows
 * have been taken for a checkpoint, and where one of the contacts ends. */
static void test_springs_of_two_images(void **state) {
    (void)state;
    struct wall_options post = {.name = "post", .shape = WALL_CYLINDER, .axis = {0, 1, 0}, .radius = 0.5};
    struct box box = hand_box(4.0);
    struct world w;
    struct history_rows rows;
    box.edge[0] = 2.0;
    box.periodic[0] = true;
    post.point[0] = 1.0;
    post.point[2] = 2.0;
    world_open(&w, box, hand_law(LAW_HOOKE, 1.0, 1e6), &post, 1, 1);
    struct particle_state *s = world_add(&w, 1.999, 2.0, 2.0, radius, 1.0);
    world_rebuild(&w, NULL);
    s->v[1] = 1.0;
    spin_of(w.particles)[0][2] = 0.5 / radius;
    double lower = 1.0 - 0.5 * lever(0.499) / radius, upper = 1.0 + 0.5 * lever(0.501) / radius;
    assert_springs(&w, 1.999, lower, upper);
    s->v[1] = spin_of(w.particles)[0][2] = 0.0;
    assert_springs(&w, 2.001, lower, upper);
    assert_springs(&w, 1.999, lower, upper);
    world_rebuild(&w, NULL);
    assert_springs(&w, 2.001, lower, upper);
    world_rebuild(&w, NULL);
    assert_near(w.particles->state[0].x[0], 0.001, 1e-12);
    assert_springs(&w, -0.001, lower, upper);
    walls_detach(w.walls, w.particles, &rows);
    history_rows_free(&rows);
    assert_springs(&w, 0.001, lower, upper);
    assert_springs(&w, 0.03, 0.0, upper); /* parted from the lower one */
    world_close(&w);
}

/* A mesh at rest is felt however many periods it lies outside of the box, and also before the first rebuild.
 */
static void test_far_outside(void **state) {
    (void)state;
    struct box box = hand_box(4.0);
    box.periodic[0] = true;
    for (int periods = -3; periods <= 3; periods++) {
        char file[64];
        struct hand_text t = text_new();
        double o[3] = {1.0 + 4.0 * periods, -5.0, 1.0}, a[3] = {1, 0, 0}, b[3] = {0, 12, 0};
        text_plate(&t, o, a, b, 1, 1, 0.0);
        struct wall_options mesh = hand_mesh(text_file(&t, file, "far"));
        struct world w;
        world_open(&w, box, hand_law(LAW_HOOKE, 1.0, 0.0), &mesh, 1, 1);
        remove(file);
        struct particle_state *s = world_add(&w, 1.5, 1.4, 1.45, 0.5, 1.0);
        assert_true(walls_overlap(w.walls, s->x, s->radius));
        world_rebuild(&w, NULL);
        world_forces(&w, 0.0);
        assert_int_equal(w.sums.contacts, 1);
        assert_near(world_force(&w, 0)[2], 1e4 * 0.05, 1e-8);
        world_close(&w);
    }
}

/* And one that reaches into the box where it is, however far its middle lies outside. */
static void test_long_mesh(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    struct box box = hand_box(4.0);
    box.periodic[0] = true;
    double o[3] = {1, 1, 1}, far[3] = {30, 1, 3}, a[3] = {1, 0, 0}, b[3] = {0, 1, 0};
    text_plate(&t, o, a, b, 1, 1, 0.0);
    text_plate(&t, far, a, b, 1, 1, 0.0);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "long"));
    struct world w;
    world_open(&w, box, hand_law(LAW_HOOKE, 1.0, 0.0), &mesh, 1, 1);
    remove(file);
    world_add(&w, 1.5, 1.4, 1.45, 0.5, 1.0);
    world_rebuild(&w, NULL);
    world_forces(&w, 0.0);
    assert_int_equal(w.sums.contacts, 1);
    world_close(&w);
}

TEST_MAIN(wall_images, cmocka_unit_test(test_springs_of_two_images), cmocka_unit_test(test_far_outside),
          cmocka_unit_test(test_long_mesh))
