/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls in the step: closed forms, planes against meshes, edges, periodic images, what is refused. */
#include "tests/test.h"

#include "physics/grains/walls/wall.h"
#include "physics/grains/laws/law_kernel.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

static const struct wall_push no_force[3];

/* Chung and Ooi (Granular Matter 13 (2011) 643), test 2: an elastic sphere of 0.1 m at 0.2 m/s on a plane
 * 1000 times stiffer. Hertz: largest overlap (5 m v^2 / (4 K))^(2/5), K = 4/3 E* sqrt(r), duration 2.94328
 * overlap / v. */
static void test_impact(void **state) {
    (void)state;
    const struct {
        double young, poisson, density, overlap, force, duration;
    } metal[] = {{70e9, 0.30, 2699, 49.737e-6, 11.370e3, 731.66e-6},
                 {40e9, 0.35, 1800, 52.123e-6, 7.2327e3, 767.07e-6}};
    for (int k = 0; k < 2; k++) {
        struct law law;
        struct error error = {0};
        struct law_options options = law_options_default();
        struct law_material material[2] = {
            {.density = metal[k].density, .young = metal[k].young, .poisson = metal[k].poisson},
            {.density = metal[k].density, .young = 1000 * metal[k].young, .poisson = metal[k].poisson}};
        static struct law_pair pair[2][2];
        pair[0][0].restitution = pair[0][1].restitution = pair[1][1].restitution = 1.0;
        options.tangential = LAW_FRICTIONLESS;
        must(law_prepare(&law, &options, 2, material, pair[0], &error), &error);
        struct wall_options plane = hand_plane(0, 0, 0, 0, 0, 1);
        plane.material = 1;
        struct world w;
        world_open(&w, hand_box(1.0), law, &plane, 1, 1);
        double mass = 4.0 / 3.0 * M_PI * 1e-3 * metal[k].density, most = 0.0, force = 0.0, begin = -1.0,
               end = 0.0;
        struct particle_state *s = world_add(&w, 0.5, 0.5, 0.1 + 1e-9, 0.1, mass);
        s->v[2] = -0.2;
        w.motion.dt = 1e-8;
        world_build(&w);
        for (int n = 0; n < 100000; n++) {
            world_step(&w, false, NULL);
            most = fmax(most, w.sums.overlap_max * 0.1);
            force = fmax(force, world_force(&w, 0)[2]);
            if (w.sums.contacts > 0 && begin < 0.0)
                begin = w.time;
            if (w.sums.contacts > 0)
                end = w.time;
        }
        assert_near(most, metal[k].overlap, 1e-3 * most);
        assert_near(force, metal[k].force, 1e-3 * force);
        assert_near(end - begin, metal[k].duration, 1e-3 * metal[k].duration);
        assert_near(w.particles->state[0].v[2], 0.2, 1e-6);
        world_close(&w);
    }
}

/* Gross sliding: v_t' = v_t - mu (1 + e) v_n, omega' = 5/2 mu (1 + e) v_n / r. (Chung and Ooi, test 4) */
static void test_oblique(void **state) {
    (void)state;
    struct wall_options plane = hand_plane(0, 0, 0, 0, 0, 1);
    struct world w;
    struct law law = hand_law_end(LAW_HERTZ, 0.8, 0.1, LAW_END_FORCE);
    world_open(&w, hand_box(1.0), law, &plane, 1, 1);
    struct particle_state *s = world_add(&w, 0.2, 0.5, 0.01001, 0.01, 4.0 / 3.0 * M_PI * 1e-3);
    s->v[0] = 0.1;
    s->v[2] = -0.05;
    w.motion.dt = 2e-6;
    world_build(&w);
    while (w.time < 0.02)
        world_step(&w, false, NULL);
    s = &w.particles->state[0];
    assert_near(s->v[2], 0.04, 2e-5);
    assert_near(s->v[0], 0.1 - 0.1 * 1.8 * 0.05, 1e-4);
    assert_near(spin_of(w.particles)[0][1], 2.5 * 0.1 * 1.8 * 0.05 / 0.01,
                0.015); /* lever: r - overlap / 2 */
    world_close(&w);
}

