/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs the first steps of a scene before a comparison. The trial finds whether the scene has rebuilds and
 * contacts, which the comparison needs, the time of a step, and that of a pair by brute force. */
#ifndef SCREE_PROGRAM_TRIAL_H
#define SCREE_PROGRAM_TRIAL_H

#include "engine/simulation.h"

struct trial {
    uint64_t steps, last; /* steps done; number of the last step of the whole run */
    double seconds;       /* wall clock of the steps done, without set-up */
    bool rebuilt;         /* the list of pairs was made again, first in step `rebuild_first` */
    bool touched;         /* something touched, first after step `contact_first` */
    uint64_t rebuild_first, contact_first;
    uint64_t particles;
    double brute_pair;    /* seconds of brute force for a pair with all of its images, on one thread */
    struct timers timers; /* of the trial; all runs of the scene have its stages */
};

/* Makes one step as a run does, without files and observers. Collective. */
void trial_step(struct simulation *simulation);

/* Creates the simulation of a scene and steps until the list of pairs has been made again, something has
 * touched (a particle or a wall) and half a second has passed, or until its last step. Shows progress on the
 * terminal; writes no files. A signal ends the trial with an error of kind ERROR_SIGNAL + number.
 * Collective. */
bool trial_run(const struct comm *comm, const struct scene *scene, struct trial *trial, struct error *error);

/* True if the first `steps` steps hold a rebuild and a contact. Else fails (user) and names the missing
 * event, its first step, and the number of steps needed. `flag` is the flag of the command line that sets the
 * length of a run. */
bool trial_suffices(const struct trial *trial, uint64_t steps, const char *flag, struct error *error);

#endif
