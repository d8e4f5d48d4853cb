/* SPDX-License-Identifier: BSD-3-Clause */
/* A row: each rank's parts -> one sum and one maximum over ranks -> components -> columns. Sums over
 * particles go chunk by chunk, the chunks in order, so that the result is the same bits for any number of
 * threads. In a reproducible run the sums are without rounding (base/exact.h), so that the result is the same
 * bits for any number of ranks and any index, too. */
#include "data/observe/observables_kinds.h"

#include "base/exact.h"
#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"
#include "kernel/particles/kinds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { CHUNK = 4096 };

/* The kinds of the particles if some of them do not count for a row, else NULL. */
static const uint8_t *kinds_for(const struct observable_kind *row, const struct output_view *view) {
    return row->of_all_kinds ? NULL : kinds_of(view->particles);
}

static bool counts(const uint8_t *kind, size_t i) {
    return kind == NULL || kind[i] == KIND_GRAIN;
}

/* Adds up (or takes the largest of) the parts of all owned particles that count. */
static void over_particles(const struct output_view *view, const struct observable_item *item, double *part) {
    const struct observable_kind *kind = observables_kind(item->kind);
    const uint8_t *of = kinds_for(kind, view);
    size_t owned = view->particles->owned, chunks = (owned + CHUNK - 1) / CHUNK;
    double(*partial)[OBSERVABLE_PARTS_MAX] = memory_allocate_zero(chunks, sizeof *partial, "partial sums");
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < chunks; c++) {
        size_t last = (c + 1) * CHUNK < owned ? (c + 1) * CHUNK : owned;
        for (size_t i = c * CHUNK; i < last; i++)
            if (counts(of, i))
                kind->of_particle(view, item, i, partial[c]);
    }
    for (size_t c = 0; c < chunks; c++)
        for (int k = 0; k < kind->parts; k++)
            part[k] =
                kind->combine == OBSERVABLE_MAX ? fmax(part[k], partial[c][k]) : part[k] + partial[c][k];
    memory_free(partial);
}

/* Adds up the parts of all owned particles that count without rounding. */
static void over_particles_exactly(const struct output_view *view, const struct observable_item *item,
                                   struct exact *sum) {
    const struct observable_kind *kind = observables_kind(item->kind);
    const uint8_t *of = kinds_for(kind, view);
#pragma omp parallel
    {
        struct exact mine[OBSERVABLE_PARTS_MAX] = {0};
#pragma omp for schedule(static)
        for (size_t i = 0; i < view->particles->owned; i++) {
            double one[OBSERVABLE_PARTS_MAX] = {0};
            if (counts(of, i))
                kind->of_particle(view, item, i, one);
            for (int k = 0; k < kind->parts; k++)
                exact_add(&mine[k], one[k]);
        }
#pragma omp critical(observables_exact)
        for (int k = 0; k < kind->parts; k++)
            exact_join(&sum[k], &mine[k]);
    }
}

/* The parts of one item that are sums over ranks, without rounding. */
static void item_exactly(const struct observable_context *context, struct observable_item *item,
                         struct exact *sum) {
    const struct observable_kind *kind = observables_kind(item->kind);
    double own[OBSERVABLE_PARTS_MAX] = {0};
    if (kind->of_particle)
        over_particles_exactly(context->view, item, sum);
    if (kind->of_rank)
        kind->of_rank(context, item, own);
    for (int k = 0; k < kind->parts; k++)
        exact_add(&sum[k], own[k]);
}

/* The parts of this rank, of all items one after another. With `exact`, parts that are summed over ranks
 * go to `exact` instead. */
static double *find_parts(struct observables *o, const struct output_view *view, struct exact *exact) {
    struct contact_list contacts = {0};
    if (o->needs_contacts)
        contact_list_create(&contacts, view);
    struct observable_context context = {
        .view = view, .wall_force = (const double(*)[6])o->wall_force, .contacts = &contacts};
    double *part = memory_allocate_zero((size_t)o->parts, sizeof *part, "parts of observables");
    if (view->walls)
        walls_forces(view->walls, o->wall_force);
    for (int k = 0; k < o->items; k++) {
        struct observable_item *item = &o->item[k];
        const struct observable_kind *kind = observables_kind(item->kind);
        double own[OBSERVABLE_PARTS_MAX] = {0};
        if (exact && kind->combine == OBSERVABLE_SUM) {
            item_exactly(&context, item, exact + item->first_part);
            continue;
        }
        if (kind->of_particle)
            over_particles(view, item, own);
        if (kind->of_rank)
            kind->of_rank(&context, item, own);
        memcpy(part + item->first_part, own, (size_t)kind->parts * sizeof *part);
    }
    contact_list_free(&contacts);
    return part;
}

/* Sums over ranks that were kept without rounding. */
static void combine_exactly(const struct observables *o, const struct comm *comm, struct exact *exact,
                            double *part) {
    comm_sum_int(comm, exact[0].word, o->parts * (int)EXACT_WORDS);
    for (int k = 0; k < o->items; k++) {
        const struct observable_kind *kind = observables_kind(o->item[k].kind);
        int first = o->item[k].first_part;
        for (int p = first; kind->combine == OBSERVABLE_SUM && p < first + kind->parts; p++)
            part[p] = exact_value(&exact[p]);
    }
}

/* Combines the parts of all ranks. */
static void combine(const struct observables *o, const struct comm *comm, double *part) {
    size_t bytes = (size_t)o->parts * sizeof *part;
    double *largest = memory_allocate((size_t)o->parts, sizeof *largest, "parts of observables");
    memcpy(largest, part, bytes);
    comm_max(comm, largest, o->parts);
    comm_sum(comm, part, o->parts);
    for (int k = 0; k < o->items; k++) {
        const struct observable_kind *kind = observables_kind(o->item[k].kind);
        if (kind->combine == OBSERVABLE_MAX)
            memcpy(part + o->item[k].first_part, largest + o->item[k].first_part,
                   (size_t)kind->parts * sizeof *part);
    }
    memory_free(largest);
}

