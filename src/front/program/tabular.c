/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes rows of tables with commas and as lines of JSON. Read tabular.h first. */
#include "front/program/tabular.h"
#include <string.h>

static int cell_add(struct tabular *cells, const char *name, bool word) {
    if (cells->count == TABULAR_CELLS_MAX)
        return -1;
    snprintf(cells->cell[cells->count].name, TABULAR_NAME_MAX, "%s", name);
    cells->cell[cells->count].word = word;
    return cells->count++;
}

void tabular_word(struct tabular *cells, const char *name, const char *text) {
    int k = cell_add(cells, name, true);
    if (k >= 0)
        snprintf(cells->cell[k].text, TABULAR_TEXT_MAX, "%s", text);
}

void tabular_number(struct tabular *cells, const char *name, const char *format, double value) {
    int k = cell_add(cells, name, false);
    if (k >= 0)
        snprintf(cells->cell[k].text, TABULAR_TEXT_MAX, format, value);
}

/* A text with commas or quotation marks stands in quotation marks, those inside doubled. */
static void text_write(const char *text, FILE *file) {
    bool quoted = strpbrk(text, ",\"") != NULL;
    if (quoted)
        fputc('"', file);
    for (const char *c = text; *c; c++) {
        if (*c == '"')
            fputc('"', file);
        fputc(*c, file);
    }
    if (quoted)
        fputc('"', file);
}

void tabular_head(const struct tabular *cells, FILE *file) {
    for (int k = 0; k < cells->count; k++) {
        fputs(k ? "," : "", file);
        text_write(cells->cell[k].name, file);
    }
    fputc('\n', file);
    fflush(file);
}

void tabular_row(const struct tabular *cells, FILE *file) {
    for (int k = 0; k < cells->count; k++) {
        fputs(k ? "," : "", file);
        text_write(cells->cell[k].text, file);
    }
    fputc('\n', file);
    fflush(file);
}

static void string_write(const char *text, FILE *file) {
    fputc('"', file);
    for (const char *c = text; *c; c++)
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if ((unsigned char)*c < 0x20)
            fprintf(file, "\\u%04x", (unsigned)*c);
        else
            fputc(*c, file);
    fputc('"', file);
}

void tabular_json(const struct tabular *cells, FILE *file) {
    for (int k = 0; k < cells->count; k++) {
        const char *text = cells->cell[k].text;
        fputs(k ? ", " : "{", file);
        string_write(cells->cell[k].name, file);
        fputs(": ", file);
        if (cells->cell[k].word)
            string_write(text, file);
        else
            fputs(strpbrk(text, "0123456789") && !strpbrk(text, "nN") ? text : "null", file);
    }
    fputs("}\n", file);
    fflush(file);
}
