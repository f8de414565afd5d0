"""The viewer with pages without a browser: sent operations, state after pages leave, and the public methods."""

import contextlib
import sys
import threading
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError, PointloomError
from pointloom.visualization.render.view import View
from pointloom.visualization.viewer import sessions
from pointloom.visualization.viewer.keys import KEYS
from pointloom.visualization.viewer.sessions import Session
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.viewer import Viewer

from .events import join_threads, wait_until
from .pages import HELLO, line_of, send
from .stand_in import page_in, toolbox_of
from .test_items import FACES, SQUARE, UTM


@pytest.fixture
def shown(capfd, caplog):
    """A viewer; nothing may be printed and no page may fail during the test."""
    with Viewer(port=0) as shown:
        yield shown
    assert capfd.readouterr() == ("", "")
    assert [record for record in caplog.records if record.name.startswith("pointloom.viewer")] == []


@pytest.fixture
def page(shown):
    with page_in(shown) as page:
        yield page


def session_of(shown):
    """The first page, after all updates."""
    wait_until(lambda: shown.sessions)
    shown.catch_up()
    with shown.lock:
        return next(iter(shown.sessions.values()))


def node_of(shown, page, name):
    shown.catch_up()
    return page.nodes[shown.sessions[page.client.client_id].streams[name]._nodes[0].id]


def positions_of(shown, node):
    pose = np.reshape(node.pose, (3, 4))
    return (node.positions @ pose[:, :3].T + pose[:, 3]) * shown.scene.frame.unit + shown.scene.frame.origin


def words_of(page):
    """The page's text about the drawn points."""
    return page.of_kind("words")[0].value


@pytest.mark.parametrize("offset", [np.zeros(3), UTM, 1e9 * np.ones(3)], ids=["zero", "utm", "far"])
def test_a_cloud_has_its_world_position_in_the_page(shown, page, rng, offset):
    points = rng.random((500, 3)) + offset
    shown.add("cloud", loom.PointCloud(points))
    node = node_of(shown, page, "cloud")
    assert node.positions.dtype == np.float32
    assert np.abs(node.positions).max() < 2  # float32 would round nothing
    assert np.abs(positions_of(shown, node) - points).max() < (1e-6 if offset[0] < 1e8 else 1e-2)


@pytest.mark.parametrize("size", [1e-7, 1e7])
def test_a_scene_of_any_size_is_fitted_into_view(shown, page, rng, size):
    points = rng.random((200, 3)) * size
    shown.add("cloud", loom.PointCloud(points))
    view = session_of(shown).camera_view()
    seen = np.array([project(view, point) for point in points])  # NaN behind the camera
    assert (np.abs(seen[:, :2] - [400, 300]) < [400, 300]).all()
    depth = seen[:, 2] / shown.scene.frame.unit
    assert page.camera.near < depth.min() <= depth.max() < page.camera.far


def test_points_that_are_not_finite_stay_out_of_the_page(shown, page, rng):
    points = rng.random((100, 3))
    points[::10] = np.nan
    shown.add("cloud", loom.PointCloud(points, colors=rng.random((100, 3))))
    node, stream = node_of(shown, page, "cloud"), session_of(shown).streams["cloud"]
    assert len(node.positions) == len(node.colors) == stream.drawn == 90
    assert stream.total == 100
    assert words_of(page) == "90 of 100 points"


def test_more_points_than_the_budget_are_shared_among_the_clouds(rng):
    with Viewer(port=0, max_points=1000) as shown, page_in(shown):
        shown.add("small", loom.PointCloud(rng.random((500, 3))))
        assert session_of(shown).streams["small"].drawn == 500
        shown.add("other", loom.PointCloud(rng.random((1000, 3)) + 5))
        shown.catch_up()
        drawn = {name: stream.drawn for name, stream in session_of(shown).streams.items()}
        assert sum(drawn.values()) <= 1000
        assert drawn["small"] == 333
        shown.remove("other")
        assert session_of(shown).streams["small"].drawn == 500


def test_a_mesh_box_and_path_are_in_every_page(shown, page, rng):
    poses = np.tile(np.eye(4), (5, 1, 1))
    poses[:, :3, 3] = rng.random((5, 3))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    shown.add("box", loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1]))
    shown.add("path", loom.Trajectory(poses))
    shown.add("voxels", loom.TriangleMesh.create_sphere(1.0).voxelize(0.3))
    with page_in(shown) as late_page:
        for one in (page, late_page):
            nodes = {name: [one.nodes[node.id] for _, node in shown.display.nodes[name].nodes] for name in shown.items}
            kinds = {name: {node.kind for node in item_nodes} for name, item_nodes in nodes.items()}
            assert kinds == {"mesh": {"triangles"}, "box": {"lines"}, "path": {"lines"}, "voxels": {"triangles"}}
            (mesh,) = nodes["mesh"]
            assert mesh.plain == [204, 199, 189] and mesh.lit  # the warm gray of pointloom's images
            assert words_of(one).endswith(" triangles") and "points" not in words_of(one)


