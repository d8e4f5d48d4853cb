/* SPDX-License-Identifier: BSD-3-Clause */
/* Walls: planes, cylinders, triangle meshes and shapes made of triangles, each with a material and a motion. A wall uses the
 * particles' contact laws, as a partner of infinite mass and infinite radius (m* = m, R* = r).
 *
 *   plane      infinite and one-sided: beyond it is solid, however deep
 *   cylinder   infinite: one-sided, solid beyond it. Finite: the shell alone, without end caps; it is felt
 *              within a radius of the sphere to both sides, pushes to the side named by `inside`, and its
 *              rims are edges. A sphere larger than the opening of a tube touches it at one point of the rim
 *   mesh       a two-sided surface of triangles. A sphere that touches several triangles of one flat patch
 *              feels one plane; edges and vertices count once, and only where no face covers them
 *              (wall_touch.h)
 *   rectangle, box, disc, cone   surfaces like a mesh, of triangles that the program makes (mesh_shape.h)
 *
 * A contact with a wall belongs to a *feature* of it: the plane; the shell of a cylinder (0) or a rim (1, 2);
 * of a mesh a flat patch, an edge between patches or a vertex of one (numbered in this order). The history of
 * a contact is keyed by particle, wall and feature; between rebuilds also by the periodic image of the wall,
 * and over a rebuild contacts with one feature through several images go on in the order of these. If a
 * contact appears and another one of the same particle and wall vanishes in the same step, and both point the
 * same way within 60 degrees, the sphere has crossed an edge: the history is carried over, turned with the
 * normal.
 *
 * Every rank holds all walls (meshes are small beside particles) and moves them alike, so wall poses are
 * never sent; only the forces on walls are summed over ranks, where an observable or a servo wants them.
 * Lengths are box-relative inside; walls_create shifts the user's values. In periodic directions meshes and
 * finite or solid cylinders are felt through the nearest images too. */
#ifndef SCREE_WALLS_WALL_H
#define SCREE_WALLS_WALL_H

#include "physics/grains/batch/force.h"
#include "physics/grains/walls/wall_options.h"
#include "physics/grains/laws/law.h"
#include "kernel/pairs/history_rows.h"
#include "kernel/particles/particles.h"
#include <stdio.h>

/* Pose of a wall: x = R x0 + t, and its velocity. A checkpoint stores this struct for each wall; doubles
 * alone. The centre is the body's point that lay on the axis of the first rotation at the start; without one
 * the wall's point, or the middle of the mesh; of a free wall the centre of mass, or if it turns about an axis the point
 * of the axis. */
struct wall_pose {
    double rotation[9]; /* row by row */
    double translation[3];
    double velocity[3], omega[3]; /* half-step, of the body: v(x) = velocity + omega x (x - centre) */
    double centre[3];
    double servo_speed;  /* along the servo's direction */
    double servo_offset; /* its displacement so far */
    /* The pose that the motions act upon: none, unless a run was resumed with other motions, which then start from
     * the pose that they find. */
    double base_rotation[9];
    double base_translation[3];
    double force[6]; /* force and torque in the last evaluation, this rank's part; in a checkpoint the
                        sum over ranks, of which rank 0 takes all when it is read */
};

/* What the particles do to a wall that follows them, summed over all ranks: force, torque about the wall's centre, and
 * the mechanical impedance of those that touch the wall, sum of sqrt(m f / overlap) (mass/time). The sum of the
 * impedances is exact: each term is a multiple of a power of two that belongs to the wall, so that no layout changes the
 * sum. */
struct wall_push {
    double force[3], torque[3];
    double impedance;
};

struct walls; /* all walls of a scene, their meshes, candidate lists and contact histories */

/* Reads meshes and tables, finds flat patches, checks everything (file and line in errors; slivers and
 * duplicate vertices are repaired or refused by name). Places the walls as they are at time 0. `notes` (may
 * be NULL) receives the repairs. `law` and `box` are copied or borrowed as follows: box is copied, law
 * must live as long as the walls. One thread; every rank does the same. Destroy frees and nulls. */
bool walls_create(struct walls **walls, const struct wall_options *options, int count, const struct law *law,
                  const struct box *box, int threads, struct error *error, FILE *notes);
void walls_destroy(struct walls **walls);

/* Takes another compiled kernel for the law than the best, as force_loop_choose does. All give the same bits.
 */
bool walls_choose(struct walls *walls, const char *kernel);

