/* SPDX-License-Identifier: BSD-3-Clause */
/* Lists the variants of a scene and applies one. Read variant.h first. */
#include "front/program/variant.h"
#include "physics/grains/grains.h"
#include "base/memory.h"
#include "engine/simulation.h"
#include "kernel/particles/material.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Brute force tests every pair of particles, so it is left out above this number of particles. */
enum { BRUTE_PARTICLES_MAX = 20000 };

/* The largest time step tried, as a part of the stable step. */
#define VARIANT_STEP_MOST 0.95

static void means_take(const struct particles *particles, const struct comm *comm,
                       struct variant_facts *facts) {
    const uint8_t *material = material_numbers(particles);
    double sum[LAW_MATERIALS_MAX][3] = {{0}};
    for (size_t k = 0; k < particles->owned; k++) {
        const struct particle_state *p = &particles->state[k];
        if (p->inverse_mass == 0)
            continue;
        double *of = sum[material_of(material, k)];
        of[0] += 1;
        of[1] += p->radius;
        of[2] += 1 / p->inverse_mass;
    }
    comm_sum(comm, sum[0], 3 * LAW_MATERIALS_MAX);
    for (int m = 0; m < LAW_MATERIALS_MAX; m++) {
        facts->radius[m] = sum[m][0] > 0 ? sum[m][1] / sum[m][0] : INFINITY;
        facts->mass[m] = sum[m][0] > 0 ? sum[m][2] / sum[m][0] : INFINITY;
    }
}

bool variant_probe(const struct comm *comm, const struct scene *scene, struct variant_facts *facts,
                   struct error *error) {
    struct simulation *s = simulation_create(comm, scene, NULL, error);
    if (s == NULL)
        return false;
    *facts = (struct variant_facts){.dt = s->clock.dt,
                                    .stable = s->timing.stable,
                                    .rayleigh = grains_of(&s->physics)->stable.limits.rayleigh,
                                    .particles = s->total,
                                    .classes = s->classes.count,
                                    .materials = scene->materials};
    means_take(s->particles, s->comm, facts);
    size_t entries = (size_t)scene->materials * (size_t)scene->materials;
    facts->coefficients = memory_allocate(entries, sizeof *facts->coefficients, "coefficients of contacts");
    memcpy(facts->coefficients, grains_of(&s->physics)->law.pair, entries * sizeof *facts->coefficients);
    simulation_destroy(&s);
    return true;
}

void variant_forget(struct variant_facts *facts) {
    memory_free(facts->coefficients);
    *facts = (struct variant_facts){0};
}

struct list {
    struct variant *variant;
    int count;
};

static void put(struct list *list, const char *group, enum variant_kind kind, double value,
                const char *settings) {
    if (list->count == VARIANTS_MAX)
        return;
    struct variant *v = &list->variant[list->count++];
    *v = (struct variant){.group = group, .changes = 1, .change = {{kind, value}}};
    snprintf(v->settings, sizeof v->settings, "%s", settings);
}

static void put_steps(struct list *list, const struct variant_facts *facts) {
    static const double factor[] = {0.5, 1.5, 2, 3, 4, 5, 6};
    char text[VARIANT_TEXT_MAX];
    for (size_t k = 0; k < sizeof factor / sizeof factor[0]; k++) {
        if (factor[k] * facts->dt > VARIANT_STEP_MOST * facts->stable)
            continue;
        snprintf(text, sizeof text, "dt x %g", factor[k]);
        put(list, "step", VARIANT_STEP, factor[k], text);
    }
}

static void put_laws(struct list *list, const struct scene *scene) {
    const struct law_row *row = law_row_get(scene->law.normal);
    char text[VARIANT_TEXT_MAX];
    /* cohesion and springs that depend on the contact radius go with few other laws */
    bool plain = scene->law.cohesion == LAW_COHESION_NONE && scene->law.tangential <= LAW_TANGENTIAL_HISTORY;
    if (!row->form->linear && plain && !law_has_trait(scene->law.normal, "file") &&
        !law_has_trait(scene->law.normal, "stiff") && scene->law.damping == LAW_DAMPING_DEFAULT) {
        snprintf(text, sizeof text, "%s for %s", law_row_get(law_linear())->name, row->name);
        put(list, "law", VARIANT_LINEAR, 0, text);
    }
    if (scene->law.tangential != LAW_FRICTIONLESS)
        put(list, "law", VARIANT_FRICTIONLESS, 0, "no friction");
    if (scene->law.tangential == LAW_TANGENTIAL_HISTORY && !scene->law.lammps_history && !scene->law.solved)
        put(list, "law", VARIANT_SLIDING,
            scene->law.sliding == LAW_SLIDING_SERIES ? LAW_SLIDING_TOTAL : LAW_SLIDING_SERIES,
            scene->law.sliding == LAW_SLIDING_SERIES ? "sliding total" : "sliding series");
    if (scene->law.rolling != LAW_ROLLING_NONE)
        put(list, "law", VARIANT_NO_ROLLING, 0, "no rolling resistance");
    if (scene->law.damping == LAW_DAMPING_DEFAULT && !law_has_trait(scene->law.normal, "stiff")) {
        put(list, "stiffness", VARIANT_SOFT, 0.1, "stiffness / 10");
        put(list, "stiffness", VARIANT_SOFT, 0.01, "stiffness / 100");
    }
}

