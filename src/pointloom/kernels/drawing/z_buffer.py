"""Z-buffer of points, lines and triangles, without a graphics library.

A cell is a 64-bit word, depth bits above an index. The atomic minimum is independent of thread order, ties go to the
smaller index. Scene parts have their own origins and share the numbering. A `View` maps vertices to the camera in units
of the scene's size to avoid float32 overflow.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..array_types import Array1, Device
from ..arrays.packed_keys import NO_KEY, pack_key
from ..lang import array, atomic_min, func, int64, isfinite, mat33, struct, vec3
from ..memory import empty, full

MIN_DEPTH = 1.0e-6  # of the unit: smaller depths count as behind the camera
FAR_OUT = 1.0e9  # [cells] clamp for projections, which fits into int32


@struct
class View:
    """A `camera` in cells of a buffer, and the map rotation x + offset from vertices to its frame, in any unit."""

    camera: Camera
    rotation: mat33
    offset: vec3

    def __init__(self, camera: CameraLike, rotation: np.ndarray, offset: np.ndarray) -> None:
        self.camera = camera  # type: ignore[assignment]  # like a Camera
        self.rotation, self.offset = rotation, offset


@struct
class DepthBuffer:
    """First element in each cell: `words`, NO_KEY if empty. Exclusive lower bounds `behind`, or empty."""

    width: int
    height: int
    words: array(dtype=int64)
    behind: array(dtype=int64)

    def __init__(
        self,
        width: int,
        height: int,
        device: Device,
        *,
        words: Array1[int64] | None = None,
        behind: Array1[int64] | None = None,
    ) -> None:
        self.width, self.height = width, height
        self.words = full(width * height, NO_KEY, int64, device) if words is None else words
        self.behind = empty(0, int64, device) if behind is None else behind


@func
def offer_behind(cell: int, depth: float, index: int, buffer: DepthBuffer):
    """As `offer_cell` (the atomic resolves the race), if the element is behind the cell's bound."""
    word = pack_key(depth, index)
    if word < buffer.words[cell]:
        bound = int64(-1)
        if buffer.behind.shape[0] > 0:
            bound = buffer.behind[cell]
        if word > bound:
            atomic_min(buffer.words, cell, word)


@func
def to_camera(p: vec3, view: View) -> vec3:
    """A vertex in the camera frame: x right, y down, z forward."""
    return view.rotation @ p + view.offset


@func
def project(q: vec3, view: View) -> vec3:
    """Column, row and depth of a camera-frame point; far outside if it is hardly before the camera."""
    z = max(q[2], MIN_DEPTH)
    u = float(view.camera.fx) * q[0] / z + float(view.camera.cx)
    v = float(view.camera.fy) * q[1] / z + float(view.camera.cy)
    return vec3(min(max(u, -FAR_OUT), FAR_OUT), min(max(v, -FAR_OUT), FAR_OUT), q[2])


@func
def is_before(q: vec3) -> int:
    before = 0
    if isfinite(q) and q[2] > MIN_DEPTH:
        before = 1
    return before


@func
def ray_through(column: float, row: float, view: View) -> vec3:
    """Camera-frame direction with depth 1 through a column and row."""
    x = (column - float(view.camera.cx)) / float(view.camera.fx)
    y = (row - float(view.camera.cy)) / float(view.camera.fy)
    return vec3(x, y, 1.0)
