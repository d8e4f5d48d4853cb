/* SPDX-License-Identifier: BSD-3-Clause */
/* Combinations of keys that cannot be: each is refused with its place before anything runs. */
#include "data/scene/scene_check.h"
#include "data/scene/mistakes.h"
#include "data/scene/packed_radii.h"
#include "data/scene/scene_stage.h"

#include <math.h>
#include <string.h>

/* The advice if two keys exclude each other. */
static const char one_of_two[] = "give one of the two, or take the other out with --set KEY=~";

/* In two dimensions a velocity must have no z component. */
static bool check_moves(const struct scene *scene, const double v[3], const char *key, struct error *error) {
    return v[2] == 0 ||
           scene_fail(scene, error, key,
                      "has a z component (%g) in a two-dimensional scene; allowed: [x, y, 0]", v[2]);
}

/* In two dimensions a rotation must be about z. */
static bool check_turns(const struct scene *scene, const double v[3], const char *key, struct error *error) {
    return (v[0] == 0 && v[1] == 0) ||
           scene_fail(scene, error, key,
                      "turns out of the plane of a two-dimensional scene; allowed: [0, 0, z]");
}

/* Velocity and spin of a source, group or insertion. */
static bool check_plane_pair(const struct scene *scene, const double velocity[3], const double omega[3],
                             const char *section, struct error *error) {
    char key[96];
    snprintf(key, sizeof(key), "%s.velocity", section);
    if (!check_moves(scene, velocity, key, error))
        return false;
    snprintf(key, sizeof(key), "%s.omega", section);
    return check_turns(scene, omega, key, error);
}

static bool check_plane_motion(const struct scene *scene, const struct wall_motion *motion,
                               const char *section, struct error *error) {
    char key[96];
    snprintf(key, sizeof(key), "%s.%s", section, motion->kind == WALL_TRANSLATE ? "velocity" : "direction");
    switch (motion->kind) {
    case WALL_TRANSLATE:
        return check_moves(scene, motion->velocity, key, error);
    case WALL_ROTATE:
    case WALL_OSCILLATE_ROTATION:
        return check_turns(scene, motion->direction, key, error);
    case WALL_OSCILLATE:
    case WALL_SERVO:
        return check_moves(scene, motion->direction, key, error);
    case WALL_TABLE: /* known when the walls are made */
        break;
    }
    return true;
}

/* A free wall that stays in the plane. */
static bool check_plane_free(const struct scene *scene, int w, struct error *error) {
    const struct wall_free_options *free = &scene->wall[w].free;
    char key[96];
    snprintf(key, sizeof(key), "walls[%d].free.density", w);
    if (!isnan(free->density))
        return scene_fail(scene, error, key,
                          "needs a volume, which nothing has in two dimensions; allowed: mass");
    snprintf(key, sizeof(key), "walls[%d].free.direction", w);
    if (free->freedom == WALL_FREE_ABOUT)
        return check_turns(scene, free->direction, key, error);
    if (free->freedom == WALL_FREE_ALONG)
        return check_moves(scene, free->direction, key, error);
    snprintf(key, sizeof(key), "walls[%d].free.velocity", w);
    if (!check_moves(scene, free->velocity, key, error))
        return false;
    snprintf(key, sizeof(key), "walls[%d].free.angular_velocity", w);
    return check_turns(scene, free->omega, key, error);
}

/* A plane stands upright, or bounds z where the box ends; a cylinder stands or lies. */
static bool check_plane_wall(const struct scene *scene, int w, struct error *error) {
    const struct wall_options *wall = &scene->wall[w];
    const double *n = wall->normal, *axis = wall->axis;
    char key[80];
    snprintf(key, sizeof(key), "walls[%d].%s", w, wall->shape == WALL_PLANE ? "normal" : "axis");
    bool bounds = n[0] == 0 && n[1] == 0 &&
                  (n[2] > 0 ? wall->point[2] <= scene->box_lower[2] : wall->point[2] >= scene->box_upper[2]);
    if (wall->shape == WALL_PLANE && n[2] != 0 && !bounds)
        return scene_fail(scene, error, key,
                          "has a z component (%g) in a two-dimensional scene; allowed: [x, y, 0], or along z "
                          "where the box ends or beyond",
                          n[2]);
    if (wall->shape == WALL_CYLINDER && axis[2] != 0 && (axis[0] != 0 || axis[1] != 0))
        return scene_fail(
            scene, error, key,
            "leans out of the plane of a two-dimensional scene; allowed: [0, 0, 1] or [x, y, 0]");
    if (wall->free.given && !check_plane_free(scene, w, error))
        return false;
    for (int m = 0; m < wall->motions; m++) {
        snprintf(key, sizeof(key), "walls[%d].motion[%d]", w, m);
        if (!check_plane_motion(scene, &wall->motion[m], key, error))
            return false;
    }
    return true;
}

