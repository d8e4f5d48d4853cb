/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws with parts over a batch of contacts: the bits of each loop are those of one contact after another. */
#include "tests/test.h"

#include "physics/grains/batch/force_general.h"
#include "physics/grains/laws/law_general.h"
#include "tests/physics/grains/laws/law_parts_by_hand.h"

static void batch_put(double row[3][FORCE_BATCH], int k, struct law_vector v) {
    row[0][k] = v.x;
    row[1][k] = v.y;
    row[2][k] = v.z;
}

/* A batch of random contacts. */
static void batch_fill(struct force_batch *b, const struct law *law, struct random_sequence *r) {
    b->walk.count = b->walk.padded = FORCE_BATCH;
    for (int k = 0; k < FORCE_BATCH; k++) {
        struct law_general in = random_contact(law, r);
        in.radius[1] = k % 8 == 7 ? INFINITY : in.radius[1]; /* a wall */
        force_set_coefficients(b, k, &in.contact.coefficients);
        force_set_resistances(b, k, &law->options, in.extra);
        force_set_sticky(b, k, law->options.cohesion, &law->sticky[law_place_of(law->materials, 0, 1)]);
        force_set_branch(b, k, in.extra);
        b->overlap[k] = in.contact.overlap;
        b->mass[k] = in.contact.mass;
        b->extra[k] = in.extra;
        batch_put(b->normal, k, in.contact.normal);
        batch_put(b->half_normal, k, in.contact.half_normal);
        batch_put(b->velocity, k, in.contact.velocity);
        batch_put(b->surface, k, in.contact.surface);
        batch_put(b->spin, k, in.contact.spin);
        for (int side = 0; side < 2; side++)
            b->walk.radius[side][k] = in.radius[side];
        for (int c = 0; c < law->history_components; c++)
            b->walk.history[c][k] = in.value[c];
    }
}

/* The columns of a batch: each number of each cohesion, and each coefficient of a law, comes back in its member. */
static void test_columns(void **state) {
    (void)state;
    static struct force_batch b;
    union law_sticky sticky_in;
    struct law_coefficients c, back;
    for (size_t n = 0; n < sizeof sticky_in / sizeof(double); n++)
        ((double *)&sticky_in)[n] = 1.0 + (double)n;
    for (size_t n = 0; n < sizeof c / sizeof(double); n++)
        ((double *)&c)[n] = 1.0 + (double)n;
#define COLUMNS(NAME, name, with, summary)                                                                   \
    {                                                                                                        \
        memset(&b, 0, sizeof b);                                                                             \
        force_set_sticky(&b, 3, LAW_COHESION_##NAME, &sticky_in);                                            \
        struct cohesion_##name out = force_##name##_of(&b, 3);                                               \
        assert_memory_equal(&out, &sticky_in, sizeof out);                                                   \
    }
    LAW_COHESION_PARTS(COLUMNS)
#undef COLUMNS
    force_set_coefficients(&b, 3, &c);
    back = force_coefficients_of(&b, 3);
    assert_memory_equal(&back, &c, sizeof c);
}

/* The loops of sliding, rolling and twisting: forces, torques, memory and energies to the last bit those of single contacts, by
 * each instruction set. Counts the evaluations whose normal direction has a loop, too. */
static int rub_once(const struct law *law, const struct force_kernel *kernel, bool energies,
                    struct random_sequence *r) {
    static struct force_batch plain, fast;
    struct force_form form;
    kernel->begin(&form, &plain, law, 1e-3, energies);
    batch_fill(&plain, law, r);
    fast = plain;
    kernel->contacts(&form, &fast);
    force_general_respond(law, form.step, &plain);
    int sums = !law->spin ? 3 : law->options.rolling || law->options.twisting ? 9 : 6;
    for (int k = 0; k < FORCE_BATCH; k++) {
        assert_true((plain.springs[5][k] > 0.0) == fast.active[k]);
        for (int c = 0; c < sums; c++)
            assert_true(plain.walk.out[c][k] == fast.walk.out[c][k]);
        for (int c = 0; c < law->history_components; c++)
            assert_true(plain.walk.history[c][k] == fast.walk.history[c][k]);
        for (int c = 0; energies && c < 3; c++)
            assert_true(plain.energy[c][k] == fast.energy[c][k]);
    }
    return form.push != force_general_push;
}

static void test_rub(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(3, RANDOM_TEST, 0);
    struct law_options o = law_options_default();
    int tried = 0, vectorised = 0, levels = 0;
    for (int level = 0; level < 3; level++)
        levels += force_kernel_find(walk_level_name(level)) != NULL;
    for (o.normal = (enum law_normal)0, o.cohesion = LAW_COHESION_NONE; next_cohesion(&o);)
        for (int kind = 0; kind < 6; kind++) {
            o.tangential = kind < 2 ? LAW_TANGENTIAL_NONE : LAW_TANGENTIAL_HISTORY;
            o.rolling = kind < 4 ? LAW_ROLLING_NONE : LAW_ROLLING_SPRING;
            o.synchronised = kind % 2;
            o.end = kind % 3 ? LAW_END_FORCE : LAW_END_OVERLAP;
            o.damping = (enum law_damping)(kind % LAW_DAMPING_TSUJI);
            OWN_LAW law = law_of(o, sticky);
            for (int level = 0; law.general && level < 3; level++) {
                const struct force_kernel *kernel = force_kernel_find(walk_level_name(level));
                if (kernel == NULL)
                    continue;
                vectorised += rub_once(&law, kernel, false, &r);
                rub_once(&law, kernel, true, &r);
                tried++;
            }
        }
    assert_true(levels > 0 && tried > levels * 66);
    assert_true(vectorised >= levels * 6 * 12); /* kinds, and laws with a cohesion that have a loop */
}

/* The same for all combinations of parts. */
static void test_resist(void **state) {
    (void)state;
    struct random_sequence r = random_sequence(4, RANDOM_TEST, 0);
    int tried = 0, levels = 0;
    for (int level = 0; level < 3; level++)
        levels += force_kernel_find(walk_level_name(level)) != NULL;
    for (int k = 0; k < OPTIONS; k++) {
        OWN_LAW law = law_of(options_of(k), sticky);
        for (int level = 0; law.general && level < 3; level++) {
            const struct force_kernel *kernel = force_kernel_find(walk_level_name(level));
            if (kernel == NULL)
                continue;
            rub_once(&law, kernel, false, &r);
            rub_once(&law, kernel, true, &r);
            tried++;
        }
    }
    assert_true(levels > 0 && tried > levels * OPTIONS / 2);
}

TEST_MAIN(law_loops, cmocka_unit_test(test_columns), cmocka_unit_test(test_rub),
          cmocka_unit_test(test_resist))
