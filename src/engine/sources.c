/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that come and go during a run: inserted, deleted, or leaving through an open side. These changes
 * happen only at a rebuild, while there are no copies. Every SOURCES_EVERY steps insertion regions are
 * checked, so that the steps at which particles appear do not depend on ranks, threads or index. */
#include "engine/sources.h"
#include "engine/crossings.h"
#include "engine/rebuild_rows.h"
#include "engine/index_view.h"
#include "kernel/particles/material.h"
#include "kernel/particles/shape.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include "data/scene/placegrid.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SOURCES_EVERY = 100 };

/* Checks that an insertion region can hold its largest sphere: a sphere that does not fit would block all
 * later spheres for ever. */
static bool insertion_fits(const struct scene *scene, const struct insertion *insertion, int k,
                           struct error *error) {
    char key[64], place[SCENE_PATH_MAX];
    double smallest, largest, room = region_inradius(&insertion->options.region, &insertion->space);
    sizes_bounds(&insertion->options.sizes, &smallest, &largest);
    if (largest <= room)
        return true;
    snprintf(key, sizeof key, "insertions[%d].sizes", k);
    return error_set(
        error, ERROR_USER,
        "%s: %s: the largest diameter, %.6g, does not fit into the region, which holds up to %.6g",
        scene_place(scene, key, place, sizeof place), key, 2 * largest, 2 * room);
}

bool sources_prepare(struct sources *sources, const struct scene *scene, struct error *error) {
    size_t count = (size_t)scene->insertions;
    sources->insertion = memory_allocate_zero(count, sizeof *sources->insertion, "insertions");
    sources->state = memory_allocate_zero(count, sizeof *sources->state, "insertions");
    sources->lost = memory_allocate_zero(count, sizeof *sources->lost, "insertions");
    for (int k = 0; k < scene->insertions; k++) {
        const struct insertion_options *options = &scene->insertion[k];
        double density = options->density;
        if (!(density > 0))
            density = scene->material[options->material].density;
        if (!insertion_prepare(&sources->insertion[k], options, k, density, scene->seed, &scene->box,
                               error) ||
            !insertion_fits(scene, &sources->insertion[k], k, error))
            return false;
    }
    return true;
}

static struct physics_grain grain_of(const struct insertion_candidate *candidate, int64_t id) {
    return (struct physics_grain){candidate->material, candidate->radius, candidate->density, id, -1,
                                  candidate->shape};
}

static double mass_of(const void *context, const struct insertion_candidate *candidate, int64_t id) {
    const struct physics_grain grain = grain_of(candidate, id);
    return physics_mass(context, &grain);
}

void sources_weigh(struct sources *sources, const struct scene *scene, const struct physics_set *set) {
    for (int k = 0; k < scene->insertions; k++)
        if (scene->insertion[k].mass_rate > 0)
            insertion_weigh(&sources->insertion[k], mass_of, set);
}

static uint64_t insertion_missing(const struct sources *sources, const struct clock *clock, int k) {
    uint64_t due = insertion_due(&sources->insertion[k], clock->time), placed = sources->state[k].placed;
    return due > placed ? due - placed : 0;
}

uint64_t sources_asked(const struct sources *sources, const struct clock *clock, int k) {
    uint64_t looked = clock->step - clock->step % SOURCES_EVERY;
    return insertion_due(&sources->insertion[k], clock_time(clock, looked));
}

static bool insertions_due(const struct sources *sources, int count, const struct clock *clock) {
    if (clock->step % SOURCES_EVERY != 0)
        return false;
    for (int k = 0; k < count; k++)
        if (insertion_missing(sources, clock, k) > 0)
            return true;
    return false;
}

static bool deletions_due(const struct scene *scene, const struct clock *clock) {
    for (int k = 0; k < scene->deletions; k++)
        if (deletion_due(&scene->deletion[k], clock->time, (int64_t)clock->step))
            return true;
    return false;
}

bool sources_due(const struct sources *sources, const struct scene *scene, const struct clock *clock) {
    return insertions_due(sources, scene->insertions, clock) || deletions_due(scene, clock);
}

void sources_give(struct given *given, const struct insertion_candidate *candidate) {
    if (given->added == given->added_room) {
        given->added_room = given->added_room ? 2 * given->added_room : 16;
        given->add = memory_resize(given->add, given->added_room, sizeof *given->add, "particles to add");
    }
    given->add[given->added++] = *candidate;
}

void sources_take(struct given *given, int64_t id) {
    if (given->taken == given->taken_room) {
        given->taken_room = given->taken_room ? 2 * given->taken_room : 16;
        given->take =
            memory_resize(given->take, given->taken_room, sizeof *given->take, "particles to delete");
    }
    given->take[given->taken++] = id;
}

