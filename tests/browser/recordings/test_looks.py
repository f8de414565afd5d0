"""Recordings in Chromium: positions and colors of drawn shapes."""

import math
from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.recording.timeline import Shape
from pointloom.visualization.render.view import fit_view

from ..pixels import count_pixels, is_color, middle_of
from .scenes import BLUE, GREEN, RED, box_of_triangles, from_above, grid, is_reddish, near_outlines, one_frame, stage


@pytest.mark.parametrize(
    ("size", "origin"),
    [((640, 480), (0, 0, 0)), ((1000, 700), (456_789.25, 5_345_678.5, 512.0)), ((400, 600), (0, 0, 0))],
)
def test_points_are_seen_where_the_view_projects_them(open_recording, size, origin):
    rng = np.random.default_rng(3)
    positions = rng.uniform(-1, 1, (3, 3)).astype(np.float32)
    colors = np.uint8([RED, BLUE, GREEN])
    view = fit_view(np.vstack([positions, -positions]) + np.array(origin), width=640, height=480)
    timeline = one_frame(Shape("points", positions, colors, size=9.0), origin=origin)
    image = stage(open_recording(timeline, width=size[0], height=size[1], view=view))
    scale = min(size[0] / 640, size[1] / 480)
    camera, T = view.intrinsic, view.T_world_camera
    for position, color in zip(positions, (RED, BLUE, GREEN), strict=True):
        x, y, z = (position + np.array(origin) - T[:3, 3]) @ T[:3, :3]
        column = size[0] / 2 + scale * (camera.fx * x / z + camera.cx + 0.5 - 320)
        row = size[1] / 2 + scale * (camera.fy * y / z + camera.cy + 0.5 - 240)
        assert math.dist(middle_of(image, color, 90), (column, row)) < 1.5


def ball_of_points(rng) -> Shape:
    positions = rng.normal(size=(20_000, 3))
    ball = (positions / np.linalg.norm(positions, axis=1, keepdims=True)).astype(np.float32)
    return Shape("points", ball, None, ball, size=8.0, plain=(89, 128, 158))


@pytest.mark.parametrize("kind", ["mesh", "cloud"])
def test_a_page_looks_like_rendered_images(open_recording, rng, kind):
    shape = box_of_triangles() if kind == "mesh" else ball_of_points(rng)
    view = fit_view(shape.positions, width=640, height=480)
    if kind == "mesh":
        geometry = loom.TriangleMesh(shape.positions, shape.indices)
    else:
        geometry = loom.PointCloud(shape.positions, normals=shape.normals)
    style = {"geometry": geometry, "color": tuple(value / 255 for value in shape.plain)}
    expected = loom.render(style, view, point_size=8.0, device="cpu")
    page = open_recording(one_frame(shape), width=640, height=480, view=view)
    away = np.abs(stage(page).astype(int) - expected).max(axis=-1)
    inside = ~near_outlines(expected) & (expected < 255).any(axis=-1)
    assert inside.mean() > 0.1
    assert (away[inside] > 12).mean() < 0.001
    assert (away > 12).mean() < 0.04  # outlines: pointloom's images have four samples a pixel


def with_inward_faces(shape: Shape, *, cull: bool) -> Shape:
    return replace(shape, indices=np.ascontiguousarray(shape.indices[:, ::-1]), cull=cull)


def test_culled_back_faces_show_the_inside_of_a_room(open_recording):
    """A box with inward faces hides its content, except from behind; as in pointloom's images."""
    room, dot = box_of_triangles(), Shape("points", np.float32([[0, 0, 0]]), size=40.0, plain=RED)
    view = fit_view(room.positions, width=640, height=480)
    closed = stage(open_recording(one_frame(with_inward_faces(room, cull=False), dot), view=view))
    assert is_reddish(closed).sum() == 0
    opened = stage(open_recording(one_frame(with_inward_faces(room, cull=True), dot), view=view))
    assert abs(is_reddish(opened).sum() - math.pi * 20**2) < 60
    mesh = loom.TriangleMesh(room.positions, room.indices[:, ::-1])
    style = {"geometry": mesh, "color": tuple(value / 255 for value in room.plain), "back_faces": False}
    expected = loom.render(style, view, device="cpu")
    compared = ~near_outlines(expected) & ~near_outlines(opened) & ~is_reddish(opened)
    away = np.abs(opened.astype(int) - expected).max(axis=-1)
    assert (expected < 250).any(axis=-1)[compared].mean() > 0.1
    assert (away[compared] > 12).mean() < 0.001
    outside = stage(open_recording(one_frame(replace(room, cull=True), dot), view=view))
    np.testing.assert_array_equal(outside != 255, closed != 255)
    assert is_reddish(outside).sum() == 0