enum { TRACK = 4000 };

/* A sphere that bounces and rolls down a slope and over it: places and spins along the way. */
static void run_down(const struct wall_options *wall, const double x[3], const double v[3],
                     enum law_normal normal, double (*track)[6]) {
    struct world w;
    world_open(&w, hand_box(40.0), hand_law(normal, 0.6, 0.4), wall, 1, 1);
    struct particle_state *s = world_add(&w, x[0], x[1], x[2], 0.5, 1.0);
    memcpy(s->v, v, sizeof s->v);
    spin_of(w.particles)[0][0] = 3.0;
    w.motion.gravity[2] = -9.81;
    w.motion.dt = normal == LAW_HOOKE ? 5e-4 : 2e-5;
    world_build(&w);
    for (int n = 0; n < TRACK; n++) {
        for (int inner = 0; inner < (normal == LAW_HOOKE ? 1 : 25); inner++)
            world_step(&w, n % 10 == 0 && inner == 0, NULL);
        memcpy(track[n], w.particles->state[0].x, 3 * sizeof(double));
        memcpy(track[n] + 3, spin_of(w.particles)[0], 3 * sizeof(double));
    }
    world_close(&w);
}

/* Plane against 2 and 1,000 triangles (and 4 triangles whose seam has no common vertices): the same to 1e-9
 * of the radius. The path leads along a line of the division and over its vertices, or anywhere. */
static void test_plane_and_meshes(void **state) {
    (void)state;
    static double track[4][TRACK][6];
    const double o[3] = {1, 1, 9}, a[3] = {20, 0, -6}, b[3] = {2, 20, 1};
    const double n[3] = {6 * 20, -6 * 2 - 20 * 1, 20 * 20}; /* a x b */
    double size = hand_length(n), quarter[3], half[3], path[2][3], speed[2][3];
    for (int d = 0; d < 3; d++) {
        half[d] = b[d] / 2;
        quarter[d] = o[d] + half[d];
        path[0][d] = o[d] + 0.08 * a[d] + 0.4 * b[d] + 0.8 * n[d] / size;
        speed[0][d] = 0.2 * a[d]; /* along the line at 0.4 b = 8 / 20 */
        path[1][d] = o[d] + 0.1 * a[d] + 0.13 * b[d] + 0.7 * n[d] / size;
        speed[1][d] = 0.1 * a[d] + 0.2 * b[d];
    }
    for (int run = 0; run < 3; run++) {
        enum law_normal normal = run == 2 ? LAW_HERTZ : LAW_HOOKE;
        struct wall_options plane = hand_plane(o[0], o[1], o[2], n[0], n[1], n[2]);
        run_down(&plane, path[run % 2], speed[run % 2], normal, track[0]);
        for (int kind = 1; kind < 4; kind++) {
            char file[64];
            struct hand_text t = text_new();
            if (kind == 1)
                text_plate(&t, o, a, b, 1, 1, 0.0);
            if (kind == 2)
                text_plate(&t, o, a, b, 25, 20, run == 0 ? 0.0 : 0.6);
            if (kind == 3) {
                text_plate(&t, o, a, half, 3, 1, 0.0);
                text_plate(&t, quarter, a, half, 7, 1, 0.0);
            }
            struct wall_options mesh = hand_mesh(text_file(&t, file, "slope"));
            run_down(&mesh, path[run % 2], speed[run % 2], normal, track[kind]);
            remove(file);
            for (int k = 0; k < TRACK; k++)
                for (int c = 0; c < 6; c++)
                    assert_near(track[kind][k][c], track[0][k][c], c < 3 ? 0.5e-9 : 1e-7);
        }
        double gone[3];
        for (int d = 0; d < 3; d++)
            gone[d] = track[0][TRACK - 1][d] - track[0][0][d];
        assert_true(hand_length(gone) > 8.0); /* it has crossed many triangles */
    }
}

