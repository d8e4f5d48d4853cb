/* SPDX-License-Identifier: BSD-3-Clause */
/* Decides on rebuilds by bounds of the displacements on all ranks (kernel/pairs/skin.h). */
#include "engine/decide.h"
#include <math.h>
#include <string.h>

/* Bounds of the displacements grow by the largest speeds. If a bound reaches a skin, the displacements are
 * measured. */
static void decide_skin(struct simulation *s) {
    double speed[CLASS_MAX] = {0};
    const struct physics_active *obstacles = s->physics.obstacles;
    int classes = s->classes.count;
    for (int t = 0; t < s->threads; t++)
        for (int c = 0; c < classes; c++)
            speed[c] = fmax(speed[c], s->search.speed[t][c]);
    for (int c = 0; c < classes; c++)
        speed[c] = sqrt(speed[c]);
    skin_moved(s->search.skin, speed, classes, s->clock.dt,
               obstacles ? obstacles->row->obstacles->displacement(&obstacles->context) : 0);
}

/* Starts the reduction of bounds, signals and errors over all ranks. */
void decide_begin(struct simulation *s) {
    double *value = s->agree.value;
    int n = s->classes.count;
    decide_skin(s);
    if (s->ranks.alone)
        return;
    memcpy(value, s->search.skin->bound, (size_t)n * sizeof *value);
    memcpy(value + n, s->search.skin->second, (size_t)n * sizeof *value);
    value[2 * n] = s->agree.signals.rebuild;
    value[2 * n + 1] = s->agree.signals.stop;
    value[2 * n + 2] = s->agree.signals.checkpoint;
    value[2 * n + 3] = s->agree.signals.error;
    comm_max_begin(s->comm, value, 2 * n + 4, &s->agree.reduction);
}

void decide_end(struct simulation *s) {
    const double *value = s->agree.value;
    int n = s->classes.count;
    if (!s->ranks.alone) {
        comm_max_end(&s->agree.reduction);
        memcpy(s->search.skin->bound, value, (size_t)n * sizeof *value);
        memcpy(s->search.skin->second, value + n, (size_t)n * sizeof *value);
        s->agree.signals.rebuild = value[2 * n] > 0;
        s->agree.signals.stop = value[2 * n + 1] > 0;
        s->agree.signals.checkpoint = value[2 * n + 2] > 0;
        s->agree.signals.error = value[2 * n + 3] > 0;
    }
    skin_settle(s->search.skin, n);
}

void decide_displacements(struct skin *skin, const struct particles *particles, int classes,
                          const struct comm *comm) {
    double two[CLASS_MAX][2];
    skin_measure(skin, particles, classes);
    for (int c = 0; c < classes; c++) {
        two[c][0] = skin->bound[c];
        two[c][1] = skin->second[c];
    }
    comm_max_two(comm, two, classes);
    for (int c = 0; c < classes; c++) {
        skin->bound[c] = two[c][0];
        skin->second[c] = two[c][1];
    }
}

/* Measures the displacements if the bounds say that a rebuild may be due. */
void decide_measure(struct simulation *s) {
    if (s->agree.signals.rebuild || !skin_due(s->search.skin, &s->classes))
        return;
    s->agree.signals.rebuild = skin_surely_due(s->search.skin, &s->classes);
    if (s->agree.signals.rebuild)
        return;
    decide_displacements(s->search.skin, s->particles, s->classes.count, s->comm);
    s->agree.signals.rebuild = skin_due(s->search.skin, &s->classes);
}

void decide_run(struct simulation *s) {
    decide_begin(s);
    decide_end(s);
    decide_measure(s);
}
