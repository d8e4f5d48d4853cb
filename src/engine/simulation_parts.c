/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts of a simulation that do not depend on its particles, and their fit to the scene. Read
 * simulation_parts.h first. */
#include "engine/simulation_parts.h"
#include "engine/sources.h"
#include "kernel/comm/balance.h"
#include "kernel/comm/cores.h"
#include "base/memory.h"
#include "base/threads.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool domain_possible(const struct scene *scene, struct error *error) {
    char place[SCENE_PATH_MAX];
    struct error plain = {0};
    if (balance_available(&plain))
        return true;
    return error_set(error, ERROR_USER, "%s: domain.name: %s",
                     scene_place(scene, "domain", place, sizeof place), plain.text);
}

/* The number of threads, `wanted` or (0) that of the cores, and its team; 0 with an error. */
static int threads_begin(struct team *team, int wanted, const struct comm *comm, struct error *error) {
    int most = PAIR_THREADS_MAX, usual = cores_threads(comm);
    if (wanted == 0 && usual < most)
        most = usual;
    int threads = threads_set(wanted, most, error);
    team_begin(team, threads, wanted > 0);
    team_probe(team);
    return threads;
}

/* Starts the physics that the scene asks for, with those that are always there first. */
static bool physics_start(struct simulation *s, struct error *error) {
    struct physics_context context = {.scene = s->scene,
                                      .box = &s->box,
                                      .comm = s->comm,
                                      .log = &s->caller.log,
                                      .particles = s->particles,
                                      .classes = &s->classes,
                                      .clock = &s->clock,
                                      .evaluation = &s->evaluation,
                                      .timers = &s->timers,
                                      .threads = s->threads,
                                      .ordered = s->scene->reproducible};
    s->search.speed = memory_allocate_zero((size_t)s->threads, sizeof *s->search.speed, "speeds");
    s->physics.speed = s->search.speed;
    interactions_create(&s->search.interactions, &(struct pairlist_options){.threads = s->threads});
    return physics_begin(&s->physics, &context, &s->search.interactions, error);
}

bool simulation_parts_prepare(struct simulation *s, struct error *error) {
    const struct scene *scene = s->scene;
    s->particles = particles_create(0);
    s->threads = threads_begin(&s->team, scene->threads, s->comm, error);
    if (s->threads == 0 || !physics_start(s, error))
        return false;
    if (scene->domain.kind == DOMAIN_BISECTION && !domain_possible(scene, error))
        return false;
    s->ranks.domain = domain_create(s->comm, &s->box, &scene->domain, error);
    if (s->ranks.domain == NULL)
        return false;
    domain_wrap(s->ranks.domain, s->ranks.wrap);
    struct index_params params = scene->index.params;
    params.instructions = (int)scene->simd;
    s->search.index = index_create(scene->index.name, &params, error);
    return s->search.index != NULL && sources_prepare(&s->sources, scene, error);
}

void simulation_parts_create(struct simulation *s) {
    s->ranks.ghosts = ghosts_create(s->comm, s->ranks.domain, &s->box, &s->scene->ghosts);
    s->search.skin = skin_create();
    s->search.sweep = s->scene->step.fused ? sweep_create(s->threads) : NULL;
}

void simulation_parts_placed(void *context, const char *what, double part) {
    static const double pause = 5;
    struct simulation *s = context;
    double now = timer_now();
    bool shown = s->scene->output.progress.mode != PROGRESS_OFF && !s->caller.quiet;
    if (s->comm->rank != 0 || !shown || now - s->sources.placing_told < pause)
        return;
    if (s->sources.placing_told > 0)
        log_tell(&s->caller.log, "%s: %.0f %%", what, 100 * part);
    s->sources.placing_told = now;
}

/* Checks that no cut-off reaches around a periodic box: to the particle itself, or twice to another
 * particle. */
static bool box_holds(const struct scene *scene, const struct box *box, double radius, double other,
                      double margin, struct error *error) {
    char place[SCENE_PATH_MAX], whom[96];
    double reach = radius + other + margin;
    if (other == radius)
        snprintf(whom, sizeof whom, "a particle of radius %.6g: needed is more than its diameter", radius);
    else
        snprintf(whom, sizeof whom, "particles of radii %.6g and %.6g: needed is more than both radii",
                 radius, other);
    const struct box_motion *motion = &box->motion;
    if (motion->shears && 2 * reach >= box->edge[motion->flow])
        return error_set(
            error, ERROR_USER,
            "%s: the %c edge %.6g along the flow of box.shear is too short for %s + range + skin, "
            "%.6g: needed is more than twice this",
            scene_place(scene, "box", place, sizeof place), 'x' + motion->flow, box->edge[motion->flow], whom,
            reach);
    for (int d = 0; d < box->dimension; d++)
        if (box->periodic[d] && reach >= box->edge[d])
            return error_set(
                error, ERROR_USER, "%s: the periodic %c edge %.6g is too short for %s + range + skin, %.6g",
                scene_place(scene, "box", place, sizeof place), 'x' + d, box->edge[d], whom, reach);
    return true;
}

bool simulation_parts_box(const struct scene *scene, const struct box *box,
                          const struct size_classes *classes, struct error *error) {
    bool good = true;
    double margin = INDEX_NOT_WANTED;
    for (int c = 0; c < classes->count && good; c++) {
        margin = fmax(margin, classes->margin[c][c]);
        for (int b = c; b >= 0 && good; b--)
            good = !classes_meet(classes, c, b) ||
                   box_holds(scene, box, classes->radius_max[c], classes->radius_max[b],
                             classes->margin[c][b], error);
    }
    for (int k = 0; k < scene->insertions && good; k++) {
        double smallest, largest;
        sizes_bounds(&scene->insertion[k].sizes, &smallest, &largest);
        good = box_holds(scene, box, largest, largest, margin, error);
    }
    return good;
}

bool simulation_parts_index(const struct scene *scene, const struct index_view *view, struct error *error) {
    char why[INDEX_WHY_MAX], place[SCENE_PATH_MAX];
    if (index_applicable(scene->index.name, &scene->index.params, view, why))
        return true;
    return error_set(error, ERROR_USER, "%s: index.name: '%s' cannot serve this scene: %s",
                     scene_place(scene, "index.name", place, sizeof place), scene->index.name, why);
}
