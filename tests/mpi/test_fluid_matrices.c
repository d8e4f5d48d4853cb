/* SPDX-License-Identifier: BSD-3-Clause */
/* The matrices of the fluid and what solves them, on a periodic square lattice, where each wave is an eigenvector with the value
 * lambda = sum over j of w_ij (1 - cos k . (x_j - x_i)), and between two planes: assembly, momentum, pressure, schur, neighbour_fluxes,
 * applied_field.
 * Ranks: 1 */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/carried/applied_field.h"
#include "physics/fluid/lattice/mirror.h"
#include "physics/fluid/operators/neighbour_fluxes.h"
#include "physics/fluid/schemes/momentum.h"
#include "physics/fluid/schemes/schur.h"
#include "team.h"
#include "tests/near.h"
#include "tests/physics/fluid/fluid_cloud.h"

#include <math.h>
#include <string.h>

/* A cloud with its flow, and the solver. */
struct room {
    struct fluid_cloud cloud;
    struct weights weights;
    uint8_t *kind;
    int64_t *body;
    struct flow flow;
    struct assembly assembly;
    struct solve *solve;
    struct error error;
};

static void planes(const void *context, int64_t wall, const double x[3], struct weights_foot *foot) {
    (void)context;
    bool below = wall == body_of_wall(0);
    *foot =
        (struct weights_foot){.distance = below ? x[2] - 0.3 : 0.8 - x[2], .normal = {0, 0, below ? 1 : -1}};
}

/* The fluid between planes at z = 0.3 and 0.8. */
static void room_walls(struct room *r) {
    fluid_cloud_plane(&r->cloud, 0.3, &r->kind, &r->body);
    for (size_t k = 0; k < r->cloud.particles->owned; k++)
        r->body[k] = body_of_wall(r->cloud.particles->state[k].x[2] > 0.5);
}

static void room_make(struct room *r, struct team *team, bool walls) {
    *r = (struct room){0};
    if (!solve_available())
        team_skip(team, "PETSc is not there");
    if (walls)
        room_walls(r);
    else
        fluid_cloud_make(&r->cloud, 2, 12, 2.3, 0, 1);
    r->weights = fluid_cloud_weigh(&r->cloud, KERNEL_WENDLAND_C2, WEIGHTS_CORRECTED, true);
    const struct mirror_input mirror = {
        .rows = &r->cloud.input, .body = r->body, .spacing = r->cloud.spacing, .wall = planes};
    if (walls)
        assert_int_equal(mirror_make(&r->weights, &mirror), 0);
    size_t n = r->cloud.particles->owned;
    r->flow = (struct flow){.comm = &team->comm,
                            .weights = &r->weights,
                            .velocity = r->cloud.particles->state[0].v,
                            .velocity_stride = sizeof *r->cloud.particles->state / sizeof(double),
                            .predicted = memory_allocate_zero(n, 3 * sizeof(double), "test"),
                            .increment = memory_allocate_zero(n, sizeof(double), "test"),
                            .row = memory_allocate_zero(n, sizeof(int64_t), "test"),
                            .regions = 1};
    flow_number(&r->flow);
    r->solve = solve_begin(&team->comm, NULL, &r->error);
    team_expect(team, r->solve != NULL && assembly_make(&r->assembly, &r->flow, &r->error), "%s",
                r->error.text);
}

static void room_free(struct room *r) {
    assembly_free(&r->assembly);
    solve_end(&r->solve, NULL, 0);
    memory_free(r->flow.predicted);
    memory_free(r->flow.increment);
    memory_free(r->flow.row);
    memory_free(r->kind);
    memory_free(r->body);
    weights_free(&r->weights);
    fluid_cloud_free(&r->cloud);
}

/* cos k . x of a particle with k = 2 pi (1, 2), and lambda of that wave, from the first row. */
static double wave(const struct room *r, size_t i) {
    const double *x = r->cloud.particles->state[i].x;
    return cos(2 * M_PI * (x[0] + 2 * x[1]));
}

static double lambda(const struct room *r) {
    double sum = 0, apart[3];
    for (size_t e = r->weights.start[0]; e < r->weights.start[1]; e++) {
        weights_apart(&r->weights, &r->cloud.input, 0, e, apart);
        sum += weights_scalar(&r->weights, e) * (1 - cos(2 * M_PI * (apart[0] + 2 * apart[1])));
    }
    return sum;
}

/* The largest |A f - value f| of the matrix that was assembled, f the wave (or 1, of a wave of no length), and 1 where columns do not
 * increase. */
static double eigen_error(const struct room *r, double value, bool constant) {
    struct solve_rows rows = assembly_rows(&r->assembly);
    double worst = 0;
    for (int32_t i = 0; i < rows.count; i++) {
        double sum = 0;
        for (int32_t k = rows.start[i]; k < rows.start[i + 1]; k++) {
            sum += rows.value[k] * (constant ? 1 : wave(r, (size_t)rows.column[k]));
            worst = fmax(worst, k > rows.start[i] && rows.column[k] <= rows.column[k - 1]);
        }
        worst = fmax(worst, fabs(sum - value * (constant ? 1 : wave(r, (size_t)i))));
    }
    return worst;
}

