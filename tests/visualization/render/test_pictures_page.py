"""The examples of docs/pictures.md run unchanged."""

import re
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[3] / "docs" / "pictures.md"


@pytest.mark.slow
def test_the_examples_of_the_page_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(), flags=re.DOTALL)
    names: dict = {}
    for block in blocks:
        exec(block, names)
    assert (tmp_path / "pictures.png").exists() and len(blocks) == 4
    assert names["clear"].shape == (480, 640, 4) and (tmp_path / "clear.webp").exists()
    assert names["seen"].shape == (480, 640, 3) and names["depth"].max() == pytest.approx(6, rel=0.5)
