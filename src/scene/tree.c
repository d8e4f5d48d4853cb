/* SPDX-License-Identifier: BSD-3-Clause */
/* Parses YAML into a tree and changes it. Read tree.h first. */
#include "scene/tree.h"

#include "core/memory.h"

#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { DEPTH_MAX = 64 };

static char *copy_text(const char *text, size_t length) {
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

/* Adds an entry (`key` and `child` taken over) to a mapping that has no such key. */
static void add_entry(struct tree_node *map, char *key, struct tree_node *child) {
    make_room(map);
    map->key[map->children] = key;
    map->child[map->children++] = child;
}

void tree_put(struct tree_node *map, const char *key, struct tree_node *child) {
    long k = find_key(map, key);
    if (k >= 0) {
        tree_free(&map->child[k]);
        map->child[k] = child;
    } else {
        add_entry(map, copy_text(key, strlen(key)), child);
    }
}

void tree_move(struct tree_node *from, struct tree_node *to,
               bool (*moves)(const void *context, const char *key), const void *context) {
    size_t kept = 0;
    for (size_t k = 0; k < from->children; k++) {
        if (moves(context, from->key[k])) {
            add_entry(to, from->key[k], from->child[k]);
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

/* Parsing. */

struct parse {
    yaml_parser_t parser;
    const char *file;
    long line; /* added to libyaml's line numbers; 0: command line, all lines are 0 */
    struct error *error;
};

static bool fail(struct parse *parse, size_t yaml_line, const char *what) {
    if (parse->line == 0)
        return error_set(parse->error, ERROR_USER, "command line: %s", what);
    return error_set(parse->error, ERROR_USER, "%s:%ld: %s", parse->file, (long)yaml_line + parse->line,
                     what);
}

static bool next(struct parse *parse, yaml_event_t *event) {
    if (yaml_parser_parse(&parse->parser, event))
        return true;
    const yaml_parser_t *parser = &parse->parser;
    char what[512];
    snprintf(what, sizeof(what), "not valid YAML: %s%s%s",
             parser->problem ? parser->problem : "cannot be read", parser->context ? " " : "",
             parser->context ? parser->context : "");
    return fail(parse, parser->problem_mark.line, what);
}

static struct tree_node *parse_node(struct parse *parse, yaml_event_t *event, int depth);

static long node_line(const struct parse *parse, const yaml_event_t *event) {
    return parse->line == 0 ? 0 : (long)event->start_mark.line + parse->line;
}

static struct tree_node *parse_scalar(struct parse *parse, yaml_event_t *event) {
    struct tree_node *node = tree_new(TREE_SCALAR, node_line(parse, event));
    node->text = copy_text((const char *)event->data.scalar.value, event->data.scalar.length);
    node->quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    return node;
}

static bool parse_list(struct parse *parse, struct tree_node *list, int depth) {
    for (;;) {
        yaml_event_t event;
        if (!next(parse, &event))
            return false;
        if (event.type == YAML_SEQUENCE_END_EVENT) {
            yaml_event_delete(&event);
            return true;
        }
        struct tree_node *child = parse_node(parse, &event, depth + 1);
        if (!child)
            return false;
        tree_append(list, child);
    }
}

/* The keys of a mapping that is being read, to find one that comes twice: a search tree (tsearch). */
struct keys {
    void *root;
};

static int compare_keys(const void *a, const void *b) {
    return strcmp(a, b);
}

/* Takes over a key event; the entry's value follows. */
static bool parse_entry(struct parse *parse, struct tree_node *map, struct keys *keys,
                        yaml_event_t *key_event, int depth) {
    size_t line = key_event->start_mark.line;
    struct tree_node *key = parse_node(parse, key_event, depth);
    if (!key)
        return false;
    bool good = key->kind == TREE_SCALAR && key->text[0];
    if (!good)
        fail(parse, line, "a key must be a name");
    if (good && tfind(key->text, &keys->root, compare_keys)) {
        char place[1200], what[2400];
        snprintf(what, sizeof(what), "key '%.200s' is given twice, first at %s", key->text,
                 tree_place(tree_get(map, key->text), parse->file, place, sizeof(place)));
        good = fail(parse, line, what);
    }
    yaml_event_t event;
    struct tree_node *child = good && next(parse, &event) ? parse_node(parse, &event, depth + 1) : NULL;
    if (child) {
        /* a mapping or list begins a line below its key: name the line of the key */
        child->line = parse->line == 0 ? 0 : (long)line + parse->line;
        add_entry(map, key->text, child);
        if (!tsearch(key->text, &keys->root, compare_keys))
            error_fatal("out of memory: keys of a scene");
        key->text = NULL;
    }
    tree_free(&key);
    return child != NULL;
}

static bool parse_entries(struct parse *parse, struct tree_node *map, struct keys *keys, int depth) {
    for (;;) {
        yaml_event_t event;
        if (!next(parse, &event))
            return false;
        if (event.type == YAML_MAPPING_END_EVENT) {
            yaml_event_delete(&event);
            return true;
        }
        if (!parse_entry(parse, map, keys, &event, depth))
            return false;
    }
}

static bool parse_map(struct parse *parse, struct tree_node *map, int depth) {
    struct keys keys = {NULL};
    bool good = parse_entries(parse, map, &keys, depth);
    while (keys.root)
        tdelete(*(const char **)keys.root, &keys.root, compare_keys);
    return good;
}

/* True if the event carries an anchor or a tag. */
static bool decorated(const yaml_event_t *event) {
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        return event->data.scalar.anchor || event->data.scalar.tag;
    case YAML_SEQUENCE_START_EVENT:
        return event->data.sequence_start.anchor || event->data.sequence_start.tag;
    case YAML_MAPPING_START_EVENT:
        return event->data.mapping_start.anchor || event->data.mapping_start.tag;
    default:
        return false;
    }
}

/* Takes over `event`. NULL on failure. */
static struct tree_node *parse_node(struct parse *parse, yaml_event_t *event, int depth) {
    struct tree_node *node = NULL;
    bool good = false;
    if (depth > DEPTH_MAX)
        fail(parse, event->start_mark.line, "nested too deep");
    else if (event->type == YAML_ALIAS_EVENT || decorated(event))
        fail(parse, event->start_mark.line, "anchors, aliases and tags (&, *, !) are not understood");
    else if (event->type == YAML_SCALAR_EVENT) {
        node = parse_scalar(parse, event);
        good = true;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        node = tree_new(TREE_LIST, node_line(parse, event));
        good = parse_list(parse, node, depth);
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        node = tree_new(TREE_MAP, node_line(parse, event));
        good = parse_map(parse, node, depth);
    } else {
        fail(parse, event->start_mark.line, "a value is missing");
    }
    yaml_event_delete(event);
    if (!good)
        tree_free(&node);
    return node;
}

/* The next event, which must be of this type. */
static bool expect(struct parse *parse, yaml_event_type_t type, const char *what) {
    yaml_event_t event;
    if (!next(parse, &event))
        return false;
    bool good = event.type == type || fail(parse, event.start_mark.line, what);
    yaml_event_delete(&event);
    return good;
}

static struct tree_node *parse_stream(struct parse *parse) {
    yaml_event_t event;
    if (!expect(parse, YAML_STREAM_START_EVENT, "not valid YAML") || !next(parse, &event))
        return NULL;
    bool empty = event.type == YAML_STREAM_END_EVENT;
    yaml_event_delete(&event);
    if (empty)
        return tree_new(TREE_MAP, parse->line);
    if (!next(parse, &event))
        return NULL;
    struct tree_node *root = parse_node(parse, &event, 0);
    if (root && (!expect(parse, YAML_DOCUMENT_END_EVENT, "not valid YAML") ||
                 !expect(parse, YAML_STREAM_END_EVENT, "a second document ('---') is not understood")))
        tree_free(&root);
    return root;
}

struct tree_node *tree_parse(const char *file, const char *text, long line, struct error *error) {
    struct parse parse = {.file = file, .line = line, .error = error};
    if (!yaml_parser_initialize(&parse.parser)) {
        error_set(error, ERROR_SYSTEM, "out of memory while parsing %s", file);
        return NULL;
    }
    yaml_parser_set_input_string(&parse.parser, (const unsigned char *)text, strlen(text));
    struct tree_node *root = parse_stream(&parse);
    yaml_parser_delete(&parse.parser);
    return root;
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
