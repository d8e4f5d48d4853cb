# SPDX-License-Identifier: BSD-3-Clause
# Examples: all of a folder ships and is installed; results of runs (out*) do not and are not.
nobase_dist_pkgdata_DATA = \
	examples/README.md examples/column/README.md examples/column/scene.yaml examples/common.sh
nobase_dist_pkgdata_SCRIPTS = examples/flow.sh examples/speed-error.sh examples/step-fraction.sh

bench = examples/bench
nobase_dist_pkgdata_DATA += \
	$(bench)/ablation.tsv $(bench)/bench.sh $(bench)/bidisperse.yaml $(bench)/chute.yaml $(bench)/cohesion.yaml \
	$(bench)/chute_settle.yaml $(bench)/in.bidisperse $(bench)/in.cells $(bench)/in.chute \
	$(bench)/in.continuous $(bench)/needs.yaml $(bench)/pairs.py $(bench)/packing.sh $(bench)/packing.yaml \
	$(bench)/performance.head.md $(bench)/performance-guards.md $(bench)/performance-index.head.md \
	$(bench)/performance-journal.head.md $(bench)/tables.sh
nobase_dist_pkgdata_SCRIPTS += \
	$(bench)/auto.sh $(bench)/bidisperse.sh $(bench)/cells.sh $(bench)/chute.sh $(bench)/cohesion.sh $(bench)/compare.sh \
	$(bench)/continuous.sh $(bench)/fluid.sh $(bench)/growth.sh $(bench)/guards.sh $(bench)/needs.sh $(bench)/page.sh $(bench)/penetration.sh \
	$(bench)/report.sh $(bench)/roofline.sh $(bench)/skin.sh $(bench)/table1.sh $(bench)/univol.sh

bidisperse = examples/bidisperse
nobase_dist_pkgdata_DATA += \
	$(bidisperse)/README.md $(bidisperse)/bidisperse_R10.data.gz $(bidisperse)/compare.awk \
	$(bidisperse)/energies.awk $(bidisperse)/energies.csv $(bidisperse)/scene.yaml \
	$(bidisperse)/step0.dump.gz $(bidisperse)/step200.dump.gz
nobase_dist_pkgdata_SCRIPTS += $(bidisperse)/check $(bidisperse)/run.sh

nobase_dist_pkgdata_DATA += \
	examples/cavity/README.md examples/cavity/scene.yaml \
	examples/electroosmosis/README.md examples/electroosmosis/picture.gp examples/electroosmosis/scene.yaml \
	examples/sphere_array/README.md examples/sphere_array/scene.yaml \
	examples/taylor_green/README.md examples/taylor_green/scene.yaml
nobase_dist_pkgdata_SCRIPTS += \
	examples/cavity/check examples/cavity/run.sh \
	examples/electroosmosis/check examples/electroosmosis/run.sh examples/electroosmosis/section.sh \
	examples/sphere_array/check examples/sphere_array/run.sh \
	examples/taylor_green/check examples/taylor_green/run.sh

blade = examples/blade
nobase_dist_pkgdata_DATA += $(blade)/README.md $(blade)/blade.txt $(blade)/picture.gp $(blade)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(blade)/check $(blade)/run.sh

repose = examples/repose
nobase_dist_pkgdata_DATA += \
	$(repose)/README.md $(repose)/last.awk $(repose)/picture.gp $(repose)/scene.yaml $(repose)/slope.awk
nobase_dist_pkgdata_SCRIPTS += $(repose)/check $(repose)/run.sh

wet_pile = examples/wet_pile
nobase_dist_pkgdata_DATA += $(wet_pile)/README.md $(wet_pile)/picture.gp $(wet_pile)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(wet_pile)/check $(wet_pile)/run.sh

crushing = examples/crushing
nobase_dist_pkgdata_DATA += \
	$(crushing)/README.md $(crushing)/crushing.gp $(crushing)/curve.awk $(crushing)/grains.awk $(crushing)/picture.awk \
	$(crushing)/scene.yaml $(crushing)/summary.awk
