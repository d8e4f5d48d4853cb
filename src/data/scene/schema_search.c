/* SPDX-License-Identifier: BSD-3-Clause */
/* Searches the rows of the schema. Read schema_help.h first. */
#include "data/scene/schema_help.h"
#include "data/scene/schema_root.h"
#include "data/scene/schema_unknown.h"

#include <ctype.h>
#include <string.h>

struct search {
    FILE *out; /* NULL: count only */
    const char *word;
    bool inside;                /* the word may be a part of names and help texts */
    int found;                  /* lines */
    char first[SCHEMA_KEY_MAX]; /* the key of the first line, "" if the line is no key */
    char last[SCHEMA_KEY_MAX];  /* the last key: rows of one key are one line */
};

static void line(struct search *search, const char *key, const char *value, const char *help) {
    char title[SCHEMA_KEY_MAX + 80];
    if (!value && strcmp(search->last, key) == 0)
        return;
    snprintf(title, sizeof(title), "%s%s%s", key, value ? ": " : "", value ? value : "");
    if (search->out)
        fprintf(search->out, "%-44s %s\n", title, help ? help : "");
    if (search->found == 0)
        snprintf(search->first, sizeof(search->first), "%s", value ? "" : key);
    if (!value)
        snprintf(search->last, sizeof(search->last), "%s", key);
    search->found++;
}

/* A letter without its case; blanks and hyphens are as good as underscores. */
static int plain(char letter) {
    return letter == ' ' || letter == '-' ? '_' : tolower((unsigned char)letter);
}

static bool begins(const char *text, const char *word) {
    while (*word && plain(*text) == plain(*word))
        text++, word++;
    return *word == '\0';
}

/* True if a word of the text begins with the word that is looked for. */
static bool has(const char *text, const char *word) {
    for (const char *at = text; text && *at; at++)
        if ((at == text || !isalnum((unsigned char)at[-1])) && begins(at, word))
            return true;
    return false;
}

/* True if the row exists only with the value that is looked for. */
static bool needs(const struct schema_row *row, const char *word) {
    char condition[SCHEMA_NOTE_MAX];
    size_t length = strlen(word);
    schema_condition(row, condition, sizeof(condition));
    for (char *at = strpbrk(condition, "=|"); at; at = strpbrk(at + 1, "=|"))
        if (strcspn(at + 1, "| ") == length && strncmp(at + 1, word, length) == 0)
            return true;
    return false;
}

static void look(void *context, const struct schema_row *row, const char *key, int depth) {
    struct search *search = context;
    const char *name, *help = NULL;
    (void)depth;
    bool found = search->inside ? has(row->key, search->word) || has(row->help, search->word)
                                : strcmp(row->key, search->word) == 0;
    if (found)
        line(search, key, NULL, row->help);
    for (int k = 0; (name = schema_value_name(row, k)); k++) {
        help = row->type == SCHEMA_NAME ? row->names[k].help : (row->choice(k, &help), help);
        if (search->inside ? !found && (has(name, search->word) || has(help, search->word))
                           : strcmp(name, search->word) == 0)
            line(search, key, name, help ? help : row->help);
    }
    if (!found && !search->inside && needs(row, search->word))
        line(search, key, NULL, row->help);
}

/* Counts or prints all lines. */
static void run(struct search *search) {
    char meant[SCHEMA_KEY_MAX];
    const char *note = NULL;
    search->found = 0;
    search->first[0] = search->last[0] = '\0';
    if (!search->inside && schema_meaning(&schema_root, "", search->word, meant, &note)) {
        char full[SCHEMA_KEY_MAX];
        const struct schema_row *row = schema_find(meant, full);
        line(search, meant, NULL, note ? note : row ? row->help : "");
    }
    schema_walk(look, search);
}

int schema_search(FILE *out, const char *word, char only[SCHEMA_KEY_MAX]) {
    struct search search = {.word = word};
    only[0] = '\0';
    run(&search);
    if (search.found == 0 && strlen(word) > 2) {
        search.inside = true;
        run(&search);
    }
    if (search.found == 1 && search.first[0]) {
        snprintf(only, SCHEMA_KEY_MAX, "%s", search.first);
        return 1;
    }
    search.out = out;
    run(&search);
    return search.found;
}
