/* SPDX-License-Identifier: BSD-3-Clause */
/* Histories of wall contacts: over threads, reorderings and migration, after a resume; sums and energy. */
#include "tests/test.h"

#include "physics/grains/walls/wall.h"
#include "physics/grains/laws/law_kernel.h"
#include "tests/near.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

/* Moving spheres of radius 0.4, at random wherever they do not lie deep in the walls of test_sums. */
static void add_where_not_deep(struct world *w) {
    unsigned seed = 4;
    for (int i = 0; i < 3000; i++) {
        double x[3];
        for (int d = 0; d < 3; d++)
            x[d] = 1.2 + 5.6 * hand_random(&seed);
        bool deep = 0.6 * (x[1] - 5.5) + 0.8 * (x[2] - 1.0) < 0.2 || hypot(x[0] - 4.0, x[2] - 4.0) > 2.4;
        if (deep)
            continue;
        struct particle_state *s = world_add(w, x[0], x[1], x[2], 0.4, 0.3);
        for (int d = 0; d < 3; d++)
            s->v[d] = hand_random(&seed) - 0.5;
    }
}

/* Adds what a contact gives to its wall: force, and torque about the wall's centre. */
static void add_to_wall(const struct world *w, const struct force_contact *contact, double sum[][6]) {
    int i = (int)contact->id_i - 1, id = (int)-contact->id_j - 1;
    const double *c = contact->normal, *f = contact->force, *x = w->particles->state[i].x;
    struct wall_pose pose;
    walls_pose(w->walls, id, &pose);
    double lever = 0.4 - 0.5 * contact->overlap, arm[3];
    assert_near(hand_length(c), 1.0, 1e-14);
    for (int d = 0; d < 3; d++)
        arm[d] = x[d] + lever * c[d] - pose.centre[d];
    for (int d = 0; d < 3; d++) {
        sum[id][d] += f[d];
        sum[id][3 + d] += arm[(d + 1) % 3] * f[(d + 2) % 3] - arm[(d + 2) % 3] * f[(d + 1) % 3];
    }
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
    add_where_not_deep(&w);
    world_build(&w);
    world_forces(&w, 1e-4);
    double on_wall[3][6], sum[3][6] = {{0}}, on_particles[3] = {0};
    struct force_contact *contact;
    size_t n = walls_contacts(w.walls, &w.context, &contact);
    walls_forces(w.walls, on_wall);
    assert_int_equal(n, w.sums.contacts);
    assert_int_equal(2 * n, w.sums.contact_sides);
    for (size_t k = 0; k < n; k++)
        add_to_wall(&w, &contact[k], sum);
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
        assert_memory_equal(spin_of(a->particles)[j], spin_of(b->particles)[i], 3 * sizeof(double));
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
    struct history_rows rows;
    uint8_t remove_flag[300];
    slope_file(file);
    open_many(&w, file, 1);
    for (int n = 0; n < 1500; n++)
        world_step(&w, n % 20 == 0, NULL);
    walls_detach(w.walls, w.particles, &rows);
    assert_true(rows.count > 50);
    struct history_row *row = rows.row;
    size_t left = 0;
    for (int i = 0; i < 300; i++) {
        remove_flag[i] = i % 3 == 1;
        left += remove_flag[i] ? 0 : rows.start[i + 1] - rows.start[i];
    }
    history_rows_remove(&rows, remove_flag, 300);
    particles_remove(w.particles, remove_flag);
    assert_int_equal(rows.count, left);
    for (size_t i = 0; i < w.particles->owned; i++)
        for (size_t r = rows.start[i]; r < rows.start[i + 1]; r++)
            assert_int_equal(row[r].id, w.particles->id[i]);
    row[0].partner = wall_row_partner(7, 0); /* of a wall and of a patch that no longer exist */
    row[1].partner = wall_row_partner(wall_row_wall(&row[1]), 1000000);
    walls_build(w.walls, w.particles, &w.classes);
    walls_attach(w.walls, &rows, w.particles);
    struct history_rows again;
    walls_detach(w.walls, w.particles, &again);
    assert_int_equal(again.count, rows.count - 2);
    assert_memory_equal(again.row + again.count - 1, row + rows.count - 1, sizeof *row);
    history_rows_free(&rows);
    history_rows_free(&again);
    assert_null(rows.row);
    world_close(&w);
    remove(file);
}

