/* SPDX-License-Identifier: BSD-3-Clause */
/* Expressions by muParser's C interface. Read expression.h first. */
#include "config.h"

#include "data/observe/expression.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

#ifdef HAVE_MUPARSER
#include <muParserDLL.h>

struct expression {
    muParserHandle_t parser;
    int count;
    double (*variable)[EXPRESSION_CHUNK];
    bool used[EXPRESSION_VARIABLES_MAX];
    double value[EXPRESSION_CHUNK];
};

bool expression_available(void) {
    return true;
}

/* The error is asked for after each call. */
static void keep_error(muParserHandle_t parser) {
    (void)parser;
}

static void note_used(struct expression *e, const char *const *name) {
    muInt_t used = mupGetExprVarNum(e->parser);
    for (muInt_t u = 0; u < used; u++) {
        const muChar_t *word = NULL;
        muFloat_t *at = NULL;
        mupGetExprVar(e->parser, (unsigned)u, &word, &at);
        for (int k = 0; word && k < e->count; k++)
            e->used[k] = e->used[k] || strcmp(word, name[k]) == 0;
    }
}

bool expression_create(struct expression **expression, const char *text, const char *const *name, int count,
                       struct error *error) {
    struct expression *e = memory_allocate_zero(1, sizeof *e, "expression");
    char known[1200] = "", why[256] = "";
    *expression = e;
    e->count = count;
    e->variable = memory_allocate_zero((size_t)count, sizeof *e->variable, "expression");
    e->parser = mupCreate(muBASETYPE_FLOAT);
    mupSetErrorHandler(e->parser, keep_error);
    for (int k = 0; k < count; k++) {
        mupDefineVar(e->parser, name[k], e->variable[k]);
        snprintf(known + strlen(known), sizeof known - strlen(known), "%s%s", k ? ", " : "", name[k]);
    }
    mupSetExpr(e->parser, text);
    note_used(e, name);
    mupEval(e->parser);
    if (!mupError(e->parser))
        return true;
    snprintf(why, sizeof why, "%.240s", mupGetErrorMsg(e->parser));
    expression_destroy(expression);
    return error_set(error, ERROR_USER,
                     "'%s' is no expression: %s; known are %s, and the functions of muParser", text, why,
                     known);
}

void expression_destroy(struct expression **expression) {
    struct expression *e = *expression;
    if (e == NULL)
        return;
    mupRelease(e->parser);
    memory_free(e->variable);
    memory_free(e);
    *expression = NULL;
}

double *expression_variable(struct expression *e, int k) {
    return e->variable[k];
}

bool expression_uses(const struct expression *e, int k) {
    return e->used[k];
}

const double *expression_evaluate(struct expression *e, size_t n) {
    mupEvalBulk(e->parser, e->value, (int)n);
    return e->value;
}

#else

bool expression_available(void) {
    return false;
}

bool expression_create(struct expression **expression, const char *text, const char *const *name, int count,
                       struct error *error) {
    (void)text, (void)name, (void)count;
    *expression = NULL;
    return error_set(
        error, ERROR_USER,
        "expressions need muParser, which this program was built without (Debian: libmuparser-dev)");
}

void expression_destroy(struct expression **expression) {
    *expression = NULL;
}

double *expression_variable(struct expression *expression, int k) {
    (void)expression, (void)k;
    return NULL;
}

bool expression_uses(const struct expression *expression, int k) {
    (void)expression, (void)k;
    return false;
}

const double *expression_evaluate(struct expression *expression, size_t n) {
    (void)expression, (void)n;
    return NULL;
}

#endif
