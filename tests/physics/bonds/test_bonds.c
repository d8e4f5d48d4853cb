/* SPDX-License-Identifier: BSD-3-Clause */
/* One bond against closed forms: pull, shear, bend, twist, strengths to the last bit, turning as a whole, energy and
 * angular momentum. */
#include "tests/test.h"

#include "physics/bonds/bond.h"
#include <float.h>
#include <math.h>
#include <string.h>
#include "tests/near.h"

/* Two spheres of radii 1 and 2 along x, 3.5 apart, with a bond of radius 0.8. */
static const struct bond_numbers numbers = {.k_n = 5.0,
                                            .k_s = 2.0,
                                            .radius = 0.8,
                                            .tensile = INFINITY,
                                            .shear = INFINITY,
                                            .mass = 3.0,
                                            .inertia = 0.7};
#define AREA (M_PI * 0.64)
#define INERTIA (M_PI * 0.4096 / 4.0)

static struct history_row new_row(void) {
    return (struct history_row){.separation = {3.5, 0.0, 0.0}, .value = {[BOND_REST] = 3.5}};
}

static struct bond_motion still(void) {
    return (struct bond_motion){.separation = {3.5, 0.0, 0.0}, .lever = {1.25, 2.25}};
}

/* One bond alone in a batch, by a step. */
static void advance_by(double dt, const struct bond_section *section, const struct bond_motion *motion,
                       struct history_row *row, struct bond_response *out) {
    struct bond_batch batch = {0};
    bond_batch_add(&batch, section, motion, row);
    bond_batch_advance(&batch, dt);
    bond_batch_take(&batch, 0, row, out);
}

static void advance(const struct bond_section *section, const struct bond_motion *motion,
                    struct history_row *row, struct bond_response *out) {
    advance_by(0.01, section, motion, row, out);
}

static void pull_is_linear(void **state) {
    struct bond_section section = bond_section_of(&numbers);
    struct history_row row = new_row();
    struct bond_motion motion = still();
    struct bond_response out;
    (void)state;
    motion.separation.x = 3.7;
    advance(&section, &motion, &row, &out);
    assert_near(out.force.x, -5.0 * AREA * 0.2, 1e-14);
    assert_near(out.tensile, 5.0 * 0.2, 1e-14);
    assert_near(out.stored, 0.5 * 5.0 * AREA * 0.04, 1e-14);
    assert_true(out.force.y == 0.0 && out.moment.x == 0.0 && out.shear == 0.0);
    motion.separation.x = 3.4;
    advance(&section, &motion, &row, &out);
    assert_near(out.force.x, 5.0 * AREA * 0.1, 1e-14);
    assert_true(out.tensile < 0.0);
}

static void spins_shear(void **state) {
    struct bond_section section = bond_section_of(&numbers);
    struct history_row row = new_row();
    struct bond_motion motion = still();
    struct bond_response out;
    (void)state;
    motion.spin[0].z = motion.spin[1].z = 0.3; /* both turn alike: no bending, slip of the surfaces */
    advance(&section, &motion, &row, &out);
    assert_near(out.force.y, 2.0 * AREA * 0.3 * 3.5 * 0.01, 1e-14);
    assert_near(out.shear, 2.0 * 0.3 * 3.5 * 0.01, 1e-14);
    assert_true(out.moment.z == 0.0 && fabs(out.force.x) < 1e-15);
}

static void spins_bend_and_twist(void **state) {
    struct bond_section section = bond_section_of(&numbers);
    struct history_row row = new_row();
    struct bond_motion motion = still();
    struct bond_response out;
    (void)state;
    motion.spin[0] = (struct law_vector){-0.2, -0.4 * 2.25, 0.0};
    motion.spin[1] = (struct law_vector){0.2, 0.4 * 1.25, 0.0}; /* no slip at the middle */
    for (int step = 0; step < 10; step++)
        advance(&section, &motion, &row, &out);
    double twist = 2.0 * 2.0 * INERTIA * 0.4 * 0.1, bend = 5.0 * INERTIA * 1.4 * 0.1;
    assert_near(out.moment.x, -twist, 1e-13);
    assert_near(out.moment.y, -bend, 1e-13);
    assert_near(out.tensile, bend * 0.8 / INERTIA, 1e-13);
    assert_near(out.shear, twist * 0.8 / (2.0 * INERTIA), 1e-13);
    assert_near(out.stored, 0.5 * twist * twist / (4.0 * INERTIA) + 0.5 * bend * bend / (5.0 * INERTIA),
                1e-13);
    assert_near(bond_energy(&section, &row), out.stored, 1e-13);
}

