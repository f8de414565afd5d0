"""A recording as one HTML file that plays from disk: `write_page`.

The file contains the player (visualization/page/), the timeline as JSON and the arrays: byte planes of blocks of
rows, deflated, in base64. Positions, colors and indices are exact. Normals have 16 bits.
"""

from __future__ import annotations

import base64
import html
import json
import math
import os
import re
import zlib
from collections.abc import Hashable, Iterator
from typing import IO, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_finite, check_positive, check_rows, check_shape
from ...core.escaped_text import escaped
from ...io.images.image_files import png_url
from ...kernels.linear_algebra import matmul
from ..page.sources import hash_of, player_script, player_style, read_source
from ..render.view import Triple, View, fit_view
from .timeline import Placement, Shape, Timeline

ROWS_PER_BLOCK = 65_536  # of byte planes: some MB, so that a large array is never stored twice
BYTES_PER_SCRIPT = 3 * 2**20  # divisible by 3, so that base64 needs no padding
NORMAL_SCALE = 32767  # int16 normals: 0.002 degrees
MAX_CAMERA_POINTS = 20_000  # positions of a shape that the camera is fitted to ...
NUM_DIRECTIONS = 64  # ... namely the outermost along this many directions
INDICES_PER_ROW = {"points": 0, "lines": 2, "triangles": 3}


def write_page(
    path: str | os.PathLike[str],
    timeline: Timeline,
    *,
    view: View | None = None,
    background: Triple = (1.0, 1.0, 1.0),
    point_size: float | None = None,
    overwrite: bool = True,
    key: tuple[str, NDArray[np.uint8]] | None = None,
) -> None:
    """Write a recording as one HTML file without external resources. Raises TypeError, ValueError or FileError.

    `view` is relative to the timeline's origin [m]. None shows all frames. `point_size` [px] overrides that of the
    shapes. `key` is the text and image of a color bar. Written atomically and reproducibly. Requires WebGL 2 (Chromium,
    Firefox, Safari since 2023). The page's policy forbids connections and other scripts. Surfaces have vertex colors.
    Textures are not drawn.

    Example:
        >>> import tempfile, numpy as np
        >>> from pathlib import Path
        >>> from pointloom.visualization.recording.timeline import Frame
        >>> shape = Shape("points", np.random.default_rng(0).random((100, 3), np.float32))
        >>> timeline = Timeline(np.zeros(3), [shape], [Frame({"cloud": Placement((0,))})], title="a cloud")
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     write_page(Path(folder) / "cloud.html", timeline)
        ...     (Path(folder) / "cloud.html").stat().st_size < 150_000  # most of it the player
        True
    """
    path = check_writable(path, overwrite=overwrite)
    _check_timeline(timeline)
    if view is not None and not isinstance(view, View):
        raise TypeError(f"view: expected a View, got {type(view).__name__}")
    if point_size is not None:
        point_size = check_positive("point_size", point_size)
    arrays: list[NDArray[Any]] = []
    description = _describe(timeline, arrays, view, _check_background(background), point_size)
    if key is not None:
        text, image = key
        description["key"] = {"text": text, "image": png_url(image), "width": image.shape[1] / 2}
    with atomic_write(path, overwrite=overwrite) as file:
        _write(file, description, arrays, timeline.name or timeline.title or path.stem)


def _write(file: IO[bytes], description: dict[str, Any], arrays: list[NDArray[Any]], name: str) -> None:
    """Fill the placeholders of player.html. Inserted text is not searched for placeholders."""
    script, style = player_script(), player_style()
    texts = {
        "script": script,
        "script-hash": hash_of(script),
        "style": style,
        "style-hash": hash_of(style),
        "title": html.escape(escaped(name)),
        "theme": "dark" if np.dot(description["background"], (0.299, 0.587, 0.114)) < 0.5 else "light",
        "description": _json_in_html(description),
    }
    for number, piece in enumerate(re.split(r"\{\{([\w-]+)\}\}", read_source("player.html"))):
        if number % 2 == 0:
            file.write(piece.encode())
        elif piece == "arrays":
            for index, values in enumerate(arrays):
                for text in _base64_pieces(values):
                    file.write(b'<script type="text/plain" data-array="%d">%s</script>\n' % (index, text))
        else:
            file.write(texts[piece].encode("utf-8", "replace"))


def _json_in_html(value: object) -> str:
    """JSON that cannot end its HTML element."""
    text = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _base64_pieces(values: NDArray[Any]) -> Iterator[bytes]:
    """Byte planes of blocks of rows, which deflate better for floats and indices."""
    packer = zlib.compressobj(6, zlib.DEFLATED, -15)
    packed = bytearray()
    for start in range(0, len(values), ROWS_PER_BLOCK):
        block = np.ascontiguousarray(values[start : start + ROWS_PER_BLOCK])
        packed += packer.compress(np.ascontiguousarray(block.view(np.uint8).reshape(len(block), -1).T).data)
        while len(packed) >= BYTES_PER_SCRIPT:
            yield base64.b64encode(packed[:BYTES_PER_SCRIPT])
            del packed[:BYTES_PER_SCRIPT]
    packed += packer.flush()
    for start in range(0, len(packed), BYTES_PER_SCRIPT):
        yield base64.b64encode(packed[start : start + BYTES_PER_SCRIPT])


