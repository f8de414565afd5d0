"""Primitives that images, viewer and recordings draw: `Points`, `Lines`, `Triangles` and `Gaussians`.

Positions are float32 on a device, relative to a float64 origin, so that large coordinates (UTM) stay precise.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
Triple = tuple[float, float, float]


PLAIN_LINE: Triple = (0.15, 0.15, 0.15)  # of lines without a color


@dataclasses.dataclass(frozen=True, eq=False)
class Points:
    """Round splats.

    Args:
        positions: vec3 (n,) on a device, relative to `origin` [m]. Non-finite ones are not drawn.
        colors, normals: vec3 (n,), or of size 0. Without colors, points are `plain`.
        size: Diameter [px], or [m] if `metric`. None closes most gaps.
        shaded: Shade by normals, or by eye-dome lighting without normals.
        lit: Apply lighting to normals. Else colors keep their brightness.
        pose: 4x4, applied to the positions.
        coloring: Meaning of the colors for a color bar. None for the cloud's own colors.
    """

    positions: Any
    origin: NDArray[np.float64]
    colors: Any
    normals: Any
    size: float | None = None
    metric: bool = False
    shaded: bool = True
    lit: bool = True
    plain: Triple = (0.35, 0.50, 0.62)
    pose: Matrix | None = None
    coloring: Any = None
    opacity: float = 1.0


@dataclasses.dataclass(frozen=True, eq=False)
class Gaussians(Points):
    """Gaussian splats with their SplatColumns. Pages and the viewer draw them as points."""

    columns: Any = None


@dataclasses.dataclass(frozen=True, eq=False)
class Lines:
    """Segments: int32 `indices` (2 m,) of `positions`, `colors` vec3 (m,) or of size 0, `width` [px]. See `Points`.
    In images, those `in_front` hide all else."""

    positions: Any
    origin: NDArray[np.float64]
    indices: Any
    colors: Any
    width: float = 1.5
    plain: Triple = PLAIN_LINE
    pose: Matrix | None = None
    in_front: bool = False


@dataclasses.dataclass(frozen=True, eq=False)
class Triangles:
    """A surface. See `Points` for the other fields.

    Args:
        indices: int32 (3 t,), counterclockwise seen from outside.
        colors, normals: vec3 (n,) per vertex, or of size 0. Without normals, faces are flat.
        uvs: vec2 (3 t,) per corner, or of size 0; (0, 0) is the lower left corner of the texture.
        texture: uint8 (h, w, 3) on the host, or None.
        wireframe: Draw edges over the faces.
        cull: Hide back faces.
        lit: Apply lighting; None: all except textured surfaces, whose texture contains the light.
    """

    positions: Any
    origin: NDArray[np.float64]
    indices: Any
    colors: Any
    normals: Any
    uvs: Any = None
    texture: NDArray[np.uint8] | None = None
    wireframe: bool = False
    cull: bool = False
    lit: bool | None = None
    plain: Triple = (0.80, 0.78, 0.74)
    pose: Matrix | None = None
    coloring: Any = None
    opacity: float = 1.0

    @property
    def is_textured(self) -> bool:
        return self.texture is not None and self.uvs is not None and self.uvs.size > 0

    @property
    def is_lit(self) -> bool:
        """True if lighting is applied: colors alone show no relief, photographs contain light."""
        return not self.is_textured if self.lit is None else bool(self.lit)


Part = Points | Lines | Triangles