def test_points_are_lit_as_in_rendered_images(shown, page, rng):
    points, normals = rng.random((50, 3)), np.tile([[0, 0, 1.0]], (50, 1))
    shown.add("plain", loom.PointCloud(points, normals=normals))
    shown.add("own colors", loom.PointCloud(points, normals=normals, colors=points))
    shown.add("flat", loom.PointCloud(points), shaded=False)
    assert (node_of(shown, page, "plain").normals == [0, 0, 32767]).all()  # light falls on them at an angle
    assert "normals" not in node_of(shown, page, "own colors")
    reliefs = {name: node_of(shown, page, name).relief for name in shown.items}
    assert reliefs == {"plain": False, "own colors": True, "flat": False}


def test_clip_planes_cut_surfaces_in_one_page_alone(shown, page):
    shown.add("ball", loom.TriangleMesh.create_sphere(1.0, 10))
    ((_, node),) = shown.display.nodes["ball"].nodes
    with page_in(shown) as other:
        page.set("z", [page.control("z").min, 0.0])
        page.set("clip", True)
        toolbox_of(shown)
        (cut,) = [one for one in page.nodes.values() if one.id != node.id]
        middle = shown.scene.frame.to_world(np.reshape(cut.pose, (3, 4))[:, 3])
        positions = cut.positions[cut.indices.ravel()] + middle
        assert not page.nodes[node.id].visible and positions[:, 2].min() >= -1 and positions[:, 2].max() <= 1e-6
        assert other.nodes[node.id].visible and len(other.nodes) == 1
        page.set("clip", False)
        toolbox_of(shown)
        assert page.nodes[node.id].visible and len(page.nodes) == 1


def test_point_sizes_are_in_pixels_or_meters(shown, page, rng):
    shown.add("pixels", loom.PointCloud(rng.random((50, 3))))
    shown.add("twice", loom.PointCloud(rng.random((50, 3))), point_size=6)
    shown.add("meters", loom.PointCloud(rng.random((50, 3))), point_size=0.01, metric=True)
    sizes = lambda: {n: (node_of(shown, page, n).size, node_of(shown, page, n).metric) for n in shown.items}  # noqa: E731
    assert sizes() == {"pixels": (3.0, False), "twice": (6.0, False), "meters": (0.01, True)}
    shown.point_size = 4.5
    assert sizes() == {"pixels": (4.5, False), "twice": (9.0, False), "meters": (0.01, True)}


def test_update_replaces_points_and_colors_in_one_message(shown, page, rng):
    points = rng.random((100, 3))
    shown.add("cloud", loom.PointCloud(points, colors=rng.random((100, 3))))
    node = node_of(shown, page, "cloud")
    page.taken.clear()
    shown.update("cloud", loom.PointCloud(points[:70] + 1, colors=np.zeros((70, 3))))
    assert node_of(shown, page, "cloud") is node  # no node is added or removed: no frame without it
    assert np.abs(positions_of(shown, node) - points[:70] - 1).max() < 1e-6
    (message,) = [ops for ops in page.taken if any(op["op"] == "set" for op in ops)]
    (changed,) = [op for op in message if op["op"] == "set"]
    assert {"positions", "colors", "pose"} <= set(changed)


def test_of_updates_that_a_page_does_not_read_the_last_one_waits(shown, page, rng):
    shown.add("cloud", loom.PointCloud(rng.random((1000, 3))))
    page.look()
    for k in range(50):
        shown.update("cloud", loom.PointCloud(rng.random((1000 + k, 3))))
        shown.set_pose("cloud", np.eye(4))
    assert 15_000 < page.own_bytes < 20_000  # 15 bytes a point, once
    assert len(node_of(shown, page, "cloud").positions) == 1049


def test_a_mesh_is_replaced_in_one_message(shown, page):
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES, vertex_colors=np.ones((4, 3))))
    ((_, first),) = shown.display.nodes["mesh"].nodes
    page.look()
    page.taken.clear()
    shown.update("mesh", loom.TriangleMesh(np.array(SQUARE) * 2, FACES))
    ((_, second),) = shown.display.nodes["mesh"].nodes
    assert first.id not in page.nodes and second.id in page.nodes
    (message,) = [ops for ops in page.taken if any(op["op"] in ("node", "drop") for op in ops)]
    changes = {op["op"]: op["id"] for op in message if op["op"] in ("node", "drop")}
    assert changes == {"drop": first.id, "node": second.id}


