/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes a picture for POV-Ray. Read paint.h first. */
#include "front/picture/paint.h"

#include <math.h>
#include <string.h>

enum { STOPS_MAX = 8 };

static const struct {
    const char *name;
    int stops;
    double stop[STOPS_MAX][3];
} palettes[] = {
    {"scree",
     6,
     {{38, 70, 83}, {38, 110, 123}, {42, 157, 143}, {233, 196, 106}, {244, 162, 97}, {231, 111, 81}}},
    {"viridis",
     7,
     {{68, 1, 84},
      {68, 57, 131},
      {49, 104, 142},
      {33, 145, 140},
      {53, 183, 121},
      {144, 215, 67},
      {253, 231, 37}}},
    {"grey", 2, {{60, 60, 64}, {235, 235, 232}}},
};
enum { PALETTES = sizeof palettes / sizeof palettes[0] };

bool paint_bands(struct paint *paint, const char *palette, int bands, struct error *error) {
    int p = 0;
    while (palette && p < PALETTES && strcmp(palettes[p].name, palette) != 0)
        p++;
    if (p == PALETTES)
        return error_set(error, ERROR_USER, "command line: --palette %s: known are scree, viridis, grey",
                         palette);
    paint->bands = bands;
    for (int k = 0; k < bands; k++) {
        double at = bands > 1 ? (double)k / (bands - 1) * (palettes[p].stops - 1) : 0;
        int stop = at < palettes[p].stops - 1 ? (int)at : palettes[p].stops - 2;
        for (int d = 0; d < 3; d++)
            paint->band[k][d] = palettes[p].stop[stop][d] +
                                (at - stop) * (palettes[p].stop[stop + 1][d] - palettes[p].stop[stop][d]);
    }
    return true;
}

int paint_band(const struct paint *paint, double value) {
    if (isnan(value))
        return PAINT_GREY;
    double part = paint->high > paint->low ? (value - paint->low) / (paint->high - paint->low) : 0.5;
    int band = (int)(fmin(fmax(part, 0), 1) * paint->bands);
    return band < paint->bands ? band : paint->bands - 1;
}

static void write_head(FILE *out, const struct paint_scene *scene) {
    const struct camera *c = scene->camera;
    const struct paint *paint = scene->paint;
    double d = c->distance;
    fprintf(out, "// made by scree picture: povray +I... +W%d +H%d +A\n#version 3.7;\n", c->width, c->height);
    fprintf(
        out,
        "global_settings { assumed_gamma 1 max_trace_level 20 }\nbackground { srgb <251,250,247>/255 }\n");
    fprintf(out, "camera { perspective location 0 direction z right %g*x up %g*y }\n", 2 * c->tangent[0],
            2 * c->tangent[1]);
    fprintf(out, "light_source { <%g,%g,%g> rgb 0.95%s }\n", -0.6 * d, 1.1 * d, 0.05 * d,
            scene->soft ? " area_light <30,0,0>, <0,0,30>, 4, 4 adaptive 0 jitter circular orient" : "");
    fprintf(out, "light_source { <%g,%g,%g> rgb 0.4 shadowless }\n", 0.6 * d, 0.35 * d, -0.3 * d);
    fprintf(out, "#declare F = finish { ambient 0 diffuse 0.75 specular 0.25 roughness 0.03 emission 0.08 }\n"
                 "#declare L = finish { ambient 0 diffuse 0 emission 1 }\n"
                 "#declare G = texture { pigment { srgb <150,155,165>/255 } finish { F } }\n"
                 "#declare P = texture { pigment { srgb <0.93,0.92,0.89> } finish { ambient 0 diffuse 0.62 "
                 "emission 0.2 } }\n"
                 "#declare W = texture { pigment { srgbt <0.55,0.60,0.68,0.6> } finish { ambient 0 diffuse "
                 "0.5 emission 0.3 } }\n"
                 "#declare K = texture { pigment { srgb <0.2,0.2,0.22> } finish { L } }\n");
    for (int k = 0; k < paint->bands; k++)
        fprintf(out, "#declare C%d = texture { pigment { srgb <%.0f,%.0f,%.0f>/255 } finish { F } }\n", k,
                paint->band[k][0], paint->band[k][1], paint->band[k][2]);
}

static void write_spheres(FILE *out, const struct paint_scene *scene) {
    facets_declare(out, scene->facets);
    for (size_t k = 0; k < scene->rows->count; k++) {
        double at[3];
        if (scene->band[k] < PAINT_GREY)
            continue;
        camera_place(scene->camera, scene->rows->position[k], at);
        if (!facets_write(out, scene->facets, scene->camera, scene->rows, k))
            fprintf(out, "sphere{<%.6g,%.6g,%.6g>%.6g ", at[0], at[1], at[2],
                    scene->rows->radius[k] * scene->camera->scale);
        if (scene->band[k] == PAINT_GREY)
            fprintf(out, "texture{G}}\n");
        else
            fprintf(out, "texture{C%d}}\n", scene->band[k]);
    }
}

static void write_point(FILE *out, const struct camera *camera, const double x[3]) {
    double at[3];
    camera_place(camera, x, at);
    fprintf(out, "<%.7g,%.7g,%.7g>", at[0], at[1], at[2]);
}

