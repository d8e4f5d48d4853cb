/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums over particles and contacts on a grid, and the file of the grid. Read observables_grid.h first. */
#include "data/observe/observables_grid.h"
#include "data/observe/observables_kinds.h"

#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"
#include "data/formats/contact_list.h"
#include "kernel/particles/kinds.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Sums of a cell: number, mass, volume of solids, momentum, flux of momentum, static stress. */
enum { NUMBER, MASS, SOLID, MOMENTUM, FLUX = MOMENTUM + 3, STATIC = FLUX + 6, SUMS = STATIC + 6 };

/* Components of a symmetric tensor. */
static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};

/* Points on the branch of a contact at which the kernel is taken, and the reach of a Gaussian in widths. */
enum { POINTS = 10, REACH = 4 };

static const char header[] =
    "time,x,y,z,number_density,density,solid_fraction,vx,vy,vz,temperature,sxx,syy,szz,sxy,sxz,syz\n";

/* The kernel of a point along a direction: at which cells it is not 0. */
struct along {
    size_t *cell;
    double *value;
    size_t count;
};

struct grid {
    const struct output_grid *options;
    char path[FILE_PATH_MAX];
    FILE *file;               /* rank 0 */
    double lower[3], edge[3]; /* of a cell */
    size_t cells[3], total;
    int images[3]; /* of the box to each side that a Gaussian may reach */
    struct along along[3];
    double (*sum)[SUMS];
};

/* The corners: those given, or of the box as it is now; and the images within the reach of a Gaussian. */
static void place_corners(struct grid *g, const struct box *box) {
    const struct output_grid *options = g->options;
    const struct box_motion *motion = &box->motion;
    for (int d = 0; d < 3; d++) {
        bool given = isfinite(options->lower[d]) && isfinite(options->upper[d]);
        g->lower[d] = given ? options->lower[d] : box->origin[d];
        g->edge[d] =
            ((given ? options->upper[d] : box->origin[d] + box->edge[d]) - g->lower[d]) / (double)g->cells[d];
        bool wraps = d < box->dimension && box->periodic[d] && options->kernel == OUTPUT_KERNEL_GAUSS;
        g->images[d] = wraps ? 1 + (int)ceil(REACH * options->width / box->edge[d]) : 0;
    }
    if (motion->shears) /* those along the gradient stand up to an edge apart along the flow */
        g->images[motion->flow] += g->images[motion->gradient];
}

static void along_add(struct along *along, size_t cell, double value) {
    along->cell[along->count] = cell;
    along->value[along->count++] = value;
}

/* Adds a Gaussian around `x` to the list. */
static void along_gauss(struct grid *g, int d, double x) {
    double width = g->options->width, first = ceil((x - REACH * width - g->lower[d]) / g->edge[d] - 0.5);
    double last = floor((x + REACH * width - g->lower[d]) / g->edge[d] - 0.5);
    double scale = 1 / (sqrt(2 * M_PI) * width * erf(REACH / sqrt(2)));
    first = fmax(first, 0);
    last = fmin(last, (double)g->cells[d] - 1);
    for (double k = first; k <= last; k++) {
        double off = (g->lower[d] + (k + 0.5) * g->edge[d] - x) / width;
        along_add(&g->along[d], (size_t)k, scale * exp(-0.5 * off * off));
    }
}

/* Finds the kernel of a point, in the user's coordinates, along a direction; false if it is 0 at all cells. */
static bool along_find(struct grid *g, const struct box *box, int d, double x) {
    struct along *along = &g->along[d];
    along->count = 0;
    if (d >= box->dimension) {
        along_add(along, 0, 1);
    } else if (g->cells[d] == 1 || g->options->kernel == OUTPUT_KERNEL_CELLS) {
        double place = floor((x - g->lower[d]) / g->edge[d]);
        if (place >= 0 && place < (double)g->cells[d])
            along_add(along, (size_t)place, 1 / g->edge[d]);
    } else {
        along_gauss(g, d, x);
    }
    return along->count > 0;
}

/* A point that adds numbers to the cells around it and around its images. */
struct point {
    double x[3], v[3]; /* box-relative, in the box; the velocity belongs to this place */
    int image[3];
    double mass; /* 0: the numbers go with no velocity */
    int first, count;
    double value[STATIC]; /* `count` of them, to be added from the sum number `first` on */
};

