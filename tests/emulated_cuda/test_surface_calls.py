"""How often surfaces, patches and planes wait for the device, at most, and that no bytes a point go to the host."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

import pointloom as loom

SIZES = (1003, 3011)
SPARE = 400  # bytes: a number or two a radius, a level or a batch of planes
Mesh = loom.TriangleMesh
MAX_WAITS = {
    "poisson, five full levels": (lambda ball, room: Mesh.create_from_point_cloud_poisson(ball, 5), 5),
    "ball pivoting": (lambda ball, room: Mesh.create_from_point_cloud_ball_pivoting(ball), 11),
    "ball pivoting, a radius": (lambda ball, room: Mesh.create_from_point_cloud_ball_pivoting(ball, 0.15), 4),
    "alpha shape": (lambda ball, room: Mesh.create_from_point_cloud_alpha_shape(ball), 8),  # empty: is it flat?
    "orientation": (lambda ball, room: ball.orient_normals_consistent_tangent_plane(12), 2),
    "disagreement": (lambda ball, room: ball.normal_disagreement(), 1),
    "segment_plane": (lambda ball, room: room.segment_plane(0.02, 3, 100), 4),
    "segment_planes": (lambda ball, room: room.segment_planes(0.02, 3, 100, max_planes=3), 12),
    "classify_ground": (lambda ball, room: loom.classify_ground(ball, 0.2, 0.05, 1.0, 0.1), 1),
    "metrics": (lambda ball, room: loom.compute_metrics(ball, room), 2),
}


def clouds(count):
    """A ball with normals, and three walls that meet."""
    rng = np.random.default_rng(0)
    ball = rng.normal(size=(count, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    walls = rng.random((count, 3))
    walls[np.arange(count), np.arange(count) % 3] = rng.normal(size=count) * 0.003
    return (
        loom.PointCloud(ball, normals=ball).to("cuda:0", arrays="warp"),
        loom.PointCloud(walls).to("cuda:0", arrays="warp").estimate_normals(max_nn=15),
    )


def count_requests(emulated, run) -> dict[str, int]:
    """Device calls of a function on its second call: trees and tables exist."""
    run()
    return emulated.count_requests(run)


@pytest.mark.parametrize("name", MAX_WAITS)
def test_waits_are_few_and_no_array_of_points_is_downloaded(emulated, name):
    operation, max_waits = MAX_WAITS[name]
    counts = [count_requests(emulated, partial(operation, *clouds(size))) for size in SIZES]
    assert max(row["copies to host"] for row in counts) <= max_waits
    assert counts[1]["bytes to host"] - counts[0]["bytes to host"] <= SPARE


@pytest.mark.parametrize("count", SIZES)
def test_planar_patches_wait_three_times_per_level_and_twice_per_round(emulated, count):
    _, room = clouds(count)
    counts = count_requests(emulated, lambda: room.detect_planar_patches(max_nn=15))
    rounds = counts["graphs made"]  # growing is a graph each time
    assert rounds >= 1 and counts["copies to host"] <= 3 * 8 + 2 * rounds + 8
