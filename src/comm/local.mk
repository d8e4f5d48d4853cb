# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcomm.la
libcomm_la_SOURCES = \
	src/comm/balance.h \
	src/comm/alone.c src/comm/alone.h \
	src/comm/comm.c src/comm/comm.h \
	src/comm/copies.c src/comm/copies.h \
	src/comm/cores.c src/comm/cores.h \
	src/comm/domain.c src/comm/domain.h \
	src/comm/domain_grid.c src/comm/domain_grid.h \
	src/comm/domain_tree.c src/comm/domain_tree.h \
	src/comm/exchange.c src/comm/exchange.h \
	src/comm/ghosts.c src/comm/ghosts.h src/comm/ghosts_parts.h \
	src/comm/ghosts_count.c \
	src/comm/ghosts_stay.c \
	src/comm/ghosts_used.c \
	src/comm/ghosts_part.c src/comm/ghosts_part.h \
	src/comm/groups.c src/comm/groups.h \
	src/comm/migrate.c src/comm/migrate.h \
	src/comm/shadows.c src/comm/shadows.h \
	src/comm/files.c src/comm/files.h
libcomm_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
libcomm_la_LIBADD = $(MPI_LIBS)
if HAVE_ZOLTAN
libcomm_la_SOURCES += src/comm/balance_zoltan.c
libcomm_la_CPPFLAGS += $(ZOLTAN_CFLAGS)
libcomm_la_LIBADD += $(ZOLTAN_LIBS)
else
libcomm_la_SOURCES += src/comm/balance_none.c
endif
