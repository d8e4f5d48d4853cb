/* SPDX-License-Identifier: BSD-3-Clause */
/* scree as a library: its engine, its contact search (scree_pairs.h), and the whole program, for other codes.
 *
 *     cc mycode.c $(pkg-config --cflags --libs scree)
 *
 * All functions are plain C. None prints or exits, except scree_main, which is a whole program. Warnings and notes
 * go to a function of the caller. Two failures still end the process, because other ranks would wait for ever:
 * exhausted memory and a failed call of MPI. The function of the caller gets their message, too. A third one, a file that one
 * of several ranks cannot write, ends the job after ten seconds where the ranks would wait for each other inside of HDF5. That
 * needs scree before MPI in the order of linking or loading; else rank 0 notes that such a job may wait.
 *
 * Functions with a `struct scree_error *` fill it and return false or NULL on failure; it may be NULL. "Collective"
 * means that all ranks of the communicator call the function, with the same arguments, and get the same result.
 * One thread at a time calls the functions of a simulation. Each comment says who owns an array. Where there is no
 * simulation (NULL), functions fail, or return 0, NULL or "". A function of the caller that the simulation calls may read
 * and write fields, add and delete; scree_step, scree_observe, scree_checkpoint, scree_report and scree_destroy refuse
 * it. */
#ifndef SCREE_H
#define SCREE_H

#include "scree_pairs.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The program `scree` with these arguments: starts and stops MPI, prints, and returns the exit status. */
int scree_main(int argc, char **argv);

/* A running scene. */
struct scree_simulation;

/* The kinds of failure; the numbers are the exit statuses of the program. */
enum scree_status {
    SCREE_GOOD = 0,
    SCREE_SYSTEM = 1, /* MPI, HDF5, memory, disk */
    SCREE_USER = 2,   /* the scene, a file or an argument */
    SCREE_PHYSICS = 3 /* a guard stopped the simulation: physical nonsense */
};

/* A failure; the text has one line for each mistake, without an end of line behind the last. */
struct scree_error {
    enum scree_status status;
    char text[2048];
};

/* The settings of a simulation. All zero: no overrides, a new start, this process alone, no messages, no force. */
struct scree_options {
    const void
        *communicator;  /* points to an MPI_Comm, which is duplicated. NULL: this process alone; MPI is then
                                 started if nobody has, and ends with the process */
    const char *resume; /* a checkpoint to go on from; NULL: none */
    const char *const *set; /* `sets` overrides "KEY=VALUE", as --set of the program; borrowed for the call */
    int sets;
    /* Gets each warning and note, a line without its end. NULL: nobody gets them. */
    void (*log)(void *context, const char *line);
    void *log_context;
    /* Adds forces to the field "force" of the owned particles. Called once in each evaluation of forces, after
     * contacts and walls, with positions and radii of this moment and velocities of half a step before. The fields
     * of scree_field may be read, and those of forces and torques be written. NULL: none. The guard of energies is
     * then off. */
    void (*force)(void *context, struct scree_simulation *simulation);
    void *force_context;
    /* Of a scene with `stages`: gets the checkpoint at the end of each stage. NULL: the checkpoints are kept in $TMPDIR
     * or /tmp until the next stage begins; ranks on several nodes need a folder that all of them see. */
    const char *folder;
    void *reserved[7]; /* NULL */
};

/* Makes a simulation of a scene: its particles, pairs and first forces. `text` is the scene, and `file` its name in
 * messages, relative paths starting from the folder of the file; `text` NULL: the file is read. Signals, progress
 * and all files of a run are left to the caller; the section `output` of the scene counts for observables alone.
 * `options` may be NULL. NULL on failure. Release with scree_destroy. Collective. */
struct scree_simulation *scree_create(const char *file, const char *text, const struct scree_options *options,
                                      struct scree_error *error);

/* Frees a simulation, and sets the pointer to NULL. Before MPI_Finalize. Collective. */
void scree_destroy(struct scree_simulation **simulation);

/* Runs `steps` time steps. After a failure no further step is possible. If the scene has stages, the step that ends a
 * stage begins the next one, and no step is taken after the end of the last stage. Collective. */
bool scree_step(struct scree_simulation *simulation, uint64_t steps, struct scree_error *error);

/* The number of steps from now to the end of the scene (`duration` or `step.count`); 0 if the end is reached. With stages:
 * to the end of the present stage, at most, as its conditions may end the stage earlier; 0 only after the last stage. */
uint64_t scree_steps_left(const struct scree_simulation *simulation);

/* The name of the present stage; "" without stages, and after the last one. Belongs to the simulation until its next
 * step. */
const char *scree_stage(const struct scree_simulation *simulation);

/* The state of the clock: number of the last step, time, and length of a step. */
uint64_t scree_step_number(const struct scree_simulation *simulation);
double scree_time(const struct scree_simulation *simulation);
double scree_time_step(const struct scree_simulation *simulation);

/* The number of particles on all ranks. */
uint64_t scree_particles(const struct scree_simulation *simulation);

