/* SPDX-License-Identifier: BSD-3-Clause */
/* Meshes for tests, written as tables. Include after walls_by_hand.h. */
#ifndef SCREE_TESTS_MESH_BY_HAND_H
#define SCREE_TESTS_MESH_BY_HAND_H

#include "tests/physics/grains/walls/walls_by_hand.h"

enum { HAND_TEXT = 1 << 20 };

struct hand_text {
    char *text;
    size_t size;
};

static inline struct hand_text text_new(void) {
    return (struct hand_text){.text = memory_allocate(HAND_TEXT, 1, "test mesh")};
}

static inline void text_triangle(struct hand_text *t, const double a[3], const double b[3],
                                 const double c[3]) {
    t->size += (size_t)snprintf(t->text + t->size, HAND_TEXT - t->size,
                                "%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", a[0], a[1], a[2],
                                b[0], b[1], b[2], c[0], c[1], c[2]);
    assert_true(t->size < HAND_TEXT - 1);
}

/* o + u a + v b */
static inline void corner(double out[3], const double o[3], const double a[3], double u, const double b[3],
                          double v) {
    for (int d = 0; d < 3; d++)
        out[d] = o[d] + u * a[d] + v * b[d];
}

/* The parallelogram at o with sides a and b, in n x m pieces of two triangles; inner corners of the division
 * are moved within the plane by up to `jitter` of a piece. */
static inline void text_plate(struct hand_text *t, const double o[3], const double a[3], const double b[3],
                              int n, int m, double jitter) {
    unsigned seed = 7;
    double(*grid)[3] = memory_allocate((size_t)((n + 1) * (m + 1)), sizeof *grid, "test mesh");
    for (int j = 0; j <= m; j++)
        for (int i = 0; i <= n; i++) {
            double du = jitter * (hand_random(&seed) - 0.5), dv = jitter * (hand_random(&seed) - 0.5);
            bool inner = i > 0 && i < n && j > 0 && j < m;
            corner(grid[j * (n + 1) + i], o, a, (i + (inner ? du : 0.0)) / n, b,
                   (j + (inner ? dv : 0.0)) / m);
        }
    for (int j = 0; j < m; j++)
        for (int i = 0; i < n; i++) {
            double(*p)[3] = grid + j * (n + 1) + i, (*q)[3] = p + n + 1;
            bool flip = (i * 7 + j * 3) % 2;
            text_triangle(t, p[0], p[1], flip ? q[0] : q[1]);
            text_triangle(t, flip ? p[1] : p[0], q[1], q[0]); /* orientation does not matter */
        }
    memory_free(grid);
}

/* The six sides of the cube from `low` to `high`, each in n x n pieces. */
static inline void text_cube(struct hand_text *t, double low, double high, int n) {
    double edge = high - low, o[3] = {low, low, low}, far[3] = {high, high, high};
    for (int d = 0; d < 3; d++) {
        double a[3] = {0}, b[3] = {0};
        a[(d + 1) % 3] = edge;
        b[(d + 2) % 3] = edge;
        text_plate(t, o, a, b, n, n, 0.5);
        a[(d + 1) % 3] = b[(d + 2) % 3] = -edge;
        text_plate(t, far, a, b, n, n, 0.5);
    }
}

/* Writes the mesh to a file and frees the text. */
static inline const char *text_file(struct hand_text *t, char path[64], const char *name) {
    hand_file(path, name, t->text, t->size);
    memory_free(t->text);
    return path;
}

#endif
