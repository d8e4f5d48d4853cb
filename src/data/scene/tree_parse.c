/* SPDX-License-Identifier: BSD-3-Clause */
/* Parses YAML into a tree by the events of libyaml. Read tree.h first. */
#include "base/memory.h"
#include "data/scene/tree.h"
#include "data/scene/tree_advice.h"

#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 64, NODES_MAX = 200000, COPIES_MAX = 100000, ANCHOR_MAX = 64 };

/* A node with a name, for the aliases that follow. */
struct anchor {
    char name[ANCHOR_MAX];
    const struct tree_node *node; /* borrowed from the tree */
};

struct parse {
    yaml_parser_t parser;
    const char *file, *text;
    long line; /* added to libyaml's line numbers; 0: command line, all lines are 0 */
    struct anchor *anchor;
    size_t anchors, nodes, copies; /* nodes that text and aliases have made so far */
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
    char what[512];
    size_t line = tree_advice(&parse->parser, parse->text, parse->line, what, sizeof(what));
    return fail(parse, line, what);
}

static struct tree_node *parse_node(struct parse *parse, yaml_event_t *event, int depth);

static long node_line(const struct parse *parse, const yaml_event_t *event) {
    return parse->line == 0 ? 0 : (long)event->start_mark.line + parse->line;
}

static struct tree_node *parse_scalar(struct parse *parse, yaml_event_t *event) {
    struct tree_node *node = tree_new(TREE_SCALAR, node_line(parse, event));
    node->text = tree_text((const char *)event->data.scalar.value, event->data.scalar.length);
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

/* Adds an entry (`key` and `child` taken over) that the mapping does not have. */
static void enter(struct tree_node *map, struct keys *keys, char *key, struct tree_node *child) {
    tree_add(map, key, child);
    if (!tsearch(key, &keys->root, compare_keys))
        error_fatal("out of memory: keys of a scene");
}

/* Adds the entries of mapping `from` (taken over) that the mapping does not have yet. */
static void merge_map(struct tree_node *map, struct keys *keys, struct tree_node *from) {
    for (size_t k = 0; k < from->children; k++) {
        if (tfind(from->key[k], &keys->root, compare_keys))
            continue;
        enter(map, keys, tree_text(from->key[k], strlen(from->key[k])), from->child[k]);
        from->child[k] = tree_new(TREE_SCALAR, 0);
    }
    tree_free(&from);
}

/* Merges what stands under '<<', a mapping or a list of mappings (taken over); earlier ones win. */
static bool merge(struct parse *parse, struct tree_node *map, struct keys *keys, struct tree_node *from,
                  size_t line) {
    bool good = from->kind == TREE_MAP || from->kind == TREE_LIST;
    for (size_t k = 0; from->kind == TREE_LIST && k < from->children; k++)
        good = good && from->child[k]->kind == TREE_MAP;
    if (!good) {
        tree_free(&from);
        return fail(parse, line, "'<<' takes in the keys of other sections: <<: *name, or <<: [*a, *b]");
    }
    if (from->kind == TREE_MAP) {
        merge_map(map, keys, from);
        return true;
    }
    while (from->children > 0)
        merge_map(map, keys, tree_take(from, 0));
    tree_free(&from);
    return true;
}

/* True if the key may come now: a name that did not come before. */
static bool key_suits(struct parse *parse, const struct tree_node *map, const struct keys *keys,
                      const struct tree_node *key, size_t line) {
    if (key->kind != TREE_SCALAR || !key->text[0])
        return fail(parse, line, "a key must be a name");
    if (!tfind(key->text, &keys->root, compare_keys))
        return true;
    char place[1200], what[2400];
    snprintf(what, sizeof(what), "key '%.200s' is given twice, first at %s", key->text,
             tree_place(tree_get(map, key->text), parse->file, place, sizeof(place)));
    return fail(parse, line, what);
}

/* Takes over a key event; the entry's value follows. What stands under '<<' goes to *merged. */
static bool parse_entry(struct parse *parse, struct tree_node *map, struct keys *keys,
                        struct tree_node **merged, yaml_event_t *key_event, int depth) {
    size_t line = key_event->start_mark.line;
    struct tree_node *key = parse_node(parse, key_event, depth);
    if (!key)
        return false;
    bool good = key_suits(parse, map, keys, key, line), merges = good && !key->quoted;
    merges = merges && strcmp(key->text, "<<") == 0;
    if (merges && *merged)
        good = fail(parse, line, "key '<<' is given twice; write <<: [*a, *b]");
    yaml_event_t event;
    struct tree_node *child = good && next(parse, &event) ? parse_node(parse, &event, depth + 1) : NULL;
    if (child) {
        /* a mapping or list begins a line below its key: name the line of the key */
        child->line = parse->line == 0 ? 0 : (long)line + parse->line;
        if (merges) {
            *merged = child;
        } else {
            enter(map, keys, key->text, child);
            key->text = NULL;
        }
    }
    tree_free(&key);
    return child != NULL;
}

static bool parse_entries(struct parse *parse, struct tree_node *map, struct keys *keys,
                          struct tree_node **merged, int depth) {
    for (;;) {
        yaml_event_t event;
        if (!next(parse, &event))
            return false;
        if (event.type == YAML_MAPPING_END_EVENT) {
            yaml_event_delete(&event);
            return true;
        }
        if (!parse_entry(parse, map, keys, merged, &event, depth))
            return false;
    }
}

static bool parse_map(struct parse *parse, struct tree_node *map, int depth, size_t line) {
    struct keys keys = {NULL};
    struct tree_node *merged = NULL;
    bool good = parse_entries(parse, map, &keys, &merged, depth);
    if (good && merged)
        good = merge(parse, map, &keys, merged, line);
    else
        tree_free(&merged);
    while (keys.root)
        tdelete(*(const char **)keys.root, &keys.root, compare_keys);
    return good;
}

/* The anchor and the tag of an event, NULL without. */
static const char *anchor_of(const yaml_event_t *event, const char **tag) {
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        *tag = (const char *)event->data.scalar.tag;
        return (const char *)event->data.scalar.anchor;
    case YAML_SEQUENCE_START_EVENT:
        *tag = (const char *)event->data.sequence_start.tag;
        return (const char *)event->data.sequence_start.anchor;
    case YAML_MAPPING_START_EVENT:
        *tag = (const char *)event->data.mapping_start.tag;
        return (const char *)event->data.mapping_start.anchor;
    default:
        *tag = NULL;
        return NULL;
    }
}

