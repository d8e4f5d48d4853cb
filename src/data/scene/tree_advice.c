/* SPDX-License-Identifier: BSD-3-Clause */
/* Guesses the mistake behind a message of libyaml. Read tree_advice.h first. */
#include "data/scene/tree_advice.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* True if a tab stands among the blanks at the beginning of line `number`, counted from 0. */
static bool tab_begins(const char *text, size_t number) {
    while (number-- > 0) {
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    return text[strspn(text, " ")] == '\t';
}

/* What libyaml says, where it happens, and what people should do. */
struct advice {
    const char *problem, *context; /* parts of libyaml's words; NULL: any */
    bool earlier;                  /* the mistake is where the context begins */
    const char *begin;             /* goes before the line where the context begins; NULL: not told */
    const char *text;
};

static const struct advice table[] = {
    {"could not find expected ':'", "simple key", true, NULL,
     "a colon and a space must follow the key: 'key: value'"},
    {"unexpected end of stream", "quoted scalar", true, NULL,
     "the quotation mark of this line is not closed"},
    {"mapping values are not allowed", NULL, false, NULL,
     "is this line indented like the other lines of its section, and has the line before a colon? (a text "
     "with ': ' in it needs quotation marks)"},
    {"did not find expected key", "block mapping", false, ", which begins in line",
     "is this line indented like the other lines of its section"},
    {"did not find expected '-'", "block collection", false, ", which begins in line",
     "is this line indented like the other entries of its list"},
    {"did not find expected ',' or '}'", NULL, false, "; the '{' is in line", "a ',' or '}' is missing"},
    {"did not find expected ',' or ']'", NULL, false, "; the '[' is in line", "a ',' or ']' is missing"},
};

size_t tree_advice(const yaml_parser_t *parser, const char *text, long first, char *what, size_t room) {
    const char *problem = parser->problem ? parser->problem : "cannot be read",
               *context = parser->context ? parser->context : "";
    size_t line = parser->problem_mark.line, begin = parser->context_mark.line;
    int used = snprintf(what, room, "not valid YAML: %s%s%s", problem, context[0] ? " " : "", context);
    if (used < 0 || (size_t)used >= room)
        return line;
    what += used;
    room -= (size_t)used;
    if (tab_begins(text, line) && (strstr(problem, "start any token") || strstr(problem, "tab"))) {
        snprintf(what, room, "; a tab indents this line: YAML wants spaces");
        return line;
    }
    for (size_t k = 0; k < sizeof(table) / sizeof(table[0]); k++) {
        const struct advice *advice = &table[k];
        if (!strstr(problem, advice->problem) || (advice->context && !strstr(context, advice->context)))
            continue;
        used = snprintf(what, room, "; %s", advice->text);
        if (advice->begin && first > 0 && used > 0 && (size_t)used < room)
            snprintf(what + used, room - (size_t)used, "%s %ld", advice->begin, (long)begin + first);
        return advice->earlier ? begin : line;
    }
    return line;
}
