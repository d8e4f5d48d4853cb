/* SPDX-License-Identifier: BSD-3-Clause */
/* Contacts of walls as a physics: checks of the section, the passes of the step, the hooks of the engine. Read blocks.h first. */
#include "physics/blocks/blocks_state.h"
#include "base/checksum.h"
#include "base/memory.h"
#include "engine/physics_set.h"
#include "engine/trip.h"
#include "physics/grains/grains.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Laws that know spheres alone, as for rocks. */
static bool check_law(const struct physics_context *context, struct error *error) {
    static const char key[] = "wall_contacts";
    const struct scene *scene = context->scene;
    const struct law *law = &grains_of(context->set)->law;
    if (scene->materials == 0)
        return scene_fail(scene, error, key, "needs materials, whose law walls touch by");
    if (law->general) {
        char title[LAW_TITLE_MAX];
        law_title(&law->options, title);
        return scene_fail(
            scene, error, key,
            "the contact law (%s) is for spheres; allowed with contacts of walls are laws without "
            "cohesion, plasticity, branches and twisting",
            title);
    }
    if (law->options.lammps_history || law->options.lammps_granular)
        return scene_fail(scene, error, key,
                          "a law to the letter of LAMMPS is for spheres: not with contacts of walls");
    return !scene->law.solved ||
           scene_fail(
               scene, error, key,
               "contact.solver knows contacts of particles; walls touch by an explicit law (not built yet)");
}

static bool check_pairs(const struct physics_context *context, struct error *error) {
    const struct blocks_options *options = context->options;
    for (int p = 0; p < options->pairs; p++) {
        const struct blocks_pair_options *pair = &options->pair[p];
        char key[64];
        snprintf(key, sizeof key, "wall_contacts.pairs[%d].walls", p);
        if (pair->walls != 2 || pair->wall[0] == pair->wall[1])
            return scene_fail(context->scene, error, key, "needs the names of two walls");
        for (int q = 0; q < p; q++) {
            const int *other = options->pair[q].wall;
            if ((other[0] == pair->wall[0] && other[1] == pair->wall[1]) ||
                (other[0] == pair->wall[1] && other[1] == pair->wall[0]))
                return scene_fail(context->scene, error, key, "names the walls of pairs[%d] again", q);
        }
    }
    return true;
}

static bool check(const struct physics_context *context, struct error *error) {
    struct blocks blocks;
    if (context->box->dimension == 2)
        return scene_fail(context->scene, error, "wall_contacts", "needs three dimensions");
    if (!check_law(context, error) || !check_pairs(context, error))
        return false;
    bool good = blocks_make(&blocks, context, error);
    blocks_free(&blocks);
    return good;
}

static void *create(const struct physics_context *context) {
    struct blocks *blocks = memory_allocate_zero(1, sizeof *blocks, "wall contacts");
    struct error none = {0};
    if (!blocks_make(blocks, context, &none))
        error_fatal("%s", none.text); /* a file that has changed since the check */
    return blocks;
}

static void destroy(void *self) {
    blocks_free(self);
    memory_free(self);
}

static void act(const struct physics_context *context) {
    blocks_act(context->self, context);
}

/* Adds the energies, once those of other contacts are known. All ranks have the same. */
static void sum(const struct physics_context *context) {
    const struct blocks *blocks = context->self;
    struct grains *grains = grains_of(context->set);
    for (int p = 0; p < blocks->pairs && context->comm->rank == 0; p++) {
        const struct blocks_pair *pair = &blocks->pair[p];
        grains->sums.elastic_normal += pair->normal;
        grains->sums.elastic_tangential += pair->tangential;
        grains->sums.taken += pair->taken;
        grains->taken += pair->taken;
    }
}

static void guard(const struct physics_context *context, struct error *error) {
    struct blocks *blocks = context->self;
    const struct scene *scene = context->scene;
    for (int p = 0; p < blocks->pairs && scene->guards.overlap != SCENE_GUARD_OFF; p++) {
        const struct blocks_pair *pair = &blocks->pair[p];
        const double relative = pair->overlap / blocks_size(blocks, pair);
        char text[400];
        if (!(relative > scene->guards.overlap_bound))
            continue;
        snprintf(
            text, sizeof text,
            "guards.overlap: walls '%.64s' and '%.64s' overlap by %.3g of the smaller one (bound %g) at step "
            "%llu, t = %.9g",
            scene->wall[pair->wall[0]].name, scene->wall[pair->wall[1]].name, relative,
            scene->guards.overlap_bound, (unsigned long long)context->clock->step, context->clock->time);
        trip(scene->guards.overlap, text, error, context->log, &blocks->warned);
    }
}

/* A number for the names of a pair: a resume, or a stage, may have other pairs. */
static uint64_t key_of(const struct scene *scene, const struct blocks_pair *pair) {
    const char *first = scene->wall[pair->wall[0]].name, *second = scene->wall[pair->wall[1]].name;
    return checksum_row(checksum_row(0, first, strlen(first)), second, strlen(second));
}

static void restart(const struct physics_context *context, struct restart *list) {
    struct blocks *blocks = context->self;
    for (int p = 0; p < blocks->pairs; p++) {
        struct blocks_pair *pair = &blocks->pair[p];
        const uint64_t key = key_of(context->scene, pair);
        restart_add(list, RESTART_REAL, true, &pair->points, "walls %016" PRIx64, key);
        for (int k = 0; k < TOUCH_POINTS_MAX * TOUCH_NUMBERS; k++)
            restart_add(list, RESTART_REAL, true, &pair->point[0].key + k, "walls %016" PRIx64 " %d", key, k);
    }
}

static void print(const struct physics_context *context, FILE *file) {
    const struct blocks *blocks = context->self;
    for (int p = 0; p < blocks->pairs && context->comm->rank == 0; p++) {
        const struct blocks_pair *pair = &blocks->pair[p];
        fprintf(file, "walls '%s' and '%s' touch, with the radius %.6g in the law\n",
                context->scene->wall[pair->wall[0]].name, context->scene->wall[pair->wall[1]].name,
                blocks_radius(blocks, pair));
    }
}

/* Blocks join no grains. */
static bool joins(const struct physics_context *context) {
    (void)context;
    return false;
}

static bool joined(const struct physics_context *context, size_t i, size_t j) {
    (void)context, (void)i, (void)j;
    return false;
}

static void stiffen(const struct physics_context *context, struct stability *stability) {
    blocks_stiffen(context->self, context, stability);
}

static double stiffest(const struct physics_context *context, const struct stability *stability) {
    return blocks_stiffest(context->self, stability);
}

static const struct physics_pass passes[] = {
    {.name = "blocks",
     .does = "contacts of walls with walls",
     .why = "wall_contacts",
     .place = PASS_SHARES,
     .whole = act},
    {.name = "blocks_sum", .why = "wall_contacts", .place = PASS_CLOSE, .timer = "blocks", .whole = sum}};
static const struct physics_joints joints = {
    .joined = joined, .joins = joins, .stiffen = stiffen, .stiffest = stiffest};

const struct physics blocks_physics = {.name = "blocks",
                                       .passes = sizeof passes / sizeof passes[0],
                                       .pass = passes,
                                       .check = check,
                                       .create = create,
                                       .destroy = destroy,
                                       .guard = guard,
                                       .print = print,
                                       .restart = restart,
                                       .joints = &joints};
