# SPDX-License-Identifier: BSD-3-Clause
"""scree from Python: particles of very different sizes.

    import scree

    scene = scree.Scene("sand.yaml")                 # or a dict of the same keys
    simulation = scree.Simulation(scene)
    simulation.run(steps=1000)
    simulation.position                              # a numpy array on the memory of the simulation
    simulation.observables                           # a pandas DataFrame

    i, j, image = scree.pairs(positions, radii)      # the contact search alone

docs/python.md is a tutorial."""

from ._library import Error, version
from ._scene import Scene
from ._search import pairs
from ._simulation import Simulation

__all__ = ["Error", "Scene", "Simulation", "pairs", "version"]
__version__ = version()
