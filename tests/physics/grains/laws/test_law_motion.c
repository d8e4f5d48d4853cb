/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws with parts in motion: impacts, plastic laws with their memory, stable steps. */
#include "tests/test.h"

#include "tests/physics/grains/laws/law_parts_by_hand.h"

/* Restitution of a head-on impact, by small steps. */
static double restitution_of(const struct law *law, double speed) {
    struct law_general in = {.extra = &law->extra[law_place_of(law->materials, 0, 1)], .radius = {1.0, 1.0}};
    in.contact = (struct law_contact){.mass = 1.0,
                                      .radius = 0.5,
                                      .normal = {1.0, 0.0, 0.0},
                                      .coefficients = law->pair[law_place_of(law->materials, 0, 1)]};
    double overlap = 0.0, v = speed, dt = 2e-5 / pow(speed, 0.2);
    do {
        struct law_response out;
        overlap += dt * v;
        in.contact.overlap = overlap;
        in.contact.velocity.x = -v;
        law_general_respond(law, law_step_of(&law->options, dt), &in, &out);
        v -= dt * out.force.x;
    } while (overlap > 0.0);
    return -v / speed;
}

/* Viscoelastic spheres: 1 - e grows as the fifth root of the speed, where it is small. */
static void test_viscoelastic(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.tangential = LAW_FRICTIONLESS;
    o.damping = LAW_DAMPING_VISCOELASTIC;
    struct law_extra extra = {.damping_viscoelastic = {.dissipative_time = 3e-5}};
    OWN_LAW law = law_of(o, extra);
    double slow = 1.0 - restitution_of(&law, 1e-3), fast = 1.0 - restitution_of(&law, 0.032);
    assert_true(slow > 1e-3 && fast < 0.05);
    assert_near(fast / slow, 2.0, 0.05);
}

/* The work of the spring, to and fro up to `most`, is what the spring stores and what flows; at least `part` of it flows. */
static void assert_balance(const struct law *law, double most, double part) {
    struct law_general in = {.extra = &law->extra[law_place_of(law->materials, 0, 1)], .radius = {1.0, 1.0}};
    in.contact = (struct law_contact){.mass = 1.0,
                                      .radius = 0.5,
                                      .normal = {1.0, 0.0, 0.0},
                                      .coefficients = law->pair[law_place_of(law->materials, 0, 1)]};
    double work = 0.0, taken = 0.0, before = 0.0, stored = 0.0, begin = 0.0;
    for (int k = 1; k < 20000; k++) {
        double overlap = most * (1.1 + sin(k * 5e-4)), last = most * (1.1 + sin((k - 1) * 5e-4));
        struct law_response out;
        in.contact.overlap = overlap;
        in.contact.velocity.x = (last - overlap) / 1e-3;
        law_general_respond(law, law_step_of(&law->options, 1e-3), &in, &out);
        if (k > 1) {
            work += 0.5 * (out.force.x + before) * (overlap - last);
            taken += out.taken;
        } else {
            begin = out.normal_energy;
        }
        before = out.force.x;
        stored = out.normal_energy;
    }
    assert_near((taken + stored - begin) / work, 1.0, 1e-3);
    assert_true(taken > part * work);
}

/* Luding's law: loading, unloading, the adhesive branch and reloading; restitution of an impact in closed form; the work
 * of the spring is what it stores and what flows. */
