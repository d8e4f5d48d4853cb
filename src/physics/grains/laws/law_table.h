/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of contact laws. Read law_form.h first: that header has the recipe for a new law.
 *
 * A row: LAW_NAME for the number, the name in scenes, the traits that keys of a scene ask for
 * (data/scene/schema.h), and what the law is. Traits: `moduli`, a law whose springs come from young and poisson of
 * the materials; `stiffness`, one whose springs are k_n and k_t of the pair, force/length; `hysteresis`, one that also
 * takes k_2 and k_c; `yield`, one with a yield pressure; `compaction`, one with a plasticity ratio and an adhesive branch that
 * grows with the load; `elastic`, moduli without plastic flow; `implicit`, a law whose contacts a solver can find (contact.solver), and `stiff`, one
 * that needs the solver; `file`, a law that the user writes (law_user.h). Laws of LAW_ELASTIC_TABLE have vectorised loops of their own (force_physics.h). */
#ifndef SCREE_LAWS_LAW_TABLE_H
#define SCREE_LAWS_LAW_TABLE_H

#include "physics/grains/laws/law_custom.h"
#include "physics/grains/laws/law_eepa.h"
#include "physics/grains/laws/law_hertz.h"
#include "physics/grains/laws/law_hooke.h"
#include "physics/grains/laws/law_luding.h"
#include "physics/grains/laws/law_rigid.h"
#include "physics/grains/laws/law_thornton.h"

#define LAW_BUILT_TABLE(ROW)                                                                                 \
    ROW(HOOKE, hooke, "stiffness implicit", "linear spring and dashpot")                                     \
    ROW(HERTZ, hertz, "moduli elastic implicit", "elastic spheres, Hertz and Mindlin")

/* Laws whose springs a file of the user's gives (law_user.h). */
#define LAW_GIVEN_TABLE(ROW)                                                                                 \
    ROW(CUSTOM, custom, "stiffness file",                                                                    \
        "a law of your own: write {file: mylaw.c}, which is compiled at the start of a run")
#define LAW_GIVEN_NAME "custom"
#define LAW_ELASTIC_TABLE(ROW) LAW_BUILT_TABLE(ROW) LAW_GIVEN_TABLE(ROW)

/* Laws with hysteresis whose branches are chosen by arithmetic: law_NAME_branch (law_luding.h) in a loop vectorises. */
#define LAW_BRANCH_TABLE(ROW)                                                                                \
    ROW(LUDING, luding, "stiffness hysteresis",                                                              \
        "plastic, adhesive grains: linear springs, steeper on unloading, with a pull after compression")

/* The members of struct law_extra that these take, one after another: columns of a batch of contacts. */
#define LAW_BRANCH_NUMBERS(NUMBER) LAW_LUDING_NUMBERS(NUMBER)
#define LAW_BRANCH_PLACE(member) LAW_BRANCH_##member,
enum { LAW_BRANCH_NUMBERS(LAW_BRANCH_PLACE) LAW_BRANCH_COUNT };

/* Laws whose contacts go through the general loop (law_general.h); LAW_TABLE: all laws. */
#define LAW_PLASTIC_TABLE(ROW)                                                                               \
    LAW_BRANCH_TABLE(ROW)                                                                                    \
    ROW(THORNTON, thornton, "moduli yield",                                                                  \
        "elastic, perfectly plastic spheres with a yield pressure: fast impacts; with the cohesion jkr "     \
        "sticky ones")                                                                                       \
    ROW(EEPA, eepa, "moduli compaction",                                                                     \
        "powders that cake: plastic spheres that stick the harder the more they were pressed (Edinburgh)")

/* Laws without springs, whose contacts a solver finds. */
#define LAW_STIFF_TABLE(ROW)                                                                                 \
    ROW(RIGID, rigid, "implicit stiff", "grains that do not yield: needs contact.solver (docs/hard.md)")
#define LAW_TABLE(ROW) LAW_ELASTIC_TABLE(ROW) LAW_PLASTIC_TABLE(ROW) LAW_STIFF_TABLE(ROW)

/* The law of a scene that names no law. */
#define LAW_NORMAL_DEFAULT LAW_HERTZ
#define LAW_NORMAL_DEFAULT_NAME "hertz"

#define LAW_ENUMERATOR(NAME, name, traits, summary) LAW_##NAME,
enum law_normal { LAW_TABLE(LAW_ENUMERATOR) LAW_COUNT };
#undef LAW_ENUMERATOR

/* The elastic laws come first, those without springs last. */
#define LAW_ONE(NAME, name, traits, summary) +1
enum {
    LAW_ELASTIC_COUNT = 0 LAW_ELASTIC_TABLE(LAW_ONE),
    LAW_SPRING_COUNT = LAW_ELASTIC_COUNT LAW_PLASTIC_TABLE(LAW_ONE)
};
#undef LAW_ONE

struct law_row {
    const char *name, *traits, *summary;
    const struct law_form *form;
};

/* The row of a law. Any thread. */
const struct law_row *law_row_get(enum law_normal normal);

/* True if the traits of a law have this word. Any thread. */
bool law_has_trait(enum law_normal normal, const char *trait);

/* The law with linear springs. */
enum law_normal law_linear(void);

/* The springs of a contact by the law `normal`. In time-critical code `normal` is a constant, so that the
 * compiler drops the other laws. Any thread. */
LAW_INLINE struct law_springs law_springs(enum law_normal normal, const struct law_coefficients *c,
                                          double radius, double overlap) {
#define LAW_CASE(NAME, name, traits, summary)                                                                \
    case LAW_##NAME:                                                                                         \
        return law_##name##_springs(c, radius, overlap);
    switch (normal) {
        LAW_TABLE(LAW_CASE)
    case LAW_COUNT:
        break;
    }
#undef LAW_CASE
    return (struct law_springs){0};
}

/* True for a law of LAW_BRANCH_TABLE. */
LAW_INLINE bool law_branches(enum law_normal normal) {
#define LAW_CASE(NAME, name, traits, summary) || normal == LAW_##NAME
    return false LAW_BRANCH_TABLE(LAW_CASE);
#undef LAW_CASE
}

/* The springs of such a law, whose contacts remember `past`. */
LAW_INLINE struct law_springs law_branch(enum law_normal normal, const struct law_coefficients *c,
                                         const struct law_extra *extra, double radius, double overlap,
                                         double *past) {
#define LAW_CASE(NAME, name, traits, summary)                                                                \
    if (normal == LAW_##NAME)                                                                                \
        return law_##name##_branch(c, extra, radius, overlap, past);
    LAW_BRANCH_TABLE(LAW_CASE)
#undef LAW_CASE
    return (struct law_springs){0};
}

#endif
