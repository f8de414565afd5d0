"""Boxes equal to Open3D's, minimal boxes against fine searches, degenerate clouds; and sets of lines."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload

from .any_cloud import clouds, examples, parts
from .open3d_clouds import cloud_of

ROTATION = np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]])
MAKERS = ("get_oriented_bounding_box", "get_minimal_oriented_bounding_box")


def random_rotation(rng):
    Q, R = np.linalg.qr(rng.normal(size=(3, 3)))
    Q = Q * np.sign(np.diag(R))
    return Q * np.sign(np.linalg.det(Q))


def assert_same_box(actual, expected, limit):
    """Check that two boxes are equal up to the signs of their axes."""
    np.testing.assert_allclose(actual.center, expected.center, rtol=0, atol=limit)
    np.testing.assert_allclose(actual.extent, expected.extent, rtol=0, atol=limit)
    assert np.abs(np.abs(np.einsum("ij,ij->j", actual.R, expected.R)) - 1).max() < 1e-12
    assert np.linalg.det(actual.R) > 0


def open3d_boxes(o3d, clouds):
    """Volume of Open3D's smallest box of each cloud, and whether it contains the cloud."""
    results = []
    for points in clouds:
        vectors = o3d.utility.Vector3dVector(np.array(points))
        box = cloud_of(o3d, points).get_minimal_oriented_bounding_box()
        wider = o3d.geometry.OrientedBoundingBox(box.center, box.R, box.extent * (1 + 1e-6) + 1e-9)
        results.append((box.volume(), len(wider.get_point_indices_within_bounding_box(vectors)) == len(points)))
    return results


def open3d_principal(o3d, points):
    box = cloud_of(o3d, points).get_oriented_bounding_box()
    return box.center, box.extent, box.R


def test_the_principal_box_of_a_cloud_is_open3ds(device, rng, oracle, tolerances):
    points = (rng.normal(size=(500, 3)) * [3, 2, 1] @ ROTATION).astype(np.float32).astype(float)
    cloud = loom.PointCloud(points, device=device)
    expected = oracle("pcd/boxes/principal", open3d_principal, points)
    box, names = cloud.get_oriented_bounding_box(), ("center", "extent", "R")
    theirs = SimpleNamespace(**dict(zip(names, expected, strict=True)))
    assert_same_box(box, theirs, tolerances.box_fraction * np.ptp(points))
    assert len(cloud.crop(box)) == len(cloud)
    assert cloud.get_minimal_oriented_bounding_box().volume() <= box.volume()


def made_shapes(rng):
    """Small clouds, a ball, flat and solid shapes."""
    ball = rng.normal(size=(150, 3))
    clouds = [rng.normal(size=(n, 3)) for n in (4, 5, 5, 6, 7, 8, 9)]
    clouds += [rng.normal(size=(n, 3)) * [3, 2, 1] for n in (30, 100)]
    clouds += [ball / np.linalg.norm(ball, axis=1, keepdims=True), rng.random((60, 3)) * [50, 50, 1]]
    clouds += [np.indices((3, 3, 3)).reshape(3, -1).T @ ROTATION, np.concatenate([np.eye(3), -np.eye(3)])]
    clouds += [np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]]) @ ROTATION]
    clouds += [np.array([[np.cos(a), np.sin(a), z] for a in np.arange(7) for z in (0, 0.5)]) @ ROTATION]
    return [points.astype(np.float32).astype(float) for points in clouds]


def test_the_smallest_box_of_a_shape_is_no_larger_than_open3ds(device, rng, oracle, tolerances):
    """If Open3D's axes are not orthogonal, it falls back to x, y, z and a box that does not contain all points."""
    clouds = made_shapes(rng)
    expected = oracle("pcd/boxes/smallest", open3d_boxes, clouds)
    assert sum(contains_all for _, contains_all in expected) >= len(clouds) - 2
    for points, (volume, contains_all) in zip(clouds, expected, strict=True):
        cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
        box = cloud.get_minimal_oriented_bounding_box()
        assert len(cloud.crop(box)) == len(cloud)
        assert not contains_all or box.volume() <= volume * (1 + tolerances.box_volume)


