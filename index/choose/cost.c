/* SPDX-License-Identifier: BSD-3-Clause */
/* The cost model: counts the steps of a search by grids of levels and prices them. Read cost.h first. */
#include "index/choose/cost.h"

#include "index/levels/levels.h"
#include "index/search_sizes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Visits that a row costs for handing out the pairs that larger rows found. */
static const double HANDED_OUT = 0.5;

static const char *const names[COST_TERMS] = {
    [COST_PARTICLE] = "particles", [COST_CELL] = "cells",     [COST_MIXED] = "mixed",
    [COST_WINDOW] = "windows",     [COST_VECTOR] = "vectors", [COST_LONG] = "long",
    [COST_VISIT] = "visits",       [COST_RUN] = "runs",       [COST_ROUND] = "round",
    [COST_SPARSE] = "sparse",      [COST_TEST] = "tests",     [COST_SINGLE] = "singles",
};

const char *cost_name(enum cost_term term) {
    return names[term];
}

/* The radius that one of `rows` particles of the level exceeds. */
static double largest_of(const struct cost_scene *scene, const struct cost_level *level, double rows) {
    double above = 0;
    int bin = level->last;
    for (; bin > level->first; bin--) {
        above += scene->count[bin];
        if (above * rows >= level->count) {
            break;
        }
    }
    return scene->radius_max[bin];
}

/* The particles of a level that holds the bins first ... last. */
static struct cost_level level_of(const struct cost_scene *scene, int first, int last) {
    struct cost_level level = {.first = first, .last = last};
    for (int bin = first; bin <= last; bin++) {
        if (scene->count[bin] > 0) {
            level.mixed = scene->classes && level.count > 0;
            level.margin = level.count == 0 || scene->classes ? scene->margin[bin] : level.margin;
            level.radius_mean += scene->count[bin] * 0.5 * (scene->radius_min[bin] + scene->radius_max[bin]);
            level.count += scene->count[bin];
            level.radius_max = scene->radius_max[bin];
            level.bins |= (uint64_t)1 << bin;
            level.unwanted |= scene->unwanted[bin];
        }
    }
    level.radius_mean /= level.count > 0 ? level.count : 1;
    level.across = pow(scene->volume, 1.0 / scene->dimension);
    level.density = level.count / scene->volume;
    return level;
}

/* Gives a level cells of this edge. */
static void set_cells(const struct cost_scene *scene, struct cost_level *level, double edge) {
    level->edge = edge;
    if (level->count == 0) {
        return;
    }
    const int dimension = scene->dimension;
    level->edge *= levels_growth(levels_cells(scene->volume, edge, dimension), level->count, dimension);
    level->cells = levels_cells(scene->volume, level->edge, dimension);
    level->sparse = levels_too_many_cells(level->cells, level->count);
    double wide = fmax(1, level->across / level->edge);
    level->pencils = dimension == 3 ? wide * wide : wide;
    level->pencil = level->count / level->pencils;
    level->span_radius[0] = largest_of(scene, level, fmin(SEARCH_OWN_ROWS, level->pencil + 1));
    level->span_radius[1] = largest_of(scene, level, fmin(SEARCH_ROWS, level->pencil + 1));
}

static int first_of(const struct cost_plan *plan, int level) {
    return level > 0 ? plan->last[level - 1] + 1 : 0;
}

double cost_level_cutoff(const struct cost_level *level) {
    return level->count > 0 ? 2 * level->radius_max + level->margin : 0;
}

double cost_cutoff(const struct cost_scene *scene, const struct cost_plan *plan, int level) {
    const struct cost_level at = level_of(scene, first_of(plan, level), plan->last[level]);
    return cost_level_cutoff(&at);
}

/* The share of the rows of g that have a partner in h. */
static double searching(const struct cost_scene *scene, const struct cost_level *g,
                        const struct cost_level *h) {
    double count = 0;
    if ((g->unwanted & h->bins) == 0) {
        return h->count > 0;
    }
    for (int bin = g->first; bin <= g->last; bin++) {
        count += (h->bins & ~scene->unwanted[bin]) != 0 ? scene->count[bin] : 0;
    }
    return count / g->count;
}

/* Groups of at most `most` rows into which the pencils of a level fall. */
static double spans_of(const struct cost_level *level, double most) {
    double some = 1 - exp(-level->pencil);
    return level->pencils *
           (level->pencil / most + 0.5 * some * (1 + exp(-level->pencil / most)) * (1 - 1 / most));
}

/* Extents of the window in which rows look at the table h. */
struct window {
    double length, high, wide; /* along the pencils, across them */
    double pencils;            /* of h in it */
    bool round;                /* the corners are left out */
};

/* The window of rows that fill length x width, to a distance `reach` of them. */
static struct window window_of(const struct cost_scene *scene, const struct cost_level *h, double length,
                               double width, double reach) {
    const double most = 3 * h->across;
    bool flat = scene->dimension == 2;
    struct window window;
    window.high = fmin(width + 2 * reach + h->edge, most);
    window.wide = flat ? h->edge : window.high;
    window.length = fmin(length + 2 * reach + 0.5 * h->edge, most);
    window.pencils = window.high * window.wide / (h->edge * h->edge);
    window.round = window.high + (flat ? 0 : window.wide) > 6.5 * h->edge;
    return window;
}

