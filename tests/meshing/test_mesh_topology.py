"""Edges, fans, boundaries and orientation of meshes: Open3D's results with its errors corrected, one-sided surfaces."""

import numpy as np
import pytest
from hypothesis import given, settings

from pointloom import TriangleMesh

from .mesh_soups import BOX, BOX_SIDES, FAR, GOOD_SOUPS, ball, fixed_soups, grid, soup, surface
from .open3d_meshes import for_each, in_open3d, one_by_one
from .simplification_scenes import edge_counts
from .test_mesh_texture import corner_table, textured

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
        assert part.get_volume() == pytest.approx(1, rel=1e-6)
        assert part._signed_volume() > 0
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


def test_an_empty_mesh_has_no_edges_boundaries_or_faults(device):
    for mesh in (TriangleMesh(device=device), TriangleMesh(BOX, device=device)):
        assert mesh.get_non_manifold_edges(False).shape == mesh.get_boundary_edges().shape == (0, 2)
        assert mesh.get_boundaries() == [] and mesh.get_non_manifold_vertices().tolist() == []
        assert mesh.is_vertex_manifold() and mesh.is_orientable() and mesh.euler_poincare_characteristic() == 0
        starts, neighbors = mesh.compute_adjacency_list()
        assert starts.tolist() == [0] * (len(mesh.vertices) + 1) and neighbors.tolist() == []
        assert mesh.compute_triangle_areas().tolist() == []