@pytest.mark.slow
def test_no_frame_of_a_fine_search_gives_a_smaller_box(device, rng, tolerances):
    """200,000 frames, then shrinking steps from the best of them, for each cloud."""
    frames = np.stack([random_rotation(rng) for _ in range(2000)])
    small = np.stack([random_rotation(rng) for _ in range(100)])
    frames = (frames[:, None] @ small[None]).reshape(-1, 3, 3)
    for count in (4, 6, 10, 40):
        points = rng.normal(size=(count, 3)).astype(np.float32).astype(float)
        box = loom.PointCloud(points, device=device, origin=np.zeros(3)).get_minimal_oriented_bounding_box()

        def volumes(rotations, points=points):
            return np.ptp(np.einsum("nj,fjk->fnk", points, rotations), axis=1).prod(axis=1)

        box_volumes = volumes(frames)
        best, frame = box_volumes.min(), frames[box_volumes.argmin()]
        for scale in 0.5 ** np.arange(1, 22):
            axes = rng.normal(size=(200, 3)) * scale * 0.2
            K = np.zeros((200, 3, 3))
            K[:, 0, 1], K[:, 0, 2], K[:, 1, 2] = axes.T
            steps, _ = np.linalg.qr(np.eye(3) + K - K.transpose(0, 2, 1))
            box_volumes = volumes(frame @ steps)
            if box_volumes.min() < best:
                best, frame = box_volumes.min(), frame @ steps[box_volumes.argmin()]
        assert box.volume() <= best * (1 + tolerances.box_volume)
        assert best < box.volume() * 1.02, "the search finds nearly the same box"


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("rotation", [np.eye(3), ROTATION], ids=["aligned", "turned"])
def test_boxes_of_degenerate_clouds_are_flat(device, maker, rotation):
    """Open3D raises a Qhull error for each of them."""
    square = np.array([[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0], [1, 1, 0]], float)
    clouds = {"plane": (square, [0, 2, 4]), "triangle": (square[:3], None), "line": (square[:2], [0, 0, 4])}
    clouds |= {"point": (square[:1] + 3, [0, 0, 0]), "equal": (np.ones((9, 3)), [0, 0, 0])}
    for name, (points, extents) in clouds.items():
        points = points @ rotation.T
        cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
        box = getattr(cloud, maker)()
        assert np.sort(box.extent)[0] < 2e-6 and len(cloud.crop(box)) == len(points), name
        if extents is not None:
            np.testing.assert_allclose(np.sort(box.extent), extents, atol=2e-6, err_msg=name)


def test_smallest_box_of_planar_points_has_minimal_area(device, rng):
    flat = rng.normal(size=(300, 2))
    points = np.column_stack([flat, np.full(300, 2.0)])
    box = loom.PointCloud(points, device=device).get_minimal_oriented_bounding_box()
    angles = np.linspace(0, np.pi / 2, 5_001)
    across = np.ptp(np.outer(np.cos(angles), flat[:, 0]) + np.outer(np.sin(angles), flat[:, 1]), axis=1)
    along = np.ptp(np.outer(-np.sin(angles), flat[:, 0]) + np.outer(np.cos(angles), flat[:, 1]), axis=1)
    assert np.sort(box.extent)[0] < 1e-6
    assert np.sort(box.extent)[1:].prod() == pytest.approx((across * along).min(), rel=1e-3)
    assert np.sort(box.extent)[1:].prod() <= (across * along).min() * (1 + 1e-6)


@pytest.mark.parametrize("maker", MAKERS)
def test_cloud_without_finite_points_has_no_oriented_box(device, maker):
    for points in (np.zeros((0, 3)), [[np.nan, 0, 0], [np.inf, 0, 0]]):
        cloud = loom.PointCloud(points, device=device)
        with pytest.raises(ValueError, match="points:"):
            getattr(cloud, maker)()
        aligned = cloud.get_axis_aligned_bounding_box()
        assert aligned == loom.AxisAlignedBoundingBox([0] * 3, [0] * 3) and aligned.is_empty()


