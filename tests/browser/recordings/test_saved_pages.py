"""Saved pages open and play from disk in Chromium without a network."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.recording.page import write_page
from pointloom.visualization.recording.shared_player import share_player, write_player

from ..pixels import count_pixels, is_color, ready, wait_in_page
from .scenes import stage, two_clouds

BRICK, PLAIN = (204, 64, 51), (20, 60, 220)
SOURCE, TARGET = (255, 180, 0), (0, 166, 237)


def test_a_saved_page_opens_from_disk_without_network_requests(open_recording):
    page = open_recording(two_clouds())
    assert [url.split(":")[0] for url in page.visit.requests] == ["file"]
    assert page.title() == page.text_content("h1") == "two squares"
    assert page.text_content("#label") == "iteration 0" and page.text_content("#place") == "1 / 8"
    assert page.text_content("#count") == "7,200 points drawn"


@pytest.fixture
def open_saved(open_page):
    """Open a page from disk without a network; it may make no requests."""

    def open_one(path: Path):
        page = open_page(path.as_uri(), offline=True)
        ready(page)
        assert page.visit.requests == [path.as_uri()]
        return page

    return open_one


def test_a_scene_that_the_viewer_saves_opens_from_disk(open_saved, tmp_path):
    cloud = loom.PointCloud(np.random.default_rng(0).random((5000, 3)))
    ball = loom.TriangleMesh.create_sphere(0.5).translate((2, 0.5, 0.5))
    with loom.Viewer(port=0) as viewer:
        viewer.add("cloud", cloud, color=np.array(PLAIN) / 255)
        viewer.add("ball", ball, color=np.array(BRICK) / 255, shaded=False)
        viewer.add("hidden", cloud.translate((0, 0, 5)), color=(0, 1, 0))
        viewer.items["hidden"].visible = False
        viewer.save_html(tmp_path / "scene.html")
    page = open_saved(tmp_path / "scene.html")
    image = stage(page)
    assert page.locator("#items label").all_text_contents() == ["cloud", "ball"]
    assert page.text_content("#count") == "5,000 points drawn"
    assert count_pixels(image, PLAIN, 60) > 3000 and is_hue(image, BRICK).sum() > 3000
    assert count_pixels(image, (0, 255, 0), 90) == 0


def is_hue(image: np.ndarray, color: tuple[int, int, int]) -> np.ndarray:
    """Mask of pixels of the color in any shading."""
    bright = image.max(axis=-1, keepdims=True)
    return (bright[..., 0] > 60) & is_color(image / np.maximum(bright, 1) * max(color), color, 30)


def test_a_recorded_registration_opens_from_disk_and_plays(open_saved, tmp_path):
    """The source moves onto the target frame by frame: together they cover less of the image."""
    rng = np.random.default_rng(1)
    positions = np.column_stack([rng.uniform(-1, 1, (3000, 2)), np.zeros(3000)])
    positions[:, 2] = 0.3 * np.sin(3 * positions[:, 0]) * np.cos(2 * positions[:, 1])
    target = loom.PointCloud(positions)
    with loom.record(tmp_path / "icp.html") as recorder:
        loom.registration.registration_icp(target.translate((0.25, 0.15, 0.2)), target, 0.6)
        recorder.step("done")
    page = open_saved(tmp_path / "icp.html")
    first = (stage(page) < 250).any(axis=-1).sum()
    last = int(page.get_attribute("#slider", "max") or 0)
    assert last >= 3
    assert page.locator("#plots span").all_text_contents() == ["fitness", "inlier rmse [m]"]
    page.uncheck("#loop")
    page.focus("#scene")
    page.keyboard.press("Space")
    wait_in_page(page, f"recording.statistics().frame === {last} && !recording.statistics().playing")
    assert first > 5000 and (stage(page) < 250).any(axis=-1).sum() < 0.95 * first
    assert page.visit.requests == [(tmp_path / "icp.html").as_uri()]


def test_a_saved_page_has_the_color_bar_of_its_values(open_saved, tmp_path):
    cloud = loom.PointCloud(np.random.default_rng(0).random((500, 3)))
    entry = {"geometry": cloud, "color_by": "height", "limits": (0.0, 1.0)}
    with loom.Viewer(port=0) as viewer:
        viewer.add("cloud", **entry)
        viewer.save_html(tmp_path / "scene.html")
    page = open_saved(tmp_path / "scene.html")
    assert page.get_attribute("#key", "alt") == "height [m], colors from 0 to 1"
    box = page.locator("#key").bounding_box()
    assert box["width"] < 100 and 300 < box["height"] < 500
    area = stage(page)[
        round(box["y"]) : round(box["y"] + box["height"]), round(box["x"]) : round(box["x"] + box["width"])
    ]
    assert (area.max(axis=-1) - area.min(axis=-1) > 100).mean() > 0.1  # colors of the bar


def test_a_page_plays_from_disk_with_a_separate_player_file(open_page, tmp_path):
    (tmp_path / "recordings").mkdir()
    write_page(tmp_path / "whole.html", two_clouds())
    write_player(tmp_path)
    share_player(tmp_path / "whole.html", tmp_path / "recordings" / "page.html", "../")
    (tmp_path / "site.html").write_text("<link rel=icon href=data:,><iframe src=recordings/page.html></iframe>")
    for path in ("recordings/page.html", "site.html"):
        page = open_page((tmp_path / path).as_uri(), offline=True)
        frame = page.frames[-1]
        ready(frame)
        assert frame.text_content("#label") == "iteration 0"
        assert frame.text_content("#count") == "7,200 points drawn"
        names = {url.rsplit("/", 1)[1] for url in page.visit.requests if url.startswith("file:")}
        assert names - {"site.html"} == {"page.html", "pointloom-player.js", "pointloom-player.css"}
