# SPDX-License-Identifier: BSD-3-Clause
# Verification cases: all of a folder ships.
nobase_dist_pkgdata_DATA += \
	%D%/README.md %D%/accuracy.head.md %D%/beverloo-3d/floor.txt %D%/beverloo-3d/scene.yaml \
	%D%/beverloo/floor.txt %D%/beverloo/scene.yaml %D%/bonded-cantilever/particles.txt \
	%D%/bonded-cantilever/scene.yaml %D%/bouncing/scene.yaml %D%/bowl/scene.yaml %D%/capillary-bridge/scene.yaml \
	%D%/case.sh %D%/chain/particles.txt %D%/chain/scene.yaml %D%/chung-ooi-1/plot.gp %D%/chung-ooi-1/scene.yaml \
	%D%/chung-ooi-2/plot.gp %D%/chung-ooi-2/scene.yaml %D%/chung-ooi-3/particles.txt %D%/chung-ooi-3/plot.gp \
	%D%/chung-ooi-3/scene.yaml %D%/chung-ooi-4/measured.txt %D%/chung-ooi-4/particles.txt \
	%D%/chung-ooi-4/plot.gp %D%/chung-ooi-4/scene.yaml %D%/chung-ooi-5/finite-elements.txt \
	%D%/chung-ooi-5/particles.txt %D%/chung-ooi-5/plot.gp %D%/chung-ooi-5/scene.yaml \
	%D%/chung-ooi-6/particles.txt %D%/chung-ooi-6/plot.gp %D%/chung-ooi-6/scene.yaml \
	%D%/chung-ooi-7/particles.txt %D%/chung-ooi-7/plot.gp %D%/chung-ooi-7/scene.yaml \
	%D%/chung-ooi-8/particles.txt %D%/chung-ooi-8/plot.gp %D%/chung-ooi-8/scene.yaml %D%/cradle/scene.yaml \
	%D%/curve.gp %D%/dmt-pull-off/scene.yaml %D%/drift-hertz/plot.gp %D%/drift-hertz/scene.yaml \
	%D%/drift-hooke/plot.gp %D%/drift-hooke/scene.yaml %D%/drum-angle/scene.yaml %D%/end-of-contact/force.txt \
	%D%/end-of-contact/overlap.txt %D%/end-of-contact/scene.yaml %D%/fluid-annulus/scene.yaml \
	%D%/fluid-cavity/scene.yaml %D%/fluid-couette/scene.yaml %D%/fluid-cylinder/scene.yaml \
	%D%/fluid-diffusion/scene.yaml %D%/fluid-electroosmosis/porous.yaml %D%/fluid-electroosmosis/scene.yaml \
	%D%/fluid-fluidised-bed/scene.yaml %D%/fluid-fluidised-bed/terminal.yaml %D%/fluid-operators/scene.yaml \
	%D%/fluid-poiseuille/scene.yaml %D%/fluid-settling/scene.yaml %D%/fluid-settling/shear.yaml \
	%D%/fluid-sphere-array/scene.yaml %D%/fluid-taylor-aris/scene.yaml %D%/fluid-taylor-green/scene.yaml \
	%D%/free-fall/scene.yaml %D%/haff/scene.yaml %D%/hard-beverloo/scene.yaml %D%/hard-bodies/scene.yaml \
	%D%/hard-boulder-discs/scene.yaml %D%/hard-boulder/scene.yaml %D%/hard-chain/scene.yaml \
	%D%/hard-column/scene.yaml %D%/hard-haff/scene.yaml %D%/hard-heavy/scene.yaml %D%/hard-impact/scene.yaml \
	%D%/hard-janssen/scene.yaml %D%/hard-mu-of-i/scene.yaml %D%/hard-rest/scene.yaml %D%/hard-rocks/scene.yaml \
	%D%/hard-sliding/scene.yaml %D%/hard-slope/scene.yaml %D%/heat-chain/scene.yaml %D%/heat-rod/particles.txt \
	%D%/heat-rod/scene.yaml %D%/hertz.awk %D%/impact.c %D%/impacts.sh %D%/implicit-hertz/scene.yaml \
	%D%/incline/scene.yaml %D%/janssen/scene.yaml %D%/jkr-pull-off/scene.yaml %D%/lees-edwards-gas/elastic.yaml \
	%D%/lees-edwards-gas/scene.yaml %D%/line.awk %D%/luding-unloading/impacts.yaml \
	%D%/luding-unloading/scene.yaml %D%/many-body/scene.yaml %D%/maw.c %D%/moving-wall/scene.yaml \
	%D%/order-hertz/plot.gp %D%/order-hertz/scene.yaml %D%/order-hooke/plot.gp %D%/order-hooke/scene.yaml \
	%D%/periodic/scene.yaml %D%/plane-mesh/scene.yaml %D%/restitution-hertz/particles.txt \
	%D%/restitution-hertz/plot.gp %D%/restitution-hertz/scene.yaml %D%/restitution-hooke/particles.txt \
	%D%/restitution-hooke/plot.gp %D%/restitution-hooke/scene.yaml %D%/restitution-speed/particles.txt \
	%D%/restitution-speed/plot.gp %D%/restitution-speed/scene.yaml %D%/rock-energy/scene.yaml \
	%D%/rock-rest/scene.yaml %D%/rock-rod/scene.yaml %D%/rock-slope/scene.yaml %D%/rock-stack/cubes.txt \
	%D%/rock-stack/scene.yaml %D%/rock-tumbling/scene.yaml %D%/rolling-decay/scene.yaml %D%/settling/scene.yaml \
	%D%/slide-to-roll/scene.yaml %D%/stack/scene.yaml %D%/sticking-velocity/scene.yaml %D%/style.gp \
	%D%/tumbling-clump/scene.yaml %D%/turning-wall/disc.txt %D%/turning-wall/hertz.yaml \
	%D%/turning-wall/plane.yaml %D%/turning-wall/scene.yaml %D%/vyas/plot.gp %D%/vyas/ratio-100.txt \
	%D%/vyas/scene.yaml %D%/wall-edge/plate.txt %D%/wall-edge/scene.yaml %D%/water-bed/discs.txt \
	%D%/water-bed/discs.yaml %D%/water-bed/scene.yaml %D%/water-bed/spheres.yaml \
	%D%/water-consolidation/permeability.yaml %D%/water-consolidation/scene.yaml %D%/water-hindered/scene.yaml \
	%D%/water-lubrication/scene.yaml %D%/water-settling/array.yaml %D%/water-settling/scene.yaml \
	%D%/water-settling/shear.yaml %D%/water-two-spheres/scene.yaml %D%/water-two-spheres/spheres.yaml

