/* SPDX-License-Identifier: BSD-3-Clause */
/* Counts pairs, contacts and displacements for the choice of the skin. Read skin_auto.h first. */
#include "engine/skin_auto.h"
#include "engine/decide.h"
#include "engine/index_view.h"
#include <math.h>

/* After so many steps without a rebuild, and at each power of two of steps after, a run looks whether a shorter
 * skin pays. */
enum { LOOK_FIRST = 64 };

/* The quotient of what the filter has done since the rebuild and of what a rebuild costs, above which a run
 * rebuilds for the sake of a shorter skin. */
static const double look_worth = 1;

struct classes_options skin_auto_options(const struct scene *scene, const struct skin_choice *choice) {
    struct classes_options options = scene->classes;
    double factor = skin_choice_factor(choice->octaves);
    options.skin *= factor;
    options.skin_relative *= factor;
    return options;
}

/* The largest distance at which particles meet, with skins of `octaves`. Particles to be inserted count. */
static double farthest(const struct size_classes *classes, const struct scene *scene, int64_t before,
                       int64_t octaves) {
    double reach = 0, most = 0;
    double scale = skin_choice_factor(octaves) / skin_choice_factor(before);
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b <= a; b++) {
            double margin = classes->margin[a][b] + (scale - 1) * classes->skin[a][b];
            if (!classes_meet(classes, a, b))
                continue;
            reach = fmax(reach, classes->radius_max[a] + classes->radius_max[b] + margin);
            most = fmax(most, margin);
        }
    for (int k = 0; k < scene->insertions; k++) {
        double smallest, largest;
        sizes_bounds(&scene->insertion[k].sizes, &smallest, &largest);
        reach = fmax(reach, 2 * largest + most);
    }
    return reach;
}

/* The most octaves with which no two particles meet through two images. A run that has such pairs already, and
 * one whose copies may not go beyond neighbours, keeps its skin or shortens it (a reproducible one on a single rank,
 * too: the choice is that of all layouts). */
static int64_t octaves_most(const struct skin_choice *choice, const struct size_classes *classes,
                            const struct scene *scene, const struct box *box, bool alone) {
    int64_t now = choice->octaves;
    if (scene->ghosts.sync == GHOSTS_NEIGHBOURS && (!alone || scene->reproducible))
        return 0;
    for (int64_t k = SKIN_MOST; k > SKIN_LEAST; k--) {
        double reach = farthest(classes, scene, now, k);
        bool fits = true;
        for (int d = 0; d < 3; d++)
            fits = fits && !(box->periodic[d] && box->edge[d] <= 2 * reach);
        if (fits)
            return k;
    }
    return now;
}

double skin_auto_most(const struct skin_choice *choice, const struct size_classes *classes,
                      const struct scene *scene, const struct box *box, bool alone) {
    return skin_choice_factor(octaves_most(choice, classes, scene, box, alone));
}

static struct skin_counts counts_take(struct simulation *s, const struct skin_choice *choice) {
    bool known = s->search.skin->moves > 1; /* else a run that resumes has no contacts yet */
    int64_t sides[2] = {pairlist_sides(s->search.interactions.all),
                        known ? physics_contact_sides(&s->physics) : 0};
    comm_sum_int(s->comm, sides, 2);
    return (struct skin_counts){.particles = (double)s->total,
                                .pairs = (double)sides[0] / 2,
                                .contacts = (double)sides[1] / 2,
                                .rate = choice->steps > 0 ? choice->used / choice->steps : 0,
                                .every = (double)s->scene->step.rebuild_every,
                                .dimension = s->box.dimension};
}

/* The choice with what was used up since the last rebuild. */
static struct skin_choice choice_with(const struct search *search, const struct particles *particles,
                                      const struct size_classes *classes, const struct comm *comm) {
    struct skin_choice choice = search->choice;
    decide_displacements(search->skin, particles, classes->count, comm);
    double used = skin_used(search->skin, classes) * skin_choice_factor(choice.octaves);
    skin_choice_add(&choice, used, search->skin->moves);
    return choice;
}

void skin_auto_choose(struct simulation *s) {
    if (!s->scene->classes.skin_auto || s->search.skin->moves == 0)
        return;
    struct skin_choice choice = choice_with(&s->search, s->particles, &s->classes, s->comm);
    struct skin_counts counts = counts_take(s, &choice);
    int64_t before = choice.octaves;
    choice.octaves =
        skin_choice_best(&s->classes, &counts, before,
                         octaves_most(&s->search.choice, &s->classes, s->scene, &s->box, s->ranks.alone));
    choice.changes += choice.octaves != before;
    s->search.choice = choice;
    if (choice.octaves == before)
        return;
    struct classes_options options = skin_auto_options(s->scene, &s->search.choice);
    struct classes_range range = interactions_range(&s->search.interactions);
    classes_set_margins(&s->classes, &options, &range);
    interactions_set_margins(&s->search.interactions, &s->classes);
}

bool skin_auto_due(struct simulation *s) {
    unsigned moves = s->search.skin->moves;
    if (!s->scene->classes.skin_auto || moves < LOOK_FIRST || (moves & (moves - 1)) != 0)
        return false;
    struct skin_choice choice = choice_with(&s->search, s->particles, &s->classes, s->comm);
    struct skin_counts counts = counts_take(s, &choice);
    int64_t now = choice.octaves, best = skin_choice_best(&s->classes, &counts, now, now);
    double saved = counts.pairs - skin_choice_pairs(&s->classes, &counts, now, best);
    return saved * moves > look_worth * (SKIN_PARTICLE * counts.particles + SKIN_PAIR * counts.pairs);
}

void skin_auto_restart(struct skin_choice *choice, struct restart *restart) {
    restart_add(restart, RESTART_INTEGER, true, &choice->octaves, "skin: octaves / 4");
    restart_add(restart, RESTART_INTEGER, true, &choice->changes, "skin: changes");
    restart_add(restart, RESTART_REAL, true, &choice->used, "skin: used");
    restart_add(restart, RESTART_REAL, true, &choice->steps, "skin: steps");
}
