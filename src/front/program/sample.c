/* SPDX-License-Identifier: BSD-3-Clause */
/* Takes the samples of a run while it runs. Read sample.h first. */
#include "front/program/sample.h"
#include "engine/index_view.h"
#include "base/memory.h"
#include "base/random.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void columns_name(struct sample_record *record, const struct observables *observables, int first) {
    for (int c = 0; c < observables_columns(observables); c++) {
        snprintf(record->name[first + c], sizeof *record->name, "%.63s",
                 observables_column_name(observables, c));
        snprintf(record->unit[first + c], sizeof *record->unit, "%.15s",
                 observables_column_unit(observables, c));
    }
}

/* Checks that the scene's own columns fit: tables made of a record have room for only so many. */
static bool columns_fit(int own, const struct scene *scene, struct error *error) {
    char place[SCENE_PATH_MAX];
    return own <= SAMPLE_COLUMNS_MAX ||
           error_set(error, ERROR_USER,
                     "%s: observables.list: makes %d columns; scree ablate --error compares up to %d",
                     scene_place(scene, "observables.list", place, sizeof place), own, SAMPLE_COLUMNS_MAX);
}

/* Makes the columns: the scene's own list (energies, momentum and contacts if the scene has no list), then
 * the energies and momentum. */
static bool columns_make(struct sampler *sampler, struct simulation *s, struct error *error) {
    struct sample_record *record = sampler->record;
    struct output_view view = simulation_view(s);
    struct output_run run = {.directory = "",
                             .scene = "",
                             .dimensionless = s->scene->units == SCENE_UNITS_NONE,
                             .materials = s->scene->materials,
                             .material = s->scene->material};
    struct observables_options own = s->scene->output.observables,
                               whole = {.count = 3,
                                        .request = {
                                            {.name = "energy"}, {.name = "momentum"}, {.name = "speed_max"}}};
    if (!observables_create(&sampler->own, &own, &view, &run, error) ||
        !observables_create(&sampler->whole, &whole, &view, &run, error))
        return false;
    if (!columns_fit(observables_columns(sampler->own), s->scene, error))
        return false;
    record->own = observables_columns(sampler->own);
    record->columns = record->own + observables_columns(sampler->whole);
    size_t columns = (size_t)record->columns, samples = (size_t)sampler->samples_max + 1;
    record->name = memory_allocate_zero(columns, sizeof *record->name, "samples");
    record->unit = memory_allocate_zero(columns, sizeof *record->unit, "samples");
    record->time = memory_allocate_zero(samples, sizeof *record->time, "samples");
    record->value = memory_allocate_zero(samples * columns, sizeof *record->value, "samples");
    columns_name(record, sampler->own, 0);
    columns_name(record, sampler->whole, record->own);
    return true;
}

static void tracked_choose(struct sampler *sampler, const struct simulation *s) {
    struct sample_record *record = sampler->record;
    int64_t ids = s->sources.next_id > 1 ? s->sources.next_id - 1 : 1;
    record->stride = (ids + SAMPLE_TRACKED_MAX - 1) / SAMPLE_TRACKED_MAX;
    record->tracked = (size_t)((ids + record->stride - 1) / record->stride);
    if (s->comm->rank != 0)
        return;
    size_t places = record->tracked * ((size_t)sampler->samples_max + 1);
    record->present = memory_allocate_zero(places, sizeof *record->present, "samples");
    record->position = memory_allocate_zero(places, sizeof *record->position, "samples");
}

static void bulk_measure(struct sample_record *record, const struct simulation *s) {
    const struct particles *p = s->particles;
    record->radius_min = INFINITY;
    for (size_t k = 0; k < p->owned; k++) {
        record->radius_min = fmin(record->radius_min, p->state[k].radius);
        record->mass += p->state[k].inverse_mass > 0 ? 1 / p->state[k].inverse_mass : 0;
    }
    comm_min(s->comm, &record->radius_min, 1);
    comm_sum(s->comm, &record->mass, 1);
    record->closed = s->scene->insertions == 0 && s->scene->deletions == 0 && !box_may_lose(&s->box);
    for (int g = 0; g < s->scene->groups; g++)
        record->closed = record->closed && s->scene->group[g].motion != SCENE_MOVING;
}

/* Displaces each particle by an amount that does not depend on the number of ranks. */
static void perturb(const struct sampler *sampler, struct simulation *s) {
    for (size_t k = 0; k < s->particles->owned; k++) {
        struct particle_state *p = &s->particles->state[k];
        struct random_sequence random =
            random_sequence(sampler->seed, RANDOM_POSITION, (uint64_t)s->particles->id[k]);
        for (int d = 0; d < s->box.dimension && p->inverse_mass > 0; d++)
            p->x[d] += (2 * random_uniform(&random) - 1) * sampler->perturbation * p->radius;
    }
}

