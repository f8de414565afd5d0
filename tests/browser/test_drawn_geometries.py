"""`draw` in Chromium: each kind of geometry is drawn in its color at its position."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

import pointloom as loom
from pointloom.cli.shell.cli import cli

from .pixels import count_pixels, middle_of, see
from .viewer_scenes import BLUE, BRICK, GREEN, RED, WHITE, grid_cloud, sphere


def trajectory() -> loom.Trajectory:
    poses = np.tile(np.eye(4), (20, 1, 1))
    poses[:, 0, 3], poses[:, 1, 3] = np.linspace(0, 2, 20), np.sin(np.linspace(0, 6, 20))
    return loom.Trajectory(poses)


def frustum() -> loom.CameraFrustum:
    return loom.CameraFrustum(loom.PinholeCameraIntrinsic(640, 480, 500.0, 500.0, 319.5, 239.5), np.eye(4), scale=1.0)


CORNERS = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 1]])

# Geometries and their minimum numbers of pixels: lines are thin.
KINDS: dict[str, tuple[Callable[[], Any], int]] = {
    "cloud": (grid_cloud, 1_500),
    "mesh": (sphere, 20_000),
    "lines": (lambda: loom.LineSet(CORNERS, [[0, 1], [1, 2], [2, 3], [3, 0]]), 250),
    "box": (lambda: loom.AxisAlignedBoundingBox((0, 0, 0), (1, 2, 1)), 500),
    "oriented box": (lambda: loom.OrientedBoundingBox((0, 0, 0), np.eye(3), (1, 2, 1)), 500),
    "trajectory": (trajectory, 120),
    "frustum": (frustum, 250),
    "hull": (lambda: grid_cloud().compute_convex_hull()[0], 500),
    "voxel grid": (lambda: sphere().voxelize(0.25), 15_000),
    "array": (lambda: np.random.default_rng(0).random((2000, 3)), 1_500),
}


def test_each_kind_is_seen_in_its_color(show):
    viewer, page = show([])
    for kind, (make, min_pixels) in KINDS.items():
        viewer.clear()
        see(page, lambda image: count_pixels(image, BRICK, 60) == 0)
        viewer.add(kind, make(), color=np.array(BRICK) / 255, shaded=False, line_width=4)
        image = see(page, lambda image, min_pixels=min_pixels: count_pixels(image, BRICK, 25) > min_pixels)
        assert count_pixels(image, WHITE, 5) > 0.2 * image[..., 0].size, kind


def test_a_million_points_are_seen(show):
    points = np.random.default_rng(0).random((1_000_000, 3)).astype(np.float32)
    _, page = show({"geometry": points, "color": (0, 0, 1)})
    see(page, lambda image: count_pixels(image, BLUE) > 40_000)


def test_a_mesh_without_colors_is_lit_as_in_rendered_images(show):
    ball = loom.TriangleMesh.create_sphere(1.0, 40).compute_vertex_normals()
    viewer, page = show(ball)
    for front in ((0, -1, 0.2), (1, 0.3, -0.5)):
        viewer.set_view(front=front, up=(0, 0, 1), lookat=(0, 0, 0), zoom=0.8)

        def looks_alike(image: np.ndarray) -> bool:
            rendered = loom.render(ball, viewer.get_view()).astype(float)
            drawn = image.astype(float)
            if drawn.shape != rendered.shape:
                return False
            both = (drawn.min(axis=2) < 245) & (rendered.min(axis=2) < 245)
            return bool(both.mean() > 0.05 and np.abs(drawn - rendered)[both].mean() < 10)

        see(page, looks_alike)


FOUR = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]])
FOUR_COLORS = [RED, GREEN, BLUE, (255, 0, 255)]


def pixels_of(viewer: loom.Viewer, points: np.ndarray) -> np.ndarray:
    """Pixel coordinates of world points [n, 3] in the page, by the view that the page reported."""
    view = viewer.get_view()
    T_camera_world = np.linalg.inv(view.T_world_camera)
    x, y, z = T_camera_world[:3, :3] @ points.T + T_camera_world[:3, 3:]
    camera = view.intrinsic
    middles = np.stack([camera.fx * x / z + camera.cx, camera.fy * y / z + camera.cy], -1)
    return middles + 0.5  # whole numbers are the centers of a View's pixels


@pytest.mark.parametrize("origin", [(0, 0, 0), (691_000.0, 5_336_000.0, 520.0)], ids=["near", "UTM"])
def test_points_are_drawn_at_their_positions_without_jitter_as_the_camera_rotates(origin, show):
    """Four single points of different colors, 1 m apart; float32 at 5,336 km has steps of half a meter."""
    points = FOUR + origin
    cloud = loom.PointCloud(points, colors=np.array(FOUR_COLORS, np.uint8))
    viewer, page = show({"geometry": cloud, "point_size": 9})
    for x in (-0.5, 0.0, 0.5):
        viewer.set_view(front=(x, -0.4, 1), up=(0, 1, 0), lookat=points.mean(axis=0), zoom=0.9)

        def are_there(image: np.ndarray) -> bool:
            if not all(count_pixels(image, color) > 20 for color in FOUR_COLORS):
                return False
            centers = np.array([middle_of(image, color) for color in FOUR_COLORS])
            return bool(np.abs(centers - pixels_of(viewer, points)).max() < 2.0)

        see(page, are_there)


def test_the_command_writes_the_picture_that_a_page_shows(show, tmp_path):
    """The file is drawn without a browser, from the initial view of a page."""
    cloud = loom.PointCloud(grid_cloud().points, colors=np.tile(np.array(BRICK, np.uint8), (12**3, 1)))
    loom.write_point_cloud(tmp_path / "cloud.ply", cloud)
    done = CliRunner().invoke(cli, ["view", str(tmp_path / "cloud.ply"), "--screenshot", str(tmp_path / "picture.png")])
    assert done.exit_code == 0, done.output
    file = np.asarray(Image.open(tmp_path / "picture.png").convert("RGB"))
    _, page = show(cloud)
    page_image = see(page, lambda image: count_pixels(image, BRICK) > 500)
    sides = [np.array(image.shape[1::-1]) for image in (file, page_image)]
    middles = [np.array(middle_of(image, BRICK)) for image in (file, page_image)]
    fractions = [(middle - side / 2) / side[1] for middle, side in zip(middles, sides, strict=True)]
    np.testing.assert_allclose(*fractions, atol=0.02)
