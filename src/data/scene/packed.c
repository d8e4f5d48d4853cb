/* SPDX-License-Identifier: BSD-3-Clause */
/* Packed sources: those that push, then those that give way. Read packed.h first.
 *
 * The spheres of all packed sources are numbered through, from 1 on; radius and first place of a sphere follow from its number. A source that
 * gives way begins with as many spheres as will leave its count, and a few more; the few too many go at random. So the neighbours
 * of a large sphere among small ones are placed by chance, and do not press on it (Stratford, Shire and Hanley 2018). */
#include "data/scene/packed.h"

#include "base/memory.h"
#include "base/random.h"
#include "data/scene/pack/relax.h"
#include "data/scene/packed_radii.h"
#include "data/scene/placegrid.h"
#include "data/scene/source_sphere.h"

#include <math.h>
#include <omp.h>
#include <string.h>

/* Spheres that are packed together. */
struct lot {
    struct packing *packing;
    struct pile pile;
    struct relax_options relax; /* the largest gap, the smallest overlap and the most sweeps of the sources */
    struct pile_part *part;     /* owned */
    int *source;                /* of each part; owned */
    int parts;
    int sweeps; /* of lots before */
};

static void show(void *context, const struct relax_state *state) {
    const struct lot *lot = context;
    struct packing *p = lot->packing;
    p->report->sweeps = lot->sweeps + state->sweep;
    p->report->overlap = state->overlap;
    if (p->share->packed)
        *p->share->packed = *p->report;
    if (p->share->progress)
        p->share->progress(p->share->context, "spheres moved apart", fmax(0, 1 - state->overlap));
}

/* Calls `each` for the spheres of all batches but that of `source` (-1: all), box-relative. */
static void each_made(const struct packing *p, int source, void (*each)(void *, const double *, double),
                      void *context) {
    double x[3];
    for (int s = 0; s < p->scene->sources; s++)
        for (size_t k = 0; s != source && k < p->batch[s].rows.count; k++) {
            struct source_sphere sphere = source_sphere_of(&p->scene->source[s], &p->batch[s], k);
            if (!source_sphere_left_out(&p->scene->source[s], &sphere) &&
                source_sphere_at(&p->scene->box, &sphere, x))
                each(context, x, sphere.radius);
        }
}

static void take_smaller(void *smallest, const double *x, double radius) {
    double *least = smallest;
    (void)x;
    *least = fmin(*least, radius);
}

/* The smallest radius of these spheres; that of the box where there are none. */
static double smallest_made(const struct packing *p, int source) {
    double smallest = p->box.edge[0];
    each_made(p, source, take_smaller, &smallest);
    return smallest;
}

/* `smallest`: of the spheres that will stay. */
static void lot_create(struct lot *lot, struct packing *p, double smallest) {
    size_t most = (size_t)p->scene->sources;
    int threads = omp_get_max_threads();
    *lot = (struct lot){.packing = p, .sweeps = p->report->sweeps};
    lot->part = memory_allocate(most, sizeof *lot->part, "packed sources");
    lot->source = memory_allocate(most, sizeof *lot->source, "packed sources");
    lot->pile = pile_create(&p->box, smallest);
    lot->pile.share = p->share;
    lot->pile.seed = p->scene->seed;
    lot->pile.part = lot->part;
    lot->relax = (struct relax_options){.bound = INFINITY,
                                        .threads = threads < PAIR_THREADS_MAX ? threads : PAIR_THREADS_MAX,
                                        .show = show,
                                        .context = lot};
}

static void lot_free(struct lot *lot) {
    pile_free(&lot->pile);
    memory_free(lot->part);
    memory_free(lot->source);
}

