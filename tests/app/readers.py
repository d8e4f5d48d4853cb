# SPDX-License-Identifier: BSD-3-Clause
"""Reads the trajectories of readers.sh by the module that the argument names, and compares them with the dump of
the same run as scree's own reader converts it (double.data)."""
import sys


def atoms():
    """Positions of the last frame by id, in metres, from the LAMMPS data file."""
    rows, inside = {}, False
    for line in open("double.data"):
        word = line.split("#")[0].split()
        if word and word[0].isalpha():
            inside = word[0] == "Atoms"
        elif inside and len(word) >= 7:
            rows[int(word[0])] = [float(x) for x in word[4:7]]
    return [rows[k] for k in sorted(rows)]


def worst(found, scale=1):
    return max(abs(a * scale - b) for p, q in zip(found, atoms()) for a, b in zip(p, q))


def by_h5py():
    import h5py

    for folder, error in ("double", 0), ("single", 2e-9), ("packed", 0), ("plain", 0):
        with h5py.File(folder + "/trajectory.h5") as f:
            all_ = f["particles/all"]
            assert all_["position/value"].shape == (5, 2000, 3)
            assert all_["box"].attrs["dimension"] == 3 and list(all_["box"].attrs["boundary"]) == [b"periodic"] * 3
            assert all_["box/edges/step"] == all_["position/step"]
            assert abs(all_["box/edges/value"][4] - [[0.04, 0, 0], [0, 0.03, 0], [0, 0, 0.02]]).max() < 1e-15
            assert all_["position/value"].attrs.get("unit") == (None if folder == "plain" else "m")
            assert worst(all_["position/value"][4]) <= error, folder
    with h5py.File("both/trajectory.h5") as f:  # a resume has added two frames
        position = f["particles/all/position/value"]
        assert position.shape == (7, 2000, 3) and position.dtype == "<f4"
        assert position.shuffle and position.compression == "gzip" and position.compression_opts == 4
        assert worst(position[4]) < 2e-9


def by_mdanalysis():
    import MDAnalysis
    from MDAnalysis import units
    from MDAnalysis.coordinates.H5MD import H5MDReader

    def read(folder, **options):
        u = MDAnalysis.Universe.empty(2000, trajectory=False)
        u.load_new(folder + "/trajectory.h5", format="H5MD", **options)
        assert len(u.trajectory) == 5
        u.trajectory[4]
        return u

    u = read("plain", convert_units=False)
    assert worst(u.atoms.positions.tolist()) < 4e-9
    assert abs(u.dimensions - [0.04, 0.03, 0.02, 90, 90, 90]).max() < 1e-5
    # as docs/output.md says: MDAnalysis knows no metre
    units.lengthUnit_factor["m"] = 1e-10
    units.conversion_factor["length"]["m"] = 1e-10
    units.unit_types["m"] = "length"
    H5MDReader._unit_translation["length"]["m"] = "m"
    u = read("double")
    assert worst(u.atoms.positions.tolist(), 1e-10) < 4e-9
    assert abs(u.trajectory.time - 20e6) < 1  # ps


{"h5py": by_h5py, "MDAnalysis": by_mdanalysis}[sys.argv[1]]()
