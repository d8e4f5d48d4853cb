/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a packing: box, spheres, relaxation, rows. Read pack.h first. */
#include "pack/pack.h"
#include "pack/bidisperse.h"

#include "core/memory.h"
#include "core/random.h"
#include "core/threads.h"
#include "pack/draw.h"
#include "pack/push.h"

#include <math.h>

/* A sphere must not meet its own image. */
static const double widths_least = 2.5;

/* The cube, from its edge or from the solid volume; wide enough for the largest. */
static bool make_box(struct pack_work *work, double solid, double largest, struct error *error) {
    const struct pack_options *o = work->options;
    double edge = o->box > 0 ? o->box : cbrt(solid / o->fraction);
    bool periodic = o->walls == PACK_PERIODIC;
    work->report->box = edge;
    work->box =
        (struct box){.dimension = 3, .edge = {edge, edge, edge}, .periodic = {periodic, periodic, periodic}};
    if (edge < largest * widths_least)
        return error_set(
            error, ERROR_USER,
            "command line: a cube of edge %g is too small for spheres of radius %g: at least %g times as "
            "wide",
            edge, largest, widths_least);
    return true;
}

/* Makes the spheres of any law but BIDISPERSE. */
static bool make_spheres(struct pack_work *work, struct error *error) {
    size_t count = (size_t)work->options->count;
    double *radius = memory_allocate(count, sizeof *radius, "radii"), solid = 0, largest = 0;
    bool good = draw_radii(work->options, radius, count, error);
    for (size_t k = 0; good && k < count; k++) {
        solid += particles_sphere_mass(radius[k], 1);
        largest = fmax(largest, radius[k]);
    }
    good = good && make_box(work, solid, largest, error);
    if (good)
        work->particles = particles_create(count);
    for (size_t k = 0; good && k < count; k++)
        work_add(work, (int64_t)k + 1, radius[k]);
    memory_free(radius);
    return good && work_relax(work, "spheres", error);
}

static void fill_row(const struct pack_work *work, struct rows *rows, size_t k) {
    const struct pack_options *o = work->options;
    const struct particle_state *state = &work->particles->state[k];
    int64_t id = work->particles->id[k];
    size_t row = (size_t)id - 1;
    rows->id[row] = id;
    rows->radius[row] = state->radius;
    rows->mass[row] = particles_sphere_mass(state->radius, o->density);
    rows->material[row] = row < work->report->large;
    for (int c = 0; c < 3; c++)
        rows->position[row][c] = state->x[c];
    struct random_sequence random = random_sequence((uint64_t)o->seed, RANDOM_VELOCITY, (uint64_t)id);
    for (int c = 0; rows->velocity && c < 3; c++)
        rows->velocity[row][c] = o->velocity * random_normal(&random);
}

static void fill_rows(const struct pack_work *work, struct rows *rows) {
    unsigned columns = ROWS_POSITION | ROWS_RADIUS | ROWS_MASS | ROWS_ID | ROWS_MATERIAL;
    rows_create(rows, work->particles->owned, columns | (work->options->velocity > 0 ? ROWS_VELOCITY : 0u));
    for (int c = 0; c < 3; c++) {
        rows->upper[c] = work->box.edge[c];
        rows->periodic[c] = work->box.periodic[c];
    }
    rows->box_given = rows->periodic_given = true;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < rows->count; k++)
        fill_row(work, rows, k);
}

/* Measures the final packing, with a new search for pairs. */
static bool measure(struct pack_work *work, struct error *error) {
    struct particles *particles = work->particles;
    struct pack_report *report = work->report;
    struct pack_search *search =
        pack_search_create(particles, &work->box, work->options->gap, work->threads, error);
    if (!search)
        return false;
    struct pushes *pushes =
        push_create(particles->owned, search->classes.radius_min[0], work->options->gap, work->threads);
    pack_search_run(search);
    report->overlap = push_all(pushes, search);
    report->smallest = search->classes.radius_min[0];
    report->largest = search->classes.radius_max[search->classes.count - 1];
    push_destroy(&pushes);
    pack_search_destroy(&search);
    return true;
}

/* The solid volume, summed in the order of the rows. */
static double solid_fraction(const struct rows *rows, double edge) {
    double solid = 0;
    for (size_t k = 0; k < rows->count; k++)
        solid += particles_sphere_mass(rows->radius[k], 1);
    return solid / (edge * edge * edge);
}

bool pack_make(const struct pack_options *options, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error) {
    struct pack_work work = {.options = options, .hook = hook, .report = report};
    work.threads = threads_set((int)options->threads, PAIR_THREADS_MAX, error);
    if (work.threads == 0)
        return false;
    *report = (struct pack_report){0};
    bool good = options->law == PACK_BIDISPERSE
                    ? make_box(&work, 0, options->ratio, error) && bidisperse_make(&work, error)
                    : make_spheres(&work, error);
    good = good && measure(&work, error);
    if (good) {
        fill_rows(&work, rows);
        report->fraction = solid_fraction(rows, report->box);
    }
    particles_destroy(&work.particles);
    return good;
}
