"""The tools of one page, with their buttons, keys and clicks."""

from __future__ import annotations

import dataclasses
import itertools
import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ....core.errors import PointloomError
from ....kernels.lang import int32, vec3
from ....kernels.memory import download, upload
from ....meshing.mesh.mesh import TriangleMesh
from ...render.parts import Triangles
from ...render.view import View
from ..panel_sections import TOOL_ORDER
from ..scene_edits import SceneEdits, requested_by_page
from ..surfaces import surface_arrays
from .clip_planes import Clip, clip_mesh
from .measuring import length_text, measurements
from .pairs_tool import PairsTool
from .picking import Pick, coordinate_text, describe_row
from .polygon_tool import PolygonTool
from .stage import Stage, Tool, check_room

if TYPE_CHECKING:
    from ..link import ClickEvent, Node
    from ..sessions import Session


NOTHING = "Nothing there: click nearer to a point."


class PointTool(Tool):
    """Shows the attributes of a clicked point."""

    label = "Pick a point"
    key = "I"
    hint = "Click on a point or a surface. Escape ends."

    def click(self, view: View, x: float, y: float) -> None:
        stage, pick = self.stage, self.stage.pick(view, x, y)
        stage.clear()
        if pick is None:
            stage.show([])
            stage.set_status(NOTHING)
            return
        rows = [("in", pick.name)]
        if pick.index is None:
            rows += [("triangle", f"{pick.triangle:,}")]
            rows += [(axis, coordinate_text(value, 1e-6)) for axis, value in zip("xyz", pick.point, strict=True)]
        else:
            rows += describe_row(stage.cloud(pick.name)[0].select([pick.index]), pick.index, pick.point)
        stage.mark(view, pick.point, "" if pick.index is None else f"{pick.index}")
        stage.show(rows)
        stage.set_status(self.hint)

    def undo(self) -> None:
        self.stage.clear()
        self.stage.show([])


class MeasureTool(Tool):
    """Measures distances and angles along clicked points."""

    label = "Measure"
    key = "M"
    hint = "Click on points or surfaces: two give a distance, more a path and angles. Backspace takes one back."

    def __init__(self, stage: Any):
        super().__init__(stage)
        self._picks: list[Pick] = []

    def click(self, view: View, x: float, y: float) -> None:
        pick = self.stage.pick(view, x, y)
        if pick is None:
            self.stage.set_status(NOTHING)
            return
        check_room(self._picks)
        self._show([*self._picks, pick], view)

    def undo(self) -> None:
        if self._picks:
            self._show(self._picks[:-1], self.stage.view())

    def finish(self) -> None:
        if self._picks:
            self._show([], self.stage.view())

    def _show(self, picks: list[Pick], view: View) -> None:
        self._picks = picks
        stage, positions = self.stage, np.array([pick.point for pick in picks]).reshape(-1, 3)
        stage.clear()
        for position in positions:
            stage.mark(view, position)
        stage.lines(positions)
        stage.show([])
        stage.set_status(self.hint)
        unit = stage.unit(pick.name for pick in picks)
        for a, b in itertools.pairwise(positions if unit is None or unit.meters is not None else []):
            stage.label((a + b) / 2, length_text(float(np.linalg.norm(b - a)), unit))
        stage.show(measurements(positions, unit))


MAX_WAITING = 64  # waiting jobs per page
ACTIVE = "orange"
KEYS = (
    ("escape", "End the tool", "stop"),
    ("backspace", "Take back the last click", "undo"),
    ("enter", "Finish", "finish"),
)
TOOLS: tuple[type[Tool], ...] = (PointTool, MeasureTool, PolygonTool, PairsTool)

log = logging.getLogger("pointloom.viewer")


