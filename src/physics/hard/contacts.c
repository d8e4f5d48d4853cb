/* SPDX-License-Identifier: BSD-3-Clause */
/* From coloured pairs and places of walls to rows, and what contacts remember. Read contacts.h first. */
#include "physics/hard/contacts.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

static const char what[] = "contacts of a step";

/* Rows of walls in a cut, those of one body always together. */
enum { WALL_CUT = 64 };

void hard_contacts_create(struct hard_contacts *contacts, int threads) {
    *contacts = (struct hard_contacts){0};
    contacts->found = memory_allocate_zero((size_t)threads, sizeof *contacts->found, what);
}

void hard_contacts_free(struct hard_contacts *contacts, int threads) {
    for (int t = 0; t < threads; t++)
        memory_free(contacts->found[t].place);
    memory_free(contacts->found);
    memory_free(contacts->pair);
    memory_free(contacts->spot);
    memory_free(contacts->wall);
    memory_free(contacts->past);
    memory_free(contacts->arm);
    memory_free(contacts->resist);
    memory_free(contacts->dropped);
    memory_free(contacts->point);
    *contacts = (struct hard_contacts){0};
}

static int material_number(const struct hard_scene *scene, size_t i) {
    return scene->material ? scene->material[i] : 0;
}

double hard_contacts_separate(const struct hard_pairs *pairs, const struct hard_scene *scene, size_t m,
                              double apart[3], double *distance) {
    const struct particle_state *i = &scene->particles->state[pairs->end[m][0]],
                                *j = &scene->particles->state[pairs->end[m][1]];
    const double *shift = scene->list->shift[pairs->image[m]];
    for (int d = 0; d < 3; d++)
        apart[d] = (j->x[d] - i->x[d]) + shift[d];
    *distance = sqrt(vector_dot(apart, apart));
    return *distance - (i->radius + j->radius);
}

/* Gives row r an arm if one of its particles is carried by a body, or all rows have one. A particle UINT32_MAX is a wall. */
static void arm_make(struct hard_contacts *contacts, struct hard_row *row, size_t r,
                     const struct hard_scene *scene, const struct hard_terms *terms, const uint32_t sphere[2],
                     const struct hard_touch *touch) {
    bool carried = false;
    for (int e = 0; e < 2; e++)
        carried = carried || (sphere[e] != UINT32_MAX && hard_clumps_carries(scene->clumps, sphere[e]));
    if (!carried && !terms->open)
        return;
    struct hard_arm *arm = &contacts->arm[r];
    *arm = (struct hard_arm){.relax = terms->relax};
    for (int e = 0; e < 2; e++) {
        double along = e ? -touch->lever[1] : touch->lever[0];
        for (int d = 0; d < 3 && touch->arm; d++)
            arm->branch[d] += e ? -touch->arm[1][d] : touch->arm[0][d];
        if (sphere[e] == UINT32_MAX)
            continue;
        if (hard_clumps_carries(scene->clumps, sphere[e])) {
            hard_clumps_lever(scene->clumps, sphere[e], arm->lever[e]);
            arm->turn[e] = hard_clumps_turn(scene->clumps, sphere[e]);
        }
        for (int d = 0; d < 3; d++)
            arm->lever[e][d] += touch->arm ? touch->arm[e][d] : along * row->normal[d];
    }
    for (int d = 0; d < 3 && touch->arm == NULL; d++)
        arm->branch[d] = (row->lever[0] + row->lever[1]) * row->normal[d];
    row->arm = arm;
}

/* Gives row r the place of its resistances, if the pair of materials has some. */
static void resist_place(struct hard_contacts *contacts, struct hard_row *row, size_t r,
                         const struct hard_term *term) {
    if (term->rolling > 0.0 || term->twisting > 0.0)
        row->resist = &contacts->resist[r];
}

bool hard_contacts_near(const struct hard_pairs *pairs, const struct hard_scene *scene,
                        const struct hard_pace *pace, size_t m) {
    const uint32_t *end = pairs->end[m];
    const struct particle_state *state = scene->particles->state;
    double apart[3], distance;
    return hard_contacts_separate(pairs, scene, m, apart, &distance) < pace->near &&
           state[end[0]].inverse_mass + state[end[1]].inverse_mass > 0.0 && distance > 0.0;
}

/* Begins row r between its two bodies where their surfaces are nearest. */
static void row_begin(struct hard_contacts *contacts, const struct hard_problem *problem, size_t r,
                      const struct hard_scene *scene, const struct hard_terms *terms,
                      const struct hard_term *term, const uint32_t particle[2],
                      const struct hard_touch *touch) {
    struct hard_row *row = &problem->row[r];
    row->gap = touch->gap;
    for (int e = 0; e < 2; e++)
        row->lever[e] = touch->lever[e];
    for (int d = 0; d < 3; d++)
        row->normal[d] = touch->normal[d];
    arm_make(contacts, row, r, scene, terms, particle, touch);
    if (row->arm)
        hard_arm_velocity(row->arm, &problem->body[row->body[0]], &problem->body[row->body[1]],
                          contacts->arm[r].start);
    resist_place(contacts, row, r, term);
}