/* A strength is reached by 1 ulp, or not. */
static void breaks_at_the_strength(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++)
        for (int below = 0; below < 2; below++) {
            struct bond_section section = bond_section_of(&numbers);
            struct history_row row = new_row(), first = row;
            struct bond_motion motion = still();
            struct bond_response out;
            motion.separation.x = way == 0 ? 3.7 : 3.5;
            motion.spin[0].z = motion.spin[1].z = way == 0 ? 0.0 : 0.3;
            advance(&section, &motion, &first, &out);
            double reached = way == 0 ? out.tensile : out.shear;
            double *strength = way == 0 ? &section.tensile : &section.shear;
            *strength = below ? nextafter(reached, INFINITY) : reached;
            advance(&section, &motion, &row, &out);
            assert_int_equal(out.end, below ? BOND_WHOLE : way == 0 ? BOND_TENSION : BOND_SHEARED);
        }
}

/* Angular velocity `w` takes the pair as a rigid body through `steps` steps; force and moment must turn with it. */
static void turns_with_the_pair(void **state) {
    struct bond_section section = bond_section_of(&numbers);
    const double angle = 2.0 * M_PI, axis[3] = {0.36, 0.48, 0.8};
    double error[2];
    (void)state;
    for (int fine = 0; fine < 2; fine++) {
        int steps = fine ? 4000 : 2000;
        struct history_row row = new_row();
        memcpy(row.value + BOND_SHEAR, (double[6]){0.0, 0.3, -0.2, 0.05, 0.02, 0.07}, 6 * sizeof(double));
        struct bond_motion motion = still();
        struct bond_response out;
        double dt = angle / steps;
        motion.spin[0] = motion.spin[1] = (struct law_vector){axis[0], axis[1], axis[2]};
        struct law_vector n = {axis[0], axis[1], axis[2]}, x = {3.5, 0.0, 0.0};
        struct law_vector along = law_scale(law_dot(x, n), n), across = law_add(x, -1.0, along);
        struct law_vector side = law_cross(n, across);
        for (int k = 1; k <= steps; k++) {
            double c = cos(k * dt), s = sin(k * dt);
            motion.separation = law_add(law_add(along, c, across), s, side);
            advance_by(dt, &section, &motion, &row, &out);
        }
        const double *v = row.value + BOND_SHEAR;
        error[fine] = fabs(v[0]) + fabs(v[1] - 0.3) + fabs(v[2] + 0.2) + fabs(v[3] - 0.05) +
                      fabs(v[4] - 0.02) + fabs(v[5] - 0.07);
    }
    assert_true(error[0] < 1e-4);
    assert_true(error[0] / error[1] > 3.8); /* of second order in the step */
}

/* Both dampers and springs: the work taken is never negative, and the force opposes the motion. */
static void dampers_take(void **state) {
    struct bond_numbers damped = numbers;
    damped.damping = 0.2;
    struct bond_section section = bond_section_of(&damped);
    struct history_row row = new_row();
    struct bond_motion motion = still();
    struct bond_response out;
    (void)state;
    motion.velocity = (struct law_vector){0.5, 0.0, 0.0};
    advance(&section, &motion, &row, &out);
    double c = 0.4 * sqrt(3.0 * 5.0 * AREA);
    assert_near(out.force.x, -c * 0.5, 1e-14);
    assert_near(out.taken, c * 0.25 * 0.01, 1e-14);
    assert_true(out.tensile == 0.0); /* dampers count for no stress */
}

