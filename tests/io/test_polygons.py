"""Faces with more than three corners: triangles cover each face once, for any shape and format."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.io.triangulation import clip_ears, split_faces

# A house with an inverted roof: the fourth of five corners is concave; the fan from corner 3 has flipped triangles.
CONCAVE = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]], float)
STAR = np.array([[np.sin(a), np.cos(a), 0] for a in np.arange(5) * 4 * np.pi / 5])
BOW_TIE = np.array([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], float)
# A square with a square hole, joined by an edge that is traversed in both directions.
RING = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [0, 0], [1, 1], [1, 3], [3, 3], [3, 1], [1, 1]], float)


def triangles_of(points, lengths=None):
    lengths = np.array([len(points)] if lengths is None else lengths)
    return split_faces("m.ply", lengths, np.arange(lengths.sum()), np.asarray(points))


def areas(points, triangles):
    a, b, c = (points[triangles[:, k], :2] for k in range(3))
    return np.cross(np.c_[b - a, np.zeros(len(a))], np.c_[c - a, np.zeros(len(a))])[:, 2] / 2


def write(path, points, faces):
    rows = "".join(f"{x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in points)
    lists = "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces)
    if path.suffix == ".ply":
        scalars = "".join(f"property double {name}\n" for name in "xyz")
        path.write_text(
            f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n{scalars}element face {len(faces)}\n"
            f"property list uchar int vertex_indices\nend_header\n{rows}{lists}"
        )
    elif path.suffix == ".off":
        path.write_text(f"OFF\n{len(points)} {len(faces)} 0\n{rows}{lists}")
    else:
        corners = "".join(f"f {' '.join(str(k + 1) for k in face)}\n" for face in faces)
        path.write_text("".join(f"v {row}\n" for row in rows.splitlines()) + corners)


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply"])
@pytest.mark.parametrize("start", range(5))
def test_a_concave_polygon_is_covered_once_in_every_format(tmp_path, suffix, start):
    path = tmp_path / f"m{suffix}"
    write(path, CONCAVE, [np.roll(np.arange(5), -start)])
    mesh = loom.read_triangle_mesh(path)
    triangle_areas = areas(mesh.vertices, mesh.triangles)
    assert triangle_areas.min() > 0
    assert triangle_areas.sum() == 10  # the fan around corner 2 has 22
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[0, 0, 1]] * 3)


@pytest.mark.parametrize("count", [4, 5, 6, 9, 40])
def test_faces_with_a_consistent_fan_stay_fans(count):
    angles = np.arange(count) * 2 * np.pi / count
    points = np.c_[np.cos(angles), np.sin(angles), np.ones(count)]
    points[1, :2] *= 0.999
    expected = np.c_[np.zeros(count - 2), np.arange(1, count - 1), np.arange(2, count)]
    np.testing.assert_array_equal(triangles_of(points), expected)


def test_a_bent_quad_is_parted_along_its_shorter_diagonal_and_a_flat_one_is_not():
    for height, diagonal in ((0.5, [1, 3]), (-0.5, [1, 3]), (0, [0, 2])):
        quad = np.array([[-2, 0, height], [0, -1, 0], [2, 0, height], [0, 1, 0]])
        first, second = triangles_of(quad)
        assert sorted(set(first) & set(second)) == diagonal and areas(quad, np.array([first, second])).sum() == 4


def test_texture_coordinates_and_values_of_faces_follow_their_triangles(tmp_path):
    corners = "".join(f"v {x} {y} {z}\nvt {x / 4} {y / 4}\n" for x, y, z in np.roll(CONCAVE, -2, axis=0))
    (tmp_path / "m.obj").write_text(corners + "f 1/1 2/2 3/3 4/4 5/5\n")
    mesh = loom.read_triangle_mesh(tmp_path / "m.obj")
    np.testing.assert_array_equal(mesh.triangle_uvs, mesh.vertices[mesh.triangles.reshape(-1), :2] / 4)


def test_holes_spikes_repeated_and_straight_corners_are_supported():
    for flat, area in (
        (RING, 12),
        ([[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [0, 2]], 4),
        ([[0, 0], [0, 0], [2, 0], [2, 2], [1, 0.5], [1, 0.5], [0, 2]], 2.5),
        ([[0, 0], [2, 0], [2, 2], [1, 1], [1, 3], [1, 1], [0, 2]], 3),
    ):
        points = np.c_[np.array(flat, float), np.zeros(len(flat))]
        for start in range(len(points)):
            rotated = np.roll(points, -start, axis=0)
            triangle_areas = areas(rotated, triangles_of(rotated))
            assert len(triangle_areas) == len(points) - 2 and triangle_areas.min() >= 0
            assert triangle_areas.sum() == pytest.approx(area, rel=1e-14)


@pytest.mark.parametrize("points", [STAR, BOW_TIE])
def test_self_intersecting_face_stays_a_fan_with_a_warning(points):
    with pytest.warns(UserWarning, match=r"m\.ply:.*2.*1"):
        triangles = triangles_of(np.r_[CONCAVE, points, points], [5, len(points), len(points)])
    fan = [[0, k, k + 1] for k in range(1, len(points) - 1)]
    np.testing.assert_array_equal(triangles[3:], np.r_[np.add(5, fan), np.add(5 + len(points), fan)])


@pytest.mark.parametrize("points", [np.zeros((4, 3)), np.outer(np.arange(6), [1, 2, 3.0]), np.full((5, 3), np.nan)])
def test_face_without_area_or_finite_vertices_stays_a_fan(points):
    triangles = triangles_of(points)
    np.testing.assert_array_equal(triangles, [[0, k, k + 1] for k in range(1, len(points) - 1)])


@pytest.mark.parametrize("scale", [1e-30, 1, 1e30, 1e90])
def test_scale_and_translation_change_no_triangle(scale):
    expected = triangles_of(np.roll(CONCAVE, -2, axis=0))
    np.testing.assert_array_equal(triangles_of(np.roll(CONCAVE, -2, axis=0) * scale), expected)
    moved = np.roll(CONCAVE, -2, axis=0) + np.array([4e5, 5e6, 100])
    np.testing.assert_array_equal(triangles_of(moved), expected)


@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(st.integers(5, 30), st.integers(0, 10**6))
def test_any_outline_is_covered_once(count, seed):
    rng = np.random.default_rng(seed)
    angles = np.sort(rng.random(count)) * 2 * np.pi
    outline = np.c_[np.cos(angles), np.sin(angles)] * rng.uniform(0.1, 1, (count, 1))
    outline = np.roll(outline, rng.integers(count), axis=0)
    triangles, good = clip_ears(outline[None, :, 0], outline[None, :, 1])
    x, y = outline.T
    area = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
    if np.diff(angles, append=angles[0] + 2 * np.pi).max() < np.pi:  # the middle is inside: no edges cross
        assert good.all()
        parts = areas(np.c_[outline, np.zeros(count)], triangles[0])
        assert parts.min() >= -1e-15 and parts.sum() == pytest.approx(area, rel=1e-12)
