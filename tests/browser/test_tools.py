"""The tools in Chromium, by mouse and keyboard: a click selects the point under it."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.viewer import Viewer

from ..visualization.viewer.stand_in import waves
from .pixels import SENDS_CLICKS, count_pixels, ready, see, wait_until

BLUE, RED, MARK = (0, 0, 255), (255, 0, 0), (230, 60, 20)
UTM = np.array([412_345.0, 5_412_345.0, 300.0])
EVIL = "<img src=x onerror=document.title='evil'> [a](javascript:b) {1+1}"


def cloud_of(points: np.ndarray, color: tuple[int, int, int], **attributes: Any) -> loom.PointCloud:
    return loom.PointCloud(points, colors=np.tile(np.array(color) / 255, (len(points), 1)), **attributes)


@pytest.fixture
def viewer(tmp_path, monkeypatch) -> Iterator[Viewer]:
    monkeypatch.chdir(tmp_path)  # to check that nothing is written there
    with Viewer(port=0) as viewer:
        yield viewer


class Visitor:
    """A page with its session's tools."""

    def __init__(self, viewer: Viewer, open_page: Callable[..., Any], color: tuple[int, int, int] = BLUE):
        existing = set(viewer.sessions)
        self.page = open_page(viewer, width=1280, height=800)
        self.picture = see(self.page, lambda image: count_pixels(image, color) > 1000)
        (self.session,) = (session for number, session in viewer.sessions.items() if number not in existing)
        self.box = self.session.tools

    def until(self, claim: Callable[[], Any]) -> None:
        wait_until(self.page, claim, lambda: f"the panel says {self.box.stage.status.value!r}")

    def start(self, label: str) -> Any:
        self.page.locator("#panel").get_by_role("button", name=label).click()
        self.until(lambda: self.box.tool is not None and self.box.tool.label == label)
        ready(self.page)
        assert self.page.evaluate(SENDS_CLICKS)
        return self.box.tool

    def draw(self, *corners: tuple[float, float]) -> None:
        """Click the corners of a polygon one after the other, as users do."""
        for x, y in corners:
            count = len(self.box.tool._corners)
            self.click(x, y)
            self.until(lambda count=count: len(self.box.tool._corners) == count + 1)

    def click(self, x: float, y: float) -> None:
        """Click at a View's column and row: whole numbers are centers of pixels there."""
        canvas = self.page.locator("#picture").bounding_box()
        self.page.mouse.click(canvas["x"] + x + 0.5, canvas["y"] + y + 0.5)

    def click_on(self, position: Any) -> None:
        self.click(*project(self.session.camera_view(), position)[:2])


@pytest.mark.parametrize("shift", [np.zeros(3), UTM], ids=["here", "UTM"])
def test_a_click_on_a_point_shows_its_index_coordinates_and_attributes(viewer, open_page, shift):
    points = waves() + shift
    viewer.add("waves", cloud_of(points, BLUE, **{EVIL: np.arange(len(points)) * 2}))
    visitor = Visitor(viewer, open_page)
    visitor.start("Pick a point")
    title = visitor.page.title()
    for index in (500, 820, 1033, 390):
        visitor.click_on(points[index])
        visitor.until(lambda index=index: ("index", f"{index:,}") in visitor.box.stage.rows.value)
        table = visitor.page.locator("table").first
        table.get_by_text(f"{index:,}", exact=True).wait_for()
        names, texts = (table.locator(kind).all_inner_texts() for kind in ("th", "td"))
        values = dict(zip(names, texts, strict=True))
        assert [float(values[axis]) for axis in "xyz"] == pytest.approx(points[index], abs=2e-5)
        assert values["color"] == "0 0 255" and values[EVIL] == f"{2 * index}"  # as text, exactly
    visitor.click(640, 20)
    visitor.until(lambda: "Nothing there" in visitor.box.stage.status.value)
    assert visitor.page.title() == title and visitor.page.locator("img[src=x]").count() == 0


def test_a_polygon_drawn_with_the_mouse_crops_like_open3d_and_can_be_undone(viewer, open_page, tmp_path):
    import open3d as o3d

    points = np.vstack([waves(60), waves(60) + np.array([0.01, 0.02, 1.0])])
    viewer.add("waves", cloud_of(points, BLUE))
    visitor = Visitor(viewer, open_page)
    visitor.start("Crop by polygon")
    visitor.draw((420, 250), (800, 180), (760, 560), (600, 430), (450, 640), (300, 300))
    visitor.page.keyboard.press("Backspace")
    visitor.until(lambda: len(visitor.box.tool._corners) == 5)
    view = visitor.session.camera_view()
    with visitor.page.expect_download() as download:
        visitor.page.keyboard.press("Enter")
    download.value.save_as(tmp_path / download.value.suggested_filename)
    visitor.until(lambda: "waves (cropped)" in viewer.items and not viewer.items["waves"].visible)
    cropped_points = viewer.items["waves (cropped)"].cloud.points
    volume = o3d.visualization.read_selection_polygon_volume(str(tmp_path / "cropped.json"))
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(viewer.items["waves"].cloud.points.copy()))
    np.testing.assert_array_equal(np.asarray(volume.crop_point_cloud(cloud).points), cropped_points)
    assert 500 < len(cropped_points) < 3000
    assert len(json.loads((tmp_path / "cropped.json").read_text())["bounding_polygon"]) == 5
    pixels = np.array([project(view, point)[:2] for point in cropped_points])
    assert (pixels.min(axis=0) > (419, 179)).all() and (pixels.max(axis=0) < (801, 641)).all()
    few = see(visitor.page, lambda image: count_pixels(image, MARK) == 0)
    visitor.page.get_by_role("button", name="Undo crop").click()
    visitor.until(lambda: "waves (cropped)" not in viewer.items and viewer.items["waves"].visible)
    see(visitor.page, lambda image: count_pixels(image, BLUE) > 2 * count_pixels(few, BLUE))


