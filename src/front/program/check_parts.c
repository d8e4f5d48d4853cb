/* SPDX-License-Identifier: BSD-3-Clause */
/* The terms of the contact law, the fields and the bytes that a scene needs, and the reasons. */
#include "front/program/check_parts.h"
#include "physics/grains/laws/law_restitution.h"
#include "physics/grains/grains.h"
#include "data/formats/frame.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum { WHY_MAX = 256 };

/* Adds a word to a list. */
static void add(char *list, size_t room, const char *word) {
    size_t used = strlen(list);
    snprintf(list + used, room - used, "%s%s", used ? ", " : "", word);
}

/* The pairs of materials for which a coefficient is not 0; "" without such pairs. */
static void pairs_with(const struct scene *scene, size_t coefficient, char *why, size_t room) {
    char pair[2 * LAW_NAME_MAX + 16];
    for (int a = 0; a < scene->materials; a++)
        for (int b = a; b < scene->materials; b++) {
            const char *at = (const char *)scene_law_pair(scene, a, b) + coefficient;
            double value;
            memcpy(&value, at, sizeof value);
            snprintf(pair, sizeof pair, "%s - %s", scene->material[a].name, scene->material[b].name);
            if (value > 0)
                add(why, room, pair);
        }
}

static void materials_list(const struct scene *scene, char *why, size_t room) {
    for (int m = 0; m < scene->materials; m++)
        add(why, room, scene->material[m].name);
}

static void groups_list(const struct scene *scene, char *why, size_t room) {
    for (int g = 1; g < scene->groups; g++)
        add(why, room, scene->group[g].name);
}

static void periodic_list(const struct scene *scene, char *why, size_t room) {
    for (int d = 0; d < 3; d++)
        if (scene->box.periodic[d])
            add(why, room, (const char *[]){"x", "y", "z"}[d]);
}

static void walls_list(const struct scene *scene, char *why, size_t room) {
    for (int w = 0; w < scene->walls; w++)
        add(why, room, scene->wall[w].name);
}

/* What is printed of the terms. */
struct terms {
    bool all;          /* a line for each term that is off, too */
    char off[WHY_MAX]; /* else: their names */
};

/* Prints one term of the model: on, with the setting that brings it, or off, with a setting that would bring
 * it. */
static void print_term(struct terms *terms, const char *term, const char *brought_by,
                       const char *would_bring) {
    if (brought_by[0])
        printf("  %-22s on   %s\n", term, brought_by);
    else if (terms->all)
        printf("  %-22s off  %s\n", term, would_bring);
    else
        add(terms->off, sizeof terms->off, term);
}

/* Prints the effect of the end of contacts, at the least restitution of all pairs, and the effect of the
 * other end. */
static void print_end(const struct scene *scene, const struct law *law) {
    enum law_end end = law->options.end, other = end == LAW_END_FORCE ? LAW_END_OVERLAP : LAW_END_FORCE;
    static const char *const what[] = {[LAW_END_OVERLAP] = "overlap: the damper pulls before surfaces part",
                                       [LAW_END_FORCE] = "force: dampers never attract"};
    double e = 1.0;
    for (int a = 0; a < law->materials; a++)
        for (int b = a; b < law->materials; b++)
            e = fmin(e, scene_law_pair(scene, a, b)->restitution);
    printf("  %-22s on   contact.end: %s", "end of a contact", what[end]);
    if (law_damping_form_of(law->options.damping)->given)
        printf("; the restitution depends on it");
    else if (e < 1.0)
        printf("; at restitution %g damping ratio %.3g, friction of sliding impacts %.3f of Coulomb's (%s: "
               "%.3g, "
               "%.3f)",
               e, law_damping_ratio(e, end), 1.0 + law_end_friction(e, end),
               end == LAW_END_FORCE ? "overlap" : "force", law_damping_ratio(e, other),
               1.0 + law_end_friction(e, other));
    printf("\n");
}

/* Prints a kind of part of the law: the scene's choice, 0: none. */
static void print_part(struct terms *terms, const char *term, enum law_part part, const char *key,
                       int chosen) {
    char text[WHY_MAX] = "", none[WHY_MAX];
    int count;
    snprintf(none, sizeof none, "%s: none", key);
    if (chosen)
        snprintf(text, sizeof text, "%s: %s", key, law_part_rows(part, &count)[chosen].name);
    print_term(terms, term, text, none);
}

