# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libobserve.la
libobserve_la_SOURCES = \
	src/observe/crossing.c \
	src/observe/crossing.h \
	src/observe/describe.c \
	src/observe/describe.h \
	src/observe/expression.c \
	src/observe/expression.h \
	src/observe/grid.c \
	src/observe/grid.h \
	src/observe/observables.c \
	src/observe/observables.h \
	src/observe/observables_bulk.c \
	src/observe/observables_expression.c \
	src/observe/observables_flow.c \
	src/observe/observables_kinds.h \
	src/observe/observables_row.c \
	src/observe/observables_single.c \
	src/observe/observables_state.c \
	src/observe/observables_stress.c \
	src/observe/progress.c \
	src/observe/progress.h \
	src/observe/report.c \
	src/observe/report.h \
	src/observe/report_json.c \
	src/observe/report_json.h \
	src/observe/report_print.c \
	src/observe/report_print.h \
	src/observe/report_rows.c \
	src/observe/report_rows.h
libobserve_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(MUPARSER_CFLAGS)
libobserve_la_LIBADD = $(MUPARSER_LIBS)

EXTRA_DIST += docs/output.md
