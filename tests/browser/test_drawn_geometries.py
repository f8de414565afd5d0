"""`draw` in Chromium: each kind of geometry is there in its colour, where it lies, and keys and controls change it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image
from playwright.sync_api import Page

import pointloom as loom
from pointloom.app.cli import cli

from .pixels import count_pixels, middle_of, picture, wait_for_picture, wait_until_still

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
WHITE, BRICK = (255, 255, 255), (204, 64, 51)
WIDTH, HEIGHT = 900, 640


@pytest.fixture
def show(open_page) -> Iterator[Callable[..., tuple[loom.Viewer, Page]]]:
    """Draw geometries and open their page."""
    viewers = []

    def show_one(geometries: Any, **settings: Any) -> tuple[loom.Viewer, Page]:
        viewer = loom.draw(geometries, port=0, block=False, open_browser=False, **settings)
        assert isinstance(viewer, loom.Viewer)
        viewers.append(viewer)
        return viewer, open_page(viewer.url, width=WIDTH, height=HEIGHT)

    yield show_one
    for viewer in viewers:
        viewer.close()


def sphere() -> loom.TriangleMesh:
    return loom.TriangleMesh.create_sphere(1.0)


def trajectory() -> loom.Trajectory:
    poses = np.tile(np.eye(4), (20, 1, 1))
    poses[:, 0, 3], poses[:, 1, 3] = np.linspace(0, 2, 20), np.sin(np.linspace(0, 6, 20))
    return loom.Trajectory(poses)


def grid_cloud() -> loom.PointCloud:
    return loom.PointCloud(np.stack(np.meshgrid(*[np.linspace(0, 1, 12)] * 3), -1).reshape(-1, 3))


def at(x: float) -> np.ndarray:
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


CORNERS = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 1]])

# What is drawn, and how many pixels are the least: lines are thin.
KINDS: dict[str, tuple[Callable[[], Any], int]] = {
    "cloud": (grid_cloud, 3_000),
    "mesh": (sphere, 40_000),
    "lines": (lambda: loom.LineSet(CORNERS, [[0, 1], [1, 2], [2, 3], [3, 0]]), 400),
    "box": (lambda: loom.AxisAlignedBoundingBox((0, 0, 0), (1, 2, 1)), 800),
    "oriented box": (lambda: loom.OrientedBoundingBox((0, 0, 0), np.eye(3), (1, 2, 1)), 800),
    "trajectory": (trajectory, 200),
    "voxel grid": (lambda: sphere().voxelize(0.25), 30_000),
    "array": (lambda: np.random.default_rng(0).random((2000, 3)), 3_000),
}


def test_each_kind_is_seen_in_its_colour(show):
    """Not in a primary colour: the page's tone mapping reaches none on surfaces, so that no mistake would show."""
    viewer, page = show([])
    for kind, (make, least) in KINDS.items():
        viewer.clear()
        wait_for_picture(page, lambda image: count_pixels(image, BRICK, 60) == 0)
        viewer.add(kind, make(), color=np.array(BRICK) / 255, shaded=False, line_width=4)
        image = wait_for_picture(page, lambda image, least=least: count_pixels(image, BRICK, 25) > least)
        assert count_pixels(image, WHITE, 5) > 0.2 * image[..., 0].size, kind


def test_geometries_in_one_scene_keep_their_colours_and_places(show):
    scene = [
        {"geometry": grid_cloud().translate((-2.5, 0, 0)), "name": "cloud", "color": (1, 0, 0)},
        {"geometry": sphere(), "name": "ball", "color": np.array(BRICK) / 255, "shaded": False},
        {"geometry": loom.LineSet([[-2, 0, -1], [2, 0, -1]], [[0, 1]]), "color": (0, 0, 1), "line_width": 3},
    ]
    _, page = show(scene, front=(0, -1, 0), up=(0, 0, 1), lookat=(0, 0, 0), zoom=0.8)
    image = wait_for_picture(page, lambda image: all(count_pixels(image, c) > 300 for c in (RED, BRICK, BLUE)))
    assert middle_of(image, RED)[0] < middle_of(image, BRICK)[0] < image.shape[1]
    assert middle_of(image, BLUE)[1] > middle_of(image, BRICK)[1]


def test_three_hundred_thousand_points_are_drawn_in_software(show):
    points = np.random.default_rng(0).random((300_000, 3))
    viewer, page = show({"geometry": points, "color": (0, 0, 1)})
    image = wait_for_picture(page, lambda image: count_pixels(image, BLUE) > 80_000, seconds=40)
    assert page.get_by_text("300,000 points").count() == 1
    assert count_pixels(image, BLUE) > 80_000
    assert len(viewer.items) == 1


