/* SPDX-License-Identifier: BSD-3-Clause */
/* The schema: one row a key. Parsing, `scree help`, docs/scene.md and the echo of the effective scene all
 * walk these rows, so that none of them can know a key that the others do not.
 *
 * A table lists the keys of one section (a mapping); sections and lists name the table of their entries. A
 * row says where in the section's struct its value lies, as offset and size. Rows are read in order: a row
 * may depend (`when`) on those before it. A key may have several rows, of whose conditions at most
 * one holds (its unit depends on a law, say, or two cohesions have it).
 *
 * How to add a key, in four steps:
 *   1. Add a member to the struct of its section: struct scene (scene.h) for a key of the top level, else the
 *      options of a module.
 *   2. Add a row to the table of its section, its place by AT or ARRAY_AT: schema_root.c (top level, box, step,
 *      index, classes, skin, domain, guards), schema_contact.c, schema_particles.c, schema_walls.c,
 *      schema_output.c, or the table of a physics (physics_table.h).
 *   3. What one row cannot say: derived values, and numbers that are NAN where not given, in finish.c;
 *      combinations of keys that are refused in scene_check.c, with a line in tests/data/scene/test_scene_check.c.
 *   4. `make pages` writes docs/scene.md. tests/data/scene/test_schema looks at each row: its help, range, default, example.
 * Reading, `--set`, help, the echo in files and the list of changes at a resume then know the key. */
#ifndef SCREE_SCENE_SCHEMA_ROWS_H
#define SCREE_SCENE_SCHEMA_ROWS_H

#include <stdbool.h>
#include <stddef.h>

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
    SCHEMA_KEYS,    /* char[size]: a mapping of full keys of the scene to values, as YAML in one line */
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

/* What a text is of a column of observables.csv. A name must break neither the line nor the path of the column in the
 * trajectory, where a slash parts groups; nor the path of a file that bears the name. */
enum schema_column { SCHEMA_NO_COLUMN, SCHEMA_COLUMN_UNIT, SCHEMA_COLUMN_NAME };

struct schema_row {
    const char *key;
    const char *alias; /* an older name of the key, still read, with a note; NULL: none */
    /* NAME: {file: PATH} stands for the name `file_name`, and PATH at the key `file_key` beside it; NULL: no such form. */
    const char *file_key, *file_name;
    enum schema_type type;
    const char *unit;     /* in SI ("m/s2"); NULL or "" for a pure number */
    const char *fallback; /* default, as YAML; NULL: none, the key may be left out */
    bool required;
    const char *range;                               /* interval, "(0, inf)" or "[0, 1]"; NULL: any */
    const struct schema_name *names;                 /* NAME: ended by a NULL name */
    const char *(*choice)(int k, const char **help); /* CHOICE: the k-th name, NULL after the last */
    bool with_target;                                /* CHOICE: NAME/TARGET is a name, too */
    const char *(*traits)(int value); /* NAME: words "a b" that conditions may ask for; NULL: none */
    const char *target;               /* REF, REFS: a list at the top level */
    enum schema_column in_column;     /* TEXT */
    const char *when; /* "shape=cylinder|plane": the key exists only then; "/contact.damping=restitution" from
                         the top; "/contact.law:moduli" (from the top alone): with all names that have the trait;
                         "a=b & c=d" */
    const struct schema_table *sub; /* SECTION, LIST */
    const char *main;               /* SECTION: a bare value instead of a mapping means this key of it */
    const char *flag;               /* SECTION: a bare value that is this word sets the key of this name */
    bool
        optional; /* SECTION: without it its keys are not read, and the int at `count_offset` stays 0, not 1 */
    bool short_form; /* LIST: its section may hold the keys of a single element itself */
    int first;       /* LIST: number of the first element read; those before are filled by the program */
    size_t offset, size, count_offset;
    int max;
    bool
        apart; /* LIST: at the offset is a pointer to the elements, which reading allocates; the section's owner frees them */
    const char *help, *example;
};

/* For the files that hold rows: the place of a member. */
#define AT(type, member) .offset = offsetof(type, member), .size = sizeof(((type *)0)->member)

/* An array member and the member that counts its entries. */
#define ARRAY_AT(type, member, counter)                                                                      \
    .offset = offsetof(type, member), .size = sizeof(((type *)0)->member[0]),                                \
    .max = sizeof(((type *)0)->member) / sizeof(((type *)0)->member[0]),                                     \
    .count_offset = offsetof(type, counter)

/* The same of a list whose elements lie apart: a pointer. */
#define LIST_AT(type, member, counter, most)                                                                 \
    .offset = offsetof(type, member), .size = sizeof(*((type *)0)->member), .apart = true, .max = (most),    \
    .count_offset = offsetof(type, counter)

/* The elements of a list of the section at `base`. */
static inline char *schema_elements(const struct schema_row *row, const char *base) {
    char *at = (char *)base + row->offset;
    return row->apart ? *(char **)(void *)at : at;
}

#define TABLE(array)                                                                                         \
    { array, sizeof(array) / sizeof(array[0]) }

#endif
