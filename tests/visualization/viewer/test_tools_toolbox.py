"""The tools in a simulated page: clicks, keys, buttons, and complete cleanup."""

import json
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.tools.polygon_crop import looks_along_axis

from .stand_in import StandIn, waves


@pytest.fixture
def stand_in():
    """Open a page of these geometries; it is closed after the test."""
    pages = []

    def open_one(**geometries):
        pages.append(StandIn(**geometries))
        return pages[-1]

    yield open_one
    for page in pages:
        page.box.close()


@pytest.fixture
def page(stand_in):
    return stand_in(waves=loom.PointCloud(waves(), level=np.arange(1600, dtype=np.int32)))


TRIANGLE = ((300, 200), (700, 220), (640, 600))


def draw(page, *corners):
    for corner in corners:
        page.click(*corner)
    page.key("enter")


def pick_pairs(page, rows, source, target):
    for row in rows:
        click_on(page, source[row])
        click_on(page, target[row])


def click_on(page, position):
    page.click(*project(page.now, position)[:2])


def test_one_tool_is_at_work_at_a_time_and_its_button_ends_it(page):
    points, before = waves(), {*page.page.controls}
    page.press("Pick a point")
    page.press("Measure")
    for index in (500, 820):
        click_on(page, points[index])
    assert f"{np.linalg.norm(points[820] - points[500]):.4f} m" in page.table and "index" not in page.table
    page.press("Measure")
    for key in ("", "escape", "enter", "backspace"):
        if key:
            page.key(key)
        click_on(page, points[777])
        assert {*page.page.controls} == before and page.page.nodes == {} and page.table == ""


def test_a_picked_point_is_reported_and_marked(page):
    page.press("Pick a point")
    click_on(page, waves()[777])
    assert "| index | 777 |" in page.table and "| level | 777 |" in page.table
    dot, words = page.page.nodes.values()
    assert (dot.kind, words.text) == ("points", "777")
    position = np.reshape(words.pose, (3, 4))[:, 3] + page.scene.frame.origin
    marked, clicked = (project(page.now, at)[:2] for at in (position, waves()[777]))
    np.testing.assert_allclose(marked, clicked, atol=0.1)
    page.click(2, 2)
    assert "Nothing there" in page.status and page.table == "" and page.page.nodes == {}


def test_names_from_files_are_shown_as_they_are_in_controls_of_plain_text(stand_in):
    name = "<img src=x onerror=alert(1)>|[a](javascript:b) *c* `d`"
    page = stand_in(**{name: loom.PointCloud(waves())})
    page.press("Pick a point")
    click_on(page, waves()[777])
    kinds = {control.kind for control in page.page.controls.values() if name in str(control.get("value"))}
    assert kinds == {"table"} and f"| in | {name} |" in page.table


def test_a_surface_is_picked_where_it_is_met(stand_in):
    page = stand_in(box=loom.TriangleMesh.create_box(1, 1, 1))
    page.press("Pick a point")
    click_on(page, [0.5, 0.25, 1.0])
    assert "| triangle |" in page.table and "| z | 1 |" in page.table


def test_clicks_measure_and_backspace_takes_one_back(page):
    points = waves()
    page.press("Measure")
    for index in (500, 820, 1033):
        click_on(page, points[index])
    assert "over 2 parts" in page.table and "angle" in page.table
    page.key("backspace")
    assert f"{np.linalg.norm(points[820] - points[500]):.4f} m" in page.table and "parts" not in page.table
    page.key("enter")
    assert page.table == "" and page.page.nodes == {}


def test_lengths_are_measured_in_the_unit_of_the_clicked_cloud(stand_in):
    other = loom.PointCloud(waves() + np.array([10, 0, 0]))
    page = stand_in(waves=loom.PointCloud(waves(), unit="foot"), other=other)
    page.press("Measure")
    for index in (500, 820):
        click_on(page, waves()[index])
    length = np.linalg.norm(waves()[820] - waves()[500])
    assert f"| distance | {length:.4f} ft |" in page.table and " m " not in page.table
    other.unit = "metre"
    click_on(page, waves()[500] + np.array([10, 0, 0]))
    assert "one is in foot, the other in metre: expected equal units to measure a length" in page.status
    assert page.table == ""


def files_of(page, folder):
    """Write the page's downloads into a folder; return the names in order."""
    files = page.page.others("download")
    for file in files:
        (folder / file.name).write_bytes(bytes(file.data))
    return [file.name for file in files]


