/* SPDX-License-Identifier: BSD-3-Clause */
/* What differs between two effective scenes. */
#include "tests/test.h"

#include "data/scene/compare.h"

#include <string.h>

static void expect(const struct scene_changes *changes, size_t k, const char *key, const char *then,
                   const char *now) {
    assert_true(k < changes->count);
    const struct scene_change *change = &changes->change[k];
    assert_string_equal(change->key, key);
    assert_true((change->then == NULL) == (then == NULL) && (change->now == NULL) == (now == NULL));
    if (then)
        assert_string_equal(change->then, then);
    if (now)
        assert_string_equal(change->now, now);
}

static void the_same_has_no_changes(void **state) {
    (void)state;
    struct scene_changes changes;
    struct error error = {0};
    static const char text[] = "step: {dt: 0.1}\nwalls: [{name: floor, point: [0, 0, 1]}]\n";
    assert_true(scene_compare("x", text, text, &changes, &error));
    assert_int_equal(changes.count, 0);
    scene_changes_free(&changes);
}

static void elements_are_matched_by_name(void **state) {
    (void)state;
    struct scene_changes changes;
    struct error error = {0};
    assert_true(scene_compare("x",
                              "materials: [{name: a, density: 1}, {name: b, density: 2}]\n"
                              "material_pairs: [{k_n: 5}, {between: [a, b], k_n: 6}]\n"
                              "gravity: [0, 0, 1]\nunits: none\n",
                              "materials: [{name: b, density: 3}, {name: a, density: 1}]\n"
                              "material_pairs: [{k_n: 5}, {between: [a, b], k_n: 7}]\n"
                              "gravity: [0, 0, 2]\nstep: {dt: 1}\n",
                              &changes, &error));
    assert_int_equal(changes.count, 5);
    expect(&changes, 0, "materials[b].density", "2", "3");
    expect(&changes, 1, "material_pairs[a, b].k_n", "6", "7");
    expect(&changes, 2, "gravity", "[0, 0, 1]", "[0, 0, 2]");
    expect(&changes, 3, "step", NULL, "{dt: 1}");
    expect(&changes, 4, "units", "none", NULL);
    scene_changes_free(&changes);
}

static void elements_may_come_and_go(void **state) {
    (void)state;
    struct scene_changes changes;
    struct error error = {0};
    assert_true(scene_compare("x", "walls: [{name: gate, r: 1}, {name: floor, r: 2}]\n",
                              "walls: [{name: floor, r: 2}, {name: lid, r: 3}]\n", &changes, &error));
    assert_int_equal(changes.count, 2);
    expect(&changes, 0, "walls[lid]", NULL, "{name: lid, r: 3}");
    expect(&changes, 1, "walls[gate]", "{name: gate, r: 1}", NULL);
    scene_changes_free(&changes);
}

static void what_is_no_scene_is_refused(void **state) {
    (void)state;
    struct scene_changes changes;
    struct error error = {0};
    assert_false(scene_compare("file.h5", "a: [1\n", "a: 1\n", &changes, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "file.h5"));
    scene_changes_free(&changes);
}

TEST_MAIN(scene_compare, cmocka_unit_test(the_same_has_no_changes),
          cmocka_unit_test(elements_are_matched_by_name), cmocka_unit_test(elements_may_come_and_go),
          cmocka_unit_test(what_is_no_scene_is_refused))