static double along(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* True if the plane of a triangle lies between the camera and the middle of what the camera sees. */
static bool is_before(const struct camera *camera, const double triangle[9]) {
    double at[3][3], side[2][3], normal[3], middle[3], centre[3];
    for (int c = 0; c < 3; c++) {
        camera_place(camera, triangle + 3 * c, at[c]);
        centre[c] = 0.5 * (camera->lower[c] + camera->upper[c]);
    }
    camera_place(camera, centre, middle);
    for (int d = 0; d < 3; d++) {
        side[0][d] = at[1][d] - at[0][d];
        side[1][d] = at[2][d] - at[0][d];
        middle[d] -= at[0][d];
    }
    for (int d = 0; d < 3; d++)
        normal[d] = side[0][(d + 1) % 3] * side[1][(d + 2) % 3] - side[0][(d + 2) % 3] * side[1][(d + 1) % 3];
    return along(normal, middle) * along(normal, at[0]) > 0;
}

/* The middle of a tube, and the direction across its axis that leads from the camera, of unit length; 0 if the camera looks along it. */
static void place_tube(const struct camera *camera, const struct shape_tube *tube, double middle[3],
                       double away[3]) {
    double axis[3], end[2][3];
    for (int e = 0; e < 2; e++)
        camera_place(camera, tube->end[e], end[e]);
    for (int d = 0; d < 3; d++) {
        middle[d] = 0.5 * (end[0][d] + end[1][d]);
        axis[d] = end[1][d] - end[0][d];
    }
    double part = along(middle, axis) / along(axis, axis);
    for (int d = 0; d < 3; d++)
        away[d] = middle[d] - part * axis[d];
    double length = sqrt(along(away, away));
    for (int d = 0; d < 3; d++)
        away[d] = length > 0 ? away[d] / length : 0;
}

static void write_walls(FILE *out, const struct camera *camera, const struct shapes *shapes) {
    for (int k = 0; k < shapes->planes; k++) {
        const struct shape_plane *plane = &shapes->plane[k];
        if (plane->corners < 3 || !camera_faces(camera, plane->corner[0], plane->normal))
            continue;
        fprintf(out, "union{");
        for (int c = 2; c < plane->corners; c++) {
            fprintf(out, "triangle{");
            write_point(out, camera, plane->corner[0]);
            fprintf(out, ",");
            write_point(out, camera, plane->corner[c - 1]);
            fprintf(out, ",");
            write_point(out, camera, plane->corner[c]);
            fprintf(out, "}");
        }
        fprintf(out, " texture{P}}\n");
    }
    for (int k = 0; k < shapes->tubes; k++) {
        double middle[3], axis[3];
        place_tube(camera, &shapes->tube[k], middle, axis);
        bool clipped = along(axis, axis) > 0;
        fprintf(out, "cylinder{");
        write_point(out, camera, shapes->tube[k].end[0]);
        fprintf(out, ",");
        write_point(out, camera, shapes->tube[k].end[1]);
        fprintf(out, ",%.7g open texture{W} no_shadow", shapes->tube[k].radius * camera->scale);
        if (clipped)
            fprintf(out, " clipped_by{plane{<%.7g,%.7g,%.7g>,%.7g}}", -axis[0], -axis[1], -axis[2],
                    -along(axis, middle));
        fprintf(out, "}\n");
    }
    size_t seen = 0;
    for (size_t k = 0; k < shapes->triangles; k++) {
        if (is_before(camera, shapes->triangle[k]))
            continue;
        fprintf(out, "%striangle{", seen++ == 0 ? "mesh{\n" : "");
        for (int c = 0; c < 3; c++) {
            write_point(out, camera, shapes->triangle[k] + 3 * c);
            fprintf(out, "%s", c < 2 ? "," : "}\n");
        }
    }
    if (seen > 0)
        fprintf(out, "texture{W} no_shadow}\n");
}

/* Writes a text, its left end at x, its middle at y, in units of half the height of the picture. */
static void write_text(FILE *out, const struct camera *camera, const char *text, double x, double y) {
    double unit = camera->tangent[1], size = 0.065 * unit;
    fprintf(out, "text{internal 2 \"");
    for (; *text; text++)
        fprintf(out, "%s%c", *text == '"' || *text == '\\' ? "\\" : "", *text);
    fprintf(out, "\" 0.01,0 scale %g translate <%g,%g,1> texture{K} no_shadow}\n", size, x,
            y * unit - 0.32 * size);
}

static void write_legend(FILE *out, const struct camera *camera, const struct paint *paint) {
    double x = 0.76 * camera->tangent[0], width = 0.045 * camera->tangent[1], unit = camera->tangent[1];
    double step = 1.0 / paint->bands, text = x + 1.5 * width;
    for (int k = 0; k < paint->bands; k++)
        fprintf(out, "box{<%g,%g,1>,<%g,%g,1.001> pigment{srgb <%.0f,%.0f,%.0f>/255} finish{L} no_shadow}\n",
                x, unit * (k * step - 0.5), x + width, unit * ((k + 1) * step - 0.5), paint->band[k][0],
                paint->band[k][1], paint->band[k][2]);
    double wide = 0.55 * 0.065 * unit * (double)strlen(paint->label);
    double last = 0.97 * camera->tangent[0] - wide;
    write_text(out, camera, paint->label, last < x ? last : x, 0.58);
    if (paint->names > 0) {
        for (int k = 0; k < paint->bands; k++)
            write_text(out, camera, paint->name[k], text, (k + 0.5) * step - 0.5);
        return;
    }
    for (int k = 0; k <= 4; k++) {
        char number[32];
        double value = paint->low + 0.25 * k * (paint->high - paint->low);
        double tiny = 1e-9 * (fabs(paint->low) + fabs(paint->high));
        snprintf(number, sizeof number, "%.3g", fabs(value) < tiny ? 0.0 : value);
        write_text(out, camera, number, text, 0.25 * k - 0.5);
    }
}

void paint_write(FILE *out, const struct paint_scene *scene) {
    write_head(out, scene);
    write_spheres(out, scene);
    if (scene->shapes)
        write_walls(out, scene->camera, scene->shapes);
    if (scene->camera->legend)
        write_legend(out, scene->camera, scene->paint);
}
