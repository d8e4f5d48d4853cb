# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libindex.la
libindex_la_SOURCES = \
	%D%/choose/auto_choose.c %D%/choose/cost.c %D%/grids/cells.c %D%/grids/cells_follow.c \
	%D%/grids/cells_slots.c %D%/grids/cells_sort.c %D%/grids/cross.c %D%/grids/grid.c %D%/grids/grid_frame.c \
	%D%/grids/locate.c %D%/grids/members.c %D%/grids/stencil.c %D%/index.c %D%/levels/levels.c \
	%D%/levels/levels_index.c %D%/levels/levels_plan.c %D%/levels/levels_stay.c %D%/methods/auto.c \
	%D%/methods/brute.c %D%/methods/bytype.c %D%/methods/hgrid.c %D%/methods/linkcell.c %D%/methods/multi.c \
	%D%/methods/registry.c %D%/prices.c %D%/search/search.c %D%/search/search_avx2.c %D%/search/search_avx512.c \
	%D%/search/search_plain.c %D%/choose/auto_choose.h %D%/choose/cost.h %D%/exact_test.h %D%/grids/cells.h \
	%D%/grids/cells_slots.h %D%/grids/cells_sort.h %D%/grids/cells_table.h %D%/grids/cross.h %D%/grids/grid.h \
	%D%/grids/grid_frame.h %D%/grids/levels_parts.h %D%/grids/members.h %D%/grids/stencil.h %D%/index.h \
	%D%/levels/levels.h %D%/levels/levels_index.h %D%/levels/levels_plan.h %D%/levels/levels_stay.h %D%/prices.h \
	%D%/search/lanes_avx2.h %D%/search/lanes_avx512.h %D%/search/lanes_plain.h %D%/search/search.h \
	%D%/search/search_direct.h %D%/search/search_gather.h %D%/search/search_pairs.h %D%/search/search_rows.h \
	%D%/search_sizes.h