/* Adds the spheres of a source, whose radii are then the lot's. */
static void lot_add(struct lot *lot, int source) {
    const struct source_options *options = &lot->packing->scene->source[source];
    struct member *m = &lot->packing->member[source];
    lot->part[lot->parts] = m->part;
    lot->source[lot->parts++] = source;
    lot->pile.parts = lot->parts;
    lot->relax.gap = fmax(lot->relax.gap, options->gap);
    lot->relax.bound = fmin(lot->relax.bound, options->overlap);
    lot->relax.sweeps = (int)fmax(lot->relax.sweeps, (double)options->sweeps);
    lot->pile.gap = lot->relax.gap;
    particles_reserve(lot->pile.particles, lot->pile.particles->owned + m->radii.count);
    for (size_t k = 0; k < m->radii.count; k++)
        pile_add(&lot->pile, m->first + (int64_t)k, m->radii.radius[k]);
    memory_free(m->radii.radius);
    m->radii.radius = NULL;
}

static void add_still(void *pile, const double *x, double radius) {
    pile_add_still(pile, x, radius);
}

/* The pushes are whole numbers, which bounds the ratio of sizes. */
static bool sizes_suit(const struct lot *lot) {
    const struct particles *particles = lot->pile.particles;
    double smallest = INFINITY, largest = 0;
    char text[200];
    for (size_t k = 0; k < particles->owned; k++) {
        smallest = fmin(smallest, particles->state[k].radius);
        largest = fmax(largest, particles->state[k].radius);
    }
    snprintf(
        text, sizeof text,
        "of the spheres that are packed together or stay, the largest (radius %g) is more than %d times the "
        "smallest (%g); allowed: that, or meets: yield",
        largest, PACKED_RATIO_MAX, smallest);
    return largest <= PACKED_RATIO_MAX * smallest || packed_fail(lot->packing, lot->source[0], "sizes", text);
}

/* Rows for the spheres of all sources of the lot. */
static void lot_rows(const struct lot *lot) {
    struct packing *p = lot->packing;
    const struct particles *particles = lot->pile.particles;
    for (int n = 0; n < lot->parts; n++) {
        struct member *m = &p->member[lot->source[n]];
        rows_create(&p->batch[lot->source[n]].rows, m->radii.count, ROWS_POSITION | ROWS_RADIUS);
    }
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++) {
        int n = 0;
        if (particles->state[k].inverse_mass == 0)
            continue;
        while (particles->id[k] >= lot->part[n].end)
            n++;
        struct rows *rows = &p->batch[lot->source[n]].rows;
        size_t row = (size_t)(particles->id[k] - p->member[lot->source[n]].first);
        rows->radius[row] = particles->state[k].radius;
        for (int d = 0; d < 3; d++)
            rows->position[row][d] = p->box.origin[d] + particles->state[k].x[d];
    }
}

/* Places and relaxes the spheres, and makes the rows of their sources. */
static bool lot_pack(struct lot *lot) {
    struct packing *p = lot->packing;
    struct relax_state state = {0};
    struct error why = {0};
    char text[300];
    if (!sizes_suit(lot))
        return false;
    double homeless = pile_place(&lot->pile);
    snprintf(
        text, sizeof text,
        "no place was found for a sphere of radius %g, in the region and clear of walls: smaller spheres are "
        "needed, or a larger region",
        homeless);
    if (homeless > 0)
        return packed_fail(p, lot->source[0], "region", text);
    if (!relax_run(&lot->pile, &lot->relax, &state, &why))
        return packed_fail(p, lot->source[0], "from", why.text);
    show(lot, &state);
    p->overlap = fmax(p->overlap, state.overlap);
    lot_rows(lot);
    return true;
}

/* All sources that push. */
static bool pack_pushing(struct packing *p, int64_t *next) {
    struct lot lot;
    bool good = true;
    lot_create(&lot, p, smallest_made(p, -1));
    each_made(p, -1, add_still, &lot.pile);
    for (int s = 0; s < p->scene->sources && good; s++)
        if (packed_is(p, s) && p->scene->source[s].meets == SOURCE_PUSHES) {
            good = packed_radii(p, s, next);
            if (good)
                lot_add(&lot, s);
        }
    good = good && (lot.parts == 0 || lot_pack(&lot));
    lot_free(&lot);
    return good;
}

