"""Objects before a surface hide it from the possible viewpoints."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.poses import line_of_sight
from pointloom.kernels.poses.line_of_sight import MAX_VIEWPOINTS, Sight, find_sight

EYE = np.zeros((1, 3))


def plate(x, y=(-1.0, 1.0), z=(-1.0, 1.0), step=0.03):
    u, v = (np.arange(low, high + 1e-9, step) for low, high in (y, z))
    return np.stack(np.meshgrid([x], u, v, indexing="ij"), -1).reshape(-1, 3)


def points_of(rows, device):
    return loom.PointCloud(rows, device=device).array("points")


def shifted(rows, device):
    cloud = loom.PointCloud(rows, device=device)
    return cloud.array("points"), np.asarray(cloud.origin, float)


@pytest.mark.parametrize(
    ("x", "y", "share"),
    [(1.0, (-0.4, 0.4), 1), (1.75, (-0.4, 0.4), 0), (3.0, (-0.4, 0.4), 0), (1.0, (2.0, 2.5), 0)],
    ids=["before", "too near to it to tell", "behind", "beside"],
)
def test_an_object_before_a_wall_is_in_the_way(device, x, y, share):
    wall, there = shifted(plate(2.0), device)
    screen, origin = shifted(plate(x, y, (-0.4, 0.4)), device)
    pose = np.eye(4)
    pose[:3, 3] = origin - there
    counts = Sight(wall, EYE - there, 0.1).count_occluding(screen, pose)
    assert counts.numpy().tolist() == [share * screen.size]


def test_a_surface_behind_another_plate_is_hidden(device):
    rows = np.r_[plate(1.0, (-0.5, 0.5), (-0.5, 0.5)), plate(2.0)]
    points, origin = shifted(rows, device)
    hidden = Sight(points, EYE - origin, 0.1).count_hidden(points)[0]
    shadow = (rows[:, 0] == 2) & (np.abs(rows[:, 1:]) < 1).all(axis=1)
    assert hidden == pytest.approx(shadow.sum(), rel=0.05)


def test_viewpoints_with_minimal_occlusion_are_selected(device):
    points = points_of(np.r_[plate(1.0, (-0.5, 0.5), (-0.5, 0.5)), plate(2.0), plate(-2.0)], device)
    sight = find_sight(points, 0.1)
    assert sight is not None and 0 < sight.viewpoint_count <= MAX_VIEWPOINTS
    x = np.asarray(sight.viewpoints.numpy())[:, 0]
    assert x.min() > 0.5  # farther back the small plate hides the wall behind it


def test_a_cloud_invisible_from_every_viewpoint_has_no_sight(device, rng, monkeypatch):
    ways = rng.normal(size=(8000, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    ways[:3000] *= 0.6  # a ball in a ball
    points = points_of(ways, device)
    assert find_sight(points, 0.1) is not None
    monkeypatch.setattr(line_of_sight, "HIDDEN", 0.01)
    assert find_sight(points, 0.1) is None
    assert find_sight(points_of(np.empty((0, 3)), device), 0.1) is None
