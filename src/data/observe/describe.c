/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the tables of docs/output.md from the tables of the program. */
#include "data/observe/describe.h"

#include "data/formats/dump.h"
#include "data/formats/frame.h"
#include "data/observe/observables_kinds.h"

#include <stdlib.h>
#include <string.h>

/* "m s-1" or "" as a cell. */
static const char *unit_cell(const char *unit) {
    return unit[0] ? unit : "1";
}

static const char *type_name(enum field_type type) {
    return type == FIELD_DOUBLE ? "float64" : type == FIELD_INT64 ? "int64" : "int32";
}

static void print_fields(const struct describe_from *from, FILE *out) {
    (void)from;
    fprintf(out, "| in H5MD | in a dump | type | shape | unit | over time | scenes with | meaning |\n"
                 "|---|---|---|---|---|---|---|---|\n");
    struct particles *known = particles_create(0);
    frame_register_all(known);
    for (int f = 0; f < fields_count(known); f++) {
        struct frame_field field = frame_field_get(fields_get(known, f));
        const char *dump = dump_columns_of(field.name, field.components), *quote = dump[0] ? "`" : "";
        char shape[32] = "N";
        if (field.spatial || field.components > 1)
            snprintf(shape, sizeof shape, field.spatial ? "N × D" : "N × %d", field.components);
        fprintf(out, "| `%s` | %s%s%s | %s | %s | %s | %s | %s | %s%s |\n", field.name, quote, dump, quote,
                type_name(field.type), shape, unit_cell(field.unit), field.fixed ? "fixed" : "each frame",
                field.needed_for ? field.needed_for : "any", field.help,
                field.asked_only ? "; written only if `fields` names the field" : "");
    }
    particles_destroy(&known);
}

