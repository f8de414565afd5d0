"""Repairs: closed, consistently oriented, edge-manifold, with a correct report, and no mesh gets worse."""

import itertools

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from pointloom import TriangleMesh
from pointloom.meshing.mesh.measures import signed_volume

from . import repair_scenes
from .mesh_soups import BOX, BOX_SIDES, FAR, GOOD_SOUPS, SOUPS, ball, grid, soup
from .repair_scenes import REPAIR_CASES, VALID, blocks, box, flipped, joined, loose, partly_flipped, welded
from .test_mesh_attributes import IMAGE, corner_table
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
    uvs = np.array(corners)[upper + lower][..., [0, 2]].reshape(-1, 2)  # texture coordinates of each vertex
    mesh = TriangleMesh(corners, upper + lower, triangle_uvs=uvs, device=device)
    assert [len(loop) for loop in mesh.get_boundaries()] == [4, 4]
    filled = mesh.fill_holes()
    assert len(filled) == 12 and filled.is_edge_manifold(allow_boundary_edges=False)
    expected = filled.vertices[filled.triangles][..., [0, 2]].reshape(-1, 2)
    np.testing.assert_allclose(filled.triangle_uvs, expected, atol=1e-6)
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
    assert mesh.repair(hole_size=0.71)[1].holes_left == 0 and len(mesh.fill_holes().get_boundary_edges()) == 0
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
    assert report.warnings == ("1 holes are left open",) and report.to_dict()["reliable"] is False


def test_new_triangles_take_texture_from_the_boundary(device):
    mesh = without_sides([0, 1], device)
    mesh.triangle_uvs = np.random.default_rng(0).random((30, 2))
    mesh.triangle_material_ids = np.arange(10) % 2
    mesh.textures = [IMAGE, IMAGE]
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
    assert signed_volume(repaired) > 0 and report.removed_non_finite_triangles == 1
    assert report.merged_vertices == 33 - 8 and report.removed_degenerate_triangles == 1
    assert report.removed_duplicated_triangles == 1 and report.removed_crowding_triangles == 1
    assert (report.filled_holes, report.added_triangles, report.holes_left) == (1, 1, 0)
    assert report.flipped_triangles == 2
    assert report.removed_vertices == 3 + 6 and report.split_vertices == 0
    assert report.is_watertight and report.is_orientable and report.boundary_edges == 0
    assert report.non_manifold_vertices == report.zero_area_triangles == 0


# Another repair would add 2 triangles, remove 1 of a part that was reversed, and remove 2 copies, in this order.
REPEATED_CUTS = (
    [(0, 1, 3), (1, 3, 4), (1, 3, 5), (1, 5, 2), (2, 3, 5), (0, 3, 4), (0, 3, 5)],
    [(1, 0, 3), (0, 5, 1), (4, 3, 2), (2, 0, 5), (2, 5, 0), (3, 0, 4), (1, 2, 0), (0, 1, 3), (2, 3, 4), (3, 2, 0)],
    [
        *[(4, 1, 0), (2, 1, 3), (4, 3, 0), (4, 3, 2), (1, 4, 3), (3, 0, 1), (4, 1, 3)],
        *[(4, 3, 1), (0, 2, 4), (0, 1, 4), (2, 4, 3), (1, 0, 4), (2, 3, 1)],
    ],
)


@HYPOTHESIS
@example(REPEATED_CUTS[0], None, None)
@example(REPEATED_CUTS[1], None, None)
@example(REPEATED_CUTS[2], None, 0.3)
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
    assert report.is_orientable != ("a part is not orientable" in str(report.warnings))
    assert report.boundary_edges == len(repaired.get_boundary_edges())
    assert report.non_manifold_vertices == len(repaired.get_non_manifold_vertices())
    assert (report.holes_left is None) == (hole_size is None)
    if hole_size is None:  # patches between coincident vertices are sewn by another repair
        again, second = repaired.repair()
        assert len(again) == len(repaired) and second.flipped_triangles == 0


