/* Checkpoints and going on from them. A checkpoint step rebuilds, so the particles stand in the order that a
 * rebuild gives, and a resume on the same layout rebuilds into the same order: its trajectory is the
 * uninterrupted one's, bit for bit. */
#include "engine/load.h"
#include "engine/simulation.h"
#include "core/memory.h"
#include "integrate/groups.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the counters of a checkpoint mean: the first ones, three of each insertion from COUNTER_INSERTION on,
 * and the last one. */
enum { COUNTER_STEP_BASE, COUNTER_TIME_BASE, COUNTER_INSERTED, COUNTER_DELETED, COUNTER_INSERTION };
enum { COUNTER_FRACTION = CHECKPOINT_COUNTERS - 1 }; /* of the stable step that was taken; 0: it was given */
/* What belongs to the ranks: sums, and what a bisection knows of its load (load.h) if as many resume. */
enum { SUM_TAKEN, SUM_WALL_WORK, SUM_LOAD_FRESH, SUM_LOAD_REACHED };
enum { INSERTION_COUNTERS = 3 };

_Static_assert((int)COUNTER_INSERTION + INSERTION_COUNTERS * (int)INSERTIONS_MAX <= (int)COUNTER_FRACTION,
               "a checkpoint has room for all insertion regions");

static uint64_t bits_of(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static double double_of(uint64_t bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void numbers_put(const struct simulation *s, struct checkpoint_numbers *n) {
    *n = (struct checkpoint_numbers){
        .step = s->step, .time = s->time, .dt = s->dt, .seed = s->scene->seed, .next_id = s->next_id};
    n->counter[COUNTER_STEP_BASE] = s->step_base;
    n->counter[COUNTER_TIME_BASE] = bits_of(s->time_base);
    n->counter[COUNTER_INSERTED] = s->inserted;
    n->counter[COUNTER_DELETED] = s->deleted;
    n->counter[COUNTER_FRACTION] = bits_of(s->dt_fraction);
    domain_grid(s->domain, n->grid);
    for (int k = 0; k < s->scene->insertions; k++) {
        uint64_t *counter = &n->counter[COUNTER_INSERTION + INSERTION_COUNTERS * k];
        counter[0] = s->insertion_state[k].placed;
        counter[1] = s->insertion_state[k].tried;
        counter[2] = bits_of(s->insertion_state[k].mass);
    }
    n->sum[SUM_LOAD_FRESH] = s->load.fresh;
    n->sum[SUM_LOAD_REACHED] = s->load.reached;
    n->sum[SUM_TAKEN] = s->taken;
    n->sum[SUM_WALL_WORK] = s->walls ? walls_work(s->walls) : 0;
}

static void numbers_take(struct simulation *s, const struct checkpoint_numbers *n) {
    s->step = s->sources_step = n->step;
    s->time = n->time;
    s->next_id = n->next_id;
    s->step_base = n->counter[COUNTER_STEP_BASE];
    s->time_base = double_of(n->counter[COUNTER_TIME_BASE]);
    s->inserted = n->counter[COUNTER_INSERTED];
    s->deleted = n->counter[COUNTER_DELETED];
    memcpy(s->resumed_grid, n->grid, sizeof s->resumed_grid);
    for (int k = 0; k < s->scene->insertions; k++) {
        const uint64_t *counter = &n->counter[COUNTER_INSERTION + INSERTION_COUNTERS * k];
        s->insertion_state[k] = (struct insertion_state){counter[0], counter[1], double_of(counter[2])};
    }
    s->taken = n->sum[SUM_TAKEN];
    if (s->walls)
        walls_set_work(s->walls, n->sum[SUM_WALL_WORK]);
    s->resumed_dt = n->dt;
    s->resumed_fraction = double_of(n->counter[COUNTER_FRACTION]);
}

static int row_compare(const void *a, const void *b) {
    const struct history_row *x = a, *y = b;
    if (x->partner != y->partner)
        return x->partner < y->partner ? -1 : 1;
    return memcmp(x->separation, y->separation, sizeof x->separation);
}

/* Threads leave a particle's rows in any order; sorted, the same state gives the same file. */
static void rows_sort(struct history_rows *rows, size_t owned) {
    for (size_t i = 0; rows->start && i < owned; i++)
        qsort(rows->row + rows->start[i], rows->start[i + 1] - rows->start[i], sizeof *rows->row,
              row_compare);
}

/* A resume gives all forces on walls to the first rank; so does the run that goes on. */
static void wall_forces_gather(struct simulation *s) {
    double force[WALLS_MAX][6];
    walls_forces(s->walls, force);
    comm_sum(s->comm, force[0], 6 * walls_count(s->walls));
    if (s->comm->rank > 0)
        memset(force, 0, sizeof force);
    walls_set_forces(s->walls, force);
}

bool resume_write(struct simulation *s, const struct output_run *run, const char *suffix,
                  struct error *error) {
    struct rebuild_rows rows;
    rebuild_detach(s, true, &rows); /* whoever reads it may divide the particles otherwise */
    rows_sort(&rows.pairs, s->particles->owned);
    if (s->walls && !s->alone)
        wall_forces_gather(s);
    struct checkpoint checkpoint = {.particles = s->particles,
                                    .box = &s->scene->box,
                                    .tree = domain_tree(s->domain),
                                    .history_components = s->law.history_components,
                                    .history = rows.pairs.start ? &rows.pairs : NULL,
                                    .wall_history = rows.walls.start ? &rows.walls : NULL,
                                    .walls = s->walls,
                                    .scene = run->scene};
    numbers_put(s, &checkpoint.numbers);
    bool good = checkpoint_write(s->comm, run->directory, suffix, &checkpoint,
                                 s->scene->output.checkpoint.keep, error);
    rebuild_rows_free(&rows);
    return good;
}

/* The scene may change much between a checkpoint and its resume, but not what the particles live in. */
static bool resume_matches(const struct simulation *s, const char *path,
                           const struct checkpoint_loaded *loaded, struct error *error) {
    const struct box *now = &s->scene->box, *then = &loaded->box;
    for (int d = 0; d < 3; d++)
        if (now->edge[d] != then->edge[d] || now->periodic[d] != then->periodic[d] ||
            now->origin[d] != then->origin[d])
            return error_set(error, ERROR_USER,
                             "%s: it was written for a box with %c from %.9g, edge %.9g, %s; the scene's is "
                             "from %.9g, edge %.9g, %s: "
                             "a resume may change gravity, walls, motion, output and duration, not the box",
                             path, 'x' + d, then->origin[d], then->edge[d],
                             then->periodic[d] ? "periodic" : "open", now->origin[d], now->edge[d],
                             now->periodic[d] ? "periodic" : "open");
    if (loaded->history_components != s->law.history_components)
        return error_set(error, ERROR_USER,
                         "%s: its contacts have a history of %d numbers, the scene's law has %d: "
                         "contact.law, friction and rolling must stay",
                         path, loaded->history_components, s->law.history_components);
    return true;
}

static void walls_restore(struct simulation *s, const struct checkpoint_loaded *loaded) {
    for (int k = 0; k < loaded->walls; k++) {
        int wall = scene_wall(s->scene, loaded->wall[k].name);
        if (wall >= 0 && s->walls)
            walls_set_pose(s->walls, wall, &loaded->wall[k].pose);
    }
}

/* Walls are known by their names: the scene may have others, or the same in another order. */
static void wall_rows_rename(const struct simulation *s, const struct checkpoint_loaded *loaded) {
    const struct wall_rows *rows = &loaded->wall_history;
    for (size_t k = 0; k < rows->count; k++) {
        int wall = rows->row[k].wall;
        bool known = wall >= 0 && wall < loaded->walls;
        rows->row[k].wall = known ? scene_wall(s->scene, loaded->wall[wall].name) : -1;
    }
}

/* Particles of groups whose motion is prescribed now and was not then, or the other way round, get the mass
 * that goes with it. */
static void masses_follow(struct simulation *s, const char *path, struct error *error) {
    struct particles *p = s->particles;
    const uint8_t *group = groups_of(p);
    const double *density = groups_densities(p);
    for (size_t k = 0; group && k < p->owned; k++) {
        if (group[k] >= s->motion.groups) {
            error_set(error, ERROR_USER,
                      "%s: particle %lld is in group %d; the scene has %d: a resume may change the "
                      "motion of groups, not drop one",
                      path, (long long)p->id[k], group[k], s->motion.groups - 1);
            return;
        }
        bool held = s->motion.motion[group[k]].prescribed;
        struct particle_state *state = &p->state[k];
        if (held)
            state->inverse_mass = 0;
        else if (state->inverse_mass == 0)
            state->inverse_mass = 1 / particles_sphere_mass(state->radius, density[k]);
    }
}

bool resume_read(struct simulation *s, const char *path, struct rebuild_rows *rows, struct error *error) {
    struct checkpoint_loaded loaded = {0};
    bool good = checkpoint_read(s->comm, path, s->particles, &loaded, error);
    if (!comm_agree(s->comm, error) || !good)
        return false;
    if (!resume_matches(s, path, &loaded, error)) {
        checkpoint_loaded_free(&loaded);
        return false;
    }
    s->total = loaded.total;
    numbers_take(s, &loaded.numbers);
    walls_restore(s, &loaded);
    wall_rows_rename(s, &loaded);
    masses_follow(s, path, error);
    if (loaded.tree && domain_bisects(s->domain)) {
        load_restore(s, loaded.tree, loaded.numbers.sum[SUM_LOAD_FRESH] != 0,
                     loaded.numbers.sum[SUM_LOAD_REACHED]);
        loaded.tree = NULL;
    }
    if (s->history) {
        rows->pairs = loaded.history;
        loaded.history = (struct history_rows){0};
    }
    if (s->walls && s->law.history_components) {
        rows->walls = loaded.wall_history;
        loaded.wall_history = (struct wall_rows){0};
    }
    checkpoint_loaded_free(&loaded);
    return comm_agree(s->comm, error);
}

void resume_begin(struct simulation *s, struct rebuild_rows *rows) {
    if (s->dt != s->resumed_dt) {
        s->step_base = s->step;
        s->time_base = s->time;
    }
    rebuild_from_rows(s, rows);
}
