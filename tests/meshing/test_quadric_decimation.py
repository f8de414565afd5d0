"""Decimation, vertex clustering and remeshing: as accurate as Open3D, scale-invariant, mesh properties stay."""

import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.remeshing import edge_bins
from pointloom.meshing.mesh.measures import signed_volume

from .open3d_meshes import for_each, one_by_one
from .simplification_scenes import box, bumpy_torus, edge_counts, euler, grid, open3d_simplified, rms_from


def sampled(mesh: TriangleMesh) -> np.ndarray:
    return mesh.sample_points_uniformly(5000, seed=1).points


@pytest.mark.parametrize("target", [1919, 501, 40])
def test_the_target_is_reached_or_exceeded_by_one_and_the_surface_stays_closed(device, target):
    mesh = TriangleMesh(*bumpy_torus(), device=device)
    thin = mesh.simplify_quadric_decimation(target)
    assert target - 1 <= len(thin) <= target and set(edge_counts(thin.triangles).values()) == {2}
    assert euler(thin) == 0 and len(np.unique(thin.triangles)) == len(thin.vertices)


def test_edges_selected_in_one_launch_are_those_of_a_launch_per_step(device, monkeypatch):
    mesh, results = TriangleMesh(*bumpy_torus(), device=device), []
    for limit in (0, 10**6):
        monkeypatch.setattr(edge_bins, "MAX_AT_ONCE", limit)
        thin = mesh.simplify_quadric_decimation(150)
        results.append((thin.vertices.tobytes(), thin.triangles.tobytes()))
    assert results[0] == results[1]


@pytest.mark.parametrize("target", [1000, 300])
def test_accuracy_is_that_of_open3d(oracle, target):
    """Within 1.1 times Open3D's distance in both directions, in the unit that suits Open3D best."""
    mesh = TriangleMesh(*bumpy_torus(70, 40))
    thin, name = mesh.simplify_quadric_decimation(target), "simplify_quadric_decimation"
    peer = TriangleMesh(*oracle(f"meshing/decimation/torus_{target}", open3d_simplified, mesh, 100.0, name, target))
    assert rms_from(thin, sampled(mesh)) <= 1.1 * rms_from(peer, sampled(mesh))
    assert rms_from(mesh, sampled(thin)) <= 1.1 * rms_from(mesh, sampled(peer))


def test_a_cube_is_reduced_to_twelve_triangles_and_keeps_its_corners(device):
    thin = TriangleMesh(*box(8), device=device).simplify_quadric_decimation(12)
    assert len(thin) == 12
    corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, -1).T
    gaps = np.linalg.norm(thin.vertices[:, None] - corners, axis=2)
    # 1e-5: the middle of an edge has 1e-8 of the weight of all accumulated planes
    assert gaps.min(axis=0).max() < 1e-5 and gaps.min(axis=1).max() < 1e-5
    assert thin.get_volume() == pytest.approx(1, abs=1e-4)


def test_the_boundary_of_a_hole_is_preserved(device):
    """A square with a round hole: two boundaries before and after, and the hole keeps its position."""
    vertices, triangles = grid(24)
    center = np.array([11.5, 11.5, 0])
    inside = np.linalg.norm(vertices - center, axis=1) < 5
    mesh = TriangleMesh(vertices, triangles[~inside[triangles].any(axis=1)], device=device)
    mesh = mesh.remove_unreferenced_vertices()
    thin = mesh.simplify_quadric_decimation(60)
    assert euler(thin) == euler(mesh) == 0 and set(edge_counts(thin.triangles).values()) == {1, 2}
    assert thin.get_surface_area() == pytest.approx(mesh.get_surface_area(), rel=0.02)
    border = np.unique([edge for edge, count in edge_counts(thin.triangles).items() if count == 1])
    spans = np.ptp(thin.vertices[border], axis=0)
    np.testing.assert_allclose(spans, [23, 23, 0], atol=0.05)


