/* SPDX-License-Identifier: BSD-3-Clause */
/* The questions about the division of the box, for bricks and for bisection. Read domain.h first. */
#include "kernel/comm/domain.h"

#include "kernel/comm/domain_grid.h"
#include "kernel/comm/domain_tree.h"
#include "base/memory.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rank (i, j, k) of the grid is number i + grid[0] (j + grid[1] k). */
struct domain {
    int rank, size;
    int grid[3];
    struct box box; /* as it was at the last rebuild */
    double edge[3];
    bool periodic[3], wrapped[3];
    int axis[3];              /* the order of a search by bricks: the gradient of a shear before its flow */
    double *cut[3];           /* grid[d] + 1 faces of the subdomains in direction d, from 0 to the edge */
    struct domain_tree *tree; /* of a bisection, which has no grid and cut; else NULL */
    struct domain_place *neighbour;
    size_t neighbours;
    double clearance;
};

/* True if images along d slide along another direction, so that no index can wrap d. */
static bool slides(const struct domain *domain, int d) {
    return domain->box.motion.shears && d == domain->box.motion.gradient;
}

static void bricks_lay(struct domain *domain, const int grid[3]) {
    for (int d = 0; d < 3; d++) {
        int n = grid[d];
        domain->grid[d] = n;
        domain->wrapped[d] = domain->periodic[d] && n == 1 && !slides(domain, d);
        memory_free(domain->cut[d]);
        domain->cut[d] = memory_allocate((size_t)n + 1, sizeof(double), "domain faces");
        for (int i = 0; i < n; i++)
            domain->cut[d][i] = domain->edge[d] * i / n;
        domain->cut[d][n] = domain->edge[d];
    }
}

static void look_around(struct domain *domain);

struct domain *domain_create(const struct comm *comm, const struct box *box,
                             const struct domain_options *options, struct error *error) {
    int grid[3];
    bool bisects = options->kind == DOMAIN_BISECTION;
    if (!bisects && !domain_grid_choose(comm->size, box, options->grid, NULL, grid)) {
        domain_grid_refuse(comm->size, box, options->grid, error);
        return NULL;
    }
    struct domain *domain = memory_allocate_zero(1, sizeof *domain, "domain");
    domain->rank = comm->rank;
    domain->size = comm->size;
    domain->box = *box;
    memcpy(domain->edge, box->edge, sizeof domain->edge);
    memcpy(domain->periodic, box->periodic, sizeof domain->periodic);
    for (int k = 0; k < 3; k++)
        domain->axis[k] = (k + (box->motion.shears ? box->motion.gradient : 0)) % 3;
    if (bisects) {
        domain_divide(domain, domain_tree_halve(comm->size, box));
    } else {
        bricks_lay(domain, grid);
        look_around(domain);
    }
    return domain;
}

void domain_lay(struct domain *domain, const int grid[3]) {
    assert(domain->tree == NULL && grid[0] * grid[1] * grid[2] == domain->size);
    bricks_lay(domain, grid);
    look_around(domain);
}

void domain_divide(struct domain *domain, struct domain_tree *tree) {
    domain_tree_destroy(&domain->tree);
    domain->tree = tree;
    for (int d = 0; d < 3; d++)
        domain->wrapped[d] = domain->periodic[d] && !domain_tree_cuts(tree, d) && !slides(domain, d);
    look_around(domain);
}

void domain_follow(struct domain *domain, const struct box *box) {
    for (int d = 0; d < 3; d++) {
        double growth = box->edge[d] / domain->edge[d];
        for (int i = 0; domain->cut[d] && i <= domain->grid[d]; i++)
            domain->cut[d][i] = i < domain->grid[d] ? domain->cut[d][i] * growth : box->edge[d];
        if (domain->tree)
            domain_tree_stretch(domain->tree, d, growth);
    }
    domain->box = *box;
    memcpy(domain->edge, box->edge, sizeof domain->edge);
    look_around(domain);
}

