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

/* Adds `sign` times the number of crossings of particle i to those of one plane. */
static void account(struct output_crossing *crossing, double number, const struct particles *particles,
                    size_t i, double sign) {
    crossing->particles += sign * number;
    crossing->mass += sign * number * groups_mass(particles, i);
}

void crossings_begin(struct output_crossing *crossing, const struct observables_options *options,
                     const struct box *box, const struct particles *particles) {
    const uint8_t *kind = kinds_of(particles);
    for (int k = 0; k < options->planes; k++) {
        if (!isnan(crossing[k].mass))
            continue;
        crossing[k] = (struct output_crossing){0, 0};
        for (size_t i = 0; i < particles->owned; i++)
            if (kind == NULL || kind[i] == KIND_GRAIN)
                account(&crossing[k], crossing_number(box, &options->plane[k], particles, i), particles, i,
                        -1);
    }
}

void crossings_account(struct output_crossing *crossing, const struct observables_options *options,
                       const struct box *box, const struct particles *particles, size_t i, double sign) {
    for (int k = 0; k < options->planes; k++)
        account(&crossing[k], crossing_number(box, &options->plane[k], particles, i), particles, i, sign);
}

void crossings_restart(struct output_crossing *crossing, const struct observables_options *options,
                       struct restart *restart) {
    for (int k = 0; k < options->planes; k++) {
        const char *name = options->plane[k].name;
        restart_add(restart, RESTART_SUM, true, &crossing[k].particles, "crossed %.40s: particles", name);
        restart_add(restart, RESTART_SUM, true, &crossing[k].mass, "crossed %.40s: mass", name);
    }
}
