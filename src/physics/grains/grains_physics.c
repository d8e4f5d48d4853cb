/* SPDX-License-Identifier: BSD-3-Clause */
/* Grains as a physics: contacts between grains and with walls, and the integrator that moves the grains. Read grains.h
 * first. */
#include "physics/grains/grains_own.h"
#include "engine/report_part.h"
#include "engine/physics_set.h"
#include "physics/grains/walls/walls_free.h"
#include "kernel/pairs/skin.h"
#include "kernel/pairs/walk.h"
#include "kernel/particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <string.h>

/* Sums over ranks what the particles do to the walls that follow them. */
static void push_sum(const struct physics_context *context) {
    struct grains *grains = context->self;
    double part[WALLS_MAX][6];
    walls_forces(grains->walls, part);
    static_assert(sizeof grains->push[0] == 7 * sizeof(double), "doubles alone are summed");
    for (int w = 0; w < walls_count(grains->walls); w++) {
        memcpy(grains->push[w].force, part[w], sizeof grains->push[w].force);
        memcpy(grains->push[w].torque, part[w] + 3, sizeof grains->push[w].torque);
        grains->push[w].impedance = *walls_impedance(grains->walls, w);
    }
    comm_sum(context->comm, grains->push[0].force, 7 * walls_count(grains->walls));
}

static void servo(const struct physics_context *context) {
    struct grains *grains = context->self;
    push_sum(context);
    for (int w = 0; w < walls_count(grains->walls); w++) {
        const double *f = grains->push[w].force;
        if (f[0] != 0 || f[1] != 0 || f[2] != 0)
            grains->pushed[w] = context->clock->step;
    }
}

/* The largest squared speed relative to the mean flow, and at least `least`, which may be no number. */
static double speed_from_flow(const struct physics_context *context, size_t first, size_t last,
                              double least) {
    for (size_t i = first; i < last; i++) {
        double v2 = skin_speed2(context->box, &context->particles->state[i], context->clock->dt);
        least = v2 > least ? v2 : least;
    }
    return least;
}

static double advance(const struct physics_context *context, int thread, size_t first, size_t last,
                      int size_class) {
    const struct grains *grains = context->self;
    (void)thread;
    if (context->classes->kind[size_class] != KIND_GRAIN)
        return 0;
    double v2 = integrator_advance(context->particles, &grains->motion, first, last);
    return context->box->motion.moves ? speed_from_flow(context, first, last, 0 * v2) : v2;
}

static void move_walls(const struct physics_context *context) {
    struct grains *grains = context->self;
    const struct clock *clock = context->clock;
    double before = clock_time(clock, clock->step - 1);
    walls_advance(grains->walls, before, clock->dt,
                  walls_follow_particles(grains->walls) ? grains->push : NULL);
}

static void contact(const struct physics_context *context, int thread, int block) {
    struct grains *grains = context->self;
    force_loop_block(grains->loop, &grains->contact, thread, block);
}

static void contact_abandon(const struct physics_context *context) {
    struct grains *grains = context->self;
    force_loop_abandon(grains->loop, &grains->contact);
}

static void wall(const struct physics_context *context, int thread) {
    struct grains *grains = context->self;
    walls_force_share(grains->walls, &grains->contact, thread);
}

/* Sums the forces on walls without rounding; rank 0 gets the sum over all ranks. */
static void walls_agree(const struct physics_context *context) {
    struct grains *grains = context->self;
    int count;
    int64_t *words = walls_exact(grains->walls, &count);
    if (context->comm->size > 1)
        comm_sum_int(context->comm, words, count);
    walls_close(grains->walls, grains->contact.dt, context->comm->rank == 0);
}

static void finish(const struct physics_context *context) {
    struct grains *grains = context->self;
    grains->sums = (struct force_sums){0};
    force_loop_finish(grains->loop, &grains->contact, &grains->sums);
    if (grains->walls)
        walls_finish(grains->walls, &grains->contact, &grains->sums);
    if (grains->walls && context->scene->reproducible)
        walls_agree(context);
    grains->taken += grains->sums.taken;
}

static bool needs_advance(const struct physics_context *context) {
    return context->moves_grains;
}

static bool needs_contacts(const struct physics_context *context) {
    return context->moves_grains && grains_touch(context) && !grains_solved(context);
}

static bool needs_servo(const struct physics_context *context) {
    const struct grains *grains = context->self;
    return grains_touch(context) && grains->walls && walls_follow_particles(grains->walls);
}

static bool needs_walls(const struct physics_context *context) {
    return needs_contacts(context) && grains_walls(context);
}

static bool needs_motion(const struct physics_context *context) {
    const struct grains *grains = context->self;
    return grains->walls && walls_move(grains->walls);
}

