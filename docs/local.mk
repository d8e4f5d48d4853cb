# SPDX-License-Identifier: BSD-3-Clause
EXTRA_DIST += docs/architecture.md docs/building.md docs/features.md docs/scene.md
EXTRA_DIST += docs/indexes.md docs/images/penetration.png
EXTRA_DIST += docs/physics.md docs/user-law.md docs/fluid.md docs/fluid-limits.md docs/fluid-method.md \
	docs/images/crushing.png docs/images/dumbbells.png docs/images/fluid-cavity.png docs/images/fluid-electroosmosis.png \
	docs/images/fluid-spheres.png docs/images/fluid-vortices.png docs/images/fluidised-bed.png docs/images/gate.png docs/images/heated-drum.png \
	docs/images/blade.png docs/images/repose.png docs/images/wet-pile.png
EXTRA_DIST += docs/hard.md docs/packing.md docs/pictures.md docs/images/picture-drum.png docs/reports.md docs/images/report.png docs/images/report-ablation.png \
	docs/index.md docs/tutorial.md docs/images/tutorial.png docs/images/site.png docs/site/conf.py
EXTRA_DIST += docs/view.md docs/images/view.png
EXTRA_DIST += docs/gallery.md docs/howto/cluster.md docs/howto/compaction.md docs/howto/coupling.md docs/howto/drum.md docs/howto/hopper.md \
	docs/howto/pouring.md docs/howto/restart.md docs/howto/shear_cell.md docs/howto/sieve.md \
	docs/images/gallery-compaction.png docs/images/gallery-compaction-plot.png \
	docs/images/gallery-drum.png docs/images/gallery-drum-plot.png \
	docs/images/gallery-hopper.png docs/images/gallery-hopper-plot.png \
	docs/images/gallery-pouring.png docs/images/gallery-pouring-plot.png \
	docs/images/gallery-shear_cell.png docs/images/gallery-shear_cell-plot.png \
	docs/images/gallery-sieve.png docs/images/gallery-sieve-plot.png
EXTRA_DIST += docs/library.md docs/python.md docs/site/Doxyfile
EXTRA_DIST += docs/scaling.md docs/layouts.md \
	docs/folders.dot docs/images/folders.svg docs/images/scaling-hybrid.svg docs/images/scaling-model.svg docs/images/scaling-ranks.svg \
	docs/images/scaling-sizes.svg docs/images/scaling-speed.svg
