/* SPDX-License-Identifier: BSD-3-Clause */
/* The variants that are keys of the scene: those of its solver of contacts, the explicit runs beside it, and those of --vary.
 * Read variant.h first. */
#include "front/program/axis.h"
#include "front/program/variant.h"
#include "base/memory.h"
#include "data/scene/scene_read.h"
#include "physics/hard/hard.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Poisson's ratio of rigid grains in explicit runs. */
#define VARIANT_POISSON 0.25

int variant_settings(const struct variant *variant, struct scene_setting *setting,
                     char text[VARIANT_SET_MAX]) {
    int count = 0;
    char *rest = NULL;
    memcpy(text, variant->set, VARIANT_SET_MAX);
    for (char *at = strtok_r(text, "\n", &rest); at && count < VARIANT_SETTINGS_MAX;
         at = strtok_r(NULL, "\n", &rest))
        setting[count++].text = at;
    return count;
}

int variant_put(struct variant *list, int count, const char *group, const char *settings, const char *set) {
    struct variant *variant = &list[count];
    if (count == VARIANTS_MAX)
        return count;
    *variant = (struct variant){.group = group, .changes = 1, .change = {{VARIANT_SETTINGS, 0}}};
    snprintf(variant->settings, sizeof variant->settings, "%s", settings);
    snprintf(variant->set, sizeof variant->set, "%s\n", set);
    return count + 1;
}

/* The keys of an explicit run at a modulus (0: as the scene has it) and a part of the stable step. */
static void explicit_write(const struct scene *scene, double young, double part, char set[VARIANT_SET_MAX]) {
    bool rigid = law_has_trait(scene->law.normal, "stiff");
    size_t used = (size_t)snprintf(set, VARIANT_SET_MAX, "contact.solver=~\n%sstep.dt=~\nstep.fraction=%g",
                                   rigid ? "contact.law=hertz\n" : "", part);
    for (int m = 0; m < scene->materials && young > 0 && used < VARIANT_SET_MAX; m++)
        used += (size_t)snprintf(set + used, VARIANT_SET_MAX - used, "\nmaterials[%d].young=%.9g%s", m, young,
                                 scene->units == SCENE_UNITS_NONE ? "" : " Pa");
    for (int m = 0; m < scene->materials && rigid && used < VARIANT_SET_MAX; m++)
        used += (size_t)snprintf(set + used, VARIANT_SET_MAX - used, "\nmaterials[%d].poisson=%g", m,
                                 VARIANT_POISSON);
}

static int put_explicit(struct variant *list, int count, const struct scene *scene, double young) {
    static const double part[] = {0.6, 0.15};
    char settings[VARIANT_TEXT_MAX], set[VARIANT_SET_MAX], modulus[64] = "";
    bool giga = young >= 1e9, plain = scene->units == SCENE_UNITS_NONE;
    if (young > 0)
        snprintf(modulus, sizeof modulus, " %.4g%s", plain ? young : young / (giga ? 1e9 : 1e6),
                 plain  ? ""
                 : giga ? " GPa"
                        : " MPa");
    for (int k = 0; k < 2; k++) {
        snprintf(settings, sizeof settings, "explicit%s at %g of stable step", modulus, part[k]);
        explicit_write(scene, young, part[k], set);
        count = variant_put(list, count, "explicit", settings, set);
    }
    return count;
}

int variant_put_explicit(struct variant *list, int count, const struct scene *scene, double young) {
    static const double soft[] = {5e6, 1e9};
    bool rigid = law_has_trait(scene->law.normal, "stiff"),
         linear = law_row_get(scene->law.normal)->form->linear;
    double most = young;
    if (!scene->law.solved)
        return count;
    for (int m = 0; m < scene->materials && !rigid && !linear; m++)
        most = fmax(most, scene->material[m].young);
    for (int k = 0; k < 2 && scene->units == SCENE_UNITS_SI && (rigid || !linear); k++)
        if (most <= 0 || soft[k] < 0.99 * most)
            count = put_explicit(list, count, scene, soft[k]);
    if (young > 0 || !rigid)
        count = put_explicit(list, count, scene, young);
    return count;
}

/* More and fewer sweeps, softer and stiffer springs, the other method. */
int variant_put_solver(struct variant *list, int count, const struct scene *scene) {
    const struct hard_options *options =
        scene->law.solved ? (const void *)scene->physics[PHYSICS_hard] : NULL;
    char settings[VARIANT_TEXT_MAX], set[VARIANT_TEXT_MAX];
    static const double sweeps[] = {1.0 / 3, 3}, kappa[] = {0.25, 10};
    if (options == NULL)
        return count;
    for (int k = 0; k < 2; k++) {
        int often = (int)fmax(1, round(options->sweeps * sweeps[k]));
        snprintf(settings, sizeof settings, "%d sweeps", often);
        snprintf(set, sizeof set, "contact.solver.sweeps=%d", often);
        count = variant_put(list, count, "solver", settings, set);
    }
    for (int k = 0; k < 2 && law_has_trait(scene->law.normal, "stiff") && isfinite(options->kappa); k++) {
        snprintf(settings, sizeof settings, "kappa %.4g", options->kappa * kappa[k]);
        snprintf(set, sizeof set, "contact.solver.kappa=%.17g", options->kappa * kappa[k]);
        count = variant_put(list, count, "solver", settings, set);
    }
    bool newton = options->method == HARD_NEWTON;
    count = variant_put(list, count, "solver", newton ? "gauss_seidel" : "newton",
                        newton ? "contact.solver.name=gauss_seidel" : "contact.solver.name=newton");
    return count;
}

bool variant_vary(const struct command_line *line, struct variant *list, int *count, struct error *error) {
    struct axis *axis = memory_allocate(AXES_MAX, sizeof *axis, "variants");
    bool good = true;
    for (int k = 0; k < line->varied && good; k++)
        good = axis_cut_setting(&axis[k], line->vary[k], "vary", error);
    for (int run = 0; good && line->varied > 0 && run < axis_runs(axis, line->varied); run++) {
        char settings[VARIANT_TEXT_MAX] = "", set[VARIANT_SET_MAX] = "", one[AXIS_SETTING_MAX];
        int at[AXES_MAX];
        axis_places(axis, line->varied, run, at);
        for (int k = 0; k < line->varied; k++) {
            size_t shown = strlen(settings), used = strlen(set);
            axis_setting(&axis[k], at[k], one);
            snprintf(settings + shown, sizeof settings - shown, "%s%s", k ? "; " : "", one);
            snprintf(set + used, sizeof set - used, "%s%s", k ? "\n" : "", one);
        }
        int before = *count;
        *count = variant_put(list, before, "vary", settings, set);
        good = *count > before ||
               error_set(error, ERROR_USER, "command line: --vary: more than %d settings", VARIANTS_MAX);
    }
    memory_free(axis);
    return good;
}
