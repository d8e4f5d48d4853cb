/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of keys itself: that its rows are sound, and that what is made of them agrees. */
#include "data/scene/scene_text.h"
#include "data/scene/schema.h"
#include "data/scene/schema_help.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_unknown.h"
#include "data/scene/schema_value.h"
#include "tests/scene_by_hand.h"

static int rows;

static void row_is_sound(void *context, const struct schema_row *row, const char *key, int depth) {
    (void)context;
    (void)depth;
    rows++;
    if (!row->help || !row->help[0])
        fail_msg("%s has no help", key);
    if (strlen(key) > 60)
        fail_msg("%s is too long", key);
    bool group = row->type == SCHEMA_SECTION || row->type == SCHEMA_LIST;
    if (group != (row->sub != NULL) || (row->type == SCHEMA_NAME) != (row->names != NULL) ||
        (row->type == SCHEMA_CHOICE) != (row->choice != NULL))
        fail_msg("%s: type and what belongs to it differ", key);
    if (row->required && row->fallback)
        fail_msg("%s is required and has a default", key);
    if (row->required && !group && row->type != SCHEMA_CHOICE && !row->example)
        fail_msg("%s is required and has no example", key);
    if (row->main && !schema_row_find(row->sub, row->main, strlen(row->main)))
        fail_msg("%s: no main key %s", key, row->main);
    char full[SCHEMA_KEY_MAX];
    if (strcmp(schema_find(key, full)->key, row->key) != 0 || strcmp(full, key) != 0)
        fail_msg("%s does not find itself", key);
    char allowed[512];
    schema_allowed(row, allowed, sizeof(allowed));
    assert_true(strlen(allowed) > 3);
}

static void rows_are_sound(void **state) {
    (void)state;
    rows = 0;
    schema_walk(row_is_sound, NULL);
    assert_true(rows > 150);
}

/* Rows of one key each have a condition. */
static void table_is_unique(const struct schema_table *table) {
    for (int a = 0; a < table->count; a++) {
        for (int b = 0; b < a; b++) {
            if (strcmp(table->rows[a].key, table->rows[b].key) != 0)
                continue;
            assert_true(table->rows[a].when && table->rows[b].when);
        }
        if (table->rows[a].sub)
            table_is_unique(table->rows[a].sub);
    }
}

static void keys_are_unique(void **state) {
    (void)state;
    table_is_unique(&schema_root);
}

/* A trait that some value has and some has not. */
static void trait_is_sound(const struct schema_row *row, const char *trait) {
    size_t length = strcspn(trait, " ");
    int with = 0, without = 0;
    assert_int_equal(row->type, SCHEMA_NAME);
    for (int k = 0; row->names[k].name; k++) {
        const char *traits = row->traits(row->names[k].value);
        bool has = false;
        for (const char *word = traits; *word; word += strcspn(word, " "), word += strspn(word, " "))
            has = has || (strcspn(word, " ") == length && memcmp(word, trait, length) == 0);
        with += has;
        without += !has;
    }
    assert_true(with > 0 && without > 0);
}

/* Each condition "key=a|b" or "key:trait" names a key that stands before, and values that it has. */
static void condition_is_sound(const struct schema_table *table, const char *condition) {
    if (*condition == '/') {
        table = &schema_root;
        condition++;
    }
    const struct schema_row *row = NULL;
    for (;;) {
        size_t part = strcspn(condition, ".=:");
        row = schema_row_find(table, condition, part);
        assert_non_null(row);
        char mark = condition[part];
        condition += part + 1;
        if (mark == ':') {
            trait_is_sound(row, condition);
            return;
        }
        if (mark == '=')
            break;
        table = row->sub;
    }
    while (*condition && *condition != ' ') {
        size_t length = strcspn(condition, "| ");
        bool found = false;
        assert_int_equal(row->type == SCHEMA_NAME || row->type == SCHEMA_CHOICE, 1);
        for (int k = 0; row->type == SCHEMA_NAME && row->names[k].name; k++)
            found = found || (strlen(row->names[k].name) == length &&
                              memcmp(row->names[k].name, condition, length) == 0);
        const char *name, *help;
        for (int k = 0; row->type == SCHEMA_CHOICE && (name = row->choice(k, &help)); k++)
            found = found || (strlen(name) == length && memcmp(name, condition, length) == 0);
        if (!found)
            fail_msg("no value %s", condition);
        condition += length + (condition[length] == '|');
    }
}

static void table_conditions(const struct schema_table *table) {
    for (int k = 0; k < table->count; k++) {
        for (const char *c = table->rows[k].when; c; c = strstr(c, " & ") ? strstr(c, " & ") + 3 : NULL)
            condition_is_sound(table, c);
        if (table->rows[k].sub)
            table_conditions(table->rows[k].sub);
    }
}

