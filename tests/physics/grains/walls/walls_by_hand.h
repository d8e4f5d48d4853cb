/* SPDX-License-Identifier: BSD-3-Clause */
/* A world of spheres and walls without an index, for tests of walls: spheres do not meet each other. Include
 * after cmocka.h and near.h. */
#ifndef SCREE_TESTS_WALLS_BY_HAND_H
#define SCREE_TESTS_WALLS_BY_HAND_H

#include "physics/grains/walls/wall.h"
#include "base/memory.h"
#include "physics/grains/motion/integrator.h"
#include "tests/fields_by_hand.h"
#include "kernel/pairs/classes_choose.h"
#include "tests/own_law.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct world {
    struct box box;
    struct law law;
    struct particles *particles;
    struct size_classes classes;
    struct walls *walls;
    struct force_context context;
    struct integrator_context motion;
    struct force_sums sums;
    int threads;
    double time;
};

static inline void must(bool good, const struct error *error) {
    if (!good)
        print_error("%s\n", error->text);
    assert_true(good);
}

/* A name for a file of this test program; `text` is written to it. */
static inline const char *hand_file(char path[64], const char *name, const char *text, size_t size) {
    snprintf(path, 64, "walls-%ld-%s", (long)getpid(), name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, size, file), size);
    fclose(file);
    return path;
}

static inline struct box hand_box(double edge) {
    return (struct box){.dimension = 3, .edge = {edge, edge, edge}};
}

/* One material; hooke with k = 1e4, k_t = 2/7 k, or hertz with E = 1e7. */
static inline struct law hand_law_end(enum law_normal normal, double restitution, double friction,
                                      enum law_end end) {
    struct law law;
    struct error error = {0};
    struct law_options options = law_options_default();
    struct law_material material = {.name = "m", .density = 1000, .young = 1e7, .poisson = 0.25};
    static struct law_pair pair[2][2];
    pair[0][0] =
        (struct law_pair){.restitution = restitution, .friction = friction, .k_n = 1e4, .k_t = 2e4 / 7.0};
    options.normal = normal;
    options.tangential = friction > 0.0 ? LAW_TANGENTIAL_HISTORY : LAW_FRICTIONLESS;
    options.synchronised = true;
    options.end = end;
    must(law_prepare(&law, &options, 1, &material, pair[0], &error), &error);
    return law;
}

static inline struct law hand_law(enum law_normal normal, double restitution, double friction) {
    return hand_law_end(normal, restitution, friction, LAW_END_OVERLAP);
}

static inline struct wall_options hand_plane(double x, double y, double z, double nx, double ny, double nz) {
    return (struct wall_options){
        .name = "plane", .shape = WALL_PLANE, .point = {x, y, z}, .normal = {nx, ny, nz}};
}

static inline struct wall_options hand_mesh(const char *path) {
    struct wall_options o = {.name = "mesh", .shape = WALL_MESH, .scale = 1.0};
    snprintf(o.file, sizeof o.file, "%s", path);
    return o;
}

/* Opens a world; particles are added by world_add, then world_build. */
static inline void world_open(struct world *w, struct box box, struct law law,
                              const struct wall_options *options, int walls, int threads) {
    struct error error = {0};
    omp_set_num_threads(threads);
    *w = (struct world){.box = box, .law = law, .threads = threads};
    w->particles = particles_with(law.spin ? WITH_SPIN : 0, 0);
    w->motion = (struct integrator_context){.dt = 1e-4, .dimension = box.dimension, .groups = 1};
    must(walls_create(&w->walls, options, walls, &w->law, &box, threads, &error, NULL), &error);
}

static inline void world_close(struct world *w) {
    walls_destroy(&w->walls);
    particles_destroy(&w->particles);
    law_free(&w->law);
}

/* Adds a sphere of mass `mass`; returns its state. */
static inline struct particle_state *world_add(struct world *w, double x, double y, double z, double radius,
                                               double mass) {
    size_t i = particles_append(w->particles);
    w->particles->id[i] = (int64_t)i + 1;
    w->particles->state[i] =
        (struct particle_state){.x = {x, y, z}, .radius = radius, .inverse_mass = 1.0 / mass};
    return &w->particles->state[i];
}

/* Candidates again; histories go along. `order` (NULL: as they are) reorders the particles. */
static inline void world_rebuild(struct world *w, const uint32_t *order) {
    struct history_rows rows;
    size_t owned = w->particles->owned;
    double *radius = memory_allocate(owned, sizeof *radius, "radii");
    struct classes_options options = classes_options_default();
    struct error error = {0};
    for (size_t i = 0; i < owned; i++)
        radius[i] = w->particles->state[i].radius;
    must(classes_choose(&w->classes, &options, NULL, radius, owned, &error), &error);
    memory_free(radius);
    walls_detach(w->walls, w->particles, &rows);
    particles_wrap(w->particles, &w->box);
    particles_classify(w->particles, &w->classes);
    if (order) {
        particles_reorder(w->particles, order);
        history_rows_reorder(&rows, order, owned);
    }
    walls_build(w->walls, w->particles, &w->classes);
    walls_attach(w->walls, &rows, w->particles);
    history_rows_free(&rows);
}

/* Forces at the present positions (zeroed before); histories advance by dt. */
static inline void world_forces(struct world *w, double dt) {
    struct particles *p = w->particles;
    size_t n = p->owned, stride = (size_t)p->force_stride;
    w->context = (struct force_context){
        .particles = p, .law = &w->law, .dt = dt, .want_sums = true, .want_virial = true};
    if (n > 0)
        memset(p->force, 0, n * stride * sizeof *p->force);
    for (int t = w->threads - 1; t >= 0; t--) /* in any order */
        walls_force_share(w->walls, &w->context, t);
    w->sums = (struct force_sums){0};
    walls_finish(w->walls, &w->context, &w->sums);
}

/* First rebuild and forces, and velocities half a step back, as a run starts. */
static inline void world_build(struct world *w) {
    world_rebuild(w, NULL);
    world_forces(w, 0.0);
    integrator_stagger(w->particles, &w->motion, 0, w->particles->owned);
}

/* One step: as the program does it. */
static inline void world_step(struct world *w, bool rebuild, const struct wall_push *push) {
    integrator_advance(w->particles, &w->motion, 0, w->particles->owned);
    if (walls_move(w->walls))
        walls_advance(w->walls, w->time, w->motion.dt, push);
    w->time += w->motion.dt;
    if (rebuild)
        world_rebuild(w, NULL);
    world_forces(w, w->motion.dt);
}

static inline const double *world_force(const struct world *w, size_t i) {
    return w->particles->force + i * (size_t)w->particles->force_stride;
}

static inline double hand_length(const double a[3]) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* A number in [0, 1). */
static inline double hand_random(unsigned *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 16777216.0;
}

#endif
