"""What pictures, viewer and recordings draw: `Points`, `Lines` and `Triangles`, whatever the geometry was.

Positions are float32 on a device, about an origin in float64, so that what lies at UTM coordinates does not tremble.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
Triple = tuple[float, float, float]


PLAIN_LINE: Triple = (0.15, 0.15, 0.15)  # of lines without a colour


@dataclasses.dataclass(frozen=True, eq=False)
class Points:
    """Round splats.

    Args:
        positions: vec3 [n] on a device, about `origin` [m]; what is not finite is not drawn.
        origin: Shape [3], float64 [m].
        colors: vec3 [n], 0 to 1, or of size 0: then all are `plain`.
        normals: vec3 [n], or of size 0.
        size: Diameter: [px], or [m] where `metric`; None closes most gaps.
        metric: Whether `size` is in metres.
        shaded: Whether light falls at an angle, or where there is none, what lies behind its neighbours is darker.
        lit: Whether light falls on normals; without, colours stay as bright as they are.
        plain: The colour of what has none.
        pose: Moves what is drawn, 4x4.
        coloring: What the colours mean, for a colour bar; None where they are the cloud's own.
        opacity: 0 to 1; below 1 what lies behind is seen through it.
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
    """Gaussian splats; for those who draw no ellipsoids (pages, the viewer), points of their size and colour.

    Args:
        columns: A SplatColumns of the same positions.
    """

    columns: Any = None


@dataclasses.dataclass(frozen=True, eq=False)
class Lines:
    """Straight segments.

    Args:
        positions: vec3 [n] on a device, about `origin` [m].
        origin: Shape [3], float64 [m].
        indices: int32 [2 m], two positions a segment.
        colors: vec3 [m], one a segment, 0 to 1, or of size 0.
        width: [px].
        plain: The colour of what has none.
        pose: Moves what is drawn, 4x4.
    """

    positions: Any
    origin: NDArray[np.float64]
    indices: Any
    colors: Any
    width: float = 1.5
    plain: Triple = PLAIN_LINE
    pose: Matrix | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Triangles:
    """A surface.

    Args:
        positions: vec3 [n] on a device, about `origin` [m].
        origin: Shape [3], float64 [m].
        indices: int32 [3 t], counterclockwise seen from outside.
        colors: vec3 [n], one a vertex, 0 to 1, or of size 0.
        normals: vec3 [n], one a vertex, or of size 0: then faces are flat.
        uvs: vec2 [3 t], one a corner, or of size 0; (0, 0) is the lower left corner of the texture.
        texture: uint8 [h, w, 3] on the host, or None.
        wireframe: Edges over the faces.
        cull: Leave out faces that look away.
        lit: Whether light falls at an angle; None for all but those with a texture, which has the light in it.
        plain: The colour of what has none.
        pose: Moves what is drawn, 4x4.
        coloring: What the colours mean, for a colour bar; None where they are the mesh's own.
        opacity: 0 to 1; below 1 what lies behind is seen through it, its own faces too.
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
        """Whether there is a texture, and where in it each corner lies."""
        return self.texture is not None and self.uvs is not None and self.uvs.size > 0

    @property
    def is_lit(self) -> bool:
        """Whether light falls at an angle: colours alone show no relief, photographs have their own light."""
        return not self.is_textured if self.lit is None else bool(self.lit)


Part = Points | Lines | Triangles
