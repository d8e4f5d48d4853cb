# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbodies.la
libbodies_la_SOURCES = \
	%D%/bodies_fields.c %D%/bodies_links.c %D%/bodies_motion.c %D%/bodies_physics.c %D%/bodies_rows.c \
	%D%/clump.c %D%/inscribe.c %D%/moments.c %D%/place.c %D%/rotor.c %D%/sums.c %D%/bodies.h %D%/bodies_fields.h \
	%D%/bodies_links.h %D%/bodies_parts.h %D%/clump.h %D%/inscribe.h %D%/moments.h %D%/rotor.h %D%/sums.h
PHYSICS_LIBS += libbodies.la