/* The spheres of pair m where they are nearest. */
static struct hard_touch spheres_touch(const struct hard_pairs *pairs, const struct hard_scene *scene,
                                       size_t m) {
    const struct particle_state *state = scene->particles->state;
    double apart[3], distance;
    struct hard_touch touch = {.gap = hard_contacts_separate(pairs, scene, m, apart, &distance)};
    for (int e = 0; e < 2; e++) {
        touch.radius[e] = state[pairs->end[m][e]].radius;
        touch.lever[e] = touch.radius[e] + 0.5 * touch.gap;
    }
    for (int d = 0; d < 3; d++)
        touch.normal[d] = apart[d] / distance;
    touch.size = fmin(touch.radius[0], touch.radius[1]);
    return touch;
}

/* Row r of pair m; `offer`: the point of a rock that it is, NULL of spheres. */
static void pair_fill(struct hard_contacts *contacts, const struct hard_problem *problem, size_t r,
                      const struct hard_pairs *pairs, const struct hard_scene *scene,
                      const struct hard_terms *terms, const struct hard_pace *pace, size_t m,
                      const struct hard_offer *offer) {
    struct hard_row *row = &problem->row[r];
    struct hard_touch touch = offer ? offer->touch : spheres_touch(pairs, scene, m);
    struct hard_ends ends = {.radius = {touch.radius[0], touch.radius[1]},
                             .size = touch.size,
                             .memory = offer ? &offer->memory : &pairs->memory[m],
                             .couple = offer           ? &offer->couple
                                       : pairs->couple ? &pairs->couple[m]
                                                       : NULL};
    int material[2];
    *row = (struct hard_row){0};
    if (offer)
        touch.arm = offer->arm;
    for (int e = 0; e < 2; e++) {
        row->body[e] = hard_clumps_carrier(scene->clumps, pairs->end[m][e]);
        ends.light += scene->particles->state[pairs->end[m][e]].inverse_mass;
        material[e] = material_number(scene, pairs->end[m][e]);
    }
    const struct hard_term *term = hard_term_of(terms, material[0], material[1]);
    row_begin(contacts, problem, r, scene, terms, term, pairs->end[m], &touch);
    hard_row_finish(row, problem, terms, term, pace, &ends);
}

/* The rows of pair m: of spheres one or none, of a rock its offers for which no others stand. */
static size_t rows_of(const struct hard_contacts *contacts, const struct hard_pairs *pairs,
                      const struct hard_scene *scene, const struct hard_pace *pace, size_t m) {
    const struct hard_rocks *rocks = scene->rocks;
    const uint8_t *dropped = contacts->dropped;
    int32_t n = hard_rocks_of(rocks, m);
    size_t count = 0;
    if (n < 0)
        return hard_contacts_near(pairs, scene, pace, m) && !(dropped && dropped[m]);
    for (size_t k = rocks->first[n]; k < rocks->first[n + 1]; k++)
        count += !dropped[pairs->colours.pairs + k];
    return count;
}

/* Fills the rows of pair m from row r on; returns the next one. */
static size_t rows_fill(struct hard_contacts *contacts, const struct hard_problem *problem, size_t r,
                        const struct hard_pairs *pairs, const struct hard_scene *scene,
                        const struct hard_terms *terms, const struct hard_pace *pace, size_t m) {
    const struct hard_rocks *rocks = scene->rocks;
    int32_t n = hard_rocks_of(rocks, m);
    if (n < 0 && rows_of(contacts, pairs, scene, pace, m) > 0) {
        pair_fill(contacts, problem, r, pairs, scene, terms, pace, m, NULL);
        contacts->pair[r++] = (uint32_t)m;
    }
    for (size_t k = n < 0 ? 0 : rocks->first[n]; n >= 0 && k < rocks->first[n + 1]; k++) {
        if (contacts->dropped[pairs->colours.pairs + k])
            continue;
        pair_fill(contacts, problem, r, pairs, scene, terms, pace, m, &rocks->offer[k]);
        contacts->spot[r] = (uint32_t)k;
        contacts->pair[r++] = (uint32_t)m;
    }
    return r;
}

