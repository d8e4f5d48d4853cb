/* SPDX-License-Identifier: BSD-3-Clause */
/* The full rebuild: a list of passes (at the end of this file), as the step is one. The rebuild runs between
 * a drift and the forces: positions are new, forces are zero, histories are those of the last evaluation.
 * Copies appear, vanish and migrate only here. */
#include "engine/rebuild.h"
#include "engine/deform.h"
#include "engine/index_view.h"
#include "engine/classify.h"
#include "engine/skin_auto.h"
#include "engine/tune.h"
#include "engine/sources.h"
#include "engine/rebuild_rows.h"
#include "engine/stages.h"
#include "engine/guards.h"
#include "engine/load_balance.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

/* True if every periodic edge is longer than two cut-offs. */
static bool one_image(const struct size_classes *classes, const struct box *box) {
    double reach = 0;
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b <= a; b++)
            if (classes_meet(classes, a, b))
                reach = fmax(reach, classes->radius_max[a] + classes->radius_max[b] + classes->margin[a][b]);
    for (int d = 0; d < 3; d++)
        if (box->periodic[d] && box->edge[d] <= 2 * reach)
            return false;
    return true;
}

/* The smallest distance between two images of a particle that may meet the same partner; INFINITY: no two
 * images may. */
static double images_apart(const struct size_classes *classes, const struct box *box) {
    double apart = INFINITY;
    if (one_image(classes, box))
        return apart;
    for (int d = 0; d < 3; d++)
        if (box->periodic[d])
            apart = fmin(apart, box->edge[d]);
    return apart;
}

static void reorder(struct simulation *s, struct rebuild_rows *rows) {
    size_t owned = s->particles->owned;
    struct index_view view;
    struct history_rows *list[REBUILD_SETS];
    tune_begin(&s->search.tuning);
    if (rows->stays && !s->search.sorts && rows->revision == s->particles->revision)
        return;
    s->search.sorts = false;
    s->search.sorted++;
    uint32_t *order = rows->order = memory_allocate(owned, sizeof *order, "particle order");
    simulation_index_view(s, &view);
    index_order(s->search.index, &view, order);
    kinds_sort(s->particles, &s->classes, order);
    particles_reorder(s->particles, order);
    for (int k = 0, n = rebuild_rows_list(rows, list); k < n; k++)
        history_rows_reorder(list[k], order, owned);
}

static void keep(struct simulation *s, struct rebuild_rows *rows) {
    const bool numbered = rows->order && rows->place;
    struct history_numbers numbers = {rows->order, s->particles->owned, numbered ? rows->place : NULL,
                                      numbered ? rows->before : s->particles->owned};
    const struct history_followers followers = {&rows->loose, s->particles, rows->near, rows->near_count};
    if (rows->keep)
        history_keep(s->search.history, s->search.list, &numbers, rows->loose.carrier ? &followers : NULL,
                     &rows->kept);
}

static void springs_restore(struct history *history, const struct pairlist *list, const struct ranks *ranks,
                            struct rebuild_rows *rows) {
    struct history_twins twins = {0};
    if (!ranks->alone)
        twins.original = ghosts_own(ranks->ghosts, &twins.first, &twins.count);
    history_restore(history, &rows->kept, &twins, list);
}

/* The most steps until the next rebuild; 0: not known. A rebuild that sorts comes first after a resume, which knows no growth of
 * bounds, and must go on as the run that was not interrupted; in reproducible mode all layouts decide alike. */
static double next_rebuild(const struct scene *scene, const struct rebuild_rows *rows) {
    bool known = rows->stays && !scene->classes.skin_auto && !scene->reproducible;
    return known ? (double)scene->step.rebuild_every : 0;
}

static void attach(struct simulation *s, struct rebuild_rows *rows) {
    if (rows->keep)
        springs_restore(s->search.history, s->search.list, &s->ranks, rows);
    else if (rows->pairs.start)
        history_attach(s->search.history, &rows->pairs, s->search.list, s->particles,
                       images_apart(&s->classes, &s->box));
    if (rows->obstacles.start)
        s->physics.obstacles->row->obstacles->attach(&s->physics.obstacles->context, &rows->obstacles);
    skin_reset(s->search.skin, s->particles, &s->classes, next_rebuild(s->scene, rows));
}

static void ghosts_pass(struct simulation *s) {
    if (!s->ranks.alone)
        ghosts_make(s->ranks.ghosts, s->particles, &s->classes);
    if (s->error.kind == ERROR_NONE)
        ghosts_fit(s->ranks.ghosts, &s->error);
}

static void index_pass(struct simulation *s) {
    simulation_index_view(s, &s->search.view);
    s->search.view.ordered = true;
    index_build(s->search.index, &s->search.view);
    s->search.revision = s->particles->revision;
}