/* Adds the numbers of one image of a point, times the kernel, to the cells. */
static void spread(struct grid *g, const struct box *box, struct point *point) {
    double v[3];
    box_drift(box, point->image, v);
    for (int d = 0; point->mass > 0 && d < 3; d++) {
        v[d] += point->v[d];
        point->value[MOMENTUM + d] = point->mass * v[d];
    }
    for (int c = 0; point->mass > 0 && c < 6; c++)
        point->value[FLUX + c] = point->mass * v[row[c]] * v[column[c]];
    for (size_t a = 0; a < g->along[0].count; a++)
        for (size_t b = 0; b < g->along[1].count; b++)
            for (size_t c = 0; c < g->along[2].count; c++) {
                size_t cell = (g->along[0].cell[a] * g->cells[1] + g->along[1].cell[b]) * g->cells[2] +
                              g->along[2].cell[c];
                double kernel = g->along[0].value[a] * g->along[1].value[b] * g->along[2].value[c];
                for (int k = 0; k < point->count; k++)
                    g->sum[cell][point->first + k] += kernel * point->value[k];
            }
}

/* Goes over the images of a point, direction by direction, from the gradient of a shear on, as its images stand elsewhere
 * along the flow. */
static void deposit_images(struct grid *g, const struct box *box, struct point *point, int depth) {
    int d = ((box->motion.shears ? box->motion.gradient : 0) + depth) % 3;
    if (depth == 3) {
        spread(g, box, point);
        return;
    }
    for (point->image[d] = -g->images[d]; point->image[d] <= g->images[d]; point->image[d]++) {
        double shift[3];
        box_shift(box, point->image, shift);
        if (along_find(g, box, d, point->x[d] + shift[d] + box->origin[d]))
            deposit_images(g, box, point, depth + 1);
    }
    point->image[d] = 0;
}

static void deposit(struct grid *g, const struct box *box, struct point *point) {
    box_wrap(box, point->x, point->v);
    deposit_images(g, box, point, 0);
}

static void add_particle(struct grid *g, const struct output_view *view, size_t i) {
    const struct particle_state *state = &view->particles->state[i];
    struct point point = {.mass = 1 / state->inverse_mass, .count = STATIC};
    integrator_full_step(view->particles, view->motion, i, point.v, NULL);
    memcpy(point.x, state->x, sizeof point.x);
    point.value[NUMBER] = 1;
    point.value[MASS] = point.mass;
    point.value[SOLID] = observables_solid(view, i);
    deposit(g, view->box, &point);
}

static void add_contact(struct grid *g, const struct output_view *view, const struct force_contact *contact) {
    const double *l = contact->branch, *f = contact->force,
                 *from = view->particles->state[contact->number_i].x;
    struct point point = {.first = STATIC, .count = 6};
    for (int c = 0; c < 6; c++)
        point.value[c] = 0.5 * (l[row[c]] * f[column[c]] + l[column[c]] * f[row[c]]) / POINTS;
    for (int p = 0; p < POINTS; p++) {
        for (int d = 0; d < 3; d++)
            point.x[d] = from[d] + (p + 0.5) / POINTS * l[d];
        deposit(g, view->box, &point);
    }
}

static void fill(struct grid *g, const struct output_view *view) {
    const uint8_t *kind = kinds_of(view->particles);
    struct contact_list list;
    place_corners(g, view->box);
    memset(g->sum, 0, g->total * sizeof *g->sum);
    for (size_t i = 0; i < view->particles->owned; i++)
        if (view->particles->state[i].inverse_mass > 0 && (kind == NULL || kind[i] == KIND_GRAIN))
            add_particle(g, view, i);
    contact_list_create(&list, view);
    for (size_t k = 0; k < list.particle_count; k++)
        add_contact(g, view, &list.particle[k]);
    for (size_t k = 0; k < list.wall_count; k++)
        add_contact(g, view, &list.wall[k]);
    contact_list_free(&list);
    for (size_t first = 0; first < g->total; first += 1 << 20) { /* counts of MPI are ints */
        size_t part = g->total - first < 1 << 20 ? g->total - first : 1 << 20;
        comm_sum(view->comm, g->sum[first], (int)(part * SUMS));
    }
}

static void row_write(const struct grid *g, const struct output_view *view, size_t cell) {
    const double *sum = g->sum[cell];
    size_t place[3] = {cell / (g->cells[1] * g->cells[2]), cell / g->cells[2] % g->cells[1],
                       cell % g->cells[2]};
    double v[3], stress[6], trace = 0;
    fprintf(g->file, "%.15g", view->time);
    for (int d = 0; d < 3; d++) {
        v[d] = sum[MASS] > 0 ? sum[MOMENTUM + d] / sum[MASS] : NAN;
        fprintf(g->file, ",%.9g", g->lower[d] + ((double)place[d] + 0.5) * g->edge[d]);
    }
    for (int c = 0; c < 6; c++) {
        double kinetic = sum[MASS] > 0 ? sum[FLUX + c] - sum[MASS] * v[row[c]] * v[column[c]] : 0;
        trace += c < 3 ? kinetic : 0;
        stress[c] = kinetic + sum[STATIC + c];
    }
    fprintf(g->file, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", sum[NUMBER], sum[MASS], sum[SOLID], v[0], v[1],
            v[2], sum[MASS] > 0 ? trace / (view->box->dimension * sum[MASS]) : NAN);
    for (int c = 0; c < 6; c++)
        fprintf(g->file, ",%.9g", stress[c]);
    fprintf(g->file, "\n");
}

