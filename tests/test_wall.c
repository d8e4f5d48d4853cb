/* Walls in the step: closed forms, planes against meshes, histories, motions, servo, threads, resume. */
#include "contact/wall.h"
#include "contact/law_kernel.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include "near.h"
#include "mesh_by_hand.h"

static const double no_force[1][3] = {{0.0, 0.0, 0.0}};

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
        static struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX];
        pair[0][0].restitution = pair[0][1].restitution = pair[1][1].restitution = 1.0;
        options.tangential = LAW_FRICTIONLESS;
        must(law_prepare(&law, &options, 2, material, pair, &error), &error);
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
    world_open(&w, hand_box(1.0), hand_law(LAW_HERTZ, 0.8, 0.1), &plane, 1, 1);
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
    assert_near(w.particles->omega[0][1], 2.5 * 0.1 * 1.8 * 0.05 / 0.01, 0.015);
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
    w.particles->omega[0][0] = 3.0;
    w.motion.gravity[2] = -9.81;
    w.motion.dt = normal == LAW_HOOKE ? 5e-4 : 2e-5;
    world_build(&w);
    for (int n = 0; n < TRACK; n++) {
        for (int inner = 0; inner < (normal == LAW_HOOKE ? 1 : 25); inner++)
            world_step(&w, n % 10 == 0 && inner == 0, NULL);
        memcpy(track[n], w.particles->state[0].x, 3 * sizeof(double));
        memcpy(track[n] + 3, w.particles->omega[0], 3 * sizeof(double));
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
                assert_near(w[0].particles->omega[i][c], w[1].particles->omega[i][c], 1e-8);
            }
    }

    assert_true(contacts > 50000 && most > 20);
    world_close(&w[0]);
    world_close(&w[1]);
}

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

/* Every shape: the force on the wall is what the particles give, its torque about the centre agrees with the
 * contacts, and the contact list says the same. */
static void test_sums(void **state) {
    (void)state;
    struct wall_options wall[3] = {hand_plane(0, 5.5, 1, 0, 0.6, 0.8),
                                   {.name = "tube", .shape = WALL_CYLINDER}};
    char file[64];
    struct hand_text t = text_new();
    text_cube(&t, 1.0, 7.0, 2);
    wall[1].point[0] = wall[1].point[1] = wall[1].point[2] = 4.0;
    wall[1].axis[1] = 2.0;
    wall[1].radius = 2.5;
    wall[1].inside = true;
    wall[2] = hand_mesh(text_file(&t, file, "sums"));
    struct world w;
    struct law law = hand_law(LAW_HERTZ, 0.7, 0.3);
    law.options.synchronised = false; /* then the list repeats the forces exactly */
    world_open(&w, hand_box(8.0), law, wall, 3, 2);
    remove(file);
    unsigned seed = 4;
    for (int i = 0; i < 3000; i++) {
        double x[3];
        for (int d = 0; d < 3; d++)
            x[d] = 1.2 + 5.6 * hand_random(&seed);
        bool deep = 0.6 * (x[1] - 5.5) + 0.8 * (x[2] - 1.0) < 0.2 || hypot(x[0] - 4.0, x[2] - 4.0) > 2.4;
        if (deep)
            continue;
        struct particle_state *s = world_add(&w, x[0], x[1], x[2], 0.4, 0.3);
        for (int d = 0; d < 3; d++)
            s->v[d] = hand_random(&seed) - 0.5;
    }
    world_build(&w);
    world_forces(&w, 1e-4);
    double on_wall[3][6], sum[3][6] = {{0}}, on_particles[3] = {0};
    struct force_contact *contact;
    size_t n = walls_contacts(w.walls, &w.context, &contact);
    walls_forces(w.walls, on_wall);
    assert_int_equal(n, w.sums.contacts);
    assert_int_equal(2 * n, w.sums.contact_sides);
    for (size_t k = 0; k < n; k++) {
        int i = (int)contact[k].id_i - 1, id = (int)-contact[k].id_j - 1;
        const double *c = contact[k].normal, *f = contact[k].force, *x = w.particles->state[i].x;
        struct wall_pose pose;
        walls_pose(w.walls, id, &pose);
        double lever = 0.4 - 0.5 * contact[k].overlap, arm[3];
        assert_near(hand_length(c), 1.0, 1e-14);
        for (int d = 0; d < 3; d++)
            arm[d] = x[d] + lever * c[d] - pose.centre[d];
        for (int d = 0; d < 3; d++) {
            sum[id][d] += f[d];
            sum[id][3 + d] += arm[(d + 1) % 3] * f[(d + 2) % 3] - arm[(d + 2) % 3] * f[(d + 1) % 3];
        }
    }
    for (size_t i = 0; i < w.particles->owned; i++)
        for (int d = 0; d < 3; d++)
            on_particles[d] += world_force(&w, i)[d];
    for (int id = 0; id < 3; id++)
        for (int d = 0; d < 6; d++)
            assert_near(on_wall[id][d], sum[id][d], 1e-9 * (1.0 + fabs(sum[id][d])));
    for (int d = 0; d < 3; d++)
        assert_near(on_wall[0][d] + on_wall[1][d] + on_wall[2][d], -on_particles[d], 1e-8);
    assert_true(n > 300 && hand_length(on_wall[0]) > 0.0 && hand_length(on_wall[1]) > 0.0);
    memory_free(contact);
    world_close(&w);
}