@pytest.mark.slow
@pytest.mark.parametrize("change", ["add", "update", "set_pose", "set_visible", "remove"])
def test_a_change_costs_the_same_among_ten_objects_and_among_two_thousand(change):
    """Numbers of function calls and sent operations of a change and its updates within a frame."""
    work = []
    for count in (10, 2000):
        with Viewer(port=0) as shown, page_in(shown) as page, shown.lock:
            shown.add_all({f"points/{k}": np.array([[k % 5, k // 5, 0]]) for k in range(count // 2)})
            boxes = {f"box {k}": loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1 + k]) for k in range(count // 2)}
            shown.add_all(boxes)
            shown.add("one", np.array([[0.1, 0.1, 0.1]]))
            warm_up = {"add": ("two", np.zeros((1, 3))), "update": ("one", np.full((1, 3), 0.2))}
            arguments = warm_up | {"set_pose": ("one", np.eye(4)), "set_visible": ("one", False), "remove": ("one",)}
            shown.add("other", np.zeros((1, 3)))
            shown.catch_up()
            page.look()
            with counted_calls() as calls:
                getattr(shown, change)(*arguments[change])
                shown.catch_up()
            work.append((calls[0], [(op["op"], op.get("kind")) for op in page.look()]))
    (few, sent), (many, sent_of_many) = work
    assert sent == sent_of_many
    assert abs(many - few) < 10, (few, many)


@contextlib.contextmanager
def counted_calls():
    """The number of Python function calls in this thread."""
    calls = [0]

    def count(frame, event, argument):
        calls[0] += event == "call"

    sys.setprofile(count)
    try:
        yield calls
    finally:
        sys.setprofile(None)


def test_a_batch_is_one_message_and_may_be_nested(shown, page, rng):
    shown.add("first", loom.PointCloud(rng.random((5, 3))))
    shown.catch_up()
    page.look()
    page.taken.clear()
    with shown.batch():
        for k in range(20):
            shown.add(f"boxes/{k}", loom.AxisAlignedBoundingBox([k, 0, 0], [k + 0.5, 1, 1]))
        with shown.batch():
            shown.set_pose("boxes/3", np.eye(4))
            shown.update("first", loom.PointCloud(rng.random((7, 3))))
        page.look()
        assert not [op for ops in page.taken for op in ops if op["op"] == "node"]
    page.look()
    (message,) = [ops for ops in page.taken if any(op["op"] == "node" for op in ops)]
    assert sum(op["op"] == "node" for op in message) == 20 and any(op["op"] == "set" for op in message)
    with pytest.raises(KeyError), shown.batch():
        shown.remove("boxes/7")
        shown.remove("boxes/7")
    assert "boxes/7" not in page.rows  # all earlier work is shown


def test_many_are_added_at_once_or_none(shown, page):
    with pytest.raises(TypeError, match="PointCloud, TriangleMesh"):
        shown.add_all({"a": np.zeros((1, 3)), "b": object()})
    assert not shown.items
    shown.add_all([{"geometry": np.zeros((1, 3)), "name": "floor", "color": (1, 0, 0)}, np.ones((1, 3))])
    assert list(shown.items) == ["floor", "points"]
    shown.catch_up()
    assert page.rows["floor"] == ("floor", True, [255, 0, 0])


def test_clouds_and_meshes_of_any_device_are_shown(shown, page, rng, device):
    points, normals = rng.random((60, 3)), np.tile([[0, 0, 1.0]], (60, 1))
    shown.add("cloud", loom.PointCloud(points, normals=normals, ring=np.arange(60), device=device))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES, device=device))
    shown.color_by("ring", colormap="gray", limits=(0, 59))
    shown.show_normals(True)
    shown.show_wireframe(True)
    node = node_of(shown, page, "cloud")
    assert np.abs(positions_of(shown, node) - points).max() < 1e-6
    assert (np.diff(node.colors[:, 0].astype(int)) > 0).all()
    assert len(page.nodes[shown.display.nodes["cloud"].normals.id].positions) == 2 * 60
    assert [page.nodes[node.id].wireframe for _, node in shown.display.nodes["mesh"].nodes] == [True]


def test_a_pose_moves_the_geometry_and_survives_updates(shown, page, rng):
    points, T = rng.random((50, 3)) + UTM, np.eye(4)
    T[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    T[:3, 3] = [1, 2, 3]
    shown.add("cloud", loom.PointCloud(points))
    before = node_of(shown, page, "cloud").positions
    shown.set_pose("cloud", T)
    assert node_of(shown, page, "cloud").positions is before
    for _ in range(2):
        gaps = positions_of(shown, node_of(shown, page, "cloud")) - points @ T[:3, :3].T - T[:3, 3]
        assert np.abs(gaps).max() < 1e-3  # UTM times a rotation: far away
        shown.update("cloud", loom.PointCloud(points))


def test_remove_and_clear_leave_nothing(shown, page, rng):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    node = node_of(shown, page, "cloud")
    assert len(page.nodes) == 2
    shown.remove("cloud")
    assert node.id not in page.nodes
    assert list(shown.items) == list(page.rows) == ["mesh"]
    shown.clear()
    assert not shown.items and not page.nodes and not page.rows
    assert not session_of(shown).streams
    shown.add("cloud", loom.PointCloud(rng.random((50, 3)) + UTM))  # fitted again at its position
    assert np.linalg.norm(shown.scene.frame.origin - UTM) < 2


def test_two_pages_look_elsewhere(shown, page, rng):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    with page_in(shown) as other:
        other.move([5.0, 6.0, 7.0])
        first, second = shown.sessions
        origin = shown.scene.frame.origin
        assert np.allclose(shown.get_view(second).T_world_camera[:3, 3] - origin, [5, 6, 7])
        assert not np.allclose(shown.get_view(first).T_world_camera[:3, 3] - origin, [5, 6, 7], atol=1)
        with pytest.raises(KeyError, match="got 99"):
            shown.get_view(99)


@pytest.mark.parametrize(
    ("odd", "size"),
    [
        ({"size": [16384, 1]}, (16384, 32)),
        ({"size": [16384, 16384]}, (5792, 5792)),
        ({"fov": 3.1415926}, (800, 600)),
        ({"position": [9e11, 0, -9e11], "orthographic": True, "fov": 1e-300}, (800, 600)),
    ],
)
def test_of_cameras_that_are_odd_a_picture_can_be_drawn(shown, page, rng, odd, size):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    shown.color_by("height")
    page.move(**({"position": [1.0, 2.0, 3.0]} | odd))
    view = shown.get_view()
    assert (view.intrinsic.width, view.intrinsic.height) == size
    assert np.isfinite(view.T_world_camera).all()
    if size[0] * size[1] < 1e6:
        assert shown.screenshot().shape == (*size[::-1], 3)


@pytest.mark.parametrize("method", ["show", "set_pose", "show_counts"])
def test_an_error_of_one_page_affects_neither_the_program_nor_another_page(rng, method, monkeypatch):
    with Viewer(port=0) as shown, page_in(shown) as page, page_in(shown) as other:
        bad = shown.sessions[page.client.client_id]
        monkeypatch.setattr(bad, method, lambda *given: 1 / 0)
        shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
        shown.set_pose("cloud", np.eye(4))
        shown.set_view(front=[1, 0, 0], up=[0, 0, 1])
        shown.catch_up()
        assert "cloud" in other.rows and len(node_of(shown, other, "cloud").positions) == 50
        assert words_of(other) == "50 points"


def test_a_page_that_failed_to_get_the_scene_is_not_counted(shown, rng, monkeypatch, caplog):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    monkeypatch.setattr(Session, "show", lambda *given: 1 / 0)
    with page_in(shown):
        assert not shown.sessions
        shown.update("cloud", loom.PointCloud(rng.random((60, 3))))
    assert "ZeroDivisionError" in caplog.text
    caplog.clear()


def test_a_page_that_goes_in_the_midst_of_updates_does_no_harm(shown, rng):
    shown.add("cloud", loom.PointCloud(rng.random((2000, 3))))
    for _ in range(3):
        with line_of(shown.server) as line:
            before = set(shown.sessions)
            send(line, HELLO)
            wait_until(lambda before=before: set(shown.sessions) - before)
            line.socket.close()
            for _ in range(10):
                shown.update("cloud", loom.PointCloud(rng.random((2000, 3))))
                shown.set_pose("cloud", np.eye(4))
    wait_until(lambda: not shown.sessions)


def test_the_camera_rests_a_while_after_it_moved(shown, page, rng, monkeypatch):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    session, views = session_of(shown), []
    wait_until(lambda: session._timer is None)
    now, timers = 0.0, []
    monkeypatch.setattr(sessions, "time", SimpleNamespace(monotonic=lambda: now))
    monkeypatch.setattr(sessions.threading, "Timer", lambda *timer: timers.append(timer) or Mock())
    monkeypatch.setattr(session, "refresh_tools", lambda: views.append(session.camera_view()))
    for k in range(10):
        now = 0.1 * k * sessions.IDLE_TIME
        page.move([float(k), 0.0, 3.0])
        page.run_callbacks()
    now = sessions.IDLE_TIME
    for seconds in (
        sessions.IDLE_TIME,
        0.9 * sessions.IDLE_TIME,
    ):  # the time since the first move, and the remaining time
        assert views == []
        waited, look = timers.pop(0)
        assert waited == pytest.approx(seconds)
        look()
        now += 0.95 * sessions.IDLE_TIME  # past the end
    (view,) = views
    assert view.T_world_camera[0, 3] - shown.scene.frame.origin[0] == pytest.approx(9)


def test_a_resized_page_shows_everything_until_the_camera_is_moved(shown, page, rng, monkeypatch):
    points = rng.random((50, 3))
    shown.add("cloud", loom.PointCloud(points))
    session_of(shown)
    position = lambda: session_of(shown).client.camera.position  # noqa: E731
    page.move(position(), size=(400, 600))
    assert seen_fraction(shown, points) > 1  # as wide as before in half the width
    wait_until(lambda: seen_fraction(shown, points) < 1)
    page.move([5.0, 5.0, 5.0], size=(400, 600))
    rested = []
    monkeypatch.setattr(session_of(shown), "refresh_tools", lambda: rested.append(True))
    page.move([5.0, 5.0, 5.0], size=(900, 600))
    wait_until(lambda: rested)
    assert position().tolist() == [5.0, 5.0, 5.0]


def seen_fraction(shown, points):
    """Largest horizontal distance of points from the image center: 1 at its edge."""
    view = shown.get_view()
    columns = np.array([project(view, point)[0] for point in points])
    return np.abs(columns - view.intrinsic.cx).max() / (view.intrinsic.width / 2)


def test_open3d_s_parameters_and_files_set_the_view(shown, page, rng, tmp_path):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3)) + UTM))
    shown.set_view(front=[0, 0, -1], up=[0, -1, 0], zoom=0.5, lookat=UTM)
    expected = View.from_open3d(shown.bounds, front=[0, 0, -1], up=[0, -1, 0], zoom=0.5, lookat=UTM)
    before = shown.get_view()
    assert np.allclose(before.T_world_camera[:3, 3], expected.T_world_camera[:3, 3], atol=1e-4)
    assert np.allclose(before.T_world_camera[:3, :3], expected.T_world_camera[:3, :3], atol=1e-6)
    loom.write_view(tmp_path / "view.json", before, shown.bounds)
    shown.set_view(None)
    assert not np.allclose(shown.get_view().T_world_camera[:3, 2], [0, 0, 1], atol=0.1)
    shown.set_view(tmp_path / "view.json")
    assert np.allclose(shown.get_view().T_world_camera, before.T_world_camera, atol=1e-6)