/* The effective scene as YAML, with all defaults. Belongs to the simulation. */
const char *scree_scene(const struct scree_simulation *simulation);

/* The box: lower corner in the coordinates of the scene, edges. Positions of particles are relative to the
 * corner. */
struct scree_box {
    double origin[3], edge[3]; /* length */
    bool periodic[3];
    int dimension; /* 2 or 3 */
};
struct scree_box scree_box(const struct scree_simulation *simulation);

enum scree_type { SCREE_DOUBLE, SCREE_INT64, SCREE_INT32, SCREE_UINT8 };

/* The values of a field at the particles that this rank owns. The memory is that of the simulation: component c of
 * particle k stands at (char *)data + k * stride + c * (bytes of a component). Steps, scree_checkpoint and
 * scree_add make it invalid, and may bring the particles into another order, in which they have their ids. */
struct scree_field {
    void *data;
    enum scree_type type;
    int components;
    size_t count;     /* particles */
    size_t stride;    /* bytes from one particle to the next */
    const char *unit; /* SI, "" without one */
};

/* Finds a field by its name in docs/output.md ("position", "velocity", "radius", "inverse_mass", "force", "id",
 * "angular_velocity" ...). Velocities are those of half a step before: v(n-1/2), which led to the positions. Values
 * may be written; positions, radii and masses alike on all ranks, and scree_changed follows. False if the scene has
 * no such field. */
bool scree_field(const struct scree_simulation *simulation, const char *name, struct scree_field *field);

/* The name of field `k`, NULL behind the last. */
const char *scree_field_name(const struct scree_simulation *simulation, int k);

/* Tells the simulation that the caller has written positions or radii: the next step searches all pairs again.
 * Collective. */
void scree_changed(struct scree_simulation *simulation);

/* A new particle. */
struct scree_particle {
    double
        position[3]; /* in the coordinates of the scene, inside the box; in two dimensions z is that of all */
    double velocity[3];         /* length/time */
    double angular_velocity[3]; /* 1/time; only with friction */
    double radius, density;     /* density as the scene means it (box.density); 0: that of the material */
    int material, group;        /* numbers in the scene, from 0; group 0 is "free" */
    const char *
        shape; /* name of an entry of bodies.clumps or bodies.shapes; "": it stays a sphere; NULL: material and radius choose, as in
                          the scene's sources */
    double orientation
        [4]; /* of a body: quaternion w x y z, of any length, from the frame in which the entry is drawn; all 0: the entry says
                              it. A body with an orientation turns with angular_velocity, without that of the entry */
};

/* Adds particles in the next step. The radius of a named shape is that of the sphere of its volume where a source or an insertion of the scene
 * names the entry, too, else of the ball around the body, as the entry's `size` says. The ids of particles follow the largest id so far, in order. Whether they overlap others is not
 * looked at. A fluid refuses all, and a periodic box rocks that are too large for it. The array is borrowed for the
 * call. Collective. */
bool scree_add(struct scree_simulation *simulation, const struct scree_particle *particles, size_t count,
               struct scree_error *error);

/* Deletes the particles with these ids in the next step, those of rigid bodies with the whole body; unknown ids do nothing.
 * Beside a fluid that resolves grains the next step fails instead. Collective. */
void scree_delete(struct scree_simulation *simulation, const int64_t *ids, size_t count);

/* Writes DIRECTORY/checkpoint-STEP.h5, from which the program, too, goes on. The simulation searches its pairs again
 * and then goes on as one that resumes from the file, to the bit. Collective. */
bool scree_checkpoint(struct scree_simulation *simulation, const char *directory, struct scree_error *error);

/* The columns of the observables: those of the scene's `observables.list`. Names and units belong to the
 * simulation; NULL if there is no such column. */
int scree_columns(const struct scree_simulation *simulation);
const char *scree_column_name(const struct scree_simulation *simulation, int column);
const char *scree_column_unit(const struct scree_simulation *simulation, int column);

/* Computes the observables of this moment into values[scree_columns()]. Energies and stresses of contacts are those
 * of the last step of a scree_step, or of the start; right after the end of a stage all values are those of that end.
 * Collective. */
bool scree_observe(struct scree_simulation *simulation, double *values, struct scree_error *error);

/* The rows that the simulation has recorded as `observables.every` of the scene says, as in observables.csv: their
 * number, and row `row` with the time first, 1 + scree_columns() numbers that belong to the simulation until its
 * next step; NULL if there is no such row. */
size_t scree_rows(const struct scree_simulation *simulation);
const double *scree_row(const struct scree_simulation *simulation, size_t row);

/* The report of the steps since scree_create, or since the present stage began: the text of report.json as docs/output.md
 * describes it; its seconds are those inside of scree_step. Belongs to the simulation until the next call or
 * scree_destroy; NULL on failure. Collective. */
const char *scree_report(struct scree_simulation *simulation, struct scree_error *error);

#ifdef __cplusplus
}
#endif

#endif
