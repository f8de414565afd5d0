"""Fast first image: clouds arrive in steps at the pace of the page; and the timeline of a live recording."""

import logging
import threading
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import PointloomError
from pointloom.visualization.viewer import live_timeline, point_transfer, scene, sessions
from pointloom.visualization.viewer.detail_tree import DetailTree
from pointloom.visualization.viewer.live_recording import Drawn, moments_of
from pointloom.visualization.viewer.live_timeline import ENTRY_BYTES
from pointloom.visualization.viewer.point_transfer import in_steps
from pointloom.visualization.viewer.scene_edits import requested_by_page
from pointloom.visualization.viewer.tools.clip_planes import Clip
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.viewer import Viewer

from .events import TIMEOUT, join_threads, wait_until
from .stand_in import StandIn, page_in, toolbox_of
from .test_server import run_python

RED = (1.0, 0.0, 0.0)


@pytest.fixture
def small_steps(monkeypatch):
    """Steps of a few hundred points, for pages that send no acknowledgement."""
    for name, value in {"POINTS_IN_FIRST_STEP": 100, "POINTS_PER_STEP": 300, "AT_ONCE": 200}.items():
        monkeypatch.setattr(point_transfer, name, value)
    monkeypatch.setattr(scene, "POINTS_IN_FIRST_STEP", 100)
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 0.01)
    monkeypatch.setattr(sessions, "STEP_PAUSE", 0.0)


def stream_of(shown, name="cloud"):
    wait_until(lambda: bool(shown.sessions))
    with shown.lock:
        return next(iter(shown.sessions.values())).streams[name]


def line_of(shown):
    shown.catch_up()
    return next(iter(shown.sessions.values()))._line.value


def is_feeder(thread):
    """True for a thread of the package that is not shared by kernels."""
    shared = ("pointloom-cpu-", "pointloom-page")  # those of the server, and of its pages
    return thread.name.startswith("pointloom-") and not thread.name.startswith(shared)


def feeders():
    return [thread.name for thread in threading.enumerate() if is_feeder(thread)]


def test_each_point_is_in_one_step_and_each_step_everywhere():
    steps = in_steps(1_000_000)
    assert 100_000 <= len(steps[0]) <= 150_000
    assert (np.sort(np.concatenate(steps)) == np.arange(1_000_000)).all()
    for rows in steps:
        fractions = np.histogram(rows, 10, (0, 1_000_000))[0] / len(rows)
        assert abs(fractions - 0.1).max() < 0.001
    assert [len(rows) for rows in in_steps(150_000)] == [150_000]
    assert [len(rows) for rows in in_steps(0)] == [0]


def test_a_part_comes_at_once_and_the_rest_in_steps(small_steps, rng, viewer, page):
    wait_until(lambda: bool(viewer.sessions))
    with viewer.lock:
        viewer.add("cloud", loom.PointCloud(rng.random((1000, 3))))
        stream = stream_of(viewer)
        assert stream.drawn == 100
        assert line_of(viewer) == "100 of 1,000 points"
    wait_until(lambda: stream.drawn == 1000)
    assert line_of(viewer) == "1,000 points"
    assert (np.sort(np.concatenate(stream._sent)) == np.arange(1000)).all()
    join_threads(lambda thread: is_feeder(thread) and thread.name != "pointloom-tools_0")


def test_existing_points_are_replaced_at_once(small_steps, rng, viewer, page):
    viewer.add("cloud", loom.PointCloud(rng.random((1000, 3))))
    stream = stream_of(viewer)
    wait_until(lambda: stream.drawn == 1000)
    for count in (1500, 150, 900, 0):
        with viewer.lock:
            viewer.update("cloud", loom.PointCloud(rng.random((count, 3))))
            assert stream.drawn == count
        wait_until(lambda count=count: stream.drawn == count)
        assert sum(len(node.positions) for node in nodes_of(page, stream)) == count


def nodes_of(page, stream):
    return [page.nodes[node.id] for node in stream._nodes]


def test_colors_size_pose_and_visibility_apply_to_all_steps(small_steps, rng, viewer, page):
    viewer.add("cloud", loom.PointCloud(rng.random((1000, 3)), colors=rng.random((1000, 3))))
    stream = stream_of(viewer)
    wait_until(lambda: stream.drawn == 1000)
    viewer.color_by("height")
    colors = np.concatenate([node.colors for node in nodes_of(page, stream)])
    assert (colors == viewer.items["cloud"].colors_of(np.concatenate(stream._sent))).all()
    viewer.point_size = 9.0
    assert {node.size for node in nodes_of(page, stream)} == {9.0}
    T = np.eye(4)
    T[:3, 3] = 5.0
    viewer.set_pose("cloud", T)
    assert len({tuple(np.round(node.pose, 6)) for node in nodes_of(page, stream)}) == 1
    viewer.set_visible("cloud", False)
    assert not any(node.visible for node in nodes_of(page, stream))
    limit = np.sort(viewer.items["cloud"].cloud.points[:, 0])[10]
    stream.set_keep(lambda points: points[:, 0] < limit)
    assert sum(len(node.positions) for node in nodes_of(page, stream)) == 10
    viewer.remove("cloud")
    assert stream._nodes == [] and page.nodes == {}