/* A copy of a node and of all below it; NULL if aliases have made too many nodes already. */
static struct tree_node *copy(struct parse *parse, const struct tree_node *node) {
    if (parse->copies++ >= COPIES_MAX)
        return NULL;
    struct tree_node *twin = tree_new(node->kind, node->line);
    twin->quoted = node->quoted;
    if (node->text)
        twin->text = tree_text(node->text, strlen(node->text));
    for (size_t k = 0; k < node->children; k++) {
        struct tree_node *child = copy(parse, node->child[k]);
        if (!child) {
            tree_free(&twin);
            return NULL;
        }
        if (node->kind == TREE_MAP)
            tree_add(twin, tree_text(node->key[k], strlen(node->key[k])), child);
        else
            tree_append(twin, child);
    }
    return twin;
}

/* What an alias stands for: the last node before it with this anchor. */
static struct tree_node *parse_alias(struct parse *parse, const yaml_event_t *event) {
    const char *name = (const char *)event->data.alias.anchor;
    char what[160];
    for (size_t k = parse->anchors; k-- > 0;) {
        if (strcmp(parse->anchor[k].name, name) != 0)
            continue;
        struct tree_node *node = copy(parse, parse->anchor[k].node);
        if (!node)
            fail(parse, event->start_mark.line, "aliases (*) make the scene too large");
        return node;
    }
    snprintf(what, sizeof(what), "'*%.60s' stands for nothing: no '&%.60s' comes before it", name, name);
    fail(parse, event->start_mark.line, what);
    return NULL;
}

static void anchor_add(struct parse *parse, const char *name, const struct tree_node *node) {
    parse->anchor =
        memory_resize(parse->anchor, parse->anchors + 1, sizeof(*parse->anchor), "anchors of a scene");
    struct anchor *anchor = &parse->anchor[parse->anchors++];
    snprintf(anchor->name, sizeof(anchor->name), "%s", name);
    anchor->node = node;
}

/* Makes the node of an event that is no alias. NULL on failure. */
static struct tree_node *parse_content(struct parse *parse, yaml_event_t *event, int depth) {
    struct tree_node *node = NULL;
    bool good = false;
    if (parse->nodes++ == NODES_MAX) {
        char what[160];
        snprintf(what, sizeof(what),
                 "more than %d keys and values up to here; tables of particles and the like belong into "
                 "files of their own",
                 NODES_MAX);
        fail(parse, event->start_mark.line, what);
    } else if (event->type == YAML_SCALAR_EVENT) {
        node = parse_scalar(parse, event);
        good = true;
    } else if (event->type == YAML_SEQUENCE_START_EVENT) {
        node = tree_new(TREE_LIST, node_line(parse, event));
        good = parse_list(parse, node, depth);
    } else if (event->type == YAML_MAPPING_START_EVENT) {
        node = tree_new(TREE_MAP, node_line(parse, event));
        good = parse_map(parse, node, depth, event->start_mark.line);
    } else {
        fail(parse, event->start_mark.line, "a value is missing");
    }
    if (!good)
        tree_free(&node);
    return node;
}

/* Takes over `event`. NULL on failure. */
static struct tree_node *parse_node(struct parse *parse, yaml_event_t *event, int depth) {
    struct tree_node *node = NULL;
    const char *tag, *anchor = anchor_of(event, &tag);
    if (depth > DEPTH_MAX)
        fail(parse, event->start_mark.line, "nested too deep");
    else if (tag)
        fail(parse, event->start_mark.line, "tags (!) are not understood");
    else if (anchor && strlen(anchor) >= ANCHOR_MAX)
        fail(parse, event->start_mark.line, "the name of an anchor (&) is too long");
    else if (event->type == YAML_ALIAS_EVENT)
        node = parse_alias(parse, event);
    else
        node = parse_content(parse, event, depth);
    if (node && anchor)
        anchor_add(parse, anchor, node);
    yaml_event_delete(event);
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
    struct parse parse = {.file = file, .text = text, .line = line, .error = error};
    if (!yaml_parser_initialize(&parse.parser)) {
        error_set(error, ERROR_SYSTEM, "out of memory while parsing %s", file);
        return NULL;
    }
    yaml_parser_set_input_string(&parse.parser, (const unsigned char *)text, strlen(text));
    struct tree_node *root = parse_stream(&parse);
    yaml_parser_delete(&parse.parser);
    memory_free(parse.anchor);
    return root;
}
