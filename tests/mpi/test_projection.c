/* SPDX-License-Identifier: BSD-3-Clause */
/* Steps of an incompressible flow on a lattice against closed forms: Taylor and Green's vortices, the start of
 * Poiseuille's flow, slip.
 * Ranks: 1 */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/operators/surface_forces.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/schemes/anderson.h"
#include "physics/fluid/schemes/projection.h"
#include "physics/fluid/schemes/steady.h"
#include "kernel/particles/kinds.h"
#include "team.h"
#include "kernel/pairs/classes_choose.h"

#include <math.h>
#include <omp.h>
#include <string.h>

/* A square of edge 1, side x side fluid particles; periodic, or with walls at y = 0 and 1. Boundary particles lie
 * behind them in memory. */
struct square {
    struct team *team;
    int side, depth; /* depth: layers of boundary particles behind each wall */
    double spacing, reach;
    struct particles *particles;
    uint8_t *kind;
    int64_t *body;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct interactions set;
    struct pair_rows pairs;
    struct weights weights;
    struct flow flow;
    struct solve *solve;
};

static double kernel_range(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)kind_a, (void)kind_b;
    return isinf(b) ? -INFINITY : *(const double *)context - a - b;
}

/* Fluid first, row by row, then what lies behind the walls. Positions are shifted by the depth, as a box begins
 * at 0. */
static void place(struct square *s) {
    size_t rows = (size_t)(s->side + 2 * s->depth), side = (size_t)s->side;
    s->particles = particles_create(rows * side);
    s->kind = memory_allocate(rows * side, 1, "test");
    s->body = memory_allocate_zero(rows * side, sizeof *s->body, "test");
    for (size_t k = 0; k < rows * side; k++) {
        int64_t y = (int64_t)(k / side);
        if (y >= s->side)
            y = y < s->side + s->depth ? y : y - (int64_t)rows;
        size_t i = particles_append(s->particles);
        struct particle_state *state = &s->particles->state[i];
        state->x[0] = ((double)(k % side) + 0.5) * s->spacing;
        state->x[1] = ((double)(y + s->depth) + 0.5) * s->spacing;
        state->radius = 0.5 * s->spacing;
        s->particles->id[i] = (int64_t)k + 1;
        s->kind[i] = k < side * side ? KIND_FLUID : KIND_BOUNDARY;
        s->body[i] = body_of_wall(y >= s->side);
    }
}

/* The walls y = 0 and y = 1; `context` is the depth of the layers. */
static void wall_foot(const void *context, int64_t body, const double x[3], struct weights_foot *foot) {
    int wall = body_wall(body);
    double y = x[1] - *(const double *)context;
    *foot = (struct weights_foot){.distance = wall == 0 ? y : 1 - y, .normal = {0, wall == 0 ? 1 : -1, 0}};
}

static void search(struct square *s) {
    struct classes_options options = {.method = CLASSES_ONE, .skin_given = true};
    struct classes_range range = interactions_range(&s->set);
    struct error error = {0};
    double radius = 0.5 * s->spacing;
    const bool wrap[3] = {true, s->depth == 0, false};
    const struct index_params params = {0};
    assert_true(classes_choose(&s->classes, &options, &range, &radius, 1, &error));
    particles_classify(s->particles, &s->classes);
    pairlist_view(&s->view, s->particles, &s->classes, &s->box, wrap);
    omp_set_num_threads(1);
    s->view.threads = 1;
    s->index = index_create("linkcell", &params, &error);
    interactions_create(&s->set, &(struct pairlist_options){.threads = 1});
    index_build(s->index, &s->view);
    pairlist_build(s->set.all, s->index, &s->view, &s->box);
    pair_rows_build(&s->pairs, s->set.all, s->particles->owned);
}