static void test_luding(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_LUDING;
    o.tangential = LAW_FRICTIONLESS;
    struct law_extra extra = {.k_2 = 3e5, .k_c = 5e4};
    OWN_LAW law = law_of(o, extra);
    struct law_surfaces s = surfaces_of(&law, 1.0, 1.0);
    const double k1 = 1e5, k2 = 3e5, kc = 5e4, most = 0.01, rest = (1.0 - k1 / k2) * most;
    const double least = k2 * rest / (k2 + kc);
    struct law_past past = {0};
    for (int k = 1; k <= 100; k++)
        assert_near(law_grip_at(&o, &s, most * k / 100.0, &past).force, k1 * most * k / 100.0, 1e-9);
    for (int k = 99; k >= 0; k--) {
        double overlap = least + (most - least) * k / 100.0;
        assert_near(law_grip_at(&o, &s, overlap, &past).force, k2 * (overlap - rest), 1e-9);
    }
    assert_near(law_grip_at(&o, &s, 0.5 * least, &past).force, -kc * 0.5 * least, 1e-9);
    /* the adhesive branch has made the largest overlap less; the contact reloads along k_2 from there */
    assert_near(past.number[0], 0.5 * most, 1e-12);
    assert_near(law_grip_at(&o, &s, 0.5 * rest, &past).force, 0.0, 1e-9);
    assert_near(law_grip_at(&o, &s, 0.5 * most, &past).force, k1 * 0.5 * most, 1e-9);

    struct law_pair pair = {.restitution = 1.0, .k_n = k1, .k_t = 1.0, .extra = extra};
    law = law_for(o, soft, pair);
    double share = (k2 - k1) / (k2 + kc), squared = k1 / k2 - share * share * kc * (kc / k2 + 1.0) / k1;
    assert_near(restitution_of(&law, 1.0), sqrt(squared), 1e-3);
    assert_near(restitution_of(&law, 3.0), sqrt(squared), 1e-3);

    assert_balance(&law, 0.01, 0.1);
}

/* Thornton's law: his closed form of the restitution, branches that meet, the dent that stays. */
static void test_thornton(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_THORNTON;
    o.tangential = LAW_FRICTIONLESS;
    struct law_pair pair = {.restitution = 1.0, .extra = {.yield_pressure = 2e4}};
    OWN_LAW law = law_for(o, soft, pair);
    struct law_surfaces s = surfaces_of(&law, 1.0, 1.0);
    double modulus = 0.75 * law.pair[law_place_of(law.materials, 0, 1)].k_n,
           a = 0.5 * M_PI * 0.5 * 2e4 / modulus, yield = a * a / 0.5;
    double slow =
        sqrt(16.0 / 15.0 * modulus * sqrt(0.5) * pow(yield, 2.5)); /* yields at this speed, m* = 1 */
    assert_near(restitution_of(&law, 0.9 * slow), 1.0, 1e-3);
    for (double speed = 2.0 * slow; speed < 100.0 * slow; speed *= 3.0) {
        double v = slow / speed, e = sqrt(1.2 * sqrt(3.0)) * sqrt(1.0 - v * v / 6.0) *
                                     pow(v / (v + 2.0 * sqrt(1.2 - 0.2 * v * v)), 0.25);
        assert_near(restitution_of(&law, speed), e, 2e-3);
    }
    struct law_past past = {0};
    double force = law_grip_at(&o, &s, 5.0 * yield, &past).force; /* loading, then just below: continuous */
    assert_near(force, 4.0 / 3.0 * modulus * a * yield + M_PI * 0.5 * 2e4 * 4.0 * yield, 1e-9 * force);
    assert_near(law_grip_at(&o, &s, 5.0 * yield * (1.0 - 1e-9), &past).force, force, 1e-7 * force);
    assert_near(law_grip_at(&o, &s, 0.5 * yield, &past).force, 0.0, 1e-12);
}

/* Thornton and Ning: JKR up to the yield; beyond it the slope of the force that their paper gives; then JKR around the dent with the
 * flattened radius, down to its pull-off force; what is pressed again is as before; work is stored or flows. */
