/* SPDX-License-Identifier: BSD-3-Clause */
/* Integrators: closed forms of single particles, and a contact through the force loop. */
#include "tests/test.h"

#include "physics/grains/batch/force.h"
#include "physics/grains/motion/integrator.h"
#include "tests/physics/grains/pairs_by_hand.h"
#include "tests/fields_by_hand.h"
#include "tests/own_law.h"
#include "tests/near.h"

static const double tau = 0.3; /* length of the runs, time */

static struct integrator_context context_for(double dt, int dimension) {
    return (struct integrator_context){.dt = dt, .dimension = dimension, .groups = 1};
}

/* `count` unit spheres of mass 2 far from each other, at rest. */
static struct particles *spheres(size_t count, unsigned features) {
    struct particles *p = particles_with(features, count);
    for (size_t k = 0; k < count; k++) {
        particles_append(p);
        p->state[k].x[0] = 10.0 * (double)k;
        p->state[k].radius = 1.0;
        p->state[k].inverse_mass = 0.5;
        p->id[k] = (int64_t)k + 1;
    }
    return p;
}

static double *force_of(struct particles *p, size_t k) {
    return p->force + k * (size_t)p->force_stride;
}

static void test_names(void **state) {
    (void)state;
    assert_int_equal(integrator_count(), 2);
    assert_true(integrator_find("synchronised_verlet")->synchronised);
    assert_false(integrator_find("velocity_verlet")->synchronised);
    assert_null(integrator_find("verlet"));
    assert_string_equal(integrator_get(0)->name, "synchronised_verlet");
}

/* Constant force, torque and gravity: exact but for rounding, position and full-step velocity; forces come
 * out zero. */
static void test_constant_force(void **state) {
    (void)state;
    struct particles *p = spheres(3, WITH_SPIN);
    struct integrator_context context = context_for(0.01, 3);
    context.gravity[2] = -9.81;
    p->state[1].v[0] = 2.0;
    p->state[1].v[2] = 1.0;
    spin_of(p)[1][1] = 3.0;
    for (int n = 0; n <= 100; n++) {
        if (n > 0) {
            double v2 = integrator_advance(p, &context, 0, 3);
            const double *v = p->state[1].v, *other = p->state[0].v;
            double own = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            assert_near(v2, fmax(own, other[2] * other[2]), 1e-12);
            for (int c = 0; c < 8; c++)
                assert_true(force_of(p, 1)[c] == 0.0);
        }
        force_of(p, 1)[1] = 6.0;
        force_of(p, 1)[5] = 0.8; /* torque about y; inertia 2/5 m r^2 = 0.8 */
        if (n == 0)
            integrator_stagger(p, &context, 0, 3);
        double t = 0.01 * n, v[3], w[3];
        integrator_full_step(p, &context, 1, v, w);
        assert_near(p->state[1].x[0], 10.0 + 2.0 * t, 1e-12);
        assert_near(p->state[1].x[1], 1.5 * t * t, 1e-12);
        assert_near(p->state[1].x[2], t - 0.5 * 9.81 * t * t, 1e-12);
        assert_near(v[1], 3.0 * t, 1e-12);
        assert_near(v[2], 1.0 - 9.81 * t, 1e-12);
        assert_near(w[1], 3.0 + t, 1e-12);
    }
    particles_destroy(&p);
}

/* A pass works on its range alone, so passes of blocks make the whole. */
static void test_ranges(void **state) {
    (void)state;
    struct particles *whole = spheres(10, 0), *parts = spheres(10, 0);
    struct integrator_context context = context_for(0.1, 3);
    for (size_t k = 0; k < 10; k++)
        for (int c = 0; c < 3; c++)
            force_of(whole, k)[c] = force_of(parts, k)[c] = (double)k + c;
    double all = integrator_advance(whole, &context, 0, 10);
    double first = integrator_advance(parts, &context, 0, 4),
           last = integrator_advance(parts, &context, 4, 10);
    assert_true(first < last && last == all);
    assert_memory_equal(whole->state, parts->state, 10 * sizeof *whole->state);
    parts->state[2].v[1] = NAN;
    assert_true(isnan(integrator_advance(parts, &context, 0, 10)));
    particles_destroy(&whole);
    particles_destroy(&parts);
}

/* Frozen and moving groups keep their motion under any force; free ones do not. */
static void test_prescribed(void **state) {
    (void)state;
    struct particles *p = spheres(3, WITH_SPIN | WITH_GROUP);
    struct integrator_context context = context_for(0.01, 3);
    context.groups = 3;
    context.gravity[2] = -10.0;
    context.motion[1].prescribed = true;
    context.motion[2] = (struct integrator_motion){true, {1.0, 0.0, -2.0}, {0.0, 5.0, 0.0}};
    for (size_t k = 0; k < 3; k++) {
        groups_of(p)[k] = (uint8_t)k;
        p->state[k].inverse_mass = k ? 0.0 : 0.5;
    }
    p->state[0].v[1] = p->state[1].v[1] = spin_of(p)[1][2] =
        3.0; /* of no consequence where it is prescribed */
    integrator_prescribe(p, &context);
    assert_true(p->state[0].v[1] == 3.0 && p->state[1].v[1] == 0.0 && spin_of(p)[1][2] == 0.0);
    assert_true(p->state[2].v[0] == 1.0 && p->state[2].v[2] == -2.0 && spin_of(p)[2][1] == 5.0);
    integrator_stagger(p, &context, 0, 3);
    for (int n = 0; n < 10; n++) {
        for (size_t k = 0; k < 3; k++)
            force_of(p, k)[0] = force_of(p, k)[4] = 7.0;
        integrator_advance(p, &context, 0, 3);
    }
    double v[3], w[3];
    assert_true(p->state[0].x[2] < -1e-3 && spin_of(p)[0][0] > 0.1);
    assert_true(p->state[1].x[0] == 10.0 && p->state[1].x[2] == 0.0 && spin_of(p)[1][0] == 0.0);
    assert_near(p->state[2].x[0], 20.0 + 0.1, 1e-13);
    assert_near(p->state[2].x[2], -0.2, 1e-13);
    integrator_full_step(p, &context, 2, v, w);
    assert_true(v[2] == -2.0 && w[1] == 5.0 && w[0] == 0.0);
    particles_destroy(&p);
}

