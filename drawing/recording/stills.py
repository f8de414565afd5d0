"""The shapes of a frame as a picture: `Stills`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ...core.devices import resolve_device
from ...kernels.lang import int32, vec3
from ...kernels.memory import empty, upload
from ..render.canvas import Canvas
from ..render.parts import Lines, Part, Points, Triangles, Triple
from ..render.scene import Scene
from ..render.view import View
from .timeline import Frame, Shape, Timeline


class Stills:
    """Draws the frames of a timeline; what stays from one to the next stays on the device.

    Args:
        timeline: The recording.
        view: Where from, in world coordinates.
        background: Red, green and blue, 0 to 1.
        device: Where to draw; None for the CPU.
    """

    def __init__(self, timeline: Timeline, view: View, background: Triple, device: Any):
        self._timeline, self._background, self._device = timeline, background, resolve_device(device)
        T = view.T_world_camera.copy()
        T[:3, 3] -= timeline.origin  # about which shapes lie: so nothing large is left to round
        self._view = dataclasses.replace(view, T_world_camera=T)
        self._parts: dict[int, Part] = {}

    def draw(self, frame: Frame) -> Canvas:
        """The picture of a frame, to be drawn on."""
        placed = [(number, placed.pose) for placed in frame.shown.values() for number in placed.shapes]
        wanted = {number for number, _ in placed}
        self._parts = {number: part for number, part in self._parts.items() if number in wanted}
        for number in sorted(wanted - set(self._parts)):
            self._parts[number] = _part(self._timeline.shapes[number], self._device)
        parts = [dataclasses.replace(self._parts[number], pose=pose) for number, pose in placed]
        camera = self._view.intrinsic
        drawing = Scene(parts, self._device).draw(self._view, background=self._background)
        return Canvas(drawing.picture, camera.width, camera.height)


def _part(shape: Shape, device: Any) -> Part:
    red, green, blue = (np.array(shape.plain) / 255).tolist()
    none = empty(0, vec3, device)
    colors = none if shape.colors is None else upload(shape.colors / np.float32(255), vec3, device)
    normals = none if shape.normals is None else upload(shape.normals, vec3, device)
    positions, origin = upload(shape.positions, vec3, device), np.zeros(3)
    plain = red, green, blue
    if shape.kind == "points":
        return Points(positions, origin, colors, normals, size=shape.size, plain=plain)
    indices = upload(np.empty(0, np.int32) if shape.indices is None else shape.indices.ravel(), int32, device)
    if shape.kind == "lines":
        return Lines(positions, origin, indices, colors, width=shape.size, plain=plain)
    faces: dict[str, Any] = {"wireframe": shape.wireframe, "cull": shape.cull, "lit": not shape.unlit}
    return Triangles(positions, origin, indices, colors, normals, **faces, plain=plain)
