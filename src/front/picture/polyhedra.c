/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes rocks as polygons. Read polyhedra.h first. */
#include "front/picture/polyhedra.h"

#include "base/memory.h"
#include "base/rotor.h"
#include "data/formats/convert.h"
#include "data/formats/vtp.h"
#include "front/picture/paint.h"
#include "physics/bodies/shapes/chamfer.h"

#include <inttypes.h>
#include <string.h>

/* Arrays of a file: points, corners and ends come before values of polygons. */
enum { VALUES_FIRST = 3, VALUES = 6 };

/* The rocks of a run. */
struct drawn {
    const struct source *source;
    struct facets facets;
    struct chamfer *surface; /* of each shape */
    bool overwrite;
};

/* The polygons of a frame. */
struct faces {
    size_t points, corners, polygons; /* so far, in the end of all */
    double (*point)[3];
    int64_t *corner, *end;
    size_t *row; /* of the frame, of each polygon */
};

static bool ends_in(const char *path, const char *ending) {
    size_t length = strlen(path), end = strlen(ending);
    return length > end && strcmp(path + length - end, ending) == 0;
}

bool polyhedra_named(const char *out) {
    return ends_in(out, ".vtp") || ends_in(out, ".pvd");
}

static void faces_free(struct faces *faces) {
    memory_free(faces->point);
    memory_free(faces->corner);
    memory_free(faces->end);
    memory_free(faces->row);
}

static void faces_reserve(struct faces *faces, const struct drawn *drawn, const struct rows *rows) {
    size_t points = 0, corners = 0, polygons = 0;
    for (size_t k = 0; k < rows->count; k++) {
        const int shape = facets_shape(&drawn->facets, rows, k);
        const struct chamfer *of = shape < 0 ? NULL : &drawn->surface[shape];
        points += of ? (size_t)of->corners : 0;
        corners += of ? (size_t)of->start[of->polygons] : 0;
        polygons += of ? (size_t)of->polygons : 0;
    }
    *faces = (struct faces){.point = memory_allocate(points, sizeof *faces->point, "faces of rocks"),
                            .corner = memory_allocate(corners, sizeof *faces->corner, "faces of rocks"),
                            .end = memory_allocate(polygons, sizeof *faces->end, "faces of rocks"),
                            .row = memory_allocate(polygons, sizeof *faces->row, "faces of rocks")};
}

/* Adds the rock of row k. */
static void faces_add(struct faces *faces, const struct clump *shape, const struct chamfer *surface,
                      const struct rows *rows, size_t k) {
    const double scale = rows->radius[k] / shape->extent;
    double turn[9];
    rotor_matrix(rows->rock_orientation[k], turn);
    for (int p = 0; p < surface->polygons; p++) {
        for (int c = surface->start[p]; c < surface->start[p + 1]; c++)
            faces->corner[faces->corners++] = (int64_t)faces->points + surface->ring[c];
        faces->end[faces->polygons] = (int64_t)faces->corners;
        faces->row[faces->polygons++] = k;
    }
    for (int c = 0; c < surface->corners; c++, faces->points++)
        for (int d = 0; d < 3; d++) {
            const double *x = surface->corner[c];
            faces->point[faces->points][d] =
                rows->position[k][d] +
                scale * (turn[3 * d] * x[0] + turn[3 * d + 1] * x[1] + turn[3 * d + 2] * x[2]);
        }
}

static void faces_make(struct faces *faces, const struct drawn *drawn, const struct rows *rows) {
    faces_reserve(faces, drawn, rows);
    for (size_t k = 0; k < rows->count; k++) {
        const int shape = facets_shape(&drawn->facets, rows, k);
        if (shape >= 0)
            faces_add(faces, &drawn->facets.shape[shape], &drawn->surface[shape], rows, k);
    }
}

/* Adds an array of values of polygons: those of their rocks. Returns it; NULL: rows lack the values. */
static void *value_add(struct vtp_content *content, struct vtp_array *array, const struct faces *faces,
                       const struct vtp_array *of_rows) {
    if (of_rows->data == NULL)
        return NULL;
    const size_t bytes = (size_t)(of_rows->bytes * of_rows->components);
    char *to = memory_allocate(faces->polygons, bytes, "values of rocks");
    for (size_t p = 0; p < faces->polygons; p++)
        memcpy(to + p * bytes, (const char *)of_rows->data + faces->row[p] * bytes, bytes);
    array[content->arrays] = *of_rows;
    array[content->arrays].rows = faces->polygons;
    array[content->arrays++].data = to;
    return to;
}

