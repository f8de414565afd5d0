"""What frames leave open adds up along a path, until the camera sees again what is surer; it reaches all verdicts."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam.frame_checks import MAX_DEVIATION, judge_drift
from pointloom.rgbd.slam.keyframes import Keyframes
from pointloom.rgbd.slam.results import TrackingResult
from pointloom.rgbd.slam.tracker import Drift

from .slam_walks import begun, frames


def deviated(off: float, verdict="tracked") -> TrackingResult:
    covariance = np.zeros((6, 6))
    covariance[4, 4] = off * off
    return TrackingResult(np.eye(4), verdict, covariance=covariance)


def test_the_deviation_of_a_position_is_that_of_its_most_open_direction():
    assert np.isclose(deviated(0.02).position_deviation, 0.02)


@pytest.mark.parametrize(("share", "verdict"), [(0.9, "tracked"), (1.1, "uncertain")])
def test_a_pose_that_is_too_open_is_uncertain_and_its_frame_fits_all_the_same(share, verdict):
    judged = judge_drift(deviated(share * MAX_DEVIATION), 0.04)
    assert (judged.status, judged.has_drifted) == (verdict, verdict == "uncertain")
    assert judged.reliable == (verdict != "uncertain")


def test_a_coarser_model_holds_less():
    assert judge_drift(deviated(1.5 * MAX_DEVIATION), 0.16).status == "tracked"


def test_a_lost_frame_stays_lost():
    assert judge_drift(dataclasses.replace(deviated(1.0), status="lost"), 0.04).status == "lost"


def test_the_way_adds_up_and_a_look_back_takes_it_off(device):
    """Each alignment is as sure as any other here: what differs is what a frame stands on."""
    model, own, offs = begun(device).model, 1e-6 * np.eye(6), []
    keyframes = Keyframes(model.device)
    drift = Drift(keyframes)
    for number in range(0, 60, 6):
        shown = frames(number)[0]
        pyramid = model.prepare(shown).pyramid
        offs.append(np.trace(drift.of(pyramid, shown.T_world_camera, own)[3:, 3:]))
        keyframes.add(pyramid, shown.T_world_camera, number)
        drift.keep(pyramid)
    back = frames(1)[0]
    again = np.trace(drift.of(model.prepare(back).pyramid, back.T_world_camera, own)[3:, 3:])
    assert offs[0] == 0 and offs[-1] > 2 * offs[1] > 0
    assert again < 0.7 * offs[-1]


def test_covariances_are_symmetric_and_positive(device):
    for result in begun(device).run(frames(0, 2, 4))[1:]:
        assert np.allclose(result.covariance, result.covariance.T)
        assert np.linalg.eigvalsh(result.covariance).min() > 0


def test_a_path_that_is_open_is_unreliable_and_says_by_how_much():
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    v, u = np.mgrid[:48, :64]
    depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    path = loom.track(loom.frames_from([(None, depth)] * 3, camera))
    assert path.reliable and path.to_dict()["position_deviation_m"] == max(path.deviations) < MAX_DEVIATION
    drifted = dataclasses.replace(path, deviations=(0.0, 0.02, 0.12), drifted=(2,), uncertain=(2,))
    assert not drifted.reliable and "0.12 m" in str(drifted.warnings) and drifted.to_dict()["drifted"] == [2]
    assert "120 mm" in str(drifted)
