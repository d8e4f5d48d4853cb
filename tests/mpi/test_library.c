/* SPDX-License-Identifier: BSD-3-Clause */
/* The engine as a library (scree.h): the ranks of a communicator against each rank alone, in a reproducible scene.
 * Ranks: 1 2 */
#include "tests/test.h"

#include "base/memory.h"
#include "scree.h"
#include "team.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { GRAINS = 400, STEPS = 60 };

static const char scene[] =
    "units: none\nreproducible: true\nthreads: 1\ngravity: [0, 0, -1]\nbox: {lower: [-6, 2, 0], upper: [6, "
    "8, 8], "
    "periodic: [true, true, false]}\nstep: {dt: 0.001, count: 100}\ncontact: {law: hertz}\n"
    "materials: [{name: a, density: 1, young: 2000, poisson: 0.3}, {name: b, density: 2, young: 2000, "
    "poisson: "
    "0.3}]\nmaterial_pairs: [{restitution: 0.5, friction: 0.5}]\n"
    "walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}]\n"
    "particles: {from: random, region: {shape: box, lower: [-6, 2, 0], upper: [6, 8, 5]}, count: 400, "
    "material: a, "
    "sizes: {law: power, min: 0.2, max: 0.6, exponent: -2}, velocity: [1, 0, -2]}\n"
    "observables: {every: 20, list: [{name: particles}, {name: momentum}, {name: position, id: 7, label: "
    "seven}]}\n";

/* What a simulation leaves: positions and velocities by id, and the last row of observables. */
struct state {
    double x[GRAINS + 3][3], v[GRAINS + 3][3], row[16];
    size_t rows;
    int columns;
};

/* Copies a field of this rank's particles to their ids; `sum` ranks hold zeros elsewhere. */
static void gather(struct team *team, const struct scree_simulation *s, const char *name, double (*to)[3],
                   bool together) {
    struct scree_field field, id;
    bool good = scree_field(s, name, &field) && scree_field(s, "id", &id);
    if (!team_expect(team, good && field.components == 3 && id.type == SCREE_INT64, "no field %s", name))
        return;
    memset(to, 0, (GRAINS + 3) * sizeof *to);
    for (size_t k = 0; k < field.count; k++) {
        int64_t number = *(int64_t *)((char *)id.data + k * id.stride);
        if (team_expect(team, number >= 1 && number < GRAINS + 3, "id %lld", (long long)number))
            memcpy(to[number], (char *)field.data + k * field.stride, sizeof *to);
    }
    if (together)
        comm_sum(&team->comm, to[0], 3 * (GRAINS + 3));
}

static void look(struct team *team, const struct scree_simulation *s, bool together, struct state *state) {
    gather(team, s, "position", state->x, together);
    gather(team, s, "velocity", state->v, together);
    state->rows = scree_rows(s);
    state->columns = scree_columns(s);
    if (state->rows > 0)
        memcpy(state->row, scree_row(s, state->rows - 1), (1 + (size_t)state->columns) * sizeof(double));
}

static struct scree_simulation *create(struct team *team, const struct scree_options *options) {
    struct scree_error error;
    struct scree_simulation *s = scree_create("scene", scene, options, &error);
    team_expect(team, s != NULL && error.status == SCREE_GOOD, "%s", error.text);
    return s;
}

static void step(struct team *team, struct scree_simulation *s, uint64_t steps) {
    struct scree_error error;
    team_expect(team, scree_step(s, steps, &error), "%s", error.text);
}

/* A pull towards the middle of the box, and a count of its calls. */
static void pull(void *context, struct scree_simulation *s) {
    struct scree_field x, f;
    ++*(int *)context;
    if (!scree_field(s, "position", &x) || !scree_field(s, "force", &f))
        return;
    for (size_t k = 0; k < x.count; k++)
        ((double *)((char *)f.data + k * f.stride))[0] += 3 - ((double *)((char *)x.data + k * x.stride))[0];
}

