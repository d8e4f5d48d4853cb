/* SPDX-License-Identifier: BSD-3-Clause */
/* Keeps the sums of planes over the particles that come and go. Read crossings.h first. */
#include "engine/crossings.h"
#include "kernel/particles/groups.h"
#include "data/observe/crossing.h"
#include "kernel/particles/kinds.h"
#include <math.h>

void crossings_prepare(struct output_crossing *crossing, int planes) {
    for (int k = 0; k < planes; k++)
        crossing[k] = (struct output_crossing){NAN, NAN};
}

static void account(struct simulation *s, int plane, size_t i, double sign) {
    double number = crossing_number(&s->box, &s->scene->output.observables.plane[plane], s->particles, i);
    s->crossings[plane].particles += sign * number;
    s->crossings[plane].mass += sign * number * groups_mass(s->particles, i);
}

void crossings_begin(struct simulation *s) {
    const uint8_t *kind = kinds_of(s->particles);
    for (int k = 0; k < s->scene->output.observables.planes; k++) {
        if (!isnan(s->crossings[k].mass))
            continue;
        s->crossings[k] = (struct output_crossing){0, 0};
        for (size_t i = 0; i < s->particles->owned; i++)
            if (kind == NULL || kind[i] == KIND_GRAIN)
                account(s, k, i, -1);
    }
}

void crossings_account(struct simulation *s, size_t i, double sign) {
    for (int k = 0; k < s->scene->output.observables.planes; k++)
        account(s, k, i, sign);
}

void crossings_restart(struct output_crossing *crossing, const struct observables_options *options,
                       struct restart *restart) {
    for (int k = 0; k < options->planes; k++) {
        const char *name = options->plane[k].name;
        restart_add(restart, RESTART_SUM, true, &crossing[k].particles, "crossed %.40s: particles", name);
        restart_add(restart, RESTART_SUM, true, &crossing[k].mass, "crossed %.40s: mass", name);
    }
}
