/* SPDX-License-Identifier: BSD-3-Clause */
/* Decides on rebuilds by bounds of the displacements on all ranks (kernel/pairs/skin.h). */
#include "engine/decide.h"
#include <math.h>
#include <string.h>

/* Bounds of the displacements grow by the largest speeds. If a bound reaches a skin, the displacements are
 * measured. */
static void decide_skin(const struct search *search, const struct physics_set *set, int threads, int classes,
                        double dt) {
    double speed[CLASS_MAX] = {0};
    const struct physics_active *obstacles = set->obstacles;
    for (int t = 0; t < threads; t++)
        for (int c = 0; c < classes; c++)
            speed[c] = fmax(speed[c], search->speed[t][c]);
    for (int c = 0; c < classes; c++)
        speed[c] = sqrt(speed[c]);
    skin_moved(search->skin, speed, classes, dt,
               obstacles ? obstacles->row->obstacles->displacement(&obstacles->context) : 0);
}

/* Starts the reduction of bounds, signals and errors over all ranks. */
void decide_begin(struct simulation *s) {
    double *value = s->agree.value;
    int n = s->classes.count;
    decide_skin(&s->search, &s->physics, s->threads, n, s->clock.dt);
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

void decide_end(struct agree *agree, struct skin *skin, int classes, bool alone) {
    const double *value = agree->value, *signal = value + 2 * classes;
    if (!alone) {
        comm_max_end(&agree->reduction);
        memcpy(skin->bound, value, (size_t)classes * sizeof *value);
        memcpy(skin->second, value + classes, (size_t)classes * sizeof *value);
        agree->signals = (struct step_signals){.rebuild = signal[0] > 0,
                                               .stop = signal[1] > 0,
                                               .checkpoint = signal[2] > 0,
                                               .error = signal[3] > 0};
    }
    skin_settle(skin, classes);
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
void decide_measure(struct agree *agree, struct skin *skin, const struct particles *particles,
                    const struct size_classes *classes, const struct comm *comm) {
    if (agree->signals.rebuild || !skin_due(skin, classes))
        return;
    agree->signals.rebuild = skin_surely_due(skin, classes);
    if (agree->signals.rebuild)
        return;
    decide_displacements(skin, particles, classes->count, comm);
    agree->signals.rebuild = skin_due(skin, classes);
}

void decide_run(struct simulation *s) {
    decide_begin(s);
    decide_end(&s->agree, s->search.skin, s->classes.count, s->ranks.alone);
    decide_measure(&s->agree, s->search.skin, s->particles, &s->classes, s->comm);
}