static void ranks_together_get_what_one_gets_alone(void **test) {
    struct team *team = *test;
    static struct state together, alone;
    int calls[2] = {0, 0};
    struct scree_options both = {.communicator = &team->comm.handle,
                                 .force = pull,
                                 .force_context = &calls[0]},
                         one = {.force = pull, .force_context = &calls[1]};
    struct scree_simulation *s = create(team, &both), *single = create(team, &one);
    if (s && single) {
        team_expect(team, scree_steps_left(s) == 100 && scree_particles(s) == GRAINS, "%zu particles",
                    (size_t)scree_particles(s));
        step(team, s, STEPS);
        step(team, single, STEPS / 2);
        step(team, single, STEPS / 2);
        look(team, s, true, &together);
        look(team, single, false, &alone);
        team_expect(team, calls[0] == STEPS + 1 && calls[1] == STEPS + 1, "%d and %d calls", calls[0],
                    calls[1]);
        team_expect(team, memcmp(&together, &alone, sizeof alone) == 0,
                    "ranks together differ from one alone");
        team_expect(team,
                    alone.rows == 4 && alone.columns == 7 && alone.row[1] == GRAINS &&
                        alone.row[5] == alone.x[7][0] - 6,
                    "%zu rows of %d, %g %g", alone.rows, alone.columns, alone.row[1], alone.row[5]);
    }
    scree_destroy(&s);
    scree_destroy(&single);
    team_finish(team);
}

static void asks_for_a_report(void *context, struct scree_simulation *s) {
    struct scree_error error;
    *(bool *)context = scree_report(s, &error) == NULL && error.status == SCREE_USER;
}

static void a_report_tells_of_the_steps(void **test) {
    struct team *team = *test;
    bool refused = false;
    char wanted[40];
    struct scree_options options = {
        .communicator = &team->comm.handle, .force = asks_for_a_report, .force_context = &refused};
    struct scree_error error;
    struct scree_simulation *s = create(team, &options);
    snprintf(wanted, sizeof wanted, "\n  \"ranks\": %d,\n", team->comm.size);
    for (int steps = 0; s && steps <= 10; steps += 5) {
        char count[40];
        snprintf(count, sizeof count, "{\n  \"steps\": %d,\n", steps);
        const char *text = scree_report(s, &error);
        if (team_expect(team, text != NULL, "%s", error.text))
            team_expect(team, strncmp(text, count, strlen(count)) == 0 && strstr(text, wanted), "%s", text);
        step(team, s, 5);
    }
    team_expect(team, refused, "a force got a report");
    team_expect(team, scree_report(NULL, &error) == NULL && error.status == SCREE_USER, "%s", error.text);
    scree_destroy(&s);
    team_finish(team);
}

/* A folder that all ranks know. */
static void folder(struct team *team, char path[32]) {
    snprintf(path, 32, "/tmp/scree-lib-XXXXXX");
    if (team->comm.rank == 0)
        team_expect(team, mkdtemp(path) != NULL, "no folder");
    comm_broadcast(&team->comm, path, 32);
}

static void a_checkpoint_goes_on_to_the_bit(void **test) {
    struct team *team = *test;
    static struct state went, resumed;
    char path[32], file[64];
    struct scree_options options = {.communicator = &team->comm.handle};
    struct scree_error error;
    folder(team, path);
    snprintf(file, sizeof file, "%s/checkpoint-%d.h5", path, STEPS);
    struct scree_simulation *s = create(team, &options);
    if (s) {
        step(team, s, STEPS);
        team_expect(team, scree_checkpoint(s, path, &error), "%s", error.text);
        step(team, s, 40);
        look(team, s, true, &went);
    }
    scree_destroy(&s);
    options.resume = file;
    s = create(team, &options);
    if (s) {
        team_expect(team, scree_step_number(s) == STEPS, "step %d", (int)scree_step_number(s));
        step(team, s, 40);
        look(team, s, true, &resumed);
        team_expect(team, memcmp(went.x, resumed.x, sizeof went.x) == 0, "positions differ");
        team_expect(team, memcmp(went.v, resumed.v, sizeof went.v) == 0, "velocities differ");
        team_expect(team, scree_steps_left(s) == 0, "%d steps left", (int)scree_steps_left(s));
    }
    scree_destroy(&s);
    if (team->comm.rank == 0) {
        remove(file);
        rmdir(path);
    }
    team_finish(team);
}

