"""Conversion of geometries to recorded shapes (`sketch`), and unique storage of shapes (`ShapeStore`).

Positions are relative to their own origin and the pose maps it to the timeline's, so no precision is lost in float32.
"""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download, upload
from ...meshing.mesh.mesh import TriangleMesh
from ..render.coloring import Coloring
from ..render.geometries import parts_of
from ..render.parts import Lines, Matrix, Part, Points, Triangles
from ..render.styles import Style
from .timeline import Frame, Placement, Shape

GOLDEN_RATIO = 0.6180339887498949
POINT_SIZES = ((5_000, 5.0), (30_000, 3.0))  # (maximum number of points, diameter [px])
VOXEL_SIZE_FACTOR = 1.25  # factor of the voxel size between two attempts
MAX_ATTEMPTS = 24


@dataclasses.dataclass(frozen=True, eq=False)
class Sketch:
    """Recorded form of a geometry: shapes relative to `origin` [m], and its pose (geometry to world, 4x4, or None).

    `drawn` of `total` points or vertices were kept. `coloring` is the meaning of their colors, if these have one.
    """

    shapes: list[Shape]
    origin: NDArray[np.float64]
    pose: Matrix | None
    drawn: int
    total: int
    device: Any = None
    coloring: Coloring | None = None


def sketch(geometry: object, style: Style, max_points: int) -> Sketch:
    """Convert a geometry. Larger clouds are sampled and larger meshes simplified to `max_points`."""
    parts = parts_of(geometry, style)
    origin = parts[0].origin if parts else np.zeros(3)
    shapes = [_shape(part, part.origin - origin, max_points) for part in parts]
    total = sum(part.positions.size for part in parts if not isinstance(part, Lines))
    drawn = sum(len(shape.positions) for shape in shapes if shape.kind != "lines")
    device = parts[0].positions.device if parts else None
    colorings = (part.coloring for part in parts if not isinstance(part, Lines))
    coloring = next((each for each in colorings if each is not None and each.kind != "rgb"), None)
    pose = parts[0].pose if parts else None
    return Sketch(shapes, np.asarray(origin, np.float64), pose, drawn, total, device, coloring)


def pose_about(pose: Matrix | None, shape_origin: NDArray[np.float64], origin: NDArray[np.float64]) -> Matrix | None:
    """Pose for positions relative to `shape_origin` in a frame relative to `origin`. None if it is the identity."""
    T = np.eye(4) if pose is None else np.array(pose, np.float64)
    T[:3, 3] += matmul(T[:3, :3], shape_origin) - origin
    return None if np.array_equal(T, np.eye(4)) else T


def spread_rows(count: int, max_count: int) -> NDArray[np.int32]:
    """Up to `max_count` of `count` rows, ascending, one in each of equal runs.

    Offsets follow the golden ratio: a fixed stride would cause stripes in organized scans.
    """
    if count <= max_count:
        return np.arange(count, dtype=np.int32)
    runs = np.arange(max_count)
    return np.floor((runs + (runs * GOLDEN_RATIO) % 1) * (count / max_count)).astype(np.int32)


def usual_size(count: int) -> float:
    return next((diameter for max_count, diameter in POINT_SIZES if count <= max_count), 2.0)


def _shape(part: Part, shift: NDArray[np.float64], max_points: int) -> Shape:
    plain = tuple(_bytes(np.array(part.plain)).tolist())
    if isinstance(part, Lines):
        positions = _shifted(download(part.positions), shift)
        pairs = download(part.indices).reshape(-1, 2)
        finite = np.asarray(np.isfinite(positions).all(axis=1))
        selected = finite[pairs].all(axis=1)
        colors = _bytes(download(part.colors))[selected] if part.colors.size else None
        return Shape(
            "lines", _finite(positions), colors, indices=pairs[selected].astype(np.int32), size=part.width, plain=plain
        )
    if isinstance(part, Triangles):
        return _surface(part, shift, max_points, plain)
    return _splats(part, shift, max_points, plain)


def _splats(part: Points, shift: NDArray[np.float64], max_points: int, plain: Any) -> Shape:
    rows = spread_rows(part.positions.size, max_points)
    arrays = [part.positions, part.colors, part.normals]
    if len(rows) < part.positions.size:  # only the kept points leave the device
        chosen = upload(rows, int32, part.positions.device)
        arrays = [gather_rows(values, chosen) if values.size else values for values in arrays]
    positions, colors, normals = (download(values) for values in arrays)
    finite = np.isfinite(positions).all(axis=1)
    size = usual_size(len(rows)) if part.size is None or part.metric else float(part.size)
    return Shape(
        "points",
        _shifted(positions, shift)[finite],
        _bytes(colors)[finite] if len(colors) else None,
        _finite(normals)[finite] if len(normals) else None,
        size=size,
        plain=plain,
    )


