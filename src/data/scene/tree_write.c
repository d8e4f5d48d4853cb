/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes a node as YAML in one line that reads back to the same tree. Read tree.h first. */
#include "data/scene/tree.h"

#include <ctype.h>
#include <string.h>

/* True if a text is read back as it is without quotes, inside of brackets, too. */
static bool is_plain(const char *text) {
    if (!isalnum((unsigned char)text[0]) && !strchr("+-.~_", text[0]))
        return false;
    for (const char *c = text; *c; c++)
        if (!isalnum((unsigned char)*c) && !strchr(" ._+-/~", *c))
            return false;
    return text[0] && text[strlen(text) - 1] != ' ' && strcmp(text, "-") != 0;
}

static void write_text(FILE *out, const char *text, bool quoted) {
    if (!quoted && is_plain(text)) {
        fprintf(out, "%s", text);
        return;
    }
    fputc('"', out);
    for (const char *c = text; *c; c++) {
        if (*c == '"' || *c == '\\')
            fprintf(out, "\\%c", *c);
        else if ((unsigned char)*c < 0x20 || *c == 0x7f)
            fprintf(out, "\\x%02x", (unsigned char)*c);
        else
            fputc(*c, out);
    }
    fputc('"', out);
}

void tree_write(FILE *out, const struct tree_node *node) {
    bool map = node->kind == TREE_MAP;
    if (node->kind == TREE_SCALAR) {
        write_text(out, node->text, node->quoted || !node->text[0]);
        return;
    }
    fputc(map ? '{' : '[', out);
    for (size_t k = 0; k < node->children; k++) {
        fprintf(out, "%s", k ? ", " : "");
        if (map) {
            write_text(out, node->key[k], false);
            fprintf(out, ": ");
        }
        tree_write(out, node->child[k]);
    }
    fputc(map ? '}' : ']', out);
}