/* The columns that a request of this kind makes. */
static void print_columns(FILE *out, const struct observable_kind *kind) {
    static const char *const vector[] = {"x", "y", "z"};
    static const char *const tensor[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
    static const char *const stems[] = {[OBSERVABLE_OF_WALL] = "WALL",
                                        [OBSERVABLE_OF_PARTICLE] = "particleID",
                                        [OBSERVABLE_OF_BODY] = "drag_BODY"};
    const struct observable_info *info = &kind->info;
    bool of_one = info->target == OBSERVABLE_OF_WALL || info->target == OBSERVABLE_OF_PARTICLE ||
                  info->target == OBSERVABLE_OF_BODY;
    const char *stem = of_one ? stems[info->target] : info->name;
    if (info->target == OBSERVABLE_OF_REGION || info->target == OBSERVABLE_OF_PLANE)
        fprintf(out, info->target == OBSERVABLE_OF_PLANE ? "`%s_PLANE`" : "`%s_REGION`", info->name);
    else if (info->components == 1)
        fprintf(out, "`%s`", stem);
    for (int c = 0; info->components > 1 && c < info->components; c++)
        fprintf(out, "%s`%s_%s%s`", c ? " " : "", stem, kind->symbol ? kind->symbol : "",
                kind->component         ? kind->component[c].name
                : info->components == 3 ? vector[c]
                                        : tensor[c]);
}

static void print_takes(FILE *out, const struct observable_info *info) {
    static const char *const takes[] = {[OBSERVABLE_OF_ALL] = "",
                                        [OBSERVABLE_OF_WALL] = "`target`: a wall",
                                        [OBSERVABLE_OF_PARTICLE] = "`id`",
                                        [OBSERVABLE_OF_REGION] = "`target`: a region",
                                        [OBSERVABLE_OF_ALL_OR_REGION] = "`target`: a region, or none",
                                        [OBSERVABLE_OF_EXPRESSION] = "`of`, `where`, `unit`, `cells`",
                                        [OBSERVABLE_OF_PLANE] = "`target`: a plane",
                                        [OBSERVABLE_OF_BODY] =
                                            "`target`: a wall or a group, or `/BODY` after the name"};
    const char *target = takes[info->target];
    fprintf(out, "%s%s%s", target, info->components == 3 && target[0] ? "; " : "",
            info->components == 3 ? "`components`" : "");
}

static void print_observables(const struct describe_from *from, FILE *out) {
    (void)from;
    fprintf(out, "| name | columns | unit | takes | meaning |\n|---|---|---|---|---|\n");
    for (int k = 0; k < observables_kinds_count(); k++) {
        const struct observable_info *info = observables_get(k);
        fprintf(out, "| `%s` | ", info->name);
        print_columns(out, observables_kind(k));
        fprintf(out, " | %s%s%s%s | ", info->unit, info->unit_flat ? " (2D: " : "",
                info->unit_flat ? info->unit_flat : "", info->unit_flat ? ")" : "");
        print_takes(out, info);
        fprintf(out, " | %s |\n", info->help);
    }
}

/* Names that stand for several observables; their members follow each other. */
static void print_families(const struct describe_from *from, FILE *out) {
    (void)from;
    const char *last = "";
    for (int k = 0; k < observables_kinds_count(); k++) {
        const struct observable_info *info = observables_get(k);
        if (info->family[0] && strcmp(info->family, last) == 0)
            fprintf(out, ", `%s`", info->name);
        else if (info->family[0])
            fprintf(out, "%s- `%s`: `%s`", last[0] ? "\n" : "", info->family, info->name);
        last = info->family[0] ? info->family : last;
    }
    fprintf(out, "\n");
}

static void print_entry(FILE *out, const char *prefix, const struct report_row *row) {
    fprintf(out, "| `%s%s` |%s%s | %s |\n", prefix, row->name, row->unit[0] ? " " : "", row->unit, row->help);
}

static void print_report(const struct describe_from *from, FILE *out) {
    bool told = false; /* the stages, once */
    fprintf(out, "| key | unit | meaning |\n|---|---|---|\n");
    for (const struct report_row *row = from->rows; row->name; row++) {
        char prefix[64];
        if (row->terminal)
            continue;
        print_entry(out, "", row);
        snprintf(prefix, sizeof prefix, "%s%s.", row->name, row->shape == REPORT_LIST ? "[]" : "");
        for (const struct report_row *below = row->rows; row->shape != REPORT_STAGES && below && below->name;
             below++)
            if (!below->terminal)
                print_entry(out, prefix, below);
        for (int s = 0; row->shape == REPORT_STAGES && !told && s < from->stages->stages; s++) {
            const struct report_row stage = {
                .name = from->stages->stage[s].name, .unit = row->unit, .help = from->stages->stage[s].help};
            print_entry(out, prefix, &stage);
        }
        told = told || row->shape == REPORT_STAGES;
    }
}

static const struct {
    const char *name;
    void (*print)(const struct describe_from *from, FILE *out);
} tables[] = {{"fields", print_fields},
              {"observables", print_observables},
              {"families", print_families},
              {"report", print_report}};
enum { TABLES = sizeof tables / sizeof tables[0] };

/* The table that a line opens; -1: none. */
static int table_of(const char *line) {
    for (int k = 0; k < TABLES; k++) {
        size_t length = strlen(tables[k].name);
        if (strncmp(line, "<!-- ", 5) == 0 && strncmp(line + 5, tables[k].name, length) == 0 &&
            line[5 + length] == ':')
            return k;
    }
    return -1;
}

/* Reads up to the line that ends a table, and copies that line. */
static bool skip_table(FILE *page, FILE *out, const char *name) {
    char end[64], *line = NULL;
    size_t room = 0;
    bool found = false;
    snprintf(end, sizeof end, "<!-- end of %s -->\n", name);
    while (!found && getline(&line, &room, page) >= 0)
        found = strcmp(line, end) == 0;
    free(line);
    if (found)
        fputs(end, out);
    return found;
}

bool describe_page(FILE *page, FILE *out, const struct describe_from *from, struct error *error) {
    char *line = NULL;
    size_t room = 0;
    bool seen[TABLES] = {false}, good = true;
    while (good && getline(&line, &room, page) >= 0) {
        fputs(line, out);
        int k = table_of(line);
        if (k < 0)
            continue;
        seen[k] = true;
        tables[k].print(from, out);
        good = skip_table(page, out, tables[k].name) ||
               error_set(error, ERROR_USER, "the page has no line \"<!-- end of %s -->\"", tables[k].name);
    }
    free(line);
    for (int k = 0; good && k < TABLES; k++)
        good = seen[k] ||
               error_set(error, ERROR_USER, "the page has no line \"<!-- %s: ... -->\"", tables[k].name);
    return good;
}