def test_border_planes_of_zero_weight_release_the_boundary():
    """Round boundaries shrink without boundary planes."""
    vertices, triangles = grid(24)
    far = np.linalg.norm(vertices - [11.5, 11.5, 0], axis=1) > 11
    mesh = TriangleMesh(vertices, triangles[~far[triangles].any(axis=1)]).remove_unreferenced_vertices()
    areas = [mesh.simplify_quadric_decimation(30, boundary_weight=w).get_surface_area() for w in (0.0, 1.0)]
    area = mesh.get_surface_area()
    assert abs(areas[1] - area) < abs(areas[0] - area)


@pytest.mark.parametrize("height", [0.0, 0.5])
def test_no_triangle_flips(device, height):
    x, y = (grid(30)[0][:, :2] + np.random.default_rng(0).uniform(-0.3, 0.3, (900, 2))).T
    hills = np.c_[x, y, height * np.sin(0.9 * x) * np.cos(0.7 * y)]
    thin = TriangleMesh(hills, grid(30)[1], device=device).simplify_quadric_decimation(200)
    a, b, c = (thin.vertices[thin.triangles[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()


@pytest.mark.parametrize(
    ("surface", "target", "vertices", "number"),
    [(box(3), 2, {4}, 2), (box(3), 0, {4}, 2), (bumpy_torus(8, 5), 0, {7, 8, 9, 10}, 0)],
)
def test_a_closed_component_remains_and_is_reported(device, surface, target, vertices, number):
    """Four vertices of a ball; for a torus one of the 21 irreducible triangulations (Lavrenchenko 1990)."""
    with pytest.warns(UserWarning, match=rf"\d+ triangles remain instead of {target}"):
        thin = TriangleMesh(*surface, device=device).simplify_quadric_decimation(target)
    assert len(thin.vertices) in vertices and euler(thin) == number
    assert set(edge_counts(thin.triangles).values()) == {2}


def test_isolated_triangles_are_removed_last_and_small_ones_first(device):
    """Open3D remains above its target where no collapse is possible; pointloom reaches the target."""
    corners = np.tile([[0, 0, 0], [1, 0, 0], [0, 1, 0]], (6, 1, 1)) * np.arange(1.0, 7)[::-1, None, None]
    corners[..., 2] = np.arange(6)[:, None]
    triangles = np.arange(18).reshape(6, 3)
    triangles[3, 0] = triangles[2, 0]  # two share a vertex, but no edge
    mesh = TriangleMesh(corners.reshape(-1, 3), triangles, device=device)
    thin = mesh.simplify_quadric_decimation(2)
    np.testing.assert_array_equal(thin.vertices, corners[:2].reshape(-1, 3))


@pytest.mark.parametrize("target", [800, 801, 2**31 - 1])
def test_a_reached_target_leaves_the_mesh_unchanged(device, target):
    mesh = TriangleMesh(*grid(21), device=device)
    same = mesh.simplify_quadric_decimation(target)
    assert same.arrays["triangles"].ptr == mesh.arrays["triangles"].ptr
    assert len(TriangleMesh(device=device).simplify_quadric_decimation(0)) == 0


def test_duplicate_triangles_are_removed_first(device):
    vertices, triangles = grid(12)
    rolled = np.roll(triangles, 1, axis=1)
    mesh = TriangleMesh(vertices, np.r_[triangles, rolled, [[3, 3, 4]]], device=device)
    thin = mesh.simplify_quadric_decimation(len(triangles))
    np.testing.assert_array_equal(thin.triangles, triangles)


def test_triangles_without_area_collapse(device):
    vertices, triangles = grid(12)
    for flat in (vertices * [1, 0, 1], vertices * 0):
        thin = TriangleMesh(flat, triangles, device=device).simplify_quadric_decimation(50)
        assert len(thin) in (49, 50) and np.isfinite(thin.vertices).all()


def test_non_manifold_edges_stay_and_get_no_more_triangles(device):
    vertices, triangles = grid(12)
    sheets = [vertices @ np.array([[c, s, 0], [0, 0, 1], [s, -c, 0]]) for c, s in ((1, 0), (-0.5, 0.8), (-0.5, -0.8))]
    merged, numbers = np.unique(np.concatenate(sheets), axis=0, return_inverse=True)
    every = numbers.reshape(-1)[np.concatenate([triangles + k * len(vertices) for k in range(3)])]
    mesh = TriangleMesh(merged, every, device=device)
    thin = mesh.simplify_quadric_decimation(60)
    assert len(thin) in (58, 59, 60)  # an edge of the line goes with three
    crowded = [edge for edge, count in edge_counts(thin.triangles).items() if count > 2]
    assert set(edge_counts(thin.triangles).values()) == {1, 2, 3} and euler(thin) == euler(mesh)
    np.testing.assert_allclose(thin.vertices[np.unique(crowded)][:, [0, 1]], 0, atol=1e-5)  # the line is kept


def test_the_maximum_error_is_respected(device):
    """Flat parts are collapsed without error; curved parts stay, without a warning."""
    x, y = grid(20)[0][:, :2].T
    bent = np.c_[x, y, np.maximum(x - 9, 0) ** 2 / 8]
    mesh = TriangleMesh(bent, grid(20)[1], device=device)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exact, near = (mesh.simplify_quadric_decimation(2, maximum_error=e) for e in (1e-10, 1.0))
    assert 2 < len(near) < len(exact) < len(mesh) and rms_from(exact, mesh.vertices) < 1e-4
    scaled = TriangleMesh(1024 * bent, grid(20)[1], device=device)  # an error is an area times a squared distance
    assert len(scaled.simplify_quadric_decimation(2, maximum_error=1024**4)) == len(near)


def test_normals_and_colors_match_their_position(device):
    """Colors that are linear on a flat square remain linear."""
    vertices, triangles = grid(16)
    colors = np.c_[vertices[:, 0], vertices[:, 1], 15 - vertices[:, 0]] / 15
    normals = np.tile([0.0, 0, 1], (256, 1))
    mesh = TriangleMesh(vertices, triangles, vertex_colors=colors, vertex_normals=normals, device=device)
    thin = mesh.simplify_quadric_decimation(40)
    where = thin.vertices
    wanted = np.c_[where[:, 0], where[:, 1], 15 - where[:, 0]] / 15
    # vertices leave the square by some 1e-5, but colors do not
    np.testing.assert_allclose(thin.vertex_colors, wanted, atol=1e-4)
    np.testing.assert_array_equal(thin.vertex_normals, np.tile([0, 0, 1], (len(where), 1)))


@pytest.mark.parametrize(("chart_count", "material_count"), [(2, 1), (1, 2)])
def test_texture_is_preserved(device, chart_count, material_count):
    """A bent sheet with a seam between two charts, or with another material on the far side."""
    vertices, triangles = grid(21)
    bent = np.c_[vertices[:, :2], 2 * np.sin(vertices[:, 1] / 4)]
    right = vertices[triangles][:, :, 0].mean(axis=1) > 10
    corners = vertices[triangles][..., :2] / 40
    if chart_count == 2:
        corners[right, :, 0] = 0.95 - corners[right, :, 0]  # mirrored, far from the other chart
    texture = {"triangle_uvs": corners.reshape(-1, 2), "triangle_material_ids": right * (material_count - 1)}
    images = [np.zeros((2, 2, 3), np.uint8)] * material_count
    mesh = TriangleMesh(bent, triangles, textures=images, device=device, **texture)
    thin = mesh.simplify_quadric_decimation(80)
    assert len(thin) in (79, 80) and len(thin.textures) == material_count
    uvs, where = thin.triangle_uvs.reshape(-1, 3, 2).astype(float), thin.vertices[thin.triangles]
    sides = where[..., 0].mean(axis=1) > 10
    assert (where[~sides][..., 0] < 10.001).all() and (where[sides][..., 0] > 9.999).all()
    np.testing.assert_array_equal(thin.triangle_material_ids, sides * (material_count - 1))
    if chart_count == 2:
        uvs[sides, :, 0] = 0.95 - uvs[sides, :, 0]
    # The sheet is bent along y alone, so x is exact; y up to the chord error of a triangle.
    np.testing.assert_allclose(uvs[..., 0] * 40, where[..., 0], atol=1e-3)
    np.testing.assert_allclose(uvs[..., 1] * 40, where[..., 1], atol=0.1)


def test_seams_are_simplified_before_the_target_is_missed(device):
    """Each triangle has a chart of its own, so every edge is a seam."""
    vertices, triangles = grid(8)
    uvs = np.random.default_rng(0).random((3 * len(triangles), 2))
    thin = TriangleMesh(vertices, triangles, triangle_uvs=uvs, device=device).simplify_quadric_decimation(10)
    assert len(thin) in (9, 10) and thin.triangle_uvs is not None
    assert (thin.triangle_uvs >= 0).all() and (thin.triangle_uvs <= 1).all()


@settings(deadline=None, max_examples=20)
@given(st.lists(st.tuples(*[st.integers(0, 9)] * 3), min_size=1, max_size=30), st.integers(0, 30))
def test_no_edge_gets_more_triangles_for_any_mesh(triangles, target):
    vertices = np.random.default_rng(0).normal(size=(10, 3))
    with cpu_compiler("warp"), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        mesh = TriangleMesh(vertices, triangles)
        thin = mesh.simplify_quadric_decimation(target)
    assert len(thin) <= len(mesh)
    if target >= len(mesh):
        return
    assert max(edge_counts(thin.triangles).values(), default=0) <= max(edge_counts(mesh.triangles).values())
    assert len(np.unique(thin.triangles)) == len(thin.vertices)
    t = thin.triangles
    assert ((t[:, 0] != t[:, 1]) & (t[:, 1] != t[:, 2]) & (t[:, 2] != t[:, 0])).all()


METHOD = "simplify_vertex_clustering"


def assert_it_is_open3ds(mesh: TriangleMesh, voxel_size: float, vertices, triangles) -> None:
    """The same vertices in the same order, and the same triangles in any order."""
    thin = mesh.simplify_vertex_clustering(voxel_size)
    np.testing.assert_allclose(thin.vertices, vertices, rtol=1e-6, atol=1e-6)  # float32 of its float64
    assert len(thin) == len(triangles)
    assert set(map(tuple, thin.triangles.tolist())) == set(map(tuple, triangles.tolist()))


def open3d_clusters(o3d, mesh, voxel_size):
    """Triangles in a fixed order: Open3D's order differs between runs."""
    vertices, triangles = open3d_simplified(o3d, mesh, 1.0, METHOD, voxel_size, "Average")
    return vertices, triangles[np.lexsort(triangles.T)]


def test_results_match_open3d_for_any_triangles(device, oracle):
    scenes = []
    for seed in range(30):
        rng = np.random.default_rng(seed)
        mesh = TriangleMesh(rng.random((12, 3)).astype(np.float32), rng.integers(0, 12, (rng.integers(0, 40), 3)))
        scenes.append((mesh, float(rng.choice([0.2, 0.5, 0.9]))))
    answers = oracle("meshing/clustering/soups", for_each, open3d_clusters, scenes)
    for (mesh, voxel_size), wanted in zip(scenes, one_by_one(answers), strict=True):
        assert_it_is_open3ds(mesh.to(device), voxel_size, *wanted)


def test_triangles_keep_the_order_of_first_appearance(device):
    """Each vertex is a separate voxel; the fourth triangle is a rotated copy of the first, the fifth its reverse."""
    corners = np.eye(3)[[0, 1, 2, 0, 1]] * np.array([1, 1, 1, 2, 2])[:, None]
    triangles = [[2, 0, 1], [4, 3, 2], [1, 0, 3], [0, 1, 2], [1, 0, 2], [3, 3, 1]]
    thin = TriangleMesh(corners, triangles, device=device).simplify_vertex_clustering(0.1)
    assert thin.triangles.tolist() == [[0, 1, 2], [2, 4, 3], [0, 3, 1], [0, 2, 1]]
    np.testing.assert_array_equal(thin.vertices, corners)


def test_quadrics_are_at_least_as_accurate_as_those_of_open3d(device, oracle):
    """In a unit where Open3D's threshold has no effect; otherwise its error is 1.7 times as large."""
    mesh = TriangleMesh(*bumpy_torus(60, 36), device=device)
    points = mesh.sample_points_uniformly(5000, seed=1).points
    quadric, mean = (mesh.simplify_vertex_clustering(0.2, way) for way in ("quadric", "average"))
    peer = oracle("meshing/clustering/quadric", open3d_simplified, mesh, 1000.0, METHOD, 200.0, "Quadric")
    np.testing.assert_array_equal(quadric.triangles, mean.triangles)
    assert rms_from(quadric, points) <= 1.02 * rms_from(TriangleMesh(*peer), points)
    assert rms_from(quadric, points) < 0.7 * rms_from(mean, points)


def test_open3ds_kinds_are_accepted(o3d):
    mesh = TriangleMesh(*bumpy_torus())
    for name in ("Average", "Quadric"):
        kind = getattr(o3d.geometry.SimplificationContraction, name)
        result = mesh.simplify_vertex_clustering(0.3, name.lower())
        np.testing.assert_array_equal(mesh.simplify_vertex_clustering(0.3, kind).vertices, result.vertices)


def test_normals_and_colors_are_means(device):
    corners = [[0, 0, 0], [0.1, 0, 0], [2, 0, 0], [0, 2, 0]]
    normals = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 2], [np.nan, 0, 0]])
    colors = np.array([[1, 0, 0], [0, 0.5, 0], [0, 0, 1], [1, 1, 1]])
    mesh = TriangleMesh(
        corners, [[0, 2, 3], [1, 2, 3]], vertex_normals=normals, vertex_colors=colors,
        triangle_uvs=np.zeros((6, 2)), triangle_material_ids=[0, 1], textures=[np.zeros((1, 1, 3), np.uint8)] * 2,
        device=device,
    )  # fmt: skip
    thin = mesh.simplify_vertex_clustering(1)
    assert thin.triangles.tolist() == [[0, 1, 2]]
    np.testing.assert_array_equal(thin.vertex_colors, [[0.5, 0.25, 0], [0, 0, 1], [1, 1, 1]])
    assert thin.vertex_normals is not None
    np.testing.assert_allclose(thin.vertex_normals[:2], [[0.5**0.5, 0.5**0.5, 0], [0, 0, 1]], rtol=1e-7)
    assert np.isnan(thin.vertex_normals[2]).all()
    assert (thin.triangle_uvs, thin.triangle_material_ids, thin.textures) == (None, None, ())


