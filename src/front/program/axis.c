/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts the lists of values that `scree ablate` varies. Read axis.h first. */
#include "front/program/axis.h"
#include <stdio.h>
#include <string.h>

/* Characters up to the next comma outside of brackets, braces and quotation marks. */
static size_t value_length(const char *text) {
    int depth = 0;
    char quote = '\0';
    size_t k = 0;
    for (; text[k] && (text[k] != ',' || depth > 0 || quote); k++) {
        if (quote)
            quote = text[k] == quote ? '\0' : quote;
        else if (text[k] == '\'' || text[k] == '"')
            quote = text[k];
        else
            depth += (strchr("[{", text[k]) != NULL) - (strchr("]}", text[k]) != NULL);
    }
    return k;
}

bool axis_cut(struct axis *axis, const char *key, const char *list, const char *flag, struct error *error) {
    snprintf(axis->key, sizeof axis->key, "%s", key);
    axis->count = 0;
    for (const char *at = list; *at;) {
        size_t length = value_length(at);
        if (length == 0 || length >= AXIS_TEXT_MAX || axis->count == AXIS_VALUES_MAX)
            return error_set(error, ERROR_USER,
                             "command line: --%s: '%s' is no list of words separated by commas", flag, at);
        snprintf(axis->value[axis->count++], AXIS_TEXT_MAX, "%.*s", (int)length, at);
        at += length;
        at += *at == ',';
    }
    return axis->count > 0 || error_set(error, ERROR_USER, "command line: --%s: an empty list", flag);
}

bool axis_cut_setting(struct axis *axis, const char *text, const char *flag, struct error *error) {
    const char *equals = strchr(text, '=');
    char key[AXIS_TEXT_MAX];
    if (equals == NULL || equals == text || (size_t)(equals - text) >= sizeof key)
        return error_set(error, ERROR_USER, "command line: --%s %s: must read KEY=VALUE,VALUE,...", flag,
                         text);
    snprintf(key, sizeof key, "%.*s", (int)(equals - text), text);
    return axis_cut(axis, key, equals + 1, flag, error);
}

int axis_runs(const struct axis *axis, int axes) {
    int runs = 1;
    for (int k = 0; k < axes; k++)
        runs *= axis[k].count > 0 ? axis[k].count : 1;
    return runs;
}

void axis_places(const struct axis *axis, int axes, int run, int at[AXES_MAX]) {
    for (int k = axes - 1; k >= 0; k--) {
        int count = axis[k].count > 0 ? axis[k].count : 1;
        at[k] = axis[k].count > 0 ? run % count : -1;
        run /= count;
    }
}

void axis_setting(const struct axis *axis, int at, char text[AXIS_SETTING_MAX]) {
    snprintf(text, AXIS_SETTING_MAX, "%s=%s", axis->key, axis->value[at]);
}