def test_the_next_step_waits_for_the_page(small_steps, rng, monkeypatch, viewer, page):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 60.0)
    viewer.add("cloud", loom.PointCloud(rng.random((1000, 3))))
    stream = stream_of(viewer)
    wait_until(lambda: "pointloom-feed" in feeders())
    wait_until(lambda: any(op["op"] == "sign" for op in page.look()))
    assert stream.drawn == 100
    page.send("sign", n=1)
    wait_until(lambda: page.answer() and stream.drawn == 1000)


def test_closing_in_the_midst_of_it_leaves_no_thread(small_steps, rng, monkeypatch):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 60.0)
    with Viewer(port=0, max_points=1000) as shown, page_in(shown):
        shown.add("cloud", loom.PointCloud(rng.random((900, 3))))
        shown.add("large", loom.PointCloud(rng.random((3000, 3))))
        wait_until(lambda: "pointloom-feed" in feeders())
        with shown.lock:  # the caller may hold it
            shown.close()
    join_threads(is_feeder)


def test_a_large_cloud_is_shown_in_part_while_its_levels_are_built(small_steps, rng, monkeypatch):
    may_go, build = threading.Event(), DetailTree.from_cloud
    monkeypatch.setattr(DetailTree, "from_cloud", lambda cloud: may_go.wait(TIMEOUT) and build(cloud))
    with Viewer(port=0, max_points=20_000) as shown, page_in(shown) as page:
        shown.add("cloud", loom.PointCloud(rng.random((60_000, 3)), colors=rng.random((60_000, 3))))
        stream = stream_of(shown)
        wait_until(lambda: stream.drawn == 100)
        assert line_of(shown) == "100 of 60,000 points"
        wait_until(lambda: page.others("progress")[-1].text == "a preview; preparing all points of cloud")
        may_go.set()
        wait_until(lambda: stream_of(shown) is not stream and 10_000 < stream_of(shown).drawn <= 20_000)
        wait_until(lambda: stream._nodes == [])
        assert page.others("progress")[-1].text == ""


def test_levels_of_a_replaced_cloud_are_freed(small_steps, rng, monkeypatch):
    may_go, build = threading.Event(), DetailTree.from_cloud
    monkeypatch.setattr(DetailTree, "from_cloud", lambda cloud: may_go.wait(TIMEOUT) and build(cloud))
    with Viewer(port=0, max_points=2000) as shown, page_in(shown):
        shown.add("cloud", loom.PointCloud(rng.random((5000, 3))))
        shown.update("cloud", loom.PointCloud(rng.random((50, 3))))
        may_go.set()
        join_threads(lambda thread: thread.name == "pointloom-levels")
        assert shown.items["cloud"].tree is None
        wait_until(lambda: stream_of(shown).drawn == 50)


def test_tools_learn_of_each_change_of_the_scene(rng, viewer, page):
    viewer.add("cloud", loom.PointCloud(rng.random((10, 3))))
    stream_of(viewer)
    refreshes = []
    toolbox_of(viewer).refresh = lambda: refreshes.append(True)
    other = loom.PointCloud(rng.random((20, 3)))
    changes = [("set_visible", "cloud", False), ("set_pose", "cloud", np.eye(4)), ("update", "cloud", other)]
    for method, *given in (*changes, ("add", "other", other), ("remove", "other")):
        refreshes.clear()
        getattr(viewer, method)(*given)
        viewer.catch_up()
        assert refreshes


def test_pictures_show_what_clip_planes_and_crops_leave(rng, viewer, page):
    points = rng.random((4000, 3))
    viewer.add("cloud", loom.PointCloud(points, colors=np.tile(RED, (4000, 1))))
    stream_of(viewer)
    toolbox = toolbox_of(viewer)
    full = red(viewer.screenshot())
    toolbox.stage.clip = Clip(low=[0.8, -9, -9], high=[9, 9, 9])
    assert 0 < red(viewer.screenshot()) < 0.6 * full
    toolbox.stage.clip = Clip()
    assert red(viewer.screenshot()) == full
    viewer.add("part", loom.PointCloud(points[:5], colors=np.tile(RED, (5, 1))))
    viewer.set_visible("cloud", False)  # as a crop does
    assert 0 < red(viewer.screenshot()) < 0.1 * full


