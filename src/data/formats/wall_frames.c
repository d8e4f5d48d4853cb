/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes frames of the walls. Read wall_frames.h first. */
#include "data/formats/wall_frames.h"
#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"
#include "data/formats/vtp.h"
#include <dirent.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

/* The text before the arrays of a frame is filled with blanks up to HEAD_BYTES, so that the places of the arrays follow
 * from the number of triangles: walls.xdmf points to them. */
enum { HEAD_BYTES = 2048 };

struct wall_frame {
    uint64_t step, triangles;
    double time;
};

struct wall_frames {
    const struct comm *comm; /* borrowed */
    char directory[FILE_PATH_MAX];
    size_t count;
    struct wall_frame *frame; /* rank 0 */
};

/* The arrays of a frame in the order of the file. */
enum array { POINTS, CORNERS, ENDS, WALL, FORCE, PRESSURE, ARRAYS };
static const struct {
    const char *name, *type, *number; /* VTK's and XDMF's names of a number */
    int bytes, components, rows;      /* of a number; of a row; rows of a triangle */
} arrays[ARRAYS] = {
    [POINTS] = {"Points", "Float64", "Float", 8, 3, 3},
    [CORNERS] = {"connectivity", "Int64", "Int", 8, 1, 3},
    [ENDS] = {"offsets", "Int64", "Int", 8, 1, 1},
    [WALL] = {"wall", "Int64", "Int", 8, 1, 1},
    [FORCE] = {"force", "Float64", "Float", 8, 3, 1},
    [PRESSURE] = {"pressure", "Float64", "Float", 8, 1, 1},
};

double wall_frames_bytes(double triangles) {
    double each = 0;
    for (int k = 0; k < ARRAYS; k++)
        each += arrays[k].bytes * arrays[k].components * arrays[k].rows;
    return HEAD_BYTES + 8 * ARRAYS + each * triangles;
}

static void frame_name(char name[64], uint64_t step) {
    snprintf(name, 64, "walls-%" PRIu64 ".vtp", step);
}

static bool is_frame(const char *name, uint64_t *step) {
    char again[64];
    if (sscanf(name, "walls-%" SCNu64 ".vtp", step) != 1)
        return false;
    frame_name(again, *step);
    return strcmp(again, name) == 0;
}

void wall_frames_discard(const char *directory, int64_t step) {
    DIR *open = opendir(directory);
    char path[FILE_PATH_MAX];
    struct error ignored = {0};
    uint64_t found;
    for (struct dirent *entry; open && (entry = readdir(open));)
        if (is_frame(entry->d_name, &found) && (int64_t)found > step &&
            file_join(path, directory, entry->d_name, &ignored))
            unlink(path);
    if (open)
        closedir(open);
}

static void frames_add(struct wall_frames *frames, const struct wall_frame *frame) {
    frames->frame = memory_resize(frames->frame, frames->count + 1, sizeof *frames->frame, "frames of walls");
    frames->frame[frames->count++] = *frame;
}

/* The frames up to a step that the list names. */
static bool frames_read(struct wall_frames *frames, int64_t step, struct error *error) {
    char path[FILE_PATH_MAX];
    struct wall_frame frame;
    struct lines lines;
    if (!file_join(path, frames->directory, "walls.pvd", error))
        return false;
    if (file_size(path) < 0)
        return true;
    if (!lines_open(&lines, path, error))
        return false;
    while (lines_next(&lines))
        if (sscanf(lines.text, "<DataSet timestep=\"%lf\" file=\"walls-%" SCNu64 ".vtp\"/><!-- %" SCNu64,
                   &frame.time, &frame.step, &frame.triangles) == 3 &&
            (int64_t)frame.step <= step)
            frames_add(frames, &frame);
    lines_close(&lines);
    return true;
}

