"""Scenes of solids put together by hand: full sizes, places relative to a piece of furniture, angles in degrees."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.scenes.primitives import BOX, CYLINDER, Solids
from ...kernels.scenes.room import PLAIN

Color = tuple[float, float, float]


class SolidBuilder:
    """Collects solids; `place` sets the frame in which the following ones are given.

    Attributes:
        kinds, rotations, centers, extents: As `Solids` takes them.
        paints, patterns: As `Room` takes them.
    """

    def __init__(self):
        self.kinds: list[int] = []
        self.rotations: list[NDArray[np.float64]] = []
        self.centers: list[NDArray[np.float64]] = []
        self.extents: list[tuple[float, float, float, float]] = []
        self.paints: list[tuple[Color, Color]] = []
        self.patterns: list[tuple[int, float]] = []
        self.place(0, 0)

    def place(self, x: float, y: float, z: float = 0.0, *, turn: float = 0.0) -> None:
        """Move the frame to a place [m], turned by an angle [degrees] about z."""
        self.frame, self.offset = _turn_about(2, turn), np.array([x, y, z])

    def box(
        self,
        center: tuple[float, float, float],
        size: tuple[float, float, float],
        color: Color,
        *,
        radius: float = 0.0,
        second: Color | None = None,
        pattern: tuple[int, float] = (PLAIN, 1.0),
        tilt: tuple[int, float] = (0, 0.0),
    ) -> None:
        """A box of this full size [m], its edges rounded by `radius` [m], tilted about an axis by degrees."""
        half = [s / 2 - radius for s in size]
        if min(half) < 0:
            raise ValueError(f"radius: {radius} m is more than half of {min(size)} m")
        self._add(BOX, center, (half[0], half[1], half[2], radius), color, second, pattern, tilt)

    def cylinder(
        self,
        center: tuple[float, float, float],
        radius: float,
        height: float,
        color: Color,
        *,
        rounding: float = 0.0,
        second: Color | None = None,
        pattern: tuple[int, float] = (PLAIN, 1.0),
        tilt: tuple[int, float] = (0, 0.0),
    ) -> None:
        """A cylinder along z with this radius and full height [m], its edges rounded by `rounding` [m]."""
        extent = (radius - rounding, 0.0, height / 2 - rounding, rounding)
        self._add(CYLINDER, center, extent, color, second, pattern, tilt)

    def sphere(
        self,
        center: tuple[float, float, float],
        radius: float,
        color: Color,
        *,
        second: Color | None = None,
        pattern: tuple[int, float] = (PLAIN, 1.0),
        tilt: tuple[int, float] = (0, 0.0),
    ) -> None:
        """A sphere [m]."""
        self._add(BOX, center, (0.0, 0.0, 0.0, radius), color, second, pattern, tilt)

    def _add(
        self,
        kind: int,
        center: tuple[float, float, float],
        extent: tuple[float, float, float, float],
        color: Color,
        second: Color | None,
        pattern: tuple[int, float],
        tilt: tuple[int, float],
    ) -> None:
        self.kinds.append(kind)
        self.centers.append(self.offset + self.frame @ center)
        self.rotations.append((self.frame @ _turn_about(*tilt)).T)
        self.extents.append(extent)
        self.paints.append((color, second or color))
        self.patterns.append(pattern)

    def solids(self, device: Any) -> Solids:
        """The solids on a device."""
        return Solids(
            np.array(self.kinds, np.int32),
            np.array(self.rotations),
            np.array(self.centers),
            np.array(self.extents),
            device,
        )


def _turn_about(axis: int, degrees: float) -> NDArray[np.float64]:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
    return R