void check_parts_terms(const struct scene *scene, const struct grains *grains, bool alone, bool sums,
                       bool all) {
    struct terms terms = {.all = all};
    char text[WHY_MAX] = "";
    printf("\nwhat is modelled, and why\n");
    char law[LAW_TITLE_MAX];
    law_title(&grains->law.options, law);
    snprintf(text, sizeof text, "contact.law: %s", law);
    print_term(&terms, "normal force", scene->materials > 0 ? text : "", "the scene has no materials");
    text[0] = '\0';
    if (scene->materials > 0 && !grains->law.options.solved)
        print_end(scene, &grains->law);
    pairs_with(scene, offsetof(struct law_pair, friction), text, sizeof text);
    print_term(&terms, "friction, spin, history",
               grains->law.spin ? text[0] ? text : "contact.tangential: history" : "",
               "contact.tangential: none");
    text[0] = '\0';
    pairs_with(scene, offsetof(struct law_pair, rolling_friction), text, sizeof text);
    print_term(&terms, "rolling resistance",
               grains->law.options.rolling ? text[0] ? text : "contact.rolling: spring" : "",
               "contact.rolling: none");
    print_part(&terms, "twisting resistance", LAW_PART_TWISTING, "contact.twisting",
               (int)grains->law.options.twisting);
    print_part(&terms, "cohesion", LAW_PART_COHESION, "contact.cohesion.law",
               (int)grains->law.options.cohesion);
    text[0] = '\0';
    walls_list(scene, text, sizeof text);
    print_term(&terms, "walls", scene->materials > 0 ? text : "",
               text[0] ? "the scene has no materials" : "the scene has none");
    print_term(&terms, "gravity",
               scene->gravity[0] != 0 || scene->gravity[1] != 0 || scene->gravity[2] != 0 ? "gravity" : "",
               "gravity is 0");
    if (scene->box.dimension == 2)
        printf("  %-22s      %s\n", "mass of a grain",
               scene->box.density == BOX_DENSITY_AREA ? "density x pi r^2 (box.density: area)"
                                                      : "density x 4/3 pi r^3 (box.density: volume)");
    print_term(&terms, "motion along z", scene->box.dimension == 3 ? "box.dimension: 3" : "",
               "box.dimension: 2");
    print_term(&terms, "exchange of copies", alone ? "" : "several ranks", "one rank");
    print_term(&terms, "energy sums",
               grains->contact.want_work ? "heat.dissipation"
               : sums                    ? "guards.energy"
                                         : "",
               "at rows of observables alone; each step if dissipated energy is among them");
    if (terms.off[0])
        printf("  off: %s\n", terms.off);
}

/* Writes the setting that brings a field, and the parts of the scene with that setting. */
static void reason_of(const struct scene *scene, const struct field *field, char *why, size_t room) {
    static const struct {
        const char *field;
        void (*list)(const struct scene *scene, char *why, size_t room);
    } lists[] = {{"material", materials_list},
                 {"group", groups_list},
                 {"density", groups_list},
                 {"image", periodic_list}};
    char names[WHY_MAX] = "";
    for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
        if (strcmp(field->name, lists[k].field) == 0)
            lists[k].list(scene, names, sizeof names);
    bool met = names[0] && (strcmp(field->name, "material") != 0 || scene->materials > 1);
    snprintf(why, room, "%s%s%s", field->needed_for ? field->needed_for : "always", met ? ": " : "",
             met ? names : "");
}

void check_parts_fields(const struct particles *particles, const struct scene *scene, const struct law *law) {
    char why[2 * WHY_MAX];
    printf("\nfields of a particle\n  %-18s %6s  %s\n", "field", "bytes", "needed for");
    for (int f = 0; f < fields_count(particles); f++) {
        const struct field *field = fields_get(particles, f);
        reason_of(scene, field, why, sizeof why);
        printf("  %-18s %6zu  %s\n", field->name, fields_bytes(field), why);
    }
    struct particles *known = particles_create(0);
    frame_register_all(known);
    for (int f = 0; f < fields_count(known); f++) {
        const struct field *field = fields_get(known, f);
        reason_of(scene, field, why, sizeof why);
        if (fields_find(particles, field->name) < 0)
            printf("  %-18s %6s  not needed; it is for %s\n", field->name, "-", why);
    }
    particles_destroy(&known);
    printf("  ");
    check_parts_bytes(particles, law);
}

void check_parts_bytes(const struct particles *particles, const struct law *law) {
    printf("stored: %zu bytes a particle (all fields, forces and spins padded), ",
           particles_bytes_each(particles));
    if (law->history_components)
        printf("history: %zu bytes a touching pair\n",
               2 * (sizeof(uint32_t) + (size_t)law->history_components * sizeof(double)));
    else
        printf("history: none (%s)\n", law->options.solved ? "a solver has its own" : "no friction");
}

/* Bytes of a particle's fields with a use. */
static size_t bytes_of(const struct particles *particles, unsigned use) {
    const struct field_list fields = fields_with(particles, use);
    return fields_packed_bytes(particles, &fields);
}

void check_parts_wire(const struct particles *particles, bool newton) {
    printf("\nbytes on the wire: %zu a copy when made, %zu a copy and step, %zu sent back, %zu a migrating "
           "particle\n",
           bytes_of(particles, FIELD_GHOST), bytes_of(particles, FIELD_FORWARD),
           newton ? bytes_of(particles, FIELD_REVERSE) : (size_t)0, bytes_of(particles, FIELD_MIGRATE));
}
