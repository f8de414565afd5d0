"""Poisson surfaces: as close to the truth as Open3D's, closed, reproducible, the effect of each argument."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels import memory
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.reconstruction import poisson as kernels_of_poisson

from . import poisson_scenes as scenes
from .poisson_scenes import assert_only_the_cube_cuts, bits, cube_around, poisson, sphere, sphere_distance, torus


def test_samples_of_a_ball_give_a_closed_ball(device):
    mesh, densities = poisson(sphere(1500), device=device)
    assert mesh.is_watertight() and len(mesh.cluster_connected_triangles()[1]) == 1
    edges, counts, twisted = scenes.edges_by_use(mesh.triangles)
    assert (counts == 2).all() and twisted == 0 and len(mesh.vertices) - len(edges) + len(mesh) == 2
    assert abs(mesh.get_volume() / (4 / 3 * np.pi) - 1) < 0.01  # outwards: the volume has a sign
    assert sphere_distance(mesh.vertices).max() < 0.02
    assert densities.shape == (len(mesh.vertices),) and densities.dtype == np.float32


def test_level_transitions_have_no_crack(device):
    points = scenes.clustered_sphere(5000)
    mesh, densities = poisson(points, depth=7, scale=1.3, device=device)
    assert np.ptp(densities) > 2.5  # local depths: cells of three levels and more
    assert assert_only_the_cube_cuts(mesh, points, 1.3) == 0 and mesh.is_watertight()


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::pointloom.NormalsWarning")
@pytest.mark.slow_on_emulated_cuda("thirty trees, on the CPU alone")
@settings(deadline=None, max_examples=30)
@given(st.integers(0, 10**6), st.integers(2, 300), st.integers(3, 7), st.sampled_from([1.0, 3.0, 8.0]))
def test_there_is_no_crack_for_any_points(seed, count, depth, power):
    rng = np.random.default_rng(seed)
    points, normals = rng.random((count, 3)) ** power, rng.normal(size=(count, 3))
    with cpu_compiler("warp"):
        mesh, densities = poisson(points, normals, depth)
        assert_only_the_cube_cuts(mesh, points)
        assert np.isfinite(mesh.vertices).all() and np.isfinite(densities).all()
        assert not mesh.edge_topology().has_split_vertex


def test_an_open_scan_ends_at_the_cube(device):
    points = sphere(3000)
    points = points[points[:, 2] > 0]
    mesh, _ = poisson(points, device=device)
    assert assert_only_the_cube_cuts(mesh, points) > 0
    _, side = cube_around(points)
    assert (mesh.vertices.max(axis=0) - mesh.vertices.min(axis=0)).max() > 0.999 * side
    near = cKDTree(points).query(mesh.vertices)[0] < 0.05
    assert np.quantile(sphere_distance(mesh.vertices[near]), 0.95) < 0.01


def test_all_sides_of_the_cube_are_equivalent(device):
    """Samples are within a cell or two of all six sides: splines beyond a side must be included on all of them."""
    points = sphere(1500)
    straight, densities = poisson(points, device=device)
    rotated, others = poisson(points * [-1, 1, -1], device=device)
    apart, nearest = cKDTree(rotated.vertices * [-1, 1, -1]).query(straight.vertices)
    assert np.quantile(apart, 0.99) < 1e-5 and np.quantile(np.abs(densities - others[nearest]), 0.99) < 1e-5


@pytest.mark.parametrize("power", [-90, 20])
def test_triangles_do_not_depend_on_the_unit_of_length(device, power):
    points = sphere(1000)
    mesh, densities = poisson(points, device=device)
    cloud = loom.PointCloud(points * 2.0**power, normals=points, origin=np.zeros(3), device=device)
    scaled, others = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
    np.testing.assert_array_equal(scaled.triangles, mesh.triangles)
    np.testing.assert_array_equal(scaled.vertices, mesh.vertices * 2.0**power)
    np.testing.assert_array_equal(others, densities)


def test_a_width_sets_the_depth_with_cells_no_wider(device):
    points = sphere(1000)
    _, side = cube_around(points)
    for width in (side / 32, side / 17):
        assert bits(poisson(points, depth=2, width=width, device=device)) == bits(poisson(points, device=device))


def test_normal_lengths_matter_only_on_request(device):
    points = sphere(1000)
    lengths = np.random.default_rng(1).uniform(0.2, 2, (1000, 1))
    assert bits(poisson(points, points * 4, device=device)) == bits(poisson(points, device=device))
    plain = poisson(points, device=device)[0].vertices
    weighed = poisson(points, points * lengths, confidence=True, device=device)[0].vertices
    apart = cKDTree(plain).query(weighed)[0]
    assert 1e-4 < np.median(apart) < 1e-2


@pytest.mark.parametrize("factor", [2.0**-80, 2.0**80])
def test_a_common_factor_of_normals_changes_nothing(device, factor):
    points = sphere(1000)
    normals = (points * np.random.default_rng(1).uniform(0.2, 2, (1000, 1))).astype(np.float32)
    plain, scaled = (poisson(points, normals * f, confidence=True, device=device) for f in (1, np.float32(factor)))
    assert bits(plain) == bits(scaled)


def test_longer_normals_attract_the_surface(device):
    """Two samples of a sheet at each position, one above the other: the longer normals win."""
    rng = np.random.default_rng(0)
    flat = np.concatenate([rng.random((2000, 2)), np.zeros((2000, 1))], axis=1)
    points = np.concatenate([flat, flat + np.array([0, 0, 0.02])])
    normals = np.tile([0, 0, 1.0], (4000, 1))
    heights = []
    for above in (0.1, 1.0, 10.0):
        lengths = np.repeat([1.0, above], 2000)[:, None]
        mesh, _ = poisson(points, normals * lengths, confidence=True, device=device)
        inner = (np.abs(mesh.vertices[:, :2] - 0.5) < 0.4).all(axis=1)
        heights.append(np.median(mesh.vertices[inner, 2]))
    assert 0 < heights[0] < 0.006 < heights[1] < 0.014 < heights[2] < 0.02


def test_point_weights_attract_the_surface(device):
    points = sphere(2000)
    meshes = [poisson(points, point_weight=weight, device=device)[0] for weight in (0, 2)]
    errors = [np.quantile(sphere_distance(mesh.vertices), 0.95) for mesh in meshes]
    assert errors[1] < errors[0] / 2 and errors[0] < 0.02


def test_linear_interpolation_is_less_exact_than_parabolic(device):
    points = sphere(8000)
    (curved, _), (straight, _) = (poisson(points, linear_fit=fit, device=device) for fit in (False, True))
    np.testing.assert_array_equal(curved.triangles, straight.triangles)
    errors = [np.median(sphere_distance(mesh.vertices)) for mesh in (curved, straight)]
    assert errors[0] < 0.65 * errors[1]


def test_more_samples_per_node_give_a_coarser_tree(device):
    points = sphere(3000)
    depths = [np.median(poisson(points, depth=6, samples_per_node=n, device=device)[1]) for n in (1.5, 6.0)]
    assert abs(depths[0] - depths[1] - 1) < 0.1  # log4 of four


def test_colors_come_from_the_nearest_points(device):
    points = sphere(1000)
    colors = np.random.default_rng(2).random((1000, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, normals=points, colors=colors, device=device)
    mesh, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
    apart, nearest = cKDTree(points).query(mesh.vertices, k=2)
    clear = apart[:, 1] - apart[:, 0] > 1e-5
    np.testing.assert_array_equal(mesh.vertex_colors[clear], colors[nearest[clear, 0]])
    assert poisson(points, device=device)[0].vertex_colors is None


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
    distance = sphere_distance if kind == "sphere" else scenes.torus_distance
    return points + noise * rng.normal(size=points.shape), noisy / np.linalg.norm(noisy, axis=1)[:, None], distance


FRACTIONS = (0.5, 0.95)
SCENES = [("sphere", 5, 0.0), ("torus", 5, 0.0), ("sphere", 5, 0.01)]


def open3d_errors(o3d, kind, depth, noise):
    points, normals, distance = samples(kind, noise, depth)
    return np.quantile(distance(open3d_poisson(o3d, points, normals, depth)[0]), FRACTIONS)


@pytest.mark.parametrize(("kind", "depth", "noise"), SCENES)
def test_the_surface_is_as_accurate_as_that_of_open3d(device, oracle, tolerances, kind, depth, noise):
    theirs = oracle(f"meshing/poisson/{kind}_{depth}_{noise}", open3d_errors, kind, depth, noise)
    points, normals, distance = samples(kind, noise, depth)
    vertices = poisson(points, normals, depth, device=device)[0].vertices
    assert (np.quantile(distance(vertices), FRACTIONS) < tolerances.poisson_error * theirs).all()


def open3d_some_vertices(o3d, kind, depth):
    """About every tenth vertex with its density and normal; the counts of all vertices and triangles."""
    points, normals, _ = samples(kind, 0.0, depth)
    positions, densities, directions, triangles = open3d_poisson(o3d, points, normals, depth)
    some = slice(None, None, max(1, len(positions) // 700))
    parts = (positions[some], densities[some], directions[some])
    return *(values.astype(np.float32) for values in parts), len(positions), len(triangles)


@pytest.mark.parametrize("kind", ["sphere", "torus"])
def test_densities_and_normals_match_open3d(device, oracle, tolerances, kind):
    theirs = oracle(f"meshing/poisson/{kind}_5", open3d_some_vertices, kind, 5)
    positions, depths, directions, vertex_count, triangle_count = theirs
    points, normals, _ = samples(kind, 0.0)
    mesh, densities = poisson(points, normals, device=device)
    nearest = cKDTree(mesh.vertices).query(positions)[1]
    assert np.median(np.abs(densities[nearest] - depths)) < tolerances.poisson_density
    assert np.quantile((mesh.vertex_normals[nearest] * directions).sum(axis=1), 0.05) > 0.95
    assert abs(len(mesh.vertices) / vertex_count - 1) < 0.02 and abs(len(mesh) / triangle_count - 1) < 0.02


def assert_sane(mesh, densities, points, scale=1.1):
    assert np.isfinite(mesh.vertices).all() and np.isfinite(densities).all() and densities.min() >= 0
    np.testing.assert_allclose(np.linalg.norm(mesh.vertex_normals, axis=1), 1, atol=1e-6)
    assert len(mesh) > 0 and mesh.triangles.min() == 0 and mesh.triangles.max() == len(mesh.vertices) - 1
    assert_only_the_cube_cuts(mesh, points, scale)


LINE, CLOSE = np.linspace(0, 1, 100)[:, None] * [1.0, 0, 0], np.concatenate([sphere(40), sphere(40) * 1e-5])
TREES = {  # points, normals, options, and a claim about the mesh and the densities
    "coarsest": (sphere(300), None, {"depth": 2}, lambda mesh, _: mesh.is_watertight() and mesh.get_volume() > 2),
    "coarse": (sphere(300), None, {"depth": 3}, lambda mesh, _: mesh.is_watertight() and mesh.get_volume() > 2),
    "deepest": (sphere(200), None, {"depth": 20}, lambda mesh, depths: depths.max() < 4 and len(mesh) < 12_000),
    "two close positions": (CLOSE, np.tile(sphere(40), (2, 1)), {"depth": 16}, lambda _, depths: depths.max() > 14),
    "a line": (LINE, np.tile([0, 0, 1.0], (100, 1)), {}, lambda *_: True),
    "a line along its normals": (LINE, np.tile([1.0, 0, 0], (100, 1)), {}, lambda *_: True),
    "a tight cube": (sphere(800), None, {"scale": 1.0}, lambda *_: True),
}


@pytest.mark.parametrize("name", TREES)
def test_trees_of_any_shape_give_a_surface(device, name):
    points, normals, options, is_right = TREES[name]
    mesh, densities = poisson(points, normals, **options, device=device)
    assert_sane(mesh, densities, points, options.get("scale", 1.1))
    assert is_right(mesh, densities)


@pytest.mark.parametrize("count", [2, 10])
def test_a_few_points_give_a_surface(device, count):
    points = sphere(count)
    assert_sane(*poisson(points, depth=6, device=device), points)


@pytest.mark.parametrize("limit", [0, 10**6], ids=["by colors", "at once"])
def test_a_level_in_one_launch_has_the_bits_of_a_launch_per_color(device, monkeypatch, limit):
    expected = bits(poisson(sphere(300), depth=4, device=device))
    for name in ("MAX_ALONE", "MAX_ALONE_ON_CPU"):
        monkeypatch.setattr(kernels_of_poisson, name, limit)
    assert bits(poisson(sphere(300), depth=4, device=device)) == expected


def test_a_flat_sheet_stays_flat_and_ends_at_the_cube(device):
    points = np.random.default_rng(0).random((2000, 3)) * [1, 1, 0]
    mesh, densities = poisson(points, np.tile([0, 0, 1.0], (2000, 1)), device=device)
    assert_sane(mesh, densities, points)
    inner = (np.abs(mesh.vertices[:, :2] - 0.5) < 0.49).all(axis=1)
    assert inner.sum() > 500 and np.abs(mesh.vertices[inner, 2]).max() < 0.003
    assert (mesh.vertex_normals[inner, 2] > 0.99).all()


@pytest.mark.parametrize("allowed", [0, 2_000_000])
def test_a_too_large_tree_is_rejected_with_its_size(device, monkeypatch, allowed):
    """The samples first, then levels from about the seventh on; nothing of the rejected level is allocated."""
    points, requests = sphere(2000), []
    poisson(points, device=device)
    room = memory.check_room

    def check(target_device, size, what):
        requests.append((size, what))
        room(target_device, size, what)

    for module in ("poisson", "octree_levels"):
        monkeypatch.setattr(f"pointloom.kernels.reconstruction.{module}.check_room", check)
    monkeypatch.setattr(memory, "free_bytes", lambda target_device: allowed)
    monkeypatch.setattr(memory, "MIN_CHECKED", 0)
    with pytest.raises(MemoryError, match=r"would take about .* GB, and .* has .* GB free; take a smaller depth"):
        poisson(points, depth=8, device=device)
    *fitting, (size, what) = requests
    assert size > allowed >= max([needed for needed, _ in fitting], default=0)
    assert what.startswith("the cells of 2,000 points" if allowed < 180_000 else "level ")


def box(low, high, device="cpu"):
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
    free, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 6, scale=1.5)
    bounded, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 6, scale=1.5, envelope=envelope)
    cell = 1.5 * 2 / 2**5
    lowest = (free.vertices - offset)[:, 2].min(), (bounded.vertices - offset)[:, 2].min()
    assert lowest[0] < -0.4 and -0.1 - cell < lowest[1]
    assert bounded.is_watertight() and not free.is_watertight()


def test_an_inverted_envelope_gives_the_same_result(device):
    cloud = half_sphere(device)
    envelope = box([-1.15, -1.15, -0.1], [1.15, 1.15, 1.15], device)
    flipped = loom.TriangleMesh(envelope.vertices, envelope.triangles[:, ::-1], device=device)
    meshes = [loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5, envelope=e)[0] for e in (envelope, flipped)]
    assert np.array_equal(meshes[0].vertices, meshes[1].vertices)


def test_opposite_normals_cause_a_warning(device):
    points = sphere(1000)
    signs = np.where(np.random.default_rng(0).random(1000) < 0.5, 1.0, -1.0)[:, None]
    cloud = loom.PointCloud(points, normals=points * signs, device=device)
    with pytest.warns(loom.NormalsWarning, match="orient_normals_consistent_tangent_plane") as caught:
        loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 4)
    assert caught[0].filename == __file__, "it points at the user's line"
    alike = cloud.orient_normals_consistent_tangent_plane(12)
    loom.TriangleMesh.create_from_point_cloud_poisson(alike, 4)  # no warning
