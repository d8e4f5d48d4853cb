# SPDX-License-Identifier: BSD-3-Clause
# Tests of the whole program: bash scripts, started by tests/launch.

EXTRA_DIST += tests/app/near.awk
EXTRA_DIST += tests/app/common.sh tests/app/forces.sh tests/app/scenes.sh
EXTRA_DIST += tests/app/lammps/hertz.data tests/app/lammps/hertz0.dump.gz tests/app/lammps/hertz200.dump.gz \
	tests/app/lammps/in.hertz
dist_check_SCRIPTS += \
	tests/app/ablate.sh \
	tests/app/bad_input.sh \
	tests/app/belt.sh \
	tests/app/bodies.sh \
	tests/app/cohesion.sh \
	tests/app/density.sh \
	tests/app/drag.sh \
	tests/app/dust.sh \
	tests/app/endless.sh \
	tests/app/entries.sh \
	tests/app/features.sh \
	tests/app/fluid.sh \
	tests/app/fluid_bodies.sh \
	tests/app/fluid_scalars.sh \
	tests/app/folder.sh \
	tests/app/guards.sh \
	tests/app/hard.sh \
	tests/app/bonds.sh \
	tests/app/heat.sh \
	tests/app/ids.sh \
	tests/app/lammps.sh \
	tests/app/layouts.sh \
	tests/app/many.sh \
	tests/app/needs.sh \
	tests/app/observables.sh \
	tests/app/pack.sh \
	tests/app/physics.sh \
	tests/app/picture.sh \
	tests/app/report.sh \
	tests/app/restart.sh \
	tests/app/resume.sh \
	tests/app/site.sh \
	tests/app/solver.sh \
	tests/app/solver_features.sh \
	tests/app/stability.sh \
	tests/app/stages.sh \
	tests/app/terminal.sh \
	tests/app/user_law.sh \
	tests/app/threads.sh \
	tests/app/view.sh

dist_check_SCRIPTS += tests/app/readers.sh
EXTRA_DIST += tests/app/readers.py
dist_check_SCRIPTS += tests/app/ranks.sh tests/app/shear.sh tests/app/stress.sh

dist_check_SCRIPTS += tests/app/drum.sh tests/app/pores.sh tests/app/verify.sh

dist_check_SCRIPTS += tests/app/pages.sh tests/app/reproducible.sh

# faults.sh makes one message or one write too short by libraries that stand before MPI
dist_check_SCRIPTS += tests/app/faults.sh
check_LTLIBRARIES += tests/app/cut_message.la tests/app/cut_write.la
tests_app_cut_message_la_SOURCES = tests/app/cut_message.c
tests_app_cut_message_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
tests_app_cut_message_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_cut_message_la_LIBADD = $(MPI_LIBS)
tests_app_cut_write_la_SOURCES = tests/app/cut_write.c
tests_app_cut_write_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
tests_app_cut_write_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_cut_write_la_LIBADD = $(MPI_LIBS) -ldl
tests/app/faults.log: tests/app/cut_message.la tests/app/cut_write.la

# unreadable.sh makes calls on files fail by a library that stands before the C library
dist_check_SCRIPTS += tests/app/unreadable.sh
check_LTLIBRARIES += tests/app/fail_call.la
tests_app_fail_call_la_SOURCES = tests/app/fail_call.c
tests_app_fail_call_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_fail_call_la_LIBADD = -ldl
tests/app/unreadable.log: tests/app/fail_call.la

# Random scenes: 12, or 200 by check-long
dist_check_SCRIPTS += tests/app/random_scenes.sh
tests/app/random_scenes.log tests/app/ranks.log: tests/checkpoint_lines

# The libraries and the programs that use them
dist_check_SCRIPTS += tests/app/library.sh
tests/app/library.log: libscree.la libscree-index.la

# Without AVX, and on emulated CPUs where qemu-user is there
dist_check_SCRIPTS += tests/app/baseline.sh

# The benchmarks, tiny
dist_check_SCRIPTS += tests/app/bench.sh
tests/app/bench.log: tests/bench_triad tests/index/bench_index