class Toolbox:
    """The tools of a page while it is connected. Jobs run in order in the page's thread."""

    def __init__(self, session: Session, edits: SceneEdits, folder: Any):
        self.tool: Tool | None = None
        self._session, self._client = session, session.client
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="pointloom-tools")
        self._lock, self._waiting, self._closed = threading.Lock(), 0, False
        self._is_stale = False
        self._controls: Any = None
        self.stage = Stage(session, edits, self.run)
        gui = self._client.gui
        with folder:
            self._buttons = {kind: gui.add_button(f"{kind.label} ({kind.key})") for kind in TOOLS}
        # at the top of the panel, visible without scrolling while a tool is active
        self._top = gui.add_folder("Tool", order=TOOL_ORDER, visible=False)
        with self._top:
            self.stage.status = gui.add_words("")
            self.stage.rows = gui.add_table((), visible=False)
        self._commands: list[Any] = []
        for kind, button in self._buttons.items():
            toggle = self._queued(lambda kind=kind: self.toggle(kind))
            button.on_click(toggle)
            self._commands.append(gui.add_command(kind.label, kind.key, group="Tools"))
            self._commands[-1].on_trigger(toggle)
        self.clip_controls = ClipControls(self.stage, folder)
        for key, label, action in KEYS:
            command = gui.add_command(label, key, group="Tools")
            command.on_trigger(self._queued(lambda action=action: self._key(action)))

    @property
    def clip(self) -> Clip:
        """Clip planes of the page."""
        return self.stage.clip

    @property
    def is_idle(self) -> bool:
        """True if no tool is active."""
        return self.tool is None

    def pick(self, view: View, x: float, y: float) -> Pick | None:
        """The geometry at an image position [px]."""
        return self.stage.pick(view, x, y)

    def run(self, job: Callable[[], None]) -> bool:
        """Queue a job. False if too many are waiting."""
        with self._lock:
            if self._closed or self._waiting >= MAX_WAITING:
                return False
            self._waiting += 1
            self._worker.submit(self._do, job)
            return True

    def refresh(self) -> None:
        with self._lock:
            if self._is_stale:  # already queued
                return
            self._is_stale = True
        if not self.run(self._sync):
            self._is_stale = False

    def start(self, kind: type[Tool]) -> None:
        """Start a tool and end the previous one."""
        self.stop()
        tool = kind(self.stage)
        gui = self._client.gui
        with self._top:
            self._controls = gui.add_folder(None)
        self._top.visible = True
        self._client.scene.on_click(self._on_click)  # before the hint that requests a click
        try:
            self.stage.set_status(kind.hint)
            with self._controls:
                tool.start()
        except BaseException:
            self._client.scene.remove_click_callback(self._on_click)
            self._controls.remove()
            self._controls = None
            raise
        self.tool = tool
        self._buttons[kind].color = ACTIVE

    def stop(self) -> None:
        """End the tool and remove its marks and controls."""
        tool, self.tool = self.tool, None
        if tool is None:
            return
        self._client.scene.remove_click_callback(self._on_click)
        self._buttons[type(tool)].color = None
        try:
            tool.stop()
        finally:
            self.stage.clear()
            self._controls.remove()
            self._controls = None
            self.stage.show([])
            self._top.visible = False

    def release_key(self, key: str) -> None:
        """Release a key that the program now uses. The tool keeps its button."""
        for command in [command for command in self._commands if command.hotkey == key]:
            self._commands.remove(command)
            command.remove()

    def toggle(self, kind: type[Tool]) -> None:
        if isinstance(self.tool, kind):
            self.stop()
        else:
            self.start(kind)

    def close(self) -> None:
        """End after the page has gone. Waiting jobs are dropped."""
        with self._lock:
            self._closed = True
        self._worker.shutdown(wait=False, cancel_futures=True)
        self.clip_controls.close()
        self.tool = None

    def _queued(self, job: Callable[[], None]) -> Callable[[Any], Any]:
        """A panel callback that queues a job."""
        return lambda _: self.run(job)

    def _on_click(self, event: ClickEvent) -> None:
        view = self._session.view_of(event.camera)  # camera at the time of the click
        camera = view.intrinsic
        self.run(lambda: self._click(view, event.x * camera.width - 0.5, event.y * camera.height - 0.5))

    def _click(self, view: View, x: float, y: float) -> None:
        if self.tool is not None:
            self.tool.click(view, x, y)

    def _key(self, action: str) -> None:
        if action == "stop":
            self.stop()
            self._top.visible = False  # an error message of the start is shown there
        elif self.tool is not None:
            getattr(self.tool, action)()

    def _sync(self) -> None:
        self._is_stale = False
        self.clip_controls.sync()
        if self.tool is not None:
            self.tool.refresh()

    def _do(self, job: Callable[[], None]) -> None:
        try:
            if not self._closed:
                with requested_by_page(), np.errstate(all="ignore"):  # the camera may be anywhere
                    job()
        except (PointloomError, ValueError, TypeError, LookupError, OSError, MemoryError) as error:
            self._show_message(str(error.args[0]) if isinstance(error, KeyError) and error.args else str(error))
        except Exception:  # the page has gone, or an internal error: continue
            log.debug("a tool", exc_info=True)
            self._show_message("This failed with an internal error; see the log of pointloom.viewer.")
        finally:
            with self._lock:
                self._waiting -= 1

    def _show_message(self, text: str) -> None:
        if not self._closed:
            self.stage.set_status(text)
            self._top.visible = True  # also for a tool that could not start


