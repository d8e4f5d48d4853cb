/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts the classes of particles into the levels that `auto` compares: equal gaps, groups of classes. Read
 * auto_choose.h first. */
#include "index/choose/auto_choose.h"

#include <math.h>

enum { LEVELS_TRIED = 8, LEVELS_PATIENCE = 2, ROUNDS = 4 };

/* Cell edges tried, as multiples of the cut-off of a level. */
static const double factors[] = {0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 8.0, 16.0};
enum { FACTORS = sizeof factors / sizeof factors[0], FACTORS_CROWDED = 4 };
static const double occupancy_dilute = 0.1;

/* Least gain, as part of the cost, for which a level is added or a cut or an edge is changed. */
static const double gain_least = 0.005;

static const double gap_ratio = 1.5, gap_price = 1.1;

void auto_bins(struct cost_scene *scene, const double *radii, size_t n, double weight) {
    double low = log(radii[0]), high = log(radii[n - 1]);
    scene->bins = 0;
    int previous = -1;
    for (size_t k = 0; k < n; k++) {
        int bin = high > low ? (int)((log(radii[k]) - low) / (high - low) * (COST_BINS - 1)) : 0;
        if (bin > previous) {
            scene->radius_min[scene->bins] = radii[k];
            scene->count[scene->bins++] = 0;
            previous = bin;
        }
        scene->count[scene->bins - 1] += weight;
        scene->radius_max[scene->bins - 1] = radii[k];
    }
}

/* The number of factors tried for a level. Particles lie in memory in the order of the cells of their level, and a step over pairs takes
 * longer if the cells of most particles are large (8 % with 2 cut-offs at R = 10), which the cost of a rebuild does not see. So the level
 * with most particles, whose particles meet each other, has cells up to 1.4 cut-offs, unless nearly all of these would be empty. */
static int factors_tried(const struct cost_sheet *sheet, int g) {
    const struct cost_level *level = &sheet->level[g];
    for (int h = 0; h < sheet->levels; h++) {
        if (sheet->level[h].count > level->count && sheet->pair[h][h] > 0) {
            return FACTORS;
        }
    }
    const double dense = level->density * pow(cost_level_cutoff(level), sheet->scene->dimension);
    return sheet->pair[g][g] > 0 && dense > occupancy_dilute ? FACTORS_CROWDED : FACTORS;
}

/* Gives a level the cells that cost least, all others kept, if these cost less than `best` seconds. True if so. */
static bool tune_level(struct cost_sheet *sheet, int g, double *best) {
    const struct cost_level *level = &sheet->level[g];
    const double cutoff = cost_level_cutoff(level), before = level->edge;
    const int tried = factors_tried(sheet, g);
    double kept = before;
    for (int f = 0; f < tried && cutoff > 0; f++) {
        cost_sheet_edge(sheet, g, factors[f] * cutoff);
        double cost = cost_sheet_seconds(sheet);
        if (cost < *best * (1 - gain_least)) {
            *best = cost;
            kept = level->edge;
        }
    }
    cost_sheet_edge(sheet, g, kept);
    return kept != before;
}

/* Tunes the cells of all levels, from the present ones on; returns the cost, seconds. */
static double tune(struct cost_sheet *sheet) {
    double best = cost_sheet_seconds(sheet);
    bool better = true;
    for (int round = 0; round < ROUNDS && better; round++) {
        better = false;
        for (int g = 0; g < sheet->levels; g++) {
            better = tune_level(sheet, g, &best) || better;
        }
    }
    return best;
}

/* The sheet of a plan with cells of the cut-offs. */
static void sheet_at_cutoffs(struct cost_sheet *sheet, const struct cost_scene *scene,
                             const struct cost_plan *plan) {
    struct cost_plan start = *plan;
    for (int g = 0; g < plan->levels; g++) {
        const double cutoff = cost_cutoff(scene, plan, g);
        start.edge[g] = cutoff > 0 ? cutoff : 1;
    }
    cost_sheet_make(sheet, scene, &start);
}

double auto_edges(const struct cost_scene *scene, struct cost_plan *plan) {
    struct cost_sheet sheet;
    sheet_at_cutoffs(&sheet, scene, plan);
    const double cost = tune(&sheet);
    cost_sheet_plan(&sheet, plan);
    return cost;
}

/* Levels of equal occupancy whose top bins end where a level of occupancy m does; returns their number. */
static int cut_at(const struct cost_scene *scene, double occupancy, struct cost_plan *plan) {
    plan->levels = 0;
    double count = 0;
    for (int bin = 0; bin < scene->bins; bin++) {
        double next = count + scene->count[bin];
        if (bin > 0 && count > 0 && next * pow(scene->radius_max[bin], scene->dimension) > occupancy &&
            plan->levels < INDEX_CLASS_MAX - 1) {
            plan->last[plan->levels++] = bin - 1;
            next = scene->count[bin];
        }
        count = next;
    }
    plan->last[plan->levels] = scene->bins - 1;
    return ++plan->levels;
}