static void particles_come_go_and_are_moved(void **test) {
    struct team *team = *test;
    static struct state state;
    struct scree_options options = {.communicator = &team->comm.handle};
    struct scree_error error;
    struct scree_simulation *s = create(team, &options);
    struct scree_particle two[2] = {{.position = {1, 5, 7.5}, .radius = 0.1, .velocity = {2, 0, 0}},
                                    {.position = {-5, 3, 7.5}, .radius = 0.2, .density = 4, .material = 1}};
    if (s) {
        step(team, s, 1);
        team_expect(team, scree_add(s, two, 2, &error), "%s", error.text);
        scree_delete(s, (int64_t[]){4, 9, 123456}, 3);
        step(team, s, 1);
        look(team, s, true, &state);
        team_expect(team, scree_particles(s) == GRAINS, "%d", (int)scree_particles(s));
        team_expect(team, state.x[4][2] == 0 && state.x[9][2] == 0 && state.x[5][2] != 0, "not deleted");
        team_expect(team, state.x[GRAINS + 1][0] == 7 && state.v[GRAINS + 1][0] == 2, "at %g",
                    state.x[GRAINS + 1][0]);
        two[0].position[2] = 9;
        team_expect(team, !scree_add(s, two, 1, &error) && strstr(error.text, "outside"), "%s", error.text);
        struct scree_field x, id;
        scree_field(s, "position", &x);
        scree_field(s, "id", &id);
        for (size_t k = 0; k < x.count; k++) /* to just above the other new one, faster than any skin */
            if (((int64_t *)id.data)[k] == GRAINS + 1)
                memcpy((char *)x.data + k * x.stride, (double[3]){1, 1, 7.75}, 3 * sizeof(double));
        scree_changed(s);
        step(team, s, 1);
        look(team, s, true, &state);
        step(team, s, 1);
        double before = state.v[GRAINS + 1][2];
        look(team, s, true, &state);
        team_expect(team, state.v[GRAINS + 1][2] > before, "the moved particle meets nobody: %g %g", before,
                    state.v[GRAINS + 1][2]);
    }
    scree_destroy(&s);
    team_finish(team);
}

static void keep_line(void *context, const char *line) {
    snprintf(context, 256, "%s", line);
}

static void mistakes_and_guards_are_told(void **test) {
    struct team *team = *test;
    char said[256] = "";
    const char *set[] = {"step.dt=1e-30", "guards.overlap=warn", "guards.overlap_bound=1e-9",
                         "guards.speed=off"};
    struct scree_options options = {
        .communicator = &team->comm.handle, .set = set, .sets = 1, .log = keep_line, .log_context = said};
    struct scree_error error;
    struct scree_simulation *s = scree_create("my.yaml", "box: {lower: [0, 0]}\nmist: 1\n", NULL, &error);
    team_expect(
        team, s == NULL && error.status == SCREE_USER && strstr(error.text, "my.yaml:2: unknown key 'mist'"),
        "%s", error.text);
    set[0] = "walls[0].colour=red";
    s = scree_create("scene", scene, &options, &error);
    team_expect(team, s == NULL && error.status == SCREE_USER, "%s", error.text);
    options.set = set;
    set[0] = "guards.step=off";
    options.sets = 4;
    s = scree_create("scene", scene, &options, &error);
    if (team_expect(team, s != NULL, "%s", error.text)) {
        int64_t told = 0;
        for (int k = 0; k < 100; k += 20)
            step(team, s, 20);
        told = strstr(said, "warning: guards.overlap") != NULL;
        comm_max_int(&team->comm, &told, 1);
        team_expect(team, told, "nothing told, or another line: %s", said);
    }
    scree_destroy(&s);
    options.sets = 3;
    set[1] = "guards.overlap=stop";
    s = scree_create("scene", scene, &options, &error);
    if (s) {
        team_expect(team, !scree_step(s, 100, &error) && error.status == SCREE_PHYSICS, "%s", error.text);
        uint64_t stopped = scree_step_number(s);
        team_expect(team, !scree_step(s, 1, &error) && scree_step_number(s) == stopped, "it went on");
    }
    scree_destroy(&s);
    team_finish(team);
}

