/* SPDX-License-Identifier: BSD-3-Clause */
/* The division of the box among ranks. All other code uses only the functions of this header, for both forms
 * of division: bricks, or recursive bisection (domain_tree.h), which follows the load (balance.h). Positions
 * are box-relative.
 *
 * A subdomain is a cuboid, closed for the purpose of distances; together the subdomains tile the box. At an
 * open side the outermost subdomains extend to infinity, so that every position has an owner. In a "wrapped"
 * direction one rank holds the whole periodic box: the index wraps the direction, distances along this
 * direction are 0, and no images exist. The gradient of a shear is never wrapped: a rank that holds the whole
 * box along it has copies of its own particles. All functions but create and destroy are pure: any thread, any
 * rank, no communication. */
#ifndef SCREE_COMM_DOMAIN_H
#define SCREE_COMM_DOMAIN_H

#include "kernel/comm/comm.h"
#include "kernel/particles/box.h"

enum domain_kind { DOMAIN_BRICK, DOMAIN_BISECTION };
enum domain_weights { DOMAIN_WEIGHTS_PAIRS, DOMAIN_WEIGHTS_TIME, DOMAIN_WEIGHTS_PARTICLES };

struct domain_options {
    int grid[3]; /* bricks: ranks per direction; 0: chosen for the least surface */
    enum domain_kind kind;
    enum domain_weights weights; /* bisection: the measure for the weight of a particle */
    double threshold; /* bisection: divides again above this ratio of largest to mean load; 0: never */
};

/* A ball meets a rank: the ball, shifted by `image` (box edges), touches the subdomain of `rank`. */
struct domain_touch {
    int rank;
    signed char image[3];
};

/* A place next to a rank's own subdomain: a ball shifted by `image` that leaves the own subdomain may touch
 * that of `rank`. The corners are given as they are, and as seen from the own subdomain (moved back by the
 * image). */
struct domain_place {
    int rank;
    signed char image[3];
    double lower[3], upper[3];
    double seen_lower[3], seen_upper[3];
};

struct domain; /* private */
struct domain_tree;

/* Divides the box among the ranks. Fails (user), alike on all ranks, if `grid` does not fit the number of
 * ranks. Free entries of `grid` are chosen by domain_grid_choose without a density. A bisection begins with
 * equal volumes and has no grid. */
struct domain *domain_create(const struct comm *comm, const struct box *box,
                             const struct domain_options *options, struct error *error);
void domain_destroy(struct domain **domain);

/* The rank that owns a wrapped position; positions beyond an open side belong to the nearest subdomain. A
 * position on the face between two subdomains belongs to the upper one. */
int domain_owner(const struct domain *domain, const double x[3]);

/* The owner of a wrapped position; without a search if the owner is `rank`, whose bounds (domain_bounds) are
 * given. */
static inline int domain_owner_from(const struct domain *domain, int rank, const double lower[3],
                                    const double upper[3], const double x[3]) {
    bool inside = x[0] >= lower[0] && x[0] < upper[0] && x[1] >= lower[1] && x[1] < upper[1] &&
                  x[2] >= lower[2] && x[2] < upper[2];
    return inside ? rank : domain_owner(domain, x);
}

/* The ranks whose subdomain a ball touches (sphere to box distance <= radius), with the image under which the
 * ball touches, each (rank, image) once; the subdomains at open sides extend to infinity outwards. In wrapped
 * directions the image is 0. `x` is wrapped; `radius` is less than the box edge in the other periodic
 * directions, so that images beyond -1 ... 1 do not occur. The ranks need not be neighbours of this rank.
 * Writes up to `room` entries and returns the number of ranks found; the order of the entries depends on the
 * arguments alone. */
int domain_touching(const struct domain *domain, const double x[3], double radius, struct domain_touch *touch,
                    int room);

/* The places next to the subdomain of this rank (the closed cuboids meet, if only in a corner), sorted by
 * rank and image. The own subdomain is not among the places; images of the own subdomain may be. A rank needs
 * only these places and domain_clearance to send copies. Borrowed until the domain is divided again, or follows
 * its box. */
const struct domain_place *domain_neighbours(const struct domain *domain, size_t *count);

/* The distance of the nearest place that is neither the own subdomain nor next to it: a ball with its centre
 * in the own subdomain and a smaller radius touches nothing beyond the neighbours. */
double domain_clearance(const struct domain *domain);

/* Squared distance of a point from a place's subdomain, computed as in all other code: x + image * edge
 * (box_shift) first, squares added in the order x, y, z. `image` is the image of the point. */
double domain_place_distance2(const struct domain *domain, const struct domain_place *place,
                              const double x[3], const int image[3]);

/* Lays the bricks again, ranks per direction. Collective in effect: all ranks give the same grid. */
void domain_lay(struct domain *domain, const int grid[3]);

/* Divides a bisection again; the domain becomes the owner of the tree. Collective in effect: all ranks give
 * the same tree. */
void domain_divide(struct domain *domain, struct domain_tree *tree);
bool domain_bisects(const struct domain *domain);

/* The tree of a bisection, borrowed until the domain is divided again; NULL for bricks. */
const struct domain_tree *domain_tree(const struct domain *domain);

/* Lower and upper corner of a rank's subdomain (infinite at open sides). */
void domain_bounds(const struct domain *domain, int rank, double lower[3], double upper[3]);

/* The directions in which one rank holds the whole, periodic box; the index wraps these directions. */
void domain_wrap(const struct domain *domain, bool wrap[3]);

/* Takes over the edges and the offset of a box that has moved: at a rebuild, before particles are asked for
 * their owners. The subdomains stretch with the box. */
void domain_follow(struct domain *domain, const struct box *box);

/* The image under which a ball at `x` touches a place with `image`: in a wrapped direction of flow the place
 * does not say how far the offset of a shear has carried the image, and this function brings the image back
 * into the box. Changes nothing in a box without shear. */
void domain_settle_image(const struct domain *domain, const double x[3], int image[3]);

/* The ranks per direction, for the report; 0 for a bisection. */
void domain_grid(const struct domain *domain, int grid[3]);

#endif
