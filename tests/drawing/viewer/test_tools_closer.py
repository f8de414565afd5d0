"""The tools that look closer, at work in a page that is a stand-in."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.viewer.coloring_choice import ColoringChoice
from pointloom.drawing.viewer.stills import clipped
from pointloom.drawing.viewer.tools.picking import project

from .stand_in import StandIn

UTM = np.array([412_345.0, 5_412_345.0, 300.0])
SIDE = 120


def heap():
    """A pyramid of 4 by 4 by 1 on a plain of 8 by 8, with an intensity, classes and times."""
    x, y = (8 * (a.ravel() + 0.5) / SIDE - 4 for a in np.mgrid[:SIDE, :SIDE].astype(float))
    z = np.maximum(0, 1 - np.maximum(np.abs(x), np.abs(y)) / 2)
    intensity = np.where(x < -3.5, np.nan, y)
    labels = np.where(z > 0, 6, 2).astype(np.uint8)
    more = {"intensity": intensity, "classification": labels, "gps_time": np.linspace(0, 100, SIDE * SIDE)}
    return loom.PointCloud(np.column_stack([x, y, z]) + UTM, unit="metre", **more)


def nearest(cloud, x, y):
    places = cloud.points - UTM
    return cloud.points[np.hypot(places[:, 0] - x, places[:, 1] - y).argmin()]


class Viewer(StandIn):
    """A page with what painting asks of a viewer."""

    def __init__(self, files, **geometries):
        self.coloring, self.sessions, self.closed = ColoringChoice(), {}, False
        self.panel = SimpleNamespace(put_item=lambda item: None, show_legend=lambda: None)
        super().__init__(files, **geometries)

    def color_by(self, by, **_):
        self.coloring = ColoringChoice(by)

    @property
    def told_rows(self):
        return dict(self.box.stage.rows.value)

    @property
    def notices(self):
        return [notice.text for notice in self.page.others("notify")]

    @property
    def cloud(self):
        return self.items["heap"].cloud


@pytest.fixture
def page(tmp_path):
    page = Viewer(tmp_path, heap=heap())
    yield page
    page.box.close()


def click_on(page, *places):
    for x, y in places:
        page.click(*project(page.now, nearest(page.cloud, x, y))[:2])


def number(page, label):
    """The number that stands beside a label in the table."""
    return float(page.told_rows[label].split()[0].replace(",", ""))


CORNERS = ((-2.5, -2.5), (2.5, -2.5), (2.5, 2.5), (-2.5, 2.5))


def test_an_area_is_told_and_taken_back_by_the_history(page):
    page.press("Area")
    click_on(page, *CORNERS)
    assert number(page, "area") == pytest.approx(25, rel=0.03) and page.told_rows["area"].endswith(" m²")
    full = page.told_rows
    page.key("enter")
    assert page.told_rows == {}
    page.key("Ctrl+Z")
    assert page.told_rows == full
    page.key("backspace")
    assert number(page, "area") == pytest.approx(12.5, rel=0.03)
    page.key("escape")
    page.key("Ctrl+Z")
    assert "the tool Area has ended" in page.notices[-1]


def test_a_heap_has_the_volume_of_a_pyramid(page):
    page.press("Volume")
    click_on(page, *CORNERS)
    page.key("enter")
    assert number(page, "above (cut)") == pytest.approx(16 / 3, rel=0.03) and "is not known" in page.told
    page.set("base", "height")
    page.set("height", 299.0)
    page.key("enter")
    assert number(page, "net") == pytest.approx(16 / 3 + 25, rel=0.03)


def test_hidden_points_count_in_no_volume(page):
    page.press("Volume")
    click_on(page, *CORNERS)
    choose(page, "classification")
    tick(page, "2 ground", False)
    page.set("fill empty cells", False)
    page.key("enter")
    assert "counted as nothing" in page.told_rows["cells without points"]


def test_a_closed_mesh_has_a_volume_and_an_open_one_none(tmp_path):
    box = loom.TriangleMesh.create_box(1, 2, 3)
    for mesh, told in ((box, "6.0000 cubic units"), (box.select_by_index(range(7)), "is not closed")):
        page = Viewer(tmp_path, box=mesh)
        page.press("Volume")
        page.click(*project(page.now, mesh.vertices[mesh.triangles[0]].mean(0))[:2])
        assert told in page.told or told in page.told_rows.get("volume", "")
        page.box.close()


def test_a_profile_is_drawn_and_sent_as_a_table(page):
    page.press("Height profile")
    click_on(page, (-3.8, 0.05), (3.8, 0.05))
    page.set("width, 0: chosen", 0.3)
    page.key("enter")
    assert number(page, "highest") == pytest.approx(301, abs=0.05) and number(page, "lowest") == 300
    page.page.say("press", id=page.page.control("save").id, value="table (CSV)")
    page.wait()
    sent = page.page.others("download")[-1]
    name, content = sent.name, sent.data.tobytes()
    table = np.genfromtxt(content.decode().splitlines(), delimiter=",", names=True)
    rows = table["index"].astype(int)
    np.testing.assert_allclose(page.cloud.points[rows, 2], table["height"], atol=1e-5)
    assert name == "profile.csv" and len(rows) == int(number(page, "points"))


def choose(page, by):
    page.set("filter by", by)


def tick(page, begin, shown):
    label = next(c.label for c in page.page.controls.values() if str(c.get("label")).startswith(begin))
    page.set(label, shown)


def seen(page):
    keep, cloud = page.streams["heap"].keep, page.cloud
    return np.ones(len(cloud), bool) if keep is None else keep(cloud.points, np.arange(len(cloud)))


def test_a_range_hides_points_from_pages_picks_and_pictures(page):
    cloud = page.cloud
    choose(page, "intensity")
    bars = page.page.control("intensity")
    edges = list(bars.edges)
    assert len(bars.counts) == 64 and sum(bars.counts) == np.isfinite(cloud["intensity"]).sum()
    page.set("intensity", [0.0, edges[1]])
    values = cloud["intensity"]
    np.testing.assert_array_equal(seen(page), np.isnan(values) | (values >= 0))
    tick(page, "no value", False)
    np.testing.assert_array_equal(seen(page), values >= 0)
    assert len(clipped(cloud, page.box.stage.clip, None)) == (values >= 0).sum()
    page.press("Pick a point")
    click_on(page, (1.0, -3.0))
    assert "Nothing there" in page.told
    for _ in range(2):
        page.key("Ctrl+Z")
    assert seen(page).all() and list(page.page.control("intensity").value) == edges
    page.key("Ctrl+Shift+Z")
    np.testing.assert_array_equal(seen(page), np.isnan(values) | (values >= 0))


def test_classes_and_planes_hide_together(page):
    cloud = page.cloud
    choose(page, "classification")
    tick(page, "6 building", False)
    page.set("clip", True)
    page.set("x", [UTM[0], page.page.control("x").max])
    np.testing.assert_array_equal(seen(page), (cloud["classification"] == 2) & (cloud.points[:, 0] >= UTM[0]))
    page.press("Remove all filters")
    np.testing.assert_array_equal(seen(page), cloud.points[:, 0] >= UTM[0])


def test_a_window_of_time_plays_on(page):
    choose(page, "gps_time")
    page.set("play", True)
    first = page.page.control("gps_time").value
    page.box.run(page.box.filter._step)
    page.wait()
    second = page.page.control("gps_time").value
    page.set("play", False)
    assert second[0] > first[0] and second[1] - second[0] == pytest.approx(first[1] - first[0])
    times = page.cloud["gps_time"]
    shown = seen(page)
    assert times[shown].min() >= second[0] and times[shown].max() <= second[1] and 1000 < shown.sum() < 2000


def test_a_brush_paints_the_cloud_and_the_history_takes_it_back(page):
    given = page.cloud
    page.press("Paint labels")
    page.set("class", "4 medium vegetation")
    click_on(page, (0.0, 0.0), (3.0, 3.0))
    item = page.items["heap"]
    painted = np.asarray(item.cloud["classification"])
    assert (
        20 < (painted == 4).sum() < 3000
        and item.painting.unsaved == 2
        and "2 changes" in page.told_rows["not saved yet"]
    )
    assert (np.asarray(given["classification"]) != 4).all() and page.cloud is not given
    places = given.points[painted == 4] - UTM
    assert (np.minimum(np.hypot(*places[:, :2].T), np.hypot(*(places[:, :2] - 3).T)) < 1).all()
    page.key("Ctrl+Z")
    page.key("Ctrl+Z")
    np.testing.assert_array_equal(item.cloud["classification"], given["classification"])
    page.key("Ctrl+Shift+Z")
    assert 0 < (np.asarray(item.cloud["classification"]) == 4).sum() < (painted == 4).sum()


def test_hidden_points_are_never_painted(page):
    choose(page, "classification")
    tick(page, "2 ground", False)
    page.press("Paint labels")
    page.set("class", "5 high vegetation")
    page.set("seen points only", False)
    page.set("shape", "polygon")
    for corner in ((1, 1), (998, 1), (998, 798), (1, 798)):
        page.click(*corner)
    page.key("enter")
    before, after = heap()["classification"], np.asarray(page.cloud["classification"])
    np.testing.assert_array_equal(after, np.where(before == 6, 5, before))


@pytest.mark.parametrize("suffix", [".ply", ".npz"])
def test_labels_are_saved_by_the_page_and_those_that_are_not_are_told(page, tmp_path, suffix):
    page.press("Paint labels")
    page.set("new class", "kerb")
    page.press("Add class")
    assert page.page.control("class").value == "8 kerb"
    click_on(page, (0.0, 0.0))
    page.key("escape")
    assert "1 change of heap" in page.notices[-1]
    page.press("Paint labels")
    page.set("file", f"labels{suffix}")
    page.press("Save the labels")
    saved = loom.read_point_cloud(tmp_path / f"labels{suffix}")
    np.testing.assert_array_equal(saved["classification"], page.cloud["classification"])
    assert page.items["heap"].painting.unsaved == 0 and page.told_rows == {} and "saved to" in page.told


def test_clip_planes_and_crops_are_taken_back(page, tmp_path):
    page.set("clip", True)
    page.set("x", [UTM[0], page.page.control("x").max])
    half = page.cloud.points[:, 0] >= UTM[0]
    np.testing.assert_array_equal(seen(page), half)
    page.press("Crop by polygon")
    for corner in ((1, 1), (998, 1), (998, 798), (1, 798)):
        page.click(*corner)
    page.key("enter")
    assert len(page.items["heap (cropped)"].cloud) == half.sum() and "hidden by clip planes or filters" in page.told
    page.key("Ctrl+Z")
    assert list(page.items) == ["heap"] and page.items["heap"].visible and "the file stays" in page.told
    page.key("Ctrl+Shift+Z")
    assert list(page.items) == ["heap", "heap (cropped)"] and not page.items["heap"].visible
    page.remove("heap (cropped)")
    page.remove("heap")
    page.add("other", heap())
    page.key("Ctrl+Z")
    assert "Cannot be taken back" in page.told and "no longer in the scene" in page.told
    page.key("escape")
    page.key("Ctrl+Z")
    assert page.page.control("clip").value is False and page.notices[-1] == "Taken back: Clip planes"


def test_what_comes_can_be_filtered_by_as_well(page):
    page.add("other", loom.PointCloud(heap().points, ring=np.arange(SIDE * SIDE) % 7))
    page.box.run(page.box.filter._offer_names)
    page.wait()
    choose(page, "ring")
    tick(page, "label 3", False)
    keep = page.streams["other"].keep
    assert keep(page.items["other"].cloud.points, np.arange(SIDE * SIDE)).sum() == np.sum(
        np.arange(SIDE * SIDE) % 7 != 3
    )
    assert seen(page).all()
