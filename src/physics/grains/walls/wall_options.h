/* SPDX-License-Identifier: BSD-3-Clause */
/* What a user says of a wall: its shape, its motions, and what makes it free. Shapes and features are told in wall.h. */
#ifndef SCREE_WALLS_WALL_OPTIONS_H
#define SCREE_WALLS_WALL_OPTIONS_H

#include <stdbool.h>

/* Walls at most: a piece of a wall keeps the number of its wall in a byte. */
enum { WALLS_MAX = 255, WALL_NAME_MAX = 64, WALL_PATH_MAX = 1024, WALL_MOTIONS_MAX = 8 };

enum wall_shape {
    WALL_PLANE,
    WALL_CYLINDER,
    WALL_MESH,
    WALL_RECTANGLE, /* from here on: triangles made by mesh_shape_make */
    WALL_BOX,
    WALL_DISC,
    WALL_CONE
};

/* True of the shapes that are surfaces of triangles. */
static inline bool wall_shape_meshed(enum wall_shape shape) {
    return shape >= WALL_MESH;
}

enum wall_motion_kind {
    WALL_TRANSLATE,          /* velocity */
    WALL_ROTATE,             /* angular velocity about a point and axis */
    WALL_OSCILLATE,          /* amplitude x sin(2 pi f t + phase) along a direction */
    WALL_OSCILLATE_ROTATION, /* angle amplitude about a point and axis */
    WALL_TABLE, /* pose against time from a file: t x y z angle_x angle_y angle_z (rotation vector), linear
                   between rows */
    WALL_SERVO /* along a direction, so that the force on the wall along it becomes `force`, or `pressure` times
                   the area; motions behind it turn the direction */
};

/* One motion. Outside of start ... stop it rests where it was last: displacement and angle are functions of
 * the time, cut to that span. Several motions of a wall are applied one after another, the first one first:
 * rotate, then translate turns the wall about an axis that travels; translate, then rotate about a fixed one.
 *
 * A motion of the surface gives the surface a velocity beside that of the wall. A contact takes the part of it that is
 * at right angles to the contact's normal. Motions of the wall behind it turn and carry it, as those before it do not. */
struct wall_motion {
    enum wall_motion_kind kind;
    bool surface; /* the surface alone moves, within itself, as a belt does: the wall stays. Not a servo */
    double start, stop;      /* active while start <= t < stop; time */
    double direction[3];     /* axis or direction, any length but 0 */
    double point[3];         /* a point of the axis (TABLE: of all axes), user's coordinates */
    double velocity[3];      /* TRANSLATE, length/time */
    double rate;             /* ROTATE: rad/time */
    double amplitude;        /* OSCILLATE: length; OSCILLATE_ROTATION: rad */
    double frequency, phase; /* 1/time, rad */
    double force;    /* SERVO: target force of the particles on the wall along direction, not 0; below it the
                         wall     moves against direction, towards the particles that push */
    double pressure; /* SERVO: instead of force, if above 0: walls_create sets force = pressure x area */
    double area; /* SERVO: across direction, for pressure; not above 0: walls_create finds it (wall_area) */
    double speed_max; /* SERVO: bound on the speed */
    double gain; /* SERVO: speed per relative force error, length/time; 0: from the impedance of the grains
                         that touch the wall */
    char table[WALL_PATH_MAX]; /* TABLE */
};

/* How a free wall may move. */
enum wall_freedom {
    WALL_FREE_ALL,   /* in each direction, and turn */
    WALL_FREE_SHIFT, /* in each direction, without turning */
    WALL_FREE_ALONG, /* along a direction alone */
    WALL_FREE_ABOUT  /* turn about an axis alone */
};

/* What makes a wall free (wall_free.h). Numbers that are not given are NAN. */
struct wall_free_options {
    int given; /* 0: the wall is not free; the other members are not read */
    enum wall_freedom freedom;
    double mass, density; /* one of the two */
    int centre_given, inertia_given;
    double centre[3];                /* of mass, user's coordinates */
    double inertia[6];               /* xx yy zz xy xz yz about the centre of mass */
    double direction[3];             /* ALONG, ABOUT: any length but 0 */
    double point[3];                 /* ABOUT: a point of the axis, user's coordinates */
    int velocity_given, omega_given; /* numbers given; 0: none, and the others are 0 */
    double velocity[3];              /* ALL, SHIFT: at the start, or anew; ALL: and the angular velocity */
    double omega[3];                 /* rad/time */
    double speed; /* the same, ALONG: along the direction; ABOUT: angular velocity about it; NAN: not given */
    double load;  /* ALONG: force along the direction; ABOUT: torque about it */
    double spring, damper; /* ALONG, ABOUT: against the displacement or angle, and against the speed */
};

struct wall_options {
    char name[WALL_NAME_MAX];
    enum wall_shape shape;
    int material;
    double point
        [3]; /* PLANE: a point; CYLINDER: a point of the axis; RECTANGLE: a corner; DISC: the middle; CONE: the
                         middle of the first end; user's coordinates */
    double normal[3]; /* PLANE: towards the particles; DISC: any of the two */
    double axis[3];   /* CYLINDER; CONE: from the first end to the second one */
    double radius;    /* CYLINDER, DISC; CONE: of the first end */
    double
        length; /* CYLINDER: extent along the axis to both sides of point in total; 0: infinite. CONE: above 0 */
    double radius_end;          /* CONE: of the second end, 0: a tip */
    double hole;                /* DISC: radius of a round hole in the middle; 0: none */
    double along[3], across[3]; /* RECTANGLE: its sides from the corner */
    double lower[3], upper[3];  /* BOX: corners, user's coordinates */
    int segments;               /* DISC, CONE: flat parts around the axis, at least 3 */
    bool inside;                /* CYLINDER: particles inside (true) or outside */
    char file[WALL_PATH_MAX];   /* MESH: STL (ASCII or binary) or a table of nine numbers a row */
    char format[16];            /* MESH: "stl", "table", or "" = by content */
    double scale;               /* MESH: lengths in the file x this */
    double offset[3];           /* MESH: added after scaling */
    bool field;                 /* MESH: felt by a distance field (wall_field.h) */
    double field_spacing;       /* of its nodes, length; NAN: by the size of the mesh */
    bool permeable;             /* holds grains alone: a fluid goes through */
    int motions;
    struct wall_motion motion[WALL_MOTIONS_MAX];
    struct wall_free_options free; /* goes with no motions */
};

/* True if the wall may move: by motions, or freely. */
static inline bool wall_moves(const struct wall_options *options) {
    return options->motions > 0 || options->free.given != 0;
}

#endif
