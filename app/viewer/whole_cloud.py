"""A cloud that one page holds at once, or an even share of it: `WholeCloud`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.memory import download
from ..recording.shapes import spread_rows
from .items import Frame, Item, Matrix

if TYPE_CHECKING:
    import viser

Keep = Callable[[NDArray[np.float64], NDArray[np.int64]], NDArray[np.bool_]]


class WholeCloud:
    """The points of an item in one page; of more than the budget, an even share.

    Has the methods of `CloudStream`, which serves clouds that do not fit.

    Args:
        client: The page.
        name: Of its node.
        item: The cloud.
        frame: The page's coordinates.
        budget: Points that may be sent.
        point_size: In units of the page.
    """

    def __init__(
        self, client: viser.ClientHandle, name: str, item: Item, *, frame: Frame, budget: int, point_size: float
    ):
        self._client, self._name, self._frame, self.budget = client, name, frame, budget
        self._point_size, self._keep, self._visible = point_size, None, item.visible
        self._colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]] = item.colors_of
        self._handle: Any = None
        self.replace(item)

    def replace(self, item: Item) -> None:
        """Show other points under the same name, all at once."""
        part = item.points
        assert part is not None
        self._item, self._part, self._colors_of = item, part, item.colors_of
        self.total = part.positions.size
        positions = download(part.positions).reshape(-1, 3)
        chosen = even_share(self.total, self.budget)
        rows = positions if chosen is None else positions[chosen]
        finite = np.isfinite(rows).all(axis=1)
        self._indices = np.flatnonzero(finite) if chosen is None else chosen[finite]
        self._positions = np.asarray(rows[finite], np.float32)
        self._send()

    @property
    def drawn(self) -> int:
        """Points that the page has."""
        return len(self._sent) if self._visible else 0

    def look(self, view: Any) -> None:
        """Nothing to do: the page has it all."""

    def set_colors(self, colors_of: Callable[[NDArray[np.int64]], NDArray[np.uint8]]) -> None:
        """Show other colours; 3 B a point."""
        self._colors_of = colors_of
        if self._handle is not None:
            self._handle.colors = colors_of(self._sent)

    def set_keep(self, keep: Keep | None) -> None:
        """Show only points for which this is true; None shows all."""
        self._keep = keep
        self._send()

    def set_point_size(self, size: float) -> None:
        """The size in units of the page."""
        self._point_size = size
        if self._handle is not None:
            self._handle.point_size = size

    def set_visible(self, visible: bool) -> None:
        """Show or hide it."""
        self._visible = visible
        if self._handle is not None:
            self._handle.visible = visible

    def set_pose(self, T: Matrix | None) -> None:
        """Move it: the item's pose is what counts."""
        if self._handle is not None:
            wxyz, position = self._frame.place(self._part.origin, self._item.pose_of(self._part))
            with self._client.atomic():
                self._handle.wxyz, self._handle.position = wxyz, position

    def close(self) -> None:
        """Take it out of the page."""
        if self._handle is not None:
            self._handle.remove()
            self._handle = None

    def _send(self) -> None:
        """Send what is kept; points and colours arrive together."""
        positions, self._sent = self._positions, self._indices
        if self._keep is not None and len(positions):
            kept = self._keep(positions.astype(np.float64) + self._part.origin, self._indices)
            positions, self._sent = positions[kept], self._indices[kept]
        colors = self._colors_of(self._sent)
        if self._frame.unit != 1:
            positions = (positions.astype(np.float64) / self._frame.unit).astype(np.float32)
        wxyz, position = self._frame.place(self._part.origin, self._item.pose_of(self._part))
        if self._handle is None:
            self._handle = self._client.scene.add_point_cloud(
                self._name,
                positions,
                colors,
                point_size=self._point_size,
                point_shape="circle",
                point_shading="flat",
                precision="float32",
                wxyz=wxyz,
                position=position,
                visible=self._visible,
            )
            return
        with self._client.atomic():
            self._handle.points, self._handle.colors = positions, colors
            self._handle.wxyz, self._handle.position = wxyz, position


def even_share(count: int, budget: int) -> NDArray[np.int64] | None:
    """Rows from all parts of a cloud, the same each time, ascending; None for all."""
    return None if count <= budget else spread_rows(count, budget).astype(np.int64)
