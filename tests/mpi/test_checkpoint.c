/* SPDX-License-Identifier: BSD-3-Clause */
/* Checkpoints: the same state back on the same layout, bit for bit, and on any other; old checkpoints deleted.
 * Ranks: 1 2 3 4 */
#include "tests/test.h"

#include "state.h"
#include "tests/own_law.h"

#include <unistd.h>

static void comes_back_on_the_same_layout(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, WITH_ALL | WITH_OTHERS);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    team_expect(team, folder_count(&f.folder) == 1, "%d files", folder_count(&f.folder));
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &team->comm, WITH_ALL);
    fixture_free(&f);
    team_finish(team);
}

static void comes_back_on_other_layouts(void **state) {
    struct team *team = *state;
    struct comm self = folder_self();
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    /* all write, each reads the whole by itself */
    fixture_make(&f, team, &team->comm, WITH_ALL | WITH_OTHERS);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &self, WITH_ALL);
    fixture_free(&f);
    /* all but the last write (or the only one), all read */
    struct comm some = folder_first(&team->comm, team->comm.size > 1 ? team->comm.size - 1 : 1);
    bool writes = team->comm.rank < some.size;
    fixture_make(&f, team, writes ? &some : &self, WITH_ALL);
    f.comm.size = some.size;
    if (writes)
        team_expect(team, checkpoint_write(&some, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                    error.text);
    team_finish(team);
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &team->comm, WITH_ALL);
    fixture_free(&f);
    folder_first_free(&some);
    team_finish(team);
}

/* Writes a checkpoint of particles with the features `written` and reads it for a scene that keeps `kept`.
 * With groups every seventh particle is held. */
static struct particles *read_otherwise(struct fixture *f, struct team *team, unsigned written,
                                        unsigned kept) {
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(f, team, &team->comm, written);
    for (size_t i = 0; i < f->particles->owned; i++) {
        bool held = groups_of(f->particles) && f->particles->id[i] % 7 == 0;
        f->particles->state[i].inverse_mass = held ? 0 : 1.0 / (double)f->particles->id[i];
    }
    team_expect(team, checkpoint_write(&f->comm, f->folder.path, "", &f->checkpoint, 2, &error), "%s",
                error.text);
    struct particles *p = particles_with(kept, 0);
    path_of(f, "checkpoint-1200.h5", path);
    if (team_expect(team, checkpoint_read(&f->comm, path, p, &l, &error), "%s", error.text))
        checkpoint_loaded_free(&l);
    int64_t total = (int64_t)p->owned;
    comm_sum_int(&f->comm, &total, 1);
    team_expect(team, total == PARTICLES, "%d particles", (int)total);
    return p;
}

static void features_may_change(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct particles *p = read_otherwise(&f, team, WITH_ALL, 0);
    int64_t held = 0;
    for (size_t i = 0; i < p->owned; i++) {
        /* particles that were held move freely now, with the mass of their density */
        int64_t id = p->id[i];
        double density = cloud_value(id, cloud_code("density"), 0, STAMP);
        double expected = 1 / (id % 7 == 0 ? particles_sphere_mass(p->state[i].radius, density) : (double)id);
        held += id % 7 == 0;
        team_expect(team, p->state[i].inverse_mass == expected, "mass of %d", (int)id);
    }
    comm_sum_int(&f.comm, &held, 1);
    team_expect(team, held == PARTICLES / 7, "%d were held", (int)held);
    particles_destroy(&p);
    fixture_free(&f);
    team_finish(team);
}

/* Without groups no particle was held: densities follow from masses, and all particles are in the first
 * group. */
