/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of weights: for each fluid particle i of this rank the neighbours j within the support, and what turns
 * differences of values into a gradient and a Laplacian:
 *
 *   (grad f)_i = sum over j of b_ij (f_j - f_i),     (div grad f)_i = sum over j of w_ij (f_j - f_i)
 *
 * with the corrected operators of second order of Trask et al., CMAME 289 (2015) 155, after Fatehi and
 * Manzari, Comput. Math. Appl. 61 (2011) 482, and Bonet and Lok, CMAME 180 (1999) 97 (correction_tensors.h has the
 * formulas). On any arrangement, to rounding:
 *
 *   sum b_ij (x) (x_j - x_i) = 1,   sum w_ij (x_j - x_i) = 0,   sum w_ij (x_j - x_i) (x) (x_j - x_i) = 2 1
 *
 * Fluid neighbours stand first in a row, wall neighbours (boundary particles) last. A wall neighbour has no
 * unknown: with the foot point of i on the body of j, d_i and d_j the distances of both from the tangent
 * plane there and beta = d_j / d_i (Morris, Fox, Zhu, J. Comput. Phys. 136 (1997) 214), a condition at the
 * wall gives
 *
 *   no slip, wall velocity u_w:   f_j - f_i = -(1 + beta) (f_i - u_w)        for each component of velocity
 *   slip length b, tangential:    f_j - f_i = -(d_i + d_j) / (d_i + b) (f_i - u_w) = -(1 + beta) d_i / (d_i + b) ...
 *   no flux (pressure):           f_j - f_i = 0
 *   body that turns by omega:     f_j - f_i = omega x (x_j - x_i) - (1 + beta) (f_i - u_w),  u_w its rigid motion at x_i
 *
 * and at an open side of given pressure p_w (`pressed`), where the velocity does not change along the normal,
 *
 *   velocity:                     f_j - f_i = 0
 *   pressure:                     f_j - f_i = -(1 + beta) (f_i - p_w)
 *
 * At an open side, where the mirror image of j in the side is a fluid particle m, as on a lattice that the side cuts
 * midway between nodes, values beyond the side are those of m, so that what varies along the side is seen, too:
 *
 *   given:                        f_j - f_i = 2 f_w - f_m - f_i
 *   not given:                    f_j - f_i = f_m - f_i
 *
 * so the wall part of a velocity row is a diagonal entry and a right-hand side. In a divergence beta is
 * capped at WEIGHTS_MIRROR_CAP. */
#ifndef SCREE_OPERATORS_WEIGHTS_H
#define SCREE_OPERATORS_WEIGHTS_H

#include "base/error.h"
#include "physics/fluid/operators/kernel.h"
#include "physics/fluid/operators/correction_tensors.h"
#include "kernel/pairs/interaction.h"
#include <math.h>

#define WEIGHTS_MIRROR_CAP 3.0

enum weights_operators { WEIGHTS_CORRECTED, WEIGHTS_STANDARD, WEIGHTS_MLS };

/* The tangent plane of a body at the point nearest to a fluid particle i. */
struct weights_foot {
    double distance;  /* d_i, length, >= WEIGHTS_NEAREST x spacing */
    double normal[3]; /* unit, out of the body into the fluid; the foot point is x_i - d_i n */
    double velocity
        [3]; /* u_w: the rigid motion of the body at x_i, at an open side what is given there; length/time */
    double spin[3];  /* omega of the body, rad/time */
    int64_t body;    /* see body_surfaces.h: id of a grain, or -1 - number of a wall or of an open side */
    bool open;       /* an open side of the box */
    bool pressed;    /* of given pressure */
    double pressure; /* there */
};
#define WEIGHTS_NEAREST 1e-4

/* The image of a wall entry at an open side. */
struct weights_image {
    uint32_t particle;  /* number of the particle m, the row's own too; WEIGHTS_NO_IMAGE */
    double velocity[3]; /* u_w at the foot of j */
};
#define WEIGHTS_NO_IMAGE UINT32_MAX