SLIDER_STEPS = 200  # of a slider
NO_PLANE = "none"
PLANE_NORMALS = {"along x": (1.0, 0.0, 0.0), "along y": (0.0, 1.0, 0.0), "along z": (0.0, 0.0, 1.0)}
AS_SEEN = "along the view"


class ClipControls:
    """Sliders for a clip box and a clip plane of one page. Clipped points cannot be picked."""

    def __init__(self, stage: Stage, folder: Any):
        self._stage = stage
        self._applied: dict[str, tuple[Any, ...]] = {}  # by item, last state of its stream: stream, planes, pose
        self._cut: dict[str, tuple[tuple[Any, ...], list[Node]]] = {}  # by item, state of the clipping and its nodes
        self._pending = False
        gui, run = stage.client.gui, stage.run
        with folder:
            self.folder = gui.add_folder("Clip planes", open=False)
        with self.folder:
            self._on = gui.add_checkbox("clip", False)
            low, high = self._box()
            self._ranges = []
            for axis in range(3):
                ends = float(low[axis]), float(high[axis])
                slider = gui.add_range("xyz"[axis], *ends, (ends[1] - ends[0]) / SLIDER_STEPS, ends)
                slider.on_update(lambda _: self._schedule_update())
                self._ranges.append(slider)
            self._plane = gui.add_dropdown("plane", (NO_PLANE, *PLANE_NORMALS, AS_SEEN))
            self._offset = gui.add_slider("position", 0.0, 1.0, 1 / SLIDER_STEPS, 0.5)
            self._flip = gui.add_checkbox("other side", False)
            gui.add_button("Whole scene").on_click(lambda _: run(self.reset))
        self._normal = (0.0, 0.0, 1.0)
        self._plane.on_update(lambda _: run(self._choose_plane))
        for control in (self._on, self._offset, self._flip):
            control.on_update(lambda _: self._schedule_update())

    def reset(self) -> None:
        """Set the box to the scene's bounds, without a plane."""
        low, high = self._box()
        for axis, slider in enumerate(self._ranges):
            ends = float(low[axis]), float(high[axis])
            slider.min, slider.max = min(slider.min, ends[0]), max(slider.max, ends[1])
            slider.value = ends
            slider.min, slider.max, slider.step = *ends, (ends[1] - ends[0]) / SLIDER_STEPS
        self._plane.value = NO_PLANE
        self.apply()

    def close(self) -> None:
        self._applied.clear()
        self._cut.clear()

    def clip(self) -> Clip:
        if not self._on.value:
            return Clip()
        low, high = self._box()
        ends = []
        for slider in self._ranges:
            # a slider at its end does not clip: float32 positions may be slightly outside the box
            a, b = slider.value
            ends.append((-np.inf if a <= slider.min else a, np.inf if b >= slider.max else b))
        box = [min(a, b) for a, b in ends], [max(a, b) for a, b in ends]
        if self._plane.value == NO_PLANE:
            return Clip(*box)
        normal = np.array(self._normal) * (-1 if self._flip.value else 1)
        corners = np.array([[a, b, c] for a in (low[0], high[0]) for b in (low[1], high[1]) for c in (low[2], high[2])])
        heights = corners @ normal
        fraction = 1 - self._offset.value if self._flip.value else self._offset.value
        offset = float(heights.min() + fraction * np.ptp(heights))
        return Clip(*box, normal=normal, offset=offset)

    def apply(self) -> None:
        self._pending = False
        self._stage.clip = self.clip()
        self._hide(self._stage.clip)

    def _hide(self, clip: Clip) -> None:
        session = self._stage.session
        with self._stage.scene.lock:
            items = dict(self._stage.scene.shown)
            streams = dict(session.streams)
        for name, stream in streams.items():
            item = items.get(name)
            known = self._applied.get(name)
            if item is None or item.points is None or (known is None and not clip.cuts):
                continue
            state = stream, clip, item.pose, item.cloud
            if not _same(known, state):
                stream.set_keep(clip.keeper(self._stage.pose_of(item)) if clip.cuts else None)
                self._applied[name] = state
        if not clip.cuts:
            self._applied.clear()
        self._cut_surfaces(items, clip)
        with self._stage.scene.lock:
            session.recount()
            session.show_counts()

    def sync(self) -> None:
        if self._stage.clip.cuts:
            self._hide(self._stage.clip)

    def _box(self) -> tuple[Any, Any]:
        low, high = (np.array(ends, np.float64) for ends in self._stage.scene.bounds)
        flat = high - low <= 1e-6 * max(float((high - low).max()), 1e-9)
        pad = 0.5 * max(float((high - low).max()), 1e-6)
        return np.where(flat, low - pad, low), np.where(flat, high + pad, high)

    def _schedule_update(self) -> None:
        """Queue one update for several changes."""
        if not self._pending:
            self._pending = True
            if not self._stage.run(self.apply):
                self._pending = False

    def _choose_plane(self) -> None:
        if self._plane.value == AS_SEEN:
            self._normal = tuple(float(c) for c in self._stage.view().T_world_camera[:3, 2])
        elif self._plane.value != NO_PLANE:
            self._normal = PLANE_NORMALS[self._plane.value]
        self.apply()

    def _cut_surfaces(self, items: dict[str, Any], clip: Clip) -> None:
        """Replace shared surfaces by clipped ones in this page."""
        stage = self._stage
        for name in [n for n in self._cut if not clip.cuts or n not in items]:
            with stage.client.atomic():
                self._drop_cut(name)
                if name in items:
                    for _, node in stage.edits.display.surface_nodes(name):
                        stage.client.scene.show_shared(node, items[name].visible)
        if not clip.cuts:
            return
        for name, item in items.items():
            shared = stage.edits.display.surface_nodes(name) if item.has_surface else []
            state = clip, item.pose, item.visible, stage.scene.wireframe, *(node for _, node in shared)
            if not shared or _same(self._cut.get(name, (None, []))[0], state):
                continue
            with stage.client.atomic():
                self._drop_cut(name)
                cut = [self._send_cut(item, part, node, clip) for part, node in shared]
            self._cut[name] = state, [node for node in cut if node is not None]

    def _drop_cut(self, name: str) -> None:
        for node in self._cut.pop(name, (None, []))[1]:
            node.remove()

    def _send_cut(self, item: Any, part: Triangles, shared: Node, clip: Clip) -> Node | None:
        nodes, scene = self._stage.client.scene, self._stage.scene
        nodes.show_shared(shared, False)
        pose = item.pose_of(part)
        left = clip_part(part, clip, pose)
        arrays = surface_arrays(left) if left.indices.size else None
        if arrays is None:
            return None
        placing = scene.frame.placing(part.origin, pose)
        wireframe = scene.wireframe or part.wireframe
        return nodes.add_surface(**arrays, **placing, wireframe=wireframe, visible=item.visible)