static bool check_plane(const struct scene *scene, struct error *error) {
    char section[64];
    if (scene->box.dimension != 2)
        return true;
    if (scene->box.periodic[2])
        return scene_fail(scene, error, "box.periodic", "z cannot be periodic in two dimensions");
    if (!check_moves(scene, scene->gravity, "gravity", error))
        return false;
    for (int s = 0; s < scene->sources; s++) {
        snprintf(section, sizeof(section), "particles.sources[%d]", s);
        if (!check_plane_pair(scene, scene->source[s].velocity, scene->source[s].omega, section, error))
            return false;
    }
    for (int g = 1; g < scene->groups; g++) {
        snprintf(section, sizeof(section), "groups[%d]", g - 1);
        if (!check_plane_pair(scene, scene->group[g].velocity, scene->group[g].omega, section, error))
            return false;
    }
    for (int k = 0; k < scene->insertions; k++) {
        snprintf(section, sizeof(section), "insertions[%d]", k);
        if (!check_plane_pair(scene, scene->insertion[k].velocity, scene->insertion[k].omega, section, error))
            return false;
    }
    for (int w = 0; w < scene->walls; w++)
        if (!check_plane_wall(scene, w, error))
            return false;
    return true;
}

/* A region must meet the box; in two dimensions a cylinder stands upright. */
static bool check_region(const struct scene *scene, const struct region *region, const char *section,
                         struct error *error) {
    char key[96];
    if (region->shape == REGION_ALL)
        return true;
    snprintf(key, sizeof(key), "%s.region.upper", section);
    for (int d = 0; region->shape == REGION_BOX && d < scene->box.dimension; d++)
        if (!(region->upper[d] > region->lower[d]))
            return scene_fail(scene, error, key, "%c: %g is not above the lower corner's %g", "xyz"[d],
                              region -> upper[d], region -> lower[d]);
    snprintf(key, sizeof(key), "%s.region.axis", section);
    if (region->shape == REGION_CYLINDER && scene->box.dimension == 2 && fabs(region->axis[2]) < 1)
        return scene_fail(scene, error, key, "must be [0, 0, 1] in two dimensions");
    double lower[3], upper[3];
    region_bounds(region, lower, upper);
    snprintf(key, sizeof(key), "%s.region", section);
    for (int d = 0; d < scene->box.dimension; d++)
        if (lower[d] > scene->box_upper[d] || upper[d] < scene->box_lower[d])
            return scene_fail(scene, error, key,
                              "lies outside of the box (%c from %g to %g, the box from %g to %g)", "xyz"[d],
                              lower[d], upper[d], scene -> box_lower[d], scene -> box_upper[d]);
    return true;
}

/* A region for spheres to be placed in: longer than a periodic edge, it would overlap itself. */
static bool check_room(const struct scene *scene, const struct region *region, const char *section,
                       struct error *error) {
    char key[96];
    double lower[3], upper[3];
    if (!check_region(scene, region, section, error))
        return false;
    region_bounds(region, lower, upper);
    snprintf(key, sizeof(key), "%s.region", section);
    for (int d = 0; region->shape != REGION_ALL && d < scene->box.dimension; d++)
        if (scene->box.periodic[d] && upper[d] - lower[d] > scene->box.edge[d] * (1 + 1e-12))
            return scene_fail(scene, error, key,
                              "reaches from %g to %g in the periodic direction %c and overlaps itself; "
                              "allowed: at most the edge of the box, %g",
                              lower[d], upper[d], "xyz"[d], scene -> box.edge[d]);
    return true;
}

