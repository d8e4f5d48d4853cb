/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the tables of parts (law_parts.h). */
#include "physics/grains/laws/law_parts.h"
#include <math.h>
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

#define LAW_KEY(PART, kind, name_, member, range_, ...)                                                      \
    {.part = LAW_PART_##PART,                                                                                \
     .name = #name_,                                                                                         \
     .offset = offsetof(struct law_extra, kind##_##name_.member),                                            \
     .key = #member,                                                                                         \
     .range = range_,                                                                                        \
     __VA_ARGS__},
#define COHESION_KEY(name_, member, ...) LAW_KEY(COHESION, cohesion, name_, member, __VA_ARGS__)
#define ROLLING_KEY(name_, member, ...) LAW_KEY(ROLLING, rolling, name_, member, __VA_ARGS__)
#define TWISTING_KEY(name_, member, ...) LAW_KEY(TWISTING, twisting, name_, member, __VA_ARGS__)
#define DAMPING_KEY(name_, member, ...) LAW_KEY(DAMPING, damping, name_, member, __VA_ARGS__)
#define COHESION_KEYS(NAME, name, with, summary) COHESION_##NAME##_KEYS(COHESION_KEY)
#define ROLLING_KEYS(NAME, name, with, summary) ROLLING_##NAME##_KEYS(ROLLING_KEY)
#define TWISTING_KEYS(NAME, name, with, summary) TWISTING_##NAME##_KEYS(TWISTING_KEY)
#define DAMPING_KEYS(NAME, name, with, summary) DAMPING_##NAME##_KEYS(DAMPING_KEY)

const struct law_given_key *law_given_keys(int *count) {
    static const struct law_given_key keys[] = {LAW_COHESION_PARTS(COHESION_KEYS) LAW_ROLLING_PARTS(
        ROLLING_KEYS) LAW_TWISTING_PARTS(TWISTING_KEYS) LAW_DAMPING_TABLE(DAMPING_KEYS)};
    *count = sizeof keys / sizeof keys[0];
    return keys;
}

union law_sticky law_sticky_of(enum law_cohesion cohesion, const struct law_coefficients *c,
                               const struct law_extra *extra) {
    union law_sticky sticky = {0};
#define CASE(NAME, name, with, summary)                                                                      \
    if (cohesion == LAW_COHESION_##NAME)                                                                     \
        sticky.name = cohesion_##name##_of(c, &extra->cohesion_##name);
    LAW_COHESION_PARTS(CASE)
#undef CASE
    return sticky;
}

void law_sticky_widen(enum law_cohesion cohesion, union law_sticky *widest, const union law_sticky *pair) {
#define WIDEN(part, member) widest->part.member = fmax(widest->part.member, pair->part.member);
#define CASE(NAME, name, with, summary)                                                                      \
    if (cohesion == LAW_COHESION_##NAME) {                                                                   \
        COHESION_##NAME##_NUMBERS(WIDEN)                                                                     \
    }
    LAW_COHESION_PARTS(CASE)
#undef CASE
#undef WIDEN
}

bool law_rolling_general(enum law_rolling rolling, const struct law_extra *extra) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (rolling == LAW_ROLLING_##NAME)                                                                       \
        return rolling_##name##_general(&extra->rolling_##name);
    LAW_ROLLING_PARTS(CASE)
#undef CASE
    return false;
}

struct law_solved law_rolling_solved(enum law_rolling rolling, const struct law_extra *extra) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (rolling == LAW_ROLLING_##NAME)                                                                       \
        return rolling_##name##_solved(&extra->rolling_##name);
    LAW_ROLLING_PARTS(CASE)
#undef CASE
    return (struct law_solved){0};
}

struct law_solved law_twisting_solved(enum law_twisting twisting, const struct law_extra *extra) {
#define CASE(NAME, name, with, summary)                                                                      \
    if (twisting == LAW_TWISTING_##NAME)                                                                     \
        return twisting_##name##_solved(&extra->twisting_##name);
    LAW_TWISTING_PARTS(CASE)
#undef CASE
    return (struct law_solved){0};
}
