/* SPDX-License-Identifier: BSD-3-Clause */
/* Places labels and writes the script of the plot. Read speed_error.h first. */
#include "front/program/speed_error.h"
#include "base/program.h"
#include <math.h>
#include <string.h>

/* In pixels, y upwards: the picture, and the frame of the plot inside; the height of a line of labels; half
 * the size of a point, and the distance of a label from its point. */
enum {
    WIDTH = 900,
    HEIGHT = 560,
    LEFT = 90,
    RIGHT = 740,
    BOTTOM = 64,
    TOP = 540,
    LINE = 13,
    POINT = 5,
    OFF = 9
};

enum { RINGS = 24, RINGS_NEAR = 2, SIDES = 8, BOXES_MAX = 2 * VARIANTS_MAX + 1, COLOURS = 8 };

static const double letter = 6.3;        /* width */
static const double error_least = 1e-16; /* stands for error 0 on the logarithmic axis */
static const char below[] = "below: cannot be told apart";

struct patch {
    double left, right, low, high;
};

/* The scales from values to pixels, and the areas already in use. */
struct canvas {
    const struct speed_report *report;
    double floor;                                /* smaller errors are drawn at this value */
    double least[2], most[2];                    /* of the axes: seconds, error */
    const struct speed_row *front[VARIANTS_MAX]; /* the fastest first */
    int fronts;
    struct patch box[BOXES_MAX]; /* points and labels so far */
    int boxes;
};

/* A position for a label. */
struct place {
    struct patch box;
    bool far; /* the label needs a line from its point */
};

static bool shown(const struct speed_row *row) {
    return row->stopped[0] == '\0' && row->seconds > 0 && isfinite(row->judged);
}

static double error_shown(const struct canvas *canvas, const struct speed_row *row) {
    return fmax(row->judged, canvas->floor);
}

static double pixel(const struct canvas *canvas, int axis, double value) {
    double from = axis == 0 ? LEFT : BOTTOM, to = axis == 0 ? RIGHT : TOP;
    return from +
           (to - from) * log(value / canvas->least[axis]) / log(canvas->most[axis] / canvas->least[axis]);
}

static struct patch patch_around(double x, double y, double half_width, double half_height) {
    return (struct patch){x - half_width, x + half_width, y - half_height, y + half_height};
}

static bool patches_meet(const struct patch *a, const struct patch *b) {
    return a->left < b->right && b->left < a->right && a->low < b->high && b->low < a->high;
}

/* True if the line along the front crosses the box. */
static bool front_crosses(const struct canvas *canvas, const struct patch *box) {
    enum { PARTS = 200 };
    for (int k = 0; k + 1 < canvas->fronts; k++) {
        const struct speed_row *a = canvas->front[k], *b = canvas->front[k + 1];
        double from[2] = {pixel(canvas, 0, a->seconds), pixel(canvas, 1, error_shown(canvas, a))};
        double to[2] = {pixel(canvas, 0, b->seconds), pixel(canvas, 1, error_shown(canvas, b))};
        for (int part = 0; part <= PARTS; part++) {
            double at = (double)part / PARTS, x = from[0] + at * (to[0] - from[0]),
                   y = from[1] + at * (to[1] - from[1]);
            if (x > box->left && x < box->right && y > box->low && y < box->high)
                return true;
        }
    }
    return false;
}

static bool patch_is_free(const struct canvas *canvas, const struct patch *box) {
    if (box->left < LEFT + 2 || box->right > RIGHT - 2 || box->low < BOTTOM + 2 || box->high > TOP - 2)
        return false;
    for (int k = 0; k < canvas->boxes; k++)
        if (patches_meet(box, &canvas->box[k]))
            return false;
    return !front_crosses(canvas, box);
}

static void patch_take(struct canvas *canvas, const struct patch *box) {
    if (canvas->boxes < BOXES_MAX)
        canvas->box[canvas->boxes++] = *box;
}

/* Sets the floor and the axes, with room around the points. */
static void canvas_frame(struct canvas *canvas) {
    const struct speed_report *report = canvas->report;
    canvas->floor = fmax(report->reference->floor, error_least);
    canvas->least[0] = INFINITY;
    canvas->most[0] = 0;
    canvas->most[1] = 3 * canvas->floor;
    for (int k = 0; k < report->rows; k++) {
        const struct speed_row *row = &report->row[k];
        if (!shown(row))
            continue;
        canvas->least[0] = fmin(canvas->least[0], row->seconds);
        canvas->most[0] = fmax(canvas->most[0], row->seconds);
        canvas->most[1] = fmax(canvas->most[1], row->judged);
    }
    double room = pow(canvas->most[0] / canvas->least[0], 0.06) * 1.05;
    canvas->least[0] /= room;
    canvas->most[0] *= room;
    room = pow(canvas->most[1] / canvas->floor, 0.06) * 1.1;
    canvas->least[1] = canvas->floor / pow(room, 1.5);
    canvas->most[1] *= room;
    for (int k = 0; k < report->rows; k++)
        if (shown(&report->row[k])) {
            struct patch point =
                patch_around(pixel(canvas, 0, report->row[k].seconds),
                             pixel(canvas, 1, error_shown(canvas, &report->row[k])), POINT, POINT);
            patch_take(canvas, &point);
        }
}