@pytest.mark.parametrize("way", ["average", "quadric"])
def test_meshes_with_at_most_one_triangle(device, way):
    assert len(TriangleMesh(device=device).simplify_vertex_clustering(1, way)) == 0
    one = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 2, 0]], device=device)
    assert one.simplify_vertex_clustering(0.1, way).triangles.tolist() == [[0, 1, 2]]
    assert len(one.simplify_vertex_clustering(10, way)) == 0
    alone = TriangleMesh([[1, 2, 3]], device=device).simplify_vertex_clustering(0.1, way)
    np.testing.assert_array_equal(alone.vertices, [[1, 2, 3]])


FAR = np.array([5.0e5, 5.4e6, 100.0])


def edge_lengths(mesh: TriangleMesh):
    sides = np.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    ends = mesh.vertices[np.unique(sides, axis=0)]
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)


def smallest_angles(mesh: TriangleMesh):
    corners = mesh.vertices[mesh.triangles]
    to, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    cosines = (to * back).sum(axis=2) / np.linalg.norm(to, axis=2) / np.linalg.norm(back, axis=2)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1))).min(axis=1)


def wavy_sheet(device=None) -> TriangleMesh:
    """A bent open sheet with triangles of very different sizes."""
    x, y = np.meshgrid(np.linspace(0, 1, 25) ** 2, np.linspace(0, 1, 9))
    corners = np.c_[x.ravel(), y.ravel(), 0.1 * np.sin(4 * x.ravel())]
    first = (np.arange(8)[:, None] * 25 + np.arange(24)).ravel()
    lower, upper = np.c_[first, first + 1, first + 25], np.c_[first + 1, first + 26, first + 25]
    return TriangleMesh(corners, np.r_[lower, upper], device=device)