/* Dampers alone, as no time passes: against stretch, slip, twist and bending, each by its own coefficient. */
static void dampers_oppose(void **state) {
    struct bond_numbers damped = numbers;
    struct history_row row = new_row();
    struct bond_motion motion = still();
    struct bond_response out;
    (void)state;
    damped.damping = 0.2;
    const struct bond_section section = bond_section_of(&damped);
    motion.velocity = (struct law_vector){0.3, -0.5, 0.0};
    advance_by(0.0, &section, &motion, &row, &out);
    assert_near(out.force.x, -2 * 0.2 * sqrt(3.0 * 5.0 * AREA) * 0.3, 1e-14);
    assert_near(out.force.y, 2 * 0.2 * sqrt(3.0 * 2.0 * AREA) * 0.5, 1e-14);
    assert_true(out.moment.x == 0.0 && out.moment.y == 0.0);
    motion.velocity = (struct law_vector){0.0, 0.0, 0.0};
    motion.spin[1] = (struct law_vector){0.7, 0.1, 0.0};
    advance_by(0.0, &section, &motion, &row, &out);
    assert_near(out.moment.x, -2 * 0.2 * sqrt(0.7 * 2.0 * 2.0 * INERTIA) * 0.7, 1e-14);
    assert_near(out.moment.y, -2 * 0.2 * sqrt(0.7 * 5.0 * INERTIA) * 0.1, 1e-14);
    assert_near(out.force.z, -2 * 0.2 * sqrt(3.0 * 2.0 * AREA) * 2.25 * 0.1,
                1e-14); /* the surface of the turning end slips */
}

/* Bonds in a full batch, one in five of which breaks: the bits of each are those of the bond alone. */
static void batch_is_one_by_one(void **state) {
    static struct bond_batch batch;
    struct history_row row[BOND_BATCH];
    struct bond_motion motion[BOND_BATCH];
    struct bond_section section[BOND_BATCH];
    int broken = 0;
    (void)state;
    batch.count = 0;
    for (int k = 0; k < BOND_BATCH; k++) {
        struct bond_numbers given = numbers;
        double angle = 0.7 * k, turn = cos(1.3 * k), tilt = sin(2.1 * k);
        given.damping = 0.1 * turn * turn;
        given.tensile = k % 5 ? INFINITY : 1e-3;
        section[k] = bond_section_of(&given);
        row[k] = new_row();
        memcpy(row[k].value + BOND_SHEAR, (double[6]){0.0, 0.3 * turn, -0.2, 0.05, 0.02 * tilt, 0.07},
               6 * sizeof(double));
        motion[k] = (struct bond_motion){.separation = {3.6, 0.02 * turn, 0.03 * tilt},
                                         .velocity = {turn, tilt, 0.1},
                                         .spin = {{turn, 0.2, tilt}, {0.3, sin(angle), cos(angle)}},
                                         .lever = {1.2, 2.2 + 0.1 * tilt}};
        bond_batch_add(&batch, &section[k], &motion[k], &row[k]);
    }
    bond_batch_advance(&batch, 0.01);
    for (int k = 0; k < BOND_BATCH; k++) {
        struct history_row together = row[k];
        struct bond_response a, b;
        bond_batch_take(&batch, k, &together, &a);
        advance(&section[k], &motion[k], &row[k], &b);
        assert_memory_equal(&together, &row[k], sizeof together);
        assert_memory_equal(&a.force, &b.force, sizeof a.force);
        assert_memory_equal(&a.moment, &b.moment, sizeof a.moment);
        assert_true(a.stored == b.stored && a.taken == b.taken && a.end == b.end);
        broken += a.end != BOND_WHOLE;
    }
    assert_int_equal(broken, 13);
}

TEST_MAIN(bonds, cmocka_unit_test(dampers_oppose), cmocka_unit_test(batch_is_one_by_one),
          cmocka_unit_test(pull_is_linear), cmocka_unit_test(spins_shear),
          cmocka_unit_test(spins_bend_and_twist), cmocka_unit_test(breaks_at_the_strength),
          cmocka_unit_test(turns_with_the_pair), cmocka_unit_test(dampers_take))
