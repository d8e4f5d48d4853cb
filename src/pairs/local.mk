# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpairs.la
libpairs_la_SOURCES = \
	src/pairs/classes_choose.c src/pairs/classes_choose.h \
	src/pairs/history.c src/pairs/history.h \
	src/pairs/history_follow.c src/pairs/history_follow.h \
	src/pairs/history_keep.c src/pairs/history_keep.h \
	src/pairs/interaction.c src/pairs/interaction.h \
	src/pairs/pairlist.c src/pairs/pairlist.h \
	src/pairs/pairlist_shares.c src/pairs/pairlist_build.c src/pairs/pairlist_build.h \
	src/pairs/ring.c src/pairs/ring.h \
	src/pairs/rowset.c src/pairs/rowset.h \
	src/pairs/skin.c src/pairs/skin.h \
	src/pairs/skin_choice.c src/pairs/skin_choice.h \
	src/pairs/sweep.c src/pairs/sweep.h \
	src/pairs/walk.c src/pairs/walk.h \
	src/pairs/walk_filter.h \
	src/pairs/walk_four.h \
	src/pairs/walk_history.h \
	src/pairs/walk_kernel.h \
	src/pairs/walk_kernels.c \
	src/pairs/walk_ordered.c src/pairs/walk_ordered.h
libpairs_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libpairs_la_LIBADD = libwalk_baseline.la

# The stages of the walk, once for each instruction set
WALK_SOURCES = src/pairs/walk_block.c
noinst_LTLIBRARIES += libwalk_baseline.la
libwalk_baseline_la_SOURCES = $(WALK_SOURCES)
libwalk_baseline_la_CFLAGS = $(KERNEL_CFLAGS)
libwalk_baseline_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_baseline
if X86_KERNELS
noinst_LTLIBRARIES += libwalk_v3.la libwalk_v4.la
libwalk_v3_la_SOURCES = $(WALK_SOURCES)
libwalk_v3_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V3)
libwalk_v3_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_v3
libwalk_v4_la_SOURCES = $(WALK_SOURCES)
libwalk_v4_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V4)
libwalk_v4_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_v4
libpairs_la_LIBADD += libwalk_v3.la libwalk_v4.la
endif
