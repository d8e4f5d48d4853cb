/* SPDX-License-Identifier: BSD-3-Clause */
/* Two relaxed random systems, of small and of large spheres, in one cube; small spheres that overlap a large
 * one are removed. So the neighbours of a large sphere are placed by chance, and do not press on the large
 * sphere. */
#include "front/pack/bidisperse.h"

#include "base/memory.h"
#include "base/random.h"
#include "front/pack/pack_search.h"

#include <math.h>
#include <string.h>

/* Additional small spheres at the start, beyond the number from which the wanted count is expected to remain:
 * a relative part and an absolute number. */
static const double surplus = 0.002, surplus_least = 50;
/* Solid fraction of the small spheres in the recipe, and its largest value: random close packing is near. */
static const double recipe_fraction = 0.36, most_fraction = 0.6;

static double sphere(double radius) {
    return 4 * M_PI / 3 * radius * radius * radius;
}

/* The number of small spheres before any is removed; 0: error filled. */
static size_t count_start(const struct pack_work *work, struct error *error) {
    const struct pack_options *o = work->options;
    double volume = pow(o->box, 3), count = rint(recipe_fraction * volume / sphere(1));
    double free = 1 - o->large * sphere(o->ratio + 1) / volume;
    if (o->numbers == PACK_TABLE)
        count = ceil(o->small / free * (1 + surplus) + surplus_least);
    double fraction = count * sphere(1) / volume;
    double most = (double)((size_t)1 << PARTICLE_INDEX_BITS);
    work->report->started_fraction = fraction;
    if (o->large + count >= most) {
        error_set(
            error, ERROR_USER,
            "command line: %.0f large spheres and %.0f small ones to begin with in a cube of edge %g are too "
            "many; allowed: fewer than %.0f",
            o->large, count, o->box, most);
        return 0;
    }
    if (free > 0 && fraction <= most_fraction && count >= 1)
        return (size_t)count;
    error_set(error, ERROR_USER,
              "command line: %g large and %g small spheres do not fit into a cube of edge %g: the small ones "
              "alone would "
              "have a solid fraction of %.3g",
              o->large, o->small, o->box, free > 0 ? fraction : INFINITY);
    return 0;
}

/* Places the large spheres in a set of their own. */
static bool place_large(struct pack_work *work, struct error *error) {
    const struct pack_options *o = work->options;
    work->particles = particles_create((size_t)o->large);
    for (int64_t k = 1; k <= (int64_t)o->large; k++)
        work_add(work, k, o->ratio);
    return work_place(work, error) && work_relax(work, "large", error);
}

/* Marks the small spheres of pairs that overlap and are not alike. */
static void mark_overlaps(const struct pack_search *search, uint8_t *remove) {
    const struct pairlist *list = search->list;
    const struct particle_state *state = search->particles->state;
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair)) {
        const struct particle_state *i = &state[pair.i], *j = &state[pair.j];
        double square = 0, touch = i->radius + j->radius;
        if (i->radius == j->radius)
            continue;
        for (int c = 0; c < 3; c++) {
            double d = j->x[c] - i->x[c] + list->shift[pair.image][c];
            square += d * d;
        }
        if (square < touch * touch)
            remove[i->radius < j->radius ? pair.i : pair.j] = 1;
    }
}

static bool remove_overlaps(struct pack_work *work, struct error *error) {
    struct particles *particles = work->particles;
    struct pack_search *search =
        pack_search_create(particles, &work->container.box, work->options->gap, work->threads, error);
    if (!search)
        return false;
    pack_search_run(search);
    uint8_t *remove = memory_allocate_zero(particles->owned, 1, "overlapping spheres");
    mark_overlaps(search, remove);
    pack_search_destroy(&search);
    work->report->removed = particles_remove(particles, remove);
    memory_free(remove);
    return true;
}

/* New ids, 1 and on in the order of the old ones; of the small spheres, whose old ids lie beyond `large`,
 * `thin` are taken out at random (Knuth's algorithm S). */
static void thin_and_number(struct pack_work *work, size_t large, size_t started, size_t thin) {
    struct particles *particles = work->particles;
    int64_t *number = memory_allocate_zero(large + started + 1, sizeof *number, "new ids");
    uint8_t *remove = memory_allocate_zero(particles->owned, 1, "surplus spheres");
    struct random_sequence random = random_sequence((uint64_t)work->options->seed, RANDOM_INSERTION, 0);
    for (size_t k = 0; k < particles->owned; k++)
        number[particles->id[k]] = 1;
    size_t left = particles->owned - large;
    int64_t next = 0;
    for (size_t id = 1; id <= large + started; id++) {
        if (!number[id])
            continue;
        if (id > large && random_uniform(&random) * (double)left-- < (double)thin) {
            number[id] = 0;
            thin--;
        } else {
            number[id] = ++next;
        }
    }
    for (size_t k = 0; k < particles->owned; k++) {
        remove[k] = number[particles->id[k]] == 0;
        particles->id[k] = number[particles->id[k]];
    }
    work->report->thinned = particles_remove(particles, remove);
    memory_free(number);
    memory_free(remove);
}

bool bidisperse_make(struct pack_work *work, struct error *error) {
    const struct pack_options *o = work->options;
    struct pack_report *report = work->report;
    size_t large = (size_t)o->large, started = count_start(work, error);
    if (started == 0 || !place_large(work, error))
        return false;
    struct particles *placed = work->particles;
    work->particles = particles_create(large + started);
    for (size_t k = 1; k <= started; k++)
        work_add(work, (int64_t)(large + k), 1);
    bool good = work_place(work, error) && work_relax(work, "small", error);
    for (size_t k = 0; k < large && good; k++) {
        size_t at = particles_append(work->particles);
        work->particles->state[at] = placed->state[k];
        work->particles->id[at] = placed->id[k];
    }
    particles_destroy(&placed);
    if (!good || !remove_overlaps(work, error))
        return false;
    size_t small = work->particles->owned - large;
    bool exact = o->numbers == PACK_TABLE;
    size_t wanted = exact ? (size_t)o->small : small;
    thin_and_number(work, large, started, small > wanted ? small - wanted : 0);
    report->large = large;
    report->small = work->particles->owned - large;
    report->difference = (int64_t)report->small - (int64_t)wanted;
    return true;
}
