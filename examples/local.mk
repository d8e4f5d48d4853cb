# Examples: all of a folder ships and is installed; results of runs (out*) do not and are not.
nobase_dist_pkgdata_DATA = \
	examples/README.md \
	examples/common.sh \
	examples/bench/bench.sh \
	examples/bench/bidisperse.yaml \
	examples/bench/chute.yaml \
	examples/bench/chute_settle.yaml \
	examples/bench/in.chute \
	examples/bench/in.bidisperse \
	examples/bidisperse/README.md \
	examples/bidisperse/bidisperse_R10.data \
	examples/bidisperse/compare.awk \
	examples/bidisperse/energies.awk \
	examples/bidisperse/energies.csv \
	examples/bidisperse/scene.yaml \
	examples/bidisperse/step0.dump.gz \
	examples/bidisperse/step200.dump.gz \
	examples/column/README.md \
	examples/column/scene.yaml \
	examples/drum/README.md \
	examples/drum/compare.awk \
	examples/drum/lammps-1.csv \
	examples/drum/lammps-2.csv \
	examples/drum/lammps/data.awk \
	examples/drum/lammps/in.drum \
	examples/drum/particles.txt \
	examples/drum/scene.yaml \
	examples/drum/walls.txt \
	examples/drum/zones.gp \
	examples/penetration/README.md \
	examples/penetration/compare.awk \
	examples/penetration/depth.gp \
	examples/penetration/lammps.csv \
	examples/penetration/lammps/data.awk \
	examples/penetration/lammps/in.penetration \
	examples/penetration/lammps/tsuji.awk \
	examples/penetration/particles.txt \
	examples/penetration/picture.awk \
	examples/penetration/picture.gp \
	examples/penetration/scene.yaml \
	examples/penetration/walls.txt

nobase_dist_pkgdata_SCRIPTS = \
	examples/bench/auto.sh \
	examples/bench/bidisperse.sh \
	examples/bench/chute.sh \
	examples/bench/penetration.sh \
	examples/bench/univol.sh \
	examples/bidisperse/check \
	examples/bidisperse/run.sh \
	examples/drum/check \
	examples/drum/lammps/run.sh \
	examples/drum/run.sh \
	examples/penetration/check \
	examples/penetration/lammps/run.sh \
	examples/penetration/layouts \
	examples/penetration/run.sh

# Hard cases, and what each term of a scene costs
nobase_dist_pkgdata_DATA += examples/bench/needs.yaml
nobase_dist_pkgdata_DATA += \
	examples/hard/boulder.yaml \
	examples/hard/coincide.yaml \
	examples/hard/denormal.yaml \
	examples/hard/edge.yaml \
	examples/hard/faces.yaml \
	examples/hard/far.txt \
	examples/hard/far.yaml \
	examples/hard/fast.yaml \
	examples/hard/jammed.yaml \
	examples/hard/lattice.txt \
	examples/hard/limit.yaml \
	examples/hard/oblique.yaml \
	examples/hard/only_slivers.txt \
	examples/hard/pair.yaml \
	examples/hard/ratio.yaml \
	examples/hard/slivers.txt \
	examples/hard/square.txt
nobase_dist_pkgdata_SCRIPTS += examples/bench/needs.sh examples/hard/run.sh examples/speed-error.sh

nobase_dist_pkgdata_DATA += \
	examples/pupcs/README.md \
	examples/pupcs/dense/scene.yaml \
	examples/pupcs/large/scene.yaml \
	examples/pupcs/sparse/scene.yaml
nobase_dist_pkgdata_SCRIPTS += examples/pupcs/run.sh

# Scaling over ranks and threads
nobase_dist_pkgdata_DATA += \
	examples/scaling/README.md \
	examples/scaling/boulders.awk \
	examples/scaling/boulders.yaml \
	examples/scaling/figures.awk \
	examples/scaling/hybrid.gp \
	examples/scaling/job.slurm \
	examples/scaling/lines.awk \
	examples/scaling/model.awk \
	examples/scaling/model.gp \
	examples/scaling/ranks.gp \
	examples/scaling/scene.yaml \
	examples/scaling/speed.gp \
	examples/scaling/tables.awk
nobase_dist_pkgdata_SCRIPTS += examples/scaling/page.sh examples/scaling/run.sh

# Benchmarks of packings, and the page of all
nobase_dist_pkgdata_DATA += \
	examples/bench/ablation.tsv \
	examples/bench/in.cells \
	examples/bench/in.continuous \
	examples/bench/packing.sh \
	examples/bench/packing.yaml \
	examples/bench/performance.head.md
nobase_dist_pkgdata_SCRIPTS += \
	examples/bench/cells.sh \
	examples/bench/compare.sh \
	examples/bench/continuous.sh \
	examples/bench/growth.sh \
	examples/bench/page.sh \
	examples/bench/report.sh \
	examples/bench/roofline.sh \
	examples/bench/table1.sh

# Full and reduced ghosts against geometry
nobase_dist_pkgdata_SCRIPTS += examples/scaling/ghosts.sh
