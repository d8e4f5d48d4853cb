/* SPDX-License-Identifier: BSD-3-Clause */
/* Draws a frame, or all frames, by other programs. Read picture.h first. */
#include "front/picture/picture.h"

#include "base/memory.h"
#include "base/file.h"
#include "base/program.h"
#include "front/picture/camera.h"
#include "front/picture/paint.h"
#include "front/picture/shapes.h"
#include "front/picture/picture_source.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BANDS_USUAL = 64, CUTS_MAX = 6 };

/* A half-space that is taken away: axis 0 ... 2, beyond `at` to the upper or to the lower side. */
struct cut {
    int axis;
    bool above;
    double at;
};

/* A picture or film in the making. */
struct drawing {
    const struct picture_options *options;
    const char *out;
    struct source source;
    struct picture_source_field field;
    struct camera camera;
    struct paint paint;
    struct facets facets; /* of all frames */
    struct cut cut[CUTS_MAX];
    int cuts;
    bool grey[LAW_MATERIALS_MAX]; /* by material */
    bool film;
    bool walls; /* can be drawn */
    int64_t first, last;
};

static bool ends_in(const char *path, const char *ending) {
    size_t length = strlen(path), end = strlen(ending);
    return length > end && strcmp(path + length - end, ending) == 0;
}

/* Reads "y<0,x>0.1". */
static bool read_cuts(struct drawing *d, const char *text, struct error *error) {
    while (text && *text) {
        char *end;
        struct cut *cut = &d->cut[d->cuts];
        bool good =
            d->cuts < CUTS_MAX && text[0] >= 'x' && text[0] <= 'z' && (text[1] == '<' || text[1] == '>');
        *cut = (struct cut){.axis = text[0] - 'x', .above = good && text[1] == '>'};
        cut->at = good ? strtod(text + 2, &end) : NAN;
        if (!good || end == text + 2 || (*end != ',' && *end != '\0') || !isfinite(cut->at))
            return error_set(
                error, ERROR_USER,
                "command line: --cut %s: must be conditions on centres such as 'y<0' or 'x>0.1,z>0.2', at "
                "most %d; what fulfils all is taken away",
                d->options->cut, CUTS_MAX);
        d->cuts++;
        text = *end == ',' ? end + 1 : end;
    }
    return true;
}

static bool read_grey(struct drawing *d, const char *text, struct error *error) {
    while (text && *text) {
        char name[SOURCE_WORD_MAX];
        size_t length = strcspn(text, ",");
        snprintf(name, sizeof name, "%.*s", (int)length, text);
        int material = d->source.scene ? scene_material(d->source.scene, name) : -1;
        if (material < 0)
            return error_set(error, ERROR_USER, "command line: --grey %s: the run has no such material",
                             name);
        d->grey[material] = true;
        text += length + (text[length] == ',');
    }
    return true;
}

static bool read_number(const char *flag, const char *text, int most, int *number, struct error *error) {
    char end;
    if (text && (sscanf(text, "%d%c", number, &end) != 1 || *number < 1 || *number > most))
        return error_set(error, ERROR_USER, "command line: --%s %s: must be a number from 1 to %d", flag,
                         text, most);
    return true;
}

/* True if the row is taken away. */
static bool is_cut(const struct drawing *d, const double x[3]) {
    bool cut = d->cuts > 0;
    for (int k = 0; k < d->cuts; k++)
        cut = cut && (d->cut[k].above ? x[d->cut[k].axis] > d->cut[k].at : x[d->cut[k].axis] < d->cut[k].at);
    return cut;
}

static bool is_grey(const struct drawing *d, const struct rows *rows, size_t k) {
    return rows->material && rows->material[k] >= 0 && rows->material[k] < LAW_MATERIALS_MAX &&
           d->grey[rows->material[k]];
}