static bool faces_write(const char *path, const struct faces *faces, const struct rows *rows,
                        struct error *error) {
    struct vtp_array array[VALUES_FIRST + VALUES] = {
        {"Points", "Float64", 8, 3, faces->points, faces->point},
        {"connectivity", "Int64", 8, 1, faces->corners, faces->corner},
        {"offsets", "Int64", 8, 1, faces->polygons, faces->end}};
    const struct vtp_array value[VALUES] = {{"id", "Int64", 8, 1, 0, rows->id},
                                            {"rock_shape", "Int32", 4, 1, 0, rows->rock_shape},
                                            {"radius", "Float64", 8, 1, 0, rows->radius},
                                            {"material", "Int32", 4, 1, 0, rows->material},
                                            {"velocity", "Float64", 8, 3, 0, rows->velocity},
                                            {"angular_velocity", "Float64", 8, 3, 0, rows->angular_velocity}};
    struct vtp_content content = {.time = rows->time,
                                  .arrays = VALUES_FIRST,
                                  .array = array,
                                  .scalars = "radius",
                                  .vectors = rows->velocity ? "velocity" : NULL};
    void *copy[VALUES];
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    for (int k = 0; k < VALUES; k++)
        copy[k] = value_add(&content, array, faces, &value[k]);
    vtp_write(file.stream, &content);
    for (int k = 0; k < VALUES; k++)
        memory_free(copy[k]);
    return file_new_close(&file, error);
}

/* Writes the rocks among the rows of a frame. */
static bool rows_write(const struct drawn *drawn, const struct rows *rows, const char *path,
                       struct error *error) {
    struct faces faces;
    if (!facets_told(&drawn->facets, drawn->source->path, rows, error))
        return false;
    faces_make(&faces, drawn, rows);
    bool good = faces_write(path, &faces, rows, error);
    faces_free(&faces);
    return good;
}

/* True if a file may be written. */
static bool is_free(const char *path, bool overwrite, struct error *error) {
    return overwrite || file_size(path) < 0 ||
           error_set(error, ERROR_USER, "%s: is there already (--overwrite replaces it)", path);
}

/* Writes a frame to NAME-STEP.vtp, and its line of the list; frames without particles are left out. */
static bool list_add(FILE *list, const struct drawn *drawn, int64_t frame, const char *out,
                     struct error *error) {
    char path[FILE_PATH_MAX + 32];
    struct rows rows;
    if (!convert_read(drawn->source->path, frame, drawn->source->comm, &rows, NULL, error))
        return false;
    snprintf(path, sizeof path, "%.*s-%" PRIu64 ".vtp", (int)(strlen(out) - strlen(".pvd")), out, rows.step);
    bool good =
        rows.count == 0 || (is_free(path, drawn->overwrite, error) && rows_write(drawn, &rows, path, error));
    if (good && rows.count > 0) {
        const char *name = strrchr(path, '/');
        fprintf(list, "<DataSet timestep=\"%.17g\" file=\"%s\"/>\n", rows.time, name ? name + 1 : path);
    }
    rows_free(&rows);
    return good;
}

static bool list_write(const struct drawn *drawn, int64_t first, int64_t last, const char *out,
                       struct error *error) {
    struct file_new file;
    if (!file_new_open(&file, out, error))
        return false;
    fprintf(file.stream,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n");
    for (int64_t k = first; k <= last && error->kind == ERROR_NONE; k++)
        list_add(file.stream, drawn, k, out, error);
    fprintf(file.stream, "</Collection>\n</VTKFile>\n");
    return file_new_close(&file, error);
}

static bool one_write(const struct drawn *drawn, int64_t frame, const char *out, struct error *error) {
    struct rows rows;
    if (!picture_source_read(drawn->source, frame, &rows, error))
        return false;
    bool good = rows_write(drawn, &rows, out, error);
    rows_free(&rows);
    return good;
}

/* Makes the shapes of the run, once for all frames. */
static bool drawn_make(struct drawn *drawn, struct error *error) {
    const struct source *source = drawn->source;
    struct facets *facets = &drawn->facets;
    if (!facets_make(facets, source->scene, error))
        return false;
    if (facets->shapes == 0)
        return error_set(error, ERROR_USER, "%s: %s; .vtp and .pvd hold the faces of rocks", source->path,
                         source->scene ? "the scene of this run has no rocks (bodies.shapes)"
                                       : "has no scene, which alone tells the shapes of rocks: use a "
                                         "trajectory or a checkpoint");
    drawn->surface = memory_allocate_zero((size_t)facets->shapes, sizeof *drawn->surface, "faces of rocks");
    for (int s = 0; s < facets->shapes; s++)
        if (facets->shape[s].core.faces > 0)
            chamfer_make(&drawn->surface[s], &facets->shape[s].core, facets->shape[s].rounding);
    return true;
}

static void drawn_free(struct drawn *drawn) {
    for (int s = 0; drawn->surface && s < drawn->facets.shapes; s++)
        chamfer_free(&drawn->surface[s]);
    memory_free(drawn->surface);
    facets_free(&drawn->facets);
}

bool polyhedra_write(const struct comm *comm, const char *in, const char *out,
                     const struct polyhedra_options *options, struct error *error) {
    struct source source = {0};
    struct drawn drawn = {.source = &source, .overwrite = options->overwrite};
    int64_t frame;
    const bool list = ends_in(out, ".pvd"), all = list && options->frame == NULL;
    if (!is_free(out, options->overwrite, error))
        return false;
    bool good = picture_source_open(&source, comm, in, error) &&
                picture_source_frame(&source, options->frame, &frame, error) && drawn_make(&drawn, error);
    good = good && (list ? list_write(&drawn, all ? 0 : frame, frame, out, error)
                         : one_write(&drawn, frame, out, error));
    drawn_free(&drawn);
    picture_source_close(&source);
    return good;
}
