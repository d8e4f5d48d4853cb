/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics of a run: finds the physics that the scene asks for, and calls them. Read physics.h first. */
#include "engine/physics.h"
#include "particles/kinds.h"
#include <math.h>

/* An entry of the table of physics. */
struct physics_entry {
    const struct physics *physics;
    void (*fields)(struct particles *particles);
    const char *key;
};

#define PHYSICS_ENTRY(name, key, whose, summary) {&name##_physics, name##_fields, #key},
static const struct physics_entry entries[] = {PHYSICS_TABLE(PHYSICS_ENTRY)};

const struct physics *physics_get(enum physics_number number) {
    return entries[number].physics;
}

const char *physics_key(enum physics_number number) {
    return entries[number].key;
}

static void activate(struct physics_set *set, const struct physics *row, const void *options,
                     const struct physics_context *context, struct interactions *interactions) {
    struct physics_active *active = &set->active[set->count++];
    *active = (struct physics_active){.row = row, .context = *context, .first = interactions->count};
    active->context.options = options;
    if (row->moving)
        interactions->moving |= row->moving(options);
    for (int k = 0; k < row->interactions; k++) {
        struct interaction interaction = row->interaction[k];
        interaction.context = options;
        interactions_add(interactions, &interaction);
    }
}

void physics_begin(struct physics_set *set, const struct physics *grains,
                   const struct physics_context *context, struct interactions *interactions) {
    const struct scene *scene = context->scene;
    set->count = 0;
    set->interactions = interactions;
    activate(set, grains, context->options, context, interactions);
    for (int k = 0; k < PHYSICS_COUNT; k++) {
        if (scene->physics_given[k] == 0)
            continue;
        if (physics_has_particles(k))
            kinds_register(context->particles);
        entries[k].fields(context->particles);
        activate(set, entries[k].physics, scene->physics[k], context, interactions);
    }
}

/* Refuses a physics that does not know a box that moves. */
static bool suits_box(const struct physics_active *active, struct error *error) {
    if (!active->context.box->motion.moves || active->row->box_moves)
        return true;
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (entries[k].physics == active->row)
            return scene_fail(active->context.scene, error, entries[k].key,
                              "does not go with a box that moves (box.shear, box.strain, box.stress)");
    return true;
}

bool physics_create(struct physics_set *set, void *self, struct error *error) {
    set->active[0].context.self = self;
    for (int k = 1; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        if (!suits_box(active, error))
            return false;
        if (active->row->check && !active->row->check(&active->context, error))
            return false;
        active->context.self = active->row->create ? active->row->create(&active->context) : NULL;
        for (int i = 0; active->row->range_of_self && i < active->row->interactions; i++)
            set->interactions->row[active->first + i].context = active->context.self;
    }
    return true;
}

void physics_own(const struct physics_set *set, const void *own[PHYSICS_COUNT]) {
    for (int number = 0; number < PHYSICS_COUNT; number++) {
        own[number] = NULL;
        for (int k = 1; k < set->count; k++)
            if (set->active[k].row == entries[number].physics)
                own[number] = set->active[k].context.self;
    }
}

void physics_free(struct physics_set *set) {
    for (int k = 1; k < set->count; k++)
        if (set->active[k].context.self)
            set->active[k].row->destroy(set->active[k].context.self);
    set->count = 0;
}

bool physics_fill(const struct physics_set *set, const struct physics_share *share, struct error *error) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->fill && !set->active[k].row->fill(&set->active[k].context, share, error))
            return false;
    return true;
}

void physics_lists(struct physics_set *set, const struct interactions *interactions) {
    for (int k = 0; k < set->count; k++)
        for (int i = 0; i < set->active[k].row->interactions; i++)
            set->active[k].context.list[i] = interaction_list(interactions, set->active[k].first + i);
}

bool physics_rebuilt(struct physics_set *set, struct ghosts *ghosts) {
    bool again = false;
    for (int k = 0; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        active->context.ghosts = ghosts;
        if (active->row->rebuilt)
            active->row->rebuilt(&active->context);
        if (active->row->rebuilt_again)
            again = active->row->rebuilt_again(&active->context) || again;
    }
    return again;
}

bool physics_rests(const struct physics_set *set) {
    bool rests = true;
    for (int k = 0; k < set->count; k++) {
        const struct physics_active *active = &set->active[k];
        rests = rests && (active->row->interactions == 0 ||
                          (active->row->rests && active->row->rests(&active->context)));
    }
    return rests;
}

bool physics_due(const struct physics_set *set) {
    bool due = false;
    for (int k = 1; k < set->count; k++)
        due = due || (set->active[k].row->due && set->active[k].row->due(&set->active[k].context));
    return due;
}

bool physics_carries(const struct physics_set *set) {
    bool carries = false;
    for (int k = 1; k < set->count; k++)
        carries = carries || set->active[k].row->rows;
    return carries;
}