nobase_dist_pkgdata_SCRIPTS += $(crushing)/check $(crushing)/run.sh

nobase_dist_pkgdata_DATA += examples/gravel/README.md examples/gravel/scene.yaml

gallery = examples/gallery
nobase_dist_pkgdata_DATA += \
	$(gallery)/README.md $(gallery)/compaction.yaml $(gallery)/drum.yaml $(gallery)/funnel.txt $(gallery)/gate.txt $(gallery)/hopper.yaml \
	$(gallery)/pictures.txt $(gallery)/plot.gp $(gallery)/pouring.yaml $(gallery)/quick.txt $(gallery)/shear_cell.yaml $(gallery)/sieve.yaml \
	$(gallery)/sieves.txt
nobase_dist_pkgdata_SCRIPTS += $(gallery)/check $(gallery)/run.sh

gate = examples/gate
nobase_dist_pkgdata_DATA += $(gate)/README.md $(gate)/bottom.txt $(gate)/gate.txt $(gate)/picture.gp $(gate)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(gate)/check $(gate)/run.sh

nobase_dist_pkgdata_DATA += examples/shear_cell/README.md examples/shear_cell/scene.yaml
nobase_dist_pkgdata_SCRIPTS += examples/shear_cell/check examples/shear_cell/run.sh

drum = examples/drum
nobase_dist_pkgdata_DATA += \
	$(drum)/README.md $(drum)/compare.awk $(drum)/lammps-1.csv $(drum)/lammps-2.csv $(drum)/lammps/data.awk \
	$(drum)/lammps/in.drum $(drum)/particles.txt.gz $(drum)/scene.yaml $(drum)/walls.txt $(drum)/zones.gp
nobase_dist_pkgdata_SCRIPTS += $(drum)/check $(drum)/lammps/run.sh $(drum)/run.sh

heated_drum = examples/heated_drum
nobase_dist_pkgdata_DATA += $(heated_drum)/README.md $(heated_drum)/picture.gp $(heated_drum)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(heated_drum)/check $(heated_drum)/run.sh

fluid_settling = examples/settling
nobase_dist_pkgdata_DATA += \
	$(fluid_settling)/README.md $(fluid_settling)/liquids.txt $(fluid_settling)/picture.gp $(fluid_settling)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(fluid_settling)/check $(fluid_settling)/run.sh $(fluid_settling)/section.sh

tumbling = examples/tumbling
nobase_dist_pkgdata_DATA += $(tumbling)/README.md $(tumbling)/picture.gp $(tumbling)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(tumbling)/check $(tumbling)/run.sh $(tumbling)/section.sh

two_sizes = examples/two_sizes
nobase_dist_pkgdata_DATA += $(two_sizes)/README.md $(two_sizes)/picture.gp $(two_sizes)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(two_sizes)/check $(two_sizes)/run.sh

bed_erosion = examples/bed_erosion
nobase_dist_pkgdata_DATA += \
	$(bed_erosion)/README.md $(bed_erosion)/bed.txt $(bed_erosion)/discs.txt $(bed_erosion)/fixed.txt $(bed_erosion)/picture.gp \
	$(bed_erosion)/resolved.yaml $(bed_erosion)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(bed_erosion)/check $(bed_erosion)/run.sh $(bed_erosion)/section.sh

fluidised = examples/fluidised_bed
nobase_dist_pkgdata_DATA += $(fluidised)/README.md $(fluidised)/picture.gp $(fluidised)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(fluidised)/check $(fluidised)/run.sh $(fluidised)/section.sh

hard = examples/hard
nobase_dist_pkgdata_DATA += \
	$(hard)/boulder.yaml $(hard)/coincide.yaml $(hard)/denormal.yaml $(hard)/edge.yaml $(hard)/faces.yaml \
	$(hard)/far.txt $(hard)/far.yaml $(hard)/fast.yaml $(hard)/jammed.yaml $(hard)/lattice.txt \
	$(hard)/limit.yaml $(hard)/oblique.yaml $(hard)/only_slivers.txt $(hard)/pair.yaml $(hard)/ratio.yaml \
	$(hard)/slivers.txt $(hard)/square.txt
