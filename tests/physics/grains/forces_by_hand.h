/* SPDX-License-Identifier: BSD-3-Clause */
/* A cloud and a force loop over it, for tests. Include after cmocka.h. */
#ifndef SCREE_TESTS_FORCES_BY_HAND_H
#define SCREE_TESTS_FORCES_BY_HAND_H

#include "physics/grains/batch/force.h"
#include "physics/grains/laws/law_kernel.h"
#include "base/random.h"
#include "tests/physics/grains/pairs_by_hand.h"
#include "tests/near.h"
#include "tests/fields_by_hand.h"
#include "tests/own_law.h"
#include <omp.h>

enum { COUNT = 200, MATERIALS = 3, LAWS = 8 * 2 * LAW_ELASTIC_COUNT };

static const double edge = 4.8;
static const char *const kernels[] = {"baseline", "x86-64-v3", "x86-64-v4"};

/* A law of these options, with coefficients that differ by material. */
static inline struct law law_with(const struct law_options *options, int materials) {
    static struct law_pair pair[MATERIALS * MATERIALS];
    struct law_material material[MATERIALS];
    for (int a = 0; a < MATERIALS; a++)
        material[a] = (struct law_material){"m", 1.0, 1e5 * (1.0 + a), 0.2 + 0.1 * a};
    for (int a = 0; a < materials; a++)
        for (int b = a; b < materials; b++)
            pair[law_place_of(materials, a, b)] = (struct law_pair){.restitution = 0.4 + 0.1 * a,
                                                                    .friction = 0.2 + 0.1 * b,
                                                                    .rolling_friction = 0.1,
                                                                    .k_n = 1e3 * (1.0 + a + b),
                                                                    .k_t = 4e2 * (1.0 + a),
                                                                    .gamma_n = 5.0,
                                                                    .gamma_t = 2.0};
    struct law law;
    struct error error = {0};
    if (!law_prepare(&law, options, materials, material, pair, &error))
        fail_msg("%s", error.text);
    return law;
}

/* Law number k of all that the loop specialises, and some with other options. */
static inline struct law law_number(int k, int materials) {
    struct law_options o = law_options_default();
    int friction = k / (2 * LAW_ELASTIC_COUNT) % 5;
    o.normal = (enum law_normal)(k / 2 % LAW_ELASTIC_COUNT);
    o.damping = k % 2 ? LAW_DAMPING_COEFFICIENT : LAW_DAMPING_RESTITUTION;
    o.tangential = friction == 0 ? LAW_FRICTIONLESS : LAW_TANGENTIAL_HISTORY;
    o.rolling = friction > 2 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    o.synchronised = friction == 2 || friction == 4;
    bool second = k >= 5 * 2 * LAW_ELASTIC_COUNT;
    o.end = second ? LAW_END_FORCE : LAW_END_OVERLAP;
    o.lammps_history = second && !o.synchronised;
    return law_with(&o, materials);
}

/* LAMMPS's granular style. */
static inline struct law law_granular(int materials) {
    struct law_options o = law_options_default();
    o.tangential = LAW_TANGENTIAL_HISTORY;
    o.synchronised = false;
    o.end = LAW_END_OVERLAP;
    o.lammps_granular = true;
    return law_with(&o, materials);
}

/* A dense random cloud in a periodic cube: small spheres and a few of three times the size. */
static inline struct particles *cloud(const struct law *law, size_t count, double box) {
    unsigned features = (law->spin ? WITH_SPIN : 0u) | (law->materials > 1 ? WITH_MATERIAL : 0u);
    struct particles *p = particles_with(features, count);
    for (size_t k = 0; k < count; k++) {
        struct random_sequence r = random_sequence(7, RANDOM_TEST, k);
        particles_append(p);
        struct particle_state *s = &p->state[k];
        s->radius = k % 25 == 0 ? 1.2 : 0.3 + 0.1 * random_uniform(&r);
        s->inverse_mass = 1.0 / particles_sphere_mass(s->radius, 1.0);
        for (int c = 0; c < 3; c++) {
            s->x[c] = box * random_uniform(&r);
            s->v[c] = random_normal(&r);
            double omega = 2.0 * random_normal(&r); /* drawn in any case: the same cloud for all laws */
            if (law->spin)
                spin_of(p)[k][c] = omega;
        }
        if (law->materials > 1)
            material_numbers(p)[k] = (uint8_t)(k % (size_t)law->materials);
        p->id[k] = (int64_t)((k * 7919) % count + 1);
    }
    return p;
}