@pytest.mark.parametrize("name", VALID)
def test_valid_meshes_are_unchanged(device, name):
    mesh = VALID[name].to(device)
    repaired, report = mesh.repair()
    np.testing.assert_array_equal(repaired.triangles, mesh.triangles)
    np.testing.assert_array_equal(repaired.vertices, mesh.vertices)
    assert report.is_watertight == mesh.is_watertight() and report.flipped_triangles == report.split_vertices == 0


@pytest.mark.parametrize("name", REPAIR_CASES)
def test_damaged_meshes_are_restored(device, name):
    given_mesh, meant = REPAIR_CASES[name]
    repaired, report = given_mesh.to(device).repair()
    assert repaired.is_edge_manifold() and repaired.is_vertex_manifold() and report.is_orientable
    assert repaired.is_watertight() == (len(meant.get_boundary_edges()) == 0)
    assert repaired.get_surface_area() == pytest.approx(meant.get_surface_area(), rel=1e-6)
    local = TriangleMesh(meant.vertices, meant.triangles)
    assert signed_volume(repaired) == pytest.approx(signed_volume(local), rel=1e-4)
    assert report.lost_area == 0 and report.removed_crowding_triangles == 0 and report.reliable
    assert len(repaired) - report.added_triangles == len(meant)


@pytest.mark.parametrize("count", [3, 4, 5, 6, 9])
def test_an_edge_of_many_triangles_is_split_into_sheets(device, count):
    mesh = repair_scenes.fans(count).to(device)
    repaired, report = mesh.repair()
    parts = repaired.cluster_connected_triangles()[1]
    assert len(repaired) == 2 * count and repaired.is_edge_manifold() and repaired.is_vertex_manifold()
    assert sorted(parts) == [2] * (count % 2) + [4] * (count // 2)
    assert report.split_vertices == 2 * ((count + 1) // 2 - 1)


@pytest.mark.parametrize("flip_triangles", [False, True])
def test_triangles_at_one_edge_are_paired_by_angle(device, flip_triangles):
    """Two thin wedges whose tips touch: each stays intact for any triangle orientation."""
    tips = [[1, 0.1, 0], [1, -0.1, 0], [-1, 0.1, 0], [-1, -0.1, 0]]
    first = [[0, 1, 3], [1, 0, 2], [2, 0, 3], [1, 2, 3]]
    second = [[0, 1, 4], [1, 0, 5], [5, 0, 4], [1, 5, 4]]
    mesh = TriangleMesh([[0, 0, 0], [0, 0, 1], *tips], first + second, device=device)
    mesh = flipped(mesh) if flip_triangles else mesh
    repaired, report = mesh.repair()
    assert repaired.is_watertight() and sorted(repaired.cluster_connected_triangles()[1]) == [4, 4]
    assert report.split_vertices == 2 and repaired.get_volume() == pytest.approx(2 * 0.2 / 6)


def test_a_single_unpaired_triangle_is_removed_and_a_sheet_stays(device):
    ball = repair_scenes.sphere()
    tip = 2 * ball.vertices[:1]
    fin = TriangleMesh(np.vstack([ball.vertices, tip]), np.vstack([ball.triangles, [[*ball.triangles[20][:2], 62]]]))
    repaired, report = fin.to(device).repair()
    assert report.removed_crowding_triangles == 1 and report.lost_area > 0 and repaired.is_watertight()
    assert "of the area was lost: compare it with the input" in report.warnings[0]
    wall = fin.with_arrays()
    triangles = np.vstack([fin.triangles, [[62, ball.triangles[20][0], 63]]])
    wall = TriangleMesh(np.vstack([fin.vertices, 3 * tip]), triangles)
    repaired, report = wall.to(device).repair()
    assert report.removed_crowding_triangles == 0 and len(repaired) == len(wall)
    assert sorted(repaired.cluster_connected_triangles()[1]) == [2, len(ball)]


def test_a_surface_that_touches_itself_along_an_edge_is_split_there(device):
    mesh = repair_scenes.ring().to(device)
    mesh.vertex_colors = np.linspace(0, 1, 3 * len(mesh.vertices)).reshape(-1, 3)
    mesh.triangle_uvs = np.random.default_rng(0).random((3 * len(mesh), 2))
    mesh.textures = [IMAGE]
    mesh.vertex_attributes["place"] = mesh.vertices
    mesh.triangle_attributes["label"] = np.arange(len(mesh))
    repaired, report = mesh.repair()
    np.testing.assert_allclose(repaired.vertex_attributes["place"], repaired.vertices)
    assert len(repaired.triangle_attributes["label"]) == len(repaired)
    assert repaired.is_watertight() and repaired.is_vertex_manifold() and report.added_triangles == 2
    assert repaired.get_volume() == pytest.approx(8) and len(repaired.triangle_uvs) == 3 * len(repaired)
    np.testing.assert_array_equal(repaired.vertices[-1], [1, 1, 1.5])
    np.testing.assert_array_equal(repaired.vertices[:-1], mesh.vertices)
    assert report.split_vertices == 1 and len(repaired.vertex_colors) == len(mesh.vertices) + 1


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 2**32 - 1), st.floats(0.2, 0.7), st.sampled_from([lambda m: m, loose, partly_flipped]))
def test_cubes_of_any_grid_become_closed_with_unchanged_area(seed, fraction, change):
    full = np.random.default_rng(seed).random((3, 3, 3)) < fraction
    full[0, 0, 0] = True
    mesh = blocks(full)
    repaired, report = change(mesh).repair()
    assert repaired.is_watertight() and repaired.is_vertex_manifold()
    assert repaired.get_surface_area() == pytest.approx(mesh.get_surface_area(), rel=1e-6)
    if change is not partly_flipped:
        assert repaired.get_volume() == pytest.approx(full.sum(), rel=1e-6)
        assert report.removed_crowding_triangles == report.removed_duplicated_triangles == 0


