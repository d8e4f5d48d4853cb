# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcomm.la
libcomm_la_SOURCES = \
	%D%/alone.c %D%/comm.c %D%/copies.c %D%/cores.c %D%/domain.c %D%/domain_grid.c %D%/domain_tree.c \
	%D%/exchange.c %D%/files.c %D%/ghosts.c %D%/ghosts_count.c %D%/ghosts_part.c %D%/ghosts_stay.c \
	%D%/ghosts_used.c %D%/migrate.c %D%/rank_groups.c %D%/shadows.c %D%/alone.h %D%/balance.h %D%/comm.h \
	%D%/copies.h %D%/cores.h %D%/domain.h %D%/domain_grid.h %D%/domain_tree.h %D%/exchange.h %D%/files.h \
	%D%/ghosts.h %D%/ghosts_parts.h %D%/migrate.h %D%/rank_groups.h %D%/shadows.h
libcomm_la_CPPFLAGS = $(AM_CPPFLAGS)
libcomm_la_LIBADD = $(MPI_LIBS)
if HAVE_ZOLTAN
libcomm_la_SOURCES += %D%/balance_zoltan.c
libcomm_la_CPPFLAGS += $(ZOLTAN_CFLAGS)
libcomm_la_LIBADD += $(ZOLTAN_LIBS)
else
libcomm_la_SOURCES += %D%/balance_none.c
endif
