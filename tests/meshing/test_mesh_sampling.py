"""Surface samples of a mesh: proportional to area, exact far from zero, reproducible, with Open3D's spacing."""

import numpy as np
import pytest
from scipy import stats
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.meshing.mesh import mesh_measures

from .open3d_meshes import in_open3d

SQUARE = ([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])


def uneven(device=None, *, offset=(0, 0, 0), size=1.0) -> TriangleMesh:
    """Forty triangles of very different areas and directions, some degenerate, with normals and colors."""
    rng = np.random.default_rng(3)
    vertices = rng.normal(size=(60, 3))
    triangles = rng.permuted(np.tile(np.arange(60), (40, 1)), axis=1)[:, :3]
    triangles[::9, 2] = triangles[::9, 1]
    normals, colors = rng.normal(size=(60, 3)), rng.random((60, 3))
    at = vertices * size + np.asarray(offset)
    return TriangleMesh(at, triangles, vertex_normals=normals, vertex_colors=colors, device=device)


def locate(points: np.ndarray, mesh: TriangleMesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The triangle nearest to each point, the barycentric weights, and the distance [m] to its plane."""
    corners = mesh.vertices[mesh.triangles]
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    n = np.cross(u, v)
    size = (n**2).sum(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        d = points[:, None] - a[None]
        second = np.einsum("ijk,ijk->ij", np.cross(d, v[None]), np.broadcast_to(n, d.shape)) / size
        third = np.einsum("ijk,ijk->ij", np.cross(u[None], d), np.broadcast_to(n, d.shape)) / size
        height = np.abs(np.einsum("ijk,jk->ij", d, n)) / np.sqrt(size)
    weights = np.stack([1 - second - third, second, third], axis=-1)
    outside = np.maximum(0, -weights.min(axis=-1))
    off = np.where(np.isfinite(height), height + outside, np.inf)
    best = off.argmin(axis=1)
    rows = np.arange(len(points))
    return best, weights[rows, best], off[rows, best]


def test_points_are_distributed_in_proportion_to_area(device):
    mesh, count = uneven(device), 20_000
    chosen, _, off = locate(mesh.sample_points_uniformly(count, seed=4).points, mesh)
    assert off.max() < 1e-5
    corners = mesh.vertices[mesh.triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    counts = np.bincount(chosen, minlength=len(areas))
    assert (counts[areas == 0] == 0).all()
    expected = count * areas / areas.sum()
    assert stats.chisquare(counts[areas > 0], expected[areas > 0]).pvalue > 1e-3


def test_points_are_uniform_within_a_triangle(device):
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], device=device)
    x, y, _ = mesh.sample_points_uniformly(20_000).points.T
    cells = np.bincount((8 * x).astype(int) + 8 * (8 * y).astype(int), minlength=64).reshape(8, 8)
    i, j = np.indices((8, 8))
    expected = np.where(i + j < 7, 1.0, np.where(i + j == 7, 0.5, 0.0))  # of a cell, by the slanted side
    assert (cells[expected == 0] == 0).all()
    expected *= 20_000 / expected.sum()
    assert stats.chisquare(cells[expected > 0], expected[expected > 0]).pvalue > 1e-3


def open3d_samples(o3d, mesh):
    """Points of Open3D and their attributes, then triangle normals."""
    peer = in_open3d(o3d, mesh)
    o3d.utility.random.seed(0)
    cloud, flat = peer.sample_points_uniformly(60), peer.sample_points_uniformly(10, use_triangle_normal=True)
    return [np.array(values) for values in (cloud.points, cloud.colors, cloud.normals, flat.normals)]


def test_attributes_match_open3d_where_they_are_linear_in_position(device, oracle):
    slope = np.array([[0.3, 0.1, 0.2], [0.1, 0.4, 0.3], [0, 0, 0]])
    vertices = np.array(SQUARE[0], float)
    colors, normals = vertices @ slope, np.array([0, 0, 1.0]) + vertices @ slope
    mesh = TriangleMesh(*SQUARE, vertex_normals=normals, vertex_colors=colors, device=device)
    *theirs, flat = oracle("meshing/sampling/square", open3d_samples, mesh)
    result = mesh.sample_points_uniformly(300)
    for points, shades, directions, unit in ((*theirs, False), (result.points, result.colors, result.normals, True)):
        wanted = np.array([0, 0, 1.0]) + points @ slope
        wanted = wanted / np.linalg.norm(wanted, axis=1, keepdims=True) if unit else wanted
        np.testing.assert_allclose(shades, points @ slope, atol=1e-6)
        np.testing.assert_allclose(directions, wanted, atol=1e-6)
    np.testing.assert_array_equal(flat, mesh.sample_points_uniformly(10, use_triangle_normal=True).normals)


def test_samples_are_prefixes_of_larger_ones_and_depend_on_the_seed(device):
    mesh = uneven(device)
    many, few, others = (mesh.sample_points_uniformly(n, seed=s).points for n, s in ((400, 7), (50, 7), (400, 8)))
    assert many[:50].tobytes() == few.tobytes()
    assert not np.isin(many, others).any()


@pytest.mark.parametrize("size", [1e-15, 1e-6, 1e6])
def test_samples_do_not_depend_on_scale(device, size):
    points = uneven(device, size=size).sample_points_uniformly(300).points / size
    np.testing.assert_allclose(points, uneven(device).sample_points_uniformly(300).points, atol=2e-5)


def ball(device=None, *, size=1.0, offset=(0, 0, 0)) -> TriangleMesh:
    mesh = TriangleMesh.create_sphere(1.0, resolution=40)
    return TriangleMesh(mesh.vertices * size + np.asarray(offset), mesh.triangles, device=device)


def nearest(points: np.ndarray, area: float) -> np.ndarray:
    """The distance of each point to its nearest neighbor, relative to the spacing of a regular pattern."""
    return cKDTree(points).query(points, k=2)[0][:, 1] / (2 * np.sqrt(area / len(points) / (2 * np.sqrt(3))))


def open3d_spread(o3d, mesh, count):
    """The minimal distances of four runs, and mean quantiles: the largest distances of one run vary by 0.03."""
    peer, runs = in_open3d(o3d, mesh), []
    for seed in range(4):
        o3d.utility.random.seed(seed)
        runs.append(nearest(np.asarray(peer.sample_points_poisson_disk(count).points), mesh.get_surface_area()))
        assert len(runs[-1]) == count
    return [run.min() for run in runs], np.mean([np.quantile(run, [0.05, 0.5, 0.95]) for run in runs], axis=0)


def test_poisson_disk_spacing_matches_open3d(device, oracle):
    mesh, count = ball(device), 1000
    area = mesh.get_surface_area()
    spacings = nearest(mesh.sample_points_poisson_disk(count).points, area)
    minimum, spread = oracle("meshing/sampling/spread", open3d_spread, mesh, count)
    assert len(spacings) == count and spacings.min() > min(minimum) - 0.005
    np.testing.assert_allclose(np.quantile(spacings, [0.05, 0.5, 0.95]), spread, atol=0.02)
    assert spacings.mean() > 0.77 > 0.5 > nearest(mesh.sample_points_uniformly(count).points, area).mean()


def open3d_selection(o3d, mesh, points, count):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return np.array(in_open3d(o3d, mesh).sample_points_poisson_disk(count, pcl=cloud).points, np.float32)


def test_poisson_disk_selection_of_a_cloud_matches_open3d(device, oracle):
    """From the same points: all but the few that depend on summation order or ties."""
    mesh = ball(device)
    start = mesh.sample_points_uniformly(2000, seed=3)
    theirs = oracle("meshing/sampling/kept", open3d_selection, mesh, start.points.copy(), 400)
    result = mesh.sample_points_poisson_disk(400, pcl=start).points
    assert len(result) == len(theirs) == 400
    assert (cKDTree(theirs).query(result)[0] < 1e-6).mean() > 0.99


def test_a_cloud_keeps_attributes_and_order_and_loses_non_finite_points(device):
    mesh = TriangleMesh(*SQUARE, device=device)
    points = mesh.sample_points_uniformly(300).points.copy()
    points[::10] = np.nan
    start = loom.PointCloud(points, row=np.arange(300), colors=np.random.default_rng(0).random((300, 3)))
    cloud = mesh.sample_points_poisson_disk(60, pcl=start)
    assert str(cloud.device).startswith(device)
    rows = cloud["row"]
    assert len(rows) == 60 and (np.diff(rows) > 0).all() and (rows % 10 != 0).all()
    np.testing.assert_array_equal(cloud.points, start.points[rows])
    np.testing.assert_array_equal(cloud.colors, start.colors[rows])
    assert len(mesh.sample_points_poisson_disk(270, pcl=start)) == 270


@pytest.mark.parametrize("count", [1, 2, 3, 100])
def test_exact_number_of_points_is_returned(device, count):
    mesh = uneven(device)
    assert len(mesh.sample_points_poisson_disk(count)) == count
    assert len(mesh.sample_points_poisson_disk(count, init_factor=1)) == count
    assert len(mesh.sample_points_poisson_disk(count, init_factor=12, use_triangle_normal=True).normals) == count


@pytest.mark.parametrize("method", ["sample_points_uniformly", "sample_points_poisson_disk"])
def test_a_mesh_without_a_surface_is_rejected(device, method):
    for mesh in (TriangleMesh(device=device), TriangleMesh([[0, 0, 0]], device=device)):
        with pytest.raises(ValueError, match=f"{method}:"):
            getattr(mesh, method)(10)
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], device=device)
    with pytest.raises(ValueError, match=f"{method}:"):
        getattr(mesh, method)(10)


def test_more_points_than_poisson_disk_sampling_supports_are_rejected(device, monkeypatch):
    mesh = TriangleMesh(*SQUARE, device=device)
    with pytest.raises(ValueError, match="number_of_points, init_factor:"):
        mesh.sample_points_poisson_disk(4_000_000)
    with pytest.raises(ValueError, match="number_of_points, init_factor:"):
        mesh.sample_points_poisson_disk(10, init_factor=2**30)
    with pytest.raises(ValueError, match="pcl:"):
        mesh.sample_points_poisson_disk(4, pcl=loom.PointCloud([*SQUARE[0][:3], [0, np.nan, 0]]))
    monkeypatch.setattr(mesh_measures, "MAX_SAMPLES", 3)
    with pytest.raises(ValueError, match="pcl:"):
        mesh.sample_points_poisson_disk(2, pcl=loom.PointCloud(SQUARE[0]))


def test_too_many_point_pairs_are_rejected_with_advice(device, monkeypatch):
    for name, limit in (("MAX_PAIRS", 100), ("MAX_ROOM", 0)):
        monkeypatch.setattr(f"pointloom.kernels.meshes.poisson_disk.{name}", limit)
    mesh = TriangleMesh(*SQUARE, device=device)
    with pytest.raises(ValueError, match="number_of_points, init_factor:"):
        mesh.sample_points_poisson_disk(20)
    with pytest.raises(ValueError, match="pcl:"):
        mesh.sample_points_poisson_disk(2, pcl=mesh.sample_points_uniformly(20))


def test_too_many_points_for_memory_are_rejected_before_sampling(device, monkeypatch):
    monkeypatch.setattr("pointloom.kernels.memory.free_bytes", lambda device: 64_000)
    mesh = TriangleMesh(*SQUARE, device=device)
    assert len(mesh.sample_points_uniformly(1000)) == 1000
    with pytest.raises(MemoryError, match="number_of_points:"):
        mesh.sample_points_uniformly(1001)