static void find_values(struct observables *o, const struct output_view *view) {
    bool reproducible = view->contact && view->contact->ordered && o->parts > 0;
    struct exact *exact =
        reproducible ? memory_allocate_zero((size_t)o->parts, sizeof *exact, "parts of observables") : NULL;
    double *part = find_parts(o, view, exact);
    combine(o, view->comm, part);
    if (exact)
        combine_exactly(o, view->comm, exact, part);
    memory_free(exact);
    for (int k = 0; k < o->items; k++) {
        const struct observable_item *item = &o->item[k];
        const struct observable_kind *kind = observables_kind(item->kind);
        double *component = part + item->first_part;
        if (kind->finish)
            kind->finish(view, item, component);
        int column = item->first_column;
        for (int c = 0; c < kind->info.components; c++)
            if (item->components & 1u << c)
                o->value[column++] = component[c];
    }
    memory_free(part);
}

static void write_header(const struct observables *o, FILE *file) {
    fprintf(file, "time[%s]", o->dimensionless ? "1" : "s");
    for (int c = 0; c < o->columns; c++)
        fprintf(file, ",%s[%s]", o->column[c].name, o->column[c].unit);
    fprintf(file, "\n");
}

/* True if the first line of a file is the header. */
static bool same_header(const struct observables *o, const char *line) {
    char *header = NULL;
    size_t size;
    FILE *memory = open_memstream(&header, &size);
    if (!memory)
        return false;
    write_header(o, memory);
    fclose(memory);
    bool same = size > 0 && strncmp(line, header, size - 1) == 0 && line[size - 1] == '\0';
    free(header);
    return same;
}

/* Reads the header of a file, if it has one; false if it is another. */
static bool header_suits(const struct observables *o, struct lines *lines, struct error *error) {
    return !lines_next(lines) || same_header(o, lines->text) ||
           error_set(error, ERROR_USER,
                     "%s: has other columns than this run writes; choose another output directory",
                     lines->path);
}

bool observables_suit(const struct observables *o, const char *directory, struct error *error) {
    struct lines lines;
    char path[FILE_PATH_MAX];
    if (!file_join(path, directory, "observables.csv", error))
        return false;
    if (file_size(path) <= 0)
        return true;
    bool good = lines_open(&lines, path, error) && header_suits(o, &lines, error);
    lines_close(&lines);
    return good;
}

/* Cuts a present file behind the last whole row up to a time. */
static bool cut_file(struct observables *o, double time, struct error *error) {
    struct lines lines;
    if (!lines_open(&lines, o->path, error))
        return false;
    if (!header_suits(o, &lines, error)) {
        lines_close(&lines);
        return false;
    }
    int64_t end = lines.whole ? lines_place(&lines) : 0;
    double row;
    while (lines_next(&lines) && lines.whole && sscanf(lines.text, "%lf", &row) == 1 &&
           row <= time + 1e-12 * fabs(time)) {
        o->last_time = row;
        end = lines_place(&lines);
    }
    lines_close(&lines);
    return truncate(o->path, end) == 0 ||
           error_set_errno(error, "%s: cannot be cut to go on with it", o->path);
}

bool observables_open(struct observables *o, const struct comm *comm, const char *directory,
                      double resume_time, struct error *error) {
    if (comm->rank == 0 && file_join(o->path, directory, "observables.csv", error)) {
        bool go_on = resume_time >= 0 && file_size(o->path) > 0;
        if (!go_on || cut_file(o, resume_time, error)) {
            o->file = fopen(o->path, go_on ? "a" : "w");
            if (!o->file)
                error_set_errno(error, "%s: cannot be written", o->path);
            else if (file_size(o->path) == 0)
                write_header(o, o->file);
            if (o->file && fflush(o->file) != 0)
                error_set_errno(error, "%s: cannot be written", o->path);
        }
    }
    return comm_agree(comm, error);
}

bool observables_need_sums(const struct observables *o) {
    return o->needs_sums;
}

bool observables_need_work(const struct observables *o) {
    return o->needs_work;
}

bool observables_write(struct observables *o, const struct output_view *view, struct error *error) {
    find_values(o, view);
    bool new_row = view->time > o->last_time + 1e-12 * fabs(o->last_time) || isinf(o->last_time);
    if (o->file && new_row) {
        fprintf(o->file, "%.15g", view->time);
        for (int c = 0; c < o->columns; c++)
            fprintf(o->file, ",%.15g", o->value[c]);
        fprintf(o->file, "\n");
        if (fflush(o->file) != 0 || ferror(o->file))
            error_set_errno(error, "%s: a row cannot be written", o->path);
        o->last_time = view->time;
    }
    return comm_agree(view->comm, error);
}

int observables_columns(const struct observables *o) {
    return o->columns;
}

const char *observables_column_name(const struct observables *o, int column) {
    return o->name[column];
}

const char *observables_column_unit(const struct observables *o, int column) {
    return o->unit[column];
}

const double *observables_values(const struct observables *o) {
    return o->value;
}

void observables_row(const struct observables *o, const struct output_view *view,
                     struct h5md_observables *row) {
    *row = (struct h5md_observables){.columns = o->columns,
                                     .name = o->name,
                                     .unit = o->unit,
                                     .value = o->value,
                                     .step = view->step,
                                     .time = view->time};
}
