# SPDX-License-Identifier: BSD-3-Clause
# Examples: all of a folder ships and is installed; results of runs (out*) do not and are not.
nobase_dist_pkgdata_DATA = \
	%D%/README.md %D%/ballast/README.md %D%/ballast/scene.yaml %D%/bead_packing/README.md \
	%D%/bead_packing/close.yaml %D%/bead_packing/cut.awk %D%/bead_packing/flow.awk \
	%D%/bead_packing/flow.sh %D%/bead_packing/open.awk %D%/bead_packing/open.sh \
	%D%/bead_packing/packing.awk %D%/bead_packing/picture.awk %D%/bead_packing/picture.gp \
	%D%/bead_packing/pour.sh %D%/bead_packing/pour.yaml %D%/bead_packing/published.txt \
	%D%/bead_packing/scene.yaml %D%/bead_packing/section.awk %D%/bead_packing/summary.awk \
	%D%/bed_erosion/README.md %D%/bed_erosion/bed.txt %D%/bed_erosion/discs.txt %D%/bed_erosion/fixed.txt \
	%D%/bed_erosion/picture.gp %D%/bed_erosion/resolved.yaml %D%/bed_erosion/scene.yaml \
	%D%/bench/ablation.tsv %D%/bench/bench.sh %D%/bench/bidisperse.yaml %D%/bench/chute.yaml \
	%D%/bench/chute_settle.yaml %D%/bench/cohesion.yaml %D%/bench/in.bidisperse %D%/bench/in.cells \
	%D%/bench/in.chute %D%/bench/in.continuous %D%/bench/laws.yaml %D%/bench/needs.yaml \
	%D%/bench/packing.sh %D%/bench/packing.yaml %D%/bench/pairs.py %D%/bench/performance-guards.md \
	%D%/bench/performance-index.head.md %D%/bench/performance-journal.head.md \
	%D%/bench/performance.head.md %D%/bench/rocks.yaml %D%/bench/tables.sh %D%/bidisperse/README.md \
	%D%/bidisperse/bidisperse_R10.data.gz %D%/bidisperse/compare.awk %D%/bidisperse/energies.awk \
	%D%/bidisperse/energies.csv %D%/bidisperse/scene.yaml %D%/bidisperse/step0.dump.gz \
	%D%/bidisperse/step200.dump.gz %D%/blade/README.md %D%/blade/blade.txt %D%/blade/picture.gp \
	%D%/blade/scene.yaml %D%/cavity/README.md %D%/cavity/scene.yaml %D%/column/README.md \
	%D%/column/scene.yaml %D%/columns/README.md %D%/columns/deposit.awk %D%/columns/laws.awk \
	%D%/columns/pick.awk %D%/columns/picture.gp %D%/columns/plane.yaml %D%/columns/round.yaml \
	%D%/common.sh %D%/crushing/README.md %D%/crushing/crushing.gp %D%/crushing/curve.awk \
	%D%/crushing/grains.awk %D%/crushing/picture.awk %D%/crushing/scene.yaml %D%/crushing/summary.awk \
	%D%/dosta2024/README.md %D%/dosta2024/curves.awk %D%/dosta2024/curves/drum-liggghts.csv \
	%D%/dosta2024/curves/drum-musen.csv %D%/dosta2024/curves/drum-peclet.csv \
	%D%/dosta2024/curves/impact100-liggghts.csv %D%/dosta2024/curves/impact100-musen.csv \
	%D%/dosta2024/curves/impact100-peclet.csv %D%/dosta2024/curves/impact25-liggghts.csv \
	%D%/dosta2024/curves/impact25-musen.csv %D%/dosta2024/curves/impact25-peclet.csv \
	%D%/dosta2024/curves/impact50-liggghts.csv %D%/dosta2024/curves/impact50-musen.csv \
	%D%/dosta2024/curves/impact50-peclet.csv %D%/dosta2024/curves/silo-large-m1-liggghts.csv \
	%D%/dosta2024/curves/silo-large-m1-musen.csv %D%/dosta2024/curves/silo-large-m1-peclet.csv \
	%D%/dosta2024/curves/silo-small-m1-musen.csv %D%/dosta2024/curves/silo-small-m1-peclet.csv \
	%D%/dosta2024/drum.awk %D%/dosta2024/growth.awk %D%/dosta2024/impact.awk %D%/dosta2024/page.gp \
	%D%/dosta2024/page.head.md %D%/dosta2024/page.tail.md %D%/dosta2024/picture.gp %D%/dosta2024/row.awk \
	%D%/dosta2024/rows.tsv %D%/dosta2024/seeds.awk %D%/dosta2024/silo.awk %D%/dosta2024/silo.yaml \
	%D%/drum/README.md %D%/drum/compare.awk %D%/drum/lammps-1.csv %D%/drum/lammps-2.csv \
	%D%/drum/lammps/data.awk %D%/drum/lammps/in.drum %D%/drum/particles.txt.gz %D%/drum/scene.yaml \
	%D%/drum/walls.txt %D%/drum/zones.gp %D%/drum_on_rollers/README.md %D%/drum_on_rollers/scene.yaml \
	%D%/dumbbells/README.md %D%/dumbbells/members.awk %D%/dumbbells/picture.gp %D%/dumbbells/scene.yaml \
	%D%/electroosmosis/README.md %D%/electroosmosis/picture.gp %D%/electroosmosis/scene.yaml \
	%D%/ergun/README.md %D%/ergun/scene.yaml %D%/ergun/section.awk %D%/fluid_scaling/README.md \
	%D%/fluid_scaling/count_calls.c %D%/fluid_scaling/counts.awk %D%/fluid_scaling/scene.yaml \
	%D%/fluid_scaling/section.awk %D%/fluidised_bed/README.md %D%/fluidised_bed/goldschmidt.yaml \
	%D%/fluidised_bed/netl.yaml %D%/fluidised_bed/picture.gp %D%/fluidised_bed/scene.yaml \
	%D%/gallery/README.md %D%/gallery/compaction.yaml %D%/gallery/drum.yaml %D%/gallery/funnel.txt \
	%D%/gallery/gate.txt %D%/gallery/hopper.yaml %D%/gallery/pictures.txt %D%/gallery/plot.gp \
	%D%/gallery/pouring.yaml %D%/gallery/quick.txt %D%/gallery/shear_cell.yaml %D%/gallery/sieve.yaml \
	%D%/gallery/sieves.txt %D%/gate/README.md %D%/gate/bottom.txt %D%/gate/gate.txt %D%/gate/picture.gp \
	%D%/gate/scene.yaml %D%/gravel/README.md %D%/gravel/scene.yaml %D%/hard/boulder.yaml \
	%D%/hard/coincide.yaml %D%/hard/denormal.yaml %D%/hard/edge.yaml %D%/hard/faces.yaml %D%/hard/far.txt \
	%D%/hard/far.yaml %D%/hard/fast.yaml %D%/hard/jammed.yaml %D%/hard/lattice.txt %D%/hard/limit.yaml \
	%D%/hard/oblique.yaml %D%/hard/only_slivers.txt %D%/hard/pair.yaml %D%/hard/ratio.yaml \
	%D%/hard/slivers.txt %D%/hard/square.txt %D%/heated_drum/README.md %D%/heated_drum/picture.gp \
	%D%/heated_drum/scene.yaml %D%/lammps/README.md %D%/lammps/granular-0.dump.gz \
	%D%/lammps/granular.data.gz %D%/lammps/granular.yaml %D%/lammps/pour-0.dump.gz \
	%D%/lammps/pour-100.dump.gz %D%/lammps/pour.2d-0.dump.gz %D%/lammps/pour.2d-100.dump.gz \
	%D%/lammps/pour.2d.data.gz %D%/lammps/pour.2d.yaml %D%/lammps/pour.data.gz %D%/lammps/pour.yaml \
	%D%/library/README.md %D%/library/search.c %D%/library/simulation.c %D%/mixer/README.md \
	%D%/mixer/picture.gp %D%/mixer/scene.yaml %D%/paddle_wheel/README.md %D%/paddle_wheel/scene.yaml \
	%D%/paddle_wheel/wheel.txt %D%/penetration/README.md %D%/penetration/compare.awk \
	%D%/penetration/depth.gp %D%/penetration/lammps.csv %D%/penetration/lammps/data.awk \
	%D%/penetration/lammps/in.penetration %D%/penetration/lammps/tsuji.awk \
	%D%/penetration/particles.txt.gz %D%/penetration/scene.yaml %D%/penetration/walls.txt \
	%D%/pores.head.md %D%/pupcs/README.md %D%/pupcs/dense/scene.yaml %D%/pupcs/large/scene.yaml \
	%D%/pupcs/sizes.gp %D%/pupcs/sparse/scene.yaml %D%/repose/README.md %D%/repose/last.awk \
	%D%/repose/picture.gp %D%/repose/scene.yaml %D%/repose/slope.awk %D%/rock_packing/README.md \
	%D%/rock_packing/published.txt %D%/rock_packing/scene.yaml %D%/rock_packing/shapes.awk \
	%D%/rocks/README.md %D%/rocks/drum.yaml %D%/rocks/hopper.yaml %D%/scaling/README.md \
	%D%/scaling/bed.yaml %D%/scaling/boulders.awk %D%/scaling/boulders.yaml %D%/scaling/counts.awk \
	%D%/scaling/counts_section.awk %D%/scaling/figures.awk %D%/scaling/hybrid.gp %D%/scaling/job.slurm \
	%D%/scaling/lines.awk %D%/scaling/model.awk %D%/scaling/model.gp %D%/scaling/ranks.gp \
	%D%/scaling/scene.yaml %D%/scaling/speed.gp %D%/scaling/tables.awk %D%/scour/README.md \
	%D%/scour/onset.yaml %D%/scour/picture.gp %D%/scour/scene.yaml %D%/scour/stream.txt \
	%D%/settling/README.md %D%/settling/liquids.txt %D%/settling/picture.gp %D%/settling/scene.yaml \
	%D%/shear_cell/README.md %D%/shear_cell/scene.yaml %D%/solver/README.md %D%/solver/bed.yaml \
	%D%/solver/collapse.yaml %D%/sphere_array/README.md %D%/sphere_array/scene.yaml \
	%D%/taylor_green/README.md %D%/taylor_green/scene.yaml %D%/tumbling/README.md %D%/tumbling/picture.gp \
	%D%/tumbling/scene.yaml %D%/two_sizes/README.md %D%/two_sizes/picture.gp %D%/two_sizes/scene.yaml \
	%D%/water_bed/README.md %D%/water_bed/picture.gp %D%/water_bed/scene.yaml %D%/wet_pile/README.md \
	%D%/wet_pile/picture.gp %D%/wet_pile/scene.yaml %D%/yade/README.md %D%/yade/gas.py %D%/yade/gas.yaml \
	%D%/yade/yade.csv
