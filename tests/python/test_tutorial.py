# SPDX-License-Identifier: BSD-3-Clause
"""The code of docs/python.md and of docs/howto/coupling.md runs, block after block."""

import pathlib
import re

import pytest

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
