/* SPDX-License-Identifier: BSD-3-Clause */
/* The schema for people: `scree help` and docs/scene.md. */
#include "data/scene/schema_help.h"
#include "data/scene/schema.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_unknown.h"

#include <string.h>

/* One line: the allowed values. */
static void print_brief(FILE *out, const struct schema_row *row) {
    char allowed[2048];
    schema_allowed(row, allowed, sizeof(allowed));
    fprintf(out, "%s", allowed);
    if (row->fallback && row->fallback[0])
        fprintf(out, "; default %s", row->fallback);
    else if (row->required)
        fprintf(out, "; required");
}

static bool is_group(const struct schema_row *row) {
    return row->type == SCHEMA_SECTION || row->type == SCHEMA_LIST;
}

static void print_line(void *context, const struct schema_row *row, const char *key, int depth) {
    FILE *out = context;
    if (is_group(row) && depth == 0)
        fprintf(out, "\n");
    fprintf(out, "%-44s %s\n", key, row->help);
}

/* The keys of one section. */
struct listing {
    FILE *out;
    const char *prefix;
};

static void print_below(void *context, const struct schema_row *row, const char *key, int depth) {
    const struct listing *listing = context;
    size_t length = strlen(listing->prefix);
    (void)depth;
    if (strncmp(key, listing->prefix, length) == 0 && key[length] == '.' && !strchr(key + length + 1, '.'))
        fprintf(listing->out, "  %-40s %s\n", key, row->help);
}

static void print_names(FILE *out, const struct schema_row *row) {
    const char *name, *help;
    for (int k = 0; row->type == SCHEMA_NAME && row->names[k].name; k++)
        if (row->names[k].help)
            fprintf(out, "    %-24s %s\n", row->names[k].name, row->names[k].help);
    for (int k = 0; row->type == SCHEMA_CHOICE && (name = row->choice(k, &help)); k++)
        fprintf(out, "    %-24s %s\n", name, help);
}

static void print_row(FILE *out, const struct schema_row *row, const char *key) {
    fprintf(out, "%s: %s\n  ", key, row->help);
    print_brief(out, row);
    fprintf(out, "\n");
    print_names(out, row);
    char condition[SCHEMA_NOTE_MAX];
    schema_condition(row, condition, sizeof(condition));
    if (condition[0])
        fprintf(out, "  only with %s\n", condition);
    if (row->alias)
        fprintf(out, "  older name: %s\n", row->alias);
    if (row->main)
        fprintf(out, "  a bare value stands for %s.%s\n", key, row->main);
    if (row->flag)
        fprintf(out, "  the word %s stands for %s.%s: true\n", row->flag, key, row->flag);
    if (row->example)
        fprintf(out, "  example: %s: %s\n", row->key, row->example);
    struct listing listing = {.out = out, .prefix = key};
    if (row->sub)
        schema_walk(print_below, &listing);
}

/* All rows of the key that is asked for. */
static void print_found(void *context, const struct schema_row *row, const char *key, int depth) {
    const struct listing *listing = context;
    (void)depth;
    if (strcmp(key, listing->prefix) == 0)
        print_row(listing->out, row, key);
}

bool scene_help(FILE *out, const char *key) {
    if (!key) {
        fprintf(out, "Keys of a scene (`scree help KEY` tells more; any key may be set by --set KEY=VALUE, "
                     "or taken out by --set 'KEY=~'):\n");
        schema_walk(print_line, out);
        return true;
    }
    char full[SCHEMA_KEY_MAX];
    bool known = schema_find(key, full) != NULL;
    int found = known ? 1 : schema_search(out, key, full);
    if (full[0] && (known || found == 1)) {
        struct listing listing = {.out = out, .prefix = full};
        schema_walk(print_found, &listing);
        return true;
    }
    if (found)
        return true;
    const char *last = strrchr(key, '.');
    char nearest[SCHEMA_KEY_MAX], section[SCHEMA_KEY_MAX];
    snprintf(section, sizeof(section), "%.*s", last ? (int)(last + 1 - key) : 0, key);
    if (schema_suggest(section, last ? last + 1 : key, nearest))
        fprintf(out, "no key '%s'; the nearest is '%s'\n", key, nearest);
    else
        fprintf(out, "no key '%s'; `scree help` lists all\n", key);
    return false;
}

/* The document. */

/* Text in a cell of a table: no bars. */
static void print_cell(FILE *out, const char *text) {
    for (; *text; text++)
        fprintf(out, *text == '|' ? "\\|" : "%c", *text);
}

static void print_table_condition(FILE *out, const struct schema_row *row) {
    char condition[SCHEMA_NOTE_MAX];
    schema_condition(row, condition, sizeof(condition));
    fprintf(out, ". Only with `");
    for (const char *c = condition; *c; c++)
        fprintf(out, *c == '|' ? " or " : "%c", *c);
    fprintf(out, "`");
}

