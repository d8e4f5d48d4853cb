/* SPDX-License-Identifier: BSD-3-Clause */
/* The damper that belongs to a restitution, in closed form. */
#ifndef SCREE_LAWS_LAW_RESTITUTION_H
#define SCREE_LAWS_LAW_RESTITUTION_H

#include "physics/grains/laws/law_form.h"

/* The smallest restitution that a contact with end at zero force can have (zeta = 22). */
#define LAW_RESTITUTION_LEAST 5e-4

/* Damping ratio zeta of the linear spring-dashpot for a restitution e. End at zero overlap: zeta = -ln e /
 * sqrt(pi^2 + ln^2 e), 1 for e = 0. End at zero force: inverts e(zeta) of Schwager and Poeschel (Granular
 * Matter 9 (2007) 465); there e = 0 needs an infinite damper, and e below LAW_RESTITUTION_LEAST counts as
 * LAW_RESTITUTION_LEAST. */
double law_damping_ratio(double restitution, enum law_end end);

/* The relative excess of the friction impulse of an impact that slides throughout, over Coulomb's impulse mu
 * (1 + e) m* v. The excess is 0 if the contact ends at zero force. If the contact ends at zero overlap, the
 * limit counts the damper's pull, too, and the excess is 2 (e_F - e) / (1 + e); e_F is the restitution of the
 * same damper with end at zero force (both laws; docs/physics.md). */
double law_end_friction(double restitution, enum law_end end);

#endif
