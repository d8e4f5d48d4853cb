# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbodies.la
libbodies_la_SOURCES = \
	%D%/bodies_fields.c %D%/bodies_links.c %D%/bodies_motion.c %D%/bodies_physics.c %D%/bodies_rows.c \
	%D%/bodies_shapes.c %D%/clump.c %D%/forms.c %D%/inscribe.c %D%/place.c %D%/rock.c %D%/rocks_check.c \
	%D%/rocks_ends.c %D%/rocks_force.c %D%/rocks_near.c %D%/rocks_pairs.c %D%/rocks_stiff.c %D%/rocks_walls.c \
	%D%/shapes/chamfer.c %D%/shapes/convex.c %D%/shapes/deep.c %D%/shapes/feature.c %D%/shapes/gjk.c \
	%D%/shapes/recall.c %D%/shapes/solid.c %D%/shapes/stiff.c %D%/shapes/touch.c %D%/sums.c %D%/bodies.h %D%/bodies_fields.h \
	%D%/bodies_links.h %D%/bodies_parts.h %D%/bodies_shapes.h %D%/clump.h %D%/inscribe.h %D%/rock.h %D%/rocks.h \
	%D%/rocks_ends.h %D%/rocks_near.h %D%/rocks_state.h %D%/shapes/chamfer.h %D%/shapes/convex.h \
	%D%/shapes/deep.h %D%/shapes/feature.h %D%/shapes/gjk.h %D%/shapes/posed.h %D%/shapes/recall.h %D%/shapes/solid.h \
	%D%/shapes/stiff.h %D%/shapes/touch.h %D%/shapes/touch_point.h %D%/sums.h
libbodies_la_CPPFLAGS = $(AM_CPPFLAGS) $(QHULL_CFLAGS)
libbodies_la_LIBADD = $(QHULL_LIBS)
PHYSICS_LIBS += libbodies.la
