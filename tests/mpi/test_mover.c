/* SPDX-License-Identifier: BSD-3-Clause */
/* Another way to move grains, whole: constant velocities, no contacts (engine/physics.h tells what a mover must do). It stands
 * in the place of the physics of density, whose section asks for it.
 * Ranks: 1 2 3 */
#include "tests/test.h"

#include "engine/physics.h"
#include "scree.h"
#include "team.h"

#include <math.h>
#include <string.h>

static double drift(const struct physics_context *context, int thread, size_t first, size_t last,
                    int size_class) {
    struct particles *p = context->particles;
    size_t stride = (size_t)p->force_stride;
    double fastest = 0, sum = 0;
    (void)thread, (void)size_class;
    for (size_t i = first; i < last; i++) {
        double *x = p->state[i].x, *v = p->state[i].v, square = 0;
        for (int d = 0; d < context->box->dimension; d++) {
            x[d] += context->clock->dt * v[d];
            square += v[d] * v[d];
        }
        memset(p->force + i * stride, 0, stride * sizeof *p->force);
        fastest = fmax(fastest, square);
        sum += square;
    }
    return fastest + 0 * sum; /* what is no number must be told */
}

static const struct physics_pass pass = {
    .name = "drift", .place = PASS_MOVE, .reads = "velocity", .writes = "position force", .rows = drift};
static const struct physics_mover mover = {0};
const struct physics density_physics = {.name = "density", .passes = 1, .pass = &pass, .mover = &mover};

enum { GRAINS = 300, STEPS = 50, MOMENTUM = 2 };

static const char scene[] =
    "units: none\nthreads: 2\ngravity: [0, 0, -9]\nbox: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: "
    "true}\n"
    "number_density: {support: 1}\nstep: {dt: 0.01, count: 50}\nskin: 0.3\ncontact: {law: hooke}\n"
    "materials: [{name: a, density: 1}]\nmaterial_pairs: [{restitution: 0.5, friction: 0.5, k_n: 1000}]\n"
    "particles: {from: random, count: 300, sizes: 0.2, velocity_sigma: 5}\n"
    "observables: {every: 10, list: [{name: particles}, {name: momentum}, {name: energy_kinetic}]}\n";

struct state {
    double x[GRAINS + 1][3], v[GRAINS + 1][3];
};

/* Positions and velocities of all ranks, by id. */
static void look(struct team *team, const struct scree_simulation *s, struct state *state) {
    struct scree_field x, v, id;
    memset(state, 0, sizeof *state);
    if (!team_expect(team,
                     scree_field(s, "position", &x) && scree_field(s, "velocity", &v) &&
                         scree_field(s, "id", &id),
                     "no fields"))
        return;
    for (size_t k = 0; k < x.count; k++) {
        int64_t number = *(int64_t *)((char *)id.data + k * id.stride);
        memcpy(state->x[number], (char *)x.data + k * x.stride, sizeof *state->x);
        memcpy(state->v[number], (char *)v.data + k * v.stride, sizeof *state->v);
    }
    comm_sum(&team->comm, state->x[0], 3 * (GRAINS + 1));
    comm_sum(&team->comm, state->v[0], 3 * (GRAINS + 1));
}

/* The mover's velocities are those at the end of a step, whatever gravity is; the rows of observables show them so. */
static void grains_keep_their_velocities(void **test) {
    struct team *team = *test;
    static struct state before, after;
    struct scree_options options = {.communicator = &team->comm.handle};
    struct scree_error error;
    struct scree_simulation *s = scree_create("scene", scene, &options, &error);
    if (s)
        look(team, s, &before);
    if (team_expect(team, s != NULL, "%s", error.text) &&
        team_expect(team, scree_step(s, STEPS, &error), "%s", error.text)) {
        look(team, s, &after);
        double worst = 0, sum[3] = {0};
        for (int k = 1; k <= GRAINS; k++)
            for (int d = 0; d < 3; d++) {
                double apart = after.x[k][d] - before.x[k][d] - STEPS * 0.01 * before.v[k][d];
                worst = fmax(worst, fabs(remainder(apart, 8)));
                sum[d] += before.v[k][d] * 4 / 3 * M_PI * 0.2 * 0.2 * 0.2;
            }
        team_expect(team, worst < 1e-12, "a grain is %g from its line", worst);
        team_expect(team, memcmp(before.v, after.v, sizeof before.v) == 0, "velocities have changed");
        for (size_t r = 0; r < scree_rows(s); r++)
            for (int d = 0; d < 3; d++) {
                double shown = scree_row(s, r)[MOMENTUM + d];
                team_expect(team, fabs(shown - sum[d]) < 1e-10, "row %zu shows a momentum of %g, not %g", r,
                            shown, sum[d]);
            }
        team_expect(team, scree_rows(s) == 1 + STEPS / 10, "%zu rows", scree_rows(s));
    }
    if (s)
        scree_destroy(&s);
    team_finish(team);
}

TEAM_MAIN(mover, team_case(grains_keep_their_velocities))