/* In a closed box of triangles as between six planes: forces, torques and histories, in faces, edges,
 * corners. */
static void test_box(void **state) {
    (void)state;
    enum { SPHERES = 200 };
    char file[64];
    struct hand_text t = text_new();
    text_cube(&t, 1.0, 3.0, 3);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "cube")), plane[6];
    for (int k = 0; k < 6; k++) {
        double at = k < 3 ? 1.0 : 3.0, n[3] = {0};
        n[k % 3] = k < 3 ? 1.0 : -1.0;
        plane[k] = hand_plane(at, at, at, n[0], n[1], n[2]);
    }
    struct world w[2];
    world_open(&w[0], hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &mesh, 1, 1);
    world_open(&w[1], hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), plane, 6, 1);
    remove(file);
    for (int k = 0; k < 2; k++) {
        unsigned seed = 1;
        for (int i = 0; i < SPHERES; i++) {
            double r = 0.1 + 0.2 * hand_random(&seed), x[3];
            for (int d = 0; d < 3; d++)
                x[d] = 1.0 + r + (2.0 - 2.0 * r) * hand_random(&seed);
            struct particle_state *s = world_add(&w[k], x[0], x[1], x[2], r, r * r * r);
            for (int d = 0; d < 3; d++)
                s->v[d] = 6.0 * hand_random(&seed) - 3.0;
        }
        w[k].motion.dt = 2e-5;
        w[k].motion.gravity[0] = -80.0;
        w[k].motion.gravity[1] = -90.0;
        w[k].motion.gravity[2] = -100.0;
        world_build(&w[k]);
    }
    size_t contacts = 0, most = 0;
    for (int n = 0; n < 8000; n++) {
        world_step(&w[0], n % 100 == 99, NULL);
        world_step(&w[1], n % 100 == 99, NULL);
        assert_int_equal(w[0].sums.contacts, w[1].sums.contacts);
        contacts += w[0].sums.contacts;
        most = w[0].sums.contacts > most ? w[0].sums.contacts : most;
        for (size_t i = 0; n % 1000 == 0 && i < SPHERES; i++)
            for (int c = 0; c < 3; c++) {
                assert_near(w[0].particles->state[i].x[c], w[1].particles->state[i].x[c], 1e-10);
                assert_near(spin_of(w[0].particles)[i][c], spin_of(w[1].particles)[i][c], 1e-8);
            }
    }

    assert_true(contacts > 50000 && most > 20);
    world_close(&w[0]);
    world_close(&w[1]);
}

/* Over a ridge without friction and damping no energy is won or lost. */
static void test_ridge(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    double low[3] = {1, 1, 1}, up[3] = {4, 0, 1}, top[3] = {5, 1, 2}, down[3] = {4, 0, -1.5},
           b[3] = {0, 4, 0};
    text_plate(&t, low, up, b, 4, 4, 0.5);
    text_plate(&t, top, down, b, 4, 4, 0.5);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "ridge"));
    struct world w;
    world_open(&w, hand_box(10.0), hand_law(LAW_HOOKE, 1.0, 0.0), &mesh, 1, 1);
    remove(file);
    struct particle_state *s = world_add(&w, 4.4, 3.0, 1.85 + 0.5 * sqrt(17.0) / 4.0 - 0.001, 0.5, 1.0);
    s->v[0] = 2.4;
    s->v[2] = 0.6;
    w.motion.gravity[2] = -9.81;
    w.motion.dt = 2e-5;
    world_build(&w);
    double first = 0.0;
    bool passed = false, touched_edge = false;
    for (int n = 0; n < 50000; n++) {
        world_step(&w, n % 500 == 0, NULL);
        double v[3];
        integrator_full_step(w.particles, &w.motion, 0, v, NULL);
        s = &w.particles->state[0];
        double energy =
            0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 9.81 * s->x[2] + w.sums.elastic_normal;
        first = n == 0 ? energy : first;
        assert_near(energy, first, 1e-5);
        assert_true(w.sums.contacts <= 1);
        touched_edge = touched_edge || (w.sums.contacts == 1 && fabs(s->x[0] - 5.0) < 0.05);
        passed = passed || (s->x[0] > 5.5 && w.sums.contacts == 1);
    }
    assert_true(passed && touched_edge);
    world_close(&w);
}

