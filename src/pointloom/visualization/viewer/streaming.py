"""Streaming of a cloud to a page: the nodes that matter for the current camera.

A node is a point cloud below a frame with the cloud's pose. Nodes are sent coarse first in batches. Each batch replaces
nodes that the view no longer needs, so the browser draws little more than its budget. Hidden nodes, up to twice the
budget of points, stay in the browser and return without being sent again.
"""

from __future__ import annotations

import dataclasses
import threading
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_positive, check_rigid, check_shape
from ..render.view import View, check_view

if TYPE_CHECKING:
    from .copc_tree import CopcTree
    from .detail_tree import DetailTree
    from .link import PageClient

ColorsOf = Callable[[NDArray[np.int64]], NDArray[np.uint8]]
Keep = Callable[[NDArray[np.float64]], NDArray[np.bool_]]


@dataclasses.dataclass
class ViewRequest:
    """Requested state of the client."""

    view: View | None = None
    colors_of: ColorsOf | None = None
    keep: Keep | None = None
    size: float | None = None
    metric: bool = False  # sizes in meters
    coloring: int = 0  # version of the colors
    keeping: int = 0  # version of the mask

    @property
    def is_metric(self) -> bool:
        """True if sizes are in meters. Always for sizes that close gaps."""
        return self.size is None or self.metric


@dataclasses.dataclass
class Sent:
    """A node in the page and its properties; `node` is None if none of its points is kept."""

    node: Any
    count: int
    mask: NDArray[np.bool_] | None
    is_exact: bool
    coloring: int
    keeping: int
    size: float
    metric: bool
    visible: bool = True


PLAIN_COLOR = (89, 128, 158)  # of clouds without colors

# Per batch: two megabytes.
_BATCH_POINTS, _BATCH_NODES = 200_000, 24
_FIRST_POINTS = 100_000  # of the first batch of an empty view

_HIDDEN_BUDGETS = 2  # budgets of hidden points in the browser

# Half a step of float16 at the far end of a node: 11 bits of half its side. Below 2^-14, steps are constant.
_HALF_STEP, _MIN_HALF_STEP = 2.0**-12, 2.0**-25
_FLOAT16_MAX = 60_000.0
_MAX_ERROR = 0.25  # [px] maximum error of positions

_DISC_SPACINGS = 1.5  # discs of this many spacings leave few gaps
_MIN_SIZE_CHANGE = 1.25  # smaller changes of size are ignored

_NOTHING, _MORE, _OVERTAKEN = "nothing", "more", "overtaken"  # remaining work after a batch

_MAX_PASSES = 6  # over a view with hidden parts, until the budget is used