/* Rows of pairs, cut by cut in the order of the colours. */
static void pairs_find(struct hard_contacts *contacts, struct hard_problem *problem, struct hard_pairs *pairs,
                       const struct hard_scene *scene, const struct hard_terms *terms,
                       const struct hard_pace *pace) {
    const struct hard_colours *colours = &pairs->colours;
    size_t rows = 0;
    hard_problem_reserve(problem, 0, 0, colours->cuts + 1);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < colours->cuts; k++) {
        problem->cut[k + 1] = 0;
        for (size_t m = colours->cut[k]; m < colours->cut[k + 1]; m++)
            problem->cut[k + 1] += rows_of(contacts, pairs, scene, pace, m);
    }
    for (size_t k = 0; k < colours->cuts; k++) {
        rows += problem->cut[k + 1];
        problem->cut[k + 1] = rows;
    }
    hard_problem_reserve(problem, 0, rows, 0);
    if (scene->clumps->links || terms->open)
        contacts->arm = hard_problem_grow(contacts->arm, &contacts->arm_room, rows + contacts->walls,
                                          sizeof *contacts->arm);
    if (terms->resists)
        contacts->resist = hard_problem_grow(contacts->resist, &contacts->resist_room, rows + contacts->walls,
                                             sizeof *contacts->resist);
    contacts->pair = hard_problem_grow(contacts->pair, &contacts->pair_room, rows, sizeof *contacts->pair);
    if (scene->rocks->rocks)
        contacts->spot =
            hard_problem_grow(contacts->spot, &contacts->spot_room, rows, sizeof *contacts->spot);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < colours->cuts; k++) {
        size_t r = problem->cut[k];
        for (size_t m = colours->cut[k]; m < colours->cut[k + 1]; m++) {
            r = rows_fill(contacts, problem, r, pairs, scene, terms, pace, m);
            pairs->memory[m] = (struct hard_memory){0};
            if (pairs->couple)
                pairs->couple[m] = (struct hard_couple){0};
        }
    }
    for (int c = 0; c < colours->colours; c++) {
        problem->cuts = colours->colour[c + 1];
        hard_problem_end_colour(problem);
    }
    problem->rows = contacts->pair_rows = rows;
}

static void wall_note(void *context, const struct wall_place *place) {
    struct hard_wall_found *found = context;
    found->place = hard_problem_grow(found->place, &found->room, found->count + 1, sizeof *found->place);
    found->place[found->count++] = *place;
}

/* Appends the contact of a particle of finite mass. */
static void wall_add(struct hard_contacts *contacts, const struct hard_scene *scene,
                     const struct hard_wall_contact *contact) {
    const struct wall_place *place = &contact->place;
    if (!(scene->particles->state[place->particle].inverse_mass > 0.0))
        return;
    contacts->wall =
        hard_problem_grow(contacts->wall, &contacts->wall_room, contacts->walls + 1, sizeof *contacts->wall);
    struct hard_wall_contact *added = &contacts->wall[contacts->walls++];
    *added = *contact;
    added->body = hard_clumps_carrier(scene->clumps, (uint32_t)place->particle);
    added->order = hard_contacts_order(scene->particles->id[place->particle],
                                       (int64_t)place->feature * WALLS_MAX + place->wall);
}

static int by_particle(const void *a, const void *b) {
    const struct hard_wall_contact *x = a, *y = b;
    if (x->place.particle != y->place.particle)
        return x->place.particle < y->place.particle ? -1 : 1;
    return x->order < y->order ? -1 : x->order > y->order;
}

/* Points of rocks near walls, in contacts->wall, all of which is then by particle. */
static void rocks_add(struct hard_contacts *contacts, const struct hard_scene *scene) {
    const size_t before = contacts->walls;
    for (int t = 0; scene->rocks->rocks && t < scene->rocks->threads; t++)
        for (size_t k = 0; k < scene->rocks->found[t].walls; k++) {
            const struct hard_wall_offer *wall = &scene->rocks->found[t].wall[k];
            struct hard_wall_contact contact = {.place = wall->place,
                                                .rock = true,
                                                .radius = wall->offer.touch.radius[0],
                                                .size = wall->offer.touch.size};
            memcpy(contact.arm, wall->offer.arm[0], sizeof contact.arm);
            wall_add(contacts, scene, &contact);
        }
    if (contacts->walls > before)
        qsort(contacts->wall, contacts->walls, sizeof *contacts->wall, by_particle);
}

/* Places of walls near particles, by particle, in contacts->wall. */
static void walls_find(struct hard_contacts *contacts, const struct hard_scene *scene, double near) {
    contacts->walls = 0;
    if (scene->walls == NULL)
        return;
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < scene->threads; t++) {
        contacts->found[t].count = 0;
        walls_visit(scene->walls, scene->particles, t, near, wall_note, &contacts->found[t]);
    }
    for (int t = 0; t < scene->threads; t++)
        for (size_t k = 0; k < contacts->found[t].count; k++) {
            const struct wall_place *place = &contacts->found[t].place[k];
            double radius = scene->particles->state[place->particle].radius;
            if (!hard_rocks_is(scene->rocks, (uint32_t)place->particle))
                wall_add(contacts, scene,
                         &(struct hard_wall_contact){.place = *place, .radius = radius, .size = radius});
        }
    rocks_add(contacts, scene);
}

