/* SPDX-License-Identifier: BSD-3-Clause */
/* Units and decimal numbers. */
#include "tests/test.h"

#include "data/scene/decimal.h"
#include "data/scene/schema_value.h"
#include "data/scene/units.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void converts(void **state) {
    (void)state;
    static const struct {
        const char *text, *unit;
        double value;
    } cases[] = {
        {"5 mm", "m", 0.005},       {"3mm", "m", 0.003},           {"7 um", "m", 7e-6},
        {"0.5 µs", "s", 5e-7},      {"2 GPa", "Pa", 2e9},          {"2.5 g/cm3", "kg/m3", 2500},
        {"1 t/m^3", "kg/m3", 1000}, {"2.3 kN/m", "N/m", 2300},     {"1 kg m-3", "kg/m3", 1},
        {"36 km/h", "m/s", 10},     {"-9.81 m/s2", "m/s2", -9.81}, {"60 rpm", "rad/s", 2 * M_PI},
        {"180 deg", "rad", M_PI},   {"50 Hz", "1/s", 50},          {"30 %", "", 0.3},
        {"2 min", "s", 120},        {"1e3", "Pa", 1000},           {"1 N*m/m2", "N/m", 1},
        {"4 g/s", "kg/s", 0.004},   {".inf", "s", INFINITY},       {"2 kW/m/K", "W/m/K", 2000},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        double value;
        char why[200] = "";
        if (!schema_number(cases[k].text, cases[k].unit, true, &value, why, sizeof(why)))
            fail_msg("%s: %s", cases[k].text, why);
        if (isinf(cases[k].value))
            assert_true(isinf(value));
        else
            assert_true(fabs(value - cases[k].value) <= 1e-15 * fabs(cases[k].value));
    }
}

/* Every symbol by its definition in base units, and which of them take prefixes. */
static void knows_every_symbol(void **state) {
    (void)state;
    static const struct {
        const char *name, *base;
        double value;
        bool prefixes;
    } symbols[] = {
        {"m", "m", 1, true},
        {"g", "kg", 1e-3, true},
        {"s", "s", 1, true},
        {"N", "kg m s-2", 1, true},
        {"Pa", "kg m-1 s-2", 1, true},
        {"K", "K", 1, true},
        {"J", "kg m2 s-2", 1, true},
        {"W", "kg m2 s-3", 1, true},
        {"Hz", "s-1", 1, true},
        {"bar", "kg m-1 s-2", 1e5, true},
        {"L", "m3", 1e-3, true},
        {"t", "kg", 1e3, false},
        {"min", "s", 60, false},
        {"h", "s", 3600, false},
        {"sec", "s", 1, false},
        {"day", "h", 86400, false},
        {"micron", "um", 1e-6, false},
        {"in", "m", 0.0254, false},
        {"ft", "m", 0.3048, false},
        {"yd", "m", 0.9144, false},
        {"lb", "kg", 0.45359237, false},
        {"lbf", "kg m s-2", 4.4482216152605, false},
        {"psi", "Pa", 6894.757293168361, false},
        {"atm", "Pa", 101325, false},
        {"rev", "rad", 2 * M_PI, false},
        {"rad", "rad", 1, true},
        {"deg", "rad", M_PI / 180, false},
        {"°", "rad", M_PI / 180, false},
        {"rpm", "rad s-1", M_PI / 30, false},
        {"%", "", 0.01, false},
        {"1", "", 1, false},
    };
    for (size_t k = 0; k < sizeof(symbols) / sizeof(symbols[0]); k++) {
        struct units_scale scale, one;
        struct units_dimension dimension, base;
        char prefixed[16];
        assert_true(units_parse(symbols[k].name, &scale, &dimension));
        assert_true(units_parse(symbols[k].base, &one, &base));
        if (!units_same(&dimension, &base))
            fail_msg("%s is not %s", symbols[k].name, symbols[k].base);
        double value = units_convert(1, &scale);
        if (fabs(value - symbols[k].value) > 1e-15 * symbols[k].value)
            fail_msg("1 %s is %.17g, not %.17g", symbols[k].name, value, symbols[k].value);
        snprintf(prefixed, sizeof(prefixed), "G%s", symbols[k].name);
        if (units_parse(prefixed, &scale, &dimension) != symbols[k].prefixes)
            fail_msg("%s: prefixes are %s", symbols[k].name, symbols[k].prefixes ? "refused" : "taken");
    }
}

/* Every prefix is its power of ten, to the last bit. */
static void knows_every_prefix(void **state) {
    (void)state;
    static const struct {
        const char *name;
        double value;
    } prefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6},
                    {"m", 1e-3}, {"c", 1e-2}, {"d", 1e-1},        {"h", 1e2},
                    {"k", 1e3},  {"M", 1e6},  {"G", 1e9},         {"T", 1e12}};
    for (size_t k = 0; k < sizeof(prefixes) / sizeof(prefixes[0]); k++) {
        struct units_scale scale;
        struct units_dimension dimension;
        char text[16];
        snprintf(text, sizeof(text), "%sPa", prefixes[k].name);
        assert_true(units_parse(text, &scale, &dimension));
        double value = units_convert(1, &scale);
        if (value != prefixes[k].value)
            fail_msg("1 %s is %.17g", text, value);
    }
}