def _describe(
    timeline: Timeline, arrays: list[NDArray[Any]], view: View | None, background: list[float], size: float | None
) -> dict[str, Any]:
    """Description of the timeline for the player. Arrays referenced by number are appended to `arrays`."""
    names = list(dict.fromkeys(name for frame in timeline.frames for name in frame.shown))
    series = list(dict.fromkeys(name for frame in timeline.frames for name in frame.values))
    poses, placements = _Table(), _Table()
    poses.add(np.eye(4).tobytes())
    numbers = {name: number for number, name in enumerate(names)}
    frames: list[dict[str, Any]] = []
    for frame in timeline.frames:
        shown = []
        for name, placement in frame.shown.items():
            pose = np.eye(4) if placement.pose is None else np.asarray(placement.pose, np.float64)
            shapes = tuple(int(number) for number in placement.shapes)
            shown.append(placements.add((numbers[name], shapes, poses.add(pose.tobytes()))))
        frames.append({"shown": shown, "label": frame.label})
    matrices = np.array([np.frombuffer(pose) for pose in poses.rows]).reshape(-1, 4, 4)
    used = sorted({(shape, pose) for _, shapes, pose in placements.rows for shape in shapes})
    low, high, outermost = _bounds(timeline.shapes, matrices, used)
    return {
        "title": timeline.title,
        "background": background,
        "fps": float(timeline.fps),
        "camera": _describe_camera(view, timeline.origin, outermost),
        "bounds": [low.tolist(), high.tolist()],
        "items": names,
        "shapes": [_describe_shape(shape, arrays, size) for shape in timeline.shapes],
        "poses": _append(arrays, matrices[:, :3].reshape(-1, 12)),
        "placements": placements.rows,
        "frames": frames,
        "series": [
            {"name": name, "values": [_finite_or_none(frame.values.get(name)) for frame in timeline.frames]}
            for name in series
        ],
        "block": ROWS_PER_BLOCK,
        "arrays": [
            {"kind": f"{values.dtype.kind}{values.dtype.itemsize}", "rows": len(values), "width": values.shape[1]}
            for values in arrays
        ],
    }


class _Table:
    """Unique rows; `add` returns the row number."""

    def __init__(self):
        self.rows: list[Any] = []
        self._numbers: dict[Any, int] = {}

    def add(self, row: Hashable) -> int:
        number = self._numbers.setdefault(row, len(self.rows))
        if number == len(self.rows):
            self.rows.append(row)
        return number


def _append(arrays: list[NDArray[Any]], values: NDArray[Any]) -> int:
    arrays.append(values)
    return len(arrays) - 1