def test_escape_leaves_no_trace(viewer, open_page, tmp_path):
    points = waves()
    viewer.add("waves", cloud_of(points, BLUE))
    visitor = Visitor(viewer, open_page)
    view = visitor.session.camera_view()
    blue = count_pixels(visitor.picture, BLUE)
    for label in ("Crop by polygon", "Measure"):
        visitor.start(label)
        if label == "Measure":
            for number, index in enumerate((500, 1033)):
                visitor.click_on(points[index])
                visitor.until(lambda n=number: len(visitor.box.tool._picks) == n + 1)
        else:
            visitor.draw((500, 300), (700, 300), (600, 500))
        see(visitor.page, lambda image: count_pixels(image, MARK) > 100)
        visitor.page.keyboard.press("Escape")
        visitor.until(lambda: visitor.box.tool is None)
        image = see(visitor.page, lambda image: count_pixels(image, MARK) == 0)
        assert abs(count_pixels(image, BLUE) - blue) < 0.02 * blue
    after = visitor.session.camera_view()
    np.testing.assert_allclose(after.T_world_camera, view.T_world_camera, atol=1e-6)
    assert after.intrinsic.fy == pytest.approx(view.intrinsic.fy)
    assert list(viewer.items) == ["waves"] and list(tmp_path.iterdir()) == [] and not visitor.box.stage._nodes


def test_pairs_picked_with_the_mouse_bring_two_clouds_together(viewer, open_page, tmp_path):
    points = waves()
    rotation = np.array([[0.9, -np.sqrt(0.19), 0], [np.sqrt(0.19), 0.9, 0], [0, 0, 1]])
    moved = points @ rotation.T + [0.4, -0.3, 1.5]
    viewer.add("source", cloud_of(moved, RED))
    viewer.add("target", cloud_of(points, BLUE))
    visitor = Visitor(viewer, open_page)
    tool = visitor.start("Register by pairs")
    for number, (a, b) in enumerate([(500, 500), (1033, 1033), (820, 821), (390, 390)]):  # one is off by a point
        visitor.click_on(viewer.items["source"].cloud.points[a])
        visitor.until(lambda n=number: len(tool._picks) == 2 * n + 1)
        visitor.click_on(points[b])
        visitor.until(lambda n=number: len(tool._picks) == 2 * n + 2)
    assert [pick.index for pick in tool._picks] == [500, 500, 1033, 1033, 820, 821, 390, 390]
    visitor.page.keyboard.press("Enter")
    visitor.until(lambda: "is registered to target" in visitor.box.stage.status.value)
    pose = viewer.items["source"].pose
    assert np.abs(moved @ pose[:3, :3].T + pose[:3, 3] - points).max() < 1e-3
    with visitor.page.expect_download(lambda download: download.suggested_filename == "pairs.txt") as download:
        visitor.page.get_by_role("button", name="Save pairs and pose").click()
    download.value.save_as(tmp_path / "pairs.txt")
    np.testing.assert_allclose(np.loadtxt(tmp_path / "pairs.txt"), pose, atol=1e-12)


def test_two_pages_use_other_tools_at_once_and_one_goes(viewer, open_page):
    points = waves()
    viewer.add("waves", cloud_of(points, BLUE))
    one, two = Visitor(viewer, open_page), Visitor(viewer, open_page)
    one.start("Pick a point")
    two.start("Measure")
    one.click_on(points[500])
    two.click_on(points[820])
    one.until(lambda: ("index", "500") in one.box.stage.rows.value)
    two.until(lambda: len(two.box.tool._picks) == 1)
    two.page.close()
    one.until(lambda: two.session.closed and len(viewer.sessions) == 1)
    one.click_on(points[1033])
    one.until(lambda: ("index", "1,033") in one.box.stage.rows.value)


def test_clip_planes_hide_points_and_parts_of_a_mesh_until_they_are_off(viewer, open_page):
    viewer.add("waves", cloud_of(waves(), BLUE))
    viewer.add("box", loom.TriangleMesh.create_box(1, 1, 1), color=(1, 0, 0), shaded=False)
    visitor = Visitor(viewer, open_page)
    red, blue = (count_pixels(visitor.picture, color) for color in (RED, BLUE))
    page = visitor.page
    page.locator("summary", has_text="Clip planes").click()
    page.get_by_role("spinbutton", name="x, high, as a number").fill("0.5")
    page.keyboard.press("Enter")
    page.get_by_role("checkbox", name="clip", exact=True).check()
    see(page, lambda image: 0.2 * red < count_pixels(image, RED) < 0.9 * red and count_pixels(image, BLUE) < 0.8 * blue)
    page.get_by_role("checkbox", name="clip", exact=True).uncheck()
    see(page, lambda image: abs(count_pixels(image, RED) - red) < 0.02 * red and count_pixels(image, BLUE) > 0.9 * blue)
