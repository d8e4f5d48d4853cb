/* SPDX-License-Identifier: BSD-3-Clause */
/* The decision of a rebuild whether the particles stay as they lie. Read index/levels/levels_stay.c first. */
#include "engine/stay.h"
#include "engine/sources.h"
#include "engine/tune.h"
#include "engine/index_view.h"

/* True if the particles of this rank may stay where they are; on several ranks only those of grains, as another physics
 * may ask for the owner of a place, and not in reproducible mode, in which all ranks wrap positions alike. */
static bool may_stay(struct simulation *s) {
    struct index_view view;
    bool simple = s->physics.count == 1 && !s->caller.force && !s->scene->reproducible &&
                  !s->sources.given.added && !s->sources.given.taken && !sources_due(s) &&
                  !box_may_lose(&s->box);
    if (s->search.sorts || s->classes_stale || s->box.motion.moves ||
        s->search.revision != s->particles->revision || !(s->ranks.alone || simple))
        return false;
    simulation_index_view(s, &view);
    return index_stays(s->search.index, &view);
}

void stay_decide(struct simulation *s, struct rebuild_rows *rows) {
    tune_select(s);
    rows->stays = may_stay(s);
    if (!s->ranks.alone)
        rows->stays = ghosts_let_stay(s->ranks.ghosts, s->particles, &s->classes, rows->stays);
}
