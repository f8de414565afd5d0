"""Nodes of the items in the pages, except points: `ItemNodes`."""

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

MAX_NORMALS = 10_000
NORMAL_COLOR = (0, 0, 0)


class ItemNodes:
    """Nodes of an item except points, shared by all pages."""

    def __init__(self, pages: PageServer, frame: Frame, item: Item, *, wireframe: bool = False):
        self._pages, self._frame, self._wireframe = pages, frame, wireframe
        self.nodes: list[tuple[Part, Node]] = []
        self.normals: Node | None = None
        self.show(item)

    def show(self, item: Item) -> None:
        """Replace the displayed item within one frame."""
        self._item = item
        with self._pages.atomic():
            for _, node in self.nodes:
                node.remove()
            self.nodes = [(part, node) for part in item.parts if (node := self._add(part)) is not None]

    def surfaces(self) -> list[tuple[Triangles, Node]]:
        return [(part, node) for part, node in self.nodes if isinstance(part, Triangles)]

    def set_pose(self) -> None:
        with self._pages.atomic():
            for part, node in self.nodes:
                node.set_transform(*self._frame.pose_in_page(part.origin, self._item.pose_of(part)))
            if self.normals is not None and self._item.points is not None:
                part = self._item.points
                self.normals.set_transform(*self._frame.pose_in_page(part.origin, self._item.pose_of(part)))

    def set_visible(self, visible: bool) -> None:
        for _, node in self.nodes:
            node.visible = visible
        if self.normals is not None:
            self.normals.visible = visible

    def set_wireframe(self, shown: bool) -> None:
        self._wireframe = shown
        for part, node in self.surfaces():
            node.set(wireframe=shown or part.wireframe)

    def set_normals(self, length: float | None) -> None:
        """Show the normals of a cloud as lines of this length [m]. None hides them."""
        if self.normals is not None:
            self.normals.remove()
            self.normals = None
        part = self._item.points
        if length is None or part is None or not part.normals.size:
            return
        step = -(-part.positions.size // MAX_NORMALS)
        feet = download(part.positions).reshape(-1, 3)[::step]
        heads = feet + np.float32(length) * download(part.normals).reshape(-1, 3)[::step]
        finite = finite_rows(heads)
        if finite.any():
            ends = np.stack([feet[finite], heads[finite]], axis=1)
            self.normals = self._pages.scene.add_lines(ends, plain=NORMAL_COLOR, **self._placement(part))

    def close(self) -> None:
        with self._pages.atomic():
            for _, node in self.nodes:
                node.remove()
            if self.normals is not None:
                self.normals.remove()
        self.nodes, self.normals = [], None

    def _add(self, part: Part) -> Node | None:
        if isinstance(part, Points):
            return None
        scene, placement = self._pages.scene, self._placement(part)
        if isinstance(part, Lines):
            lines = line_arrays(part)
            return None if lines is None else scene.add_lines(**lines, **placement)
        surface = surface_arrays(part)
        if surface is None:
            return None
        return scene.add_surface(**surface, wireframe=self._wireframe or part.wireframe, **placement)

    def _placement(self, part: Part) -> dict[str, Any]:
        return {**self._frame.placing(part.origin, self._item.pose_of(part)), "visible": self._item.visible}