def _surface(part: Triangles, shift: NDArray[np.float64], max_points: int, plain: Any) -> Shape:
    triangles = download(part.indices).reshape(-1, 3)
    positions, colors, normals = (download(values) for values in (part.positions, part.colors, part.normals))
    if part.texture is not None and part.uvs is not None and part.uvs.size:
        colors = _baked(part.texture, download(part.uvs).reshape(-1, 2), triangles, len(positions))
    if len(positions) > max_points:
        positions, triangles, colors = _simplified(positions, triangles, colors, max_points)
        normals = normals[:0]
    if not np.isfinite(positions).all():
        finite = np.asarray(np.isfinite(positions).all(axis=1))
        triangles = triangles[finite[triangles].all(axis=1)]
        positions = _finite(positions)
    return Shape(
        "triangles",
        _shifted(positions, shift),
        _bytes(colors) if len(colors) else None,
        _finite(normals) if len(normals) else None,
        triangles.astype(np.int32),
        plain=plain,
        wireframe=part.wireframe,
        cull=part.cull,
        unlit=not part.is_lit,
    )


def _simplified(
    positions: NDArray[Any], triangles: NDArray[Any], colors: NDArray[Any], max_vertices: int
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """A mesh with at most `max_vertices` vertices, by increasing voxel sizes."""
    some = positions[triangles[spread_rows(len(triangles), 10_000)]]
    lengths = np.linalg.norm(some[:, 0] - some[:, 1], axis=1)
    lengths = lengths[np.isfinite(lengths) & (lengths > 0)]
    edge = float(lengths.mean()) if len(lengths) else 1.0
    mesh = TriangleMesh(positions, triangles, vertex_colors=np.clip(colors, 0, 1) if len(colors) else None)
    size, thin = edge * (len(positions) / max_vertices) ** 0.5, mesh
    for step in range(MAX_ATTEMPTS):
        thin = mesh.simplify_vertex_clustering(size * VOXEL_SIZE_FACTOR**step)
        if len(thin.vertices) <= max_vertices:
            break
    vertex_colors = thin.vertex_colors
    return (
        thin.vertices,
        np.asarray(thin.triangles),
        np.empty((0, 3)) if vertex_colors is None else np.asarray(vertex_colors),
    )


def _baked(texture: NDArray[np.uint8], uvs: NDArray[Any], triangles: NDArray[Any], count: int) -> NDArray[np.float32]:
    """Texture color at each vertex, from one of its corners."""
    height, width = texture.shape[:2]
    columns = np.clip(np.nan_to_num(uvs[:, 0]) * width, 0, width - 1).astype(np.int64)
    rows = np.clip((1 - np.nan_to_num(uvs[:, 1])) * height, 0, height - 1).astype(np.int64)
    colors = np.full((count, 3), 0.5, np.float32)
    colors[triangles.ravel()] = texture[rows, columns, :3] / np.float32(255)
    return colors


def _shifted(positions: NDArray[Any], shift: NDArray[np.float64]) -> NDArray[np.float32]:
    moved = positions + shift if shift.any() else positions
    return np.ascontiguousarray(moved, np.float32)


def _finite(values: NDArray[Any]) -> NDArray[np.float32]:
    return np.nan_to_num(values, nan=0.0, posinf=0.0, neginf=0.0).astype(np.float32)


def _bytes(colors: NDArray[Any]) -> NDArray[np.uint8]:
    """Colors from 0 to 1 as uint8. NaN is black."""
    return np.rint(255 * np.clip(np.nan_to_num(colors), 0, 1)).astype(np.uint8)


class ShapeStore:
    """Unique shapes of a timeline by number, and the size of their arrays [bytes]."""

    def __init__(self):
        self.shapes: list[Shape] = []
        self.size = 0
        self._numbers: dict[bytes, int] = {}

    def add(self, shape: Shape) -> int:
        """Number of an equal shape, or of a new one."""
        key = _fingerprint(shape)
        number = self._numbers.setdefault(key, len(self.shapes))
        if number == len(self.shapes):
            self.shapes.append(shape)
            self.size += _size_of(shape)
        return number

    def keep_used(self, frames: Iterable[Frame]) -> list[Frame]:
        """Drop unused shapes. Returns the frames with new numbers."""
        frames = list(frames)
        used = sorted({number for frame in frames for placement in frame.shown.values() for number in placement.shapes})
        new = {number: index for index, number in enumerate(used)}
        self.shapes = [self.shapes[number] for number in used]
        self.size = sum(map(_size_of, self.shapes))
        self._numbers = {key: new[number] for key, number in self._numbers.items() if number in new}

        def renumbered(placement: Placement) -> Placement:
            return dataclasses.replace(placement, shapes=tuple(new[number] for number in placement.shapes))

        return [
            dataclasses.replace(frame, shown={name: renumbered(placement) for name, placement in frame.shown.items()})
            for frame in frames
        ]


def _arrays_of(shape: Shape) -> list[NDArray[Any] | None]:
    return [shape.positions, shape.colors, shape.normals, shape.indices]


def _size_of(shape: Shape) -> int:
    return sum(array.nbytes for array in _arrays_of(shape) if array is not None)


def _fingerprint(shape: Shape) -> bytes:
    looks = shape.kind, shape.size, shape.plain, shape.wireframe, shape.cull
    digest = hashlib.blake2b(repr(looks).encode(), digest_size=16)
    for array in _arrays_of(shape):
        digest.update(b"none" if array is None else repr(array.shape).encode())
        if array is not None:
            digest.update(np.ascontiguousarray(array).data)
    return digest.digest()
