"""Meshes cleaned: what Open3D drops and merges, its slips put right, the same whatever the order of the work."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import AxisAlignedBoundingBox, OrientedBoundingBox, SelectionPolygonVolume, TriangleMesh

from .mesh_soups import FAR, GOOD_SOUPS, SOUPS, ball, edge_counts, in_open3d, soup
from .test_mesh_texture import corner_table, textured

HYPOTHESIS = settings(deadline=None, max_examples=50)


def least_turn(t: list[int]) -> tuple[int, ...]:
    return min(tuple(t[k:] + t[:k]) for k in range(3))


def as_arrays(mesh) -> list[np.ndarray]:
    return [np.asarray(mesh.vertices), np.asarray(mesh.triangles).reshape(-1, 3)]


def assert_same(mesh: TriangleMesh, peer) -> None:
    for mine, other in zip(as_arrays(mesh), as_arrays(peer), strict=True):
        np.testing.assert_array_equal(mine, other)


# ------------------------------------------------------------------------------------------------ triangles


@HYPOTHESIS
@given(SOUPS)
def test_degenerate_triangles_are_those_of_open3d(triangles):
    mesh = soup(triangles)
    assert_same(mesh.remove_degenerate_triangles(), in_open3d(mesh).remove_degenerate_triangles())


def test_triangles_without_area_go_where_it_is_asked_for(device):
    corners = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [np.nan, 0, 0]]
    mesh = TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [1, 1, 3], [0, 1, 4]], device=device)
    assert mesh.remove_degenerate_triangles().triangles.tolist() == [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
    assert mesh.remove_degenerate_triangles(zero_area=True).triangles.tolist() == [[0, 1, 3], [0, 1, 4]]


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_slim_triangles_have_an_area_at_any_scale(device, scale):
    mesh = TriangleMesh(np.array([[0, 0, 0], [1, 0, 0], [0.5, 1e-6, 0]]) * scale, [[0, 1, 2]], device=device)
    assert len(mesh.remove_degenerate_triangles(zero_area=True)) == 1


@HYPOTHESIS
@given(GOOD_SOUPS)
def test_duplicated_triangles_are_those_of_open3d(triangles):
    mesh = soup(triangles)
    assert_same(mesh.remove_duplicated_triangles(), in_open3d(mesh).remove_duplicated_triangles())


@HYPOTHESIS
@given(SOUPS)
def test_of_triangles_equal_but_for_a_turn_the_first_stays(triangles):
    seen, kept = set(), []
    for t in map(list, triangles):
        if least_turn(t) not in seen:
            kept.append(t)
        seen.add(least_turn(t))
    assert soup(triangles).remove_duplicated_triangles().triangles.tolist() == kept


def test_turned_copies_of_a_folded_triangle_go_too_unlike_in_open3d(device):
    mesh = soup([[0, 0, 1], [0, 1, 0], [1, 0, 0]], device)
    assert mesh.remove_duplicated_triangles().triangles.tolist() == [[0, 0, 1]]
    assert len(in_open3d(mesh).remove_duplicated_triangles().triangles) == 2


def greedy_manifold(mesh: TriangleMesh) -> list[list[int]]:
    """Smallest triangles first, one after the other."""
    triangles = mesh.triangles
    counts = edge_counts(triangles)

    def edges(t):
        return [(min(a, b), max(a, b)) for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))]

    folded = [len(set(t)) < 3 and any(counts[e] > 2 for e in edges(t)) for t in triangles.tolist()]
    triangles = triangles[~np.array(folded, bool)]
    counts, kept = edge_counts(triangles), np.ones(len(triangles), bool)
    areas = TriangleMesh(mesh.vertices, triangles).compute_triangle_areas().astype(np.float32)
    for row in np.argsort(areas, kind="stable"):
        if any(counts[e] > 2 for e in edges(triangles[row].tolist())):
            kept[row] = False
            for e in edges(triangles[row].tolist()):
                counts[e] -= 1
    return triangles[kept].tolist()


@HYPOTHESIS
@given(SOUPS)
def test_crowded_edges_lose_their_smallest_triangles_first(triangles):
    mesh = soup(triangles)
    left = mesh.remove_non_manifold_edges()
    assert left.is_edge_manifold()
    assert left.triangles.tolist() == greedy_manifold(mesh)


def test_crowded_edges_lose_the_triangles_that_open3d_drops(device):
    rng = np.random.default_rng(3)
    pages = np.vstack(
        [[[0, 0, 0], [0, 0, 1]], rng.normal(size=(40, 3)), [[9, 0, 0], [9, 0, 1]], rng.normal(size=(9, 3))]
    )
    triangles = [[0, 1, k] for k in range(2, 42)] + [[42, 43, k] for k in range(44, 53)]
    mesh = TriangleMesh(pages, triangles, device=device)
    left, peer = mesh.remove_non_manifold_edges(), in_open3d(mesh).remove_non_manifold_edges()
    assert left.triangles.tolist() == np.asarray(peer.triangles).tolist() and len(left) == 4


@pytest.mark.slow_on_emulated_cuda("thousands of steps of one thread")
def test_a_book_of_thousands_of_pages_loses_all_but_two(device):
    rng = np.random.default_rng(0)
    mesh = TriangleMesh(
        np.vstack([[[0, 0, 0], [0, 0, 1]], rng.normal(size=(5000, 3))]),
        np.column_stack([np.zeros(5000, int), np.ones(5000, int), 2 + np.arange(5000)]),
        device=device,
    )
    left = mesh.remove_non_manifold_edges()
    areas = mesh.compute_triangle_areas()
    np.testing.assert_array_equal(left.triangles, mesh.triangles[np.sort(np.argsort(areas)[-2:])])


def test_a_manifold_mesh_keeps_a_triangle_without_area_unlike_in_open3d(device):
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [3, 0, 0], [4, 0, 0], [5, 0, 0]]
    mesh = TriangleMesh(vertices, [[0, 1, 2], [3, 4, 5]], device=device)
    assert len(mesh.remove_non_manifold_edges()) == 2
    assert len(in_open3d(mesh).remove_non_manifold_edges().triangles) == 1
    assert len(in_open3d(mesh).remove_degenerate_triangles().triangles) == 2  # which is what that is for


# ------------------------------------------------------------------------------------------------ vertices


@HYPOTHESIS
@given(st.lists(st.tuples(*[st.integers(0, 1)] * 3), min_size=3, max_size=12), st.randoms(use_true_random=False))
def test_duplicated_vertices_are_those_of_open3d(positions, random):
    count = len(positions)
    triangles = [[random.randrange(count) for _ in range(3)] for _ in range(6)]
    colors = np.random.default_rng(0).random((count, 3))
    mesh = TriangleMesh(positions, triangles, vertex_colors=colors, vertex_normals=-colors)
    merged, peer = mesh.remove_duplicated_vertices(), in_open3d(mesh).remove_duplicated_vertices()
    assert_same(merged, peer)
    np.testing.assert_array_equal(merged.vertex_colors, np.asarray(peer.vertex_colors))
    np.testing.assert_array_equal(merged.vertex_normals, np.asarray(peer.vertex_normals))


def test_vertices_with_nan_equal_none_and_minus_zero_is_zero(device):
    corners = [[0, 0, 0], [np.nan, 0, 0], [np.nan, 0, 0], [-0.0, 0, 0]]
    mesh = TriangleMesh(corners, [[0, 1, 2], [3, 2, 1]], device=device).remove_duplicated_vertices()
    assert mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 1]]


def test_ten_thousand_vertices_at_one_place_become_one(device):
    mesh = TriangleMesh(np.ones((10_000, 3)), [[0, 5000, 9999]], device=device)
    for merged in (mesh.remove_duplicated_vertices(), mesh.merge_close_vertices(0.1)):
        assert merged.vertices.tolist() == [[1, 1, 1]] and merged.triangles.tolist() == [[0, 0, 0]]


def greedy_groups(points: np.ndarray, eps: float) -> np.ndarray:
    """The vertex that each one joins, one after the other as Open3D does it."""
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
def test_close_vertices_join_the_first_that_stays(positions, eps, scale):
    points = np.float32(np.array(positions, float) * scale).astype(float)
    reach = eps * float(np.float32(scale))
    mesh = TriangleMesh(points, np.arange(len(points))[:, None].repeat(3, 1), origin=[0, 0, 0])
    owners = greedy_groups(points, reach)
    _, numbers = np.unique(owners, return_inverse=True)
    np.testing.assert_array_equal(mesh.merge_close_vertices(reach).triangles[:, 0], numbers)


@pytest.mark.parametrize("eps", [0.02, 0.1, 0.5, 10.0])
def test_close_vertices_are_merged_as_in_open3d(device, eps):
    rng = np.random.default_rng(1)
    points, colors = rng.random((600, 3)), rng.random((600, 3))
    mesh = TriangleMesh(points, rng.integers(0, 600, (300, 3)), vertex_colors=colors, device=device)
    mesh.vertex_normals = np.tile([0.0, 0.6, 0.8], (600, 1))
    merged, peer = mesh.merge_close_vertices(eps), in_open3d(mesh).merge_close_vertices(eps)
    np.testing.assert_array_equal(merged.triangles, np.asarray(peer.triangles))
    for name in ("vertices", "vertex_colors", "vertex_normals"):
        np.testing.assert_allclose(getattr(merged, name), np.asarray(getattr(peer, name)), atol=2e-7)  # float32


def test_vertices_in_a_row_in_order_of_their_numbers_are_merged_in_that_order(device):
    count = 3000  # each waits for the one before it
    points = np.arange(count)[:, None] * [0.6, 0, 0]
    for order in (np.arange(count), np.arange(count)[::-1]):
        mesh = TriangleMesh(points[order], [[0, 1, 2]], device=device, origin=[0, 0, 0]).merge_close_vertices(1)
        np.testing.assert_allclose(mesh.vertices[1, 0], points[order][2:4, 0].mean(), rtol=1e-6)
        assert len(mesh.vertices) == count // 2


def test_merged_normals_have_unit_length_unlike_in_open3d(device):
    mesh = TriangleMesh([[0, 0, 0], [0.1, 0, 0]], [], vertex_normals=[[1, 0, 0], [0, 1, 0]], device=device)
    np.testing.assert_allclose(mesh.merge_close_vertices(1).vertex_normals, [[0.5**0.5, 0.5**0.5, 0]], atol=1e-7)
    np.testing.assert_array_equal(in_open3d(mesh).merge_close_vertices(1).vertex_normals, [[0.5, 0.5, 0]])


def test_merging_spares_vertices_that_are_not_finite_and_works_far_from_zero(device):
    points = np.array([[0, 0, 0], [np.nan, 0, 0], [0.25, 0, 0], [np.inf, 0, 0], [np.nan, 0, 0]])
    mesh = TriangleMesh(points + FAR, [[0, 1, 2]], device=device).merge_close_vertices(0.5)
    np.testing.assert_array_equal(mesh.vertices, np.array([[0.125, 0, 0], *points[[1, 3, 4]]]) + FAR)
    assert mesh.triangles.tolist() == [[0, 1, 0]]


def test_a_distance_too_small_to_tell_is_refused():
    mesh = TriangleMesh([[1e6, 0, 0]], [], origin=[0, 0, 0])
    with pytest.raises(ValueError, match=r"eps: .* remove_duplicated_vertices"):
        mesh.merge_close_vertices(1e-20)
    with pytest.raises(ValueError, match="eps"):
        mesh.merge_close_vertices(0)


# ------------------------------------------------------------------------------------------------ selection


@HYPOTHESIS
@given(SOUPS, st.lists(st.integers(0, 6), max_size=9), st.booleans())
def test_selections_are_those_of_open3d(triangles, indices, cleanup):
    mesh = soup([t for t in triangles if len(set(t)) == 3])  # for others see the copies that Open3D misses
    assert_same(mesh.select_by_index(indices, cleanup), in_open3d(mesh).select_by_index(indices, cleanup))


@HYPOTHESIS
@given(SOUPS, st.lists(st.integers(0, 6), max_size=5))
def test_removals_by_index_are_those_of_open3d(triangles, indices):
    mesh, peer = soup(triangles), in_open3d(soup(triangles))
    peer.remove_vertices_by_index(indices)
    assert_same(mesh.remove_vertices_by_index(indices), peer)
    rows, peer = [i for i in indices if i < len(triangles)], in_open3d(mesh)
    peer.remove_triangles_by_index(rows)
    assert_same(mesh.remove_triangles_by_index(rows), peer)


def test_crops_are_those_of_open3d(device):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    mesh = ball(device)
    peer = in_open3d(mesh)
    box = AxisAlignedBoundingBox([3, 3, 3], [11, 9, 14])
    assert_same(mesh.crop(box), peer.crop(o3d.geometry.AxisAlignedBoundingBox(box.min_bound, box.max_bound)))
    turn = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
    turned = mesh.crop(OrientedBoundingBox([7, 7, 7], turn, [9, 5, 30]))
    assert_same(turned, peer.crop(o3d.geometry.OrientedBoundingBox([7, 7, 7], turn, [9, 5, 30])))
    assert 100 < len(turned) < len(mesh)
    volume = o3d.visualization.SelectionPolygonVolume()
    corners = np.array([[2.1, 2.2, 0], [12.3, 4.1, 0], [5.2, 11.3, 0]])
    volume.orthogonal_axis, volume.axis_min, volume.axis_max = "Z", 2, 9
    volume.bounding_polygon = o3d.utility.Vector3dVector(corners)
    assert_same(mesh.crop(SelectionPolygonVolume(corners, "Z", 2, 9)), volume.crop_triangle_mesh(peer))
    far = TriangleMesh(mesh.vertices + FAR, mesh.triangles, device=device).crop(
        AxisAlignedBoundingBox(np.add(box.min_bound, FAR) - 0.01, np.add(box.max_bound, FAR) + 0.01)
    )
    np.testing.assert_array_equal(far.triangles, mesh.crop(box).triangles)
    outside = mesh.crop(box, invert=True).vertices
    assert not ((outside >= box.min_bound) & (outside <= box.max_bound)).all(axis=1).any()


def test_selections_take_colours_normals_and_texture_along(device):
    mesh = textured(device)
    mesh.vertex_colors = np.random.default_rng(0).random((32, 3))
    rows = np.random.default_rng(2).permutation(32)[:24]
    left = mesh.select_by_index(rows, cleanup=False)
    whole = np.isin(mesh.triangles, rows).all(axis=1)
    assert 5 < whole.sum() < 35
    np.testing.assert_array_equal(corner_table(left), corner_table(mesh)[np.repeat(whole, 3)])
    np.testing.assert_array_equal(left.vertex_colors, mesh.vertex_colors[rows])


def test_cleaning_keeps_texture_at_its_corners(device):
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
def test_indices_beyond_the_mesh_are_refused_and_negative_ones_count_from_the_end(method):
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]] * 3)
    with pytest.raises(IndexError, match=r"3\.\.3 reach beyond a mesh of 3"):
        getattr(mesh, method)([3])
    with pytest.raises(IndexError, match="-4"):
        getattr(mesh, method)([-4])
    with pytest.raises(TypeError, match="whole numbers"):
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
        empty.crop(AxisAlignedBoundingBox([0] * 3, [1] * 3)),
        empty.fill_holes(),
        empty.repair(hole_size=1)[0],
        empty.orient_triangles(outward=True)[0],
    ):
        assert len(cleaned) == len(cleaned.vertices) == 0
