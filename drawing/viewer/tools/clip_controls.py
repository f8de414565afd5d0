"""The controls of the clip planes in a page, and the scene cut by them: `ClipControls`."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from ....kernels.lang import int32, vec3
from ....kernels.memory import download, upload
from ....meshing.mesh.mesh import TriangleMesh
from ...render.parts import Triangles
from ..surfaces import surface_arrays
from .clip_planes import Clip, clip_mesh
from .stage import Stage

if TYPE_CHECKING:
    from ..link import Node

STEPS = 200  # of a slider
NO_PLANE = "none"
NORMALS = {"along x": (1.0, 0.0, 0.0), "along y": (0.0, 1.0, 0.0), "along z": (0.0, 0.0, 1.0)}
AS_SEEN = "as one looks"


class ClipControls:
    """Sliders for a box and a plane; what lies outside is hidden in this page alone, and cannot be picked.

    Args:
        stage: The page.
        folder: Of the panel, in which they are.
    """

    def __init__(self, stage: Stage, folder: Any):
        self._stage = stage
        self._applied: dict[str, tuple[Any, ...]] = {}  # by item, what its stream was told: stream, planes, pose
        self._cut: dict[str, tuple[tuple[Any, ...], list[Node]]] = {}  # by item, what was cut how, and our nodes
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
                slider = gui.add_range("xyz"[axis], *ends, (ends[1] - ends[0]) / STEPS, ends)
                slider.on_update(lambda _: self._ask())
                self._ranges.append(slider)
            self._plane = gui.add_dropdown("plane", (NO_PLANE, *NORMALS, AS_SEEN))
            self._place = gui.add_slider("place", 0.0, 1.0, 1 / STEPS, 0.5)
            self._flip = gui.add_checkbox("other side", False)
            gui.add_button("Whole scene").on_click(lambda _: run(self.reset))
        self._normal = (0.0, 0.0, 1.0)
        self._plane.on_update(lambda _: run(self._choose_plane))
        for control in (self._on, self._place, self._flip):
            control.on_update(lambda _: self._ask())

    def reset(self) -> None:
        """Take the box of the scene as it is now, and no plane."""
        low, high = self._box()
        for axis, slider in enumerate(self._ranges):
            ends = float(low[axis]), float(high[axis])
            slider.min, slider.max = min(slider.min, ends[0]), max(slider.max, ends[1])
            slider.value = ends
            slider.min, slider.max, slider.step = *ends, (ends[1] - ends[0]) / STEPS
        self._plane.value = NO_PLANE
        self.apply()

    def close(self) -> None:
        """The page has gone, and its scene with it."""
        self._applied.clear()
        self._cut.clear()

    def clip(self) -> Clip:
        """What the controls say."""
        if not self._on.value:
            return Clip()
        low, high = self._box()
        ends = []
        for slider in self._ranges:
            # a slider at its end does not cut: float32 positions may lie a little beyond the box
            a, b = slider.value
            ends.append((-np.inf if a <= slider.min else a, np.inf if b >= slider.max else b))
        box = [min(a, b) for a, b in ends], [max(a, b) for a, b in ends]
        if self._plane.value == NO_PLANE:
            return Clip(*box)
        normal = np.array(self._normal) * (-1 if self._flip.value else 1)
        corners = np.array([[a, b, c] for a in (low[0], high[0]) for b in (low[1], high[1]) for c in (low[2], high[2])])
        heights = corners @ normal
        share = 1 - self._place.value if self._flip.value else self._place.value
        offset = float(heights.min() + share * np.ptp(heights))
        return Clip(*box, normal=normal, offset=offset)

    def apply(self) -> None:
        """Hide what the planes hide, in clouds and surfaces, and show all else."""
        self._pending = False
        self._stage.clip = self.clip()
        self._hide(self._stage.clip)

    def _hide(self, clip: Clip) -> None:
        session = self._stage.session
        with self._stage.viewer.lock:
            items = dict(self._stage.viewer.shown)
            streams = dict(session.streams)
        for name, stream in streams.items():
            item = items.get(name)
            known = self._applied.get(name)
            if item is None or item.points is None or (known is None and not clip.cuts):
                continue
            told = stream, clip, item.pose, item.cloud
            if not _same(known, told):
                stream.set_keep(clip.keeper(self._stage.pose_of(item)) if clip.cuts else None)
                self._applied[name] = told
        if not clip.cuts:
            self._applied.clear()
        self._cut_surfaces(items, clip)
        with self._stage.viewer.lock:
            session.count_anew()
            session.tell()

    def sync(self) -> None:
        """After the scene has changed: what came since is cut, too."""
        if self._stage.clip.cuts:
            self._hide(self._stage.clip)

    # -- within -------------------------------------------------------------------------------------------------------

    def _box(self) -> tuple[Any, Any]:
        """The scene's box, a little wider where it is flat."""
        low, high = (np.array(ends, np.float64) for ends in self._stage.viewer.bounds)
        flat = high - low <= 1e-6 * max(float((high - low).max()), 1e-9)
        pad = 0.5 * max(float((high - low).max()), 1e-6)
        return np.where(flat, low - pad, low), np.where(flat, high + pad, high)

    def _ask(self) -> None:
        """Apply what the controls say then, once for many changes in a row."""
        if not self._pending:
            self._pending = True
            if not self._stage.run(self.apply):
                self._pending = False

    def _choose_plane(self) -> None:
        if self._plane.value == AS_SEEN:
            self._normal = tuple(float(c) for c in self._stage.view().T_world_camera[:3, 2])
        elif self._plane.value != NO_PLANE:
            self._normal = NORMALS[self._plane.value]
        self.apply()

    def _cut_surfaces(self, items: dict[str, Any], clip: Clip) -> None:
        """In this page, surfaces of our own stand for those that all pages share, which are hidden in it."""
        stage = self._stage
        for name in [n for n in self._cut if not clip.cuts or n not in items]:
            with stage.client.atomic():
                self._drop_cut(name)
                if name in items:
                    for _, node in stage.viewer._surface_nodes(name):
                        stage.client.scene.show_shared(node, items[name].visible)
        if not clip.cuts:
            return
        for name, item in items.items():
            shared = stage.viewer._surface_nodes(name) if item.has_surface else []
            told = clip, item.pose, item.visible, stage.viewer.wireframe, *(node for _, node in shared)
            if not shared or _same(self._cut.get(name, (None, []))[0], told):
                continue
            with stage.client.atomic():
                self._drop_cut(name)
                cut = [self._send_cut(item, part, node, clip) for part, node in shared]
            self._cut[name] = told, [node for node in cut if node is not None]

    def _drop_cut(self, name: str) -> None:
        for node in self._cut.pop(name, (None, []))[1]:
            node.remove()

    def _send_cut(self, item: Any, part: Triangles, shared: Node, clip: Clip) -> Node | None:
        scene, viewer = self._stage.client.scene, self._stage.viewer
        scene.show_shared(shared, False)
        pose = item.pose_of(part)
        left = clip_part(part, clip, pose)
        arrays = surface_arrays(left) if left.indices.size else None
        if arrays is None:
            return None
        placing = viewer.frame.placing(part.origin, pose)
        wireframe = viewer.wireframe or part.wireframe
        return scene.add_surface(**arrays, **placing, wireframe=wireframe, visible=item.visible)


def _same(before: tuple[Any, ...] | None, now: tuple[Any, ...]) -> bool:
    return before is not None and len(before) == len(now) and all(a is b for a, b in zip(before, now, strict=True))


def clip_part(part: Triangles, clip: Clip, pose: Any) -> Triangles:
    """A surface cut by clip planes; one with a texture loses the triangles that reach outside instead."""
    positions = download(part.positions).reshape(-1, 3)
    faces = download(part.indices).reshape(-1, 3)
    device = part.positions.device
    if part.texture is not None and part.uvs is not None and part.uvs.size:
        kept = clip.keeper(pose)(positions.astype(np.float64) + part.origin)[faces].all(axis=1)
        uvs = download(part.uvs).reshape(-1, 3, 2)[kept]
        return dataclasses.replace(
            part,
            indices=upload(faces[kept].ravel(), int32, device),
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