@pytest.mark.parametrize(
    ("given", "error", "text"),
    [
        ({"view": 3}, TypeError, "expected a View, a path or Open3D's parameters, got int"),
        ({"zoom": 0}, ValueError, "zoom"),
        ({"fov": 3}, TypeError, "expected the keys zoom, front, .* got 'fov'"),
        ({"view": {"eye": 3}}, TypeError, "got 'eye'"),
        ({"view": "missing.json"}, FileError, "missing.json"),
    ],
)
def test_a_view_that_is_none_leaves_the_one_before(shown, given, error, text):
    shown.set_view(front=[1, 0, 0], up=[0, 0, 1])
    before = shown.get_view().T_world_camera
    with pytest.raises(error, match=text):
        shown.set_view(**given)
    assert (shown.get_view().T_world_camera == before).all()


def test_colors_follow_the_attributes_of_the_points(shown, page, rng):
    points = rng.random((50, 3))
    shown.add("cloud", loom.PointCloud(points, label=np.arange(50) % 4 - 1))
    shown.color_by("label")
    assert len(np.unique(node_of(shown, page, "cloud").colors, axis=0)) == 4
    (legend,) = page.of_kind("legend")
    assert [label for label, _, _ in legend.entries] == ["noise", "label 0", "label 1", "label 2"]
    assert [text for _, _, text in legend.entries] == ["13", "13", "12", "12"]
    shades = {tuple(color) for color in node_of(shown, page, "cloud").colors.tolist()}
    assert {tuple(color) for _, color, _ in legend.entries} == shades
    shown.color_by("height", colormap="gray", limits=(0.25, 0.75))
    gray = node_of(shown, page, "cloud").colors[:, 0]
    assert (np.diff(gray[np.argsort(points[:, 2])].astype(int)) >= 0).all()
    assert gray[points[:, 2] < 0.25].max() == 0
    assert gray[points[:, 2] > 0.75].min() == 255
    assert page.control("low").value == 0.25
    assert page.control("map").value == "gray"
    assert page.of_kind("legend") == []
    (bar,) = page.of_kind("colorbar")
    assert bar.title == "height [m]" and bar.colors.tolist() == [[k, k, k] for k in range(256)]
    assert [tuple(bar.ticks[k]) for k in (0, -1)] == [(0.0, "0.25"), (1.0, "0.75")]
    shown.update("cloud", loom.PointCloud(points + 1))
    assert (node_of(shown, page, "cloud").colors == 255).all()  # the range is unchanged
    shown.color_by(None)  # by height, as without colors
    assert page.of_kind("colorbar")[0].title == "height [m]"
    with pytest.raises(ValueError, match=r"^by:"):
        shown.color_by("intensity")


