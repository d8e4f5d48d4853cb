/* SPDX-License-Identifier: BSD-3-Clause */
/* What hard contacts say before, in and after a run. Read hard_state.h first. */
#include "base/vector.h"
#include "engine/notes.h"
#include "engine/physics.h"
#include "physics/grains/grains.h"
#include "physics/hard/hard_state.h"
#include <math.h>

/* Noted before a run: overlaps over the smaller radius above these, at rest and in an impact, and news slower than so many
 * expected speeds. */
static const double overlap_most = 0.01, impact_most = 0.1, news_least = 3.0;

bool hard_has_price(const struct hard *hard) {
    return hard->solver.terms.kappa > 0.0 && isfinite(hard->solver.terms.kappa);
}

struct hard_price hard_price_of(const struct physics_context *context) {
    const struct hard *hard = context->self;
    double kappa = hard->solver.terms.kappa, dt = context->clock->dt;
    double g = sqrt(vector_dot(context->scene->gravity, context->scene->gravity));
    double speed = grains_of(context->set)->stable.speed_most;
    return (struct hard_price){.news = sqrt(kappa) * 2.0 * hard->sizes.smallest / dt,
                               .overlap = (1.0 + hard->sizes.heavy / hard->sizes.light) * g * dt * dt /
                                          (kappa * hard->sizes.smallest),
                               .impact = speed * dt * cbrt(hard->sizes.heavy / hard->sizes.light) /
                                         (sqrt(kappa) * hard->sizes.smallest)};
}

void hard_report(const struct physics_context *context, struct report_part *part) {
    const struct hard *hard = context->self;
    part->contacts = &hard->most;
    struct report_solver row = {.name = "contacts",
                                .rows = hard->last.rows,
                                .solves = hard->solves,
                                .iterations = hard->sweeps,
                                .doubtful = hard->unmet,
                                .residual = hard->last.residual,
                                .residual_worst = hard->worst};
    part->solver[part->solvers++] = row;
    if (hard->solver.options.method != HARD_NEWTON)
        return;
    row.name = "newton";
    row.solves = hard->refined;
    row.iterations = hard->steps;
    part->solver[part->solvers++] = row;
    part->solver[part->solvers++] =
        (struct report_solver){.name = "newton_step", .solves = hard->steps, .iterations = hard->iterations};
}

void hard_notes(const struct physics_context *context, struct notes *notes) {
    const struct hard *hard = context->self;
    double kappa = hard->solver.terms.kappa, dt = context->clock->dt;
    struct hard_price price = hard_price_of(context);
    if (!hard_has_price(hard))
        return;
    if (price.news < news_least * notes->speed_expected) {
        double more = news_least * notes->speed_expected / price.news;
        notes_add(
            notes, false,
            "contact.solver.kappa: news travels at %.4g, less than %g times the expected speed; kappa: %.3g "
            "or a step of %.3g is %g times that",
            price.news, news_least, more * more * kappa, dt / more, news_least);
    }
    if (price.overlap > overlap_most)
        notes_add(
            notes, false,
            "contact.solver.kappa: the heaviest grain at rest on one of the lightest overlaps it by %.2g of "
            "its radius, more than %g; a bed shares the load, one grain needs kappa: %.3g with as many "
            "sweeps, or a step of %.3g",
            price.overlap, overlap_most, kappa * price.overlap / overlap_most,
            dt * sqrt(overlap_most / price.overlap));
    if (price.impact > impact_most)
        notes_add(
            notes, false,
            "step.dt: the heaviest grain that lands on a bed of the lightest at the expected speed overlaps "
            "them by about %.2g of their radius, more than %g; needed is a step of %.3g",
            price.impact, impact_most, dt * impact_most / price.impact);
}

/* News that was slower than the flow. */
void hard_seen(const struct physics_context *context, uint64_t first, struct notes *notes) {
    const struct hard *hard = context->self;
    double fastest = hard->most.fastest, more = news_least * fastest / hard_price_of(context).news;
    (void)first;
    if (hard_has_price(hard) && more > 1.0)
        notes_add(notes, false,
                  "contact.solver.kappa: grains were as fast as %.4g, and news travels at %.4g, less than %g "
                  "times that; kappa: %.3g or a shorter step is %g times that",
                  fastest, hard_price_of(context).news, news_least, more * more * hard->solver.options.kappa,
                  news_least);
}

static size_t contact_bytes(const struct hard_solver *solver) {
    size_t bytes = sizeof(struct hard_row) + sizeof(struct hard_memory);
    if (solver->options.method == HARD_NEWTON)
        bytes += sizeof(struct hard_newton_row) + sizeof(hard_block);
    if (solver->terms.resists)
        bytes += sizeof(struct hard_resist) + sizeof(struct hard_couple);
    if (solver->terms.open || solver->clumps.links)
        bytes += sizeof(struct hard_arm);
    return bytes;
}

/* What cohesion does to two of the smallest grains. */
static void pull_print(const struct physics_context *context, FILE *file) {
    const struct hard *hard = context->self;
    const struct hard_terms *terms = &hard->solver.terms;
    double most = 0.0, g = sqrt(vector_dot(context->scene->gravity, context->scene->gravity));
    for (int k = 0; k < terms->materials * terms->materials; k++)
        most = fmax(most, terms->pair[k].pull);
    if (!(most > 0.0) || isinf(hard->sizes.light))
        return;
    double force = 0.5 * hard->sizes.smallest * most, a = g + 2.0 * force / hard->sizes.light;
    fprintf(file, "  pull         of two of the smallest grains: %.4g", force);
    if (hard->solver.terms.kappa > 0.0)
        fprintf(file, "; impacts slower than %.3g stick", HARD_IMPACT_SPEED * a * context->clock->dt);
    fprintf(file, "\n");
}

void hard_print(const struct physics_context *context, FILE *file) {
    const struct hard *hard = context->self;
    const struct hard_solver *solver = &hard->solver;
    if (context->comm->rank > 0)
        return;
    fprintf(file, "\nsolver of contacts\n");
    fprintf(file, "  sweeps       up to %d a step, until the residual is %g\n", solver->options.sweeps,
            solver->options.tolerance);
    if (solver->options.method == HARD_NEWTON)
        fprintf(file, "  newton       up to %d steps then\n", solver->options.steps);
    if (hard_has_price(hard)) {
        struct hard_price price = hard_price_of(context);
        fprintf(file, "  news         travels about %.3g grains a step: %.4g in the smallest grains\n",
                sqrt(solver->terms.kappa), price.news);
        fprintf(file,
                "  overlap      of the heaviest grain at rest on one of the lightest: %.2g of the smallest "
                "radius\n",
                price.overlap);
        fprintf(file,
                "  impact       of the heaviest grain on a bed of the lightest: about %.2g of the smallest "
                "radius\n",
                price.impact);
    }
    pull_print(context, file);
    fprintf(file, "  memory       %zu bytes a contact\n", contact_bytes(solver));
}