def test_lines_have_the_given_width_and_end_behind_the_camera(open_recording):
    ends = np.float32([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [2, -1, 40], [-2, -1, 40]])
    lines = Shape("lines", ends, np.uint8([RED, BLUE, GREEN]), indices=np.int32([[0, 1], [2, 3], [4, 2]]), size=6.0)
    image = stage(open_recording(one_frame(lines), view=from_above()))
    assert abs(is_color(image, RED)[:, 300].sum() - 6) <= 1
    assert abs(is_color(image, RED)[240].sum() - 120 - 6) <= 3
    for color, slope in ((BLUE, 0.5), (GREEN, -0.5)):  # one that begins before the camera, one that ends there
        mask = is_color(image, color)
        rows = np.nonzero(mask.any(axis=1))[0]
        assert rows.min() > 290 and rows.max() == 479  # it leaves the image below, and never comes back
        middles = [np.nonzero(mask[row])[0].mean() for row in range(320, 480, 10)]
        np.testing.assert_allclose(middles, 319.5 + slope * (np.arange(320, 480, 10) - 299.5), atol=1)
        assert all(abs(mask[row].sum() - 6 * math.sqrt(1.25)) < 2 for row in range(320, 480, 10))


def test_one_frame_fills_the_window_and_needs_no_bar(open_recording):
    page = open_recording(one_frame(Shape("points", grid(1), size=12.0, plain=RED), label="one dot"))
    assert page.locator("#scene").bounding_box() == {"x": 0, "y": 0, "width": 640, "height": 480}
    assert not page.is_visible("#bar") and not page.is_visible("#plots")
    assert math.dist(middle_of(stage(page), RED, 60), (320, 240)) < 2
    assert abs(count_pixels(stage(page), RED, 60) - math.pi * 36) < 25
    assert page.text_content("#label") == "one dot" and page.text_content("#count") == "1 point drawn"


def test_backgrounds_are_dark_or_light(open_recording):
    page = open_recording(one_frame(Shape("points", grid(1))), background=(0.1, 0.1, 0.15))
    assert page.get_attribute("html", "data-theme") == "dark"
    assert count_pixels(stage(page), (26, 26, 38), 1) > 100_000


def test_huge_and_tiny_scenes_are_drawn(open_recording):
    for scale in (1e-7, 1e7):
        shape = Shape("points", grid(40) * np.float32(scale), size=5.0, plain=RED)
        assert is_reddish(stage(open_recording(one_frame(shape)))).mean() > 0.01


def test_smoothed_outlines_change_nothing_else(open_recording, changed_player):
    """With the sampling of a graphics card, which is disabled in software."""
    timeline = one_frame(box_of_triangles(), Shape("points", grid(8) + np.float32([0, 0, 1]), size=9.0, plain=RED))
    plain = stage(open_recording(timeline, width=640, height=480))
    changed_player("isSoftware(gl) ? 0 : ", "")
    page = open_recording(timeline, width=640, height=480)
    smooth = stage(page)
    away = np.abs(plain.astype(int) - smooth).max(axis=-1) > 12
    assert away.sum() > 50 and away[~near_outlines(plain)].mean() < 0.001
    assert len(np.unique(smooth.reshape(-1, 3), axis=0)) > len(np.unique(plain.reshape(-1, 3), axis=0))
    x, y, _ = page.evaluate("recording.project([0, 0, 0.5])")
    page.mouse.dblclick(x, y)  # depths are read where the samples were averaged
    assert math.dist(page.evaluate("recording.project([0, 0, 0.5])")[:2], (320, 240)) < 4
