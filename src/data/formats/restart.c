/* SPDX-License-Identifier: BSD-3-Clause */
/* Lists numbers by name, packs the list, and restores the numbers. Read restart.h first. */
#include "data/formats/restart.h"

#include "base/memory.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void restart_add(struct restart *restart, enum restart_kind kind, bool optional, void *value,
                 const char *format, ...) {
    restart->row = memory_resize(restart->row, restart->count + 1, sizeof *restart->row, "restart numbers");
    struct restart_number *row = &restart->row[restart->count++];
    *row = (struct restart_number){.kind = kind, .optional = optional, .value = value};
    va_list list;
    va_start(list, format);
    vsnprintf(row->name, sizeof row->name, format, list);
    va_end(list);
    for (size_t k = 0; k + 1 < restart->count; k++)
        assert(strcmp(restart->row[k].name, row->name) != 0);
}

void restart_free(struct restart *restart) {
    memory_free(restart->row);
    *restart = (struct restart){0};
}

void restart_values_allocate(struct restart_values *values, enum restart_kind kind, size_t count) {
    values->count[kind] = count;
    values->name[kind] = memory_allocate_zero(count, sizeof *values->name[kind], "restart numbers");
    values->value[kind] = memory_allocate_zero(count, sizeof *values->value[kind], "restart numbers");
}

void restart_pack(const struct restart *restart, struct restart_values *values) {
    size_t count[RESTART_KINDS] = {0}, at[RESTART_KINDS] = {0};
    for (size_t k = 0; k < restart->count; k++)
        count[restart->row[k].kind]++;
    for (int kind = 0; kind < RESTART_KINDS; kind++)
        restart_values_allocate(values, (enum restart_kind)kind, count[kind]);
    for (size_t k = 0; k < restart->count; k++) {
        const struct restart_number *row = &restart->row[k];
        snprintf(values->name[row->kind][at[row->kind]], OUTPUT_NAME_MAX, "%s", row->name);
        memcpy(&values->value[row->kind][at[row->kind]++], row->value, sizeof(uint64_t));
    }
}

void restart_values_free(struct restart_values *values) {
    for (int k = 0; k < RESTART_KINDS; k++) {
        memory_free(values->name[k]);
        memory_free(values->value[k]);
    }
    *values = (struct restart_values){0};
}

static const uint64_t *find(const struct restart_values *values, const struct restart_number *row) {
    for (size_t k = 0; k < values->count[row->kind]; k++)
        if (strncmp(values->name[row->kind][k], row->name, OUTPUT_NAME_MAX) == 0)
            return &values->value[row->kind][k];
    return NULL;
}

bool restart_take(const struct restart *restart, const struct restart_values *values, const char *path,
                  struct error *error) {
    for (size_t k = 0; k < restart->count; k++) {
        const struct restart_number *row = &restart->row[k];
        const uint64_t *value = find(values, row);
        if (value)
            memcpy(row->value, value, sizeof *value);
        else if (!row->optional)
            return error_set(error, ERROR_USER, "%s: holds no number '%s'", path, row->name);
    }
    return true;
}
