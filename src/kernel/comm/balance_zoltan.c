/* SPDX-License-Identifier: BSD-3-Clause */
/* The division by load, by Zoltan's recursive coordinate bisection. Read balance.h first. */
#include "kernel/comm/balance.h"

#include "kernel/comm/domain_tree.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <zoltan.h>

bool balance_available(struct error *error) {
    (void)error;
    return true;
}

/* The data from which Zoltan's callbacks are answered. */
struct answers {
    const struct balance_load *load;
    int dimension;
};

static int answer_count(void *data, int *code) {
    const struct answers *answers = data;
    *code = ZOLTAN_OK;
    return (int)answers->load->count;
}

static void answer_list(void *data, int global_size, int local_size, ZOLTAN_ID_PTR global,
                        ZOLTAN_ID_PTR local, int weights, float *weight, int *code) {
    const struct answers *answers = data;
    (void)global_size, (void)local_size, (void)weights;
    for (size_t k = 0; k < answers->load->count; k++) {
        global[k] = local[k] = (ZOLTAN_ID_TYPE)k;
        weight[k] = (float)answers->load->weight[k];
    }
    *code = ZOLTAN_OK;
}

static int answer_dimension(void *data, int *code) {
    const struct answers *answers = data;
    *code = ZOLTAN_OK;
    return answers->dimension;
}

static void answer_positions(void *data, int global_size, int local_size, int count, ZOLTAN_ID_PTR global,
                             ZOLTAN_ID_PTR local, int dimension, double *x, int *code) {
    const struct answers *answers = data;
    (void)global_size, (void)local_size, (void)global;
    for (int k = 0; k < count; k++)
        for (int d = 0; d < dimension; d++)
            x[(size_t)k * (size_t)dimension + (size_t)d] = answers->load->x[local[k]][d];
    *code = ZOLTAN_OK;
}

static void expect(int code, const char *call) {
    if (code != ZOLTAN_OK && code != ZOLTAN_WARN)
        error_fatal("%s failed with code %d", call, code);
}

static struct Zoltan_Struct *partitioner(const struct comm *comm, struct answers *answers) {
    static const char *const parameters[][2] = {
        {"DEBUG_LEVEL", "0"},       {"LB_METHOD", "RCB"},     {"KEEP_CUTS", "1"},
        {"RETURN_LISTS", "NONE"},   {"OBJ_WEIGHT_DIM", "1"},  {"RCB_OUTPUT_LEVEL", "0"},
        {"IMBALANCE_TOL", "1.02"},  {"NUM_GID_ENTRIES", "1"}, {"AVERAGE_CUTS", "1"},
        {"RCB_RECOMPUTE_BOX", "1"}, {"CHECK_GEOM", "0"},
    };
    float version;
    expect(Zoltan_Initialize(0, NULL, &version), "Zoltan_Initialize");
    struct Zoltan_Struct *zoltan = Zoltan_Create(comm->handle);
    if (zoltan == NULL)
        error_fatal("Zoltan_Create failed");
    for (size_t k = 0; k < sizeof parameters / sizeof parameters[0]; k++)
        expect(Zoltan_Set_Param(zoltan, parameters[k][0], parameters[k][1]), parameters[k][0]);
    Zoltan_Set_Num_Obj_Fn(zoltan, answer_count, answers);
    Zoltan_Set_Obj_List_Fn(zoltan, answer_list, answers);
    Zoltan_Set_Num_Geom_Fn(zoltan, answer_dimension, answers);
    Zoltan_Set_Geom_Multi_Fn(zoltan, answer_positions, answers);
    return zoltan;
}

static void partition(struct Zoltan_Struct *zoltan) {
    int changes, global_size, local_size, imports, exports, *import_rank, *import_part, *export_rank,
        *export_part;
    ZOLTAN_ID_PTR import_global, import_local, export_global, export_local;
    expect(Zoltan_LB_Partition(zoltan, &changes, &global_size, &local_size, &imports, &import_global,
                               &import_local, &import_rank, &import_part, &exports, &export_global,
                               &export_local, &export_rank, &export_part),
           "Zoltan_LB_Partition");
    Zoltan_LB_Free_Part(&import_global, &import_local, &import_rank, &import_part);
    Zoltan_LB_Free_Part(&export_global, &export_local, &export_rank, &export_part);
}

/* The region that is divided: the box, and beyond the open sides of the box the particles that left it. */
struct extent {
    double lower[3], upper[3];
};

static struct extent extent_of(const struct comm *comm, const struct box *box,
                               const struct balance_load *load) {
    struct extent extent = {.upper = {box->edge[0], box->edge[1], box->edge[2]}};
    for (size_t k = 0; k < load->count; k++)
        for (int d = 0; d < 3; d++) {
            extent.lower[d] = fmin(extent.lower[d], load->x[k][d]);
            extent.upper[d] = fmax(extent.upper[d], load->x[k][d]);
        }
    comm_min(comm, extent.lower, 3);
    comm_max(comm, extent.upper, 3);
    return extent;
}

/* The tree of cuts, from the corners of all parts. NULL if the parts do not form a tree: Zoltan gives parts
 * without particles arbitrary corners, also far outside. */
static struct domain_tree *tree_of(struct Zoltan_Struct *zoltan, const struct extent *extent, int ranks,
                                   int dimension) {
    double(*lower)[3] = memory_allocate_zero((size_t)ranks, sizeof *lower, "subdomains");
    double(*upper)[3] = memory_allocate_zero((size_t)ranks, sizeof *upper, "subdomains");
    for (int k = 0; k < ranks; k++) {
        int given = dimension;
        expect(Zoltan_RCB_Box(zoltan, k, &given, &lower[k][0], &lower[k][1], &lower[k][2], &upper[k][0],
                              &upper[k][1], &upper[k][2]),
               "Zoltan_RCB_Box");
        for (int d = 0; d < dimension; d++) {
            lower[k][d] = fmin(fmax(lower[k][d], extent->lower[d]), extent->upper[d]);
            upper[k][d] = fmin(fmax(upper[k][d], extent->lower[d]), extent->upper[d]);
        }
    }
    struct domain_tree *tree =
        domain_tree_from_bounds(ranks, dimension, (const double(*)[3])lower, (const double(*)[3])upper);
    memory_free(lower);
    memory_free(upper);
    return tree;
}

bool balance_divide(struct domain *domain, const struct comm *comm, const struct box *box,
                    const struct balance_load *load) {
    struct answers answers = {load, box->dimension};
    int64_t particles = (int64_t)load->count;
    comm_sum_int(comm, &particles, 1);
    if (particles < comm->size)
        return false;
    struct extent extent = extent_of(comm, box, load);
    struct Zoltan_Struct *zoltan = partitioner(comm, &answers);
    partition(zoltan);
    struct domain_tree *tree = tree_of(zoltan, &extent, comm->size, box->dimension);
    Zoltan_Destroy(&zoltan);
    if (tree)
        domain_divide(domain, tree);
    return tree != NULL;
}
