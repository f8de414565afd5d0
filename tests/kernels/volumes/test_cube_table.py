"""The table of marching cubes closes every surface, faces the right way, and puts no inner side into a face."""

from functools import cache

import numpy as np
import pytest

from pointloom.kernels.volumes import cube_table
from pointloom.kernels.volumes.cube_table import EDGE_AXIS, EDGE_CORNER, FACE_CORNERS, TRIANGLE_COUNT, TRIANGLE_EDGES

CORNERS = np.array([[c & 1, c >> 1 & 1, c >> 2 & 1] for c in range(8)])
MIDPOINTS = CORNERS[EDGE_CORNER] + 0.5 * np.eye(3)[EDGE_AXIS]
EDGE_ENDS = np.stack([EDGE_CORNER, EDGE_CORNER | (1 << EDGE_AXIS)], axis=1)
CASES = range(256)


def triangles(case: int) -> np.ndarray:
    return TRIANGLE_EDGES.reshape(256, -1)[case, : 3 * TRIANGLE_COUNT[case]].reshape(-1, 3)


def directed_sides(case: int) -> list[tuple[int, int]]:
    return [(int(t[k]), int(t[(k + 1) % 3])) for t in triangles(case) for k in range(3)]


@cache
def boundary(case: int) -> set[tuple[int, int]]:
    sides = directed_sides(case)
    return {(a, b) for a, b in sides if (b, a) not in sides}


@cache
def faces_of(edge: int) -> set[int]:
    return {f for f, face in enumerate(FACE_CORNERS) if set(EDGE_ENDS[edge]) <= set(face)}


def crossing_edges(case: int) -> set[int]:
    return {e for e, (a, b) in enumerate(EDGE_ENDS) if (case >> a & 1) != (case >> b & 1)}


def test_the_triangles_of_a_case_use_all_its_crossing_edges_and_no_others():
    for case in CASES:
        assert set(triangles(case).ravel().tolist()) == crossing_edges(case)


def test_inner_sides_of_a_case_have_opposites_and_the_rest_are_on_faces():
    for case in CASES:
        sides, outer = directed_sides(case), boundary(case)
        assert len(set(sides)) == len(sides) and all(len(faces_of(a) & faces_of(b)) == 1 for a, b in outer)
        for a, b in set(sides) - outer:
            assert not faces_of(a) & faces_of(b), "a diagonal in a face could be the neighbor's too"


@pytest.mark.parametrize("axis", range(3))
def test_neighboring_cells_draw_the_same_contour_on_their_common_face_in_opposite_directions(axis):
    low, high = FACE_CORNERS[2 * axis], FACE_CORNERS[2 * axis + 1]

    def contours(face, drop):
        by_signs = {}
        for case in CASES:
            signs = tuple(case >> c & 1 for c in sorted(face))
            on_face = {(a, b) for a, b in boundary(case) if faces_of(a) & faces_of(b) == {FACE_CORNERS.index(face)}}
            directed = on_face if face is high else [segment[::-1] for segment in on_face]
            ends = {tuple(tuple(np.delete(MIDPOINTS[e], drop)) for e in segment) for segment in directed}
            by_signs.setdefault(signs, set()).add(frozenset(ends))
        return by_signs

    upper, lower = contours(high, axis), contours(low, axis)
    assert upper == lower
    assert len(upper) == 16
    assert all(len(choices) == 1 for choices in upper.values())  # the face's own signs decide, so all 256 x 256 agree


def test_normals_point_from_inside_to_outside():
    """The boundary runs with the inside on its left as seen from inside the cell, face by face."""
    for case in CASES:
        for a, b in boundary(case):
            (face,) = faces_of(a) & faces_of(b)
            inward = np.array([0.5, 0.5, 0.5]) - CORNERS[FACE_CORNERS[face]].mean(axis=0)
            left = np.cross(inward, MIDPOINTS[b] - MIDPOINTS[a])
            for edge in (a, b):
                inside = next(c for c in EDGE_ENDS[edge] if case >> c & 1)
                assert left @ (CORNERS[inside] - (MIDPOINTS[a] + MIDPOINTS[b]) / 2) > -1e-12
    for k, corner in enumerate(CORNERS):
        p = MIDPOINTS[triangles(1 << k)[0]]
        assert np.cross(p[1] - p[0], p[2] - p[0]) @ (p[0] - corner) > 0


def test_an_ambiguous_face_cuts_off_each_inside_corner():
    for case in CASES:
        for f, face in enumerate(FACE_CORNERS):
            if [case >> c & 1 for c in face] in ([0, 1, 0, 1], [1, 0, 1, 0]):
                on_face = [(a, b) for a, b in boundary(case) if faces_of(a) & faces_of(b) == {f}]
                assert len(on_face) == 2
                for a, b in on_face:
                    (shared,) = set(EDGE_ENDS[a]) & set(EDGE_ENDS[b])
                    assert case >> int(shared) & 1


def test_the_tables_are_uploaded_once_a_device():
    tables = cube_table.device_tables("cpu")
    assert cube_table.device_tables("cpu") is tables
    assert (tables.triangle_edges.numpy() == TRIANGLE_EDGES).all()