/* Spheres rest on a floor of triangles that ends at the periodic boundary, and feel a wall across it. */
static void test_periodic(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    double o[3] = {0, 0, 1}, a[3] = {4, 0, 0}, b[3] = {0, 4, 0}, post[3] = {3.9, 0, 1}, up[3] = {0, 0, 2};
    text_plate(&t, o, a, b, 2, 2, 0.0);
    text_plate(&t, post, b, up, 1, 1, 0.0);
    struct wall_options mesh = hand_mesh(text_file(&t, file, "periodic"));
    struct box box = hand_box(4.0);
    box.periodic[0] = box.periodic[1] = true;
    struct world w;
    world_open(&w, box, hand_law(LAW_HOOKE, 0.5, 0.5), &mesh, 1, 1);
    remove(file);
    const double x[5] = {0.0, 0.1, 2.0, 3.0, 3.95};
    for (int i = 0; i < 5; i++)
        world_add(&w, x[i], i == 1 ? 0.0 : 1.0, 1.49, 0.5, 1.0);
    world_rebuild(&w, NULL);
    world_forces(&w, 0.0);
    const double side[5] = {1e4 * 0.4, 1e4 * 0.3, 0.0, 0.0, 1e4 * 0.45};
    for (int i = 0; i < 5; i++) {
        assert_near(world_force(&w, (size_t)i)[2], 100.0, 1e-7);
        assert_near(world_force(&w, (size_t)i)[0], side[i], 1e-7);
        assert_near(world_force(&w, (size_t)i)[1], 0.0, 1e-7);
    }
    assert_int_equal(w.sums.contacts, 8);
    world_close(&w);
}

/* A finite tube along a periodic direction, as long as the box or nearly: one tube, whose seam is not felt.
 */
static void test_seam(void **state) {
    (void)state;
    const double length[5] = {3.9999, 4.0, 4.0001, 5.0, 7.9}, z[6] = {0.0, 3e-5, 0.1, 1.0, 2.0, 3.95};
    struct box box = hand_box(4.0);
    box.periodic[2] = true;
    for (int k = 0; k < 5; k++) {
        struct wall_options tube = {.name = "tube", .shape = WALL_CYLINDER, .point = {2, 2, 2}};
        struct world w;
        tube.axis[2] = 1.0;
        tube.radius = 1.5;
        tube.length = length[k];
        tube.inside = true;
        world_open(&w, box, hand_law(LAW_HOOKE, 0.5, 0.0), &tube, 1, 1);
        for (int i = 0; i < 6; i++)
            world_add(&w, 3.05, 2.0, z[i], 0.5, 1.0);
        world_rebuild(&w, NULL);
        world_forces(&w, 0.0);
        for (int i = 0; i < 6; i++) {
            assert_near(world_force(&w, (size_t)i)[0], -1e4 * 0.05, 0.1);
            assert_near(world_force(&w, (size_t)i)[2], 0.0, 0.1);
        }
        assert_int_equal(w.sums.contacts, 6);
        world_close(&w);
    }
}

/* Beyond a plane the force grows on; a sphere in free flight costs nothing and feels nothing. */
static void test_deep(void **state) {
    (void)state;
    struct wall_options plane = hand_plane(0, 0, 1, 0, 0, 1);
    struct world w;
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 1.0, 0.5), &plane, 1, 1);
    world_add(&w, 2, 2, 0.2, 0.5, 1.0);
    world_add(&w, 2, 2, 2.0, 0.5, 1.0);
    world_rebuild(&w, NULL);
    world_forces(&w, 1e-4);
    assert_near(world_force(&w, 0)[2], 1e4 * 1.3, 1e-8);
    assert_true(world_force(&w, 1)[2] == 0.0);
    assert_near(w.sums.overlap_max, 2.6, 1e-14);
    assert_int_equal(w.sums.overlap_id[0], 1);
    assert_int_equal(w.sums.overlap_id[1], -1);
    assert_string_equal(walls_options(w.walls, 0)->name, "plane");
    assert_int_equal(walls_count(w.walls), 1);
    world_close(&w);
}