static void weigh(struct square *s, enum kernel_name kernel, double slip) {
    double below = s->depth * s->spacing;
    const struct weights_input input = {.particles = s->particles,
                                        .kind = s->kind,
                                        .end = (size_t)s->side * (size_t)s->side,
                                        .pairs = &s->pairs,
                                        .shift = (const double(*)[4])s->set.all->shift,
                                        .dimension = 2};
    const struct weights_options options = {.kernel = kernel_make(kernel, s->reach, 2),
                                            .operators = WEIGHTS_CORRECTED,
                                            .spacing = s->spacing,
                                            .volume = s->spacing * s->spacing,
                                            .slip = slip};
    const struct mirror_input mirror = {
        .rows = &input, .body = s->body, .spacing = s->spacing, .wall = wall_foot, .context = &below};
    weights_make(&s->weights, &input, &options);
    assert_int_equal(mirror_make(&s->weights, &mirror), 0);
}

static bool square_make(struct square *s, struct team *team, int side, bool walls, enum kernel_name kernel,
                        double reach, double slip) {
    *s = (struct square){.team = team, .side = side, .spacing = 1.0 / side};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    struct error error = {0};
    s->reach = reach * s->spacing;
    s->depth = walls ? (int)ceil(reach) : 0;
    s->box = (struct box){
        .dimension = 2, .edge = {1, 1 + 2 * s->depth * s->spacing, 1}, .periodic = {true, !walls, false}};
    interactions_add(&s->set, &(struct interaction){"kernel", kernel_range, &s->reach});
    place(s);
    search(s);
    weigh(s, kernel, slip);
    size_t n = s->particles->owned;
    s->flow = (struct flow){.comm = &team->comm,
                            .weights = &s->weights,
                            .velocity = s->particles->state[0].v,
                            .velocity_stride = sizeof *s->particles->state / sizeof(double),
                            .pressure = memory_allocate_zero(n, sizeof(double), "test"),
                            .predicted = memory_allocate_zero(n, 3 * sizeof(double), "test"),
                            .increment = memory_allocate_zero(n, sizeof(double), "test"),
                            .advection_before = memory_allocate_zero(n, 3 * sizeof(double), "test"),
                            .row = memory_allocate_zero(n, sizeof(int64_t), "test"),
                            .regions = 1};
    s->solve = solve_begin(&team->comm, NULL, &error);
    team_expect(team, s->solve != NULL, "%s", error.text);
    return s->solve != NULL;
}

static void square_free(struct square *s) {
    solve_end(&s->solve, NULL, 0);
    memory_free(s->flow.pressure);
    memory_free(s->flow.predicted);
    memory_free(s->flow.increment);
    memory_free(s->flow.advection_before);
    memory_free(s->flow.row);
    memory_free(s->kind);
    memory_free(s->body);
    weights_free(&s->weights);
    pair_rows_free(&s->pairs);
    interactions_free(&s->set);
    index_destroy(&s->index);
    particles_destroy(&s->particles);
}

/* Makes `steps` steps from the flow as it is. */
static void go(struct square *s, const struct projection_options *options, int steps, double force) {
    struct error error = {0};
    struct projection_past past = {0};
    const double along[3] = {force, 0, 0};
    flow_number(&s->flow);
    struct projection *projection = projection_create(s->solve, &s->flow, options, &error);
    for (int k = 0; projection != NULL && k < steps; k++)
        if (!projection_step(projection, &s->flow, &past, options->dt, along, &error))
            break;
    team_expect(s->team, past.steps == steps, "step %d: %s", (int)past.steps, error.text);
    projection_destroy(&projection);
}

static struct projection_options settings(const struct square *s, double viscosity, double dt) {
    return (struct projection_options){.density = 1,
                                       .viscosity = viscosity,
                                       .spacing = s->spacing,
                                       .dt = dt,
                                       .advection = true,
                                       .preconditioner = "boomeramg",
                                       .tolerance_velocity = 1e-8,
                                       .tolerance_pressure = 1e-5};
}

/* u = sin kx cos ky, v = -cos kx sin ky, which decays as exp(-2 nu k^2 t). */
static void vortices(const struct square *s, double decay, double (*out)[2]) {
    double k = 2 * M_PI;
    for (size_t i = 0; i < s->weights.rows; i++) {
        const double *x = s->particles->state[i].x;
        out[i][0] = decay * sin(k * x[0]) * cos(k * x[1]);
        out[i][1] = -decay * cos(k * x[0]) * sin(k * x[1]);
    }
}