static void test_thornton_sticky(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_THORNTON;
    o.cohesion = LAW_COHESION_JKR;
    o.tangential = LAW_FRICTIONLESS;
    struct law_pair pair = {.restitution = 1.0,
                            .extra = {.yield_pressure = 1.5e5, .cohesion_jkr = {.surface_energy = 20.0}}};
    OWN_LAW law = law_for(o, soft, pair);
    struct law_surfaces s = surfaces_of(&law, 1.0, 1.0);
    const double modulus = law_modulus(&law.pair[law_place_of(law.materials, 0, 1)]), gamma = 20.0, p = 1.5e5,
                 radius = 0.5;
    const double roughness =
        2.0 * sqrt(M_PI * gamma / modulus); /* s of physics/grains/laws/parts/cohesion_jkr.h */
    double a_y = 0.0, step = 1e-7;
    while (modulus / M_PI * (2.0 * (a_y + step) / radius - roughness / sqrt(a_y + step)) < p)
        a_y += step;
    double yield = a_y * a_y / radius - roughness * sqrt(a_y), h = 1e-6 * yield;
    struct law_past past = {0};
    double a = law_jkr_radius(modulus, gamma, radius, 0.9 * yield);
    assert_near(law_grip_at(&o, &s, 0.9 * yield, &past).force / law_jkr_at(modulus, gamma, radius, a).force,
                1.0, 1e-12);
    for (double overlap = 1.5 * yield; overlap < 5.0 * yield; overlap *= 1.3) {
        struct law_past up = past, down = past;
        double slope =
            (law_grip_at(&o, &s, overlap + h, &up).force - law_grip_at(&o, &s, overlap - h, &down).force) /
            (2.0 * h);
        a = law_jkr_radius(modulus, gamma, radius, overlap);
        double hertz = sqrt(4.0 / 3.0 * modulus * a * a * a / radius),
               pull = sqrt(3.0 * M_PI * gamma * radius);
        double want = (3.0 * M_PI * radius * p * hertz - 2.0 * modulus * a_y * pull) / (3.0 * hertz - pull);
        assert_near(slope / want, 1.0, 1e-5);
    }
    struct law_grip top = law_grip_at(&o, &s, 5.0 * yield, &past), at = top;
    assert_near(law_grip_at(&o, &s, 5.0 * yield * (1.0 - 1e-10), &past).force / top.force, 1.0, 1e-7);
    double least = 0.0, end = 0.0;
    for (double overlap = 5.0 * yield; overlap > 0.0 && at.touches; overlap -= 1e-4 * yield) {
        at = law_grip_at(&o, &s, overlap, &past);
        least = fmin(least, at.force);
        end = overlap;
    }
    double flat = top.press / (6.0 * M_PI * gamma);
    assert_true(flat > 1.2 * radius && end > 0.0 && at.interacts && !at.touches && at.force == 0.0);
    assert_near(least / (-3.0 * M_PI * gamma * flat), 1.0, 1e-5);
    assert_near(law_grip_at(&o, &s, 5.0 * yield, &past).force / top.force, 1.0, 1e-12);
    assert_balance(&law, 2.0 * yield, 0.01);
}

/* EEPA: the three branches, their meetings, the largest pull, reloading; the closed form of the restitution. */
static void test_eepa(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.normal = LAW_EEPA;
    o.tangential = LAW_FRICTIONLESS;
    for (int steep = 0; steep < 2; steep++) {
        struct law_extra extra = {.plasticity_ratio = 0.7,
                                  .adhesion_energy = 100.0,
                                  .adhesion_exponent = steep ? 4.0 : 1.5,
                                  .pull_off = 2.0};
        OWN_LAW law = law_of(o, extra);
        struct law_surfaces s = surfaces_of(&law, 1.0, 1.0);
        const double k1 = law.pair[law_place_of(law.materials, 0, 1)].k_n * sqrt(0.5), k2 = k1 / 0.3,
                     most = 0.01, f0 = 2.0;
        const double foot = 0.7 * pow(most, 1.5), patch = sqrt(2.0 * 0.5 * pow(foot, 2.0 / 3.0));
        const double pull = 1.5 * M_PI * 100.0 * patch, least = pow(foot - pull / k2, 2.0 / 3.0);
        assert_true(pull < 0.5 * k2 * foot);
        struct law_past past = {0};
        for (int k = 1; k <= 100; k++)
            assert_near(law_grip_at(&o, &s, most * k / 100.0, &past).force,
                        k1 * pow(most * k / 100.0, 1.5) - f0, 1e-9);
        for (int k = 99; k >= 0; k--) {
            double overlap = least + (most - least) * k / 100.0;
            assert_near(law_grip_at(&o, &s, overlap, &past).force, k2 * (pow(overlap, 1.5) - foot) - f0,
                        1e-8);
        }
        double force = law_grip_at(&o, &s, 0.9 * least, &past).force + f0;
        assert_near(force, -pull * pow(0.9, steep ? 4.0 : 1.5), 1e-9);
        /* pressed again: along k_2 from there, and back; then along k_1 */
        assert_near(law_grip_at(&o, &s, least, &past).force,
                    force - f0 + k2 * pow(least, 1.5) * (1.0 - pow(0.9, 1.5)), 1e-8);
        assert_near(law_grip_at(&o, &s, 0.9 * least, &past).force, force - f0, 1e-8);
        assert_near(law_grip_at(&o, &s, most, &past).force, k1 * pow(most, 1.5) - f0, 1e-8);
        assert_balance(&law, 0.005, 0.1);
    }
    struct law_pair pair = {.restitution = 1.0, .extra = {.plasticity_ratio = 0.7, .adhesion_exponent = 1.5}};
    OWN_LAW law = law_for(o, soft, pair);
    double x = pow(0.7, 2.0 / 3.0), squared = (1.0 - pow(x, 2.5) - 2.5 * 0.7 * (1.0 - x)) / 0.3;
    assert_near(restitution_of(&law, 0.5), sqrt(squared), 1e-3);
    assert_near(restitution_of(&law, 5.0), sqrt(squared), 1e-3);
}

