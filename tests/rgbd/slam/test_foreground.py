"""Moving foreground is excluded; stationary objects belong to the scene."""

import numpy as np
import pytest

from pointloom.rgbd.slam.foreground import Fit, Layers, depth_between

from .slam_walks import HEIGHT, VOXEL, WIDTH, begun, changed, error_of, fit, frame, frames, statuses

V, U = np.mgrid[:HEIGHT, :WIDTH]


def with_object(original, left, width, depth=600, seed=0):
    """A frame with a near object in some of its columns, whose pattern moves with the camera."""
    rng = np.random.default_rng([seed, original.timestamp is not None, int(1000 * (original.timestamp or 0))])
    mask = (left <= U) & (left + width > U)
    z = depth + 40 * np.sin((U - left) / 6) + 20 * np.cos(V / 8) + rng.normal(0, 1.5, U.shape)
    shade = 120 + 60 * np.sin((U - left) / 3) * np.cos(V / 4)
    picture, color = original.depth.copy(), original.color.copy()
    picture[mask] = np.rint(z[mask]).astype(picture.dtype)
    color[mask] = shade[mask][:, None].astype(np.uint8)
    return changed(original, depth=picture, color=color)


def off(results, true):
    pairs = zip(results, true, strict=True)
    return max(error_of(result, shown)[0] for result, shown in pairs if result.pose is not None)


def test_foreground_fixed_to_the_camera_is_excluded(device):
    source, slam = frames(*range(14)), begun(device)
    results = slam.run([with_object(f, 54, 26) for f in source])
    assert all(fit(results)) and len(results) == 14
    assert off(results, source) < VOXEL and slam.fixed_parts.hidden[:, 56:].mean() > 0.8
    assert not slam.fixed_parts.hidden[:, :50].any()
    assert slam.fixed_parts.note.startswith("an object that moves with the camera, 0.6")
    assert np.asarray(slam.render(results[-1].pose).depth)[:, 54:].max() > 1.0, "behind it the room is seen"


@pytest.mark.slow
def test_tracking_fails_without_foreground_exclusion():
    source, slam = frames(*range(14)), begun("cpu", leave_out_moving=False)
    results = slam.run([with_object(f, 54, 26) for f in source])
    assert "lost" in statuses(results) or off(results, source) > 0.06


def test_foreground_moving_before_the_camera_is_excluded(device):
    source, slam = frames(*range(14)), begun(device)
    results = slam.run([with_object(f, 20 + int(14 * np.sin(k / 3)), 30) for k, f in enumerate(source)])
    assert all(fit(results[2:])), "detection takes a frame or two"
    assert off(results[2:], source[2:]) < VOXEL / 2


def test_nothing_is_excluded_in_a_static_scene(device):
    source, slam = frames(*range(14)), begun(device)
    slam.run(source)
    assert slam.foreground.frames == 0 and slam.status_counts["tracked"] == 14 and not slam.fixed_parts.note


def test_a_stationary_camera_excludes_nothing():
    slam = begun("cpu")
    slam.run([with_object(changed(frame(0), timestamp=k / 30), 54, 26) for k in range(10)])
    assert slam.foreground.frames == 0 and not slam.fixed_parts.note


def test_exclusion_ends_after_the_foreground_disappears():
    source, slam = frames(*range(36)), begun("cpu")
    slam.run([with_object(f, 54, 26) if k < 4 else f for k, f in enumerate(source)])
    assert slam.fixed_parts.note and slam.fixed_parts.hidden is None and not slam.foreground.is_apart


def test_a_model_of_few_frames_finds_no_camera_that_was_lost_for_long():
    source, slam = frames(0, 1, 2), begun("cpu")
    dark = changed(source[2], depth=np.zeros_like(source[2].depth), timestamp=None)
    results = slam.run([source[0], source[1], *[dark] * 6, source[2]])
    assert statuses(results) == ["tracked", "tracked", *["lost"] * 7]
    assert results[-1].warnings == ("the model has only 2 frames, too few for relocalization",)


def test_the_depth_limit_is_between_the_two_classes():
    near, far = np.full(300, 1 / 0.8, np.float32), np.full(700, 1 / 2.5, np.float32)
    assert 0.8 < depth_between(np.concatenate([near, far, np.zeros(500, np.float32)])) < 2.5
    assert depth_between(np.concatenate([near[:30], far])) == 0.0, "too little is near"
    assert depth_between(np.zeros(100, np.float32)) == 0.0


def layers(full, far, agreement=0.95, **changes):
    from pointloom.rgbd.odometry.results import OdometryResult

    T = np.eye(4)
    T[0, 3] = 0.05
    values = {"transformation": T, "information": np.eye(6), "overlap": 0.8, "fitness": 0.75}
    result = OdometryResult(**{**values, "smallest_eigenvalue": 0.1, **changes})
    return Layers(Fit(full, agreement, result), Fit(far, agreement, result), np.eye(4))


def test_layers_are_separate_where_the_background_fits_better_than_all():
    assert layers(2.0, 0.2).are_apart and not layers(2.0, 0.2).are_one
    assert not layers(0.5, 0.3).are_apart and layers(0.5, 0.3).are_one
    assert not layers(2.0, 0.2, agreement=0.8).are_apart, "what lies behind is not found either"
    assert not layers(2.0, 0.2, overlap=0.5).are_apart
    far = np.eye(4)
    far[0, 3] = 0.4
    assert not layers(2.0, 0.2, transformation=far).are_apart, "views so far apart differ by themselves"
    assert not layers(2.0, 0.2, contradiction="the brightness does not agree").are_apart
    assert not layers(4.0, 4.0).are_one, "both fit badly"
    assert not layers(0.5, 0.3, transformation=np.eye(4)).are_one, "a camera that stands still tells nothing"


def test_the_background_must_constrain_the_pose():
    assert np.allclose(layers(2.0, 0.2).pose[:3, 3], [0.05, 0, 0])
    assert layers(2.0, 0.2, smallest_eigenvalue=0.01).pose is None