/* The relative error of the velocity at t. */
static double taylor_green(struct team *team, int side, double nu, double t, double step) {
    struct square s;
    double gap = 0, size = 0;
    if (square_make(&s, team, side, false, KERNEL_QUINTIC, 3.1, 0)) {
        double(*exact)[2] = memory_allocate(s.weights.rows, sizeof *exact, "test");
        int steps = (int)lround(t / (step * s.spacing));
        struct projection_options options = settings(&s, nu, t / steps);
        vortices(&s, 1, exact);
        for (size_t i = 0; i < s.weights.rows; i++)
            memcpy(s.particles->state[i].v, exact[i], sizeof exact[i]);
        go(&s, &options, steps, 0);
        vortices(&s, exp(-8 * M_PI * M_PI * nu * t), exact);
        for (size_t i = 0; i < s.weights.rows; i++)
            for (int d = 0; d < 2; d++) {
                gap += pow(s.particles->state[i].v[d] - exact[i][d], 2);
                size += pow(exact[i][d], 2);
            }
        memory_free(exact);
    }
    square_free(&s);
    return sqrt(gap / size);
}

static void taylor_green_is_of_second_order(void **state) {
    struct team *team = *state;
    double coarse = taylor_green(team, 32, 0.01, 0.2, 0.25), fine = taylor_green(team, 64, 0.01, 0.2, 0.25);
    print_message("Taylor-Green: %.3g at 32, %.3g at 64\n", coarse, fine);
    team_expect(team, fine <= 5e-4, "error %g at 64", fine);
    team_expect(team, log2(coarse / fine) >= 1.9, "errors %g and %g", coarse, fine);
    team_finish(team);
}

/* In dt alone, at one spacing: differences of the errors, which the lattice's own cancels from. */
static void steps_are_of_second_order(void **state) {
    struct team *team = *state;
    double error[3];
    for (int k = 0; k < 3; k++)
        error[k] = taylor_green(team, 32, 0.05, 0.25, 0.25 * pow(2, k));
    double order = log2((error[2] - error[1]) / (error[1] - error[0]));
    print_message("order in time: %.3g (errors %.4g %.4g %.4g)\n", order, error[0], error[1], error[2]);
    team_expect(team, order >= 1.9, "order %g", order);
    team_finish(team);
}

/* The start from rest under a force of 1 between walls that stand still: the series, nu = 1. */
static double poiseuille_series(double y, double t) {
    double u = 0.5 * y * (1 - y);
    for (int n = 1; n < 100; n += 2)
        u -= 4 / pow(n * M_PI, 3) * sin(n * M_PI * y) * exp(-n * n * M_PI * M_PI * t);
    return u;
}

static double profile_error(const struct square *s, double t, double slip) {
    double gap = 0, size = 0;
    for (size_t i = 0; i < s->weights.rows; i++) {
        double y = s->particles->state[i].x[1] - s->depth * s->spacing;
        double exact = slip > 0 ? 0.5 * (y * (1 - y) + slip) : poiseuille_series(y, t);
        gap += pow(s->particles->state[i].v[0] - exact, 2) + pow(s->particles->state[i].v[1], 2);
        size += exact * exact;
    }
    return sqrt(gap / size);
}

static double poiseuille(struct team *team, int side, double slip, double t, double dt) {
    struct square s;
    double error = INFINITY;
    if (square_make(&s, team, side, true, KERNEL_WENDLAND_C2, 3.1, slip)) {
        struct projection_options options = settings(&s, 1, dt);
        go(&s, &options, (int)lround(t / dt), 1);
        error = profile_error(&s, t, slip);
    }
    square_free(&s);
    return error;
}

