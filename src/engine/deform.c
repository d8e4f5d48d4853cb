/* SPDX-License-Identifier: BSD-3-Clause */
/* Moves the box, and tells the other parts. Read deform.h first. */
#include "engine/deform.h"
#include <string.h>

static const char offset_name[] = "box: offset of the shear";

void deform_prepare(struct simulation *s) {
    if (s->box.motion.moves)
        skin_follow(s->search.skin, &s->box);
}

void deform_start(struct simulation *s) {
    if (!s->box.motion.moves || !s->scene->shear.profile)
        return;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < s->particles->owned; k++) {
        double flow[3];
        box_flow(&s->box, s->particles->state[k].x, flow);
        for (int d = 0; d < 3; d++)
            s->particles->state[k].v[d] += flow[d];
    }
}

void deform_advance(struct simulation *s) {
    box_advance(&s->box, s->clock.dt);
    interactions_follow(&s->search.interactions, &s->box);
}

void deform_settle(struct simulation *s) {
    box_settle(&s->box);
    domain_follow(s->ranks.domain, &s->box);
}

void deform_restart(struct simulation *s, struct restart *restart) {
    if (!s->box.motion.moves)
        return;
    restart_add(restart, RESTART_REAL, true, &s->box.motion.offset, "%s", offset_name);
    restart_add(restart, RESTART_REAL, true, &s->box.motion.turns, "box: turns of the shear");
}

bool deform_check(const struct simulation *s, const struct restart_values *values, const char *path,
                  struct error *error) {
    for (size_t k = 0; k < values->count[RESTART_REAL]; k++)
        if (!s->box.motion.shears && strcmp(values->name[RESTART_REAL][k], offset_name) == 0)
            return error_set(
                error, ERROR_USER,
                "%s: it was written for a sheared box: box.shear must stay; rate: 0 stops the shear", path);
    return true;
}