struct layout {
    int threads;
    double busy;
    const char *kernel;
};

/* Lists of the cloud, one for each layout that the tests use: they depend on no law. */
static struct pairlist lists[4];
static const struct layout list_layouts[4] = {{1, 0.0, NULL}, {2, 0.0, NULL}, {3, 1.0, NULL}, {2, 1.0, NULL}};

static inline int make_lists(void **state) {
    (void)state;
    struct law law = {.materials = 1};
    struct particles *p = cloud(&law, COUNT, edge);
    for (int l = 0; l < 4; l++)
        hand_make(&lists[l], p,
                  &(struct hand_options){.threads = list_layouts[l].threads,
                                         .margin = 0.1,
                                         .edge = edge,
                                         .busy = list_layouts[l].busy});
    particles_destroy(&p);
    return 0;
}

static inline int free_lists(void **state) {
    (void)state;
    for (int l = 0; l < 4; l++)
        hand_free(&lists[l]);
    return 0;
}

/* A force loop over a cloud, with all that it needs. */
struct rig {
    struct particles *particles;
    struct pairlist list; /* borrows its arrays from `lists` */
    struct history *history;
    struct force_loop *loop;
    struct force_context context;
    struct force_sums sums;
};

/* False if this CPU lacks the kernel. */
static inline bool rig_make(struct rig *rig, const struct law *law, struct layout layout) {
    omp_set_num_threads(layout.threads);
    *rig = (struct rig){.loop = force_loop_create(layout.threads)};
    if (layout.kernel && !force_loop_choose(rig->loop, layout.kernel)) {
        force_loop_destroy(&rig->loop);
        return false;
    }
    rig->particles = cloud(law, COUNT, edge);
    for (int l = 0; l < 4; l++)
        if (list_layouts[l].threads == layout.threads && list_layouts[l].busy == layout.busy)
            rig->list = lists[l];
    if (law->history_components)
        rig->history = history_create(law->history_components, layout.threads);
    rig->context = (struct force_context){.particles = rig->particles,
                                          .list = &rig->list,
                                          .history = rig->history,
                                          .law = law,
                                          .want_sums = true,
                                          .want_virial = true};
    force_loop_prepare(rig->loop, &rig->context);
    return true;
}

static inline void rig_free(struct rig *rig) {
    force_loop_destroy(&rig->loop);
    if (rig->history)
        history_destroy(&rig->history);
    particles_destroy(&rig->particles);
}

/* Moves the particles on, without forces: contacts come and go. */
static inline void drift(struct particles *p, double dt) {
    for (size_t k = 0; k < p->owned; k++)
        for (int c = 0; c < 3; c++)
            p->state[k].x[c] += dt * p->state[k].v[c];
    memset(p->force, 0, p->owned * (size_t)p->force_stride * sizeof *p->force);
}

/* The first evaluation and two steps. */
static inline void rig_run(struct rig *rig) {
    for (int n = 0; n < 3; n++) {
        rig->context.dt = n == 0 ? 0.0 : 2e-3;
        drift(rig->particles, rig->context.dt);
        force_loop_run(rig->loop, &rig->context, &rig->sums);
    }
}

static inline struct law_vector vector_of(const double a[3]) {
    return (struct law_vector){a[0], a[1], a[2]};
}

static inline void add_vector(double *sum, double sign, struct law_vector a) {
    sum[0] += sign * a.x;
    sum[1] += sign * a.y;
    sum[2] += sign * a.z;
}

#endif
