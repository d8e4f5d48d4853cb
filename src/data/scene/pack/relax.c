/* SPDX-License-Identifier: BSD-3-Clause */
/* Repeats sweeps until nothing overlaps. Read relax.h first. */
#include "data/scene/pack/relax.h"

#include "data/scene/pack/pack_search.h"

/* Displacement of a sweep, in units of the one that brings the stiffest direction to rest. */
static const double step_factor = 2;

struct relaxing {
    const struct pile *pile;
    const struct relax_options *options;
    struct pack_search *search;
    struct pushes *pushes;
    struct relax_state state;
};

/* True at the end. A new search for pairs precedes the end, as wrapping moves particles by a rounding error,
 * and walls move them last. */
static bool is_done(struct relaxing *r) {
    double largest[CLASS_MAX];
    if (r->state.overlap > r->options->bound)
        return false;
    push_move(r->pushes, r->pile, 0, largest);
    pack_search_run(r->search);
    r->state.overlap = push_all(r->pushes, r->search);
    return r->state.overlap <= r->options->bound;
}

static bool relax_all(struct relaxing *r, struct error *error) {
    const struct relax_options *options = r->options;
    double largest[CLASS_MAX];
    pack_search_run(r->search);
    for (r->state.sweep = 1; r->state.sweep <= options->sweeps; r->state.sweep++) {
        r->state.overlap = push_all(r->pushes, r->search);
        if (is_done(r))
            return true;
        push_move(r->pushes, r->pile, step_factor, largest);
        if (pack_search_moved(r->search, largest))
            pack_search_run(r->search);
        r->state.searches = r->search->searches;
        if (options->show)
            options->show(options->context, &r->state);
    }
    return error_set(
        error, ERROR_USER,
        "after %d sweeps particles still overlap by up to %.2g of the smaller one's radius: this is too "
        "dense to be packed at random",
        options->sweeps, r->state.overlap);
}

bool relax_run(const struct pile *pile, const struct relax_options *options, struct relax_state *state,
               struct error *error) {
    struct particles *particles = pile->particles;
    struct relaxing r = {.pile = pile, .options = options};
    *state = r.state;
    if (particles->owned == 0)
        return true;
    r.search = pack_search_create(particles, pile->box, options->gap, options->threads, error);
    if (r.search == NULL)
        return false;
    r.pushes = push_create(particles->owned, r.search->classes.radius_min[0], options->gap, options->threads);
    bool good = relax_all(&r, error);
    *state = r.state;
    push_destroy(&r.pushes);
    pack_search_destroy(&r.search);
    return good;
}
