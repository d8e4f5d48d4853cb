/* SPDX-License-Identifier: BSD-3-Clause */
/* A cloud to observe, and the observables of the cloud: shared by the tests of observables. */
#ifndef SCREE_TESTS_MPI_OBSERVED_H
#define SCREE_TESTS_MPI_OBSERVED_H

#include "cloud.h"
#include "base/memory.h"
#include "folder.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/fields.h"
#include "team.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTICLES = 123, STAMP = 5 };

static const struct box box = {
    .dimension = 3, .origin = {-5, 100, 0.5}, .edge = {10, 11, 12}, .periodic = {true, false, true}};

struct fixture {
    struct team *team;
    struct folder folder;
    struct cloud cloud;
    struct particles *particles;
    struct integrator_context motion;
    struct force_sums sums;
    struct law_material material[2];
    struct output_view view;
    struct output_run run;
    struct observables_options options;
};

static inline double value_of(int64_t id, const char *field, int component) {
    return cloud_value(id, cloud_code(field), component, STAMP);
}

/* Particle 7 is held: its inverse mass is 0. */
static inline double inverse_mass(int64_t id) {
    return id == 7 ? 0 : 1 / (1 + value_of(id, "inverse_mass", 0));
}

/* How often a particle has crossed the box in direction d. */
static inline int32_t image_of(int64_t id, int d) {
    return box.periodic[d] ? (int32_t)((id >> d) % 3) - 1 : 0;
}

static inline void fixture_make(struct fixture *f, struct team *team) {
    *f = (struct fixture){.team = team};
    folder_make(&f->folder, &team->comm);
    cloud_make(&f->cloud, &box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_with(WITH_ALL, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (k * 7 % 5 % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    struct particles *p = f->particles;
    for (size_t i = 0; i < p->owned; i++) {
        groups_of(p)[i] = 0;
        material_numbers(p)[i] = p->id[i] % 2;
        groups_densities(p)[i] = 3;
        p->state[i].inverse_mass = inverse_mass(p->id[i]);
        for (int d = 0; d < 3; d++)
            particles_images(p)[i][d] = image_of(p->id[i], d);
    }
    f->motion = (struct integrator_context){
        .dt = 0.25, .gravity = {0, 0.5, -2}, .dimension = box.dimension, .groups = 1};
    f->sums = (struct force_sums){.elastic_normal = 1 + team->comm.rank,
                                  .elastic_tangential = 10,
                                  .virial = {1, 2, 3, 4, 5, 6},
                                  .overlap_max = 0.01 * (1 + team->comm.rank),
                                  .contact_sides = 14,
                                  .contacts = 7};
    snprintf(f->material[0].name, sizeof f->material[0].name, "glass");
    snprintf(f->material[1].name, sizeof f->material[1].name, "steel");
    f->view = (struct output_view){.comm = &team->comm,
                                   .particles = p,
                                   .box = &f->cloud.box,
                                   .motion = &f->motion,
                                   .sums = &f->sums,
                                   .taken = 100,
                                   .step = 0};
    f->run = (struct output_run){.directory = f->folder.path, .materials = 2, .material = f->material};
}

static inline void fixture_free(struct fixture *f) {
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static inline void ask(struct fixture *f, struct observable_request request) {
    f->options.request[f->options.count++] = request;
}

static inline struct observables *create(struct fixture *f) {
    struct observables *o = NULL;
    struct error error = {0};
    bool good = observables_create(&o, &f->options, &f->view, &f->run, &error);
    team_expect(f->team, good, "%s", error.text);
    return o;
}

/* The value of a column of the last row. */
static inline double column(struct fixture *f, const struct observables *o, const char *name) {
    for (int c = 0; c < observables_columns(o); c++)
        if (strcmp(observables_column_name(o, c), name) == 0)
            return observables_values(o)[c];
    team_expect(f->team, false, "there is no column %s", name);
    return NAN;
}

static inline void expect_near(struct fixture *f, const struct observables *o, const char *name,
                               double expected) {
    double value = column(f, o, name), scale = fabs(expected) > 1 ? fabs(expected) : 1;
    team_expect(f->team, fabs(value - expected) <= 1e-12 * scale, "%s is %.17g, not %.17g", name, value,
                expected);
}

static inline void write_row(struct fixture *f, struct observables *o) {
    struct error error = {0};
    team_expect(f->team, observables_write(o, &f->view, &error), "%s", error.text);
}

/* Full-step velocity and angular velocity of a free particle by their formulas. */
static inline void full_step(const struct fixture *f, int64_t id, double v[3], double w[3]) {
    double r = f->cloud.radius[id - 1];
    for (int d = 0; d < 3; d++) {
        v[d] = value_of(id, "velocity", d) +
               0.5 * f->motion.dt * (value_of(id, "force", d) * inverse_mass(id) + f->motion.gravity[d]);
        w[d] = value_of(id, "angular_velocity", d) +
               0.5 * f->motion.dt * value_of(id, "torque", d) * 2.5 * inverse_mass(id) / (r * r);
    }
}

#endif
