"""A page takes back what it changed; painted labels are the viewer's; pictures leave out what is filtered away."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.drawing.viewer import history as module
from pointloom.drawing.viewer.history import Change, History
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


class Page:
    def __init__(self):
        self.now, self.value = 0.0, 0
        self.history = History(clock=lambda: self.now)

    def put(self, value):
        self.value = value

    def change(self, value, key=None, nbytes=0):
        before, self.value = self.value, value
        undo, redo = (lambda: self.put(before)), (lambda: self.put(value))
        self.history.add(Change(f"Set {value}", undo, redo, key, nbytes))


def test_changes_are_taken_back_in_their_order_and_done_again():
    page = Page()
    for value in (1, 2, 3):
        page.change(value)
    assert [page.history.undo() for _ in range(2)] == ["Taken back: Set 3", "Taken back: Set 2"] and page.value == 1
    assert page.history.redo() == "Done again: Set 2" and page.value == 2
    page.change(7)
    assert page.history.redo() == "There is nothing to do again." and page.history.labels()[0] == [
        "Set 1",
        "Set 2",
        "Set 7",
    ]
    for _ in range(3):
        page.history.undo()
    assert page.value == 0 and page.history.undo() == "There is nothing to take back."


def test_a_slider_that_is_dragged_is_one_change():
    page = Page()
    for value in range(1, 6):
        page.now += 0.3
        page.change(value, key="size")
    page.now += 5
    page.change(9, key="size")
    page.history.undo()
    assert page.value == 5
    page.history.undo()
    assert page.value == 0
    page.history.redo()
    assert page.value == 5


def test_what_a_change_does_while_it_is_taken_back_is_no_change():
    page = Page()
    page.history.add(Change("Twice", lambda: page.change(4), lambda: page.change(5)))
    page.history.undo()
    assert page.value == 4 and page.history.labels() == ([], ["Twice"])


def test_a_change_of_what_has_gone_says_so():
    page = Page()

    def fails():
        raise ValueError("scan is no longer in the scene")

    page.history.add(Change("Hide scan", fails, fails))
    assert page.history.undo() == "Cannot be taken back: Hide scan: scan is no longer in the scene"
    assert page.history.labels() == ([], [])


def test_a_history_is_bounded_by_number_and_memory():
    page = Page()
    for value in range(module.MOST + 10):
        page.change(value)
    assert len(page.history.labels()[0]) == module.MOST
    for _ in range(module.MOST):
        page.history.undo()
    assert "the 10 before are no longer kept" in page.history.undo()
    for value in range(4):
        page.change(value, nbytes=module.MOST_BYTES // 2)
    assert len(page.history.labels()[0]) == 2