@pytest.mark.parametrize(("shape", "length"), [("sphere", 0.15), ("torus", 0.12)])
def test_triangles_become_uniform_and_stay_on_the_surface(shape, length):
    mesh = getattr(TriangleMesh, f"create_{shape}")()
    made = mesh.remesh_isotropic(length, 5)
    lengths = edge_lengths(made) / length
    assert ((lengths > 0.8) & (lengths < 4 / 3)).mean() > 0.98 and np.median(smallest_angles(made)) > 50
    assert smallest_angles(made).min() > 25
    assert made.is_watertight() and made.euler_poincare_characteristic() == mesh.euler_poincare_characteristic()
    assert made.get_volume() == pytest.approx(mesh.get_volume(), rel=0.01) and signed_volume(made) > 0
    # Edges between the faces of the round shape are cut where they have no vertex.
    metrics = made.compute_metrics(mesh, n_sampled_points=500)
    assert max(metrics.max) < 0.15 * length and not made.is_self_intersecting()


CYLINDER = TriangleMesh.create_cylinder(1.0, 2.0, 60, 40)
LATTICE = TriangleMesh.create_plane().subdivide_midpoint(5)


@pytest.mark.slow_on_emulated_cuda("sixteen remeshings; the next test runs the same kernels")
@pytest.mark.parametrize("times", [0.7, 1.5, 3, 5])
@pytest.mark.parametrize(
    "mesh",
    [
        TriangleMesh.create_sphere(1.0, 30),
        TriangleMesh.create_torus(1.0, 0.6),
        LATTICE,
        TriangleMesh.create_cylinder(1.0, 2.0, 60, 40),
    ],
    ids=["sphere", "torus", "lattice", "cylinder"],
)
def test_edges_have_the_target_length_from_any_length(mesh, times, device):
    target = times * float(np.median(edge_lengths(mesh)))
    made = mesh.to(device).remesh_isotropic(target)
    lengths = edge_lengths(made) / target
    assert ((lengths > 0.8) & (lengths < 4 / 3)).mean() > 0.8 and 0.8 < np.median(lengths) < 4 / 3
    assert made.euler_poincare_characteristic() == mesh.euler_poincare_characteristic()
    assert made.is_watertight() == mesh.is_watertight()


