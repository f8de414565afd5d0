"""Scripts of Open3D's tutorials give Open3D's numbers when their import line is changed."""

from __future__ import annotations

import pytest

from .runner import CHAPTERS, assert_found_by_both

# Positions are float32 about an origin here, float64 there: 1e-7 of a length goes in, and small sums of it come out.
USUAL = 2e-6  # of the largest number, or of 1
TOLERANCES: dict[str, dict[str, float]] = {
    "chapter_11_surfaces": {"Poisson's area": 5e-3},  # the same equation on other cells
    "chapter_15_posed_frames": {"means": 2e-5},  # a point on the face of a voxel may fall to either side
}


@pytest.mark.parametrize("chapter", sorted(path.stem for path in CHAPTERS.glob("*.py")))
def test_a_script_runs_with_its_import_line_changed(chapter, oracle, tutorial_files, monkeypatch):
    assert_found_by_both(oracle, chapter, tutorial_files, monkeypatch, TOLERANCES.get(chapter, {}), USUAL)
