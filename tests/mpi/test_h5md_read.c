/* SPDX-License-Identifier: BSD-3-Clause */
/* Trajectories read back: those of scree, those of other programs, and broken files. Ranks: 1 2 4 */
#include "tests/test.h"

#include "trajectory.h"

/* Reading back by slices, any frame, with wrong requests of a reader. */
static void reads_back(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, WITH_SPIN | WITH_IMAGE | WITH_MATERIAL);
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
                team_expect(team, rows.image[k][d] == cloud_value(id, cloud_code("image"), d, STAMP),
                            "image");
            }
            team_expect(team, rows.material[k] == cloud_value(id, cloud_code("material"), 0, STAMP),
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

/* Makes a dataset of doubles in a file of another program. */
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

/* The files of a killed run, a wrong file, and no file. */
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

TEAM_MAIN(h5md_read, team_case(reads_back), team_case(reads_foreign_files),
          team_case(broken_files_are_refused))
