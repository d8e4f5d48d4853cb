/* SPDX-License-Identifier: BSD-3-Clause */
/* Fills surfaces with spheres, the largest first. Read inscribe.h first. */
#include "physics/bodies/inscribe.h"
#include "base/memory.h"
#include "physics/grains/walls/wall_inside.h"
#include <math.h>

enum { NODES_ACROSS = 24 };

static const double least_part = 0.1; /* of the radius of the first sphere */

/* A place of the lattice. */
struct node {
    struct law_vector x;
    double depth; /* distance to the surface; 0 outside, and where a sphere covers the place */
};

struct lattice {
    size_t count;
    struct node *node;
    double spacing;
};

static double length_of(struct law_vector a) {
    return sqrt(law_dot(a, a));
}

static void lattice_make(struct lattice *lattice, const struct wall_mesh *mesh) {
    struct law_vector edge = law_add(mesh->upper, -1.0, mesh->lower);
    double spacing = fmax(edge.x, fmax(edge.y, edge.z)) / NODES_ACROSS;
    int n[3] = {(int)ceil(edge.x / spacing), (int)ceil(edge.y / spacing), (int)ceil(edge.z / spacing)};
    size_t most = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    *lattice = (struct lattice){.spacing = spacing,
                                .node = memory_allocate(most, sizeof *lattice->node, "lattice in a mesh")};
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++)
            for (int k = 0; k < n[2]; k++) {
                struct law_vector x = {mesh->lower.x + (i + 0.5) * spacing,
                                       mesh->lower.y + (j + 0.5) * spacing,
                                       mesh->lower.z + (k + 0.5) * spacing};
                double depth = wall_inside_depth(mesh, x);
                if (depth > 0.0)
                    lattice->node[lattice->count++] = (struct node){x, depth};
            }
}

/* Moves a place by up to a lattice spacing along each axis to where it is deepest, by ever smaller steps. */
static struct node deepest_near(const struct wall_mesh *mesh, struct node start, double spacing) {
    static const struct law_vector along[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                               {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    struct node best = start;
    for (double step = 0.5 * spacing; step > 0.005 * spacing; step *= 0.5)
        for (int d = 0; d < 6; d++) {
            struct law_vector x = law_add(best.x, step, along[d]), off = law_add(x, -1.0, start.x);
            bool near = fmax(fabs(off.x), fmax(fabs(off.y), fabs(off.z))) <= spacing;
            double depth = near ? wall_inside_depth(mesh, x) : 0.0;
            if (depth > best.depth)
                best = (struct node){x, depth};
        }
    return best;
}

/* Chooses up to `most` spheres; returns their number. */
static int choose(const struct wall_mesh *mesh, struct lattice *lattice, int most,
                  struct clump_sphere *sphere) {
    int chosen = 0;
    while (chosen < most) {
        struct node best = {.depth = 0.0};
        for (size_t k = 0; k < lattice->count; k++)
            if (lattice->node[k].depth > best.depth)
                best = lattice->node[k];
        if (best.depth == 0.0)
            break;
        best = deepest_near(mesh, best, lattice->spacing);
        if (chosen > 0 && best.depth < least_part * sphere[0].radius)
            break;
        sphere[chosen++] = (struct clump_sphere){{best.x.x, best.x.y, best.x.z}, best.depth};
        for (size_t k = 0; k < lattice->count; k++)
            if (length_of(law_add(lattice->node[k].x, -1.0, best.x)) <= best.depth)
                lattice->node[k].depth = 0.0;
    }
    return chosen;
}

int inscribe_spheres(const struct inscribe_options *options, struct clump_sphere *sphere,
                     struct moments *moments, struct error *error) {
    struct wall_mesh *mesh;
    struct wall_mesh_place place = {.scale = options->scale};
    int chosen = 0;
    if (wall_inside_read(&mesh, options->file, &place, "a body", error)) {
        struct lattice lattice;
        double(*corner)[9] = memory_allocate(mesh->triangles, sizeof *corner, "triangles of a body");
        for (size_t t = 0; t < mesh->triangles; t++)
            for (int c = 0; c < 9; c++) {
                struct law_vector at = mesh->triangle[t].corner[c / 3];
                corner[t][c] = c % 3 == 0 ? at.x : c % 3 == 1 ? at.y : at.z;
            }
        moments_solid(corner, mesh->triangles, moments);
        memory_free(corner);
        lattice_make(&lattice, mesh);
        chosen = choose(mesh, &lattice, options->spheres, sphere);
        memory_free(lattice.node);
        if (chosen == 0)
            error_set(error, ERROR_USER,
                      "%s: is too thin for spheres: no node of a lattice of %d across lies in it",
                      options->file, NODES_ACROSS);
    }
    wall_mesh_destroy(&mesh);
    return chosen;
}
