/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of a step: passes of physics without an interaction, and of those whose list is not that of grains. */
#include "tests/test.h"

#include "engine/plan.h"
#include "engine/stages.h"
#include "engine/physics_set.h"

#include <math.h>
#include <string.h>

enum { ROWS = 10, BLOCKS = 4 };

/* Counts of a physics' calls. */
struct calls {
    size_t rows;
    int blocks;
};

/* The squared speed is the number of rows. */
static double count_rows(const struct physics_context *context, int thread, size_t first, size_t last,
                         int size_class) {
    (void)thread, (void)size_class;
    ((struct calls *)context->self)->rows += last - first;
    return (double)(last - first);
}

static void count_blocks(const struct physics_context *context, int thread, int block) {
    (void)thread, (void)block;
    ((struct calls *)context->self)->blocks++;
}

static void no_run(struct simulation *simulation) {
    (void)simulation;
}

static bool not_needed(const struct physics_context *context) {
    (void)context;
    return false;
}

static const struct physics_pass grains_passes[] = {
    {.name = "move", .place = PASS_MOVE, .rows = count_rows},
    {.name = "touch", .place = PASS_PAIRS, .block = count_blocks}};
static const struct physics_pass no_contacts[] = {
    {.name = "move", .place = PASS_MOVE, .rows = count_rows},
    {.name = "touch", .place = PASS_PAIRS, .needed = not_needed, .block = count_blocks}};
static const struct physics_pass age_passes[] = {{.name = "age", .place = PASS_MOVE, .rows = count_rows}};
static const struct physics_pass far_passes[] = {{.name = "far", .place = PASS_PAIRS, .block = count_blocks}};

static const struct physics_search one = {.interactions = 1};
static const struct physics grains = {.search = &one, .passes = 2, .pass = grains_passes},
                            untouched = {.search = &one, .passes = 2, .pass = no_contacts},
                            age = {.passes = 1, .pass = age_passes},
                            far = {.search = &one, .passes = 1, .pass = far_passes};

/* stages.c asks for the physics of a scene; the test has its own. */
const struct physics *physics_get(enum physics_number number) {
    (void)number;
    return &age;
}

/* A list of one thread with two blocks of rows, and those of mirrored pairs and of copies. */
struct two_lists {
    struct pair_block block[BLOCKS];
    int thread_block[2];
    struct pairlist grains, far;
    double speed[1][CLASS_MAX];
};

static void lists_fill(struct two_lists *lists) {
    *lists = (struct two_lists){.block = {{.first_row = 0, .last_row = 7, .kind = PAIR_BLOCK_ROWS},
                                          {.first_row = 7, .last_row = ROWS, .kind = PAIR_BLOCK_ROWS},
                                          {.kind = PAIR_BLOCK_MIRROR},
                                          {.kind = PAIR_BLOCK_GHOST}},
                                .thread_block = {0, BLOCKS}};
    lists->grains = (struct pairlist){
        .blocks = lists->block, .block_count = BLOCKS, .threads = 1, .thread_block = lists->thread_block};
    lists->far = lists->grains;
}

static void make(struct step_plan *plan, struct physics_set *set, struct timers *timers,
                 const struct physics *first, struct two_lists *lists, struct calls calls[3]) {
    static const struct engine_pass none[] = {{0}};
    static const struct engine_passes engine = {.renew = none};
    const struct physics *rows[] = {first, &age, &far};
    lists_fill(lists);
    memset(calls, 0, 3 * sizeof *calls);
    *timers = (struct timers){0};
    *set = (struct physics_set){.count = 3, .speed = lists->speed};
    for (int k = 0; k < 3; k++)
        set->active[k] =
            (struct physics_active){.row = rows[k], .context = {.self = &calls[k], .threads = 1}};
    set->active[0].context.list[0] = &lists->grains;
    set->active[2].context.list[0] = &lists->far;
    stages_register(timers, rows, 3);
    plan_make(plan, set, &engine, timers, 0);
}

static bool holds(const struct plan *plan, const char *name) {
    bool found = false;
    for (int p = 0; p < plan->passes; p++)
        found = found || strcmp(plan->pass[p].name, name) == 0;
    return found;
}

static void rows_need_no_interaction(void **state) {
    (void)state;
    struct step_plan plan;
    struct physics_set set;
    struct timers timers;
    struct two_lists lists;
    struct calls calls[3];
    make(&plan, &set, &timers, &grains, &lists, calls);
    plan_run(&plan.plain, 0, &timers, NULL);
    assert_int_equal(calls[0].rows, ROWS);
    assert_int_equal(calls[1].rows, ROWS);
    assert_true(lists.speed[0][0] == fmax(7, ROWS - 7));
    assert_int_equal(calls[0].blocks, BLOCKS);
    assert_int_equal(calls[2].blocks, BLOCKS);
    assert_int_equal(plan.moves.count, 2);
}

/* The sweep moves particles before the first pair of grains that reads them, and of no other list. */
static void other_lists_run_after_the_sweep(void **state) {
    (void)state;
    const struct physics *const first[] = {&grains, &untouched};
    for (int k = 0; k < 2; k++) {
        struct step_plan plan;
        struct physics_set set;
        struct timers timers;
        struct two_lists lists;
        struct calls calls[3];
        make(&plan, &set, &timers, first[k], &lists, calls);
        assert_int_equal(plan.pairs.count, 1 - k);
        assert_true(holds(&plan.fused, "far") && !holds(&plan.fused, "touch"));
        assert_int_equal(holds(&plan.plain, "touch"), 1 - k);
    }
}

/* Both orders end with the same passes; a step that computes forces alone runs those from the sums over pairs on. */
static void forces_begin_at_the_pairs(void **state) {
    (void)state;
    static const struct engine_pass renew[] = {{"renew", NULL, "decide", 0, no_run},
                                               {"never", NULL, "decide", NEED_RANKS, no_run},
                                               {0}},
                                    sweep[] = {{"sweep", NULL, "sweep", 0, no_run}, {0}},
                                    last[] = {{"last", NULL, "comm", 0, no_run}, {0}};
    static const struct engine_passes engine = {
        .before = {[PASS_LOOK] = last}, .renew = renew, .sweep = sweep};
    const struct physics *rows[] = {&grains};
    struct step_plan plan;
    struct timers timers = {0};
    struct two_lists lists;
    struct physics_set set = {.count = 1, .active = {{.row = &grains}}};
    lists_fill(&lists);
    set.active[0].context.list[0] = &lists.grains;
    stages_register(&timers, rows, 1);
    plan_make(&plan, &set, &engine, &timers, 0);
    const char *const plain[] = {"move", "renew", "touch", "last"}, *const fused[] = {"sweep", "last"};
    assert_int_equal(plan.plain.passes, 4);
    assert_int_equal(plan.fused.passes, 2);
    for (int p = 0; p < 4; p++)
        assert_string_equal(plan.plain.pass[p].name, plain[p]);
    for (int p = 0; p < 2; p++)
        assert_string_equal(plan.fused.pass[p].name, fused[p]);
    assert_int_equal(plan.forces, 2);
}

TEST_MAIN(plan, cmocka_unit_test(forces_begin_at_the_pairs), cmocka_unit_test(rows_need_no_interaction),
          cmocka_unit_test(other_lists_run_after_the_sweep))