static int compare_doubles(const void *a, const void *b) {
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Widens the range of colours to the values of a frame; to 99 of 100 of them for a speed, which few have. */
static void widen(struct drawing *d, const struct rows *rows, const double *value) {
    double *kept = memory_allocate(rows->count, sizeof *kept, "values");
    size_t count = 0;
    for (size_t k = 0; k < rows->count; k++)
        if (!isnan(value[k]) && !is_grey(d, rows, k))
            kept[count++] = value[k];
    qsort(kept, count, sizeof *kept, compare_doubles);
    bool speed = strcmp(d->field.name, "speed") == 0;
    if (count > 0) {
        d->paint.low = fmin(d->paint.low, kept[0]);
        d->paint.high = fmax(d->paint.high, kept[speed ? (count - 1) * 99 / 100 : count - 1]);
    }
    memory_free(kept);
}

/* Adds the walls that are near the particles to what the camera sees. */
static void include_walls(struct drawing *d, double time) {
    struct shapes shapes;
    struct error error = {0};
    double lower[3], upper[3], reach = 0;
    const struct shapes_moment moment = {time, d->source.walls, d->source.wall};
    if (!shapes_make(&shapes, d->source.scene, &moment, &error)) {
        fprintf(stderr, "scree: walls are not drawn: %s\n", error.text);
        d->walls = false;
        return;
    }
    if (shapes.unknown && time > 0)
        fprintf(
            stderr,
            "scree: a wall with a servo, and a free one, is drawn where the wall begins; a checkpoint knows "
            "its place\n");
    for (int k = 0; k < 3; k++)
        reach = fmax(reach, 0.25 * (d->camera.upper[k] - d->camera.lower[k]));
    for (int k = 0; k < 3; k++) {
        lower[k] = d->camera.lower[k] - reach;
        upper[k] = d->camera.upper[k] + reach;
    }
    for (size_t t = 0; t < 3 * shapes.triangles; t++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = fmin(fmax(shapes.triangle[t / 3][3 * (t % 3) + (size_t)k], lower[k]), upper[k]);
        camera_include(&d->camera, x, 0);
    }
    for (int p = 0; p < shapes.planes; p++) {
        const struct shape_plane *plane = &shapes.plane[p];
        double x[3], gap = 0;
        for (int k = 0; k < 3; k++)
            gap += (0.5 * (lower[k] + upper[k]) - plane->point[k]) * plane->normal[k];
        for (int k = 0; k < 3; k++)
            x[k] = 0.5 * (lower[k] + upper[k]) - gap * plane->normal[k];
        bool near = true;
        for (int k = 0; k < 3; k++)
            near = near && x[k] >= lower[k] && x[k] <= upper[k];
        if (near)
            camera_include(&d->camera, x, 0);
    }
    shapes_free(&shapes);
}

/* Looks at all frames that will be drawn: range of the values, and what the camera must see. */
static bool look(struct drawing *d, struct error *error) {
    for (int64_t frame = d->first; frame <= d->last; frame++) {
        struct rows rows;
        if (!picture_source_read(&d->source, frame, &rows, error))
            return false;
        bool good = d->field.name[0] ||
                    picture_source_choose(&d->source, d->options->colour, &rows, &d->field, error);
        double *value = good ? picture_source_values(&d->source, &d->field, frame, &rows, error) : NULL;
        if (value)
            widen(d, &rows, value);
        for (size_t k = 0; value && k < rows.count; k++)
            if (is_grey(d, &rows, k) || !is_cut(d, rows.position[k]))
                camera_include(&d->camera, rows.position[k], rows.radius[k]);
        if (value && d->walls && (frame == d->first || frame == d->last))
            include_walls(d, rows.time);
        memory_free(value);
        rows_free(&rows);
        if (!value)
            return false;
    }
    return true;
}

/* Chooses the colours, and the names of the legend. */
static bool choose_paint(struct drawing *d, struct error *error) {
    struct paint *paint = &d->paint;
    const struct scene *scene = d->source.scene;
    int bands = BANDS_USUAL;
    char end;
    bool names = strcmp(d->field.name, "material") == 0 && scene && !d->options->range && !d->options->bands;
    if (!read_number("bands", d->options->bands, PAINT_BANDS_MAX, &bands, error))
        return false;
    if (d->options->range && (sscanf(d->options->range, "%lf,%lf%c", &paint->low, &paint->high, &end) != 2 ||
                              !(paint->low < paint->high)))
        return error_set(error, ERROR_USER, "command line: --range %s: must be LOW,HIGH", d->options->range);
    names = names && paint->high >= 0 && paint->high < scene->materials;
    if (names) { /* those that occur, and those before them */
        paint->names = bands = (int)paint->high + 1;
        paint->low = -0.5;
        paint->high = bands - 0.5;
        for (int k = 0; k < bands; k++)
            snprintf(paint->name[k], sizeof paint->name[k], "%.60s", scene->material[k].name);
    }
    snprintf(paint->label, sizeof paint->label, "%s", d->field.label);
    d->camera.legend = !d->options->bare && paint->high > paint->low;
    return paint_bands(paint, d->options->palette, bands, error);
}

/* True of a body: its members are drawn, and not it. */
static bool is_body(const struct rows *rows, size_t k) {
    return rows->body_mass && rows->body_mass[k] > 0;
}

static bool write_scene(const struct drawing *d, const char *path, int64_t frame, struct error *error) {
    struct rows rows;
    struct shapes shapes = {0};
    struct file_new file;
    if (!picture_source_read(&d->source, frame, &rows, error))
        return false;
    double *value = picture_source_values(&d->source, &d->field, frame, &rows, error);
    if (value == NULL) {
        rows_free(&rows);
        return false;
    }
    int *band = memory_allocate(rows.count, sizeof *band, "colours");
    for (size_t k = 0; k < rows.count; k++)
        band[k] = is_body(&rows, k)             ? PAINT_GREY - 1
                  : is_grey(d, &rows, k)        ? PAINT_GREY
                  : is_cut(d, rows.position[k]) ? PAINT_GREY - 1
                                                : paint_band(&d->paint, value[k]);
    const struct shapes_moment moment = {rows.time, d->source.walls, d->source.wall};
    bool walls = d->walls && shapes_make(&shapes, d->source.scene, &moment, error);
    double lower[3], upper[3], border = 0;
    for (int k = 0; k < 3; k++)
        border = fmax(border, 0.02 * (d->camera.upper[k] - d->camera.lower[k]));
    for (int k = 0; k < 3; k++) {
        lower[k] = d->camera.lower[k] - border;
        upper[k] = d->camera.upper[k] + border;
    }
    shapes_cut(&shapes, lower, upper);
    struct error unknown = {0};
    if (!facets_told(&d->facets, d->source.path, &rows, &unknown))
        fprintf(stderr, "scree: rocks are drawn as balls: %s\n", unknown.text);
    struct paint_scene scene = {.camera = &d->camera,
                                .paint = &d->paint,
                                .rows = &rows,
                                .band = band,
                                .facets = &d->facets,
                                .shapes = walls ? &shapes : NULL,
                                .soft = !d->film};
    bool good = error->kind == ERROR_NONE && file_new_open(&file, path, error);
    if (good) {
        paint_write(file.stream, &scene);
        good = file_new_close(&file, error);
    }
    shapes_free(&shapes);
    memory_free(band);
    memory_free(value);
    rows_free(&rows);
    return good;
}

/* Names of the files on the way to a picture or film. They lie in a folder of their own, in which other programs see plain
 * names: POV-Ray and ffmpeg find more in a name than letters. */
struct way {
    char folder[FILE_PATH_MAX], scene[FILE_PATH_MAX + 32], told[FILE_PATH_MAX + 32], made[FILE_PATH_MAX + 32];
};

/* Draws one frame by POV-Ray, to the file `png` in the folder. */
static bool render(const struct drawing *d, const struct way *way, int64_t frame, const char *png,
                   struct error *error) {
    char out[40], width[24], height[24];
    snprintf(out, sizeof out, "+O%s", png);
    snprintf(width, sizeof width, "+W%d", d->camera.width);
    snprintf(height, sizeof height, "+H%d", d->camera.height);
    const char *const command[] = {"povray", "-D",  "-GD",  "-GR",         "-GS", "-GW", "+FN",
                                   "+A0.2",  width, height, "+Iscene.pov", out,   NULL};
    return write_scene(d, way->scene, frame, error) &&
           program_run(command, way->folder, way->told, "povray", error);
}

static void name_frame(char name[32], int64_t number) {
    snprintf(name, 32, "%06" PRId64 ".png", number);
}

static bool make_film(const struct drawing *d, const struct way *way, struct error *error) {
    char png[32], rate[16] = "25";
    int number = 25;
    if (!read_number("rate", d->options->rate, 1000, &number, error))
        return false;
    snprintf(rate, sizeof rate, "%d", number);
    const char *const version[] = {"ffmpeg", "-version", NULL};
    bool good = program_run(version, NULL, way->told, "ffmpeg", error);
    for (int64_t frame = d->first; good && frame <= d->last; frame++) {
        name_frame(png, frame - d->first);
        if (isatty(2))
            fprintf(stderr, "\rpicture %" PRId64 " of %" PRId64, frame - d->first + 1,
                    d->last - d->first + 1);
        good = render(d, way, frame, png, error);
    }
    if (isatty(2))
        fprintf(stderr, "\n");
    const char *const command[] = {
        "ffmpeg",   "-y",      "-loglevel", "error", "-framerate",
        rate,       "-i",      "%06d.png",  "-vf",   "pad=ceil(iw/2)*2:ceil(ih/2)*2",
        "-pix_fmt", "yuv420p", "made.mp4",  NULL};
    return good && program_run(command, way->folder, way->told, "ffmpeg", error);
}

/* Removes the folder with all that may be in it. */
static void way_remove(const struct drawing *d, const struct way *way) {
    char path[FILE_PATH_MAX + 64], png[32];
    for (int64_t frame = d->first; d->film && frame <= d->last; frame++) {
        name_frame(png, frame - d->first);
        snprintf(path, sizeof path, "%s/%s", way->folder, png);
        remove(path);
    }
    remove(way->made);
    remove(way->scene);
    remove(way->told);
    rmdir(way->folder);
}

static bool make(const struct drawing *d, struct error *error) {
    struct way way;
    if (ends_in(d->out, ".pov"))
        return write_scene(d, d->out, d->first, error);
    if (strlen(d->out) > FILE_PATH_MAX - 16)
        return error_set(error, ERROR_USER, "%s: the name is too long", d->out);
    snprintf(way.folder, sizeof way.folder, "%.1000s.frames", d->out);
    snprintf(way.scene, sizeof way.scene, "%s/scene.pov", way.folder);
    snprintf(way.told, sizeof way.told, "%s/told.log", way.folder);
    snprintf(way.made, sizeof way.made, "%s/made.%s", way.folder, d->film ? "mp4" : "png");
    if (mkdir(way.folder, 0777) != 0 && access(way.folder, W_OK) != 0)
        return error_set_errno(error, "%s: cannot be made", way.folder);
    bool good = (d->film ? make_film(d, &way, error) : render(d, &way, d->first, "made.png", error)) &&
                (rename(way.made, d->out) == 0 || error_set_errno(error, "%s: cannot be written", d->out));
    way_remove(d, &way);
    return good;
}

/* Checks the command line against the run. */
static bool prepare(struct drawing *d, struct error *error) {
    struct rows rows;
    d->walls = d->source.scene && !d->options->bare;
    d->paint.low = INFINITY;
    d->paint.high = -INFINITY;
    if (!picture_source_frame(&d->source, d->options->frame, &d->last, error))
        return false;
    d->first = d->film ? 0 : d->last;
    if (!picture_source_read(&d->source, d->last, &rows, error))
        return false;
    bool good = camera_aim(&d->camera, d->options->size, d->options->view, rows.dimension, error) &&
                read_cuts(d, d->options->cut, error) && read_grey(d, d->options->grey, error) &&
                picture_source_choose(&d->source, d->options->colour, &rows, &d->field, error);
    rows_free(&rows);
    if (!good || !look(d, error) || !choose_paint(d, error))
        return false;
    if (!(d->camera.low[0] <= d->camera.high[0]))
        return error_set(error, ERROR_USER, "command line: --cut %s: takes all particles away",
                         d->options->cut);
    camera_settle(&d->camera);
    return true;
}

bool picture_draw(const struct comm *comm, const char *from, const char *out,
                  const struct picture_options *options, struct error *error) {
    static struct drawing drawing; /* large */
    drawing = (struct drawing){.options = options, .out = out, .film = ends_in(out, ".mp4")};
    if (!drawing.film && !ends_in(out, ".png") && !ends_in(out, ".pov"))
        return error_set(error, ERROR_USER, "command line: -o %s: the name must end in .png, .mp4 or .pov",
                         out);
    struct error unknown = {0};
    bool good = picture_source_open(&drawing.source, comm, from, error) && prepare(&drawing, error);
    if (good && !facets_make(&drawing.facets, drawing.source.scene, &unknown))
        fprintf(stderr, "scree: rocks are drawn as balls: %s\n", unknown.text);
    good = good && make(&drawing, error);
    facets_free(&drawing.facets);
    picture_source_close(&drawing.source);
    return good;
}