static int by_body(const void *a, const void *b) {
    const struct hard_wall_contact *x = a, *y = b;
    if (x->body != y->body)
        return x->body < y->body ? -1 : 1;
    return x->order < y->order ? -1 : x->order > y->order;
}

/* Gives contacts with walls the memory of the step before; both are sorted by particle. */
static void walls_recall(struct hard_contacts *contacts) {
    size_t p = 0;
    for (size_t k = 0; k < contacts->walls; k++) {
        const struct wall_place *place = &contacts->wall[k].place;
        while (p < contacts->pasts && contacts->past[p].particle < place->particle)
            p++;
        for (size_t q = p; q < contacts->pasts && contacts->past[q].particle == place->particle; q++)
            if (contacts->past[q].wall == place->wall && contacts->past[q].feature == place->feature) {
                contacts->wall[k].memory = contacts->past[q].memory;
                contacts->wall[k].couple = contacts->past[q].couple;
            }
    }
    contacts->pasts = 0;
}

static void wall_fill(struct hard_contacts *contacts, struct hard_problem *problem,
                      const struct hard_wall_contact *contact, size_t r, const struct hard_scene *scene,
                      const struct hard_terms *terms, const struct hard_pace *pace) {
    const struct wall_place *place = &contact->place;
    struct hard_row *row = &problem->row[r];
    uint32_t body = (uint32_t)problem->bodies++;
    int material = material_number(scene, place->particle);
    double arm[2][3] = {{contact->arm[0], contact->arm[1], contact->arm[2]}, {0.0, 0.0, 0.0}};
    const struct hard_touch touch = {
        .normal = {place->normal[0], place->normal[1], place->normal[2]},
        .gap = place->gap,
        .lever = {contact->rock ? 0.0 : fmax(0.0, contact->radius + place->gap), 0.0},
        .arm = contact->rock ? (const double(*)[3])arm : NULL};
    const uint32_t particle[2] = {(uint32_t)place->particle, UINT32_MAX};
    const struct hard_term *term = hard_term_of(terms, material, scene->wall_material[place->wall]);
    problem->body[body] =
        (struct hard_body){.v = {place->velocity[0], place->velocity[1], place->velocity[2]}};
    *row = (struct hard_row){.body = {contact->body, body}};
    row_begin(contacts, problem, r, scene, terms, term, particle, &touch);
    hard_row_finish(row, problem, terms, term, pace,
                    &(struct hard_ends){{contact->radius, INFINITY},
                                        contact->size,
                                        scene->particles->state[place->particle].inverse_mass,
                                        &contact->memory,
                                        &contact->couple});
}

void hard_contacts_ends(const struct hard_contacts *contacts, const struct hard_pairs *pairs, size_t r,
                        size_t end[2]) {
    bool wall = r >= contacts->pair_rows;
    end[0] = wall ? contacts->wall[r - contacts->pair_rows].place.particle : pairs->end[contacts->pair[r]][0];
    end[1] = wall ? SIZE_MAX : pairs->end[contacts->pair[r]][1];
}

void hard_contacts_find(struct hard_contacts *contacts, struct hard_problem *problem,
                        struct hard_pairs *pairs, const struct hard_scene *scene,
                        const struct hard_terms *terms, const struct hard_pace *pace) {
    hard_problem_begin(problem, pace->dt);
    hard_rocks_find(scene->rocks, pairs, pace->near);
    walls_find(contacts, scene, pace->near);
    walls_recall(contacts);
    if (scene->clumps->links) {
        hard_contacts_thin(contacts, pairs, scene, pace);
        if (contacts->walls > 1)
            qsort(contacts->wall, contacts->walls, sizeof *contacts->wall, by_body);
    }
    pairs_find(contacts, problem, pairs, scene, terms, pace);
    hard_problem_reserve(problem, problem->bodies + contacts->walls, problem->rows + contacts->walls,
                         problem->cuts + contacts->walls);
    for (size_t k = 0, in_cut = 1; k < contacts->walls; k++, in_cut++) {
        bool last = k + 1 == contacts->walls;
        wall_fill(contacts, problem, &contacts->wall[k], problem->rows++, scene, terms, pace);
        if (last || (in_cut >= WALL_CUT && contacts->wall[k + 1].body != contacts->wall[k].body)) {
            problem->cut[++problem->cuts] = problem->rows;
            in_cut = 0;
        }
    }
    hard_problem_end_colour(problem);
}
