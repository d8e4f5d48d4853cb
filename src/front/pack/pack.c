/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a packing: box, spheres, relaxation, rows. Read pack.h first. */
#include "front/pack/pack.h"
#include "front/pack/bidisperse.h"

#include "base/memory.h"
#include "base/random.h"
#include "base/threads.h"
#include "front/pack/draw.h"
#include "front/pack/push.h"

#include <math.h>

/* The container, whose size is given or follows from the solid volume. */
static bool make_container(struct pack_work *work, double solid, struct error *error) {
    if (!container_create(&work->container, work->options, solid, error))
        return false;
    work->report->box = work->container.box.edge[0];
    container_describe(&work->container, work->options, work->report->container,
                       sizeof work->report->container);
    return true;
}

/* The radii of any law but BIDISPERSE: as many as the options say, or as fill the container. */
static double *make_radii(const struct pack_work *work, size_t *count, struct error *error) {
    const struct pack_options *o = work->options;
    if (o->count == 0)
        return draw_fill(o, o->fraction * work->container.volume, count, error);
    *count = (size_t)o->count;
    double *radius = memory_allocate(*count, sizeof *radius, "radii");
    if (draw_radii(o, radius, *count, error))
        return radius;
    memory_free(radius);
    return NULL;
}

/* Makes the spheres of any law but BIDISPERSE. */
static bool make_spheres(struct pack_work *work, struct error *error) {
    bool sized = work->options->shape != PACK_CUBE || work->options->box > 0;
    size_t count;
    double solid = 0, largest = 0;
    if (sized && !make_container(work, 0, error))
        return false;
    double *radius = make_radii(work, &count, error);
    if (!radius)
        return false;
    for (size_t k = 0; k < count; k++) {
        solid += particles_sphere_mass(radius[k], 1);
        largest = fmax(largest, radius[k]);
    }
    bool good = (sized || make_container(work, solid, error)) &&
                container_takes(&work->container, largest, solid, error);
    if (good)
        work->particles = particles_create(count);
    for (size_t k = 0; good && k < count; k++)
        work_add(work, (int64_t)k + 1, radius[k]);
    memory_free(radius);
    return good && work_place(work, error) && work_relax(work, "spheres", error);
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
        rows->position[row][c] = work->container.lower[c] + state->x[c];
    struct random_sequence random = random_sequence((uint64_t)o->seed, RANDOM_VELOCITY, (uint64_t)id);
    for (int c = 0; rows->velocity && c < 3; c++)
        rows->velocity[row][c] = o->velocity * random_normal(&random);
}

static void fill_rows(const struct pack_work *work, struct rows *rows) {
    unsigned columns = ROWS_POSITION | ROWS_RADIUS | ROWS_MASS | ROWS_ID | ROWS_MATERIAL;
    rows_create(rows, work->particles->owned, columns | (work->options->velocity > 0 ? ROWS_VELOCITY : 0u));
    for (int c = 0; c < 3; c++) {
        rows->lower[c] = work->container.lower[c];
        rows->upper[c] = rows->lower[c] + work->container.box.edge[c];
        rows->periodic[c] = work->container.box.periodic[c];
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
        pack_search_create(particles, &work->container.box, work->options->gap, work->threads, error);
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
static double solid_fraction(const struct rows *rows, double volume) {
    double solid = 0;
    for (size_t k = 0; k < rows->count; k++)
        solid += particles_sphere_mass(rows->radius[k], 1);
    return solid / volume;
}

bool pack_make(const struct pack_options *options, const struct pack_hook *hook, struct rows *rows,
               struct pack_report *report, struct error *error) {
    struct pack_work work = {.options = options, .hook = hook, .report = report};
    work.threads = threads_set((int)options->threads, PAIR_THREADS_MAX, error);
    if (work.threads == 0)
        return false;
    *report = (struct pack_report){0};
    bool good = options->law == PACK_BIDISPERSE
                    ? make_container(&work, 0, error) &&
                          container_takes(&work.container, options->ratio, 0, error) &&
                          bidisperse_make(&work, error)
                    : make_spheres(&work, error);
    good = good && measure(&work, error);
    if (good) {
        fill_rows(&work, rows);
        report->fraction = solid_fraction(rows, work.container.volume);
    }
    particles_destroy(&work.particles);
    container_free(&work.container);
    return good;
}
