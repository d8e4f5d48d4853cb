/* SPDX-License-Identifier: BSD-3-Clause */
/* The step of hard contacts. Read hard_solve.h and row.h first. */
#include "physics/hard/hard_solve.h"
#include "base/memory.h"
#include "kernel/particles/spin.h"
#include <limits.h>
#include <string.h>

/* The residual is looked at every so many sweeps; restitution takes so many, where bodies touch at several points more. */
enum { LOOK_EVERY = 5, REBOUND_SWEEPS = 8, REBOUND_SWEEPS_BODIES = 40 };

static double size_of(const double a[3]) {
    return sqrt(vector_dot(a, a));
}

double hard_solver_wants(const struct hard_input *input, double fastest) {
    double walls = input->scene.walls ? walls_speed(input->scene.walls) : 0.0;
    return 2.0 * input->dt * (fmax(fastest, walls) + 4.0 * size_of(input->gravity) * input->dt);
}

double hard_solver_fastest(const struct hard_solver *solver, const struct particles *particles) {
    const double(*omega)[4] = spin_values(particles);
    double square = 0.0, turning = 0.0;
#pragma omp parallel for schedule(static) reduction(max : square, turning)
    for (size_t k = 0; k < particles->owned; k++) {
        square = fmax(square, vector_dot(particles->state[k].v, particles->state[k].v));
        if (omega && hard_rocks_is(&solver->rocks, (uint32_t)k))
            turning = fmax(turning, particles->state[k].radius * size_of(omega[k]));
    }
    double most = sqrt(square) + turning;
    comm_max(solver->comm, &most, 1);
    return most;
}

/* The acceleration of particle k without contacts: by gravity, and by the force of a calling program. */
static void acceleration_of(const struct hard_input *input, size_t k, double a[3]) {
    const struct particles *p = input->particles;
    const double *force = p->force + k * (size_t)p->force_stride;
    double mass = p->state[k].inverse_mass;
    for (int d = 0; d < 3; d++)
        a[d] = d < input->dimension && mass > 0.0 ? force[d] * mass + input->gravity[d] : 0.0;
}

/* Particle k without contacts at the end of the step. */
static struct hard_body body_free(const struct hard_input *input, size_t k) {
    const struct particles *p = input->particles;
    const struct particle_state *state = &p->state[k];
    const double *force = p->force + k * (size_t)p->force_stride;
    double mass = state->inverse_mass, h = input->duration, a[3];
    struct hard_body body = {.lightness = mass};
    acceleration_of(input, k, a);
    for (int d = 0; d < 3; d++)
        body.v[d] = state->v[d] + h * a[d];
    if (input->omega == NULL)
        return body;
    body.swing = 2.5 * mass / (state->radius * state->radius);
    for (int d = 0; d < 3; d++)
        body.w[d] = input->omega[k][d] + h * force[4 + d] * body.swing;
    return body;
}

/* The bodies of all particles. Finds the largest speed and acceleration without contacts, over all ranks. */
static void bodies_make(struct hard_solver *solver, const struct hard_input *input, double most[2]) {
    struct hard_problem *problem = &solver->problem;
    const struct particles *p = input->particles;
    double square = 0.0, pull = 0.0;
    problem->bodies = p->owned + p->ghosts;
    hard_problem_reserve(problem, problem->bodies, 0, 0);
#pragma omp parallel for schedule(static) reduction(max : square, pull)
    for (size_t k = 0; k < p->owned + p->ghosts; k++) {
        problem->body[k] = (struct hard_body){.lightness = p->state[k].inverse_mass};
        if (k < p->owned) {
            double a[3];
            acceleration_of(input, k, a);
            problem->body[k] = body_free(input, k);
            square = fmax(square, vector_dot(problem->body[k].v, problem->body[k].v));
            pull = fmax(pull, vector_dot(a, a));
        } else if (input->omega) {
            problem->body[k].swing =
                2.5 * p->state[k].inverse_mass / (p->state[k].radius * p->state[k].radius);
        }
    }
    most[0] = sqrt(square);
    most[1] = sqrt(pull);
    most[0] = fmax(most[0], hard_clumps_set(&solver->clumps, problem, &most[1]));
    hard_border_send(&solver->border, problem);
    comm_max(solver->comm, most, 2);
}