void auto_equal(const struct cost_scene *scene, int levels, struct cost_plan *plan) {
    double low = 0, high = 0;
    *plan = (struct cost_plan){0};
    for (int bin = 0; bin < scene->bins; bin++) {
        high += scene->count[bin];
    }
    high *= pow(scene->radius_max[scene->bins - 1], scene->dimension) * 2;
    for (int k = 0; k < 100; k++) {
        double middle = (low + high) / 2;
        if (cut_at(scene, middle, plan) > levels) {
            low = middle;
        } else {
            high = middle;
        }
    }
    cut_at(scene, high, plan);
    for (int g = 0; g < plan->levels; g++) {
        plan->edge[g] = cost_cutoff(scene, plan, g);
    }
}

/* Moves one cut to where it costs least, all others kept. True if that gained. */
static bool move_cut(const struct cost_scene *scene, int cut, struct cost_plan *plan, double *best) {
    int low = cut > 0 ? plan->last[cut - 1] + 1 : 0, high = plan->last[cut + 1] - 1;
    struct cost_plan kept = *plan;
    bool better = false;
    for (int bin = low; bin <= high; bin++) {
        struct cost_plan trial = *plan;
        trial.last[cut] = bin;
        for (int g = cut; g <= cut + 1; g++) {
            double old = cost_cutoff(scene, plan, g), now = cost_cutoff(scene, &trial, g);
            trial.edge[g] = old > 0 ? plan->edge[g] * now / old : now;
        }
        double cost = cost_seconds(scene, &trial);
        if (cost < *best * (1 - gain_least)) {
            *best = cost;
            kept = trial;
            better = true;
        }
    }
    *plan = kept;
    return better;
}

/* Sizes that lie a factor apart are different sizes: between them there is a cut, unless that costs much. */
static void cut_gaps(const struct cost_scene *scene, int most, struct cost_plan *plan) {
    for (int bin = 0; bin + 1 < scene->bins && plan->levels < most; bin++) {
        int g = 0;
        while (plan->last[g] < bin) {
            g++;
        }
        if (plan->last[g] == bin || scene->radius_min[bin + 1] < gap_ratio * scene->radius_max[bin]) {
            continue;
        }
        struct cost_plan trial = *plan;
        for (int h = trial.levels++; h > g; h--) {
            trial.last[h] = trial.last[h - 1];
        }
        trial.last[g] = bin;
        double before = cost_seconds(scene, plan);
        if (auto_edges(scene, &trial) < gap_price * before) {
            *plan = trial;
        }
    }
}

void auto_levels(const struct cost_scene *scene, int most, struct cost_plan *plan) {
    double best = INFINITY;
    int best_levels = 0;
    *plan = (struct cost_plan){.levels = 1,
                               .last = {scene->bins - 1}}; /* where costs are beyond what numbers hold */
    most = most < LEVELS_TRIED ? most : LEVELS_TRIED;
    for (int levels = 1; levels <= most && levels <= scene->bins && levels <= best_levels + LEVELS_PATIENCE;
         levels++) {
        struct cost_plan trial;
        auto_equal(scene, levels, &trial);
        double cost = auto_edges(scene, &trial);
        bool better = trial.levels > 1;
        for (int round = 0; round < ROUNDS && better; round++) {
            better = false;
            for (int cut = 0; cut + 1 < trial.levels; cut++) {
                better = move_cut(scene, cut, &trial, &cost) || better;
            }
            double with_edges = auto_edges(scene, &trial);
            cost = with_edges;
        }
        if (cost < best * (1 - gain_least)) {
            best = cost;
            best_levels = levels;
            *plan = trial;
        }
    }
    cut_gaps(scene, most, plan);
}

/* Joins the two neighbouring levels whose common level costs least, its own cells tuned and all others kept. False
 * if each pair costs more than *best together; else *best becomes the cost. */
static bool join_best(struct cost_sheet *sheet, double *best) {
    struct cost_sheet trial;
    double edge = 0;
    int joined = -1;
    for (int g = 0; g + 1 < sheet->levels; g++) {
        trial = *sheet;
        cost_sheet_join(&trial, g);
        double cost = cost_sheet_seconds(&trial);
        tune_level(&trial, g, &cost);
        if (cost < *best * (1 - gain_least)) {
            *best = cost;
            joined = g;
            edge = trial.level[g].edge;
        }
    }
    if (joined >= 0) {
        cost_sheet_join(sheet, joined);
        cost_sheet_edge(sheet, joined, edge);
    }
    return joined >= 0;
}

void auto_group(const struct cost_scene *scene, struct cost_plan *plan) {
    struct cost_sheet sheet;
    *plan = (struct cost_plan){.levels = scene->bins};
    for (int c = 0; c < scene->bins; c++) {
        plan->last[c] = c;
    }
    sheet_at_cutoffs(&sheet, scene, plan);
    double best = tune(&sheet);
    while (join_best(&sheet, &best)) {
        best = tune(&sheet);
    }
    cost_sheet_plan(&sheet, plan);
}