@example(points=np.array([(0.0, 1 / 128, 0.5), (1.0, 0.5, 0.0)]), gap=30)  # a slanted segment, ends at 1e-17 across it
@given(points=clouds(parts(2, 2), parts(128, 512), min_size=1, max_size=12), gap=st.integers(1, 30))
@examples(25)
def test_boxes_contain_their_points_and_the_smallest_is_smallest(device, points, gap):
    points = points.copy()
    if gap < len(points):
        points[gap, gap % 3] = np.nan
    cloud = loom.PointCloud(points, device=device)
    finite = int(np.isfinite(points).all(axis=1).sum())
    aligned = cloud.get_axis_aligned_bounding_box()
    principal, smallest = (getattr(cloud, maker)() for maker in MAKERS)
    for box in (aligned, principal, smallest):
        assert len(cloud.crop(box)) == finite
        assert len(box.get_point_indices_within_bounding_box(cloud)) == finite
    assert smallest.volume() <= min(aligned.volume(), principal.volume()) * (1 + 1e-9) + 1e-9


def test_joggling_changes_little(device, rng):
    cloud = loom.PointCloud(rng.normal(size=(300, 3)), device=device)
    for maker in MAKERS:
        plain, joggled = getattr(cloud, maker)(), getattr(cloud, maker)(robust=True)
        assert joggled.volume() == pytest.approx(plain.volume(), rel=1e-6)


LOW, HIGH, MIDDLE = [0.5, 1, 2], [3, 5, 8.25], [1, 2, 3]
MOVES = {"translate": ([1, 2, 3],), "translate there": ([1, 2, 3], False), "scale": (2.5, [1, 0, -1])}
MOVES["rotate"] = ROTATION, [1, 0, -1]


def pair(library):
    """An axis-aligned and an oriented box of Open3D or pointloom."""
    turned = library.OrientedBoundingBox(MIDDLE, ROTATION, [2, 4, 6])
    return {"aligned": library.AxisAlignedBoundingBox(LOW, HIGH), "turned": turned}


def open3d_measures(o3d, kind):
    """Open3D's measures and corners of a box, and its corners after each transformation."""
    box = pair(o3d.geometry)[kind]
    names = ("get_center", "get_min_bound", "get_max_bound", "volume", "is_empty")
    measures = {name: np.asarray(getattr(box, name)()) for name in names}
    measures["get_extent"] = np.asarray(box.get_extent() if kind == "aligned" else box.extent)
    measures["get_box_points"] = np.asarray(box.get_box_points())
    moved = {"bounds": np.asarray(box.get_axis_aligned_bounding_box().get_box_points())}
    for name, arguments in MOVES.items():
        box = pair(o3d.geometry)[kind]
        if kind == "aligned" and name == "rotate":  # rejected by Open3D
            box = o3d.geometry.OrientedBoundingBox.create_from_axis_aligned_bounding_box(box)
        moved[name] = np.asarray(getattr(box, name.split()[0])(*arguments).get_box_points())
    return measures, moved, pair(o3d.geometry)["aligned"].get_print_info()


@pytest.mark.parametrize("kind", ["aligned", "turned"])
def test_measures_and_moves_of_a_box_are_open3ds(kind, oracle):
    measures, moved, info = oracle(f"pcd/boxes/{kind}", open3d_measures, kind)
    box = pair(loom)[kind]
    assert box.color.tolist() == ([1, 1, 1] if kind == "aligned" else [0, 0, 0]), "Open3D leaves the latter undefined"
    box.color = (1, 0, 0)
    for name, expected in measures.items():
        np.testing.assert_allclose(getattr(box, name)(), expected, rtol=1e-14, atol=1e-14)
    extent, before = measures["get_extent"], box.get_box_points()
    np.testing.assert_array_equal(box.get_half_extent(), extent / 2)
    assert box.get_max_extent() == extent.max() and (kind != "aligned" or box.get_print_info() == info)
    corners = box.get_axis_aligned_bounding_box().get_box_points()
    np.testing.assert_allclose(corners, moved["bounds"], rtol=1e-14, atol=1e-14)
    for name, arguments in MOVES.items():
        there = getattr(box, name.split()[0])(*arguments)
        np.testing.assert_allclose(there.get_box_points(), moved[name], rtol=1e-14, atol=1e-14)
        assert there.color.tolist() == [1, 0, 0]
        np.testing.assert_array_equal(box.get_box_points(), before)
    np.testing.assert_allclose(box.rotate(ROTATION).get_center(), box.get_center())
    for wrong in ((1, 0), (2, 0, 0), (np.nan, 0, 0)):
        with pytest.raises(ValueError, match="color"):
            box.color = wrong


