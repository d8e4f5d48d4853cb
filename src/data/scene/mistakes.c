/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects mistakes. Read mistakes.h first. */
#include "data/scene/mistakes.h"

#include <stdio.h>
#include <string.h>

static const char more[] = "\nand there are more mistakes";

bool mistakes_full(const struct error *error) {
    size_t used = error->kind == ERROR_NONE ? 0 : strlen(error->text);
    return used >= sizeof(more) && strcmp(error->text + used - (sizeof(more) - 1), more) == 0;
}

bool mistakes_add(struct error *error, const char *text) {
    if (error->kind == ERROR_NONE)
        return error_set(error, ERROR_USER, "%s", text);
    size_t used = strlen(error->text), room = sizeof(error->text) - used;
    int lines = 1;
    for (const char *c = error->text; *c; c++)
        lines += *c == '\n';
    if (mistakes_full(error))
        return false;
    if (lines < MISTAKES_MAX && strlen(text) + 1 + sizeof(more) <= room)
        snprintf(error->text + used, room, "\n%s", text);
    else
        snprintf(error->text + used, room, "%s", more);
    return false;
}
