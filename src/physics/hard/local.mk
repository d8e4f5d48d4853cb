# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libhard.la
libhard_la_SOURCES = \
	%D%/border.c %D%/clumps.c %D%/colour.c %D%/contacts.c %D%/contacts_memory.c %D%/contacts_row.c \
	%D%/contacts_thin.c %D%/couple.c %D%/general.c %D%/hard_check.c %D%/hard_file.c %D%/hard_notes.c \
	%D%/hard_physics.c %D%/hard_rows.c %D%/hard_sizes.c %D%/hard_solve.c %D%/hard_terms.c %D%/local_form.c \
	%D%/models.c %D%/newton.c %D%/newton_blocks.c %D%/offers.c %D%/offers_memory.c %D%/pairs.c %D%/problem.c \
	%D%/thin.c %D%/arm.h %D%/border.h %D%/clumps.h %D%/colour.h %D%/contacts.h %D%/hard.h %D%/hard_solve.h \
	%D%/hard_state.h %D%/local_form.h %D%/models.h %D%/newton.h %D%/newton_blocks.h %D%/newton_body.h \
	%D%/newton_row.h %D%/offers.h %D%/pairs.h %D%/problem.h %D%/resist.h %D%/row.h %D%/thin.h
PHYSICS_LIBS += libhard.la
