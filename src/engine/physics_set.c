/* SPDX-License-Identifier: BSD-3-Clause */
/* The physics of a run: finds the physics that the scene asks for, and calls them. Read physics.h first. */
#include "engine/physics_set.h"
#include "kernel/particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <string.h>

/* An entry of the tables of physics. */
struct physics_entry {
    const struct physics *physics;
    void (*fields)(struct particles *particles);
    const char *key;
    bool (*start)(struct physics_context *context, struct error *error); /* of those that are always there */
};

#define PHYSICS_ENTRY(name, key, whose, summary) {&name##_physics, name##_fields, #key, NULL},
#define PHYSICS_ENTRY_ALWAYS(name) {&name##_physics, NULL, #name, name##_start},
static const struct physics_entry entries[PHYSICS_ALL] = {PHYSICS_TABLE(PHYSICS_ENTRY)
                                                              PHYSICS_ALWAYS(PHYSICS_ENTRY_ALWAYS)};

const struct physics *physics_get(enum physics_number number) {
    return entries[number].physics;
}

const char *physics_key(enum physics_number number) {
    return entries[number].key;
}

const struct physics_active *physics_next(const struct physics_set *set, const struct physics_active *before,
                                          size_t member) {
    const struct physics_active *active = before ? before + 1 : set->active;
    for (; active < set->active + set->count; active++) {
        void *value; /* NULL of all bits 0, as that of a function */
        memcpy(&value, (const char *)active->row + member, sizeof value);
        if (value)
            return active;
    }
    return NULL;
}

static void activate(struct physics_set *set, int number, const struct physics_context *context) {
    const struct physics *row = entries[number].physics;
    struct physics_active *active = &set->active[set->count++];
    *active = (struct physics_active){
        .row = row, .number = number, .context = *context, .first = set->interactions->count};
    active->context.set = set;
    if (row->maker && row->maker->moving)
        set->interactions->moving |= row->maker->moving(context->options);
    for (int k = 0; row->search && k < row->search->interactions; k++) {
        struct interaction interaction = row->search->interaction[k];
        interaction.context = context->options;
        interactions_add(set->interactions, &interaction);
    }
}

/* Finds who moves the grains, and who has what they meet. */
static bool roles_find(struct physics_set *set, struct error *error) {
    set->mover = set->obstacles = NULL;
    PHYSICS_EACH (active, set, mover) {
        const struct physics_active *mover = set->mover;
        if (mover && mover->number < PHYSICS_COUNT)
            return scene_fail(active->context.scene, error, entries[active->number].key,
                              "does not go with %s: both move the grains", entries[mover->number].key);
        set->mover = active;
    }
    for (int k = 0; k < set->count; k++)
        set->active[k].context.moves_grains = &set->active[k] == set->mover;
    PHYSICS_EACH (active, set, obstacles)
        set->obstacles = active;
    return true;
}

bool physics_begin(struct physics_set *set, const struct physics_context *context,
                   struct interactions *interactions, struct error *error) {
    const struct scene *scene = context->scene;
    set->count = 0;
    set->interactions = interactions;
    for (int k = PHYSICS_COUNT; k < PHYSICS_ALL; k++) {
        struct physics_context own = *context;
        bool good = entries[k].start(&own, error);
        activate(set, k, &own);
        if (!good)
            return false;
    }
    for (int k = 0; k < PHYSICS_COUNT; k++) {
        struct physics_context own = *context;
        if (scene->physics_given[k] == 0)
            continue;
        if (physics_has_particles(k))
            kinds_register(context->particles);
        entries[k].fields(context->particles);
        own.options = scene->physics[k];
        activate(set, k, &own);
    }
    return roles_find(set, error);
}

/* Refuses a physics that does not know a box that moves. */
static bool suits_box(const struct physics_active *active, struct error *error) {
    return !active->context.box->motion.moves || active->row->box_moves ||
           scene_fail(active->context.scene, error, entries[active->number].key,
                      "does not go with a box that moves (box.shear, box.strain, box.stress)");
}

bool physics_create(struct physics_set *set, struct error *error) {
    for (int k = 0; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        if (!suits_box(active, error))
            return false;
        if (active->row->check && !active->row->check(&active->context, error))
            return false;
        if (active->row->create)
            active->context.self = active->row->create(&active->context);
        const struct physics_search *search = active->row->search;
        for (int i = 0; search && search->range_of_self && i < search->interactions; i++)
            set->interactions->row[active->first + i].context = active->context.self;
    }
    return true;
}

void physics_own(const struct physics_set *set, const void *own[PHYSICS_COUNT]) {
    memset(own, 0, PHYSICS_COUNT * sizeof *own);
    for (int k = 0; k < set->count; k++)
        if (set->active[k].number < PHYSICS_COUNT)
            own[set->active[k].number] = set->active[k].context.self;
}

/* The last first, as others use what grains have. */
void physics_free(struct physics_set *set) {
    for (int k = set->count - 1; k >= 0; k--)
        if (set->active[k].context.self)
            set->active[k].row->destroy(set->active[k].context.self);
    set->count = 0;
}

bool physics_fill(const struct physics_set *set, const struct physics_share *share, struct error *error) {
    PHYSICS_EACH (active, set, maker)
        if (!active->row->maker->fill(&active->context, share, error))
            return false;
    return true;
}

/* The part that a physics makes. */
static bool part_made(const struct physics_set *set, const struct physics_grain *grain, int number,
                      struct physics_part *part) {
    PHYSICS_EACH (active, set, maker)
        if (active->row->maker->part && active->row->maker->part(&active->context, grain, number, part))
            return true;
    return false;
}

