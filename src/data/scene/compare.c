/* SPDX-License-Identifier: BSD-3-Clause */
/* Compares the trees of two scenes, entry by entry. Read compare.h first. */
#include "data/scene/compare.h"

#include "base/memory.h"
#include "data/scene/tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { KEY_MAX = 512 };

static void print_value(FILE *out, const struct tree_node *node) {
    bool map = node->kind == TREE_MAP;
    if (node->kind == TREE_SCALAR) {
        fprintf(out, "%s", node->text);
        return;
    }
    fprintf(out, map ? "{" : "[");
    for (size_t k = 0; k < node->children; k++) {
        fprintf(out, "%s%s%s", k ? ", " : "", map ? node->key[k] : "", map ? ": " : "");
        print_value(out, node->child[k]);
    }
    fprintf(out, map ? "}" : "]");
}

/* The value of a node as text; memory_free. NULL of NULL. */
static char *value_of(const struct tree_node *node) {
    char *text = NULL;
    size_t size = 0;
    if (node == NULL)
        return NULL;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        error_fatal("out of memory while comparing scenes");
    print_value(out, node);
    fclose(out);
    char *copy = memory_allocate(size + 1, 1, "value of a scene");
    memcpy(copy, text, size + 1);
    free(text);
    return copy;
}

/* Adds a change unless the values are the same. */
static void add(struct scene_changes *all, const char *key, const struct tree_node *then,
                const struct tree_node *now) {
    struct scene_change change = {.then = value_of(then), .now = value_of(now)};
    if (change.then && change.now && strcmp(change.then, change.now) == 0) {
        memory_free(change.then);
        memory_free(change.now);
        return;
    }
    change.key = memory_allocate(strlen(key) + 1, 1, "key of a scene");
    strcpy(change.key, key);
    all->change = memory_resize(all->change, all->count + 1, sizeof *all->change, "changes of a scene");
    all->change[all->count++] = change;
}

/* Writes the label of an element of a list: its name, or the materials between which it holds; else its
 * place. */
static void label_of(const struct tree_node *element, size_t place, char label[KEY_MAX]) {
    const struct tree_node *name = element->kind == TREE_MAP ? tree_get(element, "name") : NULL;
    if (element->kind == TREE_MAP && name == NULL)
        name = tree_get(element, "between");
    char *text = name ? value_of(name) : NULL;
    if (text && name->kind == TREE_LIST) /* without its brackets */
        snprintf(label, KEY_MAX, "%.*s", (int)(strlen(text) - 2), text + 1);
    else if (text)
        snprintf(label, KEY_MAX, "%.200s", text);
    else
        snprintf(label, KEY_MAX, "%zu", place);
    memory_free(text);
}

static const struct tree_node *find_element(const struct tree_node *list, const char *label) {
    char other[KEY_MAX];
    for (size_t k = 0; list && k < list->children; k++) {
        label_of(list->child[k], k, other);
        if (strcmp(other, label) == 0)
            return list->child[k];
    }
    return NULL;
}

/* True for a list of sections; others are values. */
static bool has_elements(const struct tree_node *node) {
    return node && node->kind == TREE_LIST && node->children > 0 && node->child[0]->kind == TREE_MAP;
}

static void compare_nodes(struct scene_changes *all, const char *key, const struct tree_node *then,
                          const struct tree_node *now);

static void compare_lists(struct scene_changes *all, const char *key, const struct tree_node *then,
                          const struct tree_node *now) {
    char label[KEY_MAX], path[KEY_MAX];
    for (size_t k = 0; now && k < now->children; k++) {
        label_of(now->child[k], k, label);
        snprintf(path, sizeof path, "%.250s[%.250s]", key, label);
        compare_nodes(all, path, find_element(then, label), now->child[k]);
    }
    for (size_t k = 0; then && k < then->children; k++) {
        label_of(then->child[k], k, label);
        snprintf(path, sizeof path, "%.250s[%.250s]", key, label);
        if (!find_element(now, label))
            add(all, path, then->child[k], NULL);
    }
}

static void compare_maps(struct scene_changes *all, const char *key, const struct tree_node *then,
                         const struct tree_node *now) {
    char path[KEY_MAX];
    for (size_t k = 0; k < now->children; k++) {
        snprintf(path, sizeof path, "%.250s%s%.250s", key, key[0] ? "." : "", now->key[k]);
        compare_nodes(all, path, tree_get(then, now->key[k]), now->child[k]);
    }
    for (size_t k = 0; k < then->children; k++) {
        snprintf(path, sizeof path, "%.250s%s%.250s", key, key[0] ? "." : "", then->key[k]);
        if (!tree_get(now, then->key[k]))
            compare_nodes(all, path, then->child[k], NULL);
    }
}

static void compare_nodes(struct scene_changes *all, const char *key, const struct tree_node *then,
                          const struct tree_node *now) {
    if (then && now && then->kind == TREE_MAP && now->kind == TREE_MAP)
        compare_maps(all, key, then, now);
    else if (has_elements(then) || has_elements(now))
        compare_lists(all, key, has_elements(then) ? then : NULL, has_elements(now) ? now : NULL);
    else
        add(all, key, then, now);
}

bool scene_compare(const char *file, const char *then, const char *now, struct scene_changes *changes,
                   struct error *error) {
    *changes = (struct scene_changes){0};
    struct tree_node *before = tree_parse(file, then, 1, error), *after = NULL;
    if (before)
        after = tree_parse(file, now, 1, error);
    if (after)
        compare_nodes(changes, "", before, after);
    tree_free(&before);
    tree_free(&after);
    return error->kind == ERROR_NONE;
}

void scene_changes_free(struct scene_changes *changes) {
    for (size_t k = 0; k < changes->count; k++) {
        memory_free(changes->change[k].key);
        memory_free(changes->change[k].then);
        memory_free(changes->change[k].now);
    }
    memory_free(changes->change);
    *changes = (struct scene_changes){0};
}
