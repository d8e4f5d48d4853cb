/* SPDX-License-Identifier: BSD-3-Clause */
/* The reference, its errors, and the errors and the front of the rows. Read speed_error.h first. */
#include "front/program/speed_error.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define HORIZON_DISTANCE 0.01 /* of the smallest radius */
#define SCALE_LEAST 0.01      /* of the largest range of a column in the same unit */

static const struct sample_record *finest(const struct speed_reference *reference) {
    return &reference->fine[SPEED_FINE - 1];
}

static int samples_both(const struct sample_record *a, const struct sample_record *b) {
    return a->samples < b->samples ? a->samples : b->samples;
}

/* Root mean square distance of the particles at a sample, over the smallest radius. */
static double distance_at(const struct sample_record *a, const struct sample_record *b, int sample) {
    double sum = 0, count = 0;
    for (size_t k = 0; k < a->tracked; k++) {
        size_t at = (size_t)sample * a->tracked + k;
        if (a->present[at] == 0 || b->present[at] == 0)
            continue;
        for (int d = 0; d < 3; d++) {
            double apart = a->position[at][d] - b->position[at][d];
            sum += apart * apart;
        }
        count++;
    }
    return count > 0 ? sqrt(sum / count) / a->radius_min : 0;
}

static double distance(const struct sample_record *a, const struct sample_record *b, int horizon) {
    double most = 0;
    for (int k = 0; k <= horizon && k < samples_both(a, b); k++)
        most = fmax(most, distance_at(a, b, k));
    return most;
}

/* Root mean square difference of a's column from b's over the samples. A column that b lacks counts as 0. */
static double difference(const struct sample_record *a, const struct sample_record *b, int column) {
    double sum = 0;
    int n = samples_both(a, b), like = sample_column_like(b, a, column);
    for (int k = 0; k < n; k++) {
        double apart = sample_value(a, k, column) - (like >= 0 ? sample_value(b, k, like) : 0);
        sum += apart * apart;
    }
    return n > 0 ? sqrt(sum / n) : NAN;
}

/* Mean of a column from a time on; 0 for a column that the record lacks. */
static double mean_of(const struct sample_record *record, int column, double from) {
    double sum = 0;
    int n = 0;
    for (int k = 0; k < record->samples && column >= 0; k++)
        if (record->time[k] >= from) {
            sum += sample_value(record, k, column);
            n++;
        }
    return n > 0 ? sum / n : 0;
}

/* The difference of a's column from b's. */
static double column_apart(const struct speed_reference *reference, const struct sample_record *a,
                           const struct sample_record *b, int column) {
    double from = reference->mean_from;
    return isnan(from) ? difference(a, b, column)
                       : fabs(mean_of(a, column, from) - mean_of(b, sample_column_like(b, a, column), from));
}

static double range_of(const struct sample_record *record, int column) {
    double least = INFINITY, most = -INFINITY;
    for (int k = 0; k < record->samples; k++) {
        least = fmin(least, sample_value(record, k, column));
        most = fmax(most, sample_value(record, k, column));
    }
    return most > least ? most - least : 0;
}

static void scales_find(struct speed_reference *reference) {
    const struct sample_record *record = finest(reference);
    for (int c = 0; c < record->own; c++) {
        double most = 0;
        for (int other = 0; other < record->own; other++)
            if (strcmp(record->unit[c], record->unit[other]) == 0)
                most = fmax(most, range_of(record, other));
        reference->scale[c] = fmax(range_of(record, c), SCALE_LEAST * most);
        if (reference->scale[c] == 0)
            reference->scale[c] = fabs(sample_value(record, 0, c));
    }
}

/* Total energy in play: the largest value that any form of energy has reached. */
static double energy_scale(const struct sample_record *record) {
    static const char *const form[] = {"energy_kinetic", "energy_rotational", "energy_elastic_normal",
                                       "energy_elastic_tangential", "energy_dissipated"};
    double most = 0;
    for (size_t f = 0; f < sizeof form / sizeof form[0]; f++) {
        int c = sample_column(record, form[f], record->own);
        for (int k = 0; c >= 0 && k < record->samples; k++)
            most = fmax(most, fabs(sample_value(record, k, c)));
    }
    return most;
}

