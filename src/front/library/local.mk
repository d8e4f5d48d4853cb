# SPDX-License-Identifier: BSD-3-Clause
# The libraries for other codes export what their map lists alone; the program is a main that calls scree_main.
noinst_LTLIBRARIES += libsearch.la libcalls.la
libsearch_la_SOURCES = src/front/library/scree_pairs.c src/scree_pairs.h
libcalls_la_SOURCES = \
	src/front/library/scree_fields.c \
	src/front/library/scree_observe.c \
	src/front/library/scree_observe.h \
	src/front/library/scree_parts.c \
	src/front/library/scree_parts.h \
	src/front/library/scree_report.c \
	src/front/library/scree_report.h \
	src/front/library/scree_simulation.c \
	src/front/library/scree_stages.c \
	src/front/library/scree_stages.h \
	src/scree.h
libcalls_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)

include_HEADERS += src/scree.h src/scree_pairs.h
EXTRA_DIST += src/front/library/libscree.map src/front/library/libscree-index.map

lib_LTLIBRARIES += libscree.la libscree-index.la
libscree_la_SOURCES =
libscree_la_LIBADD = $(APP_LIBS)
libscree_la_LDFLAGS = $(AM_LDFLAGS) -Wl,--version-script=$(srcdir)/src/front/library/libscree.map -version-info 0:0:0
EXTRA_libscree_la_DEPENDENCIES = src/front/library/libscree.map

# The contact search without MPI and HDF5
libscree_index_la_SOURCES =
libscree_index_la_LIBADD = libsearch.la $(PAIRS_LIBS)
libscree_index_la_LDFLAGS = $(AM_LDFLAGS) -Wl,--version-script=$(srcdir)/src/front/library/libscree-index.map -version-info 0:0:0
EXTRA_libscree_index_la_DEPENDENCIES = src/front/library/libscree-index.map
