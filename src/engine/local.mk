# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libengine.la
libengine_la_SOURCES = \
	%D%/checked.c %D%/classify.c %D%/crossings.c %D%/decide.c %D%/deform.c %D%/folder.c %D%/fused.c %D%/guards.c \
	%D%/index_view.c %D%/load_balance.c %D%/notes.c %D%/outputs.c %D%/outputs_open.c %D%/physics_set.c \
	%D%/plan.c %D%/rebuild.c %D%/rebuild_rows.c %D%/resume.c %D%/resume_check.c %D%/run.c %D%/run_chain.c \
	%D%/run_directory.c %D%/run_report.c %D%/run_report_lists.c %D%/run_stages.c %D%/simulation.c \
	%D%/simulation_parts.c %D%/skin_auto.c %D%/sources.c %D%/stages.c %D%/stay.c %D%/step.c %D%/timing.c \
	%D%/trip.c %D%/tune.c %D%/values.c %D%/checked.h %D%/classify.h %D%/clock.h %D%/crossings.h %D%/decide.h \
	%D%/deform.h %D%/folder.h %D%/fused.h %D%/guards.h %D%/index_view.h %D%/load_balance.h %D%/notes.h \
	%D%/outputs.h %D%/outputs_parts.h %D%/physics.h %D%/physics_set.h %D%/plan.h %D%/rebuild.h \
	%D%/rebuild_rows.h %D%/report_part.h %D%/resume.h %D%/resume_check.h %D%/run.h %D%/run_record.h \
	%D%/run_report.h %D%/run_report_lists.h %D%/run_report_source.h %D%/run_stages.h %D%/simulation.h \
	%D%/simulation_parts.h %D%/skin_auto.h %D%/sources.h %D%/stages.h %D%/state.h %D%/step.h %D%/timing.h \
	%D%/trip.h %D%/tune.h %D%/values.h src/fields_table.h src/physics_table.h

# What writes the tables of docs/output.md, after a change of fields, observables, stages or the report
EXTRA_PROGRAMS += %D%/document_output
CLEANFILES += %D%/document_output