def _same(before: tuple[Any, ...] | None, now: tuple[Any, ...]) -> bool:
    return before is not None and len(before) == len(now) and all(a is b for a, b in zip(before, now, strict=True))


def clip_part(part: Triangles, clip: Clip, pose: ArrayLike | None) -> Triangles:
    """Clip a surface. A textured one loses all triangles that are partly outside."""
    positions = download(part.positions).reshape(-1, 3)
    faces = download(part.indices).reshape(-1, 3)
    device = part.positions.device
    if part.texture is not None and part.uvs is not None and part.uvs.size:
        is_inside = clip.keeper(pose)(positions.astype(np.float64) + part.origin)[faces].all(axis=1)
        uvs = download(part.uvs).reshape(-1, 3, 2)[is_inside]
        return dataclasses.replace(
            part,
            indices=upload(faces[is_inside].ravel(), int32, device),
            uvs=upload(uvs.reshape(-1, 2), part.uvs.dtype, device),
        )
    mesh = TriangleMesh(positions.astype(np.float64) + part.origin, faces)
    if part.colors.size:
        mesh.vertex_colors = np.clip(np.nan_to_num(download(part.colors).reshape(-1, 3)), 0, 1)
    if part.normals.size:
        mesh.vertex_normals = np.nan_to_num(download(part.normals).reshape(-1, 3))
    cut = clip_mesh(mesh, clip, pose=pose)
    colors, normals = cut.vertex_colors, cut.vertex_normals
    return dataclasses.replace(
        part,
        positions=upload((cut.vertices - part.origin).astype(np.float32), vec3, device),
        indices=upload(cut.triangles.astype(np.int32).ravel(), int32, device),
        colors=part.colors if colors is None else upload(colors, vec3, device),
        normals=part.normals if normals is None else upload(normals, vec3, device),
    )
