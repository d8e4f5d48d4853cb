# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpairs.la
libpairs_la_SOURCES = \
	src/kernel/pairs/classes_choose.c src/kernel/pairs/classes_choose.h \
	src/kernel/pairs/history.c src/kernel/pairs/history.h \
	src/kernel/pairs/history_follow.c src/kernel/pairs/history_follow.h \
	src/kernel/pairs/history_keep.c src/kernel/pairs/history_keep.h \
	src/kernel/pairs/history_rows.c src/kernel/pairs/history_rows.h \
	src/kernel/pairs/interaction.c src/kernel/pairs/interaction.h \
	src/kernel/pairs/pairlist.c src/kernel/pairs/pairlist.h \
	src/kernel/pairs/pairlist_blocks.c \
	src/kernel/pairs/pairlist_build.c src/kernel/pairs/pairlist_build.h \
	src/kernel/pairs/pairlist_shares.c \
	src/kernel/pairs/ring.c src/kernel/pairs/ring.h \
	src/kernel/pairs/skin.c src/kernel/pairs/skin.h \
	src/kernel/pairs/skin_choice.c src/kernel/pairs/skin_choice.h \
	src/kernel/pairs/sweep.c src/kernel/pairs/sweep.h \
	src/kernel/pairs/walk.c src/kernel/pairs/walk.h \
	src/kernel/pairs/walk_filter.h \
	src/kernel/pairs/walk_four.h \
	src/kernel/pairs/walk_history.h \
	src/kernel/pairs/walk_kernel.h \
	src/kernel/pairs/walk_kernels.c \
	src/kernel/pairs/walk_ordered.c src/kernel/pairs/walk_ordered.h
libpairs_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libpairs_la_LIBADD = libwalk_baseline.la

# The stages of the walk, once for each instruction set
WALK_SOURCES = src/kernel/pairs/walk_block.c
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