/* assembly: of inertia + viscous lambda, of lambda, and of that times a uniform factor of particles or entries. */
static void matrices_have_waves(void **state) {
    struct room r;
    struct team *team = *state;
    room_make(&r, team, false);
    size_t n = r.weights.rows, entries = r.weights.start[n];
    double *share = memory_allocate(entries, sizeof *share, "test"), l = lambda(&r);
    assert_near(l / (4 * M_PI * M_PI * 5), 1, 0.2); /* k^2 up to the second order of the lattice */
    assembly_momentum(&r.assembly, &r.weights, 3, 0.02, 0);
    assert_near(eigen_error(&r, 3 + 0.02 * l, false), 0, 1e-10);
    assert_near(eigen_error(&r, 3, true), 0, 1e-10);
    assembly_pressure(&r.assembly, &r.weights, false, NULL);
    assert_near(eigen_error(&r, l, false), 0, 1e-9);
    for (size_t i = 0; i < n; i++)
        r.flow.increment[i] = 1.5;
    assembly_darcy(&r.assembly, &r.weights, flow_increment(&r.flow));
    assert_near(eigen_error(&r, 1.5 * l, false), 0, 1e-9);
    assembly_pressure(&r.assembly, &r.weights, true, r.flow.increment);
    assert_near(eigen_error(&r, 1.5 * l, false), 0, 1e-9);
    for (size_t e = 0; e < entries; e++)
        share[e] = 0.7;
    assembly_shared(&r.assembly, &r.weights, share);
    assert_near(eigen_error(&r, 0.7 * l, false), 0, 1e-9);
    assert_near(eigen_error(&r, 0, true), 0, 1e-9);
    memory_free(share);
    room_free(&r);
    team_finish(team);
}

/* momentum: (1 + a lambda) u* = b of each component; with another factor the matrix is filled again. */
static void momentum_divides_a_wave(void **state) {
    struct room r;
    struct team *team = *state;
    struct momentum momentum;
    const struct solve_options options = solve_options_regular("fluid_u_");
    room_make(&r, team, false);
    double(*side)[3] = memory_allocate_zero(r.weights.rows, sizeof *side, "test"), l = lambda(&r);
    team_expect(team, momentum_make(&momentum, r.solve, &r.assembly, &r.flow, 0.01, &options, &r.error), "%s",
                r.error.text);
    for (int again = 0; again < 2; again++) {
        double factor = again ? 0.002 : 0.01, worst = 0;
        for (size_t i = 0; i < r.weights.rows; i++)
            for (int c = 0; c < 2; c++)
                side[i][c] = (1 + factor * l) * (c + 2) * wave(&r, i);
        team_expect(
            team, momentum_solve(&momentum, &r.assembly, &r.flow, factor, (const double(*)[3])side, &r.error),
            "%s", r.error.text);
        for (size_t i = 0; i < r.weights.rows; i++)
            for (size_t c = 0; c < 2; c++)
                worst = fmax(worst, fabs(r.flow.predicted[3 * i + c] - (double)(c + 2) * wave(&r, i)));
        team_expect(team, worst < 1e-6, "error %g", worst);
    }
    momentum_free(&momentum);
    memory_free(side);
    room_free(&r);
    team_finish(team);
}

/* pressure: div grad phi = factor (wave + 5) has phi = - factor wave / lambda, as means are left out. */
static void pressure_divides_a_wave(void **state) {
    struct room r;
    struct team *team = *state;
    struct pressure pressure = {0};
    struct solve_options options = solve_options_singular("fluid_p_");
    options.tolerance = 1e-10;
    room_make(&r, team, false);
    double *divergence = memory_allocate(r.weights.rows, sizeof *divergence, "test"), worst = 0;
    for (size_t i = 0; i < r.weights.rows; i++)
        divergence[i] = wave(&r, i) + 5;
    team_expect(team,
                pressure_make(&pressure, r.solve, &r.assembly, &r.flow, &options, &r.error) &&
                    pressure_solve(&pressure, &r.flow, divergence, 40, false, &r.error),
                "%s", r.error.text);
    for (size_t i = 0; i < r.weights.rows; i++)
        worst = fmax(worst, fabs(r.flow.increment[i] + 40 * wave(&r, i) / lambda(&r)));
    team_expect(team, worst < 1e-8, "error %g", worst);
    pressure_free(&pressure);
    memory_free(divergence);
    room_free(&r);
    team_finish(team);
}

/* schur: of M = m - a div grad k is scale / m everywhere; with the diagonal alone as preconditioner S^-1 r = - r (1 + 1 / (k D)), D = sum
 * of w. */
