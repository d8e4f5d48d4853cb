/* SPDX-License-Identifier: BSD-3-Clause */
/* The step with rigid grains. Read rigid_step.h first. */
#include "physics/fluid/coupling/rigid_step.h"
#include "physics/fluid/coupling/rigid_sums.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include "physics/fluid/schemes/projection_parts.h"
#include <math.h>
#include <string.h>

void rigid_step_pairs(const struct physics_context *context, struct rigid *rigid,
                      const struct pair_rows *pairs) {
    struct kind_span span = kinds_span(context->particles, context->classes, KIND_FLUID);
    rigid_walls_find(&rigid->walls, context, ((const struct fluid *)context->self)->filled);
    if (rigid->section == NULL)
        rigid->section = rigid_bodies_sections(context);
    solid_pairs_take(&rigid->solid, pairs, kinds_of(context->particles), span.first, span.end);
}

static struct solid_places places_of(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    const struct fluid_options *options = fluid->options;
    return (struct solid_places){
        .bodies = context->scene->physics_given[PHYSICS_bodies] ? context : NULL,
        .state = context->particles->state,
        .shift = (const double(*)[4])context->list[0]->shift,
        .first = fluid->weights.first,
        .at_wall = fluid->rigid->walls.part,
        .at_walls = fluid->rigid->walls.parts,
        .spacing = options->spacing,
        .hydraulic = options->grains.hydraulic,
        .kappa = solid_kappa(options->spacing, options->viscosity / options->density, grain_dt(context)),
        .dimension = context->box->dimension};
}

static void solid_fill(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    rigid_walls_place(&fluid->rigid->walls, context, fluid->weights.first, fluid->weights.rows);
    struct solid_places places = places_of(context);
    solid_field_make(&fluid->rigid->solid, &places, fluid->weights.rows,
                     rigid_fields_solid(context->particles) + fluid->weights.first);
}

/* Memory for the nodes and grains of this step. */
static void room(struct rigid *rigid, size_t rows, size_t grains) {
    if (rigid->rows != rows)
        rigid->bare = memory_resize(rigid->bare, rows, sizeof *rigid->bare, "grains in a fluid");
    if (rigid->solid.nodes > rigid->parts_room || rigid->try == NULL) {
        rigid->parts_room = rigid->solid.nodes + rigid->solid.nodes / 8;
        rigid->try = memory_resize(rigid->try, rigid->parts_room, sizeof *rigid->try, "grains in a fluid");
        rigid->lack = memory_resize(rigid->lack, rigid->parts_room, sizeof *rigid->lack, "grains in a fluid");
    }
    if (rigid->grains != grains)
        rigid->sums = memory_resize(rigid->sums, grains, sizeof *rigid->sums, "grains in a fluid");
    rigid->rows = rows;
    rigid->grains = grains;
}

/* out[node] = the forcing that goes with v: which becomes it. Collective. */
static void forcing_find(const struct rigid_work *work, double (*v)[3]) {
    const struct solid_field *solid = &work->rigid->solid;
    const double(*found)[6] = (const double(*)[6])rigid_fields_found(work->context->particles);
    rigid_sums_momenta(work, (const double(*)[3])v);
    rigid_sums_motions(work);
#pragma omp parallel for schedule(static)
    for (size_t node = 0; node < solid->nodes; node++) {
        double sum[3] = {0}, rigid[3];
        for (size_t k = solid->start[node]; k < solid->start[node + 1]; k++) {
            const struct solid_part *part = &solid->part[k];
            rigid_grains_velocity(rigid_motion_at(work->rigid, found, part), part->arm, rigid);
            for (int d = 0; d < work->context->box->dimension; d++)
                sum[d] += part->share * (rigid[d] - v[node][d]);
        }
        memcpy(v[node], sum, sizeof sum);
    }
}

static size_t row_of(const struct solid_field *solid, size_t node) {
    return solid->part[solid->start[node]].row;
}

/* v = w - dt / rho grad phi at the nodes of grains, phi in flow->increment. Collective. */
static void bare_find(const struct rigid_work *work, double (*v)[3]) {
    struct projection *projection = work->fluid->projection;
    const struct solid_field *solid = &work->rigid->solid;
    flow_forward(work->flow, FLOW_INCREMENT);
    operators_gradient(work->flow->weights, flow_increment(work->flow), projection->gradient);
    for (size_t node = 0; node < solid->nodes; node++) {
        size_t row = row_of(solid, node);
        for (int d = 0; d < 3; d++)
            v[node][d] = work->rigid->bare[row][d] - work->share * projection->gradient[row][d];
    }
}