def trigger(page, action):
    """Press the key of an action as defined in its page."""
    page.key({key.action: key.hotkeys[0] for key in KEYS}[action])


def test_every_key_works_as_documented(shown, page, rng):
    points = rng.random((50, 3))
    normals = points / np.linalg.norm(points, axis=1, keepdims=True)
    shown.add("cloud", loom.PointCloud(points, normals=normals, colors=points))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    size = shown.point_size
    trigger(page, "grow_points")
    assert shown.point_size > size
    trigger(page, "shrink_points")
    assert shown.point_size == pytest.approx(size)
    for action, flag in (("toggle_normals", "normals"), ("toggle_wireframe", "wireframe")):
        trigger(page, action)
        assert getattr(shown.scene, flag)
    assert page.control("normals (N)").value and page.control("wireframe (W)").value
    assert len(page.nodes) == 3 and sum("wireframe" in node and node.wireframe for node in page.nodes.values()) == 1
    colorings = {"color_by_x": "x", "color_by_y": "y", "color_by_height": "height", "color_by_normal": "normal"}
    for action, by in (colorings | {"color_by_rgb": "rgb", "color_as_given": None, "next_coloring": "rgb"}).items():
        trigger(page, action)
        assert shown.scene.coloring.by == by
    shift = lambda: np.abs(shown.get_view().T_world_camera[:3, 3] - shown.home().T_world_camera[:3, 3]).max()  # noqa: E731
    page.move([9.0, 9.0, 9.0])
    assert shift() > 1
    trigger(page, "reset_view")
    assert shift() < 1e-6
    trigger(page, "take_screenshot")
    trigger(page, "save_view")
    assert [(file.name, file.mime) for file in page.others("download")] == [
        ("pointloom.png", "image/png"), ("view.json", "application/json")
    ]  # fmt: skip