bool wall_frames_open(struct wall_frames **frames, const struct comm *comm, const char *directory,
                      int64_t resume_step, struct error *error) {
    struct wall_frames *f = memory_allocate_zero(1, sizeof *f, "frames of walls");
    f->comm = comm;
    snprintf(f->directory, sizeof f->directory, "%s", directory);
    *frames = f;
    if (comm->rank == 0) {
        wall_frames_discard(directory, resume_step);
        if (resume_step >= 0)
            frames_read(f, resume_step, error);
    }
    if (comm_agree(comm, error))
        return true;
    wall_frames_close(frames);
    return false;
}

/* The arrays of a frame without their data. */
static void arrays_find(struct vtp_array array[ARRAYS], uint64_t triangles) {
    for (int k = 0; k < ARRAYS; k++)
        array[k] = (struct vtp_array){.name = arrays[k].name,
                                      .type = arrays[k].type,
                                      .bytes = arrays[k].bytes,
                                      .components = arrays[k].components,
                                      .rows = (uint64_t)arrays[k].rows * triangles};
}

/* The arrays of a frame; 5 numbers and 4 values a triangle are room for what the surface lacks. */
static void arrays_fill(struct vtp_array array[ARRAYS], const struct wall_surface *surface,
                        const double (*load)[4], int64_t *number, double *value) {
    const size_t count = surface->triangles;
    arrays_find(array, count);
    for (size_t k = 0; k < 3 * count; k++) {
        number[k] = (int64_t)k;
        value[k] = load[k / 3][k % 3];
    }
    for (size_t k = 0; k < count; k++) {
        double area = wall_surface_area(surface->corner[k]);
        number[3 * count + k] = 3 * (int64_t)(k + 1);
        number[4 * count + k] = surface->wall[k];
        value[3 * count + k] = area > 0 ? load[k][3] / area : 0;
    }
    array[POINTS].data = surface->corner;
    array[CORNERS].data = number;
    array[ENDS].data = number + 3 * count;
    array[WALL].data = number + 4 * count;
    array[FORCE].data = value;
    array[PRESSURE].data = value + 3 * count;
}

/* Writes a frame: numbers in the layout of `arrays`. */
static bool write_frame(const struct wall_frames *frames, const struct wall_frame *frame,
                        const struct wall_surface *surface, const double (*load)[4], struct error *error) {
    struct vtp_array array[ARRAYS];
    const struct vtp_content content = {.time = frame->time,
                                        .arrays = ARRAYS,
                                        .array = array,
                                        .scalars = "pressure",
                                        .vectors = "force",
                                        .head = HEAD_BYTES};
    char name[64], path[FILE_PATH_MAX];
    struct file_new file;
    frame_name(name, frame->step);
    if (!file_join(path, frames->directory, name, error) || !file_new_open(&file, path, error))
        return false;
    int64_t *number = memory_allocate(5 * surface->triangles, sizeof *number, "frame of walls");
    double *value = memory_allocate(4 * surface->triangles, sizeof *value, "frame of walls");
    arrays_fill(array, surface, load, number, value);
    vtp_write(file.stream, &content);
    memory_free(number);
    memory_free(value);
    return file_new_close(&file, error);
}

static void write_item(FILE *file, const struct wall_frame *frame, enum array k, int components) {
    struct vtp_array array[ARRAYS];
    arrays_find(array, frame->triangles);
    uint64_t rows = array[k].rows * (uint64_t)array[k].components / (uint64_t)components;
    fprintf(file,
            "<DataItem Dimensions=\"%" PRIu64 " %d\" NumberType=\"%s\" Precision=\"%d\" Format=\"Binary\" "
            "Endian=\"Native\" Seek=\"%" PRIu64 "\">walls-%" PRIu64 ".vtp</DataItem>",
            rows, components, arrays[k].number, arrays[k].bytes, HEAD_BYTES + vtp_place(array, (int)k) + 8,
            frame->step);
}

