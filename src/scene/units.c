#include "scene/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct symbol {
    const char *name;
    double factor;
    struct units_dimension dimension;
    bool prefixes;
};

static const struct symbol symbols[] = {
    {"m", 1, {1, 0, 0, 0}, true},
    {"g", 1e-3, {0, 1, 0, 0}, true},
    {"s", 1, {0, 0, 1, 0}, true},
    {"N", 1, {1, 1, -2, 0}, true},
    {"Pa", 1, {-1, 1, -2, 0}, true},
    {"J", 1, {2, 1, -2, 0}, true},
    {"W", 1, {2, 1, -3, 0}, true},
    {"Hz", 1, {0, 0, -1, 0}, true},
    {"bar", 1e5, {-1, 1, -2, 0}, true},
    {"L", 1e-3, {3, 0, 0, 0}, true},
    {"t", 1e3, {0, 1, 0, 0}, false},
    {"min", 60, {0, 0, 1, 0}, false},
    {"h", 3600, {0, 0, 1, 0}, false},
    {"rad", 1, {0, 0, 0, 1}, true},
    {"deg", M_PI / 180, {0, 0, 0, 1}, false},
    {"°", M_PI / 180, {0, 0, 0, 1}, false},
    {"rpm", 2 * M_PI / 60, {0, 0, -1, 1}, false},
    {"%", 0.01, {0, 0, 0, 0}, false},
    {"1", 1, {0, 0, 0, 0}, false},
};

struct prefix {
    const char *name;
    double factor;
};

static const struct prefix prefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6}, {"m", 1e-3},
                                         {"c", 1e-2}, {"d", 1e-1}, {"h", 1e2},         {"k", 1e3},         {"M", 1e6},
                                         {"G", 1e9},  {"T", 1e12}};

static const struct symbol *find_symbol(const char *name, size_t length) {
    for (size_t k = 0; k < sizeof(symbols) / sizeof(symbols[0]); k++)
        if (strlen(symbols[k].name) == length && memcmp(symbols[k].name, name, length) == 0)
            return &symbols[k];
    return NULL;
}

/* A symbol, alone or behind a prefix. */
static const struct symbol *find_prefixed(const char *name, size_t length, double *factor) {
    const struct symbol *symbol = find_symbol(name, length);
    *factor = 1;
    for (size_t k = 0; !symbol && k < sizeof(prefixes) / sizeof(prefixes[0]); k++) {
        size_t skip = strlen(prefixes[k].name);
        if (skip >= length || memcmp(prefixes[k].name, name, skip) != 0)
            continue;
        const struct symbol *base = find_symbol(name + skip, length - skip);
        if (base && base->prefixes) {
            *factor = prefixes[k].factor;
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

/* One factor of a unit, raised to `power`, multiplied into factor and dimension. */
static bool read_factor(const char **text, int power, double *factor, struct units_dimension *dimension) {
    size_t length = strcspn(*text, " */^+-0123456789");
    if (length == 0 && **text == '1')
        length = 1;
    double prefix;
    const struct symbol *symbol = find_prefixed(*text, length, &prefix);
    if (!symbol)
        return false;
    *text += length;
    int exponent;
    if (!read_exponent(text, &exponent))
        return false;
    exponent *= power;
    *factor *= pow(prefix * symbol->factor, exponent);
    dimension->length += exponent * symbol->dimension.length;
    dimension->mass += exponent * symbol->dimension.mass;
    dimension->time += exponent * symbol->dimension.time;
    dimension->angle += exponent * symbol->dimension.angle;
    return true;
}

bool units_parse(const char *text, double *factor, struct units_dimension *dimension) {
    *factor = 1;
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
        if (!read_factor(&text, power, factor, dimension))
            return false;
        power = 1;
        expected = false;
    }
}

bool units_same(const struct units_dimension *a, const struct units_dimension *b) {
    return a->length == b->length && a->mass == b->mass && a->time == b->time && a->angle == b->angle;
}

const char *units_name(const char *si) {
    static const char *const names[][2] = {
        {"m", "length"},          {"s", "time"},         {"m/s", "velocity"}, {"m/s2", "acceleration"},
        {"kg/m3", "density"},     {"Pa", "pressure"},    {"N/m", "stiffness"}, {"1/s", "rate"},
        {"rad", "angle"},         {"N", "force"},        {"kg/s", "mass rate"}, {"rad/s", "angular velocity"}};
    for (size_t k = 0; k < sizeof(names) / sizeof(names[0]); k++)
        if (strcmp(names[k][0], si) == 0)
            return names[k][1];
    return si;
}
