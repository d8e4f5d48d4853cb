/* SPDX-License-Identifier: BSD-3-Clause */
/* Refuses parts of a law that do not combine, and coefficients of parts that are out of range (law_parts.h). */
#include "physics/grains/laws/law_user.h"
#include <math.h>
#include <stdio.h>
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

/* The last row of each kind that a law without parts may have: such rows are not part of its title. */
static const int law_usual[LAW_PART_COUNT] = {[LAW_PART_COHESION] = LAW_COHESION_NONE,
                                              [LAW_PART_TANGENTIAL] = LAW_TANGENTIAL_HISTORY,
                                              [LAW_PART_ROLLING] = LAW_ROLLING_SPRING,
                                              [LAW_PART_TWISTING] = LAW_TWISTING_NONE,
                                              [LAW_PART_DAMPING] = LAW_DAMPING_COUNT};

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
        if (chosen[k] > law_usual[k])
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

bool law_check_extra(const struct law_extra *x, const struct law_options *o, const char *const name[2],
                     struct error *error) {
    bool surface = o->cohesion == LAW_COHESION_JKR || o->cohesion == LAW_COHESION_DMT;
    bool wet = o->cohesion == LAW_COHESION_CAPILLARY, far = o->cohesion == LAW_COHESION_VAN_DER_WAALS;
    bool friction = o->tangential != LAW_FRICTIONLESS, given = o->twisting == LAW_TWISTING_SDS;
    bool hysteresis = law_has_trait(o->normal, "hysteresis"), yields = law_has_trait(o->normal, "yield");
    bool cakes = law_has_trait(o->normal, "compaction");
    const struct {
        const char *key;
        double value, most;
        bool used, open;
    } rows[] = {
        {"surface_energy", x->surface_energy, INFINITY, surface, false},
        {"cohesion_density", x->cohesion_density, INFINITY, o->cohesion == LAW_COHESION_SJKR, false},
        {"surface_tension", x->surface_tension, INFINITY, wet, false},
        {"contact_angle", x->contact_angle, 0.5 * M_PI, wet, false},
        {"bridge_volume", x->bridge_volume, INFINITY, wet, false},
        {"bridge_fraction", x->bridge_fraction, INFINITY, wet, false},
        {"hamaker", x->hamaker, INFINITY, far, false},
        {"gap_least", x->gap_least, x->cut_off, far, true},
        {"cut_off", x->cut_off, INFINITY, far, true},
        {"dissipative_time", x->dissipative_time, INFINITY, o->damping == LAW_DAMPING_VISCOELASTIC, false},
        {"static_friction", x->static_friction, INFINITY, friction, false},
        {"rolling_stiffness", x->rolling_stiffness, INFINITY, o->rolling != LAW_ROLLING_NONE, false},
        {"rolling_damping", x->rolling_damping, INFINITY, o->rolling != LAW_ROLLING_NONE, false},
        {"rolling_damping_ratio", x->rolling_damping_ratio, INFINITY, o->rolling == LAW_ROLLING_EPSD, false},
        {"yield_pressure", x->yield_pressure, INFINITY, yields, true},
        {"plasticity_ratio", x->plasticity_ratio, 1.0 - 1e-9, cakes, false},
        {"adhesion_energy", x->adhesion_energy, INFINITY, cakes, false},
        {"adhesion_exponent", x->adhesion_exponent, INFINITY, cakes, true},
        {"pull_off", x->pull_off, INFINITY, cakes, false},
        {"k_2", x->k_2, INFINITY, hysteresis, true},
        {"k_c", x->k_c, INFINITY, hysteresis, false},
        {"plasticity_depth", x->plasticity_depth, INFINITY, hysteresis, false},
        {"twisting_stiffness", x->twisting_stiffness, INFINITY, given, true},
        {"twisting_damping", x->twisting_damping, INFINITY, given, false},
        {"twisting_friction", x->twisting_friction, INFINITY, given, false}};
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
    if (wet && x->surface_tension > 0.0 && !(x->bridge_volume > 0.0) == !(x->bridge_fraction > 0.0))
        return error_set(error, ERROR_USER,
                         "material pair %s, %s: give one of bridge_volume and bridge_fraction, above 0",
                         name[0], name[1]);
    return true;
}
