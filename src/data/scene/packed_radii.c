/* SPDX-License-Identifier: BSD-3-Clause */
/* How many spheres a packed source has, how large they are, and whether they have room. Read packed_radii.h first. */
#include "data/scene/packed_radii.h"

#include "base/memory.h"
#include "data/scene/source_sphere.h"

#include <math.h>

/* Additional spheres of a source that gives way, beyond the number from which its count is expected to remain: a relative part and
 * an absolute number. */
static const double surplus = 0.002, surplus_least = 50;
/* No packing at random is denser; of equal spheres random close packing is near the second. */
static const double solid_most = 0.95, yielding_most = 0.6;
/* A periodic edge over the largest radius: a sphere must not meet its own image. */
static const double widths_least = 2.5;
/* Bytes of a sphere while it is packed, its pairs included. */
static const double sphere_bytes = 400;

bool packed_is(const struct packing *p, int source) {
    return p->scene->source[source].kind == SOURCE_PACKED;
}

bool packed_fail(const struct packing *p, int source, const char *key, const char *text) {
    char whole[96];
    return scene_fail(p->scene, p->error, source_key(source, key, whole, sizeof whole), "%s", text);
}

/* False if the pair list cannot number so many spheres. */
static bool can_number(const struct packing *p, int source, double count) {
    double most = (double)((size_t)1 << PARTICLE_INDEX_BITS);
    char text[200];
    snprintf(text, sizeof text, "%.0f spheres to be packed are too many; allowed: fewer than %.0f", count,
             most);
    return count < most || packed_fail(p, source, "from", text);
}

/* The same for all sources, before any work. */
bool packed_can_number(const struct packing *p) {
    double all = 0;
    for (int s = 0; s < p->scene->sources; s++) {
        const struct source_options *options = &p->scene->source[s];
        struct sizes_sampler sampler;
        if (!packed_is(p, s))
            continue;
        if (!sizes_prepare(&sampler, &options->sizes, p->error))
            return false;
        double each = source_form_solid(&options->form) * sizes_moment(&sampler, p->scene->box.dimension) *
                      source_solid(p->scene, 1);
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
    double start =
        options->count > 0
            ? ceil((double)options->count / free * (1 + surplus) + surplus_least)
            : rint(options->volume_fraction * m->volume / (each * source_form_solid(&options->form)));
    if (free > 0 && !can_number(p, source, start))
        return false;
    snprintf(text, sizeof text,
             "the spheres do not fit between those of other sources: they alone would have a volume fraction "
             "of %.3g",
             free > 0 ? start * each / m->volume : INFINITY);
    if (!(free > 0) || start * each > yielding_most * m->volume)
        return packed_fail(p, source, "from", text);
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
    if (m->radii.balls > solid_most * m->volume) {
        snprintf(text, sizeof text,
                 "the %s is %.3g, %.3g times that of the region: random packings hold about 0.64, "
                 "of very different sizes up to 0.9",
                 options->form.shape > 0 ? "volume of the balls around the bodies" : "spheres' volume",
                 m->radii.balls, m->radii.balls / m->volume);
        return packed_fail(p, source, options->count ? "count" : "volume_fraction", text);
    }
    if (edge < widths_least * largest) {
        snprintf(text, sizeof text,
                 "a periodic box of edge %g is too small for spheres of radius %g: at least %g times as wide",
                 edge, largest, widths_least);
        return packed_fail(p, source, "region", text);
    }
    snprintf(text, sizeof text, "the region is too small for spheres of radius %g: at least 2 times as wide",
             largest);
    return width >= largest * (1 + options->gap) || packed_fail(p, source, "region", text);
}

/* Radii and numbers of a source. */
bool packed_radii(struct packing *p, int source, int64_t *next) {
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
