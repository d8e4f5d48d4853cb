# SPDX-License-Identifier: BSD-3-Clause
"""The contact search."""

import numpy as np

from ._library import Error, ffi, lib, spread, whole

_PAIR = np.dtype([("i", np.int32), ("j", np.int32), ("image", np.int8, 3)], align=True)


def _three(values, dimension, fill, dtype):
    """`values`, one for each direction, and `fill` for a third one."""
    out = np.full(3, fill, dtype)
    values = np.asarray(values, dtype)
    if values.shape != (dimension,):
        raise Error("edge and periodic have one value for each direction, or one for all")
    out[:dimension] = values
    return out


def pairs(positions, radii, edge=None, periodic=None, margin=0.0, index="hgrid", threads=0):
    """Finds all pairs of spheres nearer than r_i + r_j + margin.

    positions: (n, 3), or (n, 2) for discs; in periodic directions in [0, edge).
    radii: n numbers > 0, or one for all.
    edge: edges of the periodic box, one for each direction or one for all; None: nothing is periodic.
    periodic: True or False for each direction; None: all directions if there is an edge.
    index: a name of `scree help index.name`; threads: 0 for as many as OpenMP offers.

    Returns i, j (int32, m each; each pair once, in no particular order) and image (int8, (m, dimension)):
    positions[j] + image * edge is the place of j that i meets. Raises Error where the index cannot serve."""
    x = np.asarray(positions, np.float64)
    if x.ndim != 2 or x.shape[1] not in (2, 3):
        raise Error("positions have the shape (n, 3) or (n, 2)")
    count, dimension = x.shape
    if dimension == 2:
        x = np.column_stack([x, np.zeros(count)])
    x = np.ascontiguousarray(x)
    r = np.ascontiguousarray(spread(radii, "radii", (count,), float))
    if edge is not None and np.ndim(edge) == 0:
        edge = [edge] * dimension
    if periodic is None:
        periodic = [edge is not None] * dimension
    elif np.ndim(periodic) == 0:
        periodic = [periodic] * dimension
    if edge is None and np.any(periodic):
        raise Error("a periodic direction needs an edge")
    spheres = ffi.new("struct scree_spheres *")
    spheres.count = count
    spheres.position = ffi.from_buffer("double[]", x)
    spheres.radius = ffi.from_buffer("double[]", r)
    spheres.edge = list(_three([1.0] * dimension if edge is None else edge, dimension, 1.0, float))
    spheres.periodic = [bool(p) for p in _three(periodic, dimension, False, bool)]
    spheres.dimension = dimension
    found, number, why = ffi.new("struct scree_pair **"), ffi.new("size_t *"), ffi.new("char[512]")
    if not lib.scree_pairs(index.encode(), spheres, float(margin), whole(threads, "threads", -1 << 31, (1 << 31) - 1), found, number, why, len(why)):
        raise Error(ffi.string(why).decode(errors="replace"))
    try:
        if number[0] == 0:
            return np.empty(0, np.int32), np.empty(0, np.int32), np.empty((0, dimension), np.int8)
        rows = np.frombuffer(ffi.buffer(found[0], number[0] * ffi.sizeof("struct scree_pair")), _PAIR)
        return rows["i"].copy(), rows["j"].copy(), rows["image"][:, :dimension].copy()
    finally:
        lib.scree_free(found[0])
