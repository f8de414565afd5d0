"""A page takes back what it changed in a viewer, labels that it painted are the viewer's, and pictures leave out what
is filtered away."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.viewer.painted import begin_painting, show_painting

from .stand_in import page_in


@pytest.fixture
def viewer(rng):
    points = rng.uniform(-1, 1, (3000, 3)) * [1, 1, 0.1]
    with loom.Viewer(port=0, size=(160, 120)) as viewer:
        viewer.add("scan", loom.PointCloud(points, level=points[:, 0], label=(points[:, 1] > 0).astype(np.uint8)))
        viewer.add("boxes/1", loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1]))
        yield viewer


def settle(viewer, page):
    page.settle()
    toolbox = next(iter(viewer.sessions.values()))._toolbox
    toolbox._worker.submit(lambda: None).result(timeout=60)


def key(viewer, page, name):
    page.key(name)
    settle(viewer, page)


def test_what_a_page_changes_for_all_is_taken_back_one_by_one(viewer):
    with page_in(viewer) as page:
        tree = page.of_kind("tree")[0]
        page.say("value", id=tree.id, value=[["scan"], False])
        page.set("by", "level")
        page.set("point size", 7.0)
        key(viewer, page, "N")
        assert not viewer.items["scan"].visible and viewer.coloring.by == "level" and viewer.point_size == 7
        told = []
        for _ in range(5):
            key(viewer, page, "Ctrl+Z")
            told.append(page.others("notify")[-1].text)
        assert told == [
            "Taken back: Show normals",
            "Taken back: Points of 7 px",
            "Taken back: Colour by level",
            "Taken back: Hide scan",
            "There is nothing to take back.",
        ]
        assert viewer.items["scan"].visible and viewer.coloring.by is None and viewer.point_size == 3
        assert not viewer.normals
        for _ in range(3):
            key(viewer, page, "Ctrl+Shift+Z")
        assert not viewer.items["scan"].visible and viewer.point_size == 7 and not viewer.normals


def test_what_another_page_changed_meanwhile_stays(viewer):
    with page_in(viewer) as page:
        page.set("by", "level")
        viewer.point_size = 9
        viewer.set_visible("boxes/1", False)
        key(viewer, page, "Ctrl+Z")
        assert viewer.coloring.by is None and viewer.point_size == 9 and not viewer.items["boxes/1"].visible


def test_painted_labels_are_the_viewers_and_in_its_colours(viewer):
    given = viewer.items["scan"].cloud
    assert viewer.painted("scan") is None
    painting = begin_painting(viewer, "scan", "label")
    painting.add_class(7, "kerb", (255, 0, 255))
    viewer.color_by("label")
    rows = np.flatnonzero(given.points[:, 0] > 0.5)
    painting.paint(rows, 7)
    show_painting(viewer, "scan")
    item = viewer.items["scan"]
    np.testing.assert_array_equal(viewer.painted("scan"), item.cloud["label"])
    assert (viewer.painted("scan")[rows] == 7).all() and (given["label"] != 7).all()
    assert (item.colors_of(rows) == (255, 0, 255)).all() and item.coloring.names[7] == "kerb"
    assert (viewer.screenshot() == (255, 0, 255)).all(axis=2).sum() > 100
    painting.paint(rows[:1], 0)
    with pytest.raises(ValueError, match="not saved yet"):
        begin_painting(viewer, "scan", "other")
    viewer.update("scan", given)
    assert viewer.painted("scan") is None


def test_pictures_of_a_page_leave_out_what_its_filters_hide(viewer):
    with page_in(viewer) as page:
        page.set("by", "label")
        settle(viewer, page)
        settle(viewer, page)
        page.set("filter by", "label")
        settle(viewer, page)
        whole = viewer.screenshot()
        tick = next(one.label for one in page.controls.values() if str(one.get("label")).startswith("label 0 ("))
        page.set(tick, False)
        settle(viewer, page)
        left = viewer.screenshot()
        drawn = [(picture != 255).any(axis=2).sum() for picture in (whole, left)]
        assert 0.3 * drawn[0] < drawn[1] < 0.8 * drawn[0]


def test_labels_that_nobody_saved_are_told_as_the_viewer_is_closed(viewer, caplog):
    painting = begin_painting(viewer, "scan", "label")
    painting.paint([1, 2], 5)
    viewer.painted("scan")
    painting.paint([3], 6)
    viewer.close()
    assert "1 change of scan" in caplog.text
