/* SPDX-License-Identifier: BSD-3-Clause */
/* The parts of a simulation that do not depend on its particles, and their fit to the scene. Read
 * simulation_parts.h first. */
#include "engine/simulation_parts.h"
#include "engine/sources.h"
#include "engine/view.h"
#include "comm/balance.h"
#include "comm/cores.h"
#include "contact/law_user.h"
#include "core/memory.h"
#include "core/threads.h"
#include "pairs/walk.h"
#include "integrate/integrator.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool domain_possible(const struct simulation *s, struct error *error) {
    char place[SCENE_PATH_MAX];
    struct error plain = {0};
    if (balance_available(&plain))
        return true;
    return error_set(error, ERROR_USER, "%s: domain.name: %s",
                     scene_place(s->scene, "domain", place, sizeof place), plain.text);
}

static bool set_threads(struct simulation *s, struct error *error) {
    int most = PAIR_THREADS_MAX, usual = cores_threads(s->comm);
    if (s->scene->threads == 0 && usual < most)
        most = usual;
    s->threads = threads_set(s->scene->threads, most, error);
    team_begin(&s->team, s->threads, s->scene->threads > 0);
    team_probe(&s->team);
    return s->threads > 0;
}

/* The widest instruction set that all ranks have, or the one that the scene names. */
static const char *common_level(const struct simulation *s) {
    int64_t below = -walk_level(NULL);
    if (s->scene->simd != SCENE_SIMD_AUTO)
        return scene_simd_name(s->scene->simd);
    comm_max_int(s->comm, &below, 1);
    return walk_level_name((int)-below);
}

/* Loads the law of a file: rank 0 compiles it, all ranks load the same bytes. */
static bool load_law(struct simulation *s, struct law_options *options, struct error *error) {
    struct law_object object = {0};
    struct error plain = {0};
    char place[SCENE_PATH_MAX];
    if (!law_has_trait(options->normal, "file"))
        return true;
    const char *level = common_level(s);
    if (s->comm->rank == 0)
        law_user_compile(options->file, level, &object, &plain);
    if (comm_agree(s->comm, &plain)) {
        char *own = object.bytes;
        comm_broadcast(s->comm, &object, sizeof object);
        object.bytes = own ? own : memory_allocate(object.size, 1, "law");
        comm_broadcast(s->comm, object.bytes, object.size);
        s->grains.user = law_user_load(options->file, &object, &plain);
        comm_agree(s->comm, &plain);
    }
    law_object_free(&object);
    options->user = s->grains.user;
    return plain.kind == ERROR_NONE ||
           error_set(error, plain.kind, "%s: contact.law: %s",
                     scene_place(s->scene, "contact.law_file", place, sizeof place), plain.text);
}

/* Makes the walls, and tells of repaired meshes. */
static bool make_walls(struct simulation *s, struct error *error) {
    char *said = NULL;
    size_t length = 0;
    FILE *notes = s->comm->rank == 0 ? open_memstream(&said, &length) : NULL;
    bool good = walls_create(&s->grains.walls, s->scene->wall, s->scene->walls, &s->grains.law, &s->box,
                             s->threads, error, notes);
    if (notes) {
        fclose(notes);
        log_text(&s->caller.log, said);
        free(said);
    }
    return good;
}

bool simulation_parts_prepare(struct simulation *s, struct error *error) {
    const struct scene *scene = s->scene;
    const struct integrator *integrator = integrator_find(scene->integrator);
    struct law_options options = scene->law;
    assert(integrator);
    options.synchronised = integrator->synchronised;
    if (!load_law(s, &options, error) ||
        !law_prepare(&s->grains.law, &options, scene->materials, scene->material, scene->law_pair, error))
        return false;
    scene_integrator(scene, &s->grains.motion);
    if (!set_threads(s, error))
        return false;
    s->grains.speed = memory_allocate_zero((size_t)s->threads, sizeof *s->grains.speed, "speeds");
    if (scene->walls > 0 && !make_walls(s, error))
        return false;
    if (s->grains.walls && scene->reproducible)
        walls_set_exact(s->grains.walls);
    if (scene->domain.kind == DOMAIN_BISECTION && !domain_possible(s, error))
        return false;
    s->ranks.domain = domain_create(s->comm, &s->box, &scene->domain, error);
    if (s->ranks.domain == NULL)
        return false;
    domain_wrap(s->ranks.domain, s->ranks.wrap);
    struct index_params params = scene->index.params;
    params.instructions = (int)scene->simd;
    s->search.index = index_create(scene->index.name, &params, error);
    return s->search.index != NULL && sources_prepare(s, error);
}

