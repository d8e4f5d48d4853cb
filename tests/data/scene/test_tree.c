/* SPDX-License-Identifier: BSD-3-Clause */
/* YAML trees: lines of nodes, changes, what is refused. */
#include "tests/test.h"

#include "data/scene/tree.h"

#include <stdio.h>
#include <string.h>

static void keeps_lines(void **state) {
    (void)state;
    struct error error = {0};
    struct tree_node *root = tree_parse("s.yaml", "a: 1\nb:\n  - c: x\n  - {c: 'y z'}\n", 1, &error);
    assert_non_null(root);
    assert_int_equal(tree_get(root, "a")->line, 1);
    assert_int_equal(tree_get(root, "b")->line, 2);
    assert_null(tree_get(root, "c"));
    const struct tree_node *node = tree_nearest(root, "b[1].c");
    assert_string_equal(node->text, "y z");
    assert_true(node->quoted);
    assert_int_equal(node->line, 4);
    char place[64];
    assert_string_equal(tree_place(tree_nearest(root, "b[0].d"), "s.yaml", place, sizeof(place)), "s.yaml:3");
    assert_string_equal(tree_place(tree_nearest(root, "b[7].d"), "s.yaml", place, sizeof(place)), "s.yaml:2");
    tree_free(&root);
    assert_null(root);
}

static void changes(void **state) {
    (void)state;
    struct error error = {0};
    struct tree_node *root = tree_parse("s.yaml", "a: 1\nb: 2\nc: 3", 1, &error);
    tree_put(root, "b", tree_new(TREE_LIST, 0));
    tree_append(tree_get(root, "b"), tree_new(TREE_MAP, 0));
    assert_int_equal(tree_nearest(root, "b[0]")->kind, TREE_MAP);
    struct tree_node *taken = tree_take(root, 0);
    assert_string_equal(taken->text, "1");
    assert_int_equal(root->children, 2);
    assert_string_equal(root->key[0], "b");
    tree_free(&taken);
    char place[64];
    assert_string_equal(tree_place(tree_get(root, "b"), "s.yaml", place, sizeof(place)), "command line");
    tree_free(&root);
}

static void refuses(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"a: 1\nb: 2\na: 3\n", "s.yaml:3: key 'a' is given twice, first at s.yaml:1"},
        {"a: *x\nb: &x 1\n", "s.yaml:1: '*x' stands for nothing"},
        {"a: &x [*x]\n", "s.yaml:1: '*x' stands for nothing"},
        {"a: 1\n<<: 2\n", "s.yaml:1: '<<' takes in the keys"},
        {"a: {b: 1, <<: {}, <<: {}}\n", "s.yaml:1: key '<<' is given twice"},
        {"a: !!str 1\n", "s.yaml:1: tags"},
        {"a:\n  b: 1\n   c: 2\n", "s.yaml:3: not valid YAML: mapping values"},
        {"a:\n  b: 1\n c: 2\n", "which begins in line 1"},
        {"x: 0\na\nb: 1\n", "s.yaml:2: not valid YAML: could not find expected ':'"},
        {"a: 1\nb: 'open\nc: 2\n", "s.yaml:2: not valid YAML"},
        {"a: 1\n---\nb: 2\n", "s.yaml:2: a second document"},
        {"a: [1, 2\nb: 3\n", "s.yaml:2: not valid YAML"},
        {"a:\n\tb: 2\n", "a tab indents this line"},
        {"a: \"open\n", "not valid YAML"},
        {"? [1, 2]\n: 3\n", "s.yaml:1: a key must be a name"},
        {"a: \xff\n", "not valid YAML"},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        struct error error = {0};
        struct tree_node *root = tree_parse("s.yaml", cases[k][0], 1, &error);
        assert_null(root);
        assert_int_equal(error.kind, ERROR_USER);
        if (!strstr(error.text, cases[k][1]))
            fail_msg("case %zu: %s", k, error.text);
    }
}

