/* SPDX-License-Identifier: BSD-3-Clause */
/* Hard contacts as a physics (engine/physics.h): joins the solver to the engine. hard_check.c has what they refuse. Read hard.h first. */
#include "base/memory.h"
#include "engine/notes.h"
#include "physics/grains/grains.h"
#include "engine/report_part.h"
#include "engine/physics_set.h"
#include "physics/hard/hard_state.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"

/* The longest step: a grain moves by this part of the smallest radius at the expected speed, and a free fall from rest by this
 * part of sqrt(r/g). The default step is a fraction of it (step.fraction). */
static const double move_most = 0.5, fall_most = 1.0 / 15.0;

static double range(const void *context, int kind_a, double radius_a, int kind_b, double radius_b) {
    (void)radius_a, (void)radius_b;
    return kind_a == KIND_GRAIN && kind_b == KIND_GRAIN ? ((const struct hard *)context)->solver.reach
                                                        : -INFINITY;
}

static size_t listed(const void *self, bool walls, struct force_contact **contacts) {
    const struct hard *hard = self;
    return hard_solver_list(&hard->solver, hard->context->particles, walls, contacts);
}

static void *create(const struct physics_context *context) {
    struct hard *hard = memory_allocate_zero(1, sizeof *hard, "hard contacts");
    struct hard_solver *solver = &hard->solver;
    const struct scene *scene = context->scene;
    hard->context = context;
    grains_contact(context)->solved = listed;
    grains_contact(context)->solver = hard;
    solver->comm = solver->newton.comm = context->comm;
    solver->newton.clumps = &solver->clumps;
    hard_rocks_create(&solver->rocks, context);
    solver->options = *(const struct hard_options *)context->options;
    solver->threads = context->threads;
    hard_terms_make(&solver->terms, context, &solver->options);
    hard_pairs_create(&solver->pairs, context->threads, solver->terms.resists);
    hard_contacts_create(&solver->contacts, context->threads);
    for (int w = 0; w < scene->walls; w++)
        hard->wall_material[w] = scene->wall[w].material;
    hard->sizes.smallest = INFINITY;
    return hard;
}

static void destroy(void *self) {
    struct hard *hard = self;
    hard_pairs_free(&hard->solver.pairs);
    hard_contacts_free(&hard->solver.contacts, hard->solver.threads);
    hard_problem_free(&hard->solver.problem);
    hard_border_free(&hard->solver.border);
    hard_clumps_free(&hard->solver.clumps);
    hard_rocks_free(&hard->solver.rocks);
    hard_newton_free(&hard->solver.newton);
    memory_free(hard->solver.terms.pair);
    memory_free(hard);
}

/* True if the motion of a group is prescribed. */
static bool prescribes(const struct integrator_context *motion) {
    bool any = false;
    for (int g = 0; g < motion->groups; g++)
        any = any || motion->motion[g].prescribed;
    return any;
}

static struct hard_input input_of(const struct physics_context *context) {
    struct hard *hard = context->self;
    double dt = context->clock->dt;
    struct hard_input input = {.scene = {.particles = context->particles,
                                         .material = material_numbers(context->particles),
                                         .wall_material = hard->wall_material,
                                         .walls = grains_walls(context),
                                         .list = context->list[0],
                                         .clumps = &hard->solver.clumps,
                                         .rocks = &hard->solver.rocks,
                                         .threads = context->threads},
                               .particles = context->particles,
                               .prescribed = prescribes(grains_motion(context)),
                               .omega = spin_values(context->particles),
                               .dimension = context->box->dimension,
                               .dt = dt,
                               .duration = context->evaluation->dt > 0.0 ? dt : 0.5 * dt};
    memcpy(input.gravity, context->scene->gravity, sizeof input.gravity);
    return input;
}

static struct history_rows *rows(const struct physics_context *context) {
    struct hard *hard = context->self;
    if (context->list[0]) /* a resume asks before there are lists */
        hard_contacts_detach(&hard->solver.contacts, &hard->solver.pairs, &hard->solver.rocks,
                             context->list[0], context->particles);
    const int components =
        hard->solver.pairs.history->components + (hard->solver.rocks.rocks ? HARD_ROCK_ROW : 0);
    hard->solver.pairs.rows.components =
        components > HISTORY_COMPONENTS_USUAL ? components : HISTORY_COMPONENTS_USUAL;
    return &hard->solver.pairs.rows;
}

