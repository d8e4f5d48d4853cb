/* SPDX-License-Identifier: BSD-3-Clause */
/* The head of the H5MD file: author and program, box, parameters, the runs that led to this state. */
#include "data/formats/h5md_head.h"

#include "base/version.h"
#include "data/formats/output_shapes.h"
#include "base/file.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The author for /h5md/author: the login name, as the program knows no other name. */
static const char *author_name(void) {
    const char *name = getenv("USER");
    return name && name[0] ? name : "unknown";
}

static bool write_meta(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    static const int version[2] = {1, 1}, units_version[2] = {1, 0};
    char creator[2 * OUTPUT_NAME_MAX];
    snprintf(creator, sizeof creator, "%s (%s)", version_number(), version_revision());
    /* all ranks use the author in rank 0's environment */
    char author[OUTPUT_NAME_MAX] = "";
    snprintf(author, sizeof author, "%s", author_name());
    comm_broadcast(h5md->comm, author, sizeof author);
    bool good = h5_make_group(h5, "/h5md", error) &&
                h5_write_ints(h5, "/h5md", "version", version, 2, error) &&
                h5_make_group(h5, "/h5md/author", error) &&
                h5_write_text(h5, "/h5md/author", "name", author, error) &&
                h5_make_group(h5, "/h5md/creator", error) &&
                h5_write_text(h5, "/h5md/creator", "name", "scree", error) &&
                h5_write_text(h5, "/h5md/creator", "version", creator, error);
    if (good && !h5md->dimensionless)
        good = h5_make_group(h5, "/h5md/modules/units", error) &&
               h5_write_ints(h5, "/h5md/modules/units", "version", units_version, 2, error) &&
               h5_write_text(h5, "/h5md/modules/units", "system", "SI", error);
    return good;
}

static bool write_box(const struct h5 *h5, const struct box *box, struct error *error) {
    static const char group[] = "/particles/all/box";
    const char *boundary[3];
    for (int d = 0; d < 3; d++)
        boundary[d] = box->periodic[d] ? "periodic" : "none";
    return h5_make_group(h5, group, error) &&
           h5_write_ints(h5, group, "dimension", &box->dimension, 0, error) &&
           h5_write_texts(h5, group, "boundary", boundary, box->dimension, error) &&
           h5_write_doubles(h5, group, "origin", box->origin, box->dimension, error);
}

static const char edges_group[] = "/particles/all/box/edges",
                  edges_value[] = "/particles/all/box/edges/value";

/* A table of edge vectors, a row each, as the first rank writes it. */
static struct h5_table edges_table(const struct h5md *h5md, const struct box *box) {
    uint64_t dimension = (uint64_t)box->dimension;
    return (struct h5_table){.type = FIELD_DOUBLE,
                             .rows = dimension,
                             .width = dimension,
                             .count = h5md->comm->rank == 0 ? dimension : 0};
}

bool h5md_make_edges(const struct h5md *h5md, const struct h5 *h5, const struct box *box,
                     const char *linked_to, struct error *error) {
    struct h5_table table = edges_table(h5md, box);
    return (h5md_make_element(h5md, h5, edges_group, linked_to, error) &&
            h5_make_frames(h5, edges_value, &table, table.rows, NULL, error) &&
            h5md_write_unit(h5md, h5, edges_value, "m", error));
}

bool h5md_write_edges(const struct h5md *h5md, const struct h5 *h5, const struct box *box,
                      struct error *error) {
    double edge[9] = {0};
    int n = box->dimension;
    if (!h5_exists(h5, edges_value)) /* a file of an earlier version, whose box does not move */
        return true;
    for (int d = 0; d < n; d++)
        edge[n * d + d] = box->edge[d];
    if (box->motion.shears)
        edge[n * box->motion.gradient + box->motion.flow] = box->motion.offset;
    struct h5_table table = edges_table(h5md, box);
    return h5_write_frame(h5, edges_value, &table, h5md->frames, edge, error);
}

static bool write_run(const struct h5 *h5, const struct lineage_run *run, char scene[FILE_PATH_MAX],
                      struct error *error) {
    char group[OUTPUT_NAME_MAX];
    snprintf(group, sizeof group, "/parameters/runs/%" PRIu64, run->step);
    snprintf(scene, FILE_PATH_MAX, "%s/scene", group);
    return h5_make_group(h5, group, error) && h5_write_text(h5, group, "version", run->version, error) &&
           h5_write_text(h5, group, "revision", run->revision, error) &&
           h5_write_string(h5, scene, run->scene, error);
}

bool h5md_write_runs(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    static const char runs[] = "/parameters/runs", last[] = "/parameters/scene";
    char scene[FILE_PATH_MAX] = "";
    const struct lineage *lineage = h5md->lineage;
    if (!lineage || lineage->count == 0)
        return true;
    if (!h5_remove(h5, runs, error) || !h5_remove(h5, last, error))
        return false;
    for (size_t k = 0; k < lineage->count; k++)
        if (!write_run(h5, &lineage->run[k], scene, error))
            return false;
    return h5_link(h5, scene, last, error);
}

static bool write_parameters(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    struct h5_table table = {.type = FIELD_INT64, .rows = 1, .count = h5md->comm->rank == 0};
    int64_t seed = (int64_t)h5md->seed;
    if (!h5_make_group(h5, "/parameters", error) || !h5_make_group(h5, "/observables", error))
        return false;
    return h5md_write_runs(h5md, h5, error) && output_shapes_write(h5md, h5, error) &&
           h5_write_table(h5, "/parameters/seed", &table, &seed, error);
}

bool h5md_make_file(struct h5md *h5md, const struct box *box, struct error *error) {
    enum { ROOM_HEAD = 1 << 16 };
    struct h5 h5;
    if (h5md->comm->rank == 0)
        file_check_room(h5md->path, 0, ROOM_HEAD + (h5md->shapes ? output_shapes_bytes(h5md->shapes) : 0),
                        error);
    if (!comm_agree(h5md->comm, error) || !h5_create(&h5, h5md->path, h5md->comm, 0, error))
        return false;
    if (write_meta(h5md, &h5, error) && write_box(&h5, box, error))
        write_parameters(h5md, &h5, error);
    h5md->made = h5_close(&h5, error);
    return h5md->made;
}
