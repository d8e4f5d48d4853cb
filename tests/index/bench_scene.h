/* SPDX-License-Identifier: BSD-3-Clause */
/* Packings for the benchmark of the indexes: from a file, or with radii by a law, placed at random, large
 * spheres first. */
#ifndef SCREE_TESTS_INDEX_BENCH_SCENE_H
#define SCREE_TESTS_INDEX_BENCH_SCENE_H

#include "index/index.h"

struct bench_spec {
    char law[32];    /* power, bidisperse, exponential, lognormal, sand, boulder */
    double exponent; /* power: number density ~ r^exponent; -3 gives every size the same volume */
    double ratio;    /* largest radius over smallest; the smallest is 1 */
    size_t particles;
    const char *file; /* a LAMMPS data file, which overrides the law; NULL: none */
    double large;     /* bidisperse: share of large spheres, by number; boulder: their number */
    double fraction;  /* volume fraction; sets the cube */
    bool open;        /* no direction is periodic */
    double skin;      /* margin of a class pair as a multiple of the smaller class's smallest radius */
    double inflate;   /* radii are made larger by this factor after placing */
};

enum { BENCH_STRIDE = 8 };

/* Particles in random order, without classes. */
struct bench_scene {
    double *record; /* x y z radius and four more */
    uint8_t *size_class;
    int64_t *id;
    struct index_view view; /* classes and margins are the caller's to set */
};

void bench_scene_make(struct bench_scene *scene, const struct bench_spec *spec);
void bench_scene_free(struct bench_scene *scene);

/* Applies an order, as a rebuild does. */
void bench_scene_reorder(struct bench_scene *scene, const uint32_t *order);

#endif