static void front_collect(struct canvas *canvas) {
    for (int k = 0; k < canvas->report->rows; k++) {
        const struct speed_row *row = &canvas->report->row[k];
        int at = canvas->fronts;
        if (!shown(row) || !row->on_front)
            continue;
        for (; at > 0 && canvas->front[at - 1]->seconds > row->seconds; at--)
            canvas->front[at] = canvas->front[at - 1];
        canvas->front[at] = row;
        canvas->fronts++;
    }
}

/* Finds the nearest free place for a text beside a point, on wider and wider rings. False if no place is
 * free. */
static bool place_find(const struct canvas *canvas, const struct speed_row *row, int rings,
                       struct place *place) {
    static const double side[SIDES][2] = {{1, 0.3}, {1, 1},   {1, -1}, {-1, 0.3},
                                          {-1, 1},  {-1, -1}, {0, 1},  {0, -1}};
    double x = pixel(canvas, 0, row->seconds), y = pixel(canvas, 1, error_shown(canvas, row));
    double half = letter / 2 * (double)strlen(row->variant.settings), high = (double)LINE / 2;
    for (int ring = 0; ring < rings; ring++)
        for (int k = 0; k < SIDES; k++) {
            double away = OFF + (double)LINE * ring;
            place->box =
                patch_around(x + side[k][0] * (half + away), y + side[k][1] * (high + away), half, high);
            place->far = ring > 0;
            if (patch_is_free(canvas, &place->box))
                return true;
        }
    return false;
}

static void quote(FILE *file, const char *text) {
    fputc('\'', file);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : (char[]){*text, 0}, file);
    fputc('\'', file);
}

static void label_write(FILE *file, const struct patch *box, const char *text, const char *colour) {
    fprintf(file, "set label ");
    quote(file, text);
    fprintf(file, " at screen %.5f,%.5f center noenhanced front font ',10' tc '%s'\n",
            (box->left + box->right) / 2 / WIDTH, (box->low + box->high) / 2 / HEIGHT, colour);
}

/* Writes a line from a point to the edge of its label. */
static void line_write(FILE *file, const struct canvas *canvas, const struct speed_row *row,
                       const struct patch *box) {
    double x = pixel(canvas, 0, row->seconds), y = pixel(canvas, 1, error_shown(canvas, row));
    fprintf(file, "set arrow from screen %.5f,%.5f to screen %.5f,%.5f nohead lc 'grey60' lw 0.7 back\n",
            x / WIDTH, y / HEIGHT, fmin(fmax(x, box->left), box->right) / WIDTH,
            fmin(fmax(y, box->low), box->high) / HEIGHT);
}

/* Writes the labels of the front, or the labels of other points if there is room near the point. */
static void labels_write(FILE *file, struct canvas *canvas, bool front) {
    for (int k = 0; k < canvas->report->rows; k++) {
        const struct speed_row *row = &canvas->report->row[k];
        struct place place;
        if (!shown(row) || row->on_front != front ||
            !place_find(canvas, row, front ? RINGS : RINGS_NEAR, &place))
            continue;
        patch_take(canvas, &place.box);
        label_write(file, &place.box, row->variant.settings, front ? "black" : "grey40");
        if (place.far)
            line_write(file, canvas, row, &place.box);
    }
}

/* Writes marks at 1, 2, 5 of each decade, more on a short axis and fewer on a long axis, and no mark too near
 * to the previous one. */
static void tics_write(FILE *file, const struct canvas *canvas, int axis) {
    double span = log10(canvas->most[axis] / canvas->least[axis]), apart = axis == 0 ? 52 : 20, last = -apart;
    const char *digits = span < 0.4 ? "123456789" : span < 1.3 ? "12357" : span < 2.5 ? "125" : "1";
    const char *comma = "";
    fprintf(file, "set %ctics (", "xy"[axis]);
    for (int power = (int)floor(log10(canvas->least[axis])); power <= log10(canvas->most[axis]); power++)
        for (const char *digit = digits; *digit; digit++) {
            double value = (*digit - '0') * pow(10, power), at = pixel(canvas, axis, value);
            if (value < canvas->least[axis] || value > canvas->most[axis] || at - last < apart)
                continue;
            fprintf(file, "%s'%.3g' %.6g", comma, value, value);
            comma = ", ";
            last = at;
        }
    fprintf(file, ")\n");
}

