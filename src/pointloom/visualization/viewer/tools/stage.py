"""Interface of tools to one page: its camera, objects to pick, marks and status text.

Marks are in the page's own scene; `clear` removes them.
"""

from __future__ import annotations

import dataclasses
import tempfile
import weakref
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ....core.units import LengthUnit, is_same
from ....kernels.memory import download
from ....meshing.scene.raycasting_scene import RaycastingScene
from ....pcd.cloud import PointCloud
from ....pcd.units import InUnit
from ...render.parts import Triangles
from ...render.view import View
from ..camera import diagonal
from .clip_planes import Clip, hidden_points
from .picking import Pick, Rows, Target, pick, ray_through

if TYPE_CHECKING:
    from ..items import Item
    from ..link import CameraState, Node, Shown
    from ..scene_edits import SceneEdits
    from ..sessions import Session

Matrix = NDArray[np.float64]
Color = tuple[int, int, int]

MARK_COLOR: Color = (230, 60, 20)
MARK_SIZE = 8.0  # [px]
LINE_WIDTH = 2.5  # [px]
MAX_CLICKS = 1000  # per tool
MAX_BYTES = 256 << 20  # of a download

_scenes: weakref.WeakKeyDictionary[Any, list[tuple[Any, RaycastingScene]]] = weakref.WeakKeyDictionary()


def surfaces_of(item: Item) -> list[tuple[Any, RaycastingScene]]:
    """Raycasting scenes of an item with their parts, built on first use."""
    surfaces = _scenes.get(item)
    if surfaces is None:
        surfaces = []
        for part in item.parts:
            if isinstance(part, Triangles) and part.indices.size:
                scene = RaycastingScene(part.positions.device)
                corners = download(part.positions).reshape(-1, 3) + part.origin
                scene.add_triangles(corners, download(part.indices).reshape(-1, 3))
                surfaces.append((part, scene))
        _scenes[item] = surfaces
    return surfaces