static void poiseuille_starts(void **state) {
    struct team *team = *state;
    double coarse = poiseuille(team, 16, 0, 0.05, 1.0 / 320), fine = poiseuille(team, 32, 0, 0.05, 1.0 / 640);
    print_message("Poiseuille: %.3g at 16, %.3g at 32\n", coarse, fine);
    team_expect(team, fine <= 4e-3 && log2(coarse / fine) >= 1.8, "errors %g at 16, %g at 32", coarse, fine);
    team_finish(team);
}

static void walls_slip(void **state) {
    struct team *team = *state;
    static const double slip[2] = {0.1, 0.5};
    for (int k = 0; k < 2; k++) {
        double coarse = poiseuille(team, 16, slip[k], 8, 0.1), fine = poiseuille(team, 32, slip[k], 8, 0.1);
        print_message("slip %g: %.3g at 16, %.3g at 32\n", slip[k], coarse, fine);
        team_expect(team, fine <= 4e-3 && log2(coarse / fine) >= 1.9, "errors %g at 16, %g at 32", coarse,
                    fine);
    }
    team_finish(team);
}

/* The parabola, solved for at once: the same flow as after a long march; what the walls take is what the force
 * gives. A box without walls has no steady flow. */
static void steady_flow_is_found(void **state) {
    struct team *team = *state;
    struct square s;
    const double force[3] = {1, 0, 0};
    for (int walls = 0; walls < 2; walls++) {
        struct error error = {0};
        struct steady_report report = {0};
        if (square_make(&s, team, 32, walls, KERNEL_WENDLAND_C2, 2.3, 0)) {
            struct steady_options options = {.viscosity = 1,
                                             .spacing = s.spacing,
                                             .edge = 1,
                                             .tolerance = 1e-4,
                                             .iterations = 200,
                                             .preconditioner = "boomeramg"};
            flow_number(&s.flow);
            struct steady *steady = steady_create(s.solve, &s.flow, &options, &error);
            team_expect(team, (steady != NULL) == walls, "walls %d: %s", walls, error.text);
            if (steady != NULL) {
                team_expect(team, steady_solve(steady, &s.flow, force, &report, &error), "%s", error.text);
                double gap = profile_error(&s, 100, 0), sum[2] = {0};
                size_t feet = s.weights.foot_start[s.weights.rows];
                struct surface_forces_part *part = memory_allocate(feet, sizeof *part, "test");
                surface_forces_feet(&s.flow, 1, part);
                for (size_t f = 0; f < feet; f++)
                    for (int d = 0; d < 2; d++)
                        sum[d] += part[f].viscous[d] + part[f].pressure[d];
                memory_free(part);
                print_message("steady: error %.3g, %d iterations, residual %.2g, force %.6g %.3g\n", gap,
                              report.iterations, report.residual, sum[0], sum[1]);
                team_expect(team, gap < 4e-3 && report.iterations <= 50, "error %g", gap);
                team_expect(team, fabs(sum[0] - 1) < 1e-3 && fabs(sum[1]) < 1e-3, "force %g %g", sum[0],
                            sum[1]);
                steady_destroy(&steady);
            }
        }
        square_free(&s);
    }
    team_finish(team);
}

/* A linear lack with as many unknowns as tries is gone after them. */
static void anderson_solves_what_is_linear(void **state) {
    enum { N = 5 };
    struct team *team = *state;
    struct anderson anderson = {0};
    double x[N] = {0}, f[N], size = 0;
    anderson_begin(&anderson, &team->comm, N);
    for (int n = 0; n <= N + 1; n++) {
        size = 0;
        for (int i = 0; i < N; i++) {
            f[i] = 1 - (1.5 + i) * x[i] + 0.3 * x[(i + 1) % N];
            size += f[i] * f[i];
        }
        if (n <= N)
            anderson_next(&anderson, x, f);
    }
    team_expect(team, size < 1e-20, "lack %g", sqrt(size));
    anderson_free(&anderson);
    team_finish(team);
}

TEAM_MAIN(projection, team_case(anderson_solves_what_is_linear), team_case(taylor_green_is_of_second_order),
          team_case(steps_are_of_second_order), team_case(poiseuille_starts), team_case(walls_slip),
          team_case(steady_flow_is_found))
