"""Hole filling and mesh repair: closed, consistently oriented, edge-manifold, with a correct report."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh

from .mesh_soups import BOX, BOX_SIDES, FAR, GOOD_SOUPS, SOUPS, ball, grid, soup
from .test_mesh_texture import PICTURE, corner_table
from .test_mesh_topology import is_consistent

HYPOTHESIS = settings(deadline=None, max_examples=20)


def without_sides(removed: list[int], device=None, **options) -> TriangleMesh:
    return TriangleMesh(BOX, np.delete(BOX_SIDES, removed, axis=0), device=device, **options)


def test_a_missing_side_is_filled_outwards_unlike_open3d(device):
    mesh = without_sides([0, 1], device)
    filled = mesh.fill_holes()
    np.testing.assert_array_equal(filled.triangles[:10], mesh.triangles)
    assert filled.is_watertight() and filled.get_volume() == pytest.approx(1)
    assert is_consistent(filled.triangles)  # unlike in Open3D


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("where", [0.0, 1.0])
def test_holes_of_a_ball_are_closed_at_any_scale_and_position(device, scale, where):
    complete = ball(device)
    middles = complete.vertices[complete.triangles].mean(axis=1)
    torn = complete.remove_triangles_by_mask((middles[:, 2] > 11.5) | (middles[:, 2] < 4))
    offset = FAR * where if scale == 1 else np.zeros(3)
    torn = TriangleMesh(torn.vertices * scale + offset, torn.triangles, device=device)
    filled = torn.fill_holes(1e3 * scale)
    assert filled.is_watertight() and is_consistent(filled.triangles)
    assert filled.euler_poincare_characteristic() == 2
    flat = 0.9 * complete.get_volume() * scale**3
    assert flat * 0.8 < filled.get_volume() < complete.get_volume() * scale**3


def minimal_weight(points: np.ndarray) -> float:
    """The minimal sum of squared side lengths over all triangulations of a polygon, by enumeration."""
    n, sq = len(points), ((points[:, None] - points[None]) ** 2).sum(axis=2)
    best = np.zeros((n, n))
    for d in range(2, n):
        for i in range(n - d):
            j = i + d
            best[i, j] = min(best[i, k] + best[k, j] + sq[i, k] + sq[k, j] + sq[i, j] for k in range(i + 1, j))
    return best[0, n - 1]


def test_a_flat_convex_hole_gets_the_minimal_triangulation(device):
    rng = np.random.default_rng(0)
    angle = np.sort(rng.random(12)) * 2 * np.pi
    rim = np.column_stack([2 * np.cos(angle), np.sin(angle), np.zeros(12)])
    k, after = np.arange(12), (np.arange(12) + 1) % 12
    sides = np.vstack([np.column_stack([k, k + 12, after]), np.column_stack([after, k + 12, 12 + after])])
    mesh = TriangleMesh(np.vstack([rim, rim * 3]), sides, device=device)
    corners = mesh.vertices[mesh.fill_holes(2.5).triangles[24:]]
    weight = ((corners - np.roll(corners, 1, axis=1)) ** 2).sum()
    assert weight == pytest.approx(minimal_weight(rim.astype(np.float32).astype(float)), rel=1e-9)


@HYPOTHESIS
@given(GOOD_SOUPS)
def test_filling_adds_no_non_manifold_edge_and_changes_no_triangle(triangles):
    mesh = soup(triangles)
    filled = mesh.fill_holes()
    np.testing.assert_array_equal(filled.triangles[: len(mesh)], mesh.triangles)
    np.testing.assert_array_equal(filled.get_non_manifold_edges(), mesh.get_non_manifold_edges())
    if mesh.is_edge_manifold() and is_consistent(mesh.triangles):
        assert is_consistent(filled.triangles)
    assert all(len(set(t)) == 3 for t in filled.triangles.tolist())


def test_holes_that_would_share_one_chord_are_filled_separately(device):
    """Two square holes with the same two opposite corners: the short diagonal is the same in both."""
    # Corners 0 and 1 are shared; around each hole a fan leads to an apex on its own side.
    corners = [[0, 0.2, 0], [0, -0.2, 0], [1, 0, 0.1], [-1, 0, 0.1], [1, 0, -1.1], [-1, 0, -1.1]]
    corners += [[0, 0, 2], [0, 0, -2]]
    upper = [[0, 2, 6], [2, 1, 6], [1, 3, 6], [3, 0, 6]]
    lower = [[4, 0, 7], [1, 4, 7], [5, 1, 7], [0, 5, 7]]
    mesh = TriangleMesh(corners, upper + lower, device=device)
    assert [len(loop) for loop in mesh.get_boundaries()] == [4, 4]
    filled = mesh.fill_holes()
    assert len(filled) == 12 and filled.is_edge_manifold(allow_boundary_edges=False)
    assert mesh.repair(hole_size=10)[1].filled_holes == 2


def test_an_existing_edge_is_not_used_as_chord(device):
    """A square hole whose short diagonal is already an edge of a tetrahedron."""
    corners = [[0, 0.2, 0], [0, -0.2, 0], [1, 0, 0.1], [-1, 0, 0.1], [0, 0, 2], [0.3, 0, -2], [-0.3, 0, -2]]
    roof = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]]
    tetrahedron = [[0, 5, 1], [0, 1, 6], [0, 6, 5], [1, 5, 6]]
    mesh = TriangleMesh(corners, roof + tetrahedron, device=device)
    assert [len(loop) for loop in mesh.get_boundaries()] == [4]
    filled = mesh.fill_holes()
    assert len(filled) == 10 and filled.is_edge_manifold(allow_boundary_edges=False)


def test_only_holes_up_to_the_size_are_filled_and_no_single_triangles(device):
    triangles = np.delete(grid(9, 9), [20, 21], axis=0)
    x, y = np.meshgrid(np.arange(9.0), np.arange(9.0))
    sheet = np.column_stack([x.ravel(), y.ravel(), np.zeros(81)])
    mesh = TriangleMesh(sheet, triangles, device=device)
    assert len(mesh.fill_holes(0.7)) == len(mesh)
    assert len(mesh.fill_holes(0.71)) == len(mesh) + 2  # half the diagonal of a square
    assert mesh.repair(hole_size=0.71)[1].holes_left == 0
    assert len(mesh.fill_holes().get_boundary_edges()) == 0
    alone = TriangleMesh(BOX[:3], [[0, 1, 2]], device=device)
    assert len(alone.fill_holes()) == 1


def test_holes_with_non_finite_or_too_many_vertices_are_skipped_and_counted(device):
    broken = BOX.copy()
    broken[0] = np.nan
    assert len(TriangleMesh(broken, BOX_SIDES[2:], device=device).fill_holes()) == 10
    count = 1001
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    rim = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    fan = np.column_stack([np.full(count, count), np.arange(count), (np.arange(count) + 1) % count])
    mesh = TriangleMesh(np.vstack([rim, [[0, 0, 1]]]), fan, device=device)
    assert len(mesh.fill_holes()) == count
    report = mesh.repair(hole_size=2)[1]
    assert (report.holes_left, report.filled_holes, report.boundary_edges) == (1, 0, count)


def test_new_triangles_take_texture_from_the_boundary(device):
    mesh = without_sides([0, 1], device)
    mesh.triangle_uvs = np.random.default_rng(0).random((30, 2))
    mesh.triangle_material_ids = np.arange(10) % 2
    mesh.textures = [PICTURE, PICTURE]
    mesh.vertex_colors = BOX
    filled = mesh.fill_holes()
    np.testing.assert_array_equal(corner_table(filled)[:30], corner_table(mesh))
    known = {tuple(row[:5]) for row in corner_table(mesh).tolist()}
    assert all(tuple(row[:5]) in known for row in corner_table(filled)[30:].tolist())
    np.testing.assert_array_equal(filled.vertex_colors, BOX)


def test_repair_report_lists_all_changes(device):
    rng = np.random.default_rng(0)
    loose = BOX[BOX_SIDES].reshape(-1, 3)  # a box of triangles that share no vertex
    sides = np.arange(36).reshape(12, 3)
    sides[[2, 5]] = sides[[2, 5], ::-1]
    sides = np.vstack([sides[:-1], sides[3:4, [1, 2, 0]], [[0, 3, 3], [3, 36, 37]], [[39, 40, 38]]])
    vertices = np.vstack([loose, [[np.nan, 0, 0], [7, 7, 7]], [[0.01, 0.5, 0.1]], loose[3:5], [[9, 9, 9]]])
    repaired, report = TriangleMesh(vertices, rng.permutation(sides), device=device).repair(hole_size=2)
    assert repaired.is_watertight() and repaired.get_volume() == pytest.approx(1) and len(repaired) == 12
    assert repaired._signed_volume() > 0
    assert report.removed_non_finite_triangles == 1
    assert report.merged_vertices == 33 - 8
    assert report.removed_degenerate_triangles == 1
    assert report.removed_duplicated_triangles == 1
    assert report.removed_crowding_triangles == 1
    assert (report.filled_holes, report.added_triangles, report.holes_left) == (1, 1, 0)
    assert report.flipped_triangles == 2
    assert report.removed_vertices == 3 + 6 and report.split_vertices == 0
    assert report.is_watertight and report.is_orientable and report.boundary_edges == 0
    assert report.non_manifold_vertices == report.zero_area_triangles == 0


@HYPOTHESIS
@given(SOUPS, st.sampled_from([None, 10.0]), st.sampled_from([None, 0.3]))
def test_repairs_of_any_mesh_are_manifold_with_a_correct_report(triangles, hole_size, merge_distance):
    mesh = soup(triangles)
    repaired, report = mesh.repair(hole_size=hole_size, merge_distance=merge_distance)
    assert repaired.is_edge_manifold() and repaired.is_vertex_manifold()
    gone = report.removed_degenerate_triangles + report.removed_duplicated_triangles + report.removed_crowding_triangles
    assert len(repaired) == len(mesh) - gone - report.removed_non_finite_triangles + report.added_triangles
    left = len(mesh.vertices) - report.merged_vertices - report.removed_vertices
    assert len(repaired.vertices) == left + report.split_vertices
    assert report.is_watertight == repaired.is_watertight()
    assert report.is_orientable == repaired.is_orientable() == (is_consistent(repaired.triangles) or len(repaired) == 0)
    assert report.boundary_edges == len(repaired.get_boundary_edges())
    assert report.non_manifold_vertices == len(repaired.get_non_manifold_vertices())
    assert (report.holes_left is None) == (hole_size is None)
    if hole_size is None:  # patches between coincident vertices are sewn by another repair
        again, second = repaired.repair()
        assert len(again) == len(repaired) and second.flipped_triangles == 0


def test_a_valid_mesh_is_unchanged(device):
    mesh = ball(device)
    repaired, report = mesh.repair(hole_size=10)
    np.testing.assert_array_equal(repaired.triangles, mesh.triangles)
    assert report.is_watertight and report.flipped_triangles == report.added_triangles == report.merged_vertices == 0
    reversed_mesh = TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1], device=device)
    reoriented, report = reversed_mesh.repair()
    assert report.flipped_triangles == len(mesh) and reoriented.get_volume() == pytest.approx(mesh.get_volume())
