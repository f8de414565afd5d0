"""Operations on surfaces are continuous across seams, where a position has several vertices for its texture."""

import numpy as np
import pytest

from pointloom import TriangleMesh

from .mesh_soups import FAR
from .repair_scenes import SIDE_BY_SIDE, moved, sphere
from .test_mesh_texture import PICTURE

FILTERS = {
    "simple": lambda mesh: mesh.filter_smooth_simple(4),
    "laplacian": lambda mesh: mesh.filter_smooth_laplacian(4),
    "taubin": lambda mesh: mesh.filter_smooth_taubin(4),
    "sharpen": lambda mesh: mesh.filter_sharpen(1, 0.1),
}
CLOSE = 2e-6  # m: sums in another order, then float32


def split_at_seams(mesh: TriangleMesh, device=None) -> TriangleMesh:
    """The mesh with a texture of four charts, each with its own vertices, as in a file."""
    middles = mesh.vertices[mesh.triangles].mean(axis=1)
    piece = (middles[:, 0] > 0.1) * 2 + (middles[:, 1] > 0.1)
    keys, corners = np.unique(piece[:, None] * len(mesh.vertices) + mesh.triangles, return_inverse=True)
    split = TriangleMesh(mesh.vertices[keys % len(mesh.vertices)], corners.reshape(-1, 3), device=device)
    split.triangle_uvs = np.random.default_rng(0).random((3 * len(mesh), 2))
    split.textures = [PICTURE]
    split.vertex_colors = np.random.default_rng(1).random((len(split.vertices), 3))
    return split


def corners_of(mesh: TriangleMesh) -> np.ndarray:
    return mesh.vertices[mesh.triangles]


@pytest.mark.parametrize("name", FILTERS)
def test_filters_preserve_seams_and_texture(device, name):
    ball = sphere()
    split = split_at_seams(ball, device)
    changed = FILTERS[name](split)
    np.testing.assert_allclose(corners_of(changed), corners_of(FILTERS[name](ball)), rtol=0, atol=CLOSE)
    np.testing.assert_array_equal(changed.triangles, split.triangles)
    np.testing.assert_array_equal(changed.triangle_uvs, split.triangle_uvs)
    groups = np.unique(split.vertices, axis=0, return_inverse=True)[1]
    assert len(np.unique(np.column_stack([groups, changed.vertices]), axis=0)) == len(ball.vertices)
    assert len(np.unique(np.column_stack([groups, changed.vertex_colors]), axis=0)) == len(ball.vertices)


def test_loop_subdivision_is_smooth_across_seams(device):
    ball = sphere()
    split = split_at_seams(ball, device)
    fine = split.subdivide_loop(2)
    np.testing.assert_allclose(corners_of(fine), corners_of(ball.subdivide_loop(2)), rtol=0, atol=CLOSE)
    np.testing.assert_array_equal(fine.triangle_uvs, split.subdivide_midpoint(2).triangle_uvs)
    assert fine.is_watertight()


def test_distances_and_curvatures_are_continuous_across_seams(device):
    ball = sphere()
    split = split_at_seams(ball, device)
    index_of = {tuple(p): k for k, p in enumerate(ball.vertices.tolist())}
    numbers = [index_of[tuple(p)] for p in split.vertices.tolist()]
    source = numbers.index(0)
    wanted = ball.compute_geodesic_distances([0])[numbers]
    np.testing.assert_allclose(split.compute_geodesic_distances([source]), wanted, rtol=1e-9)
    for result, known in zip(split.compute_vertex_curvature(), ball.compute_vertex_curvature(), strict=True):
        np.testing.assert_allclose(result, known[numbers], rtol=1e-6)


def test_deformations_preserve_seams(device):
    ball = moved(sphere(), FAR)
    split = split_at_seams(ball, device)
    low, high = (int(pick(split.vertices[:, 2])) for pick in (np.argmin, np.argmax))
    targets = split.vertices[[low, high]] + [[0, 0, 0], [0, 0, 0.3]]
    bent = split.deform_as_rigid_as_possible([low, high], targets, 5)
    handles = [int(np.flatnonzero((ball.vertices == split.vertices[v]).all(axis=1))[0]) for v in (low, high)]
    wanted = ball.deform_as_rigid_as_possible(handles, targets, 5)
    np.testing.assert_allclose(corners_of(bent), corners_of(wanted), rtol=0, atol=1e-5)


def test_coincident_vertices_get_one_position(device):
    split = split_at_seams(sphere(), device)
    positions, counts = np.unique(split.vertices, axis=0, return_counts=True)
    first, second = np.flatnonzero((split.vertices == positions[counts > 1][0]).all(axis=1))[:2].tolist()
    target = split.vertices[first] + 0.1
    once = split.deform_as_rigid_as_possible([first], [target], 2)
    twice = split.deform_as_rigid_as_possible([first, second], [target, target], 2)
    np.testing.assert_array_equal(once.vertices, twice.vertices)
    with pytest.raises(ValueError, match=f"vertices {first} and {second} coincide at a seam"):
        split.deform_as_rigid_as_possible([first, second], [target, target + 1], 2)


def test_touching_solids_are_smoothed_separately(device):
    """Closed components have no boundary, so none of their edges is a seam."""
    changed = SIDE_BY_SIDE.to(device).filter_smooth_simple(2)
    alone = TriangleMesh.create_box().filter_smooth_simple(2)
    np.testing.assert_array_equal(changed.vertices[:8], alone.vertices)
