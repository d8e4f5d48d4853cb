/* SPDX-License-Identifier: BSD-3-Clause */
/* A user's expression over the fields of particles, by muParser: "0.5*mass*(vx^2+vy^2+vz^2)". The only place that calls
 * muParser. Without it, expressions are refused. */
#ifndef SCREE_OBSERVE_EXPRESSION_H
#define SCREE_OBSERVE_EXPRESSION_H

#include "base/error.h"
#include <stdbool.h>
#include <stddef.h>

enum { EXPRESSION_CHUNK = 1024, EXPRESSION_VARIABLES_MAX = 96 };

struct expression;

/* Makes an expression with `count` variables of these names. Fails (user) on a text that cannot be read or that names
 * something else; the message has the place and the names. One thread. */
bool expression_create(struct expression **expression, const char *text, const char *const *name, int count,
                       struct error *error);
void expression_destroy(struct expression **expression);

/* The values of variable `k`, EXPRESSION_CHUNK of them, to be filled before expression_evaluate. */
double *expression_variable(struct expression *expression, int k);

/* True if the text uses variable `k`. */
bool expression_uses(const struct expression *expression, int k);

/* The values of the expression for the first `n` sets of variables; valid until the next call. */
const double *expression_evaluate(struct expression *expression, size_t n);

/* True if this program has muParser. */
bool expression_available(void);

#endif