void domain_settle_image(const struct domain *domain, const double x[3], int image[3]) {
    const struct box *box = &domain->box;
    int flow = box->motion.flow;
    double shift[3];
    if (!box->motion.shears || !domain->wrapped[flow])
        return;
    image[flow] = 0;
    box_shift(box, image, shift);
    image[flow] = -(int)floor((x[flow] + shift[flow]) / box->edge[flow]);
}

bool domain_bisects(const struct domain *domain) {
    return domain->tree != NULL;
}

const struct domain_tree *domain_tree(const struct domain *domain) {
    return domain->tree;
}

void domain_destroy(struct domain **domain) {
    if (*domain == NULL)
        return;
    for (int d = 0; d < 3; d++)
        memory_free((*domain)->cut[d]);
    domain_tree_destroy(&(*domain)->tree);
    memory_free((*domain)->neighbour);
    memory_free(*domain);
    *domain = NULL;
}

/* The slab that holds a coordinate. The first guess may be wrong by rounding; the faces decide. */
static int slab_of(const struct domain *domain, int d, double x) {
    int n = domain->grid[d];
    const double *cut = domain->cut[d];
    if (n == 1 || !(x >= cut[1]))
        return 0;
    if (x >= cut[n - 1])
        return n - 1;
    int i = (int)(x * n / domain->edge[d]);
    while (x < cut[i])
        i--;
    while (x >= cut[i + 1])
        i++;
    return i;
}

static int rank_of(const struct domain *domain, const int slab[3]) {
    return slab[0] + domain->grid[0] * (slab[1] + domain->grid[1] * slab[2]);
}

int domain_owner(const struct domain *domain, const double x[3]) {
    int slab[3];
    if (domain->tree)
        return domain_tree_owner(domain->tree, x);
    for (int d = 0; d < 3; d++)
        slab[d] = slab_of(domain, d, x[d]);
    return rank_of(domain, slab);
}

static double slab_lower(const struct domain *domain, int d, int i) {
    return i == 0 && !domain->periodic[d] ? -INFINITY : domain->cut[d][i];
}

static double slab_upper(const struct domain *domain, int d, int i) {
    return i == domain->grid[d] - 1 && !domain->periodic[d] ? INFINITY : domain->cut[d][i + 1];
}

static void whole_bounds(const struct domain *domain, double lower[3], double upper[3]) {
    for (int d = 0; d < 3; d++) {
        lower[d] = domain->periodic[d] ? 0 : -INFINITY;
        upper[d] = domain->periodic[d] ? domain->edge[d] : INFINITY;
    }
}

void domain_bounds(const struct domain *domain, int rank, double lower[3], double upper[3]) {
    assert(rank >= 0 && rank < domain->size);
    if (domain->tree) {
        whole_bounds(domain, lower, upper);
        domain_tree_bounds(domain->tree, rank, lower, upper);
        return;
    }
    int slab[3] = {rank % domain->grid[0], rank / domain->grid[0] % domain->grid[1],
                   rank / domain->grid[0] / domain->grid[1]};
    for (int d = 0; d < 3; d++) {
        lower[d] = slab_lower(domain, d, slab[d]);
        upper[d] = slab_upper(domain, d, slab[d]);
    }
}

/* A search for the subdomains within `radius` of a cuboid, which may be a point. */
struct touching {
    const struct domain *domain;
    const double *from, *to;
    double radius;
    struct domain_touch *touch;
    int room, found;
    int slab[3]; /* the present slab of the search */
    signed char image[3];
};

static void touching_put(void *context, int rank) {
    struct touching *search = context;
    if (search->found < search->room) {
        struct domain_touch *touch = &search->touch[search->found];
        touch->rank = rank;
        for (int d = 0; d < 3; d++)
            touch->image[d] = search->image[d];
    }
    search->found++;
}

static void touching_axis(struct touching *search, int d, double squared);

/* The slabs of direction d near one image of the ball. Distances are formed exactly as those of pairs are
 * (x + shift first, squares added in the order x, y, z), so that rounding never makes a subdomain look
 * farther away than a particle in it. */