static void groups_may_come(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct particles *p = read_otherwise(&f, team, WITH_ALL & ~WITH_GROUP, WITH_ALL | WITH_OTHERS);
    for (size_t i = 0; i < p->owned; i++) {
        int64_t id = p->id[i];
        double mass = particles_sphere_mass(p->state[i].radius, groups_densities(p)[i]) / (double)id;
        team_expect(team, p->state[i].inverse_mass == 1.0 / (double)id, "mass of %d", (int)id);
        team_expect(team, mass > 1 - 1e-12 && mass < 1 + 1e-12, "density of %d", (int)id);
        team_expect(team, groups_of(p)[i] == 0, "group of %d", (int)id);
        team_expect(team, ((int64_t *)fields_values(p, &field_visits))[i] == -3, "fill of %d", (int)id);
        team_expect(team, ((double(*)[3])fields_values(p, &field_flux))[i][2] == 0.5, "fill of %d", (int)id);
    }
    particles_destroy(&p);
    fixture_free(&f);
    team_finish(team);
}

static void no_particles_at_all(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, WITH_SPIN);
    f.particles->owned = 0;
    f.history.count = f.wall_history.count = 0;
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    struct particles *p = particles_with(WITH_SPIN, 0);
    path_of(&f, "checkpoint-1200.h5", path);
    team_expect(team, checkpoint_read(&f.comm, path, p, &l, &error), "%s", error.text);
    team_expect(team, p->owned == 0 && l.total == 0 && l.numbers.next_id == 777, "%d particles",
                (int)l.total);
    checkpoint_loaded_free(&l);
    particles_destroy(&p);
    fixture_free(&f);
    team_finish(team);
}

/* Two planes that have moved: each comes back by its name. */
static void wall_poses_come_back(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    OWN_LAW law = {0};
    struct law_options options = law_options_default();
    static const struct law_material material = {
        .name = "glass", .density = 2500, .young = 1e7, .poisson = 0.2};
    static struct law_pair pair[2][2];
    pair[0][0] = (struct law_pair){.restitution = 0.5, .friction = 0.3};
    team_expect(team, law_prepare(&law, &options, 1, &material, pair[0], &error), "%s", error.text);
    struct wall_motion drift = {.kind = WALL_TRANSLATE, .stop = 10, .velocity = {1, 0, 0.25}};
    struct wall_motion turn = {
        .kind = WALL_ROTATE, .stop = 10, .direction = {0, 0, 1}, .point = {0, 105, 6}, .rate = 0.5};
    struct wall_options planes[2] = {{.name = "floor",
                                      .shape = WALL_PLANE,
                                      .point = {0, 105, 1},
                                      .normal = {0, 0, 1},
                                      .motions = 1,
                                      .motion = {drift}},
                                     {.name = "side",
                                      .shape = WALL_PLANE,
                                      .point = {-4, 105, 6},
                                      .normal = {1, 0, 0},
                                      .motions = 1,
                                      .motion = {turn}}};
    fixture_make(&f, team, &team->comm, WITH_SPIN);
    struct walls *walls = NULL;
    if (team_expect(team, walls_create(&walls, planes, 2, &law, &f.cloud.box, 1, &error, NULL), "%s",
                    error.text)) {
        for (int step = 0; step < 8; step++)
            walls_advance(walls, 0.125 * step, 0.125, NULL);
        f.checkpoint.walls = walls;
        struct checkpoint_loaded l;
        char path[FOLDER_MAX + 64];
        team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                    error.text);
        path_of(&f, "checkpoint-1200.h5", path);
        if (team_expect(team, checkpoint_read_head(&f.comm, path, &l, &error), "%s", error.text)) {
            team_expect(team, l.walls == 2, "%d walls", l.walls);
            for (int w = 0; w < l.walls; w++) {
                struct wall_pose now;
                walls_pose(walls, w, &now);
                team_expect(team, strcmp(l.wall[w].name, planes[w].name) == 0, "wall %d is %s", w,
                            l.wall[w].name);
                team_expect(team, memcmp(&l.wall[w].pose, &now, sizeof now) == 0, "pose of wall %d", w);
            }
            team_expect(team, l.walls < 1 || l.wall[0].pose.translation[2] == 0.25,
                        "the floor has not moved");
            checkpoint_loaded_free(&l);
        }
        walls_destroy(&walls);
    }
    fixture_free(&f);
    team_finish(team);
}