static void put_searches(struct list *list, const struct scene *scene, const struct variant_facts *facts) {
    char text[VARIANT_TEXT_MAX];
    put(list, "skin", VARIANT_SKIN, 0.5, "skin / 2");
    put(list, "skin", VARIANT_SKIN, 2, "skin x 2");
    for (int k = 0; k < index_registry_count(); k++) {
        const char *name = index_registry_get(k)->name;
        if (strcmp(name, scene->index.name) == 0 ||
            (strcmp(name, "brute") == 0 && facts->particles > BRUTE_PARTICLES_MAX))
            continue;
        snprintf(text, sizeof text, "index %s", name);
        put(list, "index", VARIANT_INDEX, k, text);
    }
    if (facts->classes > 2)
        put(list, "classes", VARIANT_CLASSES, 2, "2 size classes");
    if (facts->classes > 1)
        put(list, "classes", VARIANT_CLASSES, 1, "1 size class");
    put(list, "order", VARIANT_FUSED, scene->step.fused ? 0 : 1,
        scene->step.fused ? "plain step" : "fused step");
    if (!scene->reproducible && !scene->law.solved)
        put(list, "order", VARIANT_REPRODUCIBLE, 1, "reproducible");
}

int variant_list(struct variant *variant, const struct scene *scene, const struct variant_facts *facts) {
    struct list list = {variant, 1};
    char text[VARIANT_TEXT_MAX];
    variant[0] = (struct variant){.group = "scene", .settings = "as it is"};
    put_steps(&list, facts);
    for (int k = 0; k < integrator_count() && !scene->law.solved; k++)
        if (strcmp(integrator_get(k)->name, scene->integrator) != 0) {
            snprintf(text, sizeof text, "%s", integrator_get(k)->name);
            put(&list, "integrator", VARIANT_INTEGRATOR, k, text);
        }
    put_laws(&list, scene);
    list.count = variant_put_solver(variant, list.count, scene);
    put_searches(&list, scene, facts);
    return list.count;
}

