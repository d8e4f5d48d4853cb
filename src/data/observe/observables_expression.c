/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables that a scene writes itself: a sum, mean, largest or least value of an expression over the particles that
 * another expression selects, and how well the selected particles are mixed with the others. Read observables_kinds.h and expression.h first. */
#include "data/observe/expression.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/exact.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"

#include <math.h>
#include <string.h>

/* Variables of every scene; then each field of one double. */
enum { T, X, VX = X + 3, FX = VX + 3, WX = FX + 3, RADIUS = WX + 3, MASS, ID, MATERIAL, GROUP, FIRST_FIELD };
static const char *const names[] = {"t",  "x",  "y",  "z",  "vx",     "vy",   "vz", "fx",       "fy",
                                    "fz", "wx", "wy", "wz", "radius", "mass", "id", "material", "group"};

enum { OF, WHERE, TEXTS };

struct observable_expression {
    struct expression *text[TEXTS]; /* OF: NULL for lacey; WHERE: NULL: all particles */
    int64_t cells[3];               /* lacey */
    int variables;
    int field[EXPRESSION_VARIABLES_MAX]; /* handle, of variables from FIRST_FIELD on */
};

void observables_expression_free(struct observable_expression **expression) {
    struct observable_expression *e = *expression;
    if (e == NULL)
        return;
    for (int k = 0; k < TEXTS; k++)
        expression_destroy(&e->text[k]);
    memory_free(e);
    *expression = NULL;
}

static const char mixing_name[] = "lacey";

/* Lacey's index needs cells, and who is to be mixed. */
static bool mixing_check(const struct observable_request *request, struct error *error) {
    static const double most = 1e7;
    double all = 1;
    for (int d = 0; d < request->directions; d++)
        all *= (double)request->cells[d];
    if (request->directions != 3 || all > most)
        return error_set(
            error, ERROR_USER,
            "observables: lacey: cells: needed: three numbers, of x, y and z, of at most 10 million "
            "cells");
    return (request->where[0] && !request->of[0]) ||
           error_set(
               error, ERROR_USER,
               "observables: lacey: needs `where`, which selects the particles that are to be mixed with the "
               "others, and takes no `of`");
}

bool observables_expression_make(struct observable_expression **expression,
                                 const struct observable_request *request, const struct output_view *view,
                                 struct error *error) {
    struct observable_expression *e = memory_allocate_zero(1, sizeof *e, "expression");
    const char *name[EXPRESSION_VARIABLES_MAX];
    const struct particles *p = view->particles;
    struct error plain = {0};
    *expression = e;
    memcpy(name, names, sizeof names);
    e->variables = FIRST_FIELD;
    for (int f = 0; f < fields_count(p) && e->variables < EXPRESSION_VARIABLES_MAX; f++) {
        const struct field *field = fields_get(p, f);
        if (field->type != FIELD_DOUBLE || field->components != 1 || f < FIELD_FIRST_COUNT)
            continue;
        e->field[e->variables] = f;
        name[e->variables++] = field->name;
    }
    bool mixing = strcmp(request->name, mixing_name) == 0;
    if (mixing && !mixing_check(request, error))
        return false;
    memcpy(e->cells, request->cells, sizeof e->cells);
    bool good = mixing || request->of[0] ||
                error_set(&plain, ERROR_USER, "is missing; needed: an expression over particle fields");
    good = good && (mixing || expression_create(&e->text[OF], request->of, name, e->variables, &plain));
    if (!good)
        return error_set(error, ERROR_USER, "observables: %s: of: %s", request->name, plain.text);
    if (request->where[0] && !expression_create(&e->text[WHERE], request->where, name, e->variables, &plain))
        return error_set(error, ERROR_USER, "observables: %s: where: %s", request->name, plain.text);
    return true;
}

static bool uses(const struct observable_expression *e, int k) {
    return (e->text[OF] && expression_uses(e->text[OF], k)) ||
           (e->text[WHERE] && expression_uses(e->text[WHERE], k));
}

