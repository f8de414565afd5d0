"""The shapes of a frame as a picture."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pictures.parts import Triple
from ..pictures.render import render_point_cloud
from ..pictures.view import View
from .timeline import Frame, Timeline


class Stills:
    """Draws shapes; interim: points alone."""

    def __init__(self, timeline: Timeline, view: View, background: Triple, device: Any):
        self._timeline, self._background, self._device = timeline, background, device
        T = view.T_world_camera.copy()
        T[:3, 3] -= timeline.origin
        self._view = dataclasses.replace(view, T_world_camera=T)

    def draw(self, frame: Frame) -> NDArray[np.uint8]:
        """The picture of a frame."""
        points, colors = [np.empty((0, 3))], [np.empty((0, 3))]
        for placed in frame.shown.values():
            for number in placed.shapes:
                shape = self._timeline.shapes[number]
                p = shape.positions.astype(np.float64)
                c = np.tile(np.array(shape.plain) / 255, (len(p), 1)) if shape.colors is None else shape.colors / 255
                if shape.kind == "lines" and shape.indices is not None:
                    a, b = p[shape.indices[:, 0]], p[shape.indices[:, 1]]
                    t = np.linspace(0, 1, 40)[:, None, None]
                    p = (a + t * (b - a)).reshape(-1, 3)
                    c = np.tile(np.array(shape.plain) / 255, (len(p), 1))
                if placed.pose is not None:
                    p = p @ placed.pose[:3, :3].T + placed.pose[:3, 3]
                points.append(p)
                colors.append(c)
        cloud = SimpleNamespace(points=np.vstack(points), colors=np.vstack(colors))
        return render_point_cloud(
            cloud, point_size=3, view=self._view, background=self._background, device=self._device
        )