/* Work and losses add up: spheres on the shaking slope. */
static void test_energy(void **state) {
    (void)state;
    char file[64];
    struct world w;
    slope_file(file);
    open_many(&w, file, 1);
    w.motion.dt = 2e-5;
    double energy[2], taken = 0.0;
    for (int n = 0; n <= 5000; n++) {
        double sum = w.sums.elastic_normal;
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
        taken += w.sums.taken;
    }
    double work = walls_work(w.walls);
    assert_true(taken > 2.0 && work > 2.0);
    assert_near(energy[1], energy[0] + work - taken, 0.003 * taken);
    world_close(&w);
    remove(file);
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
    double dt = 1e-3, t;
    struct wall_pose pose, again, changed;
    world_open(&a, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &same, 1, 1);
    world_open(&b, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &same, 1, 1);
    world_open(&c, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &other, 1, 1);
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
    world_open(&d, hand_box(4.0), hand_law(LAW_HOOKE, 0.5, 0.5), &other, 1, 1);
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

/* A contact that has ended leaves the room to the one that goes on: the sphere that has parted by more than
 * the skin from one wall is a candidate of the other alone. */
static void test_one_of_two_ends(void **state) {
    (void)state;
    struct wall_options wall[2] = {hand_plane(0, 0, 0, 1, 0, 0), hand_plane(0, 0, 0, 0, 0, 1)};
    struct world w;
    world_open(&w, hand_box(8.0), hand_law(LAW_HOOKE, 1.0, 1e6), wall, 2, 1);
    struct particle_state *s = world_add(&w, 0.99, 4.0, 0.99, 1.0, 1.0);
    world_rebuild(&w, NULL);
    s->v[1] = 1.0;
    world_forces(&w, 1e-4);
    assert_int_equal(w.sums.contacts, 2);
    s->v[1] = 0.0;
    s->x[0] = 2.0;
    world_rebuild(&w, NULL);
    world_forces(&w, 1e-4);
    assert_int_equal(w.sums.contacts, 1);
    assert_near(world_force(&w, 0)[1], -2e4 / 7.0 * 1e-4, 1e-9);
    world_close(&w);
}

/* A turning cube with plates and spheres inside. With `wide` margins each sphere has other sides near, so that each contact is resolved
 * among all triangles. */
static void faces_open(struct world *w, const char *file, bool wide) {
    struct wall_options wall = hand_mesh(file);
    unsigned seed = 9;
    wall.motions = 1;
    wall.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .point = {4, 4, 4}, .direction = {0, 0.6, 0.8}, .rate = 2.0};
    world_open(w, hand_box(8.0), hand_law(LAW_HERTZ, 0.7, 0.3), &wall, 1, 2);
    for (int i = 0; i < 2000; i++) {
        struct particle_state *s = world_add(w, 4, 4, 4, 0.1 + 0.2 * hand_random(&seed), 0.3);
        for (int d = 0; d < 3; d++)
            s->x[d] += 5.8 * (hand_random(&seed) - 0.5);
    }
    world_rebuild(w, NULL);
    double margin = w->classes.margin[0][w->classes.count];
    for (int c = 0; wide && c < w->classes.count; c++)
        w->classes.margin[c][w->classes.count] = 8.0;
    walls_build(w->walls, w->particles, &w->classes);
    for (size_t i = 0; i < w->particles->owned; i++) {
        double to[3] = {hand_random(&seed) - 0.5, hand_random(&seed) - 0.5, hand_random(&seed) - 0.5};
        for (int d = 0; d < 3; d++)
            w->particles->state[i].x[d] += 0.9 * margin / hand_length(to) * to[d];
    }
}

/* Spheres above one triangle, and all of them resolved among all triangles: the same bits, wherever spheres go until the next
 * rebuild. */
static void test_faces(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    struct world a, b;
    text_cube(&t, 1.0, 7.0, 2);
    for (int k = 0; k < 5; k++) /* plates, whose rims have no other side near */
        text_plate(&t, (double[3]){2, 2, 2 + k}, (double[3]){4, 0, 0}, (double[3]){0, 4, 0}, 2, 2, 0.5);
    text_file(&t, file, "faces");
    faces_open(&a, file, false);
    faces_open(&b, file, true);
    remove(file);
    for (int n = 0; n < 4; n++) {
        world_step(&a, false, NULL);
        world_step(&b, false, NULL);
        assert_true(a.sums.contacts > 150 && a.sums.contacts == b.sums.contacts);
        assert_memory_equal(world_force(&a, 0), world_force(&b, 0),
                            a.particles->owned * (size_t)a.particles->force_stride * sizeof(double));
    }
    world_close(&a);
    world_close(&b);
}

/* The force along x on a large ball above a small plate that turns below it, after a step; the plate moves less than the margin,
 * and the foot of the ball leaves it. */
static double turned_plate(const char *file, double margin) {
    struct world w;
    struct wall_options wall = hand_mesh(file);
    wall.motions = 1;
    wall.motion[0] = (struct wall_motion){
        .kind = WALL_ROTATE, .stop = INFINITY, .point = {4, 4, 4}, .direction = {0, 1, 0}, .rate = -1300.0};
    world_open(&w, hand_box(8.0), hand_law(LAW_HOOKE, 1.0, 0.0), &wall, 1, 1);
    world_add(&w, 4.207, 3.793, 6.9, 3.0, 1.0);
    world_rebuild(&w, NULL);
    w.classes.margin[0][w.classes.count] = margin;
    walls_build(w.walls, w.particles, &w.classes);
    world_step(&w, false, NULL);
    assert_true(walls_displacement(w.walls) < 0.1 && w.sums.contacts > 0);
    double force = world_force(&w, 0)[0];
    world_close(&w);
    return force;
}

static void test_face_of_turned_plate(void **state) {
    (void)state;
    char file[64];
    struct hand_text t = text_new();
    text_plate(&t, (double[3]){3.5, 3.5, 4}, (double[3]){1, 0, 0}, (double[3]){0, 1, 0}, 1, 1, 0.0);
    text_file(&t, file, "turned");
    double near = turned_plate(file, 0.1), far = turned_plate(file, 8.0);
    remove(file);
    assert_true(near == far);
}

TEST_MAIN(wall_history, cmocka_unit_test(test_sums), cmocka_unit_test(test_threads),
          cmocka_unit_test(test_reorder), cmocka_unit_test(test_rows), cmocka_unit_test(test_one_of_two_ends),
          cmocka_unit_test(test_energy), cmocka_unit_test(test_resume), cmocka_unit_test(test_faces),
          cmocka_unit_test(test_face_of_turned_plate))
