"""Scripts of Open3D's tutorials give Open3D's numbers after changing their import line."""

import pytest

from .runner import CHAPTERS, assert_same_results

# Positions are float32 about an origin here, float64 in Open3D: inputs differ by 1e-7 of a length, small sums more.
USUAL = 2e-6  # relative to the largest number, or to 1
TOLERANCES: dict[str, dict[str, float]] = {
    "chapter_11_surfaces": {"Poisson's area": 5e-3},  # the same equation on other cells
    "chapter_15_posed_frames": {"means": 2e-5},  # a point on a voxel face may be assigned to either side
}


@pytest.mark.parametrize("chapter", sorted(path.stem for path in CHAPTERS.glob("*.py")))
def test_a_script_runs_with_its_import_line_changed(chapter, oracle, tutorial_files, monkeypatch):
    assert_same_results(oracle, chapter, tutorial_files, monkeypatch, TOLERANCES.get(chapter, {}), USUAL)
