#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The contact search beside scipy's cKDTree, in clouds of spheres of two sizes or of a power law.

    PYTHONPATH=build/python python3 examples/bench/pairs.py [COUNT] [RATIO]

cKDTree has no radii. Two ways to use it: all pairs within the largest cut-off, of which the near ones are kept; and a
question for each sphere with its own radius and the largest of the others. The first is out of the question for many
large spheres, so the second is timed, too; a row shows the faster of both. Each search is timed three times on one
thread, and the fastest counts. All three find the same pairs."""

import sys
import time

import numpy as np
import scree

try:
    from scipy.spatial import cKDTree
except ImportError:
    sys.exit("skipped: no scipy (Debian: python3-scipy)")


def cloud(law, count, ratio, fraction=0.3, seed=1):
    """Positions in a box of edge 1, and radii: the sum of the volumes is `fraction`."""
    random = np.random.default_rng(seed)
    if law == "two sizes":  # half of the volume in large spheres
        radii = np.where(random.random(count) < 1 / (1 + ratio**3), ratio, 1.0)
    else:  # a power law of exponent -3 between 1 and ratio
        u = random.random(count)
        radii = (1 - u * (1 - ratio**-2.0)) ** -0.5
    radii *= (fraction / (4 / 3 * np.pi * np.sum(radii**3))) ** (1 / 3)
    return random.random((count, 3)), radii


def near(x, r, i, j):
    return np.linalg.norm(x[i] - x[j], axis=1) < r[i] + r[j]


def by_largest(x, r):
    """All pairs within the largest cut-off, of which the near ones are kept."""
    pairs = cKDTree(x).query_pairs(2 * r.max(), output_type="ndarray")
    return np.count_nonzero(near(x, r, pairs[:, 0], pairs[:, 1]))


def by_each(x, r):
    """The spheres in order of size: each asks for the smaller ones, within its own radius and the largest."""
    found = 0
    lists = cKDTree(x).query_ball_point(x, r + r.max(), return_sorted=False)
    lengths = np.fromiter(map(len, lists), int, len(lists))
    i, j = np.repeat(np.arange(len(x)), lengths), np.fromiter((k for some in lists for k in some), int, lengths.sum())
    keep = i < j
    found += np.count_nonzero(near(x, r, i[keep], j[keep]))
    return found


def by_scree(x, r):
    return len(scree.pairs(x, r, threads=1)[0])


def timed(search, x, r):
    best = np.inf
    for _ in range(3):
        begun = time.perf_counter()
        found = search(x, r)
        best = min(best, time.perf_counter() - begun)
    return best, found


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
    ratio = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
    print(f"{count} spheres, radii 1 to {ratio:g}, one thread; seconds, and how often scree is as fast")
    print(f"{'cloud':12} {'pairs':>9} {'scree':>10} {'cKDTree':>10} {'its way':>16} {'ratio':>7}")
    for law in ("two sizes", "power law"):
        x, r = cloud(law, count, ratio)
        seconds, found = timed(by_scree, x, r)
        others = {name: timed(search, x, r) for name, search in (("largest", by_largest), ("each", by_each))}
        assert all(number == found for _, number in others.values()), (found, others)
        way = min(others, key=lambda name: others[name][0])
        print(f"{law:12} {found:9} {seconds:10.4f} {others[way][0]:10.4f} {way:>16} {others[way][0] / seconds:7.1f}")


main()
