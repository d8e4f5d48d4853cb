/* SPDX-License-Identifier: BSD-3-Clause */
/* Checks, opens and closes the files of a run. Read outputs.h first. */
#include "engine/outputs_parts.h"
#include "engine/index_view.h"
#include "base/memory.h"
#include "data/formats/dump.h"
#include "data/formats/frame.h"
#include <stdio.h>
#include <string.h>

static bool h5md_wanted(const struct outputs *o) {
    return output_interval_set(&o->options->trajectory.every) ||
           output_interval_set(&o->options->trajectory.contacts);
}

/* Puts the place of `key` in the scene before the text of a user's error. */
static bool fail_at(const struct scene *scene, const char *key, struct error *error) {
    char place[SCENE_PATH_MAX];
    struct error plain = *error;
    if (plain.kind != ERROR_USER)
        return false;
    *error = (struct error){0};
    error_set(error, ERROR_USER, "%s: %s", scene_place(scene, key, place, sizeof place), plain.text);
    return false;
}

/* True if a particle has this id. Collective. */
static bool id_there(const struct particles *particles, const struct comm *comm, int64_t id) {
    int64_t found = 0;
    for (size_t k = 0; k < particles->owned; k++)
        found += particles->id[k] == id;
    comm_sum_int(comm, &found, 1);
    return found > 0;
}

/* Refuses ids that no particle has or will have: the scene inserts none. In a resumed run a particle may have
 * left before. Collective. */
static bool observables_check_ids(const struct scene *scene, const struct particles *particles,
                                  const struct comm *comm, int64_t next_id, bool resumed,
                                  struct error *error) {
    const struct observables_options *options = &scene->output.observables;
    for (int k = 0; scene->insertions == 0 && k < options->count; k++) {
        int64_t id = options->request[k].id;
        char key[64];
        if (id <= 0 || (resumed ? id < next_id : id_there(particles, comm, id)))
            continue;
        snprintf(key, sizeof key, "observables.list[%d].id", k);
        error_set(error, ERROR_USER, "%s: there is no particle %lld; ids go up to %lld", key, (long long)id,
                  (long long)next_id - 1);
        return fail_at(scene, key, error);
    }
    return true;
}

static bool observables_prepare(struct outputs *o, const struct simulation *s, struct error *error) {
    struct output_view view = simulation_view(s);
    if (!observables_check_ids(s->scene, s->particles, s->comm, s->sources.next_id, s->resumed.dt > 0, error))
        return false;
    return observables_create(&o->observables, &o->options->observables, &view, o->run, error) ||
           fail_at(s->scene, "observables.list", error);
}

static bool grids_open(struct outputs *o, const struct output_view *view, bool resumed, struct error *error) {
    bool good = true;
    for (int k = 0; good && k < o->options->observables.grids; k++)
        good = observables_grid_open(&o->grid[k], &o->options->observables.grid[k], view, o->run->directory,
                                     resumed ? view->time : -1, error);
    return good;
}

static bool files_open(struct outputs *o, const struct comm *comm, const struct physics_set *set,
                       int64_t step, struct error *error) {
    char path[FILE_PATH_MAX];
    if (h5md_wanted(o)) {
        PHYSICS_EACH (active, set, shown)
            if (active->row->shown->shapes)
                active->row->shown->shapes(&active->context, &o->shapes);
        struct h5md_head head = {.lineage = o->run->lineage,
                                 .shapes = &o->shapes,
                                 .dimensionless = o->run->dimensionless || !o->options->trajectory.units,
                                 .single = o->options->trajectory.precision == OUTPUT_SINGLE,
                                 .deflate = (int)o->options->trajectory.deflate,
                                 .varying = o->run->varying,
                                 .xdmf = o->options->trajectory.xdmf,
                                 .seed = o->run->seed};
        snprintf(path, sizeof path, "%s/trajectory.h5", o->run->directory);
        if (!h5md_open(&o->h5md, comm, path, &head, step, error))
            return false;
    }
    if (output_interval_set(&o->options->dump.every)) {
        snprintf(path, sizeof path, "%s/dump.lammpstrj", o->run->directory);
        if (!dump_open(&o->dump, comm, path, step, error))
            return false;
    }
    return !output_interval_set(&o->options->walls.every) ||
           wall_frames_open(&o->walls, comm, o->run->directory, step, error);
}

