/* SPDX-License-Identifier: BSD-3-Clause */
/* The first steps of a scene before a comparison: does anything happen that the comparison is for, and how
 * long does a step take? */
#ifndef SCREE_APP_TRIAL_H
#define SCREE_APP_TRIAL_H

#include "engine/simulation.h"

struct trial {
    uint64_t steps, last; /* done; number of the last step of the whole run */
    double seconds;       /* wall clock of the steps done, without set-up */
    bool rebuilt;         /* the list of pairs was made again, first in step `rebuild_first` */
    bool touched;         /* something touched, first after step `contact_first` */
    uint64_t rebuild_first, contact_first;
    uint64_t particles;
};

/* Creates the simulation of a scene and steps until the list of pairs has been made again, something has
 * touched (a particle or a wall) and half a second has passed, or until its last step. Shows progress on the
 * terminal; writes no files. A signal ends it with an error of kind ERROR_SIGNAL + number. Collective. */
bool trial_run(const struct comm *comm, const struct scene *scene, struct trial *trial, struct error *error);

/* True if the first `steps` steps hold a rebuild and a contact. Else fails (user) with what is missing, when
 * it comes, and what is needed; `flag` is what on the command line says how long a run is. */
bool trial_suffices(const struct trial *trial, uint64_t steps, const char *flag, struct error *error);

#endif
