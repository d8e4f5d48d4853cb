/* SPDX-License-Identifier: BSD-3-Clause */
/* Drag as a physics: one pass adds drag and buoyancy to the forces on grains. Read drag.h and engine/physics.h first. */
#include "base/memory.h"
#include "physics/drag/drag.h"
#include "physics/drag/drag_own.h"
#include "physics/drag/drag_fields.h"
#include "physics/drag/drag_law.h"
#include "physics/drag/porosity.h"
#include "engine/physics.h"
#include "physics/drag/carrier.h"
#include "physics/bodies/bodies.h"
#include "physics/grains/motion/carried.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

struct drag {
    const struct drag_options *options; /* borrowed */
    const struct drag_law *law;
    double largest;
    bool resolved;             /* the section `fluid` has the fluid, else it is given */
    double density, viscosity; /* of the fluid */
    struct porosity *porosity; /* NULL: the law has none */
    double *given;             /* work on grains, by thread */
    double work;               /* since the start; energy */
    struct error error;        /* until the guard takes it */
};

double drag_largest(const struct scene *scene) {
    const struct drag_options *options = (const void *)scene->physics[PHYSICS_drag];
    struct carrier carrier;
    if (carrier_of(scene, &carrier))
        return carrier.largest;
    return isnan(options->largest) ? INFINITY : options->largest;
}

void drag_velocity(const struct drag *drag, double time, double velocity[3]) {
    const struct drag_fluid *fluid = &drag->options->fluid;
    for (int d = 0; d < 3; d++)
        velocity[d] = drag->resolved ? NAN : fluid->velocity[d] + time * fluid->acceleration[d];
}

double drag_density(const struct drag *drag) {
    return drag->density;
}

double drag_reach(const struct drag *drag) {
    return drag->largest;
}

double drag_work(const struct drag *drag) {
    return drag->work;
}

/* Grains meet within the support of the kernel; a wall has an infinite radius. */
static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    const struct drag_options *options = context;
    bool wall = isinf(radius_a) || isinf(radius_b);
    if (!drag_law_get(options->law)->porous || kind_a == KIND_BODY || kind_b == KIND_BODY)
        return -INFINITY;
    if (!wall && (kind_a != KIND_GRAIN || kind_b != KIND_GRAIN))
        return -INFINITY;
    return options->porosity.support - (isinf(radius_a) ? 0 : radius_a) - (isinf(radius_b) ? 0 : radius_b);
}

static bool check(const struct physics_context *context, struct error *error) {
    const struct drag_options *options = context->options;
    if (drag_law_get(options->law)->porous && context->box->dimension != 3)
        return scene_fail(context->scene, error, "drag.law",
                          "a law with a porosity needs a box of three dimensions; allowed in two: stokes, "
                          "schiller_naumann");
    const struct scene *scene = context->scene;
    if (drag_law_get(options->law)->porous && scene->physics_given[PHYSICS_bodies] &&
        ((const struct bodies_options *)(const void *)scene->physics[PHYSICS_bodies])->rocks > 0)
        return scene_fail(scene, error, "drag.law",
                          "a porosity is a sum over spheres; allowed with rocks (bodies.shapes): stokes, "
                          "schiller_naumann");
    struct carrier carrier;
    bool resolved = carrier_of(context->scene, &carrier);
    if (resolved && options->fluids > 0)
        return scene_fail(
            context->scene, error, "drag.fluid",
            "the section `fluid` has the fluid of grains up to fluid.grains.unresolved; allowed "
            "beside that key: no drag.fluid");
    if (resolved && !isnan(options->largest))
        return scene_fail(context->scene, error, "drag.largest",
                          "fluid.grains.unresolved says which grains feel drag; allowed beside that key: no "
                          "drag.largest");
    if (!resolved && options->fluids > 0 && context->scene->physics_given[PHYSICS_fluid])
        return scene_fail(
            context->scene, error, "drag.fluid",
            "is a second fluid beside the section `fluid`, which moves the grains itself; allowed beside it: "
            "fluid.grains.unresolved, and no drag.fluid");
    if (!resolved && options->fluids == 0)
        return scene_fail(
            context->scene, error, "drag.fluid",
            "is missing; allowed to be left out: with fluid.grains.unresolved, which lets the fluid of "
            "the section `fluid` move the grains");
    return true;
}