def test_a_saved_view_is_loaded_again(shown, page, rng):
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    page.move([3.0, 1.0, 2.0])
    before = shown.get_view().T_world_camera
    trigger(page, "save_view")
    text = bytes(page.others("download")[0].data).decode()
    trigger(page, "reset_view")
    assert not np.allclose(shown.get_view().T_world_camera, before, atol=0.1)
    load = page.control("Load view").id
    page.send("file", id=load, name="view.json", text=text)
    assert np.allclose(shown.get_view().T_world_camera, before, atol=1e-6)
    page.send("file", id=load, name="view.json", text="no view")
    notice = page.others("notify")[-1]
    assert notice.kind == "error" and "Expected a view as Open3D copies it" in notice.text


def test_every_key_and_every_tool_is_in_the_palette_once(shown, page):
    tools = {command.label: command.hotkey for command in page.commands if command.group == "Tools"}
    keys = {"Pick a point": "I", "Measure": "M", "Crop by polygon": "K", "Register by pairs": "J"}
    assert keys.items() <= tools.items()
    by_key = [command.hotkey for command in page.commands]
    assert len(set(by_key)) == len(by_key)
    page.key("M")
    assert toolbox_of(shown).tool.label == "Measure"


def test_names_are_sent_to_the_page_as_plain_text(shown, page, rng):
    name = "<img src=x onerror=alert(1)>"
    shown.add(name, loom.PointCloud(rng.random((50, 3)), label=np.zeros(50, int)))
    shown.color_by("label")
    page.look()
    holding = {op["op"] for ops in page.taken for op in ops if name in str(op)}
    assert holding == {"rows"}  # labels that contain text