EXTRA_DIST += docs/accuracy.md \
	docs/images/verify-beverloo-3d.svg \
	docs/images/verify-beverloo.svg \
	docs/images/verify-bonded-cantilever.svg \
	docs/images/verify-bouncing.svg \
	docs/images/verify-bowl.svg \
	docs/images/verify-capillary-bridge.svg \
	docs/images/verify-chain.svg \
	docs/images/verify-chung-ooi-1.svg \
	docs/images/verify-chung-ooi-2.svg \
	docs/images/verify-chung-ooi-3.svg \
	docs/images/verify-chung-ooi-4.svg \
	docs/images/verify-chung-ooi-5.svg \
	docs/images/verify-chung-ooi-6.svg \
	docs/images/verify-chung-ooi-7.svg \
	docs/images/verify-chung-ooi-8.svg \
	docs/images/verify-cradle.svg \
	docs/images/verify-dmt-pull-off.svg \
	docs/images/verify-drift-hertz.svg \
	docs/images/verify-drift-hooke.svg \
	docs/images/verify-drum-angle.svg \
	docs/images/verify-end-of-contact.svg \
	docs/images/verify-fluid-annulus.svg \
	docs/images/verify-fluid-cavity.svg \
	docs/images/verify-fluid-couette.svg \
	docs/images/verify-fluid-diffusion.svg \
	docs/images/verify-fluid-electroosmosis.svg \
	docs/images/verify-fluid-fluidised-bed.svg \
	docs/images/verify-fluid-operators.svg \
	docs/images/verify-fluid-poiseuille.svg \
	docs/images/verify-fluid-sphere-array.svg \
	docs/images/verify-fluid-taylor-aris.svg \
	docs/images/verify-fluid-taylor-green.svg \
	docs/images/verify-free-fall.svg \
	docs/images/verify-haff.svg \
	docs/images/verify-hard-boulder.svg \
	docs/images/verify-hard-chain.svg \
	docs/images/verify-hard-column.svg \
	docs/images/verify-hard-haff.svg \
	docs/images/verify-hard-impact.svg \
	docs/images/verify-hard-rest.svg \
	docs/images/verify-hard-sliding.svg \
	docs/images/verify-hard-slope.svg \
	docs/images/verify-implicit-hertz.svg \
	docs/images/verify-heat-chain.svg \
	docs/images/verify-heat-rod.svg \
	docs/images/verify-incline.svg \
	docs/images/verify-janssen.svg \
	docs/images/verify-jkr-pull-off.svg \
	docs/images/verify-lees-edwards-gas.svg \
	docs/images/verify-luding-unloading.svg \
	docs/images/verify-many-body.svg \
	docs/images/verify-moving-wall.svg \
	docs/images/verify-order-hertz.svg \
	docs/images/verify-order-hooke.svg \
	docs/images/verify-periodic.svg \
	docs/images/verify-plane-mesh.svg \
	docs/images/verify-restitution-hertz.svg \
	docs/images/verify-restitution-hooke.svg \
	docs/images/verify-restitution-speed.svg \
	docs/images/verify-rolling-decay.svg \
	docs/images/verify-settling.svg \
	docs/images/verify-slide-to-roll.svg \
	docs/images/verify-stack.svg \
	docs/images/verify-sticking-velocity.svg \
	docs/images/verify-tumbling-clump.svg \
	docs/images/verify-turning-wall.svg \
	docs/images/verify-vyas.svg \
	docs/images/verify-wall-edge.svg
EXTRA_DIST += docs/hard-cases.md
EXTRA_DIST += docs/speed-error.md
EXTRA_DIST += docs/images/speed-error-angle.svg docs/images/speed-error-column.svg \
	docs/images/speed-error-drum.svg \
	docs/images/speed-error-penetration.svg
EXTRA_DIST += docs/performance.md docs/performance-index.md docs/performance-journal.md \
	docs/images/performance-auto.svg \
	docs/images/performance-cells.svg \
	docs/images/performance-continuous.svg \
	docs/images/performance-growth.svg \
	docs/images/performance-optimum.svg \
	docs/images/performance-roofline.svg \
	docs/images/performance-univol.svg
EXTRA_DIST += docs/results/performance
EXTRA_DIST += docs/results/scaling/hybrid.jsonl docs/results/scaling/lengths.jsonl docs/results/scaling/ranks.jsonl \
	docs/results/scaling/strong.jsonl docs/results/scaling/weak.jsonl \
	docs/results/scaling/ghosts/lines.jsonl docs/results/scaling/ghosts/section.md \
	docs/results/scaling/pupcs/lines.jsonl docs/results/scaling/pupcs/section.md \
	docs/results/scaling/pupcs/sizes.jsonl docs/results/scaling/pupcs/sizes.md

# The pages that the program writes, after a change of the schema, a field, an observable, a stage or the report
.PHONY: pages
pages: src/scene/document src/engine/document
	src/scene/document >scene.md.new && mv scene.md.new $(top_srcdir)/docs/scene.md
	src/engine/document <$(top_srcdir)/docs/output.md >output.md.new && mv output.md.new $(top_srcdir)/docs/output.md
EXTRA_DIST += docs/pores.md docs/images/bead-packing.png docs/images/settling.png docs/images/tumbling.png docs/images/bed-erosion.png docs/images/two-sizes.png docs/results/pores

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
