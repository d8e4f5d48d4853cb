# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpack.la
libpack_la_SOURCES = \
	src/front/pack/bed.c src/front/pack/bed.h \
	src/front/pack/hull.c src/front/pack/hull.h \
	src/front/pack/laws.c src/front/pack/laws.h \
	src/front/pack/pack.c src/front/pack/pack.h \
	src/front/pack/recipe.c src/front/pack/recipe.h \
	src/front/pack/recipe_sizes.c src/front/pack/recipe_sizes.h \
	src/front/pack/recipe_work.c src/front/pack/recipe_work.h
libpack_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
