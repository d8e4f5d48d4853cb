/* Who owns which part of the box. Everything else asks only these questions, so that bricks can be
 * replaced by bisection without a change elsewhere. Positions are box-relative.
 *
 * A subdomain is a cuboid, closed for the purpose of distances; together they tile the box. At an open side
 * the outermost ones extend to infinity, so that every position has an owner. In a direction where one rank
 * holds the whole periodic box ("wrapped") there is nothing to divide: the index wraps it, distances along it
 * are 0 and no images exist. All functions but create and destroy are pure: any thread, any rank, no
 * communication. */
#ifndef SCREE_COMM_DOMAIN_H
#define SCREE_COMM_DOMAIN_H

#include "comm/comm.h"
#include "particles/box.h"

enum { DOMAIN_IMAGES = 27 };

struct domain_options {
    int grid[3]; /* ranks per direction; 0: chosen for the least surface */
};

/* A place where a rank meets a ball: the ball, shifted by `image` (box edges), touches the subdomain of
 * `rank`. */
struct domain_touch {
    int rank;
    signed char image[3];
};

struct domain; /* private */

/* Divides the box among the ranks. Fails (user), alike on all ranks, if `grid` does not fit the number of
 * ranks; a 2D box is never divided in z. Free choices take the grid that cuts the box along the smallest
 * area; among equal ones that with the thickest subdomains. */
struct domain *domain_create(const struct comm *comm, const struct box *box,
                             const struct domain_options *options, struct error *error);
void domain_destroy(struct domain **domain);

/* The rank that owns a wrapped position; positions beyond an open side belong to the nearest subdomain. A
 * position on the face between two subdomains belongs to the upper one. */
int domain_owner(const struct domain *domain, const double x[3]);

/* The ranks whose subdomain a ball touches (sphere to box distance <= radius), with the image under which it
 * does, each (rank, image) once; the subdomains at open sides extend to infinity outwards. In wrapped
 * directions the image is 0. `x` is wrapped; `radius` is less than the box edge in the other periodic
 * directions, so that images beyond -1 ... 1 do not occur. Not limited to neighbours of anybody. Writes up to
 * `room` entries and returns how many there are; their order depends on the arguments alone. */
int domain_touching(const struct domain *domain, const double x[3], double radius, struct domain_touch *touch,
                    int room);

/* Lower and upper corner of a rank's subdomain (infinite at open sides). */
void domain_bounds(const struct domain *domain, int rank, double lower[3], double upper[3]);

/* Directions in which one rank holds the whole, periodic box: the index wraps them. */
void domain_wrap(const struct domain *domain, bool wrap[3]);

/* The ranks per direction, for the report. */
void domain_grid(const struct domain *domain, int grid[3]);

#endif
