/* SPDX-License-Identifier: BSD-3-Clause */
/* How the contacts of each pair of materials answer, from the law of the scene. Read contacts.h first. */
#include "base/memory.h"
#include "physics/grains/grains.h"
#include "physics/grains/laws/law_cohesion.h"
#include "physics/hard/hard_state.h"

/* Rolling and twisting by the law's parts. */
static void resistances_take(struct hard_term *term, const struct law *law, int a, int b) {
    const struct law_extra *extra = law_extra_of(law, a, b);
    const struct law_solved twisting = law_twisting_solved(law->options.twisting, extra);
    term->rolls = law_rolling_solved(law->options.rolling, extra);
    term->rolling = law_pair_of(law, a, b)->rolling_friction;
    term->twisting = twisting.limit;
    term->twist_stiffness = twisting.stiffness;
}

/* The pull of a cohesion that is constant while the surfaces touch, over the effective radius. */
static double pull_of(const struct law *law, int a, int b) {
    const struct law_surfaces surfaces = {law_pair_of(law, a, b), law_extra_of(law, a, b), {2.0, 2.0}, 1.0};
    return law_cohesion_pull(law->options.cohesion, &surfaces, 1.0, false).force;
}

void hard_terms_make(struct hard_terms *terms, const struct physics_context *context,
                     const struct hard_options *options) {
    const struct scene *scene = context->scene;
    const struct law *law = &grains_of(context->set)->law;
    const struct law_form *form = law_form_of(&law->options);
    bool stiff = law_has_trait(law->options.normal, "stiff");
    *terms = (struct hard_terms){.kappa = stiff ? options->kappa : 0.0,
                                 .repair = options->repair,
                                 .hertz = !stiff && !form->linear,
                                 .relax = hard_relax_model((enum hard_model_number)options->model)->relax,
                                 .poisson = options->restitution == HARD_RESTITUTION_POISSON,
                                 .open = options->model == HARD_MODEL_PROJECTION,
                                 .press = law_cohesion_form_of(law->options.cohesion)->press - 1.0};
    bool slick = options->model == HARD_MODEL_FRICTIONLESS;
    terms->materials = scene->materials;
    terms->pair = memory_allocate_zero((size_t)(scene->materials * scene->materials), sizeof *terms->pair,
                                       "hard contacts");
    for (int a = 0; a < scene->materials; a++)
        for (int b = 0; b < scene->materials; b++) {
            const struct law_coefficients *c = law_pair_of(law, a, b);
            struct hard_term *term = &terms->pair[a * scene->materials + b];
            *term = (struct hard_term){.friction = slick ? 0.0 : c->friction,
                                       .restitution = scene_law_pair(scene, a, b)->restitution,
                                       .pull = pull_of(law, a, b)};
            if (!slick)
                resistances_take(term, law, a, b);
            terms->resists = terms->resists || term->rolling > 0.0 || term->twisting > 0.0;
            terms->pulls = terms->pulls || term->pull > 0.0;
            if (stiff)
                continue;
            term->stiffness = c->k_n;
            term->tangential = c->k_t;
            term->damper = c->c_n;
        }
}