nobase_dist_pkgdata_SCRIPTS += $(hard)/run.sh

nobase_dist_pkgdata_DATA += \
	examples/library/README.md examples/library/search.c examples/library/simulation.c

penetration = examples/penetration
nobase_dist_pkgdata_DATA += \
	$(penetration)/README.md $(penetration)/compare.awk $(penetration)/depth.gp $(penetration)/lammps.csv \
	$(penetration)/lammps/data.awk $(penetration)/lammps/in.penetration $(penetration)/lammps/tsuji.awk \
	$(penetration)/particles.txt.gz \
	$(penetration)/scene.yaml $(penetration)/walls.txt
nobase_dist_pkgdata_SCRIPTS += \
	$(penetration)/check $(penetration)/lammps/run.sh $(penetration)/layouts $(penetration)/run.sh

dumbbells = examples/dumbbells
nobase_dist_pkgdata_DATA += \
	$(dumbbells)/README.md $(dumbbells)/members.awk $(dumbbells)/picture.gp $(dumbbells)/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(dumbbells)/check $(dumbbells)/run.sh

pupcs = examples/pupcs
nobase_dist_pkgdata_DATA += \
	$(pupcs)/README.md $(pupcs)/dense/scene.yaml $(pupcs)/large/scene.yaml $(pupcs)/sizes.gp \
	$(pupcs)/sparse/scene.yaml
nobase_dist_pkgdata_SCRIPTS += $(pupcs)/run.sh $(pupcs)/sizes.sh

scaling = examples/scaling
nobase_dist_pkgdata_DATA += \
	$(scaling)/README.md $(scaling)/boulders.awk $(scaling)/boulders.yaml $(scaling)/figures.awk \
	$(scaling)/hybrid.gp $(scaling)/job.slurm $(scaling)/lines.awk $(scaling)/model.awk $(scaling)/model.gp \
	$(scaling)/ranks.gp $(scaling)/scene.yaml $(scaling)/speed.gp $(scaling)/tables.awk
nobase_dist_pkgdata_SCRIPTS += $(scaling)/ghosts.sh $(scaling)/page.sh $(scaling)/run.sh

bead_packing = examples/bead_packing
nobase_dist_pkgdata_DATA += \
	$(bead_packing)/README.md $(bead_packing)/close.yaml $(bead_packing)/cut.awk $(bead_packing)/flow.awk $(bead_packing)/flow.sh $(bead_packing)/open.awk $(bead_packing)/open.sh $(bead_packing)/packing.awk $(bead_packing)/picture.awk \
	$(bead_packing)/picture.gp $(bead_packing)/pour.sh $(bead_packing)/pour.yaml $(bead_packing)/published.txt $(bead_packing)/scene.yaml \
	$(bead_packing)/section.awk $(bead_packing)/summary.awk examples/pores.head.md
nobase_dist_pkgdata_SCRIPTS += \
	$(bead_packing)/breakthrough.sh $(bead_packing)/check $(bead_packing)/picture.sh $(bead_packing)/run.sh $(bead_packing)/section.sh examples/pores.sh

ergun = examples/ergun
nobase_dist_pkgdata_DATA += $(ergun)/README.md $(ergun)/scene.yaml $(ergun)/section.awk
nobase_dist_pkgdata_SCRIPTS += $(ergun)/check $(ergun)/run.sh $(ergun)/section.sh

fluid_scaling = examples/fluid_scaling
nobase_dist_pkgdata_DATA += \
	$(fluid_scaling)/README.md $(fluid_scaling)/count_calls.c $(fluid_scaling)/counts.awk $(fluid_scaling)/scene.yaml $(fluid_scaling)/section.awk
nobase_dist_pkgdata_SCRIPTS += $(fluid_scaling)/run.sh $(fluid_scaling)/section.sh
