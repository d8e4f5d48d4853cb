/* SPDX-License-Identifier: BSD-3-Clause */
/* Guesses what an unknown key means. Read schema_unknown.h first. */
#include "data/scene/schema_unknown.h"
#include "data/scene/mistakes.h"
#include "data/scene/schema_root.h"

#include <ctype.h>
#include <string.h>

/* Levenshtein's distance of two words, the longer one cut at 63 letters. */
static int word_distance(const char *a, const char *b) {
    int row[64];
    int n = (int)strnlen(a, 63), m = (int)strnlen(b, 63);
    for (int j = 0; j <= m; j++)
        row[j] = j;
    for (int i = 1; i <= n; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= m; j++) {
            int best = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            best = row[j] + 1 < best ? row[j] + 1 : best;
            row[j] = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
        }
    }
    return row[m];
}

struct suggestion {
    const char *section, *key;
    double score;
    char *nearest;
};

/* Letters that may be wrong in a word. */
static int tolerance(const char *a, const char *b) {
    size_t shorter = strlen(a) < strlen(b) ? strlen(a) : strlen(b);
    return shorter > 6 ? (int)shorter / 3 : shorter > 4 ? 2 : shorter > 2 ? 1 : 0;
}

/* True if two letters side by side are swapped, and all others agree. */
static bool swapped(const char *a, const char *b) {
    while (*a && *a == *b) {
        a++;
        b++;
    }
    return a[0] && a[1] && a[1] == b[0] && a[0] == b[1] && strcmp(a + 2, b + 2) == 0;
}

int schema_distance(const char *a, const char *b) {
    int distance = swapped(a, b) ? 1 : word_distance(a, b);
    return distance <= tolerance(a, b) ? distance : -1;
}

/* A sibling with a typing error is nearest, then one farther down in the section, then one elsewhere. */
static void suggest_row(void *context, const struct schema_row *row, const char *key, int depth) {
    struct suggestion *s = context;
    (void)depth;
    int distance = schema_distance(s->key, row->key);
    if (distance < 0)
        return;
    size_t length = strlen(s->section);
    bool inside = strncmp(key, s->section, length) == 0;
    bool sibling = inside && !strpbrk(key + length, ".");
    double score = distance + (sibling ? 0 : inside ? 0.9 : 2);
    if (score < s->score) {
        s->score = score;
        snprintf(s->nearest, SCHEMA_KEY_MAX, "%s", key);
    }
}

bool schema_suggest(const char *section, const char *key, char nearest[SCHEMA_KEY_MAX]) {
    struct suggestion suggestion = {.section = section, .key = key, .score = 1e9, .nearest = nearest};
    schema_walk(suggest_row, &suggestion);
    return suggestion.score < 1e9;
}

/* The k-th of the words in `words`, copied; false behind the last. */
static bool word_get(const char *words, int k, char word[SCHEMA_KEY_MAX]) {
    while (k-- > 0 && *words) {
        words += strcspn(words, " ");
        words += *words == ' ';
    }
    snprintf(word, SCHEMA_KEY_MAX, "%.*s", (int)strcspn(words, " "), words);
    return word[0] != '\0';
}

/* A search for a key by its last part. */
struct leaf {
    const char *word;
    char *found; /* "" until found */
};

static void leaf_look(void *context, const struct schema_row *row, const char *key, int depth) {
    struct leaf *leaf = context;
    (void)depth;
    if (!leaf->found[0] && strcmp(row->key, leaf->word) == 0)
        snprintf(leaf->found, SCHEMA_KEY_MAX, "%s", key);
}

bool schema_meaning(const struct schema_table *table, const char *section, const char *word,
                    char meant[SCHEMA_KEY_MAX], const char **note) {
    const struct synonym *synonym = synonyms_find(word);
    char key[SCHEMA_KEY_MAX];
    meant[0] = '\0';
    if (!synonym)
        return false;
    *note = synonym->note;
    for (int k = 0; table && word_get(synonym->keys, k, key); k++)
        if (schema_row_find(table, key, strlen(key))) {
            snprintf(meant, SCHEMA_KEY_MAX, "%.120s%.120s", section, key);
            return true;
        }
    for (int k = 0; word_get(synonym->keys, k, key); k++)
        if (schema_find(key, meant))
            return true;
    for (int k = 0; word_get(synonym->keys, k, key); k++) {
        struct leaf leaf = {.word = key, .found = meant};
        meant[0] = '\0';
        schema_walk(leaf_look, &leaf);
        if (meant[0])
            return true;
    }
    return false;
}