static void print_table_row(FILE *out, const struct schema_row *row) {
    char allowed[2048];
    schema_allowed(row, allowed, sizeof(allowed));
    fprintf(out, "| `%s` | ", row->key);
    print_cell(out, allowed);
    fprintf(out, " | ");
    if (row->required)
        fprintf(out, "required");
    else if (row->fallback && row->fallback[0])
        fprintf(out, "`%s`", row->fallback);
    fprintf(out, " | ");
    print_cell(out, row->help);
    const char *help;
    bool names = row->type == SCHEMA_NAME || row->type == SCHEMA_CHOICE;
    for (int k = 0; names; k++) {
        const char *name = row->type == SCHEMA_NAME ? row->names[k].name : row->choice(k, &help);
        if (!name)
            break;
        help = row->type == SCHEMA_NAME ? row->names[k].help : help;
        if (help) {
            fprintf(out, "; `%s`: ", name);
            print_cell(out, help);
        }
    }
    if (row->when)
        print_table_condition(out, row);
    if (row->main)
        fprintf(out, ". A bare value stands for `%s`", row->main);
    if (row->flag)
        fprintf(out, ", the word `%s` for `%s: true`", row->flag, row->flag);
    if (row->example) {
        fprintf(out, ". Example: `");
        print_cell(out, row->example);
        fprintf(out, "`");
    }
    fprintf(out, " |\n");
}

static void print_section(FILE *out, const struct schema_table *table, const char *title, const char *help) {
    fprintf(out, "\n## %s\n\n%s.\n\n| key | allowed | default | meaning |\n|---|---|---|---|\n", title, help);
    for (int k = 0; k < table->count; k++)
        print_table_row(out, &table->rows[k]);
}

static void print_subsection(void *context, const struct schema_row *row, const char *key, int depth) {
    FILE *out = context;
    (void)depth;
    char title[SCHEMA_KEY_MAX + 4];
    snprintf(title, sizeof(title), "`%s`", key);
    char help[512];
    snprintf(help, sizeof(help), "%c%s",
             row->help[0] >= 'a' && row->help[0] <= 'z' ? row->help[0] - 32 : row->help[0], row->help + 1);
    if (row->sub)
        print_section(out, row->sub, title, help);
}

void scene_document(FILE *out) {
    fprintf(
        out,
        "# The scene file\n\n"
        "The program writes this page from the table by which it reads scenes; `scree help KEY` "
        "explains one key.\n\n"
        "- A scene is a YAML file. Unknown, duplicate and ill-typed keys, values out of range and "
        "impossible combinations stop the\n"
        "  program before the run, with file, line, key and the allowed values,\n"
        "  up to ten mistakes at once.\n"
        "- Numbers are in SI base units (m, kg, s, rad) unless a unit follows: `5 mm`, `2 GPa`, "
        "`0.1 ms`, `20 rpm`, `2.5 g/cm3`. Prefixes n, u,\n"
        "  m, c, d, h, k, M, G, T stand before m, g, s, N, Pa, J, W, Hz, rad, bar, L; the units t, "
        "sec, min, h, day, micron, in, ft, yd,\n"
        "  lb, lbf, psi, atm, deg, rev, rpm, %% have no prefix. With `units: none`\n"
        "  a unit is an error.\n"
        "- `&name` names a value or section, `*name` repeats it, and `<<: *name` takes in the keys of a "
        "section that are not given beside it.\n"
        "- `--set KEY=VALUE` on the command line overrides any key: `--set step.dt=1e-6`, `--set "
        "walls[0].radius=\"5 cm\"`, `--set index=multi`.\n"
        "  Lists count from 0; the number after the last appends an entry. `~` (or `null`) removes "
        "a key, so that another key may take its place:\n"
        "  `--set 'step.fraction=~' --set step.dt=1e-6`, with quotes, because shells treat `~` in "
        "their own way.\n"
        "- An element of a list that has a name is also found by it: `--set walls[gate].radius=\"5 cm\"`, "
        "`--set 'walls[gate]=~'`;\n"
        "  a whole element under a new name is appended. Pairs of materials: `material_pairs[glass, "
        "steel]`.\n"
        "- Paths are relative to the folder of the scene file.\n"
        "- In two dimensions vectors may have two components.\n"
        "- The program writes the effective scene, defaults included, into `trajectory.h5` (as "
        "`/parameters/scene`) and into checkpoints;\n"
        "  `scree run` accepts this scene as input.\n");
    print_section(out, &schema_root, "Top level", "The sections, and the keys outside of any");
    schema_walk(print_subsection, out);
}
