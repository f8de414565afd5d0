"""Windows under Open3D's names: browser pages, or images without a viewer, with Open3D's cameras."""

import json
import sys
import threading
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom.open3d as o3d
from pointloom.core.errors import PointloomError
from pointloom.visualization.viewer.draw import DISPLAYS
from pointloom.visualization.viewer.tools.picking import project

from ..visualization.viewer.events import announced_events, wait_until  # noqa: F401  a fixture
from ..visualization.viewer.pages import HELLO, line_of, page_of, send
from .runner import differences, draw_nothing, results_of

FRAMES = 60  # lifetime of an unattended window


@pytest.fixture(autouse=True)
def unattended(monkeypatch):
    monkeypatch.setenv("POINTLOOM_DRAW", "picture")


@pytest.fixture
def both(request, page_files, monkeypatch):
    """Results of a page's script with Open3D, whose windows are hidden and closed, and with pointloom.open3d."""
    open3d = request.getfixturevalue("o3d")  # a name that these tests use for the pointloom class
    visualization = open3d.visualization
    window = visualization.Visualizer()
    if not window.create_window(visible=False):
        pytest.skip("Open3D draws no window here")
    window.destroy_window()
    create, callbacks = visualization.Visualizer.create_window, {}

    def run(window):
        for _ in range(FRAMES):
            callback = callbacks.get("now")
            if callback is None:
                return
            callback(window)
            window.poll_events()
            window.update_renderer()

    def show(geometries, callback=None, **_):
        window = visualization.Visualizer()
        window.create_window()
        for geometry in geometries:
            window.add_geometry(geometry)
        callbacks["now"] = callback
        window.run()
        callbacks.clear()
        window.destroy_window()

    def hidden(window, width=1920, height=1080, **_):
        return create(window, width=width, height=height, visible=False)

    monkeypatch.setattr(visualization.Visualizer, "create_window", hidden)
    monkeypatch.setattr(visualization.Visualizer, "run", run)
    register = "register_animation_callback"
    monkeypatch.setattr(visualization.Visualizer, register, lambda _, callback: callbacks.update(now=callback))
    monkeypatch.setattr(visualization, "draw_geometries_with_animation_callback", show)

    def compare(page):
        for module in (open3d, o3d):
            draw_nothing(monkeypatch, module)
        return [results_of(f"../pages/{page}", package, page_files) for package in ("open3d", "pointloom.open3d")]

    return compare


@pytest.mark.slow
@pytest.mark.usefixtures("o3d")
def test_customized_windows_have_open3ds_cameras(both):
    theirs, actual = both("customized_visualization")
    depths = [np.array(output.pop("depths")) for output in (theirs, actual)]
    assert differences(theirs, actual, {}, 1e-6) == []
    drawn = [depth > 0 for depth in depths]
    assert (drawn[0] != drawn[1]).mean() < 0.08  # a disc of pointloom covers more pixels
    assert (np.abs(depths[0] - depths[1])[drawn[0] & drawn[1]] < 1e-3).mean() > 0.95


@pytest.fixture
def drawn(tmp_path):
    """A function that draws like `draw` and returns the image of the window."""

    def draw(*geometries, **options):
        images = []

        def look(vis):
            vis.export_current_image(tmp_path / "a.png")
            images.append(np.asarray(o3d.io.read_image(tmp_path / "a.png")))

        o3d.visualization.draw(*geometries, width=64, height=48, on_init=look, **options)
        return images[0]

    return draw


@pytest.fixture
def box():
    return o3d.geometry.TriangleMesh.create_box(1, 2, 3).paint_uniform_color([1, 0, 0])


def test_a_window_without_geometries_displays_a_cube_of_2_m_about_the_origin():
    vis = o3d.visualization.Visualizer()
    vis.create_window(visible=False)
    for _ in range(2):
        status = json.loads(vis.get_view_status())["trajectory"][0]
        assert status["boundingbox_min"] == [-1] * 3 and status["boundingbox_max"] == [1] * 3
        vis.reset_view_point(True)