/* A world of many spheres on a slope of triangles and a plane, which shakes. */
static void open_many(struct world *w, const char *file, int threads) {
    struct wall_options wall[2] = {hand_mesh(file), hand_plane(0, 0, 1.2, 0, 0, 1)};
    wall[0].motions = 1;
    wall[0].motion[0] = (struct wall_motion){.kind = WALL_OSCILLATE_ROTATION,
                                             .stop = INFINITY,
                                             .direction = {0, 1, 0},
                                             .point = {4, 4, 2},
                                             .amplitude = 0.004,
                                             .frequency = 10.0};
    world_open(w, hand_box(8.0), hand_law(LAW_HERTZ, 0.5, 0.6), wall, 2, threads);
    unsigned seed = 8;
    for (int i = 0; i < 300; i++) {
        double x = 2.0 + 4.0 * hand_random(&seed), y = 2.0 + 4.0 * hand_random(&seed);
        double z =
            1.5 + (x < 4.0 ? 0.4 * (x - 1.0) / 3.0 : 0.4 - 0.5 * (x - 4.0) / 3.0) + 0.2 * (y - 1.0) / 6.0;
        double r = 0.1 + 0.3 * hand_random(&seed);
        world_add(w, x, y, z + 1.02 * r + 0.002, r, 0.2);
    }
    w->motion.gravity[2] = -9.81;
    world_build(w);
}

static const char *slope_file(char file[64]) {
    struct hand_text t = text_new();
    double o[3] = {1, 1, 1.5}, a[3] = {3, 0, 0.4}, b[3] = {0, 6, 0.2}, middle[3] = {4, 1, 1.9},
           c[3] = {3, 0, -0.5};
    text_plate(&t, o, a, b, 9, 9, 0.5);
    text_plate(&t, middle, c, b, 9, 9, 0.5);
    return text_file(&t, file, "many");
}

static void assert_same(const struct world *a, const struct world *b, const uint32_t *at) {
    for (size_t i = 0; i < a->particles->owned; i++) {
        size_t j = at ? at[i] : i;
        assert_int_equal(a->particles->id[j], b->particles->id[i]);
        assert_memory_equal(a->particles->state[j].x, b->particles->state[i].x, 3 * sizeof(double));
        assert_memory_equal(a->particles->omega[j], b->particles->omega[i], 3 * sizeof(double));
    }
}

/* The same bits for any number of threads. */
static void test_threads(void **state) {
    (void)state;
    char file[64];
    struct world w[3];
    slope_file(file);
    for (int k = 0; k < 3; k++)
        open_many(&w[k], file, 1 << k);
    size_t contacts = 0;
    for (int n = 0; n < 1000; n++)
        for (int k = 0; k < 3; k++) {
            world_step(&w[k], n % 20 == 0, NULL);
            contacts += w[k].sums.contacts;
        }
    for (int k = 1; k < 3; k++)
        assert_same(&w[0], &w[k], NULL);
    assert_true(contacts > 30000);
    assert_near(walls_work(w[0].walls), walls_work(w[2].walls), 1e-9 * fabs(walls_work(w[0].walls)));
    for (int k = 0; k < 3; k++)
        world_close(&w[k]);
    remove(file);
}