def corners_of(viewer: loom.Viewer, points: np.ndarray) -> np.ndarray:
    """Where points [n, 3] of the world are in the page [px], by the view that the page reported."""
    view = viewer.get_view()
    T_camera_world = np.linalg.inv(view.T_world_camera)
    x, y, z = T_camera_world[:3, :3] @ points.T + T_camera_world[:3, 3:]
    scale = HEIGHT / view.intrinsic.height
    camera = view.intrinsic
    return scale * np.stack([camera.fx * x / z + camera.cx, camera.fy * y / z + camera.cy], -1)


@pytest.mark.parametrize("origin", [(0, 0, 0), (691_000.0, 5_336_000.0, 520.0)], ids=["near", "UTM"])
def test_points_are_drawn_where_they_lie_far_from_the_origin_too(origin, show):
    """Four single points of their own colours, 1 m apart; float32 at 5,336 km would step by half a metre."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]]) + origin
    colors = np.array([RED, GREEN, BLUE, (255, 0, 255)], np.uint8)
    cloud = loom.PointCloud(points, colors=colors)
    viewer, page = show(
        {"geometry": cloud, "point_size": 9},
        front=(0.2, -0.3, 1),
        up=(0, 1, 0),
        lookat=(*(np.array(origin) + 0.5)[:2], origin[2]),
        zoom=0.9,
    )
    image = wait_for_picture(page, lambda image: all(count_pixels(image, tuple(c)) > 20 for c in colors.tolist()))
    image = wait_until_still(page)
    seen = np.array([middle_of(image, tuple(c)) for c in colors.tolist()])
    np.testing.assert_allclose(seen, corners_of(viewer, points), atol=2.0)


def test_a_far_cloud_does_not_jitter_as_the_camera_turns(show):
    origin = np.array([691_000.0, 5_336_000.0, 520.0])
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]]) + origin
    colors = np.array([RED, GREEN, BLUE, (255, 0, 255)], np.uint8)
    viewer, page = show({"geometry": loom.PointCloud(points, colors=colors), "point_size": 9})
    middle = np.array([0.5, 0.5, 0.0])
    for x in np.linspace(-0.5, 0.5, 4):
        viewer.set_view(front=(x, -0.4, 1), up=(0, 1, 0), lookat=origin + middle, zoom=0.9)
        page.wait_for_timeout(500)
        image = wait_until_still(page)
        seen = np.array([middle_of(image, tuple(c)) for c in colors.tolist()])
        np.testing.assert_allclose(seen, corners_of(viewer, points), atol=2.0)


# -- keys and controls ------------------------------------------------------------------------------------------------


def press(page: Page, key: str) -> None:
    page.mouse.click(300, HEIGHT - 20)  # the keys go to the scene, not to a control
    page.keyboard.press(key)


def _changed(image: np.ndarray, before: np.ndarray) -> int:
    """Pixels that differ visibly."""
    return int((np.abs(image.astype(int) - before).max(axis=-1) > 30).sum())


def test_keys_and_slider_change_the_size_of_points(show):
    _, page = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    before = count_pixels(wait_for_picture(page, lambda image: count_pixels(image, RED) > 2000), RED)
    for _ in range(3):
        press(page, "+")
    larger = count_pixels(wait_for_picture(page, lambda image: count_pixels(image, RED) > 1.8 * before), RED)
    for _ in range(5):
        press(page, "-")
    wait_for_picture(page, lambda image: 0 < count_pixels(image, RED) < 0.5 * larger)
    page.get_by_role("slider").first.focus()
    for _ in range(40):
        page.keyboard.press("ArrowRight")
    wait_for_picture(page, lambda image: count_pixels(image, RED) > 1.5 * larger)


def test_n_and_w_show_and_hide_normals_and_edges(show):
    scene = [
        {"geometry": grid_cloud().estimate_normals(max_nn=12), "name": "cloud", "color": (1, 0, 0)},
        {"geometry": sphere(), "name": "ball", "color": np.array(BRICK) / 255, "shaded": False, "pose": at(3.0)},
    ]
    viewer, page = show(scene)
    wait_for_picture(page, lambda image: count_pixels(image, RED) > 1000 and count_pixels(image, BRICK) > 10_000)
    before = wait_until_still(page)
    for key, is_on in (("n", lambda: viewer.normals), ("w", lambda: viewer.wireframe)):
        press(page, key)
        wait_for_picture(page, lambda image: _changed(image, before) > 1500)
        assert is_on()
        press(page, key)
        wait_for_picture(page, lambda image: _changed(image, before) < 200)
        assert not is_on()
    page.locator("input[type=text], input[inputmode=decimal]").first.focus()
    page.keyboard.press("w")  # a letter, there
    page.wait_for_timeout(500)
    assert not viewer.wireframe


def test_r_comes_back_to_where_the_page_began(show):
    _, page = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    wait_for_picture(page, lambda image: count_pixels(image, RED) > 1500)
    before = wait_until_still(page)
    page.mouse.move(300, 400)
    page.mouse.down()
    page.mouse.move(450, 440, steps=5)
    page.mouse.up()
    page.mouse.wheel(0, 400)
    wait_for_picture(page, lambda image: _changed(image, before) > 1500)
    press(page, "r")
    wait_for_picture(page, lambda image: _changed(image, before) < 500)


def test_a_box_that_is_not_ticked_hides_its_geometry(show):
    scene = [
        {"geometry": grid_cloud(), "name": "near", "color": (1, 0, 0)},
        {"geometry": grid_cloud().translate((2, 0, 0)), "name": "far", "color": (0, 0, 1)},
    ]
    _, page = show(scene)
    wait_for_picture(page, lambda image: min(count_pixels(image, RED), count_pixels(image, BLUE)) > 2000)
    page.get_by_label("near").uncheck()
    wait_for_picture(page, lambda image: count_pixels(image, RED) == 0 and count_pixels(image, BLUE) > 2000)
    page.get_by_label("near").check()
    wait_for_picture(page, lambda image: min(count_pixels(image, RED), count_pixels(image, BLUE)) > 2000)


# -- what a program does ----------------------------------------------------------------------------------------------


def test_update_shows_another_geometry_without_a_gap(show):
    viewer, page = show({"geometry": grid_cloud(), "name": "cloud", "color": (1, 0, 0)})
    wait_for_picture(page, lambda image: count_pixels(image, RED) > 1500)
    least = []
    for step in range(8):
        viewer.update("cloud", grid_cloud().translate((0.02 * step, 0, 0)))
        least.append(count_pixels(picture(page), RED))
    assert min(least) > 2000


def test_a_pose_moves_what_is_seen(show):
    viewer, page = show({"geometry": grid_cloud(), "name": "cloud", "color": (1, 0, 0)}, front=(0, 0, 1), up=(0, 1, 0))
    wait_for_picture(page, lambda image: count_pixels(image, RED) > 1500)
    before = middle_of(wait_until_still(page), RED)
    viewer.set_pose("cloud", at(0.3))
    wait_for_picture(page, lambda image: middle_of(image, RED)[0] > before[0] + 25)


def test_a_page_that_reconnects_sees_the_clouds_again(show, open_page):
    viewer, page = show(
        [
            {"geometry": grid_cloud(), "color": (1, 0, 0)},
            {"geometry": sphere(), "pose": at(3.0), "color": np.array(BRICK) / 255, "shaded": False},
        ]
    )
    both = lambda image: count_pixels(image, RED) > 1500 and count_pixels(image, BRICK) > 5_000  # noqa: E731
    wait_for_picture(page, both)
    first = set(viewer.sessions)
    viewer.server.disconnect_all()
    page.wait_for_timeout(500)
    wait_for_picture(page, lambda image: both(image) and bool(viewer.sessions) and first.isdisjoint(viewer.sessions))


def test_two_pages_of_one_viewer_look_elsewhere(show, open_page):
    viewer, one = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    two = open_page(viewer.url, width=WIDTH, height=HEIGHT)
    wait_for_picture(one, lambda image: count_pixels(image, RED) > 1500)
    wait_for_picture(two, lambda image: count_pixels(image, RED) > 1500)
    before = wait_until_still(one)
    two.mouse.move(300, 300)
    two.mouse.wheel(0, -600)
    wait_for_picture(two, lambda image: _changed(image, before) > 5000)
    assert _changed(picture(one), before) < 200


def test_a_million_points_are_seen(show, record_property):
    points = np.random.default_rng(0).random((1_000_000, 3)).astype(np.float32)
    start = time.monotonic()
    _, page = show({"geometry": points, "color": (0, 0, 1)})
    wait_for_picture(page, lambda image: count_pixels(image, BLUE) > 100_000, seconds=60)
    record_property("seconds_to_the_first_picture", round(time.monotonic() - start, 1))


def test_the_command_writes_the_picture_that_a_page_shows(show, tmp_path):
    """The file is drawn without a browser, from the view with which a page begins."""
    cloud = loom.PointCloud(grid_cloud().points, colors=np.tile(np.array(BRICK, np.uint8), (12**3, 1)))
    loom.write_point_cloud(tmp_path / "cloud.ply", cloud)
    done = CliRunner().invoke(cli, ["view", str(tmp_path / "cloud.ply"), "--screenshot", str(tmp_path / "picture.png")])
    assert done.exit_code == 0, done.output
    file = np.asarray(Image.open(tmp_path / "picture.png").convert("RGB"))
    _, page = show(cloud)
    wait_for_picture(page, lambda image: count_pixels(image, BRICK) > 1000)
    canvas = page.locator("canvas").first.bounding_box()
    assert canvas is not None
    seen = wait_until_still(page)[:, : int(canvas["width"])]  # the panel stands beside it
    shares = [np.array(middle_of(image, BRICK)) / image.shape[1::-1] for image in (file, seen)]
    np.testing.assert_allclose(*shares, atol=0.02)
