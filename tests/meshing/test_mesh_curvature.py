"""Curvature, geodesic distances and samples of surfaces with known geometry."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.meshes import geodesics
from pointloom.meshing.mesh import sampling

from .open3d_meshes import in_open3d
from .shape_scenes import eight_vertices, hostile_triangles, icosphere, shaken_grid


def around(device, height, cells=24):
    """A grid over -1/2 .. 1/2 as a height field of x and y, and its middle vertex."""
    positions, triangles = shaken_grid(cells, shake=0.0)
    x, y = positions[:, 0] - 0.5, positions[:, 1] - 0.5
    middle = int(np.argmin(x * x + y * y))
    return TriangleMesh(np.c_[x, y, height(x, y)], triangles, device=device).compute_vertex_curvature(), middle


@pytest.mark.parametrize("radius", [1.0, 0.02, 300.0])
def test_a_sphere_has_the_curvature_of_its_radius(device, radius):
    errors = []
    for rounds in (2, 3):
        curvature = TriangleMesh(*icosphere(rounds, radius), device=device).compute_vertex_curvature()
        np.testing.assert_allclose(curvature.mean * radius, 1, rtol=0, atol=1e-3)  # truncated: edges of 0.3 radii
        errors.append(np.abs(curvature.gaussian * radius**2 - 1).max())
        assert (curvature.least <= curvature.mean).all() and (curvature.mean <= curvature.largest).all()
    assert errors[0] < 0.03 and errors[1] < errors[0] / 3  # falls with the square of the edges


def test_angle_defects_of_a_closed_mesh_sum_to_4_pi(device):
    """Gauss-Bonnet: over a sphere, curvature times mixed Voronoi area sums to 4 pi."""
    rng = np.random.default_rng(0)
    vertices, triangles = icosphere(1)
    mesh = TriangleMesh(vertices * (1 + 1.5 * rng.random((len(vertices), 1))), triangles, device=device)
    areas = mixed_areas(mesh.vertices, triangles)
    assert areas.sum() == pytest.approx(mesh.get_surface_area(), rel=1e-12)
    assert (mesh.compute_vertex_curvature().gaussian * areas).sum() == pytest.approx(4 * np.pi, rel=1e-12)


def mixed_areas(vertices, triangles):
    """The mixed Voronoi areas of Meyer et al., figure 4."""
    areas = np.zeros(len(vertices))
    for triangle in triangles:
        for k in range(3):
            p, q, r = vertices[np.roll(triangle, -k)]
            u, v, w = q - p, r - p, r - q
            twice = np.linalg.norm(np.cross(u, v))
            if u @ v < 0:
                areas[triangle[k]] += twice / 4
            elif u @ w > 0 or v @ w < 0:
                areas[triangle[k]] += twice / 8
            else:
                areas[triangle[k]] += (u @ u * (v @ w) - v @ v * (u @ w)) / twice / 8
    return areas


@pytest.mark.parametrize(
    ("height", "smallest", "largest"),
    [(lambda x, y: 0 * x, 0, 0), (lambda x, y: -(x * x + y * y) / 2, 1, 1), (lambda x, y: (x * x - y * y) / 2, -1, 1),
     (lambda x, y: -(x * x + 3 * y * y) / 2, 1, 3)],
    ids=["plane", "cap", "saddle", "ridge"],
)  # fmt: skip
def test_surfaces_over_a_plane_have_their_second_derivatives(device, height, smallest, largest):
    curvature, middle = around(device, height)
    result = [values[middle] for values in curvature]
    wanted = [(smallest + largest) / 2, smallest * largest, smallest, largest]
    np.testing.assert_allclose(result, wanted, rtol=0, atol=0.02)  # cells of 1/24: some 1/24^2 of the curvature
    assert np.isnan(curvature.mean[0])  # at the rim


def test_only_consistently_oriented_rings_have_a_curvature(device):
    vertices, triangles = icosphere(0)
    plain = TriangleMesh(vertices, triangles, device=device).compute_vertex_curvature().mean
    assert np.isfinite(plain).all()
    flipped = triangles.copy()
    flipped[0] = flipped[0, ::-1]
    doubled = np.vstack([triangles, triangles[:1]])
    opened = triangles[1:]
    for other in (flipped, doubled, opened):
        curvature = TriangleMesh(vertices, other, device=device).compute_vertex_curvature()
        wrong = np.isin(np.arange(12), triangles[0])
        for values in curvature:
            np.testing.assert_array_equal(np.isnan(values), wrong)
        np.testing.assert_array_equal(curvature.mean[~wrong], plain[~wrong])


def test_two_fans_at_a_vertex_have_no_curvature(device):
    vertices, triangles = icosphere(0)
    other = np.where(triangles == 0, 0, triangles + 11)
    touching = np.vstack([vertices, 2 * vertices[0] - vertices[1:]])
    curvature = TriangleMesh(touching, np.vstack([triangles, other[:, ::-1]]), device=device).compute_vertex_curvature()
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(curvature.gaussian)), [0])


def test_degenerate_and_non_finite_triangles_have_no_curvature(device):
    vertices, triangles = icosphere(0)
    for spoilt in ([np.nan, 0, 0], vertices[triangles[0, 1]]):  # the latter flattens two triangles
        positions = vertices.copy()
        positions[triangles[0, 0]] = spoilt
        curvature = TriangleMesh(positions, triangles, device=device).compute_vertex_curvature()
        assert np.isnan(curvature.mean[triangles[0]]).all() and np.isfinite(curvature.mean).sum() >= 4
    assert [len(values) for values in TriangleMesh(device=device).compute_vertex_curvature()] == [0] * 4
    assert np.isnan(TriangleMesh([[1, 2, 3]], device=device).compute_vertex_curvature().mean).all()


EXACT = 1e-9  # of distances of about 1: iterations end where distances change by less than 2e-10


@pytest.mark.parametrize("cells", [5, 24])
def test_distances_on_a_plane_are_straight(device, cells):
    mesh = TriangleMesh(*shaken_grid(cells), device=device)
    source = (cells + 1) ** 2 // 3
    straight = np.linalg.norm(mesh.vertices - mesh.vertices[source], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([source]), straight, rtol=0, atol=EXACT)


def test_coincident_vertices_have_zero_distance(device):
    """A strip along a line: two of its corners coincide and are joined by an edge of zero length."""
    vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0]]
    triangles = [[0, 2, 1], [2, 4, 1], [2, 3, 4], [3, 5, 4], [5, 6, 4]]
    result = TriangleMesh(vertices, triangles, device=device).compute_geodesic_distances([0])
    np.testing.assert_allclose(result, np.linalg.norm(vertices, axis=1), rtol=0, atol=EXACT)


def test_obtuse_triangles_are_handled(device):
    """A grid sheared into slivers, which fronts enter from outside."""
    positions, triangles = shaken_grid(12)
    mesh = TriangleMesh(positions @ [[1, 0, 0], [2.5, 1, 0], [0, 0, 1]], triangles, device=device)
    wanted = np.linalg.norm(mesh.vertices - mesh.vertices[40], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([40]), wanted, rtol=0, atol=EXACT)


def test_on_a_cylinder_the_error_decreases_quadratically_with_edge_length(device):
    errors = []
    for steps in (20, 40):
        angle, along = np.meshgrid(2 * np.pi * np.arange(steps) / steps, np.linspace(0, 2, steps // 2), indexing="ij")
        indices = np.arange(angle.size).reshape(angle.shape)
        after = np.roll(indices, -1, axis=0)
        a, b, c, d = indices[:, :-1].ravel(), after[:, :-1].ravel(), after[:, 1:].ravel(), indices[:, 1:].ravel()
        vertices = np.stack([np.cos(angle), np.sin(angle), along], axis=-1).reshape(-1, 3)
        mesh = TriangleMesh(vertices, np.r_[np.c_[a, b, d], np.c_[b, c, d]], device=device)
        result = mesh.compute_geodesic_distances([steps // 4])
        wanted = np.hypot(np.minimum(angle, 2 * np.pi - angle), along - along[0, steps // 4]).ravel()
        errors.append(np.abs(result - wanted).max())
    assert errors[0] < 0.015 and errors[1] < errors[0] / 3.5


def test_distances_are_to_the_nearest_source(device):
    """Where the fronts of two sources meet, the error is below half an edge; its mean falls quadratically."""
    means = []
    for cells in (20, 40):
        mesh = TriangleMesh(*shaken_grid(cells), device=device)
        chosen = [(cells + 1) * (cells // 3) + cells // 4, (cells + 1) * (2 * cells // 3) + cells // 2]
        straight = [np.linalg.norm(mesh.vertices - mesh.vertices[s], axis=1) for s in chosen]
        errors = np.abs(mesh.compute_geodesic_distances(chosen) - np.minimum(*straight))
        assert errors.max() < 0.5 / cells
        means.append(errors.mean())
    assert means[1] < means[0] / 2.5


def test_unreachable_vertices_are_infinitely_far(device):
    vertices, triangles = icosphere(1)
    count = len(vertices)
    both = np.vstack([vertices, vertices + np.array([5, 0, 0]), [[9, 9, 9]]])
    mesh = TriangleMesh(both, np.vstack([triangles, triangles + count]), device=device)
    result = mesh.compute_geodesic_distances([0])
    assert np.isfinite(result[:count]).all() and np.isinf(result[count:]).all()
    alone = mesh.compute_geodesic_distances([2 * count])
    assert alone[-1] == 0 and np.isinf(alone[:-1]).all()


def test_paths_avoid_non_finite_vertices(device):
    positions, triangles = shaken_grid(8, shake=0.0)
    positions[40] = np.nan  # the middle
    result = TriangleMesh(positions, triangles, device=device).compute_geodesic_distances([36])
    assert np.isinf(result[40]) and np.isfinite(np.delete(result, 40)).all()
    assert result[36] == 0 and result[44] > np.linalg.norm(positions[44] - positions[36]) + 0.01


@settings(deadline=None, max_examples=40)
@given(hostile_triangles, st.integers(0, 7))
def test_no_path_is_longer_than_along_edges(triangles, source):
    """Not shorter than the straight line either, among edges of many triangles and degenerate triangles."""
    with cpu_compiler("warp"):
        mesh = TriangleMesh(eight_vertices, triangles)
        result = mesh.compute_geodesic_distances([source])
        vertices = mesh.vertices
        ways = np.full((8, 8), np.inf)
        for a, b, c in triangles:
            for i, j in ((a, b), (b, c), (c, a)):
                ways[i, j] = ways[j, i] = np.linalg.norm(vertices[i] - vertices[j])
        np.fill_diagonal(ways, 0)
        for k in range(8):
            ways = np.minimum(ways, ways[:, k : k + 1] + ways[k])
        np.testing.assert_array_equal(np.isfinite(result), np.isfinite(ways[source]))
        reached = np.isfinite(result)
        assert (result[reached] <= ways[source][reached] * (1 + EXACT)).all() and (result[reached] >= 0).all()


@pytest.mark.slow
def test_distances_converge_around_slivers(monkeypatch):
    rounds, loop_while = [], geodesics.loop_while

    def counted(running, body):
        def step():
            rounds.append(None)
            assert len(rounds) < 2000, "distances still become shorter"
            body()

        loop_while(running, step)

    monkeypatch.setattr(geodesics, "loop_while", counted)
    mesh = loom.datasets.object_mesh().filter_smooth_taubin(10)
    assert np.isfinite(mesh.compute_geodesic_distances([0])).all()


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
    assert many[:50].tobytes() == few.tobytes() and not np.isin(many, others).any()


def ball(device=None, *, size=1.0, offset=(0, 0, 0)) -> TriangleMesh:
    mesh = TriangleMesh.create_sphere(1.0, resolution=40)
    return TriangleMesh(mesh.vertices * size + np.asarray(offset), mesh.triangles, device=device)


def open3d_selection(o3d, mesh, points, count):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return np.array(in_open3d(o3d, mesh).sample_points_poisson_disk(count, pcl=cloud).points, np.float32)


def test_poisson_disk_selection_of_a_cloud_matches_open3d(device, oracle):
    """From the same points: all but the few that depend on summation order or ties."""
    mesh = ball(device)
    start = mesh.sample_points_uniformly(2000, seed=3)
    theirs = oracle("meshing/sampling/kept", open3d_selection, mesh, start.points.copy(), 400)
    result = mesh.sample_points_poisson_disk(400, pcl=start).points
    assert len(result) == len(theirs) == 400 and (cKDTree(theirs).query(result)[0] < 1e-6).mean() > 0.99


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
    line = TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], device=device)
    for mesh in (TriangleMesh(device=device), TriangleMesh([[0, 0, 0]], device=device), line):
        with pytest.raises(ValueError, match=f"{method}:"):
            getattr(mesh, method)(10)


def test_more_points_than_poisson_disk_sampling_supports_are_rejected(device, monkeypatch):
    mesh = TriangleMesh(*SQUARE, device=device)
    with pytest.raises(ValueError, match="pcl:"):
        mesh.sample_points_poisson_disk(4, pcl=loom.PointCloud([*SQUARE[0][:3], [0, np.nan, 0]]))
    monkeypatch.setattr(sampling, "MAX_SAMPLES", 3)
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
    monkeypatch.setattr("pointloom.kernels.memory.MIN_CHECKED", 0)
    mesh = TriangleMesh(*SQUARE, device=device)
    assert len(mesh.sample_points_uniformly(1000)) == 1000
    with pytest.raises(MemoryError, match="number_of_points:"):
        mesh.sample_points_uniformly(1001)
