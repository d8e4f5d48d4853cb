/* SPDX-License-Identifier: BSD-3-Clause */
/* What the surfaces and the insides of grains bring: surface_loads of a pressure and a shear, boundary_motion on a grain that turns,
 * rigid_sums of a rigid motion. */
#include "tests/test.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/coupling/boundary_motion.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/coupling/surface_loads.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/lattice/mirror.h"
#include "tests/near.h"
#include "tests/physics/fluid/fluid_cloud.h"

static const double push = 3.5, shear = 2.5, viscosity = 0.4;

static void planes(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context;
    bool below = wall == body_of_wall(0);
    *foot =
        (struct weights_foot){.distance = below ? x[2] - 0.3 : 0.8 - x[2], .normal = {0, 0, below ? 1 : -1}};
}

/* Particles with the fields of a fluid, spins and all that grains need. */
static struct particles *set_make(size_t n) {
    struct particles *p = particles_create(n);
    kinds_register(p);
    spin_register(p);
    fluid_fields(p);
    fluid_fields_riding(p);
    fluid_fields_free(p);
    rigid_fields_add(p);
    for (size_t k = 0; k < n; k++) {
        size_t i = particles_append(p);
        p->id[i] = 7 + 2 * (int64_t)i;
    }
    return p;
}

/* A flow of p = push and u_x = shear (z - 0.3) between planes of area 1 at z = 0.3 and 0.8, which are taken as grains 7 and 9: in the
 * middle of two layers of the lattice both parts are exact, and the pressure alone exerts no force on both together. */
