/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat as a physics: grains exchange heat over pairs and with walls, and warm up (engine/physics.h). Read heat.h
 * first.
 *
 * Explicit Euler steps: T(n+1) = T(n) + dt flow(n) / (m c). The flow is a sum over pairs like a force: it is
 * summed where forces are, sent back from copies with them, cleared when the temperature takes it. */
#include "heat/heat.h"
#include "contact/material.h"
#include "core/memory.h"
#include "engine/physics.h"
#include "heat/fields.h"
#include "heat/heat_own.h"
#include "heat/heat_work.h"
#include "integrate/groups.h"
#include "pairs/walk.h"
#include "particles/kinds.h"
#include <math.h>
#include <string.h>

struct heat {
    const struct heat_options *options;
    const struct physics_context *context;
    struct walk *walk;
    struct walk_work pairs;
    double conductivity[LAW_MATERIALS_MAX], capacity[LAW_MATERIALS_MAX];
    double narrow;                           /* contact radius over that of the scene's grains */
    const struct heat_wall *wall[WALLS_MAX]; /* by wall; NULL: no heat */
    int wall_material[WALLS_MAX];
    double *temperature, *flow, *wall_flow; /* of the fields, since the last rebuild */
    const uint8_t *material;
    bool conductance;                /* sums of H instead of flows */
    struct heat_work *work;          /* NULL: dissipation makes no heat */
    double (*wall_power)[WALLS_MAX]; /* [thread][wall]: power into grains in the last step, W */
};

/* The power over one kelvin between bodies whose surfaces are `gap` apart (overlap: negative). */
static double conductance(const struct heat *heat, int a, int b, double radius, double gap) {
    const struct heat_gas *gas = &heat->options->gas;
    double k = heat->conductivity[a] + heat->conductivity[b], h = 0.0;
    if (gap < 0.0)
        h = 4.0 * heat->conductivity[a] * heat->conductivity[b] / k * heat->narrow * sqrt(-radius * gap);
    if (gas->conductivity > 0.0 && gap < gas->distance)
        h += 2.0 * M_PI * gas->conductivity * radius * log(gas->distance / fmax(gap, gas->roughness));
    return h;
}

static void compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct heat *heat = task->work->context;
    for (int k = 0; k < batch->padded; k++) {
        const double *d = batch->record[k], *r[2] = {batch->radius[0], batch->radius[1]};
        size_t i = batch->i[k], j = batch->j[k];
        double gap = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - d[3];
        double radius = r[0][k] * r[1][k] / (r[0][k] + r[1][k]);
        double h =
            conductance(heat, material_of(heat->material, i), material_of(heat->material, j), radius, gap);
        double over = heat->conductance ? 1.0 : heat->temperature[j] - heat->temperature[i];
        batch->out[0][k] = h * over;
        batch->out[1][k] = heat->conductance ? h : -h * over;
    }
}

static const struct walk_client client = {.name = "heat",
                                          .memory = sizeof(struct walk_batch),
                                          .scatter = WALK_VALUES,
                                          .values = 1,
                                          .compute = compute};

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
    for (int k = 0; k < o->walls; k++) {
        snprintf(key, sizeof key, "heat.walls[%d]", k);
        if (isnan(o->wall[k].temperature) == isnan(o->wall[k].flux))
            return scene_fail(scene, error, key, "needs one of temperature and flux");
        for (int before = 0; before < k; before++)
            if (o->wall[before].wall == o->wall[k].wall)
                return scene_fail(scene, error, key, "a second entry for wall '%s'",
                                  scene->wall[o->wall[k].wall].name);
    }
    if (o->gas.conductivity > 0 && !(o->gas.roughness < o->gas.distance))
        return scene_fail(scene, error, "heat.gas", "needs a roughness and a distance above the roughness");
    return true;
}

static bool needs_walls(const struct physics_context *context) {
    return context->walls && ((const struct heat_options *)context->options)->walls > 0;
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
    for (int k = 0; k < o->walls; k++)
        heat->wall[o->wall[k].wall] = &o->wall[k];
    for (int w = 0; w < context->scene->walls; w++)
        heat->wall_material[w] = context->scene->wall[w].material;
    if (needs_walls(context))
        walls_visit_fixed(context->walls);
    heat->wall_power = memory_allocate_zero((size_t)context->threads, sizeof *heat->wall_power, "heat");
    heat->work = o->dissipation > 0.0 ? heat_work_create(context) : NULL;
    heat->walk = walk_create(&client, context->threads);
    heat->pairs = (struct walk_work){.context = heat,
                                     .particles = context->particles,
                                     .stride = 1,
                                     .radii = true,
                                     .range = range(o, KIND_GRAIN, 0, KIND_GRAIN, 0),
                                     .ordered = context->ordered};
    return heat;
}