/* True if `group` is one of the words between commas in `groups`. */
static bool group_named(const char *groups, const char *group) {
    size_t length = strlen(group);
    for (const char *at = groups; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
        if (strcspn(at, ",") == length && strncmp(at, group, length) == 0)
            return true;
    return false;
}

int variant_keep(struct variant *list, int count, const char *groups, struct error *error) {
    char known[ERROR_TEXT_MAX / 2] = "";
    int kept = 1, asked = 1, found = 0;
    if (groups == NULL)
        return count;
    for (const char *at = groups; *at; at++)
        asked += *at == ',';
    for (int k = 1; k < count; k++) {
        bool named = group_named(groups, list[k].group);
        if (strcmp(list[k].group, list[k - 1].group) != 0) {
            size_t used = strlen(known);
            snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", list[k].group);
            found += named;
        }
        if (named)
            list[kept++] = list[k];
    }
    if (found == asked)
        return kept;
    error_set(error, ERROR_USER, "command line: --only %s: allowed in this scene: %s", groups, known);
    return 0;
}

void variant_add(struct variant *to, const struct variant *from) {
    size_t used = strlen(to->settings);
    for (int k = 0; k < from->changes && to->changes < VARIANT_CHANGES_MAX; k++)
        to->change[to->changes++] = from->change[k];
    snprintf(to->settings + used, sizeof to->settings - used, "%s%s", used ? "; " : "", from->settings);
    size_t set = strlen(to->set);
    snprintf(to->set + set, sizeof to->set - set, "%s", from->set);
}

/* Sets linear springs that store the same energy as the present law at the overlap of an impact at the
 * largest speed met. */
static void pair_linear(const struct variant_facts *facts, enum law_normal normal, int a, int b,
                        struct law_pair *pair) {
    const struct law_coefficients *c = &facts->coefficients[law_place_of(facts->materials, a, b)];
    const struct law_form *form = law_row_get(normal)->form;
    double radius = 1 / (1 / facts->radius[a] + 1 / facts->radius[b]);
    double mass = 1 / (1 / facts->mass[a] + 1 / facts->mass[b]);
    if (!isfinite(radius) || !isfinite(mass)) { /* two materials that only walls have never touch */
        radius = 1;
        mass = 1;
    }
    double overlap = fmax(form->impact(c, mass, radius, facts->speed), 1e-6 * radius);
    struct law_springs springs = law_springs(normal, c, radius, overlap);
    pair->k_n = 2 * springs.energy / (overlap * overlap);
    pair->k_t = pair->k_n * springs.tangential / springs.tangent;
}

static void linear_set(const struct variant_facts *facts, struct scene *scene) {
    for (int a = 0; a < scene->materials; a++)
        for (int b = a; b < scene->materials; b++)
            pair_linear(facts, scene->law.normal, a, b, scene_law_pair(scene, a, b));
    scene->law.normal = law_linear();
}

static void soften(struct scene *scene, double factor) {
    for (int a = 0; a < scene->materials; a++) {
        scene->material[a].young *= factor;
        for (int b = a; b < scene->materials; b++) {
            struct law_pair *pair = scene_law_pair(scene, a, b);
            pair->k_n *= factor;
            pair->k_t *= factor;
            pair->extra.k_2 *= factor;
            pair->extra.k_c *= factor;
        }
    }
}

static void classes_set(struct scene *scene, int count) {
    scene->classes.method = count == 1 ? CLASSES_ONE : CLASSES_GEOMETRIC;
    scene->classes.count = count;
}

/* Makes a scene frictionless, in the same form as the reader of scenes. */
static void frictionless(struct scene *scene) {
    scene->law.tangential = LAW_FRICTIONLESS;
    scene->law.rolling = LAW_ROLLING_NONE;
    scene->law.twisting = LAW_TWISTING_NONE;
}

static double change_apply(const struct variant_change *change, const struct variant_facts *facts,
                           struct scene *scene) {
    switch (change->kind) {
    case VARIANT_STEP:
        return change->value;
    case VARIANT_INTEGRATOR:
        snprintf(scene->integrator, sizeof scene->integrator, "%s", integrator_get((int)change->value)->name);
        break;
    case VARIANT_LINEAR:
        linear_set(facts, scene);
        break;
    case VARIANT_SOFT:
        soften(scene, change->value);
        break;
    case VARIANT_FRICTIONLESS:
        frictionless(scene);
        break;
    case VARIANT_NO_ROLLING:
        scene->law.rolling = LAW_ROLLING_NONE;
        break;
    case VARIANT_SLIDING:
        scene->law.sliding = (enum law_sliding)change->value;
        break;
    case VARIANT_SKIN:
        scene->classes.skin *= change->value;
        scene->classes.skin_relative *= change->value;
        break;
    case VARIANT_INDEX:
        snprintf(scene->index.name, sizeof scene->index.name, "%s",
                 index_registry_get((int)change->value)->name);
        break;
    case VARIANT_CLASSES:
        classes_set(scene, (int)change->value);
        break;
    case VARIANT_FUSED:
        scene->step.fused = change->value > 0;
        break;
    case VARIANT_SETTINGS: /* were read with the scene */
        break;
    case VARIANT_REPRODUCIBLE:
        scene_make_reproducible(scene);
        break;
    }
    return 1;
}

double variant_apply(const struct variant *variant, const struct variant_facts *facts, struct scene *scene) {
    double factor = 1;
    for (int k = 0; k < variant->changes; k++)
        factor *= change_apply(&variant->change[k], facts, scene);
    return factor;
}

bool variant_scales_step(const struct variant *variant) {
    for (int k = 0; k < variant->changes; k++)
        if (variant->change[k].kind == VARIANT_LINEAR || variant->change[k].kind == VARIANT_SOFT ||
            variant->change[k].kind == VARIANT_SETTINGS)
            return true;
    return false;
}

bool variant_is_exact(const struct variant *variant) {
    for (int k = 0; k < variant->changes; k++)
        if (variant->change[k].kind < VARIANT_SKIN || variant->change[k].kind == VARIANT_SETTINGS)
            return false;
    return true;
}
