/* SPDX-License-Identifier: BSD-3-Clause */
/* A trajectory for tests, and functions that read files with HDF5 alone. Include after cmocka.h. */
#ifndef SCREE_TESTS_MPI_TRAJECTORY_H
#define SCREE_TESTS_MPI_TRAJECTORY_H

#include "cloud.h"
#include "base/memory.h"
#include "folder.h"
#include "data/formats/h5md.h"
#include "data/formats/h5md_read.h"
#include "kernel/particles/fields.h"
#include "team.h"

#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTICLES = 137, STAMP = 5 };

static const struct box box_3d = {
    .dimension = 3, .origin = {-5, 100, 0.5}, .edge = {10, 11, 12}, .periodic = {true, false, true}};
static const struct box box_2d = {
    .dimension = 2, .origin = {1, 2, 3}, .edge = {10, 11, 1}, .periodic = {true}};

struct fixture {
    struct team *team;
    struct folder folder;
    char path[FOLDER_MAX + 64];
    struct cloud cloud;
    struct particles *particles;
    struct integrator_context motion;
    struct output_view view;
    struct output_run run;
    struct lineage lineage;
};

static inline void fixture_make(struct fixture *f, struct team *team, const struct box *box,
                                unsigned features) {
    *f = (struct fixture){.team = team};
    folder_make(&f->folder, &team->comm);
    folder_file(&f->folder, "trajectory.h5", f->path);
    cloud_make(&f->cloud, box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_with(features, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (k * 7 % 5 % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    for (size_t i = 0; groups_of(f->particles) && i < f->particles->owned; i++)
        groups_of(f->particles)[i] = 0; /* there is no other group */
    for (size_t i = 0; !groups_densities(f->particles) && i < f->particles->owned; i++)
        if (f->particles->state[i].inverse_mass == 0)
            f->particles->state[i].inverse_mass = 1;
    f->motion = (struct integrator_context){
        .dt = 0.25, .gravity = {0, 0, -2}, .dimension = box->dimension, .groups = 1};
    f->view = (struct output_view){
        .comm = &team->comm, .particles = f->particles, .box = &f->cloud.box, .motion = &f->motion};
    f->run = (struct output_run){.directory = f->folder.path, .lineage = &f->lineage, .seed = 42};
    lineage_add(&f->lineage, 0, "0.1", "abc", "scene: test\n");
}

static inline void fixture_free(struct fixture *f) {
    lineage_free(&f->lineage);
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static inline struct h5md_head head_of(const struct fixture *f, bool varying) {
    return (struct h5md_head){
        .lineage = f->run.lineage, .varying = varying, .xdmf = true, .seed = f->run.seed};
}

/* Writes frames at steps first, first + 10, ... below last; each shows the same state at another time. */
static inline bool write_frames(struct fixture *f, struct h5md *h5md, int first, int last) {
    static const struct output_fields all = {0};
    struct error error = {0};
    for (int step = first; step < last; step += 10) {
        f->view.step = (uint64_t)step;
        f->view.time = 0.5 * step;
        struct frame frame;
        frame_create(&frame, &f->view, &all);
        h5md_write_frame(h5md, &frame, &error);
        frame_free(&frame);
    }
    return team_expect(f->team, error.kind == ERROR_NONE, "%s", error.text);
}

static inline void write_file(struct fixture *f, bool varying, int64_t resume, int first, int last) {
    struct error error = {0};
    struct h5md_head head = head_of(f, varying);
    struct h5md *h5md = NULL;
    if (!team_expect(f->team, h5md_open(&h5md, &f->team->comm, f->path, &head, resume, &error), "%s",
                     error.text))
        return;
    write_frames(f, h5md, first, last);
    team_expect(f->team, h5md_close(&h5md, &error), "%s", error.text);
}

/* Functions that read files with HDF5 alone. */

static inline void expect_size(struct team *team, hid_t file, const char *name, int rank,
                               const hsize_t *expected) {
    hid_t id = H5Dopen2(file, name, H5P_DEFAULT);
    if (!team_expect(team, id >= 0, "%s is missing", name))
        return;
    hid_t space = H5Dget_space(id);
    hsize_t size[4] = {0};
    team_expect(team, H5Sget_simple_extent_ndims(space) == rank, "rank of %s", name);
    H5Sget_simple_extent_dims(space, size, NULL);
    for (int d = 0; d < rank; d++)
        team_expect(team, size[d] == expected[d], "%s: dimension %d is %llu, not %llu", name, d,
                    (unsigned long long)size[d], (unsigned long long)expected[d]);
    H5Sclose(space);
    H5Dclose(id);
}

/* Reads a whole dataset as doubles; memory_free. */
static inline double *read_all(hid_t file, const char *name) {
    hid_t id = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(id);
    double *data = memory_allocate((size_t)H5Sget_simple_extent_npoints(space), sizeof *data, "test");
    if (H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
        error_fatal("%s cannot be read", name);
    H5Sclose(space);
    H5Dclose(id);
    return data;
}

static inline void expect_same_object(struct team *team, hid_t file, const char *a, const char *b) {
    H5O_info_t x = {0}, y = {0};
    bool found = H5Oget_info_by_name2(file, a, &x, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
                 H5Oget_info_by_name2(file, b, &y, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
    team_expect(team, found && x.addr == y.addr, "%s and %s are not one object", a, b);
}

static inline void expect_text(struct team *team, hid_t file, const char *object, const char *name,
                               const char *expected) {
    hid_t id = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    if (!team_expect(team, id >= 0, "%s has no attribute %s", object, name))
        return;
    hid_t type = H5Aget_type(id), space = H5Aget_space(id);
    bool free_text = strcmp(name, "unit") == 0; /* h5py and MDAnalysis read these as text */
    team_expect(team, H5Tget_class(type) == H5T_STRING && (H5Tis_variable_str(type) > 0) == free_text,
                "%s.%s: kind of string", object, name);
    team_expect(team, H5Sget_simple_extent_type(space) == H5S_SCALAR, "%s.%s: scalar", object, name);
    char text[256] = "";
    char *read = NULL;
    if (free_text && H5Aread(id, type, &read) >= 0 && read) {
        snprintf(text, sizeof text, "%s", read);
        H5free_memory(read);
    } else if (!free_text && H5Tget_size(type) < sizeof text)
        H5Aread(id, type, text);
    if (expected)
        team_expect(team, strcmp(text, expected) == 0, "%s.%s is \"%s\", not \"%s\"", object, name, text,
                    expected);
    H5Sclose(space);
    H5Tclose(type);
    H5Aclose(id);
}

static inline double inverse_mass(const struct fixture *f, int64_t id) {
    double w = cloud_value(id, cloud_code("inverse_mass"), 0, STAMP);
    return w == 0 && !groups_densities(f->particles) ? 1 : w;
}

/* The full-step velocity, by the formula, from the values that the cloud gave. */
static inline double full_step(const struct fixture *f, int64_t id, int d) {
    double v = cloud_value(id, cloud_code("velocity"), d, STAMP);
    double w = inverse_mass(f, id);
    double force = cloud_value(id, cloud_code("force"), d, STAMP);
    return v + 0.5 * f->motion.dt * (force * w + f->motion.gravity[d]);
}

/* One frame's values, row by row: row k shows id k + 1. */
static inline void expect_values(const struct fixture *f, hid_t file, int frame, int dimension) {
    struct team *team = f->team;
    double *position = read_all(file, "/particles/all/position/value");
    double *velocity = read_all(file, "/particles/all/velocity/value");
    double *force = read_all(file, "/particles/all/force/value");
    double *id = read_all(file, "/particles/all/id"), *radius = read_all(file, "/particles/all/radius");
    double *mass = read_all(file, "/particles/all/mass");
    for (int k = 0; k < PARTICLES; k++) {
        team_expect(team, id[k] == k + 1, "row %d holds id %g", k, id[k]);
        team_expect(team, radius[k] == f->cloud.radius[k], "radius of %d", k);
        double w = inverse_mass(f, k + 1);
        double density = cloud_value(k + 1, cloud_code("density"), 0, STAMP);
        if (w > 0)
            team_expect(team, fabs(mass[k] - 1 / w) <= 1e-15 / w, "mass of %d", k);
        else
            team_expect(team, fabs(mass[k] - particles_sphere_mass(radius[k], density)) <= 1e-12 * mass[k],
                        "mass of held %d", k);
        for (int d = 0; d < dimension; d++) {
            int place = (frame * PARTICLES + k) * dimension + d;
            double x = f->cloud.x[k][d] + f->cloud.box.origin[d];
            team_expect(team, position[place] == x, "position of %d", k);
            team_expect(team, fabs(velocity[place] - full_step(f, k + 1, d)) < 1e-9, "velocity of %d", k);
            double touched = cloud_value(k + 1, cloud_code("force"), d, STAMP); /* without gravity */
            team_expect(team, force[place] == touched, "force of %d", k);
        }
    }
    memory_free(position);
    memory_free(velocity);
    memory_free(force);
    memory_free(id);
    memory_free(radius);
    memory_free(mass);
}

#endif
