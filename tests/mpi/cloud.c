/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the cloud, and the value that each field of each particle must have. Read cloud.h first. */
#include "cloud.h"

#include "base/memory.h"
#include "base/random.h"
#include "kernel/particles/fields.h"
#include "kernel/pairs/classes_choose.h"

#include <math.h>
#include <string.h>

static double shortest_edge(const struct box *box) {
    double edge = fmin(box->edge[0], box->edge[1]);
    return box->dimension == 3 ? fmin(edge, box->edge[2]) : edge;
}

static double draw_radius(const struct box *box, enum cloud_radii radii, size_t k, double u) {
    double unit = shortest_edge(box);
    switch (radii) {
    case CLOUD_EQUAL:
        return 0.04 * unit;
    case CLOUD_BIDISPERSE:
        return k % 20 == 0 ? 0.15 * unit : 0.015 * unit;
    case CLOUD_CONTINUOUS:
        return 0.005 * unit * pow(30, u);
    case CLOUD_BOULDERS:
        return k == 0 ? 0.42 * unit : k == 1 ? 0.45 * unit : 0.01 * unit * (1 + u);
    }
    return 0;
}

void cloud_scatter(struct cloud *cloud, uint64_t seed) {
    const struct box *box = &cloud->box;
    for (size_t k = 0; k < cloud->n; k++) {
        struct random_sequence sequence = random_sequence(seed, RANDOM_POSITION, k);
        for (int d = 0; d < 3; d++) {
            double u = random_uniform(&sequence);
            if (!box->periodic[d] && k % 16 == 0)
                u = 1.6 * u - 0.3;
            cloud->x[k][d] = d == 2 && box->dimension == 2 ? 0.5 * box->edge[d] : u * box->edge[d];
        }
    }
}

void cloud_make(struct cloud *cloud, const struct box *box, enum cloud_radii radii, size_t n, uint64_t seed) {
    cloud->n = n;
    cloud->box = *box;
    cloud->x = memory_allocate(n, sizeof *cloud->x, "cloud");
    cloud->radius = memory_allocate(n, sizeof(double), "cloud");
    double *sorted = memory_allocate(n, sizeof(double), "cloud");
    for (size_t k = 0; k < n; k++) {
        struct random_sequence sequence = random_sequence(seed, RANDOM_RADIUS, k);
        cloud->radius[k] = draw_radius(box, radii, k, random_uniform(&sequence));
        sorted[k] = cloud->radius[k];
    }
    double least = INFINITY, most = 0;
    for (size_t k = 0; k < n; k++) {
        least = fmin(least, sorted[k]);
        most = fmax(most, sorted[k]);
    }
    struct classes_options options = classes_options_default();
    options.method = CLASSES_GEOMETRIC;
    options.count = (int)fmax(1, ceil(log2(most / least) - 1e-9));
    options.skin_relative = 0.1; /* boulders with their skin must fit into the box */
    struct error error = {0};
    if (!classes_choose(&cloud->classes, &options, NULL, sorted, n, &error))
        error_fatal("%s", error.text);
    memory_free(sorted);
    cloud_scatter(cloud, seed);
}

void cloud_free(struct cloud *cloud) {
    memory_free(cloud->x);
    memory_free(cloud->radius);
}

int cloud_code(const char *name) {
    unsigned code = 0;
    while (*name)
        code = (code * 31 + (unsigned char)*name++) & 0xfffff;
    return (int)code;
}

double cloud_value(int64_t id, int code, int component, unsigned stamp) {
    uint64_t item = ((uint64_t)id << 20) + (uint64_t)code;
    struct random_sequence sequence = random_sequence(stamp, RANDOM_TEST, item);
    sequence.draw = (uint32_t)component;
    return floor(200 * random_uniform(&sequence));
}

bool cloud_stamped(const struct field *field) {
    const char *name = field->name;
    return strcmp(name, "position") != 0 && strcmp(name, "radius") != 0 && strcmp(name, "id") != 0 &&
           strcmp(name, "size_class") != 0;
}

static char *component_of(const struct particles *particles, int field, int component, size_t i) {
    const struct field *row = fields_get(particles, field);
    size_t stride, bytes = fields_bytes(row) / (size_t)row->components;
    char *base = fields_base(particles, field, &stride);
    return base + i * stride + (size_t)component * bytes;
}

double cloud_get(const struct particles *particles, int field, int component, size_t i) {
    const void *at = component_of(particles, field, component, i);
    switch (fields_get(particles, field)->type) {
    case FIELD_DOUBLE:
        return *(const double *)at;
    case FIELD_INT64:
        return (double)*(const int64_t *)at;
    case FIELD_INT32:
        return *(const int32_t *)at;
    case FIELD_UINT8:
        return *(const uint8_t *)at;
    }
    return NAN;
}

void cloud_set(struct particles *particles, int field, int component, size_t i, double value) {
    void *at = component_of(particles, field, component, i);
    switch (fields_get(particles, field)->type) {
    case FIELD_DOUBLE:
        *(double *)at = value;
        break;
    case FIELD_INT64:
        *(int64_t *)at = (int64_t)value;
        break;
    case FIELD_INT32:
        *(int32_t *)at = (int32_t)value;
        break;
    case FIELD_UINT8:
        *(uint8_t *)at = (uint8_t)value;
        break;
    }
}

void cloud_append(const struct cloud *cloud, size_t k, unsigned stamp, struct particles *particles) {
    size_t i = particles_append(particles);
    for (int f = 0; f < fields_count(particles); f++) {
        const struct field *field = fields_get(particles, f);
        for (int c = 0; cloud_stamped(field) && c < field->components; c++)
            cloud_set(particles, f, c, i, cloud_value((int64_t)k + 1, cloud_code(field->name), c, stamp));
    }
    memcpy(particles->state[i].x, cloud->x[k], sizeof cloud->x[k]);
    particles->state[i].radius = cloud->radius[k];
    particles->id[i] = (int64_t)k + 1;
}
