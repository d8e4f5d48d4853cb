/* SPDX-License-Identifier: BSD-3-Clause */
/* Particle sources: files and generators. Every rank reads or generates the whole stream of spheres in the
 * same order and keeps its own, so that ids, radii and places depend on the scene alone, whatever the ranks
 * and threads. */
#ifndef SCREE_SCENE_SOURCE_H
#define SCREE_SCENE_SOURCE_H

#include "data/scene/region.h"
#include "data/scene/sizes.h"
#include <stddef.h>
#include <stdint.h>

enum {
    SOURCES_MAX = 10000,
    SOURCE_COLUMNS_MAX = 32,
    SOURCE_PATH_MAX = 1024,
    SOURCE_NAME_MAX = 64,
    SOURCE_TYPES_MAX = 32
};

enum source_kind { SOURCE_FILE, SOURCE_LATTICE, SOURCE_RANDOM, SOURCE_PACKED, SOURCE_SINGLE };
enum source_meets { SOURCE_PUSHES, SOURCE_YIELDS };
enum source_format { SOURCE_LAMMPS_DATA, SOURCE_TABLE, SOURCE_H5MD };
enum source_ids_rule { SOURCE_IDS_FILE, SOURCE_IDS_NEW };
enum source_lattice { SOURCE_SC, SOURCE_FCC, SOURCE_HCP, SOURCE_SQUARE, SOURCE_HEXAGONAL };

/* What the grains of a source become where it names a shape of bodies; the section of bodies fills it (physics_table.h). All 0: it
 * names none. */
struct source_form {
    int shape;    /* number of the entry + 1, those of bodies.clumps before those of bodies.shapes */
    double ball;  /* radius of the ball around a body over the radius that the source gives */
    double solid; /* mean part of the ball that is solid; 0: not known */
};

/* The same, 1 where no shape is named. */
static inline double source_form_ball(const struct source_form *form) {
    return form->shape > 0 ? form->ball : 1;
}

static inline double source_form_solid(const struct source_form *form) {
    return form->shape > 0 ? form->solid : 1;
}

struct source_options {
    char name[SOURCE_NAME_MAX];
    enum source_kind kind;
    /* FILE */
    char file[SOURCE_PATH_MAX];
    enum source_format format;
    int column_count;
    char column[SOURCE_COLUMNS_MAX]
               [SOURCE_NAME_MAX]; /* TABLE: what each column holds; none given: the file's header says so */
    int64_t skip_rows, rows;      /* TABLE: data rows left out at the start; rows read (0: all) */
    int64_t frame;                /* H5MD: which stored step, negative from the end (-1: the last) */
    enum source_ids_rule ids;     /* FILE: those of the file, if it has some, or new ones */
    double scale;                 /* lengths in the file x this; then offset is added */
    int type_count;
    int type_material[SOURCE_TYPES_MAX]; /* FILE: material of type 1, 2, ...; none given: `material`, or type
                                            t is material t */
    double radius_above, radius_upto;    /* FILE: keep only radii in (above, upto], after scaling */
    /* LATTICE */
    enum source_lattice lattice;
    double spacing; /* distance of neighbours, length unit */
    double jitter;  /* every coordinate moved by up to +- jitter x (spacing/2 - largest radius) */
    /* LATTICE, RANDOM, PACKED */
    struct region region;
    struct sizes_options sizes;
    int64_t count;          /* particles; 0: as many as the lattice has places, or by volume_fraction */
    double volume_fraction; /* RANDOM, PACKED: solid volume / volume of the region; 0: by count */
    int64_t attempts;       /* RANDOM: places tried for one sphere before giving up */
    /* PACKED */
    enum source_meets meets; /* what happens where its spheres meet those of other sources */
    double gap;              /* wanted between neighbours, as part of the sum of radii */
    double overlap;          /* the largest that may be left, as part of the smaller radius */
    int64_t sweeps;          /* at most */
    /* SINGLE */
    double position[3], radius;
    int64_t id; /* 0: a new one */
    /* all */
    double offset[3]; /* FILE: added to positions after scaling */
    int material, group;
    double velocity[3];    /* added to the velocity in the file */
    double velocity_sigma; /* standard deviation of each component of a random velocity */
    double omega[3];
    double density;              /* 0: the file's, else the material's */
    double temperature;          /* NAN: that of the section heat */
    char shape[SOURCE_NAME_MAX]; /* name of an entry of bodies; "": none */
    struct source_form form;     /* no key */
};

#endif
