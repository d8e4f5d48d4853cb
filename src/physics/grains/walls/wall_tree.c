/* SPDX-License-Identifier: BSD-3-Clause */
/* A tree that halves the triangles along the longest side of their box. Read wall_tree.h first. */
#include "physics/grains/walls/wall_tree.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>

enum { LEAF = 4 };

/* Nodes lie one after another, each before those below it; the first child is the next one. */
struct node {
    double lower[3], upper[3];
    int32_t second;       /* number of the second child */
    int32_t first, count; /* of a leaf: its triangles; count 0: no leaf */
};

struct wall_tree {
    const struct wall_mesh *mesh;
    int32_t nodes;
    struct node *node;
    int32_t *triangle;
};

/* A triangle with the middle of its box along the direction of a cut. */
struct place {
    double middle;
    int32_t triangle;
};

static void store(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

/* Points of a triangle lie within the tolerance of its corners' plane. */
static void box_add(struct node *node, const struct wall_mesh *mesh, int32_t t) {
    for (int c = 0; c < 3; c++) {
        double x[3];
        store(x, mesh->triangle[t].corner[c]);
        for (int d = 0; d < 3; d++) {
            node->lower[d] = fmin(node->lower[d], x[d] - 2.0 * mesh->tolerance);
            node->upper[d] = fmax(node->upper[d], x[d] + 2.0 * mesh->tolerance);
        }
    }
}

static int place_compare(const void *a, const void *b) {
    const struct place *x = a, *y = b;
    if (x->middle != y->middle)
        return x->middle < y->middle ? -1 : 1;
    return x->triangle < y->triangle ? -1 : 1;
}

static double middle_of(const struct wall_mesh *mesh, int32_t t, int d) {
    double x[3][3];
    for (int c = 0; c < 3; c++)
        store(x[c], mesh->triangle[t].corner[c]);
    return fmin(fmin(x[0][d], x[1][d]), x[2][d]) + fmax(fmax(x[0][d], x[1][d]), x[2][d]);
}

/* Makes the node of a range of triangles and those below. */
static void grow(struct wall_tree *tree, struct place *place, int32_t first, int32_t count) {
    struct node *node = &tree->node[tree->nodes++];
    int longest = 0;
    *node = (struct node){.lower = {INFINITY, INFINITY, INFINITY},
                          .upper = {-INFINITY, -INFINITY, -INFINITY},
                          .first = first,
                          .count = count};
    for (int32_t k = 0; k < count; k++)
        box_add(node, tree->mesh, place[k].triangle);
    for (int d = 1; d < 3; d++)
        if (node->upper[d] - node->lower[d] > node->upper[longest] - node->lower[longest])
            longest = d;
    if (count <= LEAF) {
        for (int32_t k = 0; k < count; k++)
            tree->triangle[first + k] = place[k].triangle;
        return;
    }
    for (int32_t k = 0; k < count; k++)
        place[k].middle = middle_of(tree->mesh, place[k].triangle, longest);
    qsort(place, (size_t)count, sizeof *place, place_compare);
    int32_t half = count / 2;
    node->count = 0;
    grow(tree, place, first, half);
    node->second = tree->nodes;
    grow(tree, place + half, first + half, count - half);
}

struct wall_tree *wall_tree_create(const struct wall_mesh *mesh) {
    struct wall_tree *tree = memory_allocate_zero(1, sizeof *tree, "tree of a mesh");
    size_t count = mesh->triangles;
    struct place *place = memory_allocate(count, sizeof *place, "tree of a mesh");
    tree->mesh = mesh;
    tree->node = memory_allocate(2 * count, sizeof *tree->node, "tree of a mesh");
    tree->triangle = memory_allocate(count, sizeof *tree->triangle, "tree of a mesh");
    for (size_t t = 0; t < count; t++)
        place[t].triangle = (int32_t)t;
    grow(tree, place, 0, (int32_t)count);
    memory_free(place);
    return tree;
}

void wall_tree_destroy(struct wall_tree **tree) {
    if (*tree == NULL)
        return;
    memory_free((*tree)->node);
    memory_free((*tree)->triangle);
    memory_free(*tree);
    *tree = NULL;
}

/* The distance of a place from a box. */
static double box_distance(const struct node *node, const double x[3]) {
    double square = 0.0;
    for (int d = 0; d < 3; d++) {
        double out = law_max(0.0, law_max(node->lower[d] - x[d], x[d] - node->upper[d]));
        square += out * out;
    }
    return sqrt(square);
}

/* Looks for what is nearer than near->distance. */
static void look(const struct wall_tree *tree, int32_t number, struct law_vector x,
                 struct wall_nearest *near) {
    const struct node *node = &tree->node[number];
    double at[3];
    store(at, x);
    for (int32_t k = node->first; k < node->first + node->count; k++) {
        struct wall_nearest one = wall_touch_nearest(tree->mesh, tree->triangle[k], x, near->distance);
        if (one.distance < near->distance)
            *near = one;
    }
    if (node->count > 0)
        return;
    int32_t child[2] = {number + 1, node->second};
    double away[2] = {box_distance(&tree->node[child[0]], at), box_distance(&tree->node[child[1]], at)};
    int nearer = away[1] < away[0];
    if (away[nearer] < near->distance)
        look(tree, child[nearer], x, near);
    if (away[1 - nearer] < near->distance)
        look(tree, child[1 - nearer], x, near);
}

bool wall_tree_nearest(const struct wall_tree *tree, struct law_vector x, double reach,
                       struct wall_nearest *near) {
    *near = (struct wall_nearest){.triangle = -1, .distance = reach};
    look(tree, 0, x, near);
    return near->triangle >= 0;
}
