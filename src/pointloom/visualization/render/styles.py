"""Drawing styles of geometries: `Style`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ...core.checks import check_color, check_fraction, check_name, check_positive, check_rigid
from .parts import Matrix, Triple


@dataclasses.dataclass(frozen=True)
class Style:
    """Drawing style of a geometry. None leaves a field to the geometry. Raises TypeError or ValueError with the key.

    Args:
        color: Uniform color: red, green and blue, 0 to 1.
        color_by, colormap, limits: Displayed property: "rgb", "normal", "height", "label" or an attribute.
        point_size: Diameter of points [px], or [m] if `metric`.
        wireframe: Draw edges over the faces. For a hull, edges only.
        shaded: Apply lighting; eye-dome lighting for points without normals.
        opacity: Opacity of points and faces, 0 to 1.
        pose: Rigid transformation, 4x4.
    """

    color: Triple | None = None
    color_by: str | None = None
    colormap: Any = None
    limits: Any = None
    point_size: float | None = None
    metric: bool = False
    line_width: float | None = None
    wireframe: bool | None = None
    back_faces: bool | None = None
    shaded: bool | None = None
    opacity: float | None = None
    pose: Matrix | None = None

    def __post_init__(self):
        if self.color is not None:
            red, green, blue = check_color("color", self.color).tolist()
            object.__setattr__(self, "color", (red, green, blue))
        if self.color_by is not None:
            check_name("color_by", self.color_by)
        for name in ("point_size", "line_width"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, check_positive(name, getattr(self, name)))
        if self.opacity is not None:
            object.__setattr__(self, "opacity", check_fraction("opacity", self.opacity))
        for name in ("metric", "wireframe", "back_faces", "shaded"):
            if getattr(self, name) is not None and not isinstance(getattr(self, name), bool | np.bool_):
                raise TypeError(f"{name}: expected True or False, got {getattr(self, name)!r}")
        if self.pose is not None:
            object.__setattr__(self, "pose", check_rigid("pose", self.pose))

    def over(self, other: Style) -> Style:
        """The style with the fields of another one where it has none."""
        chosen = {name: getattr(self if getattr(self, name) is not None else other, name) for name in _OPTIONAL}
        sized = self if self.point_size is not None else other
        return Style(**chosen, metric=sized.metric)


_OPTIONAL = tuple(field.name for field in dataclasses.fields(Style) if field.name != "metric")
STYLE_KEYS = tuple(field.name for field in dataclasses.fields(Style))