static double drift_of(const struct sample_record *record) {
    int c = sample_column(record, "energy_balance", record->own);
    double most = 0, scale = energy_scale(record);
    if (c < 0 || !record->closed || scale == 0)
        return NAN;
    for (int k = 1; k < record->samples; k++)
        most = fmax(most, fabs(sample_value(record, k, c) - sample_value(record, 0, c)));
    return most / scale;
}

static double momentum_of(const struct sample_record *record, const struct speed_reference *reference) {
    static const char *const component[] = {"momentum_x", "momentum_y", "momentum_z"};
    double sum = 0;
    for (int d = 0; d < 3; d++) {
        int c = sample_column(record, component[d], record->own);
        double apart = difference(record, finest(reference), c);
        sum += apart * apart;
    }
    return reference->momentum > 0 ? sqrt(sum) / reference->momentum : NAN;
}

static double order_of(double coarse, double fine) {
    return coarse > 0 && fine > 0 ? log2(coarse / fine) : NAN;
}

void speed_reference_make(struct speed_reference *reference) {
    const struct sample_record *coarse = &reference->fine[0], *middle = &reference->fine[1],
                               *fine = finest(reference);
    scales_find(reference);
    for (int k = 0; k < samples_both(middle, fine); k++) {
        if (distance_at(fine, middle, k) > HORIZON_DISTANCE)
            break;
        reference->horizon = k;
    }
    for (int c = 0; c < fine->own; c++) {
        double coarser = column_apart(reference, middle, coarse, c),
               finer = column_apart(reference, fine, middle, c);
        reference->uncertain[c] = reference->scale[c] > 0 ? finer / reference->scale[c] : 0;
        reference->order[c] = order_of(coarser, finer);
    }
    reference->trajectory_uncertain = distance(fine, middle, reference->horizon);
    reference->trajectory_order =
        order_of(distance(middle, coarse, reference->horizon), reference->trajectory_uncertain);
    int kinetic = sample_column(fine, "energy_kinetic", fine->own);
    for (int k = 0; k < fine->samples && kinetic >= 0; k++)
        reference->momentum =
            fmax(reference->momentum, sqrt(2 * fine->mass * fabs(sample_value(fine, k, kinetic))));
}

void speed_reference_free(struct speed_reference *reference) {
    for (int k = 0; k < SPEED_FINE; k++)
        sample_free(&reference->fine[k]);
}

static bool name_in(const char *names, const char *name) {
    size_t length = strlen(name);
    for (const char *at = names; *at;) {
        size_t word = strcspn(at, ",");
        if (word == length && strncmp(at, name, length) == 0)
            return true;
        at += word;
        at += *at == ',';
    }
    return false;
}

static bool is_energy(const char *name) {
    return strncmp(name, "energy_", 7) == 0 || strncmp(name, "work_", 5) == 0;
}

/* True if a column is 0 at all times: it says nothing of the run, as the sweeps of a run without a solver. */
static bool is_empty(const struct sample_record *record, int column) {
    for (int k = 0; k < record->samples; k++)
        if (sample_value(record, k, column) != 0)
            return false;
    return true;
}

/* The default choice: the scene's own columns without energies and without those that stay 0; if the scene has no other
 * columns, the energies of motion. */
static bool judged_by_default(const struct sample_record *record, int column) {
    const char *name = record->name[column];
    bool others = false;
    for (int c = 0; c < record->own; c++)
        others = others || !is_energy(record->name[c]);
    return others ? !is_energy(name) && !is_empty(record, column)
                  : strcmp(name, "energy_kinetic") == 0 || strcmp(name, "energy_gravity") == 0 ||
                        strcmp(name, "energy_rotational") == 0;
}

bool speed_judge(struct speed_reference *reference, const char *names, struct error *error) {
    const struct sample_record *record = &reference->fine[0];
    char known[ERROR_TEXT_MAX / 2] = "trajectory";
    int asked = 1, found = 0;
    for (const char *at = names; at && *at; at++)
        asked += *at == ',';
    for (int c = 0; c < record->own; c++) {
        size_t used = strlen(known);
        snprintf(known + used, sizeof known - used, ", %s", record->name[c]);
        reference->judged[c] = names ? name_in(names, record->name[c]) : judged_by_default(record, c);
        found += reference->judged[c];
    }
    reference->judge_trajectory = names && name_in(names, "trajectory");
    if (names && found + reference->judge_trajectory < asked)
        return error_set(error, ERROR_USER, "command line: --judge %s: allowed: %s", names, known);
    return true;
}

