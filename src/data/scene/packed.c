/* SPDX-License-Identifier: BSD-3-Clause */
/* Packed sources: numbers and radii, then the piles, then what gives way. Read packed.h first.
 *
 * The spheres of all packed sources are numbered through, from 1 on; radius and first place of a sphere follow from its number. A source that
 * gives way begins with as many spheres as will leave its count, and a few more; the few too many go at random. So the neighbours
 * of a large sphere among small ones are placed by chance, and do not press on it (Stratford, Shire and Hanley 2018). */
#include "data/scene/packed.h"

#include "base/memory.h"
#include "base/random.h"
#include "data/scene/pack/relax.h"
#include "data/scene/placegrid.h"
#include "data/scene/source_radii.h"
#include "data/scene/source_sphere.h"

#include <math.h>
#include <omp.h>
#include <string.h>

/* Additional spheres of a source that gives way, beyond the number from which its count is expected to remain: a relative part and
 * an absolute number. */
static const double surplus = 0.002, surplus_least = 50;
/* No packing at random is denser; of equal spheres random close packing is near the second. */
static const double solid_most = 0.95, yielding_most = 0.6;
/* A periodic edge over the largest radius: a sphere must not meet its own image. */
static const double widths_least = 2.5;
/* Bytes of a sphere while it is packed, its pairs included. */
static const double sphere_bytes = 400;

/* One source at work. */
struct member {
    struct pile_part part;
    int64_t first; /* number of its first sphere */
    struct source_radii radii;
    double volume; /* of the region */
};

struct packing {
    const struct scene *scene;
    const struct scene_share *share;
    struct source_batch *batch;
    struct error *error;
    struct box box; /* that of the scene, before it moves */
    struct member *member;
    struct packed_report report;
    double overlap; /* the largest that groups so far have left */
};

static bool is_packed(const struct packing *p, int s) {
    return p->scene->source[s].kind == SOURCE_PACKED;
}

static bool fail(const struct packing *p, int source, const char *key, const char *text) {
    char whole[96];
    return scene_fail(p->scene, p->error, source_key(source, key, whole, sizeof whole), "%s", text);
}

/* False if the pair list cannot number so many spheres. */
static bool can_number(const struct packing *p, int source, double count) {
    double most = (double)((size_t)1 << PARTICLE_INDEX_BITS);
    char text[200];
    snprintf(text, sizeof text, "%.0f spheres to be packed are too many; allowed: fewer than %.0f", count,
             most);
    return count < most || fail(p, source, "from", text);
}

/* The same for all sources, before any work. */
static bool can_number_all(const struct packing *p) {
    double all = 0;
    for (int s = 0; s < p->scene->sources; s++) {
        const struct source_options *options = &p->scene->source[s];
        struct sizes_sampler sampler;
        if (!is_packed(p, s))
            continue;
        if (!sizes_prepare(&sampler, &options->sizes, p->error))
            return false;
        double each = sizes_moment(&sampler, p->scene->box.dimension) * source_solid(p->scene, 1);
        all += options->count > 0 ? (double)options->count
                                  : options->volume_fraction * p->member[s].volume / each;
        if (!can_number(p, s, all))
            return false;
    }
    return true;
}

/* The volume that spheres of other sources in the region take from the centre of one of radius r. */
static double excluded(const struct packing *p, int source, double r) {
    const struct member *m = &p->member[source];
    double sum = 0;
    for (int s = 0; s < p->scene->sources; s++) {
        const struct rows *rows = &p->batch[s].rows;
        for (size_t k = 0; s != source && k < rows->count; k++) {
            struct source_sphere sphere = source_sphere_of(&p->scene->source[s], &p->batch[s], k);
            if (region_contains(&m->part.region, &m->part.space, sphere.x, 0))
                sum += source_solid(p->scene, sphere.radius + r);
        }
    }
    return sum;
}

/* How many spheres a source that gives way begins with, 0 where its volume fraction says so. False: no room, or too many. */
static bool count_start(const struct packing *p, int source, size_t *count) {
    const struct source_options *options = &p->scene->source[source];
    const struct member *m = &p->member[source];
    struct sizes_sampler sampler;
    char text[300];
    *count = 0;
    if (!sizes_prepare(&sampler, &options->sizes, p->error))
        return false;
    double mean = sizes_moment(&sampler, 1), each = source_solid(p->scene, 1);
    each *= sizes_moment(&sampler, p->scene->box.dimension);
    double free = 1 - excluded(p, source, mean) / m->volume;
    double start = options->count > 0 ? ceil((double)options->count / free * (1 + surplus) + surplus_least)
                                      : rint(options->volume_fraction * m->volume / each);
    if (free > 0 && !can_number(p, source, start))
        return false;
    snprintf(text, sizeof text,
             "the spheres do not fit between those of other sources: they alone would have a volume fraction "
             "of %.3g",
             free > 0 ? start * each / m->volume : INFINITY);
    if (!(free > 0) || start * each > yielding_most * m->volume)
        return fail(p, source, "from", text);
    *count = (size_t)start;
    return true;
}

