/* The schema: one row a key. Parsing, `scree help`, docs/scene.md and the echo of the effective scene all
 * walk these rows, so that none of them can know a key that the others do not.
 *
 * A table lists the keys of one section (a mapping); sections and lists name the table of what they hold. A
 * row says where in the section's struct its value lies, as offset and size. Rows are read in order: a row
 * may depend (`when`) on those before it. A key may have several rows, side by side, of whose conditions at most
 * one holds (its unit depends on a law, say). */
#ifndef SCREE_SCENE_SCHEMA_H
#define SCREE_SCENE_SCHEMA_H

#include "core/error.h"
#include "scene/tree.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum schema_type {
    SCHEMA_REAL,    /* double; without default: NAN */
    SCHEMA_VECTOR,  /* double[3]; a list of three, or two (z = 0) */
    SCHEMA_REALS,   /* double[max], count */
    SCHEMA_INT,     /* int */
    SCHEMA_LONG,    /* int64_t */
    SCHEMA_LONGS,   /* int64_t[max], count */
    SCHEMA_SEED,    /* uint64_t */
    SCHEMA_BOOL,    /* bool */
    SCHEMA_BOOLS,   /* bool[3]; a list of three, or one for all */
    SCHEMA_NAME,    /* int (or an enum) by a fixed list of names; without default: -1 */
    SCHEMA_CHOICE,  /* char[size], one of the names that a registry gives */
    SCHEMA_TEXT,    /* char[size] */
    SCHEMA_TEXTS,   /* char[max][size], count */
    SCHEMA_PATH,    /* char[size], a path relative to the scene file */
    SCHEMA_REF,     /* int: number of an entry of the list `target`, by its name; without default: -1 */
    SCHEMA_REFS,    /* int[max], count */
    SCHEMA_SECTION, /* a mapping with keys of its own */
    SCHEMA_LIST     /* a list of such mappings: element[max] of `size` bytes, count */
};

struct schema_name {
    const char *name;
    int value;
    const char *help; /* one line; NULL where the name says it */
};

struct schema_table {
    const struct schema_row *rows;
    int count;
};

struct schema_row {
    const char *key;
    const char *alias; /* an older name of the key, still read, with a note; NULL: none */
    enum schema_type type;
    const char *unit;     /* in SI ("m/s2"); NULL or "" for a pure number */
    const char *fallback; /* default, as YAML; NULL: none, the key may be left out */
    bool required;
    const char *range;                               /* interval, "(0, inf)" or "[0, 1]"; NULL: any */
    const struct schema_name *names;                 /* NAME: ended by a NULL name */
    const char *(*choice)(int k, const char **help); /* CHOICE: the k-th name, NULL after the last */
    const char *(*traits)(int value); /* NAME: words "a b" that conditions may ask for; NULL: none */
    const char *target;               /* REF, REFS: a list at the top level */
    bool in_column;   /* TEXT: part of a column's name in observables.csv, so without what would break that */
    const char *when; /* "shape=cylinder|plane": the key exists only then; "/contact.damping=restitution" from
                         the top; "/contact.law:moduli" (from the top alone): with all names that have the trait;
                         "a=b & c=d" */
    const struct schema_table *sub; /* SECTION, LIST */
    const char *main;               /* SECTION: a bare value instead of a mapping means this key of it */
    bool short_form;                /* LIST: its section may hold the keys of a single element itself */
    int first; /* LIST: number of the first element read; those before are filled by the program */
    size_t offset, size, count_offset;
    int max;
    const char *help, *example;
};

/* The keys of a scene. */
extern const struct schema_table schema_root;

/* Tables of schema_particles.c, schema_walls.c, schema_output.c that schema_root names. */
extern const struct schema_table schema_region, schema_sizes, schema_particles, schema_insertion,
    schema_deletion, schema_group;
extern const struct schema_table schema_wall;
extern const struct schema_table schema_output, schema_observables;

