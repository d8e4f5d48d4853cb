/* SPDX-License-Identifier: BSD-3-Clause */
/* What hard contacts refuse of a scene: laws, parts of laws and other physics. Read hard.h first. */
#include "physics/hard/hard_state.h"
#include "engine/physics_set.h"
#include "physics_table.h"
#include <stdio.h>
#include <string.h>

enum { NAMES_MOST = 64 };

/* Largest coefficient of restitution: the pass of restitution may add energy where several impacts
 * meet, and what friction and the other contacts lose makes up for it up to here. */
static const double restitution_most = 0.95;

/* Appends a word to a list. */
static void word_add(char *text, size_t room, const char *word) {
    size_t used = strlen(text);
    snprintf(text + used, room - used, "%s%s", used ? ", " : "", word);
}

/* The laws that have a trait, as a list. */
static const char *laws_with(const char *trait, char *text, size_t room) {
    text[0] = '\0';
    for (int k = 0; k < LAW_COUNT; k++)
        if (law_has_trait((enum law_normal)k, trait))
            word_add(text, room, law_row_get((enum law_normal)k)->name);
    return text;
}

/* True if row k of a part has a form in the solver; none comes first. */
static bool has_form(enum law_part part, int k) {
    const struct law_extra extra = {0};
    switch (part) {
    case LAW_PART_COHESION:
        return k == 0 || law_cohesion_form_of((enum law_cohesion)k)->constant;
    case LAW_PART_ROLLING:
        return k == 0 || law_rolling_solved((enum law_rolling)k, &extra).row != LAW_SOLVED_NONE;
    case LAW_PART_TWISTING:
        return k == 0 || law_twisting_solved((enum law_twisting)k, &extra).row != LAW_SOLVED_NONE;
    default:
        return k == 0;
    }
}

/* True if the chosen row of a part has no form in the solver; `names` gets those that have one. */
static bool has_no_form(const struct law_options *o, enum law_part part, int chosen, char names[NAMES_MOST]) {
    int count;
    const struct law_part_row *row = law_part_rows(part, &count);
    names[0] = '\0';
    for (int k = 0; k < count; k++)
        if (has_form(part, k) && law_part_combines(&row[k], law_row_get(o->normal)->traits))
            word_add(names, NAMES_MOST, row[k].name);
    return !has_form(part, chosen);
}

/* Refuses parts of a law that have no form in the solver. */
static bool check_law(const struct scene *scene, struct error *error) {
    const struct law_options *o = &scene->law;
    char laws[128], names[3][NAMES_MOST];
    if (!law_has_trait(o->normal, "implicit"))
        return scene_fail(scene, error, "contact.solver", "goes with contact.law %s, not with %s",
                          laws_with("implicit", laws, sizeof laws), law_row_get(o->normal)->name);
    const struct {
        const char *key;
        bool given;
        const char *allowed;
    } part[] = {{"contact.cohesion", has_no_form(o, LAW_PART_COHESION, (int)o->cohesion, names[2]), names[2]},
                {"contact.tangential", o->tangential > LAW_TANGENTIAL_HISTORY, "none, history"},
                {"contact.rolling", has_no_form(o, LAW_PART_ROLLING, o->rolling, names[0]), names[0]},
                {"contact.twisting", has_no_form(o, LAW_PART_TWISTING, o->twisting, names[1]), names[1]},
                {"contact.damping", o->damping != LAW_DAMPING_DEFAULT, "restitution"},
                {"contact.end", o->end != LAW_END_FORCE, "force"},
                {"contact.sliding", o->sliding != LAW_SLIDING_SERIES, "series"},
                {"contact.tangential_damping_ratio",
                 o->tangential == LAW_TANGENTIAL_HISTORY && o->tangential_damping_ratio != 1.0, "1"},
                {"contact.tangential_damping_equal", o->tangential_damping_equal, "false"},
                {"contact.lammps_history", o->lammps_history, "false"},
                {"contact.lammps_granular", o->lammps_granular, "false"}};
    for (size_t k = 0; k < sizeof part / sizeof part[0]; k++)
        if (part[k].given)
            return scene_fail(scene, error, part[k].key, "has no form in contact.solver; allowed with it: %s",
                              part[k].allowed);
    return true;
}

/* The key of a damper of rolling or twisting that is given; NULL: none. */
static const char *damper_of(const struct law_options *o, const struct law_extra *extra) {
    const char *rolling = law_rolling_solved(o->rolling, extra).lacks;
    return rolling ? rolling : law_twisting_solved(o->twisting, extra).lacks;
}

