/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks the stages of a scene: their ends, their conditions, and what they change. Read scene_stage.h first. */
#include "data/scene/scene_stage.h"

#include "data/observe/observables.h"
#include "data/scene/scene.h"
#include "data/scene/tree.h"

#include <math.h>
#include <string.h>

/* Full keys that a stage may set, with all below them. */
static const char *const may_change[] = {"gravity",
                                         "walls",
                                         "wall_contacts",
                                         "groups",
                                         "materials",
                                         "material_pairs",
                                         "insertions",
                                         "deletions",
                                         "box.shear",
                                         "box.strain",
                                         "box.stress",
                                         "heat.walls",
                                         "step",
                                         "guards",
                                         "output.trajectory.every",
                                         "output.trajectory.contacts",
                                         "output.dump.every",
                                         "output.walls.every",
                                         "output.contact_problems.every",
                                         "output.checkpoint",
                                         "output.progress",
                                         "observables.every"};

const struct tree_node *scene_stage_keys(const struct tree_node *root, int number) {
    const struct tree_node *stages = tree_get(root, "stages");
    if (!stages || stages->kind != TREE_LIST || number >= (int)stages->children ||
        stages->child[number]->kind != TREE_MAP)
        return NULL;
    const struct tree_node *keys = tree_get(stages->child[number], "set");
    return keys && keys->kind == TREE_MAP ? keys : NULL;
}

/* Fails with "PLACE: stages[K].KEY: TEXT". */
static bool fail(const struct scene *scene, struct error *error, int number, const char *key,
                 const char *text) {
    char full[128];
    snprintf(full, sizeof(full), "stages[%d]%s%.90s", number, key[0] ? "." : "", key);
    return scene_fail(scene, error, full, "stage '%s' %s", scene->stage[number].name, text);
}

/* Conditions. */

/* Splits "count/zone" into name and target; a target that is given stays. */
static struct observable_request divided(const struct observable_request *request) {
    struct observable_request own = *request;
    char *slash = strchr(own.name, '/');
    if (slash && !own.target[0])
        snprintf(own.target, sizeof(own.target), "%s", slash + 1);
    if (slash)
        *slash = '\0';
    return own;
}

static const struct observable_info *info_of(const char *name) {
    for (int k = 0; k < observables_count(); k++)
        if (strcmp(observables_get(k)->name, name) == 0)
            return observables_get(k);
    return NULL;
}

static bool has_region(const struct scene *scene, const char *target) {
    const struct observables_options *options = &scene->output.observables;
    size_t length = strcspn(target, "/");
    for (int k = 0; k < options->regions; k++)
        if (strlen(options->region[k].name) == length &&
            strncmp(options->region[k].name, target, length) == 0)
            return true;
    return false;
}

static bool has_plane(const struct scene *scene, const char *name) {
    const struct observables_options *options = &scene->output.observables;
    for (int k = 0; k < options->planes; k++)
        if (strcmp(options->plane[k].name, name) == 0)
            return true;
    return false;
}

static bool has_group(const struct scene *scene, const char *name) {
    for (int k = 0; k < scene->groups; k++)
        if (strcmp(scene->group[k].name, name) == 0)
            return true;
    return false;
}

/* True if the scene has the target of a condition; else `why` tells what is needed. */
static bool has_target(const struct scene *scene, const struct observable_request *request,
                       enum observable_target target, const char **why) {
    const char *name = request->target;
    *why = "";
    switch (target) {
    case OBSERVABLE_OF_WALL:
        *why = "needs a target: a wall of the scene as it is in this stage";
        return scene_wall(scene, name) >= 0;
    case OBSERVABLE_OF_REGION:
        *why = "needs a target: a region of observables.regions";
        return has_region(scene, name);
    case OBSERVABLE_OF_ALL_OR_REGION:
        *why = "has a target that is no region of observables.regions";
        return !name[0] || has_region(scene, name);
    case OBSERVABLE_OF_PLANE:
        *why = "needs a target: a plane of observables.planes";
        return has_plane(scene, name);
    case OBSERVABLE_OF_BODY:
        *why = "needs a target: a wall or a group";
        return scene_wall(scene, name) >= 0 || has_group(scene, name);
    case OBSERVABLE_OF_PARTICLE:
        *why = "needs the id of a particle";
        return request->id > 0;
    case OBSERVABLE_OF_EXPRESSION:
        *why = "needs an expression: `of`";
        return request->of[0];
    case OBSERVABLE_OF_ALL:
        break;
    }
    *why = "is of the whole run and has no target";
    return !name[0];
}

static bool check_condition(const struct scene *scene, int number, int k, struct error *error) {
    const struct scene_condition *condition = &scene->stage[number].condition[k];
    struct observable_request request = divided(&condition->request);
    const struct observable_info *info = info_of(request.name);
    unsigned bits = request.components;
    char key[64], text[256];
    const char *why;
    snprintf(key, sizeof(key), "until[%d]", k);
    if (!info) {
        snprintf(text, sizeof(text), "asks for '%.60s', which stands for several observables; name one",
                 request.name);
        return fail(scene, error, number, key, text);
    }
    if (info->components == 3 && bits != 1 && bits != 2 && bits != 4) {
        snprintf(text, sizeof(text), "asks for the vector '%.60s'; give component: x, y or z", request.name);
        return fail(scene, error, number, key, text);
    }
    if (info->components != 1 && info->components != 3) {
        snprintf(text, sizeof(text),
                 "asks for '%.60s', which has %d columns; needed: one with one column, or a vector",
                 request.name, info->components);
        return fail(scene, error, number, key, text);
    }
    if (!has_target(scene, &request, info->target, &why)) {
        snprintf(text, sizeof(text), "asks for '%.60s', which %s", request.name, why);
        return fail(scene, error, number, key, text);
    }
    if (isnan(condition->at_least) && isnan(condition->at_most))
        return fail(scene, error, number, key, "has a condition without a bound; give at_least or at_most");
    return !(condition->at_least > condition->at_most) ||
           fail(scene, error, number, key, "has a condition whose at_least is above at_most");
}

