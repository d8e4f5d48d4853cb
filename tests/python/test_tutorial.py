# SPDX-License-Identifier: BSD-3-Clause
"""The code of docs/python.md and of docs/howto/coupling.md runs, block after block."""

import os
import pathlib
import re
import subprocess

import pytest
import scree

SOURCE = pathlib.Path(__file__).parents[2].resolve()


@pytest.mark.parametrize("page, least", [("python.md", 6), ("howto/coupling.md", 1)])
def test_the_code_of_a_page_runs(page, least, tmp_path, monkeypatch):
    page = SOURCE / "docs" / page
    blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) >= least
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(SOURCE / "examples")
    names = {}
    for block in blocks:
        exec(compile(block, str(page), "exec"), names)
    if page.name == "python.md":
        numbers_equal_those_of_the_command_line(names["scene"])


def numbers_equal_those_of_the_command_line(scene):
    """The scene of the tutorial in reproducible mode, in this folder: the same texts of all numbers."""
    simulation = scree.Simulation(scree.Scene(scene.text, set={"reproducible": True}, folder="."))
    pathlib.Path("tutorial.yaml").write_text(simulation.scene)
    subprocess.run([os.environ["SCREE"], "run", "tutorial.yaml", "-o", "out", "--quiet"], check=True)
    lines = pathlib.Path("out/observables.csv").read_text().splitlines()
    table = simulation.run().observables
    assert len(lines) == 32 and lines[1:] == [",".join("%.15g" % value for value in row) for row in table.to_numpy()]