static bool check_sizes(const struct scene *scene, const struct sizes_options *sizes, const char *section,
                        struct error *error) {
    struct sizes_sampler sampler;
    struct error why = {0};
    char key[96];
    snprintf(key, sizeof(key), "%s.sizes", section);
    return sizes_prepare(&sampler, sizes, &why) || scene_fail(scene, error, key, "%s", why.text);
}

static bool check_lattice(const struct scene *scene, const struct source_options *source, const char *section,
                          struct error *error) {
    char key[96];
    bool flat = source->lattice == SOURCE_SQUARE || source->lattice == SOURCE_HEXAGONAL;
    snprintf(key, sizeof(key), "%s.lattice", section);
    if (flat != (scene->box.dimension == 2))
        return scene_fail(scene, error, key, "not a lattice of %d dimensions; allowed: %s",
                          scene->box.dimension, flat ? "sc, fcc, hcp" : "square, hexagonal");
    double smallest, largest;
    sizes_bounds(&source->sizes, &smallest, &largest);
    snprintf(key, sizeof(key), "%s.spacing", section);
    return source->spacing >= 2 * largest * (1 - 1e-12) ||
           scene_fail(scene, error, key, "%g is less than the largest diameter, %g: neighbours would overlap",
                      source->spacing, 2 * largest);
}

static bool check_random(const struct scene *scene, const struct source_options *source, const char *section,
                         struct error *error) {
    char key[96];
    snprintf(key, sizeof(key), "%s.volume_fraction", section);
    if (source->count > 0 && source->volume_fraction > 0)
        return scene_fail(scene, error, key, "beside count; %s", one_of_two);
    double limit = scene->box.dimension == 2 ? 0.547 : 0.382, solid = source_form_solid(&source->form);
    if (source->sizes.law == SIZES_FIXED && source->volume_fraction > limit * solid) {
        char balls[64] = "";
        if (source->form.shape > 0)
            snprintf(balls, sizeof(balls), " (balls around bodies, which fill %.3g of them)", solid);
        return scene_fail(
            scene, error, key,
            "%g: equal %s placed at random%s end at %g of the %s; from: packed, or a lattice, is "
            "denser",
            source->volume_fraction, scene->box.dimension == 2 ? "discs" : "spheres", balls, limit * solid,
            scene->box.dimension == 2 ? "area" : "volume");
    }
    snprintf(key, sizeof(key), "%s.count", section);
    return source->count > 0 || source->volume_fraction > 0 ||
           scene_fail(scene, error, key, "is missing; give count or volume_fraction");
}

static bool check_packed(const struct scene *scene, const struct source_options *source, const char *section,
                         struct error *error) {
    char key[96];
    double smallest, largest;
    snprintf(key, sizeof(key), "%s.volume_fraction", section);
    if (source->count > 0 && source->volume_fraction > 0)
        return scene_fail(
            scene, error, key,
            "beside count and a box: of count, volume_fraction and the size two decide the third; %s",
            one_of_two);
    snprintf(key, sizeof(key), "%s.count", section);
    if (source->count == 0 && source->volume_fraction == 0)
        return scene_fail(scene, error, key, "is missing; give count or volume_fraction");
    sizes_bounds(&source->sizes, &smallest, &largest);
    snprintf(key, sizeof(key), "%s.sizes", section);
    return largest <= PACKED_RATIO_MAX * smallest ||
           scene_fail(scene, error, key, "the largest size is more than %d times the smallest",
                      PACKED_RATIO_MAX);
}

/* A spin needs a law that knows one. */
static bool check_spin(const struct scene *scene, const double omega[3], const char *section,
                       struct error *error) {
    char key[96];
    snprintf(key, sizeof(key), "%s.omega", section);
    if (scene->law.tangential != LAW_FRICTIONLESS || (omega[0] == 0 && omega[1] == 0 && omega[2] == 0))
        return true;
    return scene_fail(scene, error, key, "a spin without friction has no meaning (contact.tangential: none)");
}

static bool check_file(const struct scene *scene, const struct source_options *source, const char *section,
                       struct error *error) {
    char key[96];
    snprintf(key, sizeof(key), "%s.radius_upto", section);
    if (!(source->radius_upto > source->radius_above))
        return scene_fail(scene, error, key, "%g is not above radius_above (%g)", source->radius_upto,
                          source->radius_above);
    snprintf(key, sizeof(key), "%s.material", section);
    return source->material < 0 || source->type_count == 0 ||
           scene_fail(scene, error, key, "beside types; %s", one_of_two);
}

