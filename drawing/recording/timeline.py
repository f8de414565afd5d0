"""What is seen when: shapes that are made once, and frames that show some of them somewhere."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np
from numpy.typing import NDArray


@dataclasses.dataclass(frozen=True, eq=False)
class Shape:
    """Something to draw, on the host.

    Args:
        kind: What `indices` join.
        positions: Shape [n, 3], float32, about the timeline's origin [m]; finite.
        colors: Shape [n, 3], uint8 (of lines: [m, 3], one a segment), or None: then all are `plain`.
        normals: Shape [n, 3], float32, or None.
        indices: Shape [m, 2] or [m, 3], int32; None for points.
        size: Diameter of points, width of lines [px].
        plain: Red, green and blue, uint8.
        wireframe: Edges over the faces.
        cull: Leave out faces that look away, so that one sees into a closed room through its near walls.
        unlit: Faces stay as bright as their colours: photographs have their own light.
    """

    kind: Literal["points", "lines", "triangles"]
    positions: NDArray[np.float32]
    colors: NDArray[np.uint8] | None = None
    normals: NDArray[np.float32] | None = None
    indices: NDArray[np.int32] | None = None
    size: float = 2.0
    plain: tuple[int, int, int] = (89, 128, 158)
    wireframe: bool = False
    cull: bool = False
    unlit: bool = False


@dataclasses.dataclass(frozen=True, eq=False)
class Placed:
    """Shapes in a frame: their numbers in `Timeline.shapes`, and where they lie (4x4, about the timeline's origin)."""

    shapes: tuple[int, ...]
    pose: NDArray[np.float64] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Frame:
    """One moment: what is shown by name, what it is called, and the numbers that are plotted beside it."""

    shown: dict[str, Placed]
    label: str = ""
    values: dict[str, float] = dataclasses.field(default_factory=dict)


@dataclasses.dataclass(eq=False)
class Timeline:
    """A recording: shapes, frames, and where positions count from; a browser's tab has its name, else its title."""

    origin: NDArray[np.float64]
    shapes: list[Shape] = dataclasses.field(default_factory=list)
    frames: list[Frame] = dataclasses.field(default_factory=list)
    title: str = ""
    fps: float = 10.0
    name: str = ""
