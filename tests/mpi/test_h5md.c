/* Trajectories: what H5MD demands of the file (looked up with HDF5 itself), the same bytes of data whatever
 * the ranks, numbers of particles that change, going on after a resume, contact lists, observables, and
 * reading back. Ranks: 1 2 4 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "cloud.h"
#include "core/memory.h"
#include "folder.h"
#include "output/h5md.h"
#include "output/h5md_read.h"
#include "particles/fields.h"
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
};

static void fixture_make(struct fixture *f, struct team *team, const struct box *box, unsigned features) {
    *f = (struct fixture){.team = team};
    folder_make(&f->folder, &team->comm);
    folder_file(&f->folder, "trajectory.h5", f->path);
    cloud_make(&f->cloud, box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_create(features, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (k * 7 % 5 % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    for (size_t i = 0; f->particles->group && i < f->particles->owned; i++)
        f->particles->group[i] = 0; /* there is no other */
    for (size_t i = 0; !f->particles->density && i < f->particles->owned; i++)
        if (f->particles->state[i].inverse_mass == 0)
            f->particles->state[i].inverse_mass = 1;
    f->motion = (struct integrator_context){
        .dt = 0.25, .gravity = {0, 0, -2}, .dimension = box->dimension, .groups = 1};
    f->view = (struct output_view){
        .comm = &team->comm, .particles = f->particles, .box = &f->cloud.box, .motion = &f->motion};
    f->run = (struct output_run){.directory = f->folder.path, .scene = "scene: test\n", .seed = 42};
}

