# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libengine.la
libengine_la_SOURCES = \
	src/engine/checked.c \
	src/engine/checked.h \
	src/engine/classify.c \
	src/engine/classify.h \
	src/engine/clock.h \
	src/engine/crossings.c \
	src/engine/crossings.h \
	src/engine/decide.c \
	src/engine/decide.h \
	src/engine/deform.c \
	src/engine/deform.h \
	src/engine/folder.c \
	src/engine/folder.h \
	src/engine/guards.c \
	src/engine/guards.h \
	src/engine/load_balance.c \
	src/engine/load_balance.h \
	src/engine/notes.c \
	src/engine/notes.h \
	src/engine/order.c \
	src/engine/order.h \
	src/engine/order_plan.c \
	src/engine/order_plan.h \
	src/engine/outputs.c \
	src/engine/outputs.h \
	src/engine/outputs_open.c \
	src/engine/outputs_parts.h \
	src/engine/physics.c \
	src/engine/physics.h \
	src/fields_table.h \
	src/physics_table.h \
	src/engine/plan.c \
	src/engine/plan.h \
	src/engine/rebuild.c \
	src/engine/rebuild.h \
	src/engine/rebuild_rows.c \
	src/engine/rebuild_rows.h \
	src/engine/report_part.h \
	src/engine/resume.c \
	src/engine/resume.h \
	src/engine/resume_check.c \
	src/engine/resume_check.h \
	src/engine/run.c \
	src/engine/run.h \
	src/engine/run_chain.c \
	src/engine/run_directory.c \
	src/engine/run_record.h \
	src/engine/run_report.c \
	src/engine/run_report.h \
	src/engine/run_report_lists.c \
	src/engine/run_report_lists.h \
	src/engine/run_report_source.h \
	src/engine/run_stages.c \
	src/engine/run_stages.h \
	src/engine/simulation.c \
	src/engine/simulation.h \
	src/engine/simulation_parts.c \
	src/engine/simulation_parts.h \
	src/engine/sources.c \
	src/engine/sources.h \
	src/engine/skin_auto.c \
	src/engine/skin_auto.h \
	src/engine/stages.c \
	src/engine/stages.h \
	src/engine/stay.c \
	src/engine/stay.h \
	src/engine/state.h \
	src/engine/step.c \
	src/engine/step.h \
	src/engine/timing.c \
	src/engine/timing.h \
	src/engine/trip.c \
	src/engine/trip.h \
	src/engine/tune.c \
	src/engine/tune.h \
	src/engine/values.c \
	src/engine/values.h \
	src/engine/index_view.c \
	src/engine/index_view.h
libengine_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)

# What writes the tables of docs/output.md, after a change of fields, observables, stages or the report
EXTRA_PROGRAMS += src/engine/document_output
CLEANFILES += src/engine/document_output
src_engine_document_output_SOURCES = src/engine/document_output.c
src_engine_document_output_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
src_engine_document_output_LDADD = $(ENGINE_LIBS)
