/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat as a physics: grains exchange heat over pairs and with walls, and warm up (engine/physics.h). Read heat.h
 * first.
 *
 * Explicit Euler steps: T(n+1) = T(n) + dt flow(n) / (m c). The flow is a sum over pairs like a force: it is
 * summed where forces are, sent back from copies with them, cleared when the temperature takes it. Where the contact radius
 * depends on what contacts remember, a pass after the forces adds what flows through contacts. */
#include "base/memory.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/material.h"
#include "physics/grains/grains.h"
#include "physics/grains/laws/law_grip.h"
#include "physics/heat/heat_fields.h"
#include "physics/heat/heat_own.h"
#include "physics/heat/heat_state.h"
#include "physics/heat/heat_work.h"
#include <math.h>
#include <string.h>

static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct heat_options *options = context;
    (void)radius_a, (void)radius_b;
    if (kind_a != KIND_GRAIN || kind_b != KIND_GRAIN)
        return -INFINITY;
    return options->gas.conductivity > 0.0 ? options->gas.distance : 0.0;
}

/* Refuses sections that leave a number open. */
static bool check(const struct physics_context *context, struct error *error) {
    const struct heat_options *o = context->options;
    const struct scene *scene = context->scene;
    char key[64];
    bool named[LAW_MATERIALS_MAX] = {false}, rest = false;
    if (scene->materials == 0)
        return scene_fail(scene, error, "heat", "needs `materials`: grains that touch");
    for (int k = 0; k < o->materials; k++) {
        bool *is = o->material[k].material < 0 ? &rest : &named[o->material[k].material];
        snprintf(key, sizeof key, "heat.materials[%d]", k);
        if (*is)
            return scene_fail(scene, error, key, "a second entry for the same material");
        *is = true;
    }
    for (int m = 0; m < scene->materials; m++)
        if (!named[m] && !rest)
            return scene_fail(
                scene, error, "heat.materials",
                "material '%s' is missing (an entry without `material` serves all that are not named)",
                scene->material[m].name);
    for (int k = 0; k < o->walls; k++)
        if (!heat_walls_suit(context, k, error))
            return false;
    if (o->gas.conductivity > 0 && !(o->gas.roughness < o->gas.distance))
        return scene_fail(scene, error, "heat.gas", "needs a roughness and a distance above the roughness");
    return true;
}

static void *create(const struct physics_context *context) {
    struct heat *heat = memory_allocate_zero(1, sizeof *heat, "heat");
    const struct heat_options *o = heat->options = context->options;
    heat->context = context;
    heat->narrow = 1.0 / cbrt(o->softening);
    for (int pass = 0; pass < 2; pass++) /* entries with a name go over the one without */
        for (int k = 0; k < o->materials; k++)
            for (int m = 0; m < context->scene->materials; m++)
                if (o->material[k].material == (pass ? m : -1)) {
                    heat->conductivity[m] = o->material[k].conductivity;
                    heat->capacity[m] = o->material[k].capacity;
                }
    heat_walls_read(heat);
    if (heat_walls_needed(context))
        walls_visit_fixed(grains_walls(context));
    heat->wall_power = memory_allocate_zero((size_t)context->threads, sizeof *heat->wall_power, "heat");
    heat->strange = memory_allocate_zero((size_t)context->threads, sizeof *heat->strange, "heat");
    heat->work = o->dissipation > 0.0 ? heat_work_create(context) : NULL;
    heat->walk = walk_create(&heat_pairs_client, context->threads);
    heat->pairs = (struct walk_work){.context = heat,
                                     .particles = context->particles,
                                     .stride = 1,
                                     .radii = true,
                                     .range = range(o, KIND_GRAIN, 0, KIND_GRAIN, 0),
                                     .ordered = context->ordered};
    if (law_grip_radius_recalls(grains_contact(context)->law)) {
        heat->contact_walk = walk_create(&heat_contacts_client, context->threads);
        heat->contacts = heat->pairs;
    }
    return heat;
}

static void destroy(void *self) {
    struct heat *heat = self;
    walk_destroy(&heat->walk);
    walk_destroy(&heat->contact_walk);
    heat_work_destroy(&heat->work);
    heat_walls_free(heat);
    memory_free(heat->strange);
    memory_free(heat->wall_power);
    memory_free(heat);
}

