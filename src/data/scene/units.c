/* SPDX-License-Identifier: BSD-3-Clause */
/* The tables of symbols and prefixes, and how a unit is parsed. Read units.h first. */
#include "data/scene/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct symbol {
    const char *name;
    struct units_scale scale;
    struct units_dimension dimension;
    bool prefixes;
};

static const struct symbol symbols[] = {
    {"m", {1, 0}, {1, 0, 0, 0, 0, 0}, true},
    {"g", {1, -3}, {0, 1, 0, 0, 0, 0}, true},
    {"s", {1, 0}, {0, 0, 1, 0, 0, 0}, true},
    {"N", {1, 0}, {1, 1, -2, 0, 0, 0}, true},
    {"Pa", {1, 0}, {-1, 1, -2, 0, 0, 0}, true},
    {"K", {1, 0}, {0, 0, 0, 0, 1, 0}, true},
    {"J", {1, 0}, {2, 1, -2, 0, 0, 0}, true},
    {"W", {1, 0}, {2, 1, -3, 0, 0, 0}, true},
    {"Hz", {1, 0}, {0, 0, -1, 0, 0, 0}, true},
    {"bar", {1, 5}, {-1, 1, -2, 0, 0, 0}, true},
    {"L", {1, -3}, {3, 0, 0, 0, 0, 0}, true},
    {"t", {1, 3}, {0, 1, 0, 0, 0, 0}, false},
    {"sec", {1, 0}, {0, 0, 1, 0, 0, 0}, false},
    {"day", {86400, 0}, {0, 0, 1, 0, 0, 0}, false},
    {"micron", {1, -6}, {1, 0, 0, 0, 0, 0}, false},
    {"in", {254, -4}, {1, 0, 0, 0, 0, 0}, false},
    {"ft", {3048, -4}, {1, 0, 0, 0, 0, 0}, false},
    {"yd", {9144, -4}, {1, 0, 0, 0, 0, 0}, false},
    {"lb", {45359237, -8}, {0, 1, 0, 0, 0, 0}, false},
    {"lbf", {44482216152605, -13}, {1, 1, -2, 0, 0, 0}, false},
    {"psi", {44482216152605.0 / 64516, -5}, {-1, 1, -2, 0, 0, 0}, false},
    {"atm", {101325, 0}, {-1, 1, -2, 0, 0, 0}, false},
    {"min", {60, 0}, {0, 0, 1, 0, 0, 0}, false},
    {"h", {3600, 0}, {0, 0, 1, 0, 0, 0}, false},
    {"rad", {1, 0}, {0, 0, 0, 1, 0, 0}, true},
    {"deg", {M_PI / 180, 0}, {0, 0, 0, 1, 0, 0}, false},
    {"°", {M_PI / 180, 0}, {0, 0, 0, 1, 0, 0}, false},
    {"rev", {2 * M_PI, 0}, {0, 0, 0, 1, 0, 0}, false},
    {"rpm", {2 * M_PI / 60, 0}, {0, 0, -1, 1, 0, 0}, false},
    {"%", {1, -2}, {0, 0, 0, 0, 0, 0}, false},
    {"1", {1, 0}, {0, 0, 0, 0, 0, 0}, false},
    {"V", {1, 0}, {2, 1, -3, 0, 0, -1}, true},
    {"A", {1, 0}, {0, 0, 0, 0, 0, 1}, true},
    {"C", {1, 0}, {0, 0, 1, 0, 0, 1}, true},
    {"F", {1, 0}, {-2, -1, 4, 0, 0, 2}, true},
};

struct prefix {
    const char *name;
    int decimal;
};

static const struct prefix prefixes[] = {{"n", -9}, {"u", -6}, {"\xc2\xb5", -6}, {"\xce\xbc", -6},
                                         {"m", -3}, {"c", -2}, {"d", -1},        {"h", 2},
                                         {"k", 3},  {"M", 6},  {"G", 9},         {"T", 12}};

static const struct symbol *find_symbol(const char *name, size_t length) {
    for (size_t k = 0; k < sizeof(symbols) / sizeof(symbols[0]); k++)
        if (strlen(symbols[k].name) == length && memcmp(symbols[k].name, name, length) == 0)
            return &symbols[k];
    return NULL;
}