/* Sweeps whose residual has grown by this factor go on with care. */
static const double grown = 2.0;

static double residual_of(const struct hard_solver *solver) {
    double sum[3];
    hard_problem_residual(&solver->problem, sum);
    comm_sum(solver->comm, sum, 3);
    double most = fmax(sum[1], sum[2]);
    return most > 0.0 ? sqrt(sum[0] / most) : 0.0;
}

/* Sweeps until the residual is met, or all are done. */
static void sweep(struct hard_solver *solver, struct hard_result *result) {
    const struct hard_options *options = &solver->options;
    struct hard_problem *problem = &solver->problem;
    int first = result->sweeps, done = 0;
    double least = result->residual = INFINITY;
    while (done < options->sweeps && result->residual > options->tolerance) {
        hard_border_turns(&solver->border, problem, hard_problem_sweep);
        result->sweeps = first + ++done;
        if (done % LOOK_EVERY == 0 || done == options->sweeps)
            result->residual = residual_of(solver);
        solver->border.careful = solver->border.careful || result->residual > grown * least;
        least = fmin(least, result->residual);
    }
}

/* Goes on by Newton's method where sweeps have not met the residual. */
static void refine(struct hard_solver *solver, struct hard_result *result) {
    const struct hard_newton_limits limits = {solver->options.steps, solver->options.tolerance,
                                              result->residual};
    const struct hard_newton_result newton = hard_newton_solve(&solver->newton, &limits);
    result->steps = newton.steps;
    result->iterations = newton.iterations;
    result->residual = newton.residual;
}

/* Impacts rebound. */
static void rebound(struct hard_solver *solver, struct hard_result *result) {
    struct hard_problem *problem = &solver->problem;
    if (solver->terms.poisson) {
        double any = hard_problem_expand(problem);
        comm_max(solver->comm, &any, 1);
        if (any > 0.0)
            sweep(solver, result);
        return;
    }
    const int sweeps = solver->clumps.links ? REBOUND_SWEEPS_BODIES : REBOUND_SWEEPS;
    for (int k = 0; k < sweeps; k++) {
        double any = hard_problem_rebounds(problem);
        comm_max(solver->comm, &any, 1);
        if (any <= 0.0)
            break;
        hard_border_turns(&solver->border, problem, hard_problem_rebound);
    }
}

/* The impulses of the step. */
static void iterate(struct hard_solver *solver, size_t owned, struct hard_result *result) {
    struct hard_problem *problem = &solver->problem;
    bool newton = solver->options.method == HARD_NEWTON;
    if (solver->terms.pulls) {
        hard_problem_pull(problem);
        hard_border_join(&solver->border, problem);
    }
    if (newton)
        hard_newton_begin(&solver->newton, problem, &solver->border, owned);
    hard_problem_warm(problem);
    hard_border_join(&solver->border, problem);
    sweep(solver, result);
    if (newton)
        refine(solver, result);
    rebound(solver, result);
}

static const double *gathered_of(const void *border, size_t k) {
    return hard_border_gathered(border, k);
}

/* Forces on the owned grains; adds the work that they take, with the mean of the velocities before and after the step.
 * Those on grains whose motion is prescribed are sums over rows, as no velocity tells them. */