static bool check_conditions(const struct scene *scene, int number, struct error *error) {
    for (int k = 0; k < scene->stage[number].conditions; k++)
        if (!check_condition(scene, number, k, error))
            return false;
    return true;
}

void scene_stages_finish(struct scene *scene) {
    for (int k = 0; k < scene->stages; k++)
        if (isnan(scene->stage[k].duration) && scene->stage[k].conditions > 0)
            scene->stage[k].duration = INFINITY;
}

bool scene_stages_check(const struct scene *scene, struct error *error) {
    for (int k = 0; k < scene->stages; k++) {
        const struct scene_stage *stage = &scene->stage[k];
        if (isnan(stage->duration))
            return fail(scene, error, k, "", "has no end; give duration, or until");
        if (k == 0 && stage->set[0] && strcmp(stage->set, "{}") != 0)
            return fail(scene, error, k, "set",
                        "is the first: it begins with the scene itself, and sets nothing");
    }
    return scene->stages == 0 || check_conditions(scene, 0, error);
}

/* Changes. */

/* True if a full key, "walls[gate].motion", is one of those that may change, or below one. */
static bool key_may_change(const char *key) {
    char plain[256];
    size_t used = 0;
    for (const char *c = key; *c && used + 1 < sizeof(plain); c++) {
        if (*c == '[')
            c += strcspn(c, "]");
        else
            plain[used++] = *c;
        if (!*c)
            break;
    }
    plain[used] = '\0';
    for (size_t k = 0; k < sizeof(may_change) / sizeof(may_change[0]); k++) {
        size_t length = strlen(may_change[k]);
        if (strncmp(plain, may_change[k], length) == 0 && (plain[length] == '\0' || plain[length] == '.'))
            return true;
    }
    return false;
}

static bool check_keys(const struct scene *scene, int number, struct error *error) {
    const struct tree_node *keys = scene_stage_keys(scene->tree, number);
    char list[512] = "", text[900], place[SCENE_PATH_MAX + 32];
    for (size_t k = 0; k < sizeof(may_change) / sizeof(may_change[0]); k++)
        snprintf(list + strlen(list), sizeof(list) - strlen(list), "%s%s", k ? ", " : "", may_change[k]);
    for (size_t k = 0; keys && k < keys->children; k++) {
        if (key_may_change(keys->key[k]))
            continue;
        snprintf(text, sizeof(text),
                 "stages[%d].set: stage '%s' cannot change '%.80s'; a stage may change %s", number,
                 scene->stage[number].name, keys->key[k], list);
        tree_place(keys->child[k], scene->file, place, sizeof(place));
        return error_set(error, ERROR_USER, "%.700s: %s", place, text);
    }
    return true;
}

static bool check_names(const struct scene *before, const struct scene *scene, int number,
                        struct error *error) {
    bool same = before->materials == scene->materials;
    for (int k = 0; same && k < scene->materials; k++)
        same = strcmp(before->material[k].name, scene->material[k].name) == 0;
    if (!same)
        return fail(scene, error, number, "set",
                    "adds, drops or renames a material; only coefficients may change");
    same = before->groups == scene->groups;
    for (int k = 0; same && k < scene->groups; k++)
        same = strcmp(before->group[k].name, scene->group[k].name) == 0;
    if (!same)
        return fail(scene, error, number, "set",
                    "adds, drops or renames a group; only its motion may change");
    if (before->shear_given != scene->shear_given || before->strain_given != scene->strain_given ||
        before->stress_given != scene->stress_given)
        return fail(scene, error, number, "set",
                    "lets a box move that did not, or the other way round; begin with rates of 0");
    const struct box_motion *then = &before->box.motion, *now = &scene->box.motion;
    if (then->shears != now->shears || then->flow != now->flow || then->gradient != now->gradient)
        return fail(scene, error, number, "set",
                    "changes the plane of the shear; only its rate, or the target of its stress, may change");
    for (int w = 0; w < scene->walls; w++) {
        int earlier = scene_wall(before, scene->wall[w].name);
        if (earlier >= 0 && before->wall[earlier].permeable != scene->wall[w].permeable)
            return fail(scene, error, number, "set",
                        "changes `permeable` of a wall; a fluid is filled once, so it stays as at the start");
    }
    return before->insertions <= scene->insertions ||
           fail(scene, error, number, "set",
                "takes an insertion out; set its `stop` to an earlier time instead");
}

bool scene_stage_check(const struct scene *before, const struct scene *scene, int number,
                       struct error *error) {
    return check_keys(scene, number, error) && check_names(before, scene, number, error) &&
           check_conditions(scene, number, error);
}