static void touching_slabs(struct touching *search, int step, int image, double squared) {
    const struct domain *domain = search->domain;
    const struct box_motion *motion = &domain->box.motion;
    int d = domain->axis[step];
    double shift = image * domain->edge[d];
    if (motion->shears && d == motion->flow)
        shift += search->image[motion->gradient] * motion->offset;
    double from = search->from[d] + shift, to = search->to[d] + shift;
    int first = slab_of(domain, d, from - search->radius), last = slab_of(domain, d, to + search->radius);
    if (first > 0)
        first--; /* rounding may have moved from - radius over a face */
    if (last < domain->grid[d] - 1)
        last++;
    search->image[d] = (signed char)image;
    for (int i = first; i <= last; i++) {
        double distance = domain_gap(slab_lower(domain, d, i), slab_upper(domain, d, i), from, to);
        double sum = squared + distance * distance;
        search->slab[d] = i;
        if (sum <= search->radius * search->radius)
            touching_axis(search, step + 1, sum);
    }
}

static void touching_axis(struct touching *search, int step, double squared) {
    if (step == 3) {
        touching_put(search, rank_of(search->domain, search->slab));
        return;
    }
    int d = search->domain->axis[step];
    if (search->domain->wrapped[d]) {
        search->slab[d] = 0;
        search->image[d] = 0;
        touching_axis(search, step + 1, squared);
        return;
    }
    int images = search->domain->periodic[d] ? 1 : 0;
    for (int image = -images; image <= images; image++)
        touching_slabs(search, step, image, squared);
}

/* As touching_slabs, for a tree of cuts: the leaves near each image. */
static void touching_tree(struct touching *search) {
    const struct domain *domain = search->domain;
    double lower[3], upper[3], from[3], to[3];
    int images[3];
    whole_bounds(domain, lower, upper);
    for (int d = 0; d < 3; d++)
        images[d] = domain->periodic[d] && !domain->wrapped[d] ? 1 : 0;
    struct domain_tree_search leaves = {from, to, search->radius, domain->wrapped, touching_put, search};
    for (int turn = 0; turn < IMAGE_CODES; turn++) {
        const int image[3] = {turn / 9 - 1, turn / 3 % 3 - 1, turn % 3 - 1};
        bool exists = true;
        double shift[3];
        box_shift(&domain->box, image, shift);
        for (int d = 0; d < 3; d++) {
            exists = exists && abs(image[d]) <= images[d];
            from[d] = search->from[d] + shift[d];
            to[d] = search->to[d] + shift[d];
            search->image[d] = (signed char)image[d];
        }
        if (exists)
            domain_tree_near(domain->tree, &leaves, lower, upper);
    }
}

static int touching_cuboid(const struct domain *domain, const double from[3], const double to[3],
                           double radius, struct domain_touch *touch, int room) {
    struct touching search = {
        .domain = domain, .from = from, .to = to, .radius = radius, .touch = touch, .room = room};
    if (domain->tree)
        touching_tree(&search);
    else
        touching_axis(&search, 0, 0);
    return search.found;
}

int domain_touching(const struct domain *domain, const double x[3], double radius, struct domain_touch *touch,
                    int room) {
    return touching_cuboid(domain, x, x, radius, touch, room);
}

double domain_place_distance2(const struct domain *domain, const struct domain_place *place,
                              const double x[3], const int image[3]) {
    double squared = 0, shift[3];
    box_shift(&domain->box, image, shift);
    for (int d = 0; d < 3; d++) {
        double y = x[d] + shift[d];
        double gap = domain_gap(place->lower[d], place->upper[d], y, y);
        squared += domain->wrapped[d] ? 0 : gap * gap;
    }
    return squared;
}

