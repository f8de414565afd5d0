"""Line sets: construction, boxes and cameras as in Open3D, and rejected arguments."""

import numpy as np
from scipy.spatial.transform import Rotation

import pointloom as loom

ROTATION = Rotation.from_euler("XYZ", (0.3, -0.5, 1.1)).as_matrix()


def rows_of(lines):
    """The end points of each line of an Open3D or pointloom line set, shape [m, 2, 3]."""
    return np.asarray(lines.points)[np.asarray(lines.lines)]


K = np.array([[500.0, 0, 320], [0, 510, 250], [0, 0, 1]])
EXTRINSIC = np.eye(4)
EXTRINSIC[:3, :3], EXTRINSIC[:3, 3] = ROTATION, [0.5, -1, 2]


def open3d_lines(o3d, mesh):
    """End points of the lines of two boxes, of a camera and of a mesh, and the camera's colors."""
    lines, geometry = o3d.geometry.LineSet, o3d.geometry
    legacy = geometry.TriangleMesh(o3d.utility.Vector3dVector(mesh[0]), o3d.utility.Vector3iVector(mesh[1]))
    sets = [
        lines.create_from_axis_aligned_bounding_box(geometry.AxisAlignedBoundingBox([1, 2, 3], [2, 4, 7])),
        lines.create_from_oriented_bounding_box(geometry.OrientedBoundingBox([1, 2, 3], ROTATION, [1, 2, 3])),
        lines.create_camera_visualization(640, 480, K, EXTRINSIC, 0.2),
    ]
    edges = np.asarray(lines.create_from_triangle_mesh(legacy).lines)
    return [rows_of(made) for made in sets], np.asarray(sets[2].colors), edges


def test_lines_of_boxes_cameras_and_meshes_are_open3ds(oracle):
    mesh = loom.TriangleMesh.create_icosahedron()
    arrays = mesh.vertices.copy(), np.array(mesh.triangles, np.int32)
    (aligned, oriented, frustum), colors, edges = oracle("pcd/line_set/made", open3d_lines, arrays)
    box = loom.AxisAlignedBoundingBox([1, 2, 3], [2, 4, 7])
    box.color = [1, 0, 0]
    result = loom.LineSet.create_from_axis_aligned_bounding_box(box)
    np.testing.assert_array_equal(rows_of(result), aligned)
    assert result.colors is not None and (result.colors == [1, 0, 0]).all()
    result = loom.LineSet.create_from_oriented_bounding_box(loom.OrientedBoundingBox([1, 2, 3], ROTATION, [1, 2, 3]))
    np.testing.assert_allclose(rows_of(result), oriented, atol=1e-14)
    camera = loom.PinholeCameraIntrinsic(640, 480, 500.0, 510.0, 320.0, 250.0)
    result = loom.LineSet.create_camera_visualization(camera, EXTRINSIC, 0.2)
    np.testing.assert_allclose(rows_of(result), frustum, atol=1e-12)
    np.testing.assert_array_equal(result.colors, colors)
    result = loom.LineSet.create_from_triangle_mesh(mesh)
    assert len(result) == 30
    assert {tuple(row) for row in result.lines.tolist()} == {tuple(sorted(row)) for row in edges.tolist()}


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


def test_two_sets_are_one_and_colors_stay_where_both_have_some():
    plain = loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]])
    red = plain.paint_uniform_color([1, 0, 0])
    both = red + red
    assert both.lines.tolist() == [[0, 1], [2, 3]] and both.colors.tolist() == [[1, 0, 0]] * 2
    assert (red + plain).colors is None and len((plain + plain).points) == 4
