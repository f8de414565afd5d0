"""Drawn parts of each kind of geometry, Open3D's views, and transparency."""

import json
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.up_axis import check_up
from pointloom.kernels.memory import download
from pointloom.visualization.render.geometries import (
    CLOUD_COLORS,
    bounds_of,
    kind_of,
    named_geometries,
    outer_faces,
    parts_of,
)
from pointloom.visualization.render.parts import Lines, Points, Triangles
from pointloom.visualization.render.picture_files import write_image
from pointloom.visualization.render.styles import Style
from pointloom.visualization.render.up_axis import direction_under, level_up
from pointloom.visualization.render.view import fit_view

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
    assert default_name == name and [type(part) for part in parts] == kinds
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


def test_an_object_with_a_legacy_form_is_drawn_as_that():
    class Tensors:
        def to_legacy(self):
            return loom.PointCloud(CUBE)

    [(name, geometry, style)] = named_geometries(Tensors())
    assert name == "cloud" and bounds_of(parts_of(geometry, style))[1].tolist() == [1, 1, 1]
    assert kind_of(Tensors()) == "cloud" and bounds_of(parts_of(Tensors()))[1].tolist() == [1, 1, 1]


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
    assert parts_of(cloud)[0].positions.ptr == cloud.arrays["points"].ptr
    assert parts_of(cloud)[0].colors.ptr == cloud.arrays["colors"].ptr
    [part] = parts_of(mesh)
    assert (part.positions.ptr, part.indices.ptr) == (mesh.arrays["vertices"].ptr, mesh.arrays["triangles"].ptr)


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
    assert [style.color for _, _, style in shown] == [CLOUD_COLORS[0], None, (1.0, 0.0, 0.0), CLOUD_COLORS[1]]
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


LOW, HIGH = np.array([5.0, 6.0, 7.0]), np.array([7.0, 6.9, 9.5])
BOUNDS = (LOW, HIGH)


def open3ds_cameras(o3d, parameters):
    """Its field of view [deg], camera matrix and extrinsic matrix after each of these settings, `lookat` ... `zoom`."""
    window = o3d.visualization.Visualizer()
    with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error):
        if not window.create_window(visible=False, width=640, height=480):
            pytest.skip("no window, and no EGL for one off screen")
        window.add_geometry(o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.stack(BOUNDS))))
    control, cameras = window.get_view_control(), []
    for step, (front, lookat, up, (zoom, _, _)) in enumerate(parameters):
        for name, value in {"front": front, "lookat": lookat, "up": up, "zoom": zoom}.items():
            getattr(control, f"set_{name}")(value)
        control.change_field_of_view(step % 5 - 2)
        angle = json.loads(window.get_view_status())["trajectory"][0]["field_of_view"]
        camera = control.convert_to_pinhole_camera_parameters()
        cameras.append((angle, camera.intrinsic.intrinsic_matrix.copy(), camera.extrinsic.copy()))
    window.destroy_window()
    return tuple(np.array(values) for values in zip(*cameras, strict=True))


def test_cameras_are_those_of_open3d_itself(oracle):
    rng, parameters = np.random.default_rng(3), []
    for _ in range(12):
        front, side = np.linalg.qr(rng.normal(size=(3, 2)))[0].T
        parameters.append((front, rng.normal(size=3), side, (rng.uniform(0.02, 2), 0, 0)))
    answers = zip(*oracle("visualization/open3d_views/cameras", open3ds_cameras, np.array(parameters)), strict=True)
    for (front, lookat, up, (zoom, _, _)), (angle, matrix, extrinsic) in zip(parameters, answers, strict=True):
        values = {"front": front, "lookat": lookat, "up": up, "zoom": zoom, "field_of_view": angle}
        view = loom.View.from_open3d(BOUNDS, **values, width=640, height=480)
        assert np.abs(view.intrinsic.matrix - matrix).max() < 1e-6
        assert np.abs(np.linalg.inv(view.T_world_camera) - extrinsic).max() < 1e-6


