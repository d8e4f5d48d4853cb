/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the tables of parts (law_parts.h). */
#include "physics/grains/laws/law_parts.h"
#include <string.h>

#define LAW_PART_ROW(NAME, name, with, summary) {#name, with, summary},
static const struct law_part_row cohesion_rows[] = {LAW_COHESION_TABLE(LAW_PART_ROW)};
static const struct law_part_row tangential_rows[] = {LAW_TANGENTIAL_TABLE(LAW_PART_ROW)};
static const struct law_part_row rolling_rows[] = {LAW_ROLLING_TABLE(LAW_PART_ROW)};
static const struct law_part_row twisting_rows[] = {LAW_TWISTING_TABLE(LAW_PART_ROW)};
static const struct law_part_row damping_rows[] = {LAW_DAMPING_TABLE(LAW_PART_ROW)};

static const struct {
    const char *key;
    const struct law_part_row *rows;
    int count;
} parts[] = {[LAW_PART_COHESION] = {"cohesion.law", cohesion_rows, LAW_COHESION_COUNT},
             [LAW_PART_TANGENTIAL] = {"tangential", tangential_rows, LAW_TANGENTIAL_COUNT},
             [LAW_PART_ROLLING] = {"rolling", rolling_rows, LAW_ROLLING_COUNT},
             [LAW_PART_TWISTING] = {"twisting", twisting_rows, LAW_TWISTING_COUNT},
             [LAW_PART_DAMPING] = {"damping", damping_rows, LAW_DAMPING_COUNT}};

const char *law_part_key(enum law_part part) {
    return parts[part].key;
}

const struct law_part_row *law_part_rows(enum law_part part, int *count) {
    *count = parts[part].count;
    return parts[part].rows;
}

/* True if a list of words has one of `length` letters. */
static bool has_word(const char *list, const char *word, size_t length) {
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ')
        if (strcspn(at, " ") == length && strncmp(at, word, length) == 0)
            return true;
    return false;
}

bool law_part_combines(const struct law_part_row *row, const char *traits) {
    for (const char *at = row->with; *at; at += strcspn(at, " "), at += *at == ' ')
        if (has_word(traits, at, strcspn(at, " ")))
            return true;
    return false;
}