bool physics_part(const struct physics_set *set, const struct physics_grain *grain, int number,
                  struct physics_part *part) {
    struct physics_part first;
    struct physics_grain any = *grain;
    any.variant = -1;
    if (part_made(set, grain, number, part))
        return true;
    if (number > 0 || grain->variant > 0 || part_made(set, &any, 0, &first))
        return false;
    *part = (struct physics_part){grain->radius, particles_sphere_mass(grain->radius, grain->density),
                                  grain->radius};
    return true;
}

int64_t physics_parts(const struct physics_set *set, const struct physics_grain *grain) {
    struct physics_part part;
    int count = 0;
    while (part_made(set, grain, count, &part))
        count++;
    return count;
}

double physics_mass(const struct physics_set *set, const struct physics_grain *grain) {
    struct physics_part part;
    double mass = 0;
    for (int k = 0; physics_part(set, grain, k, &part); k++)
        mass += part.mass;
    return mass;
}

double physics_edge(const struct physics_set *set, int material, double radius) {
    double least = INFINITY;
    PHYSICS_EACH (active, set, maker)
        if (active->row->maker->edge)
            least = fmin(least, active->row->maker->edge(&active->context, material, radius));
    return least;
}

void physics_join(const struct physics_set *set, size_t k, int64_t first_id) {
    PHYSICS_EACH (active, set, maker)
        if (active->row->maker->join)
            active->row->maker->join(&active->context, k, first_id);
}

bool physics_admit(const struct physics_set *set, const struct physics_grain *grain, struct error *error) {
    PHYSICS_EACH (active, set, maker)
        if (active->row->maker->admit && !active->row->maker->admit(&active->context, grain, error))
            return false;
    return true;
}

void physics_lists(struct physics_set *set, const struct interactions *interactions) {
    for (int k = 0; k < set->count; k++)
        for (int i = 0; set->active[k].row->search && i < set->active[k].row->search->interactions; i++)
            set->active[k].context.list[i] = interaction_list(interactions, set->active[k].first + i);
}

void physics_prepare(const struct physics_set *set) {
    PHYSICS_EACH (active, set, mover)
        if (active->row->mover->prepare)
            active->row->mover->prepare(&active->context);
}

bool physics_rebuilt(struct physics_set *set, struct ghosts *ghosts) {
    bool again = false;
    for (int k = 0; k < set->count; k++) {
        struct physics_active *active = &set->active[k];
        const struct physics_rows *rows = active->row->rows;
        active->context.ghosts = ghosts;
        if (active->row->rebuilt)
            active->row->rebuilt(&active->context);
        if (rows && rows->again)
            again = rows->again(&active->context) || again;
    }
    return again;
}

bool physics_rests(const struct physics_set *set) {
    bool rests = true;
    PHYSICS_EACH (active, set, search)
        rests = rests && active->row->search->rests && active->row->search->rests(&active->context);
    return rests;
}

bool physics_due(const struct physics_set *set) {
    bool due = false;
    PHYSICS_EACH (active, set, rows)
        due = due || (active->row->rows->due && active->row->rows->due(&active->context));
    return due;
}

void physics_rows(const struct physics_set *set, struct history_rows *rows[PHYSICS_COUNT]) {
    memset(rows, 0, PHYSICS_COUNT * sizeof *rows);
    PHYSICS_EACH (active, set, rows) {
        assert(active->number < PHYSICS_COUNT);
        rows[active->number] = active->row->rows->of(&active->context);
        if (rows[active->number] && active->row->rows->components > 0)
            rows[active->number]->components = active->row->rows->components;
    }
}

void physics_energies(const struct physics_set *set, struct physics_energy *energy) {
    *energy = (struct physics_energy){0};
    PHYSICS_EACH (active, set, energy) {
        struct physics_energy own = {0};
        active->row->energy(&active->context, &own);
        energy->held += own.held;
        energy->taken += own.taken;
        energy->work += own.work;
        energy->play += own.play;
    }
}

bool physics_meets(const struct physics_set *set) {
    return set->obstacles && set->obstacles->row->obstacles->needed(&set->obstacles->context);
}

void physics_full_step(const struct physics_set *set) {
    PHYSICS_EACH (active, set, shown)
        if (active->row->shown->full_step)
            active->row->shown->full_step(&active->context);
}

void physics_look(const struct physics_set *set) {
    physics_full_step(set);
    for (int k = 0; k < set->count; k++) {
        const struct physics_active *active = &set->active[k];
        for (int p = 0; p < active->row->passes; p++) {
            const struct physics_pass *pass = &active->row->pass[p];
            if (pass->place == PASS_LOOK && (pass->needed == NULL || pass->needed(&active->context)))
                pass->whole(&active->context);
        }
    }
}

double physics_limit(const struct physics_set *set, double most, bool again) {
    PHYSICS_EACH (active, set, limit)
        if (!again || !active->row->limit->stays)
            most = fmin(most, active->row->limit->of(&active->context, most));
    return most;
}

const char *physics_limit_why(const struct physics_set *set, double limit) {
    const char *why = NULL;
    PHYSICS_EACH (active, set, limit)
        if (active->row->limit->of(&active->context, INFINITY) <= limit)
            why = active->row->limit->why;
    return why;
}

void physics_restart(const struct physics_set *set, struct restart *restart) {
    PHYSICS_EACH (active, set, restart)
        active->row->restart(&active->context, restart);
}

int64_t physics_contact_sides(const struct physics_set *set) {
    const struct physics_mover *mover = set->mover->row->mover;
    return mover->contacts ? (int64_t)mover->contacts(&set->mover->context) : 0;
}

bool physics_occupied(const struct physics_set *set, const double x[3], double radius) {
    const struct physics_active *obstacles = set->obstacles;
    return obstacles && obstacles->row->obstacles->taken(&obstacles->context, x, radius);
}