def test_the_panel_lists_the_geometries(shown, page, rng):
    shown.add("one", loom.PointCloud(rng.random((5, 3))))
    shown.add("two", loom.PointCloud(rng.random((5, 3)), ring=np.arange(5)))
    shown.add("three", loom.TriangleMesh(SQUARE, FACES))
    shown.catch_up()
    assert list(page.rows) == ["one", "two", "three"]
    assert tuple(page.control("by").options) == ("own colors", "height", "x", "y", "ring")
    (tree,) = page.of_kind("tree")
    page.send("value", id=tree.id, value=[["one", "three", "gone meanwhile"], False])
    assert [item.visible for item in shown.items.values()] == [False, True, False]
    assert not page.nodes[shown.display.nodes["three"].nodes[0][1].id].visible
    shown.set_visible("one", True)
    assert page.rows["one"][1]
    shown.remove("two")
    shown.catch_up()
    assert list(page.rows) == ["one", "three"]
    assert tuple(page.control("by").options) == ("own colors", "height", "x", "y")


def test_an_empty_scene_explains_how_to_fill_it(shown, page):
    assert "viewer.add(" in page.others("hint")[-1].text
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    shown.catch_up()
    assert page.others("hint")[-1].text == ""
    shown.clear()
    shown.catch_up()
    assert "viewer.add(" in page.others("hint")[-1].text


def test_open3d_names_are_distinguished_from_pointloom_names(shown):
    with pytest.raises(AttributeError, match="no attribute 'update_geometry'"):
        shown.update_geometry(None)
    with pytest.raises(AttributeError, match="did you mean 'screenshot'"):
        shown.screenshoot()


def test_unknown_names_are_rejected_with_the_existing_ones(shown, rng):
    shown.add("cloud", loom.PointCloud(rng.random((5, 3))))
    cloud = loom.PointCloud(rng.random((5, 3)))
    for method, *more in (("update", cloud), ("remove",), ("set_pose", np.eye(4)), ("set_visible", True)):
        with pytest.raises(KeyError, match="no geometry 'clod'; there are 'cloud'"):
            getattr(shown, method)("clod", *more)


def test_empty_things_are_shown_as_nothing(shown, page, rng):
    shown.add("cloud", loom.PointCloud(np.zeros((0, 3))))
    shown.add("nan", loom.PointCloud(np.full((3, 3), np.nan)))
    shown.add("mesh", loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int)))
    shown.add("lines", loom.LineSet(np.zeros((0, 3)), np.zeros((0, 2), int)))
    shown.show_normals(True)
    shown.show_wireframe(True)
    shown.color_by("height")
    shown.catch_up()
    assert words_of(page) == "0 of 3 points"
    shown.update("cloud", loom.PointCloud(rng.random((10, 3)) + UTM))
    assert np.linalg.norm(shown.get_view().T_world_camera[:3, 3] - UTM) < 20


@pytest.mark.skipif(sys.platform == "darwin", reason="has one loopback address")
def test_a_viewer_listens_on_the_requested_address():
    with loom.Viewer(host="127.0.0.2", port=0) as viewer:
        assert "127.0.0.2" in viewer.url


def test_a_screenshot_matches_the_page(shown, rng, tmp_path):
    shown.background = (0, 0, 1)
    shown.add("cloud", loom.PointCloud(rng.random((3000, 3))), color=(1, 0, 0), shaded=False)
    picture = shown.screenshot(tmp_path / "shot.png", client=None)
    assert picture.shape == (960, 1280, 3)
    assert (loom.read_color(tmp_path / "shot.png") == picture).all()
    assert (picture[0, 0] == [0, 0, 255]).all()
    assert (picture == [255, 0, 0]).all(axis=2).sum() > 1000
    shown.set_visible("cloud", False)
    shown.update("cloud", loom.PointCloud(rng.random((60, 3))))  # it stays hidden
    with page_in(shown) as second_page:
        assert not node_of(shown, second_page, "cloud").visible
    assert (shown.screenshot() == [0, 0, 255]).all()


def test_a_saved_page_contains_the_scene_and_at_most_the_given_points(rng, tmp_path):
    with Viewer(port=0, max_points=1000) as shown:
        shown.add("cloud", loom.PointCloud(rng.random((900, 3)) + UTM))
        shown.save_html(tmp_path / "one.html")
        shown.add("more", loom.PointCloud(rng.random((90_000, 3)) + UTM))
        shown.save_html(tmp_path / "two.html")
        with pytest.raises(FileError, match="exists"):
            shown.save_html(tmp_path / "two.html", overwrite=False)
    one, two = ((tmp_path / name).stat().st_size for name in ("one.html", "two.html"))
    assert abs(two - one) < 10_000
    assert b"http://" not in (tmp_path / "two.html").read_bytes().replace(b"http://www.w3.org", b"")


