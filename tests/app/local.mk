# SPDX-License-Identifier: BSD-3-Clause
# Tests of the whole program: bash scripts, started by tests/launch.

EXTRA_DIST += \
	%D%/common.sh %D%/forces.sh %D%/lammps/hertz.data %D%/lammps/hertz0.dump.gz %D%/lammps/hertz200.dump.gz \
	%D%/lammps/in.hertz %D%/near.awk %D%/readers.py %D%/scenes.sh
dist_check_SCRIPTS += \
	%D%/ablate.sh %D%/bad_input.sh %D%/baseline.sh %D%/belt.sh %D%/bench.sh %D%/benchmarks.sh \
	%D%/bodies.sh %D%/bodies_bonds.sh %D%/bodies_boxes.sh %D%/bodies_come.sh %D%/bodies_drag.sh \
	%D%/bonds.sh %D%/cohesion.sh %D%/density.sh %D%/drag.sh %D%/drum.sh %D%/dust.sh %D%/endless.sh \
	%D%/entries.sh %D%/faults.sh %D%/features.sh %D%/field_walls.sh %D%/fluid.sh %D%/fluid_bodies.sh \
	%D%/fluid_rigid.sh %D%/fluid_rigid_bodies.sh %D%/fluid_rigid_scalars.sh %D%/fluid_rigid_walls.sh \
	%D%/fluid_scalars.sh %D%/folder.sh %D%/free_walls.sh %D%/gas.sh %D%/guards.sh %D%/hard.sh %D%/heat.sh \
	%D%/ids.sh %D%/lammps.sh %D%/layouts.sh %D%/library.sh %D%/many.sh %D%/needs.sh %D%/observables.sh \
	%D%/oracle.sh %D%/pack.sh %D%/pages.sh %D%/physics.sh %D%/picture.sh %D%/pores.sh \
	%D%/random_scenes.sh %D%/ranks.sh %D%/readers.sh %D%/report.sh %D%/reproducible.sh %D%/restart.sh \
	%D%/resume.sh %D%/rocks.sh %D%/rocks_files.sh %D%/rocks_shown.sh %D%/rocks_sources.sh \
	%D%/rocks_walls.sh %D%/shear.sh %D%/site.sh %D%/solver.sh %D%/solver_features.sh %D%/solver_newton.sh \
	%D%/solver_pull.sh %D%/solver_resist.sh %D%/solver_rocks.sh %D%/solver_table.sh %D%/stability.sh \
	%D%/stages.sh %D%/stress.sh %D%/terminal.sh %D%/threads.sh %D%/unreadable.sh %D%/user_law.sh \
	%D%/verify.sh %D%/view.sh %D%/wall_contacts.sh

# faults.sh makes one message or one write too short by libraries that stand before MPI
check_LTLIBRARIES += tests/app/cut_message.la tests/app/cut_write.la
tests_app_cut_message_la_SOURCES = %D%/cut_message.c
tests_app_cut_message_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_cut_message_la_LIBADD = $(MPI_LIBS)
tests_app_cut_write_la_SOURCES = %D%/cut_write.c
tests_app_cut_write_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_cut_write_la_LIBADD = $(MPI_LIBS) -ldl
tests/app/faults.log: tests/app/cut_message.la tests/app/cut_write.la

# unreadable.sh makes calls on files fail by a library that stands before the C library
check_LTLIBRARIES += tests/app/fail_call.la
tests_app_fail_call_la_SOURCES = %D%/fail_call.c
tests_app_fail_call_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -shared -rpath /nowhere
tests_app_fail_call_la_LIBADD = -ldl
tests/app/unreadable.log: tests/app/fail_call.la

# The libraries and the programs that use them
tests/app/library.log: libscree.la libscree-index.la
