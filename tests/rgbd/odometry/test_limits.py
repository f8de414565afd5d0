"""Each limit of the odometry checks counts by itself, on synthetic sums."""

import numpy as np
import pytest

from pointloom.kernels.rgbd import check_rows as at
from pointloom.kernels.rgbd.alignment import Alignment
from pointloom.rgbd.odometry.motion_checks import _first_fault


def fault_of(*, blur=0.0, **sums):
    """The fault of a pair of 1,000 pixels, 900 with depth and 800 on the surface, with other sums."""
    figures = np.zeros(at.EXCESS + 1)
    good = {"PIXELS": 1000, "SEEN": 900, "INLIERS": 800, "IN_FRONT": 10, "NORMALS": 800, "AGREEING": 780, "PLANES": 800}
    for name, value in (good | {"EXCESS": 800.0} | sums).items():
        figures[getattr(at, name)] = value
    none = np.zeros(21)
    alignment = Alignment(np.eye(4), 5, np.ones(4), none, figures, none, none)
    return _first_fault(alignment, *(figures[k] for k in (at.PIXELS, at.SEEN, at.INLIERS)), blur)


@pytest.mark.parametrize(
    ("sums", "fault"),
    [
        ({}, ""),
        ({"PIXELS": 0}, "the source has no depth"),
        ({"SEEN": 200, "INLIERS": 180}, "only 20% of the source pixels overlap with depth of the target"),
        ({"INLIERS": 450}, "only 50% of the overlapping pixels agree with the target's surface"),
        ({"IN_FRONT": 180}, "20% of the source pixels are in space that the target observed as free"),
        ({"AGREEING": 640}, "only 80% of the normals agree"),
        ({"EXCESS": 12_800.0}, "the surface residual is 4.0 times the depth noise"),
    ],
)
def test_each_sum_counts(sums, fault):
    assert fault_of(**sums) == fault


def test_target_blur_counts_as_noise():
    """Surface distances 4 times noise of 2 mm: a target blurred by 4 mm increases them by the root of 5."""
    sums = {"EXCESS": 12_800.0, "SQUARES": 12_800.0 * 0.002**2}
    assert "4.0 times the depth noise" in fault_of(**sums)
    assert fault_of(**sums, blur=0.004) == ""
    assert "3.6 times the depth noise" in fault_of(**sums, blur=0.001)
