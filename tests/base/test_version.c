/* SPDX-License-Identifier: BSD-3-Clause */
/* What the binary says of itself. */
#include "tests/test.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/version.h"

static void version_has_three_numbers(void **state) {
    (void)state;
    int major, minor, patch;
    assert_int_equal(sscanf(version_number(), "%d.%d.%d", &major, &minor, &patch), 3);
}

/* Twelve hexadecimal digits, perhaps marked as modified, or "unknown". */
static void revision_is_a_revision(void **state) {
    (void)state;
    const char *revision = version_revision();
    if (strcmp(revision, "unknown") == 0) {
        return;
    }
    size_t digits = strspn(revision, "0123456789abcdef");
    assert_in_range(digits, 12, 40);
    assert_true(revision[digits] == '\0' || strcmp(revision + digits, "-modified") == 0);
}

static void compiler_and_flags_are_named(void **state) {
    (void)state;
    assert_true(strpbrk(version_compiler(), "0123456789") != NULL);
    assert_non_null(strstr(version_flags(), "-O"));
    assert_non_null(strstr(version_flags(), "openmp"));
}

static void host_is_this_host(void **state) {
    (void)state;
    char expected[256], name[256], cut[2];
    assert_int_equal(gethostname(expected, sizeof expected), 0);
    version_host(name, sizeof name);
    assert_string_equal(name, expected);
    version_host(cut, sizeof cut);
    assert_true(strlen(cut) < sizeof cut);
    char cpu[256] = "";
    version_cpu(cpu, sizeof cpu);
    assert_true(strlen(cpu) > 0);
}

TEST_MAIN(version, cmocka_unit_test(version_has_three_numbers), cmocka_unit_test(revision_is_a_revision),
          cmocka_unit_test(compiler_and_flags_are_named), cmocka_unit_test(host_is_this_host))