def red(picture):
    return int(((picture[..., 0] > 200) & (picture[..., 1] < 80)).sum())


def test_a_cloud_of_levels_is_picked_and_cropped_with_its_file_s_colors(rng):
    """Its colors arrive only with its levels."""
    points = rng.random((500, 3)) * [4, 4, 0.5]
    page = StandIn(cloud=loom.PointCloud(points))
    colored = loom.PointCloud(points, colors=np.tile([1.0, 0.0, 0.0], (500, 1)))
    page.items["cloud"].tree = DetailTree.from_cloud(colored)
    page.press("Pick a point")
    page.click(*project(page.now, points[0])[:2])
    assert "255 0 0" in page.table
    page.press("Crop by polygon")
    for corner in ((100, 100), (900, 100), (900, 700), (100, 700)):
        page.click(*corner)
    page.key("enter")
    cropped = page.items["cloud (cropped)"].cloud
    assert 0 < len(cropped) <= 500
    assert (np.asarray(cropped.colors) == np.array(RED, np.float32)).all()


@pytest.mark.slow
def test_the_first_picture_of_a_cloud_waits_for_no_compiler():
    """Taichi, scipy's matrices and click take longer to import than all other modules."""
    script = (
        "import sys, pointloom as loom\n"
        "loom.draw(loom.PointCloud([[0, 0, 0], [1, 1, 1]]), port=0, block=False, open_browser=False).close()\n"
        "print(sorted({'taichi', 'scipy.sparse', 'click'} & set(sys.modules)))"
    )
    assert run_python(script)[:2] == (0, "[]\n")


POSE = np.eye(4)
POSE[:3, 3] = 1, 2, 3


def cloud_of(number, count=4):
    """A cloud whose first point contains its number."""
    points = np.zeros((count, 3))
    points[:, 0] = number
    points[-1] = 10
    return loom.PointCloud(points)


def shown(viewer):
    """The state that pages show: the number of each cloud, its position, and its visibility."""
    items = {}
    for name, item in viewer.scene.shown.items():
        position = np.zeros(3) if item.pose is None else item.pose[:3, 3]
        items[name] = (int(item.cloud.points[0][0]), position.tolist(), item.visible)
    return items


HERE = [0.0, 0.0, 0.0]


def run_example(viewer):
    """A program that adds, updates, moves, hides, shows and removes, one moment each."""
    viewer.add("old", cloud_of(9))
    viewer.set_time(0)
    viewer.add("a", cloud_of(1))
    viewer.set_time(1)
    viewer.update("a", cloud_of(2))
    viewer.set_time(2)
    viewer.set_pose("a", POSE)
    viewer.set_visible("old", False)
    viewer.set_time(3)
    viewer.remove("old")
    viewer.add("b", cloud_of(3))


STORY = [
    {"old": (9, HERE, True), "a": (1, HERE, True)},
    {"old": (9, HERE, True), "a": (2, HERE, True)},
    {"old": (9, HERE, False), "a": (2, [1.0, 2.0, 3.0], True)},
    {"a": (2, [1.0, 2.0, 3.0], True), "b": (3, HERE, True)},
]


def test_each_moment_shows_what_was_then_in_any_order(viewer):
    run_example(viewer)
    for number in (3, 0, 2, 1, 3, 1, 0):
        viewer.show_time(number)
        assert shown(viewer) == STORY[number]
    viewer.show_time(1.99)
    assert shown(viewer) == STORY[1]
    viewer.show_time(-5)
    assert shown(viewer) == STORY[0]
    viewer.show_time()
    assert shown(viewer) == STORY[3] and viewer.edits.timeline.is_live


def test_without_set_time_nothing_is_recorded(viewer):
    viewer.add("a", cloud_of(1))
    viewer.update("a", cloud_of(2))
    assert viewer.edits.timeline is None
    with pytest.raises(ValueError, match=r"^t:"):
        viewer.show_time()