static void conditions_are_sound(void **state) {
    (void)state;
    table_conditions(&schema_root);
}

/* Reads one text into a row of a struct of its own. */
static bool reads(const struct schema_row *row, const char *text, char *why, size_t room) {
    static char root[sizeof(struct scene)];
    char *base = memory_allocate_zero(
        1, row->offset + row->size * (size_t)(row->max + 1) + row->count_offset + 4096, "row");
    struct error error = {0};
    struct scene *scene = (struct scene *)root;
    scene->materials = 2;
    strcpy(scene->material[0].name, "glass");
    strcpy(scene->material[1].name, "steel");
    scene->groups = 1;
    strcpy(scene->group[0].name, "free");
    struct schema_reader reader = {.file = "x", .folder = "", .root = root, .units = true, .error = &error};
    struct tree_node *node = tree_parse("x", text[0] ? text : "''", 1, &error);
    bool good = node && schema_value(&reader, row, node, row->key, base);
    snprintf(why, room, "%s", error.text);
    tree_free(&node);
    memory_free(base);
    return good;
}

static void row_reads(void *context, const struct schema_row *row, const char *key, int depth) {
    (void)context;
    (void)depth;
    char why[2048];
    if (row->sub)
        return;
    if (row->fallback && !reads(row, row->fallback, why, sizeof(why)))
        fail_msg("default of %s: %s", key, why);
    bool listed = row->target && (strcmp(row->target, "groups") == 0 || strcmp(row->target, "walls") == 0);
    if (row->example && !listed && !reads(row, row->example, why, sizeof(why)))
        fail_msg("example of %s: %s", key, why);
}

static void defaults_and_examples_read(void **state) {
    (void)state;
    schema_walk(row_reads, NULL);
}

static void suggests(void **state) {
    (void)state;
    static const char *const cases[][3] = {{"", "gravty", "gravity"},
                                           {"walls[].", "raduis", "walls[].radius"},
                                           {"", "dt", "step.dt"},
                                           {"index.", "nam", "index.name"},
                                           {"particles.", "fiel", "particles.sources[].file"},
                                           {"", "newtn", "newton"}};
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        char nearest[SCHEMA_KEY_MAX];
        assert_true(schema_suggest(cases[k][0], cases[k][1], nearest));
        assert_string_equal(nearest, cases[k][2]);
    }
    char nearest[SCHEMA_KEY_MAX];
    assert_false(schema_suggest("", "xylophone", nearest));
}

/* All that scene_help or scene_document print. */
static char *printed(const char *key, bool document, bool *found) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    if (document)
        scene_document(out);
    else
        *found = scene_help(out, key);
    fclose(out);
    return text;
}

static void row_has_help(void *context, const struct schema_row *row, const char *key, int depth) {
    (void)depth;
    bool found;
    assert_non_null(strstr(context, key));
    char *text = printed(key, false, &found);
    assert_true(found);
    assert_non_null(strstr(text, key));
    assert_non_null(strstr(text, row->help));
    free(text);
}

static void helps(void **state) {
    (void)state;
    bool found;
    char *all = printed(NULL, false, &found);
    assert_true(found);
    schema_walk(row_has_help, all);
    free(all);
    char *short_form = printed("particles.file", false, &found);
    assert_true(found);
    assert_non_null(strstr(short_form, "particles.sources[].file"));
    free(short_form);
    char *missing = printed("gravty", false, &found);
    assert_false(found);
    assert_non_null(strstr(missing, "'gravity'"));
    free(missing);
}

/* docs/scene.md is what the program writes. */
static void document_is_current(void **state) {
    (void)state;
    const char *top = getenv("top_srcdir");
    char path[1024];
    snprintf(path, sizeof(path), "%s/docs/scene.md", top ? top : ".");
    struct error error = {0};
    char *stored;
    if (!scene_read_text(path, &stored, NULL, &error))
        fail_msg("%s", error.text);
    bool found;
    char *now = printed(NULL, true, &found);
    if (strcmp(now, stored) != 0)
        fail_msg("docs/scene.md is not what the program writes: run `make pages`");
    free(now);
    memory_free(stored);
}

TEST_MAIN(schema, cmocka_unit_test(rows_are_sound), cmocka_unit_test(keys_are_unique),
          cmocka_unit_test(conditions_are_sound), cmocka_unit_test(defaults_and_examples_read),
          cmocka_unit_test(suggests), cmocka_unit_test(helps), cmocka_unit_test(document_is_current))
