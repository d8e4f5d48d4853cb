/* SPDX-License-Identifier: BSD-3-Clause */
/* Refuses parts of a law that do not combine, and coefficients of parts that are out of range (law_parts.h). */
#include "physics/grains/laws/law_user.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Appends a word to a list. */
static void law_list(char *list, size_t room, const char *word) {
    size_t used = strlen(list);
    snprintf(list + used, room - used, "%s%s", used ? ", " : "", word);
}

/* Refuses a part that does not combine with the law, and names what does. */
static bool law_check_part(enum law_part part, int chosen, enum law_normal normal, struct error *error) {
    char laws[128] = "", list[256] = "";
    int count;
    const struct law_part_row *rows = law_part_rows(part, &count);
    const struct law_row *law = law_row_get(normal);
    if (law_part_combines(&rows[chosen], law->traits))
        return true;
    for (int k = 0; k < LAW_COUNT; k++)
        if (law_part_combines(&rows[chosen], law_row_get((enum law_normal)k)->traits))
            law_list(laws, sizeof laws, law_row_get((enum law_normal)k)->name);
    for (int k = 0; k < count; k++)
        if (law_part_combines(&rows[k], law->traits))
            law_list(list, sizeof list, rows[k].name);
    return error_set(error, ERROR_USER,
                     "contact.%s: %s goes with contact.law %s, not with %s; with %s go: %s",
                     law_part_key(part), rows[chosen].name, laws, law->name, law->name, list);
}

/* The row of each kind of part. */
static void law_parts_of(const struct law_options *o, int chosen[LAW_PART_COUNT]) {
    chosen[LAW_PART_COHESION] = o->cohesion;
    chosen[LAW_PART_TANGENTIAL] = o->tangential;
    chosen[LAW_PART_ROLLING] = o->rolling;
    chosen[LAW_PART_TWISTING] = o->twisting;
    chosen[LAW_PART_DAMPING] = o->damping;
}

/* True if a law without parts may have this row of a kind: it is no part of the law's title. */
static bool law_usual(const struct law_options *o, enum law_part part) {
    switch (part) {
    case LAW_PART_COHESION:
        return o->cohesion == LAW_COHESION_NONE;
    case LAW_PART_TANGENTIAL:
        return o->tangential <= LAW_TANGENTIAL_HISTORY;
    case LAW_PART_ROLLING:
        return law_rolling_form_of(o->rolling)->plain;
    case LAW_PART_TWISTING:
        return o->twisting == LAW_TWISTING_NONE;
    case LAW_PART_DAMPING:
    case LAW_PART_COUNT:
        break;
    }
    return true;
}

void law_title(const struct law_options *options, char text[LAW_TITLE_MAX]) {
    int chosen[LAW_PART_COUNT], count;
    law_parts_of(options, chosen);
    snprintf(text, LAW_TITLE_MAX, "%s", law_row_get(options->normal)->name);
    if (options->user)
        snprintf(text, LAW_TITLE_MAX, "file %s (text %016llx)", options->user->name,
                 (unsigned long long)options->user->checksum);
    for (int k = 0; k < LAW_PART_COUNT; k++) {
        char part[64];
        snprintf(part, sizeof part, "%s %s", law_part_key((enum law_part)k),
                 law_part_rows((enum law_part)k, &count)[chosen[k]].name);
        if (!law_usual(options, (enum law_part)k))
            law_list(text, LAW_TITLE_MAX, part);
    }
}

bool law_check_parts(const struct law_options *o, struct error *error) {
    int chosen[LAW_PART_COUNT];
    law_parts_of(o, chosen);
    for (int k = 0; k < LAW_PART_COUNT; k++)
        if (!law_check_part((enum law_part)k, chosen[k], o->normal, error))
            return false;
    if (o->tangential == LAW_FRICTIONLESS && o->twisting != LAW_TWISTING_NONE)
        return error_set(error, ERROR_USER, "contact.twisting: needs contact.tangential: history");
    if (o->lammps_granular && o->synchronised)
        return error_set(error, ERROR_USER,
                         "contact: lammps_granular goes with the integrator velocity_verlet only");
    if (o->lammps_granular && o->lammps_history)
        return error_set(error, ERROR_USER, "contact: lammps_granular beside lammps_history; give one");
    return true;
}

