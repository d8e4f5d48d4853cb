# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libintegrate.la
libintegrate_la_SOURCES = \
	src/physics/grains/motion/carried.c \
	src/physics/grains/motion/carried.h \
	src/physics/grains/motion/integrator.c \
	src/physics/grains/motion/integrator.h \
	src/physics/grains/motion/stability.c \
	src/physics/grains/motion/stability.h \
	src/physics/grains/motion/timestep.c \
	src/physics/grains/motion/timestep.h
