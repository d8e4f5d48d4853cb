/* SPDX-License-Identifier: BSD-3-Clause */
/* Inside of the walls: the common part of walls.c (life and motion), walls_pose.c, walls_displacement.c,
 * walls_near.h (candidates), walls_touch.h (geometry of one sphere), walls_force.c, walls_sums.c, wall_surface.c,
 * walls_free.c and walls_history.h. No other file includes this one.
 *
 * Candidates. At a rebuild each owned particle near a wall becomes a candidate, in the order of the
 * particles, with the *pieces* near it: (wall, image, triangle), sorted. Candidate k has the pieces first[k]
 * ... first[k + 1]. A contact belongs to a piece at least, so the same numbers lay out its records of
 * history: at most as many as it has pieces. Two buffers of records: an evaluation reads the one that is
 * `now` and writes the other; as a candidate's records lie at a fixed place, evaluations need no order and no
 * thread has a buffer of its own.
 *
 * Most spheres at a mesh lie above one triangle, farther from its rim than they move until the next rebuild, with no other patch
 * near. Their contact is that with the plane of the patch: the first piece says so (`face`), and nothing is resolved. The bits
 * are those of the long way. */
#ifndef SCREE_WALLS_WALLS_PARTS_H
#define SCREE_WALLS_WALLS_PARTS_H

#include "physics/grains/batch/force_kernel.h"
#include "physics/grains/walls/wall.h"
#include "physics/grains/walls/wall_bulk.h"
#include "physics/grains/walls/wall_field.h"
#include "physics/grains/walls/wall_free.h"
#include "physics/grains/walls/wall_grid.h"
#include "physics/grains/walls/wall_motion.h"
#include "physics/grains/walls/wall_touch.h"
#include "base/exact.h"

/* One wall. */
struct wall {
    struct wall_options options; /* as the user gave them; names stay */
    struct law_vector point,
        axis;               /* PLANE: point and normal; CYLINDER: middle and axis; box-relative, at rest */
    struct wall_mesh *mesh; /* MESH */
    struct wall_grid *grid;
    struct wall_field *field; /* NULL: the mesh is felt by its triangles */
    struct wall_bulk *bulk;   /* NULL: nobody asked for depths (walls_depth) */
    struct wall_motions *motions;
    struct wall_free *free;   /* NULL: the wall is not free */
    struct law_vector centre; /* at rest, see struct wall_pose */
    double reach[3]; /* of cylinder and mesh at rest: how far from the middle along x, y, z, at most */

    struct wall_transform pose, base; /* now; the pose that the motions act upon */
    struct wall_twist twist;          /* of the half step */
    struct wall_twist surface;        /* of the surface beside the wall, of the half step */
    bool slides;                      /* the surface has a motion of its own */
    double servo_offset, servo_speed;
    double unit;  /* of its impedance; 0: nobody needs it */
    bool moving;  /* its pose is not the identity, or may change */
    bool resumed; /* the pose was set from outside: `base` has still to be found */

    struct law_vector point_now, axis_now; /* point and axis at the pose */
    struct law_vector centre_now;          /* and the centre */
    struct wall_transform built;           /* the pose at the last walls_build */
    bool images;                           /* felt through periodic images */
    double wrap[3];                        /* brings the centre into the box, by walls_wrap */
    int image_count;
    int image[IMAGE_CODES]; /* codes of the images to look at */
};

/* A piece of a wall that is felt by a field is all of one of its images. */
enum { WALL_PIECE_FIELD = -1 };

struct wall_piece {
    int32_t triangle; /* MESH; WALL_PIECE_FIELD */
    uint8_t wall, image;
    uint8_t
        face; /* of the first piece of a wall: 1 + the place among them of the only triangle whose face may be touched */
};

/* Key of a record's contact. WALL_IMAGE_LOST: the image is no longer known, as a rebuild may have wrapped the
 * particle. */
enum { WALL_IMAGE_LOST = -1 };
struct wall_key {
    int16_t wall, image;
    int32_t feature;
};

struct wall_records {
    int32_t *count; /* of each candidate */
    struct wall_key *key;
    double *value; /* history_components doubles a record */
};

/* Contacts on their way through the law, which takes FORCE_BATCH of them at a time, in the order of the
 * candidates. contact: input and results of the law for contact k. entry[k]: the candidate, particle and wall
 * of contact k. */
