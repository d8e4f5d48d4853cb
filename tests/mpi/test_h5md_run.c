/* SPDX-License-Identifier: BSD-3-Clause */
/* Trajectories over a run: numbers of particles that change, continuation after a resume, contact lists,
 * observables, the XDMF file. Ranks: 1 2 4 */
#include "tests/test.h"

#include "base/file.h"
#include "trajectory.h"

#include <sys/resource.h>

/* New particles, dealt out among the ranks. */
static void append_particles(struct fixture *f, int64_t first, int64_t last) {
    for (int64_t id = first; id <= last; id++)
        if (id % f->team->comm.size == f->team->comm.rank) {
            size_t i = particles_append(f->particles);
            f->particles->id[i] = id;
            f->particles->state[i].radius = 1;
            f->particles->state[i].inverse_mass = 1;
        }
}

/* A trajectory for a number of particles that varies, with its first frame. */
static struct h5md *varying_begin(struct fixture *f, struct team *team) {
    struct error error = {0};
    struct h5md *h5md = NULL;
    fixture_make(f, team, &box_3d, 0);
    struct h5md_head head = head_of(f, true);
    team_expect(team, h5md_open(&h5md, &team->comm, f->path, &head, -1, &error), "%s", error.text);
    write_frames(f, h5md, 0, 1);
    return h5md;
}

/* Frames of a run in which every third particle goes, then new ones come. */
static void number_may_change(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct h5md *h5md = varying_begin(&f, team);
    uint8_t *remove = memory_allocate_zero(f.particles->owned, 1, "test");
    for (size_t i = 0; i < f.particles->owned; i++)
        remove[i] = f.particles->id[i] % 3 == 0;
    particles_remove(f.particles, remove);
    memory_free(remove);
    write_frames(&f, h5md, 10, 11);
    append_particles(&f, PARTICLES + 1, 2 * PARTICLES);
    write_frames(&f, h5md, 20, 21);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    static const int counts[] = {PARTICLES, PARTICLES - PARTICLES / 3, 2 * PARTICLES - PARTICLES / 3};
    for (int frame = 0; frame < 3; frame++) {
        struct h5md_read_options options = {.frame = frame};
        struct rows rows;
        if (!team_expect(team, h5md_read(f.path, &options, &team->comm, &rows, &error), "%s", error.text))
            continue;
        team_expect(team, rows.total == (uint64_t)counts[frame], "frame %d has %d rows", frame,
                    (int)rows.total);
        for (size_t k = 0; k < rows.count; k++) {
            int64_t id = rows.id[k];
            team_expect(team, id > 0 && (frame == 0 || id > PARTICLES || id % 3 != 0), "id %d", (int)id);
            double radius = id > PARTICLES ? 1 : f.cloud.radius[id - 1];
            team_expect(team, rows.radius[k] == radius, "radius of %d", (int)id);
        }
        rows_free(&rows);
    }
    fixture_free(&f);
    team_finish(team);
}

/* A fixed number of particles that changes nevertheless is refused. */
static void fixed_number_is_kept(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    struct h5md_head head = head_of(&f, false);
    struct h5md *h5md = NULL;
    h5md_open(&h5md, &team->comm, f.path, &head, -1, &error);
    write_frames(&f, h5md, 0, 1);
    f.particles->owned -= team->comm.rank == 0;
    static const struct output_fields all = {0};
    struct frame frame;
    f.view.step = 10;
    frame_create(&frame, &f.view, &all);
    team_expect(team, !h5md_write_frame(h5md, &frame, &error), "the frame is accepted");
    team_expect(team, strstr(error.text, "trajectory.h5") && strstr(error.text, "137"), "%s", error.text);
    frame_free(&frame);
    struct error none = {0};
    h5md_close(&h5md, &none);
    fixture_free(&f);
    team_finish(team);
}

/* A string of the file is this text. */
static void expect_scene(struct team *team, hid_t file, const char *name, const char *text) {
    char found[64] = "";
    hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    if (!team_expect(team, dataset >= 0, "no %s", name))
        return;
    hid_t type = H5Dget_type(dataset);
    if (team_expect(team, H5Tget_size(type) < sizeof found, "length of %s", name))
        H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, found);
    team_expect(team, strcmp(found, text) == 0, "%s is '%s'", name, found);
    H5Tclose(type);
    H5Dclose(dataset);
}

