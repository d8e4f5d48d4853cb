/* SPDX-License-Identifier: BSD-3-Clause */
/* Requests become items (one kind, one target), items have parts (numbers that ranks sum or compare) and
 * columns (values in the file). Computing and writing rows: observables_row.c. */
#include "data/observe/observables.h"

#include "base/memory.h"
#include "data/observe/crossing.h"
#include "data/observe/observables_kinds.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

/* Adds a comma and a name to a list of allowed names. */
static void list_name(char *list, size_t size, const char *name) {
    size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s", used ? ", " : "", name);
}

static bool refuse_name(const char *name, struct error *error) {
    char known[ERROR_TEXT_MAX / 2] = "";
    for (int k = 0; k < observables_kinds_count(); k++) {
        const struct observable_info *info = observables_get(k);
        bool new_family =
            info->family[0] && (k == 0 || strcmp(observables_get(k - 1)->family, info->family) != 0);
        if (new_family)
            list_name(known, sizeof known, info->family);
        list_name(known, sizeof known, info->name);
    }
    return error_set(error, ERROR_USER, "observables: there is no \"%s\"; there are: %s", name, known);
}

/* Adds the columns of an item: STEM, then the component. */
static void add_columns(struct observables *o, const struct observable_item *item, const char *stem) {
    static const char *const vector[] = {"x", "y", "z"}, *const tensor[] = {"xx", "yy", "zz",
                                                                            "xy", "xz", "yz"};
    const struct observable_kind *kind = observables_kind(item->kind);
    for (int c = 0; c < kind->info.components; c++) {
        if (!(item->components & 1u << c))
            continue;
        if (o->columns == o->column_room) {
            o->column_room = o->column_room ? 2 * o->column_room : 32;
            o->column = memory_resize(o->column, (size_t)o->column_room, sizeof *o->column, "observables");
        }
        struct observable_column *column = &o->column[o->columns++];
        const struct observable_component *own = kind->component ? &kind->component[c] : NULL;
        const char *unit = own && own->unit ? own->unit : kind->info.unit,
                   *flat = own && own->unit ? own->unit_flat : kind->info.unit_flat;
        column->unit = o->dimensionless ? "1" : o->flat && flat ? flat : unit;
        const char *end = own                          ? own->name
                          : kind->info.components == 1 ? ""
                          : kind->info.components == 3 ? vector[c]
                                                       : tensor[c];
        const char *symbol = kind->symbol ? kind->symbol : "";
        snprintf(column->name, sizeof column->name, "%.*s%s%s%s", OBSERVABLE_COLUMN_MAX - 24, stem,
                 end[0] ? "_" : "", symbol, end);
    }
}

static void add_item(struct observables *o, struct observable_item item, const char *stem) {
    const struct observable_kind *kind = observables_kind(item.kind);
    unsigned all = (1u << kind->info.components) - 1;
    item.components = item.components ? item.components & all : all;
    if (kind->info.components != 3)
        item.components = all;
    item.first_part = o->parts;
    item.first_column = o->columns;
    o->parts += kind->parts;
    bool listed = kind->needs_contacts && item.region;
    o->needs_contacts = o->needs_contacts || listed || kind->lists_contacts;
    o->needs_sums = o->needs_sums || (kind->needs_sums && !listed);
    o->needs_work = o->needs_work || kind->needs_work;
    add_columns(o, &item, stem);
    if (o->items == o->item_room) {
        o->item_room = o->item_room ? 2 * o->item_room : 16;
        o->item = memory_resize(o->item, (size_t)o->item_room, sizeof *o->item, "observables");
    }
    o->item[o->items++] = item;
}

/* Data for resolving a request. */
struct resolving {
    struct observables *o;
    const struct output_view *view;
    const struct output_run *run;
};

/* Refuses a target that names nothing, and a label that would name several; `known`: what a target may name. */
static bool check_found(const struct observable_request *request, int found, const char *what,
                        const char *target, const char *known, struct error *error) {
    if (found == 0)
        return error_set(error, ERROR_USER, "observables: %s: there is no %s \"%s\"; there are: %s",
                         request->name, what, target, known[0] ? known : "none");
    return found == 1 || !request->label[0] ||
           error_set(error, ERROR_USER,
                     "observables: %s: the label \"%s\" would name each of %s; give a target", request->name,
                     request->label, known);
}

