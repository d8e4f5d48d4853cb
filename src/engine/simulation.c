/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a simulation from a scene, and its parts. Read simulation.h first. */
#include "engine/simulation.h"
#include "engine/view.h"
#include "engine/classify.h"
#include "engine/timing.h"
#include "engine/sources.h"
#include "engine/resume.h"
#include "engine/rebuild_rows.h"
#include "engine/stages.h"
#include "engine/rebuild.h"
#include "engine/step.h"
#include "engine/grains.h"
#include "engine/guards.h"
#include "engine/load.h"
#include "comm/balance.h"
#include "comm/cores.h"
#include "core/memory.h"
#include "core/threads.h"
#include "scene/scene_read.h"
#include "integrate/integrator.h"
#include "particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

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

bool simulation_prepare(struct simulation *s, struct error *error) {
    const struct scene *scene = s->scene;
    struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX];
    const struct integrator *integrator = integrator_find(scene->integrator);
    struct law_options options = scene->law;
    assert(integrator);
    options.synchronised = integrator->synchronised;
    memcpy(pair, scene->law_pair, sizeof pair);
    if (!law_prepare(&s->grains.law, &options, scene->materials, scene->material, pair, error))
        return false;
    scene_integrator(scene, &s->grains.motion);
    if (!set_threads(s, error))
        return false;
    if (scene->walls > 0 && !walls_create(&s->grains.walls, scene->wall, scene->walls, &s->grains.law,
                                          &scene->box, s->threads, error, s->comm->rank == 0 ? stderr : NULL))
        return false;
    if (s->grains.walls && scene->reproducible)
        walls_set_exact(s->grains.walls);
    if (scene->domain.kind == DOMAIN_BISECTION && !domain_possible(s, error))
        return false;
    s->ranks.domain = domain_create(s->comm, &scene->box, &scene->domain, error);
    if (s->ranks.domain == NULL)
        return false;
    domain_wrap(s->ranks.domain, s->ranks.wrap);
    struct index_params params = scene->index.params;
    params.instructions = (int)scene->simd;
    s->search.index = index_create(scene->index.name, &params, error);
    return s->search.index != NULL && sources_prepare(s, error);
}

/* Makes all parts that do not depend on the number of particles. */
static void parts_create(struct simulation *s) {
    s->ranks.ghosts = ghosts_create(s->comm, s->ranks.domain, &s->scene->box, &s->scene->ghosts);
    interactions_create(&s->search.interactions, &(struct pairlist_options){.threads = s->threads});
    s->grains.history = s->grains.law.history_components
                            ? history_create(s->grains.law.history_components, s->threads)
                            : NULL;
    if (s->grains.history)
        s->grains.history->odd = s->grains.law.history_odd;
    s->search.skin = skin_create();
    s->search.sweep = s->scene->step.fused ? sweep_create(s->threads) : NULL;
    s->grains.loop = force_loop_create(s->threads);
    s->grains.speed = memory_allocate_zero((size_t)s->threads, sizeof *s->grains.speed, "speeds");
    s->grains.contact = (struct force_context){.particles = s->particles,
                                               .history = s->grains.history,
                                               .law = &s->grains.law,
                                               .prescribed = s->scene->groups > 1,
                                               .ordered = s->scene->reproducible};
}

