/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains as a physics: contacts between grains and with walls, and the integrator that moves the grains.
 * `self` is the simulation, which still holds the parts of grains. Read physics.h first. */
#include "engine/grains.h"
#include "engine/deform.h"
#include "engine/guards.h"
#include "engine/limit.h"
#include "particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <string.h>

static void servo(const struct physics_context *context) {
    struct simulation *s = context->self;
    double part[WALLS_MAX][6];
    walls_forces(s->grains.walls, part);
    static_assert(sizeof s->grains.push[0] == 4 * sizeof(double), "doubles alone are summed");
    for (int w = 0; w < walls_count(s->grains.walls); w++) {
        memcpy(s->grains.push[w].force, part[w], sizeof s->grains.push[w].force);
        s->grains.push[w].impedance = *walls_impedance(s->grains.walls, w);
    }
    comm_sum(s->comm, s->grains.push[0].force, 4 * walls_count(s->grains.walls));
}

/* The largest squared speed relative to the mean flow, and at least `least`, which may be no number. */
static double speed_from_flow(const struct simulation *s, size_t first, size_t last, double least) {
    for (size_t i = first; i < last; i++) {
        double v2 = skin_speed2(&s->box, &s->particles->state[i], s->clock.dt);
        least = v2 > least ? v2 : least;
    }
    return least;
}

/* A speed that is not a number is kept, so that the guards find it. */
static void advance(const struct physics_context *context, int thread, size_t first, size_t last,
                    int size_class) {
    struct simulation *s = context->self;
    if (s->classes.kind[size_class] != KIND_GRAIN)
        return;
    struct particles particles = *s->particles;
    if (s->grains.contact.ring) /* rows of one grain of the sweep */
        particles.force +=
            s->grains.contact.ring->shift[first / SWEEP_GRAIN] * (ptrdiff_t)particles.force_stride;
    double v2 = integrator_advance(&particles, &s->grains.motion, first, last);
    if (s->box.motion.moves)
        v2 = speed_from_flow(s, first, last, 0 * v2);
    double *largest = &s->grains.speed[thread][size_class];
    if (!isnan(*largest) && !(v2 <= *largest))
        *largest = v2;
}

static void move_walls(const struct physics_context *context) {
    struct simulation *s = context->self;
    double before = s->clock.time_base + (double)(s->clock.step - 1 - s->clock.step_base) * s->clock.dt;
    walls_advance(s->grains.walls, before, s->clock.dt,
                  walls_have_servo(s->grains.walls) ? s->grains.push : NULL);
}

static void move_flow(const struct physics_context *context) {
    deform_flow(context->self);
}

static void move_box(const struct physics_context *context) {
    deform_advance(context->self);
}

static void follow_stress(const struct physics_context *context) {
    deform_control(context->self);
}

static void contact(const struct physics_context *context, int thread, int block) {
    struct simulation *s = context->self;
    force_loop_block(s->grains.loop, &s->grains.contact, thread, block);
}

static void contact_abandon(const struct physics_context *context) {
    struct simulation *s = context->self;
    force_loop_abandon(s->grains.loop, &s->grains.contact);
}

static void wall(const struct physics_context *context, int thread) {
    struct simulation *s = context->self;
    walls_force_share(s->grains.walls, &s->grains.contact, thread);
}

/* Sums the forces on walls without rounding; rank 0 gets the sum over all ranks. */
static void walls_agree(struct simulation *s) {
    int count;
    int64_t *words = walls_exact(s->grains.walls, &count);
    if (!s->ranks.alone)
        comm_sum_int(s->comm, words, count);
    walls_close(s->grains.walls, s->grains.contact.dt, s->comm->rank == 0);
}

static void finish(const struct physics_context *context) {
    struct simulation *s = context->self;
    s->grains.sums = (struct force_sums){0};
    force_loop_finish(s->grains.loop, &s->grains.contact, &s->grains.sums);
    if (s->grains.walls)
        walls_finish(s->grains.walls, &s->grains.contact, &s->grains.sums);
    if (s->grains.walls && s->scene->reproducible)
        walls_agree(s);
    s->grains.taken += s->grains.sums.taken;
}

