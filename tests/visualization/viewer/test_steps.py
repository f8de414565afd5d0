"""Fast first image: clouds arrive in steps at the pace of the page, and levels during viewing."""

import os
import subprocess
import sys
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer import point_transfer, scene, sessions
from pointloom.visualization.viewer.detail_tree import DetailTree
from pointloom.visualization.viewer.point_transfer import in_steps
from pointloom.visualization.viewer.tools.clip_planes import Clip
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.viewer import Viewer

from .events import TIMEOUT, join_threads, wait_until
from .stand_in import StandIn, page_in

RED = (1.0, 0.0, 0.0)


@pytest.fixture
def small_steps(monkeypatch):
    """Steps of a few hundred points, for pages that send no acknowledgement."""
    for name, value in {"FIRST": 100, "STEP": 300, "AT_ONCE": 200}.items():
        monkeypatch.setattr(point_transfer, name, value)
    monkeypatch.setattr(scene, "FIRST", 100)
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 0.01)
    monkeypatch.setattr(sessions, "PAUSE", 0.0)


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
        shares = np.histogram(rows, 10, (0, 1_000_000))[0] / len(rows)
        assert abs(shares - 0.1).max() < 0.001
    assert [len(rows) for rows in in_steps(150_000)] == [150_000]
    assert [len(rows) for rows in in_steps(0)] == [0]


def test_a_part_comes_at_once_and_the_rest_in_steps(small_steps, rng):
    with Viewer(port=0) as shown, page_in(shown):
        wait_until(lambda: bool(shown.sessions))
        with shown.lock:
            shown.add("cloud", loom.PointCloud(rng.random((1000, 3))))
            stream = stream_of(shown)
            assert stream.drawn == 100
            assert line_of(shown) == "100 of 1,000 points"
        wait_until(lambda: stream.drawn == 1000)
        assert line_of(shown) == "1,000 points"
        assert (np.sort(np.concatenate(stream._sent)) == np.arange(1000)).all()
        join_threads(lambda thread: is_feeder(thread) and thread.name != "pointloom-tools_0")


def test_existing_points_are_replaced_at_once(small_steps, rng):
    with Viewer(port=0) as shown, page_in(shown) as page:
        shown.add("cloud", loom.PointCloud(rng.random((1000, 3))))
        stream = stream_of(shown)
        wait_until(lambda: stream.drawn == 1000)
        for count in (1500, 150, 900, 0):
            with shown.lock:
                shown.update("cloud", loom.PointCloud(rng.random((count, 3))))
                assert stream.drawn == count
            wait_until(lambda count=count: stream.drawn == count)
            assert sum(len(node.positions) for node in nodes_of(page, stream)) == count


def nodes_of(page, stream):
    return [page.nodes[node.id] for node in stream._nodes]


def test_colors_size_pose_and_visibility_apply_to_all_steps(small_steps, rng):
    with Viewer(port=0) as shown, page_in(shown) as page:
        shown.add("cloud", loom.PointCloud(rng.random((1000, 3)), colors=rng.random((1000, 3))))
        stream = stream_of(shown)
        wait_until(lambda: stream.drawn == 1000)
        shown.color_by("height")
        colors = np.concatenate([node.colors for node in nodes_of(page, stream)])
        assert (colors == shown.items["cloud"].colors_of(np.concatenate(stream._sent))).all()
        shown.point_size = 9.0
        assert {node.size for node in nodes_of(page, stream)} == {9.0}
        T = np.eye(4)
        T[:3, 3] = 5.0
        shown.set_pose("cloud", T)
        assert len({tuple(np.round(node.pose, 6)) for node in nodes_of(page, stream)}) == 1
        shown.set_visible("cloud", False)
        assert not any(node.visible for node in nodes_of(page, stream))
        limit = np.sort(shown.items["cloud"].cloud.points[:, 0])[10]
        stream.set_keep(lambda points: points[:, 0] < limit)
        assert sum(len(node.positions) for node in nodes_of(page, stream)) == 10
        shown.remove("cloud")
        assert stream._nodes == [] and page.nodes == {}


def test_the_next_step_waits_for_the_page(small_steps, rng, monkeypatch):
    monkeypatch.setattr(sessions, "SIGNAL_TIMEOUT", 60.0)
    with Viewer(port=0) as shown, page_in(shown) as page:
        shown.add("cloud", loom.PointCloud(rng.random((1000, 3))))
        stream = stream_of(shown)
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


def test_tools_learn_of_each_change_of_the_scene(rng):
    with Viewer(port=0) as shown, page_in(shown):
        shown.add("cloud", loom.PointCloud(rng.random((10, 3))))
        stream_of(shown)
        (session,) = shown.sessions.values()
        wait_until(lambda: session._toolbox is not None)
        refreshes = []
        session._toolbox.refresh = lambda: refreshes.append(True)
        for change in (
            lambda: shown.set_visible("cloud", False),
            lambda: shown.set_pose("cloud", np.eye(4)),
            lambda: shown.update("cloud", loom.PointCloud(rng.random((20, 3)))),
            lambda: shown.add("other", loom.PointCloud(rng.random((20, 3)))),
            lambda: shown.remove("other"),
        ):
            refreshes.clear()
            change()
            shown.catch_up()
            assert refreshes


def test_pictures_show_what_clip_planes_and_crops_leave(rng):
    points = rng.random((4000, 3))
    with Viewer(port=0) as shown, page_in(shown):
        shown.add("cloud", loom.PointCloud(points, colors=np.tile(RED, (4000, 1))))
        stream_of(shown)
        (session,) = shown.sessions.values()
        wait_until(lambda: session._toolbox is not None)
        full = red(shown.screenshot())
        session._toolbox.stage.clip = Clip(low=[0.8, -9, -9], high=[9, 9, 9])
        assert 0 < red(shown.screenshot()) < 0.6 * full
        session._toolbox.stage.clip = Clip()
        assert red(shown.screenshot()) == full
        shown.add("part", loom.PointCloud(points[:5], colors=np.tile(RED, (5, 1))))
        shown.set_visible("cloud", False)  # as a crop does
        assert 0 < red(shown.screenshot()) < 0.1 * full


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
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=True, env=environment
    )
    assert done.stdout.strip() == "[]"
