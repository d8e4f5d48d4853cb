# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libobserve.la
libobserve_la_SOURCES = \
	src/data/observe/crossing.c \
	src/data/observe/crossing.h \
	src/data/observe/describe.c \
	src/data/observe/describe.h \
	src/data/observe/expression.c \
	src/data/observe/expression.h \
	src/data/observe/observables.c \
	src/data/observe/observables.h \
	src/data/observe/observables_bulk.c \
	src/data/observe/observables_expression.c \
	src/data/observe/observables_flow.c \
	src/data/observe/observables_grid.c \
	src/data/observe/observables_grid.h \
	src/data/observe/observables_kinds.c \
	src/data/observe/observables_kinds.h \
	src/data/observe/observables_row.c \
	src/data/observe/observables_single.c \
	src/data/observe/observables_state.c \
	src/data/observe/observables_stress.c \
	src/data/observe/progress.c \
	src/data/observe/progress.h \
	src/data/observe/report.c \
	src/data/observe/report.h \
	src/data/observe/report_json.c \
	src/data/observe/report_json.h \
	src/data/observe/report_print.c \
	src/data/observe/report_print.h
libobserve_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(MUPARSER_CFLAGS)
libobserve_la_LIBADD = $(MUPARSER_LIBS)

EXTRA_DIST += docs/output.md
