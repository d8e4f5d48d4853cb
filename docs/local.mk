# SPDX-License-Identifier: BSD-3-Clause
EXTRA_DIST += \
	%D%/accuracy.md %D%/architecture.md %D%/benchmarks.md %D%/building.md %D%/features.md %D%/fluid-limits.md \
	%D%/fluid-method.md %D%/fluid.md %D%/folders.dot %D%/gallery.md %D%/hard-cases.md %D%/hard.md \
	%D%/howto/cluster.md %D%/howto/compaction.md %D%/howto/coupling.md %D%/howto/drum.md %D%/howto/hopper.md \
	%D%/howto/pouring.md %D%/howto/restart.md %D%/howto/shear_cell.md %D%/howto/sieve.md \
	%D%/images/bead-packing.png %D%/images/bed-erosion.png %D%/images/benchmarks.svg %D%/images/blade.png \
	%D%/images/crushing.png %D%/images/dumbbells.png %D%/images/fluid-cavity.png \
	%D%/images/fluid-electroosmosis.png %D%/images/fluid-spheres.png %D%/images/fluid-vortices.png \
	%D%/images/fluidised-bed.png %D%/images/folders.svg %D%/images/gallery-compaction-plot.png \
	%D%/images/gallery-compaction.png %D%/images/gallery-drum-plot.png %D%/images/gallery-drum.png \
	%D%/images/gallery-hopper-plot.png %D%/images/gallery-hopper.png %D%/images/gallery-pouring-plot.png \
	%D%/images/gallery-pouring.png %D%/images/gallery-shear_cell-plot.png %D%/images/gallery-shear_cell.png \
	%D%/images/gallery-sieve-plot.png %D%/images/gallery-sieve.png %D%/images/gate.png \
	%D%/images/heated-drum.png %D%/images/mixer.png %D%/images/paddle_wheel.png %D%/images/penetration.png \
	%D%/images/performance-auto.svg %D%/images/performance-cells.svg %D%/images/performance-continuous.svg \
	%D%/images/performance-growth.svg %D%/images/performance-optimum.svg %D%/images/performance-roofline.svg \
	%D%/images/performance-univol.svg %D%/images/picture-drum.png %D%/images/report-ablation.png \
	%D%/images/report.png %D%/images/repose.png %D%/images/rocks-drum.png %D%/images/rocks-hopper.png \
	%D%/images/scaling-hybrid.svg %D%/images/scaling-model.svg %D%/images/scaling-ranks.svg \
	%D%/images/scaling-sizes.svg %D%/images/scaling-speed.svg %D%/images/scour.png %D%/images/settling.png \
	%D%/images/site.png %D%/images/speed-error-angle.svg %D%/images/speed-error-column.svg \
	%D%/images/speed-error-drum.svg %D%/images/speed-error-penetration.svg %D%/images/tumbling.png \
	%D%/images/tutorial.png %D%/images/two-sizes.png %D%/images/verify-beverloo-3d.svg \
	%D%/images/verify-beverloo.svg %D%/images/verify-bonded-cantilever.svg %D%/images/verify-bouncing.svg \
	%D%/images/verify-bowl.svg %D%/images/verify-capillary-bridge.svg %D%/images/verify-chain.svg \
	%D%/images/verify-chung-ooi-1.svg %D%/images/verify-chung-ooi-2.svg %D%/images/verify-chung-ooi-3.svg \
	%D%/images/verify-chung-ooi-4.svg %D%/images/verify-chung-ooi-5.svg %D%/images/verify-chung-ooi-6.svg \
	%D%/images/verify-chung-ooi-7.svg %D%/images/verify-chung-ooi-8.svg %D%/images/verify-cradle.svg \
	%D%/images/verify-dmt-pull-off.svg %D%/images/verify-drift-hertz.svg %D%/images/verify-drift-hooke.svg \
	%D%/images/verify-drum-angle.svg %D%/images/verify-end-of-contact.svg %D%/images/verify-fluid-annulus.svg \
	%D%/images/verify-fluid-cavity.svg %D%/images/verify-fluid-couette.svg %D%/images/verify-fluid-diffusion.svg \
	%D%/images/verify-fluid-electroosmosis.svg %D%/images/verify-fluid-fluidised-bed.svg \
	%D%/images/verify-fluid-operators.svg %D%/images/verify-fluid-poiseuille.svg \
	%D%/images/verify-fluid-sphere-array.svg %D%/images/verify-fluid-taylor-aris.svg \
	%D%/images/verify-fluid-taylor-green.svg %D%/images/verify-free-fall.svg %D%/images/verify-haff.svg \
	%D%/images/verify-hard-boulder-discs.svg %D%/images/verify-hard-boulder.svg %D%/images/verify-hard-chain.svg \
	%D%/images/verify-hard-column.svg %D%/images/verify-hard-haff.svg %D%/images/verify-hard-impact.svg \
	%D%/images/verify-hard-janssen.svg %D%/images/verify-hard-mu-of-i.svg %D%/images/verify-hard-rest.svg \
	%D%/images/verify-hard-sliding.svg %D%/images/verify-hard-slope.svg %D%/images/verify-heat-chain.svg \
	%D%/images/verify-heat-rod.svg %D%/images/verify-implicit-hertz.svg %D%/images/verify-incline.svg \
	%D%/images/verify-janssen.svg %D%/images/verify-jkr-pull-off.svg %D%/images/verify-lees-edwards-gas.svg \
	%D%/images/verify-luding-unloading.svg %D%/images/verify-many-body.svg %D%/images/verify-moving-wall.svg \
	%D%/images/verify-order-hertz.svg %D%/images/verify-order-hooke.svg %D%/images/verify-periodic.svg \
	%D%/images/verify-plane-mesh.svg %D%/images/verify-restitution-hertz.svg \
	%D%/images/verify-restitution-hooke.svg %D%/images/verify-restitution-speed.svg \
	%D%/images/verify-rock-energy.svg %D%/images/verify-rock-rest.svg %D%/images/verify-rock-rod.svg \
	%D%/images/verify-rock-slope.svg %D%/images/verify-rock-stack.svg %D%/images/verify-rock-tumbling.svg \
	%D%/images/verify-rolling-decay.svg %D%/images/verify-settling.svg %D%/images/verify-slide-to-roll.svg \
	%D%/images/verify-stack.svg %D%/images/verify-sticking-velocity.svg %D%/images/verify-tumbling-clump.svg \
	%D%/images/verify-turning-wall.svg %D%/images/verify-vyas.svg %D%/images/verify-wall-edge.svg \
	%D%/images/verify-water-bed.svg %D%/images/verify-water-consolidation.svg \
	%D%/images/verify-water-hindered.svg %D%/images/verify-water-lubrication.svg \
	%D%/images/verify-water-settling.svg %D%/images/verify-water-two-spheres.svg %D%/images/view.png \
	%D%/images/water-bed.png %D%/images/wet-pile.png %D%/index.md %D%/indexes.md %D%/layouts.md %D%/library.md \
	%D%/packing.md %D%/performance-index.md %D%/performance-journal.md %D%/performance.md %D%/physics.md \
	%D%/pictures.md %D%/pores.md %D%/python.md %D%/reports.md %D%/results/performance %D%/results/pores \
	%D%/results/scaling/ghosts/lines.jsonl %D%/results/scaling/ghosts/section.md \
	%D%/results/scaling/hybrid.jsonl %D%/results/scaling/lengths.jsonl %D%/results/scaling/pupcs/lines.jsonl \
	%D%/results/scaling/pupcs/section.md %D%/results/scaling/pupcs/sizes.jsonl \
	%D%/results/scaling/pupcs/sizes.md %D%/results/scaling/ranks.jsonl %D%/results/scaling/strong.jsonl \
	%D%/results/scaling/weak.jsonl %D%/scaling.md %D%/scene.md %D%/site/Doxyfile %D%/site/conf.py \
	%D%/speed-error.md %D%/tutorial.md %D%/user-law.md %D%/view.md

