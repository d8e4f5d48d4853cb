/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes checkpoints and resumes from them. A checkpoint step rebuilds, so the particles stand in the order
 * of a rebuild, and a resume on the same layout rebuilds into the same order. The trajectory of the resumed
 * run then equals that of the uninterrupted run, bit for bit. */
#include "engine/crossings.h"
#include "engine/deform.h"
#include "engine/load_balance.h"
#include "engine/resume_check.h"
#include "engine/rebuild_rows.h"
#include "engine/rebuild.h"
#include "engine/resume.h"
#include "engine/skin_auto.h"
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of a run that the simulation does not hold in the form that is written. Numbers of the ranks, if as many ranks
 * resume: the state of a bisection's load (load_balance.h). */
struct resume_numbers {
    double fraction; /* fraction of the stable step; 0: the scene gives the step */
    double load_fresh, load_reached;
};

/* Lists the numbers that a resume needs, with their names. */
static void numbers_list(struct simulation *s, struct resume_numbers *own, struct restart *restart) {
    restart_add(restart, RESTART_INTEGER, false, &s->clock.step_base, "step base");
    restart_add(restart, RESTART_REAL, false, &s->clock.time_base, "time base");
    restart_add(restart, RESTART_REAL, false, &own->fraction, "fraction of the stable step");
    if (s->scene->stages > 0) {
        restart_add(restart, RESTART_INTEGER, true, &s->stage.number, "stage: number");
        restart_add(restart, RESTART_INTEGER, true, &s->stage.last, "stage: last step");
        restart_add(restart, RESTART_REAL, true, &s->stage.began, "stage: began");
    }
    restart_add(restart, RESTART_INTEGER, false, &s->sources.inserted, "inserted");
    restart_add(restart, RESTART_INTEGER, false, &s->sources.deleted, "deleted");
    restart_add(restart, RESTART_SUM, true, &s->sources.deleted_mass, "deleted mass");
    crossings_restart(s->crossings, &s->scene->output.observables, restart);
    physics_restart(&s->physics, restart);
    if (s->box.motion.moves)
        deform_restart(&s->box, &s->servo, restart);
    if (s->scene->classes.skin_auto)
        skin_auto_restart(&s->search.choice, restart);
    restart_add(restart, RESTART_SUM, false, &own->load_fresh, "load: imbalance not measured");
    restart_add(restart, RESTART_SUM, false, &own->load_reached, "load: imbalance reached");
    for (int k = 0; k < s->scene->insertions; k++) {
        struct insertion_state *state = &s->sources.state[k];
        restart_add(restart, RESTART_INTEGER, true, &state->placed, "insertion %d: placed", k);
        restart_add(restart, RESTART_INTEGER, true, &state->tried, "insertion %d: tried", k);
        restart_add(restart, RESTART_REAL, true, &state->mass, "insertion %d: mass", k);
    }
}

static void numbers_put(const struct clock *clock, const struct ranks *ranks, struct checkpoint_numbers *n,
                        struct resume_numbers *own) {
    n->step = clock->step;
    n->time = clock->time;
    n->dt = clock->dt;
    domain_grid(ranks->domain, n->grid);
    *own = (struct resume_numbers){
        .fraction = clock->dt_fraction, .load_fresh = ranks->load.fresh, .load_reached = ranks->load.reached};
}

static bool numbers_take(struct simulation *s, const char *path, const struct checkpoint_loaded *loaded,
                         struct resume_numbers *own, struct error *error) {
    const struct checkpoint_numbers *n = &loaded->numbers;
    struct restart list = {0};
    numbers_list(s, own, &list);
    bool good = restart_take(&list, &loaded->restart, path, error);
    restart_free(&list);
    s->clock.step = s->sources.last_step = n->step;
    s->clock.time = n->time;
    s->sources.next_id = n->next_id;
    memcpy(s->resumed.grid, n->grid, sizeof s->resumed.grid);
    s->resumed.dt = n->dt;
    s->resumed.fraction = own->fraction;
    return good;
}

static int row_compare(const void *a, const void *b) {
    const struct history_row *x = a, *y = b;
    if (x->partner != y->partner)
        return x->partner < y->partner ? -1 : 1;
    return memcmp(x->separation, y->separation, sizeof x->separation);
}

/* Sorts rows: threads leave the rows of a particle in any order, and the same state should give the same
 * file. */
static void rows_sort(struct history_rows *rows, size_t owned) {
    for (size_t i = 0; rows->start && i < owned; i++)
        qsort(rows->row + rows->start[i], rows->start[i + 1] - rows->start[i], sizeof *rows->row,
              row_compare);
}