void sources_free(struct sources *sources) {
    memory_free(sources->given.add);
    memory_free(sources->given.take);
    memory_free(sources->insertion);
    memory_free(sources->state);
    memory_free(sources->lost);
}

static int ids_compare(const void *a, const void *b) {
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

/* True if the calling program deletes the particle; the ids are sorted. */
static bool is_taken(const struct given *given, int64_t id) {
    return given->taken > 0 && bsearch(&id, given->take, given->taken, sizeof id, ids_compare) != NULL;
}

static bool sides_matter(const struct box *box) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (!box->periodic[d] && box->leave[d][side] != BOX_KEEP)
                return true;
    return false;
}

/* The side through which a particle has left, as direction x 2 + upper, without sides at which the box keeps
 * particles; -1: inside. */
static int side_left(const struct box *box, const double x[3], enum box_leave *leave) {
    for (int d = 0; d < box->dimension; d++) {
        int side = x[d] < 0 ? 0 : x[d] > box->edge[d] ? 1 : -1;
        if (box->periodic[d] || side < 0 || box->leave[d][side] == BOX_KEEP)
            continue;
        *leave = box->leave[d][side];
        return 2 * d + side;
    }
    return -1;
}

static void leave_error(const struct particles *particles, size_t k, const struct box *box, int side,
                        double time, struct error *error) {
    const struct particle_state *p = &particles->state[k];
    error_set(error, ERROR_PHYSICS,
              "particle %lld left the box through its %s %c side at (%.6g, %.6g, %.6g), t = %.9g (box.leave: "
              "error)",
              (long long)particles->id[k], side % 2 ? "upper" : "lower", 'x' + side / 2,
              p->x[0] + box->origin[0], p->x[1] + box->origin[1], p->x[2] + box->origin[2], time);
}

/* True if the particle is in a deletion region that is active now. */
static bool deleted_by_region(const struct scene *scene, const struct box *box, const struct clock *clock,
                              const double x[3]) {
    double user[3] = {x[0] + box->origin[0], x[1] + box->origin[1], x[2] + box->origin[2]};
    struct region_space space = {.dimension = box->dimension, .plane = user[2]};
    for (int k = 0; k < scene->deletions; k++) {
        const struct deletion_options *deletion = &scene->deletion[k];
        if (deletion_due(deletion, clock->time, (int64_t)clock->step) &&
            region_contains(&deletion->region, &space, user, 0))
            return true;
    }
    return false;
}

/* True if particle k, which nobody carries, goes. */
static bool goes(struct simulation *s, size_t k, bool regions) {
    const struct particle_state *state = &s->particles->state[k];
    enum box_leave leave = BOX_KEEP;
    int side = side_left(&s->box, state->x, &leave);
    if (leave == BOX_ERROR)
        leave_error(s->particles, k, &s->box, side, s->clock.time, &s->error);
    return leave == BOX_DELETE || (regions && deleted_by_region(s->scene, &s->box, &s->clock, state->x)) ||
           is_taken(&s->sources.given, s->particles->id[k]);
}

/* Carried grains go with their carrier, whichever rank owns it; and a carrier goes if the calling program deletes a grain that
 * it carries. Collective. */
static void marks_carry(const struct particles *p, const struct given *given, const struct comm *comm,
                        uint8_t *remove) {
    const int64_t *carrier = carried_by(p);
    const uint8_t *kind = kinds_of(p);
    size_t count = 0, bytes;
    int64_t *mine = memory_allocate(p->owned, sizeof *mine, "bodies to remove");
    for (size_t k = 0; k < p->owned; k++)
        if (carrier[k] >= 0 ? is_taken(given, p->id[k]) : kind[k] == KIND_BODY && remove[k])
            mine[count++] = carrier[k] >= 0 ? carrier[k] : p->id[k];
    int64_t *all = comm_share(comm, mine, count * sizeof *mine, &bytes);
    count = bytes / sizeof *all;
    qsort(all, count, sizeof *all, ids_compare);
    for (size_t k = 0; k < p->owned; k++) {
        int64_t id = carrier[k] >= 0 ? carrier[k] : p->id[k];
        if (carrier[k] >= 0 || kind[k] == KIND_BODY)
            remove[k] = count > 0 && bsearch(&id, all, count, sizeof id, ids_compare) != NULL;
    }
    memory_free(all);
    memory_free(mine);
}

/* What goes: particles, and of them those that nobody carries. */
struct removed {
    int64_t particles, alone;
};