/* A symbol, alone or behind a prefix. */
static const struct symbol *find_prefixed(const char *name, size_t length, int *decimal) {
    const struct symbol *symbol = find_symbol(name, length);
    *decimal = 0;
    for (size_t k = 0; !symbol && k < sizeof(prefixes) / sizeof(prefixes[0]); k++) {
        size_t skip = strlen(prefixes[k].name);
        if (skip >= length || memcmp(prefixes[k].name, name, skip) != 0)
            continue;
        const struct symbol *base = find_symbol(name + skip, length - skip);
        if (base && base->prefixes) {
            *decimal = prefixes[k].decimal;
            return base;
        }
    }
    return symbol;
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* An exponent ("2", "^2", "-3", "^-1", "+2") at *text, 1 if there is none. */
static bool read_exponent(const char **text, int *exponent) {
    const char *at = *text;
    bool caret = *at == '^';
    at += caret;
    bool sign = *at == '-' || *at == '+';
    if (!is_digit(at[sign])) {
        *exponent = 1;
        return !caret && !sign;
    }
    char *end;
    long value = strtol(at, &end, 10);
    *exponent = (int)value;
    *text = end;
    return value >= -9 && value <= 9;
}

/* One factor of a unit, raised to `power`, multiplied into scale and dimension. */
static bool read_factor(const char **text, int power, struct units_scale *scale,
                        struct units_dimension *dimension) {
    size_t length = strcspn(*text, " */^+-0123456789");
    if (length == 0 && **text == '1')
        length = 1;
    int prefix;
    const struct symbol *symbol = find_prefixed(*text, length, &prefix);
    if (!symbol)
        return false;
    *text += length;
    int exponent;
    if (!read_exponent(text, &exponent))
        return false;
    exponent *= power;
    scale->factor *= pow(symbol->scale.factor, exponent);
    scale->decimal += exponent * (prefix + symbol->scale.decimal);
    dimension->length += exponent * symbol->dimension.length;
    dimension->mass += exponent * symbol->dimension.mass;
    dimension->time += exponent * symbol->dimension.time;
    dimension->angle += exponent * symbol->dimension.angle;
    dimension->temperature += exponent * symbol->dimension.temperature;
    dimension->current += exponent * symbol->dimension.current;
    return true;
}

bool units_parse(const char *text, struct units_scale *scale, struct units_dimension *dimension) {
    *scale = (struct units_scale){1, 0};
    *dimension = (struct units_dimension){0};
    int power = 1;
    bool expected = false; /* a factor must follow */
    for (;;) {
        text += strspn(text, " ");
        if (*text == '\0')
            return !expected;
        if (*text == '*' || *text == '/') {
            if (expected)
                return false;
            power = *text == '/' ? -1 : 1;
            expected = true;
            text++;
            continue;
        }
        if (!read_factor(&text, power, scale, dimension))
            return false;
        power = 1;
        expected = false;
    }
}

double units_convert(double value, const struct units_scale *scale) {
    value *= scale->factor;
    return scale->decimal < 0 ? value / pow(10, -scale->decimal) : value * pow(10, scale->decimal);
}

bool units_same(const struct units_dimension *a, const struct units_dimension *b) {
    return a->length == b->length && a->mass == b->mass && a->time == b->time && a->angle == b->angle &&
           a->temperature == b->temperature && a->current == b->current;
}

void units_symbols(const char *si, char *text, size_t room) {
    struct units_dimension wanted;
    struct units_scale scale;
    text[0] = '\0';
    if (!units_parse(si, &scale, &wanted) || units_same(&wanted, &(struct units_dimension){0}))
        return;
    for (size_t k = 0; k < sizeof(symbols) / sizeof(symbols[0]); k++)
        if (units_same(&symbols[k].dimension, &wanted) && strlen(text) + strlen(symbols[k].name) + 2 < room)
            sprintf(text + strlen(text), "%s%s", text[0] ? " " : "", symbols[k].name);
}

const char *units_name(const char *si) {
    static const char *const names[][2] = {{"m", "length"},       {"s", "time"},
                                           {"m/s", "velocity"},   {"m/s2", "acceleration"},
                                           {"kg/m3", "density"},  {"Pa", "pressure"},
                                           {"N/m", "stiffness"},  {"1/s", "rate"},
                                           {"rad", "angle"},      {"K", "temperature"},
                                           {"V", "potential"},    {"N", "force"},
                                           {"kg/s", "mass rate"}, {"rad/s", "angular velocity"}};
    for (size_t k = 0; k < sizeof(names) / sizeof(names[0]); k++)
        if (strcmp(names[k][0], si) == 0)
            return names[k][1];
    return si;
}