/* Where a read stands; also what messages need. */
struct schema_reader {
    const char *file;     /* for messages */
    const char *folder;   /* relative paths start here */
    char *root;           /* the struct that schema_root describes */
    bool units;           /* units may be given */
    const int *dimension; /* 2: vectors may have two components */
    char *note;           /* SCHEMA_NOTE_MAX bytes: what to tell the user of an older name; "" if nothing */
    struct error *error;
};

/* Bytes that a full key ("walls[12].motion[3].direction") may have. */
enum { SCHEMA_KEY_MAX = 256, SCHEMA_NOTE_MAX = 256 };

/* Puts short forms into their full form: a bare value into its section's main key, `particles.file` into
 * particles.sources[0].file. */
bool schema_normalise(struct schema_reader *reader, struct tree_node *root);

/* Applies one --set text to a normalised tree; the value ~ (or null) takes the key out. */
bool schema_set(struct schema_reader *reader, struct tree_node *root, const char *text);

/* Checks every node against the schema and stores all values, defaults included, in reader->root. */
bool schema_read(struct schema_reader *reader, const struct tree_node *root);

/* Fills the reader's error: "PLACE: KEY: TEXT". Returns false. */
bool schema_fail(struct schema_reader *reader, const struct tree_node *node, const char *key,
                 const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Reads one value (no section, no list of sections) from a node and stores it in the section's struct at
 * `base`. */
bool schema_value(struct schema_reader *reader, const struct schema_row *row, const struct tree_node *node,
                  const char *key, char *base);

/* Stores what a row without default holds when it is left out: NAN, -1, empty. */
void schema_unset(const struct schema_row *row, char *base);

/* A number with an optional unit: "5 mm" where the row's unit is "m". False with one line in `why`. */
bool schema_number(const char *text, const char *unit, bool units_allowed, double *value, char *why,
                   size_t room);

/* The bounds of a row's range and whether they belong to it; without one: all finite numbers. True if `value`
 * lies within. */
bool schema_in_range(const struct schema_row *row, double value);

/* Name of entry k of a list at the top level (a target of REF rows), NULL beyond its end. */
const char *schema_target_name(const char *root, const char *target, int k);

/* Writes all values as YAML (see scene_echo). `working` is put before relative paths. */
void schema_write(FILE *out, const void *root, const char *working);

/* True if the row exists with the present values: its `when` holds. `base` is the struct of its section. */
bool schema_applies(const struct schema_row *row, const struct schema_table *table, const char *base,
                    const char *root);

/* The condition of a row in words: "contact.law=hertz & contact.damping=restitution"; empty without. */
void schema_condition(const struct schema_row *row, char *text, size_t room);

/* The first row of a key, or of its alias, in a table, or NULL; `length` bytes of `key` count. */
const struct schema_row *schema_row_find(const struct schema_table *table, const char *key, size_t length);

/* The list whose element a section may hold directly (`short_form`), or NULL. */
const struct schema_row *schema_short_list(const struct schema_table *table);

/* The row of a full key, list numbers ignored ("walls[3].radius", "walls[].radius" and "walls.radius" alike,
 * short forms understood), and its key in the form "walls[].radius"; or NULL. */
const struct schema_row *schema_find(const char *key, char full[SCHEMA_KEY_MAX]);

/* Writes the nearest known full key to `nearest`; false if none is near. `section` is the prefix in which the
 * key stood ("walls[]."), or "". */
bool schema_suggest(const char *section, const char *key, char nearest[SCHEMA_KEY_MAX]);

/* Calls `visit` for every row, depth first, with the full key ("walls[].radius") and its depth. */
void schema_walk(void (*visit)(void *context, const struct schema_row *row, const char *key, int depth),
                 void *context);

/* What is allowed, in words: "a number > 0 with a unit of length (m)", "one of a, b, c". */
void schema_allowed(const struct schema_row *row, char *text, size_t room);

#endif
