"""Rasterization of a scene of parts: projection and drawing order.

All parts share one z-buffer, with element numbers for points first, then triangles, then lines. All lines are merged
into one part in float32 relative to the scene's center to save launches. Transparent parts are drawn in layers in front
of that buffer (kernels/drawing/layers.py).
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.algebra.camera import Camera
from ...kernels.arrays.bounds import bound_points
from ...kernels.drawing.layers import MAX_LAYERS, before_all, has_more, start_layer, take_words
from ...kernels.drawing.lines import Pen, draw_lines
from ...kernels.drawing.placing import find_extremes, shift_indices, transform_points
from ...kernels.drawing.points import SQUARE_SIDE, Splat, count_in_squares, draw_points
from ...kernels.drawing.shading import (
    CELLS_PER_PIXEL,
    PointLook,
    Region,
    Veil,
    finish_picture,
    read_depth,
    shade_lines,
    shade_points,
    start_light,
)
from ...kernels.drawing.surfaces import Surface, Texture, shade_surface
from ...kernels.drawing.triangles import draw_triangles
from ...kernels.drawing.z_buffer import MIN_DEPTH, DepthBuffer
from ...kernels.drawing.z_buffer import View as PartView
from ...kernels.lang import float32, int32, vec3
from ...kernels.memory import check_room, empty, full, upload
from ...kernels.splats.blending import blend_splats
from ...pcd.splat_images import MIN_DEPTH as NEAREST_SPLAT
from ...pcd.splat_images import list_splats
from .parts import Gaussians, Lines, Matrix, Part, Points, Triangles, Triple
from .view import Frame, View

MAX_ELEMENTS = 2**31 - 1
CELL_BYTES, PIXEL_BYTES = 16, 15  # z-buffer and buffer of point centers. Color and image
LAYER_BYTES = 28  # per cell of transparent parts: two layers, a temporary one, and the remaining transmittance
MIN_RADIUS = 0.71  # [cells] of lines: thinner ones would have gaps
IN_FRONT = 1e-3  # factor of the depths of paths in images: geometries nearer than this fraction still hide them
GAP_CLOSING_RATIO = 2.2  # diameter over the mean point distance: leaves 2 % of gaps between random points
# fraction of image squares in which neighbors must be at most as far apart as the diameter assumes
MIN_CLOSED_FRACTION = 0.8
MIN_SIZE, MAX_SIZE = 1.5, 16.0  # [px] of automatic point sizes
_BOX_CORNERS = np.array(
    [[0, 0, 1, 1, 0, 0, 1, 1], [0, 0, 0, 0, 1, 1, 1, 1], [0, 1, 0, 1, 0, 1, 0, 1]]
)  # of a box's corners
_AXIS_COLUMN = np.arange(3)[:, None]


@dataclasses.dataclass(frozen=True, eq=False)
class BoundedPart:
    """A part with the bounds of its finite positions [m] relative to its origin. None if empty."""

    part: Part
    box: NDArray[np.float64] | None

    @functools.cached_property
    def corners(self) -> NDArray[np.float64]:
        """Corners of the bounds in the world [m], shape (8, 3), or none."""
        if self.box is None:
            return np.empty((0, 3))
        corners = self.box[_BOX_CORNERS, _AXIS_COLUMN].T + self.part.origin
        pose = self.part.pose
        return corners if pose is None else corners @ pose[:3, :3].T + pose[:3, 3]


class Scene:
    """Parts on one device with their bounds."""

    def __init__(self, parts: Sequence[Part], device: Any):
        self.device = device
        self.parts = [BoundedPart(part, _box_of(part.positions)) for part in parts]
        corners = np.concatenate([np.empty((0, 3)), *(bounded.corners for bounded in self.parts)])
        self.is_empty = not len(corners)
        self.low = np.zeros(3) if self.is_empty else corners.min(axis=0)
        self.high = np.zeros(3) if self.is_empty else corners.max(axis=0)

    @property
    def middle(self) -> NDArray[np.float64]:
        return (self.low + self.high) / 2

    @property
    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lowest and highest corner [m]."""
        return self.low, self.high

    def fit(self, frame: Frame) -> View:
        if self.is_empty:
            return frame.view(None, 0.0)
        directions, extents = frame.directions(), []
        for bounded in self.parts:
            if bounded.box is None:
                continue
            A, t = _motion_of(bounded.part)
            local = upload(directions @ A, vec3, self.device)
            offset = directions @ (A @ bounded.part.origin + t)
            extents.append(find_extremes(bounded.part.positions, local) + offset)  # sync
        return frame.view(np.max(extents, axis=0), float((self.high - self.low).max()))

    def draw(self, view: View, *, paths_in_front: bool = False) -> Drawing:
        """The drawing. Its depth is that of the visible parts only without `paths_in_front`."""
        return Drawing(self, view, paths_in_front)