def test_a_polygon_is_drawn_saved_cropped_and_undone(page, tmp_path):
    before = page.now
    page.press("Crop by polygon")
    assert looks_along_axis(page.now)
    for corner in ((300, 200), (700, 220), (640, 600), (20, 20)):
        page.click(*corner)
    page.key("backspace")
    page.key("enter")
    cropped = page.items["waves (cropped)"].cloud
    assert files_of(page, tmp_path) == ["cropped.json"] and "downloaded as cropped.json" in page.status
    volume = loom.SelectionPolygonVolume.from_json(tmp_path / "cropped.json")
    assert len(volume.bounding_polygon) == 3 and 50 < len(cropped) < 800
    assert f"{len(cropped):,} of 1,600 points" in page.status
    np.testing.assert_array_equal(page.items["waves"].cloud.crop(volume).points, cropped.points)
    assert not page.items["waves"].visible and cropped["level"].dtype == page.items["waves"].cloud["level"].dtype
    page.press("Undo crop")
    assert list(page.items) == ["waves"] and page.items["waves"].visible
    page.key("escape")
    assert page.now is before and page.page.nodes == {}


def test_points_hidden_by_clip_planes_are_not_in_a_crop(page):
    page.set("clip", True)
    page.set("x", [0.0, page.page.control("x").max])
    page.press("Crop by polygon")
    draw(page, (1, 1), (998, 1), (998, 798), (1, 798))
    assert len(page.items["waves (cropped)"].cloud) == (waves()[:, 0] >= 0).sum()
    assert "hidden by clip planes" in page.status


def test_a_download_has_a_limit(page, monkeypatch):
    monkeypatch.setattr("pointloom.visualization.viewer.tools.stage.MAX_BYTES", 100)
    page.press("Crop by polygon")
    draw(page, *TRIANGLE)
    assert "pages download at most" in page.status and list(page.items) == ["waves"]
    assert page.page.others("download") == []


def test_corners_stay_on_the_scene_as_the_view_is_moved_along(page):
    page.press("Crop by polygon")
    page.click(300, 200)
    position = page.box.tool._corners[0]
    page.now = type(page.now)(page.now.intrinsic, page.now.T_world_camera.copy())
    page.now.T_world_camera[0, 3] += 0.3
    page.click(700, 220)
    np.testing.assert_array_equal(page.box.tool._corners[0], position)
    assert len(page.box.tool._corners) == 2


def test_a_rotated_view_is_aligned_before_a_corner_counts(page):
    before = page.now
    page.press("Crop by polygon")
    page.now = before
    page.click(500, 400)
    assert looks_along_axis(page.now) and "rotated away" in page.status and page.box.tool._corners == []


def test_a_free_view_crops_the_visible_points_into_a_cloud(page, tmp_path):
    page.press("Crop by polygon")
    page.set("view", "free view")
    assert not looks_along_axis(page.now)
    draw(page, *TRIANGLE)
    assert files_of(page, tmp_path) == ["cropped.ply"]
    saved = loom.read_point_cloud(tmp_path / "cropped.ply")
    np.testing.assert_allclose(saved.points, page.items["waves (cropped)"].cloud.points)
    assert 50 < len(saved) < 800


@pytest.mark.parametrize("corners", [[], [(300, 200), (700, 220)], [(1, 1), (2, 1), (2, 3)]])
def test_a_polygon_without_corners_or_points_crops_nothing(page, corners):
    page.press("Crop by polygon")
    draw(page, *corners)
    assert list(page.items) == ["waves"] and page.page.others("download") == []
    assert "at least three corners" in page.status or "contains no points" in page.status


def test_pairs_register_and_the_old_pose_comes_back(stand_in, tmp_path):
    points = waves()
    page = stand_in(source=loom.PointCloud(points + np.array([0.3, -0.2, 1.2])), target=loom.PointCloud(points))
    page.press("Register by pairs")
    page.key("enter")
    assert "at least three pairs" in page.status
    pick_pairs(page, (500, 1033, 390), points + np.array([0.3, -0.2, 1.2]), points)
    page.key("enter")
    np.testing.assert_allclose(page.items["source"].pose[:3, 3], [-0.3, 0.2, -1.2], atol=1e-4)
    assert "is registered to target" in page.status and "| fitness | 100" in page.table.replace("&#46;", ".")
    page.press("Save pairs and pose")
    assert files_of(page, tmp_path) == ["pairs.json", "pairs.txt"]
    np.testing.assert_allclose(np.loadtxt(tmp_path / "pairs.txt"), page.items["source"].pose, atol=1e-12)
    content = json.loads((tmp_path / "pairs.json").read_text())
    assert content["correspondences"] == [[index] * 2 for index in (500, 1033, 390)] and content["source"] == "source"
    np.testing.assert_allclose(content["T_target_source"], page.items["source"].pose, atol=1e-12)
    page.press("Back to the old pose")
    np.testing.assert_array_equal(page.items["source"].pose, np.eye(4))


