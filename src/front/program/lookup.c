/* SPDX-License-Identifier: BSD-3-Clause */
/* Single values of reports and tables. JSON is read as YAML, which includes JSON. Read commands.h first. */
#include "front/program/commands.h"
#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"
#include "data/scene/scene_text.h"
#include "data/scene/tree.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { LIST_MAX = 1024 };

/* The file that a path stands for: itself, or `name` in the folder. */
static const char *file_of(const char *path, const char *name, char full[FILE_PATH_MAX]) {
    struct stat found;
    if (stat(path, &found) != 0 || !S_ISDIR(found.st_mode))
        return path;
    snprintf(full, FILE_PATH_MAX, "%s/%s", path, name);
    return full;
}

/* Adds a word to a list of words. */
static void list_add(char *list, const char *word) {
    size_t used = strlen(list);
    snprintf(list + used, LIST_MAX - used, "%s%s", used ? ", " : "", word);
}

/* Values by name below a node: their number, and the last one; `list` gets their keys. */
static int find_below(const struct tree_node *node, const char *name, const char *place, char *list,
                      const struct tree_node **found) {
    int count = 0;
    for (size_t k = 0; k < node->children; k++) {
        char key[256];
        if (node->kind == TREE_MAP)
            snprintf(key, sizeof key, "%s%s%s", place, place[0] ? "." : "", node->key[k]);
        else
            snprintf(key, sizeof key, "%s[%zu]", place, k);
        if (node->kind == TREE_MAP && strcmp(node->key[k], name) == 0) {
            list_add(list, key);
            *found = node->child[k];
            count++;
        }
        count += find_below(node->child[k], name, key, list, found);
    }
    return count;
}

/* The node of a full path, each part of which must be there; NULL: no such path. */
static const struct tree_node *find_path(const struct tree_node *root, const char *key) {
    const struct tree_node *node = root;
    while (node && *key) {
        char name[256], *end;
        size_t length = strcspn(key, ".[");
        if (*key == '[') {
            unsigned long k = strtoul(key + 1, &end, 10);
            bool good = end > key + 1 && *end == ']' && node->kind == TREE_LIST && k < node->children;
            node = good ? node->child[k] : NULL;
            key = good ? end + 1 : key;
        } else {
            snprintf(name, sizeof name, "%.*s", (int)length, key);
            node = node->kind == TREE_MAP ? tree_get(node, name) : NULL;
            key += length;
        }
        key += *key == '.';
    }
    return node;
}

/* The names of the entries of a section or list. */
static void list_entries(const struct tree_node *node, char *list) {
    if (node->kind == TREE_LIST)
        snprintf(list, LIST_MAX, "%zu entries, from [0]", node->children);
    for (size_t k = 0; node->kind == TREE_MAP && k < node->children; k++)
        list_add(list, node->key[k]);
}

static bool print_node(const struct tree_node *root, const char *path, const char *key, FILE *out,
                       struct error *error) {
    static const char file[] = "report."; /* report.pairs is pairs of the report */
    char list[LIST_MAX] = "";
    const struct tree_node *node = find_path(root, key);
    if (node == NULL && strncmp(key, file, strlen(file)) == 0)
        node = find_path(root, key + strlen(file));
    int found = node ? 1 : strpbrk(key, ".[") ? 0 : find_below(root, key, "", list, &node);
    if (found > 1)
        return error_set(error, ERROR_USER, "%s: --get %s: stands in several places: %s", path, key, list);
    list[0] = '\0';
    if (found == 0) {
        list_entries(root, list);
        return error_set(error, ERROR_USER, "%s: --get %s: there is no such key; at the top are %s", path,
                         key, list);
    }
    if (node->kind != TREE_SCALAR) {
        list_entries(node, list);
        return error_set(error, ERROR_USER, "%s: --get %s: is no single value; it has %s", path, key, list);
    }
    fprintf(out, "%s\n", node->text);
    return true;
}

