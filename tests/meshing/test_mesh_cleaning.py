"""Mesh cleaning: Open3D's results with its errors corrected, independent of execution order."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import AxisAlignedBoundingBox, OrientedBoundingBox, SelectionPolygonVolume, TriangleMesh

from .mesh_soups import FAR, SOUPS, ball, fixed_soups, soup
from .open3d_meshes import arrays_of, assert_meshes_are_open3ds, in_open3d, open3d_arrays
from .simplification_scenes import edge_counts
from .test_mesh_texture import corner_table, textured

HYPOTHESIS = settings(deadline=None, max_examples=25)


def canonical_rotation(t: list[int]) -> tuple[int, ...]:
    return min(tuple(t[k:] + t[:k]) for k in range(3))


@pytest.mark.parametrize(
    ("method", "good"), [("remove_degenerate_triangles", False), ("remove_duplicated_triangles", True)]
)
def test_remaining_triangles_match_open3d(oracle, method, good):
    scenes = [(mesh, method) for mesh in fixed_soups(good=good)]
    assert_meshes_are_open3ds(oracle, f"meshing/cleaning/{method}", scenes)


def test_triangles_without_area_are_removed_on_request(device):
    corners = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [np.nan, 0, 0]]
    mesh = TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [1, 1, 3], [0, 1, 4]], device=device)
    assert mesh.remove_degenerate_triangles().triangles.tolist() == [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
    assert mesh.remove_degenerate_triangles(zero_area=True).triangles.tolist() == [[0, 1, 3], [0, 1, 4]]


@HYPOTHESIS
@given(SOUPS)
def test_duplicates_up_to_rotation_keep_the_first(triangles):
    seen, expected = set(), []
    for t in map(list, triangles):
        if canonical_rotation(t) not in seen:
            expected.append(t)
        seen.add(canonical_rotation(t))
    assert soup(triangles).remove_duplicated_triangles().triangles.tolist() == expected


def greedy_manifold(mesh: TriangleMesh) -> list[list[int]]:
    """Process the smallest triangles first, one at a time."""
    triangles = mesh.triangles
    counts = edge_counts(triangles)

    def edges(t):
        return [(min(a, b), max(a, b)) for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))]

    folded = [len(set(t)) < 3 and any(counts[e] > 2 for e in edges(t)) for t in triangles.tolist()]
    triangles = triangles[~np.array(folded, bool)]
    counts, remaining = edge_counts(triangles), np.ones(len(triangles), bool)
    areas = TriangleMesh(mesh.vertices, triangles).compute_triangle_areas().astype(np.float32)
    for row in np.argsort(areas, kind="stable"):
        if any(counts[e] > 2 for e in edges(triangles[row].tolist())):
            remaining[row] = False
            for e in edges(triangles[row].tolist()):
                counts[e] -= 1
    return triangles[remaining].tolist()


@HYPOTHESIS
@given(SOUPS)
def test_non_manifold_edges_lose_their_smallest_triangles_first(triangles):
    mesh = soup(triangles)
    left = mesh.remove_non_manifold_edges()
    assert left.is_edge_manifold()
    assert left.triangles.tolist() == greedy_manifold(mesh)


def test_non_manifold_edges_lose_the_triangles_that_open3d_drops(device, oracle):
    rng = np.random.default_rng(3)
    edges = [[0, 0, 0], [0, 0, 1]], [[9, 0, 0], [9, 0, 1]]
    pages = np.vstack([edges[0], rng.normal(size=(40, 3)), edges[1], rng.normal(size=(9, 3))])
    triangles = [[0, 1, k] for k in range(2, 42)] + [[42, 43, k] for k in range(44, 53)]
    mesh = TriangleMesh(pages, triangles, device=device)
    left = mesh.remove_non_manifold_edges()
    _, wanted = oracle("meshing/cleaning/crowded_edges", open3d_arrays, mesh, "remove_non_manifold_edges")
    assert left.triangles.tolist() == wanted.tolist() and len(left) == 4


def test_duplicated_vertices_match_open3d(device, oracle):
    rng = np.random.default_rng(0)
    colors = rng.random((12, 3)).astype(np.float32)
    corners, triangles = rng.integers(0, 2, (12, 3)), rng.integers(0, 12, (20, 3))
    mesh = TriangleMesh(corners, triangles, vertex_colors=colors, vertex_normals=-colors, device=device)
    names = ("vertices", "triangles", "vertex_colors", "vertex_normals")
    method = "remove_duplicated_vertices"
    wanted = oracle("meshing/cleaning/duplicated_vertices", open3d_arrays, mesh, method, names=names)
    merged = mesh.remove_duplicated_vertices()
    for name, values in zip(names, wanted, strict=True):
        np.testing.assert_array_equal(getattr(merged, name), values)
    assert len(merged.vertices) < 9


def test_nan_vertices_are_distinct_and_minus_zero_equals_zero(device):
    corners = [[0, 0, 0], [np.nan, 0, 0], [np.nan, 0, 0], [-0.0, 0, 0]]
    mesh = TriangleMesh(corners, [[0, 1, 2], [3, 2, 1]], device=device).remove_duplicated_vertices()
    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 1]]


def greedy_groups(points: np.ndarray, eps: float) -> np.ndarray:
    """The vertex that each vertex is merged into, sequentially as in Open3D."""
    owners = np.full(len(points), -1)
    for v in range(len(points)):
        if owners[v] < 0:
            sqdist = ((points - points[v]) ** 2).sum(axis=1)
            owners[(owners < 0) & (sqdist < eps * eps)] = v
            owners[v] = v
    return owners


@HYPOTHESIS
@given(
    st.lists(st.tuples(*[st.integers(0, 4)] * 3), min_size=1, max_size=40),
    st.sampled_from([0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 100.0]),
    st.sampled_from([1e-6, 1.0, 1e6]),
)
def test_close_vertices_merge_into_the_first_remaining_one(positions, eps, scale):
    points = np.float32(np.array(positions, float) * scale).astype(float)
    distance = eps * float(np.float32(scale))
    mesh = TriangleMesh(points, np.arange(len(points))[:, None].repeat(3, 1), origin=[0, 0, 0])
    owners = greedy_groups(points, distance)
    _, numbers = np.unique(owners, return_inverse=True)
    np.testing.assert_array_equal(mesh.merge_close_vertices(distance).triangles[:, 0], numbers)


@pytest.mark.parametrize("eps", [0.03, 0.15, 0.6, 10.0])
def test_close_vertices_are_merged_as_in_open3d(device, oracle, eps):
    rng = np.random.default_rng(1)
    points, colors = rng.random((200, 3)), rng.random((200, 3))
    mesh = TriangleMesh(points, rng.integers(0, 200, (100, 3)), vertex_colors=colors, device=device)
    mesh.vertex_normals = np.tile([0.0, 0.6, 0.8], (200, 1))
    merged, names = mesh.merge_close_vertices(eps), ("triangles", "vertices", "vertex_colors", "vertex_normals")
    name, given = f"meshing/cleaning/close_vertices_{eps}", (mesh, "merge_close_vertices", eps)
    triangles, *wanted = oracle(name, open3d_arrays, *given, names=names)
    np.testing.assert_array_equal(merged.triangles, triangles)
    for name, values in zip(names[1:], wanted, strict=True):
        np.testing.assert_allclose(getattr(merged, name), values, atol=2e-7)  # float32


def test_sorted_chains_of_vertices_are_merged_in_order(device):
    count = 3000  # each depends on the previous one
    points = np.arange(count)[:, None] * [0.6, 0, 0]
    for order in (np.arange(count), np.arange(count)[::-1]):
        mesh = TriangleMesh(points[order], [[0, 1, 2]], device=device, origin=[0, 0, 0]).merge_close_vertices(1)
        np.testing.assert_allclose(mesh.vertices[1, 0], points[order][2:4, 0].mean(), rtol=1e-6)
        assert len(mesh.vertices) == count // 2


def test_threads_wait_for_vertices_of_lower_index():
    points = np.arange(300_000)[:, None] * [0.6, 0, 0]  # enough for several threads
    assert len(TriangleMesh(points, [[0, 1, 2]], origin=[0, 0, 0]).merge_close_vertices(1).vertices) == 150_000


def test_merged_normals_have_unit_length_unlike_in_open3d(device):
    mesh = TriangleMesh([[0, 0, 0], [0.1, 0, 0]], [], vertex_normals=[[1, 0, 0], [0, 1, 0]], device=device)
    np.testing.assert_allclose(mesh.merge_close_vertices(1).vertex_normals, [[0.5**0.5, 0.5**0.5, 0]], atol=1e-7)


def test_selections_and_removals_by_index_match_open3d(oracle):
    rng, scenes = np.random.default_rng(3), []
    for mesh in fixed_soups(30):
        # for triangles of two corners include the duplicates that Open3D misses
        cleaned = mesh.remove_degenerate_triangles()
        indices = rng.integers(0, 7, rng.integers(0, 9)).tolist()
        scenes += [(cleaned, "select_by_index", indices, cleanup) for cleanup in (True, False)]
        scenes.append((mesh, "remove_vertices_by_index", indices))
        scenes.append((mesh, "remove_triangles_by_index", [i for i in indices if i < len(mesh)]))
    assert_meshes_are_open3ds(oracle, "meshing/cleaning/by_index", scenes)


ROTATION = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
CORNERS = np.array([[2.1, 2.2, 0], [12.3, 4.1, 0], [5.2, 11.3, 0]])


def open3d_crops(o3d, mesh):
    """Triangles inside a box, a rotated box and a polygon, with all vertices in Open3D's order."""
    peer, volume = in_open3d(o3d, mesh), o3d.visualization.SelectionPolygonVolume()
    volume.orthogonal_axis, volume.axis_min, volume.axis_max = "Z", 2, 9
    volume.bounding_polygon = o3d.utility.Vector3dVector(CORNERS)
    boxes = (
        o3d.geometry.AxisAlignedBoundingBox([3, 3, 3], [11, 9, 14]),
        o3d.geometry.OrientedBoundingBox([7, 7, 7], ROTATION, [9, 5, 30]),
    )
    return [*(arrays_of(peer.crop(box)) for box in boxes), arrays_of(volume.crop_triangle_mesh(peer))]


