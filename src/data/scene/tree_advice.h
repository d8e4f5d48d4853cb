/* SPDX-License-Identifier: BSD-3-Clause */
/* Words for what libyaml does not understand. */
#ifndef SCREE_SCENE_TREE_ADVICE_H
#define SCREE_SCENE_TREE_ADVICE_H

#include <stddef.h>
#include <yaml.h>

/* Describes the error of a parser that has failed on `text`: the words of libyaml, and a mend where the usual
 * cause is known (a tab, a missing colon, an open quote or bracket, an indentation). `first` is the number of
 * the first line, for lines that the words name; 0: the command line, no line is named. Returns the line of
 * the mistake, from 0; where libyaml stumbles over something that begins earlier, the line of the beginning. */
size_t tree_advice(const yaml_parser_t *parser, const char *text, long first, char *what, size_t room);

#endif
