/* SPDX-License-Identifier: BSD-3-Clause */
/* `scree check`: prints the parts that a scene needs, and the reasons. */
#include "front/program/commands.h"
#include "front/program/check_parts.h"
#include "base/lines.h"
#include "physics/grains/walls/walls_free.h"
#include "physics/grains/grains.h"
#include "engine/skin_auto.h"
#include "engine/tune.h"
#include "engine/rebuild.h"
#include "engine/step.h"
#include "engine/notes.h"
#include "engine/outputs.h"
#include "engine/simulation.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LAYOUT_MOST = 1000000, NOTE_MAX = 256 };
static void print_classes(const struct size_classes *classes) {
    printf("\nsize classes\n  %5s %12s %12s %12s %12s\n", "class", "radius from", "to", "particles", "skin");
    for (int c = 0; c < classes->count; c++)
        printf("  %5d %12.6g %12.6g %12llu %12.6g\n", c, classes->radius_min[c], classes->radius_max[c],
               (unsigned long long)classes->population[c], classes->skin[c][c]);
}

/* Prints the interactions where there are several, and the pairs that each goes through. Without materials
 * nothing touches, and the first, that of grains, has none. */
static void print_interactions(const struct interactions *found, bool contacts) {
    if (found->count < 2)
        return;
    printf("\ninteractions, rank 0; the index finds %zu pairs\n  %-18s %12s\n", found->all->primary_count,
           "interaction", "pairs");
    for (int k = contacts ? 0 : 1; k < found->count; k++)
        printf("  %-18s %12zu  %s\n", found->row[k].name, interaction_list(found, k)->primary_count,
               found->own[k] ? "in a list of its own" : "in the list of all");
}

/* The levels of the index in one line. */
static void print_cells(const char *index, const struct index_description *description) {
    printf("index %s, rank 0", index);
    for (int l = 0; l < description->levels; l++) {
        const struct index_level *level = &description->level[l];
        printf("%s%.4g",
               l                         ? ", "
               : description->levels > 1 ? "; edges of the cells "
                                         : "; edge of a cell ",
               level->cell);
        if (level->cells && !level->sparse)
            printf(" (%.3g particles a cell)", (double)level->particles / (double)level->cells);
    }
    printf("\n");
}

static void print_levels(const struct search *search, const char *index, bool all) {
    struct index_description description;
    index_describe(search->index, &description);
    if (!all) {
        print_cells(index, &description);
        return;
    }
    printf("\nindex %s, rank 0\n  %5s %12s %12s %12s %14s\n", index, "level", "cell", "cells", "particles",
           "particles/cell");
    for (int l = 0; l < description.levels; l++) {
        const struct index_level *level = &description.level[l];
        printf("  %5d %12.6g %12zu %12zu %14.3g%s\n", l, level->cell, level->cells, level->particles,
               level->cells ? (double)level->particles / (double)level->cells : 0,
               level->sparse ? "  sparse" : "");
    }
    if (description.choice[0])
        printf("  chosen: %s; predicted %.4g ms a rebuild, the first took %.4g ms\n  %s\n",
               description.choice, 1e3 * description.predicted, 1e3 * tune_measured(search), description.why);
}

/* The longest step told of, as a part of the stable one, and the error of an impact up to which a step is told of
 * as well. */
static const double long_fraction = 0.9, small_error = 0.01;

/* Prints the share of the steps that a step of this part of the stable one takes, and its error by the study. */
static void print_price(const struct law_options *law, double present, double fraction) {
    double error = step_study_error(law, fraction);
    printf("  %13.3g %18.2g  ", fraction, present / fraction);
    if (isnan(error))
        printf("not studied\n");
    else
        printf("%.2g %%\n", 100 * error);
}

/* Prints the present step, which is a part of the stable one, and longer ones: the longest whose error is small, and the
 * longest. */
static void print_longer_steps(const struct law_options *law, double present) {
    double small = step_study_longest(law, small_error);
    printf("  step.fraction  of steps and time  an impact is off by up to (docs/speed-error.md)\n");
    print_price(law, present, present);
    bool longer =
        small > 1.001 * present && small < long_fraction; /* a run may have shortened its step by a trifle */
    if (longer)
        print_price(law, present, small);
    if (long_fraction > 1.001 * present)
        print_price(law, present, long_fraction);
    printf("  `scree ablate --error --only step` measures the errors of this scene%s\n",
           law->cohesion == LAW_COHESION_NONE ? "" : "; cohesion stronger than the study's has larger ones");
}