static void add_to_grid(void *grid, const double *x, double radius) {
    placegrid_add(grid, x, radius);
}

/* Takes the spheres out of a source that are marked, or that `thin` at random of the others (Knuth's algorithm S). */
static void take_out(struct packing *p, struct rows *rows, const uint8_t *remove, size_t left, size_t thin) {
    struct random_sequence random = random_sequence(p->scene->seed, RANDOM_INSERTION, 0);
    size_t kept = 0;
    for (size_t k = 0; k < rows->count; k++) {
        if (remove[k])
            continue;
        if (random_uniform(&random) * (double)left-- < (double)thin) {
            thin--;
            continue;
        }
        memcpy(rows->position[kept], rows->position[k], sizeof rows->position[k]);
        rows->radius[kept++] = rows->radius[k];
    }
    rows->count = kept;
    rows->total = kept;
}

/* Takes out what overlaps other sources, and what is more than counted. */
static bool give_way(struct packing *p, int source) {
    struct rows *rows = &p->batch[source].rows;
    size_t wanted = (size_t)p->scene->source[source].count, removed = 0, started = rows->count;
    struct placegrid *grid = placegrid_create(&p->box, smallest_made(p, source));
    uint8_t *remove = memory_allocate_zero(started, 1, "overlapping spheres");
    each_made(p, source, add_to_grid, grid);
#pragma omp parallel for schedule(static) reduction(+ : removed)
    for (size_t k = 0; k < started; k++) {
        double x[3];
        for (int d = 0; d < 3; d++)
            x[d] = rows->position[k][d] - p->box.origin[d];
        remove[k] = placegrid_touches(grid, x, rows->radius[k]);
        removed += remove[k];
    }
    size_t left = started - removed, thin = wanted > 0 && left > wanted ? left - wanted : 0;
    take_out(p, rows, remove, left, thin);
    memory_free(remove);
    placegrid_destroy(&grid);
    p->report->started += started;
    p->report->removed += removed;
    p->report->thinned += thin;
    char text[200];
    snprintf(text, sizeof text, "only %zu spheres are left of %zu: %zu overlap those of other sources", left,
             started, removed);
    return (left > 0 && left >= wanted) || packed_fail(p, source, wanted ? "count" : "volume_fraction", text);
}

static bool pack_yielding(struct packing *p, int source, int64_t *next) {
    struct lot lot;
    if (!packed_radii(p, source, next))
        return false;
    lot_create(&lot, p, p->box.edge[0]);
    lot_add(&lot, source);
    bool good = lot_pack(&lot) && give_way(p, source);
    lot_free(&lot);
    return good;
}

bool packed_make(const struct scene *scene, const struct scene_share *share, struct source_batch *batch,
                 struct error *error) {
    struct packed_report report = {0};
    struct packing p = {
        .report = &report, .scene = scene, .share = share, .batch = batch, .error = error, .box = scene->box};
    int64_t next = 1;
    p.box.motion = (struct box_motion){0};
    p.member = memory_allocate_zero((size_t)scene->sources, sizeof *p.member, "packed sources");
    for (int s = 0; s < scene->sources; s++) {
        struct pile_part *part = &p.member[s].part;
        part->region = source_region(scene, &scene->source[s].region, &part->space);
        p.member[s].volume = region_volume(&part->region, &part->space);
    }
    bool good = packed_can_number(&p) && pack_pushing(&p, &next);
    for (int s = 0; s < scene->sources && good; s++)
        if (packed_is(&p, s) && scene->source[s].meets == SOURCE_YIELDS)
            good = pack_yielding(&p, s, &next);
    for (int s = 0; s < scene->sources; s++)
        memory_free(p.member[s].radii.radius);
    memory_free(p.member);
    report.overlap = p.overlap;
    if (share->packed)
        *share->packed = report;
    return good;
}