static void removed_account(struct simulation *s, size_t k, struct removed *removed) {
    const uint8_t *kind = kinds_of(s->particles);
    const int64_t *carrier = carried_by(s->particles);
    removed->particles++;
    removed->alone += !carrier || carrier[k] < 0;
    if (kind && kind[k] != KIND_GRAIN) /* its parts have the mass */
        return;
    s->sources.deleted_mass += groups_mass(s->particles, k);
    crossings_account(s->crossings, &s->scene->output.observables, &s->box, s->particles, k, 1);
}

/* Collective. */
static struct removed remove_run(struct simulation *s, struct rebuild_rows *rows) {
    struct particles *particles = s->particles;
    const bool regions = deletions_due(s->scene, &s->clock);
    const size_t owned = particles->owned;
    const uint8_t *kind = kinds_of(particles);
    const int64_t *carrier = carried_by(particles);
    struct removed removed = {0, 0};
    uint8_t *remove = memory_allocate_zero(owned, 1, "particles to remove");
    for (size_t k = 0; k < owned; k++) {
        bool may = !kind || kind[k] == KIND_GRAIN || kind[k] == KIND_BODY;
        remove[k] = may && !(carrier && carrier[k] >= 0) && goes(s, k, regions);
    }
    if (carrier)
        marks_carry(particles, &s->sources.given, s->comm, remove);
    for (size_t k = 0; k < owned; k++)
        if (remove[k])
            removed_account(s, k, &removed);
    if (removed.particles > 0) {
        struct history_rows *list[REBUILD_SETS];
        for (int k = 0, n = rebuild_rows_list(rows, list); k < n; k++)
            history_rows_remove(list[k], remove, owned);
        particles_remove(particles, remove);
    }
    memory_free(remove);
    return removed;
}

/* The owned particles that candidates of a region may touch. A body is touched by the grains that it carries. */
static struct placegrid *particles_near(const struct particles *particles, const struct box *box,
                                        const struct insertion *insertion,
                                        const struct insertion_candidate *candidate, size_t n) {
    const uint8_t *kind = kinds_of(particles);
    double largest = 0, smallest = INFINITY;
    for (size_t k = 0; k < n; k++)
        largest = fmax(largest, candidate[k].radius);
    uint8_t *near = memory_allocate(particles->owned, 1, "particles near an insertion");
#pragma omp parallel for reduction(min : smallest)
    for (size_t k = 0; k < particles->owned; k++) {
        const struct particle_state *p = &particles->state[k];
        near[k] = !(kind && kind[k] == KIND_BODY) && insertion_reaches(insertion, largest, p->x, p->radius);
        if (near[k])
            smallest = fmin(smallest, p->radius);
    }
    struct placegrid *grid = placegrid_create(box, isfinite(smallest) ? smallest : 1);
    for (size_t k = 0; k < particles->owned; k++)
        if (near[k])
            placegrid_add(grid, particles->state[k].x, particles->state[k].radius);
    memory_free(near);
    return grid;
}

/* Marks the candidates that touch a wall or a particle of any rank. */
static void candidates_block(const struct physics_set *set, const struct comm *comm,
                             const struct placegrid *grid, const struct insertion_candidate *candidate,
                             uint8_t *blocked, size_t n) {
#pragma omp parallel for schedule(dynamic, 4)
    for (size_t k = 0; k < n; k++)
        if (!candidate[k].settled && !blocked[k])
            blocked[k] = physics_occupied(set, candidate[k].x, candidate[k].radius) ||
                         placegrid_touches(grid, candidate[k].x, candidate[k].radius);
    if (comm->size == 1)
        return;
    int64_t *all = memory_allocate(n, sizeof *all, "blocked places");
    for (size_t k = 0; k < n; k++)
        all[k] = blocked[k];
    comm_max_int(comm, all, (int)n);
    for (size_t k = 0; k < n; k++)
        blocked[k] = all[k] != 0;
    memory_free(all);
}

/* Appends an accepted candidate to this rank. */
static void candidate_append(struct particles *particles, const struct scene *scene,
                             const struct insertion_candidate *candidate, int64_t id) {
    size_t k = particles_append(particles);
    struct particle_state *p = &particles->state[k];
    bool prescribed = scene->group[candidate->group].motion != SCENE_FREE;
    memcpy(p->x, candidate->x, sizeof p->x);
    memcpy(p->v, candidate->v, sizeof p->v);
    p->radius = candidate->radius;
    p->inverse_mass = prescribed ? 0 : 1 / particles_sphere_mass(candidate->radius, candidate->density);
    particles->id[k] = id;
    double(*omega)[4] = spin_of(particles), *density = groups_densities(particles);
    double *temperature = fields_numbers(particles, "temperature");
    uint8_t *material = material_numbers(particles), *group = groups_of(particles);
    if (omega)
        memcpy(omega[k], candidate->omega, sizeof candidate->omega);
    if (material)
        material[k] = (uint8_t)candidate->material;
    if (group)
        group[k] = (uint8_t)candidate->group;
    if (density)
        density[k] = candidate->density;
    if (temperature)
        temperature[k] = candidate->temperature;
    shape_set(particles, k, candidate->shape, 0, candidate->orientation);
}

