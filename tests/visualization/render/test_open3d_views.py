"""Views fit their geometries; Open3D's cameras and files."""

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.up_axis import check_up
from pointloom.visualization.render.up_axis import direction_under, level_up
from pointloom.visualization.render.view import fit_view

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
    rng = np.random.default_rng(1)
    points = np.asarray(offset) + scale * rng.random((50, 3))
    bounds = points.min(axis=0), points.max(axis=0)
    view = loom.fit_view(points, width=200, height=150)
    loom.write_view(tmp_path / "view.json", view, bounds)
    again = loom.read_view(tmp_path / "view.json", width=200, height=150)
    assert np.allclose(again.intrinsic.matrix, view.intrinsic.matrix, rtol=1e-12)
    assert np.allclose(again.T_world_camera[:3, :3], view.T_world_camera[:3, :3], atol=1e-12)
    gap = np.abs(again.T_world_camera[:3, 3] - view.T_world_camera[:3, 3]).max()
    assert gap <= 1e-9 * max(scale, np.abs(offset).max())
    assert 0.02 <= view.to_open3d(bounds)["zoom"] <= 2


def test_an_up_that_leans_is_set_upright():
    view = loom.View.from_open3d(BOUNDS, front=[0, 0, 1], up=[0, 1, 5])
    assert np.allclose(view.T_world_camera[:3, 1], (0, -1, 0))


def test_a_box_that_is_a_point_still_has_a_view():
    assert np.isfinite(loom.View.from_open3d((LOW, LOW)).T_world_camera).all()


@pytest.mark.parametrize(("fy", "cx", "message"), [(510.0, 319.5, "square pixels"), (500.0, 300.0, "principal point")])
def test_cameras_that_open3d_has_not_are_refused(fy, cx, message):
    camera = loom.PinholeCameraIntrinsic(640, 480, 500.0, fy, cx, 239.5)
    with pytest.raises(ValueError, match=message):
        loom.View(camera, np.eye(4)).to_open3d(BOUNDS)


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
    view = loom.fit_view(points, width=320, height=240)
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    u = view.intrinsic.fx * local[:, 0] / local[:, 2] + view.intrinsic.cx
    v = view.intrinsic.fy * local[:, 1] / local[:, 2] + view.intrinsic.cy
    assert local[:, 2].min() > 0
    assert u.min() > 0 and u.max() < 319 and v.min() > 0 and v.max() < 239
    assert np.ptp(u) > 0.9 * 320 or np.ptp(v) > 0.9 * 240


@pytest.mark.parametrize("points", [[[1.0, 2.0, 3.0]], [[0, 0, 0], [0, 0, 4.0]], np.empty((0, 3)), [[np.nan, 0, 0]]])
def test_a_view_of_few_points_is_still_a_view(points):
    with pytest.raises(ValueError, match="direction"):
        loom.fit_view(points, direction=(0, 0, -1))  # along up
    view = loom.fit_view(points, width=160, height=120)
    assert np.isfinite(view.T_world_camera).all()


@pytest.mark.parametrize("up", ["x", "y", "z"])
def test_a_camera_is_level_to_the_axis_that_its_view_was_fitted_to(up):
    axis = np.array(check_up(up))
    x, y, z = direction_under(check_up(up))
    T = fit_view([[0, 0, 0], [1, 2, 3]], direction=(x, y, z), up=tuple(axis.tolist())).T_world_camera
    assert level_up(T[:3, 0], -T[:3, 1]).tolist() == axis.tolist()
    tilted = np.array([0.36, 0.48, 0.8])  # level to none
    assert level_up(np.cross(tilted, [0.8, -0.6, 0.0]), tilted) is tilted