def test_an_image_is_captured_without_a_page(box, tmp_path):
    vis = o3d.visualization.Visualizer()
    assert vis.create_window("boxes", 64, 48, visible=False)
    vis.add_geometry(box)
    vis.get_render_option().background_color = [0, 0, 1]
    vis.capture_screen_image(tmp_path / "a.png", True)
    image = np.asarray(o3d.io.read_image(tmp_path / "a.png"))
    assert image.shape == (48, 64, 3) and image[0, 0].tolist() == [0, 0, 255] and image[24, 32, 0] > 100
    assert image[24, 32, 1:].max() == 0
    vis.capture_depth_image(tmp_path / "depth.png")
    depth = np.asarray(o3d.io.read_image(tmp_path / "depth.png"))
    assert depth[24, 32] == pytest.approx(1000 * (3 * 0.7 * 3**0.5 - 1.5), abs=2)
    vis.capture_depth_point_cloud(tmp_path / "seen.ply", convert_to_world_coordinate=True)
    assert o3d.io.read_point_cloud(tmp_path / "seen.ply").get_max_bound()[2] == pytest.approx(3.0, abs=1e-3)
    status = vis.get_view_status()
    vis.get_view_control().rotate(300, 0)
    assert vis.get_view_status() != status
    vis.set_view_status(status)
    assert vis.get_view_status() == status and vis.remove_geometry(box) and not vis.update_geometry(box)
    assert (np.asarray(vis.capture_screen_float_buffer()) == [0, 0, 1]).all()


def test_loops_of_an_unattended_script_end(box):
    vis, iterations = o3d.visualization.Visualizer(), 0
    vis.create_window()
    vis.add_geometry(box)
    while vis.poll_events():
        iterations += 1
        vis.update_renderer()
    assert iterations == FRAMES - 1
    calls = []
    o3d.visualization.draw_geometries_with_animation_callback([box], lambda window: calls.append(window.close()))
    assert calls == [None]
    o3d.visualization.draw_geometries_with_key_callbacks([box], {ord("K"): print})
    o3d.visualization.draw([{"geometry": box, "name": "box"}], lookat=[0, 0, 0], eye=[3, 3, 3], up=[0, 0, 1])
    with pytest.raises(PointloomError, match="ibl:"):
        o3d.visualization.draw(box, ibl="default")
    with pytest.raises(TypeError, match="geometry_list:"):
        o3d.visualization.draw_geometries(box)


def test_images_and_clouds_are_drawn(rng):
    image = o3d.geometry.Image((rng.random((20, 30, 3)) * 255).astype(np.uint8))
    depth = o3d.geometry.Image(rng.random((20, 30)).astype(np.float32))
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(rng.random((50, 3)) * 30))
    cloud.estimate_normals()
    lines = o3d.geometry.LineSet.create_from_oriented_bounding_box(cloud.get_oriented_bounding_box())
    shapes = [image, depth, cloud, lines, cloud.get_axis_aligned_bounding_box()]
    o3d.visualization.draw_geometries(shapes, width=32, height=24, point_show_normal=True, zoom=0.7, front=[0, 0, 1])
    vis = o3d.visualization.Visualizer()
    vis.create_window(width=64, height=48, visible=False)
    for shape in shapes:
        vis.add_geometry(shape)
    option = vis.get_render_option()
    option.point_color_option = o3d.visualization.PointColorOption.XCoordinate
    option.show_coordinate_frame = option.point_show_normal = True
    assert np.asarray(vis.capture_screen_float_buffer()).min() < 0.9


def test_a_key_of_the_page_calls_the_program_in_its_loop(box, monkeypatch, capsys):
    monkeypatch.setenv("POINTLOOM_DRAW", "page")
    vis, pressed = o3d.visualization.VisualizerWithKeyCallback(), []
    vis.create_window("keys", 640, 480)
    assert "viewer: http://127.0.0.1:" in capsys.readouterr().err
    vis.add_geometry(box)
    vis.register_key_callback(ord("K"), lambda window: pressed.append(window is vis))
    vis.register_key_action_callback(32, lambda window, action, mods: pressed.append((action, mods)))
    with pytest.raises(ValueError, match="key:"):
        vis.register_key_callback(290, print)
    try:
        viewer = vis.viewer
        with line_of(viewer.server) as page:
            send(page, HELLO)
            wait_until(lambda: viewer.sessions)
            for key in ("K", "space"):
                command = next(command for command in viewer.hooks._actions._commands if command.hotkey == key)
                send(page, {"say": "command", "id": command.id})
            wait_until(lambda: vis._pressed.qsize() == 2)
            assert pressed == []  # in the program's own loop, not in a page thread
            assert vis.poll_events() and pressed == [True, (1, 0)]
            vis.get_render_option().background_color = [0, 0, 0]
            vis.get_render_option().show_coordinate_frame = True
            vis.get_view_control().set_front([1, 0, 0])
            box.translate([5, 0, 0])
            vis.update_geometry(box)
            vis.update_renderer()
            assert viewer.background.tolist() == [0, 0, 0]
            assert set(viewer.items) == {"TriangleMesh 1", "coordinate frame"}
            assert viewer.items["TriangleMesh 1"].geometry.get_min_bound()[0] == 5
            assert viewer.home().T_world_camera[:3, 2] == pytest.approx([-1, 0, 0])
    finally:
        vis.destroy_window()
    assert viewer.closed