/* All arrays are owned. Row k is that of the owned particle first + k. Entries of row k are start[k] ...
 * start[k + 1] - 1, the last walls(k) of which are wall neighbours; these have numbers of their own,
 * wall_start[k] ... wall_start[k + 1] - 1. All zero: empty. */
struct weights {
    int dimension;      /* 2 or 3 */
    size_t first, rows; /* the fluid particles of this rank */
    size_t *start;      /* [rows + 1] */
    size_t *wall_start; /* [rows + 1] */
    uint32_t *partner;  /* number and image code (pair_partner, pair_image), as in a pair list */
    /* The values w_ij, 1 / length^2, and b_ij, `dimension` components each, 1 / length: read by weights_scalar and
     * weights_vector. On a lattice all rows share the values of one row (pattern.h), and each entry has the number
     * of its own in `code`; else (NULL) value k is that of entry k. */
    double *scalars, *vectors;
    uint8_t *code;
    double *mirror;      /* by wall entry: beta_ij = d_j / d_i, not capped */
    double (*turn)[3];   /* by wall entry: omega x (x_j - x_i), omega of j's body; NULL: no body turns */
    uint32_t *wall_foot; /* by wall entry: number of its foot */
    struct weights_foot *foot; /* by row, then by body */
    size_t *foot_start;        /* [rows + 1]: feet of row k */
    double *volume;            /* by row: V_i, length^dimension */
    double *
        condition; /* by row: |M| |G| / dimension of correction_tensors.h, 1 on a lattice; 0: standard operators */
    double slip;                 /* slip length of the walls, >= 0; INFINITY: no friction */
    size_t opens;                /* feet at open sides (mirror_make) */
    struct weights_image *image; /* by wall entry; NULL without open sides */
    double (*whole)
        [9]; /* by particle number, copies too, borrowed: C of gradient_correction.h, row after row; NULL: 1 */
    size_t poor;       /* rows without the operators asked for: singular tensors, or too few neighbours */
    size_t poor_first; /* the first of them (a row) */
    size_t behind;     /* rows whose particle lies behind the surface of a body (mirror.h) */
    size_t row_room, entry_room, value_room, wall_room, foot_room;
};

/* The place of the values of an entry. */
static inline size_t weights_value(const struct weights *weights, size_t entry) {
    return weights->code ? weights->code[entry] : entry;
}

/* w_ij of an entry, 1 / length^2. */
static inline double weights_scalar(const struct weights *weights, size_t entry) {
    return weights->scalars[weights_value(weights, entry)];
}

/* b_ij of an entry: `dimension` components, 1 / length. */
static inline const double *weights_vector(const struct weights *weights, size_t entry) {
    return weights->vectors + weights_value(weights, entry) * (size_t)weights->dimension;
}

/* First wall entry of a row among its entries. */
static inline size_t weights_walls(const struct weights *weights, size_t row) {
    return weights->start[row + 1] - (weights->wall_start[row + 1] - weights->wall_start[row]);
}

/* 1 + beta of a wall entry, capped for a divergence. */
static inline double weights_divergence_factor(const struct weights *weights, size_t wall) {
    return 1 + fmin(weights->mirror[wall], WEIGHTS_MIRROR_CAP);
}

/* The foot of a wall entry. */
static inline const struct weights_foot *weights_foot_of(const struct weights *weights, size_t wall) {
    return &weights->foot[weights->wall_foot[wall]];
}

/* By how much the rigid motion of a wall entry's body at j differs from that at i, one component. */
static inline double weights_turn(const struct weights *weights, size_t wall, int d) {
    return weights->turn != NULL ? weights->turn[wall][d] : 0;
}

/* The image of a wall entry; NULL where there is none. */
static inline const struct weights_image *weights_image_of(const struct weights *weights, size_t wall) {
    return weights->opens > 0 && weights->image[wall].particle != WEIGHTS_NO_IMAGE ? &weights->image[wall]
                                                                                   : NULL;
}

