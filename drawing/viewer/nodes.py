"""Surfaces and lines of an item in the page, the same for all who look: `ItemNodes`."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.memory import download
from ..render.parts import Lines, Part, Points, Triangles
from .items import Frame, Item, to_bytes
from .surfaces import edges_beside, sent_colors, to_glb

if TYPE_CHECKING:
    import viser

# The page reads a surface in the background and would show nothing meanwhile: the one before stays so long [s].
OVERLAP = 0.5

EDGES = (38, 38, 38)
EDGE_GAP = 4e-4  # of the diagonal: some steps of the depth buffer at that distance
MOST_NORMALS = 10_000
NORMAL_LENGTH = 0.01  # of the scene's diagonal


class ItemNodes:
    """The nodes of an item's parts other than points; viser shows them to all pages, those that come later as well.

    Args:
        server: viser's.
        lock: The viewer's.
        frame: The page's coordinates.
        item: What is shown.
    """

    def __init__(self, server: viser.ViserServer, lock: Any, frame: Frame, item: Item):
        self._server, self._lock, self._frame = server, lock, frame
        self._turn = 0
        self._nodes: list[tuple[Part, Any]] = []
        self._old: list[Any] = []
        self._edges: list[tuple[Part, Any]] = []
        self._normals: Any = None
        self._timer: threading.Timer | None = None
        self.show(item)

    def show(self, item: Item) -> None:
        """Show this in place of what was shown."""
        self._item = item
        old, self._nodes = [node for _, node in self._nodes], []
        self._turn += 1
        with self._server.atomic():
            for number, part in enumerate(item.parts):
                node = self._add(part, f"/item/{item.number}/{self._turn}/{number}")
                if node is not None:
                    self._nodes.append((part, node))
            self._retire(old)

    def surfaces(self) -> list[tuple[Triangles, Any]]:
        """The surfaces that are shown and their nodes."""
        return [(part, node) for part, node in self._nodes if isinstance(part, Triangles)]

    def set_pose(self) -> None:
        """Move the nodes to where the item stands."""
        with self._server.atomic():
            for part, node in [*self._nodes, *self._edges]:
                node.wxyz, node.position = self._frame.place(part.origin, self._item.pose_of(part))
            if self._normals is not None and self._item.points is not None:
                part = self._item.points
                self._normals.wxyz, self._normals.position = self._frame.place(part.origin, self._item.pose_of(part))

    def set_visible(self, visible: bool) -> None:
        """Show or hide them."""
        for node in self._all():
            node.visible = visible

    def set_wireframe(self, shown: bool) -> None:
        """Show edges over the faces."""
        for _, node in self._edges:
            node.remove()
        self._edges = []
        for number, part in enumerate(self._item.parts):
            if isinstance(part, Triangles) and (shown or part.wireframe):
                node = self._add_edges(part, f"/item/{self._item.number}/edges/{number}")
                if node is not None:
                    self._edges.append((part, node))

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
        finite = np.isfinite(heads).all(axis=1)
        segments = np.stack([feet[finite], heads[finite]], axis=1)
        colors = np.zeros(segments.shape, np.uint8)
        self._normals = self._add_lines(part, f"/item/{self._item.number}/normals", segments, colors, 1.0)

    def close(self) -> None:
        """Take them out of the page."""
        for node in self._all():
            node.remove()
        if self._timer is not None:
            self._timer.cancel()
        self._drop_old()
        self._nodes, self._edges, self._normals = [], [], None

    def forget(self) -> None:
        """The server ends, and all nodes with it."""
        if self._timer is not None:
            self._timer.cancel()
        self._nodes, self._old, self._edges, self._normals = [], [], [], None

    def _all(self) -> list[Any]:
        nodes = [node for _, node in [*self._nodes, *self._edges]]
        return nodes if self._normals is None else [*nodes, self._normals]

    def _retire(self, nodes: list[Any]) -> None:
        """Remove nodes when those that came for them are seen: lines at once, surfaces a little later."""
        self._drop_old()
        surfaces = [node for node in nodes if type(node).__name__ == "GlbHandle"]
        for node in nodes:
            if node not in surfaces:
                node.remove()
        self._old = surfaces
        if surfaces:
            if self._timer is not None:
                self._timer.cancel()
            self._timer = threading.Timer(OVERLAP, self._drop_later)
            self._timer.daemon = True
            self._timer.start()

    def _drop_later(self) -> None:
        with self._lock:
            self._drop_old()

    def _drop_old(self) -> None:
        for node in self._old:
            node.remove()
        self._old = []

    def _add(self, part: Part, name: str) -> Any:
        if isinstance(part, Points):
            return None
        if isinstance(part, Lines):
            segments, colors = _segments(part)
            return self._add_lines(part, name, segments, colors, part.width)
        data = to_glb(part)
        if data is None:
            return None
        return self._server.scene.add_glb(name, data, **self._placed(part), cast_shadow=False, receive_shadow=False)

    def _add_lines(
        self, part: Part, name: str, segments: NDArray[np.float32], colors: NDArray[np.uint8], width: float
    ) -> Any:
        if not len(segments):
            return None
        return self._server.scene.add_line_segments(
            name, segments, colors, thickness=width, thickness_units="screen", **self._placed(part)
        )

    def _add_edges(self, part: Triangles, name: str) -> Any:
        positions, faces = edges_beside(part, EDGE_GAP)
        if not len(faces):
            return None
        return self._server.scene.add_mesh_simple(
            name,
            positions,
            faces,
            color=EDGES,
            wireframe=True,
            side="double",
            **self._placed(part),
            cast_shadow=False,
            receive_shadow=False,
        )

    def _placed(self, part: Part) -> dict[str, Any]:
        """Where a part stands in the page, and whether it is seen."""
        wxyz, position = self._frame.place(part.origin, self._item.pose_of(part))
        visible = self._item.visible
        return {"scale": 1 / self._frame.unit, "wxyz": wxyz, "position": position, "visible": visible}


def _segments(part: Lines) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """Ends about the part's origin, float32 [m, 2, 3], and their colours."""
    positions = np.asarray(download(part.positions), np.float32).reshape(-1, 3)
    ends = positions[download(part.indices).reshape(-1, 2)]
    colors = download(part.colors).reshape(-1, 3) if part.colors.size else np.tile(part.plain, (len(ends), 1))
    finite = np.isfinite(ends).all(axis=(1, 2))
    # The page takes the colours of lines for linear ones, and maps their tones as it does those of surfaces.
    sent = to_bytes(np.clip(sent_colors(colors, lit=False), 0, 1))
    return ends[finite], np.repeat(sent[finite, None], 2, axis=1)
