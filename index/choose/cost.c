/* SPDX-License-Identifier: BSD-3-Clause */
/* The cost model: counts the steps of a search by grids of levels and prices them. Read cost.h first. */
#include "index/choose/cost.h"

#include "index/levels/levels.h"
#include "index/search_sizes.h"

#include <math.h>
#include <stdio.h>

/* Visits that a row costs for handing out the pairs that larger rows found. */
static const double HANDED_OUT = 0.5;

static const char *const names[COST_TERMS] = {
    [COST_PARTICLE] = "particles", [COST_MIXED] = "mixed",   [COST_WINDOW] = "windows",
    [COST_VECTOR] = "vectors",     [COST_VISIT] = "visits",  [COST_RUN] = "runs",
    [COST_ROUND] = "round",        [COST_SPARSE] = "sparse", [COST_TEST] = "tests",
    [COST_SINGLE] = "singles",
};

const char *cost_name(enum cost_term term) {
    return names[term];
}

/* One level as the model sees it. */
struct part {
    double count, radius_max, radius_mean, margin, edge;
    bool mixed;
    double density; /* a length unit^dimension */
    double pencil;  /* particles in a pencil */
    double pencils;
    bool sparse;
    double span_radius[2]; /* largest radius to be expected in a span: own, other */
    int first, last;       /* bins */
    uint64_t bins;         /* bins with particles */
    uint64_t unwanted;     /* bins that particles of some bin of the level never meet */
};

/* The radius that one of `rows` particles of the level exceeds. */
static double largest_of(const struct cost_scene *scene, int first, int last, double count, double rows) {
    double above = 0;
    int bin = last;
    for (; bin > first; bin--) {
        above += scene->count[bin];
        if (above * rows >= count) {
            break;
        }
    }
    return scene->radius_max[bin];
}

static struct part part_of(const struct cost_scene *scene, const struct cost_plan *plan, int level) {
    int first = level > 0 ? plan->last[level - 1] + 1 : 0, last = plan->last[level];
    struct part part = {.edge = plan->edge[level], .first = first, .last = last};
    for (int bin = first; bin <= last; bin++) {
        if (scene->count[bin] > 0) {
            part.mixed = scene->classes && part.count > 0;
            part.margin = part.count == 0 || scene->classes ? scene->margin[bin] : part.margin;
            part.radius_mean += scene->count[bin] * 0.5 * (scene->radius_min[bin] + scene->radius_max[bin]);
            part.count += scene->count[bin];
            part.radius_max = scene->radius_max[bin];
            part.bins |= (uint64_t)1 << bin;
            part.unwanted |= scene->unwanted[bin];
        }
    }
    if (part.count == 0) {
        return part;
    }
    part.radius_mean /= part.count;
    double across = pow(scene->volume, 1.0 / scene->dimension);
    double wide = fmax(1, across / part.edge);
    part.density = part.count / scene->volume;
    part.pencils = scene->dimension == 3 ? wide * wide : wide;
    part.pencil = part.count / part.pencils;
    part.sparse = levels_too_many_cells(levels_cells(scene->volume, part.edge, scene->dimension), part.count);
    part.span_radius[0] = largest_of(scene, first, last, part.count, fmin(SEARCH_OWN_ROWS, part.pencil + 1));
    part.span_radius[1] = largest_of(scene, first, last, part.count, fmin(SEARCH_ROWS, part.pencil + 1));
    return part;
}

double cost_cutoff(const struct cost_scene *scene, const struct cost_plan *plan, int level) {
    struct part part = part_of(scene, plan, level);
    return part.count > 0 ? 2 * part.radius_max + part.margin : 0;
}

/* The share of the rows of g that have a partner in h. */
static double searching(const struct cost_scene *scene, const struct part *g, const struct part *h) {
    double count = 0;
    if ((g->unwanted & h->bins) == 0) {
        return h->count > 0;
    }
    for (int bin = g->first; bin <= g->last; bin++) {
        count += (h->bins & ~scene->unwanted[bin]) != 0 ? scene->count[bin] : 0;
    }
    return count / g->count;
}