struct output_run outputs_run(const struct scene *scene, const struct box *box, const struct lineage *lineage,
                              const char *directory) {
    struct output_run run = {.directory = directory,
                             .scene = lineage->count > 0 ? lineage->run[lineage->count - 1].scene : NULL,
                             .lineage = lineage,
                             .dimensionless = scene->units == SCENE_UNITS_NONE,
                             .varying = scene->stages > 1 || scene->insertions > 0 || scene->deletions > 0 ||
                                        box_may_lose(box),
                             .seed = scene->seed,
                             .materials = scene->materials,
                             .material = scene->material,
                             .groups = scene->groups};
    for (int g = 0; g < scene->groups; g++)
        run.group[g] = scene->group[g].name;
    return run;
}

bool outputs_create(struct outputs **outputs, const struct simulation *s, const struct output_run *run,
                    struct error *error) {
    struct outputs *o = memory_allocate_zero(1, sizeof *o, "outputs");
    o->options = &s->scene->output;
    o->run = run;
    bool good = (frame_check_fields(&o->options->trajectory.fields, s->particles, error) ||
                 fail_at(s->scene, "output.trajectory.fields", error)) &&
                ((frame_check_fields(&o->options->dump.fields, s->particles, error) &&
                  dump_check_fields(&o->options->dump.fields, s->particles, error)) ||
                 fail_at(s->scene, "output.dump.fields", error));
    if (good && output_interval_set(&o->options->observables.every))
        good = observables_prepare(o, s, error);
    *outputs = o;
    if (comm_agree(s->comm, error) && good)
        return true;
    struct error second = {0};
    outputs_close(outputs, s->comm, &second);
    return false;
}

bool outputs_go_on(const struct outputs *o, const struct comm *comm, struct error *error) {
    const char *directory = o->run->directory;
    char path[FILE_PATH_MAX];
    if (comm->rank == 0 && o->observables)
        observables_suit(o->observables, directory, error);
    for (int k = 0; comm->rank == 0 && k < o->options->observables.grids; k++)
        observables_grid_suits(&o->options->observables.grid[k], directory, error);
    if (!comm_agree(comm, error))
        return false;
    snprintf(path, sizeof path, "%s/trajectory.h5", directory);
    int64_t present = h5md_wanted(o) && comm->rank == 0 && file_size(path) >= 0;
    comm_max_int(comm, &present, 1);
    return !present || h5md_suits(comm, path, o->run->varying, error);
}

bool outputs_open(struct outputs *o, const struct output_view *view, const struct physics_set *set,
                  bool resumed, struct error *error) {
    int64_t step = resumed ? (int64_t)view->step : -1;
    bool good = o->observables == NULL || observables_open(o->observables, view->comm, o->run->directory,
                                                           resumed ? view->time : -1, error);
    good = good && grids_open(o, view, resumed, error) && files_open(o, view->comm, set, step, error);
    PHYSICS_EACH (active, set, table)
        good = good && active->row->table->open(&active->context, o->run->directory, step, error);
    return comm_agree(view->comm, error) && good;
}

bool outputs_close(struct outputs **outputs, const struct comm *comm, struct error *error) {
    struct outputs *o = *outputs;
    struct error own = {0};
    if (o == NULL)
        return true;
    /* after a failure of the system nothing more is written; after another error the rest is still written */
    struct error *here = error->kind == ERROR_SYSTEM ? error : &own;
    bool good = true;
    if (o->h5md)
        good = h5md_close(&o->h5md, here) && good;
    if (o->dump)
        good = dump_close(&o->dump, here) && good;
    if (error->kind == ERROR_NONE)
        *error = own;
    for (int k = 0; k < o->options->observables.grids; k++)
        observables_grid_close(&o->grid[k]);
    wall_frames_close(&o->walls);
    output_shapes_free(&o->shapes);
    if (o->observables)
        observables_destroy(&o->observables);
    memory_free(o);
    *outputs = NULL;
    return comm_agree(comm, error) && good;
}