def test_crops_match_open3d(device, oracle):
    mesh, box = ball(device), AxisAlignedBoundingBox([3, 3, 3], [11, 9, 14])
    volumes = (box, OrientedBoundingBox([7, 7, 7], ROTATION, [9, 5, 30]), SelectionPolygonVolume(CORNERS, "Z", 2, 9))
    for volume, (vertices, triangles) in zip(
        volumes, oracle("meshing/cleaning/crops", open3d_crops, mesh), strict=True
    ):
        cropped = mesh.crop(volume)
        np.testing.assert_array_equal(cropped.vertices, vertices)
        np.testing.assert_array_equal(cropped.triangles, triangles)
        assert 100 < len(cropped) < len(mesh)
    far_box = AxisAlignedBoundingBox(box.min_bound + FAR - 0.01, box.max_bound + FAR + 0.01)
    far = TriangleMesh(mesh.vertices + FAR, mesh.triangles, device=device).crop(far_box)
    np.testing.assert_array_equal(far.triangles, mesh.crop(box).triangles)
    outside = mesh.crop(box, invert=True).vertices
    assert not ((outside >= box.min_bound) & (outside <= box.max_bound)).all(axis=1).any()


def test_selections_keep_colors_normals_and_texture(device):
    mesh = textured(device)
    mesh.vertex_colors = np.random.default_rng(0).random((32, 3))
    rows = np.random.default_rng(2).permutation(32)[:24]
    left = mesh.select_by_index(rows, cleanup=False)
    is_selected = np.isin(mesh.triangles, rows).all(axis=1)
    assert 5 < is_selected.sum() < 35
    np.testing.assert_array_equal(corner_table(left), corner_table(mesh)[np.repeat(is_selected, 3)])
    np.testing.assert_array_equal(left.vertex_colors, mesh.vertex_colors[rows])


