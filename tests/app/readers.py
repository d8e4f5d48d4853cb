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


def by_vtk():
    """Force on each triangle adds up to the observable, in VTK's files as in XDMF's references; pressure follows from
    the force where there is no friction but by the law's own normal part, so that only its sign and bound are known."""
    import csv
    import xml.etree.ElementTree

    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    types = {"Int": "<i8", "Float": "<f8"}
    for folder in "walls_one", "walls_three":
        rows = list(csv.reader(open(folder + "/observables.csv")))
        grids = xml.etree.ElementTree.parse(folder + "/walls.xdmf").getroot().findall(".//Grid[@GridType='Uniform']")
        assert len(grids) == 4 and len(rows) == 5
        pressed = set()
        loaded, aligned = {1: 0, 3: 0}, {1: 0, 3: 0}
        for frame, step in enumerate((0, 200, 400, 600)):
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(f"{folder}/walls-{step}.vtp")
            reader.Update()
            read = reader.GetOutput()
            count = read.GetNumberOfPolys()
            cell = {name: vtk_to_numpy(read.GetCellData().GetArray(name)) for name in ("wall", "force", "pressure")}
            point = vtk_to_numpy(read.GetPoints().GetData()).reshape(count, 3, 3)
            for wall in range(6):
                own = cell["force"][cell["wall"] == wall].sum(axis=0)
                told = [float(x) for x in rows[1 + frame][1 + 3 * wall : 4 + 3 * wall]]
                assert abs(own - told).max() < 1e-12, (folder, step, wall, own, told)
                if abs(own).max() > 0:
                    pressed.add(wall)
            area = numpy.linalg.norm(numpy.cross(point[:, 1] - point[:, 0], point[:, 2] - point[:, 0]), axis=1) / 2
            force = numpy.linalg.norm(cell["force"], axis=1)
            assert (cell["pressure"] >= -1e-9).all() and ((cell["pressure"] > 0) == (force > 0)).all()
            lid = cell["wall"] == 5
            normal = abs(cell["force"][lid][:, 2]) / area[lid]  # the lid is flat and nothing touches its rim
            assert abs(cell["pressure"][lid] - normal).max() <= 1e-9 * (1 + normal.max())
            # without friction the force on a side of the funnel and of the tube is along its normal, save at rims
            across = numpy.cross(point[:, 1] - point[:, 0], point[:, 2] - point[:, 0]) / (2 * area[:, None])
            for wall in 1, 3:
                on = (cell["wall"] == wall) & (force > 0)
                along = abs((cell["force"][on] * across[on]).sum(axis=1)) / force[on]
                aligned[wall] += (along > 0.995).sum()
                loaded[wall] += on.sum()
            plate = point[cell["wall"] == 2][:, :, 2]
            assert abs(plate - (0.003 + 2 * step * 1e-5)).max() < 1e-12, (step, plate.min(), plate.max())
            found = {}
            for item in grids[frame].iter("DataItem"):
                shape = [int(n) for n in item.get("Dimensions").split()]
                values = numpy.fromfile(f"{folder}/{item.text}", types[item.get("NumberType")], shape[0] * shape[1],
                                        offset=int(item.get("Seek")))
                found[len(found)] = values.reshape(shape)
            assert (found[0].ravel() == range(3 * count)).all() and (found[1] == point.reshape(-1, 3)).all()
            assert (found[2].ravel() == cell["wall"]).all() and (found[3] == cell["force"]).all()
            assert (found[4].ravel() == cell["pressure"]).all()
        assert len(pressed) >= 4, pressed
        assert all(loaded[w] >= 2 and aligned[w] >= 0.8 * loaded[w] for w in loaded), (loaded, aligned)


{"vtkmodules": by_vtk, "h5py": by_h5py, "MDAnalysis": by_mdanalysis}[sys.argv[1]]()
