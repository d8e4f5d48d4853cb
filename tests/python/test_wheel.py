# SPDX-License-Identifier: BSD-3-Clause
"""The wheel that `pip install .` makes: it holds the package, and works where nothing else of the source is."""

import os
import pathlib
import subprocess
import sys
import zipfile

import scree

SOURCE = pathlib.Path(__file__).parents[2].resolve()


def test_the_wheel_works_by_itself(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(SOURCE / "src/front/python"))
    import build_package

    monkeypatch.setenv("SCREE_LIBRARY", scree._where.LIBRARY)
    wheel = tmp_path / build_package.build_wheel(tmp_path)
    with zipfile.ZipFile(wheel) as archive:
        assert archive.testzip() is None
        archive.extractall(tmp_path / "site")
        recorded = archive.read([name for name in archive.namelist() if name.endswith("RECORD")][0]).decode().split()
        assert sorted(row.split(",")[0] for row in recorded) == sorted(archive.namelist())
    code = "import scree; i, j, image = scree.pairs([[0, 0, 0], [1, 0, 0]], 0.6); print(scree.__file__, len(i))"
    environment = {key: value for key, value in os.environ.items() if key != "SCREE_LIBRARY"}
    environment["PYTHONPATH"] = str(tmp_path / "site")
    done = subprocess.run([sys.executable, "-c", code], env=environment, cwd=tmp_path, capture_output=True, text=True)
    assert done.stdout.split() == [str(tmp_path / "site/scree/__init__.py"), "1"], done.stderr