static void loads_of_pressure_and_shear(void **state) {
    struct fluid_cloud c;
    uint8_t *kind;
    int64_t *body;
    (void)state;
    fluid_cloud_plane(&c, 0.3, &kind, &body);
    size_t n = c.particles->owned;
    double *pressure = memory_allocate(n, sizeof *pressure, "test");
    for (size_t k = 0; k < n; k++) {
        struct particle_state *at = &c.particles->state[k];
        body[k] = body_of_wall(at->x[2] > 0.5);
        at->v[0] = shear * (at->x[2] - 0.3);
        pressure[k] = push;
    }
    struct weights w = fluid_cloud_weigh(&c, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    const struct mirror_input mirror = {.rows = &c.input, .body = body, .spacing = c.spacing, .wall = planes};
    assert_int_equal(mirror_make(&w, &mirror), 0);
    for (size_t k = 0; k < w.foot_start[w.rows]; k++) {
        bool below = w.foot[k].normal[2] > 0;
        w.foot[k].body = below ? 7 : 9;
        w.foot[k].velocity[0] = below ? 0 : shear * 0.5;
    }
    struct particles *grains = set_make(3);
    struct forces forces = {0};
    const struct physics_context context = {.particles = grains};
    const struct flow flow = {.weights = &w,
                              .velocity = c.particles->state[0].v,
                              .velocity_stride = sizeof *c.particles->state / sizeof(double),
                              .pressure = pressure};
    surface_loads_look(&forces, &context, &flow, viscosity);
    const double *drag = fluid_drag(grains);
    for (int side = 0; side < 2; side++) {
        double sign = side == 0 ? 1 : -1;
        assert_near(drag[3 * side], sign * viscosity * shear, 1e-10);
        assert_near(drag[3 * side + 1], 0, 1e-10);
        assert_near(drag[3 * side + 2], -sign * push, 1e-10);
    }
    assert_near(drag[6], 0, 0); /* nothing lies beside the third */
    w.foot[0].body = body_of_wall(0);
    w.foot[1].body = 12345;
    surface_loads_grains(&forces.grain, grains, &w);
    assert_true(forces.grain[0] == SIZE_MAX && forces.grain[1] == SIZE_MAX && forces.grain[2] < 2);
    surface_forces_free(&forces);
    memory_free(pressure);
    memory_free(kind);
    memory_free(body);
    particles_destroy(&grains);
    weights_free(&w);
    fluid_cloud_free(&c);
}

/* A boundary particle on a grain that turns about z by 0.1 a step and drifts along x: it settles with the velocity v + omega x arm; after
 * so many steps its arm has turned by their sum, of unchanged length, and its place has gone with the grain. */
static void a_boundary_particle_rides(void **state) {
    enum { STEPS = 12 };
    struct particles *p = set_make(2);
    const double omega = 0.4, drift = 0.3, dt = 0.25, none[1][4] = {{0}};
    size_t start[2] = {0, 1};
    uint32_t partner[1] = {1};
    const struct pair_rows pairs = {.start = start, .partner = partner};
    struct fluid_options options = {.density = 1};
    struct fluid fluid = {.options = &options};
    struct box box = {.dimension = 3, .edge = {9, 9, 9}};
    struct clock clock = {.dt = dt};
    const struct physics_context context = {
        .self = &fluid, .options = &options, .box = &box, .particles = p, .clock = &clock};
    (void)state;
    options.grains.unresolved = NAN;
    options.grains.hydraulic = 1;
    fluid.input = (struct weights_input){
        .particles = p, .kind = kinds_of(p), .pairs = &pairs, .shift = none, .dimension = 3};
    kinds_of(p)[0] = KIND_BOUNDARY;
    fluid_body(p)[0] = p->id[1];
    memcpy(p->state[0].x, (double[3]){3, 4, 7}, sizeof p->state[0].x);
    memcpy(p->state[1].x, (double[3]){2, 4, 6}, sizeof p->state[1].x);
    p->state[1].v[0] = drift;
    spin_of(p)[1][2] = omega;
    assert_int_equal(boundary_settle(&context, &fluid), 0);
    assert_near(p->state[0].v[0], drift, 1e-15);
    assert_near(p->state[0].v[1], omega * 1, 1e-15);
    assert_near(p->state[0].v[2], 0, 1e-15);
    assert_near(spin_of(p)[0][2], omega, 0);
    for (int k = 0; k < STEPS; k++) {
        boundary_move(&context, 0, 1);
        p->state[1].x[0] += dt * drift;
        double rode[3] = {p->state[0].x[0], p->state[0].x[1], p->state[0].x[2]};
        boundary_settle(&context, &fluid);
        for (int d = 0; d < 3; d++)
            assert_near(p->state[0].x[d], rode[d], 1e-12);
    }
    double angle = STEPS * dt * omega;
    assert_near(p->state[0].x[0], 2 + STEPS * dt * drift + cos(angle), 1e-12);
    assert_near(p->state[0].x[1], 4 + sin(angle), 1e-12);
    assert_near(p->state[0].x[2], 7, 1e-12);
    assert_near(p->state[0].v[0], drift - omega * sin(angle), 1e-12);
    assert_near(p->state[0].v[1], omega * cos(angle), 1e-12);
    fluid_body(p)[0] = 12345;
    assert_int_equal(boundary_settle(&context, &fluid), 1);
    particles_destroy(&p);
}

/* Six nodes of mass m at +- a, b, c along the axes have the mass 6 m and J_xx = 2 m (b^2 + c^2) ... In a rigid motion of them the grain has
 * their momenta; it takes the motion over if it has the density of the fluid, and shares the momentum with its excess of mass if it is heavier. */
static void sums_of_a_rigid_motion(void **state) {
    const double a[3] = {0.2, 0.3, 0.5}, rho = 1.5, cell = 0.02, radius = 0.5;
    const double motion[6] = {0.3, -1.2, 0.7, 2, -0.4, 1.1};
    struct particles *p = set_make(2);
    struct solid_part part[6] = {{0}};
    double v[6][3], volume[6], fall = -9;
    size_t start[7];
    struct rigid_grains_sums sums[1];
    struct rigid rigid = {.solid = {.parts = 6, .part = part, .nodes = 6, .start = start}, .sums = sums};
    struct fluid_options options = {.density = rho, .spacing = 0.1};
    struct fluid fluid = {.options = &options, .weights = {.volume = volume}};
    struct box box = {.dimension = 3, .edge = {9, 9, 9}};
    struct scene scene = {.gravity = {0, 0, fall}};
    const struct physics_context context = {
        .self = &fluid, .options = &options, .box = &box, .scene = &scene, .particles = p};
    struct rigid_work work = {
        .context = &context, .fluid = &fluid, .rigid = &rigid, .grains = {1, 2}, .dt = 0.01, .kappa = 1};
    (void)state;
    options.grains.motion = FLUID_GRAINS_FREE;
    options.grains.unresolved = NAN;
    options.grains.hydraulic = 1;
    for (int k = 0; k < 6; k++) {
        part[k] = (struct solid_part){.row = (uint32_t)k, .grain = 1, .share = 0.5};
        part[k].arm[k / 2] = k % 2 ? a[k / 2] : -a[k / 2];
        rigid_grains_velocity(motion, part[k].arm, v[k]);
        volume[k] = 2 * cell;
        start[k] = (size_t)k;
    }
    start[6] = 6;
    rigid_sums_moments(&work);
    double mass = rho * cell;
    assert_near(sums[0].mass, 6 * mass, 1e-14);
    for (int d = 0; d < 3; d++) {
        double next = a[(d + 1) % 3], last = a[(d + 2) % 3];
        assert_near(sums[0].first[d], 0, 1e-15);
        assert_near(sums[0].second[d], 2 * mass * (next * next + last * last), 1e-14);
        assert_near(sums[0].second[3 + d], 0, 1e-15);
    }
    for (int heavy = 0; heavy < 2; heavy++) {
        double displaced = rho * 4 / 3.0 * M_PI * pow(radius, 3), excess = heavy ? displaced : 0;
        p->state[1].radius = radius;
        p->state[1].inverse_mass = 1 / (displaced + excess);
        memset(rigid_fields_motion(p)[1], 0, sizeof rigid_fields_motion(p)[1]);
        memset(rigid_fields_impulse(p)[1], 0, sizeof rigid_fields_impulse(p)[1]);
        rigid_sums_momenta(&work, (const double(*)[3])v);
        for (int d = 0; d < 3; d++) {
            assert_near(fluid_load(p)[1][d], 6 * mass * motion[d], 1e-14);
            assert_near(fluid_load(p)[1][3 + d], sums[0].second[d] * motion[3 + d], 1e-14);
        }
        rigid_sums_motions(&work);
        const double *found = rigid_fields_found(p)[1];
        for (int d = 0; d < 3; d++) {
            double weight = d == 2 ? excess * fall * work.dt : 0;
            double inertia = 0.4 * excess * radius * radius, moment = sums[0].second[d];
            assert_near(found[d], (6 * mass * motion[d] + weight) / (6 * mass + excess), 1e-12);
            assert_near(found[3 + d], moment * motion[3 + d] / (moment + inertia), 1e-10);
        }
    }
    particles_destroy(&p);
}

TEST_MAIN(fluid_grain_surfaces, cmocka_unit_test(loads_of_pressure_and_shear),
          cmocka_unit_test(a_boundary_particle_rides), cmocka_unit_test(sums_of_a_rigid_motion))
