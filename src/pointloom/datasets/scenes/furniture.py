"""A furnished room of 5 x 4 x 2.6 m as colored solids.

x is right along the long wall, y into the room, z up [m], origin in a floor corner; window at y = 4, door at x = 5.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Device
from ...kernels.linear_algebra import matmul
from ...kernels.scenes.primitives import BOX_KIND, CYLINDER_KIND, Solids
from ...kernels.scenes.room import CHECKER_PATTERN, GLOW_PATTERN, PLAIN_PATTERN, PLANKS_PATTERN, STRIPES_PATTERN, Room

ROOM_SIZE = (5.0, 4.0, 2.6)  # [m]
LAMP_POSITION = (2.5, 2.0, 2.2)  # [m] position of the light below the ceiling
WALL_THICKNESS = 0.2  # [m] thickness of the walls, and depth of the window's recess

Triple = tuple[float, float, float]
Color = Triple  # red, green, blue, 0 to 1
Tilt = tuple[int, float]  # axis, angle [degrees]


class Paint(NamedTuple):
    """Two colors that alternate in a pattern of some period [m]."""

    first: Color
    second: Color
    pattern: int = PLAIN_PATTERN
    period: float = 1.0


_WHITE_RGB: Color = (0.93, 0.92, 0.89)
_OAK_RGB: Color = (0.74, 0.55, 0.35)
_WALNUT_RGB: Color = (0.42, 0.27, 0.17)
_STEEL_RGB: Color = (0.45, 0.47, 0.50)


def furnished_room() -> SolidBuilder:
    room = SolidBuilder()
    for add in (_shell, _window, _sofa, _rug, _table, _shelf, _lamps, _images, _small_things):
        room.set_frame(0, 0)
        add(room)
    return room


def sofa() -> SolidBuilder:
    alone = SolidBuilder()
    _sofa(alone)
    return alone


def build_room(device: Device) -> Room:
    """The furnished room on a device, ready to render."""
    parts = furnished_room()
    margin = WALL_THICKNESS + 0.15
    low, high = (-margin, -margin, -margin), tuple(s + margin for s in ROOM_SIZE)
    solids = parts.solids(device)
    return Room(solids, np.array(parts.paints), np.array(parts.patterns), lamp=LAMP_POSITION, low=low, high=high)


def _shell(room: SolidBuilder) -> None:
    x, y, z = ROOM_SIZE
    w = WALL_THICKNESS
    long, wide = x + 2 * w, y + 2 * w
    room.box(
        (x / 2, y / 2, -w / 2), (long, wide, w), Paint((0.72, 0.53, 0.36), (0.50, 0.34, 0.22), PLANKS_PATTERN, 0.14)
    )
    room.box((x / 2, y / 2, z + w / 2), (long, wide, w), _WHITE_RGB)
    room.box((-w / 2, y / 2, z / 2), (w, wide, z), (0.56, 0.68, 0.70))
    room.box((x + w / 2, y / 2, z / 2), (w, wide, z), _WHITE_RGB)
    room.box((x / 2, -w / 2, z / 2), (x, w, z), (0.90, 0.84, 0.72))
    for low, high in ((0.0, 1.6), (3.4, x)):
        room.box(((low + high) / 2, y + w / 2, z / 2), (high - low, w, z), _WHITE_RGB)
    room.box((2.5, y + w / 2, 0.45), (1.8, w, 0.9), _WHITE_RGB)
    room.box((2.5, y + w / 2, 2.375), (1.8, w, 0.45), _WHITE_RGB)
    skirting = (0.97, 0.96, 0.94)
    room.box((x / 2, y - 0.01, 0.05), (x, 0.02, 0.1), skirting)
    room.box((x / 2, 0.01, 0.05), (x, 0.02, 0.1), skirting)
    room.box((0.01, y / 2, 0.05), (0.02, y, 0.1), skirting)
    # the door
    room.box((x - 0.02, 3.3, 1.02), (0.04, 0.92, 2.04), (0.86, 0.87, 0.85))
    for low in (0.18, 1.1):
        room.box((x - 0.045, 3.3, low + 0.38), (0.02, 0.62, 0.76), (0.80, 0.81, 0.79), radius=0.008)
    room.cylinder((x - 0.06, 2.93, 1.02), 0.014, 0.06, _STEEL_RGB, tilt=(1, 90))
    room.sphere((x - 0.105, 2.93, 1.02), 0.033, (0.80, 0.66, 0.30))


def _window(room: SolidBuilder) -> None:
    x, y, z, frame = 2.5, ROOM_SIZE[1] + WALL_THICKNESS, 1.5, (0.97, 0.97, 0.97)
    room.box((x, y + 0.05, z), (1.9, 0.1, 1.4), Paint((0.62, 0.80, 0.95), (0.70, 0.86, 0.97), STRIPES_PATTERN, 0.3))
    for side in (-0.87, 0.0, 0.87):
        room.box((x + side, y - 0.03, z), (0.06, 0.06, 1.2), frame)
    for height in (-0.57, 0.57):
        room.box((x, y - 0.03, z + height), (1.8, 0.06, 0.06), frame)
    room.box((x, y - 0.13, 0.885), (2.0, 0.38, 0.03), frame, radius=0.008)
    for side in (-1, 1):
        for fold in range(5):
            at = x + side * (0.98 + 0.09 * fold)
            room.cylinder(
                (at, 3.93, 1.2), 0.05, 2.3, Paint((0.80, 0.46, 0.33), (0.72, 0.38, 0.27), STRIPES_PATTERN, 0.06)
            )
    room.cylinder((x, 3.93, 2.38), 0.014, 3.1, _STEEL_RGB, tilt=(1, 90))
    for rib in range(11):
        room.box((x - 0.5 + 0.1 * rib, 3.9, 0.42), (0.06, 0.09, 0.56), (0.95, 0.94, 0.92), radius=0.028)


def _sofa(room: SolidBuilder) -> None:
    cloth, dark = (0.30, 0.42, 0.47), (0.24, 0.35, 0.40)
    room.set_frame(0.55, 1.9, angle=-90)  # at the wall x = 0. Its x is along the wall, its y into the room
    room.box((0, 0.0, 0.24), (2.0, 0.84, 0.24), dark, radius=0.05)
    room.box((0, -0.36, 0.52), (2.0, 0.2, 0.62), cloth, radius=0.08)
    for side in (-1, 1):
        room.box((side * 0.96, 0.02, 0.38), (0.22, 0.86, 0.5), cloth, radius=0.09)
        room.box((side * 0.43, 0.08, 0.42), (0.84, 0.7, 0.17), (0.36, 0.49, 0.54), radius=0.06)
        for depth in (-0.34, 0.34):
            room.cylinder((side * 0.88, depth, 0.06), 0.025, 0.12, _WALNUT_RGB)
    mustard, rose = (0.88, 0.66, 0.22), (0.78, 0.36, 0.34)
    room.box(
        (-0.66, -0.14, 0.68),
        (0.42, 0.15, 0.42),
        Paint(mustard, (0.95, 0.88, 0.7), STRIPES_PATTERN, 0.06),
        radius=0.07,
        tilt=(0, 22),
    )
    room.box(
        (0.62, -0.14, 0.68),
        (0.42, 0.15, 0.42),
        Paint(rose, (0.9, 0.75, 0.68), CHECKER_PATTERN, 0.07),
        radius=0.07,
        tilt=(0, 24),
    )


def _rug(room: SolidBuilder) -> None:
    """The rug and a low round table in front of the sofa."""
    room.set_frame(1.75, 1.95)
    room.box(
        (0, 0, 0.01),
        (1.7, 2.3, 0.02),
        Paint((0.72, 0.25, 0.22), (0.88, 0.80, 0.66), CHECKER_PATTERN, 0.19),
        radius=0.009,
    )
    room.cylinder(
        (-0.05, 0.05, 0.40), 0.40, 0.035, Paint(_OAK_RGB, (0.66, 0.47, 0.29), STRIPES_PATTERN, 0.05), rounding=0.012
    )
    for corner in range(3):
        angle = math.radians(120 * corner + 20)
        at = (-0.05 + 0.26 * math.cos(angle), 0.05 + 0.26 * math.sin(angle), 0.2)
        room.cylinder(at, 0.022, 0.4, _WALNUT_RGB)
    room.cylinder(
        (-0.2, 0.1, 0.465),
        0.042,
        0.095,
        Paint((0.90, 0.90, 0.92), (0.2, 0.4, 0.7), CHECKER_PATTERN, 0.04),
        rounding=0.006,
    )
    room.box((0.12, 0.16, 0.43), (0.21, 0.28, 0.022), (0.15, 0.35, 0.60), tilt=(2, 25))
    room.box((0.12, 0.15, 0.452), (0.19, 0.25, 0.022), (0.85, 0.80, 0.70), tilt=(2, 12))


def _table(room: SolidBuilder) -> None:
    room.set_frame(3.75, 1.75, angle=8)
    room.box((0, 0, 0.735), (0.85, 1.4, 0.04), Paint(_OAK_RGB, (0.64, 0.45, 0.28), PLANKS_PATTERN, 0.12), radius=0.012)
    for x in (-0.36, 0.36):
        for y in (-0.63, 0.63):
            room.cylinder((x, y, 0.36), 0.032, 0.72, _OAK_RGB)
    # a plate of fruit, a laptop and a mug
    room.cylinder((0.02, 0.32, 0.775), 0.17, 0.04, (0.93, 0.93, 0.90), rounding=0.018)
    fruit = ((-0.06, 0.30, (0.85, 0.25, 0.18)), (0.06, 0.27, (0.95, 0.60, 0.15)), (0.03, 0.40, (0.55, 0.72, 0.22)))
    for x, y, color in fruit:
        room.sphere((x, y, 0.835), 0.045, color)
    room.sphere((0.01, 0.325, 0.895), 0.043, (0.90, 0.75, 0.20))
    room.box(
        (0.08, -0.32, 0.763),
        (0.25, 0.35, 0.016),
        Paint(_STEEL_RGB, (0.2, 0.2, 0.22), CHECKER_PATTERN, 0.03),
        radius=0.006,
    )
    room.box(
        (-0.075, -0.32, 0.875),
        (0.012, 0.35, 0.23),
        Paint((0.22, 0.24, 0.28), (0.3, 0.55, 0.75), CHECKER_PATTERN, 0.08),
        radius=0.005,
        tilt=(1, -14),
    )
    room.cylinder((0.28, 0.02, 0.80), 0.04, 0.09, (0.80, 0.30, 0.25), rounding=0.006)
    for x, y, angle in ((-0.72, 0.28, -85), (0.76, -0.28, 97)):
        _chair(room, 3.75 + x, 1.75 + y, angle)


def _chair(room: SolidBuilder, x: float, y: float, angle: float) -> None:
    """A chair whose front faces its own y axis."""
    wood, seat = _WALNUT_RGB, (0.86, 0.80, 0.68)
    room.set_frame(x, y, angle=angle)
    room.box((0, 0, 0.45), (0.42, 0.42, 0.05), Paint(seat, (0.75, 0.66, 0.52), STRIPES_PATTERN, 0.05), radius=0.022)
    for side in (-0.18, 0.18):
        room.cylinder((side, 0.18, 0.215), 0.02, 0.43, wood)
        room.cylinder((side, -0.19, 0.46), 0.02, 0.92, wood)
    for height in (0.62, 0.74, 0.87):
        room.box((0, -0.195, height), (0.38, 0.022, 0.075), wood, radius=0.01)


def _shelf(room: SolidBuilder) -> None:
    room.set_frame(1.3, 0.17)
    wood, back = (0.80, 0.66, 0.48), (0.66, 0.52, 0.36)
    for side in (-0.63, 0.63):
        room.box((side, 0, 0.95), (0.03, 0.32, 1.9), wood)
    for board in range(6):
        room.box((0, 0, 0.075 + 0.362 * board), (1.24, 0.32, 0.03), wood)
    room.box((0, -0.155, 0.95), (1.26, 0.01, 1.9), back)
    covers = (
        (0.62, 0.20, 0.18), (0.18, 0.33, 0.52), (0.86, 0.70, 0.32), (0.25, 0.45, 0.32), (0.88, 0.84, 0.76),
        (0.42, 0.24, 0.42), (0.85, 0.46, 0.22), (0.20, 0.22, 0.26), (0.45, 0.62, 0.70),
    )  # fmt: skip
    book = 0
    for board, runs in enumerate((((-0.58, 14),), ((-0.58, 6), (0.20, 7)), ((-0.30, 11),), ((-0.58, 8), (0.36, 4)))):
        floor = 0.09 + 0.362 * board
        for start, count in runs:
            x = start
            for _ in range(count):
                thick = 0.032 + 0.008 * (book * 7 % 5)
                height = 0.20 + 0.014 * (book * 11 % 7)
                color = covers[book * 5 % 9]
                room.box((x + thick / 2, -0.03, floor + height / 2), (thick, 0.21, height), color)
                x += thick + 0.004
                book += 1
    room.sphere(
        (-0.46, 0.0, 0.09 + 0.362 * 2 + 0.11),
        0.11,
        Paint((0.25, 0.50, 0.75), (0.35, 0.62, 0.35), CHECKER_PATTERN, 0.07),
    )
    room.box((0.02, 0.0, 0.09 + 0.362 * 3 + 0.1), (0.2, 0.14, 0.2), (0.72, 0.56, 0.60), radius=0.02)
    room.cylinder((-0.40, 0, 0.09 + 0.362 * 4 + 0.11), 0.075, 0.22, (0.35, 0.55, 0.52), rounding=0.03)
    room.cylinder(
        (0.0, 0, 0.09 + 0.362 * 4 + 0.06),
        0.10,
        0.12,
        Paint((0.90, 0.86, 0.80), (0.75, 0.42, 0.3), CHECKER_PATTERN, 0.06),
    )
    room.sphere((0.36, 0, 0.09 + 0.362 * 4 + 0.09), 0.09, (0.85, 0.80, 0.30))


def _lamps(room: SolidBuilder) -> None:
    shade = (0.98, 0.93, 0.80)
    room.cylinder(
        (LAMP_POSITION[0], LAMP_POSITION[1], 2.55),
        0.24,
        0.10,
        Paint((0.98, 0.95, 0.88), (0.98, 0.95, 0.88), GLOW_PATTERN, 1.0),
        rounding=0.04,
    )
    room.set_frame(0.45, 3.45)
    room.cylinder((0, 0, 0.015), 0.15, 0.03, _STEEL_RGB, rounding=0.01)
    room.cylinder((0, 0, 0.72), 0.014, 1.4, _STEEL_RGB)
    room.cylinder((0, 0, 1.55), 0.19, 0.30, Paint(shade, (0.92, 0.82, 0.62), STRIPES_PATTERN, 0.05))
    room.sphere((0, 0, 1.72), 0.035, _STEEL_RGB)


def _images(room: SolidBuilder) -> None:
    frame = (0.16, 0.15, 0.15)
    room.set_frame(0, 1.9, 1.55)  # above the sofa
    for y, wide, high, first, second, kind in (
        (-0.55, 0.70, 0.50, (0.85, 0.55, 0.30), (0.20, 0.35, 0.45), (CHECKER_PATTERN, 0.11)),
        (0.25, 0.50, 0.66, (0.90, 0.86, 0.78), (0.65, 0.20, 0.22), (PLANKS_PATTERN, 0.07)),
    ):
        room.box((0.015, y, 0), (0.03, wide, high), frame)
        room.box((0.03, y, 0), (0.012, wide - 0.08, high - 0.08), Paint(first, second, *kind))
    room.set_frame(3.7, 0, 1.5)
    room.box((0, 0.015, 0), (1.0, 0.03, 0.7), frame)
    room.box((0, 0.03, 0), (0.9, 0.012, 0.6), Paint((0.25, 0.42, 0.55), (0.92, 0.72, 0.42), CHECKER_PATTERN, 0.15))
    room.set_frame(5.0, 1.3, 1.6)
    room.cylinder((-0.02, 0, 0), 0.17, 0.04, (0.95, 0.95, 0.95), rounding=0.008, tilt=(1, 90))
    room.box((-0.045, 0.03, 0.045), (0.008, 0.014, 0.13), frame, tilt=(0, -35))
    room.box((-0.045, -0.03, 0.02), (0.008, 0.014, 0.09), frame, tilt=(0, 60))


def _small_things(room: SolidBuilder) -> None:
    # a plant with leaves of capsules
    room.set_frame(4.55, 0.45)
    room.cylinder((0, 0, 0.17), 0.17, 0.34, (0.78, 0.42, 0.28), rounding=0.02)
    room.cylinder((0, 0, 0.55), 0.016, 0.5, (0.35, 0.27, 0.15))
    for leaf in range(14):
        angle, lift, high = leaf * 137.5, 25 + 8 * (leaf % 6), 0.55 + 0.035 * leaf
        room.set_frame(4.55, 0.45, high, angle=angle)
        green = (0.20 + 0.03 * (leaf % 4), 0.48 + 0.04 * (leaf % 3), 0.22)
        c, s = math.cos(math.radians(lift)), math.sin(math.radians(lift))
        room.box((0.19 * c, 0, 0.19 * s), (0.36, 0.11, 0.03), green, radius=0.015, tilt=(1, -lift))
    room.set_frame(0, 0)
    room.sphere(
        (2.45, 0.62, 0.13), 0.13, Paint((0.92, 0.92, 0.90), (0.85, 0.22, 0.20), CHECKER_PATTERN, 0.11), tilt=(0, 30)
    )
    room.set_frame(2.9, 3.2, angle=20)  # a pouf and a toy box below the window
    room.cylinder(
        (0, 0, 0.2), 0.27, 0.4, Paint((0.55, 0.42, 0.62), (0.64, 0.52, 0.70), STRIPES_PATTERN, 0.07), rounding=0.09
    )
    room.set_frame(4.35, 3.0, angle=-12)
    room.box(
        (-0.25, 0.45, 0.14),
        (0.42, 0.3, 0.28),
        Paint((0.30, 0.55, 0.70), (0.92, 0.90, 0.85), CHECKER_PATTERN, 0.09),
        radius=0.02,
    )
    room.box((-0.25, 0.45, 0.35), (0.28, 0.22, 0.14), (0.85, 0.72, 0.25), radius=0.02, tilt=(2, 30))


class SolidBuilder:
    """Collects solids, in the frame set by `set_frame`. Its arrays are those of `Solids` and `Room`."""

    def __init__(self):
        self.kinds: list[int] = []
        self.rotations: list[NDArray[np.float64]] = []
        self.centers: list[NDArray[np.float64]] = []
        self.extents: list[tuple[float, float, float, float]] = []
        self.paints: list[tuple[Color, Color]] = []
        self.patterns: list[tuple[int, float]] = []
        self.set_frame(0, 0)

    def set_frame(self, x: float, y: float, z: float = 0.0, *, angle: float = 0.0) -> None:
        """Set the frame: a position [m] and a rotation [degrees] about z."""
        self.frame, self.offset = _rotation_about(2, angle), np.array([x, y, z])

    def box(
        self, center: Triple, size: Triple, paint: Color | Paint, *, radius: float = 0.0, tilt: Tilt = (0, 0.0)
    ) -> None:
        """A box of full `size` [m], its edges rounded by `radius` [m], tilted about an axis [degrees]."""
        half = [s / 2 - radius for s in size]
        if min(half) < 0:
            raise ValueError(f"radius: {radius} m is more than half of {min(size)} m")
        self._add(BOX_KIND, center, (half[0], half[1], half[2], radius), paint, tilt)

    def cylinder(
        self,
        center: Triple,
        radius: float,
        height: float,
        paint: Color | Paint,
        *,
        rounding: float = 0.0,
        tilt: Tilt = (0, 0.0),
    ) -> None:
        """A cylinder along z with `radius` and full `height` [m], its edges rounded by `rounding` [m]."""
        self._add(CYLINDER_KIND, center, (radius - rounding, 0.0, height / 2 - rounding, rounding), paint, tilt)

    def sphere(self, center: Triple, radius: float, paint: Color | Paint, *, tilt: Tilt = (0, 0.0)) -> None:
        self._add(BOX_KIND, center, (0.0, 0.0, 0.0, radius), paint, tilt)

    def _add(
        self, kind: int, center: Triple, extent: tuple[float, float, float, float], paint: Color | Paint, tilt: Tilt
    ) -> None:
        paint = paint if isinstance(paint, Paint) else Paint(paint, paint)
        self.kinds.append(kind)
        self.centers.append(self.offset + matmul(self.frame, center))
        self.rotations.append(matmul(self.frame, _rotation_about(*tilt)).T)
        self.extents.append(extent)
        self.paints.append((paint.first, paint.second))
        self.patterns.append((paint.pattern, paint.period))

    def solids(self, device: Device) -> Solids:
        kinds = np.array(self.kinds, np.int32)
        return Solids(kinds, np.array(self.rotations), np.array(self.centers), np.array(self.extents), device)


def _rotation_about(axis: int, degrees: float) -> NDArray[np.float64]:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
    return R
