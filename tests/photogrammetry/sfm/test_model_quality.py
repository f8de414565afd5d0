"""Quality of a model: angles between rays, and whether rotation alone explains the pictures."""

import dataclasses

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm.model_quality import assess_model, parallax, triangulation_angles

FOCAL, WIDTH, HEIGHT = 500.0, 640, 480


def model_of(poses, points, *, focal=FOCAL, k=0.0, wrong_focal=1.0, noise=0.0) -> loom.SfmModel:
    """The model of a camera that sees points, stored with a wrong focal length."""
    true = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [focal, WIDTH / 2, HEIGHT / 2, k])
    stored = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [focal * wrong_focal, WIDTH / 2, HEIGHT / 2, 0.0])
    rng, seen, pixels = np.random.default_rng(1), [], []
    for number, T in enumerate(poses):
        at = true.project(points @ T[:3, :3].T + T[:3, 3])
        inside = ((at >= 0) & (at < (WIDTH, HEIGHT))).all(axis=1)
        seen += [(number, point) for point in np.flatnonzero(inside)]
        pixels.append(at[inside] + rng.normal(0, noise, (inside.sum(), 2)))
    names = [f"{k:03d}" for k in range(len(poses))]
    made = {"observations": seen, "pixels": np.concatenate(pixels), "errors": np.full(len(points), 0.5)}
    return loom.SfmModel(names, [stored] * len(poses), np.array(poses), points=points, **made)


def views(count: int, *, side: float, angle: float) -> list[np.ndarray]:
    poses = []
    for along in np.linspace(-0.5, 0.5, count):
        yaw, T = angle * along, np.eye(4)
        T[:3, :3] = [[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]]
        T[:3, 3] = -T[:3, :3] @ [side * along, 0, 0]
        poses.append(T)
    return poses


@pytest.fixture
def points(rng):
    return np.column_stack([rng.uniform(-4, 4, (400, 2)), rng.uniform(3, 8, 400)])


@pytest.mark.parametrize(("focal", "k"), [(0.7, 0.1), (1.0, -0.1), (1.5, 0.0)])
def test_pure_rotation_gives_no_parallax_for_any_lens(points, focal, k):
    model = model_of(views(8, side=0.0, angle=0.6), points, k=k, wrong_focal=focal, noise=0.3)
    assert parallax(model) < 1.0  # of which features that are 0.3 px off make up 0.6


@pytest.mark.parametrize("side", [0.2, 1.0])
def test_rotation_does_not_explain_a_moving_camera(points, side):
    model = model_of(views(8, side=side, angle=0.3), points, noise=0.3)
    assert parallax(model) > 3 and parallax(model, fixed=True) >= parallax(model)
    assert (assess_model(model, 8).reliable) == (side == 1.0)  # else the angles are too small


def test_a_rotating_camera_is_rejected_despite_wide_angles(points):
    seen = model_of(views(8, side=0.0, angle=0.6), points, noise=0.3)
    moved = seen.T_camera_world.copy()
    moved[:, 0, 3] = np.linspace(-0.5, 0.5, 8)  # motion that was made up
    quality = assess_model(dataclasses.replace(seen, T_camera_world=moved), 8)
    assert quality.angle > 2 and "the camera hardly moved" in str(quality.warnings)
    assert "move instead of only rotating" in str(quality.warnings)


def test_far_points_are_uncertain(points):
    quality = assess_model(model_of(views(8, side=0.1, angle=0.3), points * [1, 1, 0.6]), 8)
    assert quality.angle < 2 and "; ".join(quality.warnings)


def test_angles_are_between_the_two_farthest_rays(points):
    poses = views(9, side=1.0, angle=0.0)
    model = model_of(poses, points)
    angles = triangulation_angles(model)
    for point in range(0, 400, 17):
        rays = model.centers[model.observations[model.observations[:, 1] == point, 0]] - points[point]
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        widest = np.degrees(np.arccos(np.clip((rays @ rays.T).min(), -1, 1))) if len(rays) > 1 else 0.0
        assert angles[point] == pytest.approx(widest, abs=1e-5)


def test_points_with_at_most_one_observation_have_no_angle():
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
    seen = {"points": np.ones((2, 3)), "observations": [[0, 1]], "pixels": [[3.0, 4.0]]}
    model = loom.SfmModel(["a"], [camera], np.eye(4)[None], **seen)
    assert triangulation_angles(model).tolist() == [0, 0] and np.isnan(parallax(model))
    empty = loom.SfmModel([], [], np.zeros((0, 4, 4)))
    assert triangulation_angles(empty).tolist() == [] and np.isnan(parallax(empty))
    assert "only 0 points" in str(assess_model(empty, 0).warnings)
    assert "only 1 of 5 images" in str(assess_model(model, 5).warnings)


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_the_quality_does_not_depend_on_the_unit_or_the_position(points, scale):
    model = model_of(views(8, side=1.0, angle=0.3), points)
    T = np.diag([scale, scale, scale, 1.0])
    T[:3, 3] = 5e5 * scale, 4e6 * scale, 0
    moved, before = assess_model(model.transform(T), 8), assess_model(model, 8)
    assert moved.reliable
    assert (moved.angle, moved.parallax) == (pytest.approx(before.angle, rel=1e-5), pytest.approx(before.parallax))


def test_few_pictures_few_points_and_several_models_are_reported(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    assert assess_model(model, 4).reliable
    assert "only 4 of 10 images could be registered" in str(assess_model(model, 10).warnings)
    assert "the images form 2 separate models (4, 2 images)" in str(assess_model(model, 6, model_sizes=(4, 2)).warnings)
    assert assess_model(model, 4, model_sizes=(4, 2)).reliable  # the same pictures again
    few = assess_model(model_of(views(4, side=1.0, angle=0.3), points[:30]), 4)
    assert "only 30 points were triangulated" in str(few.warnings)
