/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains that the fluid moves: what they displace, their added mass, buoyancy, and the steps of the fluid. */
#include "tests/test.h"

#include <math.h>

#include "engine/clock.h"
#include "tests/near.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/fluid_state.h"

struct room {
    struct fluid_options options;
    struct box box;
    struct clock clock;
    struct scene scene;
    struct fluid fluid;
    struct physics_context context;
};

static void room_make(struct room *r, int dimension) {
    *r = (struct room){.options = {.density = 1200},
                       .box = {.dimension = dimension, .edge = {1, 1, 1}},
                       .clock = {.step = 12, .dt = 0.25},
                       .scene = {.gravity = {0, 0, -10}}};
    r->options.grains.motion = FLUID_GRAINS_FREE;
    r->options.grains.every = 4;
    r->options.grains.unresolved = NAN;
    r->fluid.options = &r->options;
    r->context = (struct physics_context){
        .self = &r->fluid, .options = &r->options, .scene = &r->scene, .box = &r->box, .clock = &r->clock};
}

/* 4 pi R^3 / 3 and half its mass; of a disc pi R^2 and all of it. */
static void what_a_grain_displaces(void **state) {
    struct room r;
    (void)state;
    room_make(&r, 3);
    assert_near(grain_displaced(&r.context, 0.5), M_PI / 6, 1e-15);
    assert_near(grain_added(&r.context, 0.5), 1200 * M_PI / 12, 1e-10);
    room_make(&r, 2);
    assert_near(grain_displaced(&r.context, 0.5), M_PI / 4, 1e-15);
    assert_near(grain_added(&r.context, 0.5), 1200 * M_PI / 4, 1e-10);
}

/* The fluid steps every fourth step of the grains, by four steps; where it moves no grain, in each. */
static void the_fluid_has_longer_steps(void **state) {
    struct room r;
    (void)state;
    room_make(&r, 3);
    assert_true(grain_free(&r.options));
    assert_int_equal(grain_every(&r.context), 4);
    assert_near(grain_dt(&r.context), 1, 0);
    for (r.clock.step = 12; r.clock.step < 21; r.clock.step++)
        assert_int_equal(grain_due(&r.context), r.clock.step % 4 == 0);
    r.options.grains.motion = FLUID_GRAINS_GIVEN;
    assert_true(!grain_free(&r.options) && grain_due(&r.context));
    assert_int_equal(grain_every(&r.context), 1);
    r.options.grains.unresolved = 0.1; /* small grains take part, whatever large ones do */
    assert_int_equal(grain_every(&r.context), 4);
    assert_true(unresolved_is(&r.options, 0.1) && !unresolved_is(&r.options, 0.11));
}

/* Buoyancy -rho V g and V times the force of the drive. */
static void a_grain_floats(void **state) {
    struct room r;
    struct particles *p = particles_create(1);
    double push[3];
    (void)state;
    room_make(&r, 3);
    r.context.particles = p;
    size_t i = particles_append(p);
    p->state[i].radius = 0.5;
    r.fluid.drive.force[0] = 3;
    grain_push(&r.context, i, push);
    assert_near(push[0], M_PI / 6 * 3, 1e-12);
    assert_near(push[1], 0, 0);
    assert_near(push[2], M_PI / 6 * 12000, 1e-8);
    r.box.dimension = 2;
    grain_push(&r.context, i, push);
    assert_near(push[0], M_PI / 4 * 3, 1e-12);
    assert_near(push[2], 0, 0);
    particles_destroy(&p);
}

TEST_MAIN(fluid_grain_coupling, cmocka_unit_test(what_a_grain_displaces),
          cmocka_unit_test(the_fluid_has_longer_steps), cmocka_unit_test(a_grain_floats))