nobase_dist_pkgdata_SCRIPTS = \
	%D%/ballast/check %D%/ballast/run.sh %D%/bead_packing/breakthrough.sh %D%/bead_packing/check \
	%D%/bead_packing/picture.sh %D%/bead_packing/run.sh %D%/bead_packing/section.sh %D%/bed_erosion/check \
	%D%/bed_erosion/run.sh %D%/bed_erosion/section.sh %D%/bench/auto.sh %D%/bench/bidisperse.sh \
	%D%/bench/cells.sh %D%/bench/chute.sh %D%/bench/cohesion.sh %D%/bench/compare.sh \
	%D%/bench/continuous.sh %D%/bench/fluid.sh %D%/bench/growth.sh %D%/bench/guards.sh %D%/bench/hard.sh \
	%D%/bench/laws.sh %D%/bench/needs.sh %D%/bench/page.sh %D%/bench/penetration.sh %D%/bench/report.sh \
	%D%/bench/rocks.sh %D%/bench/roofline.sh %D%/bench/skin.sh %D%/bench/table1.sh %D%/bench/univol.sh \
	%D%/bench/water.sh %D%/bidisperse/check %D%/bidisperse/run.sh %D%/blade/check %D%/blade/run.sh \
	%D%/cavity/check %D%/cavity/run.sh %D%/columns/run.sh %D%/crushing/check %D%/crushing/run.sh \
	%D%/dosta2024/measure.sh %D%/dosta2024/page.sh %D%/dosta2024/run.sh %D%/drum/check \
	%D%/drum/lammps/run.sh %D%/drum/run.sh %D%/drum_on_rollers/check %D%/drum_on_rollers/run.sh \
	%D%/dumbbells/check %D%/dumbbells/run.sh %D%/electroosmosis/check %D%/electroosmosis/run.sh \
	%D%/electroosmosis/section.sh %D%/ergun/check %D%/ergun/run.sh %D%/ergun/section.sh %D%/flow.sh \
	%D%/fluid_scaling/run.sh %D%/fluid_scaling/section.sh %D%/fluidised_bed/beds.sh \
	%D%/fluidised_bed/check %D%/fluidised_bed/run.sh %D%/fluidised_bed/section.sh %D%/gallery/check \
	%D%/gallery/run.sh %D%/gate/check %D%/gate/run.sh %D%/hard/run.sh %D%/heated_drum/check \
	%D%/heated_drum/run.sh %D%/lammps/check %D%/lammps/make.sh %D%/mixer/check %D%/mixer/run.sh \
	%D%/paddle_wheel/check %D%/paddle_wheel/run.sh %D%/penetration/check %D%/penetration/lammps/run.sh \
	%D%/penetration/layouts %D%/penetration/run.sh %D%/pores.sh %D%/pupcs/run.sh %D%/pupcs/sizes.sh \
	%D%/repose/check %D%/repose/run.sh %D%/rock_packing/check %D%/rock_packing/run.sh %D%/rocks/check \
	%D%/rocks/run.sh %D%/scaling/counts.sh %D%/scaling/ghosts.sh %D%/scaling/page.sh %D%/scaling/run.sh \
	%D%/scour/check %D%/scour/run.sh %D%/settling/check %D%/settling/run.sh %D%/settling/section.sh \
	%D%/shear_cell/check %D%/shear_cell/run.sh %D%/solver/run.sh %D%/speed-error.sh \
	%D%/sphere_array/check %D%/sphere_array/run.sh %D%/step-fraction.sh %D%/taylor_green/check \
	%D%/taylor_green/run.sh %D%/tumbling/check %D%/tumbling/run.sh %D%/tumbling/section.sh \
	%D%/two_sizes/check %D%/two_sizes/run.sh %D%/water_bed/check %D%/water_bed/run.sh %D%/wet_pile/check \
	%D%/wet_pile/run.sh %D%/yade/run.sh
