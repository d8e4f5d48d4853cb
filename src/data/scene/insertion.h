/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles inserted during a run, and deleted. An inserted particle depends on seed, region and its number
 * alone, not on ranks or threads. The caller finds out, with all ranks, whether a place is free:
 *
 *     n = insertion_due(insertion, time) - state.placed      particles due
 *     insertion_begin(...)                                   sizes and velocities of these
 *     for round = 0 ... attempts - 1, while some are unplaced:
 *         insertion_propose(...)                             the same places on every rank
 *         blocked[k] = 1                                     where one touches a particle or a wall: the
 *                                                            maximum over ranks, each looks at its own
 *         insertion_settle(...)                              accepts those that touch no accepted one either
 *     insertion_end(...)                                     the owner of each that entered appends it
 *
 * A particle that found no place waits for the next call: a full region slows down and catches up later,
 * which the report shows. */
#ifndef SCREE_SCENE_INSERTION_H
#define SCREE_SCENE_INSERTION_H

#include "kernel/particles/box.h"
#include "data/scene/source.h"

enum { INSERTIONS_MAX = 1000, DELETIONS_MAX = 1000, INSERTION_BATCH_MAX = 4096 };

struct insertion_options {
    char name[SOURCE_NAME_MAX];
    struct region region;
    struct sizes_options sizes;
    double rate;        /* particles a time unit */
    double mass_rate;   /* or mass a time unit; one of the two is > 0 */
    double start, stop; /* time */
    int64_t count;      /* largest number of particles in all; 0: no bound */
    int64_t attempts;   /* rounds of places tried at one step */
    double velocity[3], velocity_sigma;
    double omega[3];
    int material, group;
    double density;              /* 0: the material's */
    double temperature;          /* NAN: that of the section heat */
    char shape[SOURCE_NAME_MAX]; /* name of an entry of bodies; "": none */
    struct source_form form;     /* no key */
};

struct deletion_options {
    char name[SOURCE_NAME_MAX];
    struct region region; /* a particle whose centre lies in it is deleted ... */
    double start, stop;   /* ... at a step with start <= t < stop */
    int64_t every;        /* steps between two checks */
};

/* The state of an insertion region that a checkpoint stores. */
struct insertion_state {
    uint64_t placed; /* particles inserted so far */
    uint64_t tried;  /* rounds so far: the counter of the random places */
    double mass;     /* mass inserted so far; the caller adds it */
};

/* The fixed part of an insertion, made once. */
struct insertion {
    struct insertion_options options;
    struct sizes_sampler sampler;
    struct region_space space;
    struct box box;
    uint64_t seed;
    int number;       /* of the region in the scene: chooses its random numbers */
    double density;   /* as the scene means it (enum box_density) */
    double mean_mass; /* of what a particle becomes, for mass_rate: insertion_weigh */
};

/* One candidate; positions box-relative. */
struct insertion_candidate {
    uint64_t number; /* number of the particle in this region: fixes radius and velocity */
    double x[3], v[3], omega[3];
    double radius, density;
    double temperature; /* NAN: that of the section heat */
    int material, group;
    int shape; /* as in struct source_form; -1: it stays a sphere */
    double
        orientation[4]; /* of the body that it becomes, in the frame of the entry; all 0: the entry says it */
    bool settled, accepted;
};

/* Prepares an insertion. `density` is that of its material. */
bool insertion_prepare(struct insertion *insertion, const struct insertion_options *options, int number,
                       double density, uint64_t seed, const struct box *box, struct error *error);

/* Sets the mean mass over the law of sizes of what particles become, by a fixed sample: the same on every rank, good to
 * a percent. `mass` of a material, a radius, a density and an id; `context` is handed to it. */
typedef double insertion_mass(const void *context, const struct insertion_candidate *candidate, int64_t id);
void insertion_weigh(struct insertion *insertion, insertion_mass *mass, const void *context);

/* Particles that should have been inserted by `time`, all in all. */
uint64_t insertion_due(const struct insertion *insertion, double time);

/* Fills `n` candidates for the particles state->placed ... with radii and velocities, unsettled and without a
 * place. */
void insertion_begin(const struct insertion *insertion, const struct insertion_state *state,
                     struct insertion_candidate *candidate, size_t n);

/* True if a sphere around x, box-relative, can touch a candidate with a radius up to `largest`, wherever in
 * the region that has its place (periodic images counted). Never false where one touches; sometimes true
 * where none does. */
bool insertion_reaches(const struct insertion *insertion, double largest, const double x[3], double radius);

/* Gives every unsettled candidate the place of this round and counts the round in state->tried. A candidate
 * for which the region has no room is marked in blocked[k] (n bytes, the rest set to 0). */
void insertion_propose(const struct insertion *insertion, struct insertion_state *state,
                       struct insertion_candidate *candidate, uint8_t *blocked, size_t n);

/* Accepts, in order, the unsettled candidates that are not blocked and touch no accepted one (periodic images
 * counted). Returns the number of unsettled ones. */
size_t insertion_settle(const struct insertion *insertion, struct insertion_candidate *candidate,
                        const uint8_t *blocked, size_t n);

/* Counts the accepted candidates into state->placed, as far as they follow one another without a gap: particles
 * enter in the order of their numbers, so that a size law keeps its shares where large ones find no room.
 * Candidates behind a gap are marked as not accepted, and come again at the next call. Returns the number
 * that entered: candidate[0] ... */
size_t insertion_end(struct insertion_state *state, struct insertion_candidate *candidate, size_t n);

/* True if a deletion is active at this step. */
bool deletion_due(const struct deletion_options *options, double time, int64_t step);

#endif
