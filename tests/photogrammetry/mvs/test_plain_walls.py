"""Depth without texture: a gray wall takes the plane of its frame, and a ball in front keeps its shape."""

import dataclasses

import numpy as np
import pytest
from scipy import ndimage

import pointloom as loom
from pointloom.photogrammetry.mvs import plane_search
from pointloom.photogrammetry.mvs.depth_maps import DepthMaps
from pointloom.photogrammetry.mvs.posed_images import SparsePoints

from .made_images import texture
from .made_maps import pose
from .test_estimation import ALL, digest

WIDTH, HEIGHT, FOCAL = 96, 72, 100.0
LENS = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)
SLANT, DISTANCE = 0.2, 2.0  # the wall is z = 2 + 0.2 x
HALF_WIDE, HALF_HIGH = 0.6, 0.42  # of the gray part [m]
CENTER, RADIUS = np.array([0.0, 0.0, 1.6]), 0.32  # of the ball
NOISE = 2.0  # [of 255]


def cameras() -> list[loom.photogrammetry.PosedCamera]:
    return [loom.photogrammetry.PosedCamera(LENS, pose(x, y)) for x, y in ((0.0, 0.0), (0.12, 0.0), (-0.04, 0.12))]


def look(camera: loom.photogrammetry.PosedCamera, seed: int, ball: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Noisy gray image, depth, and labels (0 frame, 1 gray wall, 2 ball), each [h, w]."""
    v, u = np.mgrid[:HEIGHT, :WIDTH].astype(np.float64)
    rays = np.stack([(u - LENS.cx) / FOCAL, (v - LENS.cy) / FOCAL, np.ones_like(u)], axis=-1)
    start = camera.center
    depth = (DISTANCE + SLANT * start[0]) / (1.0 - SLANT * rays[..., 0])
    points = start + rays * depth[..., None]
    kind = ((np.abs(points[..., 0]) < HALF_WIDE) & (np.abs(points[..., 1]) < HALF_HIGH)).astype(int)
    if ball:
        a, b, c = (rays**2).sum(-1), rays @ (start - CENTER), (start - CENTER) @ (start - CENTER) - RADIUS**2
        root = b * b - a * c
        near = (-b - np.sqrt(np.maximum(root, 0.0))) / a
        depth, kind = np.where(root > 0, near, depth), np.where(root > 0, 2, kind)
        points = start + rays * depth[..., None]
    waves = texture(2.0 * points[..., 0], 2.0 * points[..., 1])
    light = np.where(kind == 1, 0.6, waves) * 255
    noise = np.random.default_rng(seed).normal(0.0, NOISE, light.shape)
    return np.clip(np.rint(light + noise), 0, 255).astype(np.uint8), depth, kind


def estimate(ball: bool, **options) -> tuple[DepthMaps, list[np.ndarray], list[np.ndarray]]:
    """Depth maps, relative depth errors, and labels of the pixels."""
    posed = cameras()
    seen = [look(camera, i, ball) for i, camera in enumerate(posed)]
    v, u = np.mgrid[2:HEIGHT:6, 2:WIDTH:6]
    depth = seen[0][1][v, u]
    points = np.stack([(u - LENS.cx) / FOCAL * depth, (v - LENS.cy) / FOCAL * depth, depth], -1)
    points = points[seen[0][2][v, u] != 1]  # there are no features on the gray wall
    sparse = SparsePoints(points, [(i, k) for i in range(3) for k in range(len(points))])
    maps = loom.photogrammetry.estimate_depth_maps([each[0] for each in seen], posed, sparse, sources=ALL, **options)
    pairs = [(estimated.depth, true[1]) for estimated, true in zip(maps, seen, strict=True)]
    wrong = [np.where(depth > 0, np.abs(depth / true - 1), np.inf) for depth, true in pairs]
    return maps, wrong, [each[2] for each in seen]


def inner(kind: np.ndarray) -> np.ndarray:
    """Pixels whose window contains only the gray wall: the frame counts as texture."""
    return ndimage.binary_erosion(kind == 1, iterations=3)


@pytest.fixture(scope="module")
def filled():
    return estimate(False)


def test_a_gray_wall_with_a_textured_frame_is_filled_and_passes_the_filter(device, filled):
    maps, wrong, kind = estimate(False, device=device)
    for off, what in zip(wrong, kind, strict=True):
        assert (off[inner(what)] < 0.01).mean() > 0.95
    assert digest(maps) == digest(filled[0])  # on every device the same bits
    assert (loom.photogrammetry.filter_depth_maps(maps)[0].depth[inner(kind[0])] > 0).mean() > 0.8


@pytest.mark.slow
def test_a_textured_ball_before_a_gray_wall_stays_a_ball(monkeypatch, device):
    _, wrong, kind = estimate(True, device=device)
    without_priors = tuple(dataclasses.replace(phase, prior=False) for phase in plane_search.SEARCH_PHASES)
    monkeypatch.setattr(plane_search, "SEARCH_PHASES", without_priors)
    _, before, _ = estimate(True, device=device)
    ball, wall = kind[0] == 2, kind[0] == 1
    assert np.median(wrong[0][ball]) < 0.01
    assert (wrong[0][ball] < 0.02).mean() > (before[0][ball] < 0.02).mean() - 0.02
    assert (wrong[0][wall] < 0.01).mean() > (before[0][wall] < 0.01).mean() + 0.2