/* Powers of ten lose nothing: the same double as the decimal number in base units. */
static void decimals_are_exact(void **state) {
    (void)state;
    char text[64];
    for (int k = 1; k < 1000; k++) {
        double value, base;
        char why[200];
        snprintf(text, sizeof(text), "%d.%d mm", k, k % 10);
        assert_true(schema_number(text, "m", true, &value, why, sizeof(why)));
        snprintf(text, sizeof(text), "%d.%de-3", k, k % 10);
        assert_true(schema_number(text, "m", true, &base, why, sizeof(why)));
        assert_true(value == base);
    }
}

static void refuses(void **state) {
    (void)state;
    static const char *const cases[][3] = {
        {"5 kg", "m", "not a unit of length"},
        {"5 mmm", "m", "is not a unit"},
        {"5 m/", "m", "is not a unit"},
        {"5 m", "", "a pure number has no unit"},
        {"5 rad/s", "1/s", "not a unit of rate"},
        {"5 Hz", "rad/s", "angular velocity"},
        {"x", "m", "is not a number"},
        {"", "m", "is not a number"},
        {"nan", "m", "is not a number"},
        {"0x10", "m", "is not a number"},
        {"1,5", "m", "has a decimal comma"},
        {"1e999", "m", "is not a number"},
        {"5 m^", "m", "is not a unit"},
        {"5 mdeg", "rad", "is not a unit"},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        double value;
        char why[200] = "";
        assert_false(schema_number(cases[k][0], cases[k][1], true, &value, why, sizeof(why)));
        if (!strstr(why, cases[k][2]))
            fail_msg("'%s' of %s: %s", cases[k][0], cases[k][1], why);
    }
    double value;
    char why[200];
    assert_false(schema_number("5 mm", "m", false, &value, why, sizeof(why)));
    assert_non_null(strstr(why, "dimensionless"));
}

/* A whole number counts by its worth, exactly, however it is written. */
static void whole_numbers(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int64_t value;
    } good[] = {
        {"0", 0},
        {"-0.0", 0},
        {"0e99", 0},
        {"+17", 17},
        {"-17", -17},
        {"1e6", 1000000},
        {"1.50e1", 15},
        {"100e-2", 1},
        {"0.001e3", 1},
        {"12.000", 12},
        {"9007199254740993", 9007199254740993},
        {"9.007199254740993e15", 9007199254740993},
        {"1e18", 1000000000000000000},
        {"1000000000000000000", 1000000000000000000},
        {"9223372036854775807", INT64_MAX},
        {"922337203685477580.7e1", INT64_MAX},
        {"-9223372036854775807", -INT64_MAX},
    };
    static const char *const not_whole[] = {"1.5", "15e-1", "1e-3", "0.1", "x",   "",
                                            "-",   "e5",    "0x10", "1 2", "5 m", "nan"};
    static const char *const too_large[] = {
        "1e19",  "9223372036854775808",           "-1e30", "10000000000000000000", ".inf",
        "-.inf", "123456789012345678901234567890"};
    int64_t value;
    bool fits;
    for (size_t k = 0; k < sizeof(good) / sizeof(good[0]); k++)
        if (!decimal_whole(good[k].text, &value, &fits) || !fits || value != good[k].value)
            fail_msg("%s: %lld", good[k].text, (long long)value);
    for (size_t k = 0; k < sizeof(not_whole) / sizeof(not_whole[0]); k++)
        if (decimal_whole(not_whole[k], &value, &fits))
            fail_msg("%s is taken for whole", not_whole[k]);
    for (size_t k = 0; k < sizeof(too_large) / sizeof(too_large[0]); k++)
        if (!decimal_whole(too_large[k], &value, &fits) || fits)
            fail_msg("%s is taken for one of 64 bits", too_large[k]);
}

static void parses_dimensions(void **state) {
    (void)state;
    struct units_scale scale;
    struct units_dimension pascal, by_hand, newton;
    assert_true(units_parse("Pa", &scale, &pascal));
    assert_true(units_parse("kg m-1 s-2", &scale, &by_hand));
    assert_true(units_parse("N", &scale, &newton));
    assert_true(units_same(&pascal, &by_hand));
    assert_false(units_same(&pascal, &newton));
    assert_string_equal(units_name("Pa"), "pressure");
    assert_string_equal(units_name("W"), "W");
}

TEST_MAIN(units, cmocka_unit_test(converts), cmocka_unit_test(knows_every_symbol),
          cmocka_unit_test(knows_every_prefix), cmocka_unit_test(decimals_are_exact),
          cmocka_unit_test(refuses), cmocka_unit_test(whole_numbers), cmocka_unit_test(parses_dimensions))
