/* SPDX-License-Identifier: BSD-3-Clause */
/* Values of keys, and settings of the scene. Read recipe_work.h first. */
#include "front/pack/recipe_work.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

const char *recipe_given(const struct recipe_work *work, const char *key) {
    size_t length = strlen(key);
    const char *value = NULL;
    for (int k = 0; k < work->given; k++)
        if (strncmp(work->setting[k], key, length) == 0 && work->setting[k][length] == '=')
            value = work->setting[k] + length + 1;
    return value;
}

const char *recipe_value(struct recipe_work *work, const char *key) {
    const char *value = recipe_given(work, key);
    if (value)
        return value;
    char *room = work->value[work->values++ % RECIPE_VALUES];
    return laws_default(work->law, key, room, sizeof work->value[0]) ? room : NULL;
}

bool recipe_fail(struct recipe_work *work, const char *format, ...) {
    char text[600];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return error_set(work->error, ERROR_USER, "command line: %s", text);
}

void recipe_set(struct recipe_work *work, const char *format, ...) {
    va_list list;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out || work->sets == RECIPE_SETS_MAX)
        error_fatal("no room for the settings of a packing");
    va_start(list, format);
    vfprintf(out, format, list);
    va_end(list);
    fclose(out);
    work->set[work->sets++] = text;
}

bool recipe_number(struct recipe_work *work, const char *key, double least, double most, double *value) {
    const char *text = recipe_value(work, key);
    char *end;
    *value = text ? strtod(text, &end) : 0;
    if (!text)
        return true;
    if (end == text || *end || !isfinite(*value))
        return recipe_fail(work, "%s=%s: is not a number", key, text);
    return (*value >= least && *value <= most) ||
           recipe_fail(work, "%s=%s: must lie in %g ... %g", key, text, least, most);
}

bool recipe_whole(struct recipe_work *work, const char *key, double least, double *value) {
    return recipe_number(work, key, least, 1e9, value) &&
           (*value == floor(*value) ||
            recipe_fail(work, "%s=%s: must be a whole number", key, recipe_value(work, key)));
}