bool cost_meets_itself(const struct cost_scene *scene, const struct cost_plan *plan, int level) {
    const int first = level > 0 ? plan->last[level - 1] + 1 : 0;
    uint64_t bins = 0;
    for (int bin = first; bin <= plan->last[level]; bin++) {
        bins |= (uint64_t)(scene->count[bin] > 0) << bin;
    }
    for (int bin = first; bin <= plan->last[level]; bin++) {
        if ((bins >> bin & 1) != 0 && (bins & ~scene->unwanted[bin]) != 0) {
            return true;
        }
    }
    return false;
}

/* Groups of at most `most` rows into which the pencils of a level fall. */
static double spans_of(const struct part *part, double most) {
    double some = 1 - exp(-part->pencil);
    return part->pencils *
           (part->pencil / most + 0.5 * some * (1 + exp(-part->pencil / most)) * (1 - 1 / most));
}

/* Extents of the window in which rows look at the table h. */
struct window {
    double length, high, wide; /* along the pencils, across them */
    double pencils;            /* of h in it */
    bool round;                /* the corners are left out */
};

/* The window of rows that fill length x width, to a distance `reach` of them. */
static struct window window_of(const struct cost_scene *scene, const struct part *h, double length,
                               double width, double reach) {
    double across = pow(scene->volume, 1.0 / scene->dimension);
    bool flat = scene->dimension == 2;
    struct window window;
    window.high = fmin(width + 2 * reach + h->edge, 3 * across);
    window.wide = flat ? h->edge : window.high;
    window.length = fmin(length + 2 * reach + 0.5 * h->edge, 3 * across);
    window.pencils = window.high * window.wide / (h->edge * h->edge);
    window.round = window.high + (flat ? 0 : window.wide) > 6.5 * h->edge;
    return window;
}

/* Counts the search of the rows of g, one by one, in their own dense table. */
static void count_direct(const struct cost_scene *scene, const struct part *g, double count[COST_TERMS]) {
    const double rows = g->count * searching(scene, g, g);
    struct window window = window_of(scene, g, 0, 0, g->radius_mean + g->radius_max + g->margin);
    double share = 0.5 + 0.5 / window.pencils;
    double found = g->density * window.length * window.high * (scene->dimension == 2 ? 1 : window.wide);
    double vectors = fmax(1, found / window.pencils / SEARCH_LANES + 0.5);
    count[COST_WINDOW] += rows * share * window.pencils;
    count[COST_VECTOR] += rows * share * window.pencils * vectors;
}

/* Counts the search of the rows of g in the table of h, in spans. */
static void count_spans(const struct cost_scene *scene, const struct part *g, const struct part *h, bool own,
                        double count[COST_TERMS]) {
    bool flat = scene->dimension == 2;
    double spans = spans_of(g, own ? SEARCH_OWN_ROWS : SEARCH_ROWS), rows = g->count / spans;
    double across = pow(scene->volume, 1.0 / scene->dimension);
    struct window window = window_of(scene, h, fmin(across, rows / g->pencil * across),
                                     fmin(g->edge, across) * (rows - 1) / (rows + 1),
                                     g->span_radius[own ? 0 : 1] + h->radius_max + g->margin);
    double area = window.high * (flat ? 1 : window.wide);
    if (!flat && window.round) {
        area *= 0.85;
    }
    double share = own ? 0.5 + 0.5 / window.pencils : 1;
    double row_empty = exp(-h->density * window.high * (flat ? 1 : h->edge) * across);
    double found = h->density * area * share * window.length;
    double runs = share * ((1 - row_empty) * window.pencils + (flat ? 1 : window.wide / h->edge));
    double some = 1 - exp(-found);
    const double take = searching(scene, g, h);
    spans *= take;
    count[COST_VISIT] += g->count * take;
    count[COST_RUN] += spans * runs;
    count[COST_ROUND] += window.round ? spans * runs : 0;
    count[COST_SPARSE] += h->sparse ? spans * runs : 0;
    count[COST_TEST] += spans * rows * (found / SEARCH_LANES + 0.5 * some);
}