static bool add_walls(struct resolving *r, const struct observable_request *request,
                      struct observable_item item, struct error *error) {
    char known[512] = "";
    int count = r->view->walls ? walls_count(r->view->walls) : 0, found = 0;
    for (int w = 0; w < count; w++) {
        const char *name = walls_options(r->view->walls, w)->name;
        list_name(known, sizeof known, name);
        if (request->target[0] && strcmp(request->target, name) != 0)
            continue;
        item.wall = w;
        add_item(r->o, item, request->label[0] ? request->label : name);
        found++;
    }
    return (found == 0 && !request->target[0]) ||
           check_found(request, found, "wall", request->target, known, error);
}

/* Adds the item of a body, if the request is for it; lists its name. */
static int add_body(struct resolving *r, const struct observable_request *request,
                    struct observable_item item, const char *name, char known[512]) {
    char stem[OBSERVABLE_COLUMN_MAX];
    list_name(known, 512, name);
    if (request->target[0] && strcmp(request->target, name) != 0)
        return 0;
    snprintf(stem, sizeof stem, "%s_%s", observables_get(item.kind)->name, name);
    add_item(r->o, item, request->label[0] ? request->label : stem);
    return 1;
}

/* Walls, and groups but the one of free grains, which is the first. */
static bool add_bodies(struct resolving *r, const struct observable_request *request,
                       struct observable_item item, struct error *error) {
    char known[512] = "";
    int walls = r->view->walls ? walls_count(r->view->walls) : 0, found = 0;
    for (item.wall = 0, item.group = -1; item.wall < walls; item.wall++)
        found += add_body(r, request, item, walls_options(r->view->walls, item.wall)->name, known);
    for (item.wall = -1, item.group = 1; item.group < r->run->groups; item.group++)
        found += add_body(r, request, item, r->run->group[item.group], known);
    return (found == 0 && !request->target[0]) ||
           check_found(request, found, "wall or group", request->target, known, error);
}

static bool find_material(const struct resolving *r, const char *name, int *material, struct error *error) {
    char known[512] = "";
    for (int m = 0; m < r->run->materials; m++) {
        list_name(known, sizeof known, r->run->material[m].name);
        if (strcmp(r->run->material[m].name, name) == 0) {
            *material = m;
            return true;
        }
    }
    return error_set(error, ERROR_USER, "observables: there is no material \"%s\"; there are: %s", name,
                     known);
}

static bool add_regions(struct resolving *r, const struct observable_request *request,
                        struct observable_item item, struct error *error) {
    char region[OUTPUT_NAME_MAX], known[512] = "", stem[OBSERVABLE_COLUMN_MAX];
    snprintf(region, sizeof region, "%s", request->target);
    char *slash = strchr(region, '/');
    if (slash) {
        *slash = '\0';
        if (!find_material(r, slash + 1, &item.material, error))
            return false;
    }
    int found = 0;
    for (int k = 0; k < r->o->regions; k++) {
        const char *name = r->o->region[k].name;
        list_name(known, sizeof known, name);
        if (region[0] && strcmp(region, name) != 0)
            continue;
        item.region = &r->o->region[k];
        const struct observable_kind *kind = observables_kind(item.kind);
        if (kind->check && !kind->check(r->view, item.region, error))
            return false;
        snprintf(stem, sizeof stem, "%s_%s%s%s", observables_get(item.kind)->name, name, slash ? "_" : "",
                 slash ? slash + 1 : "");
        add_item(r->o, item, request->label[0] ? request->label : stem);
        found++;
    }
    return check_found(request, found, "region", region, known, error);
}

static bool add_planes(struct resolving *r, const struct observable_request *request,
                       struct observable_item item, struct error *error) {
    char known[512] = "", stem[OBSERVABLE_COLUMN_MAX];
    int found = 0;
    item.planes = r->o->plane;
    for (item.plane = 0; item.plane < r->o->planes; item.plane++) {
        const struct output_plane *plane = &r->o->plane[item.plane];
        list_name(known, sizeof known, plane->name);
        if (request->target[0] && strcmp(request->target, plane->name) != 0)
            continue;
        if (!crossing_check(r->view->box, plane, error))
            return false;
        snprintf(stem, sizeof stem, "%s_%s", observables_get(item.kind)->name, plane->name);
        add_item(r->o, item, request->label[0] ? request->label : stem);
        found++;
    }
    return check_found(request, found, "plane", request->target, known, error);
}

