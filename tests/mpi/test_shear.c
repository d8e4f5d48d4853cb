/* SPDX-License-Identifier: BSD-3-Clause */
/* Pairs in a sheared box, at any offset: each pair of a plain sum over images is found once, by every index, in
 * two and three dimensions, with bricks and bisections; and the skin holds in a box that moves.
 * Ranks: 1 3 8 */
#include "tests/test.h"

#include "cloud.h"
#include "kernel/comm/domain_tree.h"
#include "kernel/comm/ghosts.h"
#include "base/memory.h"
#include "base/random.h"
#include "kernel/pairs/skin.h"
#include "team.h"

#include <math.h>
#include <string.h>

enum { PARTICLES = 150, SETS = 4, PAIRS_MAX = 1 << 16 };

struct set {
    int dimension, flow, gradient;
    double edge[3];
    enum cloud_radii radii;
};

static const struct set sets[SETS] = {
    {2, 0, 1, {12, 8, 1}, CLOUD_BIDISPERSE},
    {2, 1, 0, {5, 12, 1}, CLOUD_BOULDERS},
    {3, 0, 2, {9, 7, 6}, CLOUD_CONTINUOUS},
    {3, 2, 0, {6, 8, 14}, CLOUD_BOULDERS},
};

/* A pair of the plain sum over images, and how often the ranks have found it. */
struct pair {
    int64_t low, high;
    double apart[3]; /* x_high - x_low */
    int64_t found;
};

struct all_pairs {
    size_t count;
    struct pair *pair;
};

struct bench {
    struct team *team;
    struct cloud cloud;
    struct domain *domain;
    struct ghosts *ghosts;
    struct particles *particles;
    struct pairlist *list;
    bool newton;
};

static struct box box_of(const struct set *set, double offset) {
    struct box box = {.dimension = set->dimension, .periodic = {true, true, set->dimension == 3}};
    memcpy(box.edge, set->edge, sizeof box.edge);
    box.motion = (struct box_motion){.moves = true,
                                     .shears = true,
                                     .flow = set->flow,
                                     .gradient = set->gradient,
                                     .shear = 0.7,
                                     .offset = offset * set->edge[set->flow],
                                     .slide = 0.7 * set->edge[set->gradient]};
    return box;
}

static void image_add(const struct cloud *cloud, size_t i, size_t j, const int image[3], double margin,
                      struct all_pairs *all) {
    double shift[3], apart[3], square = 0, reach = cloud->radius[i] + cloud->radius[j] + margin;
    box_shift(&cloud->box, image, shift);
    for (int d = 0; d < 3; d++) {
        apart[d] = cloud->x[j][d] - cloud->x[i][d] + shift[d];
        square += apart[d] * apart[d];
    }
    if (square > reach * reach)
        return;
    assert_true(all->count < PAIRS_MAX);
    struct pair *pair = &all->pair[all->count++];
    *pair = (struct pair){.low = (int64_t)i + 1, .high = (int64_t)j + 1};
    memcpy(pair->apart, apart, sizeof apart);
}

/* All pairs within the margins, by a plain loop; `touch`: those that touch alone. */
static void pairs_find(const struct cloud *cloud, bool touch, struct all_pairs *all) {
    int deep = cloud->box.dimension == 3 ? 2 : 0;
    all->count = 0;
    all->pair = memory_allocate(PAIRS_MAX, sizeof *all->pair, "pairs");
    for (size_t i = 0; i < cloud->n; i++)
        for (size_t j = i + 1; j < cloud->n; j++) {
            int a = classes_of(&cloud->classes, cloud->radius[i]),
                b = classes_of(&cloud->classes, cloud->radius[j]);
            double margin = touch ? 0 : cloud->classes.margin[a][b];
            for (int z = -deep; z <= deep; z++)
                for (int y = -2; y <= 2; y++)
                    for (int x = -2; x <= 2; x++)
                        image_add(cloud, i, j, (int[3]){x, y, z}, margin, all);
        }
}

