/* `scree ablate`: variants of one scene, run one after the other in this process. */
#ifndef SCREE_APP_ABLATE_H
#define SCREE_APP_ABLATE_H

#include "app/command.h"
#include "engine/run.h"

/* Runs a scene without files; `watch` and `report` may be NULL. A signal that ends the run is an error of
 * kind ERROR_SIGNAL + number. Collective. */
bool ablate_run(const struct comm *comm, const struct scene *scene, const struct run_watch *watch,
                struct report *report, struct error *error);

/* `scree ablate --error`. The directory of the line is there. Collective. */
bool ablate_error(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