# The pages that the program writes, after a change of the schema, a field, an observable, a stage or the report
.PHONY: pages
pages: src/data/scene/document_scene src/engine/document_output
	src/data/scene/document_scene >scene.md.new && mv scene.md.new $(top_srcdir)/docs/scene.md
	src/engine/document_output <$(top_srcdir)/docs/output.md >output.md.new && mv output.md.new $(top_srcdir)/docs/output.md

# The pages as a site, from the source tree, where links from page to page hold; warnings, broken links too, are errors
.PHONY: docs
docs: python/scree/copied
	@test -n "$(SPHINX)" && test -n "$(DOXYGEN)" || \
	    { echo "make docs needs Sphinx, MyST, Furo, Doxygen and Breathe" \
	    "(Debian: python3-sphinx python3-myst-parser furo doxygen python3-breathe)" >&2; exit 1; }
	$(MKDIR_P) site
	SCREE_SOURCE=$(abs_top_srcdir) $(DOXYGEN) $(top_srcdir)/docs/site/Doxyfile
	SCREE_BUILD=$(abs_builddir) $(SPHINX) -q -W --keep-going -c $(top_srcdir)/docs/site -b html -d site/.doctrees $(top_srcdir) site
	@echo '<meta http-equiv="refresh" content="0; url=docs/index.html">' >site/index.html
	@echo "the site: $(abs_builddir)/site/index.html"

clean-local: clean-site
clean-site:
	rm -rf site
.PHONY: clean-site
