/* SPDX-License-Identifier: BSD-3-Clause */
/* Random sequential addition: the radii of all sources are drawn first, then placed from large to small, each
 * at the first of its random places that is free. The places of a sphere come from a sequence of its own, so that the packing
 * depends on seed and scene alone. Without moves of placed spheres the density is bounded: equal spheres end
 * at 0.382 of the volume, equal discs at 0.547 of the area (Feder 1980), and the last percents take very
 * long; wide size laws reach more. */
#include "data/scene/source_makers.h"

#include "base/memory.h"
#include "data/scene/source_radii.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct draw {
    double radius;
    uint32_t number; /* in its source */
    int source;
};

static int larger_first(const void *a, const void *b) {
    const struct draw *p = a, *q = b;
    if (p->radius != q->radius)
        return p->radius < q->radius ? 1 : -1;
    if (p->source != q->source)
        return p->source < q->source ? -1 : 1;
    return p->number < q->number ? -1 : p->number > q->number;
}

/* One source at work: its region, and its spheres: `count` radii, or as many as fill the volume fraction. */
struct placing {
    const struct scene *scene;
    int source;
    const struct scene_share *share;
    struct region region;
    struct region_space space;
    struct placegrid *grid;
    size_t count, placed;
    double volume;          /* of the region */
    double wanted, reached; /* volume of the spheres: all, and placed */
};

/* The spheres of all sources. */
struct order {
    struct draw *draw;
    size_t count, capacity;
};

static void order_add(struct order *order, const struct draw *draw) {
    if (order->count == order->capacity) {
        order->capacity = order->capacity ? 2 * order->capacity : 1024;
        order->draw = memory_resize(order->draw, order->capacity, sizeof(*order->draw), "radii");
    }
    order->draw[order->count++] = *draw;
}

/* Draws the radii of a source and adds them to the order. */
static bool draw_radii(struct placing *p, struct order *order, struct error *error) {
    struct source_wish wish = {.source = p->source,
                               .first = (uint64_t)(p->source + 1) << 40,
                               .count = (size_t)p->scene->source[p->source].count,
                               .volume = p->volume,
                               .bytes = 5 * sizeof(double) + sizeof(struct draw)};
    struct source_radii radii;
    bool good = source_radii_draw(p->scene, p->share, &wish, &radii, error);
    for (size_t k = 0; good && k < radii.count; k++)
        order_add(order, &(struct draw){radii.radius[k], (uint32_t)k, p->source});
    p->count = radii.count;
    p->wanted = radii.solid;
    memory_free(radii.radius);
    return good;
}

/* Box-relative, wrapped. */
static void relative(const struct box *box, const double x[3], double y[3]) {
    for (int d = 0; d < 3; d++) {
        y[d] = x[d] - box->origin[d];
        if (box->periodic[d])
            y[d] -= floor(y[d] / box->edge[d]) * box->edge[d];
    }
}

/* Finds a free place for one sphere. */
static bool find_place(const struct placing *p, const struct draw *draw, double x[3]) {
    struct random_sequence random =
        random_sequence(p->scene->seed, RANDOM_POSITION, (uint64_t)(p->source + 1) << 40 | draw->number);
    for (int64_t k = 0; k < p->scene->source[p->source].attempts; k++) {
        double y[3];
        if (!region_draw(&p->region, &p->space, draw->radius, &random, x))
            return false;
        relative(&p->scene->box, x, y);
        if (!placegrid_touches(p->grid, y, draw->radius) &&
            !(p->share->taken && p->share->taken(p->share->context, y, draw->radius)))
            return true;
    }
    return false;
}

/* The plane wall behind which nearly all of many random places lie, although spheres should stand before it;
 * -1: none. */
