# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libhard.la
libhard_la_SOURCES = \
	%D%/border.c %D%/colour.c %D%/contacts.c %D%/hard_check.c %D%/hard_physics.c %D%/hard_rows.c \
	%D%/hard_solve.c %D%/newton.c %D%/newton_blocks.c %D%/pairs.c %D%/problem.c %D%/border.h %D%/colour.h \
	%D%/contacts.h %D%/hard.h %D%/hard_solve.h %D%/hard_state.h %D%/newton.h %D%/newton_blocks.h \
	%D%/newton_row.h %D%/pairs.h %D%/problem.h %D%/row.h
PHYSICS_LIBS += libhard.la