def open3d_sums(o3d, bounds):
    sums = []
    for a in bounds:
        for b in bounds:
            total = o3d.geometry.AxisAlignedBoundingBox(*a)
            total += o3d.geometry.AxisAlignedBoundingBox(*b)
            sums.append((np.asarray(total.min_bound), np.asarray(total.max_bound)))
    return sums


def test_sums_of_boxes_are_open3ds(oracle):
    bounds = [([0, 1, 2], [3, 5, 8]), ([10, 10, 10], [11, 11, 11]), ([50, 50, 50], [50, 51, 51]), ([0] * 3, [0] * 3)]
    boxes = [loom.AxisAlignedBoundingBox(*a) for a in bounds]
    sums = [a + b for a in boxes for b in boxes]
    expected = oracle("pcd/boxes/sums", open3d_sums, bounds)
    assert sums == [loom.AxisAlignedBoundingBox(*ends) for ends in expected]


def test_boxes_of_points_equal_boxes_of_their_cloud(rng, tolerances):
    points = (rng.normal(size=(400, 3)) * [3, 2, 1]).astype(np.float32).astype(float)
    points[7] = np.nan
    cloud = loom.PointCloud(points, origin=np.zeros(3))
    assert loom.AxisAlignedBoundingBox.create_from_points(points) == cloud.get_axis_aligned_bounding_box()
    assert loom.AxisAlignedBoundingBox.create_from_points([]).is_empty()
    made = loom.OrientedBoundingBox.create_from_points(points)
    assert_same_box(made, cloud.get_oriented_bounding_box(), 100 * tolerances.box_fraction)
    smallest = loom.OrientedBoundingBox.create_from_points_minimal(points)
    assert smallest.volume() == pytest.approx(cloud.get_minimal_oriented_bounding_box().volume())
    known = loom.OrientedBoundingBox([500, -20, 3], ROTATION, [5, 3, 2])
    inside = (rng.random((50, 3)) - 0.5) * [5, 3, 2] @ ROTATION.T + [500, -20, 3]
    smallest = loom.OrientedBoundingBox.create_from_points_minimal(np.vstack([known.get_box_points(), inside]))
    np.testing.assert_allclose(smallest.center, [500, -20, 3], atol=1e-4)
    np.testing.assert_allclose(np.sort(smallest.extent), [2, 3, 5], atol=1e-4)
    sides = np.abs(smallest.R.T @ ROTATION)[np.argsort(-smallest.extent)]
    np.testing.assert_allclose(sides, np.eye(3), atol=1e-4)
    oriented = loom.OrientedBoundingBox.create_from_axis_aligned_bounding_box(cloud.get_axis_aligned_bounding_box())
    np.testing.assert_array_equal(oriented.R, np.eye(3))


def test_masks_of_boxes_are_those_of_numpy(device, rng):
    points, origin = rng.uniform(-4, 4, (500, 3)).astype(np.float32), np.array([100.0, -50, 7])
    for R in (np.eye(3), ROTATION):
        box = loom.OrientedBoundingBox(origin + np.array([1, 0, -1]), R, [5, 4, 3])
        expected = (np.abs((points - [1, 0, -1]) @ R) <= [2.5, 2, 1.5]).all(axis=1)
        assert 20 < expected.sum() < 200
        boxes = [box] if R is ROTATION else [box, loom.AxisAlignedBoundingBox(box.get_min_bound(), box.get_max_bound())]
        for each in boxes:
            mask = each.mask_points(upload(points, vec3, device), origin)
            np.testing.assert_array_equal(download(mask) != 0, expected)