static bool write_xdmf(const struct wall_frames *frames, struct error *error) {
    char path[FILE_PATH_MAX];
    struct file_new file;
    if (!file_join(path, frames->directory, "walls.xdmf", error) || !file_new_open(&file, path, error))
        return false;
    fprintf(file.stream, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
                         "<Grid Name=\"walls\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
    for (size_t f = 0; f < frames->count; f++) {
        const struct wall_frame *frame = &frames->frame[f];
        fprintf(file.stream,
                "<Grid Name=\"step %" PRIu64 "\" GridType=\"Uniform\"><Time Value=\"%.17g\"/>\n"
                "<Topology TopologyType=\"Triangle\" NumberOfElements=\"%" PRIu64 "\">",
                frame->step, frame->time, frame->triangles);
        write_item(file.stream, frame, CORNERS, 3);
        fprintf(file.stream, "</Topology>\n<Geometry GeometryType=\"XYZ\">");
        write_item(file.stream, frame, POINTS, 3);
        fprintf(file.stream, "</Geometry>\n");
        for (int k = WALL; k < ARRAYS; k++) {
            fprintf(file.stream, "<Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Cell\">",
                    arrays[k].name, arrays[k].components == 3 ? "Vector" : "Scalar");
            write_item(file.stream, frame, (enum array)k, arrays[k].components);
            fprintf(file.stream, "</Attribute>\n");
        }
        fprintf(file.stream, "</Grid>\n");
    }
    fprintf(file.stream, "</Grid>\n</Domain></Xdmf>\n");
    return file_new_close(&file, error);
}

/* The list of frames; a comment names the number of triangles, for a resume. */
static bool write_list(const struct wall_frames *frames, struct error *error) {
    char path[FILE_PATH_MAX];
    struct file_new file;
    if (!file_join(path, frames->directory, "walls.pvd", error) || !file_new_open(&file, path, error))
        return false;
    fprintf(file.stream,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n");
    for (size_t f = 0; f < frames->count; f++)
        fprintf(file.stream,
                "<DataSet timestep=\"%.17g\" file=\"walls-%" PRIu64 ".vtp\"/><!-- %" PRIu64
                " triangles -->\n",
                frames->frame[f].time, frames->frame[f].step, frames->frame[f].triangles);
    fprintf(file.stream, "</Collection>\n</VTKFile>\n");
    return file_new_close(&file, error);
}

/* True if the last frame is that of this step: the stages of a scene and a resume meet at a step. */
static bool frames_have(const struct wall_frames *frames, uint64_t step) {
    return frames->count > 0 && frames->frame[frames->count - 1].step == step;
}

/* Adds a frame to the lists, with the parts of all ranks. */
static void frame_put(struct wall_frames *frames, const struct output_view *view,
                      const struct wall_surface *surface, struct wall_surface_part *part, size_t parts,
                      struct error *error) {
    struct wall_frame frame = {.step = view->step, .time = view->time, .triangles = surface->triangles};
    double(*load)[4] = wall_surface_sum(surface, part, parts);
    if (frames_have(frames, view->step))
        frames->count--;
    if (write_frame(frames, &frame, surface, (const double(*)[4])load, error)) {
        frames_add(frames, &frame);
        (void)(write_list(frames, error) && write_xdmf(frames, error));
    }
    memory_free(load);
}

bool wall_frames_write(struct wall_frames *frames, const struct output_view *view, struct error *error) {
    struct wall_surface surface;
    void *part = NULL;
    if (view->walls == NULL)
        return true;
    wall_surface_make(&surface, view->walls, view->contact);
    size_t bytes =
        comm_gather_varying(frames->comm, surface.part, surface.parts * sizeof *surface.part, &part, NULL);
    if (frames->comm->rank == 0)
        frame_put(frames, view, &surface, part, bytes / sizeof *surface.part, error);
    memory_free(part);
    wall_surface_free(&surface);
    return comm_agree(frames->comm, error);
}

void wall_frames_close(struct wall_frames **frames) {
    if (*frames == NULL)
        return;
    memory_free((*frames)->frame);
    memory_free(*frames);
    *frames = NULL;
}