@pytest.mark.parametrize(
    ("mesh", "length", "iterations", "remedy"),
    [(TriangleMesh.create_box(), 5.0, 10, "a smaller edge_length"), (LATTICE, 0.7, 3, "a smaller edge_length")],
)
def test_a_length_that_is_not_reached_gives_a_warning(mesh, length, iterations, remedy, device):
    with pytest.warns(UserWarning, match=f"edge_length: expected most edges .* shorter and .* longer. Pass {remedy}"):
        assert len(mesh.to(device).remesh_isotropic(length, iterations))


@pytest.mark.parametrize("is_far", [False, True])
def test_corners_and_edges_of_a_box_are_preserved(device, is_far):
    box = TriangleMesh.create_box(1, 0.5, 0.25, device=device)
    box = box.translate(FAR) if is_far else box
    made = box.remesh_isotropic(0.12, 3)
    assert made.is_watertight() and made.get_volume() == pytest.approx(0.125, rel=1e-5)
    assert made.get_surface_area() == pytest.approx(1.75, rel=1e-5)
    for corner in box.vertices:
        assert np.abs(made.vertices - corner).sum(axis=1).min() == 0


def test_edges_between_a_crease_and_a_corner_collapse_onto_the_corner_in_any_order(device):
    box = TriangleMesh.create_box(1, 0.5, 0.25).subdivide_midpoint(2)
    last = len(box.vertices) - 1
    mesh = TriangleMesh(box.vertices[::-1].copy(), last - box.triangles).to(device)
    made = mesh.remesh_isotropic(0.2, 3)
    assert made.is_watertight() and made.get_volume() == pytest.approx(0.125, rel=1e-5)
    assert made.get_surface_area() == pytest.approx(1.75, rel=1e-5) and len(made.triangles) < len(box.triangles)