static void rebuilt(const struct physics_context *context) {
    struct hard_solver *solver = &((struct hard *)context->self)->solver;
    hard_newton_renew(&solver->newton);
    solver->border.ghosts = context->ghosts;
    solver->border.particles = context->particles;
    solver->border.field = fields_find(context->particles, "contact_velocity");
    hard_clumps_link(&solver->clumps, context);
    hard_contacts_attach(&solver->contacts, &solver->pairs, context->particles);
    hard_pairs_make(&solver->pairs, context->list[0], context->particles, context->box,
                    context->scene->ghosts.newton, &solver->clumps);
    hard_rocks_link(&solver->rocks, &solver->pairs);
    history_rows_free(&solver->pairs.rows);
}

/* The reach that the present speeds ask for, with room to grow; true if it differs much from the present one. */
static bool rebuilt_again(const struct physics_context *context) {
    struct hard *hard = context->self;
    const struct hard_input input = input_of(context);
    double wants = hard_solver_wants(
        &input, fmax(hard->last.fastest, hard_solver_fastest(&hard->solver, context->particles)));
    if (wants <= hard->solver.reach && hard->solver.reach <= 8.0 * wants)
        return false;
    hard->solver.reach = 2.0 * wants;
    return true;
}

static bool due(const struct physics_context *context) {
    struct hard *hard = context->self;
    const struct hard_input input = input_of(context);
    return hard_solver_wants(&input, hard->last.fastest) > hard->solver.reach;
}

/* Rigid contacts under load would throw grains if their springs became stiffer at once, and drop them if softer. So where a
 * resume or a stage changes kappa or the step, kappa / dt^2 follows by 2 % a step; above a kappa of 1e4 at once. */
static double kappa_now(struct hard *hard, double dt) {
    const double change = 1.02, stiff = 1e4 / (dt * dt), kappa = hard->solver.options.kappa,
                 goal = kappa / (dt * dt);
    double now = hard->stiffness;
    hard->stiffness = goal;
    if (now > 0.0)
        hard->stiffness = fmin(fmax(goal, fmin(now, stiff) / change), now < stiff ? now * change : INFINITY);
    return hard->stiffness == goal ? kappa : hard->stiffness * (dt * dt);
}

/* `fall`: gravity times the step. */
static void count(const struct physics_context *context, double fall) {
    struct hard *hard = context->self;
    hard->solves++;
    hard->sweeps += (uint64_t)hard->last.sweeps;
    hard->refined += hard->last.steps > 0;
    hard->steps += (uint64_t)hard->last.steps;
    hard->iterations += (uint64_t)hard->last.iterations;
    hard->unmet +=
        hard->solver.options.tolerance > 0.0 && hard->last.residual > hard->solver.options.tolerance;
    hard->worst = fmax(hard->worst, hard->last.residual);
    hard->most.overlap = fmax(hard->most.overlap, hard->last.overlap);
    hard->most.fastest = fmax(hard->most.fastest, hard->last.fastest);
    hard->most.news = hard_has_price(hard) ? hard_price_of(context).news : 0.0;
    if (fall > 0.0)
        hard->most.approach = fmax(hard->most.approach, hard->last.approach / fall);
}

static void solve(const struct physics_context *context) {
    struct hard *hard = context->self;
    const struct hard_input input = input_of(context);
    struct grains *grains = grains_of(context->set);
    struct force_sums *sums = &grains->sums;
    double stored = hard->last.stored[0];
    if (hard->solver.terms.kappa > 0.0)
        hard->solver.terms.kappa = kappa_now(hard, context->clock->dt);
    hard_solver_step(&hard->solver, &input, &hard->last);
    count(context, sqrt(vector_dot(input.gravity, input.gravity)) * input.dt);
    *sums = (struct force_sums){.taken = hard->last.lost - (hard->last.stored[0] - stored),
                                .elastic_normal = hard->last.stored[0],
                                .elastic_tangential = hard->last.stored[1],
                                .overlap_max = hard->last.overlap,
                                .overlap_id = {hard->last.overlap_id[0], hard->last.overlap_id[1]},
                                .contacts = hard->last.contacts,
                                .contact_sides = 2 * hard->last.contacts};
    memcpy(sums->virial, hard->last.virial, sizeof sums->virial);
    if (grains->walls)
        walls_finish(grains->walls, &grains->contact, sums);
    grains->taken += sums->taken;
}