/* Writes the points of a group (NULL: of the front) as a block of data; returns whether there are any
 * points. */
static bool points_write(FILE *file, const struct canvas *canvas, const char *group) {
    bool any = false;
    for (int k = 0; k < canvas->report->rows; k++) {
        const struct speed_row *row = &canvas->report->row[k];
        if (!shown(row) || (group ? strcmp(row->variant.group, group) != 0 : !row->on_front))
            continue;
        if (!any)
            fprintf(file, "$%s << END\n", group ? group : "front");
        any = true;
        fprintf(file, "%.6g %.6g\n", row->seconds, error_shown(canvas, row));
    }
    if (any)
        fprintf(file, "END\n");
    return any;
}

static void frame_write(FILE *file, struct canvas *canvas) {
    fprintf(file,
            "set terminal svg size %d,%d font 'sans,12' background 'white'\nset output 'speed_error.svg'\n",
            WIDTH, HEIGHT);
    fprintf(file,
            "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset bmargin at screen %.5f\n"
            "set tmargin at screen %.5f\n",
            (double)LEFT / WIDTH, (double)RIGHT / WIDTH, (double)BOTTOM / HEIGHT, (double)TOP / HEIGHT);
    fprintf(file, "set logscale xy\nset xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n", canvas->least[0],
            canvas->most[0], canvas->least[1], canvas->most[1]);
    tics_write(file, canvas, 0);
    tics_write(file, canvas, 1);
    fprintf(file, "set xlabel 'time of a run, s'\nset ylabel 'error of what is judged, relative' offset 1,0\n"
                  "set key outside right samplen 1 width -2\nset grid\n");
    fprintf(
        file,
        "set object 1 rectangle from graph 0,0 to graph 1,first %.6g fc '#eeeeee' fs solid noborder behind\n",
        canvas->floor);
    double half = letter / 2 * (double)strlen(below);
    struct patch box = patch_around(RIGHT - half - 6, (BOTTOM + pixel(canvas, 1, canvas->floor)) / 2, half,
                                    (double)LINE / 2);
    label_write(file, &box, below, "grey40");
    struct patch strip = {LEFT, RIGHT, BOTTOM, pixel(canvas, 1, canvas->floor) + 2};
    patch_take(canvas, &strip);
}

static bool group_shown(const struct speed_report *report, const char *group) {
    for (int k = 0; k < report->rows; k++)
        if (shown(&report->row[k]) && strcmp(report->row[k].variant.group, group) == 0)
            return true;
    return false;
}

static void plot_write(FILE *file, struct canvas *canvas) {
    const struct speed_report *report = canvas->report;
    frame_write(file, canvas);
    labels_write(file, canvas, true);
    labels_write(file, canvas, false);
    bool front = points_write(file, canvas, NULL);
    for (int k = 0; k < report->rows; k++)
        if (speed_row_opens_group(report->row, k))
            points_write(file, canvas, report->row[k].variant.group);
    fprintf(file, "plot %.6g with lines dt 2 lc 'grey40' title 'floor'", canvas->floor);
    if (front)
        fprintf(file, ", \\\n  $front using 1:2 smooth unique with linespoints pt 6 ps 2 lw 2 lc 'black' "
                      "title 'front'");
    for (int k = 0, groups = 0; k < report->rows; k++) {
        const char *group = report->row[k].variant.group;
        if (!speed_row_opens_group(report->row, k) || !group_shown(report, group))
            continue;
        fprintf(file, ", \\\n  $%s using 1:2 with points pt %d ps 0.7 lc %d title '%s'", group,
                groups < COLOURS ? 7 : 5, groups + 1, group);
        groups++;
    }
    fprintf(file, "\n");
}

/* Runs gnuplot on the script in the folder; a gnuplot that is missing, or fails, gives a message, and is no failure. */
static void plot_run(const char *directory, const char *script) {
    static const char *const command[] = {"gnuplot", "speed_error.gp", NULL};
    struct error failed = {0};
    if (!program_run(command, directory, NULL, "gnuplot-nox", &failed))
        fprintf(stderr, "scree: warning: there is no plot from %s: %s\n", script, failed.text);
}

bool speed_plot(const struct speed_report *report, const char *directory, struct error *error) {
    char path[FILE_PATH_MAX];
    struct canvas canvas = {.report = report};
    bool any = false;
    for (int k = 0; k < report->rows; k++)
        any = any || shown(&report->row[k]);
    if (!any)
        return true;
    snprintf(path, sizeof path, "%s/speed_error.gp", directory);
    FILE *file = fopen(path, "w");
    if (file == NULL)
        return error_set_errno(error, "%s", path);
    canvas_frame(&canvas);
    front_collect(&canvas);
    plot_write(file, &canvas);
    if (fclose(file) != 0)
        return error_set_errno(error, "%s", path);
    plot_run(directory, path);
    return true;
}