static bool add_expression(struct resolving *r, const struct observable_request *request,
                           struct observable_item item, struct error *error) {
    if (!observables_expression_make(&item.expression, request, r->view, error)) {
        observables_expression_free(&item.expression);
        return false;
    }
    add_item(r->o, item, request->label[0] ? request->label : observables_get(item.kind)->name);
    if (request->unit[0] && !r->o->dimensionless && r->o->units_given < OUTPUT_REQUESTS_MAX) {
        char *unit = r->o->units[r->o->units_given++];
        snprintf(unit, OUTPUT_NAME_MAX, "%s", request->unit);
        r->o->column[r->o->columns - 1].unit = unit;
    }
    return true;
}

static bool add_particle(struct resolving *r, const struct observable_request *request,
                         struct observable_item item, struct error *error) {
    if (request->id < 1)
        return error_set(error, ERROR_USER, "observables: %s: wants the id of a particle (1 or more)",
                         request->name);
    char stem[OUTPUT_NAME_MAX];
    snprintf(stem, sizeof stem, "particle%" PRId64, request->id);
    add_item(r->o, item, request->label[0] ? request->label : stem);
    return true;
}

/* Refuses expressions of observables that have none. */
static bool takes_expressions(const struct observable_request *request, const struct observable_info *info,
                              struct error *error) {
    return info->target == OBSERVABLE_OF_EXPRESSION || (!request->of[0] && !request->where[0]) ||
           error_set(
               error, ERROR_USER,
               "observables: %s: takes neither `of` nor `where`; sum, mean, largest, least and lacey do",
               request->name);
}

static bool add_kind(struct resolving *r, const struct observable_request *request, int kind,
                     struct error *error) {
    const struct observable_info *info = observables_get(kind);
    struct observable_item item = {
        .kind = kind, .components = request->components, .material = -1, .group = -1, .id = request->id};
    bool whole_family = strcmp(request->name, info->name) != 0;
    if (!takes_expressions(request, info, error))
        return false;
    switch (info->target) {
    case OBSERVABLE_OF_WALL:
        return add_walls(r, request, item, error);
    case OBSERVABLE_OF_REGION:
        return add_regions(r, request, item, error);
    case OBSERVABLE_OF_EXPRESSION:
        return add_expression(r, request, item, error);
    case OBSERVABLE_OF_PLANE:
        return add_planes(r, request, item, error);
    case OBSERVABLE_OF_BODY:
        return add_bodies(r, request, item, error);
    case OBSERVABLE_OF_PARTICLE:
        return add_particle(r, request, item, error);
    case OBSERVABLE_OF_ALL_OR_REGION:
        if (request->target[0])
            return add_regions(r, request, item, error);
        break;
    default:
        break;
    }
    if (request->target[0])
        return error_set(error, ERROR_USER,
                         "observables: %s: is of the whole run and takes no target (\"%s\")", request->name,
                         request->target);
    add_item(r->o, item, request->label[0] && !whole_family ? request->label : info->name);
    return true;
}

/* The request with its target: a name "drag/bed" is the name "drag" and the target "bed". */
static struct observable_request divide_name(const struct observable_request *request) {
    struct observable_request divided = *request;
    char *slash = strchr(divided.name, '/');
    if (slash) {
        snprintf(divided.target, sizeof divided.target, "%s", slash + 1);
        *slash = '\0';
    }
    return divided;
}