/* A temperature of a source or an insertion, NAN: none. */
static bool check_temperature(const struct scene *scene, double temperature, const char *section,
                              struct error *error) {
    char key[80];
    snprintf(key, sizeof(key), "%s.temperature", section);
    return isnan(temperature) || scene->physics_given[PHYSICS_heat] ||
           scene_fail(scene, error, key, "needs the section heat: without it grains have no temperature");
}

static bool check_sources(const struct scene *scene, struct error *error) {
    bool others = false;
    for (int k = 0; k < PHYSICS_COUNT; k++)
        others = others || (scene->physics_given[k] && physics_has_particles(k));
    if (scene->sources == 0 && scene->insertions == 0 && !others)
        return scene_fail(scene, error, "particles",
                          "is missing; needed: a file or a generator (or insertions)");
    for (int s = 0; s < scene->sources; s++) {
        const struct source_options *source = &scene->source[s];
        char section[64];
        snprintf(section, sizeof(section), "particles.sources[%d]", s);
        bool generated =
            source->kind == SOURCE_LATTICE || source->kind == SOURCE_RANDOM || source->kind == SOURCE_PACKED;
        if (generated && (!check_room(scene, &source->region, section, error) ||
                          !check_sizes(scene, &source->sizes, section, error)))
            return false;
        if ((source->kind == SOURCE_LATTICE && !check_lattice(scene, source, section, error)) ||
            (source->kind == SOURCE_RANDOM && !check_random(scene, source, section, error)) ||
            (source->kind == SOURCE_PACKED && !check_packed(scene, source, section, error)) ||
            (source->kind == SOURCE_FILE && !check_file(scene, source, section, error)) ||
            !check_spin(scene, source->omega, section, error) ||
            !check_temperature(scene, source->temperature, section, error))
            return false;
    }
    return true;
}

static bool check_insertions(const struct scene *scene, struct error *error) {
    for (int k = 0; k < scene->insertions; k++) {
        const struct insertion_options *insertion = &scene->insertion[k];
        char section[64], key[80];
        snprintf(section, sizeof(section), "insertions[%d]", k);
        snprintf(key, sizeof(key), "insertions[%d].rate", k);
        if (insertion->rate > 0 && insertion->mass_rate > 0)
            return scene_fail(scene, error, key, "beside mass_rate; %s", one_of_two);
        if (!(insertion->rate > 0) && !(insertion->mass_rate > 0))
            return scene_fail(scene, error, key, "give one of rate and mass_rate");
        snprintf(key, sizeof(key), "insertions[%d].stop", k);
        if (!(insertion->stop > insertion->start))
            return scene_fail(scene, error, key, "%g is not after start (%g)", insertion->stop,
                              insertion->start);
        if (!check_room(scene, &insertion->region, section, error) ||
            !check_sizes(scene, &insertion->sizes, section, error) ||
            !check_temperature(scene, insertion->temperature, section, error) ||
            !check_spin(scene, insertion->omega, section, error))
            return false;
    }
    for (int k = 0; k < scene->deletions; k++) {
        const struct deletion_options *deletion = &scene->deletion[k];
        char section[64], key[80];
        snprintf(section, sizeof(section), "deletions[%d]", k);
        snprintf(key, sizeof(key), "deletions[%d].stop", k);
        if (!(deletion->stop > deletion->start))
            return scene_fail(scene, error, key, "%g is not after start (%g)", deletion->stop,
                              deletion->start);
        if (!check_region(scene, &deletion->region, section, error))
            return false;
    }
    return true;
}

