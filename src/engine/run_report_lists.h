/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of run_report.h: the rows of lists and groups, and the numbers of their entries. */
#ifndef SCREE_ENGINE_RUN_REPORT_LISTS_H
#define SCREE_ENGINE_RUN_REPORT_LISTS_H

#include "data/observe/report.h"

extern const struct report_row run_report_choice_rows[], run_report_level_rows[], run_report_class_rows[],
    run_report_insertion_rows[], run_report_scene_stage_rows[], run_report_stage_rows[],
    run_report_setup_rows[], run_report_solver_rows[], run_report_contacts_rows[];

int run_report_choices(const struct report_source *source);
int run_report_levels(const struct report_source *source);
int run_report_classes(const struct report_source *source);
int run_report_insertions(const struct report_source *source);
int run_report_scene_stages(const struct report_source *source);
int run_report_stages(const struct report_source *source);
int run_report_solvers(const struct report_source *source);
int run_report_contacts(const struct report_source *source);

#endif
