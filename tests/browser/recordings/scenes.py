"""Small recordings, and values read from their pages."""

from __future__ import annotations

import math

import numpy as np

import pointloom as loom
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline
from pointloom.visualization.render.view import View

from ..pixels import picture, ready

RED, BLUE, GREEN = (220, 30, 20), (20, 60, 220), (20, 170, 40)


def grid(count=60, size=1.0, z=0.0) -> np.ndarray:
    """A square of points."""
    axis = np.linspace(-size, size, count)
    x, y = np.meshgrid(axis, axis)
    return np.column_stack([x.ravel(), y.ravel(), np.full(count * count, z)]).astype(np.float32)


def one_frame(*shapes: Shape, origin=(0, 0, 0), label="") -> Timeline:
    """Stationary shapes, each with its own name."""
    shown = {f"part {number}": Placement((number,)) for number in range(len(shapes))}
    return Timeline(np.array(origin, float), list(shapes), [Frame(shown, label)])


def moved(x: float, y: float = 0.0) -> np.ndarray:
    T = np.eye(4)
    T[:2, 3] = x, y
    return T


def two_clouds(frame_count=8, origin=(0, 0, 0)) -> Timeline:
    """A red square that moves from the left onto a stationary blue one."""
    up = np.tile(np.float32([0, 0, 1]), (3600, 1))
    shapes = [
        Shape("points", grid(), None, up, size=4.0, plain=RED),
        Shape("points", grid(z=-0.5), None, up, size=4.0, plain=BLUE),
    ]
    last = frame_count - 1
    frames = [
        Frame(
            {"source": Placement((0,), moved(3 * (k / last - 1))), "target": Placement((1,))},
            f"iteration {k}",
            {"fitness": k / last, "inlier_rmse": 0.1 * math.exp(-k)},
        )
        for k in range(frame_count)
    ]
    return Timeline(np.array(origin, float), shapes, frames, title="two squares", fps=20)


def from_above(height=10.0, width=640, rows=480, origin=(0, 0, 0)) -> View:
    """A camera over the origin that looks down, y up in the image."""
    T = np.diag([1.0, -1, -1, 1])
    T[:3, 3] = np.add(origin, (0, 0, height))
    return View(loom.PinholeCameraIntrinsic(width, rows, 600.0, 600.0, (width - 1) / 2, (rows - 1) / 2), T)


def box_of_triangles() -> Shape:
    low, high = np.array([-1, -1, -0.5]), np.array([1, 1, 0.5])
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)], np.float32)
    faces = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4]]
    faces += [[2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
    return Shape("triangles", corners, indices=np.int32(faces), plain=(204, 199, 189))


def stage(page) -> np.ndarray:
    """The image of the scene at rest, without overlays."""
    page.evaluate(
        """() => {
            for (const id of ["panel", "help", "help-button", "overlay"]) document.getElementById(id).style.opacity = 0;
            document.getElementById("scene").style.outline = "none";
        }"""
    )
    ready(page)
    box = page.locator("#scene").bounding_box()
    return picture(page, panels=True)[: round(box["height"]), : round(box["width"])]


def is_reddish(image: np.ndarray) -> np.ndarray:
    """Mask of red pixels of any brightness."""
    red, green, blue = np.moveaxis(image.astype(int), -1, 0)
    return (red > 40) & (red > 2 * (green + blue))


def near_outlines(image: np.ndarray, contrast=12) -> np.ndarray:
    """Pixels whose 3 x 3 neighborhood is not uniform."""
    squares = np.lib.stride_tricks.sliding_window_view(np.pad(image, ((1, 1), (1, 1), (0, 0)), "edge"), (3, 3), (0, 1))
    return (squares.max(axis=(-2, -1)).astype(int) - squares.min(axis=(-2, -1)) > contrast).any(axis=-1)


def statistics(page) -> dict:
    return page.evaluate("recording.statistics()")