/* Counts the search of `rows` rows, one by one, in the table of the smaller particles g. */
static void count_singles(const struct part *g, double rows, const struct window *window, double found,
                          double count[COST_TERMS]) {
    double pencils = rows * window->pencils;
    count[COST_SINGLE] += rows;
    count[COST_VISIT] += HANDED_OUT * g->count;
    if (!g->sparse && window->pencils <= LEVELS_PENCILS_DIRECT) {
        count[COST_WINDOW] += pencils;
        count[COST_VECTOR] += pencils * fmax(1, found / window->pencils / SEARCH_LANES + 0.5);
    } else {
        count[COST_RUN] += pencils;
        count[COST_ROUND] += window->round ? pencils : 0;
        count[COST_SPARSE] += g->sparse ? pencils : 0;
        count[COST_TEST] += rows * (0.6 * found / SEARCH_LANES + 0.5);
    }
}

/* Counts the pairs between two levels, g the smaller: in spans of g, or by single rows of h. */
static void count_cross(const struct cost_scene *scene, const struct part *g, const struct part *h,
                        double count[COST_TERMS]) {
    const double reach = h->radius_max + g->radius_max + g->margin;
    const struct window up = window_of(scene, h, g->edge, g->edge, reach),
                        down = window_of(scene, g, 0, 0, reach);
    const bool flat = scene->dimension == 2;
    const struct prices_sides sides = {
        .smaller = g->count,
        .larger = h->count,
        .found_smaller = fmin(g->count, g->density * down.length * down.high * (flat ? 1 : down.wide)),
        .found_larger = fmin(h->count, h->density * up.length * up.high * (flat ? 1 : up.wide)),
        .pencils = down.pencils,
        .sparse = g->sparse};
    if (prices_from_larger(&sides)) {
        count_singles(g, h->count * searching(scene, h, g), &down, sides.found_smaller, count);
    } else {
        count_spans(scene, g, h, false, count);
    }
}

void cost_count(const struct cost_scene *scene, const struct cost_plan *plan, double count[COST_TERMS]) {
    struct part part[INDEX_CLASS_MAX];
    for (int t = 0; t < COST_TERMS; t++) {
        count[t] = 0;
    }
    for (int g = 0; g < plan->levels; g++) {
        part[g] = part_of(scene, plan, g);
        count[COST_PARTICLE] += part[g].count;
        count[COST_MIXED] += part[g].mixed ? part[g].count : 0;
    }
    for (int g = 0; g < plan->levels; g++) {
        for (int h = g; h < plan->levels && part[g].count > 0; h++) {
            if (searching(scene, &part[g], &part[h]) == 0) {
                continue;
            }
            if (g == h && !part[g].sparse) {
                count_direct(scene, &part[g], count);
            } else if (g == h) {
                count_spans(scene, &part[g], &part[g], true, count);
            } else {
                count_cross(scene, &part[g], &part[h], count);
            }
        }
    }
}

double cost_seconds(const struct cost_scene *scene, const struct cost_plan *plan) {
    double count[COST_TERMS], sum = 0;
    cost_count(scene, plan, count);
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * prices_event(t);
    }
    return sum * 1e-9 / (scene->threads > 0 ? scene->threads : 1);
}

void cost_why(const struct cost_scene *scene, const struct cost_plan *plan, char why[INDEX_WHY_MAX]) {
    double count[COST_TERMS], sum = 0, particles = 0;
    size_t used = 0;
    cost_count(scene, plan, count);
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * prices_event(t);
    }
    particles = count[COST_PARTICLE] > 0 ? count[COST_PARTICLE] : 1;
    why[0] = '\0';
    for (int t = 0; t < COST_TERMS; t++) {
        double share = sum > 0 ? 100 * count[t] * prices_event(t) / sum : 0;
        if (share >= 0.5 && used < INDEX_WHY_MAX) {
            used += (size_t)snprintf(why + used, INDEX_WHY_MAX - used, "%s%s %.3g a particle (%.0f %%)",
                                     used ? ", " : "", names[t], count[t] / particles, share);
        }
    }
}