void physics_rows(const struct physics_set *set, struct history_rows *rows[PHYSICS_COUNT],
                  int components[PHYSICS_COUNT]) {
    for (int number = 0; number < PHYSICS_COUNT; number++) {
        rows[number] = NULL;
        for (int k = 1; k < set->count; k++) {
            const struct physics *row = set->active[k].row;
            if (row != entries[number].physics || row->rows == NULL)
                continue;
            rows[number] = row->rows(&set->active[k].context);
            components[number] = row->row_components;
        }
    }
}

void physics_energy(const struct physics_set *set, double *stored, double *taken) {
    *stored = *taken = 0;
    for (int k = 1; k < set->count; k++) {
        double own[2] = {0};
        if (set->active[k].row->energy)
            set->active[k].row->energy(&set->active[k].context, &own[0], &own[1]);
        *stored += own[0];
        *taken += own[1];
    }
}

double physics_work(const struct physics_set *set) {
    double work = 0;
    for (int k = 1; k < set->count; k++)
        if (set->active[k].row->work)
            work += set->active[k].row->work(&set->active[k].context);
    return work;
}

static bool may_join(const struct physics_active *active) {
    return active->row->joins && active->row->joins(&active->context);
}

bool physics_joins(const struct physics_set *set) {
    bool joins = false;
    for (int k = 1; k < set->count; k++)
        joins = joins || may_join(&set->active[k]);
    return joins;
}

bool physics_joined(const void *context, size_t i, size_t j) {
    const struct physics_set *set = context;
    for (int k = 1; k < set->count; k++)
        if (may_join(&set->active[k]) && set->active[k].row->joined(&set->active[k].context, i, j))
            return true;
    return false;
}

void physics_stiffen(const struct physics_set *set, struct stability *stability) {
    for (int k = 1; k < set->count; k++)
        if (set->active[k].row->stiffen)
            set->active[k].row->stiffen(&set->active[k].context, stability);
}

double physics_stiffest(const struct physics_set *set, const struct stability *stability) {
    double most = 0;
    for (int k = 1; k < set->count; k++)
        if (set->active[k].row->stiffest)
            most = fmax(most, set->active[k].row->stiffest(&set->active[k].context, stability));
    return most;
}

bool physics_has_tables(const struct physics_set *set) {
    bool has = false;
    for (int k = 1; k < set->count; k++)
        has = has || set->active[k].row->table_write;
    return has;
}

bool physics_table_open(const struct physics_set *set, const char *directory, int64_t step,
                        struct error *error) {
    bool good = true;
    for (int k = 1; good && k < set->count; k++)
        if (set->active[k].row->table_open)
            good = set->active[k].row->table_open(&set->active[k].context, directory, step, error);
    return good;
}

bool physics_table_write(const struct physics_set *set, struct error *error) {
    bool good = true;
    for (int k = 1; k < set->count; k++)
        if (set->active[k].row->table_write)
            good = set->active[k].row->table_write(&set->active[k].context, error) && good;
    return good;
}

void physics_full_step(const struct physics_set *set) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->full_step)
            set->active[k].row->full_step(&set->active[k].context);
}

void physics_look(const struct physics_set *set) {
    physics_full_step(set);
    for (int k = 0; k < set->count; k++) {
        const struct physics_active *active = &set->active[k];
        for (int p = 0; p < active->row->passes; p++) {
            const struct physics_pass *pass = &active->row->pass[p];
            if (pass->stage == PASS_LOOK && (pass->needed == NULL || pass->needed(&active->context)))
                pass->whole(&active->context);
        }
    }
}

double physics_limit(const struct physics_set *set, double most) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->limit)
            most = fmin(most, set->active[k].row->limit(&set->active[k].context, most));
    return most;
}

const char *physics_limit_why(const struct physics_set *set, double limit) {
    const char *why = NULL;
    for (int k = 1; k < set->count; k++) {
        const struct physics_active *active = &set->active[k];
        if (active->row->limit && active->row->limit(&active->context, INFINITY) <= limit)
            why = active->row->limit_why;
    }
    return why;
}

void physics_guard(const struct physics_set *set, struct error *error) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->guard)
            set->active[k].row->guard(&set->active[k].context, error);
}

void physics_restart(const struct physics_set *set, struct restart *restart) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->restart)
            set->active[k].row->restart(&set->active[k].context, restart);
}

void physics_solvers(const struct physics_set *set, struct report *report) {
    report->solvers = 0;
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->solvers && report->solvers == 0)
            report->solvers = set->active[k].row->solvers(&set->active[k].context, report->solver);
}

void physics_print(const struct physics_set *set, FILE *file) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->print)
            set->active[k].row->print(&set->active[k].context, file);
}