/* The factor of (u_i - u_w) tangential to the wall, (d_i + d_j) / (d_i + b); 1 + beta without slip. */
static inline double weights_tangential_factor(const struct weights *weights, size_t wall) {
    double d = weights->foot[weights->wall_foot[wall]].distance;
    return (1 + weights->mirror[wall]) * (weights->slip > 0 ? d / (d + weights->slip) : 1);
}

/* to = C from, C of a particle (gradient_correction.h). */
static inline void weights_whole(const struct weights *weights, size_t particle, const double *from,
                                 double to[3]) {
    if (weights->whole == NULL) {
        for (int d = 0; d < weights->dimension; d++)
            to[d] = from[d];
        return;
    }
    const double *c = weights->whole[particle];
    for (int d = 0; d < weights->dimension; d++) {
        to[d] = 0;
        for (int e = 0; e < weights->dimension; e++)
            to[d] += c[3 * d + e] * from[e];
    }
}

/* |C b| / |b|, C of a particle, b of an entry: by so much the gradient of gradient_correction.h sees more of what changes along b; 1 without C. */
static inline double weights_whole_along(const struct weights *weights, size_t particle, size_t entry) {
    const double *b = weights_vector(weights, entry);
    double to[3] = {0}, square = 0, size = 0;
    weights_whole(weights, particle, b, to);
    for (int d = 0; d < weights->dimension; d++) {
        square += to[d] * to[d];
        size += b[d] * b[d];
    }
    return size > 0 ? sqrt(square / size) : 1;
}

/* How weights are made. */
struct weights_options {
    struct kernel kernel;
    enum weights_operators operators;
    int order;      /* of WEIGHTS_MLS (mls.h) */
    double spacing; /* length */
    double volume;  /* > 0: the same volume for all particles (a lattice); 0: V_i = 1 / sum of W */
    double slip;    /* slip length */
    bool
        moving; /* rows keep all pairs, with weights of 0 beyond the support: the pattern of the matrices then
                       lives as long as the pairs, though particles move */
};

/* The neighbourhood from which weights are made; all borrowed. */
struct weights_input {
    const struct particles *particles; /* owned and copies */
    const uint8_t *kind;               /* kinds_of; NULL: all are fluid */
    size_t first, end;                 /* the fluid particles of this rank, kinds_span */
    const struct pair_rows *pairs;     /* rows of all pairs up to the support at least */
    const double (*shift)[4];          /* of image codes, as in the pair list */
    int dimension;
    const double
        *volume; /* by particle number, copies too; NULL: own rows' V_i, spacing^dimension of others */
};

/* Makes rows, neighbours within the support alone, tensors and weights. Mirrors are mirror_make's. Opens its
 * own team; bits do not depend on threads. A row with too few neighbours for its operators has those of the next
 * simpler kind, and is counted in `poor`: moving least squares of order m those of m - 1 ... 2, then corrected ones,
 * then standard ones. */
void weights_make(struct weights *weights, const struct weights_input *input,
                  const struct weights_options *options);

/* The same in two parts, where copies must get the volumes in between: rows with their volumes; weights. */
void weights_rows(struct weights *weights, const struct weights_input *input,
                  const struct weights_options *options);
void weights_weigh(struct weights *weights, const struct weights_input *input,
                   const struct weights_options *options);

/* The neighbour of particle i that an entry of the pairs stands for, with W and V W'. Any thread, after
 * weights_rows. */
void weights_neighbour(const struct weights *weights, const struct weights_input *input,
                       const struct weights_options *options, size_t entry, size_t row,
                       struct correction_tensors_neighbour *to);

/* x_j - x_i of an entry of a row. Any thread. */
void weights_apart(const struct weights *weights, const struct weights_input *input, size_t row, size_t entry,
                   double apart[3]);
void weights_free(struct weights *weights);

/* Bytes held. */
size_t weights_memory(const struct weights *weights);

#endif