/* Histories survive rebuilds and reorders: the same bits as with other rebuilds. */
static void test_reorder(void **state) {
    (void)state;
    char file[64];
    struct world w[2];
    slope_file(file);
    open_many(&w[0], file, 1);
    open_many(&w[1], file, 2);
    uint32_t order[300], at[300];
    for (uint32_t i = 0; i < 300; i++) {
        order[i] = (i * 7 + 3) % 300;
        at[i] = i;
    }
    for (int n = 0; n < 1200; n++) {
        world_step(&w[0], n % 20 == 0, NULL);
        world_step(&w[1], false, NULL);
        if (n % 13 == 0) {
            uint32_t next[300];
            world_rebuild(&w[1], order);
            for (int i = 0; i < 300; i++)
                next[i] = at[order[i]];
            memcpy(at, next, sizeof at);
        }
    }
    assert_same(&w[0], &w[1], at);
    world_close(&w[0]);
    world_close(&w[1]);
    remove(file);
}

/* Rows follow removed particles too. */
static void test_rows(void **state) {
    (void)state;
    char file[64];
    struct world w;
    struct wall_rows rows;
    uint8_t remove_flag[300];
    slope_file(file);
    open_many(&w, file, 1);
    for (int n = 0; n < 1500; n++)
        world_step(&w, n % 20 == 0, NULL);
    walls_detach(w.walls, w.particles, &rows);
    assert_true(rows.count > 50);
    size_t left = 0;
    for (int i = 0; i < 300; i++) {
        remove_flag[i] = i % 3 == 1;
        left += remove_flag[i] ? 0 : rows.start[i + 1] - rows.start[i];
    }
    wall_rows_remove(&rows, remove_flag, 300);
    particles_remove(w.particles, remove_flag);
    assert_int_equal(rows.count, left);
    for (size_t i = 0; i < w.particles->owned; i++)
        for (size_t r = rows.start[i]; r < rows.start[i + 1]; r++)
            assert_int_equal(rows.row[r].id, w.particles->id[i]);
    rows.row[0].wall = 7; /* of a wall and of a patch that no longer exist */
    rows.row[1].patch = 1000000;
    walls_build(w.walls, w.particles, &w.classes);
    walls_attach(w.walls, &rows, w.particles);
    struct wall_rows again;
    walls_detach(w.walls, w.particles, &again);
    assert_int_equal(again.count, rows.count - 2);
    assert_memory_equal(again.row + again.count - 1, rows.row + rows.count - 1, sizeof *rows.row);
    wall_rows_free(&rows);
    wall_rows_free(&again);
    assert_null(rows.row);
    world_close(&w);
    remove(file);
}

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

