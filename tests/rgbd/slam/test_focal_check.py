"""A wrong focal length is detected from frames that are rotated relative to each other."""

import numpy as np
import pytest

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.trajectory import Trajectory
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import room_loop_sequence
from pointloom.rgbd.slam.focal_check import MIN_ROTATION, check_focal, rotated_pairs

from ..sequences import Part


class Stretched(Part):
    """Frames with a wrong focal length."""

    def __init__(self, part: Part, factor: float):
        super().__init__(part.sequence, part.count, part.every)
        K = part.intrinsic
        self.intrinsic = PinholeCameraIntrinsic(K.width, K.height, K.fx * factor, K.fy * factor, K.cx, K.cy)


@pytest.fixture(scope="module")
def turning() -> Part:
    """10 frames, 4 to 7 degrees apart."""
    return Part(room_loop_sequence(120, width=80, height=60), 10, every=1)


@pytest.fixture(scope="module")
def short_sequence() -> Part:
    """8 frames, 1 cm apart."""
    return Part(room_loop_sequence(600, width=80, height=60), 8)


def path_of(part: Part) -> Trajectory:
    order = np.arange(len(part))[:, None]
    return Trajectory(part.poses, ids=np.hstack([order, order, order + 1]))


def test_the_right_focal_length_is_not_reported(turning, device):
    check = check_focal(turning, path_of(turning), depth_max=4.0, device=device)
    assert check is not None and check.factor == 1.0
    assert check.reliable and "no other focal length fits better" in str(check)


@pytest.mark.parametrize(
    ("factor", "better"),
    [(1.25, 0.8), pytest.param(0.8, 1.25, marks=pytest.mark.slow), pytest.param(0.9, 1.1, marks=pytest.mark.slow)],
)
def test_a_wrong_focal_length_is_reported_with_a_better_one(turning, factor, better):
    check = check_focal(Stretched(turning, factor), path_of(turning), depth_max=4.0)
    assert check is not None and check.factor == better
    assert f"about {better:g} times as long" in str(check.warnings)


def test_a_camera_with_little_rotation_gives_no_focal_check(short_sequence):
    assert check_focal(short_sequence, path_of(short_sequence), depth_max=4.0) is None


def test_uncertain_poses_and_unreadable_frames_give_no_focal_check(turning, monkeypatch):
    path = path_of(turning)
    assert check_focal(turning, path, depth_max=4.0, uncertain=range(2, 10)) is None

    def break_off(index):
        raise FileError("frame.png", "damaged")

    monkeypatch.setattr(turning, "read", break_off)
    assert check_focal(turning, path, depth_max=4.0) is None


def test_pairs_are_rotated_enough_and_end_at_different_frames(turning):
    path = path_of(turning)
    pairs = rotated_pairs(path)
    assert len(pairs) >= 3
    assert len({second for _, second in pairs}) == len(pairs)
    for first, second in pairs:
        cosine = path.poses[first, :3, 2] @ path.poses[second, :3, 2]
        assert cosine < np.cos(np.radians(MIN_ROTATION))
