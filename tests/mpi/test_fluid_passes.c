/* SPDX-License-Identifier: BSD-3-Clause */
/* The longest step that the flow of a fluid allows: half a spacing at the largest speed of all ranks, and no limit where nothing is carried.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "kernel/particles/kinds.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/schemes/fluid_passes.h"
#include "team.h"

#include <math.h>

/* On each rank a point of the fluid, faster from rank to rank, and a grain that is faster still. */
struct room {
    struct fluid_options options;
    struct fluid fluid;
    struct physics_context context;
};

static void room_make(struct room *r, struct team *team) {
    *r = (struct room){.options = {.spacing = 0.1,
                                   .time = FLUID_TRANSIENT,
                                   .equations = FLUID_NAVIER_STOKES,
                                   .grains = {.every = 4, .unresolved = NAN}}};
    struct particles *p = particles_create(2);
    kinds_register(p);
    for (int k = 0; k < 2; k++) {
        size_t i = particles_append(p);
        kinds_of(p)[i] = k == 0 ? KIND_FLUID : KIND_GRAIN;
        p->state[i].v[0] = 3.0 * (team->comm.rank + 1 + 10 * k);
        p->state[i].v[1] = -4.0 * (team->comm.rank + 1 + 10 * k);
    }
    r->fluid.options = &r->options;
    r->context = (struct physics_context){
        .self = &r->fluid, .options = &r->options, .comm = &team->comm, .particles = p};
}

static void expect(struct team *team, const struct room *r, double most, double limit) {
    double found = fluid_passes_limit(&r->context, most);
    team_expect(team, fabs(found - limit) < 1e-15, "a limit of %g, not %g", found, limit);
}

static void steps_go_by_half_a_spacing(void **state) {
    struct team *team = *state;
    struct room r;
    room_make(&r, team);
    double speed = 5.0 * team->comm.size;
    expect(team, &r, 1, 0.5 * 0.1 / speed);
    expect(team, &r, 1e-3, 1e-3);
    r.options.grains.motion = FLUID_GRAINS_FREE; /* then the fluid makes one step in four */
    expect(team, &r, 1, 0.5 * 0.1 / speed / 4);
    r.options.opens = 2; /* what comes in through a side is faster than all that is there */
    r.options.open[0] =
        (struct fluid_open){.side = 0, .profile = FLUID_PLUG, .velocity = {0, 12, 35}, .pressure = NAN};
    r.options.open[1] = (struct fluid_open){.side = 1, .velocity = {NAN, NAN, NAN}, .pressure = 0};
    expect(team, &r, 1, 0.5 * 0.1 / 37 / 4);
    r.options.equations = FLUID_STOKES; /* nothing is carried */
    expect(team, &r, 1, 1);
    r.options.time = FLUID_STEADY; /* the steps are those of scalars alone, else of the length 1 */
    expect(team, &r, 7, 1);
    r.fluid.scalars = (struct scalars *)&r;
    expect(team, &r, 7, 7);
    particles_destroy(&r.context.particles);
    team_finish(team);
}

TEAM_MAIN(fluid_passes, team_case(steps_go_by_half_a_spacing))
