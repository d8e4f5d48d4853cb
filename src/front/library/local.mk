# SPDX-License-Identifier: BSD-3-Clause
# The libraries for other codes export what their map lists alone; the program is a main that calls scree_main.
noinst_LTLIBRARIES += libsearch.la libcalls.la
libsearch_la_SOURCES = %D%/scree_pairs.c src/scree_pairs.h
libcalls_la_SOURCES = \
	%D%/scree_fields.c %D%/scree_observe.c %D%/scree_parts.c %D%/scree_report.c %D%/scree_simulation.c \
	%D%/scree_stages.c %D%/scree_parts.h src/scree.h

include_HEADERS += src/scree.h src/scree_pairs.h
EXTRA_DIST += %D%/libscree-index.map %D%/libscree.map

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