/* The step in two lines. */
static void print_step_short(const struct scene *scene, const struct clock *clock,
                             const struct timing *timing) {
    bool springs = scene->materials > 0 && !scene->law.solved;
    printf("time step %.6g", clock->dt);
    if (!isfinite(timing->stable)) {
        printf("; any is stable\n");
        return;
    }
    printf(" = %.3g of the stable %.6g (%s)\n", clock->dt / timing->stable, timing->stable, timing->why);
    double error = step_study_error(&scene->law, clock->dt / timing->stable),
           longer = step_study_error(&scene->law, long_fraction);
    if (springs && clock->dt_fraction > 0 && !isnan(error) && !isnan(longer))
        printf("  an impact is off by up to %.2g %%; step.fraction %.2g: %.2g of the steps, %.2g %% "
               "(docs/speed-error.md)\n",
               100 * error, long_fraction, clock->dt / timing->stable / long_fraction, 100 * longer);
}

static void print_step(const struct scene *scene, const struct clock *clock, const struct timing *timing,
                       const struct timestep_limits *limits) {
    bool limited = isfinite(timing->stable);
    bool springs = scene->materials > 0 && !scene->law.solved;
    printf("\ntime step\n");
    if (limited)
        printf("  stable       %.6g (%s)\n", timing->stable, timing->why);
    if (timing->stable < timing->expected)
        printf("               %.6g for contacts to come\n", timing->expected);
    if (springs)
        printf("  contact time %.6g\n", limits->contact_time);
    if (limits->rayleigh > 0)
        printf("  Rayleigh     %.6g\n", limits->rayleigh);
    if (limited)
        printf("  chosen       %.6g = %.3g of the stable one (default %.3g)\n", clock->dt,
               clock->dt / timing->stable, timestep_default_fraction());
    else
        printf("  chosen       %.6g; any is stable\n", clock->dt);
    if (limited && springs && clock->dt_fraction > 0)
        print_longer_steps(&scene->law, clock->dt / timing->stable);
}

/* Prints all notes together, for people who read only the notes; the last line says whether a guard would end
 * the run. */
static void print_notes(const struct notes *notes) {
    if (notes->count)
        printf("\n");
    notes_print(notes, "", stdout);
    if (notes->stops[0])
        printf("\na guard would stop this run at the expected speed: %s\n", notes->stops);
}

static const char *guard_word(enum scene_guard guard, bool trips) {
    if (guard == SCENE_GUARD_OFF)
        return "off";
    return !trips ? "" : guard == SCENE_GUARD_STOP ? ": would stop the run" : ": would warn";
}

/* Prints the state of the guards before the run. */
static void print_guards(const struct scene_guards *guards, const struct grains *grains, double moved) {
    printf("\nguards, at the expected speed of %.4g\n", grains->stable.speed_expected);
    printf("  speed    moves by %.3g of the smallest radius in a step (bound 1)%s\n", moved,
           guard_word(guards->speed, moved > 1));
    if (law_has_trait(grains->law.options.normal, "stiff"))
        printf("  overlap  rigid grains overlap by as little as their solver says (bound %g)%s\n",
               guards->overlap_bound, guard_word(guards->overlap, false));
    else
        printf("  overlap  like particles, or one and a wall, overlap by %.3g of the radius (bound %g)%s\n",
               grains->stable.overlaps.met, guards->overlap_bound,
               guard_word(guards->overlap, grains->stable.overlaps.met > guards->overlap_bound));
    if (grains->stable.overlaps.squeezed > grains->stable.overlaps.met)
        printf("           a grain of radius %.3g under the heaviest, on a support, by up to %.3g%s\n",
               grains->stable.overlaps.radius, grains->stable.overlaps.squeezed,
               grains->stable.overlaps.squeezed > guards->overlap_bound && guards->overlap != SCENE_GUARD_OFF
                   ? guards->overlap == SCENE_GUARD_STOP ? ": may stop the run" : ": may warn"
                   : "");
    if (grains->stable.overlap_started > 0)
        printf("           overlaps at the start are up to %.3g%s\n", grains->stable.overlap_started,
               guard_word(guards->overlap, grains->stable.overlap_started > guards->overlap_bound));
    printf("  energy   %s\n", guards->energy == SCENE_GUARD_OFF ? "growth is not looked at"
                                                                : "growth without cause is looked for");
}

