/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of a step: contacts of grains, and of grains with walls, that may close within the step.
 *
 * Of a pair of materials the terms say how a contact answers:
 *   kappa       stiffness of rigid contacts in units of the step: stiffness = kappa / (dt^2 x inverse mass of the
 *               contact), the same at all times; INFINITY: rigid rows
 *   an implicit law (`stiffness` > 0) has its own springs instead: linear, or Hertz's with the exponent 3/2
 *   restitution of impacts that are over within two steps; the damper of an implicit law makes that of longer ones */
#ifndef SCREE_HARD_CONTACTS_H
#define SCREE_HARD_CONTACTS_H

#include "physics/hard/pairs.h"
#include "physics/hard/models.h"
#include "physics/hard/problem.h"
#include "physics/hard/offers.h"
#include "physics/hard/thin.h"
#include "physics/grains/walls/wall.h"

/* An approach faster than so many times a dt is an impact: a is the largest acceleration without contacts, and that by the
 * contact's own pull. */
#define HARD_IMPACT_SPEED 8.0

struct hard_term {
    double friction, restitution;
    double stiffness;  /* force/length; of Hertz force/length^2, times the contact radius; 0: by kappa */
    double tangential; /* the same of the tangential spring */
    double damper;     /* over sqrt(mass x stiffness) */
    double rolling;    /* coefficient of rolling friction */
    struct law_solved rolls;
    double twisting;        /* largest moment over the normal force; length */
    double twist_stiffness; /* moment over angle */
    double pull; /* of a cohesion while the surfaces touch: force over the effective radius; 0: none */
};

struct hard_terms {
    double kappa;
    double repair; /* largest release of an overlap in a step, over the smaller radius; rigid contacts */
    bool hertz;
    hard_relaxation *relax; /* of contacts with a body of spheres */
    bool poisson;           /* impacts rebound by Poisson's restitution */
    bool open;              /* of all contacts: spheres have no closed form in this model */
    bool resists;           /* some contacts resist rolling or twisting */
    bool pulls;             /* some contacts have a cohesion */
    double press;           /* limits of friction count the pull so many times beside the push */
    int materials;
    struct hard_term *pair; /* materials x materials */
};

static inline const struct hard_term *hard_term_of(const struct hard_terms *terms, int a, int b) {
    return &terms->pair[(size_t)a * (size_t)terms->materials + (size_t)b];
}

/* What a contact with a wall remembers. */
struct hard_wall_memory {
    uint32_t particle;
    int32_t wall, feature;
    struct hard_memory memory;
    struct hard_couple couple;
};

/* One contact with a wall in the step, of a sphere or of a point of a rock. */
struct hard_wall_contact {
    struct wall_place place;
    bool rock;
    double arm[3]; /* of a rock: from the centre of the particle to the point */
    double radius; /* of the surface */
    double size;   /* struct hard_touch */
    struct hard_memory memory;
    struct hard_couple couple;
    uint32_t body;  /* of the particle, or that carries it */
    uint64_t order; /* of the contacts of a body: from ids */
};

/* The particles as the contacts see them. Borrowed. */
struct hard_scene {
    const struct particles *particles;
    const uint8_t *material; /* NULL: all 0 */
    const int *wall_material;
    struct walls *walls; /* NULL: none */
    const struct pairlist *list;
    const struct hard_clumps *clumps;
    struct hard_rocks *rocks; /* its offers are found anew in each step */
    int threads;
};

/* The step. */
struct hard_pace {
    double dt, duration;
    double near; /* contacts with larger gaps cannot close in this step; length */
    double fall; /* the largest acceleration without contacts */
    int sweeps;  /* at most */
};