def test_cleaning_preserves_texture_corners(device):
    mesh = textured(device)
    for cleaned in (
        mesh.remove_duplicated_vertices(),
        mesh.remove_duplicated_triangles(),
        mesh.remove_degenerate_triangles(zero_area=True),
        mesh.merge_close_vertices(1e-6),
    ):
        np.testing.assert_array_equal(corner_table(cleaned), corner_table(mesh))
    left = mesh.remove_triangles_by_index(np.arange(0, 40, 3))
    np.testing.assert_array_equal(corner_table(left), corner_table(mesh)[np.repeat(np.arange(40) % 3 > 0, 3)])


@pytest.mark.parametrize("method", ["select_by_index", "remove_vertices_by_index", "remove_triangles_by_index"])
def test_indices_out_of_range_are_rejected_and_negative_ones_count_from_the_end(method):
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]] * 3)
    with pytest.raises(IndexError, match=r"3\.\.3 are out of range for a mesh of 3"):
        getattr(mesh, method)([3])
    with pytest.raises(IndexError, match="-4"):
        getattr(mesh, method)([-4])
    with pytest.raises(TypeError, match="integers"):
        getattr(mesh, method)([0.5])
    np.testing.assert_array_equal(getattr(mesh, method)([-1]).triangles, getattr(mesh, method)([2]).triangles)
    assert len(getattr(mesh, method)([])) == (0 if method == "select_by_index" else 3)


