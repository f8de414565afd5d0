"""Edges, fans, boundaries, orientation, components and cleaning: Open3D's results with its errors corrected."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import AxisAlignedBoundingBox, OrientedBoundingBox, SelectionPolygonVolume, TriangleMesh
from pointloom.meshing.mesh.measures import signed_volume

from .mesh_soups import BOX, BOX_SIDES, FAR, GOOD_SOUPS, SOUPS, ball, fixed_soups, grid, soup, surface
from .open3d_meshes import arrays_of, assert_meshes_are_open3ds, for_each, in_open3d, one_by_one, open3d_arrays
from .simplification_scenes import edge_counts
from .test_mesh_attributes import corner_table, textured

HYPOTHESIS = settings(deadline=None, max_examples=25)


def open3d_topology(o3d, mesh):
    """Non-manifold edges, these and boundary edges, neighbors and their counts, and the Euler characteristic."""
    peer, cleaned = in_open3d(o3d, mesh), in_open3d(o3d, mesh.remove_unreferenced_vertices())
    edges = [np.array(peer.get_non_manifold_edges(allow), np.int16).reshape(-1, 2) for allow in (True, False)]
    # Open3D makes a vertex its own neighbor if a triangle contains it twice
    neighbors = [sorted(set(near) - {v}) for v, near in enumerate(peer.compute_adjacency_list().adjacency_list)]
    return [
        *(pairs[np.lexsort(pairs.T[::-1])] for pairs in edges),
        np.array([v for near in neighbors for v in near], np.int16),
        np.array([len(near) for near in neighbors], np.int16),
        [cleaned.euler_poincare_characteristic()],
    ]


def test_edges_neighbors_and_the_euler_characteristic_match_open3d(oracle):
    soups = fixed_soups()
    answers = one_by_one(oracle("meshing/topology/soups", for_each, open3d_topology, [(mesh,) for mesh in soups]))
    for mesh, (crowded, split, near, counts, (euler,)) in zip(soups, answers, strict=True):
        np.testing.assert_array_equal(mesh.get_non_manifold_edges(True), crowded)
        np.testing.assert_array_equal(mesh.get_non_manifold_edges(False), split)
        starts, neighbors = mesh.compute_adjacency_list()
        np.testing.assert_array_equal(starts, [0, *np.cumsum(counts)])
        np.testing.assert_array_equal(neighbors, near)
        assert mesh.euler_poincare_characteristic() == euler
        edges = edge_counts(mesh.triangles)
        assert mesh.get_boundary_edges().tolist() == sorted(list(e) for e, count in edges.items() if count == 1)


def test_an_unreferenced_vertex_does_not_change_the_euler_characteristic_unlike_in_open3d(device):
    mesh = TriangleMesh(np.vstack([BOX, [[9, 9, 9]]]), BOX_SIDES, device=device)
    assert mesh.euler_poincare_characteristic() == 2
    assert surface(5, 6, wrap=True, close=True).euler_poincare_characteristic() == 0


def open3d_fans(o3d, mesh):
    peer = in_open3d(o3d, mesh)
    return [sorted(peer.get_non_manifold_vertices()), [peer.is_vertex_manifold()]]


def test_split_vertices_match_open3d(oracle):
    # Open3D reads beyond a container's end at vertices whose triangles all contain them twice
    soups = fixed_soups(good=True)
    answers = one_by_one(oracle("meshing/topology/fans", for_each, open3d_fans, [(mesh,) for mesh in soups]))
    for mesh, (split, (is_manifold,)) in zip(soups, answers, strict=True):
        assert mesh.get_non_manifold_vertices().tolist() == split.tolist()
        assert mesh.is_vertex_manifold() == is_manifold


def test_a_vertex_of_folded_triangles_only_is_manifold(device):
    assert soup([[3, 3, 3], [2, 3, 3]], device).is_vertex_manifold()


def open3d_borders(o3d, mesh):
    half_edges = o3d.geometry.HalfEdgeTriangleMesh.create_from_triangle_mesh(in_open3d(o3d, mesh))
    return [list(loop) for loop in half_edges.get_boundaries()]


def test_boundaries_match_open3d(device, oracle):
    mesh = ball(device)
    middles = mesh.vertices[mesh.triangles].mean(axis=1)
    torn = mesh.remove_triangles_by_mask((middles[:, 2] > 11.5) | (middles[:, 2] < 4)).remove_unreferenced_vertices()
    wanted = oracle("meshing/topology/borders", open3d_borders, torn)
    assert [loop.tolist() for loop in torn.get_boundaries()] == wanted and len(wanted) == 2


@HYPOTHESIS
@given(GOOD_SOUPS)
def test_loops_are_closed_paths_along_the_boundary(triangles):
    mesh = soup(triangles)
    half_edges = {(t[k], t[(k + 1) % 3]) for t in mesh.triangles.tolist() for k in range(3)}
    border, seen = {tuple(e) for e in mesh.get_boundary_edges().tolist()}, set()
    loops = [loop.tolist() for loop in mesh.get_boundaries()]
    for loop in loops:
        assert len(set(loop)) == len(loop) >= 3 and loop[0] == min(loop)
        for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
            assert (a, b) in half_edges and (min(a, b), max(a, b)) in border - seen
            seen.add((min(a, b), max(a, b)))
    assert [loop[0] for loop in loops] == sorted(loop[0] for loop in loops)
    edge_manifold_and_alike = mesh.is_edge_manifold() and len(half_edges) == 3 * len(triangles)
    assert seen == border or not edge_manifold_and_alike


def test_a_boundary_that_passes_a_vertex_twice_is_two_loops(device):
    """A sheet of 4 x 4 squares without two that touch at its middle."""
    triangles = np.delete(grid(5, 5), [2 * 5, 2 * 5 + 1, 2 * 10, 2 * 10 + 1], axis=0)
    loops = TriangleMesh(np.random.default_rng(0).random((25, 3)), triangles, device=device).get_boundaries()
    assert sorted(len(loop) for loop in loops) == [4, 4, 16]
    assert sorted(sorted(loop.tolist()) for loop in loops[1:]) == [[6, 7, 11, 12], [12, 13, 17, 18]]


def test_inconsistent_orientation_leaves_no_boundary_loop(device):
    assert TriangleMesh(BOX[:4], [[0, 1, 2], [1, 2, 3]], device=device).get_boundaries() == []
    assert TriangleMesh(BOX[:5], [[0, 1, 2], [0, 1, 3], [0, 1, 4]], device=device).get_boundaries() == []


def is_consistent(triangles: np.ndarray) -> bool:
    half_edges = [(t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3)]
    return len(set(half_edges)) == len(half_edges)


SURFACES = {
    "sheet": ({}, True),
    "ring": ({"wrap": True}, True),
    "strip of Möbius": ({"wrap": True, "twist": True}, False),
    "torus": ({"wrap": True, "close": True}, True),
    "bottle of Klein": ({"wrap": True, "twist": True, "close": True}, False),
}


@pytest.mark.parametrize("name", SURFACES)
def test_one_sided_surfaces_cannot_be_oriented(device, name):
    joined, orientable = SURFACES[name]
    mesh = surface(5, 6, **joined).to(device)
    flips = np.random.default_rng(0).random(len(mesh)) < 0.5
    shuffled = np.where(flips[:, None], mesh.triangles[:, ::-1], mesh.triangles)
    mesh = TriangleMesh(mesh.vertices, shuffled, device=device)
    assert mesh.is_edge_manifold() and mesh.is_orientable() == orientable
    oriented, is_orientable = mesh.orient_triangles()
    assert is_orientable == orientable and is_consistent(oriented.triangles) == orientable
    assert oriented.triangles[0].tolist() == mesh.triangles[0].tolist()
    if not orientable:
        np.testing.assert_array_equal(oriented.triangles, mesh.triangles)


def open3d_orientable(o3d, mesh):
    return [[in_open3d(o3d, mesh).is_orientable()]]


def test_meshes_orientable_by_open3d_are_oriented(oracle):
    soups = [mesh.remove_non_manifold_edges() for mesh in fixed_soups(good=True)]
    soups += [surface(5, 6, **joined) for joined, _ in SURFACES.values()]
    answers = one_by_one(oracle("meshing/topology/orientable", for_each, open3d_orientable, [(m,) for m in soups]))
    for mesh, ((wanted,),) in zip(soups, answers, strict=True):
        oriented, orientable = mesh.orient_triangles()
        assert orientable == mesh.is_orientable() == wanted
        assert not orientable or is_consistent(oriented.triangles)
        np.testing.assert_array_equal(np.sort(oriented.triangles, axis=1), np.sort(mesh.triangles, axis=1))
    assert [wanted for ((wanted,),) in answers[-5:]] == [orientable for _, orientable in SURFACES.values()]


@pytest.mark.parametrize("where", [np.zeros(3), FAR])
def test_closed_components_can_be_oriented_outwards_and_open_ones_stay(device, where):
    rng = np.random.default_rng(0)
    sides = np.vstack([BOX_SIDES[:, ::-1], BOX_SIDES + 8, BOX_SIDES[1:, ::-1] + 16])
    sides = np.where(rng.random(len(sides))[:, None] < 0.3, sides[:, [0, 2, 1]], sides)
    mesh = TriangleMesh(np.vstack([BOX, BOX + 3, BOX + 9]) + where, sides, device=device)
    oriented, orientable = mesh.orient_triangles(outward=True)
    assert orientable and is_consistent(oriented.triangles)
    for first in (0, 12):
        part = TriangleMesh(oriented.vertices, oriented.triangles[first : first + 12])
        assert part.get_volume() == pytest.approx(1, rel=1e-6) and signed_volume(part) > 0
    assert oriented.triangles[24].tolist() == mesh.triangles[24].tolist()


def test_a_non_finite_triangle_does_not_flip_its_component(device):
    vertices = np.vstack([BOX, [[np.nan, 0, 0]]])
    sides = np.vstack([BOX_SIDES[:, ::-1], [[0, 1, 8]]])
    oriented, _ = TriangleMesh(vertices, sides[1:], device=device).orient_triangles(outward=True)
    expected, _ = TriangleMesh(vertices, sides[1:-1], device=device).orient_triangles(outward=True)
    np.testing.assert_array_equal(oriented.triangles[:-1], expected.triangles)


def test_texture_follows_flipped_triangles(device):
    mesh = textured(device).remove_non_manifold_edges()
    oriented, _ = mesh.orient_triangles()
    flipped = (oriented.triangles != mesh.triangles).any(axis=1)
    assert 0 < flipped.sum() < len(mesh)
    before, after = (corner_table(m).reshape(-1, 3, 6) for m in (mesh, oriented))
    np.testing.assert_array_equal(after[flipped], before[flipped][:, [0, 2, 1]])
    np.testing.assert_array_equal(after[~flipped], before[~flipped])


def test_a_cavity_is_subtracted_and_a_separate_part_added(device):
    vertices = np.vstack([BOX * 4, BOX + 1, BOX + 9])
    sides = np.vstack([BOX_SIDES, BOX_SIDES[:, ::-1] + 8, BOX_SIDES + 16])
    assert TriangleMesh(vertices, sides, device=device).get_volume() == pytest.approx(64)


def open3d_areas(o3d, mesh):
    peer = o3d.t.geometry.TriangleMesh.from_legacy(in_open3d(o3d, mesh)).compute_triangle_areas()
    return peer.triangle.areas.numpy()


def test_triangle_areas_match_open3d(device, oracle):
    mesh = ball(device, 8)
    wanted = oracle("meshing/topology/areas", open3d_areas, mesh)
    np.testing.assert_allclose(mesh.compute_triangle_areas(), wanted, rtol=1e-5)  # its float32
    assert mesh.compute_triangle_areas().sum() == pytest.approx(mesh.get_surface_area(), rel=1e-12)
    broken = TriangleMesh([[0, 0, 0], [1, 0, 0], [np.nan, 0, 0]], [[0, 1, 2]], device=device)
    assert np.isnan(broken.compute_triangle_areas()).all()


def test_an_empty_mesh_has_no_edges_boundaries_components_or_faults(device):
    for mesh in (TriangleMesh(device=device), TriangleMesh(BOX, device=device)):
        assert mesh.get_non_manifold_edges(False).shape == mesh.get_boundary_edges().shape == (0, 2)
        assert mesh.get_boundaries() == [] and mesh.get_non_manifold_vertices().tolist() == []
        assert mesh.is_vertex_manifold() and mesh.is_orientable() and mesh.euler_poincare_characteristic() == 0
        starts, neighbors = mesh.compute_adjacency_list()
        assert starts.tolist() == [0] * (len(mesh.vertices) + 1) and neighbors.tolist() == []
        assert mesh.compute_triangle_areas().tolist() == []
        assert [len(values) for values in mesh.cluster_connected_triangles()] == [0, 0, 0]
        assert len(mesh.remove_small_components(min_triangles=5)) == 0


# Two squares and a separate triangle; the squares share a vertex.
CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 1, 0], [2, 2, 0], [1, 2, 0], [5, 5, 5], [6, 5, 5], [5, 8, 5]]
PARTS = [[2, 4, 5], [7, 8, 9], [0, 1, 2], [2, 5, 6], [3, 0, 2]]


def open3d_parts(o3d, mesh):
    labels, counts, areas = in_open3d(o3d, mesh).cluster_connected_triangles()
    return np.array(labels, np.int32), np.array(counts, np.int32), np.array(areas)


def test_components_match_open3d_for_any_triangles(device, oracle):
    """Includes edges of three triangles, triangles with coincident corners, and duplicate triangles."""
    soups = [mesh for mesh in fixed_soups() if len(mesh)]
    answers = oracle("meshing/components/soups", for_each, open3d_parts, [(mesh,) for mesh in soups])
    for mesh, wanted in zip(soups, one_by_one(answers), strict=True):
        labels, counts, areas = mesh.to(device).cluster_connected_triangles()
        np.testing.assert_array_equal(labels, wanted[0])
        np.testing.assert_array_equal(counts, wanted[1])
        np.testing.assert_allclose(areas, wanted[2], rtol=1e-12)


def test_components_that_share_only_a_vertex_are_separate(device):
    labels, counts, areas = TriangleMesh(CORNERS, PARTS, device=device).cluster_connected_triangles()
    assert labels.dtype == np.int32 and labels.tolist() == [0, 1, 2, 0, 2]
    assert (counts.tolist(), areas.tolist()) == ([2, 1, 2], [1.0, 1.5, 1.0])


@pytest.mark.parametrize(
    ("limits", "selected"),
    [({}, [0, 1, 2, 3, 4]), ({"min_triangles": 2}, [0, 2, 3, 4]), ({"min_triangles": 3}, []),
     ({"min_area": 1.0}, [0, 1, 2, 3, 4]), ({"min_area": 1.01}, [1]), ({"min_triangles": 2, "min_area": 1.2}, [])],
)  # fmt: skip
def test_small_parts_go_with_their_vertices(device, limits, selected):
    colors = np.random.default_rng(0).random((len(CORNERS), 3)).astype(np.float32)
    mesh = TriangleMesh(CORNERS, PARTS, vertex_colors=colors, device=device)
    left = mesh.remove_small_components(**limits)
    triangles = np.array(PARTS)[selected].reshape(-1, 3)
    used = np.unique(triangles)
    np.testing.assert_array_equal(left.triangles, np.searchsorted(used, triangles))
    np.testing.assert_array_equal(left.vertices, np.array(CORNERS)[used])
    np.testing.assert_array_equal(left.vertex_colors, colors[used])


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
        first = min(tuple(t[k:] + t[:k]) for k in range(3))  # of the rotations
        if first not in seen:
            expected.append(t)
        seen.add(first)
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
    assert left.is_edge_manifold() and left.triangles.tolist() == greedy_manifold(mesh)


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


def test_merged_vertices_have_mean_positions_and_colors_and_normals_of_unit_length_unlike_in_open3d(device):
    arrays = {"vertex_normals": [[1, 0, 0], [0, 1, 0]], "vertex_colors": [[1, 0, 0], [0, 0, 1]]}
    merged = TriangleMesh([[0, 0, 0], [0.1, 0, 0]], [], **arrays, device=device).merge_close_vertices(1)
    np.testing.assert_allclose(merged.vertex_normals, [[0.5**0.5, 0.5**0.5, 0]], atol=1e-7)
    np.testing.assert_allclose([*merged.vertices, *merged.vertex_colors], [[0.05, 0, 0], [0.5, 0, 0.5]], atol=1e-7)


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
POLYGON = np.array([[2.1, 2.2, 0], [12.3, 4.1, 0], [5.2, 11.3, 0]])


def open3d_crops(o3d, mesh):
    """Triangles inside a box, a rotated box and a polygon, with all vertices in Open3D's order."""
    peer, volume = in_open3d(o3d, mesh), o3d.visualization.SelectionPolygonVolume()
    volume.orthogonal_axis, volume.axis_min, volume.axis_max = "Z", 2, 9
    volume.bounding_polygon = o3d.utility.Vector3dVector(POLYGON)
    box = o3d.geometry.AxisAlignedBoundingBox([3, 3, 3], [11, 9, 14])
    rotated = o3d.geometry.OrientedBoundingBox([7, 7, 7], ROTATION, [9, 5, 30])
    return [*(arrays_of(peer.crop(each)) for each in (box, rotated)), arrays_of(volume.crop_triangle_mesh(peer))]


