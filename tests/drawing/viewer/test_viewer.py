"""The viewer before pages without a browser: what they are sent, what stays when they go, what programs may ask."""

import threading
import time

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError, PointloomError
from pointloom.drawing.render.view import View
from pointloom.drawing.viewer import scene
from pointloom.drawing.viewer.items import rotation
from pointloom.drawing.viewer.keys import KEYS
from pointloom.drawing.viewer.viewer import Viewer

from .pages import CAMERA, hear, page_of, say
from .pages import wait_until as wait_for

UTM = np.array([500_000.0, 5_600_000.0, 300.0])
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]

pytestmark = pytest.mark.filterwarnings("ignore:Queued a .* on a closed connection")


def wait_until(claim, seconds=30.0):
    """Of a machine that may have much else to do, or kernels to load."""
    wait_for(claim, seconds)


@pytest.fixture
def shown(capfd):
    """A viewer; whatever was done to it, nothing was printed."""
    with Viewer(port=0) as shown:
        yield shown
    assert capfd.readouterr() == ("", "")


@pytest.fixture
def page(shown):
    """A page that looks at it."""
    with page_of(shown.server) as line:
        wait_until(lambda: shown.sessions)
        yield line


def session_of(shown):
    """The first page, with all that followed from changes."""
    wait_until(lambda: shown.sessions)
    shown.catch_up()
    with shown.lock:
        return next(iter(shown.sessions.values()))


def node_of(shown, name):
    """viser's node of a cloud in the first page."""
    return session_of(shown).streams[name]._handles[0]


def places_of(shown, node, points):
    """Where a node's points stand in the world."""
    return (points @ rotation(node.wxyz).T + node.position) * shown.frame.unit + shown.frame.origin


def cloud_of(points, **more):
    return loom.PointCloud(points, **more)


# -- what a page is sent ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("place", [np.zeros(3), UTM, 1e9 * np.ones(3)], ids=["zero", "utm", "far"])
def test_a_cloud_stands_in_the_page_where_it_stands_in_the_world(shown, page, rng, place):
    points = rng.random((500, 3)) + place
    shown.add("cloud", cloud_of(points))
    node = node_of(shown, "cloud")
    assert node.points.dtype == np.float32
    assert np.abs(node.points).max() < 2  # nothing that float32 would round
    assert np.abs(places_of(shown, node, node.points) - points).max() < (1e-6 if place[0] < 1e8 else 1e-2)


@pytest.mark.parametrize("size", [1e-7, 1e-3, 1e7])
def test_a_scene_of_any_size_is_looked_at_whole(shown, page, rng, size):
    points = rng.random((200, 3)) * size
    shown.add("cloud", cloud_of(points))
    view = session_of(shown).camera_view()
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    pixels = local[:, :2] / local[:, 2:] * view.intrinsic.fx + [view.intrinsic.cx, view.intrinsic.cy]
    assert (local[:, 2] > 0).all()
    assert (np.abs(pixels - [400, 300]) < [400, 300]).all()
    camera = session_of(shown).client.camera
    depth = local[:, 2] / shown.frame.unit
    assert camera.near < depth.min()
    assert camera.far > depth.max()


def test_points_that_are_not_finite_stay_out_of_the_page(shown, page, rng):
    points = rng.random((100, 3))
    points[::10] = np.nan
    shown.add("cloud", cloud_of(points, colors=rng.random((100, 3))))
    node, stream = node_of(shown, "cloud"), session_of(shown).streams["cloud"]
    assert len(node.points) == len(node.colors) == stream.drawn == 90
    assert stream.total == 100
    assert session_of(shown)._line.content == "90 of 100 points"


def test_more_points_than_the_budget_are_shared_among_the_clouds(rng):
    with Viewer(port=0, max_points=1000) as shown, page_of(shown.server):
        shown.add("small", cloud_of(rng.random((500, 3))))
        assert session_of(shown).streams["small"].drawn == 500
        shown.add("other", cloud_of(rng.random((1000, 3)) + 5))
        shown.catch_up()
        drawn = {name: stream.drawn for name, stream in session_of(shown).streams.items()}
        assert sum(drawn.values()) <= 1000
        assert drawn["small"] == 333
        shown.remove("other")
        assert session_of(shown).streams["small"].drawn == 500