static void forces_give(struct hard_solver *solver, const struct hard_input *input,
                        struct hard_result *result) {
    struct particles *p = input->particles;
    double lost = 0.0;
    if (input->prescribed)
        hard_border_gather(&solver->border, &solver->problem);
#pragma omp parallel for schedule(static) reduction(+ : lost)
    for (size_t k = 0; k < p->owned; k++) {
        double *force = p->force + k * (size_t)p->force_stride;
        const struct hard_body before = body_free(input, k), *after = &solver->problem.body[k];
        const double *v = p->state[k].v, *w = input->omega ? input->omega[k] : NULL;
        double mass = p->state[k].inverse_mass;
        if (!(mass > 0.0) && !input->prescribed)
            continue;
        const double *gathered = mass > 0.0 ? NULL : hard_border_gathered(&solver->border, k);
        for (int d = 0; d < 3; d++) {
            double impulse = gathered ? gathered[d] : (after->v[d] - before.v[d]) / mass;
            force[d] += impulse / input->duration;
            lost -= 0.5 * impulse * (v[d] + after->v[d]);
        }
        for (int d = 0; d < 3 && w; d++) {
            double impulse = gathered ? gathered[3 + d] : (after->w[d] - before.w[d]) / before.swing;
            force[4 + d] += impulse / input->duration;
            lost -= 0.5 * impulse * (w[d] + after->w[d]);
        }
    }
    result->lost += lost + hard_clumps_give(&solver->clumps, &solver->problem, gathered_of, &solver->border);
}

/* Forces on walls; their work on grains is no loss. */
static void walls_give(const struct hard_solver *solver, const struct hard_input *input,
                       struct hard_result *result) {
    const struct hard_contacts *contacts = &solver->contacts;
    for (size_t k = 0; k < contacts->walls; k++) {
        const struct hard_row *row = &solver->problem.row[contacts->pair_rows + k];
        const struct wall_place *place = &contacts->wall[k].place;
        double force[3];
        for (int d = 0; d < 3; d++) {
            force[d] = (hard_net(row) * row->normal[d] + row->q[d]) / input->duration;
            result->lost -= force[d] * input->duration * place->velocity[d];
        }
        walls_push(input->scene.walls, 0, place, force, 0); /* no servos */
    }
}

/* The branch of a row, and the force on its second body. */
static void pull_of(const struct hard_row *row, double duration, double branch[3], double force[3]) {
    for (int d = 0; d < 3; d++) {
        branch[d] = row->arm ? row->arm->branch[d] : (row->lever[0] + row->lever[1]) * row->normal[d];
        force[d] = (hard_net(row) * row->normal[d] + row->q[d]) / duration;
    }
}

/* The speed at which the bodies of a row approach. */
static double approach_of(const struct hard_problem *problem, const struct hard_row *row) {
    double u[3];
    hard_velocity(row, &problem->body[row->body[0]], &problem->body[row->body[1]], u);
    return -vector_dot(u, row->normal);
}

/* Notes a row if its overlap is the largest so far. */
static void overlap_note(const struct hard_solver *solver, const struct particles *p, size_t r,
                         struct hard_result *result) {
    const struct hard_row *row = &solver->problem.row[r];
    bool wall = r >= solver->contacts.pair_rows;
    size_t end[2];
    hard_contacts_ends(&solver->contacts, &solver->pairs, r, end);
    double smaller = p->state[end[0]].radius;
    if (!wall)
        smaller = fmin(smaller, p->state[end[1]].radius);
    if (!(-row->gap / smaller > result->overlap))
        return;
    result->overlap = -row->gap / smaller;
    result->overlap_id[0] = p->id[end[0]];
    result->overlap_id[1] =
        wall ? -(int64_t)(solver->contacts.wall[r - solver->contacts.pair_rows].place.wall + 1)
             : p->id[end[1]];
}

/* Overlap, approach, energies and virial of a cut. */
static void account_cut(const struct hard_solver *solver, const struct hard_input *input, size_t cut,
                        struct hard_result *part) {
    *part = (struct hard_result){0};
    for (size_t r = solver->problem.cut[cut]; r < solver->problem.cut[cut + 1]; r++) {
        const struct hard_row *row = &solver->problem.row[r];
        double stored[2], branch[3], force[3];
        overlap_note(solver, input->particles, r, part);
        part->contacts += hard_acts(row);
        if (row->p > 0.0 && row->gap <= 0.0 && !row->impact)
            part->approach = fmax(part->approach, approach_of(&solver->problem, row));
        hard_stored(row, input->dt, input->duration, stored);
        part->stored[0] += row->impact ? 0.0 : stored[0];
        part->stored[1] += row->impact ? 0.0 : stored[1];
        pull_of(row, input->duration, branch, force);
        force_add_virial(part->virial, 1.0, branch, force);
    }
}