/* Grains that are new, and their copies, get the temperature of the start. */
static void begin(struct heat *heat, const struct particles *particles) {
    for (size_t i = 0; i < particles->owned + particles->ghosts; i++)
        if (isnan(heat->temperature[i]) && heat_has(particles, i))
            heat->temperature[i] = heat->options->temperature;
}

static void take_fields(struct heat *heat, const struct particles *particles) {
    heat->temperature = heat_temperature(particles);
    heat->flow = heat_flow(particles);
    heat->wall_flow = heat_wall_flow(particles);
    heat->material = material_numbers(particles);
    heat->pairs.target = heat->contacts.target = heat->flow;
}

/* Takes the list of contacts, and how far contacts with walls reach. */
static void take_contacts(struct heat *heat, const struct physics_context *context) {
    double radius = 0.0;
    for (int c = 0; c < context->classes->count; c++)
        if (context->classes->kind[c] == KIND_GRAIN)
            radius = fmax(radius, context->classes->radius_max[c]);
    heat->contacts.list = grains_contact(context)->list;
    heat->contacts.range = grains_contact(context)->range;
    heat->reach = radius > 0.0 ? fmax(law_range(grains_contact(context)->law, radius, INFINITY), 0.0) : 0.0;
    walk_prepare(heat->contact_walk, &heat->contacts);
}

static void rebuilt(const struct physics_context *context) {
    struct heat *heat = context->self;
    take_fields(heat, context->particles);
    begin(heat, context->particles);
    heat->pairs.list = context->list[0];
    walk_prepare(heat->walk, &heat->pairs);
    if (heat->contact_walk)
        take_contacts(heat, context);
    if (heat->work)
        heat_work_rebuilt(heat->work);
}

/* Takes the flow of the last step. */
static double warm(const struct physics_context *context, int thread, size_t first, size_t last,
                   int size_class) {
    struct heat *heat = context->self;
    double poison = 0.0; /* NaN once a temperature is not finite */
    if (context->classes->kind[size_class] != KIND_GRAIN)
        return 0.0;
    for (size_t i = first; i < last; i++) {
        double capacity = heat->capacity[material_of(heat->material, i)] * groups_mass(context->particles, i);
        heat->temperature[i] += context->clock->dt * heat->flow[i] / capacity;
        if (heat->work)
            heat->temperature[i] += heat->options->dissipation * heat_work_take(heat->work, i) / capacity;
        heat->flow[i] = heat->wall_flow[i] = 0.0;
        poison += 0.0 * heat->temperature[i];
    }
    for (size_t i = first; isnan(poison) && i < last; i++)
        if (!isfinite(heat->temperature[i]))
            heat->strange[thread] = 1 + context->particles->id[i];
    return 0.0;
}

/* A temperature that is not finite stops the run. */
static void guard(const struct physics_context *context, struct error *error) {
    const struct heat *heat = context->self;
    for (int t = 0; t < context->threads; t++)
        if (heat->strange[t] != 0)
            error_set(error, ERROR_PHYSICS,
                      "guards.nan: the temperature of particle %lld is not finite at step %llu, t = %.9g",
                      (long long)heat->strange[t] - 1, (unsigned long long)context->clock->step,
                      context->clock->time);
}

static void conduct(const struct physics_context *context, int thread, int block) {
    struct heat *heat = context->self;
    walk_block(heat->walk, &heat->pairs, thread, block);
}

static void abandon(const struct physics_context *context) {
    struct heat *heat = context->self;
    walk_abandon(heat->walk, &heat->pairs);
    memset(heat->flow, 0, (context->particles->owned + context->particles->ghosts) * sizeof *heat->flow);
}

static void finish(const struct physics_context *context) {
    struct heat *heat = context->self;
    walk_finish(heat->walk, &heat->pairs);
}

static bool needs_contacts(const struct physics_context *context) {
    return law_grip_radius_recalls(grains_contact(context)->law);
}

static void conduct_contacts(const struct physics_context *context) {
    struct heat *heat = context->self;
    walk_run(heat->contact_walk, &heat->contacts);
}

static bool needs_work(const struct physics_context *context) {
    return ((const struct heat_options *)context->options)->dissipation > 0.0;
}

static void dissipate(const struct physics_context *context) {
    const struct heat *heat = context->self;
    heat_work_finish(heat->work);
}