/* An alias is a copy of its anchor, with the lines of the anchor; what a mapping gives itself stays. */
static void aliases_are_copies(void **state) {
    (void)state;
    struct error error = {0};
    struct tree_node *root = tree_parse("s.yaml",
                                        "a: &a {x: 1, y: [2, 3]}\nb: *a\nc:\n  <<: *a\n  x: 4\n"
                                        "d: {<<: [{z: 6}, *a, {x: 7}]}\n'<<': 8\ne: &a 5\nf: *a\n",
                                        1, &error);
    assert_non_null(root);
    static const char *const expected[][2] = {{"b.x", "1"}, {"b.y[1]", "3"}, {"c.x", "4"}, {"c.y[0]", "2"},
                                              {"d.x", "1"}, {"d.z", "6"},    {"<<", "8"},  {"f", "5"}};
    for (size_t k = 0; k < sizeof(expected) / sizeof(expected[0]); k++) {
        const struct tree_node *node = tree_nearest(root, expected[k][0]);
        assert_int_equal(node->kind, TREE_SCALAR);
        assert_string_equal(node->text, expected[k][1]);
    }
    assert_int_equal(tree_nearest(root, "b.y[1]")->line, 1);
    assert_null(tree_get(tree_get(root, "c"), "<<"));
    tree_free(&root);
}

/* Aliases of aliases cannot fill the memory. */
static void refuses_many_copies(void **state) {
    (void)state;
    char text[400] = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
    for (int k = 1; k < 7; k++) {
        size_t used = strlen(text);
        snprintf(text + used, sizeof(text) - used, "a%d: &a%d [*a%d, *a%d, *a%d, *a%d, *a%d, *a%d, *a%d]\n",
                 k, k, k - 1, k - 1, k - 1, k - 1, k - 1, k - 1, k - 1);
    }
    struct error error = {0};
    assert_null(tree_parse("s.yaml", text, 1, &error));
    assert_non_null(strstr(error.text, "too large"));
}

static void refuses_depth(void **state) {
    (void)state;
    char text[400] = "a: ";
    memset(text + 3, '[', 200);
    struct error error = {0};
    assert_null(tree_parse("s.yaml", text, 1, &error));
    assert_non_null(strstr(error.text, "nested too deep"));
}

static bool is_vowel(const void *vowels, const char *key) {
    return strpbrk(key, vowels) != NULL;
}

/* Some entries go to another mapping, in their order; the others close the gap. */
static void moves_entries(void **state) {
    (void)state;
    struct error error = {0};
    struct tree_node *root = tree_parse("s.yaml", "a: 1\nb: 2\nc: 3\ne: 4\nf: 5", 1, &error);
    struct tree_node *other = tree_parse("s.yaml", "x: 0", 1, &error);
    tree_move(root, other, is_vowel, "aeiou");
    assert_int_equal(root->children, 3);
    assert_int_equal(other->children, 3);
    assert_string_equal(root->key[1], "c");
    assert_string_equal(tree_get(root, "f")->text, "5");
    assert_string_equal(other->key[2], "e");
    assert_string_equal(tree_get(other, "a")->text, "1");
    assert_null(tree_get(root, "a"));
    tree_put(root, "a", tree_new(TREE_LIST, 0));
    assert_int_equal(root->children, 4);
    tree_free(&root);
    tree_free(&other);
}

static void empty_is_a_mapping(void **state) {
    (void)state;
    struct error error = {0};
    struct tree_node *root = tree_parse("s.yaml", "# nothing\n", 1, &error);
    assert_non_null(root);
    assert_int_equal(root->kind, TREE_MAP);
    tree_free(&root);
}

TEST_MAIN(tree, cmocka_unit_test(keeps_lines), cmocka_unit_test(changes), cmocka_unit_test(refuses),
          cmocka_unit_test(refuses_depth), cmocka_unit_test(aliases_are_copies),
          cmocka_unit_test(refuses_many_copies), cmocka_unit_test(moves_entries),
          cmocka_unit_test(empty_is_a_mapping))