def test_a_program_goes_on_while_pages_look_at_what_was(viewer):
    run_example(viewer)
    viewer.show_time(1)
    before = list(viewer.scene.shown.values())
    viewer.set_time(4)
    viewer.update("b", cloud_of(7))
    viewer.add("c", cloud_of(8))
    viewer.set_pose("c", POSE)
    viewer.set_visible("b", False)
    viewer.remove("a")
    assert shown(viewer) == STORY[1] and list(viewer.scene.shown.values()) == before
    newest = {name: (int(item.cloud.points[0][0]), item.visible) for name, item in viewer.items.items()}
    assert newest == {"b": (7, False), "c": (8, True)} and viewer.items["c"].pose[0, 3] == 1
    with pytest.raises(KeyError, match="no geometry 'old'; there are 'b', 'c'"):
        viewer.update("old", cloud_of(1))
    viewer.set_time(5)
    viewer.clear()
    viewer.show_time(4)
    assert shown(viewer) == {"b": (7, HERE, False), "c": (8, [1.0, 2.0, 3.0], True)}
    viewer.show_time()
    assert shown(viewer) == {}
    viewer.add("d", cloud_of(1))
    assert shown(viewer) == {"d": (1, HERE, True)}


def test_later_changes_of_a_pose_array_do_not_affect_recorded_moments(viewer):
    viewer.add("a", cloud_of(1))
    T = np.eye(4)
    for frame in range(3):
        viewer.set_time(frame)
        T[0, 3] = frame
        viewer.set_pose("a", T)
    viewer.show_time(1)
    assert shown(viewer)["a"] == (1, [1.0, 0.0, 0.0], True)


def test_viewing_the_past_does_not_change_the_present(viewer):
    run_example(viewer)
    viewer.show_time(1)
    with requested_by_page():
        viewer.set_visible("old", False)
        assert not viewer.scene.shown["old"].visible and viewer.items.keys() == {"a", "b"}
        with pytest.raises(PointloomError, match="go to its end to change the scene"):
            viewer.update("a", cloud_of(5))
    viewer.show_time(0)
    viewer.show_time(1)
    assert shown(viewer) == STORY[1]
    viewer.show_time()
    assert shown(viewer) == STORY[3]


def test_a_moment_of_the_same_time_goes_on_and_an_earlier_one_is_refused(viewer):
    viewer.set_time(1.5)
    viewer.add("a", cloud_of(1))
    viewer.set_time(1.5)
    viewer.update("a", cloud_of(2))
    assert viewer.edits.timeline.times == [1.5] and len(viewer.edits.timeline.scene_at(0)) == 1
    for wrong, error in ((1, ValueError), (np.nan, ValueError), ("2", TypeError), (None, TypeError), (True, TypeError)):
        with pytest.raises(error, match=r"^t: "):
            viewer.set_time(wrong)
    with pytest.raises(TypeError, match=r"^t: "):
        viewer.show_time("1")
    assert viewer.edits.timeline.times == [1.5]


def drag(viewer, value):
    control = viewer.edits.timeline._control
    control.value = value
    for callback in control._callbacks:
        callback(SimpleNamespace(client_id=7, value=value, target=control))


def test_the_time_line_comes_with_the_second_moment_and_follows_the_newest(viewer):
    with page_in(viewer) as page:
        viewer.set_time(0)
        viewer.add("a", cloud_of(0))
        assert page.of_kind("timeline") == []
        for frame in (1, 2):
            viewer.set_time(frame)
            viewer.update("a", cloud_of(frame))
        (control,) = page.of_kind("timeline")
        assert (control.min, control.max, control.step, control.value) == (0, 2, 1, 2)
        page.send("value", id=control.id, value=1)
        assert shown(viewer)["a"][0] == 1
        for wrong in ("1", None, True):  # invalid numbers are ignored
            page.send("value", id=control.id, value=wrong)
        viewer.set_time(3)
        viewer.update("a", cloud_of(3))
        assert shown(viewer)["a"][0] == 1
        with page_in(viewer) as late_page:
            (other,) = late_page.of_kind("timeline")
            assert (other.max, other.value) == (3, 1)
        page.send("value", id=control.id, value=3)
        assert shown(viewer)["a"][0] == 3
        viewer.set_time(4)
        (control,) = page.of_kind("timeline")
        assert control.value == 4


def test_times_in_seconds_are_reached_by_steps_of_the_page(viewer):
    times = [0.1 * frame for frame in range(30)]
    for frame, time in enumerate(times):
        viewer.set_time(time)
        viewer.add("a", cloud_of(frame))
    control = viewer.edits.timeline._control
    assert control.step == pytest.approx(0.1)
    steps = np.linspace(0, control.max, round(control.max / control.step) + 1)
    for step, value in enumerate(steps):
        drag(viewer, float(value))
        assert shown(viewer)["a"][0] == step
    assert viewer.edits.timeline.is_live


