"""from_point_cloud_poisson beside Open3D's on the same samples: as near to the true surface, and the same densities."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from .poisson_scenes import poisson, sphere, sphere_distance, torus, torus_distance


def in_open3d(points, normals, depth, **options):
    """(vertices, densities, unit normals, triangles) of Open3D, on one thread: on two each run differs."""
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    vector = o3d.utility.Vector3dVector
    cloud = o3d.geometry.PointCloud(vector(points))
    cloud.normals = vector(normals)
    mesh, densities = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth, n_threads=1, **options)
    directions = np.asarray(mesh.vertex_normals)
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    return np.asarray(mesh.vertices), np.asarray(densities), directions, np.asarray(mesh.triangles)


def samples(kind: str, noise: float, depth: int = 5):
    count = 4_000 if depth == 5 else 10_000
    points, normals = (sphere(count), sphere(count)) if kind == "sphere" else torus(count)
    rng = np.random.default_rng(5)
    turned = normals + 10 * noise * rng.normal(size=normals.shape)
    distance = sphere_distance if kind == "sphere" else torus_distance
    return points + noise * rng.normal(size=points.shape), turned / np.linalg.norm(turned, axis=1)[:, None], distance


SCENES = [("sphere", 5, 0.0), ("torus", 5, 0.0), ("sphere", 5, 0.01), ("torus", 6, 0.0), ("torus", 6, 0.01)]
DEEPER = [("sphere", 6, 0.0), ("sphere", 6, 0.01), ("sphere", 7, 0.0), ("torus", 7, 0.01)]


@pytest.mark.parametrize(("kind", "depth", "noise"), SCENES)
def test_the_surface_is_as_near_to_the_true_one(device, tolerances, kind, depth, noise):
    points, normals, distance = samples(kind, noise, depth)
    theirs, _, _, _ = in_open3d(points, normals, depth)
    ours = poisson(points, normals, depth, device=device)[0].vertices
    for share in (0.5, 0.95):
        assert np.quantile(distance(ours), share) < tolerances.poisson_error * np.quantile(distance(theirs), share)


@pytest.mark.slow_on_emulated_cuda("trees of 100,000 cells")
@pytest.mark.slow
@pytest.mark.parametrize(("kind", "depth", "noise"), DEEPER)
def test_a_deeper_surface_is_as_near_to_the_true_one(device, tolerances, kind, depth, noise):
    test_the_surface_is_as_near_to_the_true_one(device, tolerances, kind, depth, noise)


@pytest.mark.parametrize(("kind", "depth"), [("sphere", 5), ("torus", 5), ("torus", 6)])
def test_densities_and_normals_are_open3ds(device, tolerances, kind, depth):
    points, normals, _ = samples(kind, 0.0, depth)
    places, depths, directions, _ = in_open3d(points, normals, depth)
    mesh, densities = poisson(points, normals, depth, device=device)
    nearest = cKDTree(places).query(mesh.vertices)[1]
    assert np.median(np.abs(densities - depths[nearest])) < tolerances.poisson_density
    assert np.quantile((mesh.vertex_normals * directions[nearest]).sum(axis=1), 0.05) > 0.95


def test_a_mesh_has_as_many_vertices(device):
    points, normals, _ = samples("torus", 0.0)
    places, _, _, triangles = in_open3d(points, normals, 5)
    mesh, _ = poisson(points, normals, 5, device=device)
    assert abs(len(mesh.vertices) / len(places) - 1) < 0.02 and abs(len(mesh) / len(triangles) - 1) < 0.02


def test_far_from_zero_the_surface_stays_where_open3ds_falls_apart(device):
    points, far = sphere(3000), np.array([5e5, 5.4e6, 100])
    ours = poisson(points + far, points, device=device)[0].vertices - far
    theirs = in_open3d(points + far, points, 5)[0] - far
    assert np.quantile(sphere_distance(ours), 0.95) < 0.003 < 10 * np.quantile(sphere_distance(theirs), 0.95)