static bool check_pairs(const struct scene *scene, struct error *error) {
    for (int a = 0; a < scene->materials; a++)
        for (int b = 0; b <= a; b++) {
            const struct law_pair *pair = scene_law_pair(scene, a, b);
            if (pair->restitution > restitution_most)
                return scene_fail(scene, error, "material_pairs",
                                  "%s, %s: restitution is %g; allowed with contact.solver are 0 to %g",
                                  scene->material[b].name, scene->material[a].name, pair->restitution,
                                  restitution_most);
            if (pair->extra.static_friction > pair->friction)
                return scene_fail(scene, error, "material_pairs",
                                  "%s, %s: static_friction has no form in contact.solver; allowed: no more "
                                  "than friction",
                                  scene->material[b].name, scene->material[a].name);
            const char *damper = damper_of(&scene->law, &pair->extra);
            if (damper)
                return scene_fail(scene, error, "material_pairs",
                                  "%s, %s: %s has no form in contact.solver; allowed with it: 0",
                                  scene->material[b].name, scene->material[a].name, damper);
        }
    return true;
}

/* True if physics k goes with a solver: bodies, a fluid (which says itself how), and one that does nothing to grains, and has no particles and no step of its own. */
static bool goes_with(int k) {
    const struct physics *row = physics_get((enum physics_number)k);
    if (k == PHYSICS_hard || k == PHYSICS_bodies || k == PHYSICS_fluid)
        return true;
    return !row->maker && !row->joints && !row->limit && !row->energy && !row->mover && !row->carrier;
}

/* Newton's method needs a library, and springs. */
static bool check_newton(const struct scene *scene, const struct hard_options *options, struct error *error) {
    if (options->method != HARD_NEWTON)
        return true;
    if (!solve_available())
        return scene_fail(scene, error, "contact.solver.name",
                          "newton needs PETSc, without which this scree was built; allowed: gauss_seidel");
    if (isinf(options->kappa))
        return scene_fail(scene, error, "contact.solver.kappa",
                          "rigid rows have no derivative; allowed with newton is a finite number");
    if (options->model != HARD_MODEL_COULOMB)
        return scene_fail(scene, error, "contact.solver.model",
                          "newton has Coulomb's law alone; allowed with it: coulomb");
    if (options->restitution == HARD_RESTITUTION_POISSON)
        return scene_fail(scene, error, "contact.solver.restitution",
                          "newton solves a step once; allowed with it: pass");
    if (scene->law.rolling != LAW_ROLLING_NONE || scene->law.twisting != LAW_TWISTING_NONE)
        return scene_fail(scene, error, "contact.solver.name",
                          "newton knows neither rolling nor twisting; allowed with these: gauss_seidel");
    return true;
}

bool hard_check(const struct physics_context *context, struct error *error) {
    const struct scene *scene = context->scene;
    static const char with[] = "does not go with contact.solver yet; allowed with it: %s";
    if (scene->materials == 0)
        return scene_fail(scene, error, "contact.solver", "needs `materials`: grains that touch");
    if (scene->reproducible)
        return scene_fail(scene, error, "reproducible",
                          "the order in which contacts are visited follows the ranks; allowed with "
                          "contact.solver: false");
    for (int k = 0; k < PHYSICS_COUNT; k++)
        if (scene->physics_given[k] && !goes_with(k))
            return scene_fail(scene, error, physics_key((enum physics_number)k), with,
                              "bodies, fluid, and physics that only look at grains");
    for (int w = 0; w < scene->walls; w++)
        if (scene->wall[w].free.given) {
            char key[64];
            snprintf(key, sizeof key, "walls[%d].free", w);
            return scene_fail(scene, error, key, with, "walls at rest, motions by order");
        }
    for (int w = 0; w < scene->walls; w++)
        for (int m = 0; m < scene->wall[w].motions; m++)
            if (scene->wall[w].motion[m].kind == WALL_SERVO) {
                char key[64];
                snprintf(key, sizeof key, "walls[%d].motion[%d]", w, m);
                return scene_fail(scene, error, key, with, "motions by order, no servo");
            }
    if (output_interval_set(&scene->output.walls.every))
        return scene_fail(scene, error, "output.walls", with, "no files of loads on walls");
    if (output_interval_set(&scene->output.contact_problems.every) &&
        scene->law.cohesion != LAW_COHESION_NONE)
        return scene_fail(scene, error, "output.contact_problems.every",
                          "its format has no pulls; allowed with it: cohesion none");
    if (output_interval_set(&scene->output.contact_problems.every) &&
        (scene->law.rolling != LAW_ROLLING_NONE || scene->law.twisting != LAW_TWISTING_NONE))
        return scene_fail(scene, error, "output.contact_problems.every",
                          "its format has no moments; allowed with it: rolling and twisting none");
    return check_law(scene, error) && check_pairs(scene, error) &&
           check_newton(scene, context->options, error);
}