def test_a_view_that_open3d_wrote_is_read(tmp_path):
    path = tmp_path / "view.json"
    path.write_text(
        """{"class_name" : "ViewTrajectory", "interval" : 29, "is_loop" : false, "trajectory" : [ {
        "boundingbox_max" : [ 7.0, 6.9, 9.5 ], "boundingbox_min" : [ 5.0, 6.0, 7.0 ], "field_of_view" : 60.0,
        "front" : [ 0.0, 0.0, 1.0 ], "lookat" : [ 6.0, 6.45, 8.25 ], "up" : [ 0.0, 1.0, 0.0 ], "zoom" : 0.7 } ],
        "version_major" : 1, "version_minor" : 0 }"""
    )
    view = loom.read_view(path, width=640, height=480)
    assert view.T_world_camera[:3, 3] == pytest.approx([6.0, 6.45, 8.25 + 1.75 * 3**0.5])
    assert (view.intrinsic.width, view.intrinsic.height) == (640, 480)


def open3ds_camera_file(o3d, T):
    parameters = o3d.camera.PinholeCameraParameters()
    parameters.intrinsic = o3d.camera.PinholeCameraIntrinsic(320, 240, 300.0, 310.0, 150.0, 120.0)
    parameters.extrinsic = np.linalg.inv(T)
    with tempfile.TemporaryDirectory() as folder:
        o3d.io.write_pinhole_camera_parameters(f"{folder}/camera.json", parameters)
        return Path(f"{folder}/camera.json").read_text()


def test_pinhole_camera_parameters_of_open3d_are_read(tmp_path, oracle):
    T = np.eye(4)
    T[:3, 3] = 1, 2, 3
    (tmp_path / "camera.json").write_text(oracle("visualization/open3d_views/camera_file", open3ds_camera_file, T))
    view = loom.read_view(tmp_path / "camera.json")
    assert view.intrinsic == loom.PinholeCameraIntrinsic(320, 240, 300.0, 310.0, 150.0, 120.0)
    assert np.allclose(view.T_world_camera, T)


@pytest.mark.parametrize(
    ("scale", "offset"), [(1e-6, (0, 0, 0)), (1.0, (5e5, 5.4e6, 300.0)), (1e6, (5e5, 5.4e6, 300.0))]
)
def test_views_go_to_open3d_and_back(tmp_path, scale, offset):
    points = np.asarray(offset) + scale * np.random.default_rng(1).random((50, 3))
    bounds = points.min(axis=0), points.max(axis=0)
    view = loom.View.fit(points, width=200, height=150)
    loom.write_view(tmp_path / "view.json", view, bounds)
    again = loom.read_view(tmp_path / "view.json", width=200, height=150)
    assert np.allclose(again.intrinsic.matrix, view.intrinsic.matrix, rtol=1e-12)
    assert np.allclose(again.T_world_camera[:3, :3], view.T_world_camera[:3, :3], atol=1e-12)
    gap = np.abs(again.T_world_camera[:3, 3] - view.T_world_camera[:3, 3]).max()
    assert gap <= 1e-9 * max(scale, np.abs(offset).max())
    assert 0.02 <= view.to_open3d(bounds)["zoom"] <= 2


def test_an_up_that_leans_is_set_upright():
    assert np.allclose(loom.View.from_open3d(BOUNDS, front=[0, 0, 1], up=[0, 1, 5]).T_world_camera[:3, 1], (0, -1, 0))


def test_a_box_that_is_a_point_still_has_a_view():
    assert np.isfinite(loom.View.from_open3d((LOW, LOW)).T_world_camera).all()