/* Work and losses add up: spheres on the shaking slope. */
static void test_energy(void **state) {
    (void)state;
    char file[64];
    struct world w;
    slope_file(file);
    open_many(&w, file, 1);
    w.motion.dt = 2e-5;
    double energy[2], dissipated = 0.0;
    for (int n = 0; n <= 5000; n++) {
        double sum = w.sums.elastic_normal + w.sums.elastic_tangential;
        for (size_t i = 0; i < w.particles->owned; i++) {
            double v[3], omega[3], r = w.particles->state[i].radius;
            integrator_full_step(w.particles, &w.motion, i, v, omega);
            sum += 0.1 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 0.2 * 9.81 * w.particles->state[i].x[2] +
                   0.04 * r * r * (omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
        }
        energy[n > 0] = sum;
        if (n == 5000)
            break;
        world_step(&w, n % 100 == 0, NULL);
        dissipated += w.sums.dissipated;
    }
    double work = walls_work(w.walls);
    assert_true(dissipated > 2.0 && work > 2.0);
    assert_near(energy[1], energy[0] + work - dissipated, 0.01 * dissipated);
    world_close(&w);
    remove(file);
}

/* A plate with a servo lies down on a sphere and presses with the force that it should. */
static void test_servo(void **state) {
    (void)state;
    struct wall_options wall[2] = {hand_plane(0, 0, 1, 0, 0, 1), hand_plane(0, 0, 2.1, 0, 0, -1)};
    struct world w;
    wall[1].motions = 1;
    wall[1].motion[0] = (struct wall_motion){.kind = WALL_SERVO,
                                             .stop = INFINITY,
                                             .direction = {0.0, 0.0, 1.0},
                                             .force = 25.0,
                                             .speed_max = 0.2,
                                             .gain = 0.05};
    world_open(&w, hand_box(4.0), hand_law(LAW_HOOKE, 0.3, 0.5), wall, 2, 1);
    world_add(&w, 2, 2, 1.5, 0.5, 1.0);
    world_build(&w);
    assert_true(walls_have_servo(w.walls));
    for (int n = 0; n < 50000; n++) {
        double force[2][6], servo[2][3];
        walls_forces(w.walls, force);
        for (int k = 0; k < 2; k++)
            memcpy(servo[k], force[k], sizeof servo[k]);
        world_step(&w, n % 100 == 0, servo);
    }
    double force[2][6];
    struct wall_pose pose;
    walls_forces(w.walls, force);
    walls_pose(w.walls, 1, &pose);
    assert_near(force[1][2], 25.0, 0.01);
    assert_near(force[0][2], -25.0, 0.01);
    assert_near(pose.translation[2], -0.1 - 2.0 * 25.0 / 1e4, 1e-5);
    assert_near(pose.servo_offset, pose.translation[2], 1e-15);
    world_close(&w);
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
    /* 40 long: ten times around; a sphere that rolls takes 2/7 of the speed */
    for (size_t i = 0; i < 4; i++) {
        assert_near(w.particles->state[i].v[0], 20.0 * 2.0 / 7.0, 0.02);
        assert_near(w.particles->state[i].v[2], 0.0, 1e-3);
    }
    world_close(&w);
}

static struct wall_options moving_plate(double x, double rate) {
    struct wall_options plane = hand_plane(2, 2, 1, 0, 0, 1);
    plane.motions = 2;
    plane.motion[0] = (struct wall_motion){.kind = WALL_ROTATE,
                                           .stop = INFINITY,
                                           .direction = {0.0, 1.0, 0.0},
                                           .point = {2, 2, 1},
                                           .rate = rate};
    plane.motion[1] =
        (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {x, 0.0, 0.3}};
    return plane;
}

/* A pose that is set goes on bitwise with the same motions, and without a jump with others. */
static void test_resume(void **state) {
    (void)state;
    struct wall_options same = moving_plate(0.1, 0.7), other = moving_plate(-5.0, -3.0);
    struct world a, b, c;
    struct law law = hand_law(LAW_HOOKE, 0.5, 0.5);
    double dt = 1e-3, t;
    struct wall_pose pose, again, changed;
    world_open(&a, hand_box(4.0), law, &same, 1, 1);
    world_open(&b, hand_box(4.0), law, &same, 1, 1);
    world_open(&c, hand_box(4.0), law, &other, 1, 1);
    for (int n = 0; n < 777; n++)
        walls_advance(a.walls, n * dt, dt, NULL);
    t = 777 * dt;
    walls_pose(a.walls, 0, &pose);
    walls_set_pose(b.walls, 0, &pose);
    walls_set_pose(c.walls, 0, &pose);
    for (int n = 777; n < 900; n++) {
        walls_advance(a.walls, n * dt, dt, NULL);
        walls_advance(b.walls, n * dt, dt, NULL);
    }
    walls_pose(a.walls, 0, &pose);
    walls_pose(b.walls, 0, &again);
    assert_memory_equal(&pose, &again, sizeof pose);
    walls_pose(c.walls, 0, &pose);
    walls_advance(c.walls, t, 1e-9, NULL);
    walls_pose(c.walls, 0, &changed);
    for (int d = 0; d < 3; d++)
        assert_near(changed.translation[d], pose.translation[d], 1e-7);
    for (int d = 0; d < 9; d++)
        assert_near(changed.rotation[d], pose.rotation[d], 1e-7);
    assert_near(changed.omega[1], -3.0, 1e-9);
    /* and once more, from the changed run */
    walls_set_pose(b.walls, 0, &pose);
    walls_advance(c.walls, t + 1e-9, dt, NULL);
    walls_pose(c.walls, 0, &pose);
    struct world d;
    world_open(&d, hand_box(4.0), law, &other, 1, 1);
    walls_set_pose(d.walls, 0, &pose);
    walls_advance(c.walls, t + 1e-9 + dt, dt, NULL);
    walls_advance(d.walls, t + 1e-9 + dt, dt, NULL);
    walls_pose(c.walls, 0, &pose);
    walls_pose(d.walls, 0, &again);
    assert_memory_equal(&pose, &again, sizeof pose);
    world_close(&a);
    world_close(&b);
    world_close(&c);
    world_close(&d);
}

/* How far walls have moved, for the decision to rebuild. */
static void test_displacement(void **state) {
    (void)state;
    struct wall_options wall = hand_plane(1, 1, 1, 0, 0, 1), tube = {.name = "tube", .shape = WALL_CYLINDER};
    struct law law = hand_law(LAW_HOOKE, 0.5, 0.5);
    struct world w;
    wall.motions = 1; /* within itself */
    wall.motion[0] = (struct wall_motion){.kind = WALL_TRANSLATE, .stop = INFINITY, .velocity = {3, 4, 0}};
    world_open(&w, hand_box(4.0), law, &wall, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    tube.axis[2] = 1.0;
    tube.radius = 1.0;
    tube.motions = 1; /* about its own axis */
    tube.motion[0] =
        (struct wall_motion){.kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 0, 1}, .rate = 3.0};
    world_open(&w, hand_box(4.0), law, &tube, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    tube.point[0] = 0.5; /* about another */
    world_open(&w, hand_box(4.0), law, &tube, 1, 1);
    walls_advance(w.walls, 0.0, 0.1, NULL);
    assert_near(walls_displacement(w.walls), 2.0 * 0.5 * sin(0.15), 1e-15);
    world_rebuild(&w, NULL);
    assert_near(walls_displacement(w.walls), 0.0, 1e-15);
    world_close(&w);
    wall.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .direction = {0, 1, 0}, .point = {1, 1, 1}, .rate = 1.0};
    world_open(&w, hand_box(4.0), law, &wall, 1, 1); /* a corner at x = 4: 3 away */
    walls_advance(w.walls, 0.0, 1e-3, NULL);
    assert_near(walls_displacement(w.walls), 3e-3, 2e-6);
    world_close(&w);
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
    assert_true(walls_memory(w.walls) > 0);
    assert_string_equal(walls_options(w.walls, 0)->name, "plane");
    assert_int_equal(walls_count(w.walls), 1);
    world_close(&w);
}

static void refuse(struct wall_options wall, const char *words) {
    struct walls *walls;
    struct error error = {0};
    struct box box = hand_box(4.0);
    struct law law = hand_law(LAW_HOOKE, 1.0, 0.0);
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_impact),
                                       cmocka_unit_test(test_oblique),
                                       cmocka_unit_test(test_plane_and_meshes),
                                       cmocka_unit_test(test_box),
                                       cmocka_unit_test(test_spring_round_an_edge),
                                       cmocka_unit_test(test_ridge),
                                       cmocka_unit_test(test_sums),
                                       cmocka_unit_test(test_threads),
                                       cmocka_unit_test(test_reorder),
                                       cmocka_unit_test(test_rows),
                                       cmocka_unit_test(test_piston),
                                       cmocka_unit_test(test_energy),
                                       cmocka_unit_test(test_servo),
                                       cmocka_unit_test(test_drum),
                                       cmocka_unit_test(test_periodic),
                                       cmocka_unit_test(test_conveyor),
                                       cmocka_unit_test(test_resume),
                                       cmocka_unit_test(test_displacement),
                                       cmocka_unit_test(test_deep),
                                       cmocka_unit_test(test_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