@pytest.fixture
def window(monkeypatch, capsys):
    """The window of `draw` as a page that has not been opened yet."""
    monkeypatch.setenv("POINTLOOM_DRAW", "page")
    window = o3d.visualization.O3DVisualizer("parts", 640, 480)
    yield window
    window.destroy_window()


def press(control, value=None):
    """Press a button of the page, or set a value, and wait until the program has been called."""
    handle, done = control._state.handles[0], threading.Event()
    for callback in handle._callbacks:
        callback(SimpleNamespace(client_id=0, value=value, target=handle))
    control._controls._calls.call(0, done.set)
    assert done.wait(60)


def test_actions_of_draw_are_buttons_that_call_with_the_window(box, window):
    def make(vis):
        vis.add_geometry({"name": "made", "geometry": o3d.geometry.TriangleMesh.create_sphere(0.5)})
        vis.show_geometry("box", False)

    window.add_geometry({"name": "box", "geometry": box, "is_visible": True, "material": None})
    window.add_action("Make", make)
    viewer = window._window.viewer
    press(viewer.hooks.controls._folders["Actions"][1][0])
    assert [(name, item.visible) for name, item in viewer.items.items()] == [("box", False), ("made", True)]
    assert window.get_geometry("made").is_visible and not window.get_geometry("box").is_visible
    with pytest.raises(ValueError, match="name:"):
        window.add_geometry("made", box)
    window.update_geometry("made", box)
    window.remove_geometry("box")
    with pytest.raises(KeyError, match="no geometry 'box'; expected one of 'made'"):
        window.show_geometry("box", True)
    assert viewer.items["made"].geometry.get_max_bound().tolist() == [1, 2, 3]


def test_geometries_of_different_times_have_a_time_line(box, window):
    for time in range(3):
        moved = o3d.geometry.TriangleMesh(box).translate([time, 0, 0])
        window.add_geometry({"name": f"box {time}", "geometry": moved, "time": time})
    window._play_times()
    viewer = window._window.viewer
    for time in (2, 0, 1):
        window.current_time = time
        assert [name for name, item in viewer.scene.shown.items() if item.visible] == [f"box {time}"]


def test_an_animation_calls_while_its_box_is_ticked(box, window):
    frames, ticks = [], []
    window.set_on_animation_frame(lambda vis, time: frames.append((vis is window, time)))
    window.set_on_animation_tick(lambda vis, passed, time: ticks.append(time))
    window.animation_time_step, window.animation_duration = 0.5, 1.6
    press(window._animate, True)
    assert window.is_animating
    for _ in range(8):
        window._tick(0.25)
    assert ticks == [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 0.0, 0.25]
    assert frames == [(True, 0.5), (True, 1.0), (True, 1.5), (True, 0.0)]
    press(window._animate, False)
    assert not window.is_animating and not window._window.viewer.hooks.calls._beats


def test_draw_accepts_the_same_arguments_without_a_page_and_geometries_with_a_legacy_form(box, drawn):
    image = drawn(
        [box, {"name": "hidden", "geometry": box, "is_visible": False, "time": 1.0}],
        title="boxes", actions=[("Make", print)], lookat=[0.5, 1, 1.5], eye=[9, 1, 1.5], up=[0, 0, 1],
        field_of_view=40.0, bg_color=(0, 0, 1, 1), show_axes=True, line_width=2, point_size=4,
        animation_time_step=0.1, animation_duration=2.0, on_animation_frame=print,
    )  # fmt: skip
    assert image.shape == (48, 64, 3) and image[0, 0].tolist() == [0, 0, 255] and image[24, 32, 0] > 100
    tensors = type("Tensors", (), {"to_legacy": lambda self: box})()
    assert drawn(tensors)[24, 32, 0] > 100


def test_a_notebook_displays_the_page_of_draw_geometries(box, monkeypatch):
    shell, displayed = type("ZMQInteractiveShell", (), {})(), []
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setitem(sys.modules, "IPython.display", SimpleNamespace(display=displayed.append))
    monkeypatch.setenv("POINTLOOM_INLINE", "1")
    o3d.visualization.draw_geometries([box], width=64, height=48)
    assert "srcdoc=" in displayed[0]._repr_mimebundle_()["text/html"]


