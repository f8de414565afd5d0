"""Point clouds in memory, contents of files, and files of line sets."""

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d

V = o3d.utility.Vector3dVector


@pytest.fixture
def cloud(rng):
    made = o3d.geometry.PointCloud(V(rng.random((20, 3)).astype(np.float32)))
    made.normals = V(np.tile([0.0, 0.6, 0.8], (20, 1)))
    made.colors = V(rng.integers(0, 256, (20, 3)) / 255)
    return made


@pytest.mark.parametrize("format", ["ply", "pcd", "xyz", "xyzn", "xyzrgb", "pts"])
def test_a_cloud_is_read_from_its_bytes(cloud, format):
    data = o3d.io.write_point_cloud_to_bytes(cloud, f"mem::{format}")
    again = o3d.io.read_point_cloud_from_bytes(data, f"mem::{format}")
    np.testing.assert_allclose(again.points, cloud.points, atol=1e-9)
    if format in ("ply", "pcd", "xyzn"):
        np.testing.assert_allclose(again.normals, cloud.normals, atol=1e-6)
    if format in ("ply", "pcd", "xyzrgb"):
        np.testing.assert_allclose(again.colors, cloud.colors, atol=1e-6)


def test_points_as_text_have_ten_decimals():
    cloud = o3d.geometry.PointCloud(V([[1, 2, 3]]))
    assert o3d.io.write_point_cloud_to_bytes(cloud, "mem::xyz") == b"1.0000000000 2.0000000000 3.0000000000\n"
    for format in ("auto", "mem::las", "xyz"):
        with pytest.raises(ValueError, match="format:"):
            o3d.io.write_point_cloud_to_bytes(cloud, format)


def test_contents_are_found_by_suffix_and_by_the_header_of_a_ply(cloud, tmp_path):
    lines = o3d.geometry.LineSet(V(np.eye(3)), o3d.utility.Vector2iVector([[0, 1]]))
    o3d.io.write_line_set(tmp_path / "lines.ply", lines)
    o3d.io.write_triangle_mesh(tmp_path / "mesh.ply", o3d.geometry.TriangleMesh.create_box())
    o3d.io.write_point_cloud(tmp_path / "cloud.ply", cloud)
    kinds = {"lines.ply": 2, "mesh.ply": 4, "cloud.ply": 1, "a.stl": 5, "a.obj": 5, "a.pcd": 1, "a.xyz": 1, "a.jpg": 0}
    assert {name: int(o3d.io.read_file_geometry_type(tmp_path / name)) for name in kinds} == kinds
    assert o3d.io.read_file_geometry_type(str(tmp_path / "mesh.ply")) & o3d.io.CONTAINS_TRIANGLES
    assert o3d.io.FileGeometry.CONTAINS_POINTS == o3d.io.CONTAINS_POINTS != o3d.io.CONTENTS_UNKNOWN
    with pytest.raises(loom.FileError, match="none"):
        o3d.io.read_file_geometry_type(tmp_path / "none.ply")


@pytest.mark.parametrize("is_text", [False, True])
@pytest.mark.parametrize("is_colored", [False, True])
def test_line_sets_are_read_as_written(rng, tmp_path, is_text, is_colored):
    lines = o3d.geometry.LineSet(V(rng.random((5, 3)).astype(np.float32)), o3d.utility.Vector2iVector([[0, 4], [2, 1]]))
    if is_colored:
        lines.colors = V([[1, 0, 0.2], [0, 1, 0.4]])
    assert o3d.io.write_line_set(tmp_path / "lines.ply", lines, write_ascii=is_text)
    again = o3d.io.read_line_set(tmp_path / "lines.ply")
    np.testing.assert_array_equal(again.points, lines.points)
    np.testing.assert_array_equal(again.lines, lines.lines)
    assert again.has_colors() == is_colored
    np.testing.assert_allclose(again.colors, lines.colors, atol=1e-7)


def test_files_without_lines_are_reported(cloud, tmp_path):
    o3d.io.write_point_cloud(tmp_path / "cloud.ply", cloud)
    with pytest.raises(loom.FileError, match="edge"):
        o3d.io.read_line_set(tmp_path / "cloud.ply")
    with pytest.raises(ValueError, match="filename:"):
        o3d.io.read_line_set(tmp_path / "cloud.obj")
    with pytest.raises(TypeError, match="line_set:"):
        o3d.io.write_line_set(tmp_path / "lines.ply", cloud)