struct hard_contacts {
    uint32_t *pair; /* of each row of a pair: its number in struct hard_pairs */
    uint32_t *spot; /* the same: its offer, if a rock is one of the pair; only where the scene has rocks */
    size_t spot_room;
    size_t pair_rows, pair_room;
    size_t walls, wall_room;
    struct hard_wall_contact *wall; /* of the rows behind those of pairs, by body */
    struct hard_wall_memory *past;  /* of the last step, by particle */
    size_t pasts, past_room;
    struct hard_arm *arm; /* of each row, where bodies or the model ask for them */
    size_t arm_room;
    struct hard_resist *resist; /* of each row, where some resist */
    size_t resist_room;
    uint8_t *
        dropped; /* of each pair, then of each offer of rocks: other contacts of its bodies stand for it (thin.h) */
    size_t dropped_room;
    struct hard_point *point;
    size_t point_room;
    struct hard_wall_found {
        size_t count, room;
        struct wall_place *place;
    } * found; /* by thread */
};

void hard_contacts_create(struct hard_contacts *contacts, int threads);
void hard_contacts_free(struct hard_contacts *contacts, int threads);

/* Makes the rows of the problem, whose bodies 0 ... are the particles, copies behind the owned ones, with the velocities
 * that they would have without contacts. Each contact with a wall adds a body, the wall at that place. Takes the memory
 * of all contacts away. One thread opens teams of its own. */
void hard_contacts_find(struct hard_contacts *contacts, struct hard_problem *problem,
                        struct hard_pairs *pairs, const struct hard_scene *scene,
                        const struct hard_terms *terms, const struct hard_pace *pace);

/* The surfaces of a contact (struct hard_touch), and what it remembers. */
struct hard_ends {
    double radius[2], size;
    double light; /* sum of 1/mass; of members by their shares of the mass */
    const struct hard_memory *memory;
    const struct hard_couple *couple; /* of a row that resists */
};

/* Makes what remains of a row once bodies, normal, levers, arm, gap and the place for resistances are known. Any thread. */
void hard_row_finish(struct hard_row *row, const struct hard_problem *problem, const struct hard_terms *terms,
                     const struct hard_term *term, const struct hard_pace *pace,
                     const struct hard_ends *ends);

/* The separation of the spheres of pair m, from the first to the second, and its length; returns the gap. True if they may
 * touch in the step. Any thread. */
double hard_contacts_separate(const struct hard_pairs *pairs, const struct hard_scene *scene, size_t m,
                              double apart[3], double *distance);
bool hard_contacts_near(const struct hard_pairs *pairs, const struct hard_scene *scene,
                        const struct hard_pace *pace, size_t m);

/* A number for two: another pair has another one, as good as always. Any thread. */
uint64_t hard_contacts_order(int64_t a, int64_t b);

/* Drops those of contacts->wall, and marks those pairs, for which other contacts of the same bodies stand. One thread. */
void hard_contacts_thin(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                        const struct hard_scene *scene, const struct hard_pace *pace);

/* The particles of row r, of which bodies may be carried; behind the rows of pairs SIZE_MAX for the wall. */
void hard_contacts_ends(const struct hard_contacts *contacts, const struct hard_pairs *pairs, size_t r,
                        size_t end[2]);

/* Turns what contacts remember into rows of the pairs (pairs.h), those with walls with a negative partner; takes these back
 * before hard_pairs_make. */
void hard_contacts_detach(const struct hard_contacts *contacts, struct hard_pairs *pairs,
                          const struct hard_rocks *rocks, const struct pairlist *list,
                          const struct particles *particles);
/* Gives the rows of walls the numbers that these have now, by the old number; -1: the wall is gone. */
void hard_contacts_rename(const struct hard_pairs *pairs, struct history_rows *rows, const int *now,
                          int walls, size_t owned);
void hard_contacts_attach(struct hard_contacts *contacts, const struct hard_pairs *pairs,
                          const struct particles *particles);

/* Gives all contacts that are no impacts the memory of the solved problem. */
void hard_contacts_remember(struct hard_contacts *contacts, const struct hard_problem *problem,
                            struct hard_pairs *pairs, struct hard_rocks *rocks, const struct hard_pace *pace);

#endif