@pytest.mark.parametrize(("fy", "cx", "message"), [(510.0, 319.5, "square pixels"), (500.0, 300.0, "principal point")])
def test_cameras_that_open3d_has_not_are_refused(fy, cx, message):
    with pytest.raises(ValueError, match=message):
        loom.View(loom.PinholeCameraIntrinsic(640, 480, 500.0, fy, cx, 239.5), np.eye(4)).to_open3d(BOUNDS)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"front": (0, 2, 0)}, "along front"),
        ({"zoom": -1}, "zoom"),
        ({"field_of_view": 180}, "field_of_view"),
        ({"bounds": (LOW, HIGH * np.inf)}, "bounds"),
    ],
)
def test_parameters_out_of_range_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        loom.View.from_open3d(**{"bounds": BOUNDS, **change})


def _changed(change):
    entry = {"boundingbox_max": [1, 1, 1], "boundingbox_min": [0, 0, 0], "field_of_view": 60.0, "zoom": 0.7}
    entry |= {"front": [0, 0, 1], "lookat": [0, 0, 0], "up": [0, 1, 0]}
    content = {"class_name": "ViewTrajectory", "trajectory": [entry]}
    change(content, entry)
    return json.dumps(content)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not JSON"),
        ("[]", "expected a JSON object"),
        ('{"class_name": "ViewTrajectory"}', "trajectory"),
        (_changed(lambda c, e: c.update(class_name="Other")), "ViewTrajectory"),
        (_changed(lambda c, e: c.update(trajectory=[])), "one view, got 0"),
        (_changed(lambda c, e: c.update(trajectory={})), "got a dict"),
        (_changed(lambda c, e: e.pop("zoom")), "zoom"),
        (_changed(lambda c, e: e.update(zoom="big")), "expected numbers, got 'big'"),
        (_changed(lambda c, e: e.update(zoom=[1, 2, 3])), "expected a number"),
        (_changed(lambda c, e: e.update(front=[0, 0, 0])), "front"),
        (_changed(lambda c, e: e.update(up=[0, 0, 2])), "along front"),
        (_changed(lambda c, e: e.update(lookat=None)), "lookat"),
        (_changed(lambda c, e: e.update(lookat=[0, 0, 1e300])), "lookat"),
        (_changed(lambda c, e: e.update(fov=3)), "is unknown"),
        ('{"intrinsic": {"width": 4, "height": 4, "intrinsic_matrix": [1, 0, 0, 0, 1, 0, 1, 1, 1]}}', "extrinsic"),
    ],
)
def test_files_that_are_no_view_are_refused(tmp_path, text, message):
    path = tmp_path / "view.json"
    path.write_text(text)
    with pytest.raises(FileError, match=message):
        loom.read_view(path)


@pytest.mark.parametrize("offset", [(0, 0, 0), (5e5, 5.4e6, 300.0)])
def test_a_fitted_view_frames_all_points_tightly(offset):
    points = np.random.default_rng(0).uniform((-2, 0, 5), (3, 1, 9), (2000, 3)) + offset
    view = loom.View.fit(points, width=320, height=240)
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    u = view.intrinsic.fx * local[:, 0] / local[:, 2] + view.intrinsic.cx
    v = view.intrinsic.fy * local[:, 1] / local[:, 2] + view.intrinsic.cy
    assert local[:, 2].min() > 0
    assert u.min() > 0 and u.max() < 319 and v.min() > 0 and v.max() < 239
    assert np.ptp(u) > 0.9 * 320 or np.ptp(v) > 0.9 * 240


@pytest.mark.parametrize("points", [[[1.0, 2.0, 3.0]], [[0, 0, 0], [0, 0, 4.0]], np.empty((0, 3)), [[np.nan, 0, 0]]])
def test_a_view_of_few_points_is_still_a_view(points):
    with pytest.raises(ValueError, match="direction"):
        loom.View.fit(points, direction=(0, 0, -1))  # along up
    assert np.isfinite(loom.View.fit(points, width=160, height=120).T_world_camera).all()


