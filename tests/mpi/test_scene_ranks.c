/* SPDX-License-Identifier: BSD-3-Clause */
/* Particle sources on many ranks. Ranks: 1 2 3 5 */
#include "kernel/comm/domain.h"
#include "data/formats/convert.h"
#include "tests/fields_by_hand.h"
#include "tests/mpi/folder.h"
#include "tests/scene_by_hand.h"

static struct comm comm;

#define RANKS_SCENE                                                                                          \
    "units: none\n"                                                                                          \
    "box: {lower: [0, 0, 0], upper: [20, 20, 20], periodic: true}\n"                                         \
    "step: {count: 1}\n"                                                                                     \
    "contact: {law: hooke}\n"                                                                                \
    "materials: [{name: a, density: 1}, {name: b, density: 2}]\n"                                            \
    "material_pairs: [{restitution: 1, k_n: 1}]\n"

struct whose {
    const struct domain *domain;
    int rank;
};

static bool is_mine(void *context, const double x[3]) {
    const struct whose *whose = context;
    return domain_owner(whose->domain, x) == whose->rank;
}

/* Every particle arrives on the rank that owns its place, exactly once. */
static void owners_get_theirs(void **state) {
    (void)state;
    struct scene *scene = good_scene(
        RANKS_SCENE "particles: {from: random, sizes: {law: uniform, min: 0.3, max: 1}, material: b,"
                    " volume_fraction: 0.2}\n",
        NULL);
    struct error error = {0};
    struct domain *domain = domain_create(&comm, &scene->box, &scene->domain, &error);
    assert_non_null(domain);
    struct whose whose = {domain, comm.rank};
    struct scene_share share = {.rank = comm.rank, .size = comm.size, .mine = is_mine, .context = &whose};
    struct particles *particles = particles_with(WITH_ALL, 0);
    struct scene_census census;
    assert_true(scene_particles(scene, &share, particles, &census, &error));
    int64_t sums[2] = {(int64_t)particles->owned, 0};
    for (size_t i = 0; i < particles->owned; i++) {
        assert_int_equal(domain_owner(domain, particles->state[i].x), comm.rank);
        sums[1] += particles->id[i];
    }
    comm_sum_int(&comm, sums, 2);
    int64_t n = (int64_t)census.particles;
    assert_int_equal(sums[0], n);
    assert_int_equal(sums[1], n * (n + 1) / 2);
    assert_true(n > 300);
    particles_destroy(&particles);
    domain_destroy(&domain);
    scene_free(&scene);
}

/* The rank that is responsible for an id finds an id that occurs twice, and all ranks agree on the error. */
static void doubles_are_found(void **state) {
    (void)state;
    struct folder folder;
    folder_make(&folder, &comm);
    char path[FOLDER_MAX + 64], text[1024];
    folder_file(&folder, "rows.txt", path);
    snprintf(text, sizeof(text), RANKS_SCENE "particles: {file: %s, format: table, material: a}\n", path);
    struct scene *scene = good_scene(text, NULL);
    for (int twice = 1; twice <= 9; twice++) {
        if (comm.rank == 0) {
            FILE *file = fopen(path, "w");
            assert_non_null(file);
            fprintf(file, "id x y z radius\n");
            for (int k = 1; k <= 9; k++)
                fprintf(file, "%d %d 1 1 0.4\n", k, k);
            fprintf(file, "%d 15 15 15 0.4\n", twice);
            fclose(file);
        }
        struct error error = {0};
        assert_true(comm_agree(&comm, &error)); /* the file is there */
        struct particles *particles = particles_with(WITH_ALL, 0);
        struct scene_share share = {.rank = comm.rank, .size = comm.size};
        int64_t found = !scene_particles(scene, &share, particles, NULL, &error);
        comm_sum_int(&comm, &found, 1);
        assert_int_equal(found, 1);
        assert_false(comm_agree(&comm, &error));
        char says[64];
        snprintf(says, sizeof(says), "rows.txt:11: has the id of particle %d, line %d", twice, twice + 1);
        assert_non_null(strstr(error.text, says));
        particles_destroy(&particles);
    }
    scene_free(&scene);
    folder_remove(&folder, &comm);
}

/* The same particles from a LAMMPS data file and from the H5MD file made of it. */
static void h5md_equals_data(void **state) {
    (void)state;
    struct folder folder;
    folder_make(&folder, &comm);
    char data[FOLDER_MAX + 64], h5[FOLDER_MAX + 64], text[1024];
    folder_file(&folder, "rows.data", data);
    folder_file(&folder, "rows.h5", h5);
    struct error error = {0};
    if (comm.rank == 0) {
        write_file(
            data,
            "rows\n\n3 atoms\n2 atom types\n\n0 20 xlo xhi\n0 20 ylo yhi\n0 20 zlo zhi\n\nAtoms # sphere\n\n"
            "3 2 1 1.5 1 2 3\n1 1 2 2.5 4 5.5 6\n8 2 1.5 1 7 8 9.25\n\n"
            "Velocities\n\n1 1 2 3 4 5 6\n3 0.5 0 0 0 0 0\n8 0 0 -7 0 0 1\n");
        struct comm self = folder_self();
        struct convert_options options = {.to = CONVERT_H5MD};
        convert_file(data, h5, &options, &self, &error);
    }
    if (!comm_agree(&comm, &error))
        fail_msg("%s", error.text);
    struct particles *set[2];
    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof(text), RANKS_SCENE "particles: {file: %s, format: %s}\n", k ? h5 : data,
                 k ? "h5md" : "lammps-data");
        struct scene *scene = good_scene(text, NULL);
        set[k] = scene_all(scene, NULL);
        scene_free(&scene);
    }
    assert_int_equal(set[0]->owned, 3);
    assert_int_equal(set[1]->owned, 3);
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            if (set[0]->id[i] == set[1]->id[j]) {
                assert_memory_equal(&set[0]->state[i], &set[1]->state[j], sizeof(set[0]->state[i]));
                assert_memory_equal(spin_of(set[0])[i], spin_of(set[1])[j], sizeof(spin_of(set[0])[i]));
                assert_int_equal(material_numbers(set[0])[i], material_numbers(set[1])[j]);
            }
    assert_int_equal(set[1]->id[0] + set[1]->id[1] + set[1]->id[2], 12);
    particles_destroy(&set[0]);
    particles_destroy(&set[1]);
    folder_remove(&folder, &comm);
}

int main(int argc, char **argv) {
    comm_start(&comm, &argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(owners_get_theirs),
                                       cmocka_unit_test(doubles_are_found),
                                       cmocka_unit_test(h5md_equals_data)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    comm_stop(&comm);
    return failed;
}