static bool add_request(struct resolving *r, const struct observable_request *given, struct error *error) {
    const struct observable_request divided = divide_name(given), *request = &divided;
    bool found = false;
    if (given->target[0] && strcmp(given->target, divided.target) != 0)
        return error_set(error, ERROR_USER,
                         "observables: %s: has the target \"%s\" already, and another, \"%s\"", given->name,
                         divided.target, given->target);
    for (int k = 0; k < observables_kinds_count(); k++) {
        const struct observable_kind *kind = observables_kind(k);
        bool named = strcmp(kind->info.name, request->name) == 0;
        bool family = kind->info.family[0] && strcmp(kind->info.family, request->name) == 0;
        found = found || named || family;
        if ((named || (family && (!kind->relevant || kind->relevant(r->view)))) &&
            !add_kind(r, request, k, error))
            return false;
    }
    return found || refuse_name(request->name, error);
}

/* Column names are also names of groups in the trajectory, so the same limit of length holds. */
static bool check_columns(const struct observables *o, struct error *error) {
    for (int c = 0; c < o->columns; c++)
        if (strlen(o->column[c].name) >= OUTPUT_NAME_MAX)
            return error_set(error, ERROR_USER,
                             "observables: a column would be called \"%s\", longer than %d characters; give "
                             "it a label that is shorter",
                             o->column[c].name, OUTPUT_NAME_MAX - 1);
    return true;
}

/* Refuses a column of the newest request whose name an earlier column has. `end`: the number of columns after each
 * request; `number`: of the newest. */
static bool check_names(const struct observables *o, const int *end, int number, struct error *error) {
    for (int a = number > 0 ? end[number - 1] : 0; a < o->columns; a++)
        for (int b = 0; b < a; b++) {
            int first = 0;
            if (strcmp(o->column[a].name, o->column[b].name) != 0)
                continue;
            while (end[first] <= b)
                first++;
            if (first == number)
                return error_set(error, ERROR_USER,
                                 "observables: list[%d] has two columns that would be called \"%s\"", number,
                                 o->column[a].name);
            return error_set(error, ERROR_USER,
                             "observables: a column of list[%d] would be called \"%s\", as one of list[%d] "
                             "is; give one of "
                             "them another label",
                             number, o->column[a].name, first);
        }
    return true;
}

bool observables_create(struct observables **observables, const struct observables_options *options,
                        const struct output_view *view, const struct output_run *run, struct error *error) {
    static const struct observable_request by_default[] = {
        {.name = "energy"}, {.name = "momentum"}, {.name = "contacts"}};
    struct observables *o = memory_allocate_zero(1, sizeof *o, "observables");
    *observables = o;
    o->dimensionless = run->dimensionless;
    o->flat = view->box->dimension == 2;
    o->regions = options->regions;
    o->last_time = -INFINITY;
    memcpy(o->region, options->region, sizeof o->region);
    o->planes = options->planes;
    memcpy(o->plane, options->plane, sizeof o->plane);
    struct resolving r = {.o = o, .view = view, .run = run};
    int count = options->count ? options->count : (int)(sizeof by_default / sizeof by_default[0]);
    bool good = true;
    int *end = memory_allocate((size_t)count, sizeof *end, "observables");
    for (int k = 0; good && k < count; k++) {
        good = add_request(&r, options->count ? &options->request[k] : &by_default[k], error);
        end[k] = o->columns;
        good = good && check_names(o, end, k, error);
    }
    memory_free(end);
    if (!good || !check_columns(o, error)) {
        observables_destroy(observables);
        return false;
    }
    size_t columns = (size_t)o->columns;
    o->value = memory_allocate_zero(columns, sizeof *o->value, "observables");
    o->name = memory_allocate(columns, sizeof *o->name, "observables");
    o->unit = memory_allocate(columns, sizeof *o->unit, "observables");
    for (int c = 0; c < o->columns; c++) {
        o->name[c] = o->column[c].name;
        o->unit[c] = o->column[c].unit;
    }
    o->wall_force = memory_allocate_zero(WALLS_MAX, sizeof *o->wall_force, "wall forces");
    return true;
}

void observables_destroy(struct observables **observables) {
    struct observables *o = *observables;
    if (!o)
        return;
    if (o->file)
        fclose(o->file);
    for (int k = 0; k < o->items; k++)
        observables_expression_free(&o->item[k].expression);
    memory_free(o->item);
    memory_free(o->column);
    memory_free(o->value);
    memory_free(o->name);
    memory_free(o->unit);
    memory_free(o->wall_force);
    memory_free(o);
    *observables = NULL;
}
