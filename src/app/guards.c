/* Guards: physical nonsense stops the run (or warns, once), naming particles, place and time. */
#include "app/simulation.h"
#include <math.h>
#include <stdio.h>

/* Stops or warns. */
static void guard_trip(struct simulation *s, enum scene_guard guard, int which, const char *text) {
    if (guard == SCENE_GUARD_STOP) {
        error_set(&s->error, ERROR_PHYSICS, "%s", text);
    } else if (guard == SCENE_GUARD_WARN && !(s->guard_warned & 1u << which)) {
        s->guard_warned |= 1u << which;
        fprintf(stderr, "scree: warning: %s (said once)\n", text);
    }
}

static void guard_overlap(struct simulation *s) {
    if (s->scene->guards.overlap == SCENE_GUARD_OFF ||
        !(s->sums.overlap_max > s->scene->guards.overlap_bound))
        return;
    char text[512];
    snprintf(text, sizeof text,
             "guards.overlap: particles %lld and %lld overlap by %.3g of the smaller radius (bound %g) at "
             "step %llu, t = %.9g",
             (long long)s->sums.overlap_id[0], (long long)s->sums.overlap_id[1], s->sums.overlap_max,
             s->scene->guards.overlap_bound, (unsigned long long)s->step, s->time);
    guard_trip(s, s->scene->guards.overlap, 0, text);
}

/* A particle that moves by more than the smallest radius in a step may pass through another unseen. */
static void guard_speed(struct simulation *s) {
    if (s->scene->guards.speed == SCENE_GUARD_OFF || s->classes.count == 0)
        return;
    double fastest = 0;
    for (int t = 0; t < s->threads; t++)
        for (int c = 0; c < s->classes.count; c++)
            fastest = fmax(fastest, s->speed[t][c]);
    double moved = sqrt(fastest) * s->dt, bound = s->classes.radius_min[0];
    if (!(moved > bound))
        return;
    size_t worst = 0;
    double speed2 = -1;
    for (size_t k = 0; k < s->particles->owned; k++) {
        const double *v = s->particles->state[k].v;
        double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (v2 > speed2) {
            speed2 = v2;
            worst = k;
        }
    }
    const double *x = s->particles->state[worst].x, *origin = s->scene->box.origin;
    char text[512];
    snprintf(text, sizeof text,
             "guards.speed: particle %lld at (%.6g, %.6g, %.6g) moves %.3g in a step, more than the smallest "
             "radius %.3g: it may pass "
             "through others unseen (step %llu, t = %.9g)",
             (long long)s->particles->id[worst], x[0] + origin[0], x[1] + origin[1], x[2] + origin[2],
             sqrt(speed2) * s->dt, bound, (unsigned long long)s->step, s->time);
    guard_trip(s, s->scene->guards.speed, 1, text);
}

void guards_check(struct simulation *s) {
    guard_overlap(s);
    guard_speed(s);
}

static bool state_finite(const struct particle_state *p) {
    return isfinite(p->x[0] + p->x[1] + p->x[2] + p->v[0] + p->v[1] + p->v[2]);
}

/* Positions that are no numbers would break the search, so they always stop the run. */
void guards_check_positions(struct simulation *s) {
    size_t bad = s->particles->owned;
#pragma omp parallel for schedule(static) reduction(min : bad)
    for (size_t k = 0; k < s->particles->owned; k++)
        if (!state_finite(&s->particles->state[k]) && k < bad)
            bad = k;
    if (bad == s->particles->owned)
        return;
    error_set(&s->error, ERROR_PHYSICS,
              "guards.nan: position or velocity of particle %lld is not finite at step %llu, t = %.9g: the "
              "time step is too "
              "large, or particles coincide",
              (long long)s->particles->id[bad], (unsigned long long)s->step, s->time);
    for (size_t k = bad; k < s->particles->owned; k++) {
        struct particle_state *p = &s->particles->state[k];
        if (state_finite(p))
            continue;
        for (int d = 0; d < 3; d++)
            p->x[d] = p->v[d] = 0;
    }
}