@pytest.mark.parametrize(("fold", "angle", "stays"), [(20, 30, False), (20, 10, True), (40, 50, False), (40, 30, True)])
def test_folds_above_the_feature_angle_stay(device, fold, angle, stays):
    """A sheet of two squares: triangles across the fold have less area than the sheet."""
    slope = np.tan(np.radians(fold / 2))
    corners = [[x, y, -slope * abs(x)] for x in (-1, 0, 1) for y in (0, 1)]
    sheet = TriangleMesh(corners, [[0, 2, 1], [1, 2, 3], [2, 4, 3], [3, 4, 5]], device=device)
    made = sheet.remesh_isotropic(0.23, feature_angle=angle)
    lost = 1 - made.get_surface_area() / sheet.get_surface_area()
    assert abs(lost) < 1e-6 if stays else lost > 5e-4


def test_boundaries_are_preserved(device):
    sheet = wavy_sheet(device)
    made = sheet.remesh_isotropic(0.08, 4)
    assert made.euler_poincare_characteristic() == 1 and made.is_edge_manifold()
    low, high = made.get_axis_aligned_bounding_box()
    np.testing.assert_allclose([low[:2], high[:2]], [[0, 0], [1, 1]], atol=1e-6)
    [border] = made.get_boundaries()
    off = np.abs(made.vertices[border][:, :2] - 0.5).max(axis=1)
    np.testing.assert_allclose(off, 0.5, atol=1e-6)
    normals = made.compute_triangle_normals()
    assert (normals[:, 2] > 0.5).all()  # no flipped triangles