def test_unchanged_geometries_are_stored_once_and_a_pose_is_small(viewer):
    viewer.add("big", cloud_of(1, 100_000), color=RED)
    viewer.add("other", cloud_of(2, 100_000), color=RED)
    viewer.set_time(0)
    start = viewer.edits.timeline.bytes
    assert 2 * 100_000 * 12 <= start < 2 * 100_000 * 16
    for frame in range(1, 1001):
        viewer.set_time(frame)
        viewer.set_pose("big", POSE)
    assert viewer.edits.timeline.bytes - start == 1000 * ENTRY_BYTES
    assert len(viewer.edits.timeline._tracks["other"]) == 1


def test_the_oldest_moments_are_removed_beyond_the_byte_limit_with_one_warning(viewer, caplog):
    viewer.history_bytes = 20 * 12_000 + 30 * ENTRY_BYTES
    with caplog.at_level(logging.WARNING, "pointloom.viewer"):
        for frame in range(200):
            viewer.set_time(frame)
            viewer.add("a", cloud_of(frame, 1000))
            assert viewer.edits.timeline.bytes <= viewer.history_bytes
    timeline = viewer.edits.timeline
    assert caplog.text.count(live_timeline.FULL) == 1
    assert 10 <= len(timeline.times) <= 21 and timeline.times[-1] == 199
    for time in timeline.times:
        viewer.show_time(time)
        assert shown(viewer)["a"][0] == time
    viewer.show_time(0)
    assert shown(viewer)["a"][0] == timeline.times[0]
    n_bytes = sum(size for _, size in timeline._arrays.values()) + ENTRY_BYTES * sum(
        map(len, timeline._tracks.values())
    )
    assert timeline.bytes == n_bytes


def test_what_never_changed_outlives_the_moment_it_came_in(viewer):
    viewer.history_bytes = 30 * ENTRY_BYTES + 10_000
    viewer.set_time(0)
    viewer.add("still", cloud_of(5))
    viewer.add("gone", cloud_of(6))
    viewer.set_time(1)
    viewer.remove("gone")
    for frame in range(2, 300):
        viewer.set_time(frame)
        viewer.set_pose("still", POSE)
    assert viewer.edits.timeline.times[0] > 1 and {*viewer.edits.timeline._tracks} == {"still"}
    viewer.show_time(0)
    assert shown(viewer) == {"still": (5, [1.0, 2.0, 3.0], True)}


def test_pages_that_look_at_a_moment_that_goes_see_the_oldest_that_is_left(viewer):
    viewer.history_bytes = 20 * 12_000
    for frame in range(5):
        viewer.set_time(frame)
        viewer.add("a", cloud_of(frame, 1000))
    viewer.show_time(0)
    for frame in range(5, 60):
        viewer.set_time(frame)
        viewer.update("a", cloud_of(frame, 1000))
    oldest = viewer.edits.timeline.times[0]
    assert oldest > 0 and shown(viewer)["a"][0] == oldest == viewer.edits.timeline.time
    assert not viewer.edits.timeline.is_live


def test_a_recording_has_a_frame_for_each_moment(viewer, tmp_path):
    run_example(viewer)
    viewer.show_time(0)
    drawn = Drawn(viewer.scene, 1000).timeline(moments_of(viewer.edits.timeline, 600))
    assert [[*frame.shown] for frame in drawn.frames] == [["old", "a"], ["old", "a"], ["a"], ["a", "b"]]
    assert [frame.label for frame in drawn.frames] == ["0", "1", "2", "3"]
    assert len(drawn.shapes) == 4  # each once
    moved = drawn.frames[2].shown["a"]
    position = drawn.shapes[moved.shapes[0]].positions[0] + moved.pose[:3, 3] + drawn.origin
    assert np.allclose(position, [2 + 1, 2, 3])
    viewer.save_recording(tmp_path / "story.html")
    assert (tmp_path / "story.html").stat().st_size > 1000


def test_of_many_moments_the_recording_has_some_and_the_newest(viewer, tmp_path):
    viewer.add("a", cloud_of(1))
    for frame in range(100):
        viewer.set_time(frame / 10)
        viewer.set_pose("a", POSE)
    moments = moments_of(viewer.edits.timeline, 10)
    assert len(moments) == 10 and moments[-1][0] == "9.9 s"
    viewer.save_recording(tmp_path / "run.html", max_frames=10, title="run")
    assert "run, 10 of 100 time steps" in (tmp_path / "run.html").read_text()
    for wrong in ({"fps": 0}, {"max_points": 0}, {"max_frames": 1}, {"color": 1}):
        with pytest.raises((ValueError, TypeError), match=next(iter(wrong))):
            viewer.save_recording(tmp_path / "a.html", **wrong)
    assert [path.name for path in tmp_path.iterdir()] == ["run.html"]
