/* SPDX-License-Identifier: BSD-3-Clause */
/* The manual page and the completion of the shell, from the tables of commands and flags. */
#ifndef SCREE_PROGRAM_MANUAL_H
#define SCREE_PROGRAM_MANUAL_H

#include <stdio.h>

/* Prints the manual page scree(1) in the language man, for `scree help --man`. */
void manual_page(FILE *out);

/* Prints the completion of bash, for `scree help --bash`. */
void manual_bash(FILE *out);

/* Prints the completion of zsh and of fish, for `scree help --zsh` and `--fish`. */
void manual_zsh(FILE *out);
void manual_fish(FILE *out);

#endif