/* Adds `windows` windows of a dense table with so many candidates each, on average, of which numbers spread. */
static void add_windows(double windows, double found, double count[COST_TERMS]) {
    count[COST_WINDOW] += windows;
    count[COST_VECTOR] += windows * fmax(1, found / SEARCH_LANES + 0.5 * (SEARCH_LANES - 1) / SEARCH_LANES);
    count[COST_LONG] += windows / (1 + exp((SEARCH_LONG + 0.5 - found) * 4 / SEARCH_LONG));
}

/* Counts the search of the rows of g, one by one, in their own dense table. */
static void count_direct(const struct cost_scene *scene, const struct cost_level *g,
                         double count[COST_TERMS]) {
    const double rows = g->count * searching(scene, g, g);
    struct window window = window_of(scene, g, 0, 0, g->radius_mean + g->radius_max + g->margin);
    const double windows =
        0.5 * (window.pencils + 1); /* of the first one half, the slots behind the row's own */
    double found = 0.5 * g->density * window.length * window.high * (scene->dimension == 2 ? 1 : window.wide);
    add_windows(rows * windows, found / windows, count);
}

/* Extents of the box around the rows of a span, along the pencils and across them. */
struct box {
    double length, width;
};

/* The probability that some particle of h is within reach of the box: else its candidates are not tested. */
static double met(const struct cost_scene *scene, const struct cost_level *g, const struct cost_level *h,
                  const struct box *box) {
    const double a = box->length, b = box->width, r = g->span_radius[1] + h->radius_mean + g->margin;
    const double volume = scene->dimension == 2 ? a * b + 2 * (a + b) * r + M_PI * r * r
                                                : a * b * b + (4 * a * b + 2 * b * b) * r +
                                                      M_PI * (a + 2 * b) * r * r + 4.0 / 3 * M_PI * r * r * r;
    return 1 - exp(-h->density * volume);
}

/* The pencils of a window, of the table h, that a span looks up; and the rows of such pencils, which it leaves out if
 * they are empty. */
static double runs_of(const struct cost_level *h, const struct window *window, bool flat) {
    if (h->sparse) {
        return fmin(window->pencils, h->pencils * (1 - exp(-h->pencil)));
    }
    const double empty = exp(-h->density * window->high * (flat ? 1 : h->edge) * h->across);
    return (1 - empty) * window->pencils + (flat ? 1 : window->wide / h->edge);
}

/* Counts the search of the rows of g in the table of h, in spans. */
static void count_spans(const struct cost_scene *scene, const struct cost_level *g,
                        const struct cost_level *h, bool own, double count[COST_TERMS]) {
    const bool flat = scene->dimension == 2;
    double spans = spans_of(g, own ? SEARCH_OWN_ROWS : SEARCH_ROWS), rows = g->count / spans;
    const struct box box = {.length = fmin(g->across, rows / g->pencil * g->across),
                            .width = fmin(g->edge, g->across) * (rows - 1) / (rows + 1)};
    const struct window window =
        window_of(scene, h, box.length, box.width, g->span_radius[own ? 0 : 1] + h->radius_max + g->margin);
    const double area = window.high * (flat ? 1 : window.wide) * (!flat && window.round ? 0.85 : 1);
    const double share = own ? 0.5 + 0.5 / window.pencils : 1;
    const double found = h->density * area * share * window.length, some = 1 - exp(-found);
    const double take = searching(scene, g, h), runs = share * runs_of(h, &window, flat);
    const double tested = own ? rows : 1 + met(scene, g, h, &box) * rows;
    spans *= take;
    count[COST_VISIT] += g->count * take;
    count[COST_RUN] += spans * runs;
    count[COST_ROUND] += window.round ? spans * runs : 0;
    count[COST_SPARSE] += h->sparse ? spans * runs : 0;
    count[COST_TEST] += spans * tested * (found / SEARCH_LANES + 0.5 * some);
}

/* Counts the search of `rows` rows, one by one, in the table of the smaller particles g. */
static void count_singles(const struct cost_level *g, double rows, const struct window *window, double found,
                          double count[COST_TERMS]) {
    double pencils = rows * window->pencils;
    count[COST_SINGLE] += rows;
    count[COST_VISIT] += HANDED_OUT * g->count;
    if (!g->sparse && window->pencils <= LEVELS_PENCILS_DIRECT) {
        add_windows(pencils, found / window->pencils, count);
    } else {
        count[COST_RUN] += pencils;
        count[COST_ROUND] += window->round ? pencils : 0;
        count[COST_SPARSE] += g->sparse ? pencils : 0;
        count[COST_TEST] += rows * (0.6 * found / SEARCH_LANES + 0.5);
    }
}

