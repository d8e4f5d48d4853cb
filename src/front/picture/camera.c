/* SPDX-License-Identifier: BSD-3-Clause */
/* Direction, scale and distance of the camera. Read camera.h first. */
#include "front/picture/camera.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double half_angle = 0.21, margin = 1.05, legend_room = 0.13;

static bool read_size(struct camera *camera, const char *size, struct error *error) {
    char end;
    camera->width = 1280;
    camera->height = 960;
    if (size && (sscanf(size, "%dx%d%c", &camera->width, &camera->height, &end) != 2 || camera->width < 16 ||
                 camera->height < 16 || camera->width > 16384 || camera->height > 16384))
        return error_set(error, ERROR_USER,
                         "command line: --size %s: must be WIDTHxHEIGHT in pixels, from 16x16 to 16384x16384",
                         size);
    bool wide = camera->width > camera->height;
    double ratio = (double)camera->width / camera->height;
    camera->tangent[0] = wide ? tan(half_angle) : tan(half_angle) * ratio;
    camera->tangent[1] = wide ? tan(half_angle) / ratio : tan(half_angle);
    return true;
}

bool camera_aim(struct camera *camera, const char *size, const char *view, int dimension,
                struct error *error) {
    static const struct {
        const char *name;
        double azimuth, elevation;
    } views[] = {{"corner", 30, 22}, {"front", 0, 0},  {"right", 90, 0},
                 {"back", 180, 0},   {"left", 270, 0}, {"top", 0, 90}};
    const char *wanted = view ? view : dimension == 2 ? "top" : "corner";
    double azimuth = NAN, elevation = NAN;
    char end;
    *camera = (struct camera){0};
    if (!read_size(camera, size, error))
        return false;
    for (size_t k = 0; k < sizeof views / sizeof views[0]; k++)
        if (strcmp(views[k].name, wanted) == 0) {
            azimuth = views[k].azimuth;
            elevation = views[k].elevation;
        }
    if (isnan(azimuth) && (sscanf(wanted, "%lf,%lf%c", &azimuth, &elevation, &end) != 2 ||
                           !isfinite(azimuth) || !(fabs(elevation) <= 90)))
        return error_set(error, ERROR_USER,
                         "command line: --view %s: must be corner, front, right, back, left, top, or "
                         "AZIMUTH,ELEVATION in degrees, elevation from -90 to 90",
                         wanted);
    double a = azimuth * M_PI / 180, e = elevation * M_PI / 180;
    double right[3] = {cos(a), sin(a), 0}, forward[3] = {-sin(a) * cos(e), cos(a) * cos(e), -sin(e)};
    for (int d = 0; d < 3; d++) {
        int n = (d + 1) % 3, m = (d + 2) % 3;
        camera->axis[0][d] = right[d];
        camera->axis[1][d] = right[n] * forward[m] - right[m] * forward[n];
        camera->axis[2][d] = forward[d];
        camera->lower[d] = camera->low[d] = INFINITY;
        camera->upper[d] = camera->high[d] = -INFINITY;
    }
    return true;
}

static double along(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void camera_include(struct camera *camera, const double x[3], double radius) {
    for (int d = 0; d < 3; d++) {
        double at = along(camera->axis[d], x);
        camera->lower[d] = fmin(camera->lower[d], x[d] - radius);
        camera->upper[d] = fmax(camera->upper[d], x[d] + radius);
        camera->low[d] = fmin(camera->low[d], at - radius);
        camera->high[d] = fmax(camera->high[d], at + radius);
    }
}

void camera_settle(struct camera *camera) {
    double half[3], largest = 0;
    for (int d = 0; d < 3; d++) {
        half[d] = 0.5 * (camera->high[d] - camera->low[d]);
        largest = fmax(largest, half[d]);
    }
    camera->scale = largest > 0 ? CAMERA_SIZE / largest : 1;
    double room = camera->legend ? 1 - legend_room : 1;
    double across = half[0] / (camera->tangent[0] * room), up = half[1] / camera->tangent[1];
    camera->distance = camera->scale * (margin * fmax(across, up) + half[2]);
}

void camera_place(const struct camera *camera, const double x[3], double place[3]) {
    for (int d = 0; d < 3; d++)
        place[d] = camera->scale * (along(camera->axis[d], x) - 0.5 * (camera->low[d] + camera->high[d]));
    place[2] += camera->distance;
    if (camera->legend)
        place[0] -= legend_room * camera->tangent[0] * camera->distance;
}

bool camera_faces(const struct camera *camera, const double x[3], const double normal[3]) {
    double place[3], towards = 0;
    camera_place(camera, x, place);
    for (int d = 0; d < 3; d++)
        towards -= place[d] * along(camera->axis[d], normal);
    return towards > 0;
}