static void places_take(struct sample_record *record, const struct simulation *s) {
    const struct particles *p = s->particles;
    int32_t(*const image)[3] = particles_images(p);
    double(*place)[4] = memory_allocate_zero(record->tracked, sizeof *place, "samples");
    for (size_t k = 0; k < p->owned; k++) {
        int64_t slot = (p->id[k] - 1) / record->stride;
        if ((p->id[k] - 1) % record->stride != 0 || slot >= (int64_t)record->tracked)
            continue;
        double shift[3] = {0, 0, 0};
        if (image)
            box_unwrap(&s->box, image[k], shift);
        for (int d = 0; d < 3; d++)
            place[slot][d] = p->state[k].x[d] + s->box.origin[d] + shift[d];
        place[slot][3] = 1;
    }
    comm_sum(s->comm, place[0], (int)(4 * record->tracked));
    for (size_t k = 0; k < record->tracked && s->comm->rank == 0; k++) {
        size_t at = (size_t)record->samples * record->tracked + k;
        memcpy(record->position[at], place[k], sizeof *record->position);
        record->present[at] = (float)place[k][3];
    }
    memory_free(place);
}

static bool sampler_look(void *context, const struct simulation *s, struct error *error) {
    struct sampler *sampler = context;
    struct sample_record *record = sampler->record;
    struct output_view view = simulation_view(s);
    double *row = record->value + (size_t)record->samples * (size_t)record->columns;
    if (!observables_write(sampler->own, &view, error) || !observables_write(sampler->whole, &view, error))
        return false;
    memcpy(row, observables_values(sampler->own), (size_t)record->own * sizeof *row);
    memcpy(row + record->own, observables_values(sampler->whole),
           (size_t)(record->columns - record->own) * sizeof *row);
    record->speed_max = fmax(record->speed_max, row[sample_column(record, "speed_max", record->own)]);
    record->time[record->samples] = s->clock.time;
    places_take(record, s);
    record->samples++;
    return true;
}

static bool sampler_begin(void *context, struct simulation *s, struct error *error) {
    struct sampler *sampler = context;
    if (!columns_make(sampler, s, error))
        return false;
    tracked_choose(sampler, s);
    bulk_measure(sampler->record, s);
    if (sampler->perturbation > 0)
        perturb(sampler, s);
    s->sums_each_step = true;
    return sampler_look(context, s, error);
}

static bool sampler_due(const void *context, uint64_t step) {
    const struct sampler *sampler = context;
    return step % sampler->steps_each == 0 && sampler->record->samples <= sampler->samples_max;
}

void sample_create(struct sampler *sampler, struct sample_record *record, uint64_t steps_each, int samples) {
    *record = (struct sample_record){0};
    *sampler = (struct sampler){.watch = {sampler, sampler_begin, sampler_due, sampler_look, false},
                                .record = record,
                                .steps_each = steps_each,
                                .samples_max = samples};
}

void sample_destroy(struct sampler *sampler) {
    if (sampler->own)
        observables_destroy(&sampler->own);
    if (sampler->whole)
        observables_destroy(&sampler->whole);
}

void sample_free(struct sample_record *record) {
    memory_free(record->name);
    memory_free(record->unit);
    memory_free(record->time);
    memory_free(record->value);
    memory_free(record->present);
    memory_free(record->position);
    *record = (struct sample_record){0};
}

int sample_column(const struct sample_record *record, const char *name, int first) {
    for (int c = first; c < record->columns; c++)
        if (strcmp(record->name[c], name) == 0)
            return c;
    return -1;
}

int sample_column_like(const struct sample_record *other, const struct sample_record *record, int column) {
    int like = sample_column(other, record->name[column], column < record->own ? 0 : other->own);
    return column < record->own && like >= other->own ? -1 : like;
}

static bool stopwatch_begin(void *context, struct simulation *s, struct error *error) {
    struct stopwatch *stopwatch = context;
    (void)s, (void)error;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &stopwatch->began);
    return true;
}

static bool stopwatch_due(const void *context, uint64_t step) {
    (void)context, (void)step;
    return false;
}

void sample_clock_create(struct stopwatch *stopwatch) {
    *stopwatch = (struct stopwatch){.watch = {stopwatch, stopwatch_begin, stopwatch_due, NULL, false}};
}

double sample_clock_read(const struct stopwatch *stopwatch) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)(now.tv_sec - stopwatch->began.tv_sec) +
           1e-9 * (double)(now.tv_nsec - stopwatch->began.tv_nsec);
}