bool resume_write(struct simulation *s, const struct output_run *run, const char *suffix,
                  struct error *error) {
    struct rebuild_rows rows = {0};
    physics_full_step(&s->physics);
    rebuild_detach(&s->search, &s->physics, s->particles, true,
                   &rows); /* the reader may divide the particles differently */
    physics_rows(&s->physics, rows.carried);
    rows_sort(&rows.pairs, s->particles->owned);
    struct resume_numbers own;
    struct restart restart = {0};
    const char *group[INTEGRATOR_GROUPS_MAX];
    for (int k = 0; k < s->scene->groups; k++)
        group[k] = s->scene->group[k].name;
    struct checkpoint checkpoint = {.restart = &restart,
                                    .history_components =
                                        s->search.history ? s->search.history->components : 0,
                                    .particles = s->particles,
                                    .box = &s->box,
                                    .tree = domain_tree(s->ranks.domain),
                                    .history = rows.pairs.start ? &rows.pairs : NULL,
                                    .carried = rows.carried,
                                    .materials = s->scene->materials,
                                    .groups = s->scene->groups,
                                    .material = s->scene->material,
                                    .group = group,
                                    .scene = run->scene,
                                    .lineage = &s->lineage};
    PHYSICS_EACH (active, &s->physics, record)
        if (active->row->record->save)
            active->row->record->save(&active->context, &rows.obstacles, &checkpoint);
    checkpoint.numbers = (struct checkpoint_numbers){.seed = s->scene->seed, .next_id = s->sources.next_id};
    numbers_put(&s->clock, &s->ranks, &checkpoint.numbers, &own);
    numbers_list(s, &own, &restart);
    bool good = checkpoint_write(s->comm, run->directory, suffix, &checkpoint,
                                 s->scene->output.checkpoint.keep, error);
    restart_free(&restart);
    rebuild_rows_free(&rows);
    return good;
}

/* Gives the physics their rows; a scene without the physics does without. */
static bool carried_take(const struct physics_set *set, const char *path, struct checkpoint_loaded *loaded,
                         struct error *error) {
    struct rebuild_rows rows = {0};
    physics_rows(set, rows.carried);
    for (int k = 0; k < PHYSICS_COUNT; k++) {
        if (rows.carried[k] == NULL || loaded->carried[k].start == NULL)
            continue;
        if (rows.carried[k]->components != loaded->carried[k].components)
            return error_set(error, ERROR_USER, "%s: the rows of %s have %d numbers each, not %d", path,
                             physics_get((enum physics_number)k)->name, loaded->carried[k].components,
                             rows.carried[k]->components);
        history_rows_free(rows.carried[k]);
        *rows.carried[k] = loaded->carried[k];
        loaded->carried[k] = (struct history_rows){0};
    }
    return true;
}

/* Moves the data read into the simulation. */
static bool take(struct simulation *s, const char *path, struct checkpoint_loaded *loaded,
                 struct rebuild_rows *rows, struct error *error) {
    struct resume_numbers own = {0};
    if (!numbers_take(s, path, loaded, &own, error))
        return false;
    if (s->box.motion.moves)
        domain_follow(s->ranks.domain, &s->box);
    if (!deform_moved(&loaded->restart))
        deform_start(&s->box, s->scene, s->particles);
    s->total = loaded->total;
    s->resumed.masses = resume_apply(s->particles, s->scene, &s->box, s->comm, loaded);
    s->lineage = loaded->lineage;
    loaded->lineage = (struct lineage){0};
    if (loaded->tree && domain_bisects(s->ranks.domain)) {
        load_restore(&s->ranks, loaded->tree, own.load_fresh != 0, own.load_reached);
        loaded->tree = NULL;
    }
    if (s->search.history) {
        rows->pairs = loaded->history;
        loaded->history = (struct history_rows){0};
    }
    PHYSICS_EACH (active, &s->physics, record)
        active->row->record->resume(&active->context, loaded, &rows->obstacles);
    return carried_take(&s->physics, path, loaded, error);
}

bool resume_read(struct simulation *s, const char *path, struct rebuild_rows *rows, struct error *error) {
    struct checkpoint_loaded loaded = {0};
    bool good = checkpoint_read(s->comm, path, s->particles, &loaded, error);
    if (!comm_agree(s->comm, error) || !good)
        return false;
    good = resume_check(s, path, &loaded, error) && take(s, path, &loaded, rows, error);
    checkpoint_loaded_free(&loaded);
    return comm_agree(s->comm, error) && good;
}

void resume_begin(struct simulation *s, struct rebuild_rows *rows) {
    if (s->clock.dt != s->resumed.dt) {
        s->clock.step_base = s->clock.step;
        s->clock.time_base = s->clock.time;
    }
    rebuild_from_rows(s, rows);
}