/* The particle that the force of the caller adds in the last step of a stage joins the next stage. */
static void add_late(void *context, struct scree_simulation *s) {
    const struct scree_particle grain = {.position = {0, 5, 7.5}, .radius = 0.1};
    if (++*(int *)context == 12) /* one call for the first forces, one for each step */
        scree_add(s, &grain, 1, NULL);
}

static void stages_follow_each_other_on_all_ranks_alike(void **test) {
    struct team *team = *test;
    static struct state together, alone;
    int calls[2] = {0, 0};
    const char *set[] = {
        "step.count=~", "step.force=true",
        ("stages=[{name: fall, every: 10, until: [{name: particles, at_least: 3}]}, {name: rise, duration: "
         "0.02, set: {gravity: [0, 0, 1]}}, {name: rest, duration: 0.01, set: {\"walls[floor]\": ~}}]")};
    struct scree_options both = {.communicator = &team->comm.handle,
                                 .set = set,
                                 .sets = 3,
                                 .force = add_late,
                                 .force_context = &calls[0]},
                         one = both;
    one.communicator = NULL;
    one.force_context = &calls[1];
    struct scree_simulation *s = create(team, &both), *single = create(team, &one);
    if (s && single) {
        team_expect(team, strcmp(scree_stage(s), "fall") == 0 && scree_steps_left(s) > 1000, "%s",
                    scree_stage(s));
        step(team, s, 10);
        team_expect(team, scree_steps_left(s) == 1, "the conditions hold, but not at the next step");
        step(team, s, 1);
        team_expect(team, strcmp(scree_stage(s), "rise") == 0 && scree_steps_left(s) == 20, "%s",
                    scree_stage(s));
        step(team, s, 100);
        team_expect(team, scree_step_number(s) == 41 && scree_steps_left(s) == 0 && scree_stage(s)[0] == '\0',
                    "step %d of 41", (int)scree_step_number(s));
        team_expect(team, scree_particles(s) == GRAINS + 1, "%d grains", (int)scree_particles(s));
        step(team, single, 41);
        look(team, s, true, &together);
        look(team, single, false, &alone);
        team_expect(team, together.rows == 3 && memcmp(&together, &alone, sizeof alone) == 0,
                    "the ranks differ from one rank");
    }
    scree_destroy(&s);
    scree_destroy(&single);
    team_finish(team);
}

/* A force of 5 down on each grain. */
static void press(void *context, struct scree_simulation *s) {
    struct scree_field f;
    (void)context;
    for (size_t k = 0; scree_field(s, "force", &f) && k < f.count; k++)
        ((double *)((char *)f.data + k * f.stride))[2] -= 5.0;
}

static void hard_contacts_feel_the_force_of_the_caller(void **test) {
    struct team *team = *test;
    const char *set[] = {"reproducible=false",
                         "contact={law: rigid, solver: {}}",
                         "materials=[{name: a, density: 1}]",
                         "gravity=[0, 0, 0]",
                         "particles={from: single, position: [0, 5, 0.4], radius: 0.4}",
                         "observables={every: 20, list: [{name: wall_force}]}"};
    struct scree_options options = {
        .communicator = &team->comm.handle, .set = set, .sets = 6, .force = press};
    struct scree_simulation *s = create(team, &options);
    if (s) {
        step(team, s, 60);
        const double *row = scree_row(s, scree_rows(s) - 1);
        team_expect(team, scree_columns(s) == 3 && fabs(row[3] + 5.0) < 1e-6, "the floor feels %g", row[3]);
    }
    scree_destroy(&s);
    team_finish(team);
}