def test_boxes_compare_by_value_and_show_it():
    aligned, oriented = pair(loom).values()
    assert aligned == pair(loom)["aligned"] and oriented == pair(loom)["turned"] and aligned != oriented
    assert aligned != aligned.translate([0, 0, 1]) and oriented != oriented.scale(2, [0, 0, 0])
    assert repr(aligned) == "AxisAlignedBoundingBox([0.5, 1.0, 2.0], [3.0, 5.0, 8.25])"
    assert repr(oriented).startswith("OrientedBoundingBox([1.0, 2.0, 3.0], [[0.8,")
    # six digits of its size, independent of its position
    far = loom.AxisAlignedBoundingBox([500_000 + 1 / 3, 1 / 3, -1e-9], [500_002, 2 / 3, 0.1])
    assert repr(far) == "AxisAlignedBoundingBox([500000.333333, 0.333333, 0.0], [500002.0, 0.666667, 0.1])"
    small = loom.AxisAlignedBoundingBox([1e-5 / 3] * 3, [1e-5] * 3)
    assert repr(small) == f"AxisAlignedBoundingBox({[3.333333e-06] * 3}, {[1e-05] * 3})"
    tilted = loom.OrientedBoundingBox([1 / 3] * 3, np.eye(3), [1000 / 3, 2, 1])
    assert repr(tilted).startswith("OrientedBoundingBox([0.3333, 0.3333, 0.3333], [[1.0, 0.0,")
    with pytest.raises(TypeError, match="unhashable"):
        hash(aligned)
    with pytest.raises(ValueError, match="read-only"):
        aligned.min_bound[0] = 99


MOTION = Rotation.from_euler("XYZ", (0.3, -0.5, 1.1)).as_matrix()


def rows_of(lines):
    """The end points of each line of an Open3D or pointloom line set, shape [m, 2, 3]."""
    return np.asarray(lines.points)[np.asarray(lines.lines)]


K = np.array([[500.0, 0, 320], [0, 510, 250], [0, 0, 1]])
EXTRINSIC = np.eye(4)
EXTRINSIC[:3, :3], EXTRINSIC[:3, 3] = MOTION, [0.5, -1, 2]


def open3d_lines(o3d, mesh):
    """End points of the lines of two boxes, of a camera and of a mesh, and the camera's colors."""
    lines, geometry = o3d.geometry.LineSet, o3d.geometry
    legacy = geometry.TriangleMesh(o3d.utility.Vector3dVector(mesh[0]), o3d.utility.Vector3iVector(mesh[1]))
    sets = [
        lines.create_from_axis_aligned_bounding_box(geometry.AxisAlignedBoundingBox([1, 2, 3], [2, 4, 7])),
        lines.create_from_oriented_bounding_box(geometry.OrientedBoundingBox([1, 2, 3], MOTION, [1, 2, 3])),
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
    result = loom.LineSet.create_from_oriented_bounding_box(loom.OrientedBoundingBox([1, 2, 3], MOTION, [1, 2, 3]))
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


def test_a_set_may_be_empty_and_the_sum_of_two_has_colors_if_both_have():
    lines = loom.LineSet(np.empty((0, 3)), np.empty((0, 2), int))
    assert len(lines) == 0 and lines.is_empty() and not lines.has_colors
    np.testing.assert_array_equal(lines.get_center(), 0)


def test_the_center_of_many_lines_far_from_the_origin_is_exact(rng):
    points = rng.random((100_000, 3)) + np.array([5e5, 5.4e6, 0])
    center = [math.fsum(axis) / len(points) for axis in points.T]
    np.testing.assert_allclose(loom.LineSet(points, [[0, 1]]).get_center(), center, rtol=0, atol=2e-9)
    plain = loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]])
    red = plain.paint_uniform_color([1, 0, 0])
    both = red + red
    assert both.lines.tolist() == [[0, 1], [2, 3]] and both.colors.tolist() == [[1, 0, 0]] * 2
    assert (red + plain).colors is None and len((plain + plain).points) == 4


@pytest.mark.parametrize("pairs", [[[0.5, 1.7]], [[np.nan, 1]], np.array([[2**64 - 1, 0]], np.uint64), [[0, 3]]])
def test_pairs_of_lines_are_indices(pairs):
    cloud = loom.PointCloud(np.eye(3))
    with pytest.raises(ValueError, match="correspondences: expected"):
        loom.LineSet.create_from_point_cloud_correspondences(cloud, cloud, pairs)
    with pytest.raises(ValueError, match="lines: expected indices"):
        loom.LineSet(np.eye(3), pairs)
    with pytest.raises(ValueError, match="colors: expected"):
        loom.LineSet(np.eye(3), [[0, 1]], [[np.nan, 0, 0]])
