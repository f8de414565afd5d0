"""Scripts of Open3D's tutorials give Open3D's numbers when their import line is changed."""

from __future__ import annotations

import pytest

from .runner import CHAPTERS, differences, draw_nothing, found_by

# Positions are float32 about an origin here, float64 there: 1e-7 of a length goes in, and small sums of it come out.
USUAL = 2e-6  # of the largest number, or of 1
TOLERANCES: dict[str, dict[str, float]] = {}


@pytest.mark.parametrize("chapter", sorted(path.stem for path in CHAPTERS.glob("*.py")))
def test_a_script_runs_with_its_import_line_changed(chapter, tutorial_files, monkeypatch):
    import open3d

    import pointloom.open3d

    shown = [draw_nothing(monkeypatch, module) for module in (open3d, pointloom.open3d)]
    theirs = found_by(chapter, "open3d", tutorial_files)
    ours = found_by(chapter, "pointloom.open3d", tutorial_files)
    assert differences(theirs, ours, TOLERANCES.get(chapter, {}), USUAL) == []
    assert shown[0] == shown[1]
