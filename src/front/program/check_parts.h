/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of what `scree check` prints: the terms and fields that a scene needs, a layout of ranks, the cost of a run, and the
 * error of its step. */
#ifndef SCREE_FRONT_PROGRAM_CHECK_PARTS_H
#define SCREE_FRONT_PROGRAM_CHECK_PARTS_H

#include "engine/state.h"
#include "physics/grains/laws/law.h"

#include <stdbool.h>

/* Prints the terms of the contact law that the scene brings, each with what brought it. The terms that it leaves out
 * are named in one line; with `all` each has the setting that would bring it. `alone`: on one rank; `sums`: energies are summed
 * in each step. One thread. */
struct grains;
void check_parts_terms(const struct scene *scene, const struct grains *grains, bool alone, bool sums,
                       bool all);

/* Prints the fields of a particle with bytes and reason, and those that are not needed. One thread. */
void check_parts_fields(const struct particles *particles, const struct scene *scene, const struct law *law);

/* Prints the bytes that are stored of a particle and of a pair that touches. One thread. */
void check_parts_bytes(const struct particles *particles, const struct law *law);

/* Prints the bytes of a particle in each kind of message; nothing on one rank. One thread. */
void check_parts_wire(const struct particles *particles, bool newton);

/* What a layout of ranks and threads will need, told by one rank: `scree check SCENE --ranks N --threads M`. */

/* Prints the bricks of `ranks` ranks, the particles and copies of a rank, and its memory, by the particles as they are
 * now. Counts each copy by the rule of kernel/comm/ghosts.h, for bricks; a bisection is more even. One rank, which has all
 * particles. False with a user's error if the box cannot be divided so. */
bool layout_print(const struct simulation *simulation, int ranks, int threads, struct error *error);

/* What a run will cost: steps, time on the clock, files. */

/* Prints, on rank 0, the number of steps, the time that they will take, and the files with their sizes, with `all` a line
 * each. For the
 * time the simulation runs some of its first steps, for about a third of a second; a simulation with a fluid is
 * not timed, as one of its steps may take long. The simulation must not be used for anything but its end
 * afterwards. Collective. */
void run_cost_print(struct simulation *simulation, bool all);

/* The error of an impact at a step that is a part of the stable one, law by law, as examples/step-fraction.sh finds it
 * (docs/speed-error.md): the largest difference, over the phases of a step at which 40 pairs of spheres meet and over the
 * impacts studied that part the pair, of the velocity after the impact from that at 0.005 of the stable step, over the speed of approach. The
 * errors of a law are its `step_error` (physics/grains/laws/law_form.h). Those of a cohesion are for one strength, with Hertz's springs. */

/* The error at a part of the stable step, > 0: that of the law or of its cohesion, whichever is larger; between the parts
 * studied along a power of the step, outside in proportion to the step. NAN: the law is not studied. Any thread. */
double step_study_error(const struct law_options *options, double fraction);

/* The largest of the parts studied up to which all errors are within a tolerance; 0: none, or the law is not studied.
 * Any thread. */
double step_study_longest(const struct law_options *options, double tolerance);

#endif
