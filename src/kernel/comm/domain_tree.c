/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the tree of cuts and searches in the tree. Read domain_tree.h first. */
#include "kernel/comm/domain_tree.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

static struct domain_tree *tree_create(int ranks) {
    struct domain_tree *tree = memory_allocate_zero(1, sizeof *tree, "cut tree");
    tree->ranks = ranks;
    tree->cut = memory_allocate((size_t)ranks - 1, sizeof *tree->cut, "cut tree");
    return tree;
}

void domain_tree_destroy(struct domain_tree **tree) {
    if (*tree == NULL)
        return;
    memory_free((*tree)->cut);
    memory_free(*tree);
    *tree = NULL;
}

/* A node during a descent of the tree: position in the array, ranks, corners. */
struct node {
    int at, first, last;
    double lower[3], upper[3];
};

static struct node node_root(const struct domain_tree *tree, const double lower[3], const double upper[3]) {
    struct node node = {.first = 0, .last = tree->ranks};
    memcpy(node.lower, lower, sizeof node.lower);
    memcpy(node.upper, upper, sizeof node.upper);
    return node;
}

static bool node_is_leaf(const struct node *node) {
    return node->last - node->first == 1;
}

static struct node node_child(const struct domain_tree *tree, const struct node *node, bool above) {
    const struct domain_cut *cut = &tree->cut[node->at];
    struct node child = *node;
    if (above) {
        child.at = node->at + cut->middle - node->first;
        child.first = cut->middle;
        child.lower[cut->axis] = cut->at;
    } else {
        child.at = node->at + 1;
        child.last = cut->middle;
        child.upper[cut->axis] = cut->at;
    }
    return child;
}

/* True if the cuts of a node and of all nodes below lie inside the node and divide the ranks of the node. */
static bool node_divides(const struct domain_tree *tree, const struct node *node) {
    if (node_is_leaf(node))
        return true;
    const struct domain_cut *cut = &tree->cut[node->at];
    if (cut->middle <= node->first || cut->middle >= node->last || cut->axis < 0 || cut->axis > 2 ||
        !(cut->at >= node->lower[cut->axis] && cut->at <= node->upper[cut->axis]))
        return false;
    struct node lower = node_child(tree, node, false), upper = node_child(tree, node, true);
    return node_divides(tree, &lower) && node_divides(tree, &upper);
}

struct domain_tree *domain_tree_from_cuts(int ranks, const struct domain_cut *cut, const double lower[3],
                                          const double upper[3]) {
    struct domain_tree *tree = tree_create(ranks);
    struct node root = node_root(tree, lower, upper);
    memcpy(tree->cut, cut, ((size_t)ranks - 1) * sizeof *cut);
    if (!node_divides(tree, &root))
        domain_tree_destroy(&tree);
    return tree;
}

static void halve(struct domain_tree *tree, const struct node *node, int dimension) {
    if (node_is_leaf(node))
        return;
    int axis = 0, ranks = node->last - node->first;
    for (int d = 1; d < dimension; d++)
        if (node->upper[d] - node->lower[d] > (node->upper[axis] - node->lower[axis]) * (1 + 1e-12))
            axis = d;
    struct domain_cut *cut = &tree->cut[node->at];
    cut->axis = axis;
    cut->middle = node->first + ranks / 2;
    cut->at = node->lower[axis] + (node->upper[axis] - node->lower[axis]) * (ranks / 2) / ranks;
    for (int above = 0; above < 2; above++) {
        struct node child = node_child(tree, node, above);
        halve(tree, &child, dimension);
    }
}

struct domain_tree *domain_tree_halve(int ranks, const struct box *box) {
    struct domain_tree *tree = tree_create(ranks);
    struct node root = node_root(tree, (double[3]){0, 0, 0}, box->edge);
    halve(tree, &root, box->dimension);
    return tree;
}

/* The corners of the subdomains whose tree is sought. */
struct shape {
    const double (*lower)[3], (*upper)[3];
    int dimension;
    int *part;     /* number of the part whose corners rank k gets */
    double *below; /* scratch: the largest upper corner of the parts up to here */
};

/* Looks for a cut across `axis` between the first and the last parts of a node; of several, the cut nearest
 * to the middle of the node. */
static bool cut_find(const struct shape *shape, const struct node *node, int axis, struct domain_cut *cut) {
    double most = -INFINITY, least = INFINITY;
    bool found = false;
    int half = node->first + (node->last - node->first) / 2;
    for (int k = node->first; k < node->last; k++)
        shape->below[k] = most = fmax(most, shape->upper[shape->part[k]][axis]);
    for (int k = node->last - 1; k > node->first; k--) {
        least = fmin(least, shape->lower[shape->part[k]][axis]);
        bool nearer = !found || abs(k - half) < abs(cut->middle - half);
        if (shape->below[k - 1] <= least && nearer) {
            *cut = (struct domain_cut){.at = least, .middle = k, .axis = axis};
            found = true;
        }
    }
    return found;
}