static const struct physics_pass passes[] = {
    {.name = "servo",
     .why = "a wall that is free, or driven to a force or a pressure",
     .place = PASS_FIRST,
     .timer = "comm",
     .needed = needs_servo,
     .whole = servo},
    {.name = "advance",
     .does = "kick and drift",
     .place = PASS_MOVE,
     .reads = "force inverse_mass",
     .writes = "position velocity",
     .needed = needs_advance,
     .rows = advance},
    {.name = "walls",
     .why = "walls that move",
     .place = PASS_MOVED,
     .timer = "wall",
     .needed = needs_motion,
     .whole = move_walls},
    {.name = "contact",
     .does = "particle forces",
     .place = PASS_PAIRS,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .why = "materials",
     .needed = needs_contacts,
     .block = contact,
     .abandon = contact_abandon},
    {.name = "wall",
     .does = "wall forces and motion of walls",
     .why = "walls",
     .place = PASS_SHARES,
     .reads = "position velocity radius inverse_mass",
     .writes = "force",
     .needed = needs_walls,
     .share = wall},
    {.name = "finish",
     .why = "materials",
     .place = PASS_CLOSE,
     .timer = "contact",
     .writes = "force",
     .needed = needs_contacts,
     .whole = finish},
};

static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    bool grains = kind_a == KIND_GRAIN && kind_b == KIND_GRAIN;
    return grains ? law_range(context, radius_a, radius_b) : -INFINITY;
}

static bool rests(const struct physics_context *context) {
    return !needs_contacts(context);
}

/* True if a physics says that the pair has no contact; `set` as context of struct force_context. */
static bool joined(const void *set, size_t i, size_t j) {
    PHYSICS_EACH (active, set, joints) {
        const struct physics_joints *joints = active->row->joints;
        if (joints->joins(&active->context) && joints->joined(&active->context, i, j))
            return true;
    }
    return false;
}

/* True if a physics has the contacts of a particle with walls. */
static bool alone(const void *set, size_t i) {
    PHYSICS_EACH (active, set, joints) {
        const struct physics_joints *joints = active->row->joints;
        if (joints->alone && joints->joins(&active->context) && joints->alone(&active->context, i))
            return true;
    }
    return false;
}

static bool may_join(const struct physics_set *set) {
    bool joins = false;
    PHYSICS_EACH (active, set, joints)
        joins = joins || active->row->joints->joins(&active->context);
    return joins;
}

/* The cut-off of the walk is one number: the largest range. */
static void rebuilt(const struct physics_context *context) {
    struct grains *grains = context->self;
    const struct classes_range reach = {.of = range, .context = context->options};
    grains->contact.range = 0;
    for (int a = 0; a < context->classes->count; a++)
        for (int b = 0; b <= a; b++)
            grains->contact.range =
                fmax(grains->contact.range, classes_range_of(context->classes, &reach, a, b));
    grains->contact.joined = may_join(context->set) ? joined : NULL;
    grains->contact.alone = may_join(context->set) ? alone : NULL;
    grains->contact.joined_context = context->set;
    if (grains->loop)
        force_loop_prepare(grains->loop, &grains->contact);
}

static double limit(const struct physics_context *context, double most) {
    return needs_contacts(context) && isfinite(most) ? limit_of_contacts(context, most) : most;
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct grains *grains = context->self;
    bool servo = grains->walls && walls_have_servo(grains->walls);
    restart_add(list, RESTART_SUM, false, &grains->taken, "energy taken by contacts");
    for (int w = 0; servo && w < walls_count(grains->walls); w++)
        restart_add(list, RESTART_SUM, true, walls_impedance(grains->walls, w), "wall %d: impedance", w);
    grains->wall_work = grains->walls ? walls_work(grains->walls) : 0;
    restart_add(list, RESTART_SUM, false, &grains->wall_work, "work of walls");
    for (int w = 0; w < context->scene->walls; w++) {
        double *power = walls_surface_power(grains->walls, w);
        if (power)
            restart_add(list, RESTART_SUM, true, power, "surface %s", context->scene->wall[w].name);
        double *number;
        int numbers = walls_free_numbers(grains->walls, w, &number);
        for (int k = 0; k < numbers; k++)
            restart_add(list, RESTART_REAL, true, &number[k], "free %d %s", k, context->scene->wall[w].name);
    }
}

static void prepare(const struct physics_context *context) {
    struct grains *grains = context->self;
    const struct evaluation *evaluation = context->evaluation;
    grains->motion.dt = context->set->mover->row->mover->stagger ? context->clock->dt : 0;
    grains->contact.list = context->list[0];
    grains->contact.dt = evaluation->dt;
    grains->contact.want_virial = evaluation->virial;
    grains->contact.want_sums = evaluation->sums || evaluation->virial || grains->contact.want_work;
}

