/* SPDX-License-Identifier: BSD-3-Clause */
/* auto: decides by the cost model which classes share a grid and how large its cells are. With one grid it is
 * `linkcell`, with one a class `bytype`, between these `hgrid`.
 *
 * The choice depends on the number of particles in each class and on the volume that they occupy, both
 * rounded to steps of a few per cent, on the classes' sizes and margins, and on nothing else: the same
 * particles give the same choice, in a repeated run and in a resumed one. If the scene changes by a step,
 * `auto` chooses again. With `measure`, `auto` offers a few variants of the choice for timing (index_trials);
 * a selection by the clock is not reproducible. */
#include "index/choose/auto_choose.h"

#include "base/memory.h"
#include "index/levels/levels.h"
#include "index/levels/levels_plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Variants that cost more than the choice by this factor are not timed. */
static const double TRIED_WITHIN = 1.15;

enum { VARIANTS = 4, SAMPLE = 16384, ACROSS_MAX = 16, STEPS_A_DOUBLING = 8, TEAM_LEAST = 4096 };

struct auto_index {
    struct index base;
    struct levels levels;
    struct cost_scene scene; /* of the last look; its events are those that the choice predicts */
    struct cost_scene steps; /* the scene of the present choice, in steps */
    struct cost_plan plan[VARIANTS];
    int variants, selected;
    uint64_t choices;
    bool ordered; /* chosen by `order` or `stays`, for the build that follows */
};

static struct auto_index *own(struct index *self) {
    return (struct auto_index *)self;
}

static const struct auto_index *own_const(const struct index *self) {
    return (const struct auto_index *)self;
}

/* Rounded to a step, so that small changes change nothing. */
static double in_steps(double value) {
    return value > 0 ? exp2(round(log2(value) * STEPS_A_DOUBLING) / STEPS_A_DOUBLING) : 0;
}

/* Threads that look at the particles. */
static int team(const struct index_view *view) {
    return view->owned > TEAM_LEAST ? view->threads : 1;
}

