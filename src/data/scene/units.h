/* SPDX-License-Identifier: BSD-3-Clause */
/* Units of measurement in scene and data files: "mm", "m/s2", "kg m-3", "GPa", "rpm". */
#ifndef SCREE_SCENE_UNITS_H
#define SCREE_SCENE_UNITS_H

#include <stdbool.h>
#include <stddef.h>

/* Powers of metre, kilogram, second, radian, kelvin and ampere. */
struct units_dimension {
    int length, mass, time, angle, temperature, current;
};

/* One unit in SI base units (m, kg, s, rad, K, A): factor x 10^decimal. Apart, so that decimal prefixes lose no
 * digit. */
struct units_scale {
    double factor;
    int decimal;
};

/* Reads a unit: factors, each a symbol with an SI prefix and an exponent ("cm3", "s^2", "m-3"), apart by
 * spaces, `*` or `/` (which divides by the one factor after it). Symbols: m g s K A N Pa J W V C F Hz rad deg rev rpm
 * sec min h day micron in ft yd t lb lbf L bar psi atm %. Gives scale and dimension; false if it is none. "" and "1" are pure numbers. */
bool units_parse(const char *text, struct units_scale *scale, struct units_dimension *dimension);

/* A value of a unit in base units. 3 mm gives the double nearest to 0.003. */
double units_convert(double value, const struct units_scale *scale);

/* True if both are of one dimension. */
bool units_same(const struct units_dimension *a, const struct units_dimension *b);

/* Writes the symbols of the dimension of an SI unit, "s sec day min h"; "" if no symbol has it. */
void units_symbols(const char *si, char *text, size_t room);

/* The name of the dimension of an SI unit ("length", "pressure"); the unit itself if the dimension has no
 * name. */
const char *units_name(const char *si);

#endif
