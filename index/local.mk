noinst_LTLIBRARIES += libindex.la
libindex_la_SOURCES = \
	index/brute.c \
	index/bytype.c \
	index/cells.c \
	index/cells.h \
	index/cells_sort.c \
	index/cells_sort.h \
	index/exact.h \
	index/frame.c \
	index/frame.h \
	index/grid.c \
	index/grid.h \
	index/hgrid.c \
	index/index.c \
	index/index.h \
	index/lanes_avx2.h \
	index/lanes_avx512.h \
	index/lanes_plain.h \
	index/levels.c \
	index/levels.h \
	index/levels_index.c \
	index/levels_index.h \
	index/linkcell.c \
	index/members.c \
	index/members.h \
	index/multi.c \
	index/registry.c \
	index/search.h \
	index/search_avx2.c \
	index/search_avx512.c \
	index/search_gather.h \
	index/search_plain.c \
	index/search_rows.h \
	index/search_test.h \
	index/stencil.c \
	index/stencil.h