/* Least and largest coordinate in direction d of each step-th owned particle. */
static void extent(const struct index_view *view, size_t step, int d, double *low, double *high) {
    double least = INFINITY, most = -INFINITY;
#pragma omp parallel for num_threads(team(view)) reduction(min : least) reduction(max : most)
    for (size_t k = 0; k < view->owned; k += step) {
        const double x = view->position[k * view->stride + (size_t)d];
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
    *low = least;
    *high = most;
}

/* The occupied part of the space around the owned particles, from a sample. Directions of no extent count as
 * one cut-off wide. */
static double occupied(const struct index_view *view, double cutoff) {
    double low[3], high[3], volume = 1;
    size_t step = view->owned / SAMPLE + 1, sampled = view->owned / step;
    int across = (int)cbrt((double)sampled / 16);
    across = across < 1 ? 1 : across > ACROSS_MAX ? ACROSS_MAX : across;
    uint8_t taken[ACROSS_MAX * ACROSS_MAX * ACROSS_MAX] = {0};
    for (int d = 0; d < 3; d++) {
        low[d] = 0;
        high[d] = view->edge[d];
        if (!view->periodic[d]) {
            extent(view, step, d, &low[d], &high[d]);
        }
        high[d] = fmin(fmax(high[d], low[d] + cutoff), low[d] + 1e12 * cutoff);
        volume *= d < view->dimension ? high[d] - low[d] : 1;
    }
    int cells = 0;
#pragma omp parallel for num_threads(team(view))
    for (size_t k = 0; k < view->owned; k += step) {
        int cell = 0;
        for (int d = 0; d < view->dimension; d++) {
            double t = (view->position[k * view->stride + (size_t)d] - low[d]) / (high[d] - low[d]) * across;
            cell = cell * across + (t > 0 ? t < across ? (int)t : across - 1 : 0);
        }
#pragma omp atomic write
        taken[cell] = 1;
    }
    for (int c = 0; c < ACROSS_MAX * ACROSS_MAX * ACROSS_MAX; c++) {
        cells += taken[c];
    }
    return volume * cells / pow(across, view->dimension);
}

/* Fills the scene from a view, as it is; its bins are the classes. */
static void look(const struct index_view *view, struct cost_scene *scene) {
    uint64_t count[INDEX_CLASS_MAX] = {0};
    memset(scene, 0, sizeof *scene);
    for (size_t k = 0, next; k < view->owned; k = next) {
        next = members_run(view->size_class, k, view->owned);
        count[view->size_class[k]] += next - k;
    }
    scene->bins = view->classes;
    scene->classes = true;
    scene->dimension = view->dimension;
    scene->threads = view->threads;
    scene->volume =
        view->owned > 0 ? occupied(view, grid_frame_cutoffs(view, 0, view->classes - 1).largest) : 1;
    for (int c = 0; c < view->classes; c++) {
        const int partner = grid_frame_partner(view, c); /* a class without partners does not count */
        scene->count[c] = partner < 0 ? 0 : (double)count[c];
        scene->radius_max[c] = scene->radius_min[c] = view->radius_max[c];
        scene->margin[c] = partner < 0 ? 0 : view->margin[c][partner];
        for (int b = 0; b < view->classes; b++) {
            scene->unwanted[c] |= (uint64_t)!index_wanted(view, c, b) << b;
        }
    }
}

/* The scene with numbers and volume in steps. */
static void in_steps_all(const struct cost_scene *scene, struct cost_scene *steps) {
    memcpy(steps, scene, sizeof *steps);
    steps->volume = in_steps(scene->volume);
    for (int c = 0; c < scene->bins; c++) {
        steps->count[c] = in_steps(scene->count[c]);
    }
}

/* Adds a variant of the choice, unless an earlier one is equal or the model finds it clearly dearer. */
static void offer(struct auto_index *index, const struct cost_plan *plan) {
    if (index->variants > 0 &&
        cost_seconds(&index->steps, plan) > TRIED_WITHIN * cost_seconds(&index->steps, &index->plan[0])) {
        return;
    }
    for (int k = 0; k < index->variants; k++) {
        if (memcmp(&index->plan[k], plan, sizeof *plan) == 0) {
            return;
        }
    }
    index->plan[index->variants++] = *plan;
}

static void choose(struct auto_index *index) {
    const struct cost_scene *scene = &index->steps;
    struct cost_plan plan = {0};
    auto_group(scene, &plan);
    index->variants = index->selected = 0;
    index->choices++;
    offer(index, &plan);
    for (int way = 0; way < 2; way++) {
        struct cost_plan other = plan;
        for (int g = 0; g < plan.levels; g++) {
            other.edge[g] *= way ? 1.35 : 0.75;
        }
        offer(index, &other);
    }
    struct cost_plan other = {.levels = plan.levels > 1 ? 1 : scene->bins, .last = {scene->bins - 1}};
    for (int c = 0; c < other.levels && other.levels > 1; c++) {
        other.last[c] = c;
    }
    auto_edges(scene, &other);
    offer(index, &other);
}

static struct levels_plan make_plan(struct auto_index *index, const struct index_view *view) {
    struct cost_scene steps;
    struct levels_plan plan = {0};
    if (!index->ordered) {
        look(view, &index->scene);
        in_steps_all(&index->scene, &steps);
        if (index->choices == 0 || memcmp(&steps, &index->steps, sizeof steps) != 0) {
            memcpy(&index->steps, &steps, sizeof steps);
            choose(index);
        }
    }
    const struct cost_plan *chosen = &index->plan[index->selected];
    double factor = index->base.params.cell_factor > 0 ? index->base.params.cell_factor : 1;
    plan.grids = chosen->levels;
    for (int g = 0; g < plan.grids; g++) {
        plan.edge[g] = chosen->edge[g] * factor;
        plan.fixed[g] = index->base.params.cell_factor > 0;
        for (int c = g > 0 ? chosen->last[g - 1] + 1 : 0; c <= chosen->last[g]; c++) {
            plan.grid_of[c] = g;
        }
    }
    levels_plan_apart(&plan, view);
    return plan;
}

static struct index *auto_create(const struct index_params *params) {
    struct auto_index *index = memory_allocate_zero(1, sizeof *index, "index");
    levels_start(&index->levels, params);
    return &index->base;
}

static void auto_destroy(struct index *self) {
    levels_free(&own(self)->levels);
    memory_free(self);
}

static bool auto_stays(struct index *self, const struct index_view *view) {
    struct levels_plan plan = make_plan(own(self), view);
    own(self)->ordered = levels_stays(&own(self)->levels, &plan, view);
    return own(self)->ordered;
}

static void auto_order(struct index *self, const struct index_view *view, uint32_t *order) {
    own(self)->ordered = false;
    struct levels_plan plan = make_plan(own(self), view);
    own(self)->ordered = true;
    levels_order(&own(self)->levels, &plan, view, order);
}

static void auto_build(struct index *self, const struct index_view *view) {
    struct levels_plan plan = make_plan(own(self), view);
    levels_build(&own(self)->levels, &plan, view);
    own(self)->ordered = false;
}

static void auto_visit(const struct index *self, const struct index_view *view, size_t first, size_t last,
                       struct index_sink *sink) {
    levels_visit(&own_const(self)->levels, view, first, last, sink);
}

static bool auto_check(const struct index *self, const struct index_view *view, char why[INDEX_WHY_MAX]) {
    return levels_check(&own_const(self)->levels, view, why);
}

static void auto_describe(const struct index *self, struct index_description *description) {
    const struct auto_index *index = own_const(self);
    const struct cost_plan *plan = &index->plan[index->selected];
    levels_describe(&index->levels, description);
    if (index->choices > 0) {
        snprintf(description->choice, sizeof description->choice, "%s",
                 plan->levels == 1                   ? "linkcell"
                 : plan->levels == index->scene.bins ? "bytype"
                                                     : "hgrid");
        description->predicted = cost_seconds(&index->scene, plan);
        description->choices = index->choices;
        description->variant = index->selected;
        cost_why(&index->scene, plan, description->why);
    }
}

static size_t auto_memory(const struct index *self) {
    return sizeof(struct auto_index) + levels_memory(&own_const(self)->levels);
}

static void auto_release(struct index *self) {
    levels_release(&own(self)->levels);
}

static int auto_trials(const struct index *self) {
    return own_const(self)->variants;
}

static void auto_select(struct index *self, int variant) {
    own(self)->selected = variant < own(self)->variants ? variant : 0;
}

extern const struct index_ops auto_ops;
const struct index_ops auto_ops = {
    .name = "auto",
    .summary = "chooses grids and cells by a cost model",
    .create = auto_create,
    .destroy = auto_destroy,
    .stays = auto_stays,
    .order = auto_order,
    .build = auto_build,
    .visit = auto_visit,
    .check = auto_check,
    .describe = auto_describe,
    .memory = auto_memory,
    .trials = auto_trials,
    .select = auto_select,
    .release = auto_release,
};