static void *create(const struct physics_context *context) {
    struct drag *drag = memory_allocate_zero(1, sizeof *drag, "drag");
    drag->options = context->options;
    drag->law = drag_law_get(drag->options->law);
    struct carrier carrier = {drag->options->fluid.density, drag->options->fluid.viscosity, INFINITY};
    drag->largest = drag_largest(context->scene);
    drag->resolved = carrier_of(context->scene, &carrier);
    drag->density = carrier.density;
    drag->viscosity = carrier.viscosity;
    drag->given = memory_allocate_zero((size_t)context->threads, sizeof *drag->given, "drag");
    if (drag->law->porous)
        drag->porosity = porosity_create(context);
    return drag;
}

static void destroy(void *self) {
    struct drag *drag = self;
    porosity_destroy(&drag->porosity);
    memory_free(drag->given);
    memory_free(drag);
}

/* A kernel that is too narrow for the largest grains. */
static void support_check(const struct physics_context *context, struct drag *drag) {
    double radius = 0, support = drag->options->porosity.support;
    for (int c = 0; c < context->classes->count; c++)
        if (context->classes->kind[c] == KIND_GRAIN && context->classes->radius_min[c] <= drag->largest)
            radius = fmax(radius, fmin(context->classes->radius_max[c], drag->largest));
    if (support < POROSITY_SUPPORT_LEAST * radius && drag->error.kind == ERROR_NONE)
        scene_fail(context->scene, &drag->error, "drag.porosity.support",
                   "%g is too short for grains of radius %g; allowed: %g radii or more, %g, or a smaller "
                   "drag.largest",
                   support, radius, POROSITY_SUPPORT_LEAST, POROSITY_SUPPORT_LEAST * radius);
}

static void rebuilt(const struct physics_context *context) {
    struct drag *drag = context->self;
    if (drag->porosity == NULL)
        return;
    support_check(context, drag);
    porosity_rebuilt(drag->porosity);
}

static bool takes_part(const struct drag *drag, const struct particles *p, const uint8_t *kind, size_t i) {
    return p->state[i].radius <= drag->largest && (kind == NULL || kind[i] == KIND_GRAIN);
}

/* What grains see of the fluid of the section `fluid`; NULL: a fluid is given, or there are no lists yet, and no grain has seen it. */
static const double (*seen_of(const struct physics_context *context))[CARRIER_SEEN] {
    const struct drag *drag = context->self;
    return drag->resolved && context->list[0]
               ? (const double(*)[CARRIER_SEEN])carrier_seen(context->particles)
               : NULL;
}

/* K of grain i, which sees `seen`; `slip` becomes its superficial slip velocity. */
static double factor_of(const struct physics_context *context, size_t i, const double *seen, double slip[3]) {
    const struct drag *drag = context->self;
    const struct particle_state *state = &context->particles->state[i];
    const double *porosity = drag_porosity(context->particles);
    struct drag_case at = {
        .density = drag->density,
        .viscosity = drag->viscosity,
        .diameter = 2 * carried_solid_radius(context->particles, carried_solid(context->particles), i),
        .porosity = porosity ? porosity[i] : 1};
    double square = 0, moved = drag->resolved ? 1 : at.porosity, flow[3] = {0};
    drag_velocity(drag, context->clock->time, slip);
    if (drag->resolved) /* without slip K is least */
        memcpy(slip, seen ? seen : state->v, 3 * sizeof *slip);
    if (context->box->motion.moves) /* the fluid moves with the box, or an image would feel another drag */
        box_flow(context->box, state->x, flow);
    for (int d = 0; d < 3; d++) {
        slip[d] = d < context->box->dimension ? slip[d] - moved * (state->v[d] - flow[d]) : 0;
        square += slip[d] * slip[d];
    }
    at.speed = sqrt(square);
    return drag->law->factor(&at) * (seen ? seen[CARRIER_SHARE] : 1);
}

/* The forces on the grains of a thread. A force acts from half a step before to half a step after, so that its work is the
 * mean of its powers at both velocities: the first half is counted now, the second one when the next force is known. */