static void put(struct observable_expression *e, int k, size_t place, double value) {
    for (int t = 0; t < TEXTS; t++)
        if (e->text[t])
            expression_variable(e->text[t], k)[place] = value;
}

/* Fills the variables of particle i. */
static void fill(struct observable_expression *e, const struct output_view *view, size_t i, size_t place) {
    const struct particles *p = view->particles;
    const double *force = p->force + i * (size_t)p->force_stride;
    const uint8_t *material = material_numbers(p), *group = groups_of(p);
    double x[3], v[3], w[3] = {0};
    observables_place(view, i, x);
    observables_velocity(view, i, v, spin_of(p) ? w : NULL);
    for (int d = 0; d < 3; d++) {
        put(e, X + d, place, x[d]);
        put(e, VX + d, place, v[d]);
        put(e, FX + d, place, force[d]);
        put(e, WX + d, place, w[d]);
    }
    put(e, T, place, view->time);
    put(e, RADIUS, place, p->state[i].radius);
    put(e, MASS, place, groups_mass(p, i));
    put(e, ID, place, (double)p->id[i]);
    put(e, MATERIAL, place, material_of(material, i));
    put(e, GROUP, place, group ? group[i] : 0);
    for (int k = FIRST_FIELD; k < e->variables; k++) {
        size_t stride;
        if (uses(e, k)) {
            const char *base = fields_base(p, e->field[k], &stride);
            double value;
            memcpy(&value, base + i * stride, sizeof value);
            put(e, k, place, value);
        }
    }
}

/* What has been found on this rank. */
struct found {
    struct exact sum;
    double count, largest, least;
};

static void take(struct observable_expression *e, size_t n, struct found *found) {
    const double *where = e->text[WHERE] ? expression_evaluate(e->text[WHERE], n) : NULL;
    const double *value = expression_evaluate(e->text[OF], n);
    for (size_t k = 0; k < n; k++) {
        if (where && where[k] == 0)
            continue;
        exact_add(&found->sum, value[k]);
        found->count += 1;
        found->largest = fmax(found->largest, value[k]);
        found->least = fmin(found->least, value[k]);
    }
}

/* Goes over all grains of all ranks; the same on every rank, and on every layout. Collective. */
static void over_all(const struct observable_context *context, struct observable_item *item,
                     struct found *found) {
    const struct output_view *view = context->view;
    const uint8_t *kind = kinds_of(view->particles);
    *found = (struct found){.largest = -INFINITY, .least = INFINITY};
    size_t n = 0;
    for (size_t i = 0; i < view->particles->owned; i++) {
        if (kind && kind[i] != KIND_GRAIN)
            continue;
        fill(item->expression, view, i, n++);
        if (n == EXPRESSION_CHUNK) {
            take(item->expression, n, found);
            n = 0;
        }
    }
    take(item->expression, n, found);
    comm_sum_int(view->comm, found->sum.word, EXACT_WORDS);
    comm_sum(view->comm, &found->count, 1);
    comm_max(view->comm, &found->largest, 1);
    comm_min(view->comm, &found->least, 1);
}

/* The value of all ranks is given by the first. */
static void give(const struct observable_context *context, double value, double *part) {
    if (context->view->comm->rank == 0)
        part[0] = value;
}

static void sum_of(const struct observable_context *context, struct observable_item *item, double *part) {
    struct found found;
    over_all(context, item, &found);
    give(context, exact_value(&found.sum), part);
}

static void mean_of(const struct observable_context *context, struct observable_item *item, double *part) {
    struct found found;
    over_all(context, item, &found);
    give(context, found.count > 0 ? exact_value(&found.sum) / found.count : NAN, part);
}

static void largest_of(const struct observable_context *context, struct observable_item *item, double *part) {
    struct found found;
    over_all(context, item, &found);
    give(context, found.count > 0 ? found.largest : NAN, part);
}

