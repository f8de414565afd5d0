"""Poisson surfaces against Open3D's on the same samples: as close to the true surface, with the same densities."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from .poisson_scenes import poisson, sphere, sphere_distance, torus, torus_distance


def open3d_poisson(o3d, points, normals, depth):
    """(vertices, densities, unit normals, triangles) of Open3D on one thread; with two, each run differs."""
    vector = o3d.utility.Vector3dVector
    cloud = o3d.geometry.PointCloud(vector(points))
    cloud.normals = vector(normals)
    mesh, densities = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth, n_threads=1)
    directions = np.asarray(mesh.vertex_normals)
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    return np.asarray(mesh.vertices), np.asarray(densities), directions, np.asarray(mesh.triangles)


def samples(kind: str, noise: float, depth: int = 5):
    count = 4_000 if depth == 5 else 10_000
    points, normals = (sphere(count), sphere(count)) if kind == "sphere" else torus(count)
    rng = np.random.default_rng(5)
    noisy = normals + 10 * noise * rng.normal(size=normals.shape)
    distance = sphere_distance if kind == "sphere" else torus_distance
    return points + noise * rng.normal(size=points.shape), noisy / np.linalg.norm(noisy, axis=1)[:, None], distance


SHARES = (0.5, 0.95)
SCENES = [("sphere", 5, 0.0), ("torus", 5, 0.0), ("sphere", 5, 0.01)]
DEEPER = [("torus", 6, 0.0), ("torus", 6, 0.01), ("sphere", 6, 0.0), ("sphere", 7, 0.0), ("torus", 7, 0.01)]


def open3d_errors(o3d, kind, depth, noise):
    points, normals, distance = samples(kind, noise, depth)
    return np.quantile(distance(open3d_poisson(o3d, points, normals, depth)[0]), SHARES)


def assert_as_near(device, tolerances, kind, depth, noise, theirs):
    points, normals, distance = samples(kind, noise, depth)
    vertices = poisson(points, normals, depth, device=device)[0].vertices
    assert (np.quantile(distance(vertices), SHARES) < tolerances.poisson_error * theirs).all()


@pytest.mark.parametrize(("kind", "depth", "noise"), SCENES)
def test_the_surface_is_as_accurate_as_that_of_open3d(device, oracle, tolerances, kind, depth, noise):
    theirs = oracle(f"meshing/poisson/{kind}_{depth}_{noise}", open3d_errors, kind, depth, noise)
    assert_as_near(device, tolerances, kind, depth, noise, theirs)


@pytest.mark.slow_on_emulated_cuda("trees of 100,000 cells")
@pytest.mark.slow
@pytest.mark.parametrize(("kind", "depth", "noise"), DEEPER)
def test_a_deeper_surface_is_as_accurate_as_that_of_open3d(device, o3d, tolerances, kind, depth, noise):
    assert_as_near(device, tolerances, kind, depth, noise, open3d_errors(o3d, kind, depth, noise))


def open3d_some_vertices(o3d, kind, depth):
    """About every tenth vertex with its density and normal; the counts of all vertices and triangles."""
    points, normals, _ = samples(kind, 0.0, depth)
    positions, densities, directions, triangles = open3d_poisson(o3d, points, normals, depth)
    some = slice(None, None, max(1, len(positions) // 700))
    parts = (positions[some], densities[some], directions[some])
    return *(values.astype(np.float32) for values in parts), len(positions), len(triangles)


def assert_alike(device, tolerances, kind, depth, theirs):
    positions, depths, directions, vertex_count, triangle_count = theirs
    points, normals, _ = samples(kind, 0.0, depth)
    mesh, densities = poisson(points, normals, depth, device=device)
    nearest = cKDTree(mesh.vertices).query(positions)[1]
    assert np.median(np.abs(densities[nearest] - depths)) < tolerances.poisson_density
    assert np.quantile((mesh.vertex_normals[nearest] * directions).sum(axis=1), 0.05) > 0.95
    assert abs(len(mesh.vertices) / vertex_count - 1) < 0.02 and abs(len(mesh) / triangle_count - 1) < 0.02


@pytest.mark.parametrize("kind", ["sphere", "torus"])
def test_densities_and_normals_match_open3d(device, oracle, tolerances, kind):
    assert_alike(device, tolerances, kind, 5, oracle(f"meshing/poisson/{kind}_5", open3d_some_vertices, kind, 5))


@pytest.mark.slow
def test_densities_and_normals_of_a_deeper_tree_match_open3d(device, o3d, tolerances):
    assert_alike(device, tolerances, "torus", 6, open3d_some_vertices(o3d, "torus", 6))