static int wall_away(const struct placing *p, double radius) {
    enum { TRIES = 200 };
    const struct scene *scene = p->scene;
    for (int w = 0; w < scene->walls; w++) {
        struct random_sequence random =
            random_sequence(scene->seed, RANDOM_POSITION, (uint64_t)(p->source + 1) << 40);
        const struct wall_options *wall = &scene->wall[w];
        int behind = 0;
        for (int k = 0; wall->shape == WALL_PLANE && k < TRIES; k++) {
            double x[3], along = 0;
            if (!region_draw(&p->region, &p->space, radius, &random, x))
                return -1;
            for (int d = 0; d < 3; d++)
                along += wall->normal[d] * (x[d] - wall->point[d]);
            behind += along < radius;
        }
        if (behind > TRIES - TRIES / 20)
            return w;
    }
    return -1;
}

/* The message if not even the first sphere found a place, as walls stand in the way; true without walls. */
static bool walls_leave_room(const struct placing *p, double radius, struct error *error) {
    const struct scene *scene = p->scene;
    char key[96];
    int w = wall_away(p, radius);
    if (w < 0)
        return true;
    const struct wall_options *wall = &scene->wall[w];
    snprintf(key, sizeof(key), "walls[%d].normal", w);
    return scene_fail(
        scene, error, key,
        "wall '%s' faces away from the particles: the places for them lie behind it, and none of "
        "%zu spheres found a place. A normal points to the side of the particles; turned round: "
        "[%g, %g, %g]",
        wall->name, p->count, 0 - wall->normal[0], 0 - wall->normal[1], 0 - wall->normal[2]);
}

static bool not_placed(const struct placing *p, double radius, struct error *error) {
    const struct source_options *source = &p->scene->source[p->source];
    char key[96];
    source_key(p->source, source->count ? "count" : "volume_fraction", key, sizeof(key));
    return scene_fail(
        p->scene, error, key,
        "only %zu of %zu spheres found a place (volume fraction %.4g of %.4g) in %lld attempts for the next "
        "one, of radius %g, clear of others and of walls. Random placement ends at about %s, and nears it "
        "slowly (more attempts); wide "
        "size laws reach more, a lattice or from: packed as well%s",
        p->placed, p->count, p->reached / p->volume, p->wanted / p->volume, (long long)source->attempts,
        radius,
        p->scene->box.dimension == 2 ? "0.547 of the area for equal discs" : "0.382 for equal spheres",
        p->scene->sources > 1 ? ". The spheres of all sources share the room: larger ones were placed first"
                              : "");
}

static bool place_one(struct placing *p, const struct draw *draw, struct source_batch *batch,
                      struct error *error) {
    double *x = batch->rows.position[p->placed], y[3];
    if (!find_place(p, draw, x))
        return (p->placed > 0 || walls_leave_room(p, draw->radius, error)) &&
               not_placed(p, draw->radius, error);
    relative(&p->scene->box, x, y);
    placegrid_add(p->grid, y, draw->radius);
    batch->rows.radius[p->placed++] = draw->radius;
    p->reached += source_form_solid(&p->scene->source[p->source].form) * source_solid(p->scene, draw->radius);
    return true;
}

bool scatter_make(const struct scene *scene, const struct scene_share *share, struct placegrid *grid,
                  struct source_batch *batch, struct error *error) {
    struct placing *placing = memory_allocate_zero((size_t)scene->sources, sizeof(*placing), "sources");
    struct order order = {0};
    bool good = true;
    for (int s = 0; s < scene->sources && good; s++) {
        if (scene->source[s].kind != SOURCE_RANDOM)
            continue;
        struct placing *p = &placing[s];
        *p = (struct placing){.scene = scene, .source = s, .share = share, .grid = grid};
        p->region = source_region(scene, &scene->source[s].region, &p->space);
        p->volume = region_volume(&p->region, &p->space);
        good = draw_radii(p, &order, error);
        if (good)
            rows_create(&batch[s].rows, p->count, ROWS_POSITION | ROWS_RADIUS);
    }
    if (good && order.count > 0)
        qsort(order.draw, order.count, sizeof(*order.draw), larger_first);
    for (size_t k = 0; k < order.count && good; k++) {
        int s = order.draw[k].source;
        source_tell(share, "spheres placed", k, (double)order.count);
        good = place_one(&placing[s], &order.draw[k], &batch[s], error);
    }
    memory_free(order.draw);
    memory_free(placing);
    return good;
}