def test_a_large_cloud_comes_in_levels_of_detail(rng):
    with Viewer(port=0, max_points=20_000) as shown, page_of(shown.server):
        shown.add("large", cloud_of(rng.random((60_000, 3)), colors=rng.random((60_000, 3))))
        wait_until(lambda: shown.items["large"].tree is not None)
        stream = session_of(shown).streams["large"]
        wait_until(lambda: 10_000 < stream.drawn <= 20_000)
        wait_until(lambda: session_of(shown)._line.content.endswith("of 60,000 points"))
        wait_until(lambda: not session_of(shown)._leaving)
        shown.point_size = 6.0
        sizes = {sent.handle.point_size for sent in stream._sent.values() if sent.handle is not None}
        (radius,) = sizes
        view, points = session_of(shown).camera_view(), shown.items["large"].sample()
        depth = np.median((points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, 2])
        assert 2 * radius * view.intrinsic.fy / depth == pytest.approx(6.0, rel=0.02)


def test_a_mesh_box_and_path_are_in_every_page(shown, page, rng):
    poses = np.tile(np.eye(4), (5, 1, 1))
    poses[:, :3, 3] = rng.random((5, 3))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    shown.add("box", loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1]))
    shown.add("path", loom.Trajectory(poses))
    shown.add("voxels", loom.TriangleMesh.create_sphere(1.0).voxelize(0.3))
    kinds = {name: [type(node).__name__ for _, node in shown._nodes[name]._nodes] for name in shown.items}
    assert kinds["mesh"] == ["GlbHandle"]
    assert kinds["box"] == ["LineSegmentsHandle"]
    assert set(kinds["path"]) == {"LineSegmentsHandle"}
    assert "GlbHandle" in kinds["voxels"]


# -- changes ----------------------------------------------------------------------------------------------------------


def test_update_replaces_points_and_colors_in_one_message(shown, page, rng):
    points = rng.random((100, 3))
    shown.add("cloud", cloud_of(points, colors=rng.random((100, 3))))
    node = node_of(shown, "cloud")
    wait_until(lambda: any("SetPosition" in str(m["type"]) for m in hear(page, 30)))
    shown.update("cloud", cloud_of(points[:70] + 1, colors=np.zeros((70, 3))))
    assert node_of(shown, "cloud") is node  # no node comes or goes: no frame without it
    assert np.abs(places_of(shown, node, node.points) - points[:70] - 1).max() < 1e-6
    together = []
    while not together:
        together = [list(m["updates"]) for m in hear(page, 30) if m["type"] == "SceneNodeUpdateMessage"]
    names = [name for names in together for name in names]
    assert {"points", "colors"} <= set(names)


def test_what_was_replaced_is_let_go(shown, page, rng):
    for k in range(5):
        geometry = cloud_of(rng.random((1000 + k, 3)))
        (shown.update if "cloud" in shown.items else shown.add)("cloud", geometry)
    buffer = session_of(shown).client._websock_connection.get_message_buffer()
    wait_until(lambda: len(buffer.message_from_id) == 0)
    assert len(node_of(shown, "cloud").points) == 1004


def test_a_mesh_is_taken_away_only_when_the_next_one_is_there(shown, page, monkeypatch):
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES, vertex_colors=np.ones((4, 3))))
    ((_, first),) = shown._nodes["mesh"]._nodes
    shown.update("mesh", loom.TriangleMesh(np.array(SQUARE) * 2, FACES))
    ((_, second),) = shown._nodes["mesh"]._nodes
    assert second.name != first.name
    assert not first._impl.removed
    wait_until(lambda: first._impl.removed)
    assert not second._impl.removed


def test_clouds_and_meshes_of_any_device_are_shown(shown, page, rng, device):
    points, normals = rng.random((60, 3)), np.tile([[0, 0, 1.0]], (60, 1))
    shown.add("cloud", cloud_of(points, normals=normals, ring=np.arange(60), device=device))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES, device=device))
    shown.color_by("ring", colormap="gray", limits=(0, 59))
    shown.show_normals(True)
    shown.show_wireframe(True)
    node = node_of(shown, "cloud")
    assert np.abs(places_of(shown, node, node.points) - points).max() < 1e-6
    assert (np.diff(node.colors[:, 0].astype(int)) > 0).all()
    assert len(shown._nodes["cloud"]._normals.points) == 60
    assert len(shown._nodes["mesh"]._edges) == 1


