/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a report by the getters of its rows, and finds its values. Read report.h first. */
#include "data/observe/report.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

enum { TEXT_ROOM = 512 };

/* Those who call the getters. */
struct making {
    const struct comm *comm;
    const struct report_source *source;
};

static int rows_count(const struct report_row *rows) {
    int count = 0;
    while (rows[count].name)
        count++;
    return count;
}

static union report_value value_make(const struct report_row *row, const struct report_source *source,
                                     int k) {
    char buffer[TEXT_ROOM];
    if (row->count)
        return (union report_value){.count = row->count(source, k)};
    if (row->each)
        return (union report_value){.count = row->each(source, k)};
    if (row->flag)
        return (union report_value){.count = row->flag(source, k)};
    if (row->real)
        return (union report_value){.real = row->real(source, k)};
    const char *text = row->text(source, k, buffer, sizeof buffer);
    size_t size = strlen(text) + 1;
    return (union report_value){.text = memcpy(memory_allocate(size, 1, "report"), text, size)};
}

static struct report_column values_make(const struct report_row *row, int entries,
                                        const struct making *making) {
    size_t values = (size_t)(row->each ? making->comm->size : entries);
    union report_value *value = memory_allocate_zero(values, sizeof *value, "report");
    for (int k = 0; k < entries; k++)
        value[k] = value_make(row, making->source, k);
    if (row->each) {
        union report_value mine = value[0];
        comm_gather_all(making->comm, &mine, sizeof mine, value);
    }
    return (struct report_column){.value = value};
}

static struct report_table table_make(const struct report_row *rows, int entries,
                                      const struct making *making) {
    int count = rows_count(rows);
    struct report_table table = {.rows = rows, .entries = entries};
    table.column = memory_allocate_zero((size_t)count, sizeof *table.column, "report");
    for (int r = 0; r < count; r++) {
        const struct report_row *row = &rows[r];
        struct report_column *column = &table.column[r];
        if (row->shape == REPORT_VALUE) {
            *column = values_make(row, entries, making);
            continue;
        }
        column->table = memory_allocate(1, sizeof *column->table, "report");
        *column->table = table_make(row->rows, row->entries ? row->entries(making->source) : 1, making);
    }
    return table;
}

void report_make(struct report *report, const struct report_row *rows, const struct comm *comm,
                 const struct report_source *source) {
    const struct making making = {comm, source};
    *report = (struct report){.ranks = comm->size, .table = table_make(rows, 1, &making)};
}

static void table_free(struct report_table *table) {
    int count = table->rows ? rows_count(table->rows) : 0;
    for (int r = 0; r < count; r++) {
        struct report_column *column = &table->column[r];
        for (int k = 0; table->rows[r].text && k < table->entries; k++)
            memory_free(column->value[k].text);
        if (column->table)
            table_free(column->table);
        memory_free(column->table);
        memory_free(column->value);
    }
    memory_free(table->column);
    *table = (struct report_table){0};
}

void report_destroy(struct report *report) {
    table_free(&report->table);
}

const struct report_row *report_find(const struct report_table *table, const char *name, size_t length,
                                     const struct report_column **column) {
    size_t part = 0;
    while (part < length && name[part] != '.')
        part++;
    for (int r = 0; table->rows[r].name; r++) {
        if (strlen(table->rows[r].name) != part || memcmp(table->rows[r].name, name, part) != 0)
            continue;
        *column = &table->column[r];
        if (part == length)
            return &table->rows[r];
        return report_find((*column)->table, name + part + 1, length - part - 1, column);
    }
    return NULL;
}

const struct report_table *report_list(const struct report *report, const char *name) {
    const struct report_column *column;
    const struct report_row *row = report_find(&report->table, name, strlen(name), &column);
    assert(row && row->rows);
    (void)row;
    return column->table;
}

double report_list_number(const struct report_table *table, int k, const char *name) {
    const struct report_column *column;
    const struct report_row *row = report_find(table, name, strlen(name), &column);
    assert(row && row->shape == REPORT_VALUE && !row->text);
    return row->real ? column->value[k].real : (double)column->value[k].count;
}

const char *report_list_text(const struct report_table *table, int k, const char *name) {
    const struct report_column *column;
    const struct report_row *row = report_find(table, name, strlen(name), &column);
    assert(row && row->text);
    (void)row;
    return column->value[k].text;
}

double report_number(const struct report *report, const char *name) {
    return report_list_number(&report->table, 0, name);
}

const char *report_text(const struct report *report, const char *name) {
    return report_list_text(&report->table, 0, name);
}

bool report_holds(const struct report_table *table, int k, const char *name) {
    const struct report_column *column;
    const struct report_row *row = report_find(table, name, strlen(name), &column);
    assert(row);
    if (row->shape != REPORT_VALUE)
        return column->table->entries > 0;
    if (row->text)
        return column->value[k].text[0] != '\0';
    return row->real ? column->value[k].real != 0 : column->value[k].count != 0;
}