class Stage:
    """One page, used by one tool at a time. `run` queues a function in order and returns whether it will run."""

    def __init__(self, session: Session, edits: SceneEdits, run: Callable[[Callable[[], None]], bool]):
        self.session, self.scene, self.client = session, session.scene, session.client
        self.edits, self.run = edits, run
        self.clip = Clip()
        self.status: Shown  # text and table in the panel, created by the toolbox
        self.rows: Shown
        self._nodes: list[Node] = []
        self._hidden: dict[str, tuple[Any, Any, Any, Any]] = {}

    def set_status(self, text: str) -> None:
        self.status.value = text

    def show(self, rows: Rows) -> None:
        self.rows.value = rows
        self.rows.visible = bool(rows)

    def download(self, name: str, write: Callable[[Path], Any]) -> None:
        """Let the page save a file that `write` creates. Raises ValueError for more than 256 MiB."""
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            path = Path(folder) / name
            write(path)
            size = path.stat().st_size
            if size > MAX_BYTES:
                raise ValueError(f"{name} has {size / 1e6:,.0f} MB; pages download at most {MAX_BYTES / 1e6:,.0f} MB")
            self.client.download(name, path.read_bytes())

    def items(self) -> list[Item]:
        """Visible items in the order of the scene."""
        with self.scene.lock:
            return [item for item in self.scene.shown.values() if item.visible]

    def clouds(self) -> list[str]:
        """Names of the visible clouds with points."""
        return [item.name for item in self.items() if item.cloud is not None and len(item.cloud)]

    def item(self, name: str) -> Item:
        """An item by name. Raises ValueError if it was removed."""
        with self.scene.lock:
            item = self.scene.shown.get(name)
        if item is None:
            raise ValueError(f"{name} is no longer in the scene")
        return item

    def cloud(self, name: str) -> tuple[Item, PointCloud]:
        """A cloud and its item. Raises ValueError if it was removed or replaced by another type."""
        item = self.item(name)
        if item.cloud is None:
            raise ValueError(f"{name} is no longer a cloud")
        return item, item.cloud

    def unit(self, names: Iterable[str]) -> LengthUnit | None:
        """Length unit between points of some items, None if unknown. Raises ValueError if units are mixed."""
        wanted = {*names}
        with self.scene.lock:
            geometries = [item.geometry for name, item in self.scene.shown.items() if name in wanted]
        known = [g.unit for g in geometries if isinstance(g, InUnit) and g.unit is not None]
        for other in known[1:]:
            if not is_same(known[0], other):
                raise ValueError(
                    f"one is in {known[0]}, the other in {other}: expected equal units to measure a length"
                )
        return known[0] if known else None

    def pose_of(self, item: Item) -> Matrix | None:
        assert item.points is not None
        return item.pose_of(item.points)

    def targets(self, names: Iterable[str] | None = None) -> list[Target]:
        """Objects to pick: all visible ones, or the named clouds. Clipped points are hidden."""
        targets: list[Target] = []
        chosen = None if names is None else set(names)
        for item in self.items():
            if item.cloud is not None and (chosen is None or item.name in chosen):
                pose = self.pose_of(item)
                targets.append(Target(item.name, item.cloud, pose=pose, hidden=self._clipped(item, pose)))
            elif item.cloud is None and chosen is None:
                targets += [
                    Target(item.name, scene=scene, pose=item.pose_of(part)) for part, scene in surfaces_of(item)
                ]
        return targets

    def pick(self, view: View, x: float, y: float, names: Iterable[str] | None = None) -> Pick | None:
        hit = pick(self.targets(names), view, x, y)
        if hit is not None and hit.index is None and not self.clip.keep(hit.point[None])[0]:
            return None  # the surface is clipped here
        return hit

    def _clipped(self, item: Item, pose: Matrix | None) -> Any:
        if not self.clip.cuts:
            self._hidden.clear()
            return None
        assert item.cloud is not None
        known = self._hidden.get(item.name)
        if known is None or known[0] is not item.cloud or known[1] is not self.clip or known[2] is not pose:
            known = item.cloud, self.clip, pose, hidden_points(item.cloud, self.clip, pose=pose)
            self._hidden[item.name] = known
        return known[3]

    def clear(self) -> None:
        nodes, self._nodes = self._nodes, []
        with self.client.atomic():
            for node in nodes:
                node.remove()

    def mark(self, view: View, position: NDArray[np.float64], text: str = "", color: Color = MARK_COLOR) -> None:
        """Draw a dot and a text at a world position, shifted toward the camera so that no points cover it."""
        toward = view.T_world_camera[:3, 3] - position
        depth = max(float(-toward @ view.T_world_camera[:3, 2]), 0.0)
        nearer = min(MARK_SIZE * depth / view.intrinsic.fy, 0.5 * depth)
        at = self.scene.frame.to_page(position + nearer * toward / (float(np.linalg.norm(toward)) or 1.0))
        with self.client.atomic():
            dot = self.client.scene.add_points(np.zeros((1, 3)), plain=color, size=MARK_SIZE, relief=False, t=at)
            self._nodes.append(dot)
            if text:
                self._nodes.append(self.client.scene.add_label(text, at, anchor="bottom-left"))

    def label(self, position: NDArray[np.float64], text: str) -> None:
        at = self.scene.frame.to_page(position)
        self._nodes.append(self.client.scene.add_label(text, at, anchor="bottom-center"))

    def lines(self, points: NDArray[np.float64], color: Color = MARK_COLOR, *, closed: bool = False) -> None:
        ends = np.vstack([points, points[:1]]) if closed else points
        if len(ends) < 2:
            return
        middle = ends.mean(axis=0)
        frame = self.scene.frame
        local = ((ends - middle) / frame.unit).astype(np.float32)
        segments, at = np.stack([local[:-1], local[1:]], axis=1), frame.to_page(middle)
        self._nodes.append(self.client.scene.add_lines(segments, plain=color, width=LINE_WIDTH, t=at))

    def before_all(self, view: View, x: float, y: float) -> NDArray[np.float64]:
        """World position of a pixel in front of the complete scene, if possible."""
        low, high = self.scene.bounds
        size = diagonal(self.scene.bounds)
        corners = np.array([[a, b, c] for a in (low[0], high[0]) for b in (low[1], high[1]) for c in (low[2], high[2])])
        depths = (corners - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, 2]
        eye, ray = ray_through(view, x, y)
        return eye + max(float(depths.min()) - 0.02 * size, 0.01 * size) * ray

    def view(self) -> View:
        return self.session.camera_view()

    def camera(self) -> CameraState:
        return self.client.camera.state

    def look_from(self, view: View) -> None:
        self.session.look_from(view)

    def look_back(self, camera: CameraState) -> None:
        self.session.look_as(camera)


def check_room(clicks: list[Any]) -> None:
    """Raise ValueError if the tool has the maximum number of clicks."""
    if len(clicks) >= MAX_CLICKS:
        raise ValueError(f"expected at most {MAX_CLICKS} clicks: finish, or take some back")


def style_of(item: Item) -> dict[str, Any]:
    fields = {field.name: field.default for field in dataclasses.fields(item.style)}
    values = {name: getattr(item.style, name) for name in fields}
    return {name: value for name, value in values.items() if value is not fields[name] and value is not None}


class Tool:
    """A tool that handles clicks. One is active per page. `key` starts and ends it; `hint` is shown at its start."""

    label = ""
    key = ""
    hint = ""

    def __init__(self, stage: Stage):
        self.stage = stage

    def start(self) -> None:
        """Add controls to the open folder of the panel."""

    def click(self, view: View, x: float, y: float) -> None: ...

    def undo(self) -> None: ...

    def finish(self) -> None:
        """Apply the tool (Enter)."""

    def refresh(self) -> None:
        """Update after a possible change of the scene."""

    def stop(self) -> None:
        """Clean up. The toolbox removes the marks."""
