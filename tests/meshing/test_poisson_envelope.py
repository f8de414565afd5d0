"""Poisson's surface kept within a closed mesh, and the word on normals that do not agree."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import pointloom as loom

from .poisson_scenes import sphere


def box(low, high, device="cpu"):
    """A closed box."""
    grid = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)])
    corners = np.where(grid == 1, high, low).astype(float)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return loom.TriangleMesh(corners, [t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])], device=device)


def half_sphere(device, offset=0.0):
    points = sphere(4000)
    points = points[points[:, 2] > 0]
    return loom.PointCloud(points + offset, normals=points, device=device)


@pytest.mark.parametrize("offset", [0.0, np.array([5e5, 5.4e6, 100.0])])
def test_an_open_scan_stays_within_its_envelope(device, offset):
    cloud = half_sphere(device, offset)
    envelope = box(np.array([-1.15, -1.15, -0.1]) + offset, np.array([1.15, 1.15, 1.15]) + offset, device)
    free, _ = loom.TriangleMesh.from_point_cloud_poisson(cloud, 6, scale=1.5)
    held, _ = loom.TriangleMesh.from_point_cloud_poisson(cloud, 6, scale=1.5, envelope=envelope)
    cell = 1.5 * 2 / 2**5
    lowest = (free.vertices - offset)[:, 2].min(), (held.vertices - offset)[:, 2].min()
    assert lowest[0] < -0.4 and -0.1 - cell < lowest[1]
    assert held.is_watertight() and not free.is_watertight()


def test_an_envelope_turned_inside_out_is_the_same(device):
    cloud = half_sphere(device)
    envelope = box([-1.15, -1.15, -0.1], [1.15, 1.15, 1.15], device)
    turned = loom.TriangleMesh(envelope.vertices, envelope.triangles[:, ::-1], device=device)
    meshes = [loom.TriangleMesh.from_point_cloud_poisson(cloud, 5, envelope=e)[0] for e in (envelope, turned)]
    assert np.array_equal(meshes[0].vertices, meshes[1].vertices)


def test_an_envelope_that_is_open_or_no_mesh_or_too_fine_is_refused():
    cloud = half_sphere("cpu")
    with pytest.raises(ValueError, match="envelope: expected a closed mesh"):
        opened = box([-2] * 3, [2] * 3)
        opened = loom.TriangleMesh(opened.vertices, opened.triangles[1:])
        loom.TriangleMesh.from_point_cloud_poisson(cloud, 4, envelope=opened)
    with pytest.raises(TypeError, match="envelope: expected a TriangleMesh, got str"):
        loom.TriangleMesh.from_point_cloud_poisson(cloud, 4, envelope="box")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="envelope: expected up to 10,000 triangles"):
        fine = loom.TriangleMesh(np.zeros((3, 3)), np.zeros((10_001, 3), int))
        loom.TriangleMesh.from_point_cloud_poisson(cloud, 4, envelope=fine)


def test_normals_to_opposite_sides_are_spoken_of(device):
    points = sphere(1000)
    signs = np.where(np.random.default_rng(0).random(1000) < 0.5, 1.0, -1.0)[:, None]
    cloud = loom.PointCloud(points, normals=points * signs, device=device)
    with pytest.warns(loom.NormalsWarning, match="orient_normals_consistent_tangent_plane") as told:
        loom.TriangleMesh.from_point_cloud_poisson(cloud, 4)
    assert told[0].filename == __file__, "it points at the user's line"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        loom.TriangleMesh.from_point_cloud_poisson(cloud.orient_normals_consistent_tangent_plane(12), 4)