static void stagger(const struct physics_context *context, double dt) {
    const struct grains *grains = context->self;
    struct kind_span all = {0, context->particles->owned};
    struct integrator_context motion = grains->motion;
    if (kinds_of(context->particles))
        all = kinds_span(context->particles, context->classes, KIND_GRAIN);
    motion.dt = dt;
    size_t count = dt != 0 ? all.end - all.first : 0, threads = (size_t)context->threads;
#pragma omp parallel for schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        integrator_stagger(context->particles, &motion, all.first + count * t / threads,
                           all.first + count * (t + 1) / threads);
    if (grains->walls && walls_have_free(grains->walls)) {
        push_sum(context);
        walls_stagger(grains->walls, grains->push, dt, context->clock->dt);
    }
}

/* Free walls at the full step. */
static void full_step(const struct physics_context *context) {
    struct grains *grains = context->self;
    if (grains->walls == NULL || !walls_have_free(grains->walls))
        return;
    push_sum(context);
    walls_full_step(grains->walls, grains->push, grains->motion.dt);
}

/* Free walls, which each rank knows. */
static void energy(const struct physics_context *context, struct physics_energy *energy) {
    const struct grains *grains = context->self;
    if (grains->walls && context->comm->rank == 0)
        *energy = (struct physics_energy){.held = walls_energy(grains->walls),
                                          .taken = walls_taken(grains->walls),
                                          .play = walls_motion(grains->walls)};
}

static void begin(const struct physics_context *context) {
    struct grains *grains = context->self;
    grains->taken = 0;
    grains->stable.overlap_started = grains->sums.overlap_max;
    comm_max(context->comm, &grains->stable.overlap_started, 1);
}

static size_t contacts(const struct physics_context *context) {
    return ((const struct grains *)context->self)->sums.contact_sides;
}

/* Adds what the stress of grains that bodies carry has besides. */
static void stress_carried(const struct physics_context *context, struct exact exact[STRESS_SUMS],
                           double sum[STRESS_SUMS]) {
    const struct carried *carried = ((const struct grains *)context->self)->motion.carried;
    for (size_t i = 0; carried && i < context->particles->owned; i++) {
        double part[6] = {0};
        if (carried_by(context->particles)[i] < 0)
            continue;
        carried_stress(carried, context->particles, i, false, context->particles->state[i].v, part);
        for (int c = 0; c < 6 && exact; c++)
            exact_add(&exact[c], part[c]);
        for (int c = 0; c < 6 && !exact; c++)
            sum[c] += part[c];
    }
}

static void stress(const struct physics_context *context, struct exact exact[STRESS_SUMS],
                   double sum[STRESS_SUMS]) {
    static_assert((int)STRESS_SUMS == (int)FORCE_EXACT, "sums of the stress");
    struct grains *grains = context->self;
    stress_carried(context, exact, sum);
    if (exact) {
        for (int t = 0; t < context->threads; t++)
            for (int c = 0; c < STRESS_SUMS; c++)
                exact_join(&exact[c], &grains->exact[t].sum[c]);
        memset(grains->exact, 0, (size_t)context->threads * sizeof *grains->exact);
        return;
    }
    for (int c = 0; c < 6; c++)
        sum[c] += grains->sums.virial[c];
    sum[6] += grains->sums.elastic_normal;
}

static struct history *history(const struct physics_context *context) {
    return ((const struct grains *)context->self)->history;
}

static void view(const struct physics_context *context, struct output_view *view) {
    const struct grains *grains = context->self;
    view->motion = &grains->motion;
    view->walls = grains->walls;
    view->contact = &grains->contact;
    view->sums = &grains->sums;
    view->taken = grains->taken;
}

static void report(const struct physics_context *context, struct report_part *part) {
    const struct grains *grains = context->self;
    part->simd = grains->loop ? force_loop_kernel(grains->loop) : walk_level_name(walk_level(NULL));
    part->law = law_row_get(grains->law.options.normal)->name;
}

static const struct physics_mover mover = {.prepare = prepare,
                                           .begin = begin,
                                           .stagger = stagger,
                                           .expected = stable_find,
                                           .why = stable_why,
                                           .fraction = timestep_default_fraction,
                                           .contacts = contacts,
                                           .stress = stress,
                                           .energies = grains_energies,
                                           .history = history};
static const struct physics_shown shown = {
    .full_step = full_step, .view = view, .report = report, .notes = grains_notes, .seen = grains_notes_seen};

static const struct physics_search search = {
    .interactions = 1, .interaction = {{.name = "contact", .range = range}}, .rests = rests};
static const struct physics_limit limits = {.of = limit};

const struct physics grains_physics = {.name = "grains",
                                       .box_moves = true,
                                       .passes = sizeof passes / sizeof passes[0],
                                       .pass = passes,
                                       .check = start_simd,
                                       .destroy = start_end,
                                       .rebuilt = rebuilt,
                                       .guard = grains_guard,
                                       .energy = energy,
                                       .restart = restart,
                                       .shown = &shown,
                                       .mover = &mover,
                                       .obstacles = &grains_obstacles,
                                       .record = &grains_record,
                                       .search = &search,
                                       .limit = &limits};