/* Distance of a touched subdomain from the own one. */
static double distance_of(const struct domain *domain, const struct domain_touch *touch) {
    double lower[3], upper[3], own_lower[3], own_upper[3], squared = 0;
    domain_bounds(domain, touch->rank, lower, upper);
    domain_bounds(domain, domain->rank, own_lower, own_upper);
    double shift[3];
    box_shift(&domain->box, (int[3]){touch->image[0], touch->image[1], touch->image[2]}, shift);
    for (int d = 0; d < 3; d++) {
        double gap = domain_gap(lower[d], upper[d], own_lower[d] + shift[d], own_upper[d] + shift[d]);
        squared += domain->wrapped[d] ? 0 : gap * gap;
    }
    return sqrt(squared);
}

/* All subdomains within `radius` of the own one; *touch is allocated. */
static int all_around(const struct domain *domain, double radius, struct domain_touch **touch) {
    double lower[3], upper[3];
    domain_bounds(domain, domain->rank, lower, upper);
    int n = touching_cuboid(domain, lower, upper, radius, NULL, 0);
    *touch = memory_allocate((size_t)n, sizeof **touch, "subdomains around");
    return touching_cuboid(domain, lower, upper, radius, *touch, n);
}

static int compare_places(const void *a, const void *b) {
    const struct domain_place *left = a, *right = b;
    if (left->rank != right->rank)
        return left->rank < right->rank ? -1 : 1;
    return memcmp(left->image, right->image, sizeof left->image);
}

static void find_neighbours(struct domain *domain) {
    struct domain_touch *touch;
    int n = all_around(domain, 0, &touch);
    memory_free(domain->neighbour);
    domain->neighbour = memory_allocate((size_t)n, sizeof *domain->neighbour, "neighbour subdomains");
    domain->neighbours = 0;
    for (int t = 0; t < n; t++) {
        bool moved = touch[t].image[0] != 0 || touch[t].image[1] != 0 || touch[t].image[2] != 0;
        if (touch[t].rank == domain->rank && !moved)
            continue;
        struct domain_place *place = &domain->neighbour[domain->neighbours++];
        place->rank = touch[t].rank;
        memcpy(place->image, touch[t].image, sizeof place->image);
        domain_bounds(domain, place->rank, place->lower, place->upper);
        double shift[3];
        box_shift(&domain->box, (int[3]){place->image[0], place->image[1], place->image[2]}, shift);
        for (int d = 0; d < 3; d++) {
            place->seen_lower[d] = place->lower[d] - shift[d];
            place->seen_upper[d] = place->upper[d] - shift[d];
        }
    }
    if (domain->neighbours > 1)
        qsort(domain->neighbour, domain->neighbours, sizeof *domain->neighbour, compare_places);
    memory_free(touch);
}

/* Searches at growing distance until a subdomain is found that is no neighbour. */
static double find_clearance(const struct domain *domain) {
    double most = 0, clearance = INFINITY;
    for (int d = 0; d < 3; d++)
        most += 2 * domain->edge[d];
    for (int d = 0; d < 3; d++)
        if (domain->periodic[d] && !domain->wrapped[d])
            most = fmin(most, domain->edge[d]);
    double radius = most / (8 * cbrt(domain->size));
    while (!isfinite(clearance)) {
        struct domain_touch *touch;
        radius = fmin(2 * radius, most);
        int n = all_around(domain, radius, &touch);
        for (int t = 0; t < n; t++) {
            double distance = distance_of(domain, &touch[t]);
            if (distance > 0)
                clearance = fmin(clearance, distance);
        }
        memory_free(touch);
        if (radius >= most)
            break;
    }
    return clearance;
}

static void look_around(struct domain *domain) {
    find_neighbours(domain);
    domain->clearance = find_clearance(domain);
}

const struct domain_place *domain_neighbours(const struct domain *domain, size_t *count) {
    *count = domain->neighbours;
    return domain->neighbour;
}

double domain_clearance(const struct domain *domain) {
    return domain->clearance;
}

void domain_wrap(const struct domain *domain, bool wrap[3]) {
    for (int d = 0; d < 3; d++)
        wrap[d] = domain->wrapped[d];
}

void domain_grid(const struct domain *domain, int grid[3]) {
    for (int d = 0; d < 3; d++)
        grid[d] = domain->grid[d];
}