/* Energies of a range: those of the full-step velocities of its free particles. */
static void test_energies(void **state) {
    (void)state;
    struct particles *p = spheres(4, WITH_SPIN);
    struct integrator_context context = context_for(0.1, 3);
    double energy[2] = {0.0, 0.0}, v[3], w[3];
    context.gravity[2] = -1.0;
    for (size_t k = 0; k < 4; k++) {
        p->state[k].v[1] = (double)k;
        spin_of(p)[k][2] = 2.0;
        force_of(p, k)[0] = force_of(p, k)[5] = 3.0;
    }
    p->state[2].inverse_mass = 0.0;
    integrator_energies(p, &context, 1, 4, energy);
    double kinetic = 0.0, rotational = 0.0;
    for (size_t k = 1; k < 4; k += 2) { /* mass 2, inertia 0.8 */
        integrator_full_step(p, &context, k, v, w);
        kinetic += v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        rotational += 0.4 * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
    assert_near(energy[0], kinetic, 1e-12);
    assert_near(energy[1], rotational, 1e-12);
    assert_true(kinetic > 10.0 && rotational > 3.2);
    particles_destroy(&p);
}

/* In 2D nothing moves in z, whatever pulls. */
static void test_two_dimensions(void **state) {
    (void)state;
    struct particles *p = spheres(2, 0);
    struct integrator_context context = context_for(0.1, 2);
    context.gravity[1] = context.gravity[2] = -1.0;
    p->state[1].x[2] = 0.5;
    for (int n = 0; n < 10; n++) {
        force_of(p, 1)[2] = 3.0;
        integrator_advance(p, &context, 0, 2);
    }
    assert_true(p->state[1].x[2] == 0.5 && p->state[1].v[2] == 0.0);
    assert_true(p->state[1].x[1] < -0.1);
    particles_destroy(&p);
}

/* Two spheres that overlap, with slip, through integrator and force loop: x of the second, its full-step
 * velocity and spin at time tau. */
static void run_contact(const char *name, double dt, double result[5]) {
    static struct law_pair pair[2][2];
    const struct law_material material = {"m", 1.0, 0.0, 0.0};
    struct law_options options = law_options_default();
    OWN_LAW law;
    struct error error = {0};
    options.normal = LAW_HOOKE;
    options.synchronised = integrator_find(name)->synchronised;
    pair[0][0] = (struct law_pair){.restitution = 1.0, .friction = 1e6, .k_n = 20.0, .k_t = 10.0};
    assert_true(law_prepare(&law, &options, 1, &material, pair[0], &error));
    struct particles *p = spheres(2, WITH_SPIN);
    p->state[1].x[0] = 1.8;
    p->state[0].v[1] = -0.5;
    p->state[1].v[1] = 0.7;
    spin_of(p)[1][2] = 0.9;
    struct pairlist list;
    const struct hand_options hand = {.threads = 1, .margin = 1.0};
    hand_make(&list, p, &hand);
    struct history *history = history_create(3, 1);
    struct force_loop *loop = force_loop_create(1);
    struct force_context force = {.particles = p, .list = &list, .history = history, .law = &law};
    struct integrator_context context = context_for(dt, 3);
    struct force_sums sums;
    force_loop_prepare(loop, &force);
    force_loop_run(loop, &force, &sums);
    integrator_stagger(p, &context, 0, 2);
    force.dt = dt;
    for (long n = lround(tau / dt); n > 0; n--) {
        integrator_advance(p, &context, 0, 2);
        force_loop_run(loop, &force, &sums);
    }
    assert_int_equal(sums.contacts, 1);
    double v[3], w[3];
    integrator_full_step(p, &context, 1, v, w);
    memcpy(result, (double[5]){p->state[1].x[0], p->state[1].x[1], v[0], v[1], w[2]}, 5 * sizeof *result);
    force_loop_destroy(&loop);
    history_destroy(&history);
    hand_free(&list);
    particles_destroy(&p);
}

/* In a lasting elastic contact with slip that turns, errors fall by 4 when the step is halved; the plain
 * scheme's do not, as its springs mix half and full step. */
static void test_order(void **state) {
    (void)state;
    double ratio[2];
    for (int k = 0; k < 2; k++) {
        const char *name = integrator_get(k)->name;
        double fine[5], result[3][5], error[3] = {0.0, 0.0, 0.0};
        run_contact("synchronised_verlet", tau / 6400, fine);
        for (int n = 0; n < 3; n++) {
            run_contact(name, tau / (50 << n), result[n]);
            for (int c = 0; c < 5; c++)
                error[n] = fmax(error[n], fabs(result[n][c] - fine[c]));
        }
        ratio[k] = error[1] / error[2];
        assert_true(error[2] < 1e-3 && error[2] > 1e-9);
    }
    assert_near(ratio[0], 4.0, 0.2);
    assert_true(ratio[1] < 3.0);
}

TEST_MAIN(integrator, cmocka_unit_test(test_names), cmocka_unit_test(test_constant_force),
          cmocka_unit_test(test_ranges), cmocka_unit_test(test_prescribed), cmocka_unit_test(test_energies),
          cmocka_unit_test(test_two_dimensions), cmocka_unit_test(test_order))
