"""How a geometry is drawn: what users say of colour, size, light and place."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ...core.checks import check_color, check_name, check_positive, check_rigid, check_share
from .parts import Matrix, Triple


@dataclasses.dataclass(frozen=True)
class Style:
    """How a geometry is drawn; None leaves it to the geometry.

    Args:
        color: Red, green and blue, 0 to 1, of all of it.
        color_by: What of points or vertices is shown as colour: "rgb", "normal", "height", "label" or any attribute.
        colormap: Of values.
        limits: The values at the ends of the colour map.
        point_size: Diameter of points: [px], or [m] where `metric`.
        metric: Whether `point_size` is in metres.
        line_width: [px].
        wireframe: Edges over the faces; of a hull, edges alone.
        back_faces: Whether faces that look away are drawn.
        shaded: Whether light falls at an angle; of points without normals, whether depth is shown.
        opacity: Of points and faces, 0 to 1; below 1 what lies behind is seen through them.
        pose: Moves it, a rigid 4x4.

    Raises:
        TypeError, ValueError: A value out of range; names the key.
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
            object.__setattr__(self, "opacity", check_share("opacity", self.opacity))
        for name in ("metric", "wireframe", "back_faces", "shaded"):
            if getattr(self, name) is not None and not isinstance(getattr(self, name), bool | np.bool_):
                raise TypeError(f"{name}: expected True or False, got {getattr(self, name)!r}")
        if self.pose is not None:
            object.__setattr__(self, "pose", check_rigid("pose", self.pose))

    def over(self, other: Style) -> Style:
        """This style, and another's where it leaves something open."""
        names = [field.name for field in dataclasses.fields(self) if field.name != "metric"]
        chosen = {name: getattr(self if getattr(self, name) is not None else other, name) for name in names}
        sized = self if self.point_size is not None else other
        return Style(**chosen, metric=sized.metric)


STYLE_KEYS = tuple(field.name for field in dataclasses.fields(Style))