def test_attributes_are_interpolated(device):
    sheet = wavy_sheet(device).compute_vertex_normals()
    sheet.vertex_colors = np.clip(sheet.vertices, 0, 1)
    sheet.vertex_attributes["place"] = sheet.vertices
    sheet.triangle_attributes["row"] = np.arange(len(sheet))
    made = sheet.remesh_isotropic(0.08, 2)
    np.testing.assert_allclose(made.vertex_attributes["place"], made.vertices, atol=1e-5)
    np.testing.assert_allclose(made.vertex_colors[:, :2], made.vertices[:, :2], atol=1e-5)
    np.testing.assert_allclose(np.linalg.norm(made.vertex_normals, axis=1), 1, atol=1e-6)
    middles = sheet.vertices[sheet.triangles[made.triangle_attributes["row"]]].mean(axis=1)
    assert np.linalg.norm(middles - made.vertices[made.triangles].mean(axis=1), axis=1).max() < 0.15


BALL = TriangleMesh.create_sphere(1.0, 6)
ODD = {
    "nothing": ([], []),
    "one triangle": (np.eye(3), [[0, 1, 2]]),
    "a triangle without area": ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]),
    "a triangle with a vertex twice": (np.eye(3), [[0, 1, 1]]),
    "a corner that is not finite": ([[0, 0, 0], [1, 0, 0], [0, np.nan, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 3]]),
    "three at an edge": ([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]], [[0, 1, 2], [0, 1, 3], [1, 0, 4]]),
    "two sides": (BALL.vertices, np.r_[BALL.triangles, BALL.triangles[:, ::-1]]),
    "turned all ways": (BALL.vertices, np.r_[BALL.triangles[::2], BALL.triangles[1::2, ::-1]]),
    "two that touch": ([*np.eye(3), [0, 0, 0], [1, -1, 0]], [[0, 1, 2], [0, 3, 4]]),
}


@pytest.mark.filterwarnings("ignore:edge_length. expected most edges")  # creases of some are shorter than the target
@pytest.mark.parametrize("name", ODD)
def test_degenerate_meshes_keep_their_surface(name):
    mesh = TriangleMesh(*ODD[name])
    made = mesh.remesh_isotropic(0.2, 3)
    assert np.isfinite(made.vertices[made.triangles]).all()
    finite = mesh.remove_triangles_by_mask(~np.isfinite(mesh.vertices[mesh.triangles]).all(axis=(1, 2)))
    assert made.get_surface_area() == pytest.approx(finite.get_surface_area(), rel=0.03)
    edges, holes = (len(m.get_boundary_edges()) for m in (mesh, made))
    assert (edges == 0) == (holes == 0) or not len(made)
