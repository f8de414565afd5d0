"""Surfaces and lines of an item in the page, the same for all who look: `ItemNodes`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...core.coordinates import finite_rows
from ...kernels.memory import download
from ..render.parts import Lines, Part, Points, Triangles
from .items import Frame, Item
from .surfaces import line_arrays, surface_arrays

if TYPE_CHECKING:
    from .link import Node, PageServer

MOST_NORMALS = 10_000
NORMAL_LENGTH = 0.01  # of the scene's diagonal
NORMAL_COLOR = (0, 0, 0)


class ItemNodes:
    """The nodes of an item's parts other than points; all pages are shown them, those that come later as well.

    Args:
        pages: Who is shown them.
        frame: The page's coordinates.
        item: What is shown.
        wireframe: Whether the edges of surfaces are shown.
    """

    def __init__(self, pages: PageServer, frame: Frame, item: Item, *, wireframe: bool = False):
        self._pages, self._frame, self._wireframe = pages, frame, wireframe
        self._nodes: list[tuple[Part, Node]] = []
        self._normals: Node | None = None
        self.show(item)

    def show(self, item: Item) -> None:
        """Show this in place of what was shown, in one picture."""
        self._item = item
        with self._pages.atomic():
            for _, node in self._nodes:
                node.remove()
            self._nodes = [(part, node) for part in item.parts if (node := self._add(part)) is not None]

    def surfaces(self) -> list[tuple[Triangles, Node]]:
        """The surfaces that are shown and their nodes."""
        return [(part, node) for part, node in self._nodes if isinstance(part, Triangles)]

    def set_pose(self) -> None:
        """Move the nodes to where the item stands."""
        with self._pages.atomic():
            for part, node in self._nodes:
                node.place(*self._frame.place(part.origin, self._item.pose_of(part)))
            if self._normals is not None and self._item.points is not None:
                part = self._item.points
                self._normals.place(*self._frame.place(part.origin, self._item.pose_of(part)))

    def set_visible(self, visible: bool) -> None:
        """Show or hide them."""
        for _, node in self._nodes:
            node.visible = visible
        if self._normals is not None:
            self._normals.visible = visible

    def set_wireframe(self, shown: bool) -> None:
        """Show edges over the faces."""
        self._wireframe = shown
        for part, node in self.surfaces():
            node.set(wireframe=shown or part.wireframe)

    def set_normals(self, length: float | None) -> None:
        """Show the normals of a cloud as lines of this length [m]; None hides them."""
        if self._normals is not None:
            self._normals.remove()
            self._normals = None
        part = self._item.points
        if length is None or part is None or not part.normals.size:
            return
        step = -(-part.positions.size // MOST_NORMALS)
        feet = download(part.positions).reshape(-1, 3)[::step]
        heads = feet + np.float32(length) * download(part.normals).reshape(-1, 3)[::step]
        finite = finite_rows(heads)
        if finite.any():
            ends = np.stack([feet[finite], heads[finite]], axis=1)
            self._normals = self._pages.scene.add_lines(ends, plain=NORMAL_COLOR, **self._placed(part))

    def close(self) -> None:
        """Take them out of the page."""
        with self._pages.atomic():
            for _, node in self._nodes:
                node.remove()
            if self._normals is not None:
                self._normals.remove()
        self._nodes, self._normals = [], None

    def _add(self, part: Part) -> Node | None:
        if isinstance(part, Points):
            return None
        scene, placed = self._pages.scene, self._placed(part)
        if isinstance(part, Lines):
            lines = line_arrays(part)
            return None if lines is None else scene.add_lines(**lines, **placed)
        surface = surface_arrays(part)
        if surface is None:
            return None
        return scene.add_surface(**surface, wireframe=self._wireframe or part.wireframe, **placed)

    def _placed(self, part: Part) -> dict[str, Any]:
        """Where a part stands in the page, and whether it is seen."""
        return {**self._frame.placing(part.origin, self._item.pose_of(part)), "visible": self._item.visible}
