/* SPDX-License-Identifier: BSD-3-Clause */
/* The files of output.contact_problems: the facet of a table in engine/physics.h. Read local_form.h first. */
#include "base/file.h"
#include "engine/physics.h"
#include "physics/hard/hard_state.h"
#include "physics/hard/local_form.h"
#include <string.h>

bool hard_file_open(const struct physics_context *context, const char *directory, int64_t step,
                    struct error *error) {
    struct hard *hard = context->self;
    (void)error;
    snprintf(hard->directory, sizeof hard->directory, "%s", directory);
    if (context->comm->rank == 0)
        contact_problem_discard(directory, step);
    hard->written = -1;
    return true;
}

static bool file_write(const struct physics_context *context, const struct hard_form *local,
                       struct error *error) {
    const struct hard *hard = context->self;
    const struct clock *clock = context->clock;
    char described[320];
    snprintf(described, sizeof described,
             "step %llu, t = %.17g; the solver ended with the residual %.3g after %d sweeps. Velocities and "
             "impulses in the units "
             "of the scene. Springs of contacts are in the diagonal of W and in q",
             (unsigned long long)clock->step, clock->time, hard->last.residual, hard->last.sweeps);
    const struct contact_problem problem = {
        .contacts = local->contacts,
        .start = local->start,
        .row = local->row,
        .value = local->value,
        .q = local->q,
        .mu = local->mu,
        .r = local->r,
        .u = local->u,
        .soft = local->soft,
        .shift = local->shift,
        .id = local->id,
        .dt = clock->dt,
        .gravity = sqrt(vector_dot(context->scene->gravity, context->scene->gravity)),
        .described = described};
    return contact_problem_write(hard->directory, clock->step, &problem, error);
}

bool hard_file_write(const struct physics_context *context, struct error *error) {
    struct hard *hard = context->self;
    const struct clock *clock = context->clock;
    struct hard_form local;
    if (hard->written == (int64_t)clock->step ||
        !output_interval_due(&context->scene->output.contact_problems.every, clock->step, clock->time,
                             clock->dt))
        return true;
    hard->written = (int64_t)clock->step;
    bool good = hard_form_make(&local, &hard->solver, context->particles);
    if (!good)
        error_set(error, ERROR_SYSTEM,
                  "output.contact_problems: the matrix of step %llu has more numbers than FCLIB's format",
                  (unsigned long long)clock->step);
    else if (local.contacts > 0)
        good = file_write(context, &local, error);
    hard_form_free(&local);
    return good;
}