def test_posed_clouds_are_registered_at_their_poses(stand_in):
    points = waves()
    page = stand_in(source=loom.PointCloud(points), target=loom.PointCloud(points))
    for name, shift in (("source", [0, 0, 2.0]), ("target", [5.0, 0, 0])):
        pose = np.eye(4)
        pose[:3, 3] = shift
        page.set_pose(name, pose)
    page.now = type(page.now)(page.now.intrinsic, page.now.T_world_camera.copy())
    page.now.T_world_camera[:3, 3] -= 15 * page.now.T_world_camera[:3, 2]
    page.press("Register by pairs")
    pick_pairs(page, (500, 1033, 390), points + np.array([0, 0, 2]), points + np.array([5, 0, 0]))
    assert [pick.index for pick in page.box.tool._picks] == [500, 500, 1033, 1033, 390, 390]
    page.key("enter")
    np.testing.assert_allclose(page.items["source"].pose, page.items["target"].pose, atol=1e-4)


def test_collinear_pairs_are_reported_and_move_nothing(stand_in):
    points = waves()
    points[:, 2] = 0
    page = stand_in(source=loom.PointCloud(points + np.array([0, 0, 1.0])), target=loom.PointCloud(points))
    page.press("Register by pairs")
    pick_pairs(page, (410, 420, 430), points + np.array([0, 0, 1.0]), points)
    page.key("enter")
    assert "are collinear" in page.status and page.items["source"].pose is None


def test_tools_report_missing_input(page):
    page.press("Register by pairs")
    assert "registration requires two clouds" in page.status and page.box.tool is None
    page.set_visible("waves", False)
    page.press("Crop by polygon")
    assert "no cloud to crop" in page.status and page.box.tool is None


def test_clip_planes_hide_points_and_spare_them_from_picking(page):
    points, clip = waves(), page.box.clip_controls
    page.set("x", [clip._ranges[0].min, 0.0])
    page.set("clip", True)
    np.testing.assert_array_equal(page.streams["waves"].keep(points), points[:, 0] <= 0)
    page.press("Pick a point")
    click_on(page, points[1200])
    assert points[1200, 0] > 0.5 and "Nothing there" in page.status
    click_on(page, points[300])
    assert "| index | 300 |" in page.table
    page.streams["waves"] = type(page.streams["waves"])()  # the page received the cloud again
    page.box.refresh()
    page.wait()
    assert page.streams["waves"].keep is not None
    page.set("clip", False)
    assert page.streams["waves"].keep is None


def test_a_cloud_removed_during_a_crop_is_reported(page):
    page.press("Crop by polygon")
    for corner in TRIANGLE:
        page.click(*corner)
    page.items["other"] = page.items.pop("waves")
    page.key("enter")
    assert "no longer in the scene" in page.status.replace("&#46;", ".")


def test_clouds_that_come_meanwhile_are_offered(stand_in):
    page = stand_in(source=loom.PointCloud(waves()), target=loom.PointCloud(waves() + np.array([0, 0, 1.0])))
    for label, control in (("Crop by polygon", "cloud"), ("Register by pairs", "target")):
        page.press(label)
        page.add(f"for {control}", loom.PointCloud(waves()))
        page.box.refresh()
        page.wait()
        assert f"for {control}" in page.page.control(control).options
    assert [page.page.control(name).value for name in ("source", "target")] == ["source", "target"]


def test_a_page_that_has_gone_is_left_alone(page):
    page.press("Pick a point")
    page.box.close()
    page.box.close()
    page.page.send("click", x=0.5, y=0.5)
    page.box.run(lambda: pytest.fail("nobody is there"))


@pytest.mark.parametrize("pixel", [(-30, 5), (5, 1e9)])
def test_a_click_outside_the_screen_is_none(page, pixel):
    page.press("Crop by polygon")
    page.click(*pixel)
    assert page.box.tool._corners == []


def test_a_thousand_clicks_are_stored(page):
    page.press("Crop by polygon")
    page.box.tool._corners = [np.zeros(3)] * 1000
    page.click(500, 400)
    assert "expected at most" in page.status and len(page.box.tool._corners) == 1000


def test_requests_beyond_the_queue_limit_are_dropped(page):
    gate, done = threading.Event(), []
    page.box.run(lambda: gate.wait(30))
    for number in range(500):
        page.box.run(lambda number=number: done.append(number))
    gate.set()
    page.wait()
    assert done == list(range(63))