/* The entry of a pair, or NULL; entries are in the order of the ids. */
static struct pair *pair_find(const struct all_pairs *all, int64_t low, int64_t high, const double apart[3]) {
    size_t first = 0, last = all->count;
    while (first < last) {
        size_t middle = (first + last) / 2;
        const struct pair *pair = &all->pair[middle];
        bool before = pair->low < low || (pair->low == low && pair->high < high);
        first = before ? middle + 1 : first;
        last = before ? last : middle;
    }
    for (size_t k = first; k < all->count && all->pair[k].low == low && all->pair[k].high == high; k++) {
        struct pair *pair = &all->pair[k];
        if (pair->low == low && pair->high == high && fabs(pair->apart[0] - apart[0]) < 1e-9 &&
            fabs(pair->apart[1] - apart[1]) < 1e-9 && fabs(pair->apart[2] - apart[2]) < 1e-9)
            return pair;
    }
    return NULL;
}

/* Counts the pairs of the list in `all`. */
static void pairs_count(const struct bench *bench, struct all_pairs *all) {
    const struct particles *p = bench->particles;
    const struct pairlist *list = bench->list;
    for (int b = 0; b < list->block_count; b++)
        for (size_t k = list->blocks[b].first_pair; k < list->blocks[b].end_pair; k++) {
            uint32_t i = list->i[k], j = pair_partner(list->j[k]);
            const double *shift = list->shift[pair_image(list->j[k])];
            double sign = p->id[i] < p->id[j] ? 1 : -1, apart[3];
            for (int d = 0; d < 3; d++)
                apart[d] = sign * (p->state[j].x[d] - p->state[i].x[d] + shift[d]);
            struct pair *pair =
                pair_find(all, sign > 0 ? p->id[i] : p->id[j], sign > 0 ? p->id[j] : p->id[i], apart);
            if (pair)
                pair->found++;
            else
                team_expect(bench->team, false, "pair %lld %lld at %g %g %g is none", (long long)p->id[i],
                            (long long)p->id[j], apart[0], apart[1], apart[2]);
        }
}

static void bench_make(struct bench *bench, struct team *team, const struct set *set, double offset,
                       int form) {
    struct box box = box_of(set, offset);
    struct error error = {0};
    struct domain_options options = {.kind = form & 1 ? DOMAIN_BISECTION : DOMAIN_BRICK};
    bench->team = team;
    bench->newton = !(form & 2);
    cloud_make(&bench->cloud, &box, set->radii, PARTICLES, 11);
    bench->domain = domain_create(&team->comm, &bench->cloud.box, &options, &error);
    assert_non_null(bench->domain);
    struct ghosts_options ghosts = {.newton = bench->newton, .reduced = bench->newton, .in_place = true};
    bench->ghosts = ghosts_create(&team->comm, bench->domain, &bench->cloud.box, &ghosts);
    bench->particles = particles_create(0);
    for (size_t k = 0; k < bench->cloud.n; k++)
        if (k % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&bench->cloud, k, 3, bench->particles);
    bench->list = pairlist_create(&(struct pairlist_options){.threads = 1});
}

static void bench_free(struct bench *bench) {
    pairlist_destroy(&bench->list);
    ghosts_destroy(&bench->ghosts);
    particles_destroy(&bench->particles);
    domain_destroy(&bench->domain);
    cloud_free(&bench->cloud);
}

/* A rebuild with one index, as the engine does it. */
static void bench_build(struct bench *bench, const char *name) {
    struct error error = {0};
    struct index_params params = {0};
    struct index_view view;
    bool wrap[3];
    ghosts_drop(bench->ghosts, bench->particles);
    box_settle(&bench->cloud.box);
    domain_follow(bench->domain, &bench->cloud.box);
    assert_true(particles_wrap(bench->particles, &bench->cloud.box));
    ghosts_migrate(bench->ghosts, bench->particles, NULL);
    particles_classify(bench->particles, &bench->cloud.classes);
    ghosts_make(bench->ghosts, bench->particles, &bench->cloud.classes);
    domain_wrap(bench->domain, wrap);
    pairlist_view(&view, bench->particles, &bench->cloud.classes, &bench->cloud.box, wrap);
    view.newton = bench->newton;
    view.threads = 1;
    struct index *index = index_create(name, &params, &error);
    assert_non_null(index);
    index_build(index, &view);
    pairlist_build(bench->list, index, &view, &bench->cloud.box);
    pairlist_add_images(bench->list, bench->particles->owned,
                        ghosts_unshift(bench->ghosts, bench->particles));
    index_destroy(&index);
}