static void pairs_pass(struct simulation *s) {
    double start = timer_now();
    pairlist_build(s->search.interactions.all, s->search.index, &s->search.view, &s->box);
    if (s->scene->ghosts.in_place && !s->ranks.alone)
        pairlist_add_images(s->search.interactions.all, s->particles->owned,
                            ghosts_unshift(s->ranks.ghosts, s->particles));
    interactions_select(&s->search.interactions, &s->classes, &s->search.view);
    s->search.pairs_seconds += timer_now() - start;
    if (s->scene->index.measure)
        tune_end(&s->search, s->comm);
}

/* Copies without a pair do not travel in the step. Grains read copies through pairs alone; other physics and the
 * calling program may read any copy. */
static void used_pass(struct simulation *s) {
    if (s->physics.count > 1 || s->caller.force)
        return;
    uint8_t *used = memory_allocate_zero(s->particles->ghosts, 1, "copies in use");
    pairlist_mark_copies(s->search.interactions.all, s->particles->owned, used);
    ghosts_use(s->ranks.ghosts, s->particles, used);
    memory_free(used);
}

/* Sets size classes: particles that have arrived have none, and after a new choice of classes the classes of
 * all particles change. */
static void classify(struct simulation *s, struct rebuild_rows *rows) {
    size_t first = s->classes_stale ? 0 : s->ranks.alone ? s->particles->owned : rows->stay;
    if (s->classes_stale) {
        s->search.sorts = true;
        classify_choose(s, &s->error);
    }
    particles_classify_from(s->particles, &s->classes, first);
}

static void obstacles_pass(struct simulation *s) {
    s->physics.obstacles->row->obstacles->search(&s->physics.obstacles->context);
}

/* If images matter, springs find their pairs by separations, so copies must follow the present positions of
 * their originals. */
static void follow(struct simulation *s) {
    if (one_image(&s->classes, &s->box))
        return;
    struct field_list fields = fields_with(s->particles, FIELD_FORWARD);
    ghosts_forward_begin(s->ranks.ghosts, s->particles, &fields);
    ghosts_forward_end(s->ranks.ghosts, s->particles);
}

static void detach(struct simulation *s, struct rebuild_rows *rows) {
    bool given = s->sources.given.added > 0 || s->sources.given.taken > 0;
    bool none_lost = !given && !sources_due(&s->sources, s->scene, &s->clock) && !box_may_lose(&s->box);
    bool keeps = s->search.history && none_lost && one_image(&s->classes, &s->box);
    if (!keeps)
        rebuild_detach(&s->search, &s->physics, s->particles, !s->ranks.alone, rows);
    else
        rebuild_detach_obstacles(&s->physics, rows);
    rows->keep = keeps;
    if (keeps && !s->ranks.alone) {
        const uint32_t *originals = ghosts_originals(s->ranks.ghosts, &rows->near_count);
        rows->near = memory_allocate(rows->near_count, sizeof *rows->near, "partners of rows");
        if (rows->near_count > 0)
            memcpy(rows->near, originals, rows->near_count * sizeof *rows->near);
    }
}

static void carry(struct simulation *s, struct rebuild_rows *rows) {
    physics_rows(&s->physics, rows->carried);
}

/* Particles that stay on their rank do not cross the box in a direction in which the box is divided. */
static void wrap(struct simulation *s, struct rebuild_rows *rows) {
    struct box box;
    ghosts_drop(s->ranks.ghosts, s->particles);
    if (s->box.motion.moves)
        deform_settle(&s->box, s->ranks.domain);
    box = s->box;
    for (int d = 0; d < 3 && rows->stays; d++)
        box.periodic[d] = box.periodic[d] && s->ranks.wrap[d];
    rows->revision = s->particles->revision;
    if (particles_wrap(s->particles, &box))
        return;
    guards_check_finite(s->particles, &s->box, &s->physics, &s->clock, &s->error);
    guards_check_images(s->particles, &s->box, &s->clock, &s->error);
}

static void come_and_go(struct simulation *s, struct rebuild_rows *rows) {
    const struct physics_active *obstacles = s->physics.obstacles;
    sources_run(s, rows);
    if (obstacles)
        obstacles->row->obstacles->changed(&obstacles->context);
    load_begin(&s->ranks, s->particles, &s->box, s->comm);
}

/* Where nothing moves the search has done its work. */
static void search_release(struct search *search) {
    interactions_release(&search->interactions);
    index_release(search->index);
    skin_release(search->skin);
    memory_trim();
}

static void tell_physics(struct simulation *s, struct rebuild_rows *rows) {
    rows->again = physics_rebuilt(&s->physics, s->ranks.alone ? NULL : s->ranks.ghosts);
    s->classes_stale = s->classes_stale || rows->again;
    if (s->search.sweep)
        s->search.sweep->stale = true;
    if (!rows->again && physics_rests(&s->physics))
        search_release(&s->search);
}