/* Takes the numbers out of a prefix: "walls[2].motion[0]." becomes "walls[].motion[].". */
static void unnumbered(const char *prefix, char section[SCHEMA_KEY_MAX]) {
    snprintf(section, SCHEMA_KEY_MAX, "%s", prefix);
    for (char *open = strchr(section, '['); open && strchr(open, ']'); open = strchr(open + 1, '[')) {
        const char *close = strchr(open, ']');
        memmove(open + 1, close, strlen(close) + 1);
    }
}

/* Appends all keys of a table, each once. */
static void table_words(const struct schema_table *table, char *text, size_t room) {
    for (int k = 0; k < table->count; k++) {
        size_t used = strlen(text);
        if (schema_row_find(table, table->rows[k].key, strlen(table->rows[k].key)) == &table->rows[k])
            snprintf(text + used, room - used, "%s%s", k ? ", " : "", table->rows[k].key);
    }
}

bool schema_unknown(struct schema_reader *reader, const struct schema_table *table,
                    const struct tree_node *node, const char *prefix, const char *key, bool lists) {
    char section[SCHEMA_KEY_MAX], nearest[SCHEMA_KEY_MAX] = "", meant[SCHEMA_KEY_MAX] = "", text[1000] = "";
    const char *note = NULL, *best;
    unnumbered(prefix, section);
    size_t length = strlen(section);
    bool near = schema_suggest(section, key, nearest);
    bool sibling = near && strncmp(nearest, section, length) == 0 && !strchr(nearest + length, '.');
    bool known = schema_meaning(table, section, key, meant, &note);
    bool inside = known && strncmp(meant, section, length) == 0;
    best = inside || (known && !sibling) ? meant : nearest;
    if (known || near)
        snprintf(text, sizeof(text), "; did you mean '%s'%s%s%s?", best, best == meant && note ? " (" : "",
                 best == meant && note ? note : "", best == meant && note ? ")" : "");
    if (table && lists) {
        snprintf(text + strlen(text), sizeof(text) - strlen(text), "%s allowed here: ", text[0] ? "" : ";");
        table_words(table, text, sizeof(text));
    }
    return schema_fail(reader, node, "", "unknown key '%s%.80s'%s", prefix, key, text);
}

/* True if entry k is what a decimal comma has left of a number: "poisson: 0,2" reads as two entries. */
static bool decimal_comma(const struct tree_node *section, size_t k) {
    const struct tree_node *child = section->child[k], *before = k > 0 ? section->child[k - 1] : NULL;
    return before && isdigit((unsigned char)section->key[k][0]) && child->kind == TREE_SCALAR &&
           !child->quoted && !child->text[0] && before->kind == TREE_SCALAR &&
           strspn(before->text, "+-0123456789") == strlen(before->text);
}

bool schema_known_keys(struct schema_reader *reader, const struct schema_table *table,
                       const struct tree_node *section, const char *prefix) {
    bool good = true;
    for (size_t k = 0; k < section->children && !mistakes_full(reader->error); k++) {
        const char *name = section->key[k];
        if (schema_row_find(table, name, strlen(name)))
            continue;
        if (decimal_comma(section, k)) {
            char key[SCHEMA_KEY_MAX];
            const char *whole = section->child[k - 1]->text;
            snprintf(key, sizeof(key), "%.120s%.80s", prefix, section->key[k - 1]);
            /* 2,500 is 2500 to some, and 2.5 to others */
            if (strlen(name) == 3 && strspn(name, "0123456789") == 3 && strcmp(whole, "0") != 0)
                schema_fail(
                    reader, section->child[k], key,
                    "'%.40s,%.40s': a comma ends the value; write %.40s%.40s, or with a decimal point: "
                    "%.40s.%.40s",
                    whole, name, whole, name, whole, name);
            else
                schema_fail(reader, section->child[k], key,
                            "'%.40s,%.40s': a comma ends the value; write a decimal point: %.40s.%.40s",
                            whole, name, whole, name);
        } else {
            schema_unknown(reader, table, section->child[k], prefix, name, good);
        }
        good = false;
    }
    return good;
}
