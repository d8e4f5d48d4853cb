# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpack.la
libpack_la_SOURCES = \
	%D%/bed.c %D%/hull.c %D%/laws.c %D%/pack.c %D%/recipe.c %D%/recipe_sizes.c %D%/recipe_work.c %D%/hull.h \
	%D%/laws.h %D%/pack.h %D%/recipe.h %D%/recipe_work.h
