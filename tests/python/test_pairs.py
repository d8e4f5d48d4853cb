# SPDX-License-Identifier: BSD-3-Clause
"""scree.pairs against all pairs by numpy."""

import numpy as np
import pytest
import scree


def cloud(count, dimension, size, seed=1):
    random = np.random.default_rng(seed)
    radii = np.where(np.arange(count) % 50 == 0, 1.0, 0.1 + 0.1 * random.random(count))
    return size * random.random((count, dimension)), radii


def brute(x, r, edge, periodic, margin):
    """All pairs as a set of (i, j, image) with i < j."""
    dimension = x.shape[1]
    ranges = [(-1, 0, 1) if p else (0,) for p in periodic]
    found = set()
    for image in np.array(np.meshgrid(*ranges)).T.reshape(-1, dimension):
        apart = np.linalg.norm(x[None] + image * edge - x[:, None], axis=2)
        for i, j in np.argwhere(apart < r[:, None] + r[None] + margin):
            if i < j:
                found.add((i, j, *image))
    return found


def by_scree(*arguments, **keys):
    i, j, image = scree.pairs(*arguments, **keys)
    assert i.dtype == j.dtype == np.int32 and image.dtype == np.int8 and len(i) == len(j) == len(image)
    found = {(a, b, *c) if a < b else (b, a, *(-c)) for a, b, c in zip(i.tolist(), j.tolist(), image)}
    assert len(found) == len(i)
    return found


@pytest.mark.parametrize("index", ["brute", "linkcell", "multi", "bytype", "hgrid"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_pairs_are_those_of_brute_force(index, dimension):
    x, r = cloud(500, dimension, 8.0)
    periodic = [True, False, True][:dimension]
    expected = brute(x, r, np.full(dimension, 8.0), periodic, 0.05)
    assert len(expected) > 100 and any(any(row[2:]) for row in expected)
    assert by_scree(x, r, edge=[8.0] * dimension, periodic=periodic, margin=0.05, index=index, threads=2) == expected


def test_an_open_box_needs_no_edge_and_any_place_will_do():
    x, r = cloud(300, 3, 6.0)
    x -= 1000.0
    expected = brute(x, r, np.ones(3), [False] * 3, 0.0)
    assert by_scree(x, r) == expected
    assert by_scree(x.astype(np.float64)[::1], r, threads=1) == expected
    everything = scree.pairs(x[:3] * 0, 1.0)
    assert len(everything[0]) == 3


def test_an_edge_alone_makes_all_directions_periodic():
    x, r = cloud(300, 3, 6.0)
    assert by_scree(x, r, edge=6.0) == brute(x, r, np.full(3, 6.0), [True] * 3, 0.0)


def test_nothing_is_found_among_nothing():
    i, j, image = scree.pairs(np.empty((0, 3)), np.empty(0))
    assert len(i) == len(j) == 0 and image.shape == (0, 3)
    assert len(scree.pairs([[0, 0, 0], [9, 0, 0]], [1, 1])[0]) == 0


@pytest.mark.parametrize(
    "keys, said",
    [
        (dict(index="octree"), "hgrid"),
        (dict(margin=-1), "margin"),
        (dict(edge=1.5), "sphere"),
        (dict(periodic=True), "edge"),
        (dict(radii=[1.0, np.nan]), "sphere 1"),
        (dict(radii=[1.0, 1e-320]), "sphere 1"),
        (dict(radii=[1.0, 1e200]), "sphere 1"),
        (dict(radii=[1.0, 1.0, 1.0]), "radii of the shape"),
        (dict(radii=["a", "b"]), "radii of the shape"),
        (dict(positions=[[0, 0, 0], [1e300, 0, 0]]), "sphere 1"),
        (dict(positions=[[0, 0, 0], [1e16, 0, 0]]), "sphere 1"),
        (dict(positions=[[0, 0, 0], [np.nan, 0, 0]]), "sphere 1"),
        (dict(positions=[0, 0, 0]), "shape"),
        (dict(edge=[4.0, 4.0]), "one value for each direction"),
        (dict(edge=4.0, periodic=[True]), "one value for each direction"),
        (dict(edge=np.nan), "sphere 0"),
        (dict(margin=np.inf), "margin"),
        (dict(threads=1.5), "threads"),
        (dict(threads=100000), "threads"),
    ],
)
def test_nonsense_is_refused(keys, said):
    arguments = dict(positions=[[0.5, 0.5, 0.5], [1.0, 1.0, 1.0]], radii=[0.5, 0.9])
    with pytest.raises(scree.Error, match=said):
        scree.pairs(**{**arguments, **keys})