int walls_count(const struct walls *walls);
const struct wall_options *walls_options(const struct walls *walls, int wall);

/* Moves all walls from time t to t + dt (positions at t + dt, velocities of the half step). push[wall] is summed
 * over ranks already (NULL where no wall follows the particles, walls_follow_particles). */
void walls_advance(struct walls *walls, double t, double dt, const struct wall_push *push);

/* The area on which a pressure acts along `direction` (any length): of a plane across a direction of the box the
 * section of the box, of a mesh the area that its shadow would have if no triangle lay before another one (half
 * of that of a closed surface). 0 where no area follows from the shape. In two dimensions the area of a plane is
 * a length. Any thread. */
double walls_area(const struct walls *walls, int wall, const double direction[3]);

/* The impedance in the last evaluation, this rank's part: may be set. */
double *walls_impedance(struct walls *walls, int wall);

/* Gives the walls, which walls_advance has moved to t in a step dt, their velocities at t itself, until the next step. */
void walls_at_end(struct walls *walls, double t, double dt);
bool walls_have_servo(const struct walls *walls);
bool walls_move(const struct walls *walls);
/* True if the motion of a wall depends on the particles: one with a servo, or a free one. */
bool walls_follow_particles(const struct walls *walls);
bool walls_have_free(const struct walls *walls);

/* At a rebuild, where walls move and particles may be outside of the box: the corners (box-relative) of a box
 * that holds the centres of all particles, on all ranks the same. Without particles lower may lie above
 * upper. */
void walls_set_extent(struct walls *walls, const double lower[3], const double upper[3]);

/* Largest distance that a wall surface point within the box, or within the extent if it reaches farther, may
 * have moved since the last walls_build (a bound; a plane moving within itself and an infinite cylinder
 * turning about its axis have not moved). */
double walls_displacement(const struct walls *walls);

/* A bound on the speed of these points across the surface in the last half step. */
double walls_speed(const struct walls *walls);

/* True if a sphere at x (box-relative) would overlap a wall as it stands now, or be beyond a one-sided one.
 * The room inside of a closed mesh is not solid: only its surface is. Any thread. */
bool walls_overlap(const struct walls *walls, const double x[3], double radius);

/* The point of a wall nearest to a place, as the wall stands now, for physics to which walls are solids: the
 * distance, negative in the solid; the unit normal of the wall there, out of the solid; the velocity of the
 * wall's surface there, and its spin (rad/time), in the last half step. Solid is
 *
 *   plane      all that lies beyond it
 *   cylinder   particles outside: the cylinder, its ends included. Particles inside: all around the bore, of
 *              a finite cylinder as far as its length: a bore through a plate
 *   mesh       the side away from which the normals of its triangles point (right-hand rule). The surface must
 *              be closed (walls_open_edges). One that is felt by a field is that of the field, as far as walls_cover says,
 *              and farther away that of the triangles */
struct wall_foot {
    double distance, normal[3], velocity[3], spin[3];
};

/* The foot of x (box-relative) on a wall. On a mesh the distance is INFINITY if the surface is farther than
 * `reach`; with an infinite reach each triangle is looked at. Any thread. */
void walls_foot(const struct walls *walls, int wall, const double x[3], double reach, struct wall_foot *foot);

/* Lets fields reach at least so far from their surfaces. Opens its own team; no other thread may look. */
void walls_cover(struct walls *walls, double reach);

/* For a wall whose solid is bounded (walls_bounded): makes walls_depth ready up to `reach`. A mesh takes memory: a byte for each cube of 0.9 of this edge in
 * the box around it. Opens its own team. */
void walls_depth_prepare(struct walls *walls, int wall, double reach);

/* The signed distance of x (box-relative) from the solid of such a wall, negative inside, cut to -reach ... reach; `arm` is the vector from the wall's
 * centre (struct wall_pose) to x, in the image of the wall that is nearest or holds x. Any thread. */
double walls_depth(const struct walls *walls, int wall, const double x[3], double arm[3]);

/* True if the solid of a wall has an end in each direction, but for the axis of a cylinder: a closed mesh whose normals point out of it, or a cylinder with particles outside. One thread. */
bool walls_bounded(const struct walls *walls, int wall);

/* The edges of a mesh that are not shared by two triangles of one orientation: 0 of a closed surface, and of
 * other shapes. Any thread. */
size_t walls_open_edges(const struct walls *walls, int wall);

/* At a rebuild: for every owned particle the wall pieces nearer than r + margin(class, walls). Opens its own
 * team. */