/* A group that neither selects nor is named by a source stays empty. */
static bool check_groups(const struct scene *scene, struct error *error) {
    for (int g = 1; g < scene->groups; g++) {
        char section[64], key[80];
        bool named = scene->group[g].selects;
        for (int s = 0; s < scene->sources; s++)
            named = named || scene->source[s].group == g;
        for (int k = 0; k < scene->insertions; k++)
            named = named || scene->insertion[k].group == g;
        snprintf(key, sizeof(key), "groups[%d].select", g - 1);
        if (!named)
            return scene_fail(scene, error, key, "the group '%s' selects nothing, and no source names it",
                              scene->group[g].name);
        if (!(scene->group[g].radius_upto > scene->group[g].radius_above))
            return scene_fail(scene, error, key, "no radius lies above %g and up to %g",
                              scene->group[g].radius_above, scene->group[g].radius_upto);
        snprintf(section, sizeof(section), "groups[%d].select", g - 1);
        if (!check_region(scene, &scene->group[g].region, section, error))
            return false;
        snprintf(section, sizeof(section), "groups[%d]", g - 1);
        if (!check_spin(scene, scene->group[g].omega, section, error))
            return false;
    }
    return true;
}

static bool check_step(const struct scene *scene, struct error *error) {
    if (scene->step.dt > 0 && scene->step.fraction > 0)
        return scene_fail(scene, error, "step.fraction", "beside step.dt; %s", one_of_two);
    if (scene->stages > 0 && (scene->duration >= 0 || scene->step.count >= 0))
        return scene_fail(scene, error, scene->duration >= 0 ? "duration" : "step.count",
                          "the scene has stages, which have durations of their own; take it out (--set %s=~)",
                          scene->duration >= 0 ? "duration" : "step.count");
    return scene->duration >= 0 || scene->step.count >= 0 || scene->stages > 0 ||
           scene_fail(scene, error, "duration", "is missing; give duration or step.count");
}

static bool check_law(const struct scene *scene, struct error *error) {
    if (law_has_trait(scene->law.normal, "stiff") && !scene->law.solved)
        return scene_fail(scene, error, "contact.law", "%s needs contact.solver, which finds its forces",
                          law_row_get(scene->law.normal)->name);
    if (scene->law.tangential_damping_equal && scene->law.tangential_damping_ratio != 1)
        return scene_fail(scene, error, "contact.tangential_damping_equal",
                          "beside tangential_damping_ratio; %s", one_of_two);
    if (scene->law.lammps_history && !law_damping_form_of(scene->law.damping)->given)
        return scene_fail(scene, error, "contact.lammps_history", "needs contact.damping: coefficient");
    if (scene->law.lammps_history && scene->law.end != LAW_END_OVERLAP)
        return scene_fail(scene, error, "contact.end",
                          "lammps_history goes with end: overlap, which it takes by itself");
    if (scene->law.lammps_granular && scene->law.end != LAW_END_OVERLAP)
        return scene_fail(scene, error, "contact.end",
                          "lammps_granular goes with end: overlap, which it takes by itself");
    if (scene->law.lammps_history && scene->law.rolling != LAW_ROLLING_NONE)
        return scene_fail(scene, error, "contact.lammps_history", "has no rolling resistance");
    return true;
}

static bool check_search(const struct scene *scene, struct error *error) {
    if (scene->ghosts.reduced && !scene->ghosts.newton)
        return scene_fail(scene, error, "ghosts",
                          "reduced needs newton: on (with newton: off the owner of a large particle needs "
                          "the small ones too)");
    for (int k = 1; scene->classes.method == CLASSES_CUTS && k < scene->classes.cut_count; k++)
        if (!(scene->classes.cut[k] > scene->classes.cut[k - 1]))
            return scene_fail(scene, error, "classes.cuts", "must increase: %g after %g",
                              scene->classes.cut[k], scene->classes.cut[k - 1]);
    if (scene->index.level_cells > 0 && scene->index.params.levels > 0 &&
        scene->index.level_cells != scene->index.params.levels)
        return scene_fail(scene, error, "index.level_cells", "%d cell sizes for %d levels",
                          scene->index.level_cells, scene->index.params.levels);
    return true;
}

bool scene_check(const struct scene *scene, struct error *error) {
    static bool (*const checks[])(const struct scene *scene, struct error *error) = {
        check_law,    scene_check_box, check_step,       check_plane,        scene_check_walls, check_search,
        check_groups, check_sources,   check_insertions, scene_check_output, scene_stages_check};
    for (size_t k = 0; k < sizeof(checks) / sizeof(checks[0]); k++) {
        struct error found = {0};
        if (!checks[k](scene, &found))
            mistakes_add(error, found.text);
    }
    return error->kind == ERROR_NONE;
}
