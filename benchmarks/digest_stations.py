"""The operations of digests.py on survey stations."""

from __future__ import annotations

from typing import Any

import numpy as np
from digest_scenes import Scenes, loom, reg

POSITIONS = np.array([[0.0, 0.0, 1.5], [0.8, 0.4, 1.6], [0.4, -0.8, 1.4]])


def surveyed(d: Scenes) -> list[Any]:
    """Three stations over a ground, from rough poses, and with a target and its control point."""
    x, y = np.random.default_rng(0).uniform(-3, 3, (2, 9000))
    ground = np.column_stack([x, y, 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)])
    scans = [loom().PointCloud(ground[k::3] - position, device=d.device) for k, position in enumerate(POSITIONS)]
    rough = np.tile(np.eye(4), (3, 1, 1))
    rough[:, :3, 3] = np.add(POSITIONS, [[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0]])
    spots = {"A": [1.0, 1.0, 0.5], "B": [-1.0, 0.5, 0.2]}
    observations = [
        reg().TargetObservation(k, name, np.subtract(at, position))
        for k, position in enumerate(POSITIONS)
        for name, at in spots.items()
    ]
    known = [reg().ControlPoint(name, at) for name, at in spots.items()]
    results = [
        reg().register_stations(scans, poses=rough, voxel_size=0.2, **options)
        for options in ({}, {"targets": observations, "control": known, "level": False})
    ]
    return [
        [one.poses, one.sigmas, one.sigma0, [pair.transformation for pair in one.pairs], one.to_dict()]
        for one in results
    ]