def _finite_or_none(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else float(value)


def _describe_shape(shape: Shape, arrays: list[NDArray[Any]], size: float | None) -> dict[str, Any]:
    described: dict[str, Any] = {
        "kind": shape.kind,
        "positions": _append(arrays, np.asarray(shape.positions, "<f4")),
        "size": size if size is not None and shape.kind == "points" else float(shape.size),
        "plain": [int(value) for value in shape.plain],
    }
    if shape.indices is not None and shape.kind != "points":
        described["indices"] = _append(arrays, np.asarray(shape.indices, "<i4"))
    if shape.colors is not None:
        described["colors"] = _append(arrays, np.asarray(shape.colors, np.uint8))
    if shape.normals is not None:
        described["normals"] = _append(arrays, _pack_normals(shape.normals))
    for look in ("wireframe", "cull", "unlit"):
        if getattr(shape, look):
            described[look] = True
    return described


def _pack_normals(normals: NDArray[np.float32]) -> NDArray[np.int16]:
    """Unit normals as int16. Zero or non-finite ones become (0, 0, 0)."""
    values = np.asarray(normals, np.float64)  # squares of float32 may underflow or overflow in float32
    with np.errstate(invalid="ignore", divide="ignore"):
        units = values / np.linalg.norm(values, axis=1, keepdims=True)
    return np.rint(np.nan_to_num(units, nan=0.0, posinf=0.0, neginf=0.0) * NORMAL_SCALE).astype("<i2")


def _describe_camera(
    view: View | None, origin: NDArray[np.float64], outermost: NDArray[np.float64]
) -> dict[str, float | list[float]]:
    if view is None:
        view, origin = fit_view(outermost), np.zeros(3)
    intrinsic, eye = view.intrinsic, view.T_world_camera[:3, 3] - np.asarray(origin, np.float64)
    return {
        "width": intrinsic.width,
        "height": intrinsic.height,
        **{name: float(getattr(intrinsic, name)) for name in ("fx", "fy", "cx", "cy")},
        "rotation": view.T_world_camera[:3, :3].ravel().tolist(),
        "eye": eye.tolist(),
    }


def _bounds(
    shapes: list[Shape], poses: NDArray[np.float64], used: list[tuple[int, int]]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Bounds of all frames, and positions that include the outermost ones."""
    outermost = {shape: _outermost(shapes[shape]) for shape in {shape for shape, _ in used}}
    positions = [matmul(outermost[shape], poses[pose, :3, :3].T) + poses[pose, :3, 3] for shape, pose in used]
    everything = np.concatenate([np.empty((0, 3)), *positions])
    if len(everything) == 0:
        return np.zeros(3), np.zeros(3), everything
    return everything.min(axis=0), everything.max(axis=0), everything


def _outermost(shape: Shape) -> NDArray[np.float64]:
    """The outermost positions along the axes, and of a sample along directions on the sphere."""
    positions = np.asarray(shape.positions, np.float32)
    if shape.kind != "points" and shape.indices is not None:
        drawn = np.zeros(len(positions), bool)
        drawn[np.asarray(shape.indices).ravel()] = True
        positions = positions[drawn]
    if len(positions) == 0:
        return np.empty((0, 3))
    sample = positions[:: -(-len(positions) // MAX_CAMERA_POINTS)]
    step = np.arange(NUM_DIRECTIONS) + 0.5  # Vogel spiral on the sphere: even and reproducible
    z, angle = 1 - 2 * step / NUM_DIRECTIONS, step * math.pi * (3 - math.sqrt(5))
    ring = np.sqrt(1 - z * z)
    extents = matmul(sample.astype(np.float64), np.stack([ring * np.cos(angle), ring * np.sin(angle), z]))
    axes = positions[np.concatenate([positions.argmin(axis=0), positions.argmax(axis=0)])]
    return np.unique(np.concatenate([sample[extents.argmax(axis=0)], axes]), axis=0).astype(np.float64)


def _check_background(background: ArrayLike) -> list[float]:
    values = check_finite("background", check_shape("background", background, (3,)))
    if values.min() < 0 or values.max() > 1:
        raise ValueError(f"background: expected numbers from 0 to 1, got {values.tolist()}")
    return values.tolist()


def _check_timeline(timeline: object) -> None:
    if not isinstance(timeline, Timeline):
        raise TypeError(f"timeline: expected a Timeline, got {type(timeline).__name__}")
    check_finite("timeline.origin", check_shape("timeline.origin", timeline.origin, (3,)))
    check_positive("timeline.fps", timeline.fps)
    for number, shape in enumerate(timeline.shapes):
        _check_shape(f"timeline.shapes[{number}]", shape)
    for number, frame in enumerate(timeline.frames):
        for name, placement in frame.shown.items():
            _check_placement(f"timeline.frames[{number}].shown[{name!r}]", placement, len(timeline.shapes))


def _check_shape(name: str, shape: Shape) -> None:
    if shape.kind not in INDICES_PER_ROW:
        raise ValueError(f"{name}.kind: expected one of {', '.join(INDICES_PER_ROW)}, got {shape.kind!r}")
    positions = check_rows(f"{name}.positions", shape.positions, 3)
    if not np.isfinite(positions).all():
        raise ValueError(f"{name}.positions: expected finite numbers; remove non-finite points")
    check_positive(f"{name}.size", shape.size)
    if len(shape.plain) != 3 or not all(0 <= value <= 255 for value in shape.plain):
        raise ValueError(f"{name}.plain: expected three whole numbers from 0 to 255, got {shape.plain}")
    count = len(positions)
    if INDICES_PER_ROW[shape.kind]:
        if shape.indices is None:
            raise ValueError(f"{name}.indices: expected shape [m, {INDICES_PER_ROW[shape.kind]}], got None")
        indices = check_rows(f"{name}.indices", shape.indices, INDICES_PER_ROW[shape.kind])
        if indices.size and (indices.min() < 0 or indices.max() >= count):
            raise ValueError(f"{name}.indices: expected 0 to {count - 1}, got {indices.min()} to {indices.max()}")
        count = len(indices) if shape.kind == "lines" else count
    if shape.colors is not None:
        colors = check_shape(f"{name}.colors", shape.colors, (count, 3), dtype=np.asarray(shape.colors).dtype)
        if colors.dtype != np.uint8:
            raise TypeError(f"{name}.colors: expected uint8, got {colors.dtype}")
    if shape.normals is not None:
        check_shape(f"{name}.normals", shape.normals, (len(positions), 3), dtype=np.float32)


def _check_placement(name: str, placement: Placement, shape_count: int) -> None:
    for number in placement.shapes:
        if not 0 <= number < shape_count:
            raise ValueError(f"{name}.shapes: expected numbers of {shape_count} shapes, got {number}")
    if placement.pose is not None:
        pose = check_finite(f"{name}.pose", check_shape(f"{name}.pose", placement.pose, (4, 4)))
        if np.abs(pose[3] - (0, 0, 0, 1)).max() > 1e-6:
            raise ValueError(f"{name}.pose: expected a last row (0, 0, 0, 1), got {pose[3].tolist()}")