/* Each pair is found as often as the rule says: once, or with newton off by each rank that owns one of the two. */
static void expect_pairs(struct bench *bench, struct all_pairs *all, const char *index) {
    int64_t across = 0, *found = memory_allocate(all->count, sizeof *found, "pairs");
    for (size_t k = 0; k < all->count; k++)
        all->pair[k].found = 0;
    pairs_count(bench, all);
    for (size_t k = 0; k < all->count; k++)
        found[k] = all->pair[k].found;
    comm_sum_int(&bench->team->comm, found, (int)all->count);
    for (size_t k = 0; k < all->count; k++) {
        struct pair *pair = &all->pair[k];
        pair->found = found[k];
        bool one = pair->found == 1 || (!bench->newton && pair->found == 2);
        across += fabs(pair->apart[bench->cloud.box.motion.gradient] -
                       (bench->cloud.x[pair->high - 1][bench->cloud.box.motion.gradient] -
                        bench->cloud.x[pair->low - 1][bench->cloud.box.motion.gradient])) > 1e-9;
        team_expect(bench->team, one, "%s: pair %lld %lld was found %lld times", index, (long long)pair->low,
                    (long long)pair->high, (long long)pair->found);
    }
    team_expect(bench->team, across > 0, "no pair across the sheared face");
    memory_free(found);
}

static void every_index(struct team *team, const struct set *set, double offset, int form) {
    struct all_pairs all = {0};
    for (int k = 0; k < index_registry_count(); k++) {
        struct bench bench;
        const char *name = index_registry_get(k)->name;
        bench_make(&bench, team, set, offset, (k + form) % 4);
        if (k == 0)
            pairs_find(&bench.cloud, false, &all);
        bench_build(&bench, name);
        expect_pairs(&bench, &all, name);
        bench_free(&bench);
    }
    memory_free(all.pair);
}

static void every_index_finds_all(void **state) {
    static const double offsets[] = {0, 0.31, -0.5, 1.77};
    struct team *team = *state;
    for (int s = 0; s < SETS; s++)
        for (int o = 0; o < 4; o++)
            every_index(team, &sets[s], offsets[o], o);
    team_finish(team);
}

/* Particles go with the flow, and a little beside it. */
static void drift(struct bench *bench, int step, double dt, double speed) {
    box_advance(&bench->cloud.box, dt);
    pairlist_follow(bench->list, &bench->cloud.box);
    for (size_t k = 0; k < bench->particles->owned; k++) {
        struct particle_state *p = &bench->particles->state[k];
        struct random_sequence sequence = random_sequence(7, RANDOM_TEST, (uint64_t)bench->particles->id[k]);
        sequence.draw = (uint32_t)(3 * (step / 10));
        box_flow(&bench->cloud.box, p->x, p->v);
        for (int d = 0; d < bench->cloud.box.dimension; d++)
            p->v[d] += speed * (2 * random_uniform(&sequence) - 1);
        for (int d = 0; d < 3; d++)
            p->x[d] += dt * p->v[d];
        memcpy(bench->cloud.x[bench->particles->id[k] - 1], p->x, sizeof p->x);
    }
}

/* On one rank: until the skin says that a rebuild is due, each pair that touches is in the list; and the bound never
 * falls below what is measured. */