/* Largest overlap and approach, contacts, energies and virial: sums over cuts, whose order no number of threads changes. */
static void account(const struct hard_solver *solver, const struct hard_input *input,
                    struct hard_result *result) {
    size_t cuts = solver->problem.cuts;
    struct hard_result *part = memory_allocate(cuts, sizeof *part, "account of contacts");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < cuts; k++)
        account_cut(solver, input, k, &part[k]);
    for (size_t k = 0; k < cuts; k++) {
        if (part[k].overlap > result->overlap) {
            result->overlap = part[k].overlap;
            memcpy(result->overlap_id, part[k].overlap_id, sizeof part[k].overlap_id);
        }
        result->approach = fmax(result->approach, part[k].approach);
        result->contacts += part[k].contacts;
        for (int d = 0; d < 2; d++)
            result->stored[d] += part[k].stored[d];
        for (int d = 0; d < 6; d++)
            result->virial[d] += part[k].virial[d];
    }
    memory_free(part);
}

size_t hard_solver_list(const struct hard_solver *solver, const struct particles *particles, bool walls,
                        struct force_contact **contacts) {
    size_t pairs = solver->contacts.pair_rows, count = 0;
    size_t first = walls ? pairs : 0, end = walls ? pairs + solver->contacts.walls : pairs;
    *contacts = memory_allocate(end - first, sizeof **contacts, "contact list");
    for (size_t r = first; r < end; r++) {
        const struct hard_row *row = &solver->problem.row[r];
        struct force_contact *contact = &(*contacts)[count];
        if (!hard_acts(row))
            continue;
        size_t at[2];
        hard_contacts_ends(&solver->contacts, &solver->pairs, r, at);
        *contact = (struct force_contact){
            .id_i = particles->id[at[0]], .overlap = -row->gap, .number_i = at[0], .number_j = at[1]};
        contact->id_j =
            walls ? -(int64_t)(solver->contacts.wall[r - pairs].place.wall + 1) : particles->id[at[1]];
        memcpy(contact->normal, row->normal, sizeof contact->normal);
        pull_of(row, solver->duration, contact->branch, contact->force);
        count++;
    }
    return count;
}

void hard_solver_step(struct hard_solver *solver, const struct hard_input *input,
                      struct hard_result *result) {
    struct hard_problem *problem = &solver->problem;
    *result = (struct hard_result){0};
    solver->duration = input->duration;
    history_rows_free(&solver->pairs.rows); /* of a checkpoint */
    double most[2];
    hard_clumps_begin(&solver->clumps, input->duration);
    bodies_make(solver, input, most);
    result->fastest = most[0];
    const struct hard_pace pace = {.dt = input->dt,
                                   .duration = input->duration,
                                   .near = fmin(solver->reach, hard_solver_wants(input, result->fastest)),
                                   .fall = most[1],
                                   .sweeps = solver->exact ? INT_MAX : solver->options.sweeps};
    hard_contacts_find(&solver->contacts, problem, &solver->pairs, &input->scene, &solver->terms, &pace);
    hard_border_count(&solver->border, problem, solver->comm->rank);
    int64_t rows = (int64_t)problem->rows;
    comm_sum_int(solver->comm, &rows, 1);
    result->rows = (uint64_t)rows;
    if (rows > 0)
        iterate(solver, input->particles->owned, result);
    forces_give(solver, input, result);
    walls_give(solver, input, result);
    account(solver, input, result);
    solver->exact = solver->options.method == HARD_NEWTON && result->residual <= solver->options.tolerance;
    hard_contacts_remember(&solver->contacts, problem, &solver->pairs, &solver->rocks, &pace);
}
