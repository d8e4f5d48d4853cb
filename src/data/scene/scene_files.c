/* SPDX-License-Identifier: BSD-3-Clause */
/* Looks for the files of a scene, by the rows of the schema that hold paths, and reads those that hold sizes.
 * Read scene_files.h first. */
#include "data/scene/scene_files.h"
#include "base/file.h"
#include "data/scene/mistakes.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_rows.h"
#include "data/scene/sizes_file.h"
#include "data/scene/tree.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool file_opens(const struct scene *scene, const char *given, const char *key, struct error *error) {
    char path[2 * SCENE_PATH_MAX];
    struct stat found;
    struct error one = {0};
    snprintf(path, sizeof(path), "%s%s", given[0] == '/' ? "" : scene->folder, given);
    int code = access(path, R_OK) == 0 && stat(path, &found) == 0 ? 0 : errno;
    if (code == 0 && S_ISDIR(found.st_mode))
        code = EISDIR;
    const char *waits = code == 0 ? file_waits(path) : NULL;
    if (code == 0 && !waits)
        return true;
    if (waits)
        scene_fail(scene, &one, key, "%.700s %s", path, waits);
    else
        scene_fail(scene, &one, key, "%.700s cannot be opened: %s%s", path, strerror(code),
                   code == ENOENT && given[0] != '/' ? " (paths begin at the folder of the scene file)" : "");
    return mistakes_add(error, one.text);
}

/* Looks at all paths in a section, whose full key is `prefix`. */
static bool section_opens(const struct scene *scene, const struct schema_table *table,
                          const struct tree_node *node, const char *prefix, struct error *error) {
    bool good = true;
    for (int k = 0; k < table->count; k++) {
        const struct schema_row *row = &table->rows[k];
        const struct tree_node *child = tree_get(node, row->key);
        char key[256], entry[288];
        if (!child || (k > 0 && strcmp(table->rows[k - 1].key, row->key) == 0))
            continue;
        snprintf(key, sizeof(key), "%.120s%s%.120s", prefix, prefix[0] ? "." : "", row->key);
        if (row->type == SCHEMA_PATH && child->kind == TREE_SCALAR)
            good = file_opens(scene, child->text, key, error) && good;
        if (row->type == SCHEMA_SECTION)
            good = section_opens(scene, row->sub, child, key, error) && good;
        for (size_t i = 0; row->type == SCHEMA_LIST && i < child->children; i++) {
            snprintf(entry, sizeof(entry), "%s[%zu]", key, i);
            good = section_opens(scene, row->sub, child->child[i], entry, error) && good;
        }
    }
    return good;
}

bool scene_files_open(const struct scene *scene, struct error *error) {
    return section_opens(scene, &schema_root, scene->tree, "", error);
}

static bool complete_sizes(struct scene *scene, struct sizes_options *sizes, const char *list, int number,
                           struct error *error) {
    struct error why = {0};
    bool in_file;
    char key[80];
    snprintf(key, sizeof(key), "%s[%d].sizes", list, number);
    if (sizes->file[0] && !scene_files_open(scene, error))
        return false;
    if (sizes_file_complete(sizes, &in_file, &why))
        return true;
    return in_file ? error_set(error, ERROR_USER, "%s", why.text)
                   : scene_fail(scene, error, key, "%s", why.text);
}

bool scene_files_sizes(struct scene *scene, struct error *error) {
    for (int s = 0; s < scene->sources; s++)
        if (!complete_sizes(scene, &scene->source[s].sizes, "particles.sources", s, error))
            return false;
    for (int k = 0; k < scene->insertions; k++)
        if (!complete_sizes(scene, &scene->insertion[k].sizes, "insertions", k, error))
            return false;
    return true;
}