/* What must hold for a pass to run; all that it names. */
enum { SEVERAL_RANKS = 1, SKIN_CHOSEN = 2, HISTORY = 4, HISTORY_KEPT = 8, OBSTACLES = 16, CARRIED_ROWS = 32 };

/* What holds; `keep`: the history stays in place in this rebuild. */
static unsigned what_holds(const struct scene *scene, const struct ranks *ranks, const struct search *search,
                           const struct physics_set *set, bool keep) {
    return (ranks->alone ? 0 : SEVERAL_RANKS) | (scene->classes.skin_auto ? SKIN_CHOSEN : 0) |
           (search->history ? HISTORY : 0) | (keep ? HISTORY_KEPT : 0) |
           (physics_meets(set) ? OBSTACLES : 0) |
           (physics_next(set, NULL, offsetof(struct physics, rows)) ? CARRIED_ROWS : 0);
}

/* A pass of the rebuild: of histories on their way, or of all else. */
struct rebuild_pass {
    const char *name, *why; /* why NULL: always */
    const char *timer;      /* its stage (stages.h) */
    unsigned needs;
    void (*rows)(struct simulation *s, struct rebuild_rows *rows);
    void (*whole)(struct simulation *s);
};

/* The passes of a rebuild. The passes before `carry` are left out if histories come from a checkpoint. */
static const struct rebuild_pass passes[] = {
    {"skin", "a skin that the run chooses", "decide", SKIN_CHOSEN, .whole = skin_auto_choose},
    {"balance", "several ranks", "migrate", SEVERAL_RANKS, .whole = load_balance},
    {"stay", NULL, "migrate", 0, .rows = stay_decide},
    {"follow", "history, several ranks", "comm", HISTORY | SEVERAL_RANKS, .whole = follow},
    {"detach", "history", "history", HISTORY, .rows = detach},
    {"carry", "pairs that a physics remembers", "history", CARRIED_ROWS, .rows = carry},
    {"wrap", NULL, "migrate", 0, .rows = wrap},
    {"sources", NULL, "migrate", 0, .rows = come_and_go},
    {"part", "several ranks", "migrate", SEVERAL_RANKS, .rows = rebuild_part},
    {"loosen", "history, several ranks", "history", HISTORY_KEPT | SEVERAL_RANKS, .rows = rebuild_loosen},
    {"migrate", "several ranks", "migrate", SEVERAL_RANKS, .rows = rebuild_migrate},
    {"classify", NULL, "migrate", 0, .rows = classify},
    {"reorder", NULL, "reorder", 0, .rows = reorder},
    {"ghosts", NULL, "ghosts", 0, .whole = ghosts_pass},
    {"keep", "history", "history", HISTORY, .rows = keep},
    {"index", NULL, "index", 0, .whole = index_pass},
    {"pairs", NULL, "pairs", 0, .whole = pairs_pass},
    {"used", "several ranks", "ghosts", SEVERAL_RANKS, .whole = used_pass},
    {"walls", "walls", "wall", OBSTACLES, .whole = obstacles_pass},
    {"attach", NULL, "history", 0, .rows = attach},
    {"physics", NULL, "pairs", 0, .rows = tell_physics},
};
enum { REBUILD_PASSES = sizeof passes / sizeof passes[0], REBUILD_CARRY = 5 };

/* Returns true if another rebuild must follow. */
static bool passes_run(struct simulation *s, struct rebuild_rows *rows, int first) {
    for (int p = first; p < REBUILD_PASSES; p++) {
        if (passes[p].needs & ~what_holds(s->scene, &s->ranks, &s->search, &s->physics, rows->keep))
            continue;
        int stage = stages_find(&s->timers, passes[p].timer);
        timer_start(&s->timers, stage);
        if (passes[p].rows)
            passes[p].rows(s, rows);
        else
            passes[p].whole(s);
        timer_stop(&s->timers, stage);
    }
    bool again = rows->again;
    rebuild_rows_free(rows);
    return again;
}

void rebuild_print(const struct scene *scene, const struct ranks *ranks, const struct search *search,
                   const struct physics_set *set, FILE *file) {
    unsigned never = ~what_holds(scene, ranks, search, set, true);
    for (int p = 0; p < REBUILD_PASSES; p++)
        if ((passes[p].needs & never) == 0)
            fprintf(file, "  %-10s %s%s\n", passes[p].name, passes[p].why ? "for " : "always",
                    passes[p].why ? passes[p].why : "");
}

void rebuild_from_rows(struct simulation *s, struct rebuild_rows *rows) {
    if (passes_run(s, rows, REBUILD_CARRY))
        rebuild_run(s);
}

void rebuild_run(struct simulation *s) {
    struct rebuild_rows rows = {0};
    if (passes_run(s, &rows, 0))
        rebuild_run(s);
}