nobase_dist_pkgdata_SCRIPTS += \
	%D%/beverloo-3d/check %D%/beverloo/check %D%/bonded-cantilever/check %D%/bouncing/check %D%/bowl/check \
	%D%/capillary-bridge/check %D%/chain/check %D%/chung-ooi-1/check %D%/chung-ooi-2/check %D%/chung-ooi-3/check \
	%D%/chung-ooi-4/check %D%/chung-ooi-5/check %D%/chung-ooi-6/check %D%/chung-ooi-7/check \
	%D%/chung-ooi-8/check %D%/cradle/check %D%/dmt-pull-off/check %D%/drift-hertz/check %D%/drift-hooke/check \
	%D%/drum-angle/check %D%/end-of-contact/check %D%/fluid-annulus/check %D%/fluid-cavity/check \
	%D%/fluid-couette/check %D%/fluid-cylinder/check %D%/fluid-diffusion/check %D%/fluid-electroosmosis/check \
	%D%/fluid-fluidised-bed/check %D%/fluid-operators/check %D%/fluid-poiseuille/check %D%/fluid-settling/check \
	%D%/fluid-sphere-array/check %D%/fluid-taylor-aris/check %D%/fluid-taylor-green/check %D%/free-fall/check \
	%D%/haff/check %D%/hard-beverloo/check %D%/hard-bodies/check %D%/hard-boulder-discs/check \
	%D%/hard-boulder/check %D%/hard-chain/check %D%/hard-column/check %D%/hard-haff/check %D%/hard-heavy/check \
	%D%/hard-impact/check %D%/hard-janssen/check %D%/hard-mu-of-i/check %D%/hard-rest/check %D%/hard-rocks/check \
	%D%/hard-sliding/check %D%/hard-slope/check %D%/heat-chain/check %D%/heat-rod/check %D%/implicit-hertz/check \
	%D%/incline/check %D%/janssen/check %D%/jkr-pull-off/check %D%/layouts.sh %D%/lees-edwards-gas/check \
	%D%/luding-unloading/check %D%/many-body/check %D%/moving-wall/check %D%/order-hertz/check \
	%D%/order-hooke/check %D%/periodic/check %D%/plane-mesh/check %D%/restitution-hertz/check \
	%D%/restitution-hooke/check %D%/restitution-speed/check %D%/rock-energy/check %D%/rock-rest/check \
	%D%/rock-rod/check %D%/rock-slope/check %D%/rock-stack/check %D%/rock-tumbling/check %D%/rolling-decay/check \
	%D%/run.sh %D%/settling/check %D%/slide-to-roll/check %D%/stack/check %D%/sticking-velocity/check \
	%D%/table.sh %D%/tumbling-clump/check %D%/turning-wall/check %D%/vyas/check %D%/wall-edge/check \
	%D%/water-bed/check %D%/water-consolidation/check %D%/water-hindered/check %D%/water-lubrication/check \
	%D%/water-settling/check %D%/water-two-spheres/check