void simulation_parts_create(struct simulation *s) {
    s->ranks.ghosts = ghosts_create(s->comm, s->ranks.domain, &s->box, &s->scene->ghosts);
    interactions_create(&s->search.interactions, &(struct pairlist_options){.threads = s->threads});
    s->grains.history = s->grains.law.history_components
                            ? history_create(s->grains.law.history_components, s->threads)
                            : NULL;
    if (s->grains.history)
        s->grains.history->odd = s->grains.law.history_odd;
    s->search.skin = skin_create();
    s->search.sweep = s->scene->step.fused ? sweep_create(s->threads) : NULL;
    s->grains.loop = force_loop_create(s->threads);
    s->grains.contact = (struct force_context){.particles = s->particles,
                                               .history = s->grains.history,
                                               .law = &s->grains.law,
                                               .prescribed = s->scene->groups > 1,
                                               .ordered = s->scene->reproducible};
}

bool simulation_parts_simd(const struct simulation *s, struct error *error) {
    char place[SCENE_PATH_MAX];
    const char *wanted = scene_simd_name(s->scene->simd);
    if (s->scene->simd == SCENE_SIMD_AUTO ||
        (force_loop_choose(s->grains.loop, wanted) &&
         (s->grains.walls == NULL || walls_choose(s->grains.walls, wanted))))
        return true;
    return error_set(
        error, ERROR_USER, "%s: simd: %s is not what this program and CPU have; the widest is %s",
        scene_place(s->scene, "simd", place, sizeof place), wanted, force_loop_kernel(s->grains.loop));
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
static bool box_holds(const struct simulation *s, double radius, double other, double margin,
                      struct error *error) {
    char place[SCENE_PATH_MAX], whom[96];
    double reach = radius + other + margin;
    if (other == radius)
        snprintf(whom, sizeof whom, "a particle of radius %.6g: needed is more than its diameter", radius);
    else
        snprintf(whom, sizeof whom, "particles of radii %.6g and %.6g: needed is more than both radii",
                 radius, other);
    const struct box_motion *motion = &s->box.motion;
    if (motion->shears && 2 * reach >= s->box.edge[motion->flow])
        return error_set(
            error, ERROR_USER,
            "%s: the %c edge %.6g along the flow of box.shear is too short for %s + range + skin, "
            "%.6g: needed is more than twice this",
            scene_place(s->scene, "box", place, sizeof place), 'x' + motion->flow, s->box.edge[motion->flow],
            whom, reach);
    for (int d = 0; d < s->box.dimension; d++)
        if (s->box.periodic[d] && reach >= s->box.edge[d])
            return error_set(
                error, ERROR_USER, "%s: the periodic %c edge %.6g is too short for %s + range + skin, %.6g",
                scene_place(s->scene, "box", place, sizeof place), 'x' + d, s->box.edge[d], whom, reach);
    return true;
}

bool simulation_parts_box(const struct simulation *s, struct error *error) {
    const struct size_classes *classes = &s->classes;
    bool good = true;
    double margin = INDEX_NOT_WANTED;
    for (int c = 0; c < classes->count && good; c++) {
        margin = fmax(margin, classes->margin[c][c]);
        for (int b = c; b >= 0 && good; b--)
            good = !classes_meet(classes, c, b) ||
                   box_holds(s, classes->radius_max[c], classes->radius_max[b], classes->margin[c][b], error);
    }
    for (int k = 0; k < s->scene->insertions && good; k++) {
        double smallest, largest;
        sizes_bounds(&s->scene->insertion[k].sizes, &smallest, &largest);
        good = box_holds(s, largest, largest, margin, error);
    }
    return good;
}

bool simulation_parts_index(struct simulation *s, struct error *error) {
    struct index_view view;
    char why[INDEX_WHY_MAX], place[SCENE_PATH_MAX];
    simulation_index_view(s, &view);
    if (index_applicable(s->scene->index.name, &s->scene->index.params, &view, why))
        return true;
    return error_set(error, ERROR_USER, "%s: index.name: '%s' cannot serve this scene: %s",
                     scene_place(s->scene, "index.name", place, sizeof place), s->scene->index.name, why);
}