static void print_memory(const struct particles *particles, const struct search *search,
                         const struct law *law, bool skin_chosen, bool all) {
    double n = particles->owned ? (double)particles->owned : 1;
    printf("%smemory, rank 0: %.1f MiB, %.0f bytes a particle%s", all ? "\n" : "",
           (double)memory_in_use() / 1048576, (double)memory_in_use() / n, all ? "\n" : "; ");
    if (all)
        printf("  particles %.1f, pairs %.1f, index %.1f, history %.1f MiB\n",
               (double)(particles_bytes_each(particles) * particles->capacity) / 1048576,
               (double)pairlist_memory(search->list) / 1048576, (double)index_memory(search->index) / 1048576,
               search->history ? (double)history_memory(search->history) / 1048576 : 0);
    else
        check_parts_bytes(particles, law);
    if (skin_chosen)
        printf("  pairs up to %.1f MiB, as the run chooses the skin\n",
               fmax(SKIN_PAIRS_MOST * n * 2 * sizeof(uint32_t), (double)pairlist_memory(search->list)) /
                   1048576);
}

static void print_extent(const char *what, const char *name, const struct extent *extent, const char *note) {
    char title[WALL_NAME_MAX + 16];
    snprintf(title, sizeof title, "%s%s%s%s", what, name[0] ? " '" : "", name, name[0] ? "'" : "");
    printf("  %-24s", title);
    for (int d = 0; d < 3; d++)
        printf("  %11.5g ... %-11.5g", extent->lower[d], extent->upper[d]);
    printf("%s\n", note);
}

/* Writes what is to be said of wall w besides its extent. */
static const char *wall_note(const struct walls *walls, int w, const struct scene *scene,
                             const struct extent *extent, char text[NOTE_MAX]) {
    const struct wall_options *wall = walls_options(walls, w);
    walls_describe(walls, w, text, NOTE_MAX);
    if (wall_shape_meshed(wall->shape) && grains_wall_apart(scene, extent))
        snprintf(text, NOTE_MAX, "  NOTE: wholly outside of the box");
    for (int m = 0; m < wall->motions; m++)
        if (wall->motion[m].kind == WALL_SERVO && wall->motion[m].pressure > 0)
            snprintf(text, NOTE_MAX, "  pressure %.4g x area %.4g = force %.4g", wall->motion[m].pressure,
                     wall->motion[m].area, wall->motion[m].force);
    return text;
}

/* Prints the extent of particles and walls, as parts that lie far apart are probably a mistake. */
static void print_extents(const struct scene *scene, const struct grains *grains, const struct notes *notes) {
    static const char *const shapes[] = {[WALL_PLANE] = "plane", [WALL_CYLINDER] = "cylinder",
                                         [WALL_MESH] = "mesh",   [WALL_RECTANGLE] = "rectangle",
                                         [WALL_BOX] = "box",     [WALL_DISC] = "disc",
                                         [WALL_CONE] = "cone"};
    struct extent box;
    char note[NOTE_MAX] = "";
    memcpy(box.lower, scene->box_lower, sizeof box.lower);
    memcpy(box.upper, scene->box_upper, sizeof box.upper);
    printf("\nwhere it is\n  %-24s  %-27s  %-27s  %s\n", "", "x from ... to", "y from ... to",
           "z from ... to");
    print_extent("box", "", &box, "");
    if (notes->outside > 0)
        snprintf(note, sizeof note, "  NOTE: %lld of them outside of the box", (long long)notes->outside);
    if (notes->total > 0)
        print_extent("particles", "", &notes->particles, note);
    for (int w = 0; w < scene->walls; w++) {
        const struct wall_options *wall = &scene->wall[w];
        struct extent extent = grains_wall_extent(grains, scene, w);
        print_extent(shapes[wall->shape], wall->name, &extent,
                     wall_note(grains->walls, w, scene, &extent, note));
    }
}

/* The parts of the program that work on the scene. */
static void print_inside(const struct simulation *s) {
    printf("\npasses of a step\n");
    step_plan_print(&s->plan, s->scene->step.fused, stdout);
    printf("\npasses of a rebuild\n");
    rebuild_print(s->scene, &s->ranks, &s->search, &s->physics, stdout);
    check_parts_fields(s->particles, s->scene, &grains_of(&s->physics)->law);
    if (!s->ranks.alone)
        check_parts_wire(s->particles, s->search.view.newton);
}