struct wall_batch {
    struct force_batch contact;
    struct wall_entry {
        size_t candidate, particle;
        struct wall_key key;
        int32_t triangle;     /* of a mesh */
        struct law_vector at; /* the contact point, in the wall's image */
        double lever, radius;
    } entry[FORCE_BATCH];
};

/* What contacts do to a wall, in sums: force, torque, and the power of the surface on particles. */
enum { WALL_FORCE, WALL_TORQUE = 3, WALL_POWER = 6, WALL_LOADS };

/* Memory of a thread for one particle, its batch, and its sums. */
struct wall_scratch {
    size_t capacity;
    struct wall_nearest *near;
    struct wall_touch *touch;
    int32_t *from;  /* old record that a contact goes on with, -1: none */
    uint8_t *taken; /* old record has found its contact */
    struct wall_batch *batch;
    struct force_sums sums;
    double (*load)[WALL_LOADS]; /* on each wall */
    double *impedance;          /* of each wall */
    struct exact (
        *exact)[WALL_LOADS]; /* instead of load, where loads are summed without rounding; else NULL */
};

struct walls {
    int count, threads;
    struct wall *wall;
    struct box box;
    double extent[2][3];   /* lower and upper corner: holds the box and all particles */
    double gravity[3];     /* of free walls */
    const struct law *law; /* borrowed */
    bool fixed_too;        /* particles at rest are candidates of walls at rest, too (walls_visit) */
    const struct force_kernel *kernel; /* the law over a batch of contacts */
    double shift[IMAGE_CODES][4];

    size_t candidates, candidate_capacity, piece_capacity;
    uint32_t *particle; /* of each candidate, increasing */
    size_t *first;      /* candidates + 1 */
    struct wall_piece *piece;
    uint32_t *near_count; /* scratch of a build: pieces of each owned particle */
    size_t near_capacity;
    int now;
    struct wall_records records[2];
    struct wall_scratch **scratch; /* each thread's in pages of its own */

    double (*force)[6]; /* on each wall in the last evaluation */
    double *power;      /* of each wall's surface on particles in the last evaluation */
    double *impedance;  /* of each wall in the last evaluation, a multiple of its unit */
    struct exact (
        *exact)[WALL_LOADS]; /* sums of forces and powers, while they are open; NULL: they are rounded */
    double work;
};

/* A sphere as a wall sees it: in the wall's image. */
struct wall_sphere {
    struct law_vector x, v;
    double radius;
};

/* The vector that image `code` of a wall is away from the wall itself. */
static inline struct law_vector walls_shift(const struct walls *walls, int wall, int code) {
    const double *shift = walls->shift[code], *wrap = walls->wall[wall].wrap;
    return (struct law_vector){shift[0] + wrap[0], shift[1] + wrap[1], shift[2] + wrap[2]};
}

/* The inverse of the mass of a wall against a push along a unit vector at a place in its own image; 0: nothing moves it. */
static inline double walls_yield_of(const struct wall *wall, struct law_vector at, struct law_vector along) {
    return wall->free ? wall_free_yield(wall->free, at, along) : 0.0;
}

/* Sets the members of a wall that follow from its pose. */
static inline void walls_follow(struct wall *wall) {
    wall->point_now = wall_transform_point(&wall->pose, wall->point);
    wall->axis_now = wall_turn(wall->pose.rotation, wall->axis);
    wall->centre_now = wall_transform_point(&wall->pose, wall->centre);
}

/* Adds the impedance of a contact to that of its wall, rounded to the wall's unit: sums are exact then. Nothing for walls that
 * need none. Any thread, with its own scratch. */
void walls_impede(const struct walls *walls, struct wall_scratch *scratch, int wall, double impedance);

/* The velocity of the surface beside that of the wall at a point with this normal: along the surface. */
static inline struct law_vector walls_slip(const struct wall *wall, struct law_vector at,
                                           struct law_vector normal) {
    struct law_vector velocity = wall_twist_at(&wall->surface, at);
    return law_add(velocity, -law_dot(velocity, normal), normal);
}

/* A position in the frame of a mesh. */
static inline struct law_vector walls_into_body(const struct wall *wall, struct law_vector x) {
    return wall->moving ? wall_transform_back(&wall->pose, x) : x;
}

#endif