/* flow->predicted = w + q. */
static void predicted_set(const struct rigid_work *work) {
    const struct solid_field *solid = &work->rigid->solid;
    size_t first = work->flow->weights->first;
    memcpy(work->flow->predicted + 3 * first, work->rigid->bare,
           work->rigid->rows * sizeof *work->rigid->bare);
    for (size_t node = 0; node < solid->nodes; node++)
        for (size_t d = 0; d < 3; d++)
            work->flow->predicted[3 * (first + row_of(solid, node)) + d] += work->rigid->try[node][d];
}

/* The largest |w| and |q|. Collective. */
static double speed_of(const struct rigid_work *work) {
    double most = 0;
    for (size_t row = 0; row < work->rigid->rows; row++) {
        const double *w = work->rigid->bare[row];
        most = fmax(most, w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
    for (size_t node = 0; node < work->rigid->solid.nodes; node++) {
        const double *q = work->rigid->try[node];
        most = fmax(most, q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    }
    comm_max(work->context->comm, &most, 1);
    return sqrt(most);
}

/* What q lacks: root mean square over the nodes of grains. Collective. */
static double size_of_lack(const struct rigid_work *work) {
    double sum[2] = {0, (double)work->rigid->solid.nodes};
    for (size_t node = 0; node < work->rigid->solid.nodes; node++)
        for (int d = 0; d < 3; d++)
            sum[0] += work->rigid->lack[node][d] * work->rigid->lack[node][d];
    comm_sum(work->context->comm, sum, 2);
    return sqrt(sum[0] / fmax(sum[1], 1));
}

/* Tells once of a fixed point that was not found. */
static void doubt(const struct rigid_work *work, double lack, double wanted) {
    const struct physics_context *context = work->context;
    if (!(lack > 10 * wanted) || work->rigid->apart)
        return;
    work->rigid->apart = true;
    if (work->fluid->first)
        log_tell(work->fluid->log,
                 "warning: fluid.grains: after %d iterations the fluid in grains and their motion differ by "
                 "%.2g of the speed at step %llu, t = %.9g: a shorter step may help (said once)",
                 RIGID_ITERATIONS, RIGID_TOLERANCE * lack / wanted, (unsigned long long)context->clock->step,
                 context->clock->time);
}

/* The fixed point of q. False, with an error, if a solver failed. Collective. */
static bool forcing_loop(const struct rigid_work *work, struct error *error) {
    struct rigid *rigid = work->rigid;
    const struct solid_field *solid = &rigid->solid;
    bare_find(work, rigid->try);
    forcing_find(work, rigid->try);
    double wanted = RIGID_TOLERANCE * speed_of(work), lack = INFINITY;
    anderson_begin(&rigid->anderson, work->context->comm, 3 * solid->nodes);
    for (int n = 0;; n++) {
        predicted_set(work);
        if (!projection_project(work->fluid->projection, work->flow, work->dt, true, error))
            return false;
        rigid->iterations++;
        bare_find(work, rigid->lack);
        forcing_find(work, rigid->lack);
        for (size_t node = 0; node < solid->nodes; node++)
            for (int d = 0; d < 3; d++)
                rigid->lack[node][d] -= rigid->try[node][d];
        lack = size_of_lack(work);
        if (!(lack > wanted) || n + 1 == RIGID_ITERATIONS)
            break;
        anderson_next(&rigid->anderson, &rigid->try[0][0], &rigid->lack[0][0]);
    }
    rigid->steps++;
    doubt(work, lack, wanted);
    return true;
}

/* At the start the fluid in grains moves with them. Collective. */
static void flow_begin(const struct rigid_work *work) {
    const struct physics_context *context = work->context;
    const struct solid_field *solid = &work->rigid->solid;
    struct particles *p = context->particles;
    for (size_t i = work->grains.first; i < work->grains.end; i++)
        memcpy(rigid_fields_found(p)[i], rigid_fields_motion(p)[i], sizeof rigid_fields_found(p)[i]);
    if (context->ghosts != NULL) {
        struct field_list list = fields_one(rigid_fields_found_handle(p));
        ghosts_forward_begin(context->ghosts, p, &list);
        ghosts_forward_end(context->ghosts, p);
    }
    for (size_t node = 0; node < solid->nodes; node++) {
        double *u = flow_velocity_of(work->flow, row_of(solid, node)), sum[3] = {0}, rigid[3];
        for (size_t k = solid->start[node]; k < solid->start[node + 1]; k++) {
            const struct solid_part *part = &solid->part[k];
            rigid_grains_velocity(
                rigid_motion_at(work->rigid, (const double(*)[6])rigid_fields_found(p), part), part->arm,
                rigid);
            for (int d = 0; d < context->box->dimension; d++)
                sum[d] += part->share * (rigid[d] - u[d]);
        }
        for (int d = 0; d < 3; d++)
            u[d] += sum[d];
    }
    flow_forward(work->flow, FLOW_VELOCITY);
}

/* The fields that the next step reads: q and phi. */
static void memory_take(const struct rigid_work *work, bool before) {
    struct particles *p = work->context->particles;
    size_t first = work->flow->weights->first, rows = work->rigid->rows;
    double *potential = rigid_fields_potential(p) + first, *increment = work->flow->increment + first;
    memcpy(before ? increment : potential, before ? potential : increment, rows * sizeof *potential);
}

/* u, p and q at the end of the step. Collective. */
static void flow_end(const struct rigid_work *work, double theta) {
    struct rigid *rigid = work->rigid;
    double(*forcing)[3] = rigid_fields_forcing(work->context->particles) + work->flow->weights->first;
    for (size_t node = 0; node < rigid->solid.nodes; node++)
        for (int d = 0; d < 3; d++)
            rigid->try[node][d] += rigid->lack[node][d];
    predicted_set(work);
    projection_correct(work->fluid->projection, work->flow, theta * work->fluid->options->viscosity,
                       work->share);
    memset(forcing, 0, rigid->rows * sizeof *forcing);
    for (size_t node = 0; node < rigid->solid.nodes; node++)
        memcpy(forcing[row_of(&rigid->solid, node)], rigid->try[node], sizeof *forcing);
}

static struct rigid_work work_make(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    struct rigid_work work = {
        .context = context, .fluid = fluid, .rigid = fluid->rigid, .flow = &fluid->flow};
    work.grains = rigid_bodies_span(context);
    work.dt = grain_dt(context);
    work.share = work.dt / fluid->options->density;
    work.kappa = places_of(context).kappa;
    solid_fill(context);
    room(work.rigid, fluid->weights.rows, work.grains.end - work.grains.first);
    rigid_sums_moments(&work);
    return work;
}

bool rigid_step(const struct physics_context *context, struct error *error) {
    struct fluid *fluid = context->self;
    rigid_walls_move(&fluid->rigid->walls, context, fluid->past.steps == 0);
    struct rigid_work work = work_make(context);
    size_t first = work.flow->weights->first, dimension = (size_t)context->box->dimension;
    double(*forcing)[3] = rigid_fields_forcing(context->particles) + first,
    theta = projection_theta(&fluid->past);
    const struct projection_push push = {work.dt, fluid->drive.force, (const double(*)[3])forcing};
    if (fluid->past.steps == 0)
        flow_begin(&work);
    if (!projection_predict(fluid->projection, work.flow, &fluid->past, &push, error))
        return false;
    for (size_t row = 0; row < work.rigid->rows; row++)
        for (size_t d = 0; d < 3; d++) /* in two dimensions output has left the vorticity at z */
            work.rigid->bare[row][d] =
                d < dimension ? work.flow->predicted[3 * (first + row) + d] - forcing[row][d] : 0;
    memory_take(&work, true);
    if (!forcing_loop(&work, error))
        return false;
    memory_take(&work, false);
    flow_end(&work, theta);
    rigid_sums_loads(&work);
    fluid->past = (struct projection_past){fluid->past.steps + 1, work.dt};
    return true;
}

void rigid_step_look(const struct physics_context *context) {
    const struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    struct kind_span grains = rigid_bodies_span(context);
    double(*load)[6] = fluid_load(p), *drag = fluid_drag(p);
    solid_fill(context);
    for (size_t i = grains.first; i < grains.end; i++) {
        bool member = rigid_bodies_member(p, i);
        double displaced =
            member ? 0
                   : rigid_bodies_inertia(context, (const double(*)[2])fluid->rigid->section, i).displaced;
        for (int d = 0; d < context->box->dimension; d++)
            drag[3 * i + (size_t)d] =
                member || isnan(load[i][d])
                    ? 0
                    : load[i][d] - fluid->drive.force[d] * displaced / fluid->options->density;
    }
}

void rigid_step_free(struct rigid *rigid) {
    solid_field_free(&rigid->solid);
    rigid_walls_free(&rigid->walls);
    anderson_free(&rigid->anderson);
    memory_free(rigid->bare);
    memory_free(rigid->try);
    memory_free(rigid->lack);
    memory_free(rigid->sums);
    memory_free(rigid->section);
}