static void destroy(void *self) {
    struct heat *heat = self;
    walk_destroy(&heat->walk);
    heat_work_destroy(&heat->work);
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
    heat->pairs.target = heat->flow;
}

static void rebuilt(const struct physics_context *context) {
    struct heat *heat = context->self;
    take_fields(heat, context->particles);
    begin(heat, context->particles);
    heat->pairs.list = context->list[0];
    walk_prepare(heat->walk, &heat->pairs);
    if (heat->work)
        heat_work_rebuilt(heat->work);
}

/* Takes the flow of the last step. */
static void warm(const struct physics_context *context, int thread, size_t first, size_t last,
                 int size_class) {
    struct heat *heat = context->self;
    (void)thread;
    if (context->classes->kind[size_class] != KIND_GRAIN)
        return;
    for (size_t i = first; i < last; i++) {
        double capacity = heat->capacity[material_of(heat->material, i)] * groups_mass(context->particles, i);
        heat->temperature[i] += context->clock->dt * heat->flow[i] / capacity;
        if (heat->work)
            heat->temperature[i] += heat->options->dissipation * heat_work_take(heat->work, i) / capacity;
        heat->flow[i] = heat->wall_flow[i] = 0.0;
    }
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

/* A thread on its way through the grains near walls. */
struct at_walls {
    struct heat *heat;
    double *power; /* by wall */
};

/* A grain that touches a wall, or is near one: called by the one thread that has the grain. */
static void at_wall(void *self, const struct wall_place *place) {
    const struct at_walls *at = self;
    size_t i = place->particle;
    int wall = place->wall;
    double gap = place->gap;
    struct heat *heat = at->heat;
    const struct heat_wall *given = heat->wall[wall];
    double radius = heat->context->particles->state[i].radius, flow = 0.0;
    if (given == NULL)
        return;
    if (!isnan(given->temperature)) {
        flow = conductance(heat, material_of(heat->material, i), heat->wall_material[wall], radius, gap);
        flow *= heat->conductance ? 1.0 : given->temperature - heat->temperature[i];
    } else if (gap < 0.0 && !heat->conductance) {
        flow = given->flux * M_PI * radius * radius;
    }
    heat->flow[i] += flow;
    heat->wall_flow[i] += flow;
    at->power[wall] += flow;
}

static void at_walls(const struct physics_context *context, int thread) {
    struct heat *heat = context->self;
    struct at_walls at = {heat, heat->wall_power[thread]};
    memset(at.power, 0, sizeof heat->wall_power[thread]);
    walls_visit(context->walls, context->particles, thread, heat->pairs.range, at_wall, &at);
}

static void finish(const struct physics_context *context) {
    struct heat *heat = context->self;
    walk_finish(heat->walk, &heat->pairs);
}

static bool needs_work(const struct physics_context *context) {
    return ((const struct heat_options *)context->options)->dissipation > 0.0;
}

static void dissipate(const struct physics_context *context) {
    const struct heat *heat = context->self;
    heat_work_finish(heat->work);
}

double heat_wall_power(const struct heat *heat, int wall) {
    double power = 0.0;
    for (int t = 0; t < heat->context->threads; t++)
        power += heat->wall_power[t][wall];
    return power;
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
    for (int t = 0; needs_walls(context) && t < context->threads; t++)
        at_walls(context, t);
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
     .stage = PASS_MOVE,
     .reads = "heat_flow inverse_mass",
     .writes = "temperature",
     .rows = warm},
    {.name = "conduct",
     .does = "flow of heat between grains",
     .stage = PASS_PAIRS,
     .reads = "position radius temperature",
     .writes = "heat_flow",
     .block = conduct,
     .abandon = abandon},
    {.name = "heat_walls",
     .why = "heat.walls",
     .does = "flow of heat from walls",
     .stage = PASS_SHARES,
     .timer = "conduct",
     .reads = "position radius temperature",
     .writes = "heat_flow",
     .needed = needs_walls,
     .share = at_walls},
    {.name = "heat_finish", .stage = PASS_CLOSE, .timer = "conduct", .writes = "heat_flow", .whole = finish},
    {.name = "dissipate",
     .why = "heat.dissipation",
     .does = "energy that contacts lose becomes heat",
     .stage = PASS_CLOSE,
     .reads = "position radius",
     .writes = "heat_work",
     .needed = needs_work,
     .whole = dissipate}};

const struct physics heat_physics = {.name = "heat",
                                     .box_moves = true,
                                     .interactions = 1,
                                     .interaction = {{.name = "heat", .range = range}},
                                     .passes = sizeof passes / sizeof passes[0],
                                     .pass = passes,
                                     .check = check,
                                     .create = create,
                                     .destroy = destroy,
                                     .rebuilt = rebuilt,
                                     .limit = limit};
