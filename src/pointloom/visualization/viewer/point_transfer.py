"""A cloud that a page stores completely, or as an even sample: `WholeCloud`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import finite_rows
from ...kernels.memory import download
from ..recording.shapes import spread_rows
from ..render.parts import Points
from ..render.view import View
from .items import Frame, Item, Matrix

if TYPE_CHECKING:
    from .link import Node, PageClient

Keep = Callable[[NDArray[np.float64]], NDArray[np.bool_]]

# A page draws this number well within a second even in software.
POINTS_IN_FIRST_STEP = 125_000
POINTS_PER_STEP = 250_000
AT_ONCE = 200_000  # steps would not be faster up to this number of points


class WholeCloud:
    """The points of an item in one page, or an even sample within the budget. Same interface as `CloudStream`.

    Large clouds start with an even sample, and `send_next` adds more. Replacements are sent at once. `point_size` is
    the diameter of points [px], or [m] if `metric`.
    """

    def __init__(
        self, client: PageClient, item: Item, *, frame: Frame, budget: int, point_size: float, metric: bool = False
    ):
        self._client, self._frame, self.budget = client, frame, budget
        self._size: dict[str, Any] = {"size": point_size, "metric": metric}
        self._keep, self._visible = None, item.visible
        self._colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]] = item.colors_of
        self._nodes: list[Node] = []
        self._sent: list[NDArray[np.int64]] = []  # point indices of each step
        self._steps: list[NDArray[np.int64]] = []
        self._is_lit = False
        self.replace(item)

    def replace(self, item: Item) -> None:
        part = item.points
        assert part is not None
        is_lit = bool(part.shaded and part.lit and part.normals.size)
        with self._client.atomic():
            if is_lit != self._is_lit:  # nodes either have normals or not
                self.close()
            self._is_lit = is_lit
            self._replace(item, part)

    def _replace(self, item: Item, part: Points) -> None:
        self._item, self._part, self._colors_of = item, part, item.colors_of
        self.total = part.positions.size
        positions = download(part.positions).reshape(-1, 3)
        chosen = even_fraction(self.total, self.budget)
        rows = positions if chosen is None else positions[chosen]
        finite = finite_rows(rows)
        self._indices = np.flatnonzero(finite) if chosen is None else chosen[finite]
        self._positions = np.asarray(rows if finite.all() else rows[finite], np.float32)
        is_complete = not self.waits
        self._steps = in_steps(len(self._positions))
        count = len(self._steps) if is_complete and self._nodes else len(self._nodes)
        self._send(min(max(count, 1), len(self._steps)))

    @property
    def drawn(self) -> int:
        return sum(map(len, self._sent)) if self._visible else 0

    @property
    def waits(self) -> bool:
        return len(self._nodes) < len(self._steps)

    def send_next(self) -> None:
        if self.waits:
            self._send_step(len(self._nodes))

    def look(self, view: View) -> None:
        """No effect: the page has all points."""

    def set_colors(self, colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]]) -> None:
        self._colors_of = colors_of
        with self._client.atomic():
            for node, sent in zip(self._nodes, self._sent, strict=True):
                node.set(colors=colors_of(sent))

    def set_keep(self, keep: Keep | None) -> None:
        """Set a mask function of visible points. None shows all."""
        self._keep = keep
        self._send(len(self._nodes))

    def set_point_size(self, size: float | None, metric: bool = False) -> None:
        self._size = {"size": size, "metric": metric}
        with self._client.atomic():
            for node in self._nodes:
                node.set(**self._size)

    def set_visible(self, visible: bool) -> None:
        self._visible = visible
        with self._client.atomic():
            for node in self._nodes:
                node.visible = visible

    def set_pose(self, T: Matrix | None) -> None:
        R, t = self._frame.pose_in_page(self._part.origin, self._item.pose_of(self._part))
        with self._client.atomic():
            for node in self._nodes:
                node.set_transform(R, t)

    def close(self) -> None:
        with self._client.atomic():
            for node in self._nodes:
                node.remove()
        self._nodes, self._sent, self._steps = [], [], []

    def _send(self, count: int) -> None:
        """Replace all points by the first `count` steps at once."""
        with self._client.atomic():
            for number in range(count):
                self._send_step(number)
            for node in self._nodes[count:]:
                node.remove()
        del self._nodes[count:], self._sent[count:]

    def _send_step(self, number: int) -> None:
        """Send the visible points of a step with their colors."""
        rows = self._steps[number]
        positions, sent = self._positions[rows], self._indices[rows]
        if self._keep is not None and len(positions):
            selected = self._keep(positions.astype(np.float64) + self._part.origin)
            positions, sent = positions[selected], sent[selected]
        R, t = self._frame.pose_in_page(self._part.origin, self._item.pose_of(self._part))
        looks = {"positions": positions, "colors": self._colors_of(sent), **self._light(sent)}
        for array in looks.values():
            array.flags.writeable = False  # made for the page only, so it need not be copied
        looks |= self._size
        if number < len(self._nodes):
            self._sent[number] = sent
            self._nodes[number].set(**looks)
            self._nodes[number].set_transform(R, t)
            return
        self._nodes.append(
            self._client.scene.add_points(
                **looks,
                relief=self._part.shaded and not self._is_lit,
                R=R,
                t=t,
                scale=1 / self._frame.unit,
                visible=self._visible,
            )
        )
        self._sent.append(sent)

    def _light(self, sent: NDArray[np.int64]) -> dict[str, NDArray[Any]]:
        return {"normals": download(self._part.normals).reshape(-1, 3)[sent]} if self._is_lit else {}


def in_steps(count: int) -> list[NDArray[np.int64]]:
    """Rows of a cloud in parts that each cover all of it, a small one first. One part for few rows."""
    if count <= AT_ONCE:
        return [np.arange(count)]
    first = spread_rows(count, POINTS_IN_FIRST_STEP).astype(np.int64)
    is_left = np.ones(count, bool)
    is_left[first] = False
    left = np.flatnonzero(is_left)
    steps = -(-len(left) // POINTS_PER_STEP)
    return [first, *(left[k::steps] for k in range(steps))]


def even_fraction(count: int, budget: int) -> NDArray[np.int64] | None:
    """Reproducible even sample of rows, ascending. None for all."""
    return None if count <= budget else spread_rows(count, budget).astype(np.int64)