static void act(const struct physics_context *context, int thread) {
    struct drag *drag = context->self;
    struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    const double *gravity = context->scene->gravity, half = 0.5 * context->clock->dt,
                 *solid = carried_solid(p);
    double(*law)[3] = (double(*)[3])drag_force(p), (*taken)[4] = carrier_force(p), given = 0;
    const double(*seen)[CARRIER_SEEN] = seen_of(context);
    size_t first = p->owned * (size_t)thread / (size_t)context->threads;
    size_t last = p->owned * ((size_t)thread + 1) / (size_t)context->threads;
    for (size_t i = first; i < last; i++) {
        double slip[3], *force = p->force + i * (size_t)p->force_stride;
        if (!takes_part(drag, p, kind, i))
            continue;
        const double *v = p->state[i].v, *own = seen ? seen[i] : NULL;
        double factor = factor_of(context, i, own, slip), power = 0;
        double mass = drag->density * porosity_volume(carried_solid_radius(p, solid, i));
        for (int d = 0; d < context->box->dimension; d++) {
            double before = law[i][d], buoyancy = -mass * gravity[d];
            law[i][d] = factor * slip[d] + (own ? own[CARRIER_PUSH + d] : 0);
            force[d] += law[i][d] + buoyancy;
            power += (law[i][d] + buoyancy) * v[d];
            power += context->clock->step > 0 ? (before + buoyancy) * v[d] : 0;
        }
        for (int d = 0; drag->resolved && d < 4; d++)
            taken[i][d] = d < 3 ? law[i][d] : factor;
        given += p->state[i].inverse_mass > 0 ? half * power : 0;
    }
    drag->given[thread] = given;
}

static void add(const struct physics_context *context) {
    struct drag *drag = context->self;
    if (drag->porosity && context->clock->step % (uint64_t)drag->options->porosity.every == 0)
        porosity_sum(drag->porosity);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < context->threads; t++)
        act(context, t);
    for (int t = 0; t < context->threads; t++)
        drag->work += drag->given[t];
}

static void energy(const struct physics_context *context, struct physics_energy *energy) {
    energy->work = drag_work(context->self);
}

/* Within mass / K the slip of a grain changes no sign. */
static double limit(const struct physics_context *context, double most) {
    struct drag *drag = context->self;
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    const double(*seen)[CARRIER_SEEN] = seen_of(context);
    double slip[3];
    if (drag->porosity && context->list[0] == NULL)
        return most;
    if (drag->porosity && context->clock->step == 0)
        porosity_sum(drag->porosity);
    for (size_t i = 0; i < p->owned; i++)
        if (takes_part(drag, p, kind, i) && p->state[i].inverse_mass > 0)
            most = fmin(most,
                        1 / (p->state[i].inverse_mass * factor_of(context, i, seen ? seen[i] : NULL, slip)));
    comm_min(context->comm, &most, 1);
    return most;
}

static void guard(const struct physics_context *context, struct error *error) {
    const struct drag *drag = context->self;
    if (error->kind == ERROR_NONE)
        *error = drag->error;
}

static void print(const struct physics_context *context, FILE *file) {
    const struct drag *drag = context->self;
    const struct drag_porosity *porosity = &drag->options->porosity;
    if (context->comm->rank > 0)
        return;
    fprintf(file, "\ndrag\n  law          %s: %s\n", drag->law->name, drag->law->summary);
    if (drag->law->porous)
        fprintf(file, "  porosity     within %.6g of a grain, every %d step%s\n", porosity->support,
                porosity->every, porosity->every == 1 ? "" : "s");
    if (isfinite(drag->largest))
        fprintf(file, "  grains       up to the radius %.6g\n", drag->largest);
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct drag *drag = context->self;
    restart_add(list, RESTART_SUM, true, &drag->work, "drag: work");
}

static const struct physics_pass pass = {.name = "drag",
                                         .place = PASS_CLOSE,
                                         .does = "drag and buoyancy of grains in a fluid, and porosity",
                                         .reads = "position velocity radius",
                                         .writes = "force drag_force porosity",
                                         .whole = add};
static const struct physics_search search = {.interactions = 1,
                                             .interaction = {{.name = "porosity", .range = range}}};
static const struct physics_limit limits = {.of = limit,
                                            .why = "drag: mass of a grain over its drag per speed"};

const struct physics drag_physics = {.name = "drag",
                                     .box_moves = true,
                                     .passes = 1,
                                     .pass = &pass,
                                     .check = check,
                                     .create = create,
                                     .destroy = destroy,
                                     .rebuilt = rebuilt,
                                     .energy = energy,
                                     .guard = guard,
                                     .print = print,
                                     .restart = restart,
                                     .search = &search,
                                     .limit = &limits};
