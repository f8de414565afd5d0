"""Scene of a viewer, independent of its pages: `Scene`."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_name, check_positive, check_shape
from ...core.errors import PointloomError
from ...core.up_axis import check_up
from ..render.geometries import Named, check_units
from ..render.parts import Triple
from ..render.up_axis import look_of
from ..render.view import View, fit_view
from .camera import diagonal, read_parameters
from .coloring_choice import ColoringChoice
from .extents import Bounds, Extents
from .items import Frame, Item
from .point_transfer import POINTS_IN_FIRST_STEP

POINT_SIZE = 3.0  # [px] default size of points
SMALLEST_POINT, LARGEST_POINT = 0.5, 40.0  # [px]
MAX_OUTLINE_POINTS, MIN_OUTLINE = 100_000, 50  # points of clouds for the view of everything. Minimum number per cloud
NORMAL_LENGTH = 0.01  # over the scene's diagonal
_EMPTY_BOUNDS: Bounds = (np.full(3, -1.0), np.full(3, 1.0))  # bounds of an empty scene


class Scene:
    """The items of a viewer, their appearance and the initial view. Changes require `lock`.

    Args:
        max_points, point_size, background, size: See `Viewer`.

    Attributes:
        shown: Items that the pages show, by name.
        frame: Coordinates of the pages.
        previews: Items whose levels of detail are being built, by name.
        point_count, triangle_count: Of all clouds, and of all surfaces.
    """

    def __init__(
        self, max_points: int, point_size: float, background: NDArray[np.float64], size: tuple[int, int]
    ) -> None:
        self.lock = threading.RLock()
        self.max_points, self.size, self.background = max_points, size, background
        self.has_own_background = bool((background != 1).any())  # a white background may follow dark mode
        self.point_size, self.has_own_point_size = point_size, point_size != POINT_SIZE
        self.frame, self.coloring = Frame(np.zeros(3)), ColoringChoice()
        self.wireframe = self.normals = False
        self.shown: dict[str, Item] = {}
        self.previews: dict[str, Item] = {}
        self.point_count = self.triangle_count = 0
        self._extents = Extents()
        self._with_unit: dict[str, Any] = {}  # geometries that had a unit when added
        self._budgets_changed = False
        self._view: View | dict[str, Any] | None = None
        self._up: Triple | None = None
        self._last_number = -1
        self._ended = threading.Event()

    @property
    def closed(self) -> bool:
        return self._ended.is_set()

    def shut_down(self) -> None:
        self._ended.set()

    def wait_until_closed(self, seconds: float) -> bool:
        """True if the viewer was closed within this time [s]."""
        return self._ended.wait(seconds)

    def clear(self) -> None:
        """Release the memory after `shut_down`."""
        self.shown, self._extents, self._with_unit = {}, Extents(), {}

    def check_open(self) -> None:
        if self.closed:
            raise PointloomError("the viewer is closed; open another one")

    def take_lock(self) -> bool:
        """Take `lock` in a thread that `close` may wait for. False if the viewer is closed."""
        while not self.closed:
            if self.lock.acquire(timeout=0.05):
                if not self.closed:
                    return True
                self.lock.release()
        return False

    @property
    def up(self) -> Triple | None:
        return self._up

    @up.setter
    def up(self, value: ArrayLike | str | None) -> None:
        self._up = None if value is None else check_up(value)

    def home(self) -> View:
        """Initial view of pages: that of `set_view`, else the complete scene."""
        if isinstance(self._view, View):
            return self._view
        width, height = self.size
        if self._view is not None:
            return View.from_open3d(self.bounds, **self._view, width=width, height=height)
        direction, up = look_of(((item.geometry, item.style.pose) for item in self.shown.values()), self._up)
        return fit_view(self._outline(), direction=direction, up=up, width=width, height=height)

    @property
    def has_own_view(self) -> bool:
        """True if `set_view` defined the initial view."""
        return self._view is not None

    def set_view(self, given: Any) -> View:
        """Set the initial view. If it cannot be drawn, raise TypeError or ValueError without a change."""
        before, self._view = self._view, read_parameters(given)
        try:
            with np.errstate(all="ignore"):
                return self.home()
        except (TypeError, ValueError, ArithmeticError) as error:
            self._view = before
            kind = TypeError if isinstance(error, TypeError) else ValueError
            raise kind(f"view of {', '.join(given)}: {error}") from error

    @property
    def bounds(self) -> Bounds:
        """Lowest and highest corner [m]. A 2 m box if the scene is empty."""
        bounds = self._extents.union()
        return _EMPTY_BOUNDS if bounds is None else bounds

    @property
    def is_empty(self) -> bool:
        """True if no item has bounds."""
        return not len(self._extents)

    def choose_frame(self) -> bool:
        """Choose the pages' coordinates at the first geometry. False if there are no bounds."""
        if self.is_empty:
            return False
        self.frame = Frame.around(self.bounds)
        return True

    def find(self, name: str) -> Item:
        if check_name("name", name) not in self.shown:
            known = ", ".join(map(repr, self.shown)) or "none"
            raise KeyError(f"name: no geometry {name!r}; there are {known}")
        return self.shown[name]

    def next_number(self) -> int:
        self._last_number += 1
        return self._last_number

    def add_item(self, item: Item) -> None:
        """Add an item, replacing one of the same name."""
        self._count(self.shown.get(item.name), -1)
        self.shown[item.name] = item
        self._count(item, 1)
        self._with_unit.pop(item.name, None)
        if getattr(item.geometry, "unit", None) is not None:
            self._with_unit[item.name] = item.geometry
        self.update_bounds(item)
        self.recolor(item)

    def remove_item(self, name: str) -> None:
        self._with_unit.pop(name, None)
        self._extents.drop(name)
        self._count(self.shown.pop(name, None), -1)

    def update_bounds(self, item: Item) -> None:
        """Update the scene's bounds after an item was moved."""
        self._extents.put(item.name, item.world_bounds())

    def recolor(self, item: Item) -> None:
        item.recolor(self.coloring.of(item))

    def _count(self, item: Item | None, sign: int) -> None:
        """Update the point and triangle counts. Detect changed budgets of clouds."""
        if item is None:
            return
        self.triangle_count += sign * item.triangle_count
        if item.cloud is not None and len(item.cloud):
            was_over = self.point_count > self.max_points
            self.point_count += sign * item.point_count
            self._budgets_changed |= was_over or self.point_count > self.max_points

    def take_budget_change(self) -> bool:
        """True if budgets of clouds may have changed since the last call."""
        changed, self._budgets_changed = self._budgets_changed, False
        return changed

    def budget_of(self, item: Item) -> int:
        """Number of points of a cloud in a page: its part of `max_points`."""
        if item.cloud is None or self.point_count <= self.max_points:
            return self.max_points
        budget = max(1, self.max_points * item.point_count // self.point_count)
        return min(budget, POINTS_IN_FIRST_STEP) if item.tree is None and item.name in self.previews else budget

    @property
    def normal_length(self) -> float | None:
        """Length of displayed normals [m]. None if they are hidden."""
        return NORMAL_LENGTH * diagonal(self.bounds) if self.normals else None

    def check_units(self, named: list[Named]) -> None:
        """Warn if the scene would have two length units."""
        replaced = {name for name, _, _ in named}
        kept = next((geometry for name, geometry in self._with_unit.items() if name not in replaced), None)
        check_units([*([] if kept is None else [kept]), *(geometry for _, geometry, _ in named)])

    @property
    def page_unit(self) -> str | None:
        """Length unit of the pages. None if unknown or mixed."""
        units = {geometry.unit for geometry in self._with_unit.values()} - {None}
        unit = units.pop() if len(units) == 1 and self.frame.unit == 1 else None
        return None if unit is None or unit.meters is None else unit.symbol

    def _outline(self) -> NDArray[np.float64]:
        """Points that define the complete scene: samples of clouds, corners of all other geometries."""
        if self.is_empty:
            return np.stack(_EMPTY_BOUNDS)
        clouds = [item for item in self.shown.values() if item.cloud is not None and item.bounds is not None]
        each = MAX_OUTLINE_POINTS // max(len(clouds), 1)
        if each < MIN_OUTLINE:  # so few that their boxes suffice
            return self._extents.corners()
        samples = [item.sample()[:: -(-len(item.sample()) // each)] for item in clouds]
        boxes = Extents()
        for item in self.shown.values():
            if item.cloud is None:
                boxes.put(item.name, item.world_bounds())
        return np.vstack([*samples, boxes.corners()])


def check_color(color: ArrayLike) -> NDArray[np.float64]:
    return np.clip(check_finite("background", check_shape("background", color, (3,))), 0, 1)


def check_size(size: float) -> float:
    """Point size [px], clipped to the visible range."""
    return min(max(check_positive("point_size", size), SMALLEST_POINT), LARGEST_POINT)