/* A part, for sorting along an axis. */
struct place {
    double lower, upper;
    int part;
};

static int compare_places(const void *a, const void *b) {
    const struct place *left = a, *right = b;
    if (left->lower != right->lower)
        return left->lower < right->lower ? -1 : 1;
    if (left->upper != right->upper)
        return left->upper < right->upper ? -1 : 1;
    return left->part - right->part;
}

/* Puts the parts of a node in the order of their lower corners along an axis. */
static void shape_sort(const struct shape *shape, const struct node *node, int axis) {
    size_t n = (size_t)(node->last - node->first);
    struct place *place = memory_allocate(n, sizeof *place, "cut tree");
    for (size_t k = 0; k < n; k++) {
        int part = shape->part[node->first + (int)k];
        place[k] = (struct place){shape->lower[part][axis], shape->upper[part][axis], part};
    }
    qsort(place, n, sizeof *place, compare_places);
    for (size_t k = 0; k < n; k++)
        shape->part[node->first + (int)k] = place[k].part;
    memory_free(place);
}

static bool shape_divide(struct domain_tree *tree, const struct shape *shape, const struct node *node) {
    if (node_is_leaf(node))
        return true;
    bool found = false;
    for (int axis = 0; axis < shape->dimension && !found; axis++) {
        shape_sort(shape, node, axis);
        found = cut_find(shape, node, axis, &tree->cut[node->at]);
    }
    if (!found)
        return false;
    struct node below = node_child(tree, node, false), above = node_child(tree, node, true);
    return shape_divide(tree, shape, &below) && shape_divide(tree, shape, &above);
}

struct domain_tree *domain_tree_from_bounds(int ranks, int dimension, const double (*lower)[3],
                                            const double (*upper)[3]) {
    struct domain_tree *tree = tree_create(ranks);
    struct shape shape = {lower, upper, dimension, memory_allocate((size_t)ranks, sizeof(int), "cut tree"),
                          memory_allocate((size_t)ranks, sizeof(double), "cut tree")};
    for (int k = 0; k < ranks; k++)
        shape.part[k] = k;
    struct node root = {.first = 0, .last = ranks};
    bool good = shape_divide(tree, &shape, &root);
    memory_free(shape.part);
    memory_free(shape.below);
    if (!good)
        domain_tree_destroy(&tree);
    return tree;
}

void domain_tree_stretch(struct domain_tree *tree, int axis, double growth) {
    for (int k = 0; k < tree->ranks - 1; k++)
        if (tree->cut[k].axis == axis)
            tree->cut[k].at *= growth;
}

int domain_tree_owner(const struct domain_tree *tree, const double x[3]) {
    int at = 0, first = 0, last = tree->ranks;
    while (last - first > 1) {
        const struct domain_cut *cut = &tree->cut[at];
        if (x[cut->axis] >= cut->at) {
            at += cut->middle - first;
            first = cut->middle;
        } else {
            at++;
            last = cut->middle;
        }
    }
    return first;
}

void domain_tree_bounds(const struct domain_tree *tree, int rank, double lower[3], double upper[3]) {
    struct node node = node_root(tree, lower, upper);
    while (!node_is_leaf(&node))
        node = node_child(tree, &node, rank >= tree->cut[node.at].middle);
    memcpy(lower, node.lower, sizeof node.lower);
    memcpy(upper, node.upper, sizeof node.upper);
}

bool domain_tree_cuts(const struct domain_tree *tree, int axis) {
    for (int k = 0; k < tree->ranks - 1; k++)
        if (tree->cut[k].axis == axis)
            return true;
    return false;
}

/* A node contains all of its subdomains, so rounding cannot make the node look farther away than one of the
 * subdomains. */
static void near(const struct domain_tree *tree, const struct domain_tree_search *search,
                 const struct node *node) {
    double squared = 0;
    for (int d = 0; d < 3; d++) {
        double gap = domain_gap(node->lower[d], node->upper[d], search->from[d], search->to[d]);
        squared += search->skip[d] ? 0 : gap * gap;
    }
    if (!(squared <= search->radius * search->radius))
        return;
    if (node_is_leaf(node)) {
        search->put(search->context, node->first);
        return;
    }
    for (int above = 0; above < 2; above++) {
        struct node child = node_child(tree, node, above);
        near(tree, search, &child);
    }
}

void domain_tree_near(const struct domain_tree *tree, const struct domain_tree_search *search,
                      const double lower[3], const double upper[3]) {
    struct node root = node_root(tree, lower, upper);
    near(tree, search, &root);
}
