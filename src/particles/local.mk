# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libparticles.la
libparticles_la_SOURCES = \
	src/particles/box.c src/particles/box.h \
	src/particles/classes.c src/particles/classes.h \
	src/particles/fields.c src/particles/fields.h \
	src/particles/groups.c src/particles/groups.h \
	src/particles/kinds.c src/particles/kinds.h \
	src/particles/material.c src/particles/material.h \
	src/particles/particles.c src/particles/particles.h \
	src/particles/spin.c src/particles/spin.h \
	src/particles/storage.c src/particles/storage.h