/* Adds a grain, or deletes the first one: the fluid that has the grains refuses both on all ranks. */
static void a_fluid_keeps_its_grains(void **test) {
    static const char water[] = "units: none\nthreads: 1\nbox: {lower: [0, 0, 0], upper: [16, 12, 0], "
                                "dimension: 2, periodic: true}\nstep: {dt: 0.25, count: 5, force: true}\n"
                                "contact: {law: hooke}\nmaterials: [{name: a, density: 1}]\n"
                                "material_pairs: [{k_n: 1, restitution: 1}]\n"
                                "particles: {from: single, position: [8, 6, 0], radius: 3}\n"
                                "fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: free}\n";
    struct team *team = *test;
    const struct scree_particle grain = {.position = {2, 2, 0}, .radius = 1};
    struct scree_options options = {.communicator = &team->comm.handle};
    struct scree_error error;
    struct scree_simulation *s = scree_create("scene", water, &options, &error);
    if (s) {
        step(team, s, 1);
        team_expect(team, !scree_add(s, &grain, 1, &error) && strstr(error.text, "inserted into a fluid"),
                    "added: %s", error.text);
        step(team, s, 1);
        scree_delete(s, (int64_t[]){1}, 1);
        team_expect(team, !scree_step(s, 1, &error) && strstr(error.text, "grains out of the fluid"),
                    "deleted: %s", error.text);
    } else {
        team_expect(team, strstr(error.text, "built without PETSc") != NULL, "%s", error.text);
    }
    scree_destroy(&s);
    team_finish(team);
}

/* Rocks that the program adds, by name and orientation: the same bits on all ranks; and one that no entry names. */
static void rocks_come_by_their_shapes_on_all_ranks_alike(void **test) {
    static const char *const numbers[] = {"position", "velocity"};
    struct team *team = *test;
    const char *set[] = {"particles.sources[0].count=60",
                         "bodies={shapes: [{name: cube, material: a, radius_above: 9, vertices: [0,0,0, "
                         "1,0,0, 0,1,0, 1,1,0, 0,0,1, "
                         "1,0,1, 0,1,1, 1,1,1], rounding: 0.05}, {name: wedge, material: a, radius_above: 9, "
                         "vertices: [0,0,0, 1,0,0, "
                         "0,1,0, 1,1,0, 0,0,1, 1,0,1], rounding: 0.05}]}",
                         "observables.list=[{name: bodies}, {name: momentum}]"};
    struct scree_options both = {.communicator = &team->comm.handle, .set = set, .sets = 3}, one = both;
    struct scree_particle rock[] = {
        {.position = {0.1, 5, 7},
         .radius = 0.7,
         .velocity = {0, 0, -5},
         .shape = "cube",
         .orientation = {1, 2, 3, 4}},
        {.position = {-5.9, 5, 7}, .radius = 0.6, .velocity = {0, 0, -5}, .shape = "wedge"},
        {.position = {3, 5, 7.3}, .radius = 0.3, .shape = "", .angular_velocity = {1, 0, 0}}};
    struct scree_error error;
    one.communicator = NULL;
    struct scree_simulation *s = create(team, &both), *single = create(team, &one);
    for (int k = 0; s && single && k < 2; k++) {
        struct scree_simulation *of = k ? single : s;
        team_expect(team, scree_add(of, rock, 3, &error), "%s", error.text);
        step(team, of, 90);
        team_expect(team, scree_row(of, scree_rows(of) - 1)[1] == 2, "%g bodies",
                    scree_row(of, scree_rows(of) - 1)[1]);
    }
    for (int f = 0; s && single && f < 2; f++) {
        static double together[GRAINS + 3][3], alone[GRAINS + 3][3];
        gather(team, s, numbers[f], together, true);
        gather(team, single, numbers[f], alone, false);
        team_expect(team, memcmp(together, alone, sizeof alone) == 0, "%s: the ranks differ from one",
                    numbers[f]);
    }
    rock[0].shape = "brick";
    if (s)
        team_expect(
            team,
            !scree_add(s, rock, 1, &error) &&
                strstr(
                    error.text,
                    "new particle 0: shape: no entry of bodies has the name 'brick'; allowed: cube, wedge"),
            "%s", error.text);
    scree_destroy(&s);
    scree_destroy(&single);
    team_finish(team);
}

TEAM_MAIN(library, team_case(ranks_together_get_what_one_gets_alone), team_case(a_report_tells_of_the_steps),
          team_case(a_checkpoint_goes_on_to_the_bit), team_case(particles_come_go_and_are_moved),
          team_case(stages_follow_each_other_on_all_ranks_alike), team_case(mistakes_and_guards_are_told),
          team_case(hard_contacts_feel_the_force_of_the_caller), team_case(a_fluid_keeps_its_grains),
          team_case(rocks_come_by_their_shapes_on_all_ranks_alike))