static void skin_holds(void **state) {
    struct team *team = *state;
    for (int s = 0; s < 2 * SETS && team->comm.size == 1; s++) {
        struct bench bench;
        bench_make(&bench, team, &sets[s % SETS], 0.2, 0);
        if (s >= SETS) /* a strain as well */
            bench.cloud.box.motion.speed[bench.cloud.box.motion.flow] = -2.5;
        struct skin *skin = skin_create();
        int classes = bench.cloud.classes.count, lasted = 0, step = 0;
        skin_follow(skin, &bench.cloud.box);
        bench_build(&bench, "linkcell");
        skin_reset(skin, bench.particles, &bench.cloud.classes, 0);
        for (; step < 400 && lasted < 3; step++) {
            double speed[CLASS_MAX] = {0}, dt = 5e-5;
            drift(&bench, step, dt, s % 2 ? 0.05 : 1);
            for (size_t k = 0; k < bench.particles->owned; k++) {
                double *most = &speed[bench.particles->size_class[k]];
                *most = fmax(*most, sqrt(skin_speed2(&bench.cloud.box, &bench.particles->state[k], dt)));
            }
            skin_moved(skin, speed, classes, dt, 0);
            double bound[CLASS_MAX];
            memcpy(bound, skin->bound, sizeof bound);
            skin_measure(skin, bench.particles, classes);
            for (int c = 0; c < classes; c++)
                team_expect(team, skin->bound[c] <= bound[c] * (1 + 1e-9), "class %d moved %g, bound %g", c,
                            skin->bound[c], bound[c]);
            if (skin_due(skin, &bench.cloud.classes)) {
                lasted++;
                bench_build(&bench, "linkcell");
                for (size_t k = 0; k < bench.particles->owned; k++)
                    memcpy(bench.cloud.x[bench.particles->id[k] - 1], bench.particles->state[k].x,
                           3 * sizeof(double));
                skin_reset(skin, bench.particles, &bench.cloud.classes, 0);
                continue;
            }
            if (step % 10)
                continue;
            struct all_pairs all;
            pairs_find(&bench.cloud, true, &all);
            const struct pairlist *list = bench.list;
            for (size_t k = 0; k < all.count; k++) {
                bool there = false;
                for (size_t p = 0; p < list->pair_count && !there; p++) {
                    int64_t a = bench.particles->id[list->i[p]],
                            b = bench.particles->id[pair_partner(list->j[p])];
                    there = (a == all.pair[k].low && b == all.pair[k].high) ||
                            (b == all.pair[k].low && a == all.pair[k].high);
                }
                team_expect(team, there, "set %d, step %d: %lld and %lld touch and are in no list", s, step,
                            (long long)all.pair[k].low, (long long)all.pair[k].high);
            }
            memory_free(all.pair);
        }
        team_expect(team, step > 4, "set %d: the lists lasted %d steps", s, step);
        skin_destroy(&skin);
        bench_free(&bench);
    }
    team_finish(team);
}

/* A particle that crosses keeps its velocity relative to the flow, and its unwrapped place. */
static void crossing(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SETS; s++) {
        struct box box = box_of(&sets[s], 0.4);
        struct particles *particles = particles_create(0);
        particles_count_images(particles);
        size_t i = particles_append(particles);
        struct particle_state *p = &particles->state[i];
        *p = (struct particle_state){.x = {1, 2, 0.5}, .radius = 0.1};
        double far[3] = {1, 2, 0.5};
        for (int step = 0; step < 60; step++) {
            double flow[3], own[3] = {0.3, 0.2, 0.01}, shift[3];
            own[box.motion.gradient] = step < 30 ? 4 : -5;
            box_flow(&box, p->x, flow);
            for (int d = 0; d < 3; d++) {
                p->v[d] = flow[d] + own[d];
                p->x[d] += 0.3 * own[d] + (d == box.motion.flow ? 0.3 * flow[d] : 0);
            }
            double before[3], after[3];
            box_flow(&box, p->x, flow);
            for (int d = 0; d < 3; d++)
                before[d] = p->v[d] - flow[d];
            box_unwrap(&box, particles_images(particles)[i], shift);
            for (int d = 0; d < 3; d++)
                far[d] = p->x[d] + shift[d];
            if (step % 7 == 3)
                box_settle(&box);
            assert_true(particles_wrap(particles, &box));
            box_flow(&box, p->x, flow);
            box_unwrap(&box, particles_images(particles)[i], shift);
            for (int d = 0; d < 3; d++) {
                after[d] = p->v[d] - flow[d];
                team_expect(team, fabs(after[d] - before[d]) < 1e-12, "velocity %g became %g", before[d],
                            after[d]);
                team_expect(team, fabs(p->x[d] + shift[d] - far[d]) < 1e-10, "place %g became %g", far[d],
                            p->x[d] + shift[d]);
            }
            box_advance(&box, 0.3);
        }
        particles_destroy(&particles);
    }
    team_finish(team);
}

TEAM_MAIN(shear, team_case(every_index_finds_all), team_case(skin_holds), team_case(crossing))