def test_crops_match_open3d(device, oracle):
    mesh, box = ball(device), AxisAlignedBoundingBox([3, 3, 3], [11, 9, 14])
    volumes = (box, OrientedBoundingBox([7, 7, 7], ROTATION, [9, 5, 30]), SelectionPolygonVolume(POLYGON, "Z", 2, 9))
    answers = oracle("meshing/cleaning/crops", open3d_crops, mesh)
    for volume, (vertices, triangles) in zip(volumes, answers, strict=True):
        cropped = mesh.crop(volume)
        np.testing.assert_array_equal(cropped.vertices, vertices)
        np.testing.assert_array_equal(cropped.triangles, triangles)
        assert 100 < len(cropped) < len(mesh)
    far_box = AxisAlignedBoundingBox(box.min_bound + FAR - 0.01, box.max_bound + FAR + 0.01)
    far = TriangleMesh(mesh.vertices + FAR, mesh.triangles, device=device).crop(far_box)
    np.testing.assert_array_equal(far.triangles, mesh.crop(box).triangles)
    outside = mesh.crop(box, invert=True).vertices
    assert not ((outside >= box.min_bound) & (outside <= box.max_bound)).all(axis=1).any()


def test_cleaning_and_selections_preserve_texture_corners(device):
    mesh = textured(device)
    mesh.vertex_colors = np.random.default_rng(0).random((32, 3))
    rows = np.random.default_rng(2).permutation(32)[:24]
    is_selected = np.isin(mesh.triangles, rows).all(axis=1)
    assert 5 < is_selected.sum() < 35
    selected = mesh.select_by_index(rows, cleanup=False)
    np.testing.assert_array_equal(corner_table(selected), corner_table(mesh)[np.repeat(is_selected, 3)])
    np.testing.assert_array_equal(selected.vertex_colors, mesh.vertex_colors[rows])
    for kind, count in (("vertices", 32), ("triangles", 40)):
        mask = np.random.default_rng(1).random(count) < 0.3
        by_mask = getattr(mesh, f"remove_{kind}_by_mask")(mask)
        by_index = getattr(mesh, f"remove_{kind}_by_index")(np.flatnonzero(mask))
        np.testing.assert_array_equal(corner_table(by_mask), corner_table(by_index))
        np.testing.assert_array_equal(by_mask.vertex_colors, by_index.vertex_colors)
        assert 0 < len(by_mask) < len(mesh)
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
    out = r"3\.\.3 are out of range for a mesh of 3"
    for index, error, words in ((3, IndexError, out), (-4, IndexError, "-4"), (0.5, TypeError, "integers")):
        with pytest.raises(error, match=words):
            getattr(mesh, method)([index])
    np.testing.assert_array_equal(getattr(mesh, method)([-1]).triangles, getattr(mesh, method)([2]).triangles)
    assert len(getattr(mesh, method)([])) == (0 if method == "select_by_index" else 3)


def test_cleaning_an_empty_mesh_leaves_an_empty_mesh(device):
    empty = TriangleMesh(device=device)
    for cleaned in (
        empty.remove_degenerate_triangles(zero_area=True), empty.remove_duplicated_triangles(),
        empty.remove_duplicated_vertices(), empty.remove_non_manifold_edges(), empty.merge_close_vertices(1),
        empty.select_by_index([]), empty.remove_vertices_by_index([]), empty.remove_triangles_by_index([]),
        empty.remove_vertices_by_mask([]), empty.remove_triangles_by_mask(np.zeros(0, bool)), empty.fill_holes(),
        empty.crop(AxisAlignedBoundingBox([0] * 3, [1] * 3)), empty.repair(hole_size=1)[0],
        empty.orient_triangles(outward=True)[0],
    ):  # fmt: skip
        assert len(cleaned) == len(cleaned.vertices) == 0