/* The file names the scene of each run with the step from which it holds; the run of step 10 was given up. */
static void runs_are_named(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    write_file(&f, false, -1, 0, 50);
    lineage_add(&f.lineage, 10, "0.2", "def", "scene: given up\n");
    write_file(&f, false, 10, 10, 50);
    lineage_free(&f.lineage);
    lineage_add(&f.lineage, 0, "0.1", "abc", "scene: test\n");
    lineage_add(&f.lineage, 25, "0.2", "def", "scene: other\n");
    write_file(&f, false, 25, 20, 70);
    if (team->comm.rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        expect_scene(team, file, "/parameters/runs/0/scene", "scene: test\n");
        expect_scene(team, file, "/parameters/runs/25/scene", "scene: other\n");
        expect_scene(team, file, "/parameters/scene", "scene: other\n");
        team_expect(team, H5Lexists(file, "/parameters/runs/10", H5P_DEFAULT) == 0,
                    "a run that was given up");
        team_expect(team,
                    H5Aexists_by_name(file, "/parameters/runs/25", "version", H5P_DEFAULT) > 0 &&
                        H5Aexists_by_name(file, "/parameters/runs/25", "revision", H5P_DEFAULT) > 0,
                    "no version");
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

/* Stop at 50, resume from 25: frames 30 and 40 are written a second time. */
static void resume_goes_on(void **state) {
    struct team *team = *state;
    for (int varying = 0; varying < 2; varying++) {
        struct fixture f;
        fixture_make(&f, team, &box_3d, WITH_SPIN);
        write_file(&f, varying, -1, 0, 50);
        write_file(&f, varying, 25, 20, 70);
        uint64_t frames = 0;
        struct error error = {0};
        if (team->comm.rank == 0) {
            team_expect(team, h5md_read_frames(f.path, NULL, &frames, &error), "%s", error.text);
            team_expect(team, frames == 7, "%d frames", (int)frames);
            hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
            double *step = read_all(file, "/particles/all/velocity/step");
            for (uint64_t k = 0; k < frames; k++)
                team_expect(team, step[k] == 10.0 * (double)k, "frame %d is step %g", (int)k, step[k]);
            memory_free(step);
            if (!varying)
                expect_values(&f, file, 6, 3);
            H5Fclose(file);
        }
        fixture_free(&f);
        team_finish(team);
    }
}

/* If particles come and go, a file made for a constant number is refused, and nothing is cut. */
static void fixed_file_is_kept(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    write_file(&f, false, -1, 0, 50);
    struct h5md_head head = head_of(&f, true);
    struct h5md *h5md = NULL;
    team_expect(team, !h5md_open(&h5md, &team->comm, f.path, &head, 25, &error), "the file is taken");
    team_expect(team, error.kind == ERROR_USER && strstr(error.text, "trajectory.h5"), "%s", error.text);
    team_expect(team, strstr(error.text, "another output directory") != NULL, "%s", error.text);
    h5md_close(&h5md, &error);
    uint64_t frames = 0;
    struct error none = {0};
    if (team->comm.rank == 0)
        team_expect(team, h5md_read_frames(f.path, NULL, &frames, &none) && frames == 5, "%d frames",
                    (int)frames);
    fixture_free(&f);
    team_finish(team);
}

/* Two frames of contacts: three a rank in the first, two in the second, and one with a wall. */
static void write_contacts(struct fixture *f) {
    struct team *team = f->team;
    struct error error = {0};
    struct h5md_head head = head_of(f, false);
    struct h5md *h5md = NULL;
    h5md_open(&h5md, &team->comm, f->path, &head, -1, &error);
    int rank = team->comm.rank;
    for (int frame = 0; frame < 2; frame++) {
        struct force_contact contact[3], wall = {.id_i = rank + 1, .id_j = -4, .force = {0, 0, rank}};
        for (int k = 0; k < 3; k++)
            contact[k] = (struct force_contact){
                .id_i = 10 * rank + k, .id_j = 1000, .overlap = k, .force = {rank, frame, k}};
        struct contact_list list = {.step = (uint64_t)frame * 10,
                                    .time = frame,
                                    .particle_count = (size_t)(3 - frame),
                                    .wall_count = 1,
                                    .particle = contact,
                                    .wall = &wall};
        team_expect(team, h5md_write_contacts(h5md, &list, &f->cloud.box, &error), "%s", error.text);
    }
    write_frames(f, h5md, 0, 1);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
}

/* Rows in the order of ranks; rows that are missing in the second frame have the ids -1. */
static void expect_contacts(struct team *team, hid_t file) {
    int size = team->comm.size;
    double *ids = read_all(file, "/connectivity/contacts/value");
    double *force = read_all(file, "/observables/contact_list/force/value");
    double *wall = read_all(file, "/observables/wall_contact_list/wall/value");
    double *count = read_all(file, "/observables/contact_list/count/value");
    team_expect(team, count[0] == 3 * size && count[1] == 2 * size, "counts %g %g", count[0], count[1]);
    for (int frame = 0; frame < 2; frame++)
        for (int row = 0; row < 3 * size; row++) {
            int each = 3 - frame, owner = row / each, k = row % each, place = frame * 3 * size + row;
            bool there = row < each * size;
            team_expect(team, ids[2 * place] == (there ? 10 * owner + k : -1), "id in row %d", row);
            if (there)
                team_expect(team, force[3 * place] == owner && force[3 * place + 1] == frame,
                            "force in row %d", row);
        }
    team_expect(team, wall[0] == 3, "wall %g", wall[0]);
    memory_free(ids);
    memory_free(force);
    memory_free(wall);
    memory_free(count);
}

static void contacts_are_listed(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    write_contacts(&f);
    if (team->comm.rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        hsize_t pairs[3] = {2, (hsize_t)(3 * team->comm.size), 2};
        expect_size(team, file, "/connectivity/contacts/value", 3, pairs);
        expect_same_object(team, file, "/connectivity/contacts/step", "/observables/contact_list/force/step");
        expect_same_object(team, file, "/connectivity/contacts/time", "/connectivity/wall_contacts/time");
        expect_contacts(team, file);
        hid_t id =
            H5Aopen_by_name(file, "/connectivity/contacts", "particles_group", H5P_DEFAULT, H5P_DEFAULT);
        hobj_ref_t reference;
        char name[64] = "";
        team_expect(team, id >= 0 && H5Aread(id, H5T_STD_REF_OBJ, &reference) >= 0, "particles_group");
        H5Rget_name(file, H5R_OBJECT, &reference, name, sizeof name);
        team_expect(team, strcmp(name, "/particles/all") == 0, "refers to %s", name);
        H5Aclose(id);
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void observables_come_along(void **state) {
    static const char *const names[] = {"energy_kinetic", "ball_vz"}, *const units[] = {"J", "m/s"};
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &box_3d, 0);
    for (int part = 0; part < 2; part++) {
        struct h5md_head head = head_of(&f, false);
        struct h5md *h5md = NULL;
        h5md_open(&h5md, &team->comm, f.path, &head, part ? 20 : -1, &error);
        write_frames(&f, h5md, 0, 1);
        /* after the resume from step 20 the row of step 20 comes a second time */
        for (int step = part ? 20 : 0; step < 31 + 10 * part; step += 5) {
            double value[2] = {step, -step};
            struct h5md_observables row = {2, names, units, value, (uint64_t)step, 0.5 * step};
            h5md_add_observables(h5md, &row);
        }
        team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    }
    if (team->comm.rank == 0) {
        hid_t file = H5Fopen(f.path, H5F_ACC_RDONLY, H5P_DEFAULT);
        hsize_t rows = 9;
        expect_size(team, file, "/observables/ball_vz/value", 1, &rows);
        expect_text(team, file, "/observables/ball_vz/value", "unit", "m s-1");
        expect_same_object(team, file, "/observables/ball_vz/step", "/observables/energy_kinetic/step");
        double *value = read_all(file, "/observables/ball_vz/value");
        for (int k = 0; k < 9; k++)
            team_expect(team, value[k] == -5 * k, "row %d is %g", k, value[k]);
        memory_free(value);
        H5Fclose(file);
    }
    fixture_free(&f);
    team_finish(team);
}

static void xdmf_names_what_is_there(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team, &box_3d, 0);
    write_file(&f, false, -1, 0, 30);
    if (team->comm.rank == 0) {
        char path[FOLDER_MAX + 64], text[16384] = "";
        FILE *file = fopen(folder_file(&f.folder, "trajectory.xdmf", path), "r");
        team_expect(team, file != NULL, "%s is missing", path);
        size_t length = file ? fread(text, 1, sizeof text - 1, file) : 0;
        team_expect(team, length > 0 && length < sizeof text - 1, "%zu bytes", length);
        if (file)
            fclose(file);
        team_expect(team, strstr(text, "trajectory.h5:/particles/all/position/value") != NULL, "no position");
        team_expect(team, strstr(text, "trajectory.h5:/particles/all/radius<") != NULL, "no radius");
        team_expect(team, strstr(text, "<Time Value=\"10\"/>") != NULL, "no time of frame 2");
        team_expect(team, strstr(text, ">2 0 0 1 1 1 1 137 3<") != NULL, "no slab of frame 2");
        team_expect(team, strcmp(text + length - 8, "</Xdmf>\n") == 0, "the end is missing");
    }
    fixture_free(&f);
    team_finish(team);
}

/* Limits the growth of the trajectory to `more` bytes on rank 0, which reserves the room; < 0: no limit. */
static void limit_growth(const struct fixture *f, int64_t more) {
    struct rlimit limit;
    if (f->team->comm.rank != 0)
        return;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = more < 0 ? limit.rlim_max : (rlim_t)(file_size(f->path) + more);
    setrlimit(RLIMIT_FSIZE, &limit);
}

/* A frame without room on the disk is refused before the first write. */
static void expect_no_room(struct fixture *f, struct h5md *h5md, int step, int64_t more) {
    static const struct output_fields all = {0};
    struct error error = {0};
    struct frame frame;
    f->view.step = (uint64_t)step;
    frame_create(&frame, &f->view, &all);
    limit_growth(f, more);
    bool written = h5md_write_frame(h5md, &frame, &error);
    limit_growth(f, -1);
    frame_free(&frame);
    team_expect(f->team, !written && error.kind == ERROR_SYSTEM && strstr(error.text, "needs"), "step %d: %s",
                step, error.text);
}

/* The disk must have room for whole chunks, 96 bytes of 4096 rows; and if a frame is wider than the earlier
 * frames, for chunks of the earlier frames, here seven. */
static void frames_have_room(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct h5md *h5md = varying_begin(&f, team);
    struct h5md_head head = head_of(&f, true);
    expect_no_room(&f, h5md, 10, 300000);
    write_frames(&f, h5md, 10, 50);
    append_particles(&f, PARTICLES + 1, PARTICLES + 4000);
    expect_no_room(&f, h5md, 50, 2000000);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    team_expect(team, h5md_open(&h5md, &team->comm, f.path, &head, 40, &error), "%s", error.text);
    expect_no_room(&f, h5md, 50, 2000000);
    write_frames(&f, h5md, 50, 51);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    uint64_t frames = 0;
    if (team->comm.rank == 0)
        team_expect(team, h5md_read_frames(f.path, NULL, &frames, &error) && frames == 6, "%d frames",
                    (int)frames);
    fixture_free(&f);
    team_finish(team);
}

/* A list of so many contacts, all of them of rank 0. */
static bool write_list(struct fixture *f, struct h5md *h5md, int step, size_t count, struct error *error) {
    bool mine = f->team->comm.rank == 0;
    struct force_contact *contact = memory_allocate_zero(count, sizeof *contact, "test");
    struct contact_list list = {
        .step = (uint64_t)step, .particle_count = mine ? count : 0, .particle = contact};
    bool good = h5md_write_contacts(h5md, &list, &f->cloud.box, error);
    memory_free(contact);
    return good;
}

/* As for frames: 72 bytes of 8192 contacts, and eight chunks for the first list that takes two. */
static void contacts_have_room(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0}, why = {0};
    fixture_make(&f, team, &box_3d, 0);
    struct h5md_head head = head_of(&f, false);
    struct h5md *h5md = NULL;
    h5md_open(&h5md, &team->comm, f.path, &head, -1, &error);
    for (int step = 0; step < 6; step++)
        team_expect(team, write_list(&f, h5md, step, 1, &error), "%s", error.text);
    for (int part = 0; part < 2; part++) { /* the second time after a resume */
        limit_growth(&f, 3000000);
        bool written = write_list(&f, h5md, 6, 9000, &why);
        limit_growth(&f, -1);
        team_expect(team, !written && why.kind == ERROR_SYSTEM && strstr(why.text, "needs"), "%s", why.text);
        why = (struct error){0};
        if (part == 0) {
            team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
            team_expect(team, h5md_open(&h5md, &team->comm, f.path, &head, 5, &error), "%s", error.text);
        }
    }
    team_expect(team, write_list(&f, h5md, 6, 9000, &error), "%s", error.text);
    team_expect(team, h5md_close(&h5md, &error), "%s", error.text);
    fixture_free(&f);
    team_finish(team);
}

TEAM_MAIN(h5md_run, team_case(number_may_change), team_case(fixed_number_is_kept), team_case(resume_goes_on),
          team_case(runs_are_named), team_case(fixed_file_is_kept), team_case(contacts_are_listed),
          team_case(observables_come_along), team_case(xdmf_names_what_is_there), team_case(frames_have_room),
          team_case(contacts_have_room))
