/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes and changes the nodes of a tree. Read tree.h first. */
#include "data/scene/tree.h"

#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *tree_text(const char *text, size_t length) {
    char *copy = memory_allocate(length + 1, 1, "scene text");
    memcpy(copy, text, length);
    copy[length] = '\0';
    return copy;
}

struct tree_node *tree_new(enum tree_kind kind, long line) {
    struct tree_node *node = memory_allocate_zero(1, sizeof(*node), "scene");
    node->kind = kind;
    node->line = line;
    return node;
}

void tree_clear(struct tree_node *node, enum tree_kind kind) {
    for (size_t k = 0; k < node->children; k++) {
        tree_free(&node->child[k]);
        if (node->key)
            memory_free(node->key[k]);
    }
    memory_free(node->child);
    memory_free(node->key);
    memory_free(node->text);
    *node = (struct tree_node){.kind = kind, .line = node->line};
}

void tree_free(struct tree_node **node) {
    if (!*node)
        return;
    tree_clear(*node, TREE_SCALAR);
    memory_free(*node);
    *node = NULL;
}

static long find_key(const struct tree_node *map, const char *key) {
    for (size_t k = 0; map->kind == TREE_MAP && k < map->children; k++)
        if (strcmp(map->key[k], key) == 0)
            return (long)k;
    return -1;
}

struct tree_node *tree_get(const struct tree_node *map, const char *key) {
    long k = find_key(map, key);
    return k < 0 ? NULL : map->child[k];
}

/* Room for one child more: arrays double where their size is a power of two. */
static void make_room(struct tree_node *node) {
    size_t n = node->children;
    if ((n & (n - 1)) != 0)
        return;
    size_t room = n ? 2 * n : 1;
    node->child = memory_resize(node->child, room, sizeof(*node->child), "scene");
    if (node->kind == TREE_MAP)
        node->key = memory_resize(node->key, room, sizeof(*node->key), "scene");
}

void tree_append(struct tree_node *list, struct tree_node *child) {
    make_room(list);
    list->child[list->children++] = child;
}

void tree_add(struct tree_node *map, char *key, struct tree_node *child) {
    make_room(map);
    map->key[map->children] = key;
    map->child[map->children++] = child;
}

struct tree_node *tree_copy(const struct tree_node *node) {
    struct tree_node *twin = tree_new(node->kind, node->line);
    twin->quoted = node->quoted;
    twin->implied = node->implied;
    if (node->text)
        twin->text = tree_text(node->text, strlen(node->text));
    for (size_t k = 0; k < node->children; k++) {
        struct tree_node *child = tree_copy(node->child[k]);
        if (node->kind == TREE_MAP)
            tree_add(twin, tree_text(node->key[k], strlen(node->key[k])), child);
        else
            tree_append(twin, child);
    }
    return twin;
}

void tree_put(struct tree_node *map, const char *key, struct tree_node *child) {
    long k = find_key(map, key);
    if (k >= 0) {
        tree_free(&map->child[k]);
        map->child[k] = child;
    } else {
        tree_add(map, tree_text(key, strlen(key)), child);
    }
}

void tree_move(struct tree_node *from, struct tree_node *to,
               bool (*moves)(const void *context, const char *key), const void *context) {
    size_t kept = 0;
    for (size_t k = 0; k < from->children; k++) {
        if (moves(context, from->key[k])) {
            tree_add(to, from->key[k], from->child[k]);
        } else {
            from->key[kept] = from->key[k];
            from->child[kept++] = from->child[k];
        }
    }
    from->children = kept;
}

struct tree_node *tree_take(struct tree_node *node, size_t k) {
    struct tree_node *child = node->child[k];
    if (node->key)
        memory_free(node->key[k]);
    node->children--;
    for (size_t i = k; i < node->children; i++) {
        node->child[i] = node->child[i + 1];
        if (node->key)
            node->key[i] = node->key[i + 1];
    }
    return child;
}

const char *tree_place(const struct tree_node *node, const char *file, char *place, size_t room) {
    if (node->line == 0)
        snprintf(place, room, "command line");
    else
        snprintf(place, room, "%s:%ld", file, node->line);
    return place;
}

const struct tree_node *tree_nearest(const struct tree_node *root, const char *key) {
    const struct tree_node *node = root;
    while (*key) {
        const struct tree_node *child = NULL;
        if (*key == '[') {
            char *end;
            unsigned long k = strtoul(key + 1, &end, 10);
            if (*end == ']' && node->kind == TREE_LIST && k < node->children)
                child = node->child[k];
            key = *end == ']' ? end + 1 : end;
        } else {
            size_t length = strcspn(key, ".[");
            char name[256];
            snprintf(name, sizeof(name), "%.*s", (int)length, key);
            child = tree_get(node, name);
            key += length;
        }
        if (!child)
            return node;
        node = child;
        key += *key == '.';
    }
    return node;
}
