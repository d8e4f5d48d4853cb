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

/* Gives row r an arm if one of its spheres is carried by a body, or all rows have one. `sphere`: its particles, UINT32_MAX a wall. */
static void arm_make(struct hard_contacts *contacts, struct hard_row *row, size_t r,
                     const struct hard_scene *scene, const struct hard_terms *terms,
                     const uint32_t sphere[2]) {
    bool carried = false;
    for (int e = 0; e < 2; e++)
        carried = carried || (sphere[e] != UINT32_MAX && hard_clumps_carries(scene->clumps, sphere[e]));
    if (!carried && !terms->open)
        return;
    struct hard_arm *arm = &contacts->arm[r];
    *arm = (struct hard_arm){.relax = terms->relax};
    for (int e = 0; e < 2; e++) {
        double along = e ? -row->lever[1] : row->lever[0];
        if (sphere[e] == UINT32_MAX)
            continue;
        if (hard_clumps_carries(scene->clumps, sphere[e])) {
            hard_clumps_lever(scene->clumps, sphere[e], arm->lever[e]);
            arm->turn[e] = hard_clumps_turn(scene->clumps, sphere[e]);
        }
        for (int d = 0; d < 3; d++)
            arm->lever[e][d] += along * row->normal[d];
    }
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

static void pair_fill(struct hard_contacts *contacts, const struct hard_problem *problem, size_t r,
                      const struct hard_pairs *pairs, const struct hard_scene *scene,
                      const struct hard_terms *terms, const struct hard_pace *pace, size_t m) {
    double apart[3], distance, gap = hard_contacts_separate(pairs, scene, m, apart, &distance);
    struct hard_row *row = &problem->row[r];
    struct hard_ends ends = {.memory = &pairs->memory[m], .couple = pairs->couple ? &pairs->couple[m] : NULL};
    int material[2];
    *row = (struct hard_row){.gap = gap};
    for (int e = 0; e < 2; e++) {
        const struct particle_state *state = &scene->particles->state[pairs->end[m][e]];
        row->body[e] = hard_clumps_carrier(scene->clumps, pairs->end[m][e]);
        ends.radius[e] = state->radius;
        ends.light += state->inverse_mass;
        material[e] = material_number(scene, pairs->end[m][e]);
        row->lever[e] = ends.radius[e] + 0.5 * gap;
    }
    for (int d = 0; d < 3; d++)
        row->normal[d] = apart[d] / distance;
    const struct hard_term *term = hard_term_of(terms, material[0], material[1]);
    arm_make(contacts, row, r, scene, terms, pairs->end[m]);
    resist_place(contacts, row, r, term);
    hard_row_finish(row, problem, terms, term, pace, &ends);
}

/* Rows of pairs, cut by cut in the order of the colours. */
static void pairs_find(struct hard_contacts *contacts, struct hard_problem *problem, struct hard_pairs *pairs,
                       const struct hard_scene *scene, const struct hard_terms *terms,
                       const struct hard_pace *pace) {
    const struct hard_colours *colours = &pairs->colours;
    const uint8_t *dropped = contacts->dropped;
    size_t rows = 0;
    hard_problem_reserve(problem, 0, 0, colours->cuts + 1);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < colours->cuts; k++) {
        problem->cut[k + 1] = 0;
        for (size_t m = colours->cut[k]; m < colours->cut[k + 1]; m++)
            problem->cut[k + 1] += hard_contacts_near(pairs, scene, pace, m) && !(dropped && dropped[m]);
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
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < colours->cuts; k++) {
        size_t r = problem->cut[k];
        for (size_t m = colours->cut[k]; m < colours->cut[k + 1]; m++) {
            if (hard_contacts_near(pairs, scene, pace, m) && !(dropped && dropped[m])) {
                pair_fill(contacts, problem, r, pairs, scene, terms, pace, m);
                contacts->pair[r++] = (uint32_t)m;
            }
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
            if (!(scene->particles->state[place->particle].inverse_mass > 0.0))
                continue;
            contacts->wall = hard_problem_grow(contacts->wall, &contacts->wall_room, contacts->walls + 1,
                                               sizeof *contacts->wall);
            contacts->wall[contacts->walls++] = (struct hard_wall_contact){
                .place = *place,
                .body = hard_clumps_carrier(scene->clumps, (uint32_t)place->particle),
                .order = hard_contacts_order(scene->particles->id[place->particle],
                                             (int64_t)place->feature * WALLS_MAX + place->wall)};
        }
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
    double radius = scene->particles->state[place->particle].radius;
    uint32_t body = (uint32_t)problem->bodies++;
    int material = material_number(scene, place->particle);
    problem->body[body] =
        (struct hard_body){.v = {place->velocity[0], place->velocity[1], place->velocity[2]}};
    const uint32_t sphere[2] = {(uint32_t)place->particle, UINT32_MAX};
    *row = (struct hard_row){.body = {contact->body, body},
                             .normal = {place->normal[0], place->normal[1], place->normal[2]},
                             .lever = {fmax(0.0, radius + place->gap), 0.0},
                             .gap = place->gap};
    const struct hard_term *term = hard_term_of(terms, material, scene->wall_material[place->wall]);
    arm_make(contacts, row, r, scene, terms, sphere);
    resist_place(contacts, row, r, term);
    hard_row_finish(row, problem, terms, term, pace,
                    &(struct hard_ends){{radius, INFINITY},
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
    walls_find(contacts, scene, pace->near);
    walls_recall(contacts);
    if (scene->clumps->links) {
        hard_contacts_thin(contacts, pairs, scene, pace);
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
