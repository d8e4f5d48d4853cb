# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcomm.la
libcomm_la_SOURCES = \
	src/kernel/comm/balance.h \
	src/kernel/comm/alone.c src/kernel/comm/alone.h \
	src/kernel/comm/comm.c src/kernel/comm/comm.h \
	src/kernel/comm/copies.c src/kernel/comm/copies.h \
	src/kernel/comm/cores.c src/kernel/comm/cores.h \
	src/kernel/comm/domain.c src/kernel/comm/domain.h \
	src/kernel/comm/domain_grid.c src/kernel/comm/domain_grid.h \
	src/kernel/comm/domain_tree.c src/kernel/comm/domain_tree.h \
	src/kernel/comm/exchange.c src/kernel/comm/exchange.h \
	src/kernel/comm/ghosts.c src/kernel/comm/ghosts.h src/kernel/comm/ghosts_parts.h \
	src/kernel/comm/ghosts_count.c \
	src/kernel/comm/ghosts_stay.c \
	src/kernel/comm/ghosts_used.c \
	src/kernel/comm/ghosts_part.c src/kernel/comm/ghosts_part.h \
	src/kernel/comm/rank_groups.c src/kernel/comm/rank_groups.h \
	src/kernel/comm/migrate.c src/kernel/comm/migrate.h \
	src/kernel/comm/shadows.c src/kernel/comm/shadows.h \
	src/kernel/comm/files.c src/kernel/comm/files.h
libcomm_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
libcomm_la_LIBADD = $(MPI_LIBS)
if HAVE_ZOLTAN
libcomm_la_SOURCES += src/kernel/comm/balance_zoltan.c
libcomm_la_CPPFLAGS += $(ZOLTAN_CFLAGS)
libcomm_la_LIBADD += $(ZOLTAN_LIBS)
else
libcomm_la_SOURCES += src/kernel/comm/balance_none.c
endif