@pytest.mark.parametrize("up", ["x", "y", "z"])
def test_a_camera_is_level_to_the_axis_that_its_view_was_fitted_to(up):
    axis = np.array(check_up(up))
    x, y, z = direction_under(check_up(up))
    T = fit_view([[0, 0, 0], [1, 2, 3]], direction=(x, y, z), up=tuple(axis.tolist())).T_world_camera
    assert level_up(T[:3, 0], -T[:3, 1]).tolist() == axis.tolist()
    tilted = np.array([0.36, 0.48, 0.8])  # level to none
    assert level_up(np.cross(tilted, [0.8, -0.6, 0.0]), tilted) is tilted


SIZE = (64, 48)
RED, BLUE, GREEN = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)


def wall(z, color, opacity=1.0, half=3.0):
    """A square across the image (or a part of it) at a depth [m], as bright as its color."""
    corners = np.array([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]])
    mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]])
    return {"geometry": mesh, "color": color, "opacity": opacity, "shaded": False}


def dots(z, color, opacity, spacing=0.05):
    """A cloud of overlapping discs across the middle of the image."""
    steps = np.arange(-0.6, 0.6, spacing)
    x, y = (each.ravel() for each in np.meshgrid(steps, steps))
    cloud = loom.PointCloud(np.column_stack([x, y, np.full(x.size, float(z))]))
    return {"geometry": cloud, "color": color, "opacity": opacity, "shaded": False, "point_size": 9}