/* The stable step of one spring at rest in its law: bounded at 0.95 of it, not at 1.1. */
static double grown(const struct law *law, const struct law_surfaces *s, double part) {
    double rest = fmax(law_grip_rest(&law->options, s), 1e-3), push, dt, least = 1e-6, most = 0.0;
    struct law_stiff stiff = law_general_stiff(law, s, 1.0, rest);
    double square = stiff.k_n, damp = 0.5 * stiff.c_n;
    dt = part * 2.0 / (sqrt(square + damp * damp) + damp);
    struct law_general in = {.extra = s->extra, .radius = {s->radius[0], s->radius[1]}};
    in.contact = (struct law_contact){.overlap = rest,
                                      .mass = 1.0,
                                      .radius = s->effective,
                                      .normal = {1.0, 0.0, 0.0},
                                      .coefficients = *s->c};
    struct law_response out;
    in.contact.overlap = 1.01 * rest; /* then a plastic law is on its unloading branch */
    law_general_respond(law, law_step_of(&law->options, dt), &in, &out);
    in.contact.overlap = rest;
    law_general_respond(law, law_step_of(&law->options, dt), &in, &out);
    push = out.force.x;
    double overlap = rest * (1.0 + least), v = 0.0;
    for (int k = 0; k < 300; k++) {
        in.contact.overlap = overlap;
        in.contact.velocity.x = -v;
        law_general_respond(law, law_step_of(&law->options, dt), &in, &out);
        v -= dt * (out.force.x - push);
        overlap += dt * v;
        most = fmax(most, fabs(overlap - rest) / (rest * least));
        if (most > 100.0)
            break;
    }
    return most;
}

static void test_stable(void **state) {
    (void)state;
    struct law_options o = law_options_default();
    o.tangential = LAW_FRICTIONLESS;
    o.end = LAW_END_OVERLAP;
    int tried = 0;
    for (o.normal = (enum law_normal)0, o.cohesion = LAW_COHESION_NONE; next_cohesion(&o);)
        for (int damping = 0; damping < LAW_DAMPING_COUNT; damping++) {
            int count;
            o.damping = (enum law_damping)damping;
            if (!law_part_combines(&law_part_rows(LAW_PART_DAMPING, &count)[damping],
                                   law_row_get(o.normal)->traits))
                continue;
            OWN_LAW law = law_of(o, sticky);
            struct law_surfaces s = surfaces_of(&law, 1.0, 1.0);
            assert_true(grown(&law, &s, 0.95) < 10.0);
            assert_true(grown(&law, &s, 1.1) > 30.0);
            tried++;
        }
    assert_true(tried > 30);
}

TEST_MAIN(law_motion, cmocka_unit_test(test_viscoelastic), cmocka_unit_test(test_luding),
          cmocka_unit_test(test_thornton), cmocka_unit_test(test_thornton_sticky),
          cmocka_unit_test(test_eepa), cmocka_unit_test(test_stable))
