"""Data of a recording: shapes, and frames that show some of them at poses."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np
from numpy.typing import NDArray


@dataclasses.dataclass(frozen=True, eq=False)
class Shape:
    """A drawable shape on the host.

    Args:
        positions: float32 (n, 3) relative to the timeline's origin [m]. Finite.
        colors: uint8 (n, 3) (lines: (m, 3) per segment), or None: all `plain`.
        normals: float32 (n, 3), or None.
        indices: int32 (m, 2) or (m, 3). None for points.
        size: Diameter of points or width of lines [px].
        cull: Hide back faces, to see into a closed room.
        unlit: Draw faces without lighting, for photographed colors.
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
class Placement:
    """Shapes in a frame: numbers in `Timeline.shapes`, and pose (4x4, relative to the timeline's origin)."""

    shapes: tuple[int, ...]
    pose: NDArray[np.float64] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Frame:
    """One time step: displayed shapes by name, label, and plotted numbers."""

    shown: dict[str, Placement]
    label: str = ""
    values: dict[str, float] = dataclasses.field(default_factory=dict)


@dataclasses.dataclass(eq=False)
class Timeline:
    """A recording: shapes, frames, and origin of positions; `name` (else `title`) is the title of the browser tab."""

    origin: NDArray[np.float64]
    shapes: list[Shape] = dataclasses.field(default_factory=list)
    frames: list[Frame] = dataclasses.field(default_factory=list)
    title: str = ""
    fps: float = 10.0
    name: str = ""