static void head_is_read_alone(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, WITH_SPIN);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    path_of(&f, "checkpoint-1200.h5", path);
    if (team_expect(team, checkpoint_read_head(&f.comm, path, &l, &error), "%s", error.text)) {
        expect_numbers(&f, &l, &f.comm);
        checkpoint_loaded_free(&l);
    }
    fixture_free(&f);
    team_finish(team);
}

static void old_ones_are_deleted(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[FILE_PATH_MAX], expected[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, 0);
    team_expect(team, !checkpoint_find(f.folder.path, 0, path), "there is one");
    static const uint64_t steps[] = {100, 90, 1000, 1100};
    for (int k = 0; k < 4; k++) {
        f.checkpoint.numbers.step = steps[k];
        team_expect(
            team,
            checkpoint_write(&f.comm, f.folder.path, k == 2 ? "-stopped" : "", &f.checkpoint, 2, &error),
            "%s", error.text);
    }
    f.checkpoint.numbers.step = 1200;
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    if (team->comm.rank == 0) {
        static const char *const names[] = {"checkpoint-90.h5", "checkpoint-100.h5",
                                            "checkpoint-1000-stopped.h5", "checkpoint-1100.h5",
                                            "checkpoint-1200.h5"};
        for (int k = 0; k < 5; k++)
            team_expect(team, (access(path_of(&f, names[k], expected), F_OK) == 0) == (k >= 2), "%s",
                        names[k]);
        team_expect(team, checkpoint_find(f.folder.path, 0, path), "none is found");
        team_expect(team, strcmp(path, expected) == 0, "the newest is %s", path);
        team_expect(team,
                    checkpoint_find(f.folder.path, 1, path) &&
                        strcmp(path, path_of(&f, "checkpoint-1100.h5", expected)) == 0,
                    "the one before is %s", path);
        team_expect(team, !checkpoint_find(f.folder.path, 2, path), "there is a third");
    }
    fixture_free(&f);
    team_finish(team);
}

/* An equal number of ranks gets the tree back, another number gets no tree; bricks give no tree either. */
static void cuts_of_a_bisection_come_back(void **state) {
    struct team *team = *state;
    struct comm self = folder_self();
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, 0);
    struct domain_tree *tree = domain_tree_halve(team->comm.size, &f.cloud.box);
    size_t bytes = ((size_t)team->comm.size - 1) * sizeof *tree->cut;
    for (int k = 0; k < team->comm.size - 1; k++)
        tree->cut[k].at *= 1 + 0x1p-50;
    for (int divided = 0; divided < 2; divided++) {
        f.checkpoint.tree = divided ? tree : NULL;
        team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                    error.text);
        team_expect(team, checkpoint_read_head(&f.comm, path_of(&f, "checkpoint-1200.h5", path), &l, &error),
                    "%s", error.text);
        bool expected = divided && team->comm.size > 1;
        team_expect(team, (l.tree != NULL) == expected, "divided %d", divided);
        if (l.tree && expected)
            team_expect(team, memcmp(l.tree->cut, tree->cut, bytes) == 0, "cuts");
        checkpoint_loaded_free(&l);
        team_expect(team, checkpoint_read_head(&self, path, &l, &error), "%s", error.text);
        team_expect(team, l.tree == NULL, "a tree of other ranks");
        checkpoint_loaded_free(&l);
        team_finish(team);
    }
    domain_tree_destroy(&tree);
    fixture_free(&f);
    team_finish(team);
}

TEAM_MAIN(checkpoint, team_case(comes_back_on_the_same_layout), team_case(comes_back_on_other_layouts),
          team_case(features_may_change), team_case(groups_may_come), team_case(no_particles_at_all),
          team_case(wall_poses_come_back), team_case(head_is_read_alone), team_case(old_ones_are_deleted),
          team_case(cuts_of_a_bisection_come_back))
