/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a simulation from a scene, and its parts. Read simulation.h first. */
#include "engine/simulation.h"
#include "engine/crossings.h"
#include "engine/deform.h"
#include "engine/simulation_parts.h"
#include "engine/classify.h"
#include "engine/timing.h"
#include "engine/sources.h"
#include "engine/resume.h"
#include "engine/rebuild_rows.h"
#include "engine/stages.h"
#include "engine/rebuild.h"
#include "engine/step.h"
#include "engine/guards.h"
#include "engine/load_balance.h"
#include "engine/index_view.h"
#include "base/memory.h"
#include "data/scene/scene_read.h"
#include "kernel/particles/kinds.h"

static bool mine(void *context, const double x[3]) {
    const struct simulation *s = context;
    return domain_owner(s->ranks.domain, x) == s->comm->rank;
}

static bool taken(void *context, const double x[3], double radius) {
    const struct simulation *s = context;
    return physics_occupied(&s->physics, x, radius);
}

/* Adds particles of other kinds than grains. */
static bool particles_fill(struct simulation *s, struct error *error) {
    const struct physics_share share = {.first_id = s->sources.next_id};
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
                                .progress = simulation_parts_placed};
    bool good = scene_particles(s->scene, &share, s->particles, &s->sources.census, error);
    if (!comm_agree(s->comm, error) || !good)
        return false;
    s->total = s->sources.census.particles;
    s->sources.next_id = s->sources.census.id_max + 1;
    deform_start(&s->box, s->scene, s->particles);
    return particles_fill(s, error);
}

/* The start of a run that is not resumed: first rebuild, first forces, velocities half a step back. */
static bool run_begin(struct simulation *s, struct error *error) {
    const struct physics_active *mover = s->physics.mover;
    struct rebuild_rows rows = {0};
    rebuild_from_rows(s, &rows);
    if (!timing_contacts(s, error))
        return false;
    s->evaluation.sums = s->evaluation.virial = true;
    step_forces(s);
    if (mover->row->mover->begin)
        mover->row->mover->begin(&mover->context);
    if (mover->row->mover->stagger)
        mover->row->mover->stagger(&mover->context, s->clock.dt);
    return true;
}

static bool run_go_on(struct simulation *s, struct rebuild_rows *rows, struct error *error) {
    const struct physics_active *mover = s->physics.mover;
    resume_begin(s, rows);
    if (!timing_contacts(s, error))
        return false;
    if (mover->row->mover->stagger)
        mover->row->mover->stagger(&mover->context, s->clock.dt - s->resumed.dt);
    return true;
}

/* Checks the particles after they have been made. */
static bool particles_suit(struct simulation *s, struct error *error) {
    struct index_view view;
    if (s->total >= (uint64_t)s->comm->size << PARTICLE_INDEX_BITS)
        return error_set(error, ERROR_USER,
                         "%llu particles on %d ranks: allowed are up to %llu a rank, copies included",
                         (unsigned long long)s->total, s->comm->size, 1ull << PARTICLE_INDEX_BITS);
    if (!classify_choose(s, error) || !simulation_parts_box(s->scene, &s->box, &s->classes, error) ||
        !timing_choose(s, error))
        return false;
    particles_classify(s->particles, &s->classes);
    interactions_divide(&s->search.interactions, &s->classes,
                        &(struct pairlist_options){.threads = s->threads});
    physics_lists(&s->physics, &s->search.interactions);
    s->search.list = interaction_list(&s->search.interactions, 0);
    physics_prepare(&s->physics);
    step_plan(s);
    deform_begin(&s->servo, &s->box, s->scene, s->particles, s->comm);
    load_lay(&s->ranks, s->particles, &s->box, s->comm, s->scene->domain.grid, s->resumed.grid);
    simulation_index_view(s, &view);
    simulation_parts_index(s->scene, &view, error);
    return comm_agree(s->comm, error); /* each rank looks at its own particles */
}

static bool simulation_fill(struct simulation *s, const char *resume, struct error *error) {
    const struct physics_active *mover = s->physics.mover;
    simulation_parts_create(s);
    deform_prepare(&s->servo, &s->box, s->scene, s->search.skin, s->threads);
    if (physics_create(&s->physics, error) && mover->row->mover->history)
        s->search.history = mover->row->mover->history(&mover->context);
    if (!comm_agree(s->comm, error)) /* ranks may have different CPUs */
        return false;
    sources_weigh(&s->sources, s->scene, &s->physics);
    struct rebuild_rows rows = {0};
    crossings_prepare(s->crossings, s->scene->output.observables.planes);
    bool good = resume ? resume_read(s, resume, &rows, error) : particles_make(s, error);
    if (!good || !particles_suit(s, error)) {
        rebuild_rows_free(&rows);
        return false;
    }
    memory_trim();
    particles_spread(s->particles);
    bool begun = resume ? run_go_on(s, &rows, error) : run_begin(s, error);
    crossings_begin(s->crossings, &s->scene->output.observables, &s->box, s->particles);
    char *echo = scene_echo(s->scene);
    lineage_go_on(&s->lineage, s->clock.step, echo);
    memory_free(echo);
    if (!begun || !guards_prepare(s, error))
        return false;
    *error = s->error;
    return s->error.kind == ERROR_NONE;
}

struct simulation *simulation_create_for(const struct simulation_caller *caller, const struct comm *comm,
                                         const struct scene *scene, const char *resume, struct error *error) {
    struct simulation *s = memory_allocate_zero(1, sizeof *s, "simulation");
    s->caller = *caller;
    s->comm = comm;
    s->scene = scene;
    s->box = scene->box;
    s->ranks.alone = comm->size == 1 && !s->box.motion.shears;
    int stage = stages_begin(&s->timers);
    timer_start(&s->timers, stage);
    simulation_parts_prepare(s, error);
    if (comm_agree(comm, error))
        simulation_fill(s, resume, error);
    if (!comm_agree(comm, error))
        simulation_destroy(&s);
    else
        timer_stop(&s->timers, stage);
    return s;
}

struct simulation *simulation_create(const struct comm *comm, const struct scene *scene, const char *resume,
                                     struct error *error) {
    return simulation_create_for(&(struct simulation_caller){0}, comm, scene, resume, error);
}

void simulation_destroy(struct simulation **simulation) {
    struct simulation *s = *simulation;
    if (s == NULL)
        return;
    team_end(&s->team);
    deform_free(&s->servo);
    sweep_destroy(&s->search.sweep);
    skin_destroy(&s->search.skin);
    physics_free(&s->physics);
    interactions_free(&s->search.interactions);
    index_destroy(&s->search.index);
    ghosts_destroy(&s->ranks.ghosts);
    domain_destroy(&s->ranks.domain);
    particles_destroy(&s->particles);
    sources_free(&s->sources);
    scene_changes_free(&s->resumed.changes);
    lineage_free(&s->lineage);
    memory_free(s->search.speed);
    memory_free(s);
    *simulation = NULL;
}
