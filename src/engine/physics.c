/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics of a run: finds the physics that the scene asks for, and calls them. Read physics.h first. */
#include "engine/physics.h"
#include "particles/kinds.h"
#include <math.h>

/* An entry of the table of physics. */
struct physics_entry {
    const struct physics *physics;
    void (*fields)(struct particles *particles);
};

#define PHYSICS_ENTRY(name, key, whose, summary) {&name##_physics, name##_fields},
static const struct physics_entry entries[] = {PHYSICS_TABLE(PHYSICS_ENTRY)};

const struct physics *physics_get(enum physics_number number) {
    return entries[number].physics;
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

bool physics_create(struct physics_set *set, void *self, struct error *error) {
    set->active[0].context.self = self;
    for (int k = 1; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        if (active->row->check && !active->row->check(&active->context, error))
            return false;
        active->context.self = active->row->create ? active->row->create(&active->context) : NULL;
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

void physics_rebuilt(struct physics_set *set, struct ghosts *ghosts) {
    for (int k = 0; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        active->context.ghosts = ghosts;
        if (active->row->rebuilt)
            active->row->rebuilt(&active->context);
    }
}

void physics_look(const struct physics_set *set) {
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

void physics_print(const struct physics_set *set, FILE *file) {
    for (int k = 0; k < set->count; k++)
        if (set->active[k].row->print)
            set->active[k].row->print(&set->active[k].context, file);
}