/* The largest sphere fits into region and box, and so do all by their volume. */
static bool has_room(const struct packing *p, int source) {
    const struct member *m = &p->member[source];
    const struct source_options *options = &p->scene->source[source];
    double largest = 0, width = region_inradius(&m->part.region, &m->part.space), edge = INFINITY;
    char text[300];
    for (size_t k = 0; k < m->radii.count; k++)
        largest = fmax(largest, m->radii.radius[k]);
    for (int d = 0; d < p->box.dimension; d++)
        edge = p->box.periodic[d] ? fmin(edge, p->box.edge[d]) : edge;
    if (m->radii.solid > solid_most * m->volume) {
        snprintf(
            text, sizeof text,
            "the spheres' volume is %.3g, %.3g times that of the region: random packings hold about 0.64, "
            "of very different sizes up to 0.9",
            m->radii.solid, m->radii.solid / m->volume);
        return fail(p, source, options->count ? "count" : "volume_fraction", text);
    }
    if (edge < widths_least * largest) {
        snprintf(text, sizeof text,
                 "a periodic box of edge %g is too small for spheres of radius %g: at least %g times as wide",
                 edge, largest, widths_least);
        return fail(p, source, "region", text);
    }
    snprintf(text, sizeof text, "the region is too small for spheres of radius %g: at least 2 times as wide",
             largest);
    return width >= largest * (1 + options->gap) || fail(p, source, "region", text);
}

/* Radii and numbers of a source. */
static bool draw_radii(struct packing *p, int source, int64_t *next) {
    struct member *m = &p->member[source];
    const struct source_options *options = &p->scene->source[source];
    struct source_wish wish = {.source = source,
                               .first = (uint64_t)(*next - 1),
                               .count = (size_t)options->count,
                               .volume = m->volume,
                               .bytes = sphere_bytes};
    if ((options->meets == SOURCE_YIELDS && !count_start(p, source, &wish.count)) ||
        !source_radii_draw(p->scene, p->share, &wish, &m->radii, p->error))
        return false;
    m->first = *next;
    m->part.end = *next += (int64_t)m->radii.count;
    return has_room(p, source);
}

/* Spheres that are packed together. */
struct group {
    struct packing *packing;
    struct pile pile;
    struct relax_options relax; /* the largest gap, the smallest overlap and the most sweeps of the sources */
    struct pile_part *part;     /* owned */
    int *source;                /* of each part; owned */
    int parts;
    int sweeps; /* of groups before */
};

static void show(void *context, const struct relax_state *state) {
    const struct group *group = context;
    struct packing *p = group->packing;
    p->report.sweeps = group->sweeps + state->sweep;
    p->report.overlap = state->overlap;
    if (p->share->packed)
        *p->share->packed = p->report;
    if (p->share->progress)
        p->share->progress(p->share->context, "spheres moved apart", fmax(0, 1 - state->overlap));
}

static void group_create(struct group *group, struct packing *p) {
    size_t most = (size_t)p->scene->sources;
    int threads = omp_get_max_threads();
    *group = (struct group){.packing = p, .sweeps = p->report.sweeps};
    group->part = memory_allocate(most, sizeof *group->part, "packed sources");
    group->source = memory_allocate(most, sizeof *group->source, "packed sources");
    group->pile = (struct pile){.particles = particles_create(0),
                                .box = &p->box,
                                .share = p->share,
                                .seed = p->scene->seed,
                                .part = group->part};
    group->relax = (struct relax_options){.bound = INFINITY,
                                          .threads = threads < PAIR_THREADS_MAX ? threads : PAIR_THREADS_MAX,
                                          .show = show,
                                          .context = group};
}

static void group_free(struct group *group) {
    particles_destroy(&group->pile.particles);
    memory_free(group->part);
    memory_free(group->source);
}