static bool needs_contacts(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return s->grains.law.materials > 0 && !s->grains.law.options.solved;
}

static bool needs_servo(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return needs_contacts(context) && s->grains.walls && walls_have_servo(s->grains.walls);
}

static bool needs_walls(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return needs_contacts(context) && s->grains.walls;
}

static bool needs_motion(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return s->grains.walls && walls_move(s->grains.walls);
}

static bool needs_stress(const struct physics_context *context) {
    return context->scene->stress_given;
}

static bool needs_box(const struct physics_context *context) {
    return context->box->motion.moves;
}

static const struct physics_pass passes[] = {
    {.name = "servo",
     .why = "a wall driven to a force or a pressure",
     .stage = PASS_FIRST,
     .timer = "comm",
     .needed = needs_servo,
     .whole = servo},
    {.name = "flow",
     .why = "a box that moves",
     .stage = PASS_FIRST,
     .timer = "advance",
     .writes = "velocity",
     .needed = needs_box,
     .whole = move_flow},
    {.name = "advance",
     .does = "kick and drift",
     .stage = PASS_MOVE,
     .reads = "force inverse_mass",
     .writes = "position velocity",
     .rows = advance},
    {.name = "box",
     .why = "a box that moves",
     .stage = PASS_MOVED,
     .timer = "advance",
     .needed = needs_box,
     .whole = move_box},
    {.name = "walls",
     .why = "walls that move",
     .stage = PASS_MOVED,
     .timer = "wall",
     .needed = needs_motion,
     .whole = move_walls},
    {.name = "contact",
     .does = "particle forces",
     .stage = PASS_PAIRS,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .why = "materials",
     .needed = needs_contacts,
     .block = contact,
     .abandon = contact_abandon},
    {.name = "wall",
     .does = "wall forces and motion of walls",
     .why = "walls",
     .stage = PASS_SHARES,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .at_end = true,
     .needed = needs_walls,
     .share = wall},
    {.name = "finish",
     .why = "materials",
     .stage = PASS_CLOSE,
     .timer = "contact",
     .writes = "force",
     .at_end = true,
     .needed = needs_contacts,
     .whole = finish},
    {.name = "stress",
     .why = "a box that follows its stress",
     .stage = PASS_CLOSE,
     .timer = "comm",
     .needed = needs_stress,
     .whole = follow_stress},
};

static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    bool grains = kind_a == KIND_GRAIN && kind_b == KIND_GRAIN;
    return grains ? law_range(context, radius_a, radius_b) : -INFINITY;
}

static bool rests(const struct physics_context *context) {
    return !needs_contacts(context);
}

/* The cut-off of the walk is one number: the largest range. */
static void rebuilt(const struct physics_context *context) {
    struct simulation *s = context->self;
    const struct classes_range reach = {.of = range, .context = context->options};
    s->grains.contact.range = 0;
    for (int a = 0; a < s->classes.count; a++)
        for (int b = 0; b <= a; b++)
            s->grains.contact.range =
                fmax(s->grains.contact.range, classes_range_of(&s->classes, &reach, a, b));
    force_loop_prepare(s->grains.loop, &s->grains.contact);
}

static double limit(const struct physics_context *context, double most) {
    return needs_contacts(context) && isfinite(most) ? limit_of_contacts(context->self, most) : most;
}

static void guard(const struct physics_context *context, struct error *error) {
    (void)error; /* the same as the error of the simulation */
    guards_check(context->self);
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct simulation *s = context->self;
    restart_add(list, RESTART_SUM, false, &s->grains.taken, "energy taken by contacts");
    bool servo = s->grains.walls && walls_have_servo(s->grains.walls);
    for (int w = 0; servo && w < walls_count(s->grains.walls); w++)
        restart_add(list, RESTART_SUM, true, walls_impedance(s->grains.walls, w), "wall %d: impedance", w);
}

const struct physics grains_physics = {.name = "grains",
                                       .interactions = 1,
                                       .interaction = {{.name = "contact", .range = range}},
                                       .passes = sizeof passes / sizeof passes[0],
                                       .pass = passes,
                                       .rebuilt = rebuilt,
                                       .rests = rests,
                                       .limit = limit,
                                       .guard = guard,
                                       .restart = restart};