bool observables_grid_write(struct grid *g, const struct output_view *view, struct error *error) {
    fill(g, view);
    for (size_t cell = 0; g->file && cell < g->total; cell++)
        row_write(g, view, cell);
    if (g->file && (fflush(g->file) != 0 || ferror(g->file)))
        error_set_errno(error, "%s: a row cannot be written", g->path);
    return comm_agree(view->comm, error);
}

/* Reads the header of a file; false if it is another. */
static bool header_suits(struct lines *lines, struct error *error) {
    return (lines_next(lines) && strncmp(lines->text, header, sizeof header - 2) == 0) ||
           error_set(error, ERROR_USER, "%s: is no file of a grid; choose another output directory",
                     lines->path);
}

/* The path of a grid's file; false if it is too long. */
static bool file_path(const struct output_grid *options, const char *directory, char path[FILE_PATH_MAX],
                      struct error *error) {
    char name[OUTPUT_NAME_MAX + 16];
    snprintf(name, sizeof name, "grid-%s.csv", options->name);
    return file_join(path, directory, name, error);
}

bool observables_grid_suits(const struct output_grid *options, const char *directory, struct error *error) {
    struct lines lines;
    char path[FILE_PATH_MAX];
    if (!file_path(options, directory, path, error))
        return false;
    if (file_size(path) <= 0)
        return true;
    bool good = lines_open(&lines, path, error) && header_suits(&lines, error);
    lines_close(&lines);
    return good;
}

/* Cuts a present file behind the last row up to a time. */
static bool cut(const struct grid *g, double time, struct error *error) {
    struct lines lines;
    int64_t end = 0;
    double row;
    if (!lines_open(&lines, g->path, error))
        return false;
    bool same = header_suits(&lines, error);
    end = lines_place(&lines);
    while (same && lines_next(&lines) && lines.whole && sscanf(lines.text, "%lf", &row) == 1 &&
           row <= time + 1e-12 * fabs(time))
        end = lines_place(&lines);
    lines_close(&lines);
    if (!same)
        return false;
    return truncate(g->path, end) == 0 ||
           error_set_errno(error, "%s: cannot be cut to go on with it", g->path);
}

static void file_open(struct grid *g, const char *directory, double resume_time, struct error *error) {
    if (!file_path(g->options, directory, g->path, error))
        return;
    bool go_on = resume_time >= 0 && file_size(g->path) > 0;
    if (go_on && !cut(g, resume_time, error))
        return;
    g->file = fopen(g->path, go_on ? "a" : "w");
    if (g->file && !go_on)
        fputs(header, g->file);
    if (g->file == NULL || fflush(g->file) != 0)
        error_set_errno(error, "%s: cannot be written", g->path);
}

bool observables_grid_open(struct grid **grid, const struct output_grid *options,
                           const struct output_view *view, const char *directory, double resume_time,
                           struct error *error) {
    struct grid *g = memory_allocate_zero(1, sizeof *g, "grid of fields");
    const struct box *box = view->box;
    *grid = g;
    g->options = options;
    g->total = 1;
    for (int d = 0; d < 3; d++) {
        g->cells[d] = d < box->dimension ? (size_t)options->cells[d] : 1;
        g->along[d].cell = memory_allocate(g->cells[d], sizeof *g->along[d].cell, "grid of fields");
        g->along[d].value = memory_allocate(g->cells[d], sizeof *g->along[d].value, "grid of fields");
        g->total *= g->cells[d];
    }
    g->sum = memory_allocate(g->total, sizeof *g->sum, "grid of fields");
    if (view->comm->rank == 0)
        file_open(g, directory, resume_time, error);
    return comm_agree(view->comm, error);
}

void observables_grid_close(struct grid **grid) {
    struct grid *g = *grid;
    if (g == NULL)
        return;
    if (g->file)
        fclose(g->file);
    for (int d = 0; d < 3; d++) {
        memory_free(g->along[d].cell);
        memory_free(g->along[d].value);
    }
    memory_free(g->sum);
    memory_free(g);
    *grid = NULL;
}
