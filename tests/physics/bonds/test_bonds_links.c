/* SPDX-License-Identifier: BSD-3-Clause */
/* What a bond takes from its two particles: entry, stiffness, radius, masses; one that has lost its partner. */
#include "tests/test.h"

#include "physics/bonds/bonds_state.h"
#include "base/memory.h"
#include "tests/particles_by_hand.h"
#include <math.h>
#include "tests/near.h"

/* A sphere of radius 1 and mass 2, one of radius 3 and mass 5. */
static struct particles *two_spheres(void) {
    struct particles *p = particles_with(0, 2);
    for (int k = 0; k < 2; k++) {
        size_t i = particles_append(p);
        p->id[i] = k + 1;
        p->state[i].radius = k ? 3.0 : 1.0;
        p->state[i].inverse_mass = k ? 0.2 : 0.5;
    }
    return p;
}

static const struct bonds_options options = {
    .entries = 2,
    .entry = {
        {.modulus = 80.0,
         .ratio = 2.5,
         .k_n = NAN,
         .k_s = NAN,
         .radius = 0.5,
         .tensile = 7.0,
         .shear = NAN,
         .damping = 0.1},
        {.modulus = NAN, .ratio = NAN, .k_n = 6.0, .k_s = 3.0, .radius = 1.0, .tensile = NAN, .shear = NAN}}};

static void section_of_unlike_spheres(void **state) {
    struct particles *p = two_spheres();
    struct physics_context context = {.particles = p};
    struct bonds bonds = {.options = &options, .context = &context};
    (void)state;
    for (uint32_t i = 0; i < 2; i++) { /* whatever the order of the two */
        struct bond_section s = bonds_section(&bonds, 0, i, 1 - i);
        /* radius by the smaller grain, stiffness by both */
        double radius = 0.5, area = M_PI * radius * radius, bending = area * radius * radius / 4,
               k_n = 80.0 / 4.0;
        double inertia = 1 / (1 / (0.4 * 2 * 1) + 1 / (0.4 * 5 * 9)), mass = 2.0 * 5.0 / 7.0;
        assert_near(s.radius, radius, 1e-15);
        assert_near(s.stretch, k_n * area, 1e-13);
        assert_near(s.slide, k_n / 2.5 * area, 1e-13);
        assert_near(s.bend, k_n * bending, 1e-14);
        assert_near(s.twist, k_n / 2.5 * 2 * bending, 1e-14);
        assert_near(s.c_stretch, 2 * 0.1 * sqrt(mass * k_n * area), 1e-13);
        assert_near(s.c_twist, 2 * 0.1 * sqrt(inertia * k_n / 2.5 * 2 * bending), 1e-14);
        assert_near(s.c_bend, 2 * 0.1 * sqrt(inertia * k_n * bending), 1e-14);
        assert_true(s.tensile == 7.0 && isinf(s.shear));
    }
    struct bond_section given = bonds_section(&bonds, 1, 0, 1);
    assert_near(given.stretch, 6.0 * M_PI, 1e-14);
    assert_near(given.slide, 3.0 * M_PI, 1e-14);
    assert_true(given.c_bend == 0.0);
    p->state[1].inverse_mass = 0; /* held: the other one's mass counts */
    assert_near(bonds_section(&bonds, 0, 0, 1).c_stretch, 2 * 0.1 * sqrt(2.0 * 20 * M_PI / 4), 1e-13);
    particles_destroy(&p);
}

static void first_entry_that_fits(void **state) {
    const struct bonds_options o = {.entries = 3,
                                    .entry = {{.materials = 2, .material = {0, 1}},
                                              {.materials = 1, .material = {1}, .groups = 1, .group = {4}},
                                              {.groups = 2, .group = {0, 4}}}};
    (void)state;
    assert_int_equal(bonds_entry_of(&o, (int[2]){1, 0}, (int[2]){9, 9}), 0);
    assert_int_equal(bonds_entry_of(&o, (int[2]){1, 1}, (int[2]){4, 4}), 1);
    assert_int_equal(bonds_entry_of(&o, (int[2]){1, 1}, (int[2]){4, 0}), 2);
    assert_int_equal(bonds_entry_of(&o, (int[2]){1, 1}, (int[2]){4, 5}), -1);
    assert_int_equal(bonds_entry_of(&o, (int[2]){0, 0}, (int[2]){4, 4}), -1);
}

/* Rows of both ends without partners: each says the same middle, in the frame of its own particle. */
static void lost_in_the_middle(void **state) {
    struct particles *p = two_spheres();
    struct clock clock = {.step = 12, .time = 0.5};
    struct physics_context context = {.particles = p, .clock = &clock};
    struct history_row row[2] = {{.id = 1, .partner = 7, .separation = {2, 0, -4}},
                                 {.id = 2, .partner = 0, .separation = {2, 0, -4}}};
    size_t start[3] = {0, 1, 2};
    struct bonds bonds = {
        .options = &options, .context = &context, .rows = {.row = row, .count = 2, .start = start}};
    (void)state;
    p->state[0].x[0] = 1;
    p->state[1].x[2] = 3;
    bonds_link_all(&bonds);
    assert_int_equal(bonds.events.count, 2);
    assert_true(bonds.link[0].end == BOND_LOST && bonds.broken[BOND_LOST] == 2.0);
    const struct bonds_event *lower = &bonds.events.event[0], *higher = &bonds.events.event[1];
    assert_true(lower->id[0] == 1 && lower->id[1] == 7 && higher->id[0] == 0 && higher->id[1] == 2);
    assert_true(lower->x[0] == 2.0 && lower->x[2] == -2.0 && lower->step == 12);
    assert_true(higher->x[0] == -1.0 && higher->x[2] == 5.0);
    memory_free(bonds.link);
    memory_free(bonds.events.event);
    particles_destroy(&p);
}

TEST_MAIN(bonds_links, cmocka_unit_test(section_of_unlike_spheres), cmocka_unit_test(first_entry_that_fits),
          cmocka_unit_test(lost_in_the_middle))
