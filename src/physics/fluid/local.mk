# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libfluid.la
libfluid_la_SOURCES = \
	%D%/carried/applied_field.c %D%/carried/electrolyte.c %D%/carried/electrolyte_fields.c \
	%D%/carried/electrolyte_rows.c %D%/carried/layer.c %D%/carried/observe_scalars.c \
	%D%/carried/scalar_links.c %D%/carried/scalars.c %D%/carried/scalars_fields.c \
	%D%/carried/scalars_rows.c %D%/carried/shares.c %D%/coupling/boundary_motion.c \
	%D%/coupling/coupled_solve.c %D%/coupling/grain_coupling.c %D%/coupling/lubrication.c \
	%D%/coupling/lubrication_pairs.c %D%/coupling/rigid_bodies.c %D%/coupling/rigid_fields.c \
	%D%/coupling/rigid_grains.c %D%/coupling/rigid_motion.c %D%/coupling/rigid_step.c \
	%D%/coupling/rigid_suits.c %D%/coupling/rigid_sums.c %D%/coupling/rigid_walls.c \
	%D%/coupling/solid_field.c %D%/coupling/surface_loads.c %D%/coupling/unresolved_grains.c \
	%D%/coupling/unresolved_shares.c %D%/flow_output.c %D%/fluid.c %D%/fluid_fields.c %D%/fluid_physics.c \
	%D%/fluid_rows.c %D%/lattice/arrangement.c %D%/lattice/body_surfaces.c %D%/lattice/lattice_fill.c \
	%D%/lattice/lattice_fill_open.c %D%/lattice/mirror.c %D%/lattice/narrow_gaps.c %D%/lattice/nodes.c \
	%D%/lattice/pattern.c %D%/lattice/regions.c %D%/lattice/surface_feet.c %D%/lattice/surface_marks.c \
	%D%/observe_drag.c %D%/observe_flow.c %D%/operators/assembly.c %D%/operators/correction_tensors.c \
	%D%/operators/gradient_correction.c %D%/operators/kernel.c %D%/operators/mls.c \
	%D%/operators/neighbour_fluxes.c %D%/operators/operators.c %D%/operators/surface_forces.c \
	%D%/operators/weights.c %D%/schemes/anderson.c %D%/schemes/boundary_values.c %D%/schemes/flow.c \
	%D%/schemes/flow_drive.c %D%/schemes/flow_fields.c %D%/schemes/flow_loss.c %D%/schemes/fluid_motion.c \
	%D%/schemes/fluid_passes.c %D%/schemes/momentum.c %D%/schemes/moving_step.c %D%/schemes/open_sides.c \
	%D%/schemes/particle_shift.c %D%/schemes/pressure.c %D%/schemes/projection.c %D%/schemes/residual.c \
	%D%/schemes/schur.c %D%/schemes/solver_watch.c %D%/schemes/steady.c %D%/carried/applied_field.h \
	%D%/carried/electrolyte.h %D%/carried/electrolyte_fields.h %D%/carried/electrolyte_rows.h \
	%D%/carried/layer.h %D%/carried/scalar_links.h %D%/carried/scalars.h %D%/carried/scalars_fields.h \
	%D%/carried/scalars_rows.h %D%/carried/shares.h %D%/coupling/boundary_motion.h \
	%D%/coupling/coupled_solve.h %D%/coupling/grain_coupling.h %D%/coupling/lubrication.h \
	%D%/coupling/lubrication_pairs.h %D%/coupling/rigid_bodies.h %D%/coupling/rigid_fields.h \
	%D%/coupling/rigid_grains.h %D%/coupling/rigid_motion.h %D%/coupling/rigid_step.h \
	%D%/coupling/rigid_suits.h %D%/coupling/rigid_sums.h %D%/coupling/rigid_walls.h \
	%D%/coupling/solid_field.h %D%/coupling/surface_loads.h %D%/coupling/unresolved_grains.h \
	%D%/coupling/unresolved_shares.h %D%/flow_output.h %D%/fluid.h %D%/fluid_fields.h %D%/fluid_state.h \
	%D%/lattice/arrangement.h %D%/lattice/body_surfaces.h %D%/lattice/lattice_fill.h \
	%D%/lattice/lattice_fill_parts.h %D%/lattice/mirror.h %D%/lattice/narrow_gaps.h %D%/lattice/nodes.h \
	%D%/lattice/pattern.h %D%/lattice/regions.h %D%/lattice/surface_feet.h %D%/observe_flow.h \
	%D%/operators/assembly.h %D%/operators/correction_tensors.h %D%/operators/gradient_correction.h \
	%D%/operators/kernel.h %D%/operators/mls.h %D%/operators/neighbour_fluxes.h %D%/operators/operators.h \
	%D%/operators/surface_forces.h %D%/operators/weights.h %D%/schemes/anderson.h \
	%D%/schemes/boundary_values.h %D%/schemes/flow.h %D%/schemes/flow_drive.h %D%/schemes/flow_fields.h \
	%D%/schemes/flow_loss.h %D%/schemes/fluid_motion.h %D%/schemes/fluid_passes.h %D%/schemes/momentum.h \
	%D%/schemes/moving_step.h %D%/schemes/open_sides.h %D%/schemes/particle_shift.h \
	%D%/schemes/pressure.h %D%/schemes/projection.h %D%/schemes/projection_parts.h %D%/schemes/residual.h \
	%D%/schemes/schur.h %D%/schemes/solver_watch.h %D%/schemes/steady.h
PHYSICS_LIBS += libfluid.la libsolve.la