static void least_of(const struct observable_context *context, struct observable_item *item, double *part) {
    struct found found;
    over_all(context, item, &found);
    give(context, found.count > 0 ? found.least : NAN, part);
}

/* The cell of a particle; one beyond the box counts in the cell next to it. */
static size_t cell_of(const struct observable_expression *e, const struct output_view *view, size_t i) {
    double x[3];
    size_t cell = 0;
    memcpy(x, view->particles->state[i].x, sizeof x);
    box_wrap(view->box, x, NULL);
    for (int d = 0; d < 3; d++) {
        double at = floor(x[d] / view->box->edge[d] * (double)e->cells[d]);
        at = fmin(fmax(at, 0), (double)(e->cells[d] - 1));
        cell = cell * (size_t)e->cells[d] + (size_t)at;
    }
    return cell;
}

/* Adds the n particles of a chunk to the counts of their cells: all, selected. */
static void count_chunk(struct observable_expression *e, const size_t *cell, size_t n, double (*count)[2]) {
    const double *where = expression_evaluate(e->text[WHERE], n);
    for (size_t k = 0; k < n; k++) {
        count[cell[k]][0] += 1;
        count[cell[k]][1] += where[k] != 0;
    }
}

/* Lacey's index of the counts. */
static double lacey_of(const double (*count)[2], size_t cells) {
    double all = 0, selected = 0, filled = 0, variance = 0;
    for (size_t k = 0; k < cells; k++) {
        all += count[k][0];
        selected += count[k][1];
        filled += count[k][0] > 0;
    }
    double p = selected / all, apart = p * (1 - p), random = apart * filled / all;
    for (size_t k = 0; k < cells; k++)
        if (count[k][0] > 0)
            variance += count[k][0] * pow(count[k][1] / count[k][0] - p, 2) / all;
    return apart > random ? (apart - variance) / (apart - random) : NAN;
}

static void lacey(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct output_view *view = context->view;
    struct observable_expression *e = item->expression;
    const uint8_t *kind = kinds_of(view->particles);
    size_t cells = (size_t)(e->cells[0] * e->cells[1] * e->cells[2]), n = 0, cell[EXPRESSION_CHUNK];
    double(*count)[2] = memory_allocate_zero(cells, sizeof *count, "cells of lacey");
    for (size_t i = 0; i < view->particles->owned; i++) {
        if (kind && kind[i] != KIND_GRAIN)
            continue;
        cell[n] = cell_of(e, view, i);
        fill(e, view, i, n++);
        if (n == EXPRESSION_CHUNK) {
            count_chunk(e, cell, n, count);
            n = 0;
        }
    }
    count_chunk(e, cell, n, count);
    comm_sum(view->comm, count[0], 2 * (int)cells);
    give(context, lacey_of((const double(*)[2])count, cells), part);
    memory_free(count);
}

#define ROW(name, function, help)                                                                            \
    { .info = {name, "", "1", help, OBSERVABLE_OF_EXPRESSION, 1, NULL}, .parts = 1, .of_rank = function }

static const struct observable_kind kinds[] = {
    ROW("sum", sum_of, "sum of an expression over the particles that `where` selects"),
    ROW("mean", mean_of, "its mean; nan without particles"),
    ROW("largest", largest_of, "its largest value"),
    ROW("least", least_of, "its least value"),
    ROW("lacey", lacey,
        "Lacey's mixing (segregation) index of the particles that `where` selects among all, by number, in "
        "the `cells` of "
        "the box: 0 apart, "
        "1 as at random; (s0 - s) / (s0 - sr) with the variances s0 = p (1 - p), s = sum of n_k (p_k - p)^2 "
        "/ N and sr = s0 K / N "
        "over the K cells with particles (Lacey, J. Appl. Chem. 4 (1954) 257)"),
};

#undef ROW

int observables_expression_count(void) {
    return sizeof kinds / sizeof kinds[0];
}

const struct observable_kind *observables_expression(int k) {
    return &kinds[k];
}