def test_close_frees_port_threads_and_memory(rng):
    before = set(threading.enumerate())
    shown = Viewer(port=0)
    shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    with page_in(shown):
        port = shown.server.port
        shown.close()
        shown.close()
        assert not shown.sessions
    assert shown.closed
    assert not shown.items
    with pytest.raises(PointloomError, match="closed"):
        shown.add("cloud", loom.PointCloud(rng.random((50, 3))))
    join_threads(lambda thread: thread not in before)
    with Viewer(port=port) as again:
        assert again.server.port == port


def test_pages_are_notified_that_the_viewer_is_closed_and_how_to_restart_it(monkeypatch):
    for arguments, reason in (
        (["/usr/bin/pointloom", "view", "a scan.las"], "pointloom view 'a scan.las'"),
        (["/home/me/show.py", "--secret"], "python show.py"),
        ([""], "The program can open another viewer."),
    ):
        monkeypatch.setattr(sys, "argv", arguments)
        with Viewer(port=0) as shown, page_in(shown) as page:
            deliver = shown.server.pages.stop
            monkeypatch.setattr(shown.server.pages, "stop", lambda page=page, deliver=deliver: (page.look(), deliver()))
            shown.close()
            (end,) = page.others("end")
            assert end.text.startswith("The viewer has been closed.") and end.text.endswith(reason)


def test_pages_know_the_unit_of_their_scale_bar_where_all_of_the_scene_is_in_one(shown):
    def unit_of(page):
        shown.catch_up()
        page.look()
        return page.others("unit")[-1].text

    with page_in(shown) as page:
        shown.add("here", loom.PointCloud([[0, 0, 0], [1, 1, 1]]))
        assert unit_of(page) is None  # the unit is unknown
        shown.add("feet", loom.PointCloud([[0, 0, 0], [2, 2, 2]], unit="ft"))
        assert unit_of(page) == "ft"
        with pytest.warns(loom.UnitWarning):
            shown.add("meters", loom.PointCloud([[0, 0, 0], [3, 3, 3]], unit="m"))
        assert unit_of(page) is None
        shown.remove("feet")
        assert unit_of(page) == "m"


def test_geometries_added_outside_the_view_are_shown_until_the_camera_is_moved(shown, page, rng):
    def is_seen(position):
        shown.catch_up()
        page.look()
        x, y, _ = project(shown.get_view(), position)  # NaN behind the camera
        return bool(0 <= x < 800 and 0 <= y < 600)

    shown.add("one", loom.PointCloud(rng.random((100, 3))))
    assert is_seen([0.5, 0.5, 0.5]) and not is_seen([40, 0, 0])
    for k in range(1, 5):
        shown.add(f"box {k}", loom.PointCloud(rng.random((100, 3)) + np.array([10 * k, 0, 0])))
        assert is_seen([10 * k, 0, 0])
    shown.update("box 4", loom.PointCloud(rng.random((100, 3)) + np.array([500, 0, 0])))
    assert not is_seen([500, 0, 0])  # moved geometries do not move the camera
    page.move(shown.get_view().T_world_camera[:3, 3] * 1.1)
    shown.add("far", loom.PointCloud(rng.random((100, 3)) + np.array([0, 900, 0])))
    assert not is_seen([0, 900, 0])


def test_the_first_view_is_upright(viewer):
    cone = loom.TriangleMesh.create_cone(0.5, 4.0)
    viewer.add("cone", cone)
    assert upwards(viewer) == "z"
    viewer.remove("cone")
    cone.up = "y"
    viewer.add("cone", cone)
    assert upwards(viewer) == "y"
    viewer.up = "x"
    assert viewer.up == (1.0, 0.0, 0.0) and upwards(viewer) == "x"
    with pytest.raises(ValueError, match="up:"):
        viewer.up = "down"


def upwards(viewer):
    """The axis that points up the most in the first view."""
    return "xyz"[int(np.argmax(-viewer.home().T_world_camera[:3, 1]))]


def test_progress_of_the_program_has_its_fraction(shown, monkeypatch):
    calls = []
    monkeypatch.setattr(shown.server.pages, "set_progress", lambda *given: calls.append(given))
    shown.tell_progress("Reading", 0.4)
    shown.tell_progress("")
    assert calls == [("Reading", 0.4), ("", None)]
