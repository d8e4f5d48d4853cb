/* Scenes with very many entries, and sources that ask for too much: answered in a moment. */
#include "tests/scene_by_hand.h"

#include <math.h>
#include <time.h>

/* Seconds of this processor since the start of the program. */
static double seconds(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

/* Seconds that it takes to refuse a scene of a first line and `count` times a pattern with a number, the best
 * of three. */
static double time_refusal(const char *first, const char *pattern, const char *last, int count) {
    size_t room = strlen(first) + strlen(last) + (strlen(pattern) + 12) * (size_t)count + 1;
    char *text = memory_allocate(room, 1, "test");
    char *end = text + sprintf(text, "%s", first);
    for (int k = 0; k < count; k++) {
        end += sprintf(end, "%.*s%d", (int)strcspn(pattern, "@"), pattern, k);
        end += sprintf(end, "%s", strchr(pattern, '@') + 1);
    }
    sprintf(end, "%s", last);
    double best = INFINITY;
    for (int k = 0; k < 3; k++) {
        struct error error;
        double began = seconds();
        assert_null(scene_from(&error, text, NULL));
        best = fmin(best, seconds() - began);
        assert_int_equal(error.kind, ERROR_USER);
    }
    memory_free(text);
    return best;
}

/* Eight times the entries take about eight times the time, not 64 times. */
static void time_grows_with_entries(void **state) {
    (void)state;
    static const char *const cases[][3] = {
        {"", "k@: 1\n", ""},
        {"particles:\n", "  k@: 1\n", ""},
        {"particles: {", "k@: 1, ", "k: 1}\n"},
        {"walls:\n", "  - {name: k@}\n", ""},
        {"walls:\n", "  - k@\n", ""},
        {"gravity: [", "@, ", "0]\n"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        double few = time_refusal(cases[k][0], cases[k][1], cases[k][2], 10000);
        double many = time_refusal(cases[k][0], cases[k][1], cases[k][2], 80000);
        if (!(many < 24 * few + 0.1))
            fail_msg("case %zu: %.3g s for 10,000 entries, %.3g s for 80,000", k, few, many);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(time_grows_with_entries)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