/* The vector instructions that the scene asks for. */
static bool simd_choose(const struct simulation *s, struct error *error) {
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

static bool mine(void *context, const double x[3]) {
    const struct simulation *s = context;
    return domain_owner(s->ranks.domain, x) == s->comm->rank;
}

static bool taken(void *context, const double x[3], double radius) {
    const struct simulation *s = context;
    return s->grains.walls && walls_overlap(s->grains.walls, x, radius);
}

/* Prints the progress of a long placement: a line of rank 0 every ten seconds, if progress is shown. */
static void placed(void *context, const char *what, double part) {
    static const double pause = 10;
    struct simulation *s = context;
    enum progress_mode mode = s->scene->output.progress.mode;
    double now = timer_now();
    bool shown = mode == PROGRESS_LINES || (mode != PROGRESS_OFF && isatty(fileno(stderr)));
    if (s->comm->rank != 0 || !shown || now - s->sources.placing_told < pause)
        return;
    if (s->sources.placing_told > 0)
        fprintf(stderr, "scree: %s: %.0f %%\n", what, 100 * part);
    s->sources.placing_told = now;
}

/* Adds particles of other kinds than grains. */
static bool particles_fill(struct simulation *s, struct error *error) {
    const struct physics_share share = {.first_id = s->sources.next_id, .mine = mine, .context = s};
    if (kinds_of(s->particles) == NULL)
        return true;
    physics_fill(&s->physics, &share, error);
    if (!comm_agree(s->comm, error))
        return false;
    int64_t total = (int64_t)s->particles->owned, last = s->sources.next_id - 1;
    for (size_t k = 0; k < s->particles->owned; k++)
        last = s->particles->id[k] > last ? s->particles->id[k] : last;
    comm_sum_int(s->comm, &total, 1);
    comm_max_int(s->comm, &last, 1);
    s->total = (uint64_t)total;
    s->sources.next_id = last + 1;
    return true;
}

static bool particles_make(struct simulation *s, struct error *error) {
    struct scene_share share = {.rank = s->comm->rank,
                                .size = s->comm->size,
                                .mine = mine,
                                .taken = taken,
                                .context = s,
                                .progress = placed};
    bool good = scene_particles(s->scene, &share, s->particles, &s->sources.census, error);
    if (!comm_agree(s->comm, error) || !good)
        return false;
    s->total = s->sources.census.particles;
    s->sources.next_id = s->sources.census.id_max + 1;
    return particles_fill(s, error);
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
    for (int d = 0; d < s->scene->box.dimension; d++)
        if (s->scene->box.periodic[d] && reach >= s->scene->box.edge[d])
            return error_set(error, ERROR_USER,
                             "%s: the periodic %c edge %.6g is too short for %s + range + skin, %.6g",
                             scene_place(s->scene, "box", place, sizeof place), 'x' + d,
                             s->scene->box.edge[d], whom, reach);
    return true;
}

/* Calls box_holds for the present particles, and for particles of insertions. */
static bool box_suffices(const struct simulation *s, struct error *error) {
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

static bool index_suits(struct simulation *s, struct error *error) {
    struct index_view view;
    char why[INDEX_WHY_MAX], place[SCENE_PATH_MAX];
    simulation_index_view(s, &view);
    if (index_applicable(s->scene->index.name, &s->scene->index.params, &view, why))
        return true;
    return error_set(error, ERROR_USER, "%s: index.name: '%s' cannot serve this scene: %s",
                     scene_place(s->scene, "index.name", place, sizeof place), s->scene->index.name, why);
}

/* The start of a run that is not resumed: first rebuild, first forces, velocities half a step back. */
static bool run_begin(struct simulation *s, struct error *error) {
    struct rebuild_rows rows = {0};
    rebuild_from_rows(s, &rows);
    if (!timing_contacts(s, error))
        return false;
    s->grains.contact.want_sums = s->grains.contact.want_virial = true;
    step_forces(s);
    s->grains.taken = 0;
    s->timing.overlap_started = s->grains.sums.overlap_max;
    comm_max(s->comm, &s->timing.overlap_started, 1);
#pragma omp parallel for schedule(static)
    for (int b = 0; b < s->grains.list->block_count; b++) {
        const struct pair_block *block = &s->grains.list->blocks[b];
        if (s->classes.kind[block->size_class] == KIND_GRAIN)
            integrator_stagger(s->particles, &s->grains.motion, block->first_row, block->last_row);
    }
    return true;
}

static bool run_go_on(struct simulation *s, struct rebuild_rows *rows, struct error *error) {
    resume_begin(s, rows);
    return timing_contacts(s, error);
}

/* Checks the particles after they have been made. */
static bool particles_suit(struct simulation *s, struct error *error) {
    if (s->total >= (uint64_t)s->comm->size << PARTICLE_INDEX_BITS)
        return error_set(error, ERROR_USER,
                         "%llu particles on %d ranks: allowed are up to %llu a rank, copies included",
                         (unsigned long long)s->total, s->comm->size, 1ull << PARTICLE_INDEX_BITS);
    if (!classify_choose(s, error) || !box_suffices(s, error) || !timing_choose(s, error))
        return false;
    particles_classify(s->particles, &s->classes);
    interactions_divide(&s->search.interactions, &s->classes,
                        &(struct pairlist_options){.threads = s->threads});
    physics_lists(&s->physics, &s->search.interactions);
    s->grains.list = s->grains.contact.list = interaction_list(&s->search.interactions, 0);
    step_plan(s);
    load_lay(s, s->resumed.grid);
    index_suits(s, error);
    return comm_agree(s->comm, error); /* each rank looks at its own particles */
}

/* Starts the physics that the scene asks for, with grains first. */
static void physics_start(struct simulation *s) {
    struct physics_context context = {.options = &s->grains.law,
                                      .scene = s->scene,
                                      .box = &s->scene->box,
                                      .comm = s->comm,
                                      .ghosts = NULL,
                                      .particles = s->particles,
                                      .classes = &s->classes,
                                      .walls = s->grains.walls,
                                      .clock = &s->clock,
                                      .threads = s->threads,
                                      .ordered = s->scene->reproducible};
    physics_begin(&s->physics, &grains_physics, &context, &s->search.interactions);
}

static bool simulation_fill(struct simulation *s, const char *resume, struct error *error) {
    s->particles = particles_create(0);
    scene_register(s->scene, &s->grains.law, s->particles);
    physics_start(s);
    parts_create(s);
    if (physics_create(&s->physics, s, error))
        simd_choose(s, error);
    if (!comm_agree(s->comm, error)) /* ranks may have different CPUs */
        return false;
    struct rebuild_rows rows = {0};
    bool good = resume ? resume_read(s, resume, &rows, error) : particles_make(s, error);
    if (!good || !particles_suit(s, error)) {
        rebuild_rows_free(&rows);
        return false;
    }
    bool begun = resume ? run_go_on(s, &rows, error) : run_begin(s, error);
    char *echo = scene_echo(s->scene);
    lineage_go_on(&s->lineage, s->clock.step, echo);
    memory_free(echo);
    if (!begun || !guards_prepare(s, error))
        return false;
    *error = s->error;
    return s->error.kind == ERROR_NONE;
}

struct simulation *simulation_create(const struct comm *comm, const struct scene *scene, const char *resume,
                                     struct error *error) {
    struct simulation *s = memory_allocate_zero(1, sizeof *s, "simulation");
    s->comm = comm;
    s->scene = scene;
    s->ranks.alone = comm->size == 1;
    int stage = stages_begin(&s->timers);
    timer_start(&s->timers, stage);
    simulation_prepare(s, error);
    if (comm_agree(comm, error))
        simulation_fill(s, resume, error);
    if (!comm_agree(comm, error))
        simulation_destroy(&s);
    else
        timer_stop(&s->timers, stage);
    return s;
}

void simulation_destroy(struct simulation **simulation) {
    struct simulation *s = *simulation;
    if (s == NULL)
        return;
    team_end(&s->team);
    force_loop_destroy(&s->grains.loop);
    walls_destroy(&s->grains.walls);
    sweep_destroy(&s->search.sweep);
    skin_destroy(&s->search.skin);
    history_destroy(&s->grains.history);
    physics_free(&s->physics);
    interactions_free(&s->search.interactions);
    index_destroy(&s->search.index);
    ghosts_destroy(&s->ranks.ghosts);
    domain_destroy(&s->ranks.domain);
    particles_destroy(&s->particles);
    scene_changes_free(&s->resumed.changes);
    lineage_free(&s->lineage);
    memory_free(s->grains.speed);
    memory_free(s);
    *simulation = NULL;
}
