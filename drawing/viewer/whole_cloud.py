"""A cloud that one page holds whole, or an even share of it, sent in a few steps: `WholeCloud`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import finite_rows
from ...kernels.memory import download
from ..recording.shapes import spread_rows
from ..render.parts import Points
from .items import Frame, Item, Matrix

if TYPE_CHECKING:
    from .link import Node, PageClient

Keep = Callable[[NDArray[np.float64]], NDArray[np.bool_]]

# Points that a page draws in well under a second even in software; they come first, the others in steps.
FIRST = 125_000
STEP = 250_000
AT_ONCE = 200_000  # points up to which steps would show nothing sooner


class WholeCloud:
    """The points of an item in one page; of more than the budget, an even share.

    Of many points an even part comes first, and `send_next` adds the others to it. What takes the place of points that
    are there comes all at once.

    Has the methods of `CloudStream`, which serves clouds that do not fit.

    Args:
        client: The page.
        item: The cloud.
        frame: The page's coordinates.
        budget: Points that may be sent.
        point_size: Diameter of points [px], or with `metric` [m].
        metric: See `point_size`.
    """

    def __init__(
        self, client: PageClient, item: Item, *, frame: Frame, budget: int, point_size: float, metric: bool = False
    ):
        self._client, self._frame, self.budget = client, frame, budget
        self._size: dict[str, Any] = {"size": point_size, "metric": metric}
        self._keep, self._visible = None, item.visible
        self._colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]] = item.colors_of
        self._nodes: list[Node] = []
        self._sent: list[NDArray[np.int64]] = []  # which points each of them holds
        self._steps: list[NDArray[np.int64]] = []
        self._is_lit = False
        self.replace(item)

    def replace(self, item: Item) -> None:
        """Show other points under the same name, all at once."""
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
        chosen = even_share(self.total, self.budget)
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
        """Points that the page has."""
        return sum(map(len, self._sent)) if self._visible else 0

    @property
    def waits(self) -> bool:
        """Whether there are steps that the page does not have yet."""
        return len(self._nodes) < len(self._steps)

    def send_next(self) -> None:
        """Send the next step."""
        if self.waits:
            self._send_step(len(self._nodes))

    def look(self, view: Any) -> None:
        """Nothing to do: the page has it all."""

    def set_colors(self, colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]]) -> None:
        """Show other colours; 3 B a point."""
        self._colors_of = colors_of
        with self._client.atomic():
            for node, sent in zip(self._nodes, self._sent, strict=True):
                node.set(colors=colors_of(sent))

    def set_keep(self, keep: Keep | None) -> None:
        """Show only points for which this is true; None shows all."""
        self._keep = keep
        self._send(len(self._nodes))

    def set_point_size(self, size: float, metric: bool = False) -> None:
        """The diameter of points [px], or with `metric` [m]."""
        self._size = {"size": size, "metric": metric}
        with self._client.atomic():
            for node in self._nodes:
                node.set(**self._size)

    def set_visible(self, visible: bool) -> None:
        """Show or hide it."""
        self._visible = visible
        with self._client.atomic():
            for node in self._nodes:
                node.visible = visible

    def set_pose(self, T: Matrix | None) -> None:
        """Move it: the item's pose is what counts."""
        R, t = self._frame.place(self._part.origin, self._item.pose_of(self._part))
        with self._client.atomic():
            for node in self._nodes:
                node.place(R, t)

    def close(self) -> None:
        """Take it out of the page."""
        with self._client.atomic():
            for node in self._nodes:
                node.remove()
        self._nodes, self._sent, self._steps = [], [], []

    def _send(self, count: int) -> None:
        """Send so many steps, all at once, in place of those that are there."""
        with self._client.atomic():
            for number in range(count):
                self._send_step(number)
            for node in self._nodes[count:]:
                node.remove()
        del self._nodes[count:], self._sent[count:]

    def _send_step(self, number: int) -> None:
        """Send what is kept of a step; points and colours arrive together."""
        rows = self._steps[number]
        positions, sent = self._positions[rows], self._indices[rows]
        if self._keep is not None and len(positions):
            kept = self._keep(positions.astype(np.float64) + self._part.origin)
            positions, sent = positions[kept], sent[kept]
        R, t = self._frame.place(self._part.origin, self._item.pose_of(self._part))
        looks = {"positions": positions, "colors": self._colors_of(sent), **self._light(sent)}
        for array in looks.values():
            array.flags.writeable = False  # made for the page alone: nobody has to copy it
        looks |= self._size
        if number < len(self._nodes):
            self._sent[number] = sent
            self._nodes[number].set(**looks)
            self._nodes[number].place(R, t)
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
        """Normals, where light falls on them."""
        return {"normals": download(self._part.normals).reshape(-1, 3)[sent]} if self._is_lit else {}


def in_steps(count: int) -> list[NDArray[np.int64]]:
    """Rows of a cloud in parts that are each spread over all of it, the first one small; one part of few rows."""
    if count <= AT_ONCE:
        return [np.arange(count)]
    first = spread_rows(count, FIRST).astype(np.int64)
    is_left = np.ones(count, bool)
    is_left[first] = False
    left = np.flatnonzero(is_left)
    steps = -(-len(left) // STEP)
    return [first, *(left[k::steps] for k in range(steps))]


def even_share(count: int, budget: int) -> NDArray[np.int64] | None:
    """Rows from all parts of a cloud, the same each time, ascending; None for all."""
    return None if count <= budget else spread_rows(count, budget).astype(np.int64)
