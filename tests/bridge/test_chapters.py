"""Scripts of Open3D's tutorials give Open3D's numbers when their import line is changed."""

from __future__ import annotations

import pytest

from .runner import CHAPTERS, differences, draw_nothing, found_by

# Positions are float32 about an origin here, float64 there: 1e-7 of a length goes in, and small sums of it come out.
USUAL = 2e-6  # of the largest number, or of 1
POISSON = 5e-3  # the same equation on other cells
TOLERANCES: dict[str, dict[str, float]] = {
    "chapter_07_icp": {"after": 1e-3, "pose": 1e-3},  # pairs at the threshold: 9,130 and 9,132 of 12,998
    "chapter_13_odometry": {"hybrid": 1e-4},  # pixels whose depths differ by just the limit
    "chapter_11_surfaces": {"Poisson's area": POISSON},
    # Balls roll from another triangle, and leave other gaps where points are sparse.
    "chapter_14_robust_kernels": {"Poisson's area": POISSON, "balls' area": 0.1},
    "chapter_15_posed_frames": {"means": 2e-5},  # a point on the face of a voxel may fall to either side
}


LONG = {"chapter_14_robust_kernels"}  # a robust ICP and two surfaces: a page and chapter 11 hold each by itself


@pytest.mark.parametrize(
    "chapter",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name in LONG else [])
        for name in sorted(path.stem for path in CHAPTERS.glob("*.py"))
    ],
)
def test_a_script_runs_with_its_import_line_changed(chapter, tutorial_files, monkeypatch):
    import open3d

    import pointloom.open3d

    shown = [draw_nothing(monkeypatch, module) for module in (open3d, pointloom.open3d)]
    theirs = found_by(chapter, "open3d", tutorial_files)
    ours = found_by(chapter, "pointloom.open3d", tutorial_files)
    assert differences(theirs, ours, TOLERANCES.get(chapter, {}), USUAL) == []
    assert shown[0] == shown[1]