static double limit(const struct physics_context *context, double most) {
    struct hard *hard = context->self;
    double speed = grains_of(context->set)->stable.speed_most;
    double g = sqrt(vector_dot(context->scene->gravity, context->scene->gravity));
    if (isinf(hard->sizes.smallest))
        hard->sizes = hard_sizes_find(context);
    if (speed > 0.0)
        most = fmin(most, move_most * hard->sizes.smallest / speed);
    if (g > 0.0)
        most = fmin(most, fall_most * sqrt(hard->sizes.smallest / g));
    return most;
}

/* True if the last step's residual is above ten times the tolerance. */
static bool is_doubtful(const struct hard *hard) {
    double tolerance = hard->solver.options.tolerance;
    return tolerance > 0.0 && hard->last.residual > 10.0 * tolerance;
}

static void guard(const struct physics_context *context, struct error *error) {
    struct hard *hard = context->self;
    enum scene_guard guard = context->scene->guards.residual;
    char text[320];
    if (!is_doubtful(hard) || guard == SCENE_GUARD_OFF || error->kind != ERROR_NONE)
        return;
    snprintf(
        text, sizeof text,
        "guards.residual: the residual of the contacts is %.3g after %d sweeps%s at step %llu, t = %.9g; "
        "contact.solver.tolerance is %g: more sweeps, or a shorter step, reach it",
        hard->last.residual, hard->last.sweeps, hard->last.steps ? " and Newton's steps" : "",
        (unsigned long long)context->clock->step, context->clock->time, hard->solver.options.tolerance);
    if (guard == SCENE_GUARD_STOP)
        error_set(error, ERROR_PHYSICS, "%s", text);
    else if (!hard->warned && context->comm->rank == 0)
        log_tell(context->log, "warning: %s (said once)", text);
    hard->warned = true;
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct hard *hard = context->self;
    restart_add(list, RESTART_SUM, true, &hard->last.stored[0], "energy in solved contacts");
    restart_add(list, RESTART_REAL, true, &hard->solver.reach, "reach of solved contacts");
    restart_add(list, RESTART_REAL, true, &hard->stiffness, "stiffness of solved contacts");
}

static bool fits(const struct physics_context *context, const char *path,
                 const struct checkpoint_loaded *loaded, struct error *error) {
    const struct history_rows *now = rows(context), *then = &loaded->carried[PHYSICS_hard];
    return then->start == NULL || then->components == now->components ||
           error_set(error, ERROR_USER,
                     "%s: its contacts remember %d numbers for contact.solver, those of the scene %d: "
                     "contact.rolling and contact.twisting must stay",
                     path, then->components, now->components);
}

/* Finds walls by their names: the scene may have other walls, or the same in another order. */
static void resume(const struct physics_context *context, struct checkpoint_loaded *loaded,
                   struct history_rows *rows) {
    const struct hard *hard = context->self;
    int now[WALLS_MAX];
    (void)rows;
    for (int w = 0; w < loaded->walls; w++)
        now[w] = scene_wall(context->scene, loaded->wall[w].name);
    hard_contacts_rename(&hard->solver.pairs, &loaded->carried[PHYSICS_hard], now, loaded->walls,
                         context->particles->owned);
}

static const struct physics_pass pass = {.name = "solve",
                                         .does = "forces of contacts, by a solver",
                                         .place = PASS_CLOSE,
                                         .timer = "contact",
                                         .reads = "position velocity radius inverse_mass force",
                                         .writes = "force",
                                         .whole = solve};

static const struct physics_search search = {
    .interactions = 1, .interaction = {{.name = "solved contact", .range = range}}, .range_of_self = true};
static const struct physics_rows memory = {.of = rows, .due = due, .again = rebuilt_again};
static const struct physics_limit limits = {
    .of = limit,
    .stays = true,
    .why = "a grain would move by half of the smallest radius in a step, or fall by 1/450 of it"};
static const struct physics_record record = {.fits = fits, .resume = resume};
static const struct physics_table table = {.open = hard_file_open, .write = hard_file_write};
static const struct physics_shown shown = {.report = hard_report, .notes = hard_notes, .seen = hard_seen};

const struct physics hard_physics = {.name = "hard",
                                     .passes = 1,
                                     .pass = &pass,
                                     .check = hard_check,
                                     .create = create,
                                     .destroy = destroy,
                                     .rebuilt = rebuilt,
                                     .guard = guard,
                                     .restart = restart,
                                     .print = hard_print,
                                     .search = &search,
                                     .rows = &memory,
                                     .limit = &limits,
                                     .table = &table,
                                     .shown = &shown,
                                     .record = &record};
