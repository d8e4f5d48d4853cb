# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libwalls.la
libwalls_la_SOURCES = \
	src/physics/grains/walls/mesh.c \
	src/physics/grains/walls/mesh.h \
	src/physics/grains/walls/mesh_obj.c \
	src/physics/grains/walls/mesh_ply.c \
	src/physics/grains/walls/mesh_polygon.c \
	src/physics/grains/walls/mesh_shape.c \
	src/physics/grains/walls/mesh_shape.h \
	src/physics/grains/walls/mesh_stl.c \
	src/physics/grains/walls/wall.h \
	src/physics/grains/walls/wall_area.c \
	src/physics/grains/walls/wall_area.h \
	src/physics/grains/walls/wall_grid.c \
	src/physics/grains/walls/wall_grid.h \
	src/physics/grains/walls/wall_inside.c \
	src/physics/grains/walls/wall_inside.h \
	src/physics/grains/walls/wall_mesh.c \
	src/physics/grains/walls/wall_mesh.h \
	src/physics/grains/walls/wall_motion.c \
	src/physics/grains/walls/wall_motion.h \
	src/physics/grains/walls/wall_patch.c \
	src/physics/grains/walls/wall_surface.c \
	src/physics/grains/walls/wall_touch.c \
	src/physics/grains/walls/wall_touch.h \
	src/physics/grains/walls/walls.c \
	src/physics/grains/walls/walls_displacement.c \
	src/physics/grains/walls/walls_foot.c \
	src/physics/grains/walls/walls_force.c \
	src/physics/grains/walls/walls_history.c \
	src/physics/grains/walls/walls_history.h \
	src/physics/grains/walls/walls_near.c \
	src/physics/grains/walls/walls_near.h \
	src/physics/grains/walls/walls_overlap.c \
	src/physics/grains/walls/walls_parts.h \
	src/physics/grains/walls/walls_pose.c \
	src/physics/grains/walls/walls_sums.c \
	src/physics/grains/walls/walls_visit.c \
	src/physics/grains/walls/walls_touch.c \
	src/physics/grains/walls/walls_touch.h