/* Adds the spheres of a source, whose radii are then the group's. */
static void group_add(struct group *group, int source) {
    const struct source_options *options = &group->packing->scene->source[source];
    struct member *m = &group->packing->member[source];
    group->part[group->parts] = m->part;
    group->source[group->parts++] = source;
    group->pile.parts = group->parts;
    group->relax.gap = fmax(group->relax.gap, options->gap);
    group->relax.bound = fmin(group->relax.bound, options->overlap);
    group->relax.sweeps = (int)fmax(group->relax.sweeps, (double)options->sweeps);
    group->pile.gap = group->relax.gap;
    particles_reserve(group->pile.particles, group->pile.particles->owned + m->radii.count);
    for (size_t k = 0; k < m->radii.count; k++)
        pile_add(&group->pile, m->first + (int64_t)k, m->radii.radius[k]);
    memory_free(m->radii.radius);
    m->radii.radius = NULL;
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

static void add_still(void *pile, const double *x, double radius) {
    pile_add_still(pile, x, radius);
}

/* Places and relaxes the spheres, and makes the rows of their sources. */
static bool group_pack(struct group *group) {
    struct packing *p = group->packing;
    const struct particles *particles = group->pile.particles;
    struct relax_state state = {0};
    struct error why = {0};
    char text[300];
    double homeless = pile_place(&group->pile);
    snprintf(
        text, sizeof text,
        "no place was found for a sphere of radius %g, in the region and clear of walls: smaller spheres are "
        "needed, or a larger region",
        homeless);
    if (homeless > 0)
        return fail(p, group->source[0], "region", text);
    if (!relax_run(&group->pile, &group->relax, &state, &why))
        return fail(p, group->source[0], "from", why.text);
    show(group, &state);
    p->overlap = fmax(p->overlap, state.overlap);
    for (int n = 0; n < group->parts; n++) {
        struct member *m = &p->member[group->source[n]];
        rows_create(&p->batch[group->source[n]].rows, m->radii.count, ROWS_POSITION | ROWS_RADIUS);
    }
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++) {
        int n = 0;
        if (particles->state[k].inverse_mass == 0)
            continue;
        while (particles->id[k] >= group->part[n].end)
            n++;
        struct rows *rows = &p->batch[group->source[n]].rows;
        size_t row = (size_t)(particles->id[k] - p->member[group->source[n]].first);
        rows->radius[row] = particles->state[k].radius;
        for (int d = 0; d < 3; d++)
            rows->position[row][d] = p->box.origin[d] + particles->state[k].x[d];
    }
    return true;
}

/* All sources that push. */
static bool pack_pushing(struct packing *p, int64_t *next) {
    struct group group;
    bool good = true;
    group_create(&group, p);
    each_made(p, -1, add_still, &group.pile);
    for (int s = 0; s < p->scene->sources && good; s++)
        if (is_packed(p, s) && p->scene->source[s].meets == SOURCE_PUSHES) {
            good = draw_radii(p, s, next);
            if (good)
                group_add(&group, s);
        }
    good = good && (group.parts == 0 || group_pack(&group));
    group_free(&group);
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
    struct placegrid *grid = placegrid_create(&p->box, 1e-3 * rows->radius[0]);
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
    p->report.started += started;
    p->report.removed += removed;
    p->report.thinned += thin;
    char text[200];
    snprintf(text, sizeof text, "only %zu spheres are left of %zu: %zu overlap those of other sources", left,
             started, removed);
    return (left > 0 && left >= wanted) || fail(p, source, wanted ? "count" : "volume_fraction", text);
}

static bool pack_yielding(struct packing *p, int source, int64_t *next) {
    struct group group;
    if (!draw_radii(p, source, next))
        return false;
    group_create(&group, p);
    group_add(&group, source);
    bool good = group_pack(&group) && give_way(p, source);
    group_free(&group);
    return good;
}

bool packed_make(const struct scene *scene, const struct scene_share *share, struct source_batch *batch,
                 struct error *error) {
    struct packing p = {.scene = scene, .share = share, .batch = batch, .error = error, .box = scene->box};
    int64_t next = 1;
    p.box.motion = (struct box_motion){0};
    p.member = memory_allocate_zero((size_t)scene->sources, sizeof *p.member, "packed sources");
    for (int s = 0; s < scene->sources; s++) {
        struct pile_part *part = &p.member[s].part;
        part->region = source_region(scene, &scene->source[s].region, &part->space);
        p.member[s].volume = region_volume(&part->region, &part->space);
    }
    bool good = can_number_all(&p) && pack_pushing(&p, &next);
    for (int s = 0; s < scene->sources && good; s++)
        if (is_packed(&p, s) && scene->source[s].meets == SOURCE_YIELDS)
            good = pack_yielding(&p, s, &next);
    for (int s = 0; s < scene->sources; s++)
        memory_free(p.member[s].radii.radius);
    memory_free(p.member);
    p.report.overlap = p.overlap;
    if (share->packed)
        *share->packed = p.report;
    return good;
}

double packed_edge(const struct scene *scene, int source, struct error *error) {
    const struct source_options *options = &scene->source[source];
    struct scene_share share = {.size = 1};
    struct source_wish wish = {.source = source, .count = (size_t)options->count};
    struct source_radii radii;
    double edge = 0, room = 0;
    if (source_radii_draw(scene, &share, &wish, &radii, error)) {
        room = radii.solid / options->volume_fraction;
        edge = scene->box.dimension == 2 ? sqrt(room) : cbrt(room);
    }
    memory_free(radii.radius);
    return edge;
}