def test_a_pose_moves_what_is_there_and_stays_through_updates(shown, page, rng):
    points, T = rng.random((50, 3)) + UTM, np.eye(4)
    T[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    T[:3, 3] = [1, 2, 3]
    shown.add("cloud", cloud_of(points))
    node = node_of(shown, "cloud")
    before = node.points
    for geometry in (None, cloud_of(points)):
        if geometry is None:
            shown.set_pose("cloud", T)
            assert node.points is before
        else:
            shown.update("cloud", geometry)
        moved = points @ T[:3, :3].T + T[:3, 3]
        assert np.abs(places_of(shown, node, node.points) - moved).max() < 1e-3  # UTM times a rotation: far away


def test_hidden_stays_hidden_through_updates_and_for_pages_that_come_later(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    shown.set_visible("cloud", False)
    shown.update("cloud", cloud_of(rng.random((60, 3))))
    assert not node_of(shown, "cloud").visible
    with page_of(shown.server):
        wait_until(lambda: len(shown.sessions) == 2)
        wait_until(lambda: all("cloud" in session.streams for session in shown.sessions.values()))
        assert not any(session.streams["cloud"]._handles[0].visible for session in shown.sessions.values())


def test_remove_and_clear_leave_nothing(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    node = node_of(shown, "cloud")
    shown.remove("cloud")
    assert node._impl.removed
    assert list(shown.items) == ["mesh"]
    shown.clear()
    assert not shown.items
    assert not session_of(shown).streams
    shown.add("cloud", cloud_of(rng.random((50, 3)) + UTM))  # looked at anew, where it is
    assert np.linalg.norm(shown.frame.origin - UTM) < 2


def test_updates_come_from_several_threads(shown, page, rng):
    points = rng.random((200, 3))
    for k in range(3):
        shown.add(f"cloud {k}", cloud_of(points))
    failed = []

    def move(k):
        try:
            for step in range(20):
                shown.update(f"cloud {k}", cloud_of(points + step))
        except Exception as error:
            failed.append(error)

    threads = [threading.Thread(target=move, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(20)
    assert failed == []
    for k in range(3):
        node = node_of(shown, f"cloud {k}")
        assert np.abs(places_of(shown, node, node.points) - points - 19).max() < 1e-5


# -- pages ------------------------------------------------------------------------------------------------------------


def test_a_page_that_comes_back_sees_everything_again(shown, rng):
    shown.add("cloud", cloud_of(rng.random((123, 3))))
    for _ in range(2):
        with page_of(shown.server):
            assert session_of(shown).streams["cloud"].drawn == 123
        wait_until(lambda: not shown.sessions)


def test_two_pages_look_elsewhere(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    with page_of(shown.server) as other:
        wait_until(lambda: len(shown.sessions) == 2)
        say(other, CAMERA | {"position": [5.0, 6.0, 7.0]})
        first, second = shown.sessions
        wait_until(lambda: np.allclose(shown.get_view(second).T_world_camera[:3, 3] - shown.frame.origin, [5, 6, 7]))
        assert not np.allclose(shown.get_view(first).T_world_camera[:3, 3] - shown.frame.origin, [5, 6, 7], atol=1)
        with pytest.raises(KeyError, match="no page 99"):
            shown.get_view(99)


def test_a_page_that_goes_in_the_midst_of_updates_does_no_harm(shown, rng):
    shown.add("cloud", cloud_of(rng.random((2000, 3))))
    for _ in range(3):
        with page_of(shown.server) as line:
            session_of(shown)
            line.socket.close()
            for _ in range(10):
                shown.update("cloud", cloud_of(rng.random((2000, 3))))
                shown.set_pose("cloud", np.eye(4))
    wait_until(lambda: not shown.sessions)


def test_the_camera_rests_a_quarter_of_a_second_after_it_moved(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    session, seen = session_of(shown), []
    time.sleep(0.6)
    session.rest(lambda view: seen.append((time.monotonic(), view)))
    for k in range(10):
        say(page, CAMERA | {"position": [float(k), 0.0, 3.0]})
        time.sleep(0.05)
    last = time.monotonic()
    wait_until(lambda: seen)
    time.sleep(0.4)
    ((at, view),) = seen
    assert at - last > 0.1
    assert view.T_world_camera[0, 3] - shown.frame.origin[0] == pytest.approx(9)


def test_the_lamps_of_a_page_go_with_its_camera(shown, page):
    lamps = session_of(shown)._lamps
    facing = {"wxyz": [1.0, 0.0, 0.0, 0.0], "look_at": [0, 0, 0], "up_direction": [0, -1, 0]}
    say(page, CAMERA | facing | {"position": [0.0, 1.0, -3.0]})
    wait_until(lambda: np.allclose(lamps._lamp.position, [0, 1, -3]))
    assert np.allclose(lamps._key.position, [-0.45, -0.65, -0.612])  # above left of it, y down


def test_points_keep_their_size_on_the_screen_as_the_camera_goes_away(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3)) * 0.1))
    near = {"wxyz": [0.0, 1.0, 0.0, 0.0], "look_at": [0, 0, 0], "up_direction": [0, 1, 0]}
    sizes = []
    for distance in (3.0, 30.0):
        say(page, CAMERA | near | {"position": [0.0, 0.0, distance]})
        before = node_of(shown, "cloud").point_size
        wait_until(lambda before=before: node_of(shown, "cloud").point_size != before)
        sizes.append(node_of(shown, "cloud").point_size)
    assert sizes[1] / sizes[0] == pytest.approx(10, rel=0.05)


def test_a_slower_page_that_draws_coarser_counts_as_large_as_it_is(shown, page):
    session = session_of(shown)
    assert session.camera_view().intrinsic.width == 800
    say(page, CAMERA | {"image_width": 600, "image_height": 450, "position": [0.0, 0.0, 4.0]})
    wait_until(lambda: session.client.camera.image_width == 600)
    time.sleep(0.1)
    assert session.camera_view().intrinsic.width == 800
    say(page, CAMERA | {"image_width": 600, "image_height": 600, "position": [0.0, 0.0, 5.0]})
    wait_until(lambda: session.camera_view().intrinsic.width == 600)


# -- views ------------------------------------------------------------------------------------------------------------


def test_open3d_s_parameters_set_the_view(shown, page, rng):
    shown.add("cloud", cloud_of(rng.random((50, 3)) + UTM))
    shown.set_view(front=[0, 0, -1], up=[0, -1, 0], zoom=0.5, lookat=UTM)
    expected = View.from_open3d(shown.bounds, front=[0, 0, -1], up=[0, -1, 0], zoom=0.5, lookat=UTM)
    seen = shown.get_view().T_world_camera
    assert np.allclose(seen[:3, 3], expected.T_world_camera[:3, 3], atol=1e-4)
    assert np.allclose(seen[:3, :3], expected.T_world_camera[:3, :3], atol=1e-6)
    shown.set_view(None)
    assert not np.allclose(shown.get_view().T_world_camera[:3, 2], [0, 0, 1], atol=0.1)


def test_a_view_goes_through_open3d_s_json(shown, rng, tmp_path):
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    shown.set_view(front=[1, 0.2, 0.3], up=[0, 0, 1], zoom=0.4)
    before = shown.get_view()
    loom.write_view(tmp_path / "view.json", before, shown.bounds)
    shown.set_view(None)
    shown.set_view(tmp_path / "view.json")
    assert np.allclose(shown.get_view().T_world_camera, before.T_world_camera, atol=1e-9)


@pytest.mark.parametrize(
    ("given", "error", "text"),
    [
        ({"view": 3}, TypeError, "expected a View, a path or Open3D's parameters, got int"),
        ({"zoom": 0}, ValueError, "zoom"),
        ({"front": [0, 0, 0]}, ValueError, "front"),
        ({"fov": 3}, TypeError, "'fov'; there are zoom, front"),
        ({"view": {"eye": 3}}, TypeError, "unknown key 'eye'"),
        ({"view": "missing.json"}, FileError, "missing.json"),
    ],
)
def test_a_view_that_is_none_leaves_the_one_before(shown, given, error, text):
    shown.set_view(front=[1, 0, 0], up=[0, 0, 1])
    before = shown.get_view().T_world_camera
    with pytest.raises(error, match=text):
        shown.set_view(**given)
    assert (shown.get_view().T_world_camera == before).all()


# -- colours, sizes, panel --------------------------------------------------------------------------------------------


def test_colors_go_by_what_is_known_of_the_points(shown, page, rng):
    points = rng.random((50, 3))
    shown.add("cloud", cloud_of(points, label=np.arange(50) % 4 - 1))
    shown.color_by("label")
    assert len(np.unique(node_of(shown, "cloud").colors, axis=0)) == 4
    assert shown.panel._legend.visible
    shown.color_by("height", colormap="gray", limits=(0.25, 0.75))
    grey = node_of(shown, "cloud").colors[:, 0]
    order = np.argsort(points[:, 2])
    assert (np.diff(grey[order].astype(int)) >= 0).all()
    assert grey[points[:, 2] < 0.25].max() == 0
    assert grey[points[:, 2] > 0.75].min() == 255
    assert shown.panel._low.value == 0.25
    assert shown.panel._map.value == "gray"
    shown.update("cloud", cloud_of(points + 1))
    assert (node_of(shown, "cloud").colors == 255).all()  # the range stays
    shown.color_by(None)
    assert not shown.panel._legend.visible
    with pytest.raises(ValueError, match="no cloud here has 'intensity'"):
        shown.color_by("intensity")


def trigger(shown, page, action):
    """Press the key of an action."""
    labels = {key.action: key.label for key in KEYS}
    command = next(c for c in shown.panel._commands if c.label == labels[action])
    say(page, {"type": "CommandTriggerMessage", "uuid": command._impl.uuid})


@pytest.mark.slow
def test_every_key_does_what_it_says(shown, page, rng):
    points = rng.random((50, 3))
    normals = points / np.linalg.norm(points, axis=1, keepdims=True)
    shown.add("cloud", cloud_of(points, normals=normals, colors=points))
    shown.add("mesh", loom.TriangleMesh(SQUARE, FACES))
    size = shown.point_size
    trigger(shown, page, "grow_points")
    wait_until(lambda: shown.point_size > size)
    trigger(shown, page, "shrink_points")
    wait_until(lambda: shown.point_size == pytest.approx(size))
    for action, flag in (("toggle_normals", "normals"), ("toggle_wireframe", "wireframe")):
        trigger(shown, page, action)
        wait_until(lambda flag=flag: getattr(shown, flag))
    wait_until(lambda: shown.panel._normals.value and shown.panel._wireframe.value)
    assert shown._nodes["cloud"]._normals is not None
    assert len(shown._nodes["mesh"]._edges) == 1
    colorings = {"color_by_x": "x", "color_by_y": "y", "color_by_height": "height", "color_by_normal": "normal"}
    for action, by in (colorings | {"color_by_rgb": "rgb", "color_as_given": None, "next_coloring": "rgb"}).items():
        trigger(shown, page, action)
        wait_until(lambda by=by: shown.coloring.by == by)
    trigger(shown, page, "reset_view")
    shift = lambda: shown.get_view().T_world_camera[:3, 3] - shown.home().T_world_camera[:3, 3]  # noqa: E731
    wait_until(lambda: np.abs(shift()).max() < 1e-6)
    say(page, CAMERA | {"position": [9.0, 9.0, 9.0]})
    wait_until(lambda: np.abs(shift()).max() > 1)
    trigger(shown, page, "reset_view")
    wait_until(lambda: np.abs(shift()).max() < 1e-6)
    files = []
    for action in ("take_screenshot", "save_view"):
        trigger(shown, page, action)
        while len(files) == len(set(files)) and not any(action in f for f in files):
            found = [m["filename"] for m in hear(page, 20) if m["type"] == "FileTransferStartDownload"]
            files += [action + name for name in found]
    assert files == ["take_screenshotpointloom.png", "save_viewview.json"]


def test_what_a_page_asks_for_in_vain_is_told_to_it(shown, page):
    trigger(shown, page, "color_by_rgb")
    while True:
        told = [m for m in hear(page, 30) if m["type"] == "NotificationShowMessage"]
        if told:
            break
    assert "no cloud here has 'rgb'" in str(told[0])


def test_names_reach_the_page_as_plain_text_alone(shown, page, rng):
    name = "<img src=x onerror=alert(1)>"
    shown.add(name, cloud_of(rng.random((50, 3)), label=np.zeros(50, int)))
    shown.color_by("label")
    time.sleep(0.1)
    buffer = shown.server.viser._websock_server._broadcast_buffer
    with buffer.buffer_lock:
        messages = list(buffer.message_from_id.values())
    holding = {type(message).__name__ for message in messages if name in str(message)}
    assert holding == {"GuiCheckboxMessage"}  # whose label is text


def test_the_panel_lists_what_is_there(shown, page, rng):
    shown.add("one", cloud_of(rng.random((5, 3))))
    shown.add("two", cloud_of(rng.random((5, 3)), ring=np.arange(5)))
    shown.catch_up()
    assert list(shown.panel._boxes) == ["one", "two"]
    assert shown.panel._by.options == ("own colours", "height", "x", "y", "ring")
    box = shown.panel._boxes["one"]
    say(page, {"type": "GuiUpdateMessage", "uuid": box._impl.uuid, "updates": {"value": False}})
    wait_until(lambda: not shown.items["one"].visible)
    shown.remove("one")
    assert list(shown.panel._boxes) == ["two"]


# -- what is asked wrongly --------------------------------------------------------------------------------------------


def test_a_geometry_of_no_known_kind_says_what_is_accepted_and_changes_nothing(shown, rng):
    shown.add("cloud", cloud_of(rng.random((5, 3))))
    for add in (shown.add, shown.update):
        with pytest.raises(TypeError, match="PointCloud, TriangleMesh"):
            add("cloud", object())
    assert len(shown.items["cloud"].cloud) == 5


def test_names_of_open3d_are_told_apart_from_ours(shown):
    with pytest.raises(AttributeError, match="no attribute 'update_geometry'"):
        shown.update_geometry(None)
    with pytest.raises(AttributeError, match="did you mean 'screenshot'"):
        shown.screenshoot()


def test_unknown_names_are_answered_with_those_that_there_are(shown, rng):
    shown.add("cloud", cloud_of(rng.random((5, 3))))
    for ask in (
        lambda: shown.update("clod", cloud_of(rng.random((5, 3)))),
        lambda: shown.remove("clod"),
        lambda: shown.set_pose("clod", np.eye(4)),
        lambda: shown.set_visible("clod", True),
    ):
        with pytest.raises(KeyError, match="no geometry 'clod'; there are 'cloud'"):
            ask()


@pytest.mark.parametrize(
    ("ask", "error"),
    [
        (lambda shown: shown.add(3, np.zeros((1, 3))), TypeError),
        (lambda shown: shown.add("a", np.zeros((1, 3)), colour=(1, 0, 0)), ValueError),
        (lambda shown: shown.add("a", np.zeros((1, 3)), pose=np.ones((4, 4))), ValueError),
        (lambda shown: shown.set_pose("cloud", 2 * np.eye(4)), ValueError),
        (lambda shown: setattr(shown, "point_size", 0), ValueError),
        (lambda shown: setattr(shown, "background", "white"), TypeError),
        (lambda shown: Viewer(port=0, max_points=0), ValueError),
        (lambda shown: Viewer(port=-1), ValueError),
        (lambda shown: Viewer(port=0, size=(0, 3)), ValueError),
    ],
)
def test_hostile_arguments_are_refused(shown, ask, error):
    shown.add("cloud", np.zeros((1, 3)))
    with pytest.raises(error):
        ask(shown)
    assert list(shown.items) == ["cloud"]


def test_empty_things_are_shown_as_nothing(shown, page, rng):
    shown.add("cloud", cloud_of(np.zeros((0, 3))))
    shown.add("nan", cloud_of(np.full((3, 3), np.nan)))
    shown.add("mesh", loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int)))
    shown.add("lines", loom.LineSet(np.zeros((0, 3)), np.zeros((0, 2), int)))
    shown.show_normals(True)
    shown.show_wireframe(True)
    shown.color_by("height")
    assert session_of(shown)._line.content == "0 of 3 points"
    shown.update("cloud", cloud_of(rng.random((10, 3)) + UTM))
    assert np.linalg.norm(shown.get_view().T_world_camera[:3, 3] - UTM) < 20


# -- stills -----------------------------------------------------------------------------------------------------------


def test_a_screenshot_shows_what_the_page_shows(shown, rng, tmp_path):
    shown.background = (0, 0, 1)
    shown.add("cloud", cloud_of(rng.random((3000, 3))), color=(1, 0, 0), shaded=False)
    picture = shown.screenshot(tmp_path / "shot.png")
    assert picture.shape == (960, 1280, 3)
    assert (loom.read_color(tmp_path / "shot.png") == picture).all()
    assert (picture[0, 0] == [0, 0, 255]).all()
    assert (picture == [255, 0, 0]).all(axis=2).sum() > 1000
    shown.set_visible("cloud", False)
    assert (shown.screenshot() == [0, 0, 255]).all()


def test_a_saved_page_holds_the_scene_and_no_more_points_than_asked(rng, tmp_path):
    with Viewer(port=0, max_points=1000) as shown:
        shown.add("cloud", cloud_of(rng.random((900, 3)) + UTM))
        shown.save_html(tmp_path / "one.html")
        shown.add("more", cloud_of(rng.random((90_000, 3)) + UTM))
        shown.save_html(tmp_path / "two.html")
        with pytest.raises(FileError, match="exists"):
            shown.save_html(tmp_path / "two.html", overwrite=False)
    one, two = ((tmp_path / name).stat().st_size for name in ("one.html", "two.html"))
    assert abs(two - one) < 10_000
    assert b"http://" not in (tmp_path / "two.html").read_bytes().replace(b"http://www.w3.org", b"")


# -- its end ----------------------------------------------------------------------------------------------------------


def test_close_frees_port_threads_and_memory(rng):
    before = threading.active_count()
    shown = Viewer(port=0)
    shown.add("cloud", cloud_of(rng.random((50, 3))))
    with page_of(shown.server):
        session_of(shown)
        port = shown.server.port
        shown.close()
        shown.close()
    assert shown.closed
    assert not shown.items
    with pytest.raises(PointloomError, match="closed"):
        shown.add("cloud", cloud_of(rng.random((50, 3))))
    wait_until(lambda: threading.active_count() <= before)
    with Viewer(port=port) as again:
        assert again.server.port == port


def test_wait_for_some_seconds_says_whether_it_is_over(shown):
    assert not shown.wait(0)
    assert not shown.wait(0.01)
    with pytest.raises(ValueError, match="seconds"):
        shown.wait(-1)
    shown.close()
    assert shown.wait(0)


def press(shown, page, key):
    """Press a key: what every command of that key does."""
    for command in [command for command in shown.panel._commands if command.hotkey == key]:
        say(page, {"type": "CommandTriggerMessage", "uuid": command._impl.uuid})


def test_a_key_calls_a_program_in_place_of_what_it_did(shown, page):
    pressed = []
    shown.on_key("w", pressed.append, "Say so")
    shown.on_key("arrowup", lambda client: pressed.append("up"))
    press(shown, page, "W")
    press(shown, page, "arrowup")
    wait_until(lambda: len(pressed) == 2)
    assert pressed == [session_of(shown).client.client_id, "up"]
    assert not shown.wireframe
    shown.on_key("W", lambda client: pressed.append("again"))
    press(shown, page, "W")
    wait_until(lambda: pressed[2:] == ["again"])
    with pytest.raises(ValueError, match="no key 'F13'; there are A to Z, 0 to 9, space"):
        shown.on_key("F13", print)


def test_a_program_can_use_a_viewer_in_a_block(rng):
    with Viewer(port=0) as shown:
        shown.add("cloud", cloud_of(rng.random((5, 3))))
        assert "1 geometries" in repr(shown) or "1 geometr" in repr(shown)
    assert "closed" in repr(shown)
    assert scene.Scene in Viewer.__mro__
