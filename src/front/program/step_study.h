/* SPDX-License-Identifier: BSD-3-Clause */
/* The error of an impact at a step that is a part of the stable one, law by law, as examples/step-fraction.sh finds it
 * (docs/speed-error.md): the largest difference, over the phases of a step at which 40 pairs of spheres meet and over the
 * impacts studied that part the pair, of the velocity after the impact from that at 0.005 of the stable step, over the speed of approach. The
 * errors of a law are its `step_error` (physics/grains/laws/law_form.h). Those of a cohesion are for one strength, with Hertz's springs. */
#ifndef SCREE_PROGRAM_STEP_STUDY_H
#define SCREE_PROGRAM_STEP_STUDY_H

#include "physics/grains/laws/law.h"

/* The error at a part of the stable step, > 0: that of the law or of its cohesion, whichever is larger; between the parts
 * studied along a power of the step, outside in proportion to the step. NAN: the law is not studied. Any thread. */
double step_study_error(const struct law_options *options, double fraction);

/* The largest of the parts studied up to which all errors are within a tolerance; 0: none, or the law is not studied.
 * Any thread. */
double step_study_longest(const struct law_options *options, double tolerance);

#endif
