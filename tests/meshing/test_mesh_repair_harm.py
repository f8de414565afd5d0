"""A repair makes no mesh worse: valid parts stay, closed parts stay closed, only duplicates are removed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh

from .mesh_soups import GOOD_SOUPS, soup
from .repair_scenes import (
    DIAGONAL,
    REPAIR_CASES,
    VALID,
    blocks,
    box,
    fans,
    flipped,
    joined,
    loose,
    moved,
    partly_flipped,
    ring,
    shells,
    sphere,
    two_sided,
    welded,
    with_more,
)
from .test_mesh_texture import PICTURE, corner_table


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
    assert repaired._signed_volume() == pytest.approx(local._signed_volume(), rel=1e-4)
    assert report.lost_area == 0 and report.removed_crowding_triangles == 0
    assert len(repaired) - report.added_triangles == len(meant)


@pytest.mark.parametrize("count", [3, 4, 5, 6, 9])
def test_an_edge_of_many_triangles_is_split_into_sheets(device, count):
    mesh = fans(count).to(device)
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
    ball = sphere()
    tip = 2 * ball.vertices[:1]
    fin = TriangleMesh(np.vstack([ball.vertices, tip]), np.vstack([ball.triangles, [[*ball.triangles[20][:2], 62]]]))
    repaired, report = fin.to(device).repair()
    assert report.removed_crowding_triangles == 1 and report.lost_area > 0 and repaired.is_watertight()
    wall = fin._with_arrays()
    triangles = np.vstack([fin.triangles, [[62, ball.triangles[20][0], 63]]])
    wall = TriangleMesh(np.vstack([fin.vertices, 3 * tip]), triangles)
    repaired, report = wall.to(device).repair()
    assert report.removed_crowding_triangles == 0 and len(repaired) == len(wall)
    assert sorted(repaired.cluster_connected_triangles()[1]) == [2, len(ball)]


def test_a_surface_that_touches_itself_along_an_edge_is_split_there(device):
    mesh = ring().to(device)
    mesh.vertex_colors = np.linspace(0, 1, 3 * len(mesh.vertices)).reshape(-1, 3)
    mesh.triangle_uvs = np.random.default_rng(0).random((3 * len(mesh), 2))
    mesh.textures = [PICTURE]
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
def test_cubes_of_any_grid_become_closed_with_unchanged_area(seed, share, change):
    full = np.random.default_rng(seed).random((3, 3, 3)) < share
    full[0, 0, 0] = True
    mesh = blocks(full)
    repaired, report = change(mesh).repair()
    assert repaired.is_watertight() and repaired.is_vertex_manifold()
    assert repaired.get_surface_area() == pytest.approx(mesh.get_surface_area(), rel=1e-6)
    if change is not partly_flipped:
        assert repaired.get_volume() == pytest.approx(full.sum(), rel=1e-6)
        assert report.removed_crowding_triangles == report.removed_duplicated_triangles == 0


SHAPES = st.sampled_from([sphere(), DIAGONAL, shells(3), ring(), joined(sphere(), sphere(0.5))])
CHANGES = st.sampled_from([flipped, two_sided, loose, partly_flipped, welded, lambda m: with_more(m, m.triangles[3:9])])


@pytest.mark.slow
@settings(deadline=None, max_examples=40)
@given(SHAPES, st.lists(CHANGES, max_size=3), st.floats(-1e6, 1e6))
def test_repairs_of_damaged_closed_meshes_are_closed(shape, changes, shift):
    mesh = shape
    for change in changes:
        mesh = change(mesh)
    repaired, report = moved(mesh, [shift, 0, 0]).repair()
    again, second = repaired.repair()
    assert report.is_watertight and report.non_manifold_vertices == 0 and report.lost_area < 0.01
    assert repaired.get_surface_area() >= 0.99 * shape.get_surface_area()
    assert len(again) == len(repaired) and second.flipped_triangles == second.split_vertices == 0


def test_each_fan_gets_its_own_vertex(device):
    mesh = welded(joined(box(), box(1, 1, 1)))
    mesh.vertex_colors = np.random.default_rng(0).random((15, 3))
    mesh.triangle_uvs = np.random.default_rng(1).random((72, 2))
    mesh.triangle_material_ids = np.zeros(24, int)
    mesh.textures = [PICTURE]
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


@settings(deadline=None, max_examples=30)
@given(GOOD_SOUPS)
def test_a_split_separates_no_edge(triangles):
    mesh = soup(triangles)
    split = mesh.split_non_manifold_vertices()
    assert split.is_vertex_manifold() and split.edge_topology()[:3] == mesh.edge_topology()[:3]