bool lookup_key(const char *path, const char *key, FILE *out, struct error *error) {
    char full[FILE_PATH_MAX], *text = NULL;
    path = file_of(path, "report.json", full);
    if (!scene_read_text(path, &text, NULL, error))
        return false;
    struct tree_node *root = NULL;
    if (text[strspn(text, " \t\r\n")] != '{')
        error_set(error, ERROR_USER, "%s: --get reads report.json of a run, which begins with {", path);
    else
        root = tree_parse(path, text, 1, error);
    bool good = root && print_node(root, path, key, out, error);
    tree_free(&root);
    memory_free(text);
    return good;
}

/* Length of the cell at `text`, which ends at a comma outside of quotes. */
static size_t cell_length(const char *text) {
    bool quoted = false;
    size_t length = 0;
    for (; text[length] && (quoted || text[length] != ','); length++)
        quoted = quoted != (text[length] == '"');
    return length;
}

/* Cell `c` of a line, and its length; NULL: the line has fewer. */
static const char *cell_of(const char *text, int c, size_t *length) {
    for (*length = cell_length(text); c > 0; c--) {
        if (text[*length] == '\0')
            return NULL;
        text += *length + 1;
        *length = cell_length(text);
    }
    return text;
}

/* The column of a name, with its unit or without; -1 with an error. */
static int column_find(const struct lines *lines, const char *name, struct error *error) {
    char list[LIST_MAX] = "";
    const char *cell;
    size_t length;
    for (int c = 0; (cell = cell_of(lines->text, c, &length)) != NULL; c++) {
        char head[256];
        snprintf(head, sizeof head, "%.*s", (int)length, cell);
        list_add(list, head);
        bool whole = strcmp(head, name) == 0;
        head[strcspn(head, "[")] = '\0';
        if (whole || strcmp(head, name) == 0)
            return c;
    }
    lines_refuse(lines, error, "--column %s: there is no such column; there are %s", name, list);
    return -1;
}

/* Reads --row; *all if all rows are wanted. */
static bool row_read(const char *row, int64_t *number, bool *all, struct error *error) {
    *all = row == NULL;
    *number = 0;
    if (*all || strcmp(row, "first") == 0)
        return true;
    if (strcmp(row, "last") == 0)
        *number = -1;
    else if (!lines_integer(row, number))
        return error_set(error, ERROR_USER, "command line: --row %s: must be first, last or a whole number",
                         row);
    return true;
}

/* Numbers of rows below the heads. */
static int64_t rows_count(const char *path, struct error *error) {
    struct lines lines;
    int64_t rows = -1;
    if (!lines_open(&lines, path, error))
        return 0;
    while (lines_next(&lines))
        rows++;
    lines_close(&lines);
    return rows;
}

bool lookup_column(const char *path, const char *name, const char *row, FILE *out, struct error *error) {
    struct lines lines;
    char full[FILE_PATH_MAX];
    int64_t wanted;
    bool all, found = false;
    size_t length;
    path = file_of(path, "observables.csv", full);
    if (!row_read(row, &wanted, &all, error))
        return false;
    int64_t rows = wanted < 0 ? rows_count(path, error) : 0, k = 0;
    if (error->kind != ERROR_NONE || !lines_open(&lines, path, error))
        return false;
    int column = -1;
    if (lines_next(&lines))
        column = column_find(&lines, name, error);
    else
        error_set(error, ERROR_USER, "%s: is empty", path);
    wanted += wanted < 0 ? rows : 0;
    for (; column >= 0 && lines_next(&lines) && error->kind == ERROR_NONE; k++) {
        const char *cell = all || k == wanted ? cell_of(lines.text, column, &length) : NULL;
        if (cell)
            fprintf(out, "%.*s\n", (int)length, cell);
        else if (all || k == wanted)
            lines_refuse(&lines, error, "--column %s: this row has fewer columns", name);
        found = found || k == wanted;
    }
    if (column >= 0 && !all && !found && error->kind == ERROR_NONE)
        error_set(error, ERROR_USER, "%s: --row %s: there is no such row; there are %lld", path, row,
                  (long long)(rows > k ? rows : k));
    lines_close(&lines);
    return error->kind == ERROR_NONE;
}