static void fixture_free(struct fixture *f) {
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static struct h5md_head head_of(const struct fixture *f, bool varying) {
    return (struct h5md_head){.scene = f->run.scene, .varying = varying, .xdmf = true, .seed = f->run.seed};
}

/* Writes frames at steps first, first + 10, ... below last; each shows the same state at another time. */
static bool write_frames(struct fixture *f, struct h5md *h5md, int first, int last) {
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

static void write_file(struct fixture *f, bool varying, int64_t resume, int first, int last) {
    struct error error = {0};
    struct h5md_head head = head_of(f, varying);
    struct h5md *h5md = NULL;
    if (!team_expect(f->team, h5md_open(&h5md, &f->team->comm, f->path, &head, resume, &error), "%s",
                     error.text))
        return;
    write_frames(f, h5md, first, last);
    team_expect(f->team, h5md_close(&h5md, &error), "%s", error.text);
}

/* Looking into files with HDF5 alone. */

static void expect_size(struct team *team, hid_t file, const char *name, int rank, const hsize_t *expected) {
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
static double *read_all(hid_t file, const char *name) {
    hid_t id = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(id);
    double *data = memory_allocate((size_t)H5Sget_simple_extent_npoints(space), sizeof *data, "test");
    if (H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
        error_fatal("%s cannot be read", name);
    H5Sclose(space);
    H5Dclose(id);
    return data;
}

static void expect_same_object(struct team *team, hid_t file, const char *a, const char *b) {
    H5O_info_t x = {0}, y = {0};
    bool found = H5Oget_info_by_name2(file, a, &x, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
                 H5Oget_info_by_name2(file, b, &y, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
    team_expect(team, found && x.addr == y.addr, "%s and %s are not one object", a, b);
}

static void expect_text(struct team *team, hid_t file, const char *object, const char *name,
                        const char *expected) {
    hid_t id = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    if (!team_expect(team, id >= 0, "%s has no attribute %s", object, name))
        return;
    hid_t type = H5Aget_type(id), space = H5Aget_space(id);
    team_expect(team, H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0,
                "%s.%s: fixed string", object, name);
    team_expect(team, H5Sget_simple_extent_type(space) == H5S_SCALAR, "%s.%s: scalar", object, name);
    char text[256] = "";
    if (H5Tget_size(type) < sizeof text)
        H5Aread(id, type, text);
    if (expected)
        team_expect(team, strcmp(text, expected) == 0, "%s.%s is \"%s\", not \"%s\"", object, name, text,
                    expected);
    H5Sclose(space);
    H5Tclose(type);
    H5Aclose(id);
}

static void expect_head(struct team *team, hid_t file) {
    int version[2] = {0};
    hid_t id = H5Aopen_by_name(file, "/h5md", "version", H5P_DEFAULT, H5P_DEFAULT);
    team_expect(team, id >= 0 && H5Aread(id, H5T_NATIVE_INT, version) >= 0, "version");
    H5Aclose(id);
    team_expect(team, version[0] == 1 && version[1] == 1, "version %d.%d", version[0], version[1]);
    expect_text(team, file, "/h5md/author", "name", NULL);
    expect_text(team, file, "/h5md/creator", "name", "scree");
    expect_text(team, file, "/h5md/creator", "version", NULL);
    expect_text(team, file, "/h5md/modules/units", "system", "SI");
    expect_text(team, file, "/particles/all/position/value", "unit", "m");
    expect_text(team, file, "/particles/all/position/time", "unit", "s");
    expect_text(team, file, "/particles/all/velocity/value", "unit", "m s-1");
    char scene[64] = "";
    hid_t dataset = H5Dopen2(file, "/parameters/scene", H5P_DEFAULT);
    hid_t type = H5Dget_type(dataset);
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, scene);
    team_expect(team, strcmp(scene, "scene: test\n") == 0, "scene text \"%s\"", scene);
    H5Tclose(type);
    H5Dclose(dataset);
}

static void expect_box(struct team *team, hid_t file, const struct box *box) {
    int dimension = 0;
    hid_t id = H5Aopen_by_name(file, "/particles/all/box", "dimension", H5P_DEFAULT, H5P_DEFAULT);
    H5Aread(id, H5T_NATIVE_INT, &dimension);
    H5Aclose(id);
    team_expect(team, dimension == box->dimension, "dimension %d", dimension);
    id = H5Aopen_by_name(file, "/particles/all/box", "boundary", H5P_DEFAULT, H5P_DEFAULT);
    hid_t type = H5Aget_type(id);
    char text[3][16] = {{0}};
    team_expect(team, H5Tget_size(type) == 8, "boundary strings of %zu bytes", H5Tget_size(type));
    char packed[24] = {0};
    H5Aread(id, type, packed);
    for (int d = 0; d < dimension; d++) {
        memcpy(text[d], packed + 8 * d, 8);
        team_expect(team, strcmp(text[d], box->periodic[d] ? "periodic" : "none") == 0, "boundary %d", d);
    }
    H5Tclose(type);
    H5Aclose(id);
    hsize_t size = (hsize_t)dimension;
    expect_size(team, file, "/particles/all/box/edges", 1, &size);
    double *edges = read_all(file, "/particles/all/box/edges");
    for (int d = 0; d < dimension; d++)
        team_expect(team, edges[d] == box->edge[d], "edge %d", d);
    memory_free(edges);
}

static double inverse_mass(const struct fixture *f, int64_t id) {
    double w = cloud_value(id, fields_find("inverse_mass"), 0, STAMP);
    return w == 0 && !f->particles->density ? 1 : w;
}

/* The full-step velocity, by the formula, from the values that the cloud gave. */
static double full_step(const struct fixture *f, int64_t id, int d) {
    double v = cloud_value(id, fields_find("velocity"), d, STAMP);
    double w = inverse_mass(f, id);
    double force = cloud_value(id, fields_find("force"), d, STAMP);
    return v + 0.5 * f->motion.dt * (force * w + f->motion.gravity[d]);
}

/* One frame's values, row by row: row k shows id k + 1. */
static void expect_values(const struct fixture *f, hid_t file, int frame, int dimension) {
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
        double density = cloud_value(k + 1, fields_find("density"), 0, STAMP);
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
            double total = cloud_value(k + 1, fields_find("force"), d, STAMP);
            total += w > 0 && d < dimension ? f->motion.gravity[d] / w : 0;
            team_expect(team, fabs(force[place] - total) < 1e-12, "force of %d", k);
        }
    }
    memory_free(position);
    memory_free(velocity);
    memory_free(force);
    memory_free(id);
    memory_free(radius);
    memory_free(mass);
}

static void file_is_h5md(const struct box *box, struct team *team) {
    struct fixture f;
    fixture_make(&f, team, box, PARTICLE_FEATURES_ALL);
    write_file(&f, false, -1, 0, 30);
    int64_t barrier = 0;
    comm_sum_int(&team->comm, &barrier, 1);
    if (team->comm.rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        expect_head(team, file);
        expect_box(team, file, box);
        hsize_t d = (hsize_t)box->dimension, vector[3] = {3, PARTICLES, d}, spin[3] = {3, PARTICLES, 3};
        hsize_t scalar[1] = {PARTICLES}, frames[1] = {3};
        expect_size(team, file, "/particles/all/position/value", 3, vector);
        expect_size(team, file, "/particles/all/image/value", 3, vector);
        expect_size(team, file, "/particles/all/angular_velocity/value", 3, spin);
        expect_size(team, file, "/particles/all/torque/value", 3, spin);
        expect_size(team, file, "/particles/all/material", 1, scalar);
        expect_size(team, file, "/particles/all/position/step", 1, frames);
        static const char *const others[] = {"velocity", "force", "image", "angular_velocity", "torque"};
        for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
            char name[64];
            snprintf(name, sizeof name, "/particles/all/%s/step", others[k]);
            expect_same_object(team, file, "/particles/all/position/step", name);
            snprintf(name, sizeof name, "/particles/all/%s/time", others[k]);
            expect_same_object(team, file, "/particles/all/position/time", name);
        }
        expect_same_object(team, file, "/particles/all/material", "/particles/all/species");
        double *step = read_all(file, "/particles/all/position/step"),
               *time = read_all(file, "/particles/all/position/time");
        for (int k = 0; k < 3; k++)
            team_expect(team, step[k] == 10 * k && time[k] == 5.0 * k, "moment of frame %d", k);
        memory_free(step);
        memory_free(time);
        for (int k = 0; k < 3; k++)
            expect_values(&f, file, k, box->dimension);
        team_expect(team, H5Lexists(file, "/particles/all/inverse_mass", H5P_DEFAULT) == 0,
                    "inverse_mass is shown");
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void solid_file_is_h5md(void **state) {
    file_is_h5md(&box_3d, *state);
}

static void flat_file_is_h5md(void **state) {
    file_is_h5md(&box_2d, *state);
}

static void only_what_the_scene_has(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    write_file(&f, false, -1, 0, 1);
    if (team->comm.rank == 0) {
        static const char *const absent[] = {"angular_velocity", "torque", "material",
                                             "species",          "image",  "group"};
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        for (size_t k = 0; k < sizeof absent / sizeof absent[0]; k++) {
            char name[64];
            snprintf(name, sizeof name, "/particles/all/%s", absent[k]);
            team_expect(team, H5Lexists(file, name, H5P_DEFAULT) == 0, "%s is there", name);
        }
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void unknown_fields_are_refused(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    struct error error = {0};
    struct output_fields good = {2, {"position", "mass"}}, bad = {1, {"torque"}};
    team_expect(team, frame_check_fields(&good, f.particles, &error), "%s", error.text);
    team_expect(team, !frame_check_fields(&bad, f.particles, &error), "torque is accepted");
    team_expect(team,
                error.kind == ERROR_USER && strstr(error.text, "torque") && strstr(error.text, "velocity"),
                "%s", error.text);
    fixture_free(&f);
    team_finish(team);
}

/* Frames of a run in which every third particle goes, then new ones come. */
static void number_may_change(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    struct h5md_head head = head_of(&f, true);
    struct h5md *h5md = NULL;
    team_expect(team, h5md_open(&h5md, &team->comm, f.path, &head, -1, &error), "%s", error.text);
    write_frames(&f, h5md, 0, 1);
    uint8_t *remove = memory_allocate_zero(f.particles->owned, 1, "test");
    for (size_t i = 0; i < f.particles->owned; i++)
        remove[i] = f.particles->id[i] % 3 == 0;
    particles_remove(f.particles, remove);
    memory_free(remove);
    write_frames(&f, h5md, 10, 11);
    for (int64_t id = PARTICLES + 1; id <= 2 * PARTICLES; id++)
        if (id % team->comm.size == team->comm.rank) {
            size_t i = particles_append(f.particles);
            f.particles->id[i] = id;
            f.particles->state[i].radius = 1;
            f.particles->state[i].inverse_mass = 1;
        }
    write_frames(&f, h5md, 20, 21);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    static const int counts[] = {PARTICLES, PARTICLES - PARTICLES / 3, 2 * PARTICLES - PARTICLES / 3};
    for (int frame = 0; frame < 3; frame++) {
        struct h5md_read_options options = {.frame = frame};
        struct rows rows;
        if (!team_expect(team, h5md_read(f.path, &options, &team->comm, &rows, &error), "%s", error.text))
            continue;
        team_expect(team, rows.total == (uint64_t)counts[frame], "frame %d has %d rows", frame,
                    (int)rows.total);
        for (size_t k = 0; k < rows.count; k++) {
            int64_t id = rows.id[k];
            team_expect(team, id > 0 && (frame == 0 || id > PARTICLES || id % 3 != 0), "id %d", (int)id);
            double radius = id > PARTICLES ? 1 : f.cloud.radius[id - 1];
            team_expect(team, rows.radius[k] == radius, "radius of %d", (int)id);
        }
        rows_free(&rows);
    }
    fixture_free(&f);
    team_finish(team);
}

/* A fixed number of particles that changes nevertheless is refused. */
static void fixed_number_is_kept(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    struct h5md_head head = head_of(&f, false);
    struct h5md *h5md = NULL;
    h5md_open(&h5md, &team->comm, f.path, &head, -1, &error);
    write_frames(&f, h5md, 0, 1);
    f.particles->owned -= team->comm.rank == 0;
    static const struct output_fields all = {0};
    struct frame frame;
    f.view.step = 10;
    frame_create(&frame, &f.view, &all);
    team_expect(team, !h5md_write_frame(h5md, &frame, &error), "the frame is accepted");
    team_expect(team, strstr(error.text, "trajectory.h5") && strstr(error.text, "137"), "%s", error.text);
    frame_free(&frame);
    struct error none = {0};
    h5md_close(&h5md, &none);
    fixture_free(&f);
    team_finish(team);
}

/* Stop at 50, resume from 25: frames 30 and 40 are written a second time. */
static void resume_goes_on(void **state) {
    struct team *team = *state;
    for (int varying = 0; varying < 2; varying++) {
        struct fixture f;
        fixture_make(&f, team, &box_3d, PARTICLE_SPIN);
        write_file(&f, varying, -1, 0, 50);
        write_file(&f, varying, 25, 20, 70);
        uint64_t frames = 0;
        struct error error = {0};
        if (team->comm.rank == 0) {
            team_expect(team, h5md_read_frames(f.path, NULL, &frames, &error), "%s", error.text);
            team_expect(team, frames == 7, "%d frames", (int)frames);
            hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
            double *step = read_all(file, "/particles/all/velocity/step");
            for (uint64_t k = 0; k < frames; k++)
                team_expect(team, step[k] == 10.0 * (double)k, "frame %d is step %g", (int)k, step[k]);
            memory_free(step);
            if (!varying)
                expect_values(&f, file, 6, 3);
            H5Fclose(file);
        }
        fixture_free(&f);
        team_finish(team);
    }
}

static void contacts_are_listed(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    struct h5md_head head = head_of(&f, false);
    struct h5md *h5md = NULL;
    h5md_open(&h5md, &team->comm, f.path, &head, -1, &error);
    int rank = team->comm.rank, size = team->comm.size;
    for (int frame = 0; frame < 2; frame++) {
        struct force_contact contact[3], wall = {.id_i = rank + 1, .id_j = -4, .force = {0, 0, rank}};
        for (int k = 0; k < 3; k++)
            contact[k] = (struct force_contact){
                .id_i = 10 * rank + k, .id_j = 1000, .overlap = k, .force = {rank, frame, k}};
        struct contact_list list = {.step = (uint64_t)frame * 10,
                                    .time = frame,
                                    .particle_count = (size_t)(3 - frame),
                                    .wall_count = 1,
                                    .particle = contact,
                                    .wall = &wall};
        team_expect(team, h5md_write_contacts(h5md, &list, &f.cloud.box, &error), "%s", error.text);
    }
    write_frames(&f, h5md, 0, 1);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    if (rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        hsize_t pairs[3] = {2, (hsize_t)(3 * size), 2};
        expect_size(team, file, "/connectivity/contacts/value", 3, pairs);
        expect_same_object(team, file, "/connectivity/contacts/step", "/observables/contact_list/force/step");
        expect_same_object(team, file, "/connectivity/contacts/time", "/connectivity/wall_contacts/time");
        double *ids = read_all(file, "/connectivity/contacts/value");
        double *force = read_all(file, "/observables/contact_list/force/value");
        double *wall = read_all(file, "/observables/wall_contact_list/wall/value");
        double *count = read_all(file, "/observables/contact_list/count/value");
        team_expect(team, count[0] == 3 * size && count[1] == 2 * size, "counts %g %g", count[0], count[1]);
        for (int frame = 0; frame < 2; frame++)
            for (int row = 0; row < 3 * size; row++) {
                int each = 3 - frame, owner = row / each, k = row % each, place = frame * 3 * size + row;
                bool there = row < each * size;
                team_expect(team, ids[2 * place] == (there ? 10 * owner + k : -1), "id in row %d", row);
                if (there)
                    team_expect(team, force[3 * place] == owner && force[3 * place + 1] == frame,
                                "force in row %d", row);
            }
        team_expect(team, wall[0] == 3, "wall %g", wall[0]);
        hid_t id =
            H5Aopen_by_name(file, "/connectivity/contacts", "particles_group", H5P_DEFAULT, H5P_DEFAULT);
        hobj_ref_t reference;
        char name[64] = "";
        team_expect(team, id >= 0 && H5Aread(id, H5T_STD_REF_OBJ, &reference) >= 0, "particles_group");
        H5Rget_name(file, H5R_OBJECT, &reference, name, sizeof name);
        team_expect(team, strcmp(name, "/particles/all") == 0, "refers to %s", name);
        H5Aclose(id);
        memory_free(ids);
        memory_free(force);
        memory_free(wall);
        memory_free(count);
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void observables_come_along(void **state) {
    static const char *const names[] = {"energy_kinetic", "ball_vz"}, *const units[] = {"J", "m/s"};
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    for (int part = 0; part < 2; part++) {
        struct h5md_head head = head_of(&f, false);
        struct h5md *h5md = NULL;
        h5md_open(&h5md, &team->comm, f.path, &head, part ? 20 : -1, &error);
        write_frames(&f, h5md, 0, 1);
        /* after the resume from step 20 the row of step 20 comes a second time */
        for (int step = part ? 20 : 0; step < 31 + 10 * part; step += 5) {
            double value[2] = {step, -step};
            struct h5md_observables row = {2, names, units, value, (uint64_t)step, 0.5 * step};
            h5md_add_observables(h5md, &row);
        }
        team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    }
    if (team->comm.rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        hsize_t rows = 9;
        expect_size(team, file, "/observables/ball_vz/value", 1, &rows);
        expect_text(team, file, "/observables/ball_vz/value", "unit", "m s-1");
        expect_same_object(team, file, "/observables/ball_vz/step", "/observables/energy_kinetic/step");
        double *value = read_all(file, "/observables/ball_vz/value");
        for (int k = 0; k < 9; k++)
            team_expect(team, value[k] == -5 * k, "row %d is %g", k, value[k]);
        memory_free(value);
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void xdmf_names_what_is_there(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    write_file(&f, false, -1, 0, 30);
    if (team->comm.rank == 0) {
        char path[FOLDER_MAX + 64], text[16384] = "";
        FILE *file = fopen(folder_file(&f.folder, "trajectory.xdmf", path), "r");
        team_expect(team, file != NULL, "%s is missing", path);
        size_t length = file ? fread(text, 1, sizeof text - 1, file) : 0;
        team_expect(team, length > 0 && length < sizeof text - 1, "%zu bytes", length);
        if (file)
            fclose(file);
        team_expect(team, strstr(text, "trajectory.h5:/particles/all/position/value") != NULL, "no position");
        team_expect(team, strstr(text, "trajectory.h5:/particles/all/radius<") != NULL, "no radius");
        team_expect(team, strstr(text, "<Time Value=\"10\"/>") != NULL, "no time of frame 2");
        team_expect(team, strstr(text, ">2 0 0 1 1 1 1 137 3<") != NULL, "no slab of frame 2");
        team_expect(team, strcmp(text + length - 8, "</Xdmf>\n") == 0, "the end is missing");
    }
    fixture_free(&f);
    team_finish(team);
}

/* Reading back by slices, any frame, with what a reader may get wrong. */
static void reads_back(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, PARTICLE_SPIN | PARTICLE_IMAGE | PARTICLE_MATERIAL);
    write_file(&f, false, -1, 0, 30);
    struct h5md_read_options options = {.frame = -2};
    struct rows rows;
    if (team_expect(team, h5md_read(f.path, &options, &team->comm, &rows, &error), "%s", error.text)) {
        int64_t total = (int64_t)rows.count;
        comm_sum_int(&team->comm, &total, 1);
        team_expect(team, total == PARTICLES && rows.total == PARTICLES, "%d rows", (int)total);
        team_expect(team, rows.step == 10 && rows.time == 5, "step %d", (int)rows.step);
        team_expect(team, rows_columns(&rows) == ROWS_ALL, "columns %x", rows_columns(&rows));
        for (size_t k = 0; k < rows.count; k++) {
            int64_t id = rows.id[k];
            team_expect(team, id == (int64_t)(rows.first + k) + 1, "id %d", (int)id);
            for (int d = 0; d < 3; d++) {
                team_expect(team, rows.position[k][d] == f.cloud.x[id - 1][d] + box_3d.origin[d], "position");
                team_expect(team, rows.image[k][d] == cloud_value(id, fields_find("image"), d, STAMP),
                            "image");
            }
            team_expect(team, rows.material[k] == cloud_value(id, fields_find("material"), 0, STAMP),
                        "material");
        }
        for (int d = 0; d < 3; d++)
            team_expect(team,
                        rows.lower[d] == box_3d.origin[d] && rows.periodic[d] == box_3d.periodic[d] &&
                            rows.upper[d] == box_3d.origin[d] + box_3d.edge[d],
                        "box %d", d);
        rows_free(&rows);
    }
    options.frame = 3;
    team_expect(team, !h5md_read(f.path, &options, &team->comm, &rows, &error), "frame 3 is there");
    team_expect(team, strstr(error.text, "trajectory.h5") && strstr(error.text, "3 frames"), "%s",
                error.text);
    error = (struct error){0};
    options = (struct h5md_read_options){.group = "none"};
    team_expect(team, !h5md_read(f.path, &options, &team->comm, &rows, &error), "group none is there");
    team_expect(team, strstr(error.text, "it has: all") != NULL, "%s", error.text);
    fixture_free(&f);
    team_finish(team);
}

/* Makes a dataset of doubles in a file of somebody else. */
static void foreign_dataset(hid_t file, const char *name, int rank, const hsize_t *size, hid_t type,
                            const void *data) {
    hid_t links = H5Pcreate(H5P_LINK_CREATE), space = H5Screate_simple(rank, size, NULL);
    H5Pset_create_intermediate_group(links, 1);
    hid_t id = H5Dcreate2(file, name, type, space, links, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
    H5Dclose(id);
    H5Sclose(space);
    H5Pclose(links);
}

static void reads_foreign_files(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    static const float position[4][2] = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
    static const double radius[4] = {1, 2, 3, 4}, short_mass[3] = {1, 1, 1}, spin[4] = {9, 8, 7, 6};
    static const short species[4] = {0, 1, 2, 0};
    for (int wrong = 0; wrong < 3; wrong++) {
        if (team->comm.rank == 0) {
            hid_t file = H5Fcreate(f.path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
            hsize_t flat[2] = {4, 2}, four[1] = {4}, three[1] = {3};
            if (wrong != 2)
                foreign_dataset(file, "/particles/grains/position", 2, flat, H5T_NATIVE_FLOAT, position);
            foreign_dataset(file, "/particles/grains/radius", 1, four, H5T_NATIVE_DOUBLE, radius);
            foreign_dataset(file, "/particles/grains/species", 1, four, H5T_NATIVE_SHORT, species);
            foreign_dataset(file, "/particles/grains/angular_velocity", 1, four, H5T_NATIVE_DOUBLE, spin);
            if (wrong == 1)
                foreign_dataset(file, "/particles/grains/mass", 1, three, H5T_NATIVE_DOUBLE, short_mass);
            H5Fclose(file);
        }
        int64_t barrier = 0;
        comm_sum_int(&team->comm, &barrier, 1);
        struct h5md_read_options options = {.frame = -1};
        struct rows rows;
        error = (struct error){0};
        bool good = h5md_read(f.path, &options, &team->comm, &rows, &error);
        team_expect(team, good == (wrong == 0), "case %d: %s", wrong, error.text);
        static const char *const expected[] = {"", "/particles/grains/mass", "/particles/grains/position"};
        team_expect(team, strstr(error.text, expected[wrong]) != NULL, "case %d: %s", wrong, error.text);
        for (size_t k = 0; good && k < rows.count; k++) {
            size_t row = rows.first + k;
            team_expect(team, rows.dimension == 2 && rows.position[k][1] == position[row][1],
                        "position of %zu", row);
            team_expect(team, rows.position[k][2] == 0 && rows.angular_velocity[k][2] == spin[row],
                        "spin of %zu", row);
            team_expect(team, rows.material[k] == species[row] && !rows.velocity, "species of %zu", row);
        }
        rows_free(&rows);
    }
    fixture_free(&f);
    team_finish(team);
}

/* What a killed run, a wrong file or no file looks like. */
static void broken_files_are_refused(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    struct rows rows;
    struct h5md_read_options options = {.frame = -1};
    struct error error = {0};
    team_expect(team, !h5md_read(f.path, &options, &team->comm, &rows, &error), "a missing file is read");
    team_expect(team, error.kind == ERROR_USER && strstr(error.text, f.path), "%s", error.text);
    if (team->comm.rank == 0) {
        FILE *file = fopen(f.path, "w");
        fprintf(file, "this is not HDF5\n");
        fclose(file);
    }
    error = (struct error){0};
    int64_t barrier = 0;
    comm_sum_int(&team->comm, &barrier, 1);
    team_expect(team, !h5md_read(f.path, &options, &team->comm, &rows, &error), "a text file is read");
    team_expect(team, error.kind == ERROR_USER && strstr(error.text, "HDF5"), "%s", error.text);
    fixture_free(&f);
    team_finish(team);
}

int main(int argc, char **argv) {
    struct team team;
    team_start(&team, &argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(solid_file_is_h5md, &team),
        cmocka_unit_test_prestate(flat_file_is_h5md, &team),
        cmocka_unit_test_prestate(only_what_the_scene_has, &team),
        cmocka_unit_test_prestate(unknown_fields_are_refused, &team),
        cmocka_unit_test_prestate(number_may_change, &team),
        cmocka_unit_test_prestate(fixed_number_is_kept, &team),
        cmocka_unit_test_prestate(resume_goes_on, &team),
        cmocka_unit_test_prestate(contacts_are_listed, &team),
        cmocka_unit_test_prestate(observables_come_along, &team),
        cmocka_unit_test_prestate(xdmf_names_what_is_there, &team),
        cmocka_unit_test_prestate(reads_back, &team),
        cmocka_unit_test_prestate(reads_foreign_files, &team),
        cmocka_unit_test_prestate(broken_files_are_refused, &team),
    };
    int failed = cmocka_run_group_tests_name("h5md", tests, NULL, NULL);
    return team_stop(&team) || failed;
}