static void print_scene(const struct simulation *s, const struct notes *notes, bool all) {
    const struct scene *scene = s->scene;
    const struct grains *grains = grains_of(&s->physics);
    printf("%s: valid\n", scene->file);
    printf("  %llu particles, %d materials, %d walls, %d groups, %s, %s, %s\n", (unsigned long long)s->total,
           scene->materials, scene->walls, scene->groups, scene->box.dimension == 2 ? "2D" : "3D",
           scene->integrator,
           scene->materials > 0 ? law_row_get(grains->law.options.normal)->name : "no contacts");
    printf("  %d rank%s, %d thread%s each, newton %s; %zu pairs and %zu contacts at the start on rank 0\n",
           s->comm->size, s->comm->size == 1 ? "" : "s", s->threads, s->threads == 1 ? "" : "s",
           s->search.view.newton ? "on" : "off", s->search.list->primary_count, grains->sums.contacts);
    if (scene->reproducible)
        printf("  reproducible: pairs across ranks are computed on both sides (newton off, full copies)\n");
    print_extents(scene, grains, notes);
    check_parts_terms(scene, grains, s->ranks.alone, s->sums_each_step, all);
    if (all)
        print_inside(s);
    print_classes(&s->classes);
    if (scene->classes.skin_auto)
        printf("  the run chooses the skin: from %.3g to %.3g times that above, with up to %d pairs a "
               "particle\n",
               skin_choice_factor(SKIN_LEAST),
               skin_auto_most(&s->search.choice, &s->classes, scene, &s->box, s->ranks.alone),
               SKIN_PAIRS_MOST);
    print_interactions(&s->search.interactions, scene->materials > 0);
    print_levels(&s->search, scene->index.name, all);
    if (all)
        print_step(scene, &s->clock, &s->timing, &grains->stable.limits);
    else
        print_step_short(scene, &s->clock, &s->timing);
    print_guards(&scene->guards, grains, notes_moved(notes, &s->classes, s->clock.dt));
    if (s->clock.dt > s->timing.stable)
        printf("  step     %.3g of the stable one: energy will grow\n", s->clock.dt / s->timing.stable);
    print_memory(s->particles, &s->search, &grains->law, scene->classes.skin_auto, all);
}

/* Refuses scenes that a run would refuse before its first step although all parts can be made. */
static bool outputs_suit(const struct simulation *s, struct error *error) {
    struct outputs *outputs;
    struct output_run run = outputs_run(s->scene, &s->box, &s->lineage, NULL);
    return outputs_create(&outputs, s, &run, error) && outputs_close(&outputs, s->comm, error);
}

/* Reads a flag with a number of ranks or threads; 0: not given. */
static bool number_read(const char *flag, const char *text, int64_t *number, struct error *error) {
    *number = 0;
    if (text == NULL || (lines_integer(text, number) && *number >= 1 && *number <= LAYOUT_MOST))
        return true;
    return error_set(error, ERROR_USER, "command line: --%s %s: must be a number from 1 to %d", flag, text,
                     LAYOUT_MOST);
}

/* Reads the layout that --ranks and --threads ask about; no ranks: none is asked for. */
static bool layout_read(const struct comm *comm, const struct command_line *line, int64_t *ranks,
                        int64_t *threads, struct error *error) {
    const char *wanted = line->list[ABLATE_THREADS];
    if (!number_read("ranks", line->ranks, ranks, error) || !number_read("threads", wanted, threads, error))
        return false;
    if (wanted && !line->ranks)
        return error_set(error, ERROR_USER, "command line: --threads goes with --ranks N");
    return !line->ranks || comm->size == 1 ||
           error_set(error, ERROR_USER, "command line: --ranks is for one rank; check was started on %d",
                     comm->size);
}

int command_check(const struct comm *comm, const struct command_line *line, struct error *error) {
    int status = 0;
    int64_t ranks, threads;
    if (!layout_read(comm, line, &ranks, &threads, error))
        return error->kind;
    struct scene *scene = command_scene(comm, line, NULL, 0, error);
    if (scene == NULL)
        return error->kind;
    struct simulation *s = simulation_create(comm, scene, NULL, error);
    if (s && outputs_suit(s, error)) {
        struct notes *notes = memory_allocate_zero(1, sizeof *notes, "notes");
        notes_take(s, notes);
        if (comm->rank == 0)
            print_scene(s, notes, line->all);
        PHYSICS_EACH (active, &s->physics, print)
            active->row->print(&active->context, stdout);
        if (ranks)
            layout_print(s, (int)ranks, threads ? (int)threads : s->threads, error);
        run_cost_print(s, line->all);
        if (comm->rank == 0 && !line->all)
            printf("\n--all prints what is off, each field of a particle, and the passes of a step\n");
        if (comm->rank == 0)
            print_notes(notes);
        status = notes->stops[0] ? ERROR_PHYSICS : 0;
        memory_free(notes);
    }
    simulation_destroy(&s);
    scene_free(&scene);
    return error->kind ? (int)error->kind : status;
}
