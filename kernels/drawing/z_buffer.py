"""The z-buffer that points, lines and triangles are drawn into, without a graphics library, and how they get there.

A cell of the buffer is one word of 64 bits: the bits of the depth above the index of what is seen there. The smallest
word wins by an atomic minimum, so the picture is the same whatever the order of the threads; equal depths go to the
smaller index. The buffer is several cells a pixel of the picture wide (shading.py).

A scene is a few parts, each with vertices about an origin of its own. They share the buffer: what is drawn is numbered
through, and a `View` takes each part's vertices to the camera, in a unit of the scene's size, so that float32 neither
overflows nor vanishes.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..array_types import Array1, Device
from ..arrays.packed_keys import NO_KEY, pack_key
from ..lang import array, atomic_min, func, int64, isfinite, mat33, struct, vec3
from ..memory import empty, full

NEAR = 1.0e-6  # of the unit: smaller depths are behind the camera
FAR_OUT = 1.0e9  # [cells] where what is projected farther out is said to be: whole numbers of 32 bits hold it


@struct
class View:
    """A camera, and where the vertices of a part are before it.

    Attributes:
        camera: A Camera, or what has its attributes, in cells of a buffer.
        rotation, offset: x -> rotation x + offset takes vertices to the camera's frame; in any unit.
    """

    camera: Camera
    rotation: mat33
    offset: vec3

    def __init__(self, camera: CameraLike, rotation: np.ndarray, offset: np.ndarray) -> None:
        self.camera = camera  # type: ignore[assignment]  # like a Camera
        self.rotation, self.offset = rotation, offset


@struct
class DepthBuffer:
    """What is seen first in each cell.

    Attributes:
        width, height: Cells.
        words: int64 [height * width]: depth bits above an index, NO_KEY where nothing is seen.
        behind: int64 [height * width]: words that `offer_behind` takes are larger than these; of size 0 where it
            takes all.
    """

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
    """Keep the nearer of a cell's content and this one, unless this one lies before what the cell looks behind.

    As `offer_cell`: the plain read can only be too large, the atomic settles the race for the cell.
    """
    word = pack_key(depth, index)
    if word < buffer.words[cell]:
        least = int64(-1)
        if buffer.behind.shape[0] > 0:
            least = buffer.behind[cell]
        if word > least:
            atomic_min(buffer.words, cell, word)


@func
def to_camera(p: vec3, view: View) -> vec3:
    """A vertex in the camera's frame: x right, y down, z forward."""
    return view.rotation @ p + view.offset


@func
def project(q: vec3, view: View) -> vec3:
    """Column, row and depth of a point of the camera's frame; far out where it is hardly before the camera."""
    z = max(q[2], NEAR)
    u = float(view.camera.fx) * q[0] / z + float(view.camera.cx)
    v = float(view.camera.fy) * q[1] / z + float(view.camera.cy)
    return vec3(min(max(u, -FAR_OUT), FAR_OUT), min(max(v, -FAR_OUT), FAR_OUT), q[2])


@func
def is_before(q: vec3) -> int:
    """1 for a point of the camera's frame that lies before the camera."""
    before = 0
    if isfinite(q) and q[2] > NEAR:
        before = 1
    return before


@func
def ray_through(column: float, row: float, view: View) -> vec3:
    """The direction with depth 1 that is seen at a column and row, in the camera's frame."""
    x = (column - float(view.camera.cx)) / float(view.camera.fx)
    y = (row - float(view.camera.cy)) / float(view.camera.fy)
    return vec3(x, y, 1.0)
