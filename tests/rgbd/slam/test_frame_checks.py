"""Tracking status from the figures of an alignment: each limit counts by itself."""

import dataclasses

import numpy as np
import pytest

from pointloom.rgbd.odometry.motion_checks import UNDETERMINED
from pointloom.rgbd.odometry.results import OdometryResult
from pointloom.rgbd.slam.frame_checks import SURE_OVERLAP, judge_recognition, judge_tracking

FRACTIONS = {"inliers": 900, "fitness": 0.8, "overlap": 0.9}
ERRORS = {"inlier_rmse": 0.001, "intensity_rmse": 0.01, "smallest_eigenvalue": 0.1, "contradiction": ""}
GOOD = OdometryResult(transformation=np.eye(4), information=np.eye(6), iterations=5, **FRACTIONS, **ERRORS)


def moved(shift=0.0, angle=0.0):
    """A motion by a shift along x [m] and a rotation about z [degrees]."""
    T = np.eye(4)
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    T[:2, :2], T[0, 3] = [[c, -s], [s, c]], shift
    return T


def test_a_frame_on_the_model_near_the_last_pose_is_tracked():
    assert judge_tracking(GOOD, moved(0.3, 25.0)) == ("tracked", "")


@pytest.mark.parametrize(("shift", "angle"), [(0.5, 0.0), (0.0, 40.0), (0.5, 40.0), (np.nan, 0.0)])
def test_a_frame_with_a_pose_jump_is_lost_even_if_it_fits(shift, angle):
    status, reason = judge_tracking(GOOD, moved(shift, angle))
    assert status == "lost" and reason.startswith("its pose jumps by ")


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"overlap": 0.1, "fitness": 0.09}, "lost"),
        ({"overlap": 0.2, "fitness": 0.19}, "uncertain"),
        ({"fitness": 0.3}, "lost"),
        ({"fitness": 0.5}, "uncertain"),
        ({"contradiction": "the brightness does not agree"}, "lost"),
        ({"smallest_eigenvalue": 0.001}, "uncertain"),
    ],
)
def test_each_figure_counts_in_tracking(change, expected):
    status, reason = judge_tracking(dataclasses.replace(GOOD, **change), np.eye(4))
    assert status == expected and reason


@pytest.mark.parametrize(
    ("rmse", "usual_gap", "expected"),
    [
        (0.06, 0.01, "lost"),
        (0.06, 0.05, "tracked"),  # nearly the usual distance
        (0.008, 0.001, "tracked"),  # a multiple of the usual distance, but millimeters
        (0.06, np.nan, "tracked"),  # no usual distance yet
    ],
)
def test_a_frame_much_farther_from_the_model_than_usual_is_lost(rmse, usual_gap, expected):
    status, reason = judge_tracking(dataclasses.replace(GOOD, inlier_rmse=rmse), np.eye(4), usual_gap)
    assert status == expected and reason.startswith("its distance from the model" if expected == "lost" else "")


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({}, "tracked"),
        ({"warnings": (UNDETERMINED,)}, "tracked"),  # its limit is for frames of full size
        ({"warnings": ("the source has no depth",)}, "lost"),
        ({"smallest_eigenvalue": 0.001}, "lost"),
        ({"fitness": 0.6}, "lost"),
        ({"overlap": 0.4, "fitness": 0.4}, "lost"),
    ],
)
def test_each_figure_counts_in_relocalization(change, expected):
    assert judge_recognition(dataclasses.replace(GOOD, **change), SURE_OVERLAP)[0] == expected
