# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libobserve.la
libobserve_la_SOURCES = \
	%D%/crossing.c %D%/describe.c %D%/expression.c %D%/observables.c %D%/observables_bulk.c \
	%D%/observables_expression.c %D%/observables_flow.c %D%/observables_grid.c %D%/observables_kinds.c \
	%D%/observables_row.c %D%/observables_single.c %D%/observables_state.c %D%/observables_stress.c \
	%D%/progress.c %D%/report.c %D%/report_json.c %D%/report_print.c %D%/crossing.h %D%/describe.h \
	%D%/expression.h %D%/observables.h %D%/observables_grid.h %D%/observables_kinds.h %D%/progress.h \
	%D%/report.h %D%/report_json.h %D%/report_print.h
libobserve_la_CPPFLAGS = $(AM_CPPFLAGS) $(MUPARSER_CFLAGS)
libobserve_la_LIBADD = $(MUPARSER_LIBS)

EXTRA_DIST += docs/output.md