def test_each_fan_gets_its_own_vertex(device):
    mesh = welded(joined(box(), box(1, 1, 1)))
    mesh.vertex_colors = np.random.default_rng(0).random((15, 3))
    mesh.triangle_uvs = np.random.default_rng(1).random((72, 2))
    mesh.triangle_material_ids = np.zeros(24, int)
    mesh.textures = [IMAGE]
    mesh = mesh.to(device)
    split = mesh.split_non_manifold_vertices()
    assert not mesh.is_vertex_manifold() and split.is_vertex_manifold() and len(split.vertices) == 16
    np.testing.assert_array_equal(split.vertices[:15], mesh.vertices)
    np.testing.assert_array_equal(corner_table(split), corner_table(mesh))


def test_folded_triangles_go_with_the_first_fan_at_their_vertex(device):
    """Two fans meet in vertex 0, which two triangles contain twice. The last triangle is alone at its two vertices."""
    triangles = [[0, 1, 2], [0, 3, 4], [0, 0, 1], [3, 0, 0], [5, 5, 1]]
    mesh = TriangleMesh(np.random.default_rng(0).random((7, 3)), triangles).to(device)
    split = mesh.split_non_manifold_vertices()
    np.testing.assert_array_equal(split.vertices, mesh.vertices[[*range(7), 0, 1]])
    np.testing.assert_array_equal(split.triangles, [[0, 1, 2], [7, 3, 4], [0, 0, 1], [3, 0, 0], [5, 5, 8]])


def fan_count(triangles):
    """Number of fans, by SciPy: corners of one vertex in triangles that share an edge there belong together."""
    corners, pairs = np.arange(triangles.size).reshape(-1, 3), []
    for (s, first), (t, second) in itertools.combinations(enumerate(triangles.tolist()), 2):
        common = set(first) & set(second)
        if len(common) > 1:
            pairs += [(corners[s, first.index(v)], corners[t, second.index(v)]) for v in common]
    rows, columns = np.array(pairs, int).reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(rows)), (rows, columns)), (triangles.size,) * 2)
    return connected_components(graph, directed=False)[0]


@settings(deadline=None, max_examples=30)
@given(GOOD_SOUPS)
def test_a_split_separates_no_edge(triangles):
    mesh = soup(triangles)
    split = mesh.split_non_manifold_vertices()
    assert split.is_vertex_manifold() and split.edge_topology()[:3] == mesh.edge_topology()[:3]
    assert len(split.vertices) == len(mesh.vertices) - len(np.unique(mesh.triangles)) + fan_count(mesh.triangles)