/* Counts the pairs between two levels, g the smaller: in spans of g, or by single rows of h. */
static void count_cross(const struct cost_scene *scene, const struct cost_level *g,
                        const struct cost_level *h, double count[COST_TERMS]) {
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

/* Adds the events of level h alone (g = h), and those of its pairs with the rows of g <= h. */
static void count_pair(const struct cost_scene *scene, const struct cost_level *g, const struct cost_level *h,
                       double count[COST_TERMS]) {
    if (g == h) {
        count[COST_PARTICLE] += g->count;
        count[COST_MIXED] += g->mixed ? g->count : 0;
        count[COST_CELL] += g->sparse ? 0 : g->cells;
    }
    if (g->count == 0 || searching(scene, g, h) == 0) {
        return;
    }
    if (g == h && !g->sparse) {
        count_direct(scene, g, count);
    } else if (g == h) {
        count_spans(scene, g, g, true, count);
    } else {
        count_cross(scene, g, h, count);
    }
}

static double priced(const double count[COST_TERMS]) {
    double sum = 0;
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * prices_event(t);
    }
    return sum;
}

/* Prices the pairs of level g with all levels. */
static void price_level(struct cost_sheet *sheet, int g) {
    for (int other = 0; other < sheet->levels; other++) {
        const int low = g < other ? g : other, high = g < other ? other : g;
        double count[COST_TERMS] = {0};
        count_pair(sheet->scene, &sheet->level[low], &sheet->level[high], count);
        sheet->pair[low][high] = priced(count);
    }
}

void cost_sheet_make(struct cost_sheet *sheet, const struct cost_scene *scene, const struct cost_plan *plan) {
    sheet->scene = scene;
    sheet->levels = plan->levels;
    for (int g = 0; g < plan->levels; g++) {
        sheet->level[g] = level_of(scene, first_of(plan, g), plan->last[g]);
        set_cells(scene, &sheet->level[g], plan->edge[g]);
    }
    for (int g = 0; g < plan->levels; g++) {
        price_level(sheet, g);
    }
}

void cost_sheet_plan(const struct cost_sheet *sheet, struct cost_plan *plan) {
    *plan = (struct cost_plan){.levels = sheet->levels};
    for (int g = 0; g < sheet->levels; g++) {
        plan->last[g] = sheet->level[g].last;
        plan->edge[g] = sheet->level[g].edge;
    }
}

double cost_sheet_seconds(const struct cost_sheet *sheet) {
    double sum = 0;
    for (int g = 0; g < sheet->levels; g++) {
        for (int h = g; h < sheet->levels; h++) {
            sum += sheet->pair[g][h];
        }
    }
    return sum * 1e-9 / (sheet->scene->threads > 0 ? sheet->scene->threads : 1);
}

void cost_sheet_edge(struct cost_sheet *sheet, int level, double edge) {
    set_cells(sheet->scene, &sheet->level[level], edge);
    price_level(sheet, level);
}

void cost_sheet_join(struct cost_sheet *sheet, int level) {
    struct cost_level *joined = &sheet->level[level];
    const int first = joined->first, last = sheet->level[level + 1].last;
    sheet->levels--;
    for (int g = level + 1; g < sheet->levels; g++) {
        sheet->level[g] = sheet->level[g + 1];
    }
    for (int g = 0; g < sheet->levels; g++) {
        for (int h = g > level ? g : level + 1; h < sheet->levels; h++) {
            sheet->pair[g][h] = sheet->pair[g > level ? g + 1 : g][h + 1];
        }
    }
    *joined = level_of(sheet->scene, first, last);
    const double edge = cost_level_cutoff(joined);
    cost_sheet_edge(sheet, level, edge > 0 ? edge : 1);
}

void cost_count(const struct cost_scene *scene, const struct cost_plan *plan, double count[COST_TERMS]) {
    struct cost_level level[INDEX_CLASS_MAX];
    memset(count, 0, COST_TERMS * sizeof *count);
    for (int h = 0; h < plan->levels; h++) {
        level[h] = level_of(scene, first_of(plan, h), plan->last[h]);
        set_cells(scene, &level[h], plan->edge[h]);
        for (int g = 0; g <= h; g++) {
            count_pair(scene, &level[g], &level[h], count);
        }
    }
}

double cost_seconds(const struct cost_scene *scene, const struct cost_plan *plan) {
    double count[COST_TERMS];
    cost_count(scene, plan, count);
    return priced(count) * 1e-9 / (scene->threads > 0 ? scene->threads : 1);
}

void cost_why(const struct cost_scene *scene, const struct cost_plan *plan, char why[INDEX_WHY_MAX]) {
    double count[COST_TERMS];
    size_t used = 0;
    cost_count(scene, plan, count);
    const double sum = priced(count), particles = count[COST_PARTICLE] > 0 ? count[COST_PARTICLE] : 1;
    why[0] = '\0';
    for (int t = 0; t < COST_TERMS; t++) {
        double share = sum > 0 ? 100 * count[t] * prices_event(t) / sum : 0;
        if (share >= 0.5 && used < INDEX_WHY_MAX) {
            used += (size_t)snprintf(why + used, INDEX_WHY_MAX - used, "%s%s %.3g a particle (%.0f %%)",
                                     used ? ", " : "", names[t], count[t] / particles, share);
        }
    }
}