class Drawing:
    """The light and the z-buffer of a scene on the device."""

    def __init__(self, scene: Scene, view: View, paths_in_front: bool = False):
        camera = view.intrinsic
        self._has_paths_in_front = paths_in_front
        cells = camera.width * CELLS_PER_PIXEL, camera.height * CELLS_PER_PIXEL
        need = cells[0] * cells[1] * CELL_BYTES + camera.width * camera.height * PIXEL_BYTES
        veils = [bounded for bounded in scene.parts if _is_veil(bounded)]
        splats = [bounded for bounded in scene.parts if bounded.box is not None and isinstance(bounded.part, Gaussians)]
        need += cells[0] * cells[1] * (LAYER_BYTES * bool(veils) + 8 * sum(isinstance(p.part, Points) for p in veils))
        need += cells[0] * cells[1] * 4 * bool(splats)
        check_room(scene.device, need, f"an image of {camera.width} x {camera.height} pixels")
        self.scene, self.view, self.device = scene, view, scene.device
        self.camera = _in_cells(camera)
        corners = np.stack([scene.low, scene.high]) - view.T_world_camera[:3, 3]
        self.unit = _power_of_two(float(np.abs(corners).max()))
        self.buffer = DepthBuffer(*cells, scene.device)
        self.light = start_light(self.buffer)
        self.left = full(cells[0] * cells[1] if veils or splats else 0, 1.0, float32, self.device)
        self.stop = 0
        self._views: dict[Part, PartView] = {}  # in cells
        self._draw(veils, [bounded.part for bounded in splats])

    def before(self, background: Triple) -> Any:
        """The image before a background, uint8 (3 * pixels,)."""
        return finish_picture(self.buffer, self.light, self.left, vec3(*background))

    def depth(self) -> Any:
        """Depth of each pixel [m], float32 on the device. 0 for background and transparent parts."""
        first, last, closer = self.lines
        return read_depth(self.buffer, self.unit, lines=(first, last), closer=closer)

    def _draw(self, veils: Sequence[BoundedPart], splats: Sequence[Any]) -> None:
        seen = [p for p in self.scene.parts if p.box is not None and not isinstance(p.part, Gaussians)]
        points = [(p, p.part) for p in seen if isinstance(p.part, Points) and p.part.opacity == 1]
        surfaces = [(p, p.part) for p in seen if isinstance(p.part, Triangles) and p.part.opacity == 1]
        shown: list[tuple[Points | Triangles, Region]] = [
            (part, self._draw_points(p, part, self.buffer)) for p, part in points
        ]
        last_point = self.stop
        shown += [(part, self._draw_surface(p, part, self.buffer)) for p, part in surfaces]
        lines = self._draw_lines()
        for part in splats:
            self._draw_splats(part)
        self._draw_layers(veils)
        if lines is not None:
            merged, region = lines
            look: dict[str, Any] = {"colors": merged.colors, "plain": vec3(*merged.plain)}
            shade_lines(self.buffer, region, self.light, veil=Veil(1.0, self.left), **look)
        for part, region in shown:
            self._shade(part, region, self.buffer, self.buffer, last_point)

    def _draw_splats(self, part: Gaussians) -> None:
        """Composite Gaussian splats in front of opaque parts."""
        view = self._view_of(part, self.view.intrinsic)
        near = max(NEAREST_SPLAT / self.unit, MIN_DEPTH)
        lists, projected = list_splats(part.columns, view, near=near, fraction=part.opacity)
        blend_splats(lists, projected, self.buffer, self.left, self.light)

    def _draw_layers(self, veils: Sequence[BoundedPart]) -> None:
        """Composite transparent parts in front of opaque ones, layer by layer."""
        if not veils:
            return
        clouds, surfaces = [], []
        for bounded in veils:
            if isinstance(bounded.part, Points):
                own = DepthBuffer(self.buffer.width, self.buffer.height, self.device)
                clouds.append((bounded.part, self._draw_points(bounded, bounded.part, own), own))
            else:
                count = bounded.part.indices.size // 3
                surfaces.append((bounded.part, Region(self._number(count), self.stop, self._rectangle(bounded, 1.0))))
        behind = before_all(self.buffer)
        for _ in range(MAX_LAYERS):
            layer = start_layer(self.buffer, behind)
            for _, _, own in clouds:
                take_words(own, layer)
            for part, region in surfaces:
                self._draw_triangles(part, region, layer)
            if not has_more(layer, self.buffer):  # sync
                break
            for part, region, own in clouds:
                self._shade(part, region, layer, own, self.stop)
            for part, region in surfaces:
                self._shade(part, region, layer, layer, self.stop)
            behind = layer.words

    def _shade(
        self, part: Points | Triangles, region: Region, buffer: DepthBuffer, around: DepthBuffer, last_point: int
    ) -> None:
        """Shade the visible pixels of a part in a buffer."""
        view, veil = self._view_in_cells(part), Veil(part.opacity, self.left)
        if isinstance(part, Points):
            look = PointLook(part.colors, part.normals, vec3(*part.plain), part.shaded, part.lit)
            shade_points(buffer, view, region, self.light, look, last_point=last_point, around=around, veil=veil)
        else:
            shade_surface(buffer, view, region, self.light, self._surface(part), veil)

    def _draw_points(self, bounded: BoundedPart, part: Points, buffer: DepthBuffer) -> Region:
        view = self._view_in_cells(part)
        if part.metric and part.size is not None:
            splat = Splat(0.0, part.size / 2 / self.unit * self.camera.fx)
        elif part.size is not None:
            splat = Splat(part.size * CELLS_PER_PIXEL / 2)
        else:
            splat = self._closing_splat(bounded, view)  # sync
        start = self._number(part.positions.size)
        draw_points(part.positions, view, buffer, splat=splat, start=start)
        return Region(
            start,
            self.stop,
            self._rectangle(bounded, splat.radius / CELLS_PER_PIXEL, splat.scaled_radius / CELLS_PER_PIXEL),
        )

    def _closing_splat(self, bounded: BoundedPart, view: PartView) -> Splat:
        """Splats of one world size that touch most neighbors, limited to a few pixels."""
        counts, depths = count_in_squares(bounded.part.positions, view)  # sync
        min_radius, max_radius = MIN_SIZE * CELLS_PER_PIXEL / 2, MAX_SIZE * CELLS_PER_PIXEL / 2
        if not len(counts):
            return Splat(min_radius)
        world_radius = (
            GAP_CLOSING_RATIO / 2 * float(np.quantile(depths * SQUARE_SIDE / np.sqrt(counts), MIN_CLOSED_FRACTION))
        )
        return Splat(min_radius, world_radius, max_radius)

    def _draw_surface(self, bounded: BoundedPart, part: Triangles, buffer: DepthBuffer) -> Region:
        region = Region(self._number(part.indices.size // 3), self.stop, self._rectangle(bounded, 1.0))
        self._draw_triangles(part, region, buffer)
        return region

    def _draw_triangles(self, part: Triangles, region: Region, buffer: DepthBuffer) -> None:
        view = self._view_in_cells(part)
        draw_triangles(part.positions, part.indices, view, buffer, cull=part.cull, start=region.start)

    def _draw_lines(self) -> tuple[Lines, Region] | None:
        """Draw all lines as one part. Returns it and its region for shading."""
        lines = [p.part for p in self.scene.parts if isinstance(p.part, Lines) and p.box is not None]
        lines = sorted((part for part in lines if part.indices.size), key=self._pen_of)
        start, self.lines = self.stop, (self.stop, self.stop, 1.0)
        if not lines:
            return None
        merged = merge_lines(lines, self.scene.middle, self.device)
        view, drawn = self._view_in_cells(merged), 0
        for width, in_front in dict.fromkeys(map(self._pen_of, lines)):
            count = sum(part.indices.size // 2 for part in lines if self._pen_of(part) == (width, in_front))
            pen = Pen(max(width * CELLS_PER_PIXEL / 2, MIN_RADIUS), self.camera)
            pen.closer = IN_FRONT if in_front else pen.closer
            run = merged.indices[2 * drawn : 2 * (drawn + count)]
            draw_lines(merged.positions, run, view, self.buffer, pen=pen, start=self._number(count))
            drawn += count
            self.lines = start, self.stop, pen.closer
        return merged, Region(start, self.stop, (0, 0, self.view.intrinsic.width, self.view.intrinsic.height))

    def _pen_of(self, part: Lines) -> tuple[float, bool]:
        """Width of lines [px], and whether they hide all else."""
        return part.width, part.in_front and self._has_paths_in_front

    def _number(self, count: int) -> int:
        start = self.stop
        self.stop = start + count
        if self.stop > MAX_ELEMENTS:
            raise ValueError(f"geometries: {self.stop:,} points, triangles and lines are more than 2^31 in one picture")
        return start

    def _view_in_cells(self, part: Part) -> PartView:
        view = self._views.get(part)
        if view is None:
            view = self._views[part] = self._view_of(part, self.camera)
        return view

    def _view_of(self, part: Part, camera: Any) -> PartView:
        """Vertices of a part in the coordinates of a camera, in units of the scene's size."""
        A, t = _motion_of(part)
        R, eye = self.view.T_world_camera[:3, :3].T, self.view.T_world_camera[:3, 3]
        offset = R @ (A @ part.origin + t - eye) / self.unit
        return PartView(camera, R @ A / self.unit, offset)

    def _surface(self, part: Triangles) -> Surface:
        texture = None
        if part.texture is not None and part.is_textured:
            texture = Texture(np.asarray(part.texture, np.uint8), part.uvs)
        arrays: dict[str, Any] = {"normals": part.normals, "colors": part.colors, "texture": texture}
        looks = {"plain": vec3(*part.plain), "lit": part.is_lit, "edges": part.wireframe}
        return Surface(part.positions, part.indices, **looks, **arrays)

    def _rectangle(self, bounded: BoundedPart, margin: float, world_margin: float = 0.0) -> tuple[int, int, int, int]:
        """Image rectangle of a part [px]: left, top, right, bottom."""
        camera, T = self.view.intrinsic, self.view.T_world_camera
        full = 0, 0, camera.width, camera.height
        local = (bounded.corners - T[:3, 3]) @ T[:3, :3] / self.unit
        depth = local[:, 2]
        if depth.min() <= 1e-3:
            return full
        margin += 2 + world_margin / depth.min()
        columns = camera.fx * local[:, 0] / depth + camera.cx
        rows = camera.fy * local[:, 1] / depth + camera.cy
        ends = [columns.min() - margin, rows.min() - margin, columns.max() + margin + 1, rows.max() + margin + 1]
        limits = [camera.width, camera.height, camera.width, camera.height]
        left, top, right, bottom = (int(min(max(end, 0), limit)) for end, limit in zip(ends, limits, strict=True))
        return left, top, right, bottom


def merge_lines(parts: Sequence[Lines], origin: NDArray[np.float64], device: Any) -> Lines:
    vertices = sum(part.positions.size for part in parts)
    count = sum(part.indices.size for part in parts)
    positions, indices = empty(vertices, vec3, device), empty(count, int32, device)
    colors = empty(count // 2, vec3, device)
    first = corner = 0
    for part in parts:
        A, t = _motion_of(part)
        transform_points(part.positions, A, A @ part.origin + t - origin, positions, first)
        shift_indices(part.indices, first, indices, corner)
        lines = part.indices.size // 2
        given = part.colors if part.colors.size else upload(np.tile(part.plain, (lines, 1)), vec3, device)
        transform_points(given, np.eye(3), np.zeros(3), colors, corner // 2)
        first, corner = first + part.positions.size, corner + part.indices.size
    return Lines(positions, origin, indices, colors)


def _is_veil(bounded: BoundedPart) -> bool:
    """True if a part is transparent but not invisible. Gaussian splats are handled separately."""
    if isinstance(bounded.part, Gaussians):
        return False
    return bounded.box is not None and not isinstance(bounded.part, Lines) and 0 < bounded.part.opacity < 1


def _box_of(positions: Any) -> NDArray[np.float64] | None:
    low, high, count = bound_points(positions)  # sync
    return np.stack([low, high]).astype(np.float64) if count else None


def _motion_of(part: Part) -> tuple[Matrix, NDArray[np.float64]]:
    return (np.eye(3), np.zeros(3)) if part.pose is None else (part.pose[:3, :3], part.pose[:3, 3])


def _in_cells(camera: Any) -> Camera:
    c = [(value + 0.5) * CELLS_PER_PIXEL - 0.5 for value in (camera.cx, camera.cy)]
    return Camera(
        camera.width * CELLS_PER_PIXEL,
        camera.height * CELLS_PER_PIXEL,
        camera.fx * CELLS_PER_PIXEL,
        camera.fy * CELLS_PER_PIXEL,
        *c,
    )


def _power_of_two(length: float) -> float:
    """The next power of 2 above a length: division by it is exact."""
    return math.ldexp(1.0, math.frexp(length)[1]) if length > 0 else 1.0
