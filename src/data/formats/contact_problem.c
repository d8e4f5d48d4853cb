/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes contact problems as HDF5. Read contact_problem.h first. */
#include "data/formats/contact_problem.h"
#include "base/file.h"
#include "data/formats/h5.h"
#include <dirent.h>
#include <inttypes.h>
#include <string.h>
#include <unistd.h>

static void name_of(char name[64], uint64_t step) {
    snprintf(name, 64, "contact-problem-%" PRIu64 ".hdf5", step);
}

static bool is_problem(const char *name, uint64_t *step) {
    char again[64];
    if (sscanf(name, "contact-problem-%" SCNu64 ".hdf5", step) != 1)
        return false;
    name_of(again, *step);
    return strcmp(again, name) == 0;
}

void contact_problem_discard(const char *directory, int64_t step) {
    DIR *open = opendir(directory);
    char path[FILE_PATH_MAX];
    struct error ignored = {0};
    uint64_t found;
    for (struct dirent *entry; open && (entry = readdir(open));)
        if (is_problem(entry->d_name, &found) && (int64_t)found > step &&
            file_join(path, directory, entry->d_name, &ignored))
            unlink(path);
    if (open)
        closedir(open);
}

static bool reals(const struct h5 *h5, const char *name, size_t count, const double *value,
                  struct error *error) {
    return h5_write_table(h5, name, &(struct h5_table){.type = FIELD_DOUBLE, .rows = count, .count = count},
                          value, error);
}

static bool numbers(const struct h5 *h5, const char *name, size_t count, const int32_t *value,
                    struct error *error) {
    return h5_write_table(h5, name, &(struct h5_table){.type = FIELD_INT32, .rows = count, .count = count},
                          value, error);
}

/* By compressed columns, which FCLIB tells by nz = -1. */
static bool matrix_write(const struct h5 *h5, const struct contact_problem *problem, struct error *error) {
    const int32_t size = (int32_t)(3 * problem->contacts), entries = problem->start[size], kind = -1;
    const struct {
        const char *name;
        size_t count;
        const int32_t *value;
    } part[] = {{"/fclib_local/W/nzmax", 1, &entries},
                {"/fclib_local/W/m", 1, &size},
                {"/fclib_local/W/n", 1, &size},
                {"/fclib_local/W/nz", 1, &kind},
                {"/fclib_local/W/p", (size_t)size + 1, problem->start},
                {"/fclib_local/W/i", (size_t)entries, problem->row}};
    for (size_t k = 0; k < sizeof part / sizeof part[0]; k++)
        if (!numbers(h5, part[k].name, part[k].count, part[k].value, error))
            return false;
    return reals(h5, "/fclib_local/W/x", (size_t)entries, problem->value, error);
}

static bool all_write(const struct h5 *h5, const struct contact_problem *problem, struct error *error) {
    static const char *const groups[] = {"/fclib_local/W", "/fclib_local/vectors", "/fclib_local/info",
                                         "/solution", "/scree"};
    const struct {
        const char *name;
        const double *value;
    } vector[] = {{"/fclib_local/vectors/q", problem->q},
                  {"/solution/r", problem->r},
                  {"/solution/u", problem->u},
                  {"/scree/soft", problem->soft},
                  {"/scree/shift", problem->shift}};
    const int32_t three = 3;
    const size_t contacts = problem->contacts;
    bool good = true;
    for (size_t k = 0; k < sizeof groups / sizeof groups[0]; k++)
        good = good && h5_make_group(h5, groups[k], error);
    good = good && numbers(h5, "/fclib_local/spacedim", 1, &three, error) && matrix_write(h5, problem, error);
    for (size_t k = 0; k < sizeof vector / sizeof vector[0]; k++)
        good = good && reals(h5, vector[k].name, 3 * contacts, vector[k].value, error);
    return good && h5_write_doubles(h5, "/scree", "dt", &problem->dt, 1, error) &&
           h5_write_doubles(h5, "/scree", "gravity", &problem->gravity, 1, error) &&
           reals(h5, "/fclib_local/vectors/mu", contacts, problem->mu, error) &&
           h5_write_string(h5, "/fclib_local/info/title", "the contacts of a step of scree", error) &&
           h5_write_string(h5, "/fclib_local/info/description", problem->described, error) &&
           h5_write_table(
               h5, "/scree/id",
               &(struct h5_table){.type = FIELD_INT64, .rows = contacts, .width = 2, .count = contacts},
               problem->id, error);
}

bool contact_problem_write(const char *directory, uint64_t step, const struct contact_problem *problem,
                           struct error *error) {
    char name[64], path[FILE_PATH_MAX], temporary[FILE_PATH_MAX + 8];
    struct h5 h5;
    name_of(name, step);
    if (!file_join(path, directory, name, error))
        return false;
    snprintf(temporary, sizeof temporary, "%s.part", path);
    if (!h5_create(&h5, temporary, NULL, 0, error))
        return false;
    bool good = all_write(&h5, problem, error);
    good = h5_close(&h5, error) && good;
    if (!good)
        unlink(temporary);
    return good && file_settle(temporary, path, error);
}
