/* SPDX-License-Identifier: BSD-3-Clause */
/* An electrolyte in a slit between two walls: the profile of Debye and Hueckel, the charge that balances that of the walls, the force of the
 * applied field on it.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "fluid_run.h"
#include "team.h"
#include "physics/fluid/carried/electrolyte.h"
#include "physics/fluid/carried/electrolyte_fields.h"

#include <math.h>
#include <stdio.h>

enum { TEXT_MAX = 2048 };
static const double width = 0.5, debye_length = 0.25, voltage = 0.5, permittivity = 2, along = 3;

/* A slit between walls at y = 0 and 1 with a field along x, and what holds on its floor and its ceiling. */
static bool slit_make(struct fluid_run *run, struct team *team, const char *equation, const char *floor,
                      const char *ceiling) {
    char text[TEXT_MAX];
    snprintf(text, sizeof text,
             "units: none\nthreads: 1\n"
             "box: {lower: [0, 0, 0], upper: [%g, 1, 0], periodic: [true, false, false], dimension: 2}\n"
             "walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]},"
             " {name: ceiling, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}]\n"
             "step: {count: 1}\n"
             "fluid:\n  spacing: 0.03125\n  density: 1\n  viscosity: 1\n  equations: stokes\n  time: steady\n"
             "  electrolyte: {equation: %s, permittivity: %g, debye_length: %g, thermal_voltage: %g,"
             " field: [%g, 0, 0], surfaces: [{wall: floor, %s}, {wall: ceiling, %s}]}\n",
             width, equation, permittivity, debye_length, voltage, along, floor, ceiling);
    if (!fluid_run_begin(run, team, text, false))
        return false;
    electrolyte_step(run->context);
    return team_expect(team, run->fluid->error.kind == ERROR_NONE, "%s", run->fluid->error.text);
}

/* psi = zeta cosh((y - 1/2) / lambda) / cosh(1 / (2 lambda)) between walls of one zeta, of second order in the spacing (an eighth of lambda:
 * within 0.5 %); the charge density is -epsilon / lambda^2 psi. */
static void ions_screen_the_walls(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    const double zeta = 0.07;
    double worst = 0, apart = 0;
    if (slit_make(&run, team, "debye_hueckel", "zeta: 0.07", "zeta: 0.07")) {
        const struct particles *p = run.context->particles;
        for (size_t row = 0; row < run.fluid->weights.rows; row++) {
            size_t i = run.fluid->weights.first + row;
            double psi = electrolyte_potential(p)[i], charge = electrolyte_charge(p)[i];
            double exact = zeta * cosh((p->state[i].x[1] - 0.5) / debye_length) / cosh(0.5 / debye_length);
            worst = fmax(worst, fabs(psi - exact) / zeta);
            apart = fmax(apart, fabs(charge + permittivity / (debye_length * debye_length) * psi));
        }
        team_expect(team, worst < 5e-3, "the potential is off by %g of zeta", worst);
        team_expect(team, apart < 1e-12, "the charge density is off by %g", apart);
    }
    fluid_run_free(&run);
    team_finish(team);
}

/* Gauss: a lattice between walls of given charge holds minus that charge, to the tolerance of the solver, whatever the potential is, here one of
 * several thermal voltages; each particle is pushed by its charge times the field, which is the applied one. */
static void ions_balance_the_walls(void **state) {
    struct team *team = *state;
    struct fluid_run run;
    double sum[2] = {0}, worst = 0, most = 0;
    if (slit_make(&run, team, "poisson_boltzmann", "charge: 30", "charge: -12")) {
        const struct particles *p = run.context->particles;
        for (size_t row = 0; row < run.fluid->weights.rows; row++) {
            size_t i = run.fluid->weights.first + row;
            double charge = electrolyte_charge(p)[i], volume = run.fluid->weights.volume[row];
            const double *push = run.fluid->flow.body[row];
            sum[0] += volume * charge;
            sum[1] += volume * push[0];
            worst = fmax(worst, fabs(electrolyte_field(p)[3 * i] - along) + fabs(push[1]) / fabs(charge));
            most = fmax(most, fabs(electrolyte_potential(p)[i]) / voltage);
        }
        comm_sum(&team->comm, sum, 2);
        comm_max(&team->comm, &most, 1);
        team_expect(team, most > 3, "the potential reaches %g thermal voltages only", most);
        team_expect(team, fabs(sum[0] / (-18 * width) - 1) < 1e-6, "charge %.10g, not %g", sum[0],
                    -18 * width);
        team_expect(team, fabs(sum[1] / (-18 * width * along) - 1) < 1e-6, "force %.10g", sum[1]);
        team_expect(team, worst < 1e-6, "the field is off by %g", worst);
    }
    fluid_run_free(&run);
    team_finish(team);
}

TEAM_MAIN(fluid_electrolyte, team_case(ions_screen_the_walls), team_case(ions_balance_the_walls))