def test_cleaning_an_empty_mesh_leaves_an_empty_mesh(device):
    empty = TriangleMesh(device=device)
    for cleaned in (
        empty.remove_degenerate_triangles(zero_area=True),
        empty.remove_duplicated_triangles(),
        empty.remove_duplicated_vertices(),
        empty.remove_non_manifold_edges(),
        empty.merge_close_vertices(1),
        empty.select_by_index([]),
        empty.remove_vertices_by_index([]),
        empty.remove_triangles_by_index([]),
        empty.remove_vertices_by_mask([]),
        empty.remove_triangles_by_mask(np.zeros(0, bool)),
        empty.crop(AxisAlignedBoundingBox([0] * 3, [1] * 3)),
        empty.fill_holes(),
        empty.repair(hole_size=1)[0],
        empty.orient_triangles(outward=True)[0],
    ):
        assert len(cleaned) == len(cleaned.vertices) == 0


def strip(device=None) -> TriangleMesh:
    rng = np.random.default_rng(0)
    vertices, normals, colors = rng.random((3, 60, 3)).astype(np.float32)
    triangles = rng.permuted(np.tile(np.arange(50), (80, 1)), axis=1)[:, :3]  # ten vertices are unreferenced
    return TriangleMesh(vertices, triangles, vertex_normals=normals, vertex_colors=colors, device=device)


NAMES = ("triangles", "vertices", "vertex_normals", "vertex_colors")


@pytest.mark.parametrize("method", ["remove_vertices_by_mask", "remove_triangles_by_mask"])
def test_results_of_cleaning_match_open3d(device, oracle, method):
    mesh = strip(device)
    chances = np.random.default_rng(1).random(60 if "vertices" in method else 80)
    for share in (0.0, 0.1, 0.5, 1.0):
        mask = chances < share
        wanted = oracle(f"meshing/cuts/{method}_{share}", open3d_arrays, mesh, method, mask, names=NAMES)
        left = getattr(mesh, method)(mask)
        for name, values in zip(NAMES, wanted, strict=True):
            np.testing.assert_array_equal(getattr(left, name), values)
    assert len(mesh) == 80 and len(mesh.vertices) == 60