def test_a_polygon_crops_clouds_and_meshes(tmp_path, rng):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(rng.random((200, 3))))
    volume = o3d.visualization.SelectionPolygonVolume()
    volume.bounding_polygon = o3d.utility.Vector3dVector([[0, 0, 0], [0.5, 0, 0], [0.5, 0.5, 0], [0, 0.5, 0]])
    volume.orthogonal_axis, volume.axis_min, volume.axis_max = "Z", 0.0, 0.5
    inside = (np.asarray(cloud.points) < 0.5).all(axis=1)
    assert volume.crop_in_polygon(cloud) == np.flatnonzero(inside).tolist()
    assert np.allclose(volume.crop_point_cloud(cloud).points, np.asarray(cloud.points)[inside], atol=1e-6)
    assert volume.crop_triangle_mesh(o3d.geometry.TriangleMesh.create_sphere(0.6)).get_max_bound().max() <= 0.5
    volume.native.to_json(tmp_path / "cropped.json")
    again = o3d.visualization.read_selection_polygon_volume(tmp_path / "cropped.json")
    assert len(again.crop_point_cloud(cloud).points) == inside.sum()


@pytest.fixture
def no_display(monkeypatch, tmp_path):
    """No browser can be opened, and the working directory is empty."""
    for name in ("POINTLOOM_DRAW", "SSH_CONNECTION", *DISPLAYS):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("pointloom.visualization.viewer.draw.sys", SimpleNamespace(platform="linux"))
    monkeypatch.chdir(tmp_path)


def test_windows_write_images_without_a_display(box, no_display, tmp_path, capsys):
    o3d.visualization.draw_geometries([box], width=64, height=48)
    o3d.visualization.draw_geometries_with_editing([box], width=64, height=48)
    o3d.visualization.draw(box, width=64, height=48)
    for visible, captures in ((True, False), (True, True), (False, False)):
        vis = o3d.visualization.Visualizer()
        vis.create_window(width=64, height=48, visible=visible)
        vis.add_geometry(box)
        vis.poll_events()
        if captures:
            vis.capture_screen_float_buffer()
        vis.destroy_window()
    names = [f"pointloom-{number}.png" for number in (1, 2, 3, 4)]
    assert sorted(path.name for path in tmp_path.iterdir()) == names
    assert all(np.asarray(o3d.io.read_image(name))[24, 32, 0] > 100 for name in names)
    assert all(name in capsys.readouterr().err for name in names[:1])


def test_nothing_is_picked_without_a_page(box, capsys):
    vis = o3d.visualization.VisualizerWithEditing()
    vis.create_window()
    vis.add_geometry(box)
    vis.run()
    vis.destroy_window()
    assert vis.get_picked_points() == [] and capsys.readouterr() == ("", "")


def click(line, viewer, point):
    """Click on a point of the scene in a page of 800 x 600 pixels."""
    x, y, _ = project(viewer.get_view(), point)
    send(line, {"say": "click", "x": (x + 0.5) / 800, "y": (y + 0.5) / 600})


def marks(viewer):
    """Number of the points that the page shows as picked."""
    item = viewer.items.get("picked points")
    return 0 if item is None else len(item.cloud)


def test_clicks_pick_points_and_clicks_on_picked_points_remove_them(monkeypatch):
    monkeypatch.setenv("POINTLOOM_DRAW", "page")
    points = np.array([[0.0, 0, 0], [0.6, 0, 0], [0, 0.6, 0], [0.6, 0.6, 0]])
    vis = o3d.visualization.VisualizerWithEditing()
    vis.create_window()
    vis.add_geometry(o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)))
    viewer = vis.viewer
    with page_of(viewer.server) as line:
        wait_until(lambda: viewer.sessions)
        for clicked, picked in ((2, [2]), (0, [2, 0]), (3, [2, 0, 3]), (0, [2, 3])):
            click(line, viewer, points[clicked])
            wait_until(lambda expected=picked: marks(viewer) == len(expected))
            assert vis.get_picked_points() == picked
    vis.destroy_window()
    assert vis.get_picked_points() == [2, 3] and (np.asarray(vis.get_cropped_geometry().points) == points).all()
    vis.create_window()
    assert vis.get_picked_points() == []
    vis.destroy_window()


def test_materials_set_the_color_of_geometries_without_colors(drawn):
    material = o3d.visualization.rendering.MaterialRecord()
    material.shader, material.base_color, material.point_size = "defaultLit", [0, 0, 1, 1], 9
    plain = o3d.geometry.TriangleMesh.create_box(1, 1, 1)
    red = o3d.geometry.TriangleMesh(plain).paint_uniform_color([1, 0, 0])
    entries = [{"name": "box", "geometry": mesh, "material": material} for mesh in (plain, red)]
    middles = [drawn([entry])[24, 32] for entry in entries]
    assert middles[0][2] > 100 > middles[0][0] and middles[1][0] > 100 > middles[1][2]
    with pytest.raises(AttributeError, match="base_colour"):
        material.base_colour = [1, 0, 0, 1]
    with pytest.raises(TypeError, match="material:"):
        o3d.visualization.draw([{"name": "box", "geometry": plain, "material": "red"}])