/* An accepted candidate enters, on the rank that owns its position; all ranks advance the next id. Returns its mass. */
static double candidate_enter(struct simulation *s, const struct insertion_candidate *candidate) {
    const struct physics_grain grain = grain_of(candidate, s->sources.next_id);
    s->sources.next_id += 1 + physics_parts(&s->physics, &grain);
    if (domain_owner(s->ranks.domain, candidate->x) == s->comm->rank) {
        size_t first = s->particles->owned;
        candidate_append(s->particles, s->scene, candidate, grain.id);
        physics_join(&s->physics, first, grain.id + 1);
        const uint8_t *kind = kinds_of(s->particles);
        for (size_t k = first; k < s->particles->owned; k++)
            if (!kind || kind[k] == KIND_GRAIN)
                crossings_account(s->crossings, &s->scene->output.observables, &s->box, s->particles, k, -1);
    }
    return physics_mass(&s->physics, &grain);
}

static void insertion_run(struct simulation *s, int number) {
    struct insertion *insertion = &s->sources.insertion[number];
    struct insertion_state *state = &s->sources.state[number];
    uint64_t missing = insertion_missing(&s->sources, &s->clock, number);
    size_t n = missing > INSERTION_BATCH_MAX ? INSERTION_BATCH_MAX : (size_t)missing;
    struct insertion_candidate *candidate = memory_allocate_zero(n, sizeof *candidate, "insertion");
    uint8_t *blocked = memory_allocate_zero(n, 1, "insertion");
    insertion_begin(insertion, state, candidate, n);
    struct placegrid *grid = particles_near(s->particles, &s->box, insertion, candidate, n);
    size_t left = n;
    for (int64_t round = 0; round < insertion->options.attempts && left > 0; round++) {
        insertion_propose(insertion, state, candidate, blocked, n);
        candidates_block(&s->physics, s->comm, grid, candidate, blocked, n);
        left = insertion_settle(insertion, candidate, blocked, n);
    }
    s->sources.inserted += insertion_end(state, candidate, n);
    for (size_t k = 0; k < n; k++) {
        enum box_leave leave = BOX_KEEP;
        if (!candidate[k].accepted)
            continue;
        state->mass += candidate_enter(s, &candidate[k]);
        s->sources.lost[number] += side_left(&s->box, candidate[k].x, &leave) >= 0;
    }
    placegrid_destroy(&grid);
    memory_free(candidate);
    memory_free(blocked);
}

void sources_run(struct simulation *s, struct rebuild_rows *rows) {
    struct given *given = &s->sources.given;
    bool deletes = sides_matter(&s->box) || deletions_due(s->scene, &s->clock) || given->taken > 0,
         inserts = insertions_due(&s->sources, s->scene->insertions, &s->clock);
    if ((!deletes && !inserts && given->added == 0) || s->sources.last_step == s->clock.step)
        return;
    s->sources.last_step = s->clock.step;
    if (given->taken > 0)
        qsort(given->take, given->taken, sizeof *given->take, ids_compare);
    const struct removed removed = deletes ? remove_run(s, rows) : (struct removed){0, 0};
    int64_t gone[2] = {removed.particles, removed.alone}, id_before = s->sources.next_id;
    size_t before = s->particles->owned;
    uint64_t inserted_before = s->sources.inserted;
    for (int k = 0; inserts && k < s->scene->insertions; k++)
        if (insertion_missing(&s->sources, &s->clock, k) > 0)
            insertion_run(s, k);
    for (size_t k = 0; k < given->added; k++)
        candidate_enter(s, &given->add[k]);
    s->sources.inserted += given->added;
    given->added = given->taken = 0;
    if (s->particles->owned > (size_t)1 << PARTICLE_INDEX_BITS)
        error_fatal("%zu particles on one rank, at most %zu are possible: use more ranks",
                    s->particles->owned, (size_t)1 << PARTICLE_INDEX_BITS);
    struct history_rows *list[REBUILD_SETS];
    for (int k = 0, n = rebuild_rows_list(rows, list); k < n; k++)
        history_rows_extend(list[k], before, s->particles->owned);
    if (!s->ranks.alone)
        comm_sum_int(s->comm, gone, 2);
    s->sources.deleted += (uint64_t)gone[1];
    s->total += (uint64_t)(s->sources.next_id - id_before) - (uint64_t)gone[0];
    s->classes_stale = s->classes_stale || s->sources.inserted != inserted_before || gone[0] > 0;
}
