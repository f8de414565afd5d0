"""Ground control of the synthetic flights: points on the ground and their marks by a distorted lens."""

import numpy as np

import pointloom as loom
from pointloom.photogrammetry.video.ground_control import ControlMark, GroundControl

from .made_flights import FRAME, hidden

LENS = loom.CameraModel("OPENCV", 640, 480, [480, 482, 322, 238, -0.08, 0.03, 0.001, -0.0005])
GROUND = np.array([
    [2.0, 3.0, 0.3], [41.0, 4.0, 1.8], [39.0, 44.0, 0.0], [4.0, 45.0, 2.4], [22.0, 24.0, 0.9], [30.0, 12.0, 1.1],
    [12.0, 30.0, 2.0],
])  # fmt: skip
NAMES = ("A", "B", "C", "D", "E", "F", "G")
SIGMA = 0.01


def model_of(poses):
    """The model in an arbitrary frame and unit, with the lens of this module."""
    model, _ = hidden(poses)
    return loom.SfmModel(model.names, [LENS] * len(model), model.T_camera_world)


def marks_of(poses, points=GROUND, names=NAMES, noise=0.0, max_count=8, seed=0):
    """Marks of the points in the pictures, in the order of the pictures."""
    rng = np.random.default_rng(seed)
    marks = []
    for name, point in zip(names, points, strict=True):
        seen = 0
        for k, T in enumerate(np.linalg.inv(poses)):
            pixel = LENS.project((T[:3, :3] @ point + T[:3, 3])[None])[0]
            if np.isfinite(pixel).all() and (pixel > 0).all() and (pixel < (639, 479)).all() and seen < max_count:
                pixel = pixel + rng.normal(size=2) * noise
                marks.append(ControlMark(name, f"IMG_{k:04d}.JPG", pixel))
                seen += 1
    return marks


def control_of(
    poses, points=GROUND, names=NAMES, *, marks=None, noise=0.0, crs="EPSG:32632", wrong=(), checks=(), bars=(), seed=0
):
    """Ground control in UTM, or in local east, north and up; `wrong` are (name, meters [3])."""
    rng = np.random.default_rng(seed + 100)
    known = FRAME.to_utm(points, int(crs[5:])) if crs else points.copy()
    known = known + rng.normal(size=known.shape) * (SIGMA if noise else 0.0)
    for name, off in wrong:
        known[names.index(name)] += off
    marks = marks_of(poses, points, names, noise, seed=seed) if marks is None else marks
    rows = [loom.registration.ControlPoint(name, position, SIGMA) for name, position in zip(names, known, strict=True)]
    return GroundControl(rows, marks, bars, crs, checks)
