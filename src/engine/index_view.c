/* SPDX-License-Identifier: BSD-3-Clause */
/* Views of the state of a simulation. */
#include "engine/index_view.h"
#include "engine/load_balance.h"

void simulation_index_view(struct simulation *s, struct index_view *view) {
    pairlist_view(view, s->particles, &s->classes, &s->box, s->ranks.wrap);
    view->newton = s->scene->ghosts.newton;
    view->threads = s->team.size;
    view->body = carried_by(s->particles);
    view->around.known = !s->ranks.alone;
    if (view->around.known)
        ghosts_around(s->ranks.ghosts, &s->classes, view->around.low, view->around.high);
}

struct output_view simulation_view(const struct simulation *s) {
    struct ghosts_counts ghosts;
    ghosts_count(s->ranks.ghosts, &ghosts);
    struct output_view view = {.comm = s->comm,
                               .particles = s->particles,
                               .box = &s->box,
                               .step = s->clock.step,
                               .time = s->clock.time,
                               .staged = s->scene->stages > 0,
                               .load = {.ghosts = ghosts.ghosts,
                                        .messages = ghosts.messages,
                                        .bytes = ghosts.bytes,
                                        .work = timer_sum(&s->timers, TIMER_WORK, 0),
                                        .waiting = timer_sum(&s->timers, TIMER_WAIT, 0)}};
    struct physics_energy others;
    view.turnover = (struct output_turnover){.inserted = s->sources.inserted,
                                             .deleted = s->sources.deleted,
                                             .deleted_mass = s->sources.deleted_mass};
    for (int k = 0; k < s->scene->insertions; k++)
        view.turnover.inserted_mass += s->sources.state[k].mass;
    view.crossing = s->crossings;
    physics_own(&s->physics, view.own);
    physics_energies(&s->physics, &others);
    view.held = others.held;
    view.gone = others.taken - others.work;
    PHYSICS_EACH (active, &s->physics, shown)
        if (active->row->shown->view)
            active->row->shown->view(&active->context, &view);
    return view;
}