void walls_build(struct walls *walls, const struct particles *particles, const struct size_classes *classes);

/* Forces of walls on thread `thread`'s share of the owned particles near walls, like ones for all threads;
 * adds to particles.force. Each thread's once an evaluation, in any order; many threads at once. */
void walls_force_share(struct walls *walls, const struct force_context *context, int thread);

/* Ends the evaluation: history buffers change places, sums of threads are added to `sums` (a contact with a
 * wall counts as one contact, two sides) and make the wall forces. One thread. */
void walls_finish(struct walls *walls, const struct force_context *context, struct force_sums *sums);

/* From now on forces on walls are summed without rounding (base/exact.h), so that they do not depend on the
 * division among threads and ranks. walls_finish then leaves them open: walls_exact gives the `count` words
 * of this rank's sums, to be added up over ranks in place, and walls_close makes the forces of them, on one
 * rank: `mine` there, and 0 elsewhere. */
void walls_set_exact(struct walls *walls);
int64_t *walls_exact(struct walls *walls, int *count);
void walls_close(struct walls *walls, double dt, bool mine);

/* Force and torque (about the wall's centre) of the particles on each wall in the last evaluation, this
 * rank's part: 6 doubles a wall. */
void walls_forces(const struct walls *walls, double (*force_torque)[6]);
void walls_set_forces(struct walls *walls, double (*force_torque)[6]); /* sets this rank's part */

/* The power of the moving surface of a wall on particles in the last evaluation, this rank's part; NULL if the surface
 * has no motion of its own. May be set. Any thread. */
double *walls_surface_power(struct walls *walls, int wall);

/* Work that walls did on particles since the start, this rank's part; energy. Mean of the forces at both ends
 * of a step times the motion in it; of a surface, mean of its powers at both ends. */
double walls_work(const struct walls *walls);
void walls_set_work(struct walls *walls, double work); /* for a resume */

/* From the next walls_build on, walls_visit finds particles whose motion is prescribed and that do not move. */
void walls_visit_fixed(struct walls *walls);

/* A place of a wall near a particle. */
struct wall_place {
    size_t particle;
    int wall;
    int32_t feature;      /* of the wall, see above */
    double gap;           /* between the surfaces; overlaps are negative */
    double normal[3];     /* unit vector from the centre of the particle to the wall */
    double velocity[3];   /* of the wall there, in the last half step, with that of a surface that moves */
    double at[3];         /* the point of the wall, box-relative, in the wall's own image */
    double torque[3];     /* of walls_push: on the wall, beside that of the force */
    const double *record; /* of the contact, in the history of the law; NULL: none */
};

/* Calls `visitor` for each owned particle and each place of a wall whose surface is nearer than `range` to that
 * of the particle. `range` lies within the range of the interactions, for which walls_build has found the particles near
 * walls. Each thread takes its own particles, in increasing order, thread after thread; a particle belongs to one
 * thread. Many threads at once, with different `thread`. */
typedef void walls_visitor(void *context, const struct wall_place *place);
void walls_visit(const struct walls *walls, const struct particles *particles, int thread, double range,
                 walls_visitor *visitor, void *context);

/* Adds a force on the wall, and place->torque, at such a place to the loads of the evaluation that walls_finish ends, and the impedance of what
 * pushes there (struct wall_push), which servos read. Many threads at once, with different `thread`. */
void walls_push(struct walls *walls, int thread, const struct wall_place *place, const double force[3],
                double impedance);

/* A plane as it stands now, box-relative, its normal towards the particles; false: the wall has another shape. Any thread. */
bool walls_plane(const struct walls *walls, int wall, double point[3], double normal[3]);

/* Velocity of the surface of a wall at a place of it, and its spin, in the last half step; `normal` of the wall there. Any
 * thread. */
void walls_surface_motion(const struct walls *walls, int wall, const double at[3], const double normal[3],
                          double velocity[3], double spin[3]);

/* What one contact does to a wall. */
struct wall_load {
    int wall;
    int32_t triangle; /* of a wall of triangles */
    double at[3];     /* the contact point, box-relative, in the wall's own image */
    double force[3];  /* on the wall */
    double
        push; /* the part of the force along the normal of the contact, above 0 where the particle presses */
};

/* The loads of all contacts with walls now, of this rank's particles. Allocated (memory_free). */
size_t walls_loads(const struct walls *walls, const struct force_context *context, struct wall_load **loads);

