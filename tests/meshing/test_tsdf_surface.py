"""The surface of a TSDFVolume as a mesh and as points matches the observed surface."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.volumes.tsdf_blocks import SIDE

from .tsdf_scenes import CAMERA, RADIUS, SMALL, VOXEL, fuse, fused_sphere, set_voxels, triangle_normals, voxels_of


def dense_field(volume, threshold):
    """(field, low voxel): the distances in one array, NaN where weights do not exceed the threshold."""
    blocks, distances, weights, _ = voxels_of(volume)
    low = blocks.min(axis=0)
    size = (blocks.max(axis=0) + 1 - low) * SIDE
    field = np.full(size, np.nan, np.float32)
    for block, d, w in zip((blocks - low) * SIDE, distances, weights, strict=True):
        x, y, z = (slice(k, k + 8) for k in block)
        field[x, y, z] = np.where(w > threshold, d, np.nan)
    return field, low * SIDE


def boundary_edges(mesh):
    """Vertex indices [k, 2] of the edges with one triangle; fails for edges with more than two."""
    t = mesh.triangles.astype(np.int64)
    sides = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    edges, count = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    assert count.max() <= 2
    directed = len(np.unique(sides, axis=0))
    assert directed == len(sides), "neighbors turn the same way"
    return edges[count == 1]


def test_a_sphere_seen_from_all_sides_is_closed_and_round(device):
    mesh = fused_sphere(device).extract_triangle_mesh(0)
    assert np.isfinite(mesh.vertices).all()
    assert np.array_equal(np.unique(mesh.triangles), np.arange(len(mesh.vertices))), "no vertex without a triangle"
    assert len(np.unique(mesh.vertices.astype(np.float32), axis=0)) == len(mesh.vertices), "no two at one place"
    assert len(boundary_edges(mesh)) == 0 and mesh.is_watertight()
    error = np.linalg.norm(mesh.vertices, axis=1) - RADIUS
    assert np.sqrt(np.mean(error**2)) < 0.3 * VOXEL
    normals, centers = triangle_normals(mesh)
    assert (np.einsum("ij,ij->i", normals, centers) > 0).all(), "outward, toward the cameras"
    assert mesh.get_volume() == pytest.approx(4 / 3 * np.pi * RADIUS**3, rel=0.03)


def test_a_surface_of_random_values_matches_the_dense_copy(device, rng):
    """Every case of the table, across block boundaries, with random unseen voxels."""
    volume = fused_sphere(device)
    count = volume._blocks.distances.size
    set_voxels(volume, "distances", rng.uniform(-1, 1, count).astype(np.float32))
    set_voxels(volume, "weights", rng.integers(0, 30, count).astype(np.uint16))
    mesh = volume.extract_triangle_mesh(1)
    field, low = dense_field(volume, 1)
    dense = loom.marching_cubes(field, spacing=[VOXEL] * 3, origin=low * VOXEL, device=device)
    assert len(mesh) == len(dense) > 10_000
    assert len(mesh.vertices) == len(dense.vertices)
    a, b = (np.sort(triangle_normals(m)[1].round(4), axis=0) for m in (mesh, dense))
    assert np.abs(a - b).max() < 2e-4
    assert cKDTree(dense.vertices).query(mesh.vertices)[0].max() < 2e-6


def test_a_voxel_counts_if_more_frames_than_the_threshold_observed_it(device):
    frame = (np.full((120, 160), 1.2345), np.eye(4))
    volume = fuse([frame] * 3, device)
    sizes = [len(volume.extract_triangle_mesh(t)) for t in (0, 2, 2.5, 3, 4)]
    assert sizes[0] == sizes[1] == sizes[2] > 0 and sizes[3:] == [0, 0]
    assert [len(volume.extract_point_cloud(t)) > 0 for t in (2, 3)] == [True, False]
    assert [(volume.ray_cast(CAMERA, np.eye(4), weight_threshold=t).depth > 0).any() for t in (2, 3)] == [True, False]


def test_points_are_on_the_sphere_with_outward_normals(device):
    volume = fused_sphere(device)
    cloud, mesh = volume.extract_point_cloud(0), volume.extract_triangle_mesh(0)
    radii = np.linalg.norm(cloud.points, axis=1)
    assert np.sqrt(np.mean((radii - RADIUS) ** 2)) < 0.3 * VOXEL
    assert np.abs(np.linalg.norm(cloud.normals, axis=1) - 1).max() < 1e-5
    cosines = np.einsum("ij,ij->i", cloud.normals, cloud.points / radii[:, None])
    # means of clipped distances from many sides tilt the gradient; 13.8 degrees were measured
    assert cosines.min() > 0.8 and np.quantile(cosines, 0.05) > np.cos(np.radians(15))
    points = set(map(tuple, cloud.points.astype(np.float32).tolist()))
    assert set(map(tuple, mesh.vertices.astype(np.float32).tolist())) <= points, "each vertex is a point"


def test_an_empty_volume_gives_empty_results(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, device=device)
    mesh, cloud, view = volume.extract_triangle_mesh(), volume.extract_point_cloud(), volume.ray_cast(SMALL, np.eye(4))
    assert (len(mesh), len(mesh.vertices), len(cloud)) == (0, 0, 0)
    assert view.depth.shape == (24, 32) and not view.depth.any()
    assert np.isnan(view.points).all() and np.isnan(view.normals).all()
    assert volume.truncation == 4 * VOXEL
