/* SPDX-License-Identifier: BSD-3-Clause */
/* Plans the visits of the fused order and of the ring order after a rebuild. Read order_plan.h first. */
#include "engine/order_plan.h"
#include "engine/stages.h"
#include "kernel/pairs/ring.h"
#include "kernel/pairs/sweep.h"

static size_t early_count(const struct sweep *sweep) {
    size_t early = 0;
    for (int t = 0; t < sweep->threads; t++)
        for (size_t r = 0; r < sweep->thread[t].early_count; r++)
            early += sweep->thread[t].early[r].last - sweep->thread[t].early[r].first;
    return early;
}

/* The ring order has one more pass, over the particles that move early in the fused one, and over those at walls: it is
 * planned unless these are more than one in RING_PART. */
enum { RING_PART = 3 };

static void plan_sweep(struct simulation *s) {
    size_t many = s->particles->owned / RING_PART;
    struct ring *ring = s->order.ring;
    const struct physics_active *obstacles = s->physics.obstacles;
    struct sweep_numbers early[2] = {{0}};
    if (!s->ranks.alone)
        early[0].number = ghosts_step_originals(s->ranks.ghosts, &early[0].count);
    if (ring && obstacles)
        early[1].count = obstacles->row->obstacles->near(&obstacles->context, &early[1].number);
    bool few = early[1].count <= many;
    if (!few)
        early[1].count = 0;
    sweep_build(s->search.sweep, s->search.list, s->particles->owned, early);
    if (ring)
        ring->sweep = NULL;
    if (ring && few && early_count(s->search.sweep) <= many)
        ring_build(ring, s->search.sweep, s->search.list, s->particles->owned,
                   s->particles->owned + s->particles->ghosts);
}

void order_plan(struct simulation *s) {
    if (!s->search.sweep->stale)
        return;
    int stage = stages_find(&s->timers, "pairs");
    timer_start(&s->timers, stage);
    plan_sweep(s);
    timer_stop(&s->timers, stage);
}

void order_forget(struct simulation *s) {
    if (s->search.sweep)
        s->search.sweep->stale = true;
}

bool order_needs_agreement(const struct simulation *s) {
    return !s->ranks.alone && s->order.ring;
}

void order_agree(struct simulation *s) {
    plan_sweep(s);
    int64_t without = s->order.ring->sweep == NULL;
    comm_max_int(s->comm, &without, 1);
    s->order.agreed = without == 0;
}
