/* SPDX-License-Identifier: BSD-3-Clause */
/* The frame: positions and radii as floats, in which the search filters.
 *
 * A coordinate is (x - centre) * scale, rounded to float, with scale = 1 / smallest cut-off. One frame serves
 * all grids of an index, so that a row is compared with the particles of any grid without conversion.
 * Invariants:
 *
 * - Coordinates are clamped to [low, high] first. Clamping is monotone and shortens distances, never
 * lengthens them, so no pair is lost. Clamping changes a coordinate only if its particle lies extremely far
 * out (or is not a number); then `clamped` is set and no distance in the frame counts as certain: the exact
 * test decides all distances.
 * - A distance formed from two frame coordinates, one of them shifted by a box edge, differs from the true
 * one by at most `tolerance`: coordinates and edges carry 2^-24 of their size each, four of them enter, and
 * the square root of three directions is below two (see grid_frame.c).
 * - In open directions the centre and the cells depend on the owned particles alone (ghosts add cells beyond). `order` and `build` both
 *   see the owned particles, so both divide space alike, and a build after a reorder finds all particles in
 *   order. */
#ifndef SCREE_INDEX_GRIDS_GRID_FRAME_H
#define SCREE_INDEX_GRIDS_GRID_FRAME_H

#include "index/index.h"

struct frame {
    double centre[3], low[3], high[3];   /* length unit */
    double scale;                        /* frame units a length unit */
    double unit;                         /* 1 / scale */
    bool periodic[3];                    /* as in the view */
    float edge[3];                       /* box edges in periodic directions, else 0; frame units */
    float owned_low[3], owned_high[3];   /* extent of owned particles; in periodic directions the box */
    float all_low[3], all_high[3];       /* extent of all particles */
    float tolerance;                     /* frame units */
    float hollow_low[3], hollow_high[3]; /* in open directions: no ghost lies inside */
    bool clamped;
};

/* The class that sets the cut-off of class c (radius_max of both + margin): c itself or, if particles of c do
 * not meet each other, the nearest class that c meets; -1 if c meets no class. */
int grid_frame_partner(const struct index_view *view, int c);

/* Smallest and largest cut-off of the classes first ... last; both 1 if no class has a size, or no class has
 * a partner class. */
struct grid_frame_cutoffs {
    double smallest, largest;
};
struct grid_frame_cutoffs grid_frame_cutoffs(const struct index_view *view, int first, int last);

/* Fits a frame to the view; before there are ghosts (total = owned) also to where they will be. Opens a team of threads
 * if a direction is open. */
void grid_frame_make(struct frame *frame, const struct index_view *view);

/* Takes the ghosts of a view into a frame that was made before they were there. False if one lies out of the frame:
 * then the frame does not serve. */
bool grid_frame_meet(struct frame *frame, const struct index_view *view);

/* Lets positions lie farther out, by half of the frame's size, without clamping them; the tolerance doubles. For
 * particles that have moved since the frame was made. */
void grid_frame_loosen(struct frame *frame);

/* Frame coordinate of a position in direction d. Not a number gives the lower end. */
static inline float grid_frame_coordinate(const struct frame *frame, int d, double x) {
    x = x > frame->low[d] ? x : frame->low[d];
    x = x < frame->high[d] ? x : frame->high[d];
    return (float)((x - frame->centre[d]) * frame->scale);
}

/* False if grid_frame_coordinate clamps this position. */
static inline bool grid_frame_holds(const struct frame *frame, int d, double x) {
    return x >= frame->low[d] && x <= frame->high[d];
}

#endif