/* What is said of a place before anything is there agrees with what is felt by a sphere put there. */
static void test_overlap(void **state) {
    (void)state;
    enum { SPHERES = 2000 };
    char file[64];
    static const char plate[] = "0.2 0.2 0.5 0.8 0.2 0.5 0.8 0.8 0.6\n0.2 0.2 0.5 0.8 0.8 0.6 0.2 0.8 0.6\n";
    struct wall_options wall[3] = {hand_plane(0, 0, 0.1, 0.1, 0, 1),
                                   {.name = "pipe",
                                    .shape = WALL_CYLINDER,
                                    .point = {0.5, 0.5, 0.5},
                                    .axis = {0, 0, 1},
                                    .radius = 0.45,
                                    .inside = true},
                                   hand_mesh(hand_file(file, "plate", plate, sizeof plate - 1))};
    wall[2].motions = 1;
    wall[2].motion[0] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {0, 0.1, 0.2}};
    struct world w;
    unsigned seed = 3;
    world_open(&w, hand_box(1.0), hand_law(LAW_HERTZ, 0.5, 0.3), wall, 3, 1);
    unlink(file);
    walls_advance(w.walls, 0.0, 0.5, no_force);
    for (int k = 0; k < SPHERES; k++) {
        double x = hand_random(&seed), y = hand_random(&seed), z = hand_random(&seed);
        world_add(&w, x, y, z, 0.01 + 0.04 * hand_random(&seed), 1.0);
    }
    world_build(&w);
    struct force_contact *contact;
    size_t contacts = walls_contacts(w.walls, &w.context, &contact), overlaps = 0;
    static bool felt[SPHERES + 1];
    for (size_t k = 0; k < contacts; k++)
        felt[contact[k].id_i] = true;
    for (size_t k = 0; k < w.particles->owned; k++) {
        const struct particle_state *s = &w.particles->state[k];
        bool overlap = walls_overlap(w.walls, s->x, s->radius);
        assert_int_equal(overlap, felt[w.particles->id[k]]);
        overlaps += overlap;
    }
    assert_in_range(overlaps, SPHERES / 10, 9 * SPHERES / 10);
    memory_free(contact);
    world_close(&w);
}

static void refuse(struct wall_options wall, const char *words) {
    struct walls *walls;
    struct error error = {0};
    struct box box = hand_box(4.0);
    OWN_LAW law = hand_law(LAW_HOOKE, 1.0, 0.0);
    assert_false(walls_create(&walls, &wall, 1, &law, &box, 1, &error, NULL));
    assert_null(walls);
    assert_int_equal(error.kind, ERROR_USER);
    if (strstr(error.text, words) == NULL)
        fail_msg("'%s' lacks '%s'", error.text, words);
}

static void test_refused(void **state) {
    (void)state;
    refuse(hand_plane(0, 0, 0, 0, 0, 0), "wall 'plane': its normal has no length");
    refuse((struct wall_options){.name = "c", .shape = WALL_CYLINDER, .axis = {1, 0, 0}}, "a radius above 0");
    refuse(hand_mesh("no/such.stl"), "no/such.stl: cannot be opened");
    struct wall_options none = hand_mesh("x");
    none.scale = 0.0;
    refuse(none, "wall 'mesh': scale is 0");
}

TEST_MAIN(wall, cmocka_unit_test(test_impact), cmocka_unit_test(test_oblique),
          cmocka_unit_test(test_plane_and_meshes), cmocka_unit_test(test_box), cmocka_unit_test(test_ridge),
          cmocka_unit_test(test_periodic), cmocka_unit_test(test_seam), cmocka_unit_test(test_deep),
          cmocka_unit_test(test_overlap), cmocka_unit_test(test_refused))
