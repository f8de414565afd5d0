"""Geometries of the tests of the viewer, and input to its page."""

from __future__ import annotations

import numpy as np
from playwright.sync_api import Page

import pointloom as loom

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
# Surfaces are not given a primary color: the page's tone mapping reaches none there, so that no mistake would show.
WHITE, BRICK = (255, 255, 255), (204, 64, 51)
WIDTH, HEIGHT = 720, 480  # of the window [px]; the panel stands in its right half


def sphere() -> loom.TriangleMesh:
    return loom.TriangleMesh.create_sphere(1.0)


def grid_cloud() -> loom.PointCloud:
    return loom.PointCloud(np.stack(np.meshgrid(*[np.linspace(0, 1, 12)] * 3), -1).reshape(-1, 3))


def at(x: float) -> np.ndarray:
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


def brick(geometry: object, **style: object) -> dict[str, object]:
    """A surface in its own color, without light."""
    return {"geometry": geometry, "color": np.array(BRICK) / 255, "shaded": False, **style}


def press(page: Page, key: str) -> None:
    """Press a key for the scene, not for a control."""
    page.evaluate("() => document.activeElement?.blur()")
    page.keyboard.press(key)


def changed(image: np.ndarray, before: np.ndarray) -> int:
    """Pixels that differ visibly."""
    return int((np.abs(image.astype(int) - before).max(axis=-1) > 30).sum())
