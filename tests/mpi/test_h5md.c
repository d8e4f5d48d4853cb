/* SPDX-License-Identifier: BSD-3-Clause */
/* Trajectories: the elements that H5MD demands (read with HDF5 itself), and the same bytes of data for every
 * number of ranks. Ranks: 1 2 4 */
#include "tests/test.h"

#include "trajectory.h"

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
    hsize_t size[3] = {3, (hsize_t)dimension, (hsize_t)dimension};
    expect_size(team, file, "/particles/all/box/edges/value", 3, size);
    expect_same_object(team, file, "/particles/all/position/step", "/particles/all/box/edges/step");
    double *edges = read_all(file, "/particles/all/box/edges/value");
    for (int k = 0; k < 3 * dimension * dimension; k++) {
        int i = k / dimension % dimension, j = k % dimension;
        team_expect(team, edges[k] == (i == j ? box->edge[i] : 0), "edge %d", k);
    }
    memory_free(edges);
}

static void file_is_h5md(const struct box *box, struct team *team) {
    struct fixture f;
    fixture_make(&f, team, box, WITH_ALL);
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

TEAM_MAIN(h5md, team_case(solid_file_is_h5md), team_case(flat_file_is_h5md),
          team_case(only_what_the_scene_has), team_case(unknown_fields_are_refused))
