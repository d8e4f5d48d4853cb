# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libparticles.la
libparticles_la_SOURCES = \
	src/kernel/particles/box.c src/kernel/particles/box.h \
	src/kernel/particles/classes.c src/kernel/particles/classes.h \
	src/kernel/particles/fields.c src/kernel/particles/fields.h \
	src/kernel/particles/groups.c src/kernel/particles/groups.h \
	src/kernel/particles/kinds.c src/kernel/particles/kinds.h \
	src/kernel/particles/material.c src/kernel/particles/material.h \
	src/kernel/particles/particles.c src/kernel/particles/particles.h \
	src/kernel/particles/spin.c src/kernel/particles/spin.h \
	src/kernel/particles/storage.c src/kernel/particles/storage.h
