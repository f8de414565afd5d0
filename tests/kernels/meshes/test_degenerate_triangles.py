"""Triangles without area, triangles that name a vertex twice, and vertices that are not finite."""

import numpy as np
import pytest

from pointloom.kernels.lang import uint8, vec3, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes.clean_triangles import join_masks, mask_repeats
from pointloom.kernels.meshes.mesh_edges import MeshEdges, count_sharers
from pointloom.kernels.meshes.mesh_measures import measure
from pointloom.kernels.meshes.pseudonormals import volume_of_shell
from pointloom.kernels.meshes.sheets import OpenEdges

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.fixture
def put(device):
    return lambda values, kind: upload(np.asarray(values), kind, device)


def test_triangles_that_name_a_vertex_twice_repeat_their_rotations(put):
    triangles = [[1, 2, 1], [1, 1, 2], [2, 1, 1], [2, 2, 1], [3, 3, 3], [3, 3, 3], [0, 1, 2], [0, 2, 1]]
    assert download(mask_repeats(put(triangles, vec3i))).tolist() == [0, 1, 1, 0, 0, 1, 0, 0]


def test_a_triangle_that_has_an_edge_twice_counts_once(put):
    edges = MeshEdges(put([[0, 1, 0], [0, 1, 2]], vec3i), 3)
    numbers = map(download, (edges.lows, edges.highs, count_sharers(edges)))
    assert {(a, b): n for a, b, n in zip(*numbers, strict=True)} == {(0, 0): 1, (0, 1): 2, (1, 2): 1, (0, 2): 1}


def test_open_half_edges_without_length_belong_to_no_edge(put):
    edges = OpenEdges(put([[0, 1, 1], [0, 1, 2]], vec3i), 3, put([0, 1, 0, 1, 1, 1], uint8))
    assert edges.count == 3 and sorted(download(edges.half_edges)[: download(edges.starts)[3]]) == [3, 4, 5]


def test_masks_are_joined(put):
    joined = join_masks(put([1, 0, 0, 0], uint8), put([0, 1, 0, 0], uint8), put([0, 1, 1, 0], uint8))
    assert download(joined).tolist() == [1, 1, 1, 0]


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_triangle_with_a_corner_that_is_not_finite_adds_no_volume(put, bad):
    """The tetrahedron alone encloses a volume; with a bad triangle beside it, it still has it but encloses none."""
    corners, faces = np.vstack([CORNERS, [[bad, 0, 0]]]), np.vstack([FACES, [[4, 1, 2]]])
    assert measure(put(corners, vec3), put(faces, vec3i))[1] == pytest.approx(1 / 6)
    assert volume_of_shell(put(corners, vec3), put(faces, vec3i)) is None
    assert volume_of_shell(put(CORNERS, vec3), put(FACES, vec3i)) == pytest.approx(1 / 6)


def test_a_closed_mesh_without_area_encloses_no_volume(put):
    assert volume_of_shell(put(CORNERS * [1, 0, 0], vec3), put(FACES, vec3i)) is None
