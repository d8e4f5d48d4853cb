/* SPDX-License-Identifier: BSD-3-Clause */
/* Estimates the overlaps of a run. Read overlaps.h first. */
#include "physics/grains/overlaps.h"
#include "physics/grains/sorts.h"
#include "base/memory.h"
#include <math.h>

/* A sort of grains that are free to move, or a wall or fixed grains: then only the material counts. */
struct side {
    int material;
    bool fixed;
    double small, large, mass; /* radii; mass of the heaviest */
    double speed;              /* the largest */
    double soft,
        stiff; /* overlaps that the softest and the stiffest support store alone, for the smallest's weight */
    int softest, stiffest; /* these supports */
};

enum { SIDES_MAX = SORTS_MAX + LAW_MATERIALS_MAX };

static struct grains *grains_own(const struct physics_context *c) {
    return c->self;
}

/* The time until the end of the run; infinite where the scene does not say. */
static double time_left(const struct physics_context *c) {
    const struct scene *scene = c->scene;
    if (scene->stages > 0)
        return INFINITY;
    if (scene->duration > 0)
        return fmax(scene->duration - c->clock->time, 0);
    return scene->step.count > 0 ? fmax((double)scene->step.count - (double)c->clock->step, 0) * c->clock->dt
                                 : INFINITY;
}

/* The largest speed of grains that start at a speed and fall, both as squares: by the depth of the fall, and by the
 * time that it may take. */
static double speed_of(const struct physics_context *c, double start, double fall) {
    const double *g = c->scene->gravity;
    double gained = fall > 0 ? sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * time_left(c) : 0;
    if (c->scene->step.speed_max > 0)
        return c->scene->step.speed_max;
    return fmin(sqrt(start + fall), sqrt(start) + gained);
}

static int sides_find(const struct physics_context *c, const struct sorts *sorts, struct side *side) {
    int n = 0;
    for (int k = 0; k < SORTS_MAX; k++) {
        double large = sorts->radius_max[k];
        if (large > 0)
            side[n++] = (struct side){.material = sorts_material(k),
                                      .small = sorts->radius_min[k],
                                      .large = large,
                                      .mass = sorts->heaviest[k] * large * large * large,
                                      .speed = speed_of(c, sorts->start[k], sorts->fall[k])};
    }
    for (int m = 0; m < c->scene->materials; m++)
        if (sorts->fixed[m] > 0)
            side[n++] = (struct side){
                .material = m, .fixed = true, .small = INFINITY, .large = INFINITY, .mass = INFINITY};
    return n;
}

/* The largest overlap of an impact of two spheres, or one and a wall, of these materials; length. */
static double impact_of(const struct physics_context *c, const struct side *a, const struct side *b,
                        const double radius[2], double mass, double speed) {
    const struct law *law = &grains_own(c)->law;
    int p = a->material, q = b->material;
    return law_impact_of(&law->options, law_pair_of(law, p, q), law_extra_of(law, p, q), mass,
                         1 / (1 / radius[0] + 1 / radius[1]), speed);
}

/* The largest of two sides meet at the largest speed; over the smaller radius. */
static double meet(const struct physics_context *c, const struct side *a, const struct side *b) {
    double mass = 1 / (1 / a->mass + 1 / b->mass);
    return impact_of(c, a, b, (double[2]){a->large, b->large}, mass, grains_own(c)->stable.speed_expected) /
           fmin(a->large, b->large);
}

/* Finds the softest and the stiffest support of the smallest grain of a side. */
static void supports_find(const struct physics_context *c, const struct side *side, int sides,
                          struct side *grain) {
    grain->stiff = INFINITY;
    for (int k = 0; k < sides; k++) {
        double overlap =
            impact_of(c, grain, &side[k], (double[2]){grain->small, side[k].large}, grain->mass, 1);
        if (overlap < grain->stiff) {
            grain->stiff = overlap;
            grain->stiffest = k;
        }
        if (overlap > grain->soft) {
            grain->soft = overlap;
            grain->softest = k;
        }
    }
}

/* The largest of `top` squeezes the smallest of `grain` against a support; keeps the worst case. */
static void squeeze(const struct physics_context *c, const struct side *top, const struct side *grain,
                    const struct side *support) {
    struct overlaps *worst = &grains_own(c)->stable.overlaps;
    double p = law_form_of(&grains_own(c)->law.options)->tangent + 1;
    double above = impact_of(c, top, grain, (double[2]){top->large, grain->small}, top->mass, top->speed);
    double below =
        impact_of(c, grain, support, (double[2]){grain->small, support->large}, top->mass, top->speed);
    double most = fmax(above, below), ratio = most > 0 ? fmin(above, below) / most : 0;
    double overlap = most * pow(1 + pow(ratio, p / (p - 1)), -1 / p) / fmin(grain->small, top->large);
    if (!(overlap > worst->squeezed))
        return;
    worst->squeezed = overlap;
    worst->speed = top->speed;
    worst->mass = top->mass;
    worst->radius = fmin(grain->small, top->large);
    worst->exponent = p;
    worst->material[0] = grain->material;
    worst->material[1] = above >= below ? top->material : support->material;
}

/* True if grains may rest on something. */
static bool supported(const struct physics_context *c, const struct side *side, int sides) {
    const double *g = c->scene->gravity;
    return g[0] != 0 || g[1] != 0 || g[2] != 0 || (sides > 0 && side[sides - 1].fixed);
}

/* Keeps the worst case of all particles on all grains. */
static void squeezes_find(const struct physics_context *c, struct side *side, int n) {
    for (int b = 0; supported(c, side, n) && b < n; b++) {
        if (side[b].fixed)
            continue;
        supports_find(c, side, n, &side[b]);
        for (int a = 0; a < n; a++)
            if (!side[a].fixed) {
                squeeze(c, &side[a], &side[b], &side[side[b].softest]);
                squeeze(c, &side[a], &side[b], &side[side[b].stiffest]);
            }
    }
}

void overlaps_expect(const struct physics_context *c) {
    struct grains_stable *stable = &grains_own(c)->stable;
    struct sorts *sorts = memory_allocate(1, sizeof *sorts, "sorts of grains");
    struct side *side = memory_allocate(SIDES_MAX, sizeof *side, "sorts of grains");
    sorts_collect(c, sorts);
    int n = sides_find(c, sorts, side);
    stable->overlaps = (struct overlaps){0};
    stable->speed_expected = speed_of(c, sorts->fastest, 0);
    for (int a = 0; a < n; a++)
        stable->speed_expected = fmax(stable->speed_expected, side[a].speed);
    for (int a = 0; a < n; a++)
        for (int b = a; b < n; b++)
            if (!side[a].fixed || !side[b].fixed)
                stable->overlaps.met = fmax(stable->overlaps.met, meet(c, &side[a], &side[b]));
    squeezes_find(c, side, n);
    memory_free(side);
    memory_free(sorts);
}

double overlaps_stiffening(const struct overlaps *overlaps, double bound) {
    return pow(overlaps->squeezed / bound, overlaps->exponent);
}