double heat_energy(const struct heat *heat, size_t i) {
    const struct particles *p = heat->context->particles;
    double energy = heat->capacity[material_of(heat->material, i)] * groups_mass(p, i) * heat->temperature[i];
    energy += heat->context->clock->dt * heat->flow[i];
    return heat->work ? energy + heat->options->dissipation * heat_work_lost(heat->work, i) : energy;
}

/* Puts the sums of H into the flows of the owned grains. */
static void conductances(const struct physics_context *context, struct heat *heat) {
    struct field_list fields = fields_one(heat_flow_field(context->particles));
    heat->conductance = true;
    walk_run(heat->walk, &heat->pairs);
    if (heat->contact_walk)
        walk_run(heat->contact_walk, &heat->contacts);
    for (int t = 0; heat_walls_needed(context) && t < context->threads; t++)
        heat_walls_share(context, t);
    heat->conductance = false;
    if (context->ghosts)
        ghosts_reverse(context->ghosts, context->particles, &fields);
}

/* Steps up to m c / sum of H are stable and monotonic: no grain gets hotter than its hottest neighbour. */
static double limit(const struct physics_context *context, double most) {
    struct heat *heat = context->self;
    const struct particles *p = context->particles;
    size_t all = p->owned + p->ghosts;
    if (context->list[0] == NULL || heat->pairs.list == NULL)
        return most;
    double *kept = memory_allocate(2 * all, sizeof *kept, "heat flows");
    memcpy(kept, heat->flow, all * sizeof *kept);
    memcpy(kept + all, heat->wall_flow, all * sizeof *kept);
    memset(heat->flow, 0, all * sizeof *kept);
    double(*power)[WALLS_MAX] = memory_allocate((size_t)context->threads, sizeof *power, "heat flows");
    memcpy(power, heat->wall_power, (size_t)context->threads * sizeof *power);
    conductances(context, heat);
    memcpy(heat->wall_power, power, (size_t)context->threads * sizeof *power);
    memory_free(power);
    for (size_t i = 0; i < p->owned; i++)
        if (heat_has(p, i) && heat->flow[i] > 0.0)
            most = fmin(most,
                        heat->capacity[material_of(heat->material, i)] * groups_mass(p, i) / heat->flow[i]);
    memcpy(heat->flow, kept, all * sizeof *kept);
    memcpy(heat->wall_flow, kept + all, all * sizeof *kept);
    memory_free(kept);
    comm_min(context->comm, &most, 1);
    return most;
}

static const struct physics_pass passes[] = {
    {.name = "warm",
     .does = "temperatures take the flow of heat",
     .place = PASS_MOVE,
     .reads = "heat_flow inverse_mass",
     .writes = "temperature",
     .rows = warm},
    {.name = "conduct",
     .does = "flow of heat between grains",
     .place = PASS_PAIRS,
     .reads = "position radius temperature",
     .writes = "heat_flow",
     .block = conduct,
     .abandon = abandon},
    {.name = "heat_walls",
     .why = "heat.walls",
     .does = "flow of heat from walls",
     .place = PASS_SHARES,
     .timer = "conduct",
     .reads = "position radius temperature",
     .writes = "heat_flow",
     .needed = heat_walls_needed,
     .share = heat_walls_share},
    {.name = "heat_finish", .place = PASS_CLOSE, .timer = "conduct", .writes = "heat_flow", .whole = finish},
    {.name = "heat_contacts",
     .why = "contacts whose radius depends on what they remember",
     .does = "flow of heat through contacts that remember their state",
     .place = PASS_CLOSE,
     .timer = "conduct",
     .reads = "position radius temperature",
     .writes = "heat_flow",
     .needed = needs_contacts,
     .whole = conduct_contacts},
    {.name = "dissipate",
     .why = "heat.dissipation",
     .does = "energy that contacts lose becomes heat",
     .place = PASS_CLOSE,
     .reads = "position radius",
     .writes = "heat_work",
     .needed = needs_work,
     .whole = dissipate}};

static const struct physics_search search = {.interactions = 1,
                                             .interaction = {{.name = "heat", .range = range}}};
static const struct physics_limit limits = {.of = limit};

const struct physics heat_physics = {.name = "heat",
                                     .box_moves = true,
                                     .passes = sizeof passes / sizeof passes[0],
                                     .pass = passes,
                                     .check = check,
                                     .create = create,
                                     .destroy = destroy,
                                     .rebuilt = rebuilt,
                                     .search = &search,
                                     .limit = &limits,
                                     .guard = guard};