/* True if a value lies in a range "(0, inf)", "[0, 1)". */
static bool law_in_range(const char *range, double value) {
    char *at;
    double low = strtod(range + 1, &at), high = strtod(at + 1, &at);
    return isfinite(value) && (*range == '(' ? value > low : value >= low) &&
           (*at == ')' ? value < high : value <= high);
}

/* The keys of the parts in use. */
static bool law_check_keys(const struct law_extra *x, const struct law_options *o, const char *const name[2],
                           struct error *error) {
    int chosen[LAW_PART_COUNT], count, rows;
    const struct law_given_key *key = law_given_keys(&count);
    law_parts_of(o, chosen);
    for (int k = 0; k < count; k++) {
        const double value = *(const double *)((const char *)x + key[k].offset);
        bool used = strcmp(law_part_rows(key[k].part, &rows)[chosen[key[k].part]].name, key[k].name) == 0;
        bool absent = value == 0.0 && !key[k].required;
        if (used && !absent && !law_in_range(key[k].range, value))
            return error_set(error, ERROR_USER, "material pair %s, %s: %s is %g; allowed is %s", name[0],
                             name[1], key[k].key, value, key[k].range);
    }
    const char *wrong = NULL;
#define CASE(NAME, name, with, summary)                                                                      \
    if (o->cohesion == LAW_COHESION_##NAME)                                                                  \
        wrong = cohesion_##name##_wrong(&x->cohesion_##name);
    LAW_COHESION_PARTS(CASE)
#undef CASE
    return !wrong || error_set(error, ERROR_USER, "material pair %s, %s: %s", name[0], name[1], wrong);
}

bool law_check_extra(const struct law_extra *x, const struct law_options *o, const char *const name[2],
                     struct error *error) {
    bool friction = o->tangential != LAW_FRICTIONLESS;
    bool hysteresis = law_has_trait(o->normal, "hysteresis"), yields = law_has_trait(o->normal, "yield");
    bool cakes = law_has_trait(o->normal, "compaction");
    const struct {
        const char *key;
        double value, most;
        bool used, open;
    } rows[] = {{"static_friction", x->static_friction, INFINITY, friction, false},
                {"yield_pressure", x->yield_pressure, INFINITY, yields, true},
                {"plasticity_ratio", x->plasticity_ratio, 1.0 - 1e-9, cakes, false},
                {"adhesion_energy", x->adhesion_energy, INFINITY, cakes, false},
                {"adhesion_exponent", x->adhesion_exponent, INFINITY, cakes, true},
                {"pull_off", x->pull_off, INFINITY, cakes, false},
                {"k_2", x->k_2, INFINITY, hysteresis, true},
                {"k_c", x->k_c, INFINITY, hysteresis, false},
                {"plasticity_depth", x->plasticity_depth, INFINITY, hysteresis, false}};
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++)
        if (rows[r].used &&
            !(isfinite(rows[r].value) && (rows[r].open ? rows[r].value > 0.0 : rows[r].value >= 0.0) &&
              rows[r].value <= rows[r].most))
            return error_set(error, ERROR_USER, "material pair %s, %s: %s is %g; allowed is %s%g", name[0],
                             name[1], rows[r].key, rows[r].value, rows[r].open ? "above 0 up to " : "0 to ",
                             rows[r].most);
    if (o->user && x->parameters != o->user->law->parameters)
        return error_set(error, ERROR_USER, "material pair %s, %s: parameters: %d given; the law %s takes %d",
                         name[0], name[1], x->parameters, o->user->name, o->user->law->parameters);
    return law_check_keys(x, o, name, error);
}