def view():
    """A camera at the origin that looks along z."""
    camera = loom.PinholeCameraIntrinsic(*SIZE, 60.0, 60.0, (SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2)
    return loom.View(camera, np.eye(4))


def draw(*geometries, **options):
    return loom.render(list(geometries), view(), **options)


def middle(picture):
    return picture[SIZE[1] // 2, SIZE[0] // 2].astype(int).tolist()


def test_colors_are_blended_with_the_background_by_opacity(device):
    assert middle(draw(wall(2, RED, 0.4), wall(3, BLUE), device=device)) == [102, 0, 153]
    assert middle(draw(wall(2, RED, 0.4), background="black", device=device)) == [102, 0, 0]


def test_layers_are_sorted_by_depth_for_any_input_order(device):
    walls = [wall(2, RED, 0.5), wall(3, GREEN, 0.5), wall(4, BLUE, 0.5)]
    picture = draw(*walls, background="black", device=device)
    assert np.abs(np.array(middle(picture)) - [127.5, 63.75, 31.875]).max() <= 1
    assert draw(*walls[::-1], background="black", device=device).tobytes() == picture.tobytes()


def test_faces_behind_faces_of_one_mesh_are_seen(device):
    ball = loom.TriangleMesh.create_sphere(1.0).translate((0, 0, 4))
    style = {"color": RED, "opacity": 0.5, "shaded": False}
    both = draw({"geometry": ball, **style}, background="black", device=device)
    front = draw({"geometry": ball, **style, "back_faces": False}, background="black", device=device)
    assert middle(front) == [128, 0, 0] and middle(both) == [191, 0, 0]


def test_discs_of_one_cloud_that_overlap_are_one_layer(device):
    inside = draw(dots(2, RED, 0.4), wall(3, BLUE), device=device)[20:28, 26:38].reshape(-1, 3)
    assert (inside == [102, 0, 153]).all()


def test_a_cloud_between_two_walls_is_behind_the_one_and_before_the_other(device):
    shown = [wall(3, BLUE, 0.5), dots(2, RED, 0.5), wall(1, GREEN, 0.5)]
    assert np.abs(np.array(middle(draw(*shown, background="black", device=device))) - [63.75, 127.5, 31.875]).max() <= 1


def test_opaque_surfaces_hide_transparent_ones(device):
    assert middle(draw(wall(2, RED), wall(3, GREEN, 0.5), dots(4, BLUE, 0.5), device=device)) == [255, 0, 0]


def test_zero_opacity_is_invisible_and_full_opacity_is_the_default(device):
    plain = wall(2, RED)
    del plain["opacity"]
    assert draw(wall(2, RED, 1.0), device=device).tobytes() == draw(plain, device=device).tobytes()
    assert middle(draw(wall(2, RED, 0.0), wall(3, BLUE), device=device)) == [0, 0, 255]


def test_beyond_the_maximum_of_layers_the_opaque_surface_follows(device):
    walls = [wall(2 + 0.05 * k, RED, 0.02) for k in range(40)]
    red, _, blue = middle(draw(*walls, wall(9, BLUE), device=device))
    assert red == round(255 * (1 - 0.98**16)) and blue == round(255 * 0.98**16)


def test_depth_is_that_of_opaque_surfaces(device):
    _, depth = draw(wall(2, RED, 0.5), wall(3, BLUE, half=0.3), depth=True, device=device)
    assert depth[24, 32] == pytest.approx(3.0) and depth[0, 0] == 0


def test_a_transparent_background_leaves_colors_and_how_opaque_they_are(device):
    picture = draw(wall(2, RED, 0.4), wall(3, BLUE, half=0.3), background="transparent", device=device)
    assert picture.shape == (*SIZE[::-1], 4) and repr(picture) == "Picture(64 x 48)" and picture._repr_png_()
    assert middle(picture) == [102, 0, 153, 255]
    assert picture[1, 1].tolist() == [255, 0, 0, 102]
    assert draw(wall(2, RED, half=0.2), background="transparent", device=device)[0, 0].tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("ground", ["black", (0.2, 0.4, 1.0)])
def test_a_transparent_picture_laid_over_a_ground_is_the_picture_before_it(device, ground):
    ball = loom.TriangleMesh.create_sphere(1.0).translate((0, 0, 4))
    shown = [{"geometry": ball, "opacity": 0.6}, wall(6, GREEN, 0.5, half=1.4)]
    words = {"legend": [("a", RED)], "labels": [("here", (0, 0, 3))], "scale_bar": True}
    clear = draw(*shown, background="transparent", device=device, **({} if ground == "black" else words))
    opaque = draw(*shown, background=ground, device=device, **({} if ground == "black" else words))
    fraction = clear[..., 3:] / 255
    laid = clear[..., :3] * fraction + 255 * np.array((0, 0, 0) if ground == "black" else ground) * (1 - fraction)
    assert np.abs(laid - opaque).max() <= 2.5


@pytest.mark.parametrize("name", ["a.png", "a.webp"])
def test_files_contain_transparent_geometries(tmp_path, name):
    picture = draw(wall(2, RED, 0.4, half=0.5), background="transparent")
    write_image(tmp_path / name, picture)
    with Image.open(tmp_path / name) as read:
        assert read.mode == "RGBA" and np.array_equal(np.array(read), picture)


@pytest.mark.parametrize("name", ["a.jpg", "a.gif"])
def test_files_without_transparency_support_are_rejected_with_a_remedy(tmp_path, name):
    with pytest.raises(FileError, match="does not support transparency"):
        write_image(tmp_path / name, np.zeros((4, 4, 4), np.uint8))


@pytest.mark.parametrize("shape", [(1, 16384, 4), (16384, 1, 4)])
def test_images_larger_than_webp_allows_are_rejected(tmp_path, shape):
    with pytest.raises(ValueError, match=r"image: expected at most 16383 pixels per side for \.webp"):
        write_image(tmp_path / "a.webp", np.zeros(shape, np.uint8))


def test_lines_are_light_before_black(device):
    box = loom.AxisAlignedBoundingBox([-1, -1, 4], [1, 1, 6])
    assert draw(box, background="black", device=device).max() > 200
    assert draw({"geometry": box, "color": (0.1, 0.1, 0.1)}, background="black", device=device).max() < 40


@pytest.mark.parametrize(("opacity", "kind"), [(1.5, ValueError), (-0.1, ValueError), ("half", TypeError)])
def test_an_opacity_out_of_range_is_refused(opacity, kind):
    with pytest.raises(kind, match="opacity"):
        draw(wall(2, RED, opacity))
    with pytest.raises(ValueError, match="opacity:"):
        draw({"geometry": loom.AxisAlignedBoundingBox([0, 0, 1], [1, 1, 2]), "opacity": 0.5})
