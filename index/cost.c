#include "index/cost.h"

#include "index/levels.h"

#include <math.h>
#include <stdio.h>

enum { SPAN_OWN = 12, SPAN_OTHER = 32, LANES = 8 };

/* Nanoseconds an event: fitted on an AMD EPYC (Zen 4), AVX-512. */
static const double price[COST_TERMS] = {
    [COST_PARTICLE] = 20, [COST_MIXED] = 60,  [COST_VISIT] = 8.5, [COST_RUN] = 12.7,
    [COST_ROUND] = 14,    [COST_SPARSE] = 20, [COST_TEST] = 2.45,
};

static const char *const names[COST_TERMS] = {
    [COST_PARTICLE] = "particles", [COST_MIXED] = "mixed",   [COST_VISIT] = "visits", [COST_RUN] = "runs",
    [COST_ROUND] = "round",        [COST_SPARSE] = "sparse", [COST_TEST] = "tests",
};

const char *cost_name(enum cost_term term) {
    return names[term];
}

double cost_price(enum cost_term term) {
    return price[term];
}

/* One level as the model sees it. */
struct part {
    double count, radius_max, margin, edge;
    bool mixed;
    double density; /* a length unit^dimension */
    double pencil;  /* particles in a pencil */
    double pencils;
    bool sparse;
    double span_radius[2]; /* largest radius to be expected in a span: own, other */
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
    struct part part = {.edge = plan->edge[level]};
    for (int bin = first; bin <= last; bin++) {
        if (scene->count[bin] > 0) {
            part.mixed = scene->classes && part.count > 0;
            part.margin = part.count == 0 || scene->classes ? scene->margin[bin] : part.margin;
            part.count += scene->count[bin];
            part.radius_max = scene->radius_max[bin];
        }
    }
    if (part.count == 0) {
        return part;
    }
    double across = pow(scene->volume, 1.0 / scene->dimension);
    double wide = fmax(1, across / part.edge);
    part.density = part.count / scene->volume;
    part.pencils = scene->dimension == 3 ? wide * wide : wide;
    part.pencil = part.count / part.pencils;
    part.sparse = levels_too_many_cells(levels_cells(scene->volume, part.edge, scene->dimension), part.count);
    part.span_radius[0] = largest_of(scene, first, last, part.count, fmin(SPAN_OWN, part.pencil + 1));
    part.span_radius[1] = largest_of(scene, first, last, part.count, fmin(SPAN_OTHER, part.pencil + 1));
    return part;
}

double cost_cutoff(const struct cost_scene *scene, const struct cost_plan *plan, int level) {
    struct part part = part_of(scene, plan, level);
    return part.count > 0 ? 2 * part.radius_max + part.margin : 0;
}

/* Groups of at most `most` rows into which the pencils of a level fall. */
static double spans_of(const struct part *part, double most) {
    double some = 1 - exp(-part->pencil);
    return part->pencils *
           (part->pencil / most + 0.5 * some * (1 + exp(-part->pencil / most)) * (1 - 1 / most));
}

/* Rows of g in the table of h. */
static void count_search(const struct cost_scene *scene, const struct part *g, const struct part *h, bool own,
                         double count[COST_TERMS]) {
    bool flat = scene->dimension == 2;
    double most = own ? SPAN_OWN : SPAN_OTHER;
    double spans = spans_of(g, most), rows = g->count / spans;
    double across = pow(scene->volume, 1.0 / scene->dimension);
    double reach = g->span_radius[own ? 0 : 1] + h->radius_max + g->margin;
    double length = fmin(across, rows / g->pencil * across);
    double width = fmin(g->edge, across) * (rows - 1) / (rows + 1);
    double high = fmin(width + 2 * reach + h->edge, 3 * across), wide = flat ? h->edge : high;
    double pencils = high * wide / (h->edge * h->edge);
    double area = high * (flat ? 1 : wide);
    bool round = high + (flat ? 0 : wide) > 6.5 * h->edge;
    if (!flat && round) { /* the corners are left out */
        area *= 0.85;
    }
    double share = own ? 0.5 + 0.5 / pencils : 1;
    double row_empty = exp(-h->density * high * (flat ? 1 : h->edge) * across);
    double found = h->density * area * share * fmin(length + 2 * reach + 0.5 * h->edge, 3 * across);
    double runs = share * ((1 - row_empty) * pencils + (flat ? 1 : wide / h->edge));
    double some = 1 - exp(-found);
    count[COST_VISIT] += g->count;
    count[COST_RUN] += spans * runs;
    count[COST_ROUND] += round ? spans * runs : 0;
    count[COST_SPARSE] += h->sparse ? spans * runs : 0;
    count[COST_TEST] += spans * rows * (found / LANES + 0.5 * some);
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
            if (part[h].count > 0) {
                count_search(scene, &part[g], &part[h], g == h, count);
            }
        }
    }
}

double cost_seconds(const struct cost_scene *scene, const struct cost_plan *plan) {
    double count[COST_TERMS], sum = 0;
    cost_count(scene, plan, count);
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * price[t];
    }
    return sum * 1e-9 / (scene->threads > 0 ? scene->threads : 1);
}

void cost_why(const struct cost_scene *scene, const struct cost_plan *plan, char why[INDEX_WHY_MAX]) {
    double count[COST_TERMS], sum = 0, particles = 0;
    size_t used = 0;
    cost_count(scene, plan, count);
    for (int t = 0; t < COST_TERMS; t++) {
        sum += count[t] * price[t];
    }
    particles = count[COST_PARTICLE] > 0 ? count[COST_PARTICLE] : 1;
    why[0] = '\0';
    for (int t = 0; t < COST_TERMS; t++) {
        double share = sum > 0 ? 100 * count[t] * price[t] / sum : 0;
        if (share >= 0.5 && used < INDEX_WHY_MAX) {
            used += (size_t)snprintf(why + used, INDEX_WHY_MAX - used, "%s%s %.3g a particle (%.0f %%)",
                                     used ? ", " : "", names[t], count[t] / particles, share);
        }
    }
}