/* Contacts with walls now, for the contact list: id_j = -(wall + 1). Allocated (memory_free). */
size_t walls_contacts(const struct walls *walls, const struct force_context *context,
                      struct force_contact **contacts);

/* The partner of the row of a contact with a wall: below 0. A wall or a feature that no scene has gives 0, which is none. */
static inline int64_t wall_row_partner(int wall, int32_t feature) {
    bool may_be = wall >= 0 && wall < WALLS_MAX && feature >= 0;
    return may_be ? -1 - wall - (int64_t)WALLS_MAX * feature : 0;
}
/* The wall of such a row, and the number of its feature, see above; -1 of any other row. */
static inline int wall_row_wall(const struct history_row *row) {
    return row->partner < 0 ? (int)((-1 - row->partner) % WALLS_MAX) : -1;
}
static inline int32_t wall_row_feature(const struct history_row *row) {
    return row->partner < 0 ? (int32_t)((-1 - row->partner) / WALLS_MAX) : -1;
}
/* Before and after a rebuild; the partners of rows are those of wall_row_partner. detach allocates `rows` (also if there is no history: then no row) and forgets
 * the images of contacts, as the rows have no images: so a run that goes on without a rebuild and a run that
 * goes on from the rows are the same. attach gives the rows to the new candidates. attach drops rows of walls
 * or features that no longer exist, and of walls that the particle is no longer near. */
void walls_detach(struct walls *walls, const struct particles *particles, struct history_rows *rows);
void walls_attach(struct walls *walls, const struct history_rows *rows, const struct particles *particles);

/* Poses, for checkpoints and output. The wall's motions go on from a pose that was set: if these motions led
 * to the pose, as without a break (bitwise), else from the pose. */
void walls_pose(const struct walls *walls, int wall, struct wall_pose *pose);
void walls_set_pose(struct walls *walls, int wall, const struct wall_pose *pose);

/* Velocity of the centre of a wall and its angular velocity: of a free wall those at the full step (walls_free.h), else of the
 * last half step. */
void walls_velocity(const struct walls *walls, int wall, double velocity[3], double omega[3]);

/* The rotation vector (rad) of a wall from its pose at rest, of a length up to pi; of a wall that is free about an axis the
 * angle since it became free, all turns counted, along the axis. */
void walls_rotation(const struct walls *walls, int wall, double rotation[3]);

/* Energy of all free walls at the full step. */
double walls_energy(const struct walls *walls);

/* Displacement of the wall's centre (see struct wall_pose) from its place at rest in the scene; length. */
void walls_offset(const struct walls *walls, int wall, double offset[3]);

/* Triangles of a wall of triangles at its present pose, user's coordinates, 9 doubles each, for output; 0 for other
 * shapes. Allocated (memory_free). */
size_t walls_triangles(const struct walls *walls, int wall, double (**triangles)[9]);

/* The walls as they stand now as triangles, with what the particles do to each triangle: for output. A plane is cut to
 * the box (beyond the box: to its extent along the plane), an endless cylinder to the extent of the box, and cylinders
 * are drawn with WALL_SURFACE_SECTORS flat sides. */
enum { WALL_SURFACE_SECTORS = 64 };
struct wall_surface {
    size_t triangles;
    double (*corner)[9]; /* user's coordinates */
    int32_t *wall;       /* of each triangle */
    size_t parts;
    struct wall_surface_part *part; /* of the loads, in any order */
};

/* What a contact does to a triangle. */
struct wall_surface_part {
    uint64_t triangle;
    double load[4]; /* force; its part along the normal of the contact, above 0 where the particle presses */
};

/* Makes the surfaces, with the parts of this rank's particles (none if `context` is NULL). wall_surface_free
 * releases. One thread. */
void wall_surface_make(struct wall_surface *surface, const struct walls *walls,
                       const struct force_context *context);
void wall_surface_free(struct wall_surface *surface);

/* Adds up parts, of all ranks say, by triangle, and sorts them: the sums do not depend on their order. Allocated (memory_free), 4 doubles a
 * triangle. One thread. */
double (*wall_surface_sum(const struct wall_surface *surface, struct wall_surface_part *part,
                          size_t parts))[4];

/* Area of a triangle. */
double wall_surface_area(const double corner[9]);

/* The least angle (rad) by which a mesh wall turns at an edge, of those edges at which a sphere touches both
 * sides at a time (more than WALL_TOUCH_SMOOTH, wall_touch.h); INFINITY without such edges, or for other
 * shapes. */
double walls_turn(const struct walls *walls, int wall);

#endif
