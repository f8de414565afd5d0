"""Drawn parts of each kind of geometry: names, styles, shared arrays, boxes, and rejected input."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.memory import download
from pointloom.visualization.render.geometries import (
    PALETTE,
    bounds_of,
    kind_of,
    named_geometries,
    outer_faces,
    parts_of,
)
from pointloom.visualization.render.parts import Lines, Points, Triangles
from pointloom.visualization.render.styles import Style

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
INTRINSIC = loom.PinholeCameraIntrinsic.prime_sense_default()


def volume():
    tsdf = loom.TSDFVolume(voxel_size=0.1)
    camera = loom.PinholeCameraIntrinsic(64, 48, 60, 60, 31.5, 23.5)
    tsdf.integrate(np.full((48, 64), 1.0, np.float32), camera, np.eye(4))
    return tsdf


KINDS = {
    "cloud": (lambda: loom.PointCloud(CUBE), [Points], (0, 1)),
    "mesh": (lambda: loom.TriangleMesh.create_box(1, 1, 1), [Triangles], (0, 1)),
    "voxels": (lambda: loom.TriangleMesh.create_box(1, 1, 1).voxelize(0.5), [Triangles], None),
    "box": (lambda: loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1]), [Lines], (0, 1)),
    "lines": (lambda: loom.LineSet(CUBE, [[0, 7]]), [Lines], (0, 1)),
    "trajectory": (lambda: loom.Trajectory(np.tile(np.eye(4), (3, 1, 1))), [Lines], (0, 0.1)),
    "hull": (lambda: loom.PointCloud(CUBE).compute_convex_hull()[0], [Lines], (0, 1)),
    "volume": (lambda: loom.SelectionPolygonVolume(CUBE[::2], "Z", axis_min=0, axis_max=1), [Lines], (0, 1)),
    "surface": (volume, [Triangles], None),
    "camera": (lambda: loom.CameraFrustum(INTRINSIC, np.eye(4)), [Lines], None),
    "points": (lambda: np.array(CUBE, np.float32), [Points], (0, 1)),
}


@pytest.mark.parametrize("name", KINDS)
def test_each_kind_has_its_name_parts_and_box(name, device):
    make, kinds, extent = KINDS[name]
    [(default_name, geometry, style)] = named_geometries(make())
    parts = parts_of(geometry, style, device)
    assert default_name == name == kind_of(geometry) and [type(part) for part in parts] == kinds
    assert all(str(part.positions.device) == str(device) for part in parts) or str(device) == "cpu"
    low, high = bounds_of(parts)
    assert low.dtype == np.float64 and (high >= low).all()
    if extent is not None:
        assert low == pytest.approx(extent[0]) and high == pytest.approx(extent[1])


def test_an_oriented_box_and_the_boxes_color_are_drawn():
    box = loom.OrientedBoundingBox([0, 0, 0], np.eye(3), [2, 2, 2])
    box.color = (0.2, 0.4, 0.6)
    [part] = parts_of(box)
    assert part.plain == (0.2, 0.4, 0.6) and part.indices.size == 24
    corners, edges = download(part.positions), download(part.indices).reshape(-1, 2)
    assert (np.abs(corners[edges[:, 0]] - corners[edges[:, 1]]).sum(axis=1) == 2).all()  # edges, and no diagonal
    assert len(np.unique(edges, axis=0)) == 12


def test_plain_objects_and_open3d_objects_are_accepted(o3d):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(CUBE, float)))
    ball = o3d.geometry.TriangleMesh.create_box()
    lines = o3d.geometry.LineSet.create_from_axis_aligned_bounding_box(cloud.get_axis_aligned_bounding_box())
    plain = SimpleNamespace(points=CUBE, colors=np.full((8, 3), 128, np.uint8), normals=None)
    shown = named_geometries([cloud, ball, lines, cloud.get_oriented_bounding_box(), plain])
    assert [name for name, _, _ in shown] == ["cloud", "mesh", "lines", "box", "cloud 2"]
    for _, geometry, style in shown:
        low, high = bounds_of(parts_of(geometry, style))
        assert low == pytest.approx(0, abs=1e-6) and high == pytest.approx(1, abs=1e-6)
    assert download(parts_of(plain)[0].colors)[0] == pytest.approx(128 / 255)


def test_open3d_tensor_geometries_are_drawn_like_legacy_ones(o3d):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(CUBE, float)))
    cloud.paint_uniform_color([0.2, 0.4, 0.6])
    mesh, box = o3d.geometry.TriangleMesh.create_box(), cloud.get_axis_aligned_bounding_box()
    lines = o3d.geometry.LineSet.create_from_axis_aligned_bounding_box(box)
    legacy = {"PointCloud": cloud, "TriangleMesh": mesh, "LineSet": lines, "AxisAlignedBoundingBox": box}
    tensors = [getattr(o3d.t.geometry, name).from_legacy(geometry) for name, geometry in legacy.items()]
    shown = named_geometries([*tensors, o3d.core.Tensor(np.array(CUBE, np.float32))])
    assert [name for name, _, _ in shown] == ["cloud", "mesh", "lines", "box", "points"]
    for _, geometry, style in shown:
        low, high = bounds_of(parts_of(geometry, style))
        assert low == pytest.approx(0, abs=1e-6) and high == pytest.approx(1, abs=1e-6)
    assert download(parts_of(shown[0][1])[0].colors)[0] == pytest.approx([0.2, 0.4, 0.6], abs=1e-6)
    assert bounds_of(parts_of(o3d.core.Tensor(np.array(CUBE))))[1].tolist() == [1, 1, 1]
    with pytest.raises(TypeError, match=r"got open3d\S*\.VoxelGrid"):
        named_geometries(o3d.geometry.VoxelGrid())


def test_errors_state_the_given_value_and_a_remedy():
    for path in ("scan.ply", Path("scan.ply")):
        with pytest.raises(TypeError, match=r"^geometries:.*loom\.read_point_cloud.*scan\.ply"):
            named_geometries([path])
    with pytest.raises(TypeError, match="geometries:"):
        named_geometries({1: loom.PointCloud(CUBE)})


def test_arrays_of_clouds_and_meshes_are_shared(device):
    cloud = loom.PointCloud(CUBE, colors=CUBE, device=device)
    mesh = loom.TriangleMesh.create_box(1, 1, 1).to(device)
    assert parts_of(cloud)[0].positions.ptr == cloud._arrays["points"].ptr
    assert parts_of(cloud)[0].colors.ptr == cloud._arrays["colors"].ptr
    [part] = parts_of(mesh)
    assert (part.positions.ptr, part.indices.ptr) == (mesh._arrays["vertices"].ptr, mesh._arrays["triangles"].ptr)


def test_names_are_as_given_or_made_unique_by_numbers():
    cloud, mesh = loom.PointCloud(CUBE), loom.TriangleMesh.create_box(1, 1, 1)
    for given, names in (
        ([cloud, mesh, cloud, {"geometry": mesh, "name": "cloud"}], ["cloud", "mesh", "cloud 2", "cloud 3"]),
        ({"a": cloud, "b": {"geometry": mesh, "wireframe": True}}, ["a", "b"]),
    ):
        assert [name for name, _, _ in named_geometries(given)] == names


def test_several_clouds_without_colors_get_different_ones():
    cloud, colored = loom.PointCloud(CUBE), loom.PointCloud(CUBE, colors=CUBE)
    shown = named_geometries([cloud, colored, {"geometry": cloud, "color": (1, 0, 0)}, cloud])
    assert [style.color for _, _, style in shown] == [PALETTE[0], None, (1.0, 0.0, 0.0), PALETTE[1]]
    assert named_geometries(cloud)[0][2].color is None


def test_styles_are_applied_to_the_parts():
    cloud = loom.PointCloud(CUBE, colors=CUBE)
    [part] = parts_of(cloud, Style(color=(1, 0, 0), point_size=4, metric=True, shaded=False, pose=np.eye(4)))
    assert (part.plain, part.size, part.metric, part.shaded, part.colors.size) == ((1, 0, 0), 4.0, True, False, 0)
    assert part.pose is not None
    [part] = parts_of(cloud, Style(color_by="height", colormap="jet"))
    assert part.coloring.colormap == "jet" and part.colors.size == 8
    [part] = parts_of(loom.TriangleMesh.create_box(1, 1, 1), Style(wireframe=True, back_faces=False, shaded=True))
    assert (part.wireframe, part.cull, part.lit) == (True, True, True)
    [part] = parts_of(loom.LineSet(CUBE, [[0, 1]], [[1, 0, 0]]), Style(line_width=5, color=(0, 1, 0)))
    assert (part.width, part.plain, part.colors.size) == (5.0, (0, 1, 0), 0)
    [part] = parts_of(loom.PointCloud(CUBE).compute_convex_hull()[0], Style(wireframe=False))
    assert isinstance(part, Triangles)


def test_boxes_follow_poses_and_stay_exact_far_away():
    T = np.eye(4)
    T[:3, 3] = 5e5, 5.4e6, 100
    points = np.random.default_rng(0).random((100, 3))
    for parts in (parts_of(loom.PointCloud(points), Style(pose=T)), parts_of(loom.PointCloud(points + T[:3, 3]))):
        low, high = bounds_of(parts)
        assert np.abs(low - T[:3, 3] - points.min(axis=0)).max() < 1e-6
        assert np.abs(high - T[:3, 3] - points.max(axis=0)).max() < 1e-6
    assert [end.tolist() for end in bounds_of([])] == [[0, 0, 0], [0, 0, 0]]
    assert [end.tolist() for end in bounds_of(parts_of(np.full((2, 3), np.nan)))] == [[0, 0, 0], [0, 0, 0]]


def test_voxels_show_the_faces_that_no_other_voxel_touches():
    cells = np.array([[0, 0, 0], [1, 0, 0], [3, 0, 0]], np.int32)
    grid = loom.VoxelGrid(np.array([10.0, 0, 0]), 0.5, (4, 1, 1), cells)
    faces = outer_faces(grid)
    assert len(faces) == 10 + 6
    normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 3] - faces[:, 0])
    centers = faces.mean(axis=1)
    owner = np.array([0.5, 0.5, 0.5]) + cells[np.abs(centers[:, None] - cells - 0.5).sum(axis=2).argmin(axis=1)]
    assert (((centers - owner) * normals).sum(axis=1) > 0).all()  # counterclockwise from outside
    edges = parts_of(grid, Style(wireframe=True))[1]
    assert isinstance(edges, Lines) and edges.indices.size == 2 * (20 + 12)
    assert len(outer_faces(loom.VoxelGrid(np.zeros(3), 1.0, (0, 0, 0), np.empty((0, 3), np.int32)))) == 0


def test_a_frustum_contains_the_view_of_its_camera():
    T = np.eye(4)
    T[:3, 3] = 1, 2, 3
    frustum = loom.CameraFrustum(INTRINSIC, T, scale=2.0)
    corners = frustum.corners()[:4] - T[:3, 3]
    pixels = corners[:, :2] / corners[:, 2:] * 525 + (319.5, 239.5)
    assert pixels == pytest.approx(np.array([[-0.5, -0.5], [639.5, -0.5], [639.5, 479.5], [-0.5, 479.5]]))
    assert (corners[:, 2] == 2).all() and frustum.corners()[4, 1] < frustum.corners()[0, 1]


@pytest.mark.parametrize("wrong", [3, None, [1, 2], [[0, 0, 0]], {"a": 3}, loom.PointCloud, [loom.PointCloud(), None]])
def test_unsupported_geometries_are_rejected_with_the_supported_ones(wrong):
    with pytest.raises((TypeError, ValueError), match=r"^geometries:"):
        for _, geometry, style in named_geometries(wrong):
            parts_of(geometry, style)


@pytest.mark.parametrize(
    ("keys", "kind", "message"),
    [
        ({"colour": (1, 0, 0)}, ValueError, "'colour'"),
        ({"color": "red"}, TypeError, "color"),
        ({"color": (255, 180, 0)}, ValueError, "color: expected 0..1.*divide 8-bit colors by 255"),
        ({"color": (0.5, np.nan, 0)}, ValueError, "color: expected 0..1"),
        ({"point_size": -1}, ValueError, "point_size"),
        ({"line_width": "thin"}, TypeError, "line_width"),
        ({"wireframe": 1}, TypeError, "wireframe"),
        ({"pose": np.zeros((4, 4))}, ValueError, "pose"),
        ({"color_by": 3}, TypeError, "color_by"),
        ({"name": 3}, TypeError, "name"),
    ],
)
def test_styles_out_of_range_are_refused(keys, kind, message):
    with pytest.raises(kind, match=message):
        named_geometries({"geometry": loom.PointCloud(CUBE), **keys})


def test_a_mesh_is_colored_by_its_vertex_attributes():
    mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).paint_uniform_color((1, 0, 0))
    mesh.vertex_attributes["bend"] = np.array([-1.0, 0.0, 1.0])
    [part] = parts_of(mesh, Style(color_by="bend", colormap="gray", limits=(-1, 1)))
    assert download(part.colors)[[0, 2]].tolist() == [[0, 0, 0], [1, 1, 1]]
    assert (part.coloring.title, part.coloring.limits) == ("bend", (-1.0, 1.0))
