/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles of a fluid with their pairs and weights, in a periodic unit square or cube: shared by the tests of the
 * operators. */
#ifndef SCREE_TESTS_FLUID_CLOUD_H
#define SCREE_TESTS_FLUID_CLOUD_H

#include "physics/fluid/lattice/arrangement.h"
#include "physics/fluid/operators/operators.h"
#include "kernel/particles/kinds.h"

/* A periodic unit square or cube of n particles a side, displaced at random. */
struct fluid_cloud {
    int dimension, side, threads;
    double spacing, reach;
    struct particles *particles;
    struct size_classes classes;
    struct box box;
    struct index *index;
    struct index_view view;
    struct interactions set;
    struct pair_rows rows;
    struct weights_input input;
};

/* Makes a cloud of side^dimension particles, on another lattice about as many, whose pairs reach `reach` spacings; each
 * coordinate is displaced by up to chi / 2 spacings. */
void fluid_cloud_make(struct fluid_cloud *cloud, int dimension, int side, double reach, double chi,
                      int threads);
void fluid_cloud_make_on(struct fluid_cloud *cloud, enum fluid_arrangement arrangement, int dimension,
                         int side, double reach, double chi, int threads);

/* A cloud of 10^3 with a plane across z: particles below `height`, and above z = 0.8, where nothing looks, are boundary particles of
 * wall 0, at the end. Returns how many are fluid. The caller frees kinds and bodies. */
size_t fluid_cloud_plane(struct fluid_cloud *cloud, double height, uint8_t **kinds, int64_t **bodies);
void fluid_cloud_free(struct fluid_cloud *cloud);

/* Finds index, pairs and rows again, after the particles have been reordered. */
void fluid_cloud_pair(struct fluid_cloud *cloud);

/* Weights (weights_free); operators WEIGHTS_MLS + m are moving least squares of order m. */
struct weights fluid_cloud_weigh(const struct fluid_cloud *cloud, enum kernel_name name, int operators,
                                 bool lattice);

/* x_j - x_i of an entry of a row. */
void fluid_cloud_apart(const struct fluid_cloud *cloud, const struct weights *weights, size_t row,
                       size_t entry, double apart[3]);

/* The largest deviation from the three identities of the weights, in units of 1. */
double fluid_cloud_identities(const struct fluid_cloud *cloud, const struct weights *weights);

/* Relative errors of gradient and Laplacian of f = product of sin 2 pi x. */
struct fluid_cloud_errors {
    double gradient, laplacian;
};
struct fluid_cloud_errors fluid_cloud_errors(int dimension, int side, double reach, double chi,
                                             int operators);

/* The same of a cloud that was made, and frees the cloud. */
struct fluid_cloud_errors fluid_cloud_errors_of(struct fluid_cloud *cloud, int operators);

#endif