/* Standard deviation of the members' means. */
static double spread_of_means(const struct sample_record *member, int members, int column, double from) {
    double mean = 0, sum = 0;
    for (int m = 0; m < members; m++)
        mean += mean_of(&member[m], column, from) / members;
    for (int m = 0; m < members; m++) {
        double off = mean_of(&member[m], column, from) - mean;
        sum += off * off / (members - 1);
    }
    return sqrt(sum);
}

/* Root mean square over samples of the members' deviation from their mean. */
static double spread_of(const struct sample_record *member, int members, int column) {
    double sum = 0;
    int n = member[0].samples;
    for (int m = 1; m < members; m++)
        n = member[m].samples < n ? member[m].samples : n;
    for (int k = 0; k < n; k++) {
        double mean = 0;
        for (int m = 0; m < members; m++)
            mean += sample_value(&member[m], k, column) / members;
        for (int m = 0; m < members; m++) {
            double off = sample_value(&member[m], k, column) - mean;
            sum += off * off / (members - 1);
        }
    }
    return n > 0 ? sqrt(sum / n) : 0;
}

void speed_spread(struct speed_reference *reference, const struct sample_record *member, int members) {
    const struct sample_record *record = finest(reference);
    reference->members = members;
    reference->floor = 0;
    for (int c = 0; c < record->own; c++) {
        if (members > 1 && reference->scale[c] > 0)
            reference->spread[c] =
                (isnan(reference->mean_from) ? spread_of(member, members, c)
                                             : spread_of_means(member, members, c, reference->mean_from)) /
                reference->scale[c];
        if (reference->judged[c])
            reference->floor = fmax(reference->floor, fmax(reference->spread[c], reference->uncertain[c]));
    }
    for (int m = 1; m < members; m++)
        reference->trajectory_spread =
            fmax(reference->trajectory_spread, distance(&member[0], &member[m], reference->horizon));
    if (reference->judge_trajectory)
        reference->floor =
            fmax(reference->floor, fmax(reference->trajectory_spread, reference->trajectory_uncertain));
}

void speed_row_measure(struct speed_row *row, const struct sample_record *record,
                       const struct speed_reference *reference) {
    const struct sample_record *fine = finest(reference);
    row->trajectory = distance(fine, record, reference->horizon);
    row->drift = drift_of(record);
    row->momentum = momentum_of(record, reference);
    row->judged = reference->judge_trajectory ? row->trajectory : 0;
    row->worst = -1;
    for (int c = 0; c < fine->own; c++) {
        row->error[c] =
            reference->scale[c] > 0 ? column_apart(reference, fine, record, c) / reference->scale[c] : 0;
        if (reference->judged[c] && !(row->error[c] <= row->judged)) {
            row->judged = row->error[c];
            row->worst = c;
        }
    }
}

void speed_front(struct speed_row *row, int rows, const struct speed_reference *reference) {
    for (int a = 0; a < rows; a++) {
        double error = fmax(row[a].judged, reference->floor);
        row[a].on_front = row[a].stopped[0] == '\0' && isfinite(error);
        for (int b = 0; b < rows && row[a].on_front; b++) {
            double other = fmax(row[b].judged, reference->floor);
            if (b == a || row[b].stopped[0] || !isfinite(other))
                continue;
            bool no_worse = row[b].seconds <= row[a].seconds && other <= error;
            bool better = row[b].seconds < row[a].seconds || other < error || b < a;
            row[a].on_front = !(no_worse && better);
        }
    }
}

bool speed_row_opens_group(const struct speed_row *row, int k) {
    for (int other = 0; other < k; other++)
        if (strcmp(row[other].variant.group, row[k].variant.group) == 0)
            return false;
    return true;
}

static bool in_group(const struct speed_row *row, const char *group) {
    return row->stopped[0] == '\0' && (group == NULL || strcmp(row->variant.group, group) == 0);
}

int speed_most_exact(const struct speed_report *report, const char *group) {
    int best = -1;
    for (int k = 0; k < report->rows; k++)
        if (in_group(&report->row[k], group) &&
            (best < 0 || report->row[k].judged < report->row[best].judged))
            best = k;
    return best;
}

int speed_best(const struct speed_report *report, const char *group, double tolerance) {
    int best = -1;
    for (int k = 0; k < report->rows; k++)
        if (in_group(&report->row[k], group) && report->row[k].judged <= tolerance &&
            (best < 0 || report->row[k].seconds < report->row[best].seconds))
            best = k;
    return best;
}