static void schur_adds_the_part_of_darcy(void **state) {
    struct room r;
    struct team *team = *state;
    struct schur schur = {0};
    const struct solve_options options = solve_options_regular("fluid_u_");
    const double scale = 0.6, inertia = 30;
    room_make(&r, team, false);
    size_t n = r.weights.rows;
    double *a = memory_allocate(n, sizeof *a, "test"), *z = memory_allocate(n, sizeof *z, "test");
    double diagonal = 0, worst = 0;
    assembly_momentum(&r.assembly, &r.weights, inertia, 0.1, 0);
    struct solve_rows rows = assembly_rows(&r.assembly);
    struct solve_system *velocity = solve_create(r.solve, &rows, &options, &r.error);
    team_expect(team, schur_make(&schur, r.solve, &r.assembly, &r.flow, velocity, scale, "jacobi", &r.error),
                "%s", r.error.text);
    for (size_t e = r.weights.start[0]; e < r.weights.start[1]; e++)
        diagonal += weights_scalar(&r.weights, e);
    for (size_t i = 0; i < n; i++)
        a[i] = sin(3.0 * (double)i);
    schur_apply(&schur, &r.flow, a, z);
    for (size_t i = 0; i < n; i++)
        worst = fmax(worst, fabs(z[i] + a[i] * (1 + inertia / (scale * diagonal))));
    team_expect(team, worst < 1e-9, "error %g", worst);
    schur_free(&schur);
    solve_destroy(&velocity);
    memory_free(a);
    memory_free(z);
    room_free(&r);
    team_finish(team);
}

/* neighbour_fluxes: a uniform flow has a_ij = b_ij . u; of any flow what a particle loses in all is nothing, though the raw sums are not
 * 0, and what i loses to j, j gains: all particles together neither win nor lose of a scalar. */
static void fluxes_have_no_sources(void **state) {
    struct room r;
    struct team *team = *state;
    struct fluxes fluxes = {0};
    room_make(&r, team, false);
    for (int stirred = 0; stirred < 2; stirred++) {
        double worst = 0, raw = 0, all = 0;
        for (size_t i = 0; i < r.weights.rows; i++) {
            double *v = r.cloud.particles->state[i].v;
            v[0] = 0.3 + (stirred ? wave(&r, i) : 0);
            v[1] = -0.8 + (stirred ? 0.5 * wave(&r, i) : 0);
        }
        team_expect(team, neighbour_fluxes_make(&fluxes, r.solve, &r.assembly, &r.flow, true, &r.error), "%s",
                    r.error.text);
        for (size_t i = 0; i < r.weights.rows; i++) {
            double sum = 0;
            for (size_t e = r.weights.start[i]; e < r.weights.start[i + 1]; e++) {
                const double *b = weights_vector(&r.weights, e);
                size_t j = pair_partner(r.weights.partner[e]);
                sum += fluxes.carry[e];
                all += fluxes.carry[e] * (sin(7.0 * (double)i) + sin(7.0 * (double)j));
                if (!stirred)
                    worst = fmax(worst, fabs(fluxes.carry[e] - 0.3 * b[0] + 0.8 * b[1]));
            }
            worst = fmax(worst, fabs(sum));
            raw = fmax(raw, fabs(fluxes.sum[i]));
        }
        team_expect(team, worst < 1e-6 && fabs(all) < 1e-6, "error %g, %g", worst, all);
        team_expect(team, (raw > 1) == (stirred == 1), "raw sums %g", raw);
    }
    neighbour_fluxes_free(&fluxes);
    room_free(&r);
    team_finish(team);
}

/* applied_field: between planes across z that insulate nothing is left of the part across them, and all of that along them. */
static void a_field_goes_along_planes(void **state) {
    struct room r;
    struct team *team = *state;
    const double far[3] = {1.3, -0.4, 0.9};
    room_make(&r, team, true);
    size_t n = r.weights.rows, entries = r.weights.start[n];
    double *share = memory_allocate(entries, sizeof *share, "test"), worst = 0;
    double *field = memory_allocate(n, 3 * sizeof *field, "test");
    for (size_t e = 0; e < entries; e++)
        share[e] = 1;
    const struct applied applied = {.flow = &r.flow,
                                    .input = &r.cloud.input,
                                    .assembly = &r.assembly,
                                    .solve = r.solve,
                                    .share = share,
                                    .preconditioner = "boomeramg"};
    team_expect(team, applied_field(&applied, far, field, &r.error), "%s", r.error.text);
    for (size_t i = 0; i < 3 * n; i++)
        worst = fmax(worst, fabs(field[i] - (i % 3 == 2 ? 0 : far[i % 3])));
    team_expect(team, worst < 1e-6, "error %g", worst);
    memory_free(share);
    memory_free(field);
    room_free(&r);
    team_finish(team);
}

TEAM_MAIN(fluid_matrices, team_case(matrices_have_waves), team_case(momentum_divides_a_wave),
          team_case(pressure_divides_a_wave), team_case(schur_adds_the_part_of_darcy),
          team_case(fluxes_have_no_sources), team_case(a_field_goes_along_planes))
