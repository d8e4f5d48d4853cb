/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains as a physics: contacts between them and with walls, and the integrator that moves them. Its self is the
 * simulation, whose parts are still those of grains. Read physics.h first. */
#include "engine/grains.h"
#include "engine/guards.h"
#include "engine/limit.h"
#include "particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <string.h>

static void servo(const struct physics_context *context) {
    struct simulation *s = context->self;
    double part[WALLS_MAX][6];
    walls_forces(s->walls, part);
    for (int w = 0; w < walls_count(s->walls); w++)
        memcpy(s->servo_force[w], part[w], sizeof s->servo_force[w]);
    comm_sum(s->comm, s->servo_force[0], 3 * walls_count(s->walls));
}

/* A speed that is no number stays: the guards look for it. */
static void advance(const struct physics_context *context, int thread, size_t first, size_t last,
                    int size_class) {
    struct simulation *s = context->self;
    double v2 = integrator_advance(s->particles, &s->motion, first, last);
    double *largest = &s->speed[thread][size_class];
    if (!isnan(*largest) && !(v2 <= *largest))
        *largest = v2;
}

static void move_walls(const struct physics_context *context) {
    struct simulation *s = context->self;
    double before = s->time_base + (double)(s->step - 1 - s->step_base) * s->dt;
    walls_advance(s->walls, before, s->dt, walls_have_servo(s->walls) ? s->servo_force : NULL);
}

static void contact(const struct physics_context *context, int thread, int block) {
    struct simulation *s = context->self;
    force_loop_block(s->loop, &s->contact, thread, block);
}

static void contact_abandon(const struct physics_context *context) {
    struct simulation *s = context->self;
    force_loop_abandon(s->loop, &s->contact);
}

static void wall(const struct physics_context *context, int thread) {
    struct simulation *s = context->self;
    walls_force_share(s->walls, &s->contact, thread);
}

/* Forces on walls summed without rounding: rank 0 gets those of all ranks. */
static void walls_agree(struct simulation *s) {
    int count;
    int64_t *words = walls_exact(s->walls, &count);
    if (!s->alone)
        comm_sum_int(s->comm, words, count);
    walls_close(s->walls, s->contact.dt, s->comm->rank == 0);
}

static void finish(const struct physics_context *context) {
    struct simulation *s = context->self;
    s->sums = (struct force_sums){0};
    force_loop_finish(s->loop, &s->contact, &s->sums);
    if (s->walls)
        walls_finish(s->walls, &s->contact, &s->sums);
    if (s->walls && s->scene->reproducible)
        walls_agree(s);
    s->taken += s->sums.taken;
}

static bool needs_servo(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return s->walls && walls_have_servo(s->walls);
}

static bool needs_walls(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return s->walls != NULL;
}

static bool needs_motion(const struct physics_context *context) {
    const struct simulation *s = context->self;
    return s->walls && walls_move(s->walls);
}

static const struct physics_pass passes[] = {
    {.name = "servo",
     .why = "a wall driven to a force",
     .stage = PASS_FIRST,
     .timer = "comm",
     .needed = needs_servo,
     .whole = servo},
    {.name = "advance",
     .stage = PASS_MOVE,
     .reads = "force inverse_mass",
     .writes = "position velocity",
     .rows = advance},
    {.name = "walls",
     .why = "walls that move",
     .stage = PASS_MOVED,
     .timer = "wall",
     .needed = needs_motion,
     .whole = move_walls},
    {.name = "contact",
     .stage = PASS_PAIRS,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .block = contact,
     .abandon = contact_abandon},
    {.name = "wall",
     .why = "walls",
     .stage = PASS_SHARES,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .needed = needs_walls,
     .share = wall},
    {.name = "finish", .stage = PASS_CLOSE, .timer = "contact", .writes = "force", .whole = finish},
};

static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    bool grains = kind_a == KIND_GRAIN && kind_b == KIND_GRAIN;
    return grains ? law_range(context, radius_a, radius_b) : -INFINITY;
}

/* The cut-off of the walk is one number: the largest range. */
static void rebuilt(const struct physics_context *context) {
    struct simulation *s = context->self;
    const struct classes_range reach = {range, context->options};
    s->contact.range = 0;
    for (int a = 0; a < s->classes.count; a++)
        for (int b = 0; b <= a; b++)
            s->contact.range = fmax(s->contact.range, classes_range_of(&s->classes, &reach, a, b));
    force_loop_prepare(s->loop, &s->contact);
}

static double limit(const struct physics_context *context, double most) {
    return limit_of_contacts(context->self, most);
}

static void guard(const struct physics_context *context, struct error *error) {
    (void)error; /* it is the simulation's */
    guards_check(context->self);
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct simulation *s = context->self;
    restart_add(list, RESTART_SUM, false, &s->taken, "energy taken by contacts");
}

const struct physics grains_physics = {.name = "grains",
                                       .interactions = 1,
                                       .interaction = {{.name = "contact", .range = range}},
                                       .passes = sizeof passes / sizeof passes[0],
                                       .pass = passes,
                                       .rebuilt = rebuilt,
                                       .limit = limit,
                                       .guard = guard,
                                       .restart = restart};