class CloudStream:
    """One cloud for one client. Thread-safe: a newer request replaces an older one.

    Args:
        client: The page. A reconnected page needs a new stream.
        origin: World position of the scene's origin [m], shape (3,).
        budget: Maximum number of points. A smaller cloud is sent completely.
        point_size: Diameter [px], or [m] if `metric`. If None, chosen for each view to close most gaps, larger for
            coarse nodes without children.
        pause: Called between batches until the client can take the next. Returns False if the client has gone. If None,
            batches are sent without a pause.
    """

    def __init__(
        self,
        client: PageClient,
        tree: DetailTree | CopcTree,
        *,
        origin: ArrayLike,
        budget: int,
        point_size: float | None = None,
        metric: bool = False,
        pause: Callable[[], bool] | None = None,
    ):
        self._client, self._tree = client, tree
        self._origin = check_shape("origin", origin, (3,))
        self._budget = check_count("budget", budget)
        self._request = ViewRequest(size=_checked_size(point_size), metric=metric)
        self._version, self._is_closed, self._pause = 0, False, pause
        self._asking, self._working = threading.Lock(), threading.Lock()
        self._sent: dict[int, Sent] = {}  # hidden ones in the order of hiding
        self._visible_counts: NDArray[np.int64] = tree.counts  # number of unmasked points of each node
        self._pose, self._drawn, self._size = np.eye(4), 0, 0.0
        self._steps = np.maximum(tree.halves * _HALF_STEP, _MIN_HALF_STEP)
        self._steps[tree.halves > _FLOAT16_MAX] = np.inf
        self._frame = client.scene.add_group(**self._placing())

    @property
    def drawn(self) -> int:
        return self._drawn

    @property
    def total(self) -> int:
        return self._tree.count

    @property
    def point_size(self) -> float:
        """Diameter of most points: as set, else [m]. 0 before the first view."""
        return self._size

    def look(self, view: View) -> None:
        """Send what matters for a view and hide the rest."""
        self._update_request(self._pause, view=check_view(view))

    def set_colors(self, colors_of: ColorsOf | None) -> None:
        """Set a function from point indices (k,) to uint8 colors (k, 3). None restores the cloud's own."""
        self._update_request(colors_of=colors_of, coloring=self._request.coloring + 1)

    def set_keep(self, keep: Keep | None) -> None:
        """Set a function from positions (k, 3) [m] in cloud coordinates to a mask of visible points. None shows all."""
        self._update_request(keep=keep, keeping=self._request.keeping + 1)

    def set_point_size(self, size: float | None, metric: bool = False) -> None:
        """Set the diameter of points [px], or [m] if `metric`. None closes most gaps."""
        self._update_request(size=_checked_size(size), metric=metric)

    def set_visible(self, visible: bool) -> None:
        with self._working:
            if not self._is_closed:
                self._frame.visible = bool(visible)

    def set_pose(self, T: ArrayLike) -> None:
        """Set T_world_cloud, 4x4, and select nodes again."""
        pose = check_rigid("T", T)
        with self._working:
            self._pose = pose
            if not self._is_closed:
                self._frame.set_transform(**self._placing())
        self._update_request()

    def close(self) -> None:
        with self._asking:
            self._version += 1
        with self._working:
            if self._is_closed:
                return
            self._frame.remove()
            self._is_closed, self._drawn = True, 0
            self._sent.clear()

    def _update_request(self, pause: Callable[[], bool] | None = None, **changes: Any) -> None:
        with self._asking:
            for name, value in changes.items():
                setattr(self._request, name, value)
            self._version += 1
            version = self._version
        while True:
            with self._working:
                is_unfinished = self._serve(version, in_steps=pause is not None)
            if not is_unfinished or pause is None or not pause():  # a newer request may arrive during the pause
                return

    def _is_overtaken(self, version: int) -> bool:
        return self._is_closed or version != self._version or not self._client.is_open

    def _serve(self, version: int, *, in_steps: bool) -> bool:
        """Do the next step toward the requested state. True if more steps remain."""
        with self._asking:
            request = dataclasses.replace(self._request)
        if self._is_overtaken(version) or request.view is None:
            return False
        view = View(request.view.intrinsic, np.linalg.inv(self._pose) @ request.view.T_world_camera)
        self._forget_masks(request)
        for _ in range(_MAX_PASSES if request.keep is not None else 1):
            previous = self._visible_counts.copy()
            nodes = self._choose(view)
            left = self._show(nodes, view, request, version, in_steps)
            if left is not _NOTHING or np.array_equal(previous, self._visible_counts):
                return left is _MORE
        return False

    def _choose(self, view: View) -> list[int]:
        if int(self._visible_counts.sum()) > self._budget:
            return self._tree.select(view, self._budget, counts=self._visible_counts)
        gaps = self._tree.pixels(view, self._tree.spacings)
        return [i for i in np.argsort(-gaps, kind="stable").tolist() if self._visible_counts[i]]

    def _forget_masks(self, request: ViewRequest) -> None:
        """Reset the masks of nodes after a change of `keep`."""
        self._visible_counts = self._tree.counts.copy()
        for i, sent in self._sent.items():
            if sent.keeping == request.keeping:
                self._visible_counts[i] = sent.count

    def _show(self, nodes: list[int], view: View, request: ViewRequest, version: int, in_steps: bool) -> str:
        """Show these nodes, or one batch of them. Returns the remaining work."""
        sizes = self._sizes(nodes, view, request)
        errors = self._tree.pixels(view, self._steps)
        chosen = set(nodes)
        spare = [i for i in reversed(self._sent) if self._sent[i].visible and i not in chosen]
        for batch in self._batches(nodes, errors, request):
            made = [(i, self._make(i, bool(errors[i] > _MAX_ERROR), request)) for i in batch]
            if self._is_overtaken(version):
                return _OVERTAKEN
            with self._client.atomic():
                for i, content in made:
                    self._put(i, content, sizes[i])
                while spare and self._drawn > self._budget:
                    self._hide(spare.pop(0))
            if self._is_overtaken(version):
                return _OVERTAKEN
            if in_steps and next(self._batches(nodes, errors, request), None):
                return _MORE
        with self._client.atomic():
            for i in spare:
                self._hide(i)
            self._resize(sizes, request.is_metric)
            self._drop_hidden()
        return _NOTHING

    def _batches(self, nodes: list[int], errors: NDArray[np.float64], request: ViewRequest) -> Iterator[list[int]]:
        """Batches of nodes that are missing or outdated."""
        batch: list[int] = []
        points = 0
        for i in nodes:
            sent = self._sent.get(i)
            if sent is not None and sent.visible and self._is_right(sent, errors[i], request):
                continue
            batch.append(i)
            points += int(self._tree.counts[i])
            if points >= (_BATCH_POINTS if self._drawn else _FIRST_POINTS) or len(batch) >= _BATCH_NODES:
                yield batch
                batch, points = [], 0
        if batch:
            yield batch

    def _is_right(self, sent: Sent, error: float, request: ViewRequest) -> bool:
        is_near_enough = sent.is_exact or not error > _MAX_ERROR
        return sent.keeping == request.keeping and sent.coloring == request.coloring and is_near_enough

    def _make(self, i: int, is_exact: bool, request: ViewRequest) -> Callable[[float], Sent] | None:
        """Prepare the update of a node: a function that sends it or its colors, or None to show it as is."""
        sent = self._sent.get(i)
        if sent is not None and sent.keeping == request.keeping and (sent.is_exact or not is_exact):
            if sent.coloring == request.coloring or sent.node is None:
                return None
            colors = self._colors(i, sent.mask, request)

            def recolor(size: float) -> Sent:
                sent.node.set(colors=colors)
                sent.coloring = request.coloring
                return sent

            return recolor
        node = self._tree.node(i)
        mask = None if request.keep is None else np.asarray(request.keep(self._tree.points_of(i)), bool)
        positions = node.positions if mask is None else node.positions[mask]
        colors = self._colors(i, mask, request) if len(positions) else None
        tag = (is_exact, request.coloring, request.keeping)
        middle = node.middle - self._tree.origin

        def send(size: float) -> Sent:
            if sent is not None and sent.node is not None:
                sent.node.remove()
            if not len(positions):
                return Sent(None, 0, mask, *tag, size, request.is_metric)
            node = self._client.scene.add_points(
                np.asarray(positions, np.float32 if is_exact else np.float16),
                colors,
                size=size,
                metric=request.is_metric,
                parent=self._frame,
                t=middle,
            )
            return Sent(node, len(positions), mask, *tag, size, request.is_metric)

        return send

    def _colors(self, i: int, mask: NDArray[np.bool_] | None, request: ViewRequest) -> Any:
        indices = self._tree.indices_of(i)
        indices = indices if mask is None else indices[mask]
        colors = self._tree.colors_of(indices) if request.colors_of is None else request.colors_of(indices)
        return np.broadcast_to(np.array(PLAIN_COLOR, np.uint8), (len(indices), 3)) if colors is None else colors

    def _put(self, i: int, content: Callable[[float], Sent] | None, size: float) -> None:
        before = self._sent.pop(i, None)
        was_visible = before is not None and before.visible
        self._drawn -= before.count if before is not None and was_visible else 0
        sent = before if content is None else content(size)
        assert sent is not None
        if not sent.visible and sent.node is not None:
            sent.node.visible = True
        sent.visible = True
        self._sent[i] = sent
        self._visible_counts[i] = sent.count
        self._drawn += sent.count

    def _hide(self, i: int) -> None:
        sent = self._sent.pop(i)
        if sent.node is not None:
            sent.node.visible = False
        sent.visible = False
        self._drawn -= sent.count
        self._sent[i] = sent

    def _drop_hidden(self) -> None:
        hidden = [(i, sent) for i, sent in self._sent.items() if not sent.visible]
        room = _HIDDEN_BUDGETS * self._budget
        for i, sent in reversed(hidden):
            room -= sent.count
            if room < 0:
                if sent.node is not None:
                    sent.node.remove()
                del self._sent[i]

    def _sizes(self, nodes: list[int], view: View, request: ViewRequest) -> dict[int, float]:
        """Point diameter of each node: uniform, but larger for coarse nodes without drawn children."""
        if request.size is not None or not nodes:
            self._size = request.size or self._size
            return dict.fromkeys(nodes, self._size)
        self._size = self._fitting_size(nodes, view)
        wide = np.where(self._tree.are_refined(nodes), 0.0, _DISC_SPACINGS * self._tree.spacings[nodes])
        return dict(zip(nodes, np.maximum(wide, self._size).tolist(), strict=True))

    def _fitting_size(self, nodes: list[int], view: View) -> float:
        """A diameter that closes most gaps: the spacing at the median level of the points in view."""
        spacings = self._tree.spacings[nodes]
        counts = self._visible_counts[nodes] * (
            self._tree.fractions_in_view(view, nodes) + 1e-6
        )  # breaks ties if no point is in view
        ranks = np.argsort(-spacings, kind="stable")
        half = np.searchsorted(np.cumsum(counts[ranks]), counts.sum() / 2)
        size = _DISC_SPACINGS * float(spacings[ranks[min(half, len(nodes) - 1)]])
        return self._size if self._size / _MIN_SIZE_CHANGE < size < self._size * _MIN_SIZE_CHANGE else size

    def _resize(self, sizes: dict[int, float], is_metric: bool) -> None:
        for i, size in sizes.items():
            sent = self._sent[i]
            if sent.node is not None and (sent.size, sent.metric) != (size, is_metric):
                sent.size, sent.metric = size, is_metric
                sent.node.set(size=size, metric=is_metric)

    def _placing(self) -> dict[str, Any]:
        return {"R": self._pose[:3, :3], "t": self._pose[:3, :3] @ self._tree.origin + self._pose[:3, 3] - self._origin}


def _checked_size(size: float | None) -> float | None:
    return None if size is None else check_positive("point_size", size)
