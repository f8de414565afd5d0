"""Line sets: what they join, the boxes and cameras of Open3D, refusals."""

import numpy as np
import open3d as o3d
import pytest

import pointloom as loom

TURN = o3d.geometry.get_rotation_matrix_from_xyz([0.3, -0.5, 1.1])


def rows_of(lines):
    """The ends of each line, in Open3D's or our set, shape [m, 2, 3]."""
    return np.asarray(lines.points)[np.asarray(lines.lines)]


def test_boxes_have_the_edges_that_open3d_gives_them():
    box = loom.AxisAlignedBoundingBox([1, 2, 3], [2, 4, 7])
    box.color = [1, 0, 0]
    theirs = o3d.geometry.AxisAlignedBoundingBox([1, 2, 3], [2, 4, 7])
    ours = loom.LineSet.create_from_axis_aligned_bounding_box(box)
    expected = o3d.geometry.LineSet.create_from_axis_aligned_bounding_box(theirs)
    np.testing.assert_array_equal(rows_of(ours), rows_of(expected))
    assert ours.colors is not None and (ours.colors == [1, 0, 0]).all()


def test_turned_boxes_have_the_edges_that_open3d_gives_them():
    ours = loom.LineSet.create_from_oriented_bounding_box(loom.OrientedBoundingBox([1, 2, 3], TURN, [1, 2, 3]))
    theirs = o3d.geometry.OrientedBoundingBox([1, 2, 3], TURN, [1, 2, 3])
    expected = o3d.geometry.LineSet.create_from_oriented_bounding_box(theirs)
    np.testing.assert_allclose(rows_of(ours), rows_of(expected), atol=1e-14)


def test_a_camera_looks_as_open3d_draws_it():
    camera = loom.PinholeCameraIntrinsic(640, 480, 500.0, 510.0, 320.0, 250.0)
    extrinsic = np.eye(4)
    extrinsic[:3, :3], extrinsic[:3, 3] = TURN, [0.5, -1, 2]
    ours = loom.LineSet.create_camera_visualization(camera, extrinsic, 0.2)
    K = np.array([[500.0, 0, 320], [0, 510, 250], [0, 0, 1]])
    theirs = o3d.geometry.LineSet.create_camera_visualization(640, 480, K, extrinsic, 0.2)
    np.testing.assert_allclose(rows_of(ours), rows_of(theirs), atol=1e-12)
    np.testing.assert_array_equal(ours.colors, np.asarray(theirs.colors))


def test_a_mesh_has_each_edge_once():
    mesh = loom.TriangleMesh.create_icosahedron()
    lines = loom.LineSet.create_from_triangle_mesh(mesh)
    legacy = o3d.geometry.TriangleMesh(
        o3d.utility.Vector3dVector(mesh.vertices.copy()), o3d.utility.Vector3iVector(np.array(mesh.triangles, np.int32))
    )
    theirs = np.asarray(o3d.geometry.LineSet.create_from_triangle_mesh(legacy).lines)
    assert len(lines) == 30
    assert {tuple(row) for row in lines.lines.tolist()} == {tuple(sorted(row)) for row in theirs.tolist()}


def test_pairs_join_the_points_of_two_clouds():
    first, second = loom.PointCloud(np.eye(3)), loom.PointCloud(np.eye(3) + 5)
    lines = loom.LineSet.create_from_point_cloud_correspondences(first, second, [[2, 0], [0, 1]])
    np.testing.assert_allclose(rows_of(lines), [[[0, 0, 1], [6, 5, 5]], [[1, 0, 0], [5, 6, 5]]])


def test_motions_move_the_points_and_leave_the_set_as_it_was():
    lines = loom.LineSet([[0, 0, 0], [2, 0, 0]], [[0, 1]])
    T = np.eye(4)
    T[:3, 3] = [1, 2, 3]
    np.testing.assert_array_equal(lines.transform(T).points, [[1, 2, 3], [3, 2, 3]])
    np.testing.assert_array_equal(lines.translate([0, 0, 1], relative=False).points, [[-1, 0, 1], [1, 0, 1]])
    np.testing.assert_array_equal(lines.scale(2, [0, 0, 0]).points, [[0, 0, 0], [4, 0, 0]])
    np.testing.assert_array_equal(lines.points, [[0, 0, 0], [2, 0, 0]])


def test_a_set_may_be_empty():
    lines = loom.LineSet(np.empty((0, 3)), np.empty((0, 2), int))
    assert len(lines) == 0 and lines.is_empty() and not lines.has_colors
    np.testing.assert_array_equal(lines.get_center(), 0)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([[0, 2]], "expected indices of 2 points, got 0 to 2"),
        ([[-1, 0]], "got -1 to 0"),
        ([[0.5, 1]], "expected indices"),
    ],
)
def test_lines_between_points_that_do_not_exist_are_refused(lines, message):
    with pytest.raises(ValueError, match=message):
        loom.LineSet([[0, 0, 0], [1, 1, 1]], lines)


def test_points_that_are_not_finite_are_refused():
    with pytest.raises(ValueError, match="points: expected finite coordinates, got 1 points without"):
        loom.LineSet([[0, 0, 0], [np.nan, 1, 1]], [[0, 1]])


def test_two_sets_are_one_and_colours_stay_where_both_have_some():
    plain = loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]])
    red = plain.paint_uniform_color([1, 0, 0])
    both = red + red
    assert both.lines.tolist() == [[0, 1], [2, 3]] and both.colors.tolist() == [[1, 0, 0]] * 2
    assert (red + plain).colors is None and len((plain + plain).points) == 4
    with pytest.raises(TypeError):
        plain + red.points
